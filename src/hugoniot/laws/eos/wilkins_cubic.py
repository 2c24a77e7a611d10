r"""Mie-Grüneisen equation of state as a cubic in strain, as in Wilkins' KO codes.

It is included so that decks of those codes give the same numbers. In new decks use `mie_gruneisen`, of which this is the expansion about
the reference state:

$$p = k_1x + k_2x^2 + k_3x^3 + \Gamma_0\rho_0e, \qquad x = 1 - \rho_0/\rho, \qquad k_2 = 0 \text{ for } x < 0,$$
$$k_1 = \rho_0c_0^2, \quad k_2 = k_1\left(2s - \tfrac12\Gamma_0\right), \quad k_3 = k_1s\,(3s - \Gamma_0).$$

In compression its Hugoniot lies below that of the linear Us-up relation from which it was derived (copper:
by 0.6 % in pressure at a strain of 0.1, 16 % at 0.3).

With a constant specific heat $c_v$ the temperature is $T = T_0e^{\Gamma_0x} + (e - e_S)/c_v$ with the isentrope through the reference
state

$$\rho_0e_S = \sum_{n=1}^3 k_nJ_n, \qquad J_n = \int_0^x y^n e^{\Gamma_0(x-y)}\,dy = \frac{\Gamma_0J_{n+1} + x^{n+1}}{n+1}, \qquad
  J_3 = x^4\sum_{m\ge0}\frac{3!\,(\Gamma_0x)^m}{(m+4)!}.$$

Source: Wilkins, Computer Simulation of Dynamic Phenomena (1999), eq. 3.58; Jordan (2011), section 7.1, has the same coefficients.
"""

import math
from typing import NamedTuple

from hugoniot.core.ops import vexp, vlog
from hugoniot.laws.eos.contract import EOS

_TERMS = 30     # of J_3: the rest is below round-off for |gamma0 x| < 4


class WilkinsCubic(NamedTuple):
    rho0: float
    c0: float
    s: float
    gamma0: float
    specific_heat: float = math.nan
    reference_temperature: float = 298.15


def _coefficients(x, par):
    k1 = par.rho0 * par.c0 * par.c0
    return k1, (k1 * (2.0 * par.s - 0.5 * par.gamma0) if x > 0.0 else 0.0), k1 * par.s * (3.0 * par.s - par.gamma0)


def pressure(rho, e, par):
    x = 1.0 - par.rho0 / rho
    k1, k2, k3 = _coefficients(x, par)
    return x * (k1 + x * (k2 + x * k3)) + par.gamma0 * par.rho0 * e


def pressure_derivatives(rho, e, par):
    x = 1.0 - par.rho0 / rho
    k1, k2, k3 = _coefficients(x, par)
    return (k1 + x * (2.0 * k2 + 3.0 * x * k3)) * par.rho0 / (rho * rho), par.gamma0 * par.rho0


def energy(rho, p, par):
    return (p - pressure(rho, 0.0, par)) / (par.gamma0 * par.rho0)


def reference_isentrope(rho, par):
    """(e, ln T/T0) on the isentrope through the reference state; energies beside it grow as the temperature."""
    x = 1.0 - par.rho0 / rho
    k1, k2, k3 = _coefficients(x, par)
    g = par.gamma0
    term = 0.25
    j3 = term
    for m in range(1, _TERMS):
        term = term * g * x / (m + 4)
        j3 = j3 + term
    j3 = j3 * x * x * x * x
    j2 = (g * j3 + x * x * x) / 3.0
    j1 = (g * j2 + x * x) / 2.0
    return (k1 * j1 + k2 * j2 + k3 * j3) / par.rho0, g * x


def temperature(rho, e, par):
    e_s, growth = reference_isentrope(rho, par)
    return par.reference_temperature * vexp(growth) + (e - e_s) / par.specific_heat


def specific_heat(rho, e, par):
    return par.specific_heat


def entropy(rho, e, par):
    """Zero at the reference state."""
    return par.specific_heat * (vlog(temperature(rho, e, par) / par.reference_temperature) - par.gamma0 * (1.0 - par.rho0 / rho))


def reference_state(par):
    return par.rho0, 0.0


def density_limits(par):
    return 0.0, math.inf


EOS.add(
    "wilkins_cubic", WilkinsCubic,
    functions=[pressure, pressure_derivatives, energy, temperature, specific_heat, entropy, reference_state, density_limits,
               reference_isentrope],
    example=WilkinsCubic(8930.0, 3900.0, 1.49, 1.99, 385.0),
    units={"rho0": "kg/m^3", "c0": "m/s", "s": "1", "gamma0": "1", "specific_heat": "J/kg/K", "reference_temperature": "K"},
    meaning={"rho0": "reference density", "c0": "shock velocity at zero particle velocity", "s": "slope of the Hugoniot, dUs/dup",
             "gamma0": "Grüneisen parameter at the reference density",
             "specific_heat": "specific heat at constant volume, needed for temperatures",
             "reference_temperature": "temperature of the reference state"},
    defaults={"specific_heat": math.nan, "reference_temperature": 298.15},
    box={"rho": (8000.0, 14000.0), "e": (0.0, 5e6)},
    references=("Wilkins, Computer Simulation of Dynamic Phenomena (1999), eq. 3.58", "Jordan 2011, section 7.1"),
    flags=("linear_in_energy",),
)
