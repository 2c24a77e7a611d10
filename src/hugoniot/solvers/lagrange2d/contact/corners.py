"""Normals of surfaces, and the side of an edge on which a point near its ends lies."""

import numba as nb

from hugoniot.core.target import BY_ADDRESS, INLINE
from hugoniot.solvers.lagrange2d.contact import layout as C
from hugoniot.solvers.lagrange2d.contact.rigid import X, place

DEEP = 0.05          # of an edge: a point that was deeper behind it at the start of a step did not come through it
FACING = -0.1        # cosine between the outward normals of point and edge
TIP = 0.3            # cosine between a normal and the edges of a tip that does not point along it
BEYOND = 0.5         # of an edge: how far it bounds the free space beyond a hollow corner,
AT_CORNER = 5e-4     # for points that were no deeper than this behind the other edge there
EDGE_END = 1e-6
STRAIGHT = 1e-9      # angle by which a surface turns inward at a hollow corner at least


@nb.njit(**INLINE)
def edge_vector(c, e, t):
    """From the start of an edge to its end after the part t of a step."""
    (ax, ay), (bx, by) = place(c, c.edges[e, C.EDGE_A], t), place(c, c.edges[e, C.EDGE_B], t)
    return bx - ax, by - ay


@nb.njit(**BY_ADDRESS)
def edge_way(c, e, t):
    """Unit vector along an edge after the part t of a step."""
    dx, dy = edge_vector(c, e, t)
    length = (dx * dx + dy * dy) ** 0.5
    return (dx / length, dy / length) if length > 0.0 else (0.0, 0.0)


@nb.njit(**INLINE)
def normal(c, e, t):
    """Outward unit normal of an edge after the part t of a step."""
    dx, dy = edge_way(c, e, t)
    return dy, -dx


@nb.njit(**BY_ADDRESS)
def point_normal(c, p, t):
    """Mean outward normal of the edges at a point after the part t of a step, a unit vector unless they are opposite."""
    x, y = 0.0, 0.0
    for column in (C.POINT_BEFORE, C.POINT_AFTER):
        e = c.points[p, column]
        if e >= 0:
            dx, dy = edge_way(c, e, t)
            x, y = x + dy, y - dx
    size = (x * x + y * y) ** 0.5
    return (x / size, y / size) if size > 0.0 else (0.0, 0.0)


@nb.njit(**INLINE)
def beyond(c, e, at_end):
    """The edge that goes on at an end of an edge; -1 if none does."""
    return c.points[c.edges[e, C.EDGE_B], C.POINT_AFTER] if at_end else c.points[c.edges[e, C.EDGE_A], C.POINT_BEFORE]


@nb.njit(**INLINE)
def hollow(c, e, other, at_end):
    """Whether the surface at the end of a step turns inward where the edge `other` goes on at an end of e: material on both sides of the
    free space there.

    Where it turns right back it is a crevice that has closed, not a needle.
    """
    (ax, ay), (bx, by) = edge_vector(c, e, 1.0), edge_vector(c, other, 1.0)
    turn, onward = ax * by - ay * bx if at_end else bx * ay - by * ax, ax * bx + ay * by
    return turn < -STRAIGHT * (ax * ax + ay * ay) or turn < -AT_CORNER * onward


@nb.njit(**INLINE)
def from_edge(c, p, a, b, t):
    """(gap, share of the way from point a to point b, length) of a point p and the edge between a and b after the part t of a step."""
    (x, y), (ax, ay), (bx, by) = place(c, p, t), place(c, a, t), place(c, b, t)
    dx, dy, px, py = bx - ax, by - ay, x - ax, y - ay
    square = dx * dx + dy * dy
    length = square**0.5
    return (px * dy - py * dx) / length, (px * dx + py * dy) / square, length


@nb.njit(**INLINE)
def crosses(before, after, other_before, other_after):
    """Whether a point passes from the front of one line to behind it while it is behind another one, by its gaps to both."""
    return before >= 0.0 and other_before < 0.0 and before * (other_before - other_after) > other_before * (before - after)


