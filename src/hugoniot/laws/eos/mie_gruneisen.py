r"""Mie-Grüneisen equation of state with the Hugoniot Us = c0 + s up as reference curve: the standard law for shocked solids and liquids.

$$p = p_R(\eta) + \rho_0\Gamma_0\,[e - e_R(\eta)], \qquad \eta = 1 - \rho_0/\rho$$

The product $\rho\Gamma = \rho_0\Gamma_0$ is constant. In compression ($\eta \ge 0$) the reference curve is the principal Hugoniot of
$U_s = c_0 + s\,u_p$,

$$p_R = \frac{\rho_0 c_0^2\,\eta}{(1 - s\eta)^2}, \qquad e_R = \frac{p_R\,\eta}{2\rho_0},$$

so the law reproduces the measured Hugoniot exactly for any $\Gamma_0$. In tension ($\eta < 0$) the reference curve is an isentrope,

$$e_R = \frac{c_0^2\eta^2}{2(1 - a\eta)}, \qquad p_R = \rho_0 \frac{de_R}{d\eta}
     = \rho_0 c_0^2\,\eta\,\frac{1 - a\eta/2}{(1 - a\eta)^2}, \qquad a = \tfrac43 s,$$

which continues the Hugoniot with the same pressure, slope and curvature. Its slope $\rho_0c_0^2/(1 - a\eta)^3$ is positive at every
expansion, so the sound speed is real wherever $e \ge e_R$, and tensions on the curve stay below $3\rho_0c_0^2/(8s)$ (22 GPa for the
example). Real materials fail at lower tensions; add a fracture law.

The Hugoniot has a pole at $\eta = 1/s$. With $s < 1$ the fit ends where $u_p$ catches up with $U_s$, at $u_p = c_0/(1 - s)$ (J-E16).

**Other forms.** `gamma_form = "constant"` keeps $\Gamma$ constant, and `"linear"` takes the slope $\Gamma_1$ of
`mie_gruneisen_linear_gamma`; both are evaluated by that law. For curved Hugoniots see `mie_gruneisen_quadratic` and
`mie_gruneisen_cubic`.

**Temperature.** With a constant specific heat $c_v$, $T = T_0 e^{\Gamma_0\eta} + (e - e_S)/c_v$, where $e_S$ is the isentrope through the
reference state ($e = 0$, temperature $T_0$). In tension $e_S = e_R$. In compression, with $y = 1 - s\eta$, $\beta = \Gamma_0/s$ and the
exponential integral Ei,

$$e_S = \frac{c_0^2}{s^2}\Big\{\left(1-\tfrac{\beta}{2}\right)\left(\tfrac1y - e^{\beta(1-y)}\right)
 + \tfrac12\left(1 - e^{\beta(1-y)}\right)
 - \left(1 - 2\beta + \tfrac{\beta^2}{2}\right) e^{-\beta y}\,[\mathrm{Ei}(\beta) - \mathrm{Ei}(\beta y)]\Big\},$$

the exact solution of $de_S/d\eta - \Gamma_0 e_S = c_0^2\eta(1 - \Gamma_0\eta/2)/(1 - s\eta)^2$. The source calls the
integral an error function (J-E8). If $\Gamma_0 > 8s$ this form loses digits; $e_S$ is then integrated numerically, as in
`mie_gruneisen_linear_gamma` with $\Gamma_1 = 0$.

Source: Starkenberg, ARL-TR-2161, appendix A-4, A-6.2, A-11; Herrmann, WL-TR-64-107, C.5, C.6, C.12; Jordan (2011), eq. 5.1.4 to 5.1.10.
"""

import math
from typing import NamedTuple

from hugoniot.core.ops import vexp, vlog
from hugoniot.errors import OutOfRange
from hugoniot.laws.eos.contract import EOS
from hugoniot.laws.eos.mie_gruneisen_linear_gamma import MieGruneisenLinearGamma
from hugoniot.laws.eos.reference_curves import GAMMA_MEANING, gamma_slope_of
from hugoniot.laws.eos.special import ei_difference


class MieGruneisen(NamedTuple):
    rho0: float
    c0: float
    s: float
    gamma0: float
    specific_heat: float = math.nan
    reference_temperature: float = 298.15


def _strain(rho, par):
    """(eta, 1/(1 - kappa eta)); kappa is s in compression and 4s/3 in tension. The density stands in rho0/rho alone."""
    eta = 1.0 - par.rho0 / rho
    return eta, 1.0 / (1.0 - (par.s if eta > 0.0 else (4.0 / 3.0) * par.s) * eta)


def pressure(rho, e, par):
    eta, inverse = _strain(rho, par)
    g = par.gamma0
    tension = 0.0 if eta > 0.0 else (2.0 / 3.0) * par.s
    shape = 1.0 - 0.5 * g * eta - tension * eta * (1.0 - g * eta)
    return par.rho0 * (par.c0 * par.c0 * (eta * inverse * inverse * shape) + g * e)


