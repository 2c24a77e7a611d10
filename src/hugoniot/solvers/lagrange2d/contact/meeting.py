"""Which pairs meet in a step, and what contact then asks of their velocities.

A pair meets when its point would be behind its edge at the end of the step, was not before, and the surfaces face each other
(`corners`). Where the edge ends at a corner that juts out, a point behind both edges meets the one it came through.
"""

import numba as nb

from hugoniot.core.target import BY_ADDRESS, INLINE
from hugoniot.solvers.lagrange2d.contact import layout as C
from hugoniot.solvers.lagrange2d.contact.corners import DEEP, edge_vector, faces, has_edges, hollow, over_edge
from hugoniot.solvers.lagrange2d.contact.impulses import (
    CLOSE_ENOUGH,
    arm_of,
    inverse_mass,
    of_pair,
    relative,
    response,
    weight_of_friction,
)
from hugoniot.solvers.lagrange2d.contact.near import list_bond
from hugoniot.solvers.lagrange2d.contact.rigid import arm, place

SAME_PLACE = 1e-6    # of an edge
STRAIGHT = 0.999     # cosine between edges that bound the same half of the plane
OVERHANG = 0.5       # of an edge: how far beyond its ends forces may act on it, so that they have no moment
KEPT_DEPTH = 0.9     # of the depth at the start of a step may be left at its end
RISE = 1e-2          # of the change of velocity that contact made in the last step: what is behind rises no faster
CLOSED = 1e-3        # of an edge: a gap that a bond bridges


@nb.njit(**INLINE)
def offsets(c, nodes, k, dt):
    """(way of the edge, way from its start to the point) of the pair k, with positions moved by dt times the velocities of movers."""
    q = c.pairs[k]
    (ax, ay), (bx, by) = place(c, nodes, q[C.PAIR_A], q[C.PAIR_AT_A], dt), place(c, nodes, q[C.PAIR_B], q[C.PAIR_AT_B], dt)
    x, y = place(c, nodes, q[C.PAIR_S], q[C.PAIR_AT], dt)
    return bx - ax, by - ay, x - ax, y - ay


@nb.njit(**INLINE)
def seen(c, nodes, k, dt):
    """(gap, share, normal, length) of the pair k, with positions moved by dt times the velocities of movers."""
    dx, dy, px, py = offsets(c, nodes, k, dt)
    length = (dx * dx + dy * dy) ** 0.5
    if length == 0.0:
        return 1e300, 0.5, 0.0, 0.0, 0.0
    dx, dy = dx / length, dy / length
    return px * dy - py * dx, (px * dx + py * dy) / length, dy, -dx, length


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


@nb.njit(**BY_ADDRESS)
def turned_by(c, nodes, k, m):
    """Cosine between the edges of two pairs."""
    ax, ay = edge_vector(c, nodes, c.pairs[k, C.PAIR_EDGE])
    bx, by = edge_vector(c, nodes, c.pairs[m, C.PAIR_EDGE])
    return (ax * bx + ay * by) / ((ax * ax + ay * ay) * (bx * bx + by * by)) ** 0.5


@nb.njit(**BY_ADDRESS)
def said_already(c, nodes, k, first):
    """Whether a pair of two nodes that face each other exactly stands in the list: with the next edge, or from the other side."""
    p, other = c.pairs[k, C.PAIR_POINT], faced(c, k)
    if other < 0:
        return False
    for m in range(first, k):
        if c.pairs[m, C.PAIR_ACTIVE] != C.OFF and faced(c, m) == other and turned_by(c, nodes, k, m) > STRAIGHT:
            return True
    if other < p:
        m = c.points[other, C.POINT_FIRST]
        while m < k and c.pairs[m, C.PAIR_POINT] == other:
            if c.pairs[m, C.PAIR_ACTIVE] != C.OFF and faced(c, m) == p and turned_by(c, nodes, k, m) < -STRAIGHT:
                return True
            m += 1
    return False


@nb.njit(**BY_ADDRESS)
def meets(c, nodes, k, first, dt, slack, depth):
    """Whether the pair k, with the velocities found so far, is behind its edge at the end of the step by more than `slack` of the edge
    and more than `depth`, and no active pair says so already; first: of its point.

    Keeps the gap at the start of the step, and the share of the edge at its end.
    """
    dx, dy, px, py = offsets(c, nodes, k, dt)
    behind, square = py * dx - px * dy, dx * dx + dy * dy      # the depth times the length of the edge
    if behind <= 0.0 or behind <= max(slack * square, depth * square**0.5):
        return False
    p, e, share = c.pairs[k, C.PAIR_POINT], c.pairs[k, C.PAIR_EDGE], (px * dx + py * dy) / square
    c.pair_numbers[k, C.SHARE] = share
    if said_already(c, nodes, k, first):
        return False
    before, _, nx, ny, length = seen(c, nodes, k, 0.0)
    c.pair_numbers[k, C.GAP] = before
    if before < -DEEP * length or not over_edge(c, nodes, p, e, (-behind / square**0.5, share), dt, (slack, depth)):
        return False
    return not tied(c, p, e) and faces(c, nodes, p, nx, ny)


