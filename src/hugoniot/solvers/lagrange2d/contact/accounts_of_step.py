"""Results of contact in a step: heat and friction into zones, impulses on constraints, forces, bonds that break."""

import numba as nb

from hugoniot.core.target import BY_ADDRESS, INLINE
from hugoniot.solvers.lagrange2d import layout as L
from hugoniot.solvers.lagrange2d.contact import layout as C
from hugoniot.solvers.lagrange2d.contact.active import remember
from hugoniot.solvers.lagrange2d.contact.corners import point_normal
from hugoniot.solvers.lagrange2d.contact.impulses import arm_of, arm_of_bond, movers, of_pair, relative, slip
from hugoniot.solvers.lagrange2d.contact.meeting import seen
from hugoniot.solvers.lagrange2d.contact.rigid import lead_on, place
from hugoniot.solvers.lagrange2d.quads import AREA_WEIGHTED, PLANAR

E, INVERSE_MASS = 3, 1      # rows of the zone table


@nb.njit(**INLINE)
def warm(c, p, e, heat):
    """Give heat to the zones on both sides of a pair in equal halves, all of it to one side where the other is rigid."""
    behind, before, after = c.edges[e, C.EDGE_ZONE], c.points[p, C.POINT_BEFORE], c.points[p, C.POINT_AFTER]
    first = c.edges[before, C.EDGE_ZONE] if before >= 0 else -1
    second = c.edges[after, C.EDGE_ZONE] if after >= 0 else -1
    first, second = (second if first < 0 else first), (first if second < 0 else second)
    sides = (1.0 if behind >= 0 else 0.0) + (1.0 if first >= 0 else 0.0)
    if sides == 0.0:
        return
    heat /= sides
    if behind >= 0:
        c.zones[E, behind] += heat * c.zones[INVERSE_MASS, behind]
    if first >= 0:
        c.zones[E, first] += 0.5 * heat * c.zones[INVERSE_MASS, first]
        c.zones[E, second] += 0.5 * heat * c.zones[INVERSE_MASS, second]


@nb.njit(**BY_ADDRESS)
def book_heat(c, start, dt):
    """Heat and friction of all pairs and bonds; start: 1 where velocities jumped from those before (their mean counts), 0 for mean ones."""
    old, new = 0.5 * start, 1.0 - 0.5 * start
    for i in range(c.counts[C.ACTIVE]):
        k = c.active[i]
        q, (s, a, b) = c.pair_numbers[k], of_pair(c, k)
        if q[C.LAMBDA] == 0.0 and q[C.TAU] == 0.0:
            continue
        u, v = relative(c, s, a, b, q[C.SHARE], arm_of(q), C.U)
        if start > 0.0:
            u0, v0 = relative(c, s, a, b, q[C.SHARE], arm_of(q), C.U0)
            u, v = old * u0 + new * u, old * v0 + new * v
        heat = -q[C.LAMBDA] * (u * q[C.NX] + v * q[C.NY])
        friction = -q[C.TAU] * (old * slip(c, q, s, a, b, C.U0) + new * slip(c, q, s, a, b, C.U)) if q[C.TAU] != 0.0 else 0.0
        c.numbers[C.HEAT] += heat
        c.numbers[C.FRICTION] += friction
        warm(c, c.pairs[k, C.PAIR_POINT], c.pairs[k, C.PAIR_EDGE], heat + friction)
    for i in range(c.sizes[C.BONDS]):
        p = c.bound[i]
        q, e = c.bond_numbers[p], c.bonds[p, C.BOND_EDGE]
        s, a, b = movers(c, p, e)
        u, v = relative(c, s, a, b, q[C.BOND_SHARE], arm_of_bond(q), C.U)
        u0, v0 = relative(c, s, a, b, q[C.BOND_SHARE], arm_of_bond(q), C.U0)
        heat = -(q[C.BOND_X] * (old * u0 + new * u) + q[C.BOND_Y] * (old * v0 + new * v))
        c.numbers[C.HEAT] += heat
        warm(c, p, e, heat)


