r"""JWL form for unreacted explosives and other solids, with rho Gamma constant instead of Gamma.

$$p = A\left(1 - \frac{\Gamma_0}{R_1}\right)e^{-R_1V} + B\left(1 - \frac{\Gamma_0}{R_2}\right)e^{-R_2V} + \rho_0\Gamma_0e,
  \qquad V = \rho_0/\rho$$

The reference state is the density $\rho_0$ with the energy $e_{\text{ref}}$ that gives zero pressure. All isentropes are
$e_S = h_S(V) + \text{const}\cdot e^{-\Gamma_0V}$ with $h_S = (A/R_1\,e^{-R_1V} + B/R_2\,e^{-R_2V})/\rho_0$. With a constant specific heat
$c_v$ the temperature is

$$T = T_0e^{\Gamma_0(1-V)} + \frac{e - e_S}{c_v}, \qquad e_S = h_S(V) + [e_{\text{ref}} - h_S(1)]\,e^{\Gamma_0(1-V)}.$$

Constants fitted for `jwl_unreacted` ($\Gamma$ constant) give other pressures in this form away from $V = 1$ and must be fitted again. The
constants of the example are such a set; they only show the syntax.

Source: Starkenberg, ARL-TR-2161, appendix A-10, with corrections S-E12 and S-E14.
"""

import math
from typing import NamedTuple

from hugoniot.core.ops import vexp, vlog
from hugoniot.laws.eos.contract import EOS


class JWLProportional(NamedTuple):
    a: float
    b: float
    r1: float
    r2: float
    gamma0: float
    rho0: float
    specific_heat: float = math.nan
    reference_temperature: float = 298.15


def _cold(v, par):
    return par.a * (1.0 - par.gamma0 / par.r1) * vexp(-par.r1 * v) + par.b * (1.0 - par.gamma0 / par.r2) * vexp(-par.r2 * v)


def pressure(rho, e, par):
    return _cold(par.rho0 / rho, par) + par.rho0 * par.gamma0 * e


def pressure_derivatives(rho, e, par):
    v = par.rho0 / rho
    slope = par.a * (par.r1 - par.gamma0) * vexp(-par.r1 * v) + par.b * (par.r2 - par.gamma0) * vexp(-par.r2 * v)
    return slope * v / rho, par.rho0 * par.gamma0


def energy(rho, p, par):
    return (p - _cold(par.rho0 / rho, par)) / (par.rho0 * par.gamma0)


def reference_isentrope(rho, par):
    """The exponential terms alone; energies beside them grow as exp(Gamma0 (1 - V))."""
    v = par.rho0 / rho
    return (par.a / par.r1 * vexp(-par.r1 * v) + par.b / par.r2 * vexp(-par.r2 * v)) / par.rho0, par.gamma0 * (1.0 - v)


def temperature(rho, e, par):
    h, logarithm = reference_isentrope(rho, par)
    growth = vexp(logarithm)
    e_rest = -_cold(1.0, par) / (par.rho0 * par.gamma0)
    e_s = h + (e_rest - reference_isentrope(par.rho0, par)[0]) * growth
    return par.reference_temperature * growth + (e - e_s) / par.specific_heat


def specific_heat(rho, e, par):
    return par.specific_heat


def entropy(rho, e, par):
    """Zero at the reference state."""
    ratio = temperature(rho, e, par) / par.reference_temperature
    return par.specific_heat * (vlog(ratio) - par.gamma0 * (1.0 - par.rho0 / rho))


def reference_state(par):
    return par.rho0, -_cold(1.0, par) / (par.rho0 * par.gamma0)


def density_limits(par):
    return 0.0, math.inf


EOS.add(
    "jwl_proportional", JWLProportional,
    functions=[pressure, pressure_derivatives, energy, temperature, specific_heat, entropy, reference_state, density_limits,
               reference_isentrope],
    example=JWLProportional(77810e9, -5.031e9, 11.3, 1.13, 0.8938, 1717.0, 1000.0),
    units={"a": "Pa", "b": "Pa", "r1": "1", "r2": "1", "gamma0": "1", "rho0": "kg/m^3", "specific_heat": "J/kg/K",
           "reference_temperature": "K"},
    meaning={"a": "coefficient of the first exponential", "b": "coefficient of the second exponential, usually negative",
             "r1": "exponent of the first exponential", "r2": "exponent of the second exponential",
             "gamma0": "Grüneisen parameter at the reference density", "rho0": "reference density",
             "specific_heat": "specific heat at constant volume, needed for temperatures",
             "reference_temperature": "temperature of the reference state"},
    defaults={"specific_heat": math.nan, "reference_temperature": 298.15},
    box={"rho": (1600.0, 4000.0), "e": (-1e5, 1e7)},
    references=("Starkenberg, ARL-TR-2161, appendix A-10 (corrected: S-E12, S-E14)",),
    flags=("linear_in_energy",),
)
