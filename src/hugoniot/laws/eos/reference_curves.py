r"""Reference curves of the Mie-Grüneisen solids, and the laws they make.

A reference curve is (P, E, dP/deta, dE/deta) at the compression $\eta = 1 - \rho_0/\rho$, with P = p/rho0 and E both in J/kg:

* an isentrope through the reference state (murnaghan, tait, vinet, birch_murnaghan): a law gives `reference_curve(rho, par)`, the rest
  is ON_ISENTROPE;
* `shocked`, a Hugoniot through the reference state, $E = P\eta/2$, continued below rho0 by `stretched`, the isentrope of bounded tension of
  mie_gruneisen (mie_gruneisen_quadratic, mie_gruneisen_cubic): a law gives `hugoniot_curve(eta, par)`, the rest is ON_HUGONIOT.

$$p = \rho_0P + \rho\Gamma\,(e - E), \qquad \rho\Gamma = \rho_0(\Gamma_0 + \Gamma_1\mu), \qquad \mu = \rho/\rho_0 - 1$$

With the isentrope $e_S$ through the reference state (e = 0, T0) and constant $c_v$: $T = T_0\varphi + (e - e_S)/c_v$,
$\ln\varphi = (\Gamma_0 - \Gamma_1)\eta - \Gamma_1\ln(1 - \eta)$, where $\Gamma_1$ is `gamma_slope`.

Source: Starkenberg A-1, A-4, A-6, A-11; the tension curve is derived in mie_gruneisen.
"""

import math

from hugoniot.core.ops import vexp, vlog
from hugoniot.errors import OutOfRange
from hugoniot.laws.eos.contract import hugoniot_curve, reference_curve
from hugoniot.laws.eos.contract import temperature as law_temperature
from hugoniot.laws.eos.special import quadrature


def gamma_slope_of(form, gamma0, slope=math.nan):
    """The slope of Gamma = (gamma0 + slope mu)/(1 + mu) for a named form: rho_gamma_constant, constant, linear (then `slope`).

    Without a form (None) a slope makes it linear. A form refuses a slope that contradicts it; 0 is the slope of a law that was given none.
    """
    given = math.isfinite(slope)
    if form is None:
        return slope if given else 0.0
    if form == "linear":
        if not given:
            raise OutOfRange("gamma_form = 'linear' needs gamma_slope, as in Gamma = (gamma0 + gamma_slope mu)/(1 + mu) with mu = "
                             "rho/rho0 - 1")
        return slope
    implied = {"rho_gamma_constant": 0.0, "constant": gamma0}
    if form not in implied:
        raise OutOfRange(f"unknown gamma_form '{form}'; known: rho_gamma_constant, constant, linear")
    if given and slope not in (0.0, implied[form]):
        raise OutOfRange(f"gamma_form = '{form}' means gamma_slope = {implied[form]:g}, but gamma_slope is {slope:g}; omit gamma_form, or "
                         f"set gamma_slope = {implied[form]:g}")
    return implied[form]


GAMMA_UNITS = {"gamma0": "1", "gamma_slope": "1", "specific_heat": "J/kg/K", "reference_temperature": "K", "gamma_form": "text"}
GAMMA_MEANING = {
    "gamma0": "Grüneisen parameter at the reference density",
    "gamma_slope": "slope of rho Gamma/rho0 against mu = rho/rho0 - 1: Gamma = (gamma0 + gamma_slope mu)/(1 + mu)",
    "specific_heat": "specific heat at constant volume, needed for temperatures",
    "reference_temperature": "temperature of the reference state",
    "gamma_form": "form of the Grüneisen parameter: `rho_gamma_constant`, `constant`, or `linear` with `gamma_slope`; if omitted, `linear` "
                  "where `gamma_slope` is given, else `rho_gamma_constant`",
}
GAMMA_DEFAULTS = {"gamma_slope": math.nan, "specific_heat": math.nan, "reference_temperature": 298.15, "gamma_form": None}


def with_gamma_form(parameters):
    """A law's builder from a deck's values: the Grüneisen parameter by `gamma_form` as in mie_gruneisen."""
    def build(gamma_form=None, gamma_slope=math.nan, **given):
        return parameters(gamma_slope=gamma_slope_of(gamma_form, given["gamma0"], gamma_slope), **given)

    return build


def shocked(p, p_eta, eta):
    """(P, E, dP, dE) of a Hugoniot from P and its slope."""
    return p, 0.5 * p * eta, p_eta, 0.5 * (p_eta * eta + p)


def stretched(eta, c0, s):
    """(P, E, dP, dE) of the isentrope of bounded tension that continues a Hugoniot of sound speed c0 and initial slope s."""
    a = (4.0 / 3.0) * s
    inverse = 1.0 / (1.0 - a * eta)
    p = c0 * c0 * eta * (1.0 - 0.5 * a * eta) * inverse * inverse
    return p, 0.5 * c0 * c0 * eta * eta * inverse, c0 * c0 * inverse * inverse * inverse, p


