r"""Mie-Grüneisen solid on Steinberg's cubic shock Hugoniot.

$$U_s = c_0 + \left[s_1 + s_2\frac{u_p}{U_s} + s_3\left(\frac{u_p}{U_s}\right)^2\right]u_p \;\Longleftrightarrow\;
  p_H = \frac{\rho_0c_0^2\,\eta}{(1 - s_1\eta - s_2\eta^2 - s_3\eta^3)^2}, \qquad e_H = \frac{p_H\eta}{2\rho_0},$$
$$p = p_H + \rho\Gamma\,(e - e_H), \quad \rho\Gamma = \rho_0(\Gamma_0 + b\mu), \quad \mu = \rho/\rho_0 - 1, \quad \eta = 1 - \rho_0/\rho.$$

Below rho0 the isentrope of bounded tension of mie_gruneisen takes over. Temperature as in mie_gruneisen_linear_gamma, by 16 Gauss points
in eta (error below 1e-12 of e up to 70 % of the limiting strain).

Source: Steinberg, Cochran and Guinan 1980 as quoted by 003 (Starkenberg) A-6; 003 A-11.
"""

import math
from typing import NamedTuple

import numpy as np

from hugoniot.core.ops import vexp, vlog
from hugoniot.errors import OutOfRange
from hugoniot.laws.eos import reference_curves
from hugoniot.laws.eos.contract import EOS
from hugoniot.laws.eos.reference_curves import (
    gamma_slope_of,
    highest_density,
    isentrope_source,
    log_heating,
    lowest_density,
    mie_gruneisen_derivatives,
    mie_gruneisen_pressure,
    shocked,
    stretched,
)
from hugoniot.laws.eos.special import quadrature


class MieGruneisenCubic(NamedTuple):
    rho0: float
    c0: float
    s1: float
    s2: float
    s3: float
    gamma0: float
    gamma_slope: float = 0.0
    specific_heat: float = math.nan
    reference_temperature: float = 298.15


def _hugoniot(eta, par):
    """(P, dP/deta) of the Hugoniot, P = p/rho0."""
    r = 1.0 / (1.0 - eta * (par.s1 + eta * (par.s2 + eta * par.s3)))
    u = par.c0 * r
    return u * u * eta, u * u * (1.0 + 2.0 * eta * r * (par.s1 + eta * (2.0 * par.s2 + 3.0 * par.s3 * eta)))


def _curve(rho, par):
    eta = 1.0 - par.rho0 / rho
    if eta > 0.0:
        p, p_eta = _hugoniot(eta, par)
        return shocked(p, p_eta, eta)
    return stretched(eta, par.c0, par.s1)


def pressure(rho, e, par):
    return mie_gruneisen_pressure(rho, e, _curve(rho, par), par.rho0, par.gamma0, par.gamma_slope)


def pressure_derivatives(rho, e, par):
    return mie_gruneisen_derivatives(rho, e, _curve(rho, par), par.rho0, par.gamma0, par.gamma_slope)


def energy(rho, p, par):
    return (p - pressure(rho, 0.0, par)) / (par.rho0 * par.gamma0 + par.gamma_slope * (rho - par.rho0))


def reference_isentrope(rho, par):
    """(e, T/T0) on the isentrope through the reference state."""
    eta = 1.0 - par.rho0 / rho
    growth = log_heating(eta, par.gamma0, par.gamma_slope)
    if eta > 0.0:
        total = 0.0
        for x, w in quadrature():
            t = x * eta
            total += w * isentrope_source(t, _hugoniot(t, par)[0], par.gamma0, par.gamma_slope, growth)
        return eta * total, vexp(growth)
    return stretched(eta, par.c0, par.s1)[1], vexp(growth)


def temperature(rho, e, par):
    e_s, ratio = reference_isentrope(rho, par)
    return par.reference_temperature * ratio + (e - e_s) / par.specific_heat


def specific_heat(rho, e, par):
    return par.specific_heat


def entropy(rho, e, par):
    """Zero at the reference state."""
    ratio = temperature(rho, e, par) / par.reference_temperature
    return par.specific_heat * (vlog(ratio) - log_heating(1.0 - par.rho0 / rho, par.gamma0, par.gamma_slope))


def reference_state(par):
    return par.rho0, 0.0


def _strain_limit(par):
    """Smallest strain below 1 at which the Hugoniot is singular, else 1."""
    roots = np.roots(np.trim_zeros([-par.s3, -par.s2, -par.s1, 1.0], "f"))
    real = roots.real[(abs(roots.imag) < 1e-9 * abs(roots)) & (roots.real > 0.0)]
    return float(min(real.min(initial=1.0), 1.0))


def density_limits(par):
    high = highest_density(par.rho0, _strain_limit(par), par.gamma0, par.gamma_slope)
    return lowest_density(par.rho0, par.gamma0, par.gamma_slope), high


def particle_velocity_limit(par):
    """J-E16: where the Hugoniot reaches infinite compression (eta = 1) before its pole, up = Us there; inf else."""
    rest = 1.0 - par.s1 - par.s2 - par.s3
    return par.c0 / rest if _strain_limit(par) == 1.0 and rest > 0.0 else math.inf


def build(rho0, c0, s1, s2, s3, gamma0, gamma_form="rho_gamma_constant", gamma_slope=math.nan, specific_heat=math.nan,
          reference_temperature=298.15):
    """Parameters from a deck: the Grüneisen parameter by `gamma_form` as in mie_gruneisen."""
    if not (rho0 > 0.0 and c0 > 0.0 and s1 >= 0.0 and gamma0 > 0.0):
        raise OutOfRange(f"mie_gruneisen_cubic: needs rho0, c0, gamma0 > 0 and s1 >= 0, got {rho0}, {c0}, {gamma0}, {s1}")
    if gamma_form == "rho_gamma_constant" and math.isfinite(gamma_slope) and gamma_slope != 0.0:
        gamma_form = "linear"
    slope = gamma_slope_of(gamma_form, gamma0, gamma_slope)
    return MieGruneisenCubic(rho0, c0, s1, s2, s3, gamma0, slope, specific_heat, reference_temperature)


EOS.add(
    "mie_gruneisen_cubic", MieGruneisenCubic,
    functions=[pressure, pressure_derivatives, energy, temperature, specific_heat, entropy, reference_state, density_limits,
               particle_velocity_limit],
    example=MieGruneisenCubic(11340.0, 2006.0, 1.429, 0.8506, -1.64, 2.77, 0.54, 130.0),
    build=build,
    units={"rho0": "kg/m^3", "c0": "m/s", "s1": "1", "s2": "1", "s3": "1", **reference_curves.GAMMA_UNITS},
    meaning={"rho0": "density at rest", "c0": "shock velocity at vanishing particle velocity", "s1": "coefficient of up",
             "s2": "coefficient of (up/Us) up", "s3": "coefficient of (up/Us)^2 up", **reference_curves.GAMMA_MEANING},
    defaults=reference_curves.GAMMA_DEFAULTS,
    box={"rho": (9500.0, 20000.0), "e": (0.0, 5e6)},
    references=("Steinberg, Cochran and Guinan, J. Appl. Phys. 51, 1498 (1980), as quoted in Starkenberg, ARL-TR-2161, A-6",
                "Starkenberg, ARL-TR-2161, A-11"),
    flags=("linear_in_energy",),
)