def pressure_derivatives(rho, e, par):
    eta, inverse = _strain(rho, par)
    g, a = par.gamma0, (4.0 / 3.0) * par.s
    compressed = 1.0 + (par.s - g) * eta
    stretched = 1.0 - g * eta * (1.0 - 0.5 * a * eta) * (1.0 - a * eta)
    slope = compressed if eta > 0.0 else stretched
    v_ratio = 1.0 - eta
    return par.c0 * par.c0 * (v_ratio * v_ratio) * (inverse * inverse * inverse * slope), par.rho0 * g


def energy(rho, p, par):
    return (p - pressure(rho, 0.0, par)) / (par.rho0 * par.gamma0)


def reference_isentrope(rho, par):
    """(e, T/T0) on the isentrope through the reference state; not a number where gamma0 > 8 s (see `build`)."""
    eta, inverse = _strain(rho, par)
    beta = par.gamma0 / par.s if par.gamma0 <= 8.0 * par.s else math.nan
    # exp(-beta y) = exp(-beta) exp(Gamma0 eta): one exponential serves the whole temperature
    growth = vexp(par.gamma0 * eta) + 0.0 * beta
    if eta > 0.0:
        y = 1.0 - par.s * eta
        bracket = ((1.0 - 0.5 * beta) * (inverse - growth) + 0.5 * (1.0 - growth)
                   - (1.0 - 2.0 * beta + 0.5 * beta * beta) * vexp(-beta) * growth * (ei_difference(beta, y) - vlog(y)))
        e_s = par.c0 * par.c0 / (par.s * par.s) * bracket
    else:
        e_s = 0.5 * par.c0 * par.c0 * eta * eta * inverse
    return e_s, growth


def temperature(rho, e, par):
    e_s, ratio = reference_isentrope(rho, par)
    return par.reference_temperature * ratio + (e - e_s) / par.specific_heat


def specific_heat(rho, e, par):
    return par.specific_heat


def entropy(rho, e, par):
    """Zero at the reference state."""
    ratio = temperature(rho, e, par) / par.reference_temperature
    return par.specific_heat * (vlog(ratio) - par.gamma0 * (1.0 - par.rho0 / rho))


def reference_state(par):
    return par.rho0, 0.0


def density_limits(par):
    """The Hugoniot is singular at eta = 1/s; with s <= 1 that lies beyond infinite density (J-E16)."""
    return 0.0, par.rho0 * par.s / (par.s - 1.0) if par.s > 1.0 else math.inf


def particle_velocity_limit(par):
    """J-E16: with s < 1 up catches up with the fitted Us at up = c0/(1 - s), infinite compression; no shock is faster."""
    return par.c0 / (1.0 - par.s) if par.s < 1.0 else math.inf


def build(rho0, c0, s, gamma0, gamma_form=None, gamma_slope=math.nan, specific_heat=math.nan, reference_temperature=298.15):
    """Parameters from a deck.

    Where rho Gamma is not constant they are those of the law mie_gruneisen_linear_gamma, and so they are with gamma0 > 8 s, a Hugoniot so
    straight that the closed form of the temperature would cancel; pressures are the same in both.
    """
    for name, value, unit in (("rho0", rho0, "kg/m3"), ("c0", c0, "m/s")):
        if not value > 0.0:
            raise OutOfRange(f"mie_gruneisen: {name} must be positive, got {value:g} {unit}")
    if not (s >= 0.0 and gamma0 > 0.0):
        raise OutOfRange(f"mie_gruneisen: needs s >= 0 and gamma0 > 0, got s = {s:g}, gamma0 = {gamma0:g}")
    slope = gamma_slope_of(gamma_form, gamma0, gamma_slope)
    if slope == 0.0 and gamma0 <= 8.0 * s:
        return MieGruneisen(rho0, c0, s, gamma0, specific_heat, reference_temperature)
    return MieGruneisenLinearGamma(rho0, c0, s, gamma0, slope, specific_heat, reference_temperature)


EOS.add(
    "mie_gruneisen", MieGruneisen,
    functions=[pressure, pressure_derivatives, energy, temperature, specific_heat, entropy, reference_state, density_limits,
               particle_velocity_limit],
    example=MieGruneisen(2785.0, 5328.0, 1.338, 2.0, 863.0),
    build=build,
    units={"rho0": "kg/m^3", "c0": "m/s", "s": "1", "gamma0": "1", "specific_heat": "J/kg/K", "reference_temperature": "K",
           "gamma_form": "text", "gamma_slope": "1"},
    meaning={"rho0": "reference density", "c0": "shock velocity at zero particle velocity", "s": "slope of the Hugoniot, dUs/dup",
             "gamma0": "Grüneisen parameter at the reference density",
             "specific_heat": "specific heat at constant volume, needed for temperatures",
             "reference_temperature": "temperature of the reference state",
             "gamma_form": GAMMA_MEANING["gamma_form"], "gamma_slope": GAMMA_MEANING["gamma_slope"]},
    defaults={"specific_heat": math.nan, "reference_temperature": 298.15, "gamma_form": None, "gamma_slope": math.nan},
    box={"rho": (2100.0, 6500.0), "e": (0.0, 2e7)},
    references=("Starkenberg, ARL-TR-2161, appendix A-6.2, A-11", "Herrmann, WL-TR-64-107, eq. C.5, C.6, C.12",
                "Jordan 2011, eq. 5.1.4 to 5.1.10"),
    flags=("linear_in_energy",),
)