@nb.njit(**BY_ADDRESS)
def other_way(c, nodes, k, first, dt):
    """Whether an active pair of the same point, from `first` on, has the edge the point came through, around a corner that juts out."""
    p, e = c.pairs[k, C.PAIR_POINT], c.pairs[k, C.PAIR_EDGE]
    m = first
    while m < c.counts[C.PAIRS] and c.pairs[m, C.PAIR_POINT] == p:
        f = c.pairs[m, C.PAIR_EDGE]
        if m != k and c.pairs[m, C.PAIR_ACTIVE] != C.OFF:
            follows = c.edges[e, C.EDGE_B] == c.edges[f, C.EDGE_A]
            if follows or c.edges[f, C.EDGE_B] == c.edges[e, C.EDGE_A]:
                mine, others = c.pair_numbers[k, C.GAP], c.pair_numbers[m, C.GAP]
                if not hollow(c, nodes, e, f, follows, dt) and (mine < others or (mine == others and m < k)):
                    return True
        m += 1
    return False


@nb.njit(**BY_ADDRESS)
def activate(c, nodes, dt, closing, slack):
    """Add pairs that meet to those that are active, with their impulses of the last step unless it is `closing`; whether there were any.

    What meets by less than `slack` of an edge is left to the next step.
    """
    found, i, last = False, 0, c.sizes[C.NEAR]
    depth = CLOSE_ENOUGH * c.numbers[C.CHANGE] * dt if closing else 0.0
    while i < last:
        k = first = c.near[i]
        p, fresh = c.pairs[first, C.PAIR_POINT], False
        while i < last and c.pairs[c.near[i], C.PAIR_POINT] == p:
            k = c.near[i]
            if c.pairs[k, C.PAIR_ACTIVE] == C.OFF and meets(c, nodes, k, first, dt, slack, depth):
                q, c.pairs[k, C.PAIR_ACTIVE], fresh = c.pair_numbers[k], C.FRESH, True
                q[C.LAMBDA], q[C.TAU] = (0.0, 0.0) if closing else (q[C.LAST], q[C.LAST_TAU])
            i += 1
        if fresh:
            for m in range(first, k + 1):
                if c.pairs[m, C.PAIR_ACTIVE] == C.FRESH and other_way(c, nodes, m, first, dt):
                    c.pairs[m, C.PAIR_ACTIVE] = C.OFF
            for m in range(first, k + 1):
                if c.pairs[m, C.PAIR_ACTIVE] == C.FRESH:
                    c.pairs[m, C.PAIR_ACTIVE], found = C.ON, True
    if found:
        list_active(c)
    return found


@nb.njit(**BY_ADDRESS)
def list_active(c):
    """List the active pairs."""
    count = 0
    for i in range(c.sizes[C.NEAR]):
        k = c.near[i]
        if c.pairs[k, C.PAIR_ACTIVE] == C.ON:
            c.active[count] = k
            count += 1
    c.counts[C.ACTIVE] = count


@nb.njit(**BY_ADDRESS)
def forget(c):
    """No pair is active."""
    c.counts[C.ACTIVE] = 0
    for i in range(c.sizes[C.NEAR]):
        c.pairs[c.near[i], C.PAIR_ACTIVE] = C.OFF


@nb.njit(**BY_ADDRESS)
def remember(c, dt):
    """Keep the impulses of this step for the next one."""
    c.numbers[C.LAST_STEP] = dt
    for i in range(c.sizes[C.BONDS]):
        q = c.bond_numbers[c.bound[i]]
        q[C.BOND_LAST_X], q[C.BOND_LAST_Y] = q[C.BOND_X], q[C.BOND_Y]
    for i in range(c.sizes[C.NEAR]):
        k = c.near[i]
        q, on = c.pair_numbers[k], c.pairs[k, C.PAIR_ACTIVE] == C.ON
        q[C.LAST], q[C.LAST_TAU] = (q[C.LAMBDA], q[C.TAU]) if on else (0.0, 0.0)


@nb.njit(**BY_ADDRESS)
def point(c, nodes, k, dt):
    """Set where and along what normal the impulse of pair k acts, with places after dt; the gap there."""
    q, (s, a, b) = c.pair_numbers[k], of_pair(c, k)
    gap, share, q[C.NX], q[C.NY], length = seen(c, nodes, k, dt)
    q[C.SHARE], q[C.LIFT] = min(max(share, -OVERHANG), 1.0 + OVERHANG), gap / length if length > 0.0 else 0.0
    q[C.SIDE], x, y = arm(c, nodes, s, a, b, (c.pairs[k, C.PAIR_AT_A], c.pairs[k, C.PAIR_AT_B]), q[C.SHARE], dt)
    q[C.ARM_X], q[C.ARM_Y] = x + gap * q[C.NX], y + gap * q[C.NY]
    return gap


