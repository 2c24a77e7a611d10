"""The short list of pairs that may touch in a step, and their movers; all other pairs and movers are skipped.

Points are assumed to move in straight lines with the velocities at the time the list was made. As long as no point deviates farther than
allowed for, no other pair can touch.
"""

import numba as nb

from hugoniot.core.target import BY_ADDRESS, INLINE
from hugoniot.solvers.lagrange2d import layout as L
from hugoniot.solvers.lagrange2d.contact import layout as C
from hugoniot.solvers.lagrange2d.contact.corners import BEYOND, DEEP, EDGE_END, beyond
from hugoniot.solvers.lagrange2d.contact.rigid import chord

IM = L.Nodes._fields.index("im")      # row of the node table
EVERY = 5          # steps between two looks at which pairs may meet
SPARE = 2.0        # times what points went astray from straight flight between the last two looks, they may between the next
LEAST_ASTRAY = 1e-3      # of the mean edge
MOST = 0.8         # of all pairs: where more are near, all are listed up to the next search
CLOSED = 1e-3        # of an edge: a gap that a bond bridges
ANY_WAY = 1e300    # how far points may go astray, and for how long, where all pairs are listed


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
    c.sizes[C.LISTED], c.sizes[C.POINTS], c.sizes[C.PUSHED] = 0, 0, 0


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
def may_meet(c, k, astray, time):
    """Whether a pair may meet within a time, if no two points go astray from straight flight relative to each other by more than `astray`:
    come behind its edge, not deep, and beside it or a little beyond its ends.

    An edge does not go on for the point at the other end of the next edge, which can only fold onto it.
    """
    p, a, b = c.pairs[k, C.PAIR_POINT], c.pairs[k, C.PAIR_FROM], c.pairs[k, C.PAIR_TO]
    (x, y, u, v), (dx, dy, du, dv) = from_point(c, p, a), from_point(c, b, a)
    size, away = abs(dx) + abs(dy) + time * (abs(du) + abs(dv)), abs(x) + abs(y) + time * (abs(u) + abs(v))
    least, most = swept(y * dx - x * dy, v * dx - u * dy + y * du - x * dv, v * du - u * dv, time)
    error, square = astray * (size + away + astray), (size + astray) ** 2
    if most + error < -CLOSED * square or least - error > DEEP * square:
        return False
    before, after = c.points[a, C.POINT_BEFORE], c.points[b, C.POINT_AFTER]
    on = EDGE_END if before >= 0 and c.edges[before, C.EDGE_A] == p else BEYOND
    least, most = swept(*along(x + on * dx, y + on * dy, u + on * du, v + on * dv, dx, dy, du, dv), time)
    error += 4.0 * astray * (size + astray)
    if most + error < 0.0:
        return False
    on = 1.0 + (EDGE_END if after >= 0 and c.edges[after, C.EDGE_B] == p else BEYOND)
    least, most = swept(*along(x - on * dx, y - on * dy, u - on * du, v - on * dv, dx, dy, du, dv), time)
    return least - error <= 0.0


@nb.njit(**INLINE)
def swept(value, rate, growth, time):
    """Bounds of a square function of time up to `time`."""
    slope, bend = time * rate, time * time * growth
    return value + min(slope, 0.0) + min(bend, 0.0), value + max(slope, 0.0) + max(bend, 0.0)


@nb.njit(**INLINE)
def along(x, y, u, v, dx, dy, du, dv):
    """(value, rate, growth) of the product of two ways that change steadily."""
    return x * dx + y * dy, u * dx + v * dy + x * du + y * dv, u * du + v * dv


@nb.njit(**INLINE)
def from_point(c, p, q):
    """Way from a point q to another in straight flight, and the velocity of that."""
    f, g = c.flight[p], c.flight[q]
    return (f[C.FLIGHT_X] - g[C.FLIGHT_X], f[C.FLIGHT_Y] - g[C.FLIGHT_Y], f[C.FLIGHT_U] - g[C.FLIGHT_U], f[C.FLIGHT_V] - g[C.FLIGHT_V])


