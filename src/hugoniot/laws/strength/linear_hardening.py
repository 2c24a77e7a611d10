r"""Elastic-plastic solid with linear isotropic hardening, up to an optional limit.

$$G = G_0, \qquad Y = \min\left(Y_0 + H\,\varepsilon_p,\; Y_{\max}\right)$$

* $G$: shear modulus, with the constant value $G_0$, `shear_modulus`
* $Y$: flow stress in uniaxial stress; $Y_0$: its value at first yield, `yield_stress`; $Y_{\max}$: its limit, `largest_stress`
* $H$: hardening modulus, `hardening_modulus`; $\varepsilon_p$: accumulated equivalent plastic strain

$H$ is the slope of the stress against the *plastic* strain. From the tangent modulus $E_t$ of a tensile test and Young's modulus $E$ it
is $H = E E_t / (E - E_t)$. The constants of the example are those of
the copper bar in the verification problem `taylor_copper`.
"""

from typing import NamedTuple

from hugoniot.core.ops import NO_LIMIT, fmin
from hugoniot.laws.strength.contract import STRENGTH


class LinearHardening(NamedTuple):
    shear_modulus: float
    yield_stress: float
    hardening_modulus: float
    largest_stress: float = NO_LIMIT


def shear_modulus(rho, p, temperature, bulk_modulus, par):
    return par.shear_modulus


def flow_stress(rho, p, temperature, plastic_strain, strain_rate, par):
    return fmin(par.yield_stress + par.hardening_modulus * plastic_strain, par.largest_stress)


STRENGTH.add(
    "linear_hardening", LinearHardening,
    functions=[shear_modulus, flow_stress],
    example=LinearHardening(43.3e9, 0.4e9, 0.1e9, 0.7e9),
    units={"shear_modulus": "Pa", "yield_stress": "Pa", "hardening_modulus": "Pa", "largest_stress": "Pa"},
    meaning={"shear_modulus": "shear modulus", "yield_stress": "flow stress in uniaxial stress at first yield",
             "hardening_modulus": "slope of the flow stress against plastic strain",
             "largest_stress": "upper limit of the flow stress"},
    defaults={"largest_stress": NO_LIMIT},
    box={"rho": (5000.0, 15000.0), "p": (-5e9, 1e11), "temperature": (0.0, 1e4), "bulk_modulus": (1e9, 1e12),
         "plastic_strain": (0.0, 10.0), "strain_rate": (0.0, 1e9)},
    references=("Hill, The Mathematical Theory of Plasticity (1950), chapter II",),
    flags=("hardens",),
)
