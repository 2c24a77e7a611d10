"""Which of the pairs listed may meet in a step, and which movers that concerns; all other pairs and movers are left out of it.

A pair that was found to be `away` apart cannot meet until points have moved that far relative to each other.
"""

import numba as nb

from hugoniot.core.target import BY_ADDRESS, INLINE
from hugoniot.solvers.lagrange2d.contact import layout as C
from hugoniot.solvers.lagrange2d.contact.corners import BEYOND, DEEP, beyond
from hugoniot.solvers.lagrange2d.contact.rigid import place

IM = 12      # row of the node table
NEAR = -1e300      # how far pairs are apart that touch
EVERY = 4    # steps between two looks at how far pairs are apart


@nb.njit(**INLINE)
def distance(x, y, ax, ay, bx, by, before, after):
    """Distance from a point to the stretch from a to b, which goes on before a and after b by parts of its length; that length."""
    dx, dy = bx - ax, by - ay
    square = dx * dx + dy * dy
    t = ((x - ax) * dx + (y - ay) * dy) / square if square > 0.0 else 0.0
    t = min(max(t, -before), 1.0 + after)
    return ((x - ax - t * dx) ** 2 + (y - ay - t * dy) ** 2) ** 0.5, square**0.5


@nb.njit(**INLINE)
def include_mover(c, nodes, m):
    """List a mover."""
    if c.movers[m, C.MOVER_LISTED] == 0:
        c.movers[m, C.MOVER_LISTED] = 1
        c.listed[c.sizes[C.LISTED]] = m
        c.sizes[C.LISTED] += 1
        if c.movers[m, C.MOVER_RIGID] < 0:
            c.mover_numbers[m, C.IM] = nodes[IM, c.movers[m, C.MOVER_NODE]]


@nb.njit(**INLINE)
def include(c, nodes, p):
    """List a point with its mover."""
    if c.marks[p] == 0:
        m, c.marks[p] = c.points[p, C.POINT_MOVER], 1
        c.near_points[c.sizes[C.POINTS], 0], c.near_points[c.sizes[C.POINTS], 1] = p, m
        c.sizes[C.POINTS] += 1
        include_mover(c, nodes, m)


@nb.njit(**BY_ADDRESS)
def strike_off(c):
    """List no points and no movers; those that were have no impulse."""
    for i in range(c.sizes[C.POINTS]):
        c.marks[c.near_points[i, 0]] = 0
    for i in range(c.sizes[C.LISTED]):
        m = c.listed[i]
        q, c.movers[m, C.MOVER_LISTED] = c.mover_numbers[m], 0
        q[C.JX], q[C.JY], q[C.JW] = 0.0, 0.0, 0.0
    c.sizes[C.LISTED], c.sizes[C.POINTS] = 0, 0


@nb.njit(**INLINE)
def include_edge(c, nodes, e):
    """List the ends of an edge and of those beside it, on which it depends what a corner bounds."""
    include(c, nodes, c.edges[e, C.EDGE_A])
    include(c, nodes, c.edges[e, C.EDGE_B])
    before, after = beyond(c, e, False), beyond(c, e, True)
    if before >= 0:
        include(c, nodes, c.edges[before, C.EDGE_A])
    if after >= 0:
        include(c, nodes, c.edges[after, C.EDGE_B])


@nb.njit(**INLINE)
def list_bond(c, p):
    """List a point whose bond stands."""
    c.bound[c.sizes[C.BONDS]] = p
    c.sizes[C.BONDS] += 1


@nb.njit(**INLINE)
def away(c, k, moved):
    """How far the points of a pair may have moved relative to each other, counted from `since`, before it can meet; kept for later steps.

    An edge does not go on for the point at the other end of the next edge, which can only fold onto it.
    """
    p, a, b = c.pairs[k, C.PAIR_POINT], c.pairs[k, C.PAIR_FROM], c.pairs[k, C.PAIR_TO]
    before, after = c.points[a, C.POINT_BEFORE], c.points[b, C.POINT_AFTER]
    on_before = 0.0 if before >= 0 and c.edges[before, C.EDGE_A] == p else BEYOND
    on_after = 0.0 if after >= 0 and c.edges[after, C.EDGE_B] == p else BEYOND
    apart, length = distance(*place(c, p, 0.0), *place(c, a, 0.0), *place(c, b, 0.0), on_before, on_after)
    # a place beyond an end moves with that end and by a part of what the ends move relative to each other, by which the length changes too
    c.away[k] = (apart - DEEP * length) / (1.0 + DEEP + BEYOND) - moved
    return c.away[k]


