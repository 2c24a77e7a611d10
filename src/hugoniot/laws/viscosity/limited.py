r"""Kuropatenko's artificial viscosity with a monotonic limiter: equal to the pressure jump in a shock, zero in smooth flow.

$$q = (1 - \psi)\,\rho\,|\Delta u|\left(c_2 |\Delta u| + \sqrt{c_2^2\,\Delta u^2 + c_1^2\,c^2}\right)$$

* $q$: viscous pressure; it is added to the pressure of a zone under compression, and is zero in a zone that expands
* $\rho$: density; $\Delta u$: velocity difference across the zone
* $\psi$: smoothness of the velocity field, computed by the solver: 1 where the velocity is linear, 0 at a shock or an extremum
* $c$: longitudinal sound speed
* $c_1$: `linear`; $c_2$: `quadratic`; $c_c$: `linear_condensed`, which takes the place of $c_1$ in some materials (see below)

**Quadratic coefficient.** Let $\psi = 0$, $c_1 = 1$ and $c_2 = (\gamma + 1)/4$. The expression in the large parentheses is then the speed,
relative to the gas ahead, of a shock in an ideal gas with the velocity jump $\Delta u$, and $q$ is the exact pressure jump of this shock.
For a solid with $U_s = c_0 + s u_p$ the same holds in strong shocks with $c_2 = s/2$. The default, 2/3, is the value for a monatomic gas
and for $s = 1.33$, which is near that of most metals. For a diatomic gas the value is 0.6. A larger value widens strong shocks without
any gain.

**Linear coefficient.** With $c_1 = 0.3$ weak shocks in gases and elastic precursors extend over only a few zones; with $c_1 = 1$ they would
be smeared (W-E4). In solids and liquids, however, $c_1 = 0.3$ damps the oscillations behind a strong shock too little, and the velocity of
a free surface overshoots. The coefficient therefore depends on the material:

* gases: $c_1$
* nonporous solids and liquids without strength: $c_c$ in place of $c_1$
* nonporous solids with strength, and porous materials whose pores stay crushed: the following expression in place of $c_1^2$, which is
  near $c_1^2$ in a precursor and near $c_c^2$ in a plastic or crushing shock:

$$c_1^2 + (c_c^2 - c_1^2)\,\frac{\Delta u^4}{\Delta u^4 + (0.014\,c)^4}$$

If a deck gives `linear` but not `linear_condensed`, $c_c$ has the value of $c_1$. In an explosive that burns by the law `programmed` with
the mixture `burned_products`, the linear term is zero. Explosives that burn have $c_1$, whatever their
stiffness. If the deck names no viscosity, a run in which something burns has $c_2 = 1$.
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
             "linear": "c1, linear coefficient in gases and, in materials with strength or pores, in weak shocks",
             "linear_condensed": "linear coefficient in solids and liquids; with strength or pores only in strong shocks"},
    defaults={"quadratic": 2.0 / 3.0, "linear": 0.3, "linear_condensed": 1.0},
    box={"v": (5e-5, 1e3), "c": (1.0, 2e4), "p": (-1e10, 1e12), "du": (-1e4, 0.0), "psi": (0.0, 1.0)},
    least={"quadratic": 0.0, "linear": 0.0, "linear_condensed": 0.0},
    references=("Caramana, Shashkov & Whalen, J. Comput. Phys. 144 (1998) 70, equations 10 to 14", "Kuropatenko (1967)"),
    flags=("limited",),
)
