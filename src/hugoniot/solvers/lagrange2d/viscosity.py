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

from hugoniot.core.ops import fmax, fmin, vsqrt
from hugoniot.core.passes import rows_apart
from hugoniot.solvers.lagrange2d.layout import Closing, Metric, Points, Rates, Shape, Smoothness, Stress, Tensor, Vector
from hugoniot.solvers.lagrange2d.row_pass import row_pass

SMALL = 1e-200
NOISE = 1e-12
FLAT = 0.25             # part of a parallelogram's corner below which a triangle that shrinks, or is turned over, has no larger gradients
SLIGHT = 1e-4           # part of the other jump up to which one limits no time step
SLENDER, NEEDLE = 4.0, 8.0





class MetricOf(NamedTuple):
    """Two rows of nodes -> mean edges of the zones between them."""

    low: Points
    high: Points
    m: Metric


class ClosingOf(NamedTuple):
    """A corner's node, the nodes next and before, counter-clockwise; area, metric and smoothness of the zone -> what closes."""

    at: Points
    after: Points
    before: Points
    area: Any
    m: Metric
    smooth: Smoothness
    c: Closing


class ResistOf(NamedTuple):
    """Density, what closes and the viscous speeds of both directions -> viscous stress of the corner, largest speed of the zone."""

    rho: Any
    c: Closing
    speed1: Any
    speed2: Any
    along: Tensor
    q: Tensor
    fastest: Any


class AlongOf(NamedTuple):
    """Strain rates, area, mean edges and smoothness of zones -> what closes along the edges."""

    d: Rates
    area: Any
    m: Metric
    smooth: Smoothness
    c: Closing


class ResistAlongOf(NamedTuple):
    """Density, what closes along the mean edges, these, the viscous speeds -> viscous stress along them, largest speed."""

    rho: Any
    c: Closing
    m: Metric
    speed1: Any
    speed2: Any
    q: Tensor
    fastest: Any


class MeanOf(NamedTuple):
    """Shape and the viscous stresses of the corners -> their mean."""

    s: Shape
    q0: Tensor
    q1: Tensor
    q2: Tensor
    q3: Tensor
    mean: Stress


class HoopOf(NamedTuple):
    """Strain rates, mean viscous stress -> its hoop part."""

    d: Rates
    mean: Stress


class CornerForcesOf(NamedTuple):
    """Nodes of a corner, its stress, the zone's mean, half the subzonal pressure, weights and force rows of the three nodes."""

    at: Points
    after: Points
    before: Points
    q: Tensor
    mean: Stress
    extra: Any
    w0: Any
    w1: Any
    w2: Any
    f0: Vector
    f1: Vector
    f2: Vector



@row_pass(MetricOf)
def metric(count, given, dt, numbers, law):
    """Mean edges of a row of zones, each as a tensor e (x) e."""
    rows_apart()
    low, high, m = given
    for j in range(count):
        ax, ay = 0.5 * (high.x[j] - low.x[j] + high.x[j + 1] - low.x[j + 1]), 0.5 * (high.y[j] - low.y[j] + high.y[j + 1] - low.y[j + 1])
        bx, by = 0.5 * (low.x[j + 1] - low.x[j] + high.x[j + 1] - high.x[j]), 0.5 * (low.y[j + 1] - low.y[j] + high.y[j + 1] - high.y[j])
        m.xixx[j], m.xiyy[j], m.xixy[j] = bx * bx, by * by, bx * by
        m.etaxx[j], m.etayy[j], m.etaxy[j] = ax * ax, ay * ay, ax * ay


