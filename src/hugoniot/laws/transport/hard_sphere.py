r"""Shear viscosity of a gas of hard spheres, from Maxwell's elementary kinetic theory.

$$\mu = \frac{2}{3\pi d^2}\sqrt{\frac{m k_B T}{\pi}} \;\propto\; \sqrt{T}$$

* $m$: mass of a molecule, `molecular_mass`; $d$: its diameter, `diameter`
* $k_B$: Boltzmann's constant; $T$: temperature

The equation of state must give a temperature. Jordan's "Maxwell viscosity" refers to this formula, but his numbers are those of
`power_law` with the exponent 0.81 (J-E4).
"""

from typing import NamedTuple

from hugoniot.core.ops import vsqrt
from hugoniot.laws.transport.contract import TRANSPORT

BOLTZMANN = 1.380649e-23  # J/K, exact by definition of the kelvin
_SQRT_PI_CUBED = 5.568327996831707


class HardSphereViscosity(NamedTuple):
    molecular_mass: float
    diameter: float


def viscosity(rho, T, par):
    return 2.0 / (3.0 * _SQRT_PI_CUBED) * vsqrt(par.molecular_mass * BOLTZMANN * T) / (par.diameter * par.diameter)


TRANSPORT.add(
    "hard_sphere", HardSphereViscosity, functions=[viscosity], example=HardSphereViscosity(6.6335e-26, 2.95e-10),
    units={"molecular_mass": "kg", "diameter": "m"},
    meaning={"molecular_mass": "mass of a molecule", "diameter": "diameter of a molecule"},
    box={"rho": (1e-3, 1e2), "T": (50.0, 1e5)},
    references=("Jordan 2011, section 6.2, Maxwell's viscosity model (formula damaged in our copy)",
                "Bird, Stewart and Lightfoot, Transport Phenomena (1960), eq. 1.4-9"),
    flags=("needs_temperature",),
)
