r"""Tait equation of state, for liquids.

It is a Mie-Grüneisen law whose reference isentrope is a Tait curve with pressure $p_c$ and energy $e_c$. With $\eta = 1 - \rho_0/\rho$,

$$p = p_c(\rho) + \rho\Gamma\,[e - e_c(\rho)], \qquad \rho\Gamma = \rho_0(\Gamma_0 + \Gamma_1\mu), \qquad \mu = \rho/\rho_0 - 1$$
$$\eta = C\ln\left(1 + \frac{p_c}{B}\right) \;\Longleftrightarrow\; p_c = B\left(e^{\eta/C} - 1\right), \qquad
  e_c = \frac{B}{\rho_0}\left[C\left(e^{\eta/C} - 1\right) - \eta\right]$$

$\Gamma_1 = 0$ keeps $\rho\Gamma$ constant and $\Gamma_1 = \Gamma_0$ keeps $\Gamma$ constant; `gamma_form` selects one of these, and
`gamma_slope` gives any other slope. Densities at which $\rho\Gamma$ would not be positive are refused.

The curve is the isentrope through the reference state ($e = 0$, temperature $T_0$); its bulk modulus there is $B/C$. With a constant
specific heat $c_v$,

$$T = T_0\varphi + \frac{e - e_c}{c_v}, \qquad \ln\varphi = (\Gamma_0 - \Gamma_1)\,\eta - \Gamma_1\ln(1 - \eta).$$

Use the logarithm as written: constants published for the decimal logarithm have another $C$. Constants from
static experiments are valid up to the pressures of those experiments. Tensions on the curve stay below $B$.

Source: Tait (1888) in the form of Dymond and Malhotra, Int. J. Thermophys. 9, 941 (1988).
"""

import math
from typing import NamedTuple

from hugoniot.core.ops import vexp
from hugoniot.laws.eos import reference_curves
from hugoniot.laws.eos.contract import EOS
from hugoniot.laws.eos.reference_curves import with_gamma_form


class Tait(NamedTuple):
    rho0: float
    b: float
    c: float
    gamma0: float
    gamma_slope: float = 0.0
    specific_heat: float = math.nan
    reference_temperature: float = 298.15


def reference_curve(rho, par):
    """(P, E, dP/deta, dE/deta) of the cold curve, P = p/rho0."""
    eta = 1.0 - par.rho0 / rho
    k = par.b / par.rho0
    growth = vexp(eta / par.c)
    p = k * (growth - 1.0)
    return p, par.c * p - k * eta, k / par.c * growth, p


EOS.add(
    "tait", Tait,
    functions={**reference_curves.ON_ISENTROPE, "reference_curve": reference_curve},
    example=Tait(998.0, 0.2996e9, 0.1368, 0.12, 0.0, 4180.0),
    build=with_gamma_form(Tait),
    units={"rho0": "kg/m^3", "b": "Pa", "c": "1", **reference_curves.GAMMA_UNITS},
    meaning={"rho0": "reference density", "b": "pressure scale", "c": "compression scale, with the natural logarithm",
             **reference_curves.GAMMA_MEANING},
    defaults=reference_curves.GAMMA_DEFAULTS,
    box={"rho": (900.0, 2000.0), "e": (0.0, 3e6)},
    references=("Dymond and Malhotra, Int. J. Thermophys. 9, 941 (1988)",),
    flags=("linear_in_energy",),
)
