r"""Tensor viscosity in the four corners of a zone: each principal direction that closes is resisted with its own length.

In a corner with the edges $e_1$ (to the next corner) and $e_2$ (to the one before) the velocity gradient is that of the triangle they
span. Its symmetric part has the principal rates $\lambda_{1,2} = \bar d \mp R$ along $n_{1,2}$. The velocity jump along $n$ is
$\Delta u = \lambda\,\ell(n)$, with the length of the zone in that direction from its mean edges,
$\ell^2 = (n\cdot e_\xi)^2 + (n\cdot e_\eta)^2$, and

$$Q = \rho \sum_{\lambda_k < 0} |\Delta u_k|\,w(\Delta u_k, \psi_k)\; n_k \otimes n_k ,$$

with w the viscous speed of the law `limited`. In solids its linear coefficient is that of shocks where the zone shrinks, and a smaller one
where it flows at constant volume (`coefficients`). psi is the mean of the values for the two logical directions (`smoothness`), weighted by
their contributions to $\ell^2$ and to the square of the velocity gradient, so that a direction without any change has no weight.

The stress is a continuous function of the rates, and no result depends on round-off:

* Where the two rates are equal, as in flow that converges from all sides, the principal directions are undefined. Lengths and weights then
  change continuously to the mean of both, with the factor $\min(1, R/|\bar d|)$.
* A direction that opened at the start of the step is not in smooth flow: its psi is 0, as in one dimension. If it closed at less
  than `STEADY` of its present rate, psi falls in proportion.
* A jump that is weak relative to the sound speed or to the motion along the other direction counts for the time step only in proportion.

In a slender zone a small rotation of a principal direction turns the viscosity along the zone into shear stress across the short edges,
too stiff for an explicit step. If the longer mean edge is more than 4 times the height above it (in a zone that is slender or sheared
flat), the closing along the mean edges is increasingly resisted instead, completely from 8 times on: $Q = \sum q\,t\otimes t$ with the unit
edges t, which has no shear.

As a corner opens to a straight angle, the area of its triangle vanishes and its gradient would grow without bound. The gradient is
therefore taken over at least a quarter of the area of the zone. The force, its transpose, still opposes the motion, so that its work stays
positive, also in a re-entrant corner.

The force is the transpose of the corner's gradient: $+\tfrac14 Q (e_{2y}, -e_{2x})$ on the next corner, and so on. The mean of Q over the
zone is added to the stress, so that it conserves axial momentum; the rest acts with the weights of `layout.Shape`.

Campbell & Shashkov, J. Comput. Phys. 172 (2001) 739; Kolev & Rieben, J. Comput. Phys. 228 (2009) 8336.
"""

from typing import Any, NamedTuple

from hugoniot.core.binder import bind
from hugoniot.core.ops import fmax, fmin, vsqrt
from hugoniot.core.passes import law_of, rows_apart, zone_pass
from hugoniot.laws.viscosity.contract import viscous_speed
from hugoniot.solvers.lagrange2d.closing import STRETCH
from hugoniot.solvers.lagrange2d.coefficients import in_zone
from hugoniot.solvers.lagrange2d.jumps import SLIGHT, SMALL, both_at_middle, both_counted, both_kept
from hugoniot.solvers.lagrange2d.layout import Corners, Points, Rates, Smoothness, Tensor
from hugoniot.solvers.lagrange2d.quads import quad
from hugoniot.zones.viscosity import OWN

FLAT = 0.25             # part of a parallelogram's corner below which a triangle that shrinks, or is turned over, has no larger gradients
SLENDER, NEEDLE = 4.0, 8.0
LESS = 1.0 - 1e-15      # so that no length is the root of a negative number by round-off


class ResistOf(NamedTuple):
    """Nodes in the middle, strain rates, smoothness, state, density of the solid, stretches in which something closes (`closing`) -> mean
    viscous stress, corner forces of what the corners' stresses have beyond it, largest viscous speed, heat per volume and time."""

    low: Points
    high: Points
    rates: Rates
    smooth: Smoothness
    v: Any
    c: Any
    p: Any
    rho: Any
    closes: Any
    mean: Tensor
    g: Corners
    fastest: Any
    paid: Any


class Metric(NamedTuple):
    """Of a zone: mean edges along the second (xi) and the first (eta) logical direction as tensors e (x) e (m^2), each as half its trace,
    half the difference of its diagonal, and its shear; least doubled area of a corner's triangle."""

    xi: float
    xidev: float
    xixy: float
    eta: float
    etadev: float
    etaxy: float
    least: float


