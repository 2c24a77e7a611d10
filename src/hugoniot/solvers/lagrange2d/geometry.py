r"""Geometry of one row of quadrilaterals: volume, gradient coefficients and strain rates; forces are their transpose.

A mean gradient over a zone of volume $V$ is $D_{xx} = \sum_k b_{kx} u_k / V$ and so on, the hoop rate $\sum_k h_k u_k / V$. Stress
puts the power $V \sigma : D$ into a zone, so that a corner feels $F_{kx} = -(b_{kx}\sigma_{xx} + b_{ky}\sigma_{xy} + h_k\sigma_\theta)$,
$F_{ky} = -(b_{kx}\sigma_{xy} + b_{ky}\sigma_{yy})$ (virtual work). The coefficients are

* planar: the area's derivatives $a_k = \partial A/\partial x_k$; no hoop.
* true volume (per radian, x the radius): means over the true volume with bilinear velocities, $b_{kx} = \int \partial_x N_k\,x\,dA$,
  $b_{ky} = \int \partial_y N_k\,x\,dA = \partial V/\partial y_k$, $h_k = \int N_k\,dA = (A + T_k)/6$ with the corner's triangle $T_k$;
  $b_{kx} + h_k = \partial V/\partial x_k$, so pressure does exactly p dV, and the axial momentum is kept.
* area weighted: the planar force times the corner's radius, with $h_k = A_k r_k/\bar r$, $A_k$ a quarter-like share of the area and
  $\bar r$ the mean radius of the corners: $b_{kx} = r_k a_{kx} - h_k$, $b_{ky} = r_k a_{ky}$. Divided by the constant node mass this is
  the planar acceleration with the terms $(s_{rr} - s_{\theta\theta})/r$ and $s_{rz}/r$ of the curved equations. Since these act as the
  zone's own $1/\bar r$ times the weight of the corner, they are radial in spherical flow on equal angles as the planar force is:
  symmetry is kept with viscosity and strength. Pressure does p dV to second order.

Caramana, Burton, Shashkov & Whalen, J. Comput. Phys. 146 (1998) 227; Caramana & Whalen, J. Comput. Phys. 141 (1998) 174.
"""

from typing import Any, NamedTuple

from hugoniot.core.passes import rows_apart
from hugoniot.solvers.lagrange2d.layout import Corners, Points, Rates, Shape, Stress
from hugoniot.solvers.lagrange2d.row_pass import row_pass

PLANAR, TRUE_VOLUME, AREA_WEIGHTED = range(3)
AXIS_RADIUS = 1e-14      # radius a node on the axis is given (area weighted), in units of the largest: its motion weighs nothing in sums


class ShapeOf(NamedTuple):
    """Two rows of nodes -> the shape of the zones between them."""

    low: Points
    high: Points
    s: Shape


class RatesOf(NamedTuple):
    """Two rows of nodes and the shape of the zones between them -> velocity gradient."""

    low: Points
    high: Points
    s: Shape
    d: Rates


class ForcesOf(NamedTuple):
    """Shape and stress -> corner forces."""

    s: Shape
    t: Stress
    f: Corners


class PowerOf(NamedTuple):
    """Two rows of nodes and corner forces -> power, W."""

    low: Points
    high: Points
    f: Corners
    power: Any



