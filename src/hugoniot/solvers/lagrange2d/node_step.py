"""Rows of nodes in a step: forces gathered from their zones, motion, and its effect on the zones between them.

The nodes of a block are first moved by the forces of their own zones; special nodes are then recomputed (`special_nodes`).
"""

from typing import Any, NamedTuple

from hugoniot.core.binder import bind, bind_choice
from hugoniot.core.passes import rows_apart, zone_pass
from hugoniot.solvers.lagrange2d import layout as L

LEAST_LEFT = 0.8     # of the area in the middle of a step; a step takes no more than a third of a zone's area


# -- rows of nodes ----------------------------------------------------------------------------------------------------------------
class Behind(NamedTuple):
    """Forces of the row of zones behind a row of nodes on it: on corner 0 of the zone on one side, 3 of that on the other."""

    f0: L.Vector
    f3: L.Vector


class Before(NamedTuple):
    """Forces of the row of zones before it."""

    f1: L.Vector
    f2: L.Vector


class OfPairs(NamedTuple):
    """Forces of a row of cells of two triangles on one of the rows of nodes beside it, in place of `Behind` or `Before`.

    lower, upper            of the lower triangles on the corner 0 or 1 of their cells, of the upper ones on 3 or 2
    lower_third, upper_third   of both on their third corners
    starts, ends            1 where the upper triangle's third corner is the one `lower` acts on, the lower one's the one `upper` acts on
    """

    lower: L.Vector
    upper: L.Vector
    lower_third: L.Vector
    upper_third: L.Vector
    starts: Any
    ends: Any


class MeanOf(NamedTuple):
    """Corner forces in the middle of the step, velocity at its start -> whole force, mean velocity."""

    behind: Behind
    before: Before
    u: Any
    v: Any
    im: Any
    force: L.Vector
    um: Any
    vm: Any


class DriftOf(NamedTuple):
    """Motion at the start, half of the change of velocity in the previous step -> velocity and position in the middle of the step."""

    x: Any
    y: Any
    u: Any
    v: Any
    um: Any
    vm: Any
    du: Any
    dv: Any
    xh: Any
    yh: Any


class MoveOf(NamedTuple):
    """Motion at the start and mean velocity -> motion at the end, half of the change of velocity."""

    x: Any
    y: Any
    u: Any
    v: Any
    um: Any
    vm: Any
    du: Any
    dv: Any


def gather(count, behind, before, force):
    """Forces on a row of nodes."""
    choose(type(behind))(count, behind, before, force)


def gather_of_quads(count, behind, before, force):
    f0, f3, f1, f2, last = behind.f0, behind.f3, before.f1, before.f2, count - 1
    force.x[0], force.y[0] = f0.x[0] + f1.x[0], f0.y[0] + f1.y[0]
    for j in range(1, last):
        force.x[j] = f0.x[j] + f3.x[j - 1] + (f1.x[j] + f2.x[j - 1])
        force.y[j] = f0.y[j] + f3.y[j - 1] + (f1.y[j] + f2.y[j - 1])
    force.x[last], force.y[last] = f3.x[last - 1] + f2.x[last - 1], f3.y[last - 1] + f2.y[last - 1]


def start_of(f, j):
    """Force of the cell j on its first corner on a row of nodes."""
    return f.lower.x[j] + f.starts[j] * f.upper_third.x[j], f.lower.y[j] + f.starts[j] * f.upper_third.y[j]


def end_of(f, j):
    """Force of the cell j on its second corner on a row of nodes."""
    return f.upper.x[j] + f.ends[j] * f.lower_third.x[j], f.upper.y[j] + f.ends[j] * f.lower_third.y[j]


def gather_of_triangles(count, behind, before, force):
    last = count - 1
    (ax, ay), (bx, by) = start_of(behind, 0), start_of(before, 0)
    force.x[0], force.y[0] = ax + bx, ay + by
    for j in range(1, last):
        (ax, ay), (bx, by), (cx, cy), (dx, dy) = start_of(behind, j), start_of(before, j), end_of(behind, j - 1), end_of(before, j - 1)
        force.x[j], force.y[j] = ax + cx + (bx + dx), ay + cy + (by + dy)
    (cx, cy), (dx, dy) = end_of(behind, last - 1), end_of(before, last - 1)
    force.x[last], force.y[last] = cx + dx, cy + dy


def choose(*classes):
    return gather_of_triangles if OfPairs in classes else gather_of_quads


bind_choice(gather, choose)
for _function in (gather_of_quads, gather_of_triangles, start_of, end_of):
    bind(_function)


@zone_pass(DriftOf)
def drift(count, n, dt, numbers, law):
    """To the middle of the step: positions by the velocities at its start, and those extrapolated by the acceleration of the previous step.

    dt is half the step, numbers[0] its ratio to the one before.
    """
    rows_apart()
    ahead = numbers[0]
    for j in range(count):
        u, v = n.u[j], n.v[j]
        n.um[j], n.vm[j] = u + ahead * n.du[j], v + ahead * n.dv[j]
        n.xh[j], n.yh[j] = n.x[j] + dt * u, n.y[j] + dt * v


@zone_pass(MeanOf)
def mean_motion(count, n, dt, numbers, law):
    """Forces in the middle of the step, and the mean velocity they give."""
    rows_apart()
    gather(count, n.behind, n.before, n.force)
    half, gx, gy = 0.5 * dt, numbers[0], numbers[1]
    for j in range(count):
        n.um[j] = n.u[j] + half * (n.force.x[j] * n.im[j] + gx)
        n.vm[j] = n.v[j] + half * (n.force.y[j] * n.im[j] + gy)


@zone_pass(MoveOf)
def move(count, n, dt, numbers, law):
    """To the end of the step; a negative dt takes it back."""
    rows_apart()
    for j in range(count):
        um, vm = n.um[j], n.vm[j]
        n.x[j] += dt * um
        n.y[j] += dt * vm
        n.du[j], n.dv[j] = um - n.u[j], vm - n.v[j]
        n.u[j] = 2.0 * um - n.u[j]
        n.v[j] = 2.0 * vm - n.v[j]


class LookOf(NamedTuple):
    """Rows of nodes at the end and in the middle of the step -> how many zones are tangled."""

    low: L.Positions
    high: L.Positions
    middle_low: L.Positions
    middle_high: L.Positions
    tangled: Any


def doubled_area(j, low, high):
    """Twice the area of zone j between two rows of nodes."""
    return (high.x[j + 1] - low.x[j]) * (low.y[j + 1] - high.y[j]) - (high.y[j + 1] - low.y[j]) * (low.x[j + 1] - high.x[j])


bind(doubled_area)


@zone_pass(LookOf, exact=True)
def look(count, z, dt, numbers, law):
    """How many zones of a row the step has turned inside out, or has robbed of so much of their area that it was too long."""
    rows_apart()
    bad = 0
    for j in range(count):
        middle, area = doubled_area(j, z.middle_low, z.middle_high), doubled_area(j, z.low, z.high)
        bad += 0 if (area > LEAST_LEFT * middle) & (area > 0.0) else 1     # whole numbers: a sum of others is taken one by one here
    z.tangled[0] += bad