def mie_gruneisen_pressure(rho, e, curve, rho0, gamma0, slope):
    """p = rho0 (P + (gamma0 + slope mu)(e - E))."""
    return rho0 * (curve[0] + (gamma0 + slope * (rho / rho0 - 1.0)) * (e - curve[1]))


def mie_gruneisen_derivatives(rho, e, curve, rho0, gamma0, slope):
    """(dp/drho, dp/de) of `mie_gruneisen_pressure`; the curve's slopes are by eta."""
    g = gamma0 + slope * (rho / rho0 - 1.0)
    eta_rho = rho0 / (rho * rho)
    return rho0 * (curve[2] - g * curve[3]) * eta_rho + slope * (e - curve[1]), rho0 * g


def log_heating(eta, gamma0, slope):
    """ln(T/T0) along an isentrope from rho0 to eta: (gamma0 - slope) eta - slope ln(1 - eta)."""
    return (gamma0 - slope) * eta - slope * vlog(1.0 - eta)


def isentrope_source(t, p, gamma0, slope, growth):
    """Integrand of the isentrope energy at strain t: (P - Gamma rho/rho0 E) T(eta)/T(t) for a Hugoniot with pressure P at t."""
    return p * (1.0 - 0.5 * t * (gamma0 + slope * t / (1.0 - t))) * vexp(growth - log_heating(t, gamma0, slope))


def highest_density(rho0, strain_limit, gamma0, slope):
    """Density at a limiting strain (inf where it is 1), no higher than where a falling rho Gamma vanishes."""
    high = rho0 / (1.0 - strain_limit) if strain_limit < 1.0 else math.inf
    return min(high, rho0 * (1.0 - gamma0 / slope)) if slope < 0.0 else high


def lowest_density(rho0, gamma0, slope):
    """Density below which rho Gamma would be negative (0 where it never is)."""
    return rho0 * (1.0 - gamma0 / slope) if slope > gamma0 else 0.0


# -- the functions of a law on a curve ---------------------------------------------------------------------------
def pressure(rho, e, par):
    return mie_gruneisen_pressure(rho, e, reference_curve(rho, par), par.rho0, par.gamma0, par.gamma_slope)


def pressure_derivatives(rho, e, par):
    return mie_gruneisen_derivatives(rho, e, reference_curve(rho, par), par.rho0, par.gamma0, par.gamma_slope)


def energy(rho, p, par):
    return (p - pressure(rho, 0.0, par)) / (par.rho0 * par.gamma0 + par.gamma_slope * (rho - par.rho0))


def specific_heat(rho, e, par):
    return par.specific_heat


def entropy(rho, e, par):
    """Zero at the reference state."""
    ratio = law_temperature(rho, e, par) / par.reference_temperature
    return par.specific_heat * (vlog(ratio) - log_heating(1.0 - par.rho0 / rho, par.gamma0, par.gamma_slope))


def reference_state(par):
    return par.rho0, 0.0


def density_limits(par):
    return lowest_density(par.rho0, par.gamma0, par.gamma_slope), highest_density(par.rho0, 1.0, par.gamma0, par.gamma_slope)


def reference_isentrope(rho, par):
    """(E, ln(T/T0)) where the curve is the isentrope through the reference state."""
    return reference_curve(rho, par)[1], log_heating(1.0 - par.rho0 / rho, par.gamma0, par.gamma_slope)


def temperature(rho, e, par):
    e_s, growth = reference_isentrope(rho, par)
    return par.reference_temperature * vexp(growth) + (e - e_s) / par.specific_heat


def shocked_or_stretched(rho, par):
    """The Hugoniot above rho0, bounded tension below: pressure, slope and curvature are continuous."""
    eta = 1.0 - par.rho0 / rho
    if eta > 0.0:
        p, p_eta = hugoniot_curve(eta, par)
        return shocked(p, p_eta, eta)
    return stretched(eta, par.c0, par.s1)


def isentrope_beside_hugoniot(rho, par):
    """(e, ln(T/T0)) on the isentrope through the reference state, by 16 Gauss points in eta: error below 1e-12 of e up to 70 % of the
    limiting strain."""
    eta = 1.0 - par.rho0 / rho
    growth = log_heating(eta, par.gamma0, par.gamma_slope)
    if eta > 0.0:
        total = 0.0
        for x, w in quadrature():
            t = x * eta
            total += w * isentrope_source(t, hugoniot_curve(t, par)[0], par.gamma0, par.gamma_slope, growth)
        return eta * total, growth
    return stretched(eta, par.c0, par.s1)[1], growth


def temperature_beside_hugoniot(rho, e, par):
    e_s, growth = isentrope_beside_hugoniot(rho, par)
    return par.reference_temperature * vexp(growth) + (e - e_s) / par.specific_heat


_COMMON = {"pressure": pressure, "pressure_derivatives": pressure_derivatives, "energy": energy, "specific_heat": specific_heat,
           "entropy": entropy, "reference_state": reference_state}
ON_ISENTROPE = {**_COMMON, "temperature": temperature, "reference_isentrope": reference_isentrope, "density_limits": density_limits}
ON_HUGONIOT = {**_COMMON, "temperature": temperature_beside_hugoniot, "reference_curve": shocked_or_stretched}
