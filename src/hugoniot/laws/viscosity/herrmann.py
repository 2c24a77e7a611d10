r"""Herrmann's artificial viscosity: linear and quadratic in the rate of compression.

$$q = \rho\left\{B_2\,\Delta x\,c\,\frac{\dot\rho}{\rho} + \left[B_1\,\Delta x\,\frac{\dot\rho}{\rho}\right]^2\right\}, \qquad
  \dot\rho > 0$$

* $q$: viscous pressure; it is added to the pressure of a zone under compression, and is zero in a zone that expands
* $\rho$: density; $\dot\rho$: its rate of change; $c$: longitudinal sound speed; $\Delta x$: width of the zone
* $B_1$, $B_2$: `quadratic`, `linear`

The velocity difference across the zone, with its sign reversed, takes the place of $\Delta x\,\dot\rho/\rho$; in planar flow the two are
equal. The law is therefore identical to `landshoff`. The report gives no values of $B_1$ and $B_2$, so the defaults are those of
`landshoff`.
"""

from typing import NamedTuple

from hugoniot.laws.viscosity.contract import VISCOSITY


class HerrmannViscosity(NamedTuple):
    quadratic: float = 1.4
    linear: float = 0.3


def viscous_speed(v, c, p, du, psi, par):
    return par.linear * c - par.quadratic * par.quadratic * du


VISCOSITY.add(
    "herrmann", HerrmannViscosity,
    functions=[viscous_speed],
    example=HerrmannViscosity(),
    units={"quadratic": "1", "linear": "1"},
    meaning={"quadratic": "B1, quadratic coefficient, which enters squared", "linear": "B2, linear coefficient"},
    defaults={"quadratic": 1.4, "linear": 0.3},
    box={"v": (5e-5, 1e3), "c": (1.0, 2e4), "p": (-1e10, 1e12), "du": (-1e4, 0.0), "psi": (0.0, 1.0)},
    least={"quadratic": 0.0, "linear": 0.0},
    references=("Herrmann, WL-TR-64-107 (1964), equation 4.3 and section A.2; B3 in B.53 is B1 (H-E7)",),
)
