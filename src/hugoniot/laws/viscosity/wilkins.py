r"""Wilkins' artificial viscosity: von Neumann-Richtmyer and Landshoff, with $\sqrt{P/\rho}$ in place of the sound speed.

$$q = C_0^2\,\rho\,(\Delta u)^2 + C_L\,\rho\,a\,|\Delta u|, \qquad a = \sqrt{P/\rho} \text{ for } P > 0, \text{ else } 0$$

* $q$: viscous pressure; it is added to the pressure of a zone under compression, and is zero in a zone that expands
* $\rho$: density; $\Delta u$: velocity difference across the zone
* $P$: pressure of the zone
* $C_0$, $C_L$: `quadratic`, `linear`

The defaults are Wilkins' values. The linear term vanishes at zero pressure and in tension, where $\sqrt{P/\rho}$ is zero or undefined
(W-E4).
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
    meaning={"quadratic": "C0, quadratic coefficient, which enters squared", "linear": "CL, linear coefficient"},
    defaults={"quadratic": 2.0, "linear": 1.0},
    box={"v": (5e-5, 1e3), "c": (1.0, 2e4), "p": (-1e10, 1e12), "du": (-1e4, 0.0), "psi": (0.0, 1.0)},
    least={"quadratic": 0.0, "linear": 0.0},
    references=("Wilkins, appendix B.2, item 7 (W-E3)",),
)
