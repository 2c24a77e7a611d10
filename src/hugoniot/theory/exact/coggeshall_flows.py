r"""Coggeshall's adiabatic flows of an ideal gas in one dimension without shocks: every radius stays in proportion to the size of the body.

They test a solver in smooth expansion and compression, where any rise of the entropy is an error. In each, the density or the entropy is a
power of the radius with a free exponent $b$, `slope`. The numbers of the problems are Coggeshall's; $d$ = 1, 2, 3 in planar, cylindrical
and spherical geometry.

* Problem 1, coasting: $u = r/t$, $\rho = \rho_0r^bt^{-b-d}$, $e = e_0r^{-b}t^{b-(\gamma-1)d}$. The pressure is uniform, so nothing
  accelerates.
* Problem 2, driven: $u = ar/t$, $\rho = \rho_0r^bt^{-a(b+d)}$, $e = \frac{a(1-a)}{(\gamma-1)(b+2)}\frac{r^2}{t^2}$ with
  $a = \frac{2}{2 + (\gamma-1)d}$ and $b > -2$.
* Problem 6, collapse from rest, for $\gamma = 1 + 2/d$: $u = -rt/(\tau^2 - t^2)$, $\rho = s^{-d}G(X)$, $p = s^{-d-2}P(X)$ with
  $s^2 = 1 - t^2/\tau^2$ and the initial radius $X = r/s$. The momentum equation is $P' = XG/\tau^2$. Here $G = \rho_0X^b$ and
  $P = \rho_0X^{b+2}/((b+2)\tau^2)$ with $b > -2$.
* Problem 7, the same with a free inner surface at $X = R$ and the entropy $p/\rho^\gamma \propto X^b$: with
  $Y = X^{2-b/\gamma} - R^{2-b/\gamma}$ the profiles are $G = CX^{-b/\gamma}Y^{1/(\gamma-1)}$ and
  $P = C\,\frac{\gamma-1}{(2\gamma-b)\tau^2}Y^{\gamma/(\gamma-1)}$, $b < 2\gamma$; the constant $C$ follows from the density at the outer
  radius. For $b = 0$ it is Kidder's shell without inner pressure.

Here $\rho_0$ and $e_0$ are the density and energy at unit radius (and, in problems 1 and 2, unit time), $\gamma$ is the ratio of specific
heats and $\tau$ the time of collapse, `collapse_time`.

ExactPack has all problems up to 21 except 15. Of those not given here, 8 and 11 are problem 1, 9 is problem 2 and 18 is problem 6, each
for the exponent at which a heat flux has no divergence. Problem 19 is `noh`, and 20 and 21 are `coggeshall_noh` and
`coggeshall_stopping`. Problems 3, 4, 5 and 12 have gamma < 1 or a negative temperature, and 10, 13, 14, 16 and 17 need heat conduction.

Source: Coggeshall, Phys. Fluids A 3 (1991) 757, problems 1, 2, 6, 7; derived for this project for any exponent.
"""

import numpy as np

from hugoniot.errors import OutOfRange
from hugoniot.theory.exact.noh import DIMENSION
from hugoniot.theory.exact.solution import Solution


def coggeshall_coasting(geometry: str = "spherical", gamma: float = 5.0 / 3.0, slope: float = 1.0, density: float = 1.0,
                        energy_per_mass: float = 1.0) -> Solution:
    """Coggeshall's coasting flow: velocity r/t, density a power of the radius, uniform pressure.

    geometry          planar, cylindrical or spherical
    gamma             ratio of specific heats, above 1
    slope             exponent b of the density
    density           density at r = 1, t = 1
    energy_per_mass   specific internal energy at r = 1, t = 1

    Fields: density, velocity, pressure, energy. Numbers: velocity_factor (1). Valid for times above 0.
    """
    if gamma <= 1.0 or density <= 0.0 or energy_per_mass <= 0.0:
        raise OutOfRange("Coggeshall's flows need gamma > 1 and a positive density and energy")
    return _flow("Coggeshall, coasting", geometry, gamma, (1.0, slope, density),
                 lambda r, t: energy_per_mass * r**-slope * t ** (slope - (gamma - 1.0) * DIMENSION[geometry]))


def coggeshall_driven(geometry: str = "spherical", gamma: float = 5.0 / 3.0, slope: float = 0.0, density: float = 1.0) -> Solution:
    """Coggeshall's driven flow: velocity proportional to r/t, density to a power of the radius, temperature quadratic in the radius.

    geometry   planar, cylindrical or spherical
    gamma      ratio of specific heats, above 1
    slope      exponent b of the density, above -2
    density    density at r = 1, t = 1

    Fields: density, velocity, pressure, energy. Numbers: velocity_factor (a). Valid for times above 0.
    """
    if gamma <= 1.0 or density <= 0.0 or slope <= -2.0:
        raise OutOfRange("Coggeshall's driven flow needs gamma > 1, a positive density and slope > -2")
    a = 2.0 / (2.0 + (gamma - 1.0) * DIMENSION[geometry])
    factor = a * (1.0 - a) / ((gamma - 1.0) * (slope + 2.0))
    return _flow("Coggeshall, driven", geometry, gamma, (a, slope, density), lambda r, t: factor * (r / t) ** 2)