@row_pass(ClosingOf)
def closing(count, given, dt, numbers, law):
    """What closes in one corner of a row of zones."""
    rows_apart()
    at, after, before, area, m, smooth, c = given
    for j in range(count):
        e1x, e1y, e2x, e2y = after.x[j] - at.x[j], after.y[j] - at.y[j], before.x[j] - at.x[j], before.y[j] - at.y[j]
        u1, v1, u2, v2 = after.u[j] - at.u[j], after.v[j] - at.v[j], before.u[j] - at.u[j], before.v[j] - at.v[j]
        twice = e1x * e2y - e1y * e2x
        inverse = 1.0 / fmax(twice, FLAT * area[j])
        dxx = (u1 * e2y - u2 * e1y) * inverse
        dyy = (v2 * e1x - v1 * e2x) * inverse
        dxy = 0.5 * (u2 * e1x - u1 * e2x + v1 * e2y - v2 * e1y) * inverse
        mean, dev = 0.5 * (dxx + dyy), 0.5 * (dxx - dyy)
        size = vsqrt(dev * dev + dxy * dxy)
        over = 1.0 / (size + SMALL)
        mxx, mxy = dev * over, dxy * over
        half = 0.5 * fmin(1.0, size / (fmax(mean, -mean) + SMALL))
        # tensors contracted with n1 (x) n1 and n2 (x) n2
        xi, eta = 0.5 * (m.xixx[j] + m.xiyy[j]), 0.5 * (m.etaxx[j] + m.etayy[j])
        xim = half * ((m.xixx[j] - m.xiyy[j]) * mxx + 2.0 * m.xixy[j] * mxy)
        etam = half * ((m.etaxx[j] - m.etayy[j]) * mxx + 2.0 * m.etaxy[j] * mxy)
        square1, square2 = xi - xim + eta - etam, xi + xim + eta + etam
        psi1 = ((xi - xim) * smooth.xi[j] + (eta - etam) * smooth.eta[j]) / square1
        psi2 = ((xi + xim) * smooth.xi[j] + (eta + etam) * smooth.eta[j]) / square2
        before_mean = 0.5 * (smooth.xx[j] + smooth.yy[j])
        before_dev = 0.5 * (smooth.xx[j] - smooth.yy[j]) * mxx + smooth.xy[j] * mxy
        least = -NOISE * (size + fmax(mean, -mean))      # round-off closes nothing
        c.du1[j] = (mean - size) * vsqrt(square1) if mean - size < least else 0.0
        c.du2[j] = (mean + size) * vsqrt(square2) if mean + size < least else 0.0
        c.psi1[j] = psi1 if before_mean - before_dev < 0.0 else 0.0
        c.psi2[j] = psi2 if before_mean + before_dev < 0.0 else 0.0
        c.mxx[j] = mxx
        c.mxy[j] = mxy


@row_pass(ResistOf)
def resist(count, given, dt, numbers, law):
    """The corner's viscous stress (compression positive) into `q`, and the largest viscous speed of the zone into `fastest`."""
    rows_apart()
    rho, c, speed1, speed2, along, q, fastest = given
    for j in range(count):
        w1 = speed1[j] if c.du1[j] < 0.0 else 0.0
        w2 = speed2[j] if c.du2[j] < 0.0 else 0.0
        q1, q2 = -rho[j] * c.du1[j] * w1, -rho[j] * c.du2[j] * w2
        part = c.apart[j]
        half, dev, rest = 0.5 * part * (q1 + q2), 0.5 * part * (q2 - q1), 1.0 - part
        q.xx[j] = half + dev * c.mxx[j] + rest * along.xx[j]
        q.yy[j] = half - dev * c.mxx[j] + rest * along.yy[j]
        q.xy[j] = dev * c.mxy[j] + rest * along.xy[j]
        w1, w2 = w1 if c.du1[j] < SLIGHT * c.du2[j] else 0.0, w2 if c.du2[j] < SLIGHT * c.du1[j] else 0.0
        fastest[j] = fmax(fastest[j], fmax(w1, w2))


@row_pass(AlongOf)
def closing_along(count, given, dt, numbers, law):
    """What closes along the mean edges of zones, and how slender they are."""
    rows_apart()
    d, area, m, smooth, c = given
    for j in range(count):
        xi, eta = m.xixx[j] + m.xiyy[j], m.etaxx[j] + m.etayy[j]
        rate1 = (d.xx[j] * m.xixx[j] + d.yy[j] * m.xiyy[j] + 2.0 * d.xy[j] * m.xixy[j]) / xi
        rate2 = (d.xx[j] * m.etaxx[j] + d.yy[j] * m.etayy[j] + 2.0 * d.xy[j] * m.etaxy[j]) / eta
        before1 = smooth.xx[j] * m.xixx[j] + smooth.yy[j] * m.xiyy[j] + 2.0 * smooth.xy[j] * m.xixy[j]
        before2 = smooth.xx[j] * m.etaxx[j] + smooth.yy[j] * m.etayy[j] + 2.0 * smooth.xy[j] * m.etaxy[j]
        least = -NOISE * vsqrt(d.xx[j] * d.xx[j] + d.yy[j] * d.yy[j] + d.xy[j] * d.xy[j])
        c.du1[j] = rate1 * vsqrt(xi) if rate1 < least else 0.0
        c.du2[j] = rate2 * vsqrt(eta) if rate2 < least else 0.0
        c.psi1[j] = smooth.xi[j] if before1 < 0.0 else 0.0
        c.psi2[j] = smooth.eta[j] if before2 < 0.0 else 0.0
        aspect = fmax(xi, eta) / area[j]
        part = fmax(0.0, fmin(1.0, (NEEDLE - aspect) / (NEEDLE - SLENDER)))
        c.apart[j] = part


