r"""Shear viscosity of a gas as a power of the temperature.

$$\mu = \mu_0\,(T/T_0)^{\omega}$$

* $\mu_0$: viscosity at $T_0$, `shear_viscosity`; $T_0$: `reference_temperature`; $\omega$: `exponent`; $T$: temperature

The default exponent is that of argon. The equation of state must give a temperature. Both the "power law" and the "Maxwell" rows of
Jordan's table 6.2.1.1 follow from this law: they are the same profile, scaled by two different mean free paths (J-E4).
"""

from typing import NamedTuple

from hugoniot.core.ops import vpow
from hugoniot.laws.transport.contract import TRANSPORT


class PowerLawViscosity(NamedTuple):
    shear_viscosity: float
    exponent: float
    reference_temperature: float


def viscosity(rho, T, par):
    return par.shear_viscosity * vpow(T / par.reference_temperature, par.exponent)


TRANSPORT.add(
    "power_law", PowerLawViscosity, functions=[viscosity], example=PowerLawViscosity(2.27e-5, 0.81, 300.0),
    units={"shear_viscosity": "Pa s", "exponent": "1", "reference_temperature": "K"},
    meaning={"shear_viscosity": "shear viscosity at the reference temperature", "exponent": "power of the temperature",
             "reference_temperature": "temperature of the given viscosity"},
    defaults={"exponent": 0.81, "reference_temperature": 300.0},
    box={"rho": (1e-3, 1e2), "T": (50.0, 1e5)},
    references=("Jordan 2011, section 6.2, power law model", "Bird, Molecular Gas Dynamics (1994), section 4.3"),
    flags=("needs_temperature",),
)