def coggeshall_collapse(geometry: str = "spherical", slope: float = 0.0, density: float = 1.0, collapse_time: float = 1.0) -> Solution:
    """Coggeshall's collapse from rest: density a power of the radius, gamma = 1 + 2/d (planar 3, cylindrical 2, spherical 5/3).

    geometry        planar, cylindrical or spherical
    slope           exponent b of the density, above -2
    density         density at r = 1, t = 0
    collapse_time   time at which every radius reaches 0

    Fields: density, velocity, pressure, energy. Numbers: gamma. Valid for times below collapse_time.
    """
    if density <= 0.0 or collapse_time <= 0.0 or slope <= -2.0:
        raise OutOfRange("Coggeshall's collapse needs a positive density and collapse_time, and slope > -2")
    return _collapse("Coggeshall, collapse from rest", geometry, collapse_time, (0.01, 1.0),
                     lambda x: (density * x**slope, density * x ** (slope + 2.0) / ((slope + 2.0) * collapse_time**2)), {})


def coggeshall_shell(geometry: str = "spherical", inner: float = 0.5, outer: float = 1.0, slope: float = 1.2, density: float = 1.0,
                     collapse_time: float = 1.0) -> Solution:
    """Coggeshall's shell: collapse from rest without inner pressure, the entropy a power of the radius, gamma = 1 + 2/d.

    geometry        planar, cylindrical or spherical
    inner           inner radius at t = 0, a free surface
    outer           outer radius at t = 0
    slope           exponent b of the entropy p/rho^gamma, below 2 gamma
    density         density at the outer radius at t = 0
    collapse_time   time at which every radius reaches 0

    The pressure at the outer radius drives the shell.

    Fields: density, velocity, pressure, energy; not a number (NaN) outside the shell. Numbers: gamma, first_outer_pressure (pressure at the
    outer radius at time 0). Valid for times below collapse_time.
    """
    gamma = 1.0 + 2.0 / DIMENSION[geometry]
    if not 0.0 <= inner < outer or min(density, collapse_time) <= 0.0 or slope >= 2.0 * gamma:
        raise OutOfRange(f"Coggeshall's shell needs 0 <= inner < outer, positive density and collapse_time, and slope < {2 * gamma:g}")
    c = 2.0 - slope / gamma

    def shape(x):
        inside = (x >= inner * (1.0 - 1e-12)) & (x <= outer * (1.0 + 1e-12)) & (x > 0.0)
        x = np.where(inside, x, np.nan)
        y = np.maximum(x**c - inner**c, 0.0) / (outer**c - inner**c)
        factor = density * outer ** (slope / gamma) * (outer**c - inner**c) / (gamma * c * collapse_time**2)
        return (density * (x / outer) ** (-slope / gamma) * y ** (1.0 / (gamma - 1.0)),
                (gamma - 1.0) * factor * y ** (gamma / (gamma - 1.0)))

    return _collapse("Coggeshall, shell", geometry, collapse_time, (inner, outer), shape,
                     {"first_outer_pressure": float(shape(np.array(outer))[1])})


def _collapse(title: str, geometry: str, collapse_time: float, between: tuple[float, float], shape, numbers) -> Solution:
    """Collapse from rest; shape: function X -> (G, P), the density and pressure at rest over the radius at rest."""
    d = DIMENSION[geometry]
    gamma = 1.0 + 2.0 / d

    def scale(time):
        return np.sqrt(1.0 - (time / collapse_time) ** 2)

    def profile(r, time):
        s = scale(time)
        at_rest, pressure = shape(r / s)
        with np.errstate(invalid="ignore", divide="ignore"):
            e = np.where(at_rest > 0.0, pressure / ((gamma - 1.0) * at_rest), 0.0 * at_rest) / s**2
        velocity = np.where(np.isnan(at_rest), np.nan, -r * time / (collapse_time * s) ** 2)
        return {"density": at_rest * s**-d, "velocity": velocity, "pressure": pressure * s ** (-d - 2.0), "energy": e}

    return Solution(f"{title}, {geometry}", geometry, profile, numbers={"gamma": gamma, **numbers},
                    times=(0.0, collapse_time * (1.0 - 1e-12)), domain=lambda time: (between[0] * scale(time), between[1] * scale(time)))


def _flow(title: str, geometry: str, gamma: float, shape: tuple[float, float, float], energy) -> Solution:
    a, slope, density = shape

    def profile(r, time):
        rho = density * r**slope * time ** (-a * (slope + DIMENSION[geometry]))
        e = energy(r, time)
        return {"density": rho, "velocity": a * r / time, "pressure": (gamma - 1.0) * rho * e, "energy": e}

    return Solution(f"{title}, {geometry}", geometry, profile, numbers={"velocity_factor": a}, times=(1e-300, np.inf),
                    domain=lambda time: (0.01, 1.0))
