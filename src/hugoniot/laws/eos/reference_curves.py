r"""Reference curves of the Mie-Grüneisen solids, and the law they make.

A reference curve is (P, E, dP/deta, dE/deta) at the compression $\eta = 1 - \rho_0/\rho$, with P = p/rho0 and E both in J/kg:

* `shocked`: a Hugoniot through the rest state, $E = P\eta/2$;
* `stretched`: the isentrope of bounded tension of mie_gruneisen below rho0.

`mie_gruneisen_pressure` and `mie_gruneisen_derivatives` join a curve to $\rho\Gamma = \rho_0(\Gamma_0 + b\mu)$, $\mu = \rho/\rho_0 - 1$.

Source: 003 (Starkenberg) A-1, A-6, A-11; the tension curve is derived in mie_gruneisen.
"""

import math

from hugoniot.core.ops import vexp, vlog
from hugoniot.errors import OutOfRange

KERNEL_HELPERS = True


def gamma_slope_of(form, gamma0, slope=math.nan):
    """b of Gamma = (gamma0 + b mu)/(1 + mu) for a named form: rho_gamma_constant, constant, linear (then `slope`)."""
    if form == "rho_gamma_constant":
        return 0.0
    if form == "constant":
        return gamma0
    if form == "linear":
        if not math.isfinite(slope):
            raise OutOfRange("mie_gruneisen: gamma_form 'linear' needs gamma_slope, the b of (gamma0 + b mu)/(1 + mu)")
        return slope
    raise OutOfRange(f"mie_gruneisen: unknown gamma_form '{form}'; known: rho_gamma_constant, constant, linear")


GAMMA_UNITS = {"gamma0": "1", "gamma_slope": "1", "specific_heat": "J/kg/K", "reference_temperature": "K", "gamma_form": "text"}
GAMMA_MEANING = {
    "gamma0": "Grüneisen parameter at rest", "gamma_slope": "b of Gamma = (gamma0 + b mu)/(1 + mu), mu = rho/rho0 - 1",
    "specific_heat": "specific heat at constant volume (for temperatures)", "reference_temperature": "temperature at rest",
    "gamma_form": "rho_gamma_constant | constant | linear (then with gamma_slope)",
}
GAMMA_DEFAULTS = {"gamma_slope": math.nan, "specific_heat": math.nan, "reference_temperature": 298.15, "gamma_form": "rho_gamma_constant"}


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
    """p = rho0 (P + (gamma0 + b mu)(e - E))."""
    return rho0 * (curve[0] + (gamma0 + slope * (rho / rho0 - 1.0)) * (e - curve[1]))


def mie_gruneisen_derivatives(rho, e, curve, rho0, gamma0, slope):
    """(dp/drho, dp/de) of `mie_gruneisen_pressure`; the curve's slopes are by eta."""
    g = gamma0 + slope * (rho / rho0 - 1.0)
    eta_rho = rho0 / (rho * rho)
    return rho0 * (curve[2] - g * curve[3]) * eta_rho + slope * (e - curve[1]), rho0 * g


def log_heating(eta, gamma0, slope):
    """ln(T/T0) along an isentrope from rho0 to eta: (gamma0 - b) eta - b ln(1 - eta)."""
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