class Around(NamedTuple):
    """Of a zone: smoothness along both logical directions; strain rates at the start of the step (mean and half difference of the
    diagonal, shear); volume, sound speed, pressure, density of the solid; viscous stress of the previous step (mean and half difference of
    the diagonal, shear), and the velocity times length that a pascal of it gives (`zones.viscosity.at_middle`)."""

    xi: float
    eta: float
    share: float
    mean: float
    dev: float
    xy: float
    v: float
    c: float
    p: float
    rho: float
    q: float
    q_dev: float
    q_xy: float
    gives: float


def metric(ax, ay, bx, by, least):
    """`Metric` of the mean edges a along the first logical direction and b along the second."""
    axx, ayy, bxx, byy, half = ax * ax, ay * ay, bx * bx, by * by, 0.5 * LESS
    return Metric(0.5 * (bxx + byy), half * (bxx - byy), LESS * bx * by, 0.5 * (axx + ayy), half * (axx - ayy), LESS * ax * ay, least)


def metric_of(q):
    """`Metric` of a quadrilateral."""
    return metric(0.5 * (q.x1 - q.x0 + q.x2 - q.x3), 0.5 * (q.y1 - q.y0 + q.y2 - q.y3),
                  0.5 * (q.x3 - q.x0 + q.x2 - q.x1), 0.5 * (q.y3 - q.y0 + q.y2 - q.y1), FLAT * q.area)


def around(z, j, gives):
    """`Around` of zone j whose mean viscous stress is still that of the previous step; gives: m2 of `Around.gives` over the volume."""
    s, xx, yy, qxx, qyy, v = z.smooth, z.smooth.xx[j], z.smooth.yy[j], z.mean.xx[j], z.mean.yy[j], z.v[j]
    return Around(s.xi[j], s.eta[j], s.share[j], 0.5 * (xx + yy), 0.5 * (xx - yy), s.xy[j], v, z.c[j], z.p[j], z.rho[j],
                  0.5 * (qxx + qyy), 0.5 * (qxx - qyy), z.mean.xy[j], gives * v)


def along_edges(m, d, a, viscosity):
    """(viscous stress along the mean edges (xx, yy, xy), largest speed); d: strain rates (xx, yy, xy)."""
    mean, dev, xy = 0.5 * (d[0] + d[1]), 0.5 * (d[0] - d[1]), d[2]
    over1, over2 = 1.0 / m.xi, 1.0 / m.eta
    rate1, rate2 = mean + (dev * m.xidev + xy * m.xixy) * over1, mean + (dev * m.etadev + xy * m.etaxy) * over2
    before1, before2 = a.mean + (a.dev * m.xidev + a.xy * m.xixy) * over1, a.mean + (a.dev * m.etadev + a.xy * m.etaxy) * over2
    length1, length2 = vsqrt(2.0 * m.xi), vsqrt(2.0 * m.eta)
    du1, du2 = rate1 * length1, rate2 * length2
    size1, size2 = fmax(du1, -du1), fmax(du2, -du2)
    du1, du2 = fmin(du1, 0.0), fmin(du2, 0.0)
    psi1, psi2 = both_kept(a.xi, a.share, before1, fmin(rate1, 0.0), a.eta, 1.0 - a.share, before2, fmin(rate2, 0.0))
    w1, w2 = viscous_speed(a.v, a.c, a.p, du1, psi1, viscosity), viscous_speed(a.v, a.c, a.p, du2, psi2, viscosity)
    before1, before2 = a.q + (a.q_dev * m.xidev + a.q_xy * m.xixy) * over1, a.q + (a.q_dev * m.etadev + a.q_xy * m.etaxy) * over2
    du1, du2 = both_at_middle(du1, before1, w1, length1, du2, before2, w2, length2, a)
    q1, q2 = -0.5 * a.rho * du1 * w1 * over1, -0.5 * a.rho * du2 * w2 * over2
    half, dev = q1 * m.xi + q2 * m.eta, q1 * m.xidev + q2 * m.etadev
    return half + dev, half - dev, q1 * m.xixy + q2 * m.etaxy, both_counted(w1, du1, size2, w2, du2, size1, a.c)


