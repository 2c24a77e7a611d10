"""Where surfaces bound material: normals, and what an edge says of a point near its ends."""

import numba as nb

from hugoniot.core.target import BY_ADDRESS, INLINE
from hugoniot.solvers.lagrange2d.contact import layout as C
from hugoniot.solvers.lagrange2d.contact.impulses import columns, movers
from hugoniot.solvers.lagrange2d.contact.rigid import place

DEEP = 0.05          # of an edge: a point that was deeper behind it at the start of a step did not come through it
FACING = -0.1        # cosine between the outward normals of point and edge
TIP = 0.3            # cosine between a normal and the edges of a tip that does not point along it
BEYOND = 0.5         # of an edge: how far it bounds the free space beyond a hollow corner,
AT_CORNER = 1e-3     # for points that were no deeper than this behind the other edge there
EDGE_END = 1e-6
STRAIGHT = 1e-9      # angle by which a surface turns inward at a hollow corner at least


@nb.njit(**INLINE)
def edge_vector(c, nodes, e):
    """From the start of an edge to its end as nodes stand."""
    a, b = c.points[c.edges[e, C.EDGE_A], C.POINT_NODE], c.points[c.edges[e, C.EDGE_B], C.POINT_NODE]
    return nodes[0, b] - nodes[0, a], nodes[1, b] - nodes[1, a]


@nb.njit(**BY_ADDRESS)
def edge_after(c, nodes, e, dt):
    """The same with positions moved by dt times the velocities of movers."""
    a, b = c.edges[e, C.EDGE_A], c.edges[e, C.EDGE_B]
    ax, ay = place(c, nodes, c.points[a, C.POINT_MOVER], c.points[a, C.POINT_NODE], dt)
    bx, by = place(c, nodes, c.points[b, C.POINT_MOVER], c.points[b, C.POINT_NODE], dt)
    return bx - ax, by - ay


@nb.njit(**BY_ADDRESS)
def edge_way(c, nodes, e):
    """Unit vector along an edge as nodes stand."""
    dx, dy = edge_vector(c, nodes, e)
    length = (dx * dx + dy * dy) ** 0.5
    return (dx / length, dy / length) if length > 0.0 else (0.0, 0.0)


@nb.njit(**BY_ADDRESS)
def point_normal(c, nodes, p):
    """Mean outward normal of the edges at a point, a unit vector unless they are opposite."""
    x, y = 0.0, 0.0
    for column in (C.POINT_BEFORE, C.POINT_AFTER):
        e = c.points[p, column]
        if e >= 0:
            dx, dy = edge_way(c, nodes, e)
            x, y = x + dy, y - dx
    size = (x * x + y * y) ** 0.5
    return (x / size, y / size) if size > 0.0 else (0.0, 0.0)


@nb.njit(**BY_ADDRESS)
def beyond(c, e, at_end):
    """The edge that goes on at an end of an edge; -1 if none does."""
    return c.points[c.edges[e, C.EDGE_B], C.POINT_AFTER] if at_end else c.points[c.edges[e, C.EDGE_A], C.POINT_BEFORE]


@nb.njit(**BY_ADDRESS)
def hollow(c, nodes, e, other, at_end, dt):
    """Whether the surface turns inward where the edge `other` goes on at an end of e: material on both sides of the free space there.

    Where it turns right back it is a crevice that has closed, not a needle. Positions are moved by dt times the velocities of movers.
    """
    ax, ay = edge_after(c, nodes, e, dt)
    bx, by = edge_after(c, nodes, other, dt)
    turn, onward = ax * by - ay * bx if at_end else bx * ay - by * ax, ax * bx + ay * by
    return turn < -STRAIGHT * (ax * ax + ay * ay) or turn < -AT_CORNER * onward


