"""The pairs that touch in a step, and the constraints on their velocities.

A pair touches if its point would be behind its edge at the end of the step, was not before, and the surfaces face each other
(`corners`). At a protruding corner, a point behind both edges touches the one it came through.
"""

import numba as nb

from hugoniot.core.target import BY_ADDRESS, INLINE
from hugoniot.solvers.lagrange2d.contact import layout as C
from hugoniot.solvers.lagrange2d.contact.active import list_active
from hugoniot.solvers.lagrange2d.contact.corners import (
    AT_CORNER,
    BEYOND,
    DEEP,
    edge_vector,
    faces,
    has_edges,
    hollow,
    over_edge,
    through_sheet,
)
from hugoniot.solvers.lagrange2d.contact.impulses import (
    arm_of,
    inverse_mass,
    of_pair,
    relative,
    response,
    weight_of_friction,
)
from hugoniot.solvers.lagrange2d.contact.near import CLOSED, list_bond
from hugoniot.solvers.lagrange2d.contact.rigid import arm, place

SAME_PLACE = 1e-6    # of an edge
STRAIGHT = 0.999     # cosine between edges that bound the same half of the plane
OVERHANG = 0.5       # of an edge: how far beyond its ends forces may act on it, so that they have no moment
KEPT_DEPTH = 0.9     # of the depth at the start of a step may be left at its end
RISE = 1e-2          # of the change of velocity that contact made in the last step: what is behind rises no faster
CLOSING_ENOUGH = 5e-3      # of the change that contact made to a velocity in the last step: what surfaces that touch close by


@nb.njit(**INLINE)
def offsets(c, k, t):
    """(way of the edge, way from its start to the point) of the pair k after the part t of a step."""
    q = c.pairs[k]
    (ax, ay), (bx, by), (x, y) = place(c, q[C.PAIR_FROM], t), place(c, q[C.PAIR_TO], t), place(c, q[C.PAIR_POINT], t)
    return bx - ax, by - ay, x - ax, y - ay


@nb.njit(**INLINE)
def seen(c, k, t):
    """(gap, share, normal, length) of the pair k after the part t of a step."""
    dx, dy, px, py = offsets(c, k, t)
    length = (dx * dx + dy * dy) ** 0.5
    if length == 0.0:
        return 1e300, 0.5, 0.0, 0.0, 0.0
    over = 1.0 / length
    dx, dy = dx * over, dy * over
    return px * dy - py * dx, (px * dx + py * dy) * over, dy, -dx, length


@nb.njit(**BY_ADDRESS)
def tied(c, p, e):
    """Whether a bond stands for the pair of a point and an edge."""
    law = c.law_of[c.points[p, C.POINT_PART], c.edges[e, C.EDGE_PART]]
    if int(c.laws[law, C.LAW_KIND]) == C.SLIDING:
        return False
    if c.bonds[p, C.BOND_STATE] == C.BOUND:
        return True
    a, b = c.edges[e, C.EDGE_A], c.edges[e, C.EDGE_B]
    return c.bonds[a, C.BOND_STATE] == C.BOUND and c.bonds[b, C.BOND_STATE] == C.BOUND


@nb.njit(**INLINE)
def faced(c, k):
    """The point at the end of an edge that the point of pair k faces exactly; -1 if none."""
    e, share = c.pairs[k, C.PAIR_EDGE], c.pair_numbers[k, C.SHARE]
    return c.edges[e, C.EDGE_A] if abs(share) < SAME_PLACE else c.edges[e, C.EDGE_B] if abs(share - 1.0) < SAME_PLACE else -1


@nb.njit(**INLINE)
def turned_by(c, k, m):
    """Cosine between the edges of two pairs."""
    (ax, ay), (bx, by) = edge_vector(c, c.pairs[k, C.PAIR_EDGE], 0.0), edge_vector(c, c.pairs[m, C.PAIR_EDGE], 0.0)
    return (ax * bx + ay * by) / ((ax * ax + ay * ay) * (bx * bx + by * by)) ** 0.5


