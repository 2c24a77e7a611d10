r"""Herrmann's artificial viscosity: quadratic and linear in the rate of compression, coefficients proportional to the mesh size.

$$q = \rho\left\{B_2\,\Delta x\,c\,\frac{\dot\rho}{\rho} + \left[B_1\,\Delta x\,\frac{\dot\rho}{\rho}\right]^2\right\}, \qquad
  \dot\rho > 0$$

The velocity difference across the zone is used for $-\Delta x\,\dot\rho/\rho$, to which it is equal in planar flow. The report gives
no values of B1 and B2; the defaults are those of the `landshoff` law, to which the planar form is identical.

Source: Herrmann WL-TR-64-107, equation 4.3 and section A.2 (B1 enters squared; B.53's B3 is B1, H-E7).
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
    meaning={"quadratic": "B1, which enters squared", "linear": "B2"},
    defaults={"quadratic": 1.4, "linear": 0.3},
    box={"v": (5e-5, 1e3), "c": (1.0, 2e4), "p": (-1e10, 1e12), "du": (-1e4, 0.0), "psi": (0.0, 1.0)},
    least={"quadratic": 0.0, "linear": 0.0},
    references=("Herrmann, WL-TR-64-107, equation 4.3 and section A.2",),
)
