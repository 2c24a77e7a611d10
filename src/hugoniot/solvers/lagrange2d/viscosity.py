r"""Tensor viscosity in the four corners of a zone: each principal direction of closing resisted with its own length.

In a corner with the edges $e_1$ (to the next corner) and $e_2$ (to the one before) the velocity gradient is that of the triangle they
span. Its symmetric part has the principal rates $\lambda_{1,2} = \bar d \mp R$ along $n_{1,2}$. The velocity jump along $n$ is
$\Delta u = \lambda\,\ell(n)$, with the length of the zone in that direction from its mean edges,
$\ell^2 = (n\cdot e_\xi)^2 + (n\cdot e_\eta)^2$, and

$$Q = \rho \sum_{\lambda_k < 0} |\Delta u_k|\,w(\Delta u_k, \psi_k)\; n_k \otimes n_k ,$$

w the viscous speed of the viscosity's law. psi is the mean of those of the two logical directions (`smoothness`), weighted by their parts
of $\ell^2$ and of the square of the velocity gradient, so that a direction along which nothing changes has no say.

The stress is a continuous function of the rates, and nothing is decided by round-off:

* Where the two rates are equal, as in flow that converges from all sides, the directions are anyone's. Lengths and weights turn
  continuously into the mean of both, with the factor $\min(1, R/|\bar d|)$.
* A direction that opened at the start of the step is no smooth flow: its psi is 0, as in one dimension. Between, where it closed at less
  than `STEADY` of the rate now, psi falls in proportion.
* A jump counts for the time step in proportion, where it is faint beside the sound speed or the motion along the other direction.

A principal direction that turns a little in a slender zone makes shear stress of the long direction's viscosity across the short edges,
which an explicit step does not bear. Where the longer mean edge is 4 times the height above it, wholly from 8 times on, be the zone
slender or sheared flat, the closing along the mean edges themselves is
resisted instead, $Q = \sum q\,t\otimes t$ with the unit edges t, which has no shear.

The triangle of a corner that opens to a straight angle vanishes, and its gradient would grow beyond all bounds. The gradient is taken over
a quarter of the zone's area at least: the force still opposes the very motion it is transposed from, so that its work stays positive,
even where a corner points inward.

The force is the transpose of the corner's gradient: $+\tfrac14 Q (e_{2y}, -e_{2x})$ on the next corner, and so on. The mean of Q over the
zone goes with the stress, so that it keeps axial momentum; what the corners have besides acts with the weights of `layout.Shape`.

Campbell & Shashkov, J. Comput. Phys. 172 (2001) 739; Kolev & Rieben, J. Comput. Phys. 228 (2009) 8336.
"""

from typing import Any, NamedTuple

from hugoniot.core.binder import bind
from hugoniot.core.ops import fmax, fmin, vsqrt
from hugoniot.core.passes import law_of, rows_apart, zone_pass
from hugoniot.laws.viscosity.contract import viscous_speed
from hugoniot.solvers.lagrange2d.layout import Corners, Points, Smoothness, Tensor
from hugoniot.solvers.lagrange2d.quads import quad

SMALL = 1e-60
FLAT = 0.25             # part of a parallelogram's corner below which a triangle that shrinks, or is turned over, has no larger gradients
SLIGHT, FAINT = 1e-4, 1e-6    # parts of the other jump and of the sound speed below which a jump limits the time step in proportion
STEADY = 1e-3           # part of the rate now below which one at the start of the step keeps the limiter in proportion
SLENDER, NEEDLE = 4.0, 8.0


class ResistOf(NamedTuple):
    """Nodes in the middle, strain rates, smoothness, state, density of the solid -> mean viscous stress, corner forces of what the
    corners' stresses have beyond it, largest viscous speed, heat per volume and time."""

    low: Points
    high: Points
    rates: Tensor
    smooth: Smoothness
    v: Any
    c: Any
    p: Any
    rho: Any
    mean: Tensor
    g: Corners
    fastest: Any
    paid: Any