def in_corner(e1x, e1y, e2x, e2y, u1, v1, u2, v2, m, a, viscosity):
    """(viscous stress over density (xx, yy, xy), largest speed, heat per mass and time) of the corner with the edges e1 to the next corner
    and e2 to the one before, along which the velocities differ by (u1, v1) and (u2, v2)."""
    area = fmax(e1x * e2y - e1y * e2x, m.least)
    gxx, gyy, shear = u1 * e2y - u2 * e1y, v2 * e1x - v1 * e2x, u2 * e1x - u1 * e2x + v1 * e2y - v2 * e1y
    # of twice the gradient times the area: its deviator and the larger of that and its trace; one division does for three
    total, dev, area = gxx + gyy, gxx - gyy, area + area
    size = vsqrt(dev * dev + shear * shear) + SMALL
    larger = fmax(size, fmax(total, -total))
    wide, both = larger * area, size * larger
    inverse = 1.0 / (size * wide)
    over, within, unit = wide * inverse, size * area * inverse, both * inverse
    mxx, mxy, pxx, pxy = dev * over, shear * over, dev * within, shear * within
    mean, size = total * unit, size * unit
    # tensors contracted with n1 (x) n1 and n2 (x) n2
    xim, etam = m.xidev * pxx + m.xixy * pxy, m.etadev * pxx + m.etaxy * pxy
    xi1, xi2, eta1, eta2 = m.xi - xim, m.xi + xim, m.eta - etam, m.eta + etam
    before = a.dev * mxx + a.xy * mxy
    length1, length2 = vsqrt(xi1 + eta1), vsqrt(xi2 + eta2)
    most, rate1, rate2 = fmax(mean, -mean) + size, fmin(mean - size, 0.0), fmin(mean + size, 0.0)
    psi1, psi2 = both_kept(xi1 * a.xi + eta1 * a.eta, xi1 * a.share + eta1 * (1.0 - a.share), a.mean - before, rate1,
                           xi2 * a.xi + eta2 * a.eta, xi2 * a.share + eta2 * (1.0 - a.share), a.mean + before, rate2)
    du1, du2 = rate1 * length1, rate2 * length2
    w1, w2 = viscous_speed(a.v, a.c, a.p, du1, psi1, viscosity), viscous_speed(a.v, a.c, a.p, du2, psi2, viscosity)
    before = a.q_dev * mxx + a.q_xy * mxy
    du1, du2 = both_at_middle(du1, a.q - before, w1, length1, du2, a.q + before, w2, length2, a)
    q1, q2 = -du1 * w1, -du2 * w2
    fast = both_counted(w1, du1, most * length2, w2, du2, most * length1, a.c)
    half, dev = 0.5 * (q1 + q2), 0.5 * (q2 - q1)
    return half + dev * mxx, half - dev * mxx, dev * mxy, fast, -(q1 * rate1 + q2 * rate2)


def corner_force(xx, yy, xy, e1x, e1y, e2x, e2y):
    """Planar force of a quarter of a corner's stress (compression positive) on the next corner (x, y) and on the one before (x, y)."""
    return xx * e2y - xy * e2x, xy * e2y - yy * e2x, xy * e1x - xx * e1y, yy * e1x - xy * e1y


def in_corners(z, j, a, viscous):
    """Write what the four corners of zone j, with `Around` a, resist."""
    low, high, viscosity = z.low, z.high, in_zone(viscous, z.rates, j)
    q = quad(low, high, j)
    m, rho = metric_of(q), z.rho[j]
    # edges from corner to corner, and the differences of velocity along them
    ax, ay, bx, by = q.x1 - q.x0, q.y1 - q.y0, q.x2 - q.x1, q.y2 - q.y1
    cx, cy, dx, dy = q.x3 - q.x2, q.y3 - q.y2, q.x0 - q.x3, q.y0 - q.y3
    au, av, bu, bv = high.u[j] - low.u[j], high.v[j] - low.v[j], high.u[j + 1] - high.u[j], high.v[j + 1] - high.v[j]
    cu, cv, du, dv = low.u[j + 1] - high.u[j + 1], low.v[j + 1] - high.v[j + 1], low.u[j] - low.u[j + 1], low.v[j] - low.v[j + 1]
    xx0, yy0, xy0, fast0, heat0 = in_corner(ax, ay, -dx, -dy, au, av, -du, -dv, m, a, viscosity)
    xx1, yy1, xy1, fast1, heat1 = in_corner(bx, by, -ax, -ay, bu, bv, -au, -av, m, a, viscosity)
    xx2, yy2, xy2, fast2, heat2 = in_corner(cx, cy, -bx, -by, cu, cv, -bu, -bv, m, a, viscosity)
    xx3, yy3, xy3, fast3, heat3 = in_corner(dx, dy, -cx, -cy, du, dv, -cu, -cv, m, a, viscosity)
    z.fastest[j] = fmax(fmax(fast0, fast1), fmax(fast2, fast3))
    # the mean, each corner with the area it stands for; one that points inward stands for none
    w0, w1, w2, w3 = fmax(q.t0, 0.0), fmax(q.t1, 0.0), fmax(q.area - q.t0, 0.0), fmax(q.area - q.t1, 0.0)
    inverse, quarter = 1.0 / (w0 + w1 + w2 + w3), 0.25 * rho
    xx = (w0 * xx0 + w1 * xx1 + w2 * xx2 + w3 * xx3) * inverse
    yy = (w0 * yy0 + w1 * yy1 + w2 * yy2 + w3 * yy3) * inverse
    xy = (w0 * xy0 + w1 * xy1 + w2 * xy2 + w3 * xy3) * inverse
    z.mean.xx[j], z.mean.yy[j], z.mean.xy[j] = rho * xx, rho * yy, rho * xy
    z.paid[j] = rho * (w0 * heat0 + w1 * heat1 + w2 * heat2 + w3 * heat3) * inverse
    n0x, n0y, p0x, p0y = corner_force(quarter * (xx0 - xx), quarter * (yy0 - yy), quarter * (xy0 - xy), ax, ay, -dx, -dy)
    n1x, n1y, p1x, p1y = corner_force(quarter * (xx1 - xx), quarter * (yy1 - yy), quarter * (xy1 - xy), bx, by, -ax, -ay)
    n2x, n2y, p2x, p2y = corner_force(quarter * (xx2 - xx), quarter * (yy2 - yy), quarter * (xy2 - xy), cx, cy, -bx, -by)
    n3x, n3y, p3x, p3y = corner_force(quarter * (xx3 - xx), quarter * (yy3 - yy), quarter * (xy3 - xy), dx, dy, -cx, -cy)
    z.g.f0x[j], z.g.f0y[j] = n3x + p1x - n0x - p0x, n3y + p1y - n0y - p0y
    z.g.f1x[j], z.g.f1y[j] = n0x + p2x - n1x - p1x, n0y + p2y - n1y - p1y
    z.g.f2x[j], z.g.f2y[j] = n1x + p3x - n2x - p2x, n1y + p3y - n2y - p2y
    z.g.f3x[j], z.g.f3y[j] = n2x + p0x - n3x - p3x, n2y + p0y - n3y - p3y


