r"""Power series in the compression eta = 1 - rho0/rho, linear in energy, as in Herrmann's codes.

Use it for published coefficients of this form:

$$p = k_0\eta\,(1 + k_1\eta + k_2\eta^2 + k_3\eta^3) + e\,h_0\,(1 + h_1\eta + h_2\eta^2 + h_3\eta^3), \qquad \eta = 1 - \rho_0/\rho$$

The factor of $e$ is $\rho\Gamma$, so $h_0 = \rho_0\Gamma_0$. `hugoniot eos convert` computes the coefficients from $c_0$ and $s$, or from
Murnaghan, finite-strain or Rice-McQueen-Walsh constants. With $h_0 = 0$ the pressure depends on the density alone. The series is used
unchanged in tension.

With a constant specific heat $c_v$ the temperature is

$$T = T_0\varphi + \frac{e - e_S}{c_v}, \qquad \ln\varphi = \frac{h_0}{\rho_0}\left(\eta + \tfrac12h_1\eta^2 + \tfrac13h_2\eta^3
  + \tfrac14h_3\eta^4\right), \qquad e_S = \frac{\varphi}{\rho_0}\int_0^\eta \frac{p(t, 0)}{\varphi(t)}\,dt,$$

where $e_S$ is the isentrope through the reference state, evaluated with 16 Gauss points.

Source: Herrmann, WL-TR-64-107, eq. 3.6, A.11, A.12, C.1, C.16.
"""

import math
from typing import NamedTuple

from hugoniot.core.ops import vexp, vlog
from hugoniot.laws.eos.contract import EOS
from hugoniot.laws.eos.special import quadrature


class HerrmannSeries(NamedTuple):
    rho0: float
    k0: float
    k1: float
    k2: float
    k3: float
    h0: float
    h1: float = 0.0
    h2: float = 0.0
    h3: float = 0.0
    specific_heat: float = math.nan
    reference_temperature: float = 298.15


def _cold(eta, par):
    return par.k0 * eta * (1.0 + eta * (par.k1 + eta * (par.k2 + eta * par.k3)))


def _rho_gamma(eta, par):
    return par.h0 * (1.0 + eta * (par.h1 + eta * (par.h2 + eta * par.h3)))


def pressure(rho, e, par):
    eta = 1.0 - par.rho0 / rho
    return _cold(eta, par) + e * _rho_gamma(eta, par)


def pressure_derivatives(rho, e, par):
    v = par.rho0 / rho
    eta = 1.0 - v
    cold = par.k0 * (1.0 + eta * (2.0 * par.k1 + eta * (3.0 * par.k2 + 4.0 * par.k3 * eta)))
    warm = par.h0 * (par.h1 + eta * (2.0 * par.h2 + 3.0 * par.h3 * eta))
    return (cold + e * warm) * v / rho, _rho_gamma(eta, par)


def energy(rho, p, par):
    eta = 1.0 - par.rho0 / rho
    return (p - _cold(eta, par)) / _rho_gamma(eta, par)


def _heating(eta, par):
    """ln(T/T0) along an isentrope from rho0."""
    return par.h0 / par.rho0 * eta * (1.0 + eta * (par.h1 / 2.0 + eta * (par.h2 / 3.0 + eta * par.h3 / 4.0)))


def reference_isentrope(rho, par):
    """(e, T/T0) on the isentrope through the reference state."""
    eta = 1.0 - par.rho0 / rho
    growth = _heating(eta, par)
    total = 0.0
    for x, w in quadrature():
        total += w * _cold(x * eta, par) * vexp(growth - _heating(x * eta, par))
    return eta * total / par.rho0, vexp(growth)


def temperature(rho, e, par):
    e_s, ratio = reference_isentrope(rho, par)
    return par.reference_temperature * ratio + (e - e_s) / par.specific_heat


def specific_heat(rho, e, par):
    return par.specific_heat


def entropy(rho, e, par):
    """Zero at the reference state."""
    ratio = temperature(rho, e, par) / par.reference_temperature
    return par.specific_heat * (vlog(ratio) - _heating(1.0 - par.rho0 / rho, par))


def reference_state(par):
    return par.rho0, 0.0


def density_limits(par):
    return 0.0, math.inf


EOS.add(
    "herrmann_series", HerrmannSeries,
    functions=[pressure, pressure_derivatives, energy, temperature, specific_heat, entropy, reference_state, density_limits],
    example=HerrmannSeries(2780.0, 76.4e9, 1.692, 1.752, 0.675, 5473.0, 1.0, 1.0, 1.0, 890.0),
    units={"rho0": "kg/m^3", "k0": "Pa", "k1": "1", "k2": "1", "k3": "1", "h0": "kg/m^3", "h1": "1", "h2": "1", "h3": "1",
           "specific_heat": "J/kg/K", "reference_temperature": "K"},
    meaning={"rho0": "reference density", "k0": "coefficient of eta, the bulk modulus in the reference state",
             "k1": "coefficient of eta^2 divided by k0", "k2": "coefficient of eta^3 divided by k0",
             "k3": "coefficient of eta^4 divided by k0",
             "h0": "reference density times Grüneisen parameter; 0 for a pressure that depends on the density alone",
             "h1": "coefficient of eta in rho Gamma, divided by h0", "h2": "coefficient of eta^2 in rho Gamma, divided by h0",
             "h3": "coefficient of eta^3 in rho Gamma, divided by h0",
             "specific_heat": "specific heat at constant volume, needed for temperatures",
             "reference_temperature": "temperature of the reference state"},
    least={"h0": 0.0},
    defaults={"h1": 0.0, "h2": 0.0, "h3": 0.0, "specific_heat": math.nan, "reference_temperature": 298.15},
    box={"rho": (2500.0, 7000.0), "e": (0.0, 1e7)},
    references=("Herrmann, WL-TR-64-107, eq. 3.6, A.12, C.16",),
    flags=("linear_in_energy",),
)
