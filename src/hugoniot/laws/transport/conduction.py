r"""Thermal conductivity of a material: zero, from a Prandtl number, constant, or a power of the temperature.

$$k = 0 \;(\text{none}), \qquad k = \mu c_p/\mathrm{Pr} \;(\text{prandtl}), \qquad k = k_0 \;(\text{constant}), \qquad
  k = k_0\,(T/T_0)^{\omega} \;(\text{power law})$$

* $k$: thermal conductivity; the heat flux is $-k\,\partial T/\partial x$
* $\mu$: shear viscosity; $c_p$: specific heat at constant pressure; $\mathrm{Pr}$: Prandtl number, `prandtl`
* $k_0$: `conductivity`; $T_0$: `reference_temperature`; $\omega$: `exponent`

The specific heat $c_p$ is that of the equation of state, $c_p = c_v c^2/(c^2 - \Gamma^2 c_v T)$, with the specific heat $c_v$ at constant
volume, the sound speed $c$ and the Grüneisen parameter $\Gamma$. The Prandtl number of argon is 2/3.
"""

from typing import NamedTuple

from hugoniot.core.ops import vpow
from hugoniot.laws.transport.contract import CONDUCTION

_BOX = {"rho": (1e-3, 1e4), "T": (50.0, 1e5)}


class NoConduction(NamedTuple):
    pass


class PrandtlConduction(NamedTuple):
    prandtl: float


class ConstantConduction(NamedTuple):
    conductivity: float


class PowerLawConduction(NamedTuple):
    conductivity: float
    exponent: float
    reference_temperature: float


def no_conductivity(rho, T, mu, cp, par):
    return 0.0


def prandtl_conductivity(rho, T, mu, cp, par):
    return mu * cp / par.prandtl


def constant_conductivity(rho, T, mu, cp, par):
    return par.conductivity


def power_law_conductivity(rho, T, mu, cp, par):
    return par.conductivity * vpow(T / par.reference_temperature, par.exponent)


CONDUCTION.add(
    "none", NoConduction, line="No heat conduction.",
    functions={"conductivity": no_conductivity}, example=NoConduction(), units={}, meaning={}, box=_BOX,
    references=("Jordan 2011, section 7.1: conduction is small in the energy balance of shocks in water",),
)
CONDUCTION.add(
    "prandtl", PrandtlConduction, line="Thermal conductivity from the Prandtl number.",
    functions={"conductivity": prandtl_conductivity}, example=PrandtlConduction(2.0 / 3.0),
    units={"prandtl": "1"}, meaning={"prandtl": "Prandtl number mu c_p / k"}, box=_BOX,
    references=("Jordan 2011, section 6.3 and tables 7.1.1, 7.2.1",),
)
CONDUCTION.add(
    "constant", ConstantConduction, line="Constant thermal conductivity.",
    functions={"conductivity": constant_conductivity}, example=ConstantConduction(0.0177),
    units={"conductivity": "W/m/K"}, meaning={"conductivity": "thermal conductivity"}, box=_BOX,
    references=("Fourier's law; Bird, Stewart and Lightfoot, Transport Phenomena (1960), eq. 8.1-6",),
)
CONDUCTION.add(
    "power_law", PowerLawConduction, line="Thermal conductivity as a power of the temperature.",
    functions={"conductivity": power_law_conductivity},
    example=PowerLawConduction(0.0177, 0.81, 300.0),
    units={"conductivity": "W/m/K", "exponent": "1", "reference_temperature": "K"},
    meaning={"conductivity": "thermal conductivity at the reference temperature",
             "exponent": "power of the temperature; the default is that of argon",
             "reference_temperature": "temperature of the given conductivity"},
    defaults={"exponent": 0.81, "reference_temperature": 300.0}, box=_BOX,
    references=("Jordan 2011, section 6.2, power law model", "Bird, Molecular Gas Dynamics (1994), section 4.3"),
)
