r"""Third-order Birch-Murnaghan equation of state, for solids known from static compression or ultrasonic data.

It is a Mie-Grüneisen law whose reference isentrope is a Birch-Murnaghan curve with pressure $p_c$ and energy $e_c$:

$$p = p_c(\rho) + \rho\Gamma\,[e - e_c(\rho)], \qquad \rho\Gamma = \rho_0(\Gamma_0 + \Gamma_1\mu), \qquad \mu = \rho/\rho_0 - 1$$
$$p_c = 3K_0f(1 + 2f)^{5/2}\left[1 + \tfrac32(K_0' - 4)f\right], \quad e_c = \frac{9K_0}{2\rho_0}f^2\left[1 + (K_0' - 4)f\right],
  \quad f = \tfrac12\left[(\rho/\rho_0)^{2/3} - 1\right]$$

$\Gamma_1 = 0$ keeps $\rho\Gamma$ constant and $\Gamma_1 = \Gamma_0$ keeps $\Gamma$ constant; `gamma_form` selects one of these, and
`gamma_slope` gives any other slope. Densities at which $\rho\Gamma$ would not be positive are refused.

The curve is the isentrope through the reference state ($e = 0$, temperature $T_0$), so $K_0$ is the isentropic bulk modulus
(static compression gives the isothermal one). With a constant specific heat $c_v$,

$$T = T_0\varphi + \frac{e - e_c}{c_v}, \quad
  \ln\varphi = (\Gamma_0 - \Gamma_1)\,\eta - \Gamma_1\ln(1 - \eta), \quad \eta = 1 - \rho_0/\rho.$$

The curve has a greatest tension (iron: 23 GPa at $0.68\,\rho_0$), beyond which the sound speed on it is no longer real. With
$K_0' < 4$ its pressure also has a maximum in compression.

Source: Birch, Phys. Rev. 71, 809 (1947).
"""

import math
from typing import NamedTuple

from hugoniot.core.ops import vexp, vlog
from hugoniot.laws.eos import reference_curves
from hugoniot.laws.eos.contract import EOS
from hugoniot.laws.eos.reference_curves import with_gamma_form


class BirchMurnaghan(NamedTuple):
    rho0: float
    bulk_modulus: float
    bulk_modulus_slope: float
    gamma0: float
    gamma_slope: float = 0.0
    specific_heat: float = math.nan
    reference_temperature: float = 298.15


def reference_curve(rho, par):
    """(P, E, dP/deta, dE/deta) of the cold curve, P = p/rho0."""
    root = vexp(vlog(rho / par.rho0) / 3.0)
    y = root * root
    f = 0.5 * (y - 1.0)
    w = par.bulk_modulus_slope - 4.0
    k = par.bulk_modulus / par.rho0
    stretch = y * y * root
    p = 3.0 * k * f * stretch * (1.0 + 1.5 * w * f)
    # df/deta = (1 + 2f)^(5/2)/3
    p_f = 3.0 * k * stretch * ((1.0 + 5.0 * f / y) * (1.0 + 1.5 * w * f) + 1.5 * w * f)
    return p, 4.5 * k * f * f * (1.0 + w * f), p_f * stretch / 3.0, p


EOS.add(
    "birch_murnaghan", BirchMurnaghan,
    functions={**reference_curves.ON_ISENTROPE, "reference_curve": reference_curve},
    example=BirchMurnaghan(7874.0, 166e9, 5.3, 1.7, 0.0, 450.0),
    build=with_gamma_form(BirchMurnaghan),
    units={"rho0": "kg/m^3", "bulk_modulus": "Pa", "bulk_modulus_slope": "1", **reference_curves.GAMMA_UNITS},
    meaning={"rho0": "reference density", "bulk_modulus": "bulk modulus in the reference state",
             "bulk_modulus_slope": "pressure derivative of the bulk modulus in the reference state", **reference_curves.GAMMA_MEANING},
    defaults=reference_curves.GAMMA_DEFAULTS,
    box={"rho": (7200.0, 16000.0), "e": (0.0, 1e7)},
    references=("Birch, Phys. Rev. 71, 809 (1947)",),
    flags=("linear_in_energy",),
)
