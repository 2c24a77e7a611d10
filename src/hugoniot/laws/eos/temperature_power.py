r"""Specific heat that varies with temperature, for an equation of state whose own specific heat is constant.

The pressure is that of the base law. At constant volume the specific heat varies as a power of the temperature:

$$T = T_S\left[1 + \frac{e - e_S}{w\,c_{v0}T_S}\right]^w, \qquad c_v = c_{v0}\left(\frac{T}{T_S}\right)^{(1-w)/w}$$

$T_S(\rho)$ and $e_S(\rho)$ are temperature and energy on the isentrope of the base law through the reference state, $c_{v0}$ is the
specific heat of the base law, and $w$ the exponent. $w = 1$ gives the base law, and $w < 1$ a specific heat that grows on heating.
Temperature and specific heat in the reference state are those of the base law. With the entropy $s_1$ of the base law, zero in the
reference state, the entropy is

$$s = w\,c_{v0}\,\frac{y^{1-w} - 1}{1-w}, \qquad y = 1 + \frac{\exp(s_1/c_{v0}) - 1}{w}.$$

The source calls $w < 1$ inconsistent with quantum statistics at high temperature.

Source: Starkenberg, ARL-TR-2161, appendix A-4.
"""

import math
from typing import Any, NamedTuple

from hugoniot.core.ops import vexp, vlog, vpow
from hugoniot.errors import OutOfRange
from hugoniot.laws.eos.contract import EOS, has_temperature
from hugoniot.laws.eos.contract import density_limits as base_density_limits
from hugoniot.laws.eos.contract import energy as base_energy
from hugoniot.laws.eos.contract import entropy as base_entropy
from hugoniot.laws.eos.contract import particle_velocity_limit as base_velocity_limit
from hugoniot.laws.eos.contract import pressure as base_pressure
from hugoniot.laws.eos.contract import pressure_derivatives as base_derivatives
from hugoniot.laws.eos.contract import reference_state as base_reference_state
from hugoniot.laws.eos.contract import specific_heat as base_specific_heat
from hugoniot.laws.eos.contract import temperature as base_temperature
from hugoniot.laws.eos.jwl_proportional import JWLProportional


class TemperaturePower(NamedTuple):
    base: Any
    exponent: float


def heating(rho, e, par):
    """(y, y1): (T/T0 phi)^(1/w), and the same with w = 1."""
    rho0, e0 = base_reference_state(par.base)
    c = base_specific_heat(rho0, e0, par.base)
    first = vexp((base_entropy(rho, e, par.base) - base_entropy(rho0, e0, par.base)) / c)
    return 1.0 + (first - 1.0) / par.exponent, first


def pressure(rho, e, par):
    return base_pressure(rho, e, par.base)


def pressure_derivatives(rho, e, par):
    return base_derivatives(rho, e, par.base)


def energy(rho, p, par):
    return base_energy(rho, p, par.base)


def temperature(rho, e, par):
    y, first = heating(rho, e, par)
    return base_temperature(rho, e, par.base) / first * vpow(y, par.exponent)


def specific_heat(rho, e, par):
    return base_specific_heat(rho, e, par.base) * vpow(heating(rho, e, par)[0], 1.0 - par.exponent)


def entropy(rho, e, par):
    """Zero in the reference state."""
    rho0, e0 = base_reference_state(par.base)
    logarithm = vlog(heating(rho, e, par)[0])
    rest = 1.0 - par.exponent
    grown = (vexp(rest * logarithm) - 1.0) / rest if rest * rest > 1e-20 else logarithm
    return par.exponent * base_specific_heat(rho0, e0, par.base) * grown


def reference_state(par):
    return base_reference_state(par.base)


def density_limits(par):
    return base_density_limits(par.base)


def particle_velocity_limit(par):
    return base_velocity_limit(par.base)


def build(base, exponent):
    """Parameters; the base needs a constant specific heat, a temperature and an entropy."""
    functions = EOS.of(base).functions
    if not {"temperature", "entropy", "specific_heat", "energy"} <= set(functions) or not has_temperature(base):
        raise OutOfRange(f"temperature_power: '{EOS.of(base).name}' has no temperature unless a specific heat is given; "
                         "give a specific_heat")
    if not (0.0 < exponent < math.inf):
        raise OutOfRange(f"temperature_power: exponent = {exponent:g} must be positive; 1 is a constant specific heat")
    return TemperaturePower(base, exponent)


EOS.add(
    "temperature_power", TemperaturePower,
    functions=[pressure, pressure_derivatives, energy, temperature, specific_heat, entropy, reference_state, density_limits,
               particle_velocity_limit],
    example=TemperaturePower(JWLProportional(77810e9, -5.031e9, 11.3, 1.13, 0.8938, 1717.0, 1000.0), 0.7),
    build=build,
    units={"base": "law", "exponent": "1"},
    meaning={"base": "equation of state with a constant specific heat, which this law changes",
             "exponent": "w in the equations; 1 gives the specific heat of the base law"},
    box={"rho": (1717.0, 2600.0), "e": (1e6, 5e6)},
    references=("Starkenberg, ARL-TR-2161, appendix A-4",),
)
