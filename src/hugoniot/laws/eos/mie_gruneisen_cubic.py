r"""Mie-Grüneisen equation of state with Steinberg's cubic shock Hugoniot as reference curve, for curved Us-up relations.

The Hugoniot is a polynomial in $u_p/U_s$, which equals the compression $\eta = 1 - \rho_0/\rho$ behind the shock:

$$U_s = c_0 + \left[s_1 + s_2\frac{u_p}{U_s} + s_3\left(\frac{u_p}{U_s}\right)^2\right]u_p \;\Longleftrightarrow\;
  p_H = \frac{\rho_0c_0^2\,\eta}{(1 - s_1\eta - s_2\eta^2 - s_3\eta^3)^2}, \qquad e_H = \frac{p_H\eta}{2\rho_0},$$
$$p = p_H + \rho\Gamma\,(e - e_H), \qquad \rho\Gamma = \rho_0(\Gamma_0 + \Gamma_1\mu), \qquad \mu = \rho/\rho_0 - 1.$$

$\Gamma_1 = 0$ keeps $\rho\Gamma$ constant and $\Gamma_1 = \Gamma_0$ keeps $\Gamma$ constant; `gamma_form` selects one of these, and
`gamma_slope` gives any other slope. Densities at which $\rho\Gamma$ would not be positive are refused. Below $\rho_0$ the reference curve
is the isentrope that `mie_gruneisen` uses in tension, with $s_1$ for $s$. The law ends at the pole of $p_H$, or before it where $u_p$ no
longer rises with $\eta$. The temperature is that of `mie_gruneisen_linear_gamma` with this Hugoniot; its isentrope is integrated with 16
Gauss points (error below $10^{-12}$ of the energy up to 70 % of the limiting compression).

Source: Steinberg, Cochran and Guinan, J. Appl. Phys. 51, 1498 (1980), as quoted by Starkenberg, ARL-TR-2161, appendix A-6; Starkenberg
A-11.
"""

import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from hugoniot.errors import OutOfRange
from hugoniot.laws.eos import reference_curves
from hugoniot.laws.eos.contract import EOS
from hugoniot.laws.eos.reference_curves import highest_density, lowest_density, with_gamma_form


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


def hugoniot_curve(eta, par):
    """(P, dP/deta) of the Hugoniot, P = p/rho0."""
    r = 1.0 / (1.0 - eta * (par.s1 + eta * (par.s2 + eta * par.s3)))
    u = par.c0 * r
    return u * u * eta, u * u * (1.0 + 2.0 * eta * r * (par.s1 + eta * (2.0 * par.s2 + 3.0 * par.s3 * eta)))


@lru_cache(maxsize=1024)       # asked with every state that is searched for
def _first(*coefficients: float) -> float:
    """Smallest root between 0 and 1 of a polynomial (highest power first), else 1."""
    roots = np.roots(np.trim_zeros(coefficients, "f"))
    real = roots.real[(abs(roots.imag) < 1e-9 * abs(roots)) & (roots.real > 0.0)]
    return float(min(real.min(initial=1.0), 1.0))


def _pole(par):
    """Smallest strain below 1 at which the Hugoniot is singular, else 1."""
    return _first(-par.s3, -par.s2, -par.s1, 1.0)


def _strain_limit(par):
    """Where the Hugoniot ends: at its pole, or before that where up = c0 eta/(1 - s1 eta - s2 eta^2 - s3 eta^3) is largest; else 1.

    d(up)/d(eta) vanishes with 1 + s2 eta^2 + 2 s3 eta^3. Beyond it the fit would turn back to weaker shocks.
    """
    return min(_pole(par), _first(2.0 * par.s3, par.s2, 0.0, 1.0))


def density_limits(par):
    high = highest_density(par.rho0, _strain_limit(par), par.gamma0, par.gamma_slope)
    return lowest_density(par.rho0, par.gamma0, par.gamma_slope), high


def particle_velocity_limit(par):
    """up at the end of a Hugoniot that has no pole before it: its largest, or that at eta = 1 (J-E16); inf else."""
    eta, pole = _strain_limit(par), _pole(par)
    rest = 1.0 - eta * (par.s1 + eta * (par.s2 + eta * par.s3))
    return par.c0 * eta / rest if rest > 0.0 and (eta < pole or eta == 1.0) else math.inf


def build(rho0, c0, s1, gamma0, gamma_form=None, gamma_slope=math.nan, **given):
    """Parameters from a deck: the Grüneisen parameter by `gamma_form` as in mie_gruneisen."""
    if not (rho0 > 0.0 and c0 > 0.0 and s1 >= 0.0 and gamma0 > 0.0):
        raise OutOfRange(f"mie_gruneisen_cubic: needs rho0, c0, gamma0 > 0 and s1 >= 0, got rho0 = {rho0:g} kg/m3, "
                         f"c0 = {c0:g} m/s, gamma0 = {gamma0:g}, s1 = {s1:g}")
    return with_gamma_form(MieGruneisenCubic)(gamma_form, gamma_slope, rho0=rho0, c0=c0, s1=s1, gamma0=gamma0, **given)


EOS.add(
    "mie_gruneisen_cubic", MieGruneisenCubic,
    functions={**reference_curves.ON_HUGONIOT, "hugoniot_curve": hugoniot_curve, "density_limits": density_limits,
               "particle_velocity_limit": particle_velocity_limit},
    example=MieGruneisenCubic(11340.0, 2006.0, 1.429, 0.8506, -1.64, 2.77, 0.54, 130.0),
    build=build,
    units={"rho0": "kg/m^3", "c0": "m/s", "s1": "1", "s2": "1", "s3": "1", **reference_curves.GAMMA_UNITS},
    meaning={"rho0": "reference density", "c0": "shock velocity at zero particle velocity", "s1": "coefficient of up in Us",
             "s2": "coefficient of (up/Us) up in Us", "s3": "coefficient of (up/Us)^2 up in Us", **reference_curves.GAMMA_MEANING},
    defaults=reference_curves.GAMMA_DEFAULTS,
    box={"rho": (9500.0, 20000.0), "e": (0.0, 5e6)},
    references=("Steinberg, Cochran and Guinan, J. Appl. Phys. 51, 1498 (1980), as quoted in Starkenberg, ARL-TR-2161, appendix A-6",
                "Starkenberg, ARL-TR-2161, appendix A-11"),
    flags=("linear_in_energy",),
)
