"""Where surfaces bound material: normals, and what an edge says of a point near its ends."""

import numba as nb

from hugoniot.core.target import BY_ADDRESS, INLINE
from hugoniot.solvers.lagrange2d.contact import layout as C
from hugoniot.solvers.lagrange2d.contact.impulses import columns, movers
from hugoniot.solvers.lagrange2d.contact.rigid import place

DEEP = 0.05          # of an edge: a point that was deeper behind it at the start of a step did not come through it
FACING = -0.1        # cosine between the outward normals of point and edge
TIP = 0.05           # cosine between a normal and the edges of a tip that points against it
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
def hollow(c, nodes, e, other, at_end):
    """Whether the surface turns inward where the edge `other` goes on at an end of e: material on both sides of the free space there.

    Where it turns right back it is a crevice that has closed, not a needle.
    """
    ax, ay = edge_vector(c, nodes, e)
    bx, by = edge_vector(c, nodes, other)
    turn, onward = ax * by - ay * bx if at_end else bx * ay - by * ax, ax * bx + ay * by
    return turn < -STRAIGHT * (ax * ax + ay * ay) or turn < -AT_CORNER * onward


@nb.njit(**BY_ADDRESS)
def in_front(c, nodes, p, e, dt):
    """How far a point is in front of an edge, over its length, with positions moved by dt times the velocities of movers."""
    (k, i, j), (s, a, b) = columns(c, p, e), movers(c, p, e)
    (x, y), (ax, ay), (bx, by) = place(c, nodes, s, k, dt), place(c, nodes, a, i, dt), place(c, nodes, b, j, dt)
    dx, dy = bx - ax, by - ay
    return ((x - ax) * dy - (y - ay) * dx) / (dx * dx + dy * dy)


@nb.njit(**BY_ADDRESS)
def over_edge(c, nodes, p, e, share, dt):
    """Whether an edge bounds the material at a share of it, for a point behind it.

    Where the surface juts out at the nearer end, the material is behind the other edge too. Where it is hollow, each edge bounds the free
    space beyond the corner for points that may have come through the other one. Where it ends, on the axis or a wall, it goes on a little.
    """
    at_end, on_it = share > 0.5, -EDGE_END <= share <= 1.0 + EDGE_END
    other = beyond(c, e, at_end)
    if other < 0:
        return on_it or (c.edges[e, C.EDGE_ZONE] >= 0 and -DEEP < share < 1.0 + DEEP)
    inward = hollow(c, nodes, e, other, at_end)
    if c.edges[other, C.EDGE_A] == p or c.edges[other, C.EDGE_B] == p:
        return inward and on_it
    if inward:
        return on_it or (-BEYOND < share < 1.0 + BEYOND and in_front(c, nodes, p, other, 0.0) > -AT_CORNER)
    if not on_it:
        return False
    away = in_front(c, nodes, p, other, dt)
    return away <= EDGE_END or (away <= AT_CORNER and in_front(c, nodes, p, e, 0.0) > -AT_CORNER)      # corners that face each other hold


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
    return ax * nx + ay * ny < -TIP and bx * nx + by * ny > TIP
