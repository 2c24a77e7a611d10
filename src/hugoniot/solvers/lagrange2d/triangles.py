r"""Geometry of triangles: volume, gradient coefficients and strain rates, as `quads` has them for quadrilaterals.

The shape functions $N_k$ are linear, so a triangle of area $A$ has one velocity gradient, $\partial_x u = \sum_k a_{kx} u_k / A$ with
$a_k = \partial A/\partial x_k$. With the mean radius $\bar r$ of its corners and its true volume $V = A\bar r$ the coefficients are

* planar: $b_k = a_k$.
* true volume: $b_k = \bar r\,a_k$, $h_k = \int N_k\,dA = A/3$, so that $b_{kx} + h_k = \partial V/\partial x_k$ and
  $b_{ky} = \partial V/\partial y_k$: the derivatives of the volume, exactly.
* area weighted: $h_k = \tfrac13 A\,r_k/\bar r$, $b_{kx} = r_k a_{kx} - h_k$, $b_{ky} = r_k a_{ky}$.

The planar force is that of KB2 (source 001), $P\,\partial A/\partial x_k$.
"""

from typing import NamedTuple

from hugoniot.solvers.lagrange2d.quads import Strains


class Triangle(NamedTuple):
    """Corners of a zone, counter-clockwise, the derivatives of its area by them, and the area."""

    x0: float
    y0: float
    x1: float
    y1: float
    x2: float
    y2: float
    ax: float
    ay: float
    bx: float
    by: float
    cx: float
    cy: float
    area: float


class TriangleCoefficients(NamedTuple):
    """Of the mean gradient, of the hoop rate, and weights of planar forces."""

    b0x: float
    b0y: float
    b1x: float
    b1y: float
    b2x: float
    b2y: float
    h0: float
    h1: float
    h2: float
    w0: float
    w1: float
    w2: float


def triangle(corners, j):
    """The zone j of three rows of corners."""
    x0, y0, x1, y1, x2, y2 = corners.a.x[j], corners.a.y[j], corners.b.x[j], corners.b.y[j], corners.c.x[j], corners.c.y[j]
    ax, ay, bx, by = 0.5 * (y1 - y2), 0.5 * (x2 - x1), 0.5 * (y2 - y0), 0.5 * (x0 - x2)
    return Triangle(x0, y0, x1, y1, x2, y2, ax, ay, bx, by, 0.5 * (y0 - y1), 0.5 * (x1 - x0), (x1 - x0) * bx + (y1 - y0) * by)


def plane_area(t, geometry):
    return t.area


def ring_volume(t, geometry):
    """Area times mean radius."""
    return t.area * ((t.x0 + t.x1 + t.x2) * (1.0 / 3.0))


def plane_weights(t, near, geometry):
    return TriangleCoefficients(t.ax, t.ay, t.bx, t.by, t.cx, t.cy, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0)


def ring_weights(t, near, geometry):
    """Exact integrals over the true volume."""
    r, h = (t.x0 + t.x1 + t.x2) * (1.0 / 3.0), t.area * (1.0 / 3.0)
    return TriangleCoefficients(r * t.ax, r * t.ay, r * t.bx, r * t.by, r * t.cx, r * t.cy, h, h, h, r, r, r)


def area_weights(t, near, geometry):
    """The planar ones times the radius of the corner, at least `near`."""
    r0, r1, r2 = t.x0 if t.x0 > near else near, t.x1 if t.x1 > near else near, t.x2 if t.x2 > near else near
    share = t.area / (t.x0 + t.x1 + t.x2)
    h0, h1, h2 = share * r0, share * r1, share * r2
    return TriangleCoefficients(r0 * t.ax - h0, r0 * t.ay, r1 * t.bx - h1, r1 * t.by, r2 * t.cx - h2, r2 * t.cy, h0, h1, h2, r0, r1, r2)


def plane_rates(t, corners, j, near, geometry):
    """The gradient in the plane; nothing around the axis."""
    return _rates(t, corners, j, 0.0)


def ring_rates(t, corners, j, near, geometry):
    """The gradient in the plane, and the mean of u over the area by the mean radius: both schemes have the same."""
    return _rates(t, corners, j, (corners.a.u[j] + corners.b.u[j] + corners.c.u[j]) / (t.x0 + t.x1 + t.x2))


def _rates(t, corners, j, hoop):
    inverse = 1.0 / t.area
    u0, v0, u1, v1, u2, v2 = corners.a.u[j], corners.a.v[j], corners.b.u[j], corners.b.v[j], corners.c.u[j], corners.c.v[j]
    xx, yy = (t.ax * u0 + t.bx * u1 + t.cx * u2) * inverse, (t.ay * v0 + t.by * v1 + t.cy * v2) * inverse
    uy, vx = (t.ay * u0 + t.by * u1 + t.cy * u2) * inverse, (t.ax * v0 + t.bx * v1 + t.cx * v2) * inverse
    return Strains(xx, yy, 0.5 * (uy + vx), 0.5 * (vx - uy), hoop, xx + yy + hoop)
