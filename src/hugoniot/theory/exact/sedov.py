r"""Point explosion in a uniform cold ideal gas (Sedov, Taylor, von Neumann), planar, cylindrical or spherical.

It tests a solver with a strong blast wave from a concentrated release of energy: the radius of the shock and the profile behind it.

The shock is at $R = (E t^2/\alpha\rho_0)^{1/(d+2)}$. With $\delta = 2/(d+2)$ and $\xi = r/R$ the flow behind it is

$$u = \delta\, \frac rt\, v(\xi), \qquad c^2 = \delta^2\, \frac{r^2}{t^2}\, z(\xi), \qquad \rho = \rho_0 G(\xi)$$

* $E$: energy of the explosion, `energy`; $\rho_0$: density of the gas ahead, `density`; $\gamma$: ratio of specific heats
* $d$: 1 planar, 2 cylindrical, 3 spherical
* $\alpha$: energy integral, given below

The equations of motion have the integral $z = \gamma(\gamma-1)\,v^2(1-v)/[2(\gamma v - 1)]$, and

$$\frac{d\ln\xi}{dv} = \frac{\gamma + 1 - 2/v + (\gamma-1)/(\gamma v - 1)}{(d+2) - (2 + (\gamma-1)d)\,v}, \qquad
  \frac{d\ln G}{dv} = \frac{1 + d\,v\,d\ln\xi/dv}{1-v}$$

from $v = 2/(\gamma+1)$ behind the shock to $v = 1/\gamma$ at the origin. For $d = 3$ and $\gamma > 7$, $v$ rises to 1 instead, at the
edge of an empty core; at $\gamma = 7$ it is constant. The energy integral is

$$\alpha = S_d\,\delta^2\int_0^1\left[\tfrac12 G v^2 + \frac{G z}{\gamma(\gamma-1)}\right]\xi^{d+1}\,d\xi, \qquad
S_1 = 1 \text{ (one side)}, \quad S_2 = 2\pi, \quad S_3 = 4\pi$$

Implementation: the first equation integrates in partial fractions; G follows from the entropy, which the conservation of mass
m = G xi^d (1 - v) makes a power of m, so that G^(2 - gamma) xi^(d+2) z (1 - v) is constant, or at gamma = 2 from quadrature of the second
equation.

Source: Sedov, Similarity and Dimensional Methods in Mechanics (1959), chapter IV; Landau & Lifshitz, Fluid Mechanics, section 106
(generalised here to d = 1, 2); values: Kamm, LA-UR-00-6055 (2000).
"""

import numpy as np
from scipy.integrate import quad
from scipy.interpolate import make_interp_spline

from hugoniot.errors import OutOfRange
from hugoniot.theory.exact.noh import DIMENSION
from hugoniot.theory.exact.solution import Solution

SURFACE = {1: 1.0, 2: 2.0 * np.pi, 3: 4.0 * np.pi}
_FOLDS = 60.0  # e-foldings of xi resolved towards the origin, fewer for gamma near 1, where they would underflow


