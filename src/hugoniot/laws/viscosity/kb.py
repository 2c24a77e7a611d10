r"""The quadratic artificial viscosity of the KB codes, acting only in compression.

$$q = C\,\rho\,(\Delta u)^2$$

* $q$: viscous pressure; it is added to the pressure of a zone under compression, and is zero in a zone that expands
* $\rho$: density; $\Delta u$: velocity difference across the zone
* $C$: `quadratic`, the coefficient; the formula has $C$, not $C^2$

The manual of the KB codes (Field Precision, 2000) prints $C\rho|\Delta u|(-\Delta u)$, which also acts in expansion (K-E6); the law
`kb_two_sided` has this form. The law `kb` has no linear term, so oscillations behind a shock decay slowly.
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
    meaning={"quadratic": "C, quadratic coefficient, usually near 1"},
    defaults={"quadratic": 1.0},
    box={"v": (5e-5, 1e3), "c": (1.0, 2e4), "p": (-1e10, 1e12), "du": (-1e4, 0.0), "psi": (0.0, 1.0)},
    least={"quadratic": 0.0},
    references=("KB codes manual (Field Precision, 2000), equation 1.8",),
)
