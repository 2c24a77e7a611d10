r"""Viscosity of von Neumann-Richtmyer and Landshoff as printed by Wilkins: sqrt(P/rho) in the linear term, not the sound speed.

$$q = C_0^2\,\rho\,(\Delta u)^2 + C_L\,\rho\,a\,|\Delta u|, \qquad a = \sqrt{P/\rho} \text{ for } P > 0, \text{ else } 0$$

sqrt(P/rho) vanishes at rest and is imaginary in tension, hence a = 0 there (W-E4). B.1 item 8
prints the velocity gradient without absolute value; B.2 item 7, used here, is correct (W-E3). C0 enters squared.

Source: Wilkins, appendix B.2 item 7, with C0 = 2, CL = 1.
"""

from typing import NamedTuple

from hugoniot.core.ops import fmax, vsqrt
from hugoniot.laws.viscosity.contract import VISCOSITY


class Wilkins(NamedTuple):
    quadratic: float = 2.0
    linear: float = 1.0


def viscous_speed(v, c, p, du, psi, par):
    return par.linear * vsqrt(fmax(p, 0.0) * v) - par.quadratic * par.quadratic * du


VISCOSITY.add(
    "wilkins", Wilkins,
    functions=[viscous_speed],
    example=Wilkins(),
    units={"quadratic": "1", "linear": "1"},
    meaning={"quadratic": "C0, which enters squared", "linear": "CL of the term with sqrt(P/rho)"},
    defaults={"quadratic": 2.0, "linear": 1.0},
    box={"v": (5e-5, 1e3), "c": (1.0, 2e4), "p": (-1e10, 1e12), "du": (-1e4, 0.0), "psi": (0.0, 1.0)},
    least={"quadratic": 0.0, "linear": 0.0},
    references=("Wilkins, appendix B.2 item 7",),
)