@nb.njit(**INLINE)
def said_already(c, k, first, other):
    """Whether a pair of two nodes that face each other exactly stands in the list: with the next edge, or from the other side.

    other: the point that the one of pair k faces.
    """
    p = c.pairs[k, C.PAIR_POINT]
    for m in range(first, k):
        if c.pairs[m, C.PAIR_ACTIVE] != C.OFF and faced(c, m) == other and turned_by(c, k, m) > STRAIGHT:
            return True
    if other < p:
        m = c.points[other, C.POINT_FIRST]
        while m < k and c.pairs[m, C.PAIR_POINT] == other:
            if c.pairs[m, C.PAIR_ACTIVE] != C.OFF and faced(c, m) == p and turned_by(c, k, m) < -STRAIGHT:
                return True
            m += 1
    return False


@nb.njit(**BY_ADDRESS)
def list_candidates(c, slack, depth):
    """List the pairs whose point ends the step behind the edge, by more than `slack` of it and more than `depth`, not far beyond its ends,
    and was not deep behind it at the start; how many.

    Without branches, which would cost more than all this.
    """
    found = count = 0
    for i in range(c.sizes[C.NEAR]):
        k, p, a, b = c.near[i]
        (x, y), (ax, ay), (bx, by) = place(c, p, 1.0), place(c, a, 1.0), place(c, b, 1.0)
        dx, dy, px, py = bx - ax, by - ay, x - ax, y - ay
        along, square, behind = px * dx + py * dy, dx * dx + dy * dy, py * dx - px * dy
        c.candidates[found] = i
        found += (behind > slack * square) & (behind * behind > depth * depth * square) & (
            along >= -BEYOND * square) & (along <= (1.0 + BEYOND) * square)
    for n in range(found):
        k, p, a, b = c.near[c.candidates[n]]
        (x, y), (ax, ay), (bx, by) = place(c, p, 0.0), place(c, a, 0.0), place(c, b, 0.0)
        dx, dy, px, py = bx - ax, by - ay, x - ax, y - ay
        c.candidates[count] = k
        count += py * dx - px * dy <= DEEP * (dx * dx + dy * dy)
    return count


@nb.njit(**INLINE)
def meets(c, k, first, slack, depth):
    """Whether the edge of pair k holds its point, which is behind it at the end of the step by more than `slack` of the edge and more than
    `depth`, and no active pair says so already; first: of its point.

    Keeps the gap at the start of the step, and the share of the edge at its end.
    """
    dx, dy, px, py = offsets(c, k, 1.0)
    square = dx * dx + dy * dy
    p, e, q, share = c.pairs[k, C.PAIR_POINT], c.pairs[k, C.PAIR_EDGE], c.pair_numbers[k], (px * dx + py * dy) / square
    q[C.SHARE] = share
    other = faced(c, k)
    if other >= 0 and said_already(c, k, first, other):
        return False
    q[C.GAP], started, nx, ny, before = seen(c, k, 0.0)
    if q[C.GAP] < -AT_CORNER * before and through_sheet(c, p, e):
        return False
    if not over_edge(c, p, e, (q[C.GAP], started, before), (-(py * dx - px * dy) / square**0.5, share), (slack, depth)):
        return False
    return not (c.binds and tied(c, p, e)) and faces(c, p, nx, ny)


@nb.njit(**INLINE)
def other_way(c, k, first):
    """Whether an active pair of the same point, from `first` on, has the edge the point came through, around a corner that juts out."""
    p, e = c.pairs[k, C.PAIR_POINT], c.pairs[k, C.PAIR_EDGE]
    m = first
    while m < c.counts[C.PAIRS] and c.pairs[m, C.PAIR_POINT] == p:
        f = c.pairs[m, C.PAIR_EDGE]
        if m != k and c.pairs[m, C.PAIR_ACTIVE] != C.OFF:
            follows = c.edges[e, C.EDGE_B] == c.edges[f, C.EDGE_A]
            if follows or c.edges[f, C.EDGE_B] == c.edges[e, C.EDGE_A]:
                mine, others = c.pair_numbers[k, C.GAP], c.pair_numbers[m, C.GAP]
                if (mine < others or (mine == others and m < k)) and not hollow(c, e, f, follows):
                    return True
        m += 1
    return False


