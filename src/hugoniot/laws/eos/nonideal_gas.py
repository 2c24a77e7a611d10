r"""Nonideal gas for detonation products, referred to one isentrope, on which the pressure is a power of the density.

Use it for an explosive for which only one state of the products, usually the CJ state, and an exponent are known. The isentrope through
that state $(\rho_1, p_1)$ is $p_i = p_1(\rho/\rho_1)^\beta$ with the energy $e_i = p_i/[\rho(\beta-1)]$, and

$$p = \chi\rho^\beta + \Gamma\rho e, \qquad \chi = p_1\rho_1^{-\beta}\left(1 - \frac{\Gamma}{\beta - 1}\right)$$

with a constant Grüneisen parameter $\Gamma$. The products of a constant-volume explosion have the density $\rho_0$ and the energy
$E_0/\rho_0$. With a constant specific heat $c_v$ and the temperature $T_1$ of the known state,
$T = T_1(\rho/\rho_1)^\Gamma + (e - e_i)/c_v$.

Real products expand with a falling exponent; for large expansions use `jwl` or `davis_products`.

The CJ state, $\beta$ and $E_0$ of the example are those of Herrmann's pentolite; $\Gamma$, $c_v$ and $T_1$ are illustrative.

Source: Herrmann, WL-TR-64-107, equations C.19 to C.23; where the source prints "$p_i$ = 2.77" for pentolite, it means $\beta$ = 2.77
(H-E12).
"""

import math
from typing import NamedTuple

from hugoniot.core.ops import vexp, vlog, vpow
from hugoniot.laws.eos.contract import EOS


class NonidealGas(NamedTuple):
    rho1: float
    p1: float
    beta: float
    gamma: float
    rho0: float
    e0: float = 0.0
    specific_heat: float = math.nan
    reference_temperature: float = math.nan


def pressure(rho, e, par):
    on_isentrope = par.p1 * vpow(rho / par.rho1, par.beta)
    return on_isentrope * (1.0 - par.gamma / (par.beta - 1.0)) + par.gamma * rho * e


def pressure_derivatives(rho, e, par):
    on_isentrope = par.p1 * vpow(rho / par.rho1, par.beta)
    return on_isentrope * (1.0 - par.gamma / (par.beta - 1.0)) * par.beta / rho + par.gamma * e, par.gamma * rho


def energy(rho, p, par):
    return (p - pressure(rho, 0.0, par)) / (par.gamma * rho)


def reference_isentrope(rho, par):
    """The measured one; energies beside it grow as rho^Gamma."""
    x = rho / par.rho1
    return par.p1 / par.rho1 * vpow(x, par.beta - 1.0) / (par.beta - 1.0), par.gamma * vlog(x)


def temperature(rho, e, par):
    e_i, growth = reference_isentrope(rho, par)
    return par.reference_temperature * vexp(growth) + (e - e_i) / par.specific_heat


def specific_heat(rho, e, par):
    return par.specific_heat


def entropy(rho, e, par):
    """Zero at (rho1, p1)."""
    return par.specific_heat * (vlog(temperature(rho, e, par) / par.reference_temperature) - par.gamma * vlog(rho / par.rho1))


def reference_state(par):
    """The products at the density and energy of the explosive (constant-volume explosion)."""
    return par.rho0, par.e0 / par.rho0


def density_limits(par):
    return 0.0, math.inf


EOS.add(
    "nonideal_gas", NonidealGas,
    functions=[pressure, pressure_derivatives, energy, temperature, specific_heat, entropy, reference_state, density_limits,
               reference_isentrope],
    example=NonidealGas(2333.0, 29.0289e9, 2.77, 0.9, 1714.0, 8.2e9, 1300.0, 3500.0),
    units={"rho1": "kg/m^3", "p1": "Pa", "beta": "1", "gamma": "1", "rho0": "kg/m^3", "e0": "J/m^3", "specific_heat": "J/kg/K",
           "reference_temperature": "K"},
    meaning={"rho1": "density of the known state of the products, usually the CJ state",
             "p1": "pressure of the known state of the products", "beta": "exponent of the isentrope", "gamma": "Grüneisen parameter",
             "rho0": "density of the unreacted explosive", "e0": "detonation energy per volume of unreacted explosive",
             "specific_heat": "specific heat at constant volume, needed for temperatures",
             "reference_temperature": "temperature of the known state, needed for temperatures"},
    defaults={"e0": 0.0, "specific_heat": math.nan, "reference_temperature": math.nan},
    box={"rho": (50.0, 3500.0), "e": (1e6, 2e7)},
    references=("Herrmann, WL-TR-64-107, eq. C.19 to C.23",),
    flags=("linear_in_energy", "gas", "reacted"),
)
