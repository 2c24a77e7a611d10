r"""Mie-Grüneisen equation of state with a linear shock Hugoniot as reference curve and a Grüneisen parameter that varies with compression.

Use it instead of `mie_gruneisen` where $\rho\Gamma$ is not constant, which matters far from the Hugoniot: in porous or reshocked
material.

$$p = p_R(\eta) + \rho\Gamma\,[e - e_R(\eta)], \qquad \rho\Gamma = \rho_0(\Gamma_0 + \Gamma_1\mu), \qquad
  \mu = \rho/\rho_0 - 1, \quad \eta = 1 - \rho_0/\rho$$

The reference curves $p_R$ and $e_R$ are those of `mie_gruneisen`: the principal Hugoniot $p_R = \rho_0c_0^2\eta/(1-s\eta)^2$,
$e_R = p_R\eta/(2\rho_0)$ in compression, an isentrope below $\rho_0$. $\Gamma_1 = 0$ keeps $\rho\Gamma$ constant and
$\Gamma_1 = \Gamma_0$ keeps $\Gamma$ constant. Densities are limited to those where $\rho\Gamma$ is positive, and by the pole of the
Hugoniot at $\eta = 1/s$ if $s > 1$; with $s < 1$ the fit ends at $u_p = c_0/(1 - s)$ (J-E16).

With a constant specific heat $c_v$ the temperature is $T = T_0\varphi + (e - e_S)/c_v$ with
$\varphi = e^{(\Gamma_0-\Gamma_1)\eta}(1-\eta)^{-\Gamma_1}$ and the isentrope through the reference state, in compression

$$e_S = \varphi \int_0^\eta \frac{c_0^2\,t\,(1 - \tfrac12 t\,[\Gamma_0 + \Gamma_1\,t/(1-t)])}{(1-st)^2\,\varphi(t)}\,dt.$$

It is evaluated with 10 Gauss points in $-\ln(1 - t/\eta_m)$, where $\eta_m$ is the limiting compression ($1/s$, or 1 if $s \le 1$). For
$s > 1$ the error is below $10^{-13}$ of the energy up to 80 % of $\eta_m$, and $10^{-9}$ at 95 %.

Source: Steinberg, Cochran and Guinan, J. Appl. Phys. 51, 1498 (1980), as quoted by Starkenberg, ARL-TR-2161, appendix A-6; Starkenberg
A-11; Herrmann, WL-TR-64-107, C.12.
"""

import math
from typing import NamedTuple

from hugoniot.core.ops import vexp, vlog
from hugoniot.laws.eos.contract import EOS
from hugoniot.laws.eos.reference_curves import highest_density, log_heating, lowest_density


class MieGruneisenLinearGamma(NamedTuple):
    rho0: float
    c0: float
    s: float
    gamma0: float
    gamma_slope: float
    specific_heat: float = math.nan
    reference_temperature: float = 298.15


def _strain(rho, par):
    """(eta, 1/(1 - kappa eta), mu); kappa is s in compression and 4s/3 in tension."""
    d = rho - par.rho0
    b = rho - (par.s if d > 0.0 else (4.0 / 3.0) * par.s) * d
    r = 1.0 / (rho * b)
    return d * b * r, rho * rho * r, d / par.rho0


def pressure(rho, e, par):
    eta, inverse, mu = _strain(rho, par)
    g = par.gamma0 + par.gamma_slope * mu
    tension = 0.0 if eta > 0.0 else (2.0 / 3.0) * par.s
    shape = 1.0 - 0.5 * g * eta - tension * eta * (1.0 - g * eta)
    return par.rho0 * (par.c0 * par.c0 * (eta * inverse * inverse * shape) + g * e)


def pressure_derivatives(rho, e, par):
    eta, inverse, mu = _strain(rho, par)
    a, b = (4.0 / 3.0) * par.s, par.gamma_slope
    g = par.gamma0 + b * mu
    compressed = 1.0 + (par.s - g) * eta
    stretched = 1.0 - g * eta * (1.0 - 0.5 * a * eta) * (1.0 - a * eta)
    slope = compressed if eta > 0.0 else stretched
    v_ratio = 1.0 - eta
    cc = par.c0 * par.c0
    e_reference = 0.5 * cc * eta * eta * inverse * (inverse if eta > 0.0 else 1.0)
    return cc * (v_ratio * v_ratio) * (inverse * inverse * inverse * slope) + b * (e - e_reference), par.rho0 * g


