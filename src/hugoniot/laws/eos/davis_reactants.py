r"""Davis equation of state for unreacted explosives.

It is referred to the principal isentrope, with pressure $p_s$ and energy $e_s$. With $y = 1 - \rho_0/\rho$ and $\hat p = \rho_0A^2/(4B)$,

$$p_s = \hat p\left[e^{4By} - 1\right]\ (y < 0), \qquad
  p_s = \hat p\left[\sum_{j=1}^{3}\frac{(4By)^j}{j!} + C\frac{(4By)^4}{4!} + \frac{y^2}{(1-y)^4}\right]\ (y \ge 0),$$
$$e_s = e_0 + \frac{1}{\rho_0}\int_0^y p_s\,dy, \qquad p = p_s + \rho\Gamma(e - e_s),$$

with $\Gamma = \Gamma_0$ in tension and $\Gamma = \Gamma_0 + Zy$ in compression. A specific heat $c_v = c_{v0}(T/T_s)^{\alpha}$ gives

$$T = T_s\left[1 + \frac{(1+\alpha)(e - e_s)}{c_{v0}T_s}\right]^{1/(1+\alpha)}, \quad T_s = T_0(1-y)^{-\Gamma_0-Z}e^{-Zy}
  \quad (Z = 0 \text{ for } y < 0).$$

With $Z < 0$ the law ends at the density at which $\Gamma$ vanishes.

Source: Wescott, Stewart and Davis, J. Appl. Phys. 98, 053514 (2005), eq. 10 to 20; Davis, Combust. Flame 120, 399 (2000).
"""

import math
from typing import NamedTuple

from hugoniot.core.ops import vexp, vlog, vpow
from hugoniot.laws.eos.contract import EOS


class DavisReactants(NamedTuple):
    rho0: float
    a: float
    b: float
    c: float
    gamma0: float
    z: float = 0.0
    alpha: float = 0.0
    e0: float = 0.0
    specific_heat: float = math.nan
    reference_temperature: float = 297.0


def _isentrope(y, par):
    """(p_s/rho0, e_s - e0, d(p_s/rho0)/dy)."""
    k, scale = 4.0 * par.b, par.a * par.a / (4.0 * par.b)
    x = k * y
    if y < 0.0:
        growth = vexp(x)
        return scale * (growth - 1.0), scale * ((growth - 1.0) / k - y), scale * k * growth
    r = 1.0 / (1.0 - y)
    p = x * (1.0 + x * (1 / 2 + x * (1 / 6 + x * (par.c / 24.0)))) + y * y * (r * r) * (r * r)
    e = x * x * (1 / 2 + x * (1 / 6 + x * (1 / 24 + x * (par.c / 120.0)))) / k + y * y * y * (r * r * r) / 3.0
    slope = k * (1.0 + x * (1.0 + x * (1 / 2 + x * (par.c / 6.0)))) + 2.0 * y * (1.0 + y) * (r * r) * (r * r * r)
    return scale * p, scale * e, scale * slope


def _z(y, par):
    return par.z if y > 0.0 else 0.0


def pressure(rho, e, par):
    y = 1.0 - par.rho0 / rho
    p_s, e_s, _ = _isentrope(y, par)
    return par.rho0 * p_s + rho * (par.gamma0 + _z(y, par) * y) * (e - par.e0 - e_s)


def pressure_derivatives(rho, e, par):
    v = par.rho0 / rho
    y = 1.0 - v
    p_s, e_s, slope = _isentrope(y, par)
    z = _z(y, par)
    gamma = par.gamma0 + z * y
    # dy/drho = v/rho, so d(rho Gamma)/drho = Gamma + Z v
    return v * v * slope + (gamma + z * v) * (e - par.e0 - e_s) - gamma * v * p_s, rho * gamma


