r"""Davis equation of state for detonation products.

It is referred to an isentrope with energy $e_s$ and pressure $p_s$. With $v = 1/\rho$, $w = v/v_c$ and
$D(w) = \tfrac12(w^n + w^{-n})$,

$$e_s = e_c\frac{D^{a/n}}{w^{k-1+a}}, \quad p_s = \frac{e_s}{v}(k - 1 + F), \quad F = \frac{2a\,w^{-n}}{w^n + w^{-n}}, \quad
  e_c = \frac{p_cv_c}{k-1+a},$$
$$p = p_s + \frac{\Gamma}{v}(e - e_s), \qquad \Gamma = k - 1 + (1-b)F.$$

On the isentrope $F$ falls from $2a$ in dense products to 0 in a dilute gas. This transition is centred at the volume $v_c$, where
$F = a$. The adiabatic exponent $-d\ln p_s/d\ln v$ goes from $k + 2a$ to $k$, but with a maximum in between (example: from 2.95 to 1.35,
with a maximum of 4.05 at $1.08\,v_c$).

With a constant specific heat $c_v$ the temperature is

$$T = T_s + \frac{e - e_s}{c_v}, \qquad T_s = T_c\frac{D^{(a/n)(1-b)}}{w^{k-1+a(1-b)}}, \qquad
  T_c = \frac{2^{-ab/n}}{k-1+a}\,\frac{p_cv_c}{c_v}.$$

The state at $\rho_0$ and $e_0$ is that of a constant-volume explosion. Energies of products and explosive must have the same origin; for
an explosive with the law `davis_reactants` use the same `e0`.

Source: Wescott, Stewart and Davis, J. Appl. Phys. 98, 053514 (2005), eq. 1 to 9; Davis (1993), as quoted by Starkenberg, A-1.
"""

import math
from typing import NamedTuple

from hugoniot.core.ops import vexp, vlog
from hugoniot.laws.eos.contract import EOS


class DavisProducts(NamedTuple):
    a: float
    b: float
    k: float
    n: float
    vc: float
    pc: float
    rho0: float
    e0: float = 0.0
    specific_heat: float = math.nan


def _shape(rho, par):
    """(ln w, ln D, F)."""
    u = -vlog(rho * par.vc)
    shrink = vexp(-2.0 * par.n * u)
    # D = w^n (1 + w^-2n)/2
    return u, par.n * u + vlog(0.5 + 0.5 * shrink), 2.0 * par.a * shrink / (1.0 + shrink)


def _energy_isentrope(u, log_d, par):
    return par.pc * par.vc / (par.k - 1.0 + par.a) * vexp(par.a / par.n * log_d - (par.k - 1.0 + par.a) * u)


def pressure(rho, e, par):
    u, log_d, f = _shape(rho, par)
    e_s = _energy_isentrope(u, log_d, par)
    return rho * (e_s * (par.k - 1.0 + f) + (par.k - 1.0 + (1.0 - par.b) * f) * (e - e_s))


def pressure_derivatives(rho, e, par):
    u, log_d, f = _shape(rho, par)
    e_s = _energy_isentrope(u, log_d, par)
    h = par.k - 1.0 + f
    gamma = par.k - 1.0 + (1.0 - par.b) * f
    # by ln rho: e_s' = h e_s, F' = n F (2 - F/a)
    f_slope = par.n * f * (2.0 - f / par.a)
    return (e_s * (h * (1.0 + h - gamma) + f_slope) + (gamma + (1.0 - par.b) * f_slope) * (e - e_s)), rho * gamma


def energy(rho, p, par):
    u, log_d, f = _shape(rho, par)
    e_s = _energy_isentrope(u, log_d, par)
    return e_s + (p / rho - e_s * (par.k - 1.0 + f)) / (par.k - 1.0 + (1.0 - par.b) * f)


def _log_heating(u, log_d, par):
    """ln(T_s/T_c)."""
    return (1.0 - par.b) * par.a / par.n * log_d - (par.k - 1.0 + par.a * (1.0 - par.b)) * u


def temperature(rho, e, par):
    u, log_d, _ = _shape(rho, par)
    t_c = vexp(-par.a * par.b / par.n * 0.6931471805599453) / (par.k - 1.0 + par.a) * par.pc * par.vc / par.specific_heat
    return t_c * vexp(_log_heating(u, log_d, par)) + (e - _energy_isentrope(u, log_d, par)) / par.specific_heat


def specific_heat(rho, e, par):
    return par.specific_heat


def entropy(rho, e, par):
    """Zero where T = 1 K at v = vc."""
    u, log_d, _ = _shape(rho, par)
    return par.specific_heat * (vlog(temperature(rho, e, par)) - _log_heating(u, log_d, par))


def reference_isentrope(rho, par):
    u, log_d, _ = _shape(rho, par)
    return _energy_isentrope(u, log_d, par), _log_heating(u, log_d, par)


def reference_state(par):
    """The products at the density and energy of the explosive (constant-volume explosion)."""
    return par.rho0, par.e0


def density_limits(par):
    return 0.0, math.inf


EOS.add(
    "davis_products", DavisProducts,
    functions=[pressure, pressure_derivatives, energy, temperature, specific_heat, entropy, reference_state, density_limits,
               reference_isentrope],
    example=DavisProducts(0.798311, 0.58, 1.35, 2.66182, 0.75419e-3, 3.2e9, 1890.0, 4.115e6, 1072.0),
    units={"a": "1", "b": "1", "k": "1", "n": "1", "vc": "m^3/kg", "pc": "Pa", "rho0": "kg/m^3", "e0": "J/kg", "specific_heat": "J/kg/K"},
    meaning={"a": "half the value of F in dense products", "b": "fraction of F that is missing from the Grüneisen parameter",
             "k": "adiabatic exponent at large volumes",
             "n": "sharpness of the transition", "vc": "specific volume of the transition", "pc": "pressure scale of the transition",
             "rho0": "density of the unreacted explosive", "e0": "energy of the unreacted explosive",
             "specific_heat": "specific heat at constant volume, needed for temperatures"},
    defaults={"e0": 0.0, "specific_heat": math.nan},
    box={"rho": (20.0, 3500.0), "e": (3e6, 2e7)},
    references=("Wescott, Stewart and Davis, J. Appl. Phys. 98, 053514 (2005)",
                "Davis 1993, as cited in Starkenberg, ARL-TR-2161, appendix A-1"),
    flags=("linear_in_energy", "gas", "reacted"),
)
