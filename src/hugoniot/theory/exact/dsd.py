r"""Detonation shock dynamics: detonation fronts whose normal velocity decreases linearly with their curvature.

$$D_n = D(1 - \alpha\kappa)$$

* $D_n$: normal velocity of the front; $D$: velocity of a plane front, `detonation_velocity`
* $\kappa$: total curvature of the front; $\alpha$: `curvature_length`

The solutions test programs that propagate such fronts, and give the effect of a charge's diameter on its detonation velocity.

**Expanding front**, cylindrical ($n = 1$) or spherical ($n = 2$), with $\kappa = n/r$ and the radius $r_0$ at $t = 0$:

$$t = \frac1D\left[r - r_0 + n\alpha\ln\frac{r - n\alpha}{r_0 - n\alpha}\right]$$

**Rate stick**: a cylinder (or a slab) of radius (half-width) $R$, in which the front is steady and moves along the axis at the speed
$\delta D$. Let $\phi$ be the angle between the normal of the front and the axis, and $z$ the lag behind the axis:

$$\delta\cos\phi = 1 - \alpha\left(\cos\phi\frac{d\phi}{dr} + \frac{\sin\phi}{r}\right), \qquad \frac{dz}{dr} = \tan\phi$$

without $\sin\phi/r$ in a slab. $\delta$ is found so that $\phi$ rises from 0 on the axis to the edge angle $\phi_e$, at which the
explosive meets its confinement. For the slab both integrals have a closed form,

$$R = \frac\alpha\delta\left[\frac{2}{\sqrt{1-\delta^2}}\arctan\!\left(\sqrt{\frac{1+\delta}{1-\delta}}\tan\frac{\phi_e}2\right)
  - \phi_e\right], \qquad z = \frac\alpha\delta\ln\frac{1 - \delta\cos\phi}{1 - \delta}$$

**Arc**: a front rotates steadily at the angular velocity $\Omega$ in a ring of explosive. With $\psi$ the outward tilt of its normal from
the direction of rotation, $D_n = \Omega r\cos\psi$ and $\kappa = \cos\psi\,d\psi/dr + \sin\psi/r$. $\psi$ is given at both edges: it is
minus `inner_angle_degrees` at the inner and `outer_angle_degrees` at the outer edge. $\Omega$ is the value for which the integration from
the inner edge gives the right $\psi$ at the outer edge. The angle $\vartheta$ by which the front lags behind its inner edge follows from
$d\vartheta/dr = \tan\psi/r$.

Source: Bdzil, J. Fluid Mech. 108 (1981) 195; Bdzil and Stewart, Phys. Fluids A 1 (1989) 1261; Short and Bdzil, J. Fluid Mech. 479 (2003)
39; derived for this project.
"""

import math

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from hugoniot.errors import NoSolution, OutOfRange
from hugoniot.theory.exact.solution import Solution

_TIGHT = {"rtol": 1e-12, "atol": 1e-14, "method": "DOP853"}


def dsd_expansion(geometry: str = "cylindrical", detonation_velocity: float = 8000.0, curvature_length: float = 1e-4,
                  radius: float = 0.01) -> Solution:
    """Detonation shock dynamics: a cylindrical or spherical front that expands from a given radius.

    geometry              cylindrical or spherical
    detonation_velocity   velocity D of a plane front
    curvature_length      alpha in D_n = D (1 - alpha kappa)
    radius                radius of the front at time 0, above n alpha

    Positions are radii outside `radius`.

    Fields: burn_time (s), shock_velocity. Numbers: first_velocity (of the front at `radius`), delay (n alpha/D, the
    time that the front loses, relative to the velocity D, for every factor e in radius).
    """
    n = {"cylindrical": 1, "spherical": 2}.get(geometry, 0)
    if not n:
        raise OutOfRange("an expanding front is cylindrical or spherical")
    d, lag = detonation_velocity, n * curvature_length
    if min(d, curvature_length) <= 0.0 or radius <= lag:
        raise OutOfRange(f"the front must start at a radius above {lag:g} m, where its velocity would vanish")

    def burn_time(r):
        return (r - radius + lag * np.log((r - lag) / (radius - lag))) / d

    def front(time):
        low, high = radius, radius + d * time
        return brentq(lambda r: burn_time(r) - time, low, high, xtol=1e-15 * high, rtol=8.9e-16) if time > 0.0 else radius

    def profile(r, time):
        if (r < radius).any():
            raise OutOfRange(f"a position lies inside the radius at which the front starts, {radius:g} m")
        return {"burn_time": burn_time(r), "shock_velocity": d * (1.0 - lag / r)}

    numbers = {"first_velocity": d * (1.0 - lag / radius), "delay": lag / d}
    return Solution(f"expanding detonation, {geometry}", geometry, profile, lambda time: (front(time),), numbers,
                    domain=lambda time: (radius, max(1.2 * front(time), 2.0 * radius)))