@row_pass(ShapeOf)
def planar(count, given, dt, numbers, law):
    """Coefficients of `count` zones between the node rows `low` and `high` into the rows `s` (layout.Shape)."""
    rows_apart()
    low, high, s = given
    for j in range(count):
        x0, y0, x1, y1 = low.x[j], low.y[j], high.x[j], high.y[j]
        x2, y2, x3, y3 = high.x[j + 1], high.y[j + 1], low.x[j + 1], low.y[j + 1]
        ax, ay = 0.5 * (y1 - y3), 0.5 * (x3 - x1)
        bx, by = 0.5 * (y2 - y0), 0.5 * (x0 - x2)
        area = (x0 - x2) * ax + (y0 - y2) * ay
        s.volume[j] = area
        s.area[j] = area
        s.t0[j] = 0.5 * ((x1 - x0) * (y3 - y0) - (y1 - y0) * (x3 - x0))
        s.t1[j] = 0.5 * ((x2 - x1) * (y0 - y1) - (y2 - y1) * (x0 - x1))
        s.b0x[j], s.b0y[j] = ax, ay
        s.b1x[j], s.b1y[j] = bx, by
        s.b2x[j], s.b2y[j] = -ax, -ay
        s.b3x[j], s.b3y[j] = -bx, -by
        s.h0[j] = 0.0
        s.h1[j] = 0.0
        s.h2[j] = 0.0
        s.h3[j] = 0.0
        s.w0[j] = 1.0
        s.w1[j] = 1.0
        s.w2[j] = 1.0
        s.w3[j] = 1.0


@row_pass(ShapeOf)
def true_volume(count, given, dt, numbers, law):
    """As `planar`, per radian, by exact integrals over the true volume."""
    rows_apart()
    low, high, s = given
    for j in range(count):
        x0, y0, x1, y1 = low.x[j], low.y[j], high.x[j], high.y[j]
        x2, y2, x3, y3 = high.x[j + 1], high.y[j + 1], low.x[j + 1], low.y[j + 1]
        t0 = 0.5 * ((x1 - x0) * (y3 - y0) - (y1 - y0) * (x3 - x0))
        t1 = 0.5 * ((x2 - x1) * (y0 - y1) - (y2 - y1) * (x0 - x1))
        area = 0.5 * ((x2 - x0) * (y3 - y1) - (y2 - y0) * (x3 - x1))
        # mean squares of the radius on the edges, and with them dV/dy; V = sum (dy of an edge) (its mean square) / 2
        e0 = (x0 * x0 + x0 * x1 + x1 * x1) * (1.0 / 6.0)
        e1 = (x1 * x1 + x1 * x2 + x2 * x2) * (1.0 / 6.0)
        e2 = (x2 * x2 + x2 * x3 + x3 * x3) * (1.0 / 6.0)
        e3 = (x3 * x3 + x3 * x0 + x0 * x0) * (1.0 / 6.0)
        d0, d1, d2, d3 = (y1 - y0) * (1.0 / 6.0), (y2 - y1) * (1.0 / 6.0), (y3 - y2) * (1.0 / 6.0), (y0 - y3) * (1.0 / 6.0)
        volume = 6.0 * (d0 * e0 + d1 * e1 + d2 * e2 + d3 * e3)
        h0, h1 = (area + t0) * (1.0 / 6.0), (area + t1) * (1.0 / 6.0)
        h2, h3 = (2.0 * area - t0) * (1.0 / 6.0), (2.0 * area - t1) * (1.0 / 6.0)
        s.volume[j] = volume
        s.area[j] = area
        s.t0[j] = t0
        s.t1[j] = t1
        s.b0x[j] = d3 * (x3 + 2.0 * x0) + d0 * (2.0 * x0 + x1) - h0
        s.b1x[j] = d0 * (x0 + 2.0 * x1) + d1 * (2.0 * x1 + x2) - h1
        s.b2x[j] = d1 * (x1 + 2.0 * x2) + d2 * (2.0 * x2 + x3) - h2
        s.b3x[j] = d2 * (x2 + 2.0 * x3) + d3 * (2.0 * x3 + x0) - h3
        s.b0y[j] = e3 - e0
        s.b1y[j] = e0 - e1
        s.b2y[j] = e1 - e2
        s.b3y[j] = e2 - e3
        s.h0[j] = h0
        s.h1[j] = h1
        s.h2[j] = h2
        s.h3[j] = h3
        mean = volume / area
        s.w0[j] = mean
        s.w1[j] = mean
        s.w2[j] = mean
        s.w3[j] = mean