class Metric(NamedTuple):
    """Of a zone: mean edges along the second (xi) and the first (eta) logical direction as tensors e (x) e (m^2), least doubled area of a
    corner's triangle."""

    xixx: float
    xiyy: float
    xixy: float
    etaxx: float
    etayy: float
    etaxy: float
    least: float


class Around(NamedTuple):
    """Of a zone: smoothness along both logical directions and strain rates at the start of the step; volume, sound speed, pressure,
    density of the solid."""

    xi: float
    eta: float
    share: float
    xx: float
    yy: float
    xy: float
    v: float
    c: float
    p: float
    rho: float


def metric_of(q):
    """`Metric` of a quadrilateral."""
    ax, ay = 0.5 * (q.x1 - q.x0 + q.x2 - q.x3), 0.5 * (q.y1 - q.y0 + q.y2 - q.y3)
    bx, by = 0.5 * (q.x3 - q.x0 + q.x2 - q.x1), 0.5 * (q.y3 - q.y0 + q.y2 - q.y1)
    return Metric(bx * bx, by * by, bx * by, ax * ax, ay * ay, ax * ay, FLAT * q.area)


def kept(psi, before, now):
    """Smoothness along a direction that closes at the rate `now`: psi if it closed at the start of the step too, 0 if it opened."""
    return psi * fmax(0.0, fmin(1.0, before / (STEADY * now - SMALL)))


def counted(w, du, other, c):
    """What a jump du <= 0 with the viscous speed w asks of the time step, beside the size `other` of that of the other direction."""
    return w * fmin(1.0, -du / (SLIGHT * other + FAINT * c + SMALL))


def along_edges(m, d, a, area, viscosity):
    """(viscous stress along the mean edges (xx, yy, xy), largest speed, part of the corners' own stress, 1 in zones that are not slender).

    d: strain rates (xx, yy, xy).
    """
    xx, yy, xy = d
    xi, eta = m.xixx + m.xiyy, m.etaxx + m.etayy
    rate1 = (xx * m.xixx + yy * m.xiyy + 2.0 * xy * m.xixy) / xi
    rate2 = (xx * m.etaxx + yy * m.etayy + 2.0 * xy * m.etaxy) / eta
    before1 = a.xx * m.xixx + a.yy * m.xiyy + 2.0 * a.xy * m.xixy
    before2 = a.xx * m.etaxx + a.yy * m.etayy + 2.0 * a.xy * m.etaxy
    before1, before2 = before1 / xi, before2 / eta
    du1, du2 = rate1 * vsqrt(xi), rate2 * vsqrt(eta)
    size1, size2 = fmax(du1, -du1), fmax(du2, -du2)
    du1, du2 = fmin(du1, 0.0), fmin(du2, 0.0)
    w1 = viscous_speed(a.v, a.c, a.p, du1, kept(a.xi / fmax(a.share, SMALL), before1, fmin(rate1, 0.0)), viscosity)
    w2 = viscous_speed(a.v, a.c, a.p, du2, kept(a.eta / fmax(1.0 - a.share, SMALL), before2, fmin(rate2, 0.0)), viscosity)
    q1, q2 = -a.rho * du1 * w1 / xi, -a.rho * du2 * w2 / eta
    fast = fmax(counted(w1, du1, size2, a.c), counted(w2, du2, size1, a.c))
    part = fmax(0.0, fmin(1.0, (NEEDLE - fmax(xi, eta) / area) * (1.0 / (NEEDLE - SLENDER))))
    return q1 * m.xixx + q2 * m.etaxx, q1 * m.xiyy + q2 * m.etayy, q1 * m.xixy + q2 * m.etaxy, fast, part


