r"""Sutherland's shear viscosity of gases: hard spheres with a weak attraction.

$$\mu = \mu_0\left(\frac{T}{T_0}\right)^{3/2}\frac{T_0 + S}{T + S}$$

* $\mu_0$: viscosity at $T_0$, `shear_viscosity`; $T_0$: `reference_temperature`; $T$: temperature
* $S$: Sutherland's constant, `sutherland_temperature`, about 144 K for argon

The equation of state must give a temperature.
"""

from typing import NamedTuple

from hugoniot.core.ops import vsqrt
from hugoniot.laws.transport.contract import TRANSPORT


class SutherlandViscosity(NamedTuple):
    shear_viscosity: float
    reference_temperature: float
    sutherland_temperature: float


def viscosity(rho, T, par):
    ratio = T / par.reference_temperature
    return (par.shear_viscosity * ratio * vsqrt(ratio)
            * (par.reference_temperature + par.sutherland_temperature) / (T + par.sutherland_temperature))


TRANSPORT.add(
    "sutherland", SutherlandViscosity, functions=[viscosity], example=SutherlandViscosity(2.27e-5, 300.0, 144.4),
    units={"shear_viscosity": "Pa s", "reference_temperature": "K", "sutherland_temperature": "K"},
    meaning={"shear_viscosity": "shear viscosity at the reference temperature",
             "reference_temperature": "temperature of the given viscosity", "sutherland_temperature": "Sutherland's constant S"},
    box={"rho": (1e-3, 1e2), "T": (100.0, 3e3)},
    references=("Sutherland, Phil. Mag. 36 (1893) 507", "White, Viscous Fluid Flow, table 1-2, for argon",),
    flags=("needs_temperature",),
)
