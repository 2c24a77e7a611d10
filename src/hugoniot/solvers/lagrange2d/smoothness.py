r"""Smoothness of the velocity field in each zone along its two logical directions, used by the limiter of a viscosity.

With $g$ the velocity difference across a zone per length, a vector, and $g_l$, $g_r$ those of the neighbours on either side,

$$\psi = \max(0, \min(1, \tfrac12(r_l + r_r), 2 r_l, 2 r_r)),\qquad r = g_{l,r}\cdot g / g^2 :$$

which is 1 in a linear field and 0 at a shock or an extremum, or where the differences are only round-off. Vectors are compared, not
components, so that a rotation of the frame changes nothing. Beyond a joint are the zones of the other block, behind a wall the mirror
image; at other edges of a block the field is continued from inside.

The vectors are stored in a table with a layer of ghost cells around each block, which `fill_ghosts` fills.

Caramana, Shashkov & Whalen, J. Comput. Phys. 144 (1998) 70, equations 10 to 14.
"""

from typing import Any, NamedTuple

import numba as nb

from hugoniot.core.binder import bind
from hugoniot.core.ops import fmax, fmin, vsqrt
from hugoniot.core.passes import rows, rows_apart, zone_pass
from hugoniot.core.target import BY_ADDRESS
from hugoniot.solvers.lagrange2d.closing import STRETCH
from hugoniot.solvers.lagrange2d.layout import Nodes, Points, Smoothness, Vector

SMALL = 1e-60
GHOST, OWN, DIRECTION, NODE_A, NODE_B, FAR_A, FAR_B, FAR = range(8)     # integer columns of the table of ghosts
NORMAL_X, NORMAL_Y, WAY = range(3)                                 # and columns of numbers


class Gradients(NamedTuple):
    """Velocity differences per length along the second (xi) and the first (eta) logical direction."""

    xix: Any
    xiy: Any
    etax: Any
    etay: Any


CARRIED = len(Gradients._fields)      # first row of what `heat_flux` carries through joints


class GradientsOf(NamedTuple):
    """Two rows of nodes -> velocity differences of the zones between them."""

    low: Points
    high: Points
    g: Gradients


class ComparedOf(NamedTuple):
    """Two rows of nodes, differences of the zones between them, of their neighbours in the row, and in the rows on both sides, stretches in
    which something closes (`closing`) -> psi and strain rates."""

    low: Points
    high: Points
    g: Gradients
    left: Vector
    right: Vector
    before: Vector
    behind: Vector
    closes: Any
    smooth: Smoothness


@zone_pass(GradientsOf)
def gradients(count, z, dt, numbers, law):
    """Velocity differences per length along the rows of nodes and from one to the next."""
    rows_apart()
    low, high, g = z.low, z.high, z.g
    for j in range(count):
        ax, ay = low.x[j + 1] - low.x[j] + high.x[j + 1] - high.x[j], low.y[j + 1] - low.y[j] + high.y[j + 1] - high.y[j]
        bx, by = high.x[j] - low.x[j] + high.x[j + 1] - low.x[j + 1], high.y[j] - low.y[j] + high.y[j + 1] - low.y[j + 1]
        a, b = vsqrt(ax * ax + ay * ay), vsqrt(bx * bx + by * by)
        inverse = 1.0 / (a * b)      # one division does for both
        over_a, over_b = b * inverse, a * inverse
        g.xix[j] = (low.u[j + 1] - low.u[j] + high.u[j + 1] - high.u[j]) * over_a
        g.xiy[j] = (low.v[j + 1] - low.v[j] + high.v[j + 1] - high.v[j]) * over_a
        g.etax[j] = (high.u[j] - low.u[j] + high.u[j + 1] - low.u[j + 1]) * over_b
        g.etay[j] = (high.v[j] - low.v[j] + high.v[j + 1] - low.v[j + 1]) * over_b


def smooth(lx, ly, gx, gy, rx, ry):
    """psi from the vectors of the left neighbour, the zone and the right neighbour."""
    inverse = 1.0 / (gx * gx + gy * gy + SMALL)
    before, behind = (lx * gx + ly * gy) * inverse, (rx * gx + ry * gy) * inverse
    return fmax(0.0, fmin(fmin(0.5 * (before + behind), 1.0), 2.0 * fmin(before, behind)))


def compare_zone(z, j):
    """Write psi along both directions, and strain rates in the plane, of zone j."""
    low, high, g, found = z.low, z.high, z.g, z.smooth
    ax, ay, bx, by = high.x[j + 1] - low.x[j], high.y[j + 1] - low.y[j], low.x[j + 1] - high.x[j], low.y[j + 1] - high.y[j]
    au, av, bu, bv = high.u[j + 1] - low.u[j], high.v[j + 1] - low.v[j], low.u[j + 1] - high.u[j], low.v[j + 1] - high.v[j]
    inverse = 1.0 / (ax * by - ay * bx)
    found.xx[j] = (au * by - bu * ay) * inverse
    found.yy[j] = (ax * bv - bx * av) * inverse
    found.xy[j] = 0.5 * (ax * bu - bx * au + av * by - bv * ay) * inverse
    xx, xy, ex, ey = g.xix[j], g.xiy[j], g.etax[j], g.etay[j]
    share = (xx * xx + xy * xy) / (xx * xx + xy * xy + ex * ex + ey * ey + SMALL)
    found.xi[j] = smooth(z.left.x[j], z.left.y[j], xx, xy, z.right.x[j], z.right.y[j]) * share
    found.eta[j] = smooth(z.before.x[j], z.before.y[j], ex, ey, z.behind.x[j], z.behind.y[j]) * (1.0 - share)
    found.share[j] = share


bind(smooth)
bind(compare_zone)


@zone_pass(ComparedOf)
def compare(count, z, dt, numbers, law):
    """psi along both directions, and strain rates in the plane at the start of the step, where something closes."""
    rows_apart()
    first = 0
    while first < count:
        end = min(first + STRETCH, count)
        if z.closes[first] > 0.0:
            for j in range(first, end):
                compare_zone(z, j)
        first = end


@nb.njit(**BY_ADDRESS)
def fill_ghosts(table, nodes, ghosts, numbers):
    """Fill the cells around the blocks: from beyond a joint, as the mirror image behind a wall, or like the zone inside."""
    n = rows(Nodes, nodes, 0)
    for i in range(ghosts.shape[0]):
        row, ghost, own, c, d = ghosts[i, DIRECTION], ghosts[i, GHOST], ghosts[i, OWN], ghosts[i, FAR_A], ghosts[i, FAR_B]
        x, y, nx, ny = table[row, own], table[row + 1, own], numbers[i, NORMAL_X], numbers[i, NORMAL_Y]
        if c >= 0:
            a, b = ghosts[i, NODE_A], ghosts[i, NODE_B]
            ex, ey = n.x[c] + n.x[d] - n.x[a] - n.x[b], n.y[c] + n.y[d] - n.y[a] - n.y[b]
            inverse = numbers[i, WAY] / (ex * ex + ey * ey) ** 0.5
            x, y = (n.u[c] + n.u[d] - n.u[a] - n.u[b]) * inverse, (n.v[c] + n.v[d] - n.v[a] - n.v[b]) * inverse
        elif nx != 0.0 or ny != 0.0:
            along = 2.0 * (x * nx + y * ny)
            x, y = along * nx - x, along * ny - y
        table[row, ghost], table[row + 1, ghost] = x, y
        far = ghosts[i, FAR]
        for k in range(CARRIED, table.shape[0]):
            table[k, ghost] = table[k, far] if far >= 0 else 0.0