@nb.njit(**BY_ADDRESS)
def stray_ends(c, nodes, dt):
    """By how much any two points have gone astray from straight flight relative to each other at most at the end of a step with mean
    velocities, those of movers where contact has changed them: the diagonal of the box that holds the ways of all."""
    left, bottom, right, top, time = 0.0, 0.0, 0.0, 0.0, c.looked[C.FLOWN] + dt
    vertices = c.points.shape[0] - (c.copies_start[c.movers.shape[0]] - c.copies_start[c.movers.shape[0] - c.rigid.shape[0]])
    for p in range(c.points.shape[0]):
        k, f, px, py = c.points[p, C.POINT_NODE], c.flight[p], c.places[p, C.AT_X], c.places[p, C.AT_Y]
        u, v = nodes[6, k], nodes[7, k]
        if c.marks[p] != 0 or p >= vertices:
            q = c.mover_numbers[c.points[p, C.POINT_MOVER]]
            if q[C.JX] != 0.0 or q[C.JY] != 0.0:
                u, v = q[C.U], q[C.V]
                if q[C.W] != 0.0:
                    x, y = chord(c.rigid[c.movers[c.points[p, C.POINT_MOVER], C.MOVER_RIGID]], px, py, dt * q[C.W])
                    u, v = u + x / dt, v + y / dt
        x, y = px + dt * u - f[C.FLIGHT_X] - time * f[C.FLIGHT_U], py + dt * v - f[C.FLIGHT_Y] - time * f[C.FLIGHT_V]
        left, bottom, right, top = min(left, x), min(bottom, y), max(right, x), max(top, y)
    return ((right - left) ** 2 + (top - bottom) ** 2) ** 0.5


@nb.njit(**BY_ADDRESS)
def list_near(c, nodes, dt, astray):
    """List the pairs that may meet in a step, with their points and movers, those of bonds and rigid bodies, unless the list that stands
    serves for it; astray: by how much points have gone astray from straight flight, at the end of the step too with the velocities of its
    start. Which further pairs are in the list changes nothing but the time it takes."""
    if c.sizes[C.NEAR] >= 0:
        c.looked[C.FARTHEST] = max(c.looked[C.FARTHEST], astray)
        if astray <= c.looked[C.ASTRAY] and c.looked[C.FLOWN] + dt <= c.looked[C.SERVES]:
            if c.binds:
                list_concerned(c, nodes)
            return
    look(c, nodes, dt, max(SPARE * c.looked[C.FARTHEST], LEAST_ASTRAY * c.numbers[C.MEAN_EDGE]))


@nb.njit(**BY_ADDRESS)
def look(c, nodes, dt, astray):
    """List the pairs that may meet in this step or in the next ones."""
    anew, count = c.sizes[C.NEAR] < 0, 0
    c.looked[C.FLOWN], c.looked[C.FARTHEST], c.looked[C.ASTRAY], c.looked[C.SERVES] = 0.0, 0.0, astray, EVERY * dt
    for p in range(c.points.shape[0]):
        k, f = c.points[p, C.POINT_NODE], c.flight[p]
        f[C.FLIGHT_X], f[C.FLIGHT_Y], f[C.FLIGHT_U], f[C.FLIGHT_V] = nodes[0, k], nodes[1, k], nodes[2, k], nodes[3, k]
    if anew:
        list_touched(c)
    same = not anew
    for k in range(c.counts[C.PAIRS]):
        if c.pair_numbers[k, C.LAST] != 0.0 or may_meet(c, k, astray, EVERY * dt):
            same = same and c.near[count, 0] == k
            c.near[count, 0] = k
            count += 1
    if count > MOST * c.counts[C.PAIRS]:
        c.looked[C.ASTRAY], c.looked[C.SERVES], same, count = ANY_WAY, ANY_WAY, False, c.counts[C.PAIRS]
        for k in range(count):
            c.near[k, 0] = k
    same, c.sizes[C.NEAR] = same and count == c.sizes[C.NEAR], count
    if not same or c.binds:
        list_concerned(c, nodes)


@nb.njit(**BY_ADDRESS)
def list_touched(c):
    """List the pairs that had an impulse in the last step."""
    count = 0
    for k in range(c.counts[C.PAIRS]):
        if c.pair_numbers[k, C.LAST] != 0.0:
            c.touched[count] = k
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
    if c.looked[C.ASTRAY] == ANY_WAY:
        c.sizes[C.PUSHED] = c.sizes[C.LISTED]
        for i in range(c.sizes[C.LISTED]):
            c.pushed[i] = c.listed[i]
