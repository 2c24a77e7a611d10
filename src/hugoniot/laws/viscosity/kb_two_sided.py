r"""The quadratic artificial viscosity of the KB codes as printed, which also acts in expansion.

$$q = -C\,\rho\,|\Delta u|\,\Delta u$$

* $q$: viscous pressure, added to the pressure of the zone
* $\rho$: density; $\Delta u$: velocity difference across the zone, negative in compression
* $C$: `quadratic`, the coefficient; the formula has $C$, not $C^2$

In expansion $q < 0$. This tension converts motion into heat where the flow is smooth (K-E6), so releases are too warm and too slow.
Use this law only to reproduce results of the KB codes (Field Precision, 2000), whose threshold burn depends on it, and `kb` for anything
else.
"""

from typing import NamedTuple

from hugoniot.core.ops import fmax
from hugoniot.laws.viscosity.contract import VISCOSITY


class KBTwoSided(NamedTuple):
    quadratic: float = 1.0


def viscous_speed(v, c, p, du, psi, par):
    return par.quadratic * fmax(du, -du)


VISCOSITY.add(
    "kb_two_sided", KBTwoSided,
    functions=[viscous_speed],
    example=KBTwoSided(),
    units={"quadratic": "1"},
    meaning={"quadratic": "C, quadratic coefficient, usually near 1"},
    defaults={"quadratic": 1.0},
    box={"v": (5e-5, 1e3), "c": (1.0, 2e4), "p": (-1e10, 1e12), "du": (-1e4, 0.0), "psi": (0.0, 1.0)},
    least={"quadratic": 0.0},
    references=("KB codes manual (Field Precision, 2000), equation 1.8",),
    flags=("two_sided",),
)
