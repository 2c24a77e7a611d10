r"""Maxwell's elementary kinetic theory of hard spheres: one literal reading of Jordan's "Maxwell viscosity".

$$\mu = \frac{2}{3\,d^2}\sqrt{\frac{m k_B T}{\pi^3}} = \frac{2}{3\pi d^2}\sqrt{\frac{m k_B T}{\pi}} \;\propto\; \sqrt{T}$$

Source: Jordan section 6.2, where the formula is damaged; this is the form of Bird, Stewart and Lightfoot, Transport Phenomena,
eq. 1.4-9. Jordan's "Maxwell" numbers do not follow from it: they are those of the power law $T^{0.81}$ (J-E4).
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
    meaning={"molecular_mass": "mass of one molecule", "diameter": "diameter of the sphere"},
    box={"rho": (1e-3, 1e2), "T": (50.0, 1e5)},
    references=("Jordan 2011, section 6.2, Maxwell's viscosity model (as a formula)",
                "Bird, Stewart and Lightfoot, Transport Phenomena (1960), eq. 1.4-9"),
    flags=("needs_temperature",),
)