def energy(rho, p, par):
    y = 1.0 - par.rho0 / rho
    p_s, e_s, _ = _isentrope(y, par)
    return par.e0 + e_s + (p - par.rho0 * p_s) / (rho * (par.gamma0 + _z(y, par) * y))


def _log_heating(y, par):
    """ln(T_s/T_0)."""
    z = _z(y, par)
    return -(par.gamma0 + z) * vlog(1.0 - y) - z * y


def reference_isentrope(rho, par):
    """The principal isentrope."""
    y = 1.0 - par.rho0 / rho
    return par.e0 + _isentrope(y, par)[1], _log_heating(y, par)


def _temperature_isentrope(y, par):
    return par.reference_temperature * vexp(_log_heating(y, par))


def _heat(rho, e, par):
    """(T_s, X), X = 1 + (1 + alpha)(e - e_s)/(c_v T_s): T = T_s X^(1/(1 + alpha))."""
    y = 1.0 - par.rho0 / rho
    t_s = _temperature_isentrope(y, par)
    return t_s, 1.0 + (1.0 + par.alpha) * (e - par.e0 - _isentrope(y, par)[1]) / (par.specific_heat * t_s)


def temperature(rho, e, par):
    t_s, x = _heat(rho, e, par)
    return t_s * vpow(x, 1.0 / (1.0 + par.alpha))


def specific_heat(rho, e, par):
    """c_v (T/T_s)^alpha, the power as X T_s/T."""
    _, x = _heat(rho, e, par)
    return par.specific_heat * (x / vpow(x, 1.0 / (1.0 + par.alpha)))


def entropy(rho, e, par):
    """Zero on the principal isentrope."""
    ratio = temperature(rho, e, par) / _temperature_isentrope(1.0 - par.rho0 / rho, par)
    logarithm = vlog(ratio)
    if par.alpha == 0.0:
        return par.specific_heat * logarithm
    return par.specific_heat * (vexp(par.alpha * logarithm) - 1.0) / par.alpha


def reference_state(par):
    return par.rho0, par.e0


def density_limits(par):
    """For Z < 0 the Grüneisen parameter vanishes at y = -gamma0/Z."""
    if par.z < 0.0 and -par.gamma0 / par.z < 1.0:
        return 0.0, par.rho0 / (1.0 + par.gamma0 / par.z)
    return 0.0, math.inf


EOS.add(
    "davis_reactants", DavisReactants,
    functions=[pressure, pressure_derivatives, energy, temperature, specific_heat, entropy, reference_state, density_limits,
               reference_isentrope],
    example=DavisReactants(1890.0, 1800.0, 4.6, 0.34, 0.56, 0.0, 0.4265, 4.115e6, 1074.0, 297.0),
    units={"rho0": "kg/m^3", "a": "m/s", "b": "1", "c": "1", "gamma0": "1", "z": "1", "alpha": "1", "e0": "J/kg",
           "specific_heat": "J/kg/K", "reference_temperature": "K"},
    meaning={"rho0": "reference density", "a": "sound speed in the reference state", "b": "stiffness of the isentrope",
             "c": "factor of the fourth-order term", "gamma0": "Grüneisen parameter at the reference density",
             "z": "slope of the Grüneisen parameter with 1 - rho0/rho in compression", "alpha": "exponent of the specific heat",
             "e0": "energy of the reference state; the heat of detonation if the energy of the fully expanded, cold products is zero",
             "specific_heat": "specific heat at constant volume on the principal isentrope",
             "reference_temperature": "temperature of the reference state"},
    defaults={"z": 0.0, "alpha": 0.0, "e0": 0.0, "specific_heat": math.nan, "reference_temperature": 297.0},
    box={"rho": (1700.0, 3800.0), "e": (4.0e6, 1.5e7)},
    references=("Wescott, Stewart and Davis, J. Appl. Phys. 98, 053514 (2005)", "Davis, Combust. Flame 120, 399 (2000)"),
    flags=("linear_in_energy",),
)
