r"""Vinet equation of state, for solids under strong static compression.

It is a Mie-Grüneisen law whose reference isentrope is a Vinet curve with pressure $p_c$ and energy $e_c$:

$$p = p_c(\rho) + \rho\Gamma\,[e - e_c(\rho)], \qquad \rho\Gamma = \rho_0(\Gamma_0 + \Gamma_1\mu), \qquad \mu = \rho/\rho_0 - 1$$
$$p_c = 3K_0\frac{1 - X}{X^2}e^{\zeta(1-X)}, \quad e_c = \frac{9K_0}{\rho_0\zeta^2}\left\{1 + [\zeta(1-X) - 1]e^{\zeta(1-X)}\right\},
  \quad X = (\rho_0/\rho)^{1/3}, \; \zeta = \tfrac32(K_0' - 1)$$

$\Gamma_1 = 0$ keeps $\rho\Gamma$ constant and $\Gamma_1 = \Gamma_0$ keeps $\Gamma$ constant; `gamma_form` selects one of these, and
`gamma_slope` gives any other slope. Densities at which $\rho\Gamma$ would not be positive are refused.

The curve is the isentrope through the reference state ($e = 0$, temperature $T_0$), so $K_0$ is the isentropic bulk modulus
(static compression gives the isothermal one). With a constant specific heat $c_v$,

$$T = T_0\varphi + \frac{e - e_c}{c_v}, \quad
  \ln\varphi = (\Gamma_0 - \Gamma_1)\,\eta - \Gamma_1\ln(1 - \eta), \quad \eta = 1 - \rho_0/\rho.$$

The curve has a greatest tension (copper: 18 GPa at $0.72\,\rho_0$), beyond which the sound speed on it is no longer real.

Source: Vinet, Ferrante, Rose and Smith, J. Geophys. Res. 92, 9319 (1987).
"""

import math
from typing import NamedTuple

from hugoniot.core.ops import vexp, vlog
from hugoniot.laws.eos import reference_curves
from hugoniot.laws.eos.contract import EOS
from hugoniot.laws.eos.reference_curves import with_gamma_form


class Vinet(NamedTuple):
    rho0: float
    bulk_modulus: float
    bulk_modulus_slope: float
    gamma0: float
    gamma_slope: float = 0.0
    specific_heat: float = math.nan
    reference_temperature: float = 298.15


def reference_curve(rho, par):
    """(P, E, dP/deta, dE/deta) of the cold curve, P = p/rho0."""
    x = vexp(vlog(par.rho0 / rho) / 3.0)
    zeta = 1.5 * (par.bulk_modulus_slope - 1.0)
    k = par.bulk_modulus / par.rho0
    y = 1.0 - x
    growth = vexp(zeta * y)
    p = 3.0 * k * y / (x * x) * growth
    e = 9.0 * k / (zeta * zeta) * (1.0 + (zeta * y - 1.0) * growth)
    # dX/deta = -1/(3 X^2)
    return p, e, k * growth * (2.0 - x + zeta * x * y) / (x * x * x * x * x), p


EOS.add(
    "vinet", Vinet,
    functions={**reference_curves.ON_ISENTROPE, "reference_curve": reference_curve},
    example=Vinet(8930.0, 137e9, 5.48, 1.99, 0.0, 385.0),
    build=with_gamma_form(Vinet),
    units={"rho0": "kg/m^3", "bulk_modulus": "Pa", "bulk_modulus_slope": "1", **reference_curves.GAMMA_UNITS},
    meaning={"rho0": "reference density", "bulk_modulus": "bulk modulus in the reference state",
             "bulk_modulus_slope": "pressure derivative of the bulk modulus in the reference state, not 1",
             **reference_curves.GAMMA_MEANING},
    defaults=reference_curves.GAMMA_DEFAULTS,
    box={"rho": (7600.0, 20000.0), "e": (0.0, 1e7)},
    references=("Vinet, Ferrante, Rose and Smith, J. Geophys. Res. 92, 9319 (1987)",),
    flags=("linear_in_energy",),
)
