"""Search for points that may touch edges: edges are sorted into square cells, and each point is tested against nine cells."""

import numba as nb

from hugoniot.core.target import BY_ADDRESS, INLINE
from hugoniot.solvers.lagrange2d.contact import layout as C
from hugoniot.solvers.lagrange2d.contact.near import ANY_WAY, distance, list_near

EVERY = 4            # steps after which the motion of points is counted anew
AHEAD = 2.0          # times what the velocities at the start of a step say of its motion: they may grow in it


@nb.njit(**BY_ADDRESS)
def spreads(c, nodes, dt):
    """By how much the velocities of any two points differ at most, their displacements counted from `since`, and what they have gone astray
    from straight flight, at the start of a step and at its end with the velocities of its start: the diagonals of the boxes that hold
    those of all points. Notes where points are."""
    left, bottom, right, top = 1e300, 1e300, -1e300, -1e300
    west, south, east, north = left, bottom, right, top
    x0, y0, x1, y1, time, flying = 0.0, 0.0, 0.0, 0.0, c.looked[C.FLOWN], c.sizes[C.NEAR] >= 0 and c.looked[C.ASTRAY] != ANY_WAY
    for p in range(c.points.shape[0]):
        k = c.points[p, C.POINT_NODE]
        x, y, u, v = nodes[0, k], nodes[1, k], nodes[2, k], nodes[3, k]
        c.places[p, C.AT_X], c.places[p, C.AT_Y] = x, y
        dx, dy = x - c.since[p, 0], y - c.since[p, 1]
        left, bottom, right, top = min(left, u), min(bottom, v), max(right, u), max(top, v)
        west, south, east, north = min(west, dx), min(south, dy), max(east, dx), max(north, dy)
        if flying:
            f = c.flight[p]
            du, dv = dt * (u - f[C.FLIGHT_U]), dt * (v - f[C.FLIGHT_V])
            x, y = x - f[C.FLIGHT_X] - time * f[C.FLIGHT_U], y - f[C.FLIGHT_Y] - time * f[C.FLIGHT_V]
            x0, y0, x1, y1 = min(x0, x, x + du), min(y0, y, y + dv), max(x1, x, x + du), max(y1, y, y + dv)
    return diagonal(right - left, top - bottom), diagonal(east - west, north - south), diagonal(x1 - x0, y1 - y0)


@nb.njit(**INLINE)
def diagonal(width, height):
    """Of a box."""
    return (width * width + height * height) ** 0.5


@nb.njit(**BY_ADDRESS)
def grid(c, x, y):
    """(left, bottom, cell, columns, rows) of cells as wide as the reach and half the longest edge, or wider where there are too many."""
    left, bottom, right, top, longest = 1e300, 1e300, -1e300, -1e300, 0.0
    for e in range(c.edges.shape[0]):
        a, b = c.points[c.edges[e, C.EDGE_A], C.POINT_NODE], c.points[c.edges[e, C.EDGE_B], C.POINT_NODE]
        left, bottom = min(left, x[a], x[b]), min(bottom, y[a], y[b])
        right, top = max(right, x[a], x[b]), max(top, y[a], y[b])
        longest = max(longest, (x[a] - x[b]) ** 2 + (y[a] - y[b]) ** 2)
    cell = c.numbers[C.REACH] + 0.5 * longest**0.5
    most = c.cells.shape[0] - 1
    while int((right - left) / cell + 1.0) * int((top - bottom) / cell + 1.0) > most:
        cell *= 1.5
    return left, bottom, cell, int((right - left) / cell + 1.0), int((top - bottom) / cell + 1.0)


@nb.njit(**BY_ADDRESS)
def sort_edges(c, x, y, left, bottom, cell, columns, rows):
    """Edges by the cell of their middle, in their order within a cell, each with the box in which points are within reach."""
    count = columns * rows
    c.cells[:count + 1] = 0
    for again in range(2):
        for e in range(c.edges.shape[0]):
            a, b = c.points[c.edges[e, C.EDGE_A], C.POINT_NODE], c.points[c.edges[e, C.EDGE_B], C.POINT_NODE]
            i = min(int((0.5 * (x[a] + x[b]) - left) / cell), columns - 1)
            j = min(int((0.5 * (y[a] + y[b]) - bottom) / cell), rows - 1)
            at = i * rows + j
            if again == 0:
                c.cells[at + 1] += 1
            else:
                n, c.cells[at] = c.cells[at], c.cells[at] + 1
                c.sorted_edges[n] = e
                c.boxes[n, 0], c.boxes[n, 1] = min(x[a], x[b]) - c.numbers[C.REACH], max(x[a], x[b]) + c.numbers[C.REACH]
                c.boxes[n, 2], c.boxes[n, 3] = min(y[a], y[b]) - c.numbers[C.REACH], max(y[a], y[b]) + c.numbers[C.REACH]
        if again == 0:
            for k in range(count):
                c.cells[k + 1] += c.cells[k]
    for k in range(count, 0, -1):      # each start has run on to the next one
        c.cells[k] = c.cells[k - 1]
    c.cells[0] = 0


@nb.njit(**BY_ADDRESS)
def set_aside(c):
    """Keep the pairs that had impulses in the last step, by point, for the next list of pairs."""
    count = 0
    for k in range(c.counts[C.PAIRS]):
        if c.pair_numbers[k, C.LAST] != 0.0:
            c.old_pairs[count, 0], c.old_pairs[count, 1] = c.pairs[k, C.PAIR_POINT], c.pairs[k, C.PAIR_EDGE]
            for n in range(c.pair_numbers.shape[1]):
                c.old_numbers[count, n] = c.pair_numbers[k, n]
            count += 1
    c.counts[C.OLD_PAIRS] = count


