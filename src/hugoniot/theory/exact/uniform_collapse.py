r"""Uniform collapse: a body flows inwards with a velocity proportional to the radius, so that it stays uniform.

It tests whether a solver keeps such a body uniform and on its isentrope. The geometry is planar, cylindrical or spherical; the material is
an ideal gas or any material in the library.

$$u = -\frac{r}{t_c - t}, \qquad \rho = \rho_0\left(1 - \frac{t}{t_c}\right)^{-d}, \qquad e = e_S(\rho)$$

* $t_c$: time of collapse, `collapse_time`; $\rho_0$: density at $t = 0$
* $d$: 1 planar, 2 cylindrical, 3 spherical
* $e_S$: energy on the isentrope through the initial state; for an ideal gas $e_S = e_0(1 - t/t_c)^{-d(\gamma-1)}$ with the initial energy
  $e_0$

The pressure is uniform, so nothing accelerates.

Source: Noh, J. Comput. Phys. 72 (1987) 78 (his second problem, the uniform collapse); derived for this project for any equation of state.
"""

import numpy as np

from hugoniot.errors import OutOfRange
from hugoniot.theory.exact.noh import DIMENSION
from hugoniot.theory.exact.solution import Solution
from hugoniot.theory.exact.substance import law_named
from hugoniot.theory.isentrope import isentrope, reference


def uniform_collapse(geometry: str = "spherical", gamma: float = 5.0 / 3.0, density: float = 1.0, energy_per_mass: float = 1.0,
                     collapse_time: float = 1.0, material: str = "") -> Solution:
    """Uniform collapse (Noh's second problem): velocity proportional to the radius, everything else uniform.

    geometry          planar, cylindrical or spherical
    gamma             ratio of specific heats of an ideal gas, above 1
    density           density at time 0
    energy_per_mass   specific internal energy at time 0
    collapse_time     time at which every radius would reach 0
    material          name of a library material, which starts from its reference state; gamma, density and energy_per_mass are then not
                      used

    Fields: density, velocity, pressure, energy. Numbers: first_density and first_pressure (at time 0), compression_at_half_time (density at
    half of collapse_time divided by that at time 0).
    Valid for times below collapse_time, and for a material as far as its equation of state reaches.
    """
    d = DIMENSION[geometry]
    if min(density, collapse_time) <= 0.0 or gamma <= 1.0 or energy_per_mass < 0.0:
        raise OutOfRange("the uniform collapse needs gamma > 1, positive density and collapse_time, and an energy that is not negative")
    density, state = _isentrope(material) if material else (density, _ideal(gamma, density, energy_per_mass))

    def profile(r, time):
        left = 1.0 - time / collapse_time
        rho = density * left**-d
        p, e = state(rho)
        return {"density": np.full_like(r, rho), "velocity": -r / (collapse_time * left), "pressure": np.full_like(r, p),
                "energy": np.full_like(r, e)}

    numbers = {"first_density": float(density), "first_pressure": state(density)[0], "compression_at_half_time": 2.0**d}
    return Solution(f"uniform collapse, {geometry}", geometry, profile, numbers=numbers, times=(0.0, collapse_time * (1.0 - 1e-12)),
                    domain=lambda time: (0.0, 1.0))


def _ideal(gamma: float, density: float, energy: float):
    """rho -> (pressure, energy) on the isentrope of an ideal gas."""
    def state(rho):
        e = energy * (rho / density) ** (gamma - 1.0)
        return (gamma - 1.0) * rho * e, e

    return state


def _isentrope(material: str):
    """(density at rest, rho -> (pressure, energy)) on the isentrope of a material through its reference state."""
    par = law_named(material)
    start = reference(par)

    def state(rho):
        end = isentrope(par, start, density=rho)
        return float(end.pressure), float(end.specific_internal_energy)

    return start.density, state
