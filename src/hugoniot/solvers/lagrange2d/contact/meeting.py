"""Which pairs meet in a step, and what contact then asks of their velocities.

A pair meets when its point would be behind its edge at the end of the step, was not before, and the surfaces face each other. Where the
edge ends at a corner that juts out, a point behind both edges meets the one it came through; where the corner is hollow, both edges
bound the space that is free, beyond the corner too.
"""

import numba as nb

from hugoniot.core.target import GUARD, INLINE
from hugoniot.solvers.lagrange2d.contact import layout as C
from hugoniot.solvers.lagrange2d.contact.impulses import CLOSE_ENOUGH, inverse_mass, of_pair, relative, response

SAME_PLACE = 1e-6    # of an edge
STRAIGHT = 0.999     # cosine between edges that bound the same half of the plane
DEEP = 0.05          # of an edge: a point that was deeper behind it at the start of a step did not come through it
FACING = -0.1        # cosine between the outward normals of point and edge
BEYOND = 0.5         # of an edge: how far it bounds the free space beyond a hollow corner
EDGE_END = 1e-6
OVERHANG = 0.5       # of an edge: how far beyond its ends forces may act on it, so that they have no moment
KEPT_DEPTH = 0.9     # of the depth at the start of a step may be left at its end
RISE = 1e-2          # of the change of velocity that contact made in the last step: what is behind rises no faster
CLOSED = 1e-3        # of an edge: a gap that a bond bridges


@nb.njit(**INLINE)
def offsets(c, nodes, k, dt):
    """(way of the edge, way from its start to the point) of the pair k, with positions moved by dt times the velocities of movers."""
    q, n, x, y = c.pairs[k], c.mover_numbers, nodes[0], nodes[1]
    at, at_a, at_b, s, a, b = q[C.PAIR_AT], q[C.PAIR_AT_A], q[C.PAIR_AT_B], q[C.PAIR_S], q[C.PAIR_A], q[C.PAIR_B]
    ax, ay = x[at_a] + dt * n[a, C.U], y[at_a] + dt * n[a, C.V]
    return (x[at_b] + dt * n[b, C.U] - ax, y[at_b] + dt * n[b, C.V] - ay, x[at] + dt * n[s, C.U] - ax, y[at] + dt * n[s, C.V] - ay)


@nb.njit(**INLINE)
def seen(c, nodes, k, dt):
    """(gap, share, normal, length) of the pair k, with positions moved by dt times the velocities of movers."""
    dx, dy, px, py = offsets(c, nodes, k, dt)
    length = (dx * dx + dy * dy) ** 0.5
    if length == 0.0:
        return 1e300, 0.5, 0.0, 0.0, 0.0
    dx, dy = dx / length, dy / length
    return px * dy - py * dx, (px * dx + py * dy) / length, dy, -dx, length


@nb.njit(**GUARD)
def edge_way(c, nodes, e):
    """Unit vector along an edge as nodes stand."""
    a, b = c.points[c.edges[e, C.EDGE_A], C.POINT_NODE], c.points[c.edges[e, C.EDGE_B], C.POINT_NODE]
    dx, dy = nodes[0, b] - nodes[0, a], nodes[1, b] - nodes[1, a]
    length = (dx * dx + dy * dy) ** 0.5
    return (dx / length, dy / length) if length > 0.0 else (0.0, 0.0)


@nb.njit(**GUARD)
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


@nb.njit(**GUARD)
def hollow(c, nodes, e, at_end):
    """Whether the surface turns inward at an end of an edge: material on both sides of the free space there."""
    p = c.edges[e, C.EDGE_B] if at_end else c.edges[e, C.EDGE_A]
    other = c.points[p, C.POINT_AFTER] if at_end else c.points[p, C.POINT_BEFORE]
    if other < 0:
        return False
    ax, ay = edge_way(c, nodes, e)
    bx, by = edge_way(c, nodes, other)
    turn = ax * by - ay * bx if at_end else bx * ay - by * ax
    return turn < -1e-9


