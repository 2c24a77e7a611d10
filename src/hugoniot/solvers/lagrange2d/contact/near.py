"""Which of the pairs listed may meet in a step, and which movers that concerns; all other pairs and movers are left out of it.

A pair that was found to be `away` apart cannot meet until points have moved that far relative to each other.
"""

import numba as nb

from hugoniot.core.target import BY_ADDRESS, INLINE
from hugoniot.solvers.lagrange2d.contact import layout as C
from hugoniot.solvers.lagrange2d.contact.corners import BEYOND, DEEP, beyond


@nb.njit(**INLINE)
def distance(x, y, ax, ay, bx, by, onward):
    """Distance from a point to the stretch from a to b, which goes on at both ends by `onward` of its length; that length."""
    dx, dy = bx - ax, by - ay
    square = dx * dx + dy * dy
    t = ((x - ax) * dx + (y - ay) * dy) / square if square > 0.0 else 0.0
    t = min(max(t, -onward), 1.0 + onward)
    return ((x - ax - t * dx) ** 2 + (y - ay - t * dy) ** 2) ** 0.5, square**0.5


@nb.njit(**INLINE)
def include(c, m):
    """List a mover."""
    if c.movers[m, C.MOVER_LISTED] == 0:
        c.movers[m, C.MOVER_LISTED] = 1
        c.listed[c.sizes[C.LISTED]] = m
        c.sizes[C.LISTED] += 1


@nb.njit(**BY_ADDRESS)
def strike_off(c):
    """List no movers; those that were have no impulse."""
    for i in range(c.sizes[C.LISTED]):
        m = c.listed[i]
        q, c.movers[m, C.MOVER_LISTED] = c.mover_numbers[m], 0
        q[C.JX], q[C.JY], q[C.JW] = 0.0, 0.0, 0.0
    c.sizes[C.LISTED] = 0


@nb.njit(**INLINE)
def include_edge(c, e):
    """List the movers of an edge and of those beside it, on which it depends what a corner bounds."""
    include(c, c.points[c.edges[e, C.EDGE_A], C.POINT_MOVER])
    include(c, c.points[c.edges[e, C.EDGE_B], C.POINT_MOVER])
    before, after = beyond(c, e, False), beyond(c, e, True)
    if before >= 0:
        include(c, c.points[c.edges[before, C.EDGE_A], C.POINT_MOVER])
    if after >= 0:
        include(c, c.points[c.edges[after, C.EDGE_B], C.POINT_MOVER])


@nb.njit(**INLINE)
def list_bond(c, p):
    """List a point whose bond stands."""
    c.bound[c.sizes[C.BONDS]] = p
    c.sizes[C.BONDS] += 1


@nb.njit(**BY_ADDRESS)
def list_near(c, nodes, moved, ahead):
    """List the pairs that may meet in a step, with their movers and those of bonds and rigid bodies.

    moved: how far points have moved relative to each other since the search, at most; ahead: how far they may in the step.
    """
    strike_off(c)
    count, last = 0, -1
    for k in range(c.counts[C.PAIRS]):
        q = c.pair_numbers[k]
        if q[C.AWAY] > moved + ahead:
            continue
        i, a, b = c.pairs[k, C.PAIR_AT], c.pairs[k, C.PAIR_AT_A], c.pairs[k, C.PAIR_AT_B]
        apart, length = distance(nodes[0, i], nodes[1, i], nodes[0, a], nodes[1, a], nodes[0, b], nodes[1, b], BEYOND)
        away = (apart - DEEP * length) / (1.0 + DEEP + 2.0 * BEYOND)      # places beyond an end move more, and the length changes
        q[C.AWAY] = away - moved
        if away > ahead:
            q[C.LAST], q[C.LAST_TAU], c.pairs[k, C.PAIR_ACTIVE] = 0.0, 0.0, C.OFF
            continue
        c.near[count] = k
        count += 1
        include(c, c.pairs[k, C.PAIR_S])
        e = c.pairs[k, C.PAIR_EDGE]
        if e != last:
            include_edge(c, e)
            last = e
    c.sizes[C.NEAR], c.sizes[C.BONDS] = count, 0
    for p in range(c.bonds.shape[0]):
        if c.bonds[p, C.BOND_STATE] == C.BOUND:
            list_bond(c, p)
            include(c, c.points[p, C.POINT_MOVER])
            include_edge(c, c.bonds[p, C.BOND_EDGE])
    for m in range(c.movers.shape[0] - c.rigid.shape[0], c.movers.shape[0]):
        include(c, m)
