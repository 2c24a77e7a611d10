r"""Artificial viscosity of von Neumann-Richtmyer and Landshoff, with the longitudinal sound speed.

$$q = C_0^2\,\rho\,(\Delta u)^2 + C_L\,\rho\,c\,|\Delta u|$$

* $q$: viscous pressure; it is added to the pressure of a zone under compression, and is zero in a zone that expands
* $\rho$: density; $\Delta u$: velocity difference across the zone
* $c$: longitudinal sound speed
* $C_0$, $C_L$: coefficients `quadratic` and `linear`

The quadratic term spreads strong shocks over a few zones; the linear term damps the oscillations behind them. Wilkins takes
$\sqrt{P/\rho}$ for $c$ and $C_L = 1$ (law `wilkins`); with the longitudinal sound speed $C_L = 1$ would give far too much viscosity (W-E4).
"""

from typing import NamedTuple

from hugoniot.laws.viscosity.contract import VISCOSITY


class Landshoff(NamedTuple):
    quadratic: float = 1.4
    linear: float = 0.3


def viscous_speed(v, c, p, du, psi, par):
    return par.linear * c - par.quadratic * par.quadratic * du


VISCOSITY.add(
    "landshoff", Landshoff,
    functions=[viscous_speed],
    example=Landshoff(),
    units={"quadratic": "1", "linear": "1"},
    meaning={"quadratic": "C0, quadratic coefficient, which enters squared", "linear": "CL, linear coefficient"},
    defaults={"quadratic": 1.4, "linear": 0.3},
    box={"v": (5e-5, 1e3), "c": (1.0, 2e4), "p": (-1e10, 1e12), "du": (-1e4, 0.0), "psi": (0.0, 1.0)},
    least={"quadratic": 0.0, "linear": 0.0},
    references=("von Neumann & Richtmyer, J. Appl. Phys. 21 (1950) 232", "Landshoff, LA-1930 (1955)",
                "Wilkins, appendix B.2, item 7"),
)
