r"""Mie-Grüneisen equation of state on a cold curve truncated at order 3 to 6, as in Jordan (2011).

Use it to reproduce results obtained with a truncated cold curve; `mie_gruneisen_cold` is the same law without truncation.

$$p = P_c + \rho_0\Gamma_0(e - E_c), \qquad E_c = \sum_{n=0}^{N} e_n\eta^n,
  \; P_c = \rho_0\frac{dE_c}{d\eta}, \qquad \eta = 1 - \rho_0/\rho$$

The coefficients follow from the Hugoniot $U_s = c_0 + s\,u_p$ and the cold energy $E_{00}$ by

$$e_0 = E_{00}, \qquad (n+1)\,e_{n+1} = \Gamma_0e_n + S_n, \qquad S_n = c_0^2\left[n s^{n-1} - \tfrac{\Gamma_0}{2}(n-1)s^{n-2}\right]
  \; (n \ge 1), \quad S_0 = 0,$$

so that $e_2 = (c_0^2 + \Gamma_0^2E_{00})/2$ and $e_3 = (4sc_0^2 + \Gamma_0^3E_{00})/6$. The error of the truncation grows with
compression: for copper with $E_{00} = 0$ the cold energy at $\eta = 0.3$ is 21 % too low at order 3 and 1.5 % at order 6. The series is
used unchanged in tension. The temperature is $T = (e - E_c)/c_v$ with a constant specific heat $c_v$.

Source: Jordan (2011), eq. 5.1.11 to 5.1.13; 5.1.11 and 5.1.13 are missing from the available copy and were rederived (J-E17).
"""

import math
from typing import NamedTuple

from hugoniot.core.ops import vlog
from hugoniot.errors import OutOfRange
from hugoniot.laws.eos.contract import EOS
from hugoniot.laws.eos.mie_gruneisen_cold import cold_coefficients


class MieGruneisenColdSeries(NamedTuple):
    """e2 ... e6 are filled by `build`; those above the order are 0."""

    rho0: float
    gamma0: float
    e00: float
    e2: float
    e3: float
    e4: float
    e5: float
    e6: float
    specific_heat: float = math.nan


def cold_energy(rho, par):
    """E_c, J/kg."""
    x = 1.0 - par.rho0 / rho
    first = par.gamma0 * par.e00
    return par.e00 + x * (first + x * (par.e2 + x * (par.e3 + x * (par.e4 + x * (par.e5 + x * par.e6)))))


def cold_slope(x, par):
    """dE_c/deta, J/kg."""
    return par.gamma0 * par.e00 + x * (2.0 * par.e2 + x * (3.0 * par.e3 + x * (4.0 * par.e4 + x * (5.0 * par.e5 + 6.0 * par.e6 * x))))


def pressure(rho, e, par):
    return par.rho0 * (cold_slope(1.0 - par.rho0 / rho, par) + par.gamma0 * (e - cold_energy(rho, par)))


def pressure_derivatives(rho, e, par):
    v = par.rho0 / rho
    x = 1.0 - v
    curvature = 2.0 * par.e2 + x * (6.0 * par.e3 + x * (12.0 * par.e4 + x * (20.0 * par.e5 + 30.0 * par.e6 * x)))
    return (curvature - par.gamma0 * cold_slope(x, par)) * v * v, par.rho0 * par.gamma0


def energy(rho, p, par):
    return (p - pressure(rho, 0.0, par)) / (par.rho0 * par.gamma0)


def temperature(rho, e, par):
    return (e - cold_energy(rho, par)) / par.specific_heat


def specific_heat(rho, e, par):
    return par.specific_heat


def entropy(rho, e, par):
    """Zero where T = 1 K at rho0."""
    return par.specific_heat * (vlog(temperature(rho, e, par)) - par.gamma0 * (1.0 - par.rho0 / rho))


def reference_state(par):
    return par.rho0, 0.0


def density_limits(par):
    return 0.0, math.inf


def build(rho0, c0, s, gamma0, order=3.0, cold_energy=0.0, specific_heat=math.nan):
    """Parameters from a linear Hugoniot; `order` is 3, 4, 5 or 6."""
    if order not in (3, 4, 5, 6):
        raise OutOfRange(f"mie_gruneisen_cold_series: order must be 3, 4, 5 or 6, got {order}; for the exact curve use mie_gruneisen_cold")
    e = cold_coefficients(c0, s, gamma0, cold_energy, int(order)) + [0.0] * (6 - int(order))
    return MieGruneisenColdSeries(rho0, gamma0, cold_energy, *e[2:], specific_heat)


_COEFFICIENTS = {f"e{n}": n for n in range(2, 7)}

EOS.add(
    "mie_gruneisen_cold_series", MieGruneisenColdSeries,
    functions=[pressure, pressure_derivatives, energy, temperature, specific_heat, entropy, reference_state, density_limits],
    example=build(8930.0, 3940.0, 1.49, 1.99, 4, -385.0 * 298.15, 385.0),
    build=build,
    units={"rho0": "kg/m^3", "c0": "m/s", "s": "1", "gamma0": "1", "order": "1", "cold_energy": "J/kg", "specific_heat": "J/kg/K",
           "e00": "J/kg", **dict.fromkeys(_COEFFICIENTS, "J/kg")},
    meaning={"rho0": "reference density", "c0": "shock velocity at zero particle velocity", "s": "slope of the Hugoniot, dUs/dup",
             "gamma0": "Grüneisen parameter at the reference density", "order": "order of the truncated series, 3 to 6",
             "cold_energy": "energy at the reference density and 0 K",
             "specific_heat": "specific heat at constant volume, needed for temperatures",
             "e00": "energy at the reference density and 0 K",
             **{k: f"coefficient of eta^{n} (filled by build)" for k, n in _COEFFICIENTS.items()}},
    defaults={"order": 3.0, "cold_energy": 0.0, "specific_heat": math.nan},
    box={"rho": (8000.0, 14000.0), "e": (0.0, 3e6)},
    references=("Jordan 2011, eq. 5.1.11 to 5.1.13 (J-E17)",),
    flags=("linear_in_energy", "truncated"),
)
