r"""JWL form fitted to an unreacted explosive, with zero pressure in the reference state.

$$p = A\left(1 - \frac{\omega}{R_1V}\right)e^{-R_1V} + B\left(1 - \frac{\omega}{R_2V}\right)e^{-R_2V} + \omega\rho e,
  \qquad V = \rho_0/\rho$$

The pressure is that of the law `jwl`, whose page describes the limit of tension for $B < 0$. The reference state is $\rho_0$ with the
energy $e_{\text{ref}}$ that gives zero pressure. Published sets are made so that
$Ae^{-R_1} + Be^{-R_2} + \omega\rho_0c_vT_0 \approx 0$, which they satisfy to within about 15 MPa; no energy is given in a deck. With a
constant specific heat $c_v$ the temperature is

$$T = T_0V^{-\omega} + \frac{e - e_S}{c_v}, \qquad e_S = h_S(V) + [e_{\text{ref}} - h_S(1)]\,V^{-\omega}, \qquad
  h_S = \frac{1}{\rho_0}\left(\frac{A}{R_1}e^{-R_1V} + \frac{B}{R_2}e^{-R_2V}\right).$$

Source: Starkenberg, ARL-TR-2161, appendix A-9 and A-10.1; Lee and Tarver, Phys. Fluids 23, 2362 (1980), as cited there.
"""

import math
from typing import NamedTuple

from hugoniot.core.ops import vexp, vlog
from hugoniot.laws.eos import jwl
from hugoniot.laws.eos.contract import EOS


class JWLUnreacted(NamedTuple):
    a: float
    b: float
    r1: float
    r2: float
    omega: float
    rho0: float
    specific_heat: float = math.nan
    reference_temperature: float = 298.15


def _rest_energy(par):
    first, second = par.a * vexp(-par.r1), par.b * vexp(-par.r2)
    return -(first * (1.0 - par.omega / par.r1) + second * (1.0 - par.omega / par.r2)) / (par.omega * par.rho0)


def temperature(rho, e, par):
    energy_s, logarithm = jwl.reference_isentrope(rho, par)
    growth = vexp(logarithm)
    e_s = energy_s + (_rest_energy(par) - jwl.reference_isentrope(par.rho0, par)[0]) * growth
    return par.reference_temperature * growth + (e - e_s) / par.specific_heat


def specific_heat(rho, e, par):
    return par.specific_heat


def entropy(rho, e, par):
    """Zero at the reference state."""
    return par.specific_heat * (vlog(temperature(rho, e, par) / par.reference_temperature) - par.omega * vlog(rho / par.rho0))


def reference_state(par):
    return par.rho0, _rest_energy(par)


def density_limits(par):
    return 0.0, math.inf


EOS.add(
    "jwl_unreacted", JWLUnreacted,
    functions=[jwl.pressure, jwl.pressure_derivatives, jwl.energy, temperature, specific_heat, entropy, reference_state, density_limits,
               jwl.reference_isentrope],
    example=JWLUnreacted(77810e9, -5.031e9, 11.3, 1.13, 0.8938, 1905.0, 1305.5),
    units={"a": "Pa", "b": "Pa", "r1": "1", "r2": "1", "omega": "1", "rho0": "kg/m^3", "specific_heat": "J/kg/K",
           "reference_temperature": "K"},
    meaning={"a": "coefficient of the first exponential", "b": "coefficient of the second exponential, usually negative",
             "r1": "exponent of the first exponential", "r2": "exponent of the second exponential", "omega": "Grüneisen parameter",
             "rho0": "reference density", "specific_heat": "specific heat at constant volume, needed for temperatures",
             "reference_temperature": "temperature of the reference state"},
    defaults={"specific_heat": math.nan, "reference_temperature": 298.15},
    box={"rho": (1850.0, 4000.0), "e": (-3e5, 1e7)},
    references=("Starkenberg, ARL-TR-2161, appendix A-9, A-10.1", "Lee and Tarver, Phys. Fluids 23, 2362 (1980), as cited there"),
    flags=("linear_in_energy",),
)
