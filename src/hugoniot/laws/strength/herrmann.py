r"""Elastic-perfectly plastic solid whose shear modulus is a cubic in the compression.

$$G = g_0\,\left(1 + g_1 x + g_2 x^2 + g_3 x^3\right), \qquad x = 1 - \rho_0/\rho, \qquad Y = Y_0$$

* $G$: shear modulus; $Y$: flow stress in uniaxial stress
* $\rho_0$: reference density, `rho0`; $x$: compression
* $g_0$: shear modulus at $\rho_0$, `g0`; $g_1, g_2, g_3$: coefficients, `g1`, `g2`, `g3`
* $Y_0$: yield stress, `yield_stress`

The example is the aluminium of Herrmann's report (section VI). The report gives its yield stress as 0.276 GPa, and in one place as
0.273 GPa (H-E10).
"""

from typing import NamedTuple

from hugoniot.laws.strength.contract import STRENGTH


class Herrmann(NamedTuple):
    rho0: float
    g0: float
    g1: float
    g2: float
    g3: float
    yield_stress: float


def shear_modulus(rho, p, temperature, bulk_modulus, par):
    x = 1.0 - par.rho0 / rho
    return par.g0 * (1.0 + x * (par.g1 + x * (par.g2 + x * par.g3)))


def flow_stress(rho, p, temperature, plastic_strain, strain_rate, par):
    return par.yield_stress


STRENGTH.add(
    "herrmann", Herrmann,
    functions=[shear_modulus, flow_stress],
    example=Herrmann(2780.0, 28.6e9, 5.86, 8.44, 0.0, 0.276e9),
    units={"rho0": "kg/m^3", "g0": "Pa", "g1": "1", "g2": "1", "g3": "1", "yield_stress": "Pa"},
    meaning={"rho0": "reference density", "g0": "shear modulus at the reference density",
             "g1": "coefficient of the compression", "g2": "coefficient of the square of the compression",
             "g3": "coefficient of the cube of the compression", "yield_stress": "flow stress in uniaxial stress"},
    box={"rho": (2500.0, 4500.0), "p": (-5e9, 1e11), "temperature": (0.0, 1e4), "bulk_modulus": (1e9, 1e12),
         "plastic_strain": (0.0, 10.0), "strain_rate": (0.0, 1e9)},
    references=("Herrmann, WL-TR-64-107 (1964), equations A.17 ff. and B.28, with the compression as defined in C.4",),
)
