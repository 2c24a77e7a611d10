r"""Tensor viscosity in the four corners of a zone: each principal direction of closing resisted with its own length.

In a corner with the edges $e_1$ (to the next corner) and $e_2$ (to the one before) the velocity gradient is that of the triangle they
span. Its symmetric part has the principal rates $\lambda_{1,2} = \bar d \mp R$ along $n_{1,2}$. The velocity jump along $n$ is
$\Delta u = \lambda\,\ell(n)$, with the length of the zone in that direction from its mean edges,
$\ell^2 = (n\cdot e_\xi)^2 + (n\cdot e_\eta)^2$, and

$$Q = \rho \sum_{\lambda_k < 0} |\Delta u_k|\,w(\Delta u_k, \psi_k)\; n_k \otimes n_k ,$$

w the viscous speed of the viscosity's law. psi is the mean of those of the two logical directions (`smoothness`), weighted by their parts
of $\ell^2$. Where the two rates are equal, as in flow that converges from all sides, the directions are anyone's: lengths and weights
then turn continuously into the mean of both, with the factor $\min(1, R/|\bar d|)$, so that no direction is chosen by round-off and the
symmetry of a polar mesh is kept. A direction that opened at the start of the step is no smooth flow: its psi is 0, as in one dimension.

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
from hugoniot.solvers.lagrange2d.layout import Corners, Points, Rates, Smoothness, Stress, Tensor
from hugoniot.solvers.lagrange2d.quads import quad

SMALL = 1e-200
NOISE = 1e-12
FLAT = 0.25             # part of a parallelogram's corner below which a triangle that shrinks, or is turned over, has no larger gradients
SLIGHT = 1e-4           # part of the other jump up to which one limits no time step
SLENDER, NEEDLE = 4.0, 8.0


class ResistOf(NamedTuple):
    """Nodes in the middle, strain rates, smoothness, state, density of the solid -> mean viscous stress, corner forces of what the
    corners' stresses have beyond it, largest viscous speed."""

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


class HoopOf(NamedTuple):
    """Strain rates, mean viscous stress -> its hoop part."""

    d: Rates
    mean: Stress


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
    least = -NOISE * vsqrt(xx * xx + yy * yy + xy * xy)
    du1, du2 = rate1 * vsqrt(xi) if rate1 < least else 0.0, rate2 * vsqrt(eta) if rate2 < least else 0.0
    w1 = viscous_speed(a.v, a.c, a.p, du1, a.xi if before1 < 0.0 else 0.0, viscosity)
    w2 = viscous_speed(a.v, a.c, a.p, du2, a.eta if before2 < 0.0 else 0.0, viscosity)
    w1, w2 = w1 if du1 < 0.0 else 0.0, w2 if du2 < 0.0 else 0.0
    q1, q2 = -a.rho * du1 * w1 / xi, -a.rho * du2 * w2 / eta
    fast = fmax(w1 if du1 < SLIGHT * du2 else 0.0, w2 if du2 < SLIGHT * du1 else 0.0)
    part = fmax(0.0, fmin(1.0, (NEEDLE - fmax(xi, eta) / area) * (1.0 / (NEEDLE - SLENDER))))
    return q1 * m.xixx + q2 * m.etaxx, q1 * m.xiyy + q2 * m.etayy, q1 * m.xixy + q2 * m.etaxy, fast, part