@nb.njit(**INLINE)
def over_edge(c, p, e, before, after, enough):
    """Whether an edge bounds the material for a point behind it.

    before: (gap, share, length of the edge) at the start of the step. after: (gap, share) at its end. enough: (of an edge, m) how far
    behind an edge a point must be to meet it.

    Where the surface juts out at the nearer end, the material is behind the other edge too; a point may pass right through a thin tip. One
    that touches the edge and slides off its end is held to the end of the step, and so is one whose surface does not face the other edge.
    Where it is hollow, each edge bounds the free space beyond the corner for points that come from there. Where it ends, on the axis or a
    wall, it goes on a little.
    """
    (gap, started, length), (behind, share) = before, after
    at_end, on_it = share > 0.5, -EDGE_END <= share <= 1.0 + EDGE_END
    other = beyond(c, e, at_end)
    if other < 0:
        return on_it or (c.edges[e, C.EDGE_ZONE] >= 0 and -DEEP < share < 1.0 + DEEP)
    a, b = c.edges[other, C.EDGE_A], c.edges[other, C.EDGE_B]
    inward = hollow(c, e, other, at_end)
    if a == p or b == p:      # it folds onto this edge if it was in front, unless it is the tip of a needle
        return on_it and (inward or gap >= 0.0)
    if inward and on_it:
        return True
    if not -BEYOND < share < 1.0 + BEYOND:
        return False
    if on_it:      # and the corner juts out
        away, _, other_length = from_edge(c, p, a, b, 1.0)
        if away < -max(enough[0] * other_length, enough[1]):
            return True
        if gap > -AT_CORNER * length and away <= AT_CORNER * other_length and has_edges(c, p):      # corners that face each other hold
            return True
        other_gap, _, _ = from_edge(c, p, a, b, 0.0)
        return crosses(gap, behind, other_gap, away)
    shallow = gap > -AT_CORNER * length
    if inward and not shallow:
        return False
    other_gap, _, other_length = from_edge(c, p, a, b, 0.0)
    deep_there = other_gap <= -AT_CORNER * other_length
    if inward and deep_there:
        return False
    away, place_there, other_length = from_edge(c, p, a, b, 1.0)
    on_other = -EDGE_END <= place_there <= 1.0 + EDGE_END
    if inward:      # the other edge is in front of this one there: a point that comes no deeper behind it is held by it
        return not (on_other and away <= behind)
    if not on_other or away >= -max(enough[0] * other_length, enough[1]):      # it has slid off
        return shallow and gap <= AT_CORNER * length and -AT_CORNER <= started <= 1.0 + AT_CORNER and has_edges(c, p)
    return (shallow and deep_there) or not faces(c, p, *normal(c, other, 0.0))      # it came through this one, or the other cannot hold it


@nb.njit(**BY_ADDRESS)
def through_sheet(c, p, e):
    """Whether an edge has a point behind it because that is on the other side of a thin sheet: nearer to the other side of the zone there,
    or with its own zones behind the edge too.

    Of a point that has gone into another surface they are still in front, however little of them. Places are those at the start of a step.
    """
    (px, py), (ax, ay), (dx, dy), found = place(c, p, 0.0), place(c, c.edges[e, C.EDGE_A], 0.0), edge_vector(c, e, 0.0), False
    if c.edges[e, C.EDGE_ZONE] >= 0:
        first, second = c.edges[e, C.EDGE_ACROSS_1], c.edges[e, C.EDGE_ACROSS_2]
        x, y = c.nodes[X, first], c.nodes[X + 1, first]
        u, v = c.nodes[X, second] - x, c.nodes[X + 1, second] - y
        depth, from_there = (py - ay) * dx - (px - ax) * dy, (py - y) * u - (px - x) * v
        if from_there < 0.0 or from_there * from_there * (dx * dx + dy * dy) < depth * depth * (u * u + v * v):
            return True
    for column in (C.POINT_BEFORE, C.POINT_AFTER):
        own = c.points[p, column]
        if own >= 0:
            if c.edges[own, C.EDGE_ZONE] < 0:
                return False
            (x, y), (u, v) = place(c, c.edges[own, C.EDGE_A], 0.0), place(c, c.edges[own, C.EDGE_B], 0.0)
            first, second = c.edges[own, C.EDGE_ACROSS_1], c.edges[own, C.EDGE_ACROSS_2]
            x, y = 0.25 * (x + u + c.nodes[X, first] + c.nodes[X, second]), 0.25 * (y + v + c.nodes[X + 1, first] + c.nodes[X + 1, second])
            if (x - ax) * dy - (y - ay) * dx >= 0.0:
                return False
            found = True
    return found


@nb.njit(**INLINE)
def has_edges(c, p):
    """Whether a point belongs to a surface; those that zones have left behind do not."""
    return c.points[p, C.POINT_BEFORE] >= 0 or c.points[p, C.POINT_AFTER] >= 0


@nb.njit(**INLINE)
def faces(c, p, nx, ny):
    """Whether the surface at a point faces against a unit normal: its own mean normal does, or it is a tip whose edges both rise from it.

    Places are those at the start of a step. A point without edges faces all ways.
    """
    each = True
    for column in (C.POINT_BEFORE, C.POINT_AFTER):
        e = c.points[p, column]
        if e >= 0:
            dx, dy = edge_vector(c, e, 0.0)
            along = dy * nx - dx * ny
            each = each and along < 0.0 and along * along >= FACING * FACING * (dx * dx + dy * dy)
    if each:      # then their mean does
        return True
    x, y = point_normal(c, p, 0.0)
    if x * nx + y * ny <= FACING:
        return True
    before, after = c.points[p, C.POINT_BEFORE], c.points[p, C.POINT_AFTER]
    if before < 0 or after < 0:
        return False
    ax, ay = edge_way(c, before, 0.0)
    bx, by = edge_way(c, after, 0.0)
    return ax * by > ay * bx and ax * nx + ay * ny < TIP and bx * nx + by * ny > -TIP
