r"""Constant shear viscosity.

$$\mu = \mu_0$$

with $\mu_0$ = `shear_viscosity`. It suits liquids and gases whose temperature changes little.
"""

from typing import NamedTuple

from hugoniot.laws.transport.contract import TRANSPORT


class ConstantViscosity(NamedTuple):
    shear_viscosity: float


def viscosity(rho, T, par):
    return par.shear_viscosity


TRANSPORT.add(
    "constant", ConstantViscosity, functions=[viscosity], example=ConstantViscosity(2.27e-5),
    units={"shear_viscosity": "Pa s"}, meaning={"shear_viscosity": "shear viscosity"},
    box={"rho": (1e-3, 1e4), "T": (50.0, 1e5)}, references=("Jordan 2011, section 6.2, constant viscosity",),
)
