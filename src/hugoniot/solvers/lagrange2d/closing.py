"""Where zones close: the passes of the tensor viscosity skip groups of zones in a row in which no corner closes.

Skipping never changes a result: nothing closes in such a group, so its viscous stress is zero.
"""

from typing import Any, NamedTuple

from hugoniot.core.binder import bind
from hugoniot.core.ops import fmax
from hugoniot.core.passes import rows_apart, zone_pass
from hugoniot.solvers.lagrange2d.layout import Points

STRETCH = 16            # zones of a piece that are looked at together
HEAD = 8                # of these the first that are looked at
NOTHING = 1e-15        # part of a position that is lost in its digits
ALIKE = NOTHING / 16.0      # and part of the sound speed by which velocities may differ so that no corner closes by more than that


class ClosingOf(NamedTuple):
    """Nodes in the middle, sound speed -> at the first zone of every stretch, whether something closes in it (1, else 0)."""

    low: Points
    high: Points
    c: Any
    closes: Any


def closes(e1x, e1y, e2x, e2y, u1, v1, u2, v2):
    """Positive where a principal direction of a corner closes: about the square of its rate times the doubled area."""
    gxx, gyy, gxy = u1 * e2y - u2 * e1y, v2 * e1x - v1 * e2x, u2 * e1x - u1 * e2x + v1 * e2y - v2 * e1y
    total, difference = gxx + gyy, gxx - gyy
    return difference * difference + gxy * gxy - total * fmax(total, -total)


def closing(z, j):
    """Positive where a corner of zone j closes by more, in the time sound takes across the zone, than the last digits of its position."""
    low, high = z.low, z.high
    x0, y0, x1, y1 = low.x[j], low.y[j], high.x[j], high.y[j]
    x2, y2, x3, y3 = high.x[j + 1], high.y[j + 1], low.x[j + 1], low.y[j + 1]
    au, av, bu, bv = high.u[j] - low.u[j], high.v[j] - low.v[j], high.u[j + 1] - high.u[j], high.v[j + 1] - high.v[j]
    cu, cv, du, dv = low.u[j + 1] - high.u[j + 1], low.v[j + 1] - high.v[j + 1], low.u[j] - low.u[j + 1], low.v[j] - low.v[j + 1]
    ax, ay, bx, by, cx, cy, dx, dy = x1 - x0, y1 - y0, x2 - x1, y2 - y1, x3 - x2, y3 - y2, x0 - x3, y0 - y3
    most = fmax(closes(ax, ay, -dx, -dy, au, av, -du, -dv), closes(bx, by, -ax, -ay, bu, bv, -au, -av))
    most = fmax(most, fmax(closes(cx, cy, -bx, -by, cu, cv, -bu, -bv), closes(dx, dy, -cx, -cy, du, dv, -cu, -cv)))
    c = NOTHING * z.c[j]
    return most - c * c * (x0 * x0 + y0 * y0 + x2 * x2 + y2 * y2)


def unlike(line, j, u, v):
    """By how much the velocity of node j of a row differs from (u, v)."""
    x, y = line.u[j] - u, line.v[j] - v
    return fmax(fmax(x, -x), fmax(y, -y))


def most_closing(z, first, end):
    """The largest of what `closing` finds in zones first to end - 1; 0 if there is none that closes."""
    most = 0.0
    for j in range(first, end):
        most = fmax(most, closing(z, j))
    return most


def alike(z, first, end):
    """Whether all nodes of zones first to end - 1 move alike, so that nothing can close; most often the last ones say that they do not."""
    u, v, limit = z.low.u[first], z.low.v[first], ALIKE * z.c[first]
    differ = fmax(unlike(z.low, end, u, v), unlike(z.high, end, u, v))
    if differ <= limit:
        for j in range(first, end):
            differ = fmax(differ, fmax(unlike(z.low, j, u, v), unlike(z.high, j, u, v)))
    return differ <= limit


@zone_pass(ClosingOf)
def find_closing(count, z, dt, numbers, law):
    """Which stretches of zones the viscosity counts in: ahead of waves nodes move alike, behind them the first zones show it."""
    rows_apart()
    first = 0
    while first < count:
        end = min(first + STRETCH, count)
        head, most = min(first + HEAD, end), 0.0
        if not alike(z, first, end):
            most = most_closing(z, first, head)
            if most == 0.0:
                most = most_closing(z, head, end)
        z.closes[first] = 1.0 if most > 0.0 else 0.0
        first = end


for _function in (closes, closing, unlike, most_closing, alike):
    bind(_function)
