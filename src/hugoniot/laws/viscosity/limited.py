r"""Kuropatenko's viscosity with a monotonic limiter: the pressure jump of a shock, and zero in smooth flow.

$$q = (1 - \psi)\,\rho\,|\Delta u|\left(c_2 |\Delta u| + \sqrt{c_2^2\,\Delta u^2 + c_1^2\,c^2}\right)$$

With $c_2 = (\gamma + 1)/4$ and $c_1 = 1$ the bracket is the speed of an ideal-gas shock with velocity jump du relative to the gas ahead,
and q is the exact pressure jump. For a solid with $U_s = c_0 + s u_p$ the same holds with $c_2 \approx s/2$. The default, 2/3, is the value
for a monatomic gas and for most metals (s = 1.3); diatomic gases have 0.6. A larger value widens strong shocks without any gain. $c_1 =
0.3$ instead of 1 keeps weak shocks in gases and elastic precursors thin (W-E4). In condensed material only q damps the ringing behind
strong shocks, which would appear as an overshoot of a free surface. With strength, the square of the linear coefficient therefore grows
from $c_1$ = `linear` in the jumps of a precursor to $c_c$ = `linear_condensed` in a plastic shock,

$$c_1^2 + (c_c^2 - c_1^2)\,\frac{\Delta u^4}{\Delta u^4 + (0.014\,c)^4} \quad\text{in place of}\quad c_1^2,$$

and without strength the coefficient is $c_c$ throughout. If a deck gives only `linear`, its value applies to both.
psi is the smoothness of the velocity field from the solver: 1 where the velocity is linear, 0 at a shock or an extremum.

Source: Kuropatenko (1967); Caramana, Shashkov & Whalen, J. Comput. Phys. 144 (1998) 70, equations 10 to 14.
"""

from typing import NamedTuple

from hugoniot.core.ops import vsqrt
from hugoniot.laws.viscosity.contract import VISCOSITY

PRECURSOR = 0.014     # |du| / c of a zone: a precursor has less, a plastic shock more
SMALL = 1e-30


class Limited(NamedTuple):
    quadratic: float = 2.0 / 3.0
    linear: float = 0.3
    linear_condensed: float = 1.0


def viscous_speed(v, c, p, du, psi, par):
    strong = par.quadratic * du
    weak = par.linear * c
    more = par.linear_condensed * par.linear_condensed - par.linear * par.linear
    jump, precursor = du * du, PRECURSOR * PRECURSOR * c * c
    share = jump * jump / (jump * jump + precursor * precursor + SMALL)
    return (1.0 - psi) * (vsqrt(strong * strong + weak * weak + more * share * c * c) - strong)


VISCOSITY.add(
    "limited", Limited,
    functions=[viscous_speed],
    example=Limited(),
    units={"quadratic": "1", "linear": "1", "linear_condensed": "1"},
    meaning={"quadratic": "c2, (gamma + 1)/4 for an ideal gas",
             "linear": "c1, weight of the sound speed; 0 in explosives whose burn is programmed alone",
             "linear_condensed": "c1 in nonporous solids and liquids (with strength: only in strong jumps); default: `linear` if given"},
    defaults={"quadratic": 2.0 / 3.0, "linear": 0.3, "linear_condensed": 1.0},
    box={"v": (5e-5, 1e3), "c": (1.0, 2e4), "p": (-1e10, 1e12), "du": (-1e4, 0.0), "psi": (0.0, 1.0)},
    least={"quadratic": 0.0, "linear": 0.0, "linear_condensed": 0.0},
    references=("Caramana, Shashkov & Whalen, J. Comput. Phys. 144 (1998) 70", "Kuropatenko (1967)"),
    flags=("limited",),
)
