r"""The quadratic viscosity of the KB codes as printed: it also resists expansion.

$$w = -C\,\rho\,|\Delta V|\,\Delta V$$

In expansion w < 0, a tension that converts motion into heat where the flow is smooth (K-E6), so that releases are too warm and too slow.
The KB codes use this form, and the speed of their threshold burn depends on it. Use `kb` for anything else.

Source: KB codes, equation 1.8, without a compression switch.
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
    meaning={"quadratic": "C, near unity, not squared"},
    defaults={"quadratic": 1.0},
    box={"v": (5e-5, 1e3), "c": (1.0, 2e4), "p": (-1e10, 1e12), "du": (-1e4, 0.0), "psi": (0.0, 1.0)},
    least={"quadratic": 0.0},
    references=("KB codes, equation 1.8",),
    flags=("two_sided",),
)