def energy(rho, p, par):
    return (p - pressure(rho, 0.0, par)) / (par.rho0 * par.gamma0 + par.gamma_slope * (rho - par.rho0))


def _node(x, weight, far, top, growth, par):
    """One Gauss point of the isentrope energy at sigma = x far, weight and dt/dsigma included."""
    z = vexp(-far * x)
    t = top * (1.0 - z)
    y = 1.0 - par.s * t
    cold = t * (1.0 - 0.5 * t * (par.gamma0 + par.gamma_slope * t / (1.0 - t))) / (y * y)
    return weight * z * cold * vexp(growth - log_heating(t, par.gamma0, par.gamma_slope))


def reference_isentrope(rho, par):
    """(e, T/T0) on the isentrope through the reference state."""
    eta, inverse, mu = _strain(rho, par)
    cc, s = par.c0 * par.c0, par.s
    growth = log_heating(eta, par.gamma0, par.gamma_slope)
    e_s = 0.5 * cc * eta * eta * inverse
    if eta > 0.0:
        top = 1.0 / s if s > 1.0 else 1.0
        far = -vlog(1.0 - eta / top)
        # ten calls and no loop: an inner loop would stop the vectoriser
        total = (_node(0.013046735741414128, 0.03333567215434407, far, top, growth, par)
                 + _node(0.06746831665550773, 0.0747256745752902, far, top, growth, par)
                 + _node(0.16029521585048778, 0.109543181257991, far, top, growth, par)
                 + _node(0.2833023029353764, 0.13463335965499826, far, top, growth, par)
                 + _node(0.4255628305091844, 0.1477621123573764, far, top, growth, par)
                 + _node(0.5744371694908156, 0.1477621123573764, far, top, growth, par)
                 + _node(0.7166976970646236, 0.13463335965499826, far, top, growth, par)
                 + _node(0.8397047841495122, 0.109543181257991, far, top, growth, par)
                 + _node(0.9325316833444923, 0.0747256745752902, far, top, growth, par)
                 + _node(0.9869532642585859, 0.03333567215434407, far, top, growth, par))
        e_s = cc * top * far * total
    return e_s, vexp(growth)


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


def density_limits(par):
    """rho Gamma vanishes below mu = -gamma0/gamma_slope when gamma_slope > gamma0; the Hugoniot is singular at eta = 1/s (s > 1)."""
    strain = 1.0 / par.s if par.s > 1.0 else 1.0
    return (lowest_density(par.rho0, par.gamma0, par.gamma_slope),
            highest_density(par.rho0, strain, par.gamma0, par.gamma_slope))


def particle_velocity_limit(par):
    """J-E16: with s < 1 up catches up with the fitted Us at up = c0/(1 - s), infinite compression; no shock is faster."""
    return par.c0 / (1.0 - par.s) if par.s < 1.0 else math.inf


EOS.add(
    "mie_gruneisen_linear_gamma", MieGruneisenLinearGamma,
    functions=[pressure, pressure_derivatives, energy, temperature, specific_heat, entropy, reference_state, density_limits,
               particle_velocity_limit],
    example=MieGruneisenLinearGamma(2785.0, 5328.0, 1.338, 2.0, 0.48, 863.0),
    units={"rho0": "kg/m^3", "c0": "m/s", "s": "1", "gamma0": "1", "gamma_slope": "1", "specific_heat": "J/kg/K",
           "reference_temperature": "K"},
    meaning={"rho0": "reference density", "c0": "shock velocity at zero particle velocity", "s": "slope of the Hugoniot, dUs/dup",
             "gamma0": "Grüneisen parameter at the reference density",
             "gamma_slope": "slope of rho Gamma/rho0 against mu = rho/rho0 - 1: Gamma = (gamma0 + gamma_slope mu)/(1 + mu)",
             "specific_heat": "specific heat at constant volume, needed for temperatures",
             "reference_temperature": "temperature of the reference state"},
    defaults={"specific_heat": math.nan, "reference_temperature": 298.15},
    box={"rho": (2100.0, 6500.0), "e": (0.0, 2e7)},
    references=("Steinberg, Cochran and Guinan, J. Appl. Phys. 51, 1498 (1980), as quoted in Starkenberg, ARL-TR-2161, appendix A-6",
                "Starkenberg, ARL-TR-2161, appendix A-11"),
    flags=("linear_in_energy",),
)