@row_pass(ShapeOf)
def area_weighted(count, given, dt, numbers, law):
    """As `planar`, times the radius of the corner, at least `near`; the volume is the true one."""
    rows_apart()
    low, high, s = given
    near = numbers[0]
    for j in range(count):
        x0, y0, x1, y1 = low.x[j], low.y[j], high.x[j], high.y[j]
        x2, y2, x3, y3 = high.x[j + 1], high.y[j + 1], low.x[j + 1], low.y[j + 1]
        ax, ay = 0.5 * (y1 - y3), 0.5 * (x3 - x1)
        bx, by = 0.5 * (y2 - y0), 0.5 * (x0 - x2)
        area = (x0 - x2) * ax + (y0 - y2) * ay
        t0 = 0.5 * ((x1 - x0) * (y3 - y0) - (y1 - y0) * (x3 - x0))
        t1 = 0.5 * ((x2 - x1) * (y0 - y1) - (y2 - y1) * (x0 - x1))
        e0 = (y1 - y0) * (x0 * x0 + x0 * x1 + x1 * x1)
        e1 = (y2 - y1) * (x1 * x1 + x1 * x2 + x2 * x2)
        e2 = (y3 - y2) * (x2 * x2 + x2 * x3 + x3 * x3)
        e3 = (y0 - y3) * (x3 * x3 + x3 * x0 + x0 * x0)
        volume = (e0 + e1 + e2 + e3) * (1.0 / 6.0)
        # on the axis the weight is `near` instead of the radius
        share = 4.0 / (x0 + x1 + x2 + x3)
        r0, r1 = x0 if x0 > near else near, x1 if x1 > near else near
        r2, r3 = x2 if x2 > near else near, x3 if x3 > near else near
        h0 = (0.125 * area + 0.25 * t0) * (share * r0)
        h1 = (0.125 * area + 0.25 * t1) * (share * r1)
        h2 = (0.375 * area - 0.25 * t0) * (share * r2)
        h3 = (0.375 * area - 0.25 * t1) * (share * r3)
        s.volume[j] = volume
        s.area[j] = area
        s.t0[j] = t0
        s.t1[j] = t1
        s.b0x[j], s.b0y[j] = r0 * ax - h0, r0 * ay
        s.b1x[j], s.b1y[j] = r1 * bx - h1, r1 * by
        s.b2x[j], s.b2y[j] = -r2 * ax - h2, -r2 * ay
        s.b3x[j], s.b3y[j] = -r3 * bx - h3, -r3 * by
        s.h0[j] = h0
        s.h1[j] = h1
        s.h2[j] = h2
        s.h3[j] = h3
        s.w0[j] = r0
        s.w1[j] = r1
        s.w2[j] = r2
        s.w3[j] = r3


@row_pass(RatesOf)
def mean_rates(count, given, dt, numbers, law):
    """Strain rates, spin and hoop rate as means over the zone's volume (planar, true volume), into the rows `d` (layout.Rates)."""
    rows_apart()
    low, high, s, d = given
    for j in range(count):
        u0, v0, u1, v1 = low.u[j], low.v[j], high.u[j], high.v[j]
        u2, v2, u3, v3 = high.u[j + 1], high.v[j + 1], low.u[j + 1], low.v[j + 1]
        inverse = 1.0 / s.volume[j]
        xx = s.b0x[j] * u0 + s.b1x[j] * u1 + s.b2x[j] * u2 + s.b3x[j] * u3
        yy = s.b0y[j] * v0 + s.b1y[j] * v1 + s.b2y[j] * v2 + s.b3y[j] * v3
        uy = s.b0y[j] * u0 + s.b1y[j] * u1 + s.b2y[j] * u2 + s.b3y[j] * u3
        vx = s.b0x[j] * v0 + s.b1x[j] * v1 + s.b2x[j] * v2 + s.b3x[j] * v3
        hoop = s.h0[j] * u0 + s.h1[j] * u1 + s.h2[j] * u2 + s.h3[j] * u3
        d.xx[j] = xx * inverse
        d.yy[j] = yy * inverse
        d.xy[j] = 0.5 * (uy + vx) * inverse
        d.spin[j] = 0.5 * (vx - uy) * inverse
        d.hoop[j] = hoop * inverse
        d.dilation[j] = (xx + yy + hoop) * inverse