@nb.njit(**BY_ADDRESS)
def list_near(c, nodes, moved, ahead):
    """List the pairs that may meet in a step, with their points and movers, those of bonds and rigid bodies.

    moved: how far points have moved relative to each other since `since`, at most; ahead: how far they may in the step. The list serves
    the steps up to the next look, unless points move farther before. Which further pairs are in it changes nothing but the time it takes.
    """
    anew, start = c.sizes[C.NEAR] < 0, c.counts[C.STEPS] % EVERY == 0
    c.counts[C.STEPS] += 1
    if anew:
        list_touched(c)
    if start:
        count_from_now(c, moved)
        moved = 0.0
    look = start or moved + ahead > c.numbers[C.MARGIN]
    if look:
        c.numbers[C.MARGIN] = moved + ahead + 0.5 * EVERY * ahead
    if anew or look:
        count, same = 0, not anew
        for k in range(c.counts[C.PAIRS]):
            if c.away[k] <= c.numbers[C.MARGIN] and (c.pair_numbers[k, C.LAST] != 0.0 or away(c, k, moved) <= c.numbers[C.MARGIN]):
                same = same and c.near[count, 0] == k
                c.near[count, 0] = k
                count += 1
        anew, c.sizes[C.NEAR] = not same or count != c.sizes[C.NEAR], count
    if anew or c.binds:
        list_concerned(c, nodes)


@nb.njit(**BY_ADDRESS)
def count_from_now(c, moved):
    """Count the motion of points from where they are now; the search reaches less far by what they have moved."""
    for p in range(c.points.shape[0]):
        c.since[p, 0], c.since[p, 1] = c.places[p, C.AT_X], c.places[p, C.AT_Y]
    for k in range(c.counts[C.PAIRS]):
        c.away[k] -= moved
    c.numbers[C.REACH] -= moved


@nb.njit(**BY_ADDRESS)
def list_touched(c):
    """List the pairs that had an impulse in the last step; they are near."""
    count = 0
    for k in range(c.counts[C.PAIRS]):
        if c.pair_numbers[k, C.LAST] != 0.0:
            c.touched[count], c.away[k] = k, NEAR
            count += 1
    c.sizes[C.TOUCHED] = count


@nb.njit(**BY_ADDRESS)
def list_concerned(c, nodes):
    """List the points and movers of the pairs that may meet, those of bonds and of rigid bodies."""
    strike_off(c)
    last, c.sizes[C.BONDS] = -1, 0
    for i in range(c.sizes[C.NEAR]):
        q, e = c.near[i], c.pairs[c.near[i, 0], C.PAIR_EDGE]
        q[C.NEAR_POINT], q[C.NEAR_FROM], q[C.NEAR_TO] = c.pairs[q[0], C.PAIR_POINT], c.edges[e, C.EDGE_A], c.edges[e, C.EDGE_B]
        include(c, nodes, q[C.NEAR_POINT])
        if e != last:
            include_edge(c, nodes, e)
            last = e
    for p in range(c.bonds.shape[0] if c.binds else 0):
        if c.bonds[p, C.BOND_STATE] == C.BOUND:
            list_bond(c, p)
            for e in (c.bonds[p, C.BOND_EDGE], c.points[p, C.POINT_BEFORE], c.points[p, C.POINT_AFTER]):
                if e >= 0:
                    include_edge(c, nodes, e)
    for m in range(c.movers.shape[0] - c.rigid.shape[0], c.movers.shape[0]):
        include_mover(c, nodes, m)
