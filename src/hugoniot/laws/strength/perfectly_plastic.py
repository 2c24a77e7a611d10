r"""Elastic-perfectly plastic solid with constant shear modulus and yield stress.

$$G = G_0, \qquad Y = Y_0$$

* $G$: shear modulus, with the constant value $G_0$, `shear_modulus`
* $Y$: flow stress in uniaxial stress, with the constant value $Y_0$, `yield_stress`

The simplest strength law, suited to shocks in which hardening and heating change the flow stress little.
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
    meaning={"shear_modulus": "shear modulus", "yield_stress": "flow stress in uniaxial stress"},
    box={"rho": (2000.0, 5000.0), "p": (-5e9, 1e11), "temperature": (0.0, 1e4), "bulk_modulus": (1e9, 1e12),
         "plastic_strain": (0.0, 10.0), "strain_rate": (0.0, 1e9)},
    references=("Wilkins, appendix B.1, items 5 and 9 (where the shear modulus is mu)",),
)
