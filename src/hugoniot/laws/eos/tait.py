r"""Mie-Grüneisen liquid on a Tait curve.

$$p = p_c(\rho) + \rho\Gamma\,(e - e_c(\rho)), \qquad \rho\Gamma = \rho_0(\Gamma_0 + b\mu), \qquad \mu = \rho/\rho_0 - 1$$
$$\eta = C\ln\left(1 + \frac{p_c}{B}\right) \;\Longleftrightarrow\; p_c = B\left(e^{\eta/C} - 1\right), \qquad
  e_c = \frac{B}{\rho_0}\left[C\left(e^{\eta/C} - 1\right) - \eta\right]$$

The curve is taken as the isentrope through the rest state (e = 0, T0), so $T = T_0\varphi + (e - e_c)/c_v$,
$\ln\varphi = (\Gamma_0 - b)\eta - b\ln(1-\eta)$, $\eta = 1 - \rho_0/\rho$. b = 0: rho Gamma constant; b = gamma0: Gamma constant.

Source: Tait 1888 in the form of Dymond and Malhotra 1988, Int. J. Thermophys. 9, 941 (natural logarithm).
"""

import math
from typing import NamedTuple

from hugoniot.core.ops import vexp, vlog
from hugoniot.laws.eos import reference_curves
from hugoniot.laws.eos.contract import EOS
from hugoniot.laws.eos.reference_curves import (
    gamma_slope_of,
    highest_density,
    log_heating,
    lowest_density,
    mie_gruneisen_derivatives,
    mie_gruneisen_pressure,
)


class Tait(NamedTuple):
    rho0: float
    b: float
    c: float
    gamma0: float
    gamma_slope: float = 0.0
    specific_heat: float = math.nan
    reference_temperature: float = 298.15


def _curve(rho, par):
    """(P, E, dP/deta, dE/deta) of the cold curve, P = p/rho0."""
    eta = 1.0 - par.rho0 / rho
    k = par.b / par.rho0
    growth = vexp(eta / par.c)
    p = k * (growth - 1.0)
    return p, par.c * p - k * eta, k / par.c * growth, p



def pressure(rho, e, par):
    return mie_gruneisen_pressure(rho, e, _curve(rho, par), par.rho0, par.gamma0, par.gamma_slope)


def pressure_derivatives(rho, e, par):
    return mie_gruneisen_derivatives(rho, e, _curve(rho, par), par.rho0, par.gamma0, par.gamma_slope)


def energy(rho, p, par):
    return (p - pressure(rho, 0.0, par)) / (par.rho0 * par.gamma0 + par.gamma_slope * (rho - par.rho0))


def reference_isentrope(rho, par):
    """(e, T/T0) on the isentrope through the rest state."""
    return _curve(rho, par)[1], vexp(log_heating(1.0 - par.rho0 / rho, par.gamma0, par.gamma_slope))


def temperature(rho, e, par):
    e_s, ratio = reference_isentrope(rho, par)
    return par.reference_temperature * ratio + (e - e_s) / par.specific_heat


def specific_heat(rho, e, par):
    return par.specific_heat


def entropy(rho, e, par):
    """Zero at the rest state."""
    ratio = temperature(rho, e, par) / par.reference_temperature
    return par.specific_heat * (vlog(ratio) - log_heating(1.0 - par.rho0 / rho, par.gamma0, par.gamma_slope))


def reference_state(par):
    return par.rho0, 0.0


def density_limits(par):
    return lowest_density(par.rho0, par.gamma0, par.gamma_slope), highest_density(par.rho0, 1.0, par.gamma0, par.gamma_slope)


def build(rho0, b, c, gamma0, gamma_form="rho_gamma_constant", gamma_slope=math.nan, specific_heat=math.nan,
          reference_temperature=298.15):
    """Parameters from a deck: the Grüneisen parameter by `gamma_form` as in mie_gruneisen."""
    if gamma_form == "rho_gamma_constant" and math.isfinite(gamma_slope) and gamma_slope != 0.0:
        gamma_form = "linear"
    slope = gamma_slope_of(gamma_form, gamma0, gamma_slope)
    return Tait(rho0, b, c, gamma0, slope, specific_heat, reference_temperature)


EOS.add(
    "tait", Tait,
    functions=[pressure, pressure_derivatives, energy, temperature, specific_heat, entropy, reference_state, density_limits],
    example=Tait(998.0, 0.2996e9, 0.1368, 0.12, 0.0, 4180.0),
    build=build,
    units={"rho0": "kg/m^3", "b": "Pa", "c": "1", **reference_curves.GAMMA_UNITS},
    meaning={"rho0": "density at rest", "b": "B, Pa", "c": "C (natural logarithm)", **reference_curves.GAMMA_MEANING},
    defaults=reference_curves.GAMMA_DEFAULTS,
    box={"rho": (900.0, 2000.0), "e": (0.0, 3e6)},
    references=("Dymond and Malhotra, Int. J. Thermophys. 9, 941 (1988)",),
    flags=("linear_in_energy",),
)
