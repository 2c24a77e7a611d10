r"""Murnaghan equation of state, for moderately compressed solids known from ultrasonic or static compression data.

It is a Mie-Grüneisen law whose reference isentrope is a Murnaghan curve with pressure $p_c$ and energy $e_c$, on which the bulk modulus
is linear in the pressure:

$$p = p_c(\rho) + \rho\Gamma\,[e - e_c(\rho)], \qquad \rho\Gamma = \rho_0(\Gamma_0 + \Gamma_1\mu), \qquad \mu = \rho/\rho_0 - 1$$
$$p_c = \frac{K_0}{n}\left(X^n - 1\right), \qquad e_c = \frac{K_0}{n\rho_0}\left[\frac{X^{n-1} - 1}{n - 1} + \frac1X - 1\right],
  \qquad X = \rho/\rho_0$$

$\Gamma_1 = 0$ keeps $\rho\Gamma$ constant and $\Gamma_1 = \Gamma_0$ keeps $\Gamma$ constant; `gamma_form` selects one of these, and
`gamma_slope` gives any other slope. Densities at which $\rho\Gamma$ would not be positive are refused.

The curve is the isentrope through the reference state ($e = 0$, temperature $T_0$), so $K_0$ is the isentropic bulk modulus
(static compression gives the isothermal one). With a constant specific heat $c_v$,

$$T = T_0\varphi + \frac{e - e_c}{c_v}, \quad
  \ln\varphi = (\Gamma_0 - \Gamma_1)\,\eta - \Gamma_1\ln(1 - \eta), \quad \eta = 1 - \rho_0/\rho.$$

Tensions on the curve stay below $K_0/n$ (18 GPa for the example), and its sound speed is real at any expansion.

Source: Murnaghan, Proc. Natl. Acad. Sci. 30, 244 (1944); Herrmann, WL-TR-64-107, C.8 (with A = K0/n).
"""

import math
from typing import NamedTuple

from hugoniot.core.ops import vpow
from hugoniot.laws.eos import reference_curves
from hugoniot.laws.eos.contract import EOS
from hugoniot.laws.eos.reference_curves import with_gamma_form


class Murnaghan(NamedTuple):
    rho0: float
    bulk_modulus: float
    exponent: float
    gamma0: float
    gamma_slope: float = 0.0
    specific_heat: float = math.nan
    reference_temperature: float = 298.15


def reference_curve(rho, par):
    """(P, E, dP/deta, dE/deta) of the cold curve, P = p/rho0."""
    x, n = rho / par.rho0, par.exponent
    k = par.bulk_modulus / par.rho0
    power = vpow(x, n - 1.0)
    p = k / n * (power * x - 1.0)
    return p, k / n * ((power - 1.0) / (n - 1.0) + 1.0 / x - 1.0), k * power * x * x, p


EOS.add(
    "murnaghan", Murnaghan,
    functions={**reference_curves.ON_ISENTROPE, "reference_curve": reference_curve},
    example=Murnaghan(2785.0, 76e9, 4.3, 2.0, 0.0, 863.0),
    build=with_gamma_form(Murnaghan),
    units={"rho0": "kg/m^3", "bulk_modulus": "Pa", "exponent": "1", **reference_curves.GAMMA_UNITS},
    meaning={"rho0": "reference density", "bulk_modulus": "bulk modulus in the reference state",
             "exponent": "exponent, the pressure derivative of the bulk modulus, not 1", **reference_curves.GAMMA_MEANING},
    defaults=reference_curves.GAMMA_DEFAULTS,
    box={"rho": (2300.0, 6000.0), "e": (0.0, 1e7)},
    above={"exponent": 0.0},
    references=("Herrmann, WL-TR-64-107, eq. C.8", "Murnaghan, Proc. Natl. Acad. Sci. 30, 244 (1944)",),
    flags=("linear_in_energy",),
)
