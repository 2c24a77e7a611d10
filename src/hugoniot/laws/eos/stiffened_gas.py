r"""Stiffened gas: an ideal gas under a constant internal pressure, for liquids.

$$p = (\gamma - 1)\rho e - \gamma P_\infty, \qquad T = \frac{e - P_\infty/\rho}{c_v}, \qquad
  s = c_v \ln\frac{T}{T_0} - (\gamma - 1)c_v\ln\frac{\rho}{\rho_0}$$

$P_\infty > 0$ is minus the $p_\infty$ of the source, which has the opposite sign (S-E8). The adiabatic exponent is $\gamma(p + P_\infty)/p$
(S-E6). T0 is the temperature at rest, that is, at rho0 and zero pressure.

Source: Starkenberg A-8.
"""

import math
from typing import NamedTuple

from hugoniot.core.ops import vlog
from hugoniot.laws.eos.contract import EOS


class StiffenedGas(NamedTuple):
    gamma: float
    p_infinity: float
    rho0: float = 1000.0
    specific_heat: float = math.nan


def pressure(rho, e, par):
    return (par.gamma - 1.0) * rho * e - par.gamma * par.p_infinity


def pressure_derivatives(rho, e, par):
    return (par.gamma - 1.0) * e, (par.gamma - 1.0) * rho


def energy(rho, p, par):
    return (p + par.gamma * par.p_infinity) / ((par.gamma - 1.0) * rho)


def temperature(rho, e, par):
    return (e - par.p_infinity / rho) / par.specific_heat


def specific_heat(rho, e, par):
    return par.specific_heat


def entropy(rho, e, par):
    """Zero at rho0 with zero pressure."""
    thermal = par.p_infinity / ((par.gamma - 1.0) * par.rho0)
    return par.specific_heat * (vlog((e - par.p_infinity / rho) / thermal) - (par.gamma - 1.0) * vlog(rho / par.rho0))


def reference_isentrope(rho, par):
    """The one at zero temperature (Starkenberg A-8: de = P dv at p = -P)."""
    return par.p_infinity / rho, (par.gamma - 1.0) * vlog(rho / par.rho0)


def reference_state(par):
    """Zero pressure at the nominal density."""
    return par.rho0, par.gamma * par.p_infinity / ((par.gamma - 1.0) * par.rho0)


def density_limits(par):
    return 0.0, math.inf


EOS.add(
    "stiffened_gas", StiffenedGas,
    functions=[pressure, pressure_derivatives, energy, temperature, specific_heat, entropy, reference_state, density_limits,
               reference_isentrope],
    example=StiffenedGas(4.4, 6e8, 1000.0, 1400.0),
    units={"gamma": "1", "p_infinity": "Pa", "rho0": "kg/m^3", "specific_heat": "J/kg/K"},
    meaning={"gamma": "exponent", "p_infinity": "internal pressure P (positive)", "rho0": "density at rest, zero pressure",
             "specific_heat": "specific heat at constant volume (for temperatures)"},
    defaults={"rho0": 1000.0, "specific_heat": math.nan},
    box={"rho": (700.0, 3000.0), "e": (9e5, 2e7)},
    references=("Starkenberg, ARL-TR-2161, A-8 (corrected: S-E6, S-E7, S-E8, S-E9)",),
    flags=("linear_in_energy",),
)
