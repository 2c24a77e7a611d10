r"""Mie-Grüneisen solid on a Murnaghan curve.

$$p = p_c(\rho) + \rho\Gamma\,(e - e_c(\rho)), \qquad \rho\Gamma = \rho_0(\Gamma_0 + b\mu), \qquad \mu = \rho/\rho_0 - 1$$
$$p_c = \frac{K_0}{n}\left(X^n - 1\right), \qquad e_c = \frac{K_0}{n\rho_0}\left[\frac{X^{n-1} - 1}{n - 1} + \frac1X - 1\right],
  \qquad X = \rho/\rho_0$$

The curve is taken as the isentrope through the rest state (e = 0, T0), so that $T = T_0\varphi + (e - e_c)/c_v$ with constant $c_v$ and
$\ln\varphi = (\Gamma_0 - b)\eta - b\ln(1 - \eta)$, $\eta = 1 - \rho_0/\rho$. b = 0: rho Gamma constant; b = gamma0: Gamma constant.

Source: Herrmann C.8 (with A = K0/n, exponent n); Murnaghan 1944.
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
    meaning={"rho0": "density at rest",
             "bulk_modulus": "bulk modulus at rest", "exponent": "exponent n, its pressure derivative (not 1)",
             **reference_curves.GAMMA_MEANING},
    defaults=reference_curves.GAMMA_DEFAULTS,
    box={"rho": (2300.0, 6000.0), "e": (0.0, 1e7)},
    above={"exponent": 0.0},
    references=("Herrmann, WL-TR-64-107, C.8", "Murnaghan, Proc. Natl. Acad. Sci. 30, 244 (1944)",),
    flags=("linear_in_energy",),
)
