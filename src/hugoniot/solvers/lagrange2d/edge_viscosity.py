r"""Edge viscosity: each edge of a zone whose ends approach each other resists along their velocity difference.

Between the corners k and k + 1 lies the segment from the middle of their edge to the centre of the zone, with the normal S (of the same
length, pointing from k to k + 1). Where $\Delta u\cdot S < 0$ the force on the corner k + 1 is

$$F = \rho\,w(|\Delta u|, \psi)\,(\Delta u\cdot S)\,\frac{\Delta u}{|\Delta u|}$$

and that on k the opposite. The dissipation is never negative, no rigid motion is resisted, and the result is frame invariant. psi is that
of the logical direction of the edge (`smoothness`). The mean stress of these forces, $\bar Q = \frac1A\sum_k \mathrm{sym}\,F_k\otimes x_k$,
is added to the stress of the zone, so that it has the terms of the geometry; the remaining forces act unchanged.

Caramana, Shashkov & Whalen, J. Comput. Phys. 144 (1998) 70.
"""

from hugoniot.core.binder import bind
from hugoniot.core.ops import fmax, fmin, vsqrt
from hugoniot.core.passes import law_of, rows_apart, zone_pass
from hugoniot.laws.viscosity.contract import viscous_speed
from hugoniot.solvers.lagrange2d.coefficients import in_zone
from hugoniot.solvers.lagrange2d.jumps import SMALL, counted, kept
from hugoniot.solvers.lagrange2d.quads import quad
from hugoniot.solvers.lagrange2d.viscosity import ResistOf, around
from hugoniot.zones.viscosity import OWN, at_middle


def along_edge(ex, ey, tx, ty, u, v, psi, a, viscosity):
    """(force x, y on the end of an edge, largest speed, power) of the edge (ex, ey), from whose middle (tx, ty) leads to the centre, and
    along which the velocity differs by (u, v)."""
    speed, square = vsqrt(u * u + v * v), ex * ex + ey * ey
    closing = fmin(u * ty - v * tx, 0.0)
    before = a.mean + (a.dev * (ex * ex - ey * ey) + 2.0 * a.xy * ex * ey) / square
    w = viscous_speed(a.v, a.c, a.p, -speed, kept(psi, before, fmin((u * ex + v * ey) / square, 0.0)), viscosity)
    over = 1.0 / fmax(speed * speed, SMALL)
    stress = a.q + (a.q_dev * (u * u - v * v) + 2.0 * a.q_xy * u * v) * over
    size = -a.rho * w * closing * at_middle(-speed, stress, a.gives / vsqrt(square), a.rho * w) * over
    fast = counted(w, closing / vsqrt(tx * tx + ty * ty), 0.0, a.c)
    return size * u, size * v, fast, -size * speed * speed


@zone_pass(ResistOf)
def resist_edges(count, z, dt, numbers, law):
    """Viscous forces of the four edges of zones: their mean stress, and the planar forces beyond it."""
    rows_apart()
    viscous, low, high = law_of(law, numbers), z.low, z.high
    for j in range(count):
        q = quad(low, high, j)
        a, viscosity = around(z, j, OWN * dt), in_zone(viscous, z.rates, j)
        xi, eta = a.xi / fmax(a.share, SMALL), a.eta / fmax(1.0 - a.share, SMALL)
        cx, cy = 0.25 * (q.x0 + q.x1 + q.x2 + q.x3), 0.25 * (q.y0 + q.y1 + q.y2 + q.y3)
        u0, v0, u1, v1 = low.u[j], low.v[j], high.u[j], high.v[j]
        u2, v2, u3, v3 = high.u[j + 1], high.v[j + 1], low.u[j + 1], low.v[j + 1]
        ax, ay, fast0, heat0 = along_edge(q.x1 - q.x0, q.y1 - q.y0, cx - 0.5 * (q.x0 + q.x1), cy - 0.5 * (q.y0 + q.y1), u1 - u0, v1 - v0,
                                          eta, a, viscosity)
        bx, by, fast1, heat1 = along_edge(q.x2 - q.x1, q.y2 - q.y1, cx - 0.5 * (q.x1 + q.x2), cy - 0.5 * (q.y1 + q.y2), u2 - u1, v2 - v1,
                                          xi, a, viscosity)
        dx, dy, fast2, heat2 = along_edge(q.x3 - q.x2, q.y3 - q.y2, cx - 0.5 * (q.x2 + q.x3), cy - 0.5 * (q.y2 + q.y3), u3 - u2, v3 - v2,
                                          eta, a, viscosity)
        ex, ey, fast3, heat3 = along_edge(q.x0 - q.x3, q.y0 - q.y3, cx - 0.5 * (q.x3 + q.x0), cy - 0.5 * (q.y3 + q.y0), u0 - u3, v0 - v3,
                                          xi, a, viscosity)
        z.fastest[j] = fmax(fmax(fast0, fast1), fmax(fast2, fast3))
        inverse = 1.0 / q.area
        z.paid[j] = (heat0 + heat1 + heat2 + heat3) * inverse
        f0x, f0y, f1x, f1y, f2x, f2y, f3x, f3y = ex - ax, ey - ay, ax - bx, ay - by, bx - dx, by - dy, dx - ex, dy - ey
        xx = (f0x * q.x0 + f1x * q.x1 + f2x * q.x2 + f3x * q.x3) * inverse
        yy = (f0y * q.y0 + f1y * q.y1 + f2y * q.y2 + f3y * q.y3) * inverse
        xy = 0.5 * (f0x * q.y0 + f1x * q.y1 + f2x * q.y2 + f3x * q.y3 + f0y * q.x0 + f1y * q.x1 + f2y * q.x2 + f3y * q.x3) * inverse
        z.mean.xx[j], z.mean.yy[j], z.mean.xy[j] = xx, yy, xy
        p0x, p0y, p1x, p1y = q.ax * xx + q.ay * xy, q.ax * xy + q.ay * yy, q.bx * xx + q.by * xy, q.bx * xy + q.by * yy
        g = z.g
        g.f0x[j], g.f0y[j], g.f1x[j], g.f1y[j] = f0x - p0x, f0y - p0y, f1x - p1x, f1y - p1y
        g.f2x[j], g.f2y[j], g.f3x[j], g.f3y[j] = f2x + p0x, f2y + p0y, f3x + p1x, f3y + p1y


bind(along_edge)