@nb.njit(**BY_ADDRESS)
def ask_closing(c, nodes, dt):
    """At the start of a step: points may not come nearer than their gap allows, and do not slide where friction holds them."""
    for i in range(c.counts[C.ACTIVE]):
        k = c.active[i]
        q, (s, a, b) = c.pair_numbers[k], of_pair(c, k)
        q[C.LEAST], q[C.AIM] = -max(point(c, nodes, k, 0.0), 0.0) / dt, 0.0
        weigh(c, q, s, a, b)


@nb.njit(**BY_ADDRESS)
def ask_mean(c, nodes, dt):
    """For the mean velocity of a step: the gap at its end is not negative, and what slides may be at rest there at best."""
    for i in range(c.counts[C.ACTIVE]):
        k = c.active[i]
        q, (s, a, b) = c.pair_numbers[k], of_pair(c, k)
        gap, _, _, _, _ = seen(c, nodes, k, dt)
        point(c, nodes, k, 0.5 * dt)
        weigh(c, q, s, a, b)
        u, v = relative(c, s, a, b, q[C.SHARE], arm_of(q), C.U)
        wanted = min(q[C.GAP] + min((KEPT_DEPTH - 1.0) * q[C.GAP], RISE * c.numbers[C.CHANGE] * dt), 0.0)
        q[C.LEAST] = u * q[C.NX] + v * q[C.NY] + (wanted - gap) / dt
        if q[C.COULOMB] > 0.0:
            at_a, at_b = c.pairs[k, C.PAIR_AT_A], c.pairs[k, C.PAIR_AT_B]
            u, v = start_velocity(nodes, c.pairs[k, C.PAIR_AT], at_a, at_b, q[C.SHARE])
            turn = (nodes[2, at_b] - nodes[2, at_a]) * q[C.NX] + (nodes[3, at_b] - nodes[3, at_a]) * q[C.NY]
            q[C.AIM] = 0.5 * (v * q[C.NX] - u * q[C.NY] + q[C.LIFT] * turn)


@nb.njit(**BY_ADDRESS)
def start_velocity(nodes, i, j, k, t):
    """Velocity of a column of the nodes relative to the place t between two others at the start of the step."""
    return nodes[2, i] - (1.0 - t) * nodes[2, j] - t * nodes[2, k], nodes[3, i] - (1.0 - t) * nodes[3, j] - t * nodes[3, k]


@nb.njit(**BY_ADDRESS)
def weigh(c, q, s, a, b):
    """What unit impulses of a pair along its normal and its tangent do."""
    x, y, t = q[C.NX], q[C.NY], q[C.SHARE]
    if q[C.SIDE] != 0.0:
        q[C.TURN] = q[C.SIDE] * c.mover_numbers[s if q[C.SIDE] > 0.0 else a, C.II] * (q[C.ARM_X] * y - q[C.ARM_Y] * x)
    q[C.SX], q[C.SY] = response(c, s, x, y)
    q[C.AX], q[C.AY] = response(c, a, (t - 1.0) * x, (t - 1.0) * y)
    q[C.BX], q[C.BY] = response(c, b, -t * x, -t * y)
    q[C.WN] = inverse_mass(c, s, a, b, t, arm_of(q), x, y)
    q[C.MASS] = 1.0 / q[C.WN] if q[C.WN] > 0.0 else 0.0
    q[C.WT] = weight_of_friction(c, q, s, a, b) if q[C.COULOMB] > 0.0 else 0.0


@nb.njit(**BY_ADDRESS)
def bind_points(c, nodes):
    """Bond points that have come to rest on an edge they are to be tied to."""
    for i in range(c.sizes[C.NEAR]):
        k = c.near[i]
        p, e = c.pairs[k, C.PAIR_POINT], c.pairs[k, C.PAIR_EDGE]
        law = c.law_of[c.points[p, C.POINT_PART], c.edges[e, C.EDGE_PART]]
        if int(c.laws[law, C.LAW_KIND]) == C.SLIDING or c.laws[law, C.LAW_TIES] == 0.0 or c.bonds[p, C.BOND_STATE] != C.FREE:
            continue
        gap, share, nx, ny, length = seen(c, nodes, k, 0.0)
        if abs(gap) > CLOSED * length or share < -CLOSED or share > 1.0 + CLOSED:
            continue
        if not (has_edges(c, p) and faces(c, nodes, p, nx, ny)):
            continue
        c.bonds[p, C.BOND_STATE], c.bonds[p, C.BOND_EDGE] = C.BOUND, e
        list_bond(c, p)
        c.bond_numbers[p, :] = 0.0
        c.bond_numbers[p, C.BOND_SHARE] = min(max(share, 0.0), 1.0)
