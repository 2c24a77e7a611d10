r"""Elastic-perfectly plastic with a constant shear modulus.

$$G = G_0, \qquad Y = Y_0$$

Source: Wilkins B.1 items 5 and 9 (his shear modulus is written mu).
"""

from typing import NamedTuple

from hugoniot.laws.strength.contract import STRENGTH


class PerfectlyPlastic(NamedTuple):
    shear_modulus: float
    yield_stress: float


def shear_modulus(rho, p, temperature, bulk_modulus, par):
    return par.shear_modulus


def flow_stress(rho, p, temperature, plastic_strain, strain_rate, par):
    return par.yield_stress


STRENGTH.add(
    "perfectly_plastic", PerfectlyPlastic,
    functions=[shear_modulus, flow_stress],
    example=PerfectlyPlastic(27.6e9, 0.3e9),
    units={"shear_modulus": "Pa", "yield_stress": "Pa"},
    meaning={"shear_modulus": "shear modulus, constant", "yield_stress": "uniaxial stress at yield, constant"},
    box={"rho": (2000.0, 5000.0), "p": (-5e9, 1e11), "temperature": (0.0, 1e4), "bulk_modulus": (1e9, 1e12),
         "plastic_strain": (0.0, 10.0), "strain_rate": (0.0, 1e9)},
    references=("Wilkins, B.1 items 5 and 9",),
)