class Profile:
    """xi, G and z of one (gamma, d) as functions of a coordinate s >= 0 that is 0 at the shock and grows inwards.

    gamma v - 1 = w2 exp(-s) in the usual case; 1 - v = (1 - v2) exp(-s) with an empty core.
    """

    def __init__(self, gamma: float, d: int):
        self.gamma, self.d = gamma, d
        self.shock = 2.0 / (gamma + 1.0)
        self.slope = 2.0 + (gamma - 1.0) * d
        gap = (d + 2.0) - self.slope * self.shock
        self.case = "power" if abs(gap) < 1e-9 else ("standard" if gap > 0.0 else "vacuum")
        mixed = gamma * (d + 2.0) - self.slope
        b, k = d + 2.0, self.slope
        self._exponents = (-2.0 / b, (gamma - 1.0) / mixed, -(gamma + 1.0 - 2.0 * k / b + k * (gamma - 1.0) / mixed) / k)
        self.deepest = _FOLDS if self.case == "vacuum" else min(_FOLDS / self._exponents[1], 600.0)
        self._reference = 0.0 if self.case == "power" else self._log_xi(self.shock, gamma * self.shock - 1.0)
        self._spline = self._quadrature() if abs(gamma - 2.0) < 1e-3 else None

    def _log_xi(self, v, w):
        a, b, c = self._exponents
        return a * np.log(v) + b * np.log(w) + c * np.log(np.abs((self.d + 2.0) - self.slope * v))

    def coordinates(self, s):
        """(v, gamma v - 1, 1 - v) at s, each without cancellation."""
        if self.case == "vacuum":
            rest = (1.0 - self.shock) * np.exp(-s)
            return 1.0 - rest, self.gamma * (1.0 - rest) - 1.0, rest
        w = (self.gamma * self.shock - 1.0) * np.exp(-s)
        return (1.0 + w) / self.gamma, w, (self.gamma - 1.0 - w) / self.gamma

    def log_xi(self, s):
        v, w, _ = self.coordinates(s)
        return self._log_xi(v, w) - self._reference

    def at(self, s):
        """(xi, v, G, G z) at s."""
        g, d = self.gamma, self.d
        v, w, rest = self.coordinates(s)
        log_xi = self._log_xi(v, w) - self._reference
        log_z = np.log(g * (g - 1.0) * v * v * rest / (2.0 * w))
        if self._spline is not None:
            log_g = np.log((g + 1.0) / (g - 1.0)) + self._spline(s) - self._spline(0.0)
        else:
            z2 = 2.0 * g * (g - 1.0) / (g + 1.0) ** 2
            ratio = (d + 2.0) * log_xi + log_z - np.log(z2) + np.log(rest / (1.0 - self.shock))
            log_g = np.log((g + 1.0) / (g - 1.0)) - ratio / (2.0 - g)
        return np.exp(log_xi), v, np.exp(log_g), np.exp(log_g + log_z)

    def _quadrature(self):
        s = np.linspace(0.0, self.deepest, 40001)
        v, w, rest = self.coordinates(s)
        dlnxi = (self.gamma + 1.0 - 2.0 / v + (self.gamma - 1.0) / w) / ((self.d + 2.0) - self.slope * v)
        return make_interp_spline(s, -(1.0 + self.d * v * dlnxi) / rest * w / self.gamma, k=5).antiderivative()

    def invert(self, xi):
        """s at which log_xi equals log(xi), by bisection on the monotone function."""
        target = np.log(xi)
        low, high = np.zeros_like(target), np.full_like(target, self.deepest)
        for _ in range(70):
            middle = 0.5 * (low + high)
            outside = self.log_xi(middle) > target
            low, high = np.where(outside, middle, low), np.where(outside, high, middle)
        return 0.5 * (low + high)

    def fields(self, xi):
        """(v, G, G z) at an array of xi in (0, 1)."""
        g = self.gamma
        if self.case == "power":
            density = (g + 1.0) / (g - 1.0) * xi ** (self.d * self.shock / (1.0 - self.shock))
            z = 2.0 * g * (g - 1.0) / (g + 1.0) ** 2
            return np.full_like(xi, self.shock), density, density * z
        _, v, density, stiffness = self.at(self.invert(xi))
        return v, density, stiffness

    def energy_integral(self) -> float:
        """alpha of E = alpha rho0 R^(d+2) / t^2; the planar value is that of one side."""
        g, d = self.gamma, self.d
        if self.case == "power":
            v, density, stiffness = self.fields(np.ones(1))
            total = (0.5 * density * v * v + stiffness / (g * (g - 1.0)))[0] / (d + 2.0 + d * self.shock / (1.0 - self.shock))
        else:
            def integrand(s):
                v, w, rest = self.coordinates(s)
                slope = (g + 1.0 - 2.0 / v + (g - 1.0) / w) / ((d + 2.0) - self.slope * v)
                step = slope * (w / g if self.case == "standard" else -rest)
                xi, v, density, stiffness = self.at(s)
                return (0.5 * density * v * v + stiffness / (g * (g - 1.0))) * xi ** (d + 2) * step
            edges = np.concatenate(([0.0, 0.5, 2.0], np.geomspace(5.0, self.deepest, 8)))
            total = sum(quad(integrand, a, b, epsabs=0.0, epsrel=1e-12, limit=200)[0] for a, b in zip(edges[:-1], edges[1:]))
            if self.case == "standard":  # the core inside has the uniform pressure of the centre
                xi, _, _, stiffness = self.at(self.deepest)
                total += stiffness * xi ** (d + 2) / (g * (g - 1.0) * d)
        return SURFACE[d] * (2.0 / (d + 2.0)) ** 2 * float(total)


def sedov(geometry: str = "spherical", gamma: float = 1.4, energy: float = 0.851072, density: float = 1.0) -> Solution:
    """Point explosion in cold ideal gas of uniform density.

    geometry   planar, cylindrical or spherical
    gamma      ratio of specific heats, above 1
    energy     energy of the explosion: planar per area on one side, cylindrical per length, spherical total
    density    density of the gas ahead

    Fields: density, velocity, pressure, energy, sound_speed. Ahead of the shock and in an empty core energy is 0. At r = 0 (without an
    empty core) density is 0, the pressure finite and the energy infinite. Numbers: alpha, shock_coefficient (radius of the shock at t = 1
    s), peak_density (behind the shock). Valid for times above 0.
    """
    if gamma <= 1.0 or energy <= 0.0 or density <= 0.0:
        unit = {"planar": "J/m2", "cylindrical": "J/m", "spherical": "J"}[geometry]
        raise OutOfRange(f"a point explosion needs gamma > 1, energy > 0 and density > 0, got gamma = {gamma:g}, energy = {energy:g} "
                         f"{unit}, density = {density:g} kg/m3")
    d = DIMENSION[geometry]
    profile_of = Profile(gamma, d)
    alpha = profile_of.energy_integral()
    delta = 2.0 / (d + 2.0)
    coefficient = (energy / (alpha * density)) ** (1.0 / (d + 2.0))

    def profile(r, time):
        shock = coefficient * time**delta
        xi = r / shock
        inside = (xi < 1.0) & (r > 0.0)
        if profile_of.case == "vacuum":
            inside &= np.log(np.maximum(xi, 1e-300)) > profile_of.log_xi(profile_of.deepest)
        scale = np.where(inside, delta * r / time, 0.0)
        v, g, gz = profile_of.fields(np.where(inside, xi, 0.5))
        rho = density * np.where(inside, g, np.where(xi < 1.0, 0.0, 1.0))
        p = np.where(inside, density * gz * scale**2 / gamma, 0.0)
        if profile_of.case == "standard":
            p = np.where(r == 0.0, profile(np.array([1e-3 * shock]), time)["pressure"][0], p) if np.any(r == 0.0) else p
        with np.errstate(divide="ignore", invalid="ignore"):
            e = np.where(p > 0.0, p / ((gamma - 1.0) * rho), 0.0)
        return {"density": rho, "velocity": scale * v, "pressure": p, "energy": e,
                "sound_speed": np.sqrt(gamma * (gamma - 1.0) * e)}

    numbers = {"alpha": alpha, "shock_coefficient": coefficient, "peak_density": density * (gamma + 1.0) / (gamma - 1.0)}
    return Solution(f"Sedov, {geometry}", geometry, profile, lambda time: (coefficient * time**delta,), numbers, (1e-300, float("inf")))
