r"""How smooth the velocity field is in each zone, along its two logical directions: what the limiter of a viscosity looks at.

With $g$ the velocity difference across a zone per length, a vector, and $g_l$, $g_r$ those of the neighbours on either side,

$$\psi = \max(0, \min(1, \tfrac12(r_l + r_r), 2 r_l, 2 r_r)),\qquad r = g_{l,r}\cdot g / g^2 :$$

1 in a linear field, 0 at a shock or an extremum, and where there is nothing but round-off to compare. Vectors are compared, not
components, so that turning the frame changes nothing. Behind a wall stands the mirror image; at other edges of a block the field goes on
as inside.

Caramana, Shashkov & Whalen, J. Comput. Phys. 144 (1998) 70, equations 10 to 14.
"""

from typing import Any, NamedTuple

from hugoniot.core.ops import fmax, fmin, vsqrt
from hugoniot.core.passes import rows_apart
from hugoniot.solvers.lagrange2d.layout import Points, Smoothness, Vector
from hugoniot.solvers.lagrange2d.row_pass import row_pass

SMALL = 1e-200
NOISE = 1e-12     # part of the whole gradient, squared, beside which one direction's has no neighbours to compare with




class GradientOf(NamedTuple):
    """Two rows of nodes -> velocity differences per length."""

    low: Points
    high: Points
    g: Vector


class Compared(NamedTuple):
    """Differences of the neighbours, of the zones themselves, and of these along the other direction -> psi."""

    left: Vector
    middle: Vector
    right: Vector
    other: Vector
    psi: Any


class RatesNow(NamedTuple):
    """Two rows of nodes -> strain rates."""

    low: Points
    high: Points
    smooth: Smoothness



@row_pass(GradientOf)
def gradient_along(count, given, dt, numbers, law):
    """Velocity difference per length along the rows of nodes, for a row of zones."""
    rows_apart()
    low, high, g = given
    for j in range(count):
        ex = low.x[j + 1] - low.x[j] + high.x[j + 1] - high.x[j]
        ey = low.y[j + 1] - low.y[j] + high.y[j + 1] - high.y[j]
        inverse = 1.0 / vsqrt(ex * ex + ey * ey)
        g.x[j] = (low.u[j + 1] - low.u[j] + high.u[j + 1] - high.u[j]) * inverse
        g.y[j] = (low.v[j + 1] - low.v[j] + high.v[j + 1] - high.v[j]) * inverse


@row_pass(GradientOf)
def gradient_across(count, given, dt, numbers, law):
    """Velocity difference per length from one row of nodes to the next."""
    rows_apart()
    low, high, g = given
    for j in range(count):
        ex = high.x[j] - low.x[j] + high.x[j + 1] - low.x[j + 1]
        ey = high.y[j] - low.y[j] + high.y[j + 1] - low.y[j + 1]
        inverse = 1.0 / vsqrt(ex * ex + ey * ey)
        g.x[j] = (high.u[j] - low.u[j] + high.u[j + 1] - low.u[j + 1]) * inverse
        g.y[j] = (high.v[j] - low.v[j] + high.v[j + 1] - low.v[j + 1]) * inverse


@row_pass(Compared)
def compare(count, given, dt, numbers, law):
    """psi of a row of zones from the vectors g of the zones and of their neighbours."""
    rows_apart()
    left, middle, right, other, psi = given
    for j in range(count):
        gx, gy = middle.x[j], middle.y[j]
        size = gx * gx + gy * gy
        inverse = 1.0 / (size + NOISE * (size + other.x[j] * other.x[j] + other.y[j] * other.y[j]) + SMALL)
        l = (left.x[j] * gx + left.y[j] * gy) * inverse
        r = (right.x[j] * gx + right.y[j] * gy) * inverse
        psi[j] = fmax(0.0, fmin(fmin(0.5 * (l + r), 1.0), 2.0 * fmin(l, r)))


@row_pass(RatesNow)
def rates_now(count, given, dt, numbers, law):
    """Strain rates in the plane at the start of the step, of a row of zones."""
    rows_apart()
    low, high, smooth = given
    for j in range(count):
        ax, ay = high.x[j + 1] - low.x[j], high.y[j + 1] - low.y[j]
        bx, by = low.x[j + 1] - high.x[j], low.y[j + 1] - high.y[j]
        au, av = high.u[j + 1] - low.u[j], high.v[j + 1] - low.v[j]
        bu, bv = low.u[j + 1] - high.u[j], low.v[j + 1] - high.v[j]
        inverse = 1.0 / (ax * by - ay * bx)
        smooth.xx[j] = (au * by - bu * ay) * inverse
        smooth.yy[j] = (ax * bv - bx * av) * inverse
        smooth.xy[j] = 0.5 * (ax * bu - bx * au + av * by - bv * ay) * inverse
