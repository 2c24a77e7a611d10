r"""Viscosity of triangles: `tensor`, `edge` and `herrmann` as they are for quadrilaterals, with one velocity gradient a zone.

* `tensor`: the stress of a corner (`viscosity`) with the gradient of the triangle. The logical directions are the two sides that are not
  the diagonal, one along i, one along j. Lengths along principal directions follow from them, so that in a rectangle divided by its
  diagonal a plane shock along either direction has the same width as without the diagonal. The stress is uniform in the triangle.
* `edge`: the two sides that are not the diagonal resist; the segments run from their middles to the middle of the diagonal, which is the
  centre of the cell. Their velocity differences determine the whole gradient. A resisting diagonal would push nodes beside a wall along
  which a plane shock runs, since such nodes have diagonals on one side only.
* `herrmann`: the extents of the triangle, and for the bulk part the area of the parallelogram of which it is half.

The smoothness is that of the cell (`smoothness`), shared by both of its triangles.
"""

from typing import Any, NamedTuple

from hugoniot.core.binder import bind
from hugoniot.core.ops import fmax, fmin, vsqrt
from hugoniot.core.passes import law_of, rows_apart, zone_pass
from hugoniot.solvers.lagrange2d.coefficients import in_zone
from hugoniot.solvers.lagrange2d.edge_viscosity import along_edge
from hugoniot.solvers.lagrange2d.herrmann_viscosity import resisted
from hugoniot.solvers.lagrange2d.jumps import SLIGHT, SMALL
from hugoniot.solvers.lagrange2d.layout import Rates, Smoothness, Stress, Tensor, VertexForces, Vertices
from hugoniot.solvers.lagrange2d.triangles import triangle
from hugoniot.solvers.lagrange2d.viscosity import along_edges, around, in_corner, metric, slenderness
from hugoniot.zones.viscosity import OWN


class TensorOf(NamedTuple):
    """Corners in the middle of the step, diagonals, strain rates, smoothness, state, density of the solid -> viscous stress, largest
    viscous speed, heat per volume and time."""

    corners: Vertices
    way: Any
    rates: Rates
    smooth: Smoothness
    v: Any
    c: Any
    p: Any
    rho: Any
    mean: Tensor
    fastest: Any
    paid: Any


class EdgesOf(NamedTuple):
    """The same, and planar forces beyond the mean stress."""

    corners: Vertices
    way: Any
    rates: Rates
    smooth: Smoothness
    v: Any
    c: Any
    p: Any
    rho: Any
    mean: Tensor
    g: VertexForces
    fastest: Any
    paid: Any


class AxesOf(NamedTuple):
    """Corners in the middle of the step, strain rates, state, density of the solid -> viscous stress, largest speed."""

    corners: Vertices
    d: Rates
    v: Any
    c: Any
    p: Any
    rho: Any
    mean: Stress
    fastest: Any


@zone_pass(TensorOf)
def resist_triangles(count, z, dt, numbers, law):
    """Viscous stress of triangles."""
    rows_apart()
    viscous, n = law_of(law, numbers), z.corners
    for j in range(count):
        ax, ay, au, av = n.b.x[j] - n.a.x[j], n.b.y[j] - n.a.y[j], n.b.u[j] - n.a.u[j], n.b.v[j] - n.a.v[j]
        bx, by, bu, bv = n.c.x[j] - n.a.x[j], n.c.y[j] - n.a.y[j], n.c.u[j] - n.a.u[j], n.c.v[j] - n.a.v[j]
        ex, ey = (bx - ax, by - ay) if z.way[j] > 0.5 else (bx, by)
        m, a = metric(ax, ay, ex, ey, SMALL), around(z, j, OWN * dt)
        d, viscosity = (z.rates.xx[j], z.rates.yy[j], z.rates.xy[j]), in_zone(viscous, z.rates, j)
        along = slenderness(ax * by - ay * bx, m)
        part = (1.0 - along) * a.rho
        lxx, lyy, lxy, fast = along_edges(m, d, a, viscosity)
        lxx, lyy, lxy = lxx * along, lyy * along, lxy * along
        xx, yy, xy, faster, heat = in_corner(ax, ay, bx, by, au, av, bu, bv, m, a, viscosity)
        z.mean.xx[j], z.mean.yy[j], z.mean.xy[j] = part * xx + lxx, part * yy + lyy, part * xy + lxy
        z.fastest[j] = fmax(fast * fmin(1.0, along * (1.0 / SLIGHT)), faster)
        z.paid[j] = part * heat - (lxx * d[0] + lyy * d[1] + 2.0 * lxy * d[2])


