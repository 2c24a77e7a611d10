r"""Artificial heat flux: spreads the excess heat that a shock leaves where it starts, is reflected or converges (wall heating).

The heat flux through the face A between two zones of a gas is

$$\Phi = h\,A\,\frac{\min(q_L,q_R)}{\max(w_L + c_L/3,\; w_R + c_R/3)}\,(e_L - e_R),$$

with the trace q of the viscous stress and the viscous speed w of the previous step: q/w is the density times the velocity jump of a closing
zone, or less where the limiter acts. With the sound speed c the flux is proportional to weak motions. The smaller q is used, so that no
heat flows from the hot gas behind a shock into the shock, which would lower the peak of a blast wave. What leaves one zone enters the next.
Beyond faces at the edge of a block lies a cell without q, so that nothing flows there, except at joints where the same material starts in
the same state on both sides (`smoothness.fill_ghosts`).

Noh, J. Comput. Phys. 72 (1987) 78, section on artificial heat conduction.
"""

from typing import Any, NamedTuple

from hugoniot.core.binder import bind, bind_choice
from hugoniot.core.ops import fmax, fmin, vsqrt
from hugoniot.core.passes import kind_of, rows_apart, zone_pass
from hugoniot.solvers.lagrange2d.layout import Positions
from hugoniot.solvers.lagrange2d.quads import Planar

SMALL = 1e-60
WARM = 1.0 / 3.0


class Carried(NamedTuple):
    """Energy, trace of the viscous stress, w + c/3."""

    e: Any
    q: Any
    speed: Any


class CarryOf(NamedTuple):
    """State at the start of the step -> the table with cells around the blocks."""

    e: Any
    q: Any
    viscous_speed: Any
    c: Any
    cells: Carried


class ConductOf(NamedTuple):
    """Nodes in the middle of the step, cells of the zones and of their neighbours, inverse mass; e is advanced."""

    low: Positions
    high: Positions
    here: Carried
    left: Carried
    right: Carried
    before: Carried
    behind: Carried
    inverse_mass: Any
    e: Any


@zone_pass(CarryOf)
def carry(count, z, dt, numbers, law):
    """What neighbours see of a zone."""
    rows_apart()
    for j in range(count):
        z.cells.e[j] = z.e[j]
        z.cells.q[j] = fmax(z.q[j], 0.0)
        z.cells.speed[j] = z.viscous_speed[j] + WARM * fmax(z.c[j], 0.0)


def in_plane(x1, x2, geometry):
    """Width of a face across the plane: one metre."""
    return 1.0


def around_axis(x1, x2, geometry):
    """Width of a face across the plane, for a radian."""
    return 0.5 * (x1 + x2)


def width(x1, x2, geometry):
    """Width across the plane of the face between two nodes."""
    return (in_plane, around_axis, around_axis)[int(geometry.code)](x1, x2, geometry)


def through(x1, y1, x2, y2, own, other, j, geometry):
    """Heat per time and unit of the coefficient that enters zone j of `own` through the face between two nodes from that of `other`."""
    x, y = x2 - x1, y2 - y1
    carried = fmin(own.q[j], other.q[j]) / (fmax(own.speed[j], other.speed[j]) + SMALL)
    return vsqrt(x * x + y * y) * width(x1, x2, geometry) * carried * (other.e[j] - own.e[j])


@zone_pass(ConductOf)
def conduct(count, z, dt, numbers, law):
    """Heat through the four faces of zones; numbers: the coefficient h."""
    rows_apart()
    geometry, low, high, here = kind_of(law), z.low, z.high, z.here
    for j in range(count):
        along = through(low.x[j], low.y[j], high.x[j], high.y[j], here, z.left, j, geometry)
        along += through(low.x[j + 1], low.y[j + 1], high.x[j + 1], high.y[j + 1], here, z.right, j, geometry)
        across = through(low.x[j], low.y[j], low.x[j + 1], low.y[j + 1], here, z.before, j, geometry)
        across += through(high.x[j], high.y[j], high.x[j + 1], high.y[j + 1], here, z.behind, j, geometry)
        z.e[j] += dt * numbers[0] * z.inverse_mass[j] * (along + across)


bind_choice(width, lambda *classes: in_plane if classes[-1] is Planar else around_axis)
bind(through)