@nb.njit(**BY_ADDRESS)
def activate(c, dt, closing, slack):
    """Add pairs that meet to those that are active, with their impulses of the last step unless it is `closing`; whether there were any.

    What meets by less than `slack` of an edge is left to the next step.
    """
    depth = CLOSING_ENOUGH * c.numbers[C.CHANGE] * dt if closing else 0.0
    found, i, last = False, 0, list_candidates(c, slack, depth)
    while i < last:
        k, fresh = c.candidates[i], False
        p = c.pairs[k, C.PAIR_POINT]
        first = c.points[p, C.POINT_FIRST]
        while i < last and c.pairs[c.candidates[i], C.PAIR_POINT] == p:
            k = c.candidates[i]
            i += 1
            if c.pairs[k, C.PAIR_ACTIVE] == C.OFF and meets(c, k, first, slack, depth):
                q, c.pairs[k, C.PAIR_ACTIVE], fresh = c.pair_numbers[k], C.FRESH, True
                q[C.LAMBDA], q[C.TAU] = (0.0, 0.0) if closing else (q[C.LAST], q[C.LAST_TAU])
        if fresh:
            for m in range(first, k + 1):
                if c.pairs[m, C.PAIR_ACTIVE] == C.FRESH and other_way(c, m, first):
                    c.pairs[m, C.PAIR_ACTIVE] = C.OFF
            for m in range(first, k + 1):
                if c.pairs[m, C.PAIR_ACTIVE] == C.FRESH:
                    c.pairs[m, C.PAIR_ACTIVE], found = C.ON, True
    if found:
        list_active(c)
    return found


@nb.njit(**INLINE)
def point(c, k, t):
    """Set where and along what normal the impulse of pair k acts, at the time t of `rigid.place`; the gap there."""
    q = c.pair_numbers[k]
    gap, share, q[C.NX], q[C.NY], length = seen(c, k, t)
    q[C.SHARE] = min(max(share, -OVERHANG), 1.0 + OVERHANG)
    if q[C.MORE] != 0.0:
        s, a, _ = of_pair(c, k)
        q[C.LIFT] = gap / length if length > 0.0 else 0.0
        q[C.SIDE], x, y = arm(c, s, a, (c.pairs[k, C.PAIR_FROM], c.pairs[k, C.PAIR_TO]), q[C.SHARE], t)
        q[C.ARM_X], q[C.ARM_Y] = x + gap * q[C.NX], y + gap * q[C.NY]
    return gap


@nb.njit(**BY_ADDRESS)
def ask_closing(c, dt):
    """At the start of a step: points may not come nearer than their gap allows, and do not slide where friction holds them."""
    for i in range(c.counts[C.ACTIVE]):
        k = c.active[i]
        q = c.pair_numbers[k]
        q[C.LEAST], q[C.AIM] = -max(point(c, k, 0.0), 0.0) / dt, 0.0
        weigh(c, q, *of_pair(c, k))


