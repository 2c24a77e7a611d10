r"""Mie-Grüneisen equation of state with the Hugoniot Us = c0 + s1 up + s2 up^2 as reference curve.

Use it for materials whose measured $U_s$-$u_p$ relation is curved. With $u_p = \eta U_s$, $\eta = 1 - \rho_0/\rho$, the fit is a
quadratic equation for $U_s$; the root that starts from $c_0$ is

$$U_s = \frac{2c_0}{1 - s_1\eta + \sqrt{(1 - s_1\eta)^2 - 4 s_2c_0\eta^2}},
  \qquad p_H = \rho_0U_s^2\eta, \qquad e_H = \frac{p_H\eta}{2\rho_0},$$
$$p = p_H + \rho\Gamma\,(e - e_H), \qquad \rho\Gamma = \rho_0(\Gamma_0 + \Gamma_1\mu), \qquad \mu = \rho/\rho_0 - 1.$$

$\Gamma_1 = 0$ keeps $\rho\Gamma$ constant and $\Gamma_1 = \Gamma_0$ keeps $\Gamma$ constant; `gamma_form` selects one of these, and
`gamma_slope` gives any other slope. Densities at which $\rho\Gamma$ would not be positive are refused. Below $\rho_0$ the reference curve
is the isentrope that `mie_gruneisen` uses in tension, with $s_1$ for $s$.

For $s_2 > 0$ the root ends at $u_p = \sqrt{c_0/s_2}$, the compression $1/(s_1 + 2\sqrt{c_0s_2})$. For $s_2 < 0$ the law ends where the
fitted $U_s$ is highest, $u_p = s_1/(2|s_2|)$, or before that where $u_p$ catches up with $U_s$. Use the fit only in the range of particle
velocities in which it was made. The temperature is that of `mie_gruneisen_linear_gamma` with this Hugoniot; its isentrope is integrated
with 16 Gauss points (error below $10^{-12}$ of the energy up to 70 % of the limiting compression).

Source: Starkenberg, ARL-TR-2161, appendix A-11 (any $U_H(u)$ that can be solved); form of the Hugoniot as in compilations of shock data
(Marsh 1980).
"""

import math
from typing import NamedTuple

from hugoniot.core.ops import vsqrt
from hugoniot.errors import OutOfRange
from hugoniot.laws.eos import reference_curves
from hugoniot.laws.eos.contract import EOS
from hugoniot.laws.eos.reference_curves import highest_density, lowest_density, with_gamma_form


class MieGruneisenQuadratic(NamedTuple):
    rho0: float
    c0: float
    s1: float
    s2: float
    gamma0: float
    gamma_slope: float = 0.0
    specific_heat: float = math.nan
    reference_temperature: float = 298.15


def hugoniot_curve(eta, par):
    """(P, dP/deta) of the Hugoniot, P = p/rho0."""
    a = 1.0 - par.s1 * eta
    root = vsqrt(a * a - 4.0 * par.s2 * par.c0 * eta * eta)
    u = 2.0 * par.c0 / (a + root)
    root_eta = -(par.s1 * a + 4.0 * par.s2 * par.c0 * eta) / root
    u_eta = u * (par.s1 - root_eta) / (a + root)
    return u * u * eta, u * (u + 2.0 * eta * u_eta)


def particle_velocity_limit(par):
    """Where the root ends (s2 > 0), the fitted Us stops rising (s2 < 0) or up catches up with Us (J-E16), whichever is first."""
    c0, s1, s2 = par.c0, par.s1, par.s2
    if s2 == 0.0:
        return c0 / (1.0 - s1) if s1 < 1.0 else math.inf
    limit = math.sqrt(c0 / s2) if s2 > 0.0 else s1 / (-2.0 * s2)
    discriminant = (s1 - 1.0) ** 2 - 4.0 * s2 * c0
    if discriminant >= 0.0:
        q = -0.5 * ((s1 - 1.0) + math.copysign(math.sqrt(discriminant), s1 - 1.0))
        limit = min([limit, *(u for u in (q / s2, c0 / q if q else 0.0) if u > 0.0)])
    return limit


def density_limits(par):
    up = particle_velocity_limit(par)
    strain = up / (par.c0 + par.s1 * up + par.s2 * up * up) if math.isfinite(up) else 1.0 / max(par.s1, 1.0)
    return lowest_density(par.rho0, par.gamma0, par.gamma_slope), highest_density(par.rho0, strain, par.gamma0, par.gamma_slope)


def build(rho0, c0, s1, gamma0, gamma_form=None, gamma_slope=math.nan, **given):
    """Parameters from a deck: the Grüneisen parameter by `gamma_form` as in mie_gruneisen."""
    if not (rho0 > 0.0 and c0 > 0.0 and s1 >= 0.0 and gamma0 > 0.0):
        raise OutOfRange(f"mie_gruneisen_quadratic: needs rho0, c0, gamma0 > 0 and s1 >= 0, got rho0 = {rho0:g} kg/m3, "
                         f"c0 = {c0:g} m/s, gamma0 = {gamma0:g}, s1 = {s1:g}")
    return with_gamma_form(MieGruneisenQuadratic)(gamma_form, gamma_slope, rho0=rho0, c0=c0, s1=s1, gamma0=gamma0, **given)


EOS.add(
    "mie_gruneisen_quadratic", MieGruneisenQuadratic,
    functions={**reference_curves.ON_HUGONIOT, "hugoniot_curve": hugoniot_curve, "density_limits": density_limits,
               "particle_velocity_limit": particle_velocity_limit},
    example=MieGruneisenQuadratic(7856.0, 3531.0, 1.914, -6.06e-5, 1.69, 0.0, 450.0),
    build=build,
    units={"rho0": "kg/m^3", "c0": "m/s", "s1": "1", "s2": "s/m", **reference_curves.GAMMA_UNITS},
    meaning={"rho0": "reference density", "c0": "shock velocity at zero particle velocity", "s1": "initial slope of the Hugoniot, dUs/dup",
             "s2": "coefficient of up^2 in Us", **reference_curves.GAMMA_MEANING},
    defaults=reference_curves.GAMMA_DEFAULTS,
    box={"rho": (6000.0, 12000.0), "e": (0.0, 2e7)},
    references=("Starkenberg, ARL-TR-2161, appendix A-11",),
    flags=("linear_in_energy",),
)
