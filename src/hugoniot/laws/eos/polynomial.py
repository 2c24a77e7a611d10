r"""Polynomial in the compression, linear in energy, as in Wilkins' KO codes.

Use it for published coefficients of this form:

$$p = a\,\mu + b\,\mu^2 + c\,\mu^3 + d\,\rho e, \qquad \mu = \rho/\rho_0 - 1$$

$a$ is the bulk modulus in the reference state and $d$ the constant Grüneisen parameter. Sources often give the
energy per reference volume, $E = \rho_0e$, and the last term as $d\,(1 + \mu)E$, which is the same. The polynomial is used unchanged in
tension and far beyond the compressions of the data, where a negative coefficient makes the law unstable.

With a constant specific heat $c_v$ the temperature is $T = T_0X^d + (e - e_S)/c_v$, $X = \rho/\rho_0$, with the isentrope through the
reference state

$$e_S = \frac{X^d}{\rho_0}\sum_{n=0}^{3} c_n \frac{X^{n-1-d} - 1}{n-1-d}, \qquad p(X, 0) = \sum_n c_nX^n$$

(a logarithm where the exponent vanishes).

Source: Wilkins, B.1 item 6, and A.1, which has no cubic term and writes c for d.
"""

import math
from typing import NamedTuple

from hugoniot.core.ops import vexp, vlog
from hugoniot.laws.eos.contract import EOS


class Polynomial(NamedTuple):
    rho0: float
    a: float
    b: float
    c: float
    d: float
    specific_heat: float = math.nan
    reference_temperature: float = 298.15


def pressure(rho, e, par):
    x = rho / par.rho0 - 1.0
    return x * (par.a + x * (par.b + x * par.c)) + par.d * rho * e


def pressure_derivatives(rho, e, par):
    x = rho / par.rho0 - 1.0
    return (par.a + x * (2.0 * par.b + 3.0 * par.c * x)) / par.rho0 + par.d * e, par.d * rho


def energy(rho, p, par):
    return (p - pressure(rho, 0.0, par)) / (par.d * rho)


def _power_integral(m, u, power):
    """(X**m - 1)/m from u = ln X and power = X**m; u where m vanishes."""
    z = m * u
    if z * z < 1e-4:
        return u * (1.0 + z * (1 / 2 + z * (1 / 6 + z * (1 / 24 + z * (1 / 120 + z * (1 / 720 + z * (1 / 5040)))))))
    return (power - 1.0) / m


def reference_isentrope(rho, par):
    """(e, T/T0) on the isentrope through the reference state."""
    x = rho / par.rho0
    u = vlog(x)
    a, b, c, d = par.a, par.b, par.c, par.d
    growth = vexp(d * u)
    shrink = 1.0 / growth
    total = ((b - a - c) * _power_integral(-1.0 - d, u, shrink / x) + (a - 2.0 * b + 3.0 * c) * _power_integral(-d, u, shrink)
             + (b - 3.0 * c) * _power_integral(1.0 - d, u, shrink * x) + c * _power_integral(2.0 - d, u, shrink * x * x))
    return growth * total / par.rho0, growth


def temperature(rho, e, par):
    e_s, ratio = reference_isentrope(rho, par)
    return par.reference_temperature * ratio + (e - e_s) / par.specific_heat


def specific_heat(rho, e, par):
    return par.specific_heat


def entropy(rho, e, par):
    """Zero at the reference state."""
    return par.specific_heat * (vlog(temperature(rho, e, par) / par.reference_temperature) - par.d * vlog(rho / par.rho0))


def reference_state(par):
    return par.rho0, 0.0


def density_limits(par):
    return 0.0, math.inf


EOS.add(
    "polynomial", Polynomial,
    functions=[pressure, pressure_derivatives, energy, temperature, specific_heat, entropy, reference_state, density_limits],
    example=Polynomial(2700.0, 73e9, 172e9, 40e9, 1.6, 890.0),
    units={"rho0": "kg/m^3", "a": "Pa", "b": "Pa", "c": "Pa", "d": "1", "specific_heat": "J/kg/K", "reference_temperature": "K"},
    meaning={"rho0": "reference density", "a": "linear coefficient, the bulk modulus in the reference state",
             "b": "quadratic coefficient", "c": "cubic coefficient", "d": "coefficient of the energy, the Grüneisen parameter",
             "specific_heat": "specific heat at constant volume, needed for temperatures",
             "reference_temperature": "temperature of the reference state"},
    defaults={"specific_heat": math.nan, "reference_temperature": 298.15},
    box={"rho": (2400.0, 6000.0), "e": (0.0, 2e7)},
    references=("Wilkins, B.1 item 6 and A.1",),
    flags=("linear_in_energy",),
)
