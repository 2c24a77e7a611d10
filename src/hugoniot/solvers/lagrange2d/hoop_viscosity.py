r"""Viscous hoop stress of the area-weighted scheme, which resists closing around the axis.

It follows the in-plane principal direction whose rate is closest to the hoop rate. In spherical flow
this is the tangential direction, so that both tangential directions are resisted alike, and the curvature terms of the viscous stress are
radial. In a shock that runs along the axis or towards it, it is the direction along the front, in which there is no viscosity.

With the deviations $q_d$ and $D_d$ of stress and rates from their means $\bar q$, $\bar d$, and $s = |D_d|$, the stress is
$\bar q + \beta |q_d|$, $\beta = 2 (q_d : D_d)(d_\theta - \bar d) / (s^2 |q_d|)$ between -1 and 1. Its sign does not depend on
which of the two rates is the larger, so that nothing is decided by round-off where they cross.
"""

from typing import Any, NamedTuple

from hugoniot.core.ops import fmax, fmin, vsqrt
from hugoniot.core.passes import rows_apart, zone_pass
from hugoniot.solvers.lagrange2d.layout import Corners, Rates, Stress

SMALL = 1e-60
LEAST_LIKE = 1e-20      # square of the difference of the rates beside their mean below which no direction is the one around the axis
WIDER = 0.1             # part of the rates by which the one around the axis may exceed those in the plane


class HoopOf(NamedTuple):
    """Strain rates, heat of the stress in the plane, its mean, forces of the rest -> its hoop part, cut where it does not pay."""

    d: Rates
    paid: Any
    mean: Stress
    g: Corners


@zone_pass(HoopOf)
def hoop_viscosity(count, given, dt, numbers, law):
    """Around the axis the viscous stress of the direction in the plane that closes most nearly as fast."""
    rows_apart()
    d, paid, q, g = given
    for j in range(count):
        mean, dev, xy, around = 0.5 * (d.xx[j] + d.yy[j]), 0.5 * (d.xx[j] - d.yy[j]), d.xy[j], d.hoop[j]
        half, part, qxy = 0.5 * (q.xx[j] + q.yy[j]), 0.5 * (q.xx[j] - q.yy[j]), q.xy[j]
        square, size = dev * dev + xy * xy, vsqrt(part * part + qxy * qxy)
        likeness = (part * dev + qxy * xy) * (around - mean) / ((square + LEAST_LIKE * mean * mean) * size + SMALL)
        found = half + size * fmax(-1.0, fmin(1.0, 2.0 * likeness))
        # where it opens: as long as the motion in the plane opens as fast, and no more than that motion pays for
        spread = vsqrt(square)
        scale = WIDER * (spread + fmax(mean, -mean)) + SMALL
        found *= fmax(0.0, fmin(1.0, (fmax(0.0, mean + spread) + 2.0 * scale - around) / scale))
        # more than that is no viscosity: what is left of the whole stress keeps its symmetry
        rest = fmax(0.0, fmin(1.0, paid[j] / fmax(found * around, SMALL)))
        q.xx[j] *= rest
        q.yy[j] *= rest
        q.xy[j] *= rest
        q.hoop[j] = found * rest
        g.f0x[j], g.f0y[j], g.f1x[j], g.f1y[j] = g.f0x[j] * rest, g.f0y[j] * rest, g.f1x[j] * rest, g.f1y[j] * rest
        g.f2x[j], g.f2y[j], g.f3x[j], g.f3y[j] = g.f2x[j] * rest, g.f2y[j] * rest, g.f3x[j] * rest, g.f3y[j] * rest