def dsd_rate_stick(geometry: str = "cylindrical", detonation_velocity: float = 8000.0, curvature_length: float = 1e-3,
                   radius: float = 0.02, edge_angle_degrees: float = 40.0) -> Solution:
    """Detonation shock dynamics: speed and shape of the steady front in a rate stick or a slab.

    geometry              cylindrical (a stick) or planar (a slab)
    detonation_velocity   velocity D of a plane front
    curvature_length      alpha in D_n = D (1 - alpha kappa)
    radius                radius of the stick, or half the width of the slab
    edge_angle_degrees    angle between the normal of the front and the axis at the edge, between 0 and 90

    Positions are distances from the axis. The solution does not depend on time.

    Fields: lag (m, behind the axis), slope_angle (degrees), shock_velocity (normal to the front).
    Numbers: axial_velocity, velocity_deficit (1 - axial_velocity/D), edge_lag (m).
    """
    edge = math.radians(edge_angle_degrees)
    known = geometry in ("cylindrical", "planar")
    if not known or min(detonation_velocity, curvature_length, radius) <= 0.0 or not 0.0 < edge < 0.5 * np.pi:
        raise OutOfRange("a rate stick is cylindrical or planar, with positive lengths and an edge angle between 0 and 90 degrees")
    scale = radius / curvature_length
    delta = _slab_speed(scale, edge) if geometry == "planar" else _stick_speed(scale, edge)
    shape = _front(delta, 0 if geometry == "planar" else 1, scale, edge)

    def profile(r, time):
        if (np.abs(r) > radius * (1.0 + 1e-12)).any():
            raise OutOfRange(f"a position lies outside the stick, whose radius is {radius:g} m")
        phi, lag = shape(np.minimum(np.abs(r) / curvature_length, scale))
        return {"lag": curvature_length * lag, "slope_angle": np.degrees(phi), "shock_velocity": delta * detonation_velocity * np.cos(phi)}

    numbers = {"axial_velocity": delta * detonation_velocity, "velocity_deficit": 1.0 - delta,
               "edge_lag": curvature_length * float(shape(np.array([scale]))[1][0])}
    return Solution(f"rate stick, {geometry}", geometry, profile, numbers=numbers, domain=lambda time: (0.0, radius), steady=True)


def dsd_arc(detonation_velocity: float = 8000.0, curvature_length: float = 1e-3, inner: float = 0.04, outer: float = 0.06,
            inner_angle_degrees: float = 0.0, outer_angle_degrees: float = 30.0) -> Solution:
    """Detonation shock dynamics: a front that rotates steadily in a ring of explosive.

    detonation_velocity   velocity D of a plane front
    curvature_length      alpha in D_n = D (1 - alpha kappa)
    inner                 inner radius of the ring
    outer                 outer radius of the ring
    inner_angle_degrees   angle between the normal of the front and the direction of rotation at the inner edge
    outer_angle_degrees   the same at the outer edge; both are positive where the front falls back towards the edge

    Positions are radii. The solution does not depend on time.

    Fields: lag (m along the circle, behind the point at the inner edge), slope_angle (degrees, outwards), shock_velocity (normal to the
    front). Numbers: angular_velocity (rad/s), inner_velocity and outer_velocity (along the edges).
    """
    if min(detonation_velocity, curvature_length, inner) <= 0.0 or not outer > inner:
        raise OutOfRange("the ring needs positive lengths and an outer radius above the inner one")
    a, b = inner / curvature_length, outer / curvature_length
    first, last = -math.radians(inner_angle_degrees), math.radians(outer_angle_degrees)

    def rates(r, y, omega):
        psi = y[0]
        return [(1.0 - omega * r * math.cos(psi) - math.sin(psi) / r) / math.cos(psi), math.tan(psi) / r]

    def run(omega, dense=False):
        blown = [_leaves(0.5 * np.pi - 1e-3), _leaves(-0.5 * np.pi + 1e-3)]
        return solve_ivp(rates, (a, b), (first, 0.0), args=(omega,), events=blown, dense_output=dense, **_TIGHT)

    def miss(omega):
        end = run(omega)
        return end.y[0][-1] - last if end.status == 0 else math.copysign(2.0, end.y[0][-1])

    low, high = 0.02 / b, 2.0 / a
    if miss(low) < 0.0 or miss(high) > 0.0:
        raise NoSolution("no steadily turning front has these edge angles: the ring is too thin for them")
    omega = brentq(miss, low, high, xtol=1e-15 / a, rtol=8.9e-16)
    shape = run(omega, dense=True).sol

    def profile(r, time):
        psi, turned = shape(np.clip(r / curvature_length, a, b))
        turn = omega * detonation_velocity * r / curvature_length
        return {"lag": r * turned, "slope_angle": np.degrees(psi), "shock_velocity": turn * np.cos(psi)}

    angular = omega * detonation_velocity / curvature_length
    numbers = {"angular_velocity": angular, "inner_velocity": angular * inner, "outer_velocity": angular * outer}
    return Solution("detonation in a ring", "cylindrical", profile, numbers=numbers, domain=lambda time: (inner, outer), steady=True)