@nb.njit(**BY_ADDRESS)
def from_edge(c, nodes, p, e, dt):
    """(gap, share, length) of a point and an edge, with positions moved by dt times the velocities of movers."""
    (k, i, j), (s, a, b) = columns(c, p, e), movers(c, p, e)
    (x, y), (ax, ay), (bx, by) = place(c, nodes, s, k, dt), place(c, nodes, a, i, dt), place(c, nodes, b, j, dt)
    dx, dy, px, py = bx - ax, by - ay, x - ax, y - ay
    square = dx * dx + dy * dy
    length = square**0.5
    return (px * dy - py * dx) / length, (px * dx + py * dy) / square, length


@nb.njit(**INLINE)
def crosses(before, after, other_before, other_after):
    """Whether a point passes from the front of one line to behind it while it is behind another one, by its gaps to both."""
    return before >= 0.0 and other_before < 0.0 and before * (other_before - other_after) > other_before * (before - after)


@nb.njit(**BY_ADDRESS)
def over_edge(c, nodes, p, e, after, dt, enough):
    """Whether an edge bounds the material for a point behind it.

    after: (gap, share) at the end of the step. enough: (of an edge, m) how far behind an edge a point must be to meet it.

    Where the surface juts out at the nearer end, the material is behind the other edge too; a point may pass right through a thin tip.
    Where it is hollow, each edge bounds the free space beyond the corner for points that come from there. Where it ends, on the axis or a
    wall, it goes on a little.
    """
    behind, share = after
    at_end, on_it = share > 0.5, -EDGE_END <= share <= 1.0 + EDGE_END
    other = beyond(c, e, at_end)
    if other < 0:
        return on_it or (c.edges[e, C.EDGE_ZONE] >= 0 and -DEEP < share < 1.0 + DEEP)
    inward = hollow(c, nodes, e, other, at_end, dt)
    if c.edges[other, C.EDGE_A] == p or c.edges[other, C.EDGE_B] == p:
        return inward and on_it
    if inward and on_it:
        return True
    if not -BEYOND < share < 1.0 + BEYOND:
        return False
    (gap, _, length), (other_gap, _, other_length) = from_edge(c, nodes, p, e, 0.0), from_edge(c, nodes, p, other, 0.0)
    shallow, deep_there = gap > -AT_CORNER * length, other_gap <= -AT_CORNER * other_length
    if inward:
        return shallow and not deep_there
    away, place_there, other_length = from_edge(c, nodes, p, other, dt)
    if away < -max(enough[0] * other_length, enough[1]):
        return on_it or (shallow and deep_there and -EDGE_END <= place_there <= 1.0 + EDGE_END)      # it came through this one
    if on_it and shallow and away <= AT_CORNER * other_length and has_edges(c, p):      # corners that face each other hold
        return True
    return on_it and crosses(gap, behind, other_gap, away)


@nb.njit(**BY_ADDRESS)
def has_edges(c, p):
    """Whether a point belongs to a surface; those that zones have left behind do not."""
    return c.points[p, C.POINT_BEFORE] >= 0 or c.points[p, C.POINT_AFTER] >= 0


@nb.njit(**BY_ADDRESS)
def faces(c, nodes, p, nx, ny):
    """Whether the surface at a point faces against a unit normal: its own mean normal does, or it is a tip whose edges both rise from it.

    A point without edges faces all ways.
    """
    each = True
    for column in (C.POINT_BEFORE, C.POINT_AFTER):
        e = c.points[p, column]
        if e >= 0:
            dx, dy = edge_vector(c, nodes, e)
            along = dy * nx - dx * ny
            each = each and along < 0.0 and along * along >= FACING * FACING * (dx * dx + dy * dy)
    if each:      # then their mean does
        return True
    x, y = point_normal(c, nodes, p)
    if x * nx + y * ny <= FACING:
        return True
    before, after = c.points[p, C.POINT_BEFORE], c.points[p, C.POINT_AFTER]
    if before < 0 or after < 0:
        return False
    ax, ay = edge_way(c, nodes, before)
    bx, by = edge_way(c, nodes, after)
    return ax * by > ay * bx and ax * nx + ay * ny < TIP and bx * nx + by * ny > -TIP