@nb.njit(**BY_ADDRESS)
def ask_mean(c, nodes, dt):
    """For the mean velocity of a step: the gap at its end is not negative, and what slides may be at rest there at best."""
    over = 1.0 / dt
    for i in range(c.counts[C.ACTIVE]):
        k = c.active[i]
        q, (s, a, b) = c.pair_numbers[k], of_pair(c, k)
        gap, _, _, _, _ = seen(c, k, 1.0)
        point(c, k, 0.5)
        weigh(c, q, s, a, b)
        u, v = relative(c, s, a, b, q[C.SHARE], arm_of(q), C.U)
        wanted = min(q[C.GAP] + min((KEPT_DEPTH - 1.0) * q[C.GAP], RISE * c.numbers[C.CHANGE] * dt), 0.0)
        q[C.LEAST] = u * q[C.NX] + v * q[C.NY] + (wanted - gap) * over
        if q[C.COULOMB] > 0.0:
            at_a, at_b = c.points[c.pairs[k, C.PAIR_FROM], C.POINT_NODE], c.points[c.pairs[k, C.PAIR_TO], C.POINT_NODE]
            u, v = start_velocity(nodes, c.points[c.pairs[k, C.PAIR_POINT], C.POINT_NODE], at_a, at_b, q[C.SHARE])
            turn = (nodes[2, at_b] - nodes[2, at_a]) * q[C.NX] + (nodes[3, at_b] - nodes[3, at_a]) * q[C.NY]
            q[C.AIM] = 0.5 * (v * q[C.NX] - u * q[C.NY] + q[C.LIFT] * turn)


@nb.njit(**INLINE)
def start_velocity(nodes, i, j, k, t):
    """Velocity of a column of the nodes relative to the place t between two others at the start of the step."""
    return nodes[2, i] - (1.0 - t) * nodes[2, j] - t * nodes[2, k], nodes[3, i] - (1.0 - t) * nodes[3, j] - t * nodes[3, k]


@nb.njit(**INLINE)
def weigh(c, q, s, a, b):
    """What unit impulses of a pair along its normal and its tangent do."""
    x, y, t = q[C.NX], q[C.NY], q[C.SHARE]
    q[C.SX], q[C.SY] = response(c, s, x, y)
    q[C.AX], q[C.AY] = response(c, a, (t - 1.0) * x, (t - 1.0) * y)
    q[C.BX], q[C.BY] = response(c, b, -t * x, -t * y)
    if a == b:
        q[C.WN] = inverse_mass(c, s, a, b, t, (0.0, 0.0, 0.0), x, y)
    else:
        q[C.WN] = (q[C.SX] + (t - 1.0) * q[C.AX] - t * q[C.BX]) * x + (q[C.SY] + (t - 1.0) * q[C.AY] - t * q[C.BY]) * y
    if q[C.MORE] != 0.0:
        q[C.WT] = weight_of_friction(c, q, s, a, b) if q[C.COULOMB] > 0.0 else 0.0
        if q[C.SIDE] != 0.0:
            moment = q[C.ARM_X] * y - q[C.ARM_Y] * x
            q[C.TURN] = q[C.SIDE] * c.mover_numbers[s if q[C.SIDE] > 0.0 else a, C.II] * moment
            q[C.WN] += q[C.SIDE] * q[C.TURN] * moment
    q[C.MASS] = 1.0 / q[C.WN] if q[C.WN] > 0.0 else 0.0


@nb.njit(**BY_ADDRESS)
def bind_points(c):
    """Bind points that have come to rest on an edge they are to be tied to."""
    for i in range(c.sizes[C.NEAR]):
        k = c.near[i, 0]
        p, e = c.pairs[k, C.PAIR_POINT], c.pairs[k, C.PAIR_EDGE]
        law = c.law_of[c.points[p, C.POINT_PART], c.edges[e, C.EDGE_PART]]
        if int(c.laws[law, C.LAW_KIND]) == C.SLIDING or c.laws[law, C.LAW_TIES] == 0.0 or c.bonds[p, C.BOND_STATE] != C.FREE:
            continue
        gap, share, nx, ny, length = seen(c, k, 0.0)
        if abs(gap) > CLOSED * length or share < -CLOSED or share > 1.0 + CLOSED:
            continue
        if not (has_edges(c, p) and faces(c, p, nx, ny)):
            continue
        c.bonds[p, C.BOND_STATE], c.bonds[p, C.BOND_EDGE] = C.BOUND, e
        list_bond(c, p)
        c.bond_numbers[p, :] = 0.0
        c.bond_numbers[p, C.BOND_SHARE] = min(max(share, 0.0), 1.0)
