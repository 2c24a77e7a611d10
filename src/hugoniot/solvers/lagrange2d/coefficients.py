r"""Coefficients of the artificial viscosity of a zone: those of a shock where it is compressed, a smaller linear one where it flows.

A shock in a solid needs as large a linear part as one in one dimension, or it rings, but the sustained plastic flow behind it would be
resisted as well. A shock compresses, plastic flow does not. With $\lambda_1$ the rate of the fastest closing the linear coefficient is

$$c = c_s + (c_l - c_s) \min\left(1, \max\left(0, \frac{\dot V/V}{\lambda_1}\right)\right)^2 ,$$

with the coefficient $c_l$ of a weak or of a strong shock (`laws.viscosity.limited`) in the material.
"""

from typing import NamedTuple

from hugoniot.core.binder import bind
from hugoniot.core.ops import fmax, fmin, vsqrt
from hugoniot.laws.viscosity.limited import Limited

SMALL = 1e-60


class Viscous(NamedTuple):
    """Coefficients of the viscosity of a material: those of the law `limited`, linear ones where it shrinks; linear one where it flows at
    constant volume."""

    quadratic: float
    linear: float
    linear_condensed: float
    shear: float


def in_zone(viscous, rates, j):
    """The law of the viscous speed in zone j.

    The part of its fastest closing with which it shrinks is 1 in a plane shock, 1 - 2 nu in an elastic bar and 0 in plastic flow; squared.
    """
    xx, yy, xy = rates.xx[j], rates.yy[j], rates.xy[j]
    dev = 0.5 * (xx - yy)
    closing = 0.5 * (xx + yy) - vsqrt(dev * dev + xy * xy)
    part = fmax(0.0, fmin(1.0, rates.dilation[j] / fmin(closing, -SMALL)))
    part *= part
    return Limited(viscous.quadratic, viscous.shear + part * (viscous.linear - viscous.shear),
                   viscous.shear + part * (viscous.linear_condensed - viscous.shear))


bind(in_zone)
