r"""Geometry of quadrilaterals: volume, gradient coefficients and strain rates; forces are their transpose.

The mean gradient over a zone of volume $V$ is $D_{xx} = \sum_k b_{kx} u_k / V$ and so on, the hoop rate $\sum_k h_k u_k / V$. The power of
the stress on a zone is $V \sigma : D$, so the force on a corner is $F_{kx} = -(b_{kx}\sigma_{xx} + b_{ky}\sigma_{xy} + h_k\sigma_\theta)$,
$F_{ky} = -(b_{kx}\sigma_{xy} + b_{ky}\sigma_{yy})$ (virtual work). The coefficients are

* planar: the area's derivatives $a_k = \partial A/\partial x_k$; no hoop.
* true volume (per radian, x the radius): means over the true volume with bilinear velocities, $b_{kx} = \int \partial_x N_k\,x\,dA$,
  $b_{ky} = \int \partial_y N_k\,x\,dA = \partial V/\partial y_k$, $h_k = \int N_k\,dA = (A + T_k)/6$ with the corner's triangle $T_k$;
  $b_{kx} + h_k = \partial V/\partial x_k$, so the work of the pressure is exactly p dV, and the axial momentum is conserved.
* area weighted: the planar force times the corner's radius, with $h_k = A_k r_k/\bar r$, $A_k$ a quarter-like share of the area and
  $\bar r$ the mean radius of the corners: $b_{kx} = r_k a_{kx} - h_k$, $b_{ky} = r_k a_{ky}$. Divided by the constant node mass this is
  the planar acceleration plus the terms $(s_{rr} - s_{\theta\theta})/r$ and $s_{rz}/r$ due to curvature. Each zone contributes these with
  its own $1/\bar r$ times the weight of the corner, so that in spherical flow on equal angles they are radial, like the planar force:
  symmetry is preserved with viscosity and strength. The work of the pressure is p dV to second order.

The first argument of the functions is a `Quad`, the last one the geometry, whose class selects the scheme in kernels.
Caramana, Burton, Shashkov & Whalen, J. Comput. Phys. 146 (1998) 227; Caramana & Whalen, J. Comput. Phys. 141 (1998) 174.
"""

from typing import NamedTuple

from hugoniot.core.binder import bind, bind_choice

AXIS_RADIUS = 1e-14      # radius a node on the axis is given (area weighted), in units of the largest: its motion weighs nothing in sums


class Planar(NamedTuple):
    """In the plane, per metre of depth."""

    code: float = 0.0


class TrueVolume(NamedTuple):
    """Axisymmetric by virtual work, per radian."""

    code: float = 1.0


class AreaWeighted(NamedTuple):
    """Axisymmetric by planar forces times the radius, per radian."""

    code: float = 2.0


PLANAR, TRUE_VOLUME, AREA_WEIGHTED = range(3)
KINDS = (Planar(), TrueVolume(), AreaWeighted())


class Quad(NamedTuple):
    """Corners of a zone, counter-clockwise, and what follows for its area: derivatives by corners 0 and 1 (2 and 3: minus these),
    the area, the triangles at corners 0 and 1 (at 2 and 3: the area less these)."""

    x0: float
    y0: float
    x1: float
    y1: float
    x2: float
    y2: float
    x3: float
    y3: float
    ax: float
    ay: float
    bx: float
    by: float
    area: float
    t0: float
    t1: float


class Coefficients(NamedTuple):
    """Of the mean gradient, of the hoop rate, and weights of planar forces."""

    b0x: float
    b0y: float
    b1x: float
    b1y: float
    b2x: float
    b2y: float
    b3x: float
    b3y: float
    h0: float
    h1: float
    h2: float
    h3: float
    w0: float
    w1: float
    w2: float
    w3: float


class Strains(NamedTuple):
    """Strain rates, spin (dv/dx - du/dy)/2, hoop rate, volume rate over volume, 1/s."""

    xx: float
    yy: float
    xy: float
    spin: float
    hoop: float
    dilation: float


