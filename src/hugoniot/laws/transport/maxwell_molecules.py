r"""Shear viscosity of a gas of Maxwell molecules, proportional to the temperature.

$$\mu = \mu_0\,T/T_0$$

* $\mu_0$: viscosity at $T_0$, `shear_viscosity`; $T_0$: `reference_temperature`; $T$: temperature

Maxwell molecules repel each other with a force that varies as the inverse fifth power of the distance. The equation of state must give a
temperature.
"""

from typing import NamedTuple

from hugoniot.laws.transport.contract import TRANSPORT


class MaxwellMoleculesViscosity(NamedTuple):
    shear_viscosity: float
    reference_temperature: float


def viscosity(rho, T, par):
    return par.shear_viscosity * T / par.reference_temperature


TRANSPORT.add(
    "maxwell_molecules", MaxwellMoleculesViscosity, functions=[viscosity], example=MaxwellMoleculesViscosity(2.27e-5, 300.0),
    units={"shear_viscosity": "Pa s", "reference_temperature": "K"},
    meaning={"shear_viscosity": "shear viscosity at the reference temperature",
             "reference_temperature": "temperature of the given viscosity"},
    box={"rho": (1e-3, 1e2), "T": (50.0, 1e5)},
    references=("Chapman and Cowling, The Mathematical Theory of Non-uniform Gases (1970), section 12.32",),
    flags=("needs_temperature",),
)