@zone_pass(EdgesOf)
def resist_triangle_edges(count, z, dt, numbers, law):
    """Viscous forces of the two sides of triangles that are no diagonals: their mean stress, and the planar forces beyond it."""
    rows_apart()
    viscous, n = law_of(law, numbers), z.corners
    for j in range(count):
        t, a, viscosity = triangle(n, j), around(z, j, OWN * dt), in_zone(viscous, z.rates, j)
        xi, eta, over = a.xi / fmax(a.share, SMALL), a.eta / fmax(1.0 - a.share, SMALL), z.way[j] > 0.5
        u0, v0, u1, v1, u2, v2 = n.a.u[j], n.a.v[j], n.b.u[j], n.b.v[j], n.c.u[j], n.c.v[j]
        # the middle of the diagonal, from c to a or from b to c; the other side runs from b to c or from c to a
        cx, cy = 0.5 * (t.x2 + (t.x0 if over else t.x1)), 0.5 * (t.y2 + (t.y0 if over else t.y1))
        ax, ay, fast0, heat0 = along_edge(t.x1 - t.x0, t.y1 - t.y0, cx - 0.5 * (t.x0 + t.x1), cy - 0.5 * (t.y0 + t.y1), u1 - u0, v1 - v0,
                                          eta, a, viscosity)
        ex, ey, mx, my = t.x2 - t.x1, t.y2 - t.y1, 0.5 * (t.x1 + t.x2), 0.5 * (t.y1 + t.y2)
        eu, ev = u2 - u1, v2 - v1
        if not over:
            ex, ey, mx, my = t.x0 - t.x2, t.y0 - t.y2, 0.5 * (t.x2 + t.x0), 0.5 * (t.y2 + t.y0)
            eu, ev = u0 - u2, v0 - v2
        bx, by, fast1, heat1 = along_edge(ex, ey, cx - mx, cy - my, eu, ev, xi, a, viscosity)
        z.fastest[j] = fmax(fast0, fast1)
        inverse = 1.0 / t.area
        z.paid[j] = (heat0 + heat1) * inverse
        f0x, f0y, f1x, f1y, f2x, f2y = -ax, -ay, ax - bx, ay - by, bx, by
        if not over:
            f0x, f0y, f1x, f1y, f2x, f2y = bx - ax, by - ay, ax, ay, -bx, -by
        xx, yy = (f0x * t.x0 + f1x * t.x1 + f2x * t.x2) * inverse, (f0y * t.y0 + f1y * t.y1 + f2y * t.y2) * inverse
        xy = 0.5 * (f0x * t.y0 + f1x * t.y1 + f2x * t.y2 + f0y * t.x0 + f1y * t.x1 + f2y * t.x2) * inverse
        z.mean.xx[j], z.mean.yy[j], z.mean.xy[j] = xx, yy, xy
        g = z.g
        g.f0x[j], g.f0y[j] = f0x - (t.ax * xx + t.ay * xy), f0y - (t.ax * xy + t.ay * yy)
        g.f1x[j], g.f1y[j] = f1x - (t.bx * xx + t.by * xy), f1y - (t.bx * xy + t.by * yy)
        g.f2x[j], g.f2y[j] = f2x - (t.cx * xx + t.cy * xy), f2y - (t.cx * xy + t.cy * yy)


@zone_pass(AxesOf)
def resist_triangles_along_axes(count, z, dt, numbers, law):
    """Bulk viscosity and viscous deviators along the axes."""
    rows_apart()
    viscosity, d = law_of(law, numbers), z.d
    for j in range(count):
        t = triangle(z.corners, j)
        v, c, p, rho, third = z.v[j], z.c[j], z.p[j], z.rho[j], d.dilation[j] * (1.0 / 3.0)
        wide = fmax(t.x0, fmax(t.x1, t.x2)) - fmin(t.x0, fmin(t.x1, t.x2))
        tall = fmax(t.y0, fmax(t.y1, t.y2)) - fmin(t.y0, fmin(t.y1, t.y2))
        bulk, fast = resisted(d.dilation[j], vsqrt(2.0 * t.area), v, c, p, viscosity)
        xx, fast_x = resisted(d.xx[j] - third, wide, v, c, p, viscosity)
        yy, fast_y = resisted(d.yy[j] - third, tall, v, c, p, viscosity)
        shear = d.xy[j]
        across, fast_xy = resisted(-fmax(shear, -shear), vsqrt(wide * tall), v, c, p, viscosity)
        z.mean.xx[j], z.mean.yy[j], z.mean.hoop[j] = rho * (bulk + xx), rho * (bulk + yy), rho * (bulk - xx - yy)
        z.mean.xy[j] = -rho * across if shear > 0.0 else rho * across
        z.fastest[j] = fast + fmax(fmax(fast_x, fast_y), fast_xy)


bind(triangle)