@nb.njit(**GUARD)
def over_edge(c, nodes, e, share):
    """Whether an edge bounds the free space at a share of it."""
    if share < -EDGE_END:
        return share > -BEYOND and hollow(c, nodes, e, False)
    if share > 1.0 + EDGE_END:
        return share < 1.0 + BEYOND and hollow(c, nodes, e, True)
    return True


@nb.njit(**GUARD)
def tied(c, p, e):
    """Whether a bond stands for the pair of a point and an edge."""
    law = c.law_of[c.points[p, C.POINT_PART], c.edges[e, C.EDGE_PART]]
    if int(c.laws[law, C.LAW_KIND]) == C.SLIDING:
        return False
    if c.bonds[p, C.BOND_STATE] == C.BOUND:
        return True
    a, b = c.edges[e, C.EDGE_A], c.edges[e, C.EDGE_B]
    return c.bonds[a, C.BOND_STATE] == C.BOUND and c.bonds[b, C.BOND_STATE] == C.BOUND


@nb.njit(**GUARD)
def meets(c, nodes, k, dt, slack, depth):
    """Whether the pair k, with the velocities found so far, is behind its edge at the end of the step by more than `slack` of the edge
    and more than `depth`.

    Keeps the gap at the start of the step, and the share of the edge at its end.
    """
    dx, dy, px, py = offsets(c, nodes, k, dt)
    if px * dy >= py * dx:
        return False
    p, e = c.pairs[k, C.PAIR_POINT], c.pairs[k, C.PAIR_EDGE]
    gap, share, _, _, length = seen(c, nodes, k, dt)
    if gap >= -max(slack * length, depth):
        return False
    before, _, nx, ny, _ = seen(c, nodes, k, 0.0)
    if before < -DEEP * length or not over_edge(c, nodes, e, share) or tied(c, p, e):
        return False
    x, y = point_normal(c, nodes, p)
    if x * nx + y * ny > FACING and (c.points[p, C.POINT_BEFORE] >= 0 or c.points[p, C.POINT_AFTER] >= 0):
        return False
    c.pair_numbers[k, C.GAP], c.pair_numbers[k, C.SHARE] = before, share
    return True


@nb.njit(**INLINE)
def faced(c, k):
    """The point at the end of an edge that the point of pair k faces exactly; -1 if none."""
    e, share = c.pairs[k, C.PAIR_EDGE], c.pair_numbers[k, C.SHARE]
    return c.edges[e, C.EDGE_A] if abs(share) < SAME_PLACE else c.edges[e, C.EDGE_B] if abs(share - 1.0) < SAME_PLACE else -1


@nb.njit(**GUARD)
def said_already(c, nodes, k, first):
    """Whether a pair of two nodes that face each other exactly stands in the list: with the next edge, or from the other side."""
    p, other = c.pairs[k, C.PAIR_POINT], faced(c, k)
    if other < 0:
        return False
    ax, ay = edge_way(c, nodes, c.pairs[k, C.PAIR_EDGE])
    for m in range(first, k):
        if c.pairs[m, C.PAIR_ACTIVE] != C.OFF and faced(c, m) == other:
            bx, by = edge_way(c, nodes, c.pairs[m, C.PAIR_EDGE])
            if ax * bx + ay * by > STRAIGHT:
                return True
    if other < p:
        m = c.points[other, C.POINT_FIRST]
        while m < k and c.pairs[m, C.PAIR_POINT] == other:
            if c.pairs[m, C.PAIR_ACTIVE] != C.OFF and faced(c, m) == p:
                bx, by = edge_way(c, nodes, c.pairs[m, C.PAIR_EDGE])
                if ax * bx + ay * by < -STRAIGHT:
                    return True
            m += 1
    return False