@row_pass(RatesOf)
def area_rates(count, given, dt, numbers, law):
    """Strain rates and spin as means over the zone's area, the hoop rate as mean velocity over mean radius (area weighted)."""
    rows_apart()
    low, high, s, d = given
    for j in range(count):
        u0, v0, u1, v1 = low.u[j], low.v[j], high.u[j], high.v[j]
        u2, v2, u3, v3 = high.u[j + 1], high.v[j + 1], low.u[j + 1], low.v[j + 1]
        ax, ay = 0.5 * (high.y[j] - low.y[j + 1]), 0.5 * (low.x[j + 1] - high.x[j])
        bx, by = 0.5 * (high.y[j + 1] - low.y[j]), 0.5 * (low.x[j] - high.x[j + 1])
        inverse = 1.0 / s.area[j]
        xx = ax * (u0 - u2) + bx * (u1 - u3)
        yy = ay * (v0 - v2) + by * (v1 - v3)
        uy = ay * (u0 - u2) + by * (u1 - u3)
        vx = ax * (v0 - v2) + bx * (v1 - v3)
        hoop = (u0 + u1 + u2 + u3) / (low.x[j] + high.x[j] + high.x[j + 1] + low.x[j + 1])
        d.xx[j] = xx * inverse
        d.yy[j] = yy * inverse
        d.xy[j] = 0.5 * (uy + vx) * inverse
        d.spin[j] = 0.5 * (vx - uy) * inverse
        d.hoop[j] = hoop
        d.dilation[j] = (xx + yy) * inverse + hoop


@row_pass(ForcesOf)
def stress_forces(count, given, dt, numbers, law):
    """Corner forces of the stress rows `t` (layout.Stress), by virtual work, into the rows `f` (layout.Corners)."""
    rows_apart()
    s, t, f = given
    for j in range(count):
        xx, yy, xy, hoop = t.xx[j], t.yy[j], t.xy[j], t.hoop[j]
        f.f0x[j] = -(s.b0x[j] * xx + s.b0y[j] * xy + s.h0[j] * hoop)
        f.f0y[j] = -(s.b0x[j] * xy + s.b0y[j] * yy)
        f.f1x[j] = -(s.b1x[j] * xx + s.b1y[j] * xy + s.h1[j] * hoop)
        f.f1y[j] = -(s.b1x[j] * xy + s.b1y[j] * yy)
        f.f2x[j] = -(s.b2x[j] * xx + s.b2y[j] * xy + s.h2[j] * hoop)
        f.f2y[j] = -(s.b2x[j] * xy + s.b2y[j] * yy)
        f.f3x[j] = -(s.b3x[j] * xx + s.b3y[j] * xy + s.h3[j] * hoop)
        f.f3y[j] = -(s.b3x[j] * xy + s.b3y[j] * yy)


@row_pass(PowerOf)
def power(count, given, dt, numbers, law):
    """Power that the corner forces `f` take from the nodes' motion, -sum F.u, W per metre or radian: what a zone gains, into `found`."""
    rows_apart()
    low, high, f, found = given
    for j in range(count):
        work = f.f0x[j] * low.u[j] + f.f0y[j] * low.v[j] + f.f1x[j] * high.u[j] + f.f1y[j] * high.v[j]
        work += f.f2x[j] * high.u[j + 1] + f.f2y[j] * high.v[j + 1] + f.f3x[j] * low.u[j + 1] + f.f3y[j] * low.v[j + 1]
        found[j] = -work