def quad(low, high, j):
    """The zone j between two rows of nodes."""
    x0, y0, x1, y1 = low.x[j], low.y[j], high.x[j], high.y[j]
    x2, y2, x3, y3 = high.x[j + 1], high.y[j + 1], low.x[j + 1], low.y[j + 1]
    ax, ay, bx, by = 0.5 * (y1 - y3), 0.5 * (x3 - x1), 0.5 * (y2 - y0), 0.5 * (x0 - x2)
    area = (x0 - x2) * ax + (y0 - y2) * ay
    t0 = 0.5 * ((x1 - x0) * (y3 - y0) - (y1 - y0) * (x3 - x0))
    t1 = 0.5 * ((x2 - x1) * (y0 - y1) - (y2 - y1) * (x0 - x1))
    return Quad(x0, y0, x1, y1, x2, y2, x3, y3, ax, ay, bx, by, area, t0, t1)


# -- volume ---------------------------------------------------------------------------------------------------------------------
def volume(q, geometry):
    """Area, or true volume per radian."""
    return (plane_volume, true_volume, true_volume)[int(geometry.code)](q, geometry)


def plane_volume(q, geometry):
    return q.area


def true_volume(q, geometry):
    """Sum of (dy of an edge) (mean square of its radius) / 2."""
    e0 = (q.y1 - q.y0) * (q.x0 * q.x0 + q.x0 * q.x1 + q.x1 * q.x1)
    e1 = (q.y2 - q.y1) * (q.x1 * q.x1 + q.x1 * q.x2 + q.x2 * q.x2)
    e2 = (q.y3 - q.y2) * (q.x2 * q.x2 + q.x2 * q.x3 + q.x3 * q.x3)
    e3 = (q.y0 - q.y3) * (q.x3 * q.x3 + q.x3 * q.x0 + q.x0 * q.x0)
    return (e0 + e1 + e2 + e3) * (1.0 / 6.0)


# -- coefficients ---------------------------------------------------------------------------------------------------------------
def coefficients(q, near, geometry):
    """`Coefficients` of a zone; near: the radius used for the axis."""
    return (plane_coefficients, volume_coefficients, area_coefficients)[int(geometry.code)](q, near, geometry)


def plane_coefficients(q, near, geometry):
    return Coefficients(q.ax, q.ay, q.bx, q.by, -q.ax, -q.ay, -q.bx, -q.by, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0)


def volume_coefficients(q, near, geometry):
    """Exact integrals over the true volume."""
    x0, x1, x2, x3 = q.x0, q.x1, q.x2, q.x3
    e0, e1 = (x0 * x0 + x0 * x1 + x1 * x1) * (1.0 / 6.0), (x1 * x1 + x1 * x2 + x2 * x2) * (1.0 / 6.0)
    e2, e3 = (x2 * x2 + x2 * x3 + x3 * x3) * (1.0 / 6.0), (x3 * x3 + x3 * x0 + x0 * x0) * (1.0 / 6.0)
    d0, d1, d2, d3 = (q.y1 - q.y0) * (1.0 / 6.0), (q.y2 - q.y1) * (1.0 / 6.0), (q.y3 - q.y2) * (1.0 / 6.0), (q.y0 - q.y3) * (1.0 / 6.0)
    h0, h1 = (q.area + q.t0) * (1.0 / 6.0), (q.area + q.t1) * (1.0 / 6.0)
    h2, h3 = (2.0 * q.area - q.t0) * (1.0 / 6.0), (2.0 * q.area - q.t1) * (1.0 / 6.0)
    mean = 6.0 * (d0 * e0 + d1 * e1 + d2 * e2 + d3 * e3) / q.area
    return Coefficients(d3 * (x3 + 2.0 * x0) + d0 * (2.0 * x0 + x1) - h0, e3 - e0, d0 * (x0 + 2.0 * x1) + d1 * (2.0 * x1 + x2) - h1,
                        e0 - e1, d1 * (x1 + 2.0 * x2) + d2 * (2.0 * x2 + x3) - h2, e1 - e2,
                        d2 * (x2 + 2.0 * x3) + d3 * (2.0 * x3 + x0) - h3, e2 - e3, h0, h1, h2, h3, mean, mean, mean, mean)


