r"""Stiffened gas: an ideal gas under a constant internal pressure, for liquids.

$$p = (\gamma - 1)\rho e - \gamma P_\infty$$

It is the simplest law with a liquid's sound speed, $c^2 = \gamma(p + P_\infty)/\rho$, and supports tensions up to $P_\infty$. Choose
$\gamma$ and $P_\infty > 0$ to match $\rho_0$, $c_0$ and the initial slope $dU_s/du_p = (\gamma + 1)/4$ of the Hugoniot. The adiabatic
exponent $\rho c^2/p$ is not $\gamma$ but $\gamma(p + P_\infty)/p$ (S-E6).

$$T = \frac{e - P_\infty/\rho}{c_v}, \qquad s = c_v \ln\frac{T}{T_0} - (\gamma - 1)c_v\ln\frac{\rho}{\rho_0}$$

with a constant specific heat $c_v$. The temperature of the reference state (density $\rho_0$, zero pressure) follows from the other
constants, $T_0 = P_\infty/[(\gamma - 1)\rho_0c_v]$, and is 126 K for the example: choose $c_v$ for a given $T_0$ where temperatures
matter.

Source: Starkenberg, ARL-TR-2161, appendix A-8, with corrections S-E6, S-E7, S-E8 and S-E9. The source writes $p_\infty = -P_\infty$ (S-E8).
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
    meaning={"gamma": "exponent of the law", "p_infinity": "internal pressure, positive",
             "rho0": "reference density, at zero pressure",
             "specific_heat": "specific heat at constant volume, needed for temperatures"},
    defaults={"rho0": 1000.0, "specific_heat": math.nan},
    box={"rho": (700.0, 3000.0), "e": (9e5, 2e7)},
    references=("Starkenberg, ARL-TR-2161, appendix A-8 (corrected: S-E6, S-E7, S-E8, S-E9)",),
    flags=("linear_in_energy",),
)