def _leaves(limit: float):
    """A terminal event: the tilt reaches `limit`."""
    def event(r, y, *given):
        return y[0] - limit

    event.terminal = True
    return event


def _slab_speed(scale: float, edge: float) -> float:
    """delta of a slab of half-width R/alpha = scale, from the closed integral; it grows without bound as delta goes to 1."""
    def half_width(gap):  # of 1 - delta, which stays exact near 1
        delta = 1.0 - gap
        root = math.sqrt(gap * (2.0 - gap))
        return (2.0 / root * math.atan2(math.sqrt(2.0 - gap) * math.tan(0.5 * edge), math.sqrt(gap)) - edge) / delta

    narrowest = math.sin(edge)
    if scale <= narrowest:
        raise NoSolution(f"with this edge angle the detonation fails in slabs of a half-width below {narrowest:.5g} times curvature_length")
    return 1.0 - brentq(lambda g: half_width(g) - scale, 1e-300 if scale > 1e8 else 1e-18, 1.0 - 1e-12, xtol=1e-300, rtol=8.9e-16)


def _stick_speed(scale: float, edge: float) -> float:
    """delta of a cylindrical stick of R/alpha = scale, by shooting from the axis."""
    def miss(delta):
        end = _shoot(delta, scale, edge)
        return (end.y[0][-1] if end.status == 0 else edge + (scale - end.t[-1]) / scale) - edge

    low, high = 1e-9, 1.0 - 1e-12
    if miss(low) < 0.0:
        raise NoSolution("a stick with this edge angle fails at so small a radius: no steady front has it")
    return brentq(miss, low, high, xtol=1e-15, rtol=8.9e-16)


def _shoot(delta: float, scale: float, edge: float, dense: bool = False, axisymmetric: int = 1):
    """(phi, z) against r, all in curvature lengths, from a series at the axis, phi = (1 - delta) r/2 there (r in a slab)."""
    start = 1e-6 * scale
    slope = (1.0 - delta) / (1 + axisymmetric)

    def rates(r, y):
        phi = y[0]
        return [(1.0 - delta * math.cos(phi) - axisymmetric * math.sin(phi) / r) / math.cos(phi), math.tan(phi)]

    events = None if dense else _leaves(min(edge + 0.2, 0.5 * math.pi - 1e-4))
    return solve_ivp(rates, (start, scale), (slope * start, 0.5 * slope * start**2), events=events, dense_output=dense, **_TIGHT)


def _front(delta: float, axisymmetric: int, scale: float, edge: float):
    """Function r -> (phi, z) of the steady front."""
    run = _shoot(delta, scale, edge, dense=True, axisymmetric=axisymmetric)
    slope = (1.0 - delta) / (1 + axisymmetric)

    def shape(r):
        phi, lag = run.sol(np.maximum(r, run.t[0]))
        near = r < run.t[0]
        return np.where(near, slope * r, phi), np.where(near, 0.5 * slope * r**2, lag)

    return shape