def area_coefficients(q, near, geometry):
    """The planar ones times the radius of the corner, at least `near`."""
    share = 4.0 / (q.x0 + q.x1 + q.x2 + q.x3)
    r0, r1 = q.x0 if q.x0 > near else near, q.x1 if q.x1 > near else near
    r2, r3 = q.x2 if q.x2 > near else near, q.x3 if q.x3 > near else near
    h0, h1 = (0.125 * q.area + 0.25 * q.t0) * (share * r0), (0.125 * q.area + 0.25 * q.t1) * (share * r1)
    h2, h3 = (0.375 * q.area - 0.25 * q.t0) * (share * r2), (0.375 * q.area - 0.25 * q.t1) * (share * r3)
    return Coefficients(r0 * q.ax - h0, r0 * q.ay, r1 * q.bx - h1, r1 * q.by, -r2 * q.ax - h2, -r2 * q.ay, -r3 * q.bx - h3, -r3 * q.by,
                        h0, h1, h2, h3, r0, r1, r2, r3)


# -- strain rates -----------------------------------------------------------------------------------------------------------------
def strains(q, low, high, j, near, geometry):
    """`Strains` of zone j between two rows of nodes, which is the quadrilateral q."""
    return (mean_strains, mean_strains, area_strains)[int(geometry.code)](q, low, high, j, near, geometry)


def mean_strains(q, low, high, j, near, geometry):
    """Means over the zone's volume."""
    c, inverse = coefficients(q, near, geometry), 1.0 / volume(q, geometry)
    u0, v0, u1, v1 = low.u[j], low.v[j], high.u[j], high.v[j]
    u2, v2, u3, v3 = high.u[j + 1], high.v[j + 1], low.u[j + 1], low.v[j + 1]
    xx = c.b0x * u0 + c.b1x * u1 + c.b2x * u2 + c.b3x * u3
    yy = c.b0y * v0 + c.b1y * v1 + c.b2y * v2 + c.b3y * v3
    uy = c.b0y * u0 + c.b1y * u1 + c.b2y * u2 + c.b3y * u3
    vx = c.b0x * v0 + c.b1x * v1 + c.b2x * v2 + c.b3x * v3
    hoop = c.h0 * u0 + c.h1 * u1 + c.h2 * u2 + c.h3 * u3
    return Strains(xx * inverse, yy * inverse, 0.5 * (uy + vx) * inverse, 0.5 * (vx - uy) * inverse, hoop * inverse,
                   (xx + yy + hoop) * inverse)


def area_strains(q, low, high, j, near, geometry):
    """Means over the zone's area, the hoop rate as mean velocity over mean radius."""
    au, av, bu, bv = low.u[j] - high.u[j + 1], low.v[j] - high.v[j + 1], high.u[j] - low.u[j + 1], high.v[j] - low.v[j + 1]
    inverse = 1.0 / q.area
    xx, yy = (q.ax * au + q.bx * bu) * inverse, (q.ay * av + q.by * bv) * inverse
    uy, vx = (q.ay * au + q.by * bu) * inverse, (q.ax * av + q.bx * bv) * inverse
    hoop = (low.u[j] + high.u[j] + high.u[j + 1] + low.u[j + 1]) / (q.x0 + q.x1 + q.x2 + q.x3)
    return Strains(xx, yy, 0.5 * (uy + vx), 0.5 * (vx - uy), hoop, xx + yy + hoop)


def _by_geometry(*functions):
    """What chooses one of three functions by the class of a kernel's last argument."""
    known = dict(zip((type(kind) for kind in KINDS), functions))
    return lambda *classes: known.get(classes[-1])


bind(quad)
bind_choice(volume, _by_geometry(plane_volume, true_volume, true_volume))
bind_choice(coefficients, _by_geometry(plane_coefficients, volume_coefficients, area_coefficients))
bind_choice(strains, _by_geometry(mean_strains, mean_strains, area_strains))
