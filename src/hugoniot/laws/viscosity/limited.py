r"""Kuropatenko's artificial viscosity with a monotonic limiter: the pressure jump of a shock, and zero in smooth flow.

$$q = (1 - \psi)\,\rho\,|\Delta u|\left(c_2 |\Delta u| + \sqrt{c_2^2\,\Delta u^2 + c_1^2\,c^2}\right)$$

* $q$: viscous pressure, added to the pressure of a zone in compression and zero in expansion
* $\rho$: density; $\Delta u$: velocity difference across the zone
* $\psi$: smoothness of the velocity field, computed by the solver: 1 where the velocity is linear, 0 at a shock or an extremum
* $c$: longitudinal sound speed
* $c_1$, $c_2$: `linear`, `quadratic`

**Quadratic coefficient.** With $c_2 = (\gamma + 1)/4$ and $c_1 = 1$ the factor in parentheses is the speed, relative to the gas ahead, of
an ideal-gas shock with the velocity jump $\Delta u$, and $q$ is its exact pressure jump. For a solid with $U_s = c_0 + s u_p$ the same
holds in strong shocks with $c_2 = s/2$. The default, 2/3, is the value for a monatomic gas and for $s = 1.33$, which is near that of most
metals. For a diatomic gas the value is 0.6. A larger value widens strong shocks without any gain.

**Linear coefficient.** $c_1 = 0.3$ keeps weak shocks in gases and elastic precursors thin; with 1 they would be smeared (W-E4). Behind
strong shocks in condensed material, however, only $q$ damps the oscillations, which would appear as an overshoot of a free surface. In
nonporous solids and liquids without strength the coefficient is therefore $c_c$, `linear_condensed`. With strength $c_1^2$ is replaced by

$$c_1^2 + (c_c^2 - c_1^2)\,\frac{\Delta u^4}{\Delta u^4 + (0.014\,c)^4} ,$$

which is near $c_1^2$ in a precursor and near $c_c^2$ in a plastic shock. If a deck gives only `linear`, its value applies to both.
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
    meaning={"quadratic": "c2, quadratic coefficient, (gamma + 1)/4 for an ideal gas",
             "linear": "c1, linear coefficient; 0 in explosives that burn by a schedule alone",
             "linear_condensed": "linear coefficient in nonporous solids and liquids (with strength: only in strong shocks)"},
    defaults={"quadratic": 2.0 / 3.0, "linear": 0.3, "linear_condensed": 1.0},
    box={"v": (5e-5, 1e3), "c": (1.0, 2e4), "p": (-1e10, 1e12), "du": (-1e4, 0.0), "psi": (0.0, 1.0)},
    least={"quadratic": 0.0, "linear": 0.0, "linear_condensed": 0.0},
    references=("Caramana, Shashkov & Whalen, J. Comput. Phys. 144 (1998) 70, equations 10 to 14", "Kuropatenko (1967)"),
    flags=("limited",),
)