@nb.njit(**GUARD)
def other_way(c, nodes, k, first):
    """Whether an active pair of the same point, from `first` on, has the edge the point came through, around a corner that juts out."""
    p, e = c.pairs[k, C.PAIR_POINT], c.pairs[k, C.PAIR_EDGE]
    m = first
    while m < c.counts[C.PAIRS] and c.pairs[m, C.PAIR_POINT] == p:
        f = c.pairs[m, C.PAIR_EDGE]
        if m != k and c.pairs[m, C.PAIR_ACTIVE] != C.OFF:
            follows = c.edges[e, C.EDGE_B] == c.edges[f, C.EDGE_A]
            if follows or c.edges[f, C.EDGE_B] == c.edges[e, C.EDGE_A]:
                mine, others = c.pair_numbers[k, C.GAP], c.pair_numbers[m, C.GAP]
                if not hollow(c, nodes, e, follows) and (mine < others or (mine == others and m < k)):
                    return True
        m += 1
    return False


@nb.njit(**GUARD)
def activate(c, nodes, dt, closing, slack):
    """Add pairs that meet to those that are active, with their impulses of the last step unless it is `closing`; whether there were any.

    What meets by less than `slack` of an edge is left to the next step.
    """
    found, k, last = False, 0, c.counts[C.PAIRS]
    depth = CLOSE_ENOUGH * c.numbers[C.CHANGE] * dt if closing else 0.0
    while k < last:
        p, first, fresh = c.pairs[k, C.PAIR_POINT], k, False
        while k < last and c.pairs[k, C.PAIR_POINT] == p:
            if c.pairs[k, C.PAIR_ACTIVE] == C.OFF and meets(c, nodes, k, dt, slack, depth) and not said_already(c, nodes, k, first):
                q, c.pairs[k, C.PAIR_ACTIVE], fresh = c.pair_numbers[k], C.FRESH, True
                q[C.LAMBDA], q[C.TAU] = (0.0, 0.0) if closing else (q[C.LAST], q[C.LAST_TAU])
            k += 1
        if fresh:
            for m in range(first, k):
                if c.pairs[m, C.PAIR_ACTIVE] == C.FRESH and other_way(c, nodes, m, first):
                    c.pairs[m, C.PAIR_ACTIVE] = C.OFF
            for m in range(first, k):
                if c.pairs[m, C.PAIR_ACTIVE] == C.FRESH:
                    c.pairs[m, C.PAIR_ACTIVE], found = C.ON, True
    if found:
        list_active(c)
    return found


@nb.njit(**GUARD)
def list_active(c):
    """List the active pairs."""
    count = 0
    for k in range(c.counts[C.PAIRS]):
        if c.pairs[k, C.PAIR_ACTIVE] == C.ON:
            c.active[count] = k
            count += 1
    c.counts[C.ACTIVE] = count


@nb.njit(**GUARD)
def forget(c):
    """No pair is active."""
    c.counts[C.ACTIVE] = 0
    for k in range(c.counts[C.PAIRS]):
        c.pairs[k, C.PAIR_ACTIVE] = C.OFF


@nb.njit(**GUARD)
def remember(c, dt):
    """Keep the impulses of this step for the next one."""
    c.numbers[C.LAST_STEP] = dt
    for p in range(c.bonds.shape[0]):
        q = c.bond_numbers[p]
        q[C.BOND_LAST_X], q[C.BOND_LAST_Y] = q[C.BOND_X], q[C.BOND_Y]
    for k in range(c.counts[C.PAIRS]):
        q, on = c.pair_numbers[k], c.pairs[k, C.PAIR_ACTIVE] == C.ON
        q[C.LAST], q[C.LAST_TAU] = (q[C.LAMBDA], q[C.TAU]) if on else (0.0, 0.0)


@nb.njit(**GUARD)
def ask_closing(c, nodes, dt):
    """At the start of a step: points may not come nearer than their gap allows, and do not slide where friction holds them."""
    for i in range(c.counts[C.ACTIVE]):
        k = c.active[i]
        q = c.pair_numbers[k]
        gap, share, q[C.NX], q[C.NY], _ = seen(c, nodes, k, 0.0)
        q[C.SHARE] = min(max(share, -OVERHANG), 1.0 + OVERHANG)
        q[C.LEAST], q[C.AIM] = -max(gap, 0.0) / dt, 0.0
        weigh(c, k, q)