def in_corner(e1x, e1y, e2x, e2y, u1, v1, u2, v2, m, a, viscosity):
    """(viscous stress (xx, yy, xy), largest speed, heat per volume and time) of the corner with the edges e1 to the next corner
    and e2 to the one before, along which the velocities differ by (u1, v1) and (u2, v2)."""
    inverse = 1.0 / fmax(e1x * e2y - e1y * e2x, m.least)
    dxx, dyy = (u1 * e2y - u2 * e1y) * inverse, (v2 * e1x - v1 * e2x) * inverse
    dxy = 0.5 * (u2 * e1x - u1 * e2x + v1 * e2y - v2 * e1y) * inverse
    mean, dev = 0.5 * (dxx + dyy), 0.5 * (dxx - dyy)
    size = vsqrt(dev * dev + dxy * dxy)
    over = 1.0 / (size + SMALL)
    mxx, mxy = dev * over, dxy * over
    half = 0.5 * fmin(1.0, size / (fmax(mean, -mean) + SMALL))
    # tensors contracted with n1 (x) n1 and n2 (x) n2
    xi, eta = 0.5 * (m.xixx + m.xiyy), 0.5 * (m.etaxx + m.etayy)
    xim = half * ((m.xixx - m.xiyy) * mxx + 2.0 * m.xixy * mxy)
    etam = half * ((m.etaxx - m.etayy) * mxx + 2.0 * m.etaxy * mxy)
    square1, square2 = xi - xim + eta - etam, xi + xim + eta + etam
    before_mean, before_dev = 0.5 * (a.xx + a.yy), 0.5 * (a.xx - a.yy) * mxx + a.xy * mxy
    length1, length2 = vsqrt(square1), vsqrt(square2)
    most = fmax(mean, -mean) + size
    rate1, rate2 = fmin(mean - size, 0.0), fmin(mean + size, 0.0)
    left = 1.0 - a.share
    psi1 = ((xi - xim) * a.xi + (eta - etam) * a.eta) / fmax((xi - xim) * a.share + (eta - etam) * left, SMALL)
    psi2 = ((xi + xim) * a.xi + (eta + etam) * a.eta) / fmax((xi + xim) * a.share + (eta + etam) * left, SMALL)
    psi1, psi2 = kept(psi1, before_mean - before_dev, rate1), kept(psi2, before_mean + before_dev, rate2)
    du1, du2 = rate1 * length1, rate2 * length2
    w1, w2 = viscous_speed(a.v, a.c, a.p, du1, psi1, viscosity), viscous_speed(a.v, a.c, a.p, du2, psi2, viscosity)
    q1, q2 = -a.rho * du1 * w1, -a.rho * du2 * w2
    fast = fmax(counted(w1, du1, most * length2, a.c), counted(w2, du2, most * length1, a.c))
    half, dev = 0.5 * (q1 + q2), 0.5 * (q2 - q1)
    return half + dev * mxx, half - dev * mxx, dev * mxy, fast, -(q1 * rate1 + q2 * rate2)


def corner_force(xx, yy, xy, e1x, e1y, e2x, e2y):
    """Planar force of a corner's stress (compression positive) on the next corner (x, y) and on the one before (x, y)."""
    xx, yy, xy = 0.25 * xx, 0.25 * yy, 0.25 * xy
    return xx * e2y - xy * e2x, xy * e2y - yy * e2x, xy * e1x - xx * e1y, yy * e1x - xy * e1y


