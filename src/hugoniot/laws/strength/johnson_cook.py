r"""Johnson-Cook: flow stress as a product of strain hardening, rate hardening and thermal softening.

$$Y = \left(A + B\,\varepsilon_p^{\,n}\right)\left(1 + C \ln\frac{\dot\varepsilon}{\dot\varepsilon_0}\right)\left(1 - T^{*m}\right),
  \qquad T^* = \frac{T - T_r}{T_m - T_r}, \qquad G = G_0$$

* $Y$: flow stress in uniaxial stress; $G$: shear modulus, constant, `shear_modulus`
* $A$, $B$, $n$: `yield_stress`, `hardening_coefficient`, `hardening_exponent`; $\varepsilon_p$: accumulated equivalent plastic strain
* $C$: `rate_coefficient`; $\dot\varepsilon$: equivalent strain rate; $\dot\varepsilon_0$: `reference_rate`
* $m$: `thermal_exponent`; $T_r$, $T_m$: `room_temperature`, `melt_temperature`; $T$: temperature of the equation of state

The rate factor is set to 1 below the reference rate, where the law was not fitted. The thermal factor is 1 below $T_r$ and 0 above $T_m$.
The shear modulus stays constant above $T_m$, because the law does not describe it. The equation of state must give a temperature.
The example is OFHC copper.
"""

from typing import NamedTuple

from hugoniot.core.ops import vlog, vpow
from hugoniot.errors import OutOfRange
from hugoniot.laws.strength.contract import STRENGTH


class JohnsonCook(NamedTuple):
    shear_modulus: float
    yield_stress: float
    hardening_coefficient: float
    hardening_exponent: float
    rate_coefficient: float
    thermal_exponent: float
    room_temperature: float
    melt_temperature: float
    reference_rate: float = 1.0


def shear_modulus(rho, p, temperature, bulk_modulus, par):
    return par.shear_modulus


def flow_stress(rho, p, temperature, plastic_strain, strain_rate, par):
    hardening = par.hardening_coefficient * vpow(plastic_strain, par.hardening_exponent) if plastic_strain > 0.0 else 0.0
    rate = 1.0 + par.rate_coefficient * vlog(strain_rate / par.reference_rate) if strain_rate > par.reference_rate else 1.0
    if temperature >= par.melt_temperature:
        thermal = 0.0
    elif temperature > par.room_temperature:
        warm = (temperature - par.room_temperature) / (par.melt_temperature - par.room_temperature)
        thermal = 1.0 - vpow(warm, par.thermal_exponent)
    else:
        thermal = 1.0
    return (par.yield_stress + hardening) * rate * thermal


def build(**values):
    """Parameters; the melting temperature must lie above room temperature and the reference rate above zero."""
    par = JohnsonCook(**values)
    if par.melt_temperature <= par.room_temperature:
        raise OutOfRange(f"melt_temperature = {par.melt_temperature:g} K must be above room_temperature = {par.room_temperature:g} K")
    if par.reference_rate <= 0.0:
        raise OutOfRange(f"reference_rate = {par.reference_rate:g} 1/s must be positive; Johnson and Cook used 1 per second")
    return par


STRENGTH.add(
    "johnson_cook", JohnsonCook,
    functions=[shear_modulus, flow_stress],
    example=JohnsonCook(46e9, 90e6, 292e6, 0.31, 0.025, 1.09, 294.0, 1356.0),
    build=build,
    units={
        "shear_modulus": "Pa", "yield_stress": "Pa", "hardening_coefficient": "Pa", "hardening_exponent": "1",
        "rate_coefficient": "1", "thermal_exponent": "1", "room_temperature": "K", "melt_temperature": "K", "reference_rate": "1/s",
    },
    meaning={
        "shear_modulus": "shear modulus",
        "yield_stress": "A, flow stress at first yield at room temperature and the reference rate",
        "hardening_coefficient": "B, coefficient of strain hardening",
        "hardening_exponent": "n, exponent of strain hardening",
        "rate_coefficient": "C, coefficient of rate hardening",
        "thermal_exponent": "m, exponent of thermal softening",
        "room_temperature": "temperature below which there is no thermal softening",
        "melt_temperature": "temperature at which the flow stress vanishes",
        "reference_rate": "reference strain rate, below which the rate has no effect",
    },
    defaults={"reference_rate": 1.0},
    box={"rho": (8000.0, 14000.0), "p": (-5e9, 1e11), "temperature": (0.0, 3000.0), "bulk_modulus": (1e9, 1e12),
         "plastic_strain": (0.0, 10.0), "strain_rate": (0.0, 1e9)},
    least={"hardening_coefficient": 0.0, "hardening_exponent": 0.0, "rate_coefficient": 0.0, "thermal_exponent": 0.0},
    references=("Johnson & Cook, Proc. 7th Int. Symp. on Ballistics (1983) 541, equation 1 and table 1",),
    flags=("hardens", "needs_temperature", "needs_rate"),
)
