r"""Herrmann's viscosity, for comparison: a bulk pressure, and stress deviators along the coordinate axes.

$$q = \rho\,\ell\,\dot e\,(B_2 c + B_1^2\ell\,\dot e),\quad \ell = \sqrt A,\quad \dot e = \dot\rho/\rho > 0;\qquad
  {}^dq_{xx} = -\rho\,\bar x\,|d'_{xx}|\,(B_4 c + B_3^2\,\bar x\,|d'_{xx}|)\quad (d'_{xx} < 0)$$

and likewise for y, with the extent of the zone along each axis;

$${}^dq_{xy} = \rho\,\ell_s\,d_{xy}\,(B_4 c + B_3^2\,\ell_s\,|d_{xy}|),\quad \ell_s = \sqrt{\bar x\bar y}$$

acts for either sign of the shear, and ${}^dq_\theta = -({}^dq_{xx} + {}^dq_{yy})$. As printed, the quadratic shear term has a fixed sign
and drives shear of the opposite sign (H-E4). The report gives no coefficients. Here $B_3 = B_1$ and $B_4 = B_2$, and strong and weak shocks
are resisted as by the other viscosities: $B_1^2 = 2 c_2$, $B_2 = c_1$, with the coefficients of the deck.

The deviators are not frame invariant: the same rate of pure shear is resisted twice as strongly at 45 degrees to the axes as along them,
and a rotation of the frame changes the run. There is no limiter. Where the deviators are cut off, their work need not be positive.

Source: Herrmann, WL-TR-64-107, equations B.19 and B.20.
"""

from typing import Any, NamedTuple

from hugoniot.core.binder import bind
from hugoniot.core.ops import fmax, fmin, vsqrt
from hugoniot.core.passes import law_of, rows_apart, zone_pass
from hugoniot.laws.viscosity.contract import viscous_speed
from hugoniot.solvers.lagrange2d.jumps import counted
from hugoniot.solvers.lagrange2d.layout import Corners, Points, Rates, Stress
from hugoniot.solvers.lagrange2d.quads import quad


class HerrmannOf(NamedTuple):
    """Nodes in the middle, strain rates, state, density of the solid -> viscous stress, forces beyond it (none), largest speed."""

    low: Points
    high: Points
    d: Rates
    v: Any
    c: Any
    p: Any
    rho: Any
    mean: Stress
    g: Corners
    fastest: Any


def resisted(rate, length, v, c, p, viscosity):
    """(viscous stress over the density, speed) of a rate < 0 over a length."""
    du = fmin(rate, 0.0) * length
    w = viscous_speed(v, c, p, du, 0.0, viscosity)
    return -du * w, counted(w, du, 0.0, c)


@zone_pass(HerrmannOf)
def resist_along_axes(count, z, dt, numbers, law):
    """Bulk viscosity and viscous deviators along the axes."""
    rows_apart()
    viscosity, d = law_of(law, numbers), z.d
    for j in range(count):
        q = quad(z.low, z.high, j)
        v, c, p, rho, third = z.v[j], z.c[j], z.p[j], z.rho[j], d.dilation[j] * (1.0 / 3.0)
        wide = fmax(fmax(q.x0, q.x1), fmax(q.x2, q.x3)) - fmin(fmin(q.x0, q.x1), fmin(q.x2, q.x3))
        tall = fmax(fmax(q.y0, q.y1), fmax(q.y2, q.y3)) - fmin(fmin(q.y0, q.y1), fmin(q.y2, q.y3))
        bulk, fast = resisted(d.dilation[j], vsqrt(q.area), v, c, p, viscosity)
        xx, fast_x = resisted(d.xx[j] - third, wide, v, c, p, viscosity)
        yy, fast_y = resisted(d.yy[j] - third, tall, v, c, p, viscosity)
        shear = d.xy[j]
        across, fast_xy = resisted(-fmax(shear, -shear), vsqrt(wide * tall), v, c, p, viscosity)
        z.mean.xx[j], z.mean.yy[j], z.mean.hoop[j] = rho * (bulk + xx), rho * (bulk + yy), rho * (bulk - xx - yy)
        z.mean.xy[j] = -rho * across if shear > 0.0 else rho * across
        z.fastest[j] = fast + fmax(fmax(fast_x, fast_y), fast_xy)
        g = z.g
        g.f0x[j], g.f0y[j], g.f1x[j], g.f1y[j], g.f2x[j], g.f2y[j], g.f3x[j], g.f3y[j] = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0


bind(resisted)