@row_pass(ResistAlongOf)
def resist_along(count, given, dt, numbers, law):
    """Viscous stress along the mean edges."""
    rows_apart()
    rho, c, m, speed1, speed2, q, fastest = given
    for j in range(count):
        w1 = speed1[j] if c.du1[j] < 0.0 else 0.0
        w2 = speed2[j] if c.du2[j] < 0.0 else 0.0
        q1 = -rho[j] * c.du1[j] * w1 / (m.xixx[j] + m.xiyy[j])
        q2 = -rho[j] * c.du2[j] * w2 / (m.etaxx[j] + m.etayy[j])
        q.xx[j] = q1 * m.xixx[j] + q2 * m.etaxx[j]
        q.yy[j] = q1 * m.xiyy[j] + q2 * m.etayy[j]
        q.xy[j] = q1 * m.xixy[j] + q2 * m.etaxy[j]
        w1, w2 = w1 if c.du1[j] < SLIGHT * c.du2[j] else 0.0, w2 if c.du2[j] < SLIGHT * c.du1[j] else 0.0
        fastest[j] = fmax(w1, w2)


@row_pass(MeanOf)
def mean_viscosity(count, given, dt, numbers, law):
    """Mean of the corners' stresses over the zone, each with the area it stands for; a corner that points inward stands for none."""
    rows_apart()
    s, q0, q1, q2, q3, mean = given
    for j in range(count):
        over = 0.5 / s.area[j]
        w0, w1 = s.t0[j] * over, s.t1[j] * over
        w2, w3 = fmax(0.5 - w0, 0.0), fmax(0.5 - w1, 0.0)
        w0, w1 = fmax(w0, 0.0), fmax(w1, 0.0)
        inverse = 1.0 / (w0 + w1 + w2 + w3)
        w0, w1, w2, w3 = w0 * inverse, w1 * inverse, w2 * inverse, w3 * inverse
        mean.xx[j] = w0 * q0.xx[j] + w1 * q1.xx[j] + w2 * q2.xx[j] + w3 * q3.xx[j]
        mean.yy[j] = w0 * q0.yy[j] + w1 * q1.yy[j] + w2 * q2.yy[j] + w3 * q3.yy[j]
        mean.xy[j] = w0 * q0.xy[j] + w1 * q1.xy[j] + w2 * q2.xy[j] + w3 * q3.xy[j]


@row_pass(HoopOf)
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


@row_pass(CornerForcesOf)
def corner_forces(count, given, dt, numbers, law):
    """Add the forces of what a corner's stress has beyond the zone's mean, and of its subzonal pressure, to the three nodes it holds."""
    rows_apart()
    at, after, before, q, mean, extra, w0, w1, w2, f0, f1, f2 = given
    for j in range(count):
        e1x, e1y, e2x, e2y = after.x[j] - at.x[j], after.y[j] - at.y[j], before.x[j] - at.x[j], before.y[j] - at.y[j]
        xx, yy = 0.25 * (q.xx[j] - mean.xx[j] + extra[j]), 0.25 * (q.yy[j] - mean.yy[j] + extra[j])
        xy = 0.25 * (q.xy[j] - mean.xy[j])
        ax, ay = xx * e2y - xy * e2x, xy * e2y - yy * e2x
        bx, by = xy * e1x - xx * e1y, yy * e1x - xy * e1y
        f1.x[j] += ax * w1[j]
        f1.y[j] += ay * w1[j]
        f2.x[j] += bx * w2[j]
        f2.y[j] += by * w2[j]
        f0.x[j] -= (ax + bx) * w0[j]
        f0.y[j] -= (ay + by) * w0[j]