@nb.njit(**BY_ADDRESS)
def take_over(c, count, old):
    """Give the pair `count` the impulses it had in the last step and their directions; `old`: where to look in the old list.

    Returns where its point begins there.
    """
    p, e, last = c.pairs[count, C.PAIR_POINT], c.pairs[count, C.PAIR_EDGE], c.counts[C.OLD_PAIRS]
    c.pair_numbers[count, C.LAST], c.pair_numbers[count, C.LAST_TAU] = 0.0, 0.0
    while old < last and c.old_pairs[old, 0] < p:
        old += 1
    k = old
    while k < last and c.old_pairs[k, 0] == p:
        if c.old_pairs[k, 1] == e:
            for n in range(c.pair_numbers.shape[1]):
                c.pair_numbers[count, n] = c.old_numbers[k, n]
        k += 1
    return old


@nb.njit(**BY_ADDRESS)
def describe(c, k):
    """What the pair k is looked up for in every step: its movers, its points, its friction."""
    p, q, e = c.pairs[k, C.PAIR_POINT], c.pairs[k], c.edges[c.pairs[k, C.PAIR_EDGE]]
    q[C.PAIR_FROM], q[C.PAIR_TO] = e[C.EDGE_A], e[C.EDGE_B]
    for n, m in enumerate((p, q[C.PAIR_FROM], q[C.PAIR_TO])):
        q[C.PAIR_S + n] = c.points[m, C.POINT_MOVER]
    friction = c.laws[c.law_of[c.points[p, C.POINT_PART], e[C.EDGE_PART]], C.LAW_FRICTION]
    turns = c.mover_numbers[q[C.PAIR_S], C.II] > 0.0 or c.mover_numbers[q[C.PAIR_A], C.II] > 0.0
    c.pair_numbers[k, C.COULOMB], c.pair_numbers[k, C.MORE] = friction, 1.0 if friction > 0.0 or turns else 0.0


@nb.njit(**BY_ADDRESS)
def search(c, nodes):
    """List the pairs within reach, by point; False where the table is too short for them, which then is empty."""
    x, y = nodes[0], nodes[1]
    left, bottom, cell, columns, rows = grid(c, x, y)
    sort_edges(c, x, y, left, bottom, cell, columns, rows)
    if c.counts[C.FULL] == 0:
        set_aside(c)
    reach, count, old = c.numbers[C.REACH], 0, 0
    for p in range(c.points.shape[0]):
        k, part = c.points[p, C.POINT_NODE], c.points[p, C.POINT_PART]
        px, py, c.points[p, C.POINT_FIRST] = x[k], y[k], count
        i, j = int((px - left) / cell), int((py - bottom) / cell)
        for m in range(max(i - 1, 0), min(i + 2, columns)):
            for n in range(max(j - 1, 0), min(j + 2, rows)):
                for q in range(c.cells[m * rows + n], c.cells[m * rows + n + 1]):
                    if px < c.boxes[q, 0] or px > c.boxes[q, 1] or py < c.boxes[q, 2] or py > c.boxes[q, 3]:
                        continue
                    e = c.sorted_edges[q]
                    if c.law_of[part, c.edges[e, C.EDGE_PART]] < 0 or c.edges[e, C.EDGE_A] == p or c.edges[e, C.EDGE_B] == p:
                        continue
                    a, b = c.points[c.edges[e, C.EDGE_A], C.POINT_NODE], c.points[c.edges[e, C.EDGE_B], C.POINT_NODE]
                    if distance(px, py, x[a], y[a], x[b], y[b], 0.0, 0.0)[0] > reach:
                        continue
                    if count == c.pairs.shape[0]:
                        c.counts[C.PAIRS], c.counts[C.FULL] = 0, 1
                        return False
                    c.pairs[count, C.PAIR_POINT], c.pairs[count, C.PAIR_EDGE] = p, e
                    c.pairs[count, C.PAIR_ACTIVE] = C.OFF
                    old = take_over(c, count, old)
                    describe(c, count)
                    count += 1
        c.since[p, 0], c.since[p, 1] = px, py
    c.counts[C.PAIRS], c.counts[C.FULL], c.sizes[C.NEAR] = count, 0, -1
    c.counts[C.SEARCHES] += 1
    return True


@nb.njit(**BY_ADDRESS)
def count_from_now(c, moved):
    """Count the motion of points from where they are now; the search reaches less far by what they have moved."""
    for p in range(c.points.shape[0]):
        c.since[p, 0], c.since[p, 1] = c.places[p, C.AT_X], c.places[p, C.AT_Y]
    c.numbers[C.REACH] -= moved


@nb.njit(**BY_ADDRESS)
def make_ready(c, nodes, dt):
    """List the pairs that may meet in the step, after a search if the last one is worth nothing: where points have moved relative to
    each other, or will in this step, farther than it looked. False where there is no room for what it found."""
    speed, moved, astray = spreads(c, nodes, dt)
    ahead = AHEAD * dt * speed
    if c.counts[C.SEARCHES] == 0 or c.counts[C.FULL] != 0 or moved + ahead > c.numbers[C.REACH]:
        c.numbers[C.REACH] = max(0.5 * c.numbers[C.MEAN_EDGE], 3.0 * ahead)
        if not search(c, nodes):
            return False
    elif c.counts[C.STEPS] % EVERY == 0:
        count_from_now(c, moved)
    c.counts[C.STEPS] += 1
    list_near(c, nodes, dt, astray)
    return True