@nb.njit(**GUARD)
def ask_mean(c, nodes, dt):
    """For the mean velocity of a step: the gap at its end is not negative, and what slides may be at rest there at best."""
    for i in range(c.counts[C.ACTIVE]):
        k = c.active[i]
        q, (s, a, b) = c.pair_numbers[k], of_pair(c, k)
        gap, _, _, _, _ = seen(c, nodes, k, dt)
        _, share, q[C.NX], q[C.NY], _ = seen(c, nodes, k, 0.5 * dt)
        q[C.SHARE] = min(max(share, -OVERHANG), 1.0 + OVERHANG)
        u, v = relative(c, s, a, b, q[C.SHARE], C.U, C.V)
        wanted = min(q[C.GAP] + min((KEPT_DEPTH - 1.0) * q[C.GAP], RISE * c.numbers[C.CHANGE] * dt), 0.0)
        q[C.LEAST] = u * q[C.NX] + v * q[C.NY] + (wanted - gap) / dt
        if q[C.COULOMB] > 0.0:
            u, v = start_velocity(c, nodes, s, a, b, q[C.SHARE])
            q[C.AIM] = 0.5 * (v * q[C.NX] - u * q[C.NY])
        weigh(c, k, q)


@nb.njit(**GUARD)
def start_velocity(c, nodes, s, a, b, t):
    """Relative velocity of three movers at the start of the step."""
    i, j, k = c.movers[s, C.MOVER_NODE], c.movers[a, C.MOVER_NODE], c.movers[b, C.MOVER_NODE]
    return (nodes[2, i] - (1.0 - t) * nodes[2, j] - t * nodes[2, k], nodes[3, i] - (1.0 - t) * nodes[3, j] - t * nodes[3, k])


@nb.njit(**GUARD)
def weigh(c, k, q):
    """What unit impulses of a pair along its normal and its tangent do."""
    s, a, b = of_pair(c, k)
    x, y, t = q[C.NX], q[C.NY], q[C.SHARE]
    q[C.SX], q[C.SY] = response(c, s, x, y)
    q[C.AX], q[C.AY] = response(c, a, (t - 1.0) * x, (t - 1.0) * y)
    q[C.BX], q[C.BY] = response(c, b, -t * x, -t * y)
    q[C.WN] = inverse_mass(c, s, a, b, t, x, y)
    q[C.WT] = inverse_mass(c, s, a, b, t, -y, x) if q[C.COULOMB] > 0.0 else 0.0


@nb.njit(**GUARD)
def bind_points(c, nodes):
    """Bond points that have come to rest on an edge they are to be tied to."""
    for k in range(c.counts[C.PAIRS]):
        p, e = c.pairs[k, C.PAIR_POINT], c.pairs[k, C.PAIR_EDGE]
        law = c.law_of[c.points[p, C.POINT_PART], c.edges[e, C.EDGE_PART]]
        if int(c.laws[law, C.LAW_KIND]) == C.SLIDING or c.laws[law, C.LAW_TIES] == 0.0 or c.bonds[p, C.BOND_STATE] != C.FREE:
            continue
        gap, share, nx, ny, length = seen(c, nodes, k, 0.0)
        if abs(gap) > CLOSED * length or share < -CLOSED or share > 1.0 + CLOSED:
            continue
        x, y = point_normal(c, nodes, p)
        if x * nx + y * ny > FACING:
            continue
        c.bonds[p, C.BOND_STATE], c.bonds[p, C.BOND_EDGE] = C.BOUND, e
        c.bond_numbers[p, :] = 0.0
        c.bond_numbers[p, C.BOND_SHARE] = min(max(share, 0.0), 1.0)
