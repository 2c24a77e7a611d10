r"""Elastic-perfectly plastic with a shear modulus that is a power series in the compression.

$$G = g_0\,\left(1 + g_1 x + g_2 x^2 + g_3 x^3\right), \qquad x = 1 - \rho_0/\rho, \qquad Y = Y_0$$

Source: Herrmann WL-TR-64-107, equations A.17 ff. and B.28. His compression eta is x here: it is (rho - rho0)/rho by the definition under
C.4 and by the factor (1 - eta) in the derivatives under A.14. The report's aluminium has g0 = 286 kb, g1 = 5.86, g2 = 8.44, g3 = 0, Y =
2.76 kb, rho0 = 2.78 g/cm3 (section VI; 2.73 kb in one place, H-E10).
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
    meaning={"rho0": "density at zero compression", "g0": "shear modulus at zero compression",
             "g1": "first coefficient of the compression series", "g2": "second coefficient of the compression series",
             "g3": "third coefficient of the compression series", "yield_stress": "uniaxial stress at yield, constant"},
    box={"rho": (2500.0, 4500.0), "p": (-5e9, 1e11), "temperature": (0.0, 1e4), "bulk_modulus": (1e9, 1e12),
         "plastic_strain": (0.0, 10.0), "strain_rate": (0.0, 1e9)},
    references=("Herrmann, WL-TR-64-107, equations A.17 ff. and B.28",),
)