def in_corner(e1x, e1y, e2x, e2y, u1, v1, u2, v2, m, a, viscosity):
    """(viscous stress (xx, yy, xy), largest speed) of the corner with the edges e1 to the next corner and e2 to the one before, along
    which the velocities differ by (u1, v1) and (u2, v2)."""
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
    psi1 = ((xi - xim) * a.xi + (eta - etam) * a.eta) / square1 if before_mean - before_dev < 0.0 else 0.0
    psi2 = ((xi + xim) * a.xi + (eta + etam) * a.eta) / square2 if before_mean + before_dev < 0.0 else 0.0
    least = -NOISE * (size + fmax(mean, -mean))      # round-off closes nothing
    du1 = (mean - size) * vsqrt(square1) if mean - size < least else 0.0
    du2 = (mean + size) * vsqrt(square2) if mean + size < least else 0.0
    w1, w2 = viscous_speed(a.v, a.c, a.p, du1, psi1, viscosity), viscous_speed(a.v, a.c, a.p, du2, psi2, viscosity)
    w1, w2 = w1 if du1 < 0.0 else 0.0, w2 if du2 < 0.0 else 0.0
    q1, q2 = -a.rho * du1 * w1, -a.rho * du2 * w2
    fast = fmax(w1 if du1 < SLIGHT * du2 else 0.0, w2 if du2 < SLIGHT * du1 else 0.0)
    half, dev = 0.5 * (q1 + q2), 0.5 * (q2 - q1)
    return half + dev * mxx, half - dev * mxx, dev * mxy, fast


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
        a = Around(smooth.xi[j], smooth.eta[j], smooth.xx[j], smooth.yy[j], smooth.xy[j], z.v[j], z.c[j], z.p[j], z.rho[j])
        lxx, lyy, lxy, fast, part = along_edges(m, d, a, q.area, viscosity)
        rest = 1.0 - part
        lxx, lyy, lxy = lxx * rest, lyy * rest, lxy * rest
        # edges from corner to corner, and the differences of velocity along them
        ax, ay, bx, by = q.x1 - q.x0, q.y1 - q.y0, q.x2 - q.x1, q.y2 - q.y1
        cx, cy, dx, dy = q.x3 - q.x2, q.y3 - q.y2, q.x0 - q.x3, q.y0 - q.y3
        au, av, bu, bv = high.u[j] - low.u[j], high.v[j] - low.v[j], high.u[j + 1] - high.u[j], high.v[j + 1] - high.v[j]
        cu, cv, du, dv = low.u[j + 1] - high.u[j + 1], low.v[j + 1] - high.v[j + 1], low.u[j] - low.u[j + 1], low.v[j] - low.v[j + 1]
        xx0, yy0, xy0, fast0 = in_corner(ax, ay, -dx, -dy, au, av, -du, -dv, m, a, viscosity)
        xx1, yy1, xy1, fast1 = in_corner(bx, by, -ax, -ay, bu, bv, -au, -av, m, a, viscosity)
        xx2, yy2, xy2, fast2 = in_corner(cx, cy, -bx, -by, cu, cv, -bu, -bv, m, a, viscosity)
        xx3, yy3, xy3, fast3 = in_corner(dx, dy, -cx, -cy, du, dv, -cu, -cv, m, a, viscosity)
        z.fastest[j] = fmax(fast, fmax(fmax(fast0, fast1), fmax(fast2, fast3)))
        # the mean, each corner with the area it stands for; one that points inward stands for none
        w0, w1, w2, w3 = fmax(q.t0, 0.0), fmax(q.t1, 0.0), fmax(q.area - q.t0, 0.0), fmax(q.area - q.t1, 0.0)
        inverse = 1.0 / (w0 + w1 + w2 + w3)
        xx = (w0 * xx0 + w1 * xx1 + w2 * xx2 + w3 * xx3) * inverse
        yy = (w0 * yy0 + w1 * yy1 + w2 * yy2 + w3 * yy3) * inverse
        xy = (w0 * xy0 + w1 * xy1 + w2 * xy2 + w3 * xy3) * inverse
        z.mean.xx[j], z.mean.yy[j], z.mean.xy[j] = part * xx + lxx, part * yy + lyy, part * xy + lxy
        n0x, n0y, p0x, p0y = corner_force(part * (xx0 - xx), part * (yy0 - yy), part * (xy0 - xy), ax, ay, -dx, -dy)
        n1x, n1y, p1x, p1y = corner_force(part * (xx1 - xx), part * (yy1 - yy), part * (xy1 - xy), bx, by, -ax, -ay)
        n2x, n2y, p2x, p2y = corner_force(part * (xx2 - xx), part * (yy2 - yy), part * (xy2 - xy), cx, cy, -bx, -by)
        n3x, n3y, p3x, p3y = corner_force(part * (xx3 - xx), part * (yy3 - yy), part * (xy3 - xy), dx, dy, -cx, -cy)
        z.g.f0x[j], z.g.f0y[j] = n3x + p1x - n0x - p0x, n3y + p1y - n0y - p0y
        z.g.f1x[j], z.g.f1y[j] = n0x + p2x - n1x - p1x, n0y + p2y - n1y - p1y
        z.g.f2x[j], z.g.f2y[j] = n1x + p3x - n2x - p2x, n1y + p3y - n2y - p2y
        z.g.f3x[j], z.g.f3y[j] = n2x + p0x - n3x - p3x, n2y + p0y - n3y - p3y


@zone_pass(HoopOf)
def hoop_viscosity(count, given, dt, numbers, law):
    """What resists the closing around the axis: the viscous stress along the principal direction that closes most nearly as fast.

    In spherical flow that is the tangential one, so that both tangential directions are resisted alike, and the curved terms of the
    viscous stress are radial; in a shock that runs along the axis or toward it, it is the direction along the front, which nothing resists.
    """
    rows_apart()
    d, q = given
    for j in range(count):
        mean, dev, xy, around = 0.5 * (d.xx[j] + d.yy[j]), 0.5 * (d.xx[j] - d.yy[j]), d.xy[j], d.hoop[j]
        size = vsqrt(dev * dev + xy * xy)
        half, part = 0.5 * (q.xx[j] + q.yy[j]), (0.5 * (q.xx[j] - q.yy[j]) * dev + q.xy[j] * xy) / (size + SMALL)
        found = half + part if around > mean else half - part
        q.hoop[j] = found if around < 0.0 else 0.0


def write(s, solid):
    """Write how the viscous stress in the middle of the step is found, from the density row `solid`."""
    z, w, at = s.at.z, s.at.w, s.at
    s.do(resist, ResistOf(at.mid_low, at.mid_high, Tensor(at.d.xx, at.d.yy, at.d.xy), at.smooth, w.v, z.c, s.p_half, solid,
                          Tensor(at.coming.xx, at.coming.yy, at.coming.xy), at.rest, z.viscous_speed), law=s.laws.viscosity)


for _function in (metric_of, along_edges, in_corner, corner_force):
    bind(_function)
