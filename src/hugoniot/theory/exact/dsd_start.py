r"""Detonation shock dynamics of a rate stick from its start: a plane front that becomes the steady one.

It tests programs that propagate curved fronts in time, and shows the distance over which a front becomes steady.

The normal velocity is $D_n = D(1 - \alpha\kappa)$ with the velocity $D$ of a plane front, the curvature $\kappa$ and the length $\alpha$
(`curvature_length`). For the position $z(r, t)$ of the front along the axis, with $z' = \partial z/\partial r$, this is

$$\frac{\partial z}{\partial t} = D\left[\sqrt{1 + z'^2} + \alpha\left(\frac{z''}{1 + z'^2} + n\frac{z'}r\right)\right], \qquad
  z(r, 0) = 0, \quad z'(0, t) = 0, \quad z'(R, t) = -\tan\phi_e$$

with $n = 1$ in a stick and 0 in a slab, the radius (half-width) $R$ and the edge angle $\phi_e$. At early times the edge lags by
$2\tan\phi_e\sqrt{\alpha Dt/\pi}$ for a small angle. The equation is solved by collocation at Chebyshev points across the width, with
error control in time.

Source: Bdzil and Stewart, Phys. Fluids A 1 (1989) 1261, for the model; derived and solved here.
"""

import math

import numpy as np
from scipy.integrate import solve_ivp

from hugoniot.errors import NoSolution, OutOfRange
from hugoniot.theory.exact.dsd import dsd_rate_stick
from hugoniot.theory.exact.solution import Solution

# across the width: exact to 1e-4, 1e-5 and 1e-6 of the edge's lag at a thousandth, a hundredth and a tenth of R^2/(alpha D)
POINTS = 64


def dsd_rate_stick_start(geometry: str = "cylindrical", detonation_velocity: float = 8000.0, curvature_length: float = 1e-3,
                         radius: float = 0.02, edge_angle_degrees: float = 40.0) -> Solution:
    """Detonation shock dynamics: the front of a rate stick lit simultaneously over the plane z = 0, until it is steady.

    geometry              cylindrical (a stick) or planar (a slab)
    detonation_velocity   velocity D of a plane front
    curvature_length      alpha in D_n = D (1 - alpha kappa)
    radius                radius R of the stick, or half the width of the slab
    edge_angle_degrees    angle between the normal of the front and the axis at the edge, between 0 and 90

    Positions are distances from the axis.

    Fields: front_position (m along the axis), lag (m, behind the axis), slope_angle (degrees), shock_velocity (normal to the front).
    Numbers: steady_velocity (along the axis), relaxation_time (R^2/(alpha D), in which the shape becomes steady).
    """
    steady = dsd_rate_stick(geometry, detonation_velocity, curvature_length, radius, edge_angle_degrees)
    relaxation = radius**2 / (curvature_length * detonation_velocity)
    front = _Front(0 if geometry == "planar" else 1, curvature_length / radius, math.tan(math.radians(edge_angle_degrees)))

    def profile(r, time):
        if (np.abs(r) > radius * (1.0 + 1e-12)).any():
            raise OutOfRange(f"a position lies outside the stick, whose radius is {radius:g} m")
        z, slope, rate = front(np.minimum(np.abs(r) / radius, 1.0), time * detonation_velocity / radius)
        return {"front_position": radius * z, "lag": radius * (front.on_axis - z), "slope_angle": np.degrees(np.arctan(-slope)),
                "shock_velocity": detonation_velocity * rate / np.sqrt(1.0 + slope**2)}

    numbers = {"steady_velocity": steady.numbers["axial_velocity"], "relaxation_time": relaxation}
    return Solution(f"rate stick from a plane front, {geometry}", geometry, profile, numbers=numbers, domain=lambda time: (0.0, radius))


class _Front:
    """z, its slope and its rate over x = r/R at the time t D/R; lengths in R."""

    def __init__(self, n: int, alpha: float, tangent: float):
        self.n, self.alpha, self.tangent, self.on_axis = n, alpha, tangent, 0.0
        self.x, self.first = _chebyshev(POINTS)
        self.second = self.first @ self.first
        edge = [0, -1]
        self.to_edges = np.linalg.inv(self.first[np.ix_(edge, edge)])
        self.inner = self.first[np.ix_(edge, range(1, POINTS - 1))]

    def whole(self, inner):
        """Values at all points: those at the edges follow from the slopes there."""
        ends = self.to_edges @ (np.array([-self.tangent, self.tangent]) - self.inner @ inner)
        return np.concatenate(([ends[0]], inner, [ends[1]]))

    def rate(self, z):
        """(dz/dt, dz/dx) at all points."""
        slope, bend = self.first @ z, self.second @ z
        square = 1.0 + slope * slope
        return np.sqrt(square) + self.alpha * (bend / square + self.n * slope / self.x), slope

    def __call__(self, x, time: float):
        if time <= 0.0:
            self.on_axis = 0.0
            return np.zeros_like(x), np.zeros_like(x), np.ones_like(x)
        found = solve_ivp(lambda t, inner: self.rate(self.whole(inner))[0][1:-1], (0.0, time), np.zeros(POINTS - 2), method="LSODA",
                          t_eval=[time], rtol=1e-9, atol=1e-12)
        if not found.success:
            raise NoSolution(f"the front could not be followed: {found.message}")
        z = self.whole(found.y[:, -1])
        rate, slope = self.rate(z)
        at = [np.polynomial.chebyshev.chebfit(self.x, values, POINTS - 1) for values in (z, slope, rate)]
        self.on_axis = float(np.polynomial.chebyshev.chebval(0.0, at[0]))
        return tuple(np.polynomial.chebyshev.chebval(x, series) for series in at)


def _chebyshev(count: int) -> tuple[np.ndarray, np.ndarray]:
    """Points cos(k pi/(count - 1)) and the matrix of the derivative at them (Trefethen, Spectral Methods in MATLAB, chapter 6)."""
    k = np.arange(count)
    x = np.cos(np.pi * k / (count - 1))
    weight = np.where((k == 0) | (k == count - 1), 2.0, 1.0) * (-1.0) ** k
    apart = x[:, None] - x[None, :] + np.eye(count)
    matrix = np.outer(weight, 1.0 / weight) / apart
    return x, matrix - np.diag(matrix.sum(axis=1))
