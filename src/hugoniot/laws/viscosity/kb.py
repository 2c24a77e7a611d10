r"""The quadratic viscosity of the KB codes.

$$w = C\,\rho\,(\Delta V)^2 \quad\text{in compression}$$

The printed form C rho |dV| (-dV) is negative in expansion, where it would also resist the flow. Here it acts only in compression, like
all laws but `kb_two_sided` (K-E6). C is not squared. There is no linear term, so ripples behind a shock decay slowly.

Source: KB codes, equation 1.8.
"""

from typing import NamedTuple

from hugoniot.laws.viscosity.contract import VISCOSITY


class KB(NamedTuple):
    quadratic: float = 1.0


def viscous_speed(v, c, p, du, psi, par):
    return -par.quadratic * du


VISCOSITY.add(
    "kb", KB,
    functions=[viscous_speed],
    example=KB(),
    units={"quadratic": "1"},
    meaning={"quadratic": "C, near unity, not squared"},
    defaults={"quadratic": 1.0},
    box={"v": (5e-5, 1e3), "c": (1.0, 2e4), "p": (-1e10, 1e12), "du": (-1e4, 0.0), "psi": (0.0, 1.0)},
    least={"quadratic": 0.0},
    references=("KB codes, equation 1.8",),
)