@zone_pass(ResistOf)
def resist(count, z, dt, numbers, law):
    """Viscous stress of the four corners of zones: its mean, and the planar forces of what each has beyond the mean."""
    rows_apart()
    viscosity, low, high, smooth = law_of(law, numbers), z.low, z.high, z.smooth
    for j in range(count):
        q = quad(low, high, j)
        m, d = metric_of(q), (z.rates.xx[j], z.rates.yy[j], z.rates.xy[j])
        a = Around(smooth.xi[j], smooth.eta[j], smooth.share[j], smooth.xx[j], smooth.yy[j], smooth.xy[j], z.v[j], z.c[j], z.p[j], z.rho[j])
        lxx, lyy, lxy, fast, part = along_edges(m, d, a, q.area, viscosity)
        rest = 1.0 - part
        lxx, lyy, lxy = lxx * rest, lyy * rest, lxy * rest
        # edges from corner to corner, and the differences of velocity along them
        ax, ay, bx, by = q.x1 - q.x0, q.y1 - q.y0, q.x2 - q.x1, q.y2 - q.y1
        cx, cy, dx, dy = q.x3 - q.x2, q.y3 - q.y2, q.x0 - q.x3, q.y0 - q.y3
        au, av, bu, bv = high.u[j] - low.u[j], high.v[j] - low.v[j], high.u[j + 1] - high.u[j], high.v[j + 1] - high.v[j]
        cu, cv, du, dv = low.u[j + 1] - high.u[j + 1], low.v[j + 1] - high.v[j + 1], low.u[j] - low.u[j + 1], low.v[j] - low.v[j + 1]
        xx0, yy0, xy0, fast0, heat0 = in_corner(ax, ay, -dx, -dy, au, av, -du, -dv, m, a, viscosity)
        xx1, yy1, xy1, fast1, heat1 = in_corner(bx, by, -ax, -ay, bu, bv, -au, -av, m, a, viscosity)
        xx2, yy2, xy2, fast2, heat2 = in_corner(cx, cy, -bx, -by, cu, cv, -bu, -bv, m, a, viscosity)
        xx3, yy3, xy3, fast3, heat3 = in_corner(dx, dy, -cx, -cy, du, dv, -cu, -cv, m, a, viscosity)
        z.fastest[j] = fmax(fast, fmax(fmax(fast0, fast1), fmax(fast2, fast3)))
        # the mean, each corner with the area it stands for; one that points inward stands for none
        w0, w1, w2, w3 = fmax(q.t0, 0.0), fmax(q.t1, 0.0), fmax(q.area - q.t0, 0.0), fmax(q.area - q.t1, 0.0)
        inverse = 1.0 / (w0 + w1 + w2 + w3)
        xx = (w0 * xx0 + w1 * xx1 + w2 * xx2 + w3 * xx3) * inverse
        yy = (w0 * yy0 + w1 * yy1 + w2 * yy2 + w3 * yy3) * inverse
        xy = (w0 * xy0 + w1 * xy1 + w2 * xy2 + w3 * xy3) * inverse
        z.mean.xx[j], z.mean.yy[j], z.mean.xy[j] = part * xx + lxx, part * yy + lyy, part * xy + lxy
        z.paid[j] = part * (w0 * heat0 + w1 * heat1 + w2 * heat2 + w3 * heat3) * inverse - (lxx * d[0] + lyy * d[1] + 2.0 * lxy * d[2])
        n0x, n0y, p0x, p0y = corner_force(part * (xx0 - xx), part * (yy0 - yy), part * (xy0 - xy), ax, ay, -dx, -dy)
        n1x, n1y, p1x, p1y = corner_force(part * (xx1 - xx), part * (yy1 - yy), part * (xy1 - xy), bx, by, -ax, -ay)
        n2x, n2y, p2x, p2y = corner_force(part * (xx2 - xx), part * (yy2 - yy), part * (xy2 - xy), cx, cy, -bx, -by)
        n3x, n3y, p3x, p3y = corner_force(part * (xx3 - xx), part * (yy3 - yy), part * (xy3 - xy), dx, dy, -cx, -cy)
        z.g.f0x[j], z.g.f0y[j] = n3x + p1x - n0x - p0x, n3y + p1y - n0y - p0y
        z.g.f1x[j], z.g.f1y[j] = n0x + p2x - n1x - p1x, n0y + p2y - n1y - p1y
        z.g.f2x[j], z.g.f2y[j] = n1x + p3x - n2x - p2x, n1y + p3y - n2y - p2y
        z.g.f3x[j], z.g.f3y[j] = n2x + p0x - n3x - p3x, n2y + p0y - n3y - p3y


for _function in (metric_of, kept, counted, along_edges, in_corner, corner_force):
    bind(_function)