def slenderness(area, m):
    """Part of the viscous stress that is along the mean edges: 0 in zones that are not slender."""
    return fmax(0.0, fmin(1.0, (2.0 * fmax(m.xi, m.eta) / area - SLENDER) * (1.0 / (NEEDLE - SLENDER))))


def in_slender(z, j, a, viscous):
    """Put what is resisted along the mean edges of zone j in the place of what the corners resist, as far as it is slender."""
    q = quad(z.low, z.high, j)
    m, d, g = metric_of(q), (z.rates.xx[j], z.rates.yy[j], z.rates.xy[j]), z.g
    along = slenderness(q.area, m)
    rest = 1.0 - along
    xx, yy, xy, fast = along_edges(m, d, a, in_zone(viscous, z.rates, j))
    z.fastest[j] = fmax(z.fastest[j], fast * fmin(1.0, along * (1.0 / SLIGHT)))
    xx, yy, xy = xx * along, yy * along, xy * along
    z.mean.xx[j], z.mean.yy[j], z.mean.xy[j] = rest * z.mean.xx[j] + xx, rest * z.mean.yy[j] + yy, rest * z.mean.xy[j] + xy
    z.paid[j] = rest * z.paid[j] - (xx * d[0] + yy * d[1] + 2.0 * xy * d[2])
    g.f0x[j], g.f0y[j], g.f1x[j], g.f1y[j] = rest * g.f0x[j], rest * g.f0y[j], rest * g.f1x[j], rest * g.f1y[j]
    g.f2x[j], g.f2y[j], g.f3x[j], g.f3y[j] = rest * g.f2x[j], rest * g.f2y[j], rest * g.f3x[j], rest * g.f3y[j]


@zone_pass(ResistOf)
def resist(count, z, dt, numbers, law):
    """Viscous stress of the four corners of zones: its mean, and the planar forces of what each has beyond the mean.

    Stretches of zones in which nothing closes are skipped.
    """
    rows_apart()
    viscous, first = law_of(law, numbers), 0
    gives = OWN * dt
    while first < count:
        end, slender = min(first + STRETCH, count), 0.0
        if z.closes[first] > 0.0:
            for j in range(first, end):
                q = quad(z.low, z.high, j)
                slender = fmax(slender, slenderness(q.area, metric_of(q)))
            if slender > 0.0:
                for j in range(first, end):
                    a = around(z, j, gives)
                    in_corners(z, j, a, viscous)
                    in_slender(z, j, a, viscous)
            else:
                for j in range(first, end):
                    in_corners(z, j, around(z, j, gives), viscous)
        else:
            most = 0.0
            for j in range(first, end):
                xx, yy, xy = z.mean.xx[j], z.mean.yy[j], z.mean.xy[j]
                most = fmax(fmax(most, z.fastest[j]), fmax(fmax(xx, -xx), fmax(yy, -yy)) + fmax(xy, -xy))
                z.paid[j] = 0.0
            if most > 0.0:      # most often it is zero already: rows that are only read need not go back to memory
                for j in range(first, end):
                    z.mean.xx[j] = z.mean.yy[j] = z.mean.xy[j] = z.fastest[j] = 0.0
        first = end


for _function in (metric, metric_of, around, along_edges, in_corner, corner_force,
                  in_corners, slenderness, in_slender):
    bind(_function)