@nb.njit(**BY_ADDRESS)
def book_holds(c, start):
    """Impulse and work of walls, axis, driven edges and rigid bodies against contact."""
    old, new = 0.5 * start, 1.0 - 0.5 * start
    for m in c.held:
        q, first, second = c.mover_numbers[m], c.movers[m, C.MOVER_CHAIN_1], c.movers[m, C.MOVER_CHAIN_2]
        if q[C.JX] == 0.0 and q[C.JY] == 0.0:
            continue
        u, v = old * q[C.U0] + new * q[C.U], old * q[C.V0] + new * q[C.V]
        if c.movers[m, C.MOVER_RIGID] >= 0:
            book(c.chains, first, -q[C.JX], -q[C.JY], u, v)
            c.chains[first, L.CHAIN_WORK] -= q[C.JW] * (old * q[C.W0] + new * q[C.W])
            continue
        x = q[C.JX] - (q[C.PXX] * q[C.JX] + q[C.PXY] * q[C.JY])
        y = q[C.JY] - (q[C.PXY] * q[C.JX] + q[C.PYY] * q[C.JY])
        a, b = x * q[C.H1X] + y * q[C.H1Y], 0.0
        if second >= 0:
            b, overlap = x * q[C.H2X] + y * q[C.H2Y], q[C.H1X] * q[C.H2X] + q[C.H1Y] * q[C.H2Y]
            over = 1.0 / (1.0 - overlap * overlap)
            a, b = (a - overlap * b) * over, (b - overlap * a) * over
            book(c.chains, second, -b * q[C.H2X], -b * q[C.H2Y], u, v)
        book(c.chains, first, -a * q[C.H1X], -a * q[C.H1Y], u, v)


@nb.njit(**BY_ADDRESS)
def book(chains, chain, x, y, u, v):
    """An impulse on the material, and its work."""
    chains[chain, L.CHAIN_WORK] += x * u + y * v
    chains[chain, L.CHAIN_IMPULSE_X] += x
    chains[chain, L.CHAIN_IMPULSE_Y] += y


@nb.njit(**BY_ADDRESS)
def area(c, p, kind):
    """Area of the surface that belongs to a point at the end of a step: half of its edges, times the radius in axisymmetric flow."""
    found, (own, _) = 0.0, place(c, p, 1.0)
    for column in (C.POINT_BEFORE, C.POINT_AFTER):
        e = c.points[p, column]
        if e >= 0:
            (ax, ay), (bx, by) = place(c, c.edges[e, C.EDGE_A], 1.0), place(c, c.edges[e, C.EDGE_B], 1.0)
            length = ((ax - bx) ** 2 + (ay - by) ** 2) ** 0.5
            other = ax + bx - own
            radius = 1.0 if kind == PLANAR else own if kind == AREA_WEIGHTED else (2.0 * own + other) / 3.0
            found += 0.5 * length * radius
    return found


@nb.njit(**BY_ADDRESS)
def accept(c, dt):
    """Book the step that was taken."""
    c.looked[C.FLOWN] += dt
    c.of_points[:, C.FORCE_X] = 0.0
    c.of_points[:, C.FORCE_Y] = 0.0
    lead_on(c, dt)
    book_heat(c, 0.0, dt)
    last = -1
    for i in range(c.counts[C.ACTIVE]):
        k = c.active[i]
        q, p = c.pair_numbers[k], c.pairs[k, C.PAIR_POINT]
        if q[C.LAMBDA] == 0.0:
            continue
        gap, _, _, _, length = seen(c, k, 1.0)
        c.numbers[C.DEEPEST] = max(c.numbers[C.DEEPEST], -gap / length)
        if p != last:
            s, a, b = of_pair(c, k)
            c.of_points[p, C.SLID] += dt * abs(slip(c, q, s, a, b, C.U))
            last = p
    for i in range(c.sizes[C.POINTS]):
        p, m = c.near_points[i, 0], c.near_points[i, 1]
        if c.movers[m, C.MOVER_RIGID] < 0:
            c.of_points[p, C.FORCE_X], c.of_points[p, C.FORCE_Y] = c.mover_numbers[m, C.JX] / dt, c.mover_numbers[m, C.JY] / dt
    remember(c)
    break_bonds(c, dt)


@nb.njit(**BY_ADDRESS)
def break_bonds(c, dt):
    """Bonds whose tension over the area of their point exceeds their strength."""
    for i in range(c.sizes[C.BONDS]):
        p = c.bound[i]
        e, q = c.bonds[p, C.BOND_EDGE], c.bond_numbers[p]
        law = c.law_of[c.points[p, C.POINT_PART], c.edges[e, C.EDGE_PART]]
        if int(c.laws[law, C.LAW_KIND]) == C.SEPARABLE:
            x, y = point_normal(c, p, 1.0)
            if q[C.BOND_X] * x + q[C.BOND_Y] * y > c.laws[law, C.LAW_STRENGTH] * area(c, p, c.kind) * dt:
                c.bonds[p, C.BOND_STATE] = C.BROKEN
                c.counts[C.BROKEN_BONDS] += 1
