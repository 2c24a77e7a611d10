r"""The velocities closest to the free ones that no constraint forbids, by Gauss's principle of least constraint.

Movers have masses $M$ and free velocities $u^*$. Contact may not let a point go deeper: $n\cdot(u_s - (1-t)u_a - t u_b) \ge \ell$ for every
pair of a point s and an edge from a to b. The velocities that minimise $\sum M|u - u^*|^2$ under these inequalities are unique; their
multipliers $\lambda \ge 0$ are the impulses of contact, equal and opposite on both sides, zero where surfaces separate. Neither side
is master. Relaxation finds them: one pair after the other gets the impulse that just satisfies it, none pulls, and friction
gets the tangential impulse that stops the sliding, at most its coefficient times $\lambda$ (J. J. Moreau, Int. Centre Mech. Sci. 302
(1988) 1; M. Jean, Comput. Methods Appl. Mech. Eng. 177 (1999) 235). What a sweep changes is the gradient of a method of conjugate
gradients, without which nodes that nearly face each other would take hundreds of sweeps (M. Silcowitz-Hansen, S. Niebe, K. Erleben,
The Visual Computer 26 (2010) 893).
"""

import numba as nb

from hugoniot.core.target import BY_ADDRESS, INLINE
from hugoniot.solvers.lagrange2d.contact import layout as C

ENOUGH_SWEEPS, MOST_SWEEPS = 8, 80      # the more only where nodes would end far behind surfaces
CLOSE_ENOUGH = 5e-4      # of the largest change that contact makes to a velocity


@nb.njit(**INLINE)
def along(c, m, x, y):
    """Inverse mass of a mover along a unit vector."""
    n = c.mover_numbers
    return n[m, C.IM] * (n[m, C.PXX] * x * x + 2.0 * n[m, C.PXY] * x * y + n[m, C.PYY] * y * y)


@nb.njit(**INLINE)
def response(c, m, x, y):
    """Change of the velocity of a mover by the impulse (x, y)."""
    n = c.mover_numbers
    return n[m, C.IM] * (n[m, C.PXX] * x + n[m, C.PXY] * y), n[m, C.IM] * (n[m, C.PXY] * x + n[m, C.PYY] * y)


@nb.njit(**INLINE)
def turner(s, a, arm):
    """Which of the movers of a point and an edge turns."""
    return s if arm[0] > 0.0 else a


@nb.njit(**INLINE)
def inverse_mass(c, s, a, b, t, arm, x, y):
    """Change along (x, y) of the velocity of mover s relative to the place t between movers a and b by a unit impulse along it."""
    turn = 0.0
    if arm[0] != 0.0:
        turn = c.mover_numbers[turner(s, a, arm), C.II] * (arm[1] * y - arm[2] * x) ** 2
    if a == b:
        return along(c, s, x, y) + along(c, a, x, y) + turn
    return along(c, s, x, y) + (1.0 - t) ** 2 * along(c, a, x, y) + t * t * along(c, b, x, y) + turn


@nb.njit(**INLINE)
def movers(c, p, e):
    """Movers of a point and of the ends of an edge."""
    return (c.points[p, C.POINT_MOVER], c.points[c.edges[e, C.EDGE_A], C.POINT_MOVER], c.points[c.edges[e, C.EDGE_B], C.POINT_MOVER])


@nb.njit(**INLINE)
def columns(c, p, e):
    """Columns of the nodes of a point and of the ends of an edge."""
    return c.points[p, C.POINT_NODE], c.points[c.edges[e, C.EDGE_A], C.POINT_NODE], c.points[c.edges[e, C.EDGE_B], C.POINT_NODE]


@nb.njit(**INLINE)
def of_pair(c, k):
    """Movers of a pair."""
    return c.pairs[k, C.PAIR_S], c.pairs[k, C.PAIR_A], c.pairs[k, C.PAIR_B]


@nb.njit(**INLINE)
def arm_of(q):
    """(side, x, y) of a pair: which of its movers turns, and the way from the centre of that to where the impulse acts."""
    return q[C.SIDE], q[C.ARM_X], q[C.ARM_Y]


@nb.njit(**INLINE)
def arm_of_bond(q):
    """The same of a bond."""
    return q[C.BOND_SIDE], q[C.BOND_ARM_X], q[C.BOND_ARM_Y]


@nb.njit(**INLINE)
def relative(c, s, a, b, t, arm, u):
    """Velocity of mover s relative to the place t between movers a and b; u: its first column, before those of y and of turning."""
    n = c.mover_numbers
    x, y = n[s, u] - (1.0 - t) * n[a, u] - t * n[b, u], n[s, u + 1] - (1.0 - t) * n[a, u + 1] - t * n[b, u + 1]
    if arm[0] != 0.0:
        spin = arm[0] * n[turner(s, a, arm), u + 2]
        x, y = x - spin * arm[2], y + spin * arm[1]
    return x, y


@nb.njit(**INLINE)
def push(c, m, x, y, part):
    """Give a mover an impulse; its velocity changes by `part` of impulse over mass."""
    n, (u, v) = c.mover_numbers, response(c, m, x, y)
    n[m, C.JX], n[m, C.JY] = n[m, C.JX] + x, n[m, C.JY] + y
    n[m, C.U], n[m, C.V] = n[m, C.U] + part * u, n[m, C.V] + part * v


@nb.njit(**INLINE)
def exchange(c, s, a, b, t, arm, x, y, part):
    """Give mover s an impulse and movers a and b the opposite one."""
    push(c, s, x, y, part)
    push(c, a, -(1.0 - t) * x, -(1.0 - t) * y, part)
    push(c, b, -t * x, -t * y, part)
    if arm[0] != 0.0:
        m, n, moment = turner(s, a, arm), c.mover_numbers, arm[0] * (arm[1] * y - arm[2] * x)
        n[m, C.JW] += moment
        n[m, C.W] += part * n[m, C.II] * moment


@nb.njit(**INLINE)
def slip(c, q, s, a, b, u):
    """How fast a pair slides: along the edge, in the frame that turns with it, where the point is; u as in `relative`."""
    n = c.mover_numbers
    x, y = relative(c, s, a, b, q[C.SHARE], arm_of(q), u)
    turn = (n[b, u] - n[a, u]) * q[C.NX] + (n[b, u + 1] - n[a, u + 1]) * q[C.NY]
    return y * q[C.NX] - x * q[C.NY] + q[C.LIFT] * turn


@nb.njit(**INLINE)
def rub(c, q, s, a, b, more, part):
    """Give a pair `more` of an impulse along its edge. Across a gap it has a moment, which a couple of impulses on the ends takes back."""
    exchange(c, s, a, b, q[C.SHARE], arm_of(q), -more * q[C.NY], more * q[C.NX], part)
    if a != b:
        x, y = q[C.LIFT] * more * q[C.NX], q[C.LIFT] * more * q[C.NY]
        push(c, a, -x, -y, part)
        push(c, b, x, y, part)


@nb.njit(**BY_ADDRESS)
def weight_of_friction(c, q, s, a, b):
    """Change of the slip of a pair by a unit impulse of friction."""
    x, y, t, arm = -q[C.NY], q[C.NX], q[C.SHARE], arm_of(q)
    if a == b:
        return inverse_mass(c, s, a, b, t, arm, x, y)
    turn = 0.0 if arm[0] == 0.0 else c.mover_numbers[turner(s, a, arm), C.II] * (arm[1] * y - arm[2] * x) ** 2
    lift_x, lift_y = q[C.LIFT] * q[C.NX], q[C.LIFT] * q[C.NY]
    edge = along(c, a, (1.0 - t) * x + lift_x, (1.0 - t) * y + lift_y) + along(c, b, t * x - lift_x, t * y - lift_y)
    return along(c, s, x, y) + edge + turn


@nb.njit(**INLINE)
def along_normal(c, q, s, a, b, more):
    """Change velocities by `more` of an impulse of a pair along its normal; the impulses of movers are added up in `restart`."""
    n = c.mover_numbers
    n[s, C.U], n[s, C.V] = n[s, C.U] + more * q[C.SX], n[s, C.V] + more * q[C.SY]
    n[a, C.U], n[a, C.V] = n[a, C.U] + more * q[C.AX], n[a, C.V] + more * q[C.AY]
    n[b, C.U], n[b, C.V] = n[b, C.U] + more * q[C.BX], n[b, C.V] + more * q[C.BY]
    if q[C.SIDE] != 0.0:
        n[turner(s, a, arm_of(q)), C.W] += more * q[C.TURN]


@nb.njit(**BY_ADDRESS)
def restart(c, part):
    """Velocities from those before and the impulses of all pairs and bonds, along their present directions."""
    n = c.mover_numbers
    for i in range(c.sizes[C.LISTED]):
        m = c.listed[i]
        n[m, C.U], n[m, C.V], n[m, C.W] = n[m, C.U0], n[m, C.V0], n[m, C.W0]
        n[m, C.JX], n[m, C.JY], n[m, C.JW] = 0.0, 0.0, 0.0
    for i in range(c.counts[C.ACTIVE]):
        k = c.active[i]
        q, (s, a, b) = c.pair_numbers[k], of_pair(c, k)
        exchange(c, s, a, b, q[C.SHARE], arm_of(q), q[C.LAMBDA] * q[C.NX], q[C.LAMBDA] * q[C.NY], part)
        if q[C.TAU] != 0.0:
            rub(c, q, s, a, b, q[C.TAU], part)
    for i in range(c.sizes[C.BONDS]):
        p = c.bound[i]
        q, (s, a, b) = c.bond_numbers[p], movers(c, p, c.bonds[p, C.BOND_EDGE])
        exchange(c, s, a, b, q[C.BOND_SHARE], arm_of_bond(q), q[C.BOND_X], q[C.BOND_Y], part)


@nb.njit(**INLINE)
def relax_pair(c, k, part):
    """Satisfy one pair; the change of its velocity."""
    q, (s, a, b) = c.pair_numbers[k], of_pair(c, k)
    nx, ny, t, change = q[C.NX], q[C.NY], q[C.SHARE], 0.0
    if q[C.WN] == 0.0:
        return 0.0
    arm = arm_of(q)
    u, v = relative(c, s, a, b, t, arm, C.U)
    new = max(0.0, q[C.LAMBDA] + (q[C.LEAST] - (u * nx + v * ny)) * q[C.MASS] / part)
    more = new - q[C.LAMBDA]
    q[C.LAMBDA] = new
    if more != 0.0:
        along_normal(c, q, s, a, b, part * more)
        change = abs(more) * part * q[C.WN]
    most = q[C.COULOMB] * new
    if q[C.WT] > 0.0 and (most > 0.0 or q[C.TAU] != 0.0):
        new = min(max(q[C.TAU] + (q[C.AIM] - slip(c, q, s, a, b, C.U)) / (part * q[C.WT]), -most), most)
        more = new - q[C.TAU]
        q[C.TAU] = new
        rub(c, q, s, a, b, more, part)
        change = max(change, abs(more) * part * q[C.WT])
    return change


@nb.njit(**BY_ADDRESS)
def relax_bond(c, p, part):
    """Satisfy the bond of a point; the change of its velocity."""
    q, change, (s, a, b) = c.bond_numbers[p], 0.0, movers(c, p, c.bonds[p, C.BOND_EDGE])
    t, arm = q[C.BOND_SHARE], arm_of_bond(q)
    for k in range(2):
        w = q[C.BOND_WX + k]
        if w > 0.0:
            u, v = relative(c, s, a, b, t, arm, C.U)
            missing = q[C.BOND_AIM_X] - u if k == 0 else q[C.BOND_AIM_Y] - v
            more = missing / (part * w)
            q[C.BOND_X + k] += more
            exchange(c, s, a, b, t, arm, more if k == 0 else 0.0, more if k == 1 else 0.0, part)
            change = max(change, abs(missing))
    return change


@nb.njit(**BY_ADDRESS)
def weigh_bonds(c):
    """Inverse masses of the bonds."""
    for i in range(c.sizes[C.BONDS]):
        p = c.bound[i]
        q, (s, a, b) = c.bond_numbers[p], movers(c, p, c.bonds[p, C.BOND_EDGE])
        q[C.BOND_WX] = inverse_mass(c, s, a, b, q[C.BOND_SHARE], arm_of_bond(q), 1.0, 0.0)
        q[C.BOND_WY] = inverse_mass(c, s, a, b, q[C.BOND_SHARE], arm_of_bond(q), 0.0, 1.0)


@nb.njit(**BY_ADDRESS)
def sweep_once(c, part, forward):
    """Satisfy all active pairs and all bonds one after the other; (largest change of a velocity, square of the change of the impulses)."""
    change, square, pairs, bonds = 0.0, 0.0, c.counts[C.ACTIVE], c.sizes[C.BONDS]
    for i in range(pairs):
        k = c.active[i if forward else pairs - 1 - i]
        q = c.pair_numbers[k]
        q[C.OLD], q[C.OLD_TAU] = q[C.LAMBDA], q[C.TAU]
        change = max(change, relax_pair(c, k, part))
        square += q[C.WN] * (q[C.LAMBDA] - q[C.OLD]) ** 2 + q[C.WT] * (q[C.TAU] - q[C.OLD_TAU]) ** 2
    for i in range(bonds):
        p = c.bound[i if forward else bonds - 1 - i]
        q = c.bond_numbers[p]
        q[C.BOND_OLD_X], q[C.BOND_OLD_Y] = q[C.BOND_X], q[C.BOND_Y]
        change = max(change, relax_bond(c, p, part))
        square += q[C.BOND_WX] * (q[C.BOND_X] - q[C.BOND_OLD_X]) ** 2 + q[C.BOND_WY] * (q[C.BOND_Y] - q[C.BOND_OLD_Y]) ** 2
    c.counts[C.SWEEPS] += 1
    return change, square


@nb.njit(**BY_ADDRESS)
def go_on(c, part, share):
    """Add `share` of the direction of search to the impulses, and the change of the last sweep to the direction."""
    for i in range(c.counts[C.ACTIVE]):
        k = c.active[i]
        q, (s, a, b) = c.pair_numbers[k], of_pair(c, k)
        x, y = share * q[C.WAY], share * q[C.WAY_TAU]
        q[C.WAY], q[C.WAY_TAU] = x + q[C.LAMBDA] - q[C.OLD], y + q[C.TAU] - q[C.OLD_TAU]
        if x != 0.0:
            q[C.LAMBDA] += x
            along_normal(c, q, s, a, b, part * x)
        if y != 0.0:
            q[C.TAU] += y
            rub(c, q, s, a, b, y, part)
    for i in range(c.sizes[C.BONDS]):
        p = c.bound[i]
        q = c.bond_numbers[p]
        x, y = share * q[C.BOND_WAY_X], share * q[C.BOND_WAY_Y]
        q[C.BOND_WAY_X], q[C.BOND_WAY_Y] = x + q[C.BOND_X] - q[C.BOND_OLD_X], y + q[C.BOND_Y] - q[C.BOND_OLD_Y]
        if share > 0.0:
            q[C.BOND_X] += x
            q[C.BOND_Y] += y
            s, a, b = movers(c, p, c.bonds[p, C.BOND_EDGE])
            exchange(c, s, a, b, q[C.BOND_SHARE], arm_of_bond(q), x, y, part)


@nb.njit(**BY_ADDRESS)
def largest(c):
    """Largest change of velocity that contact makes."""
    n, found = c.mover_numbers, 0.0
    for i in range(c.sizes[C.LISTED]):
        m = c.listed[i]
        found = max(found, abs(n[m, C.U] - n[m, C.U0]), abs(n[m, C.V] - n[m, C.V0]))
    return found


@nb.njit(**BY_ADDRESS)
def relax(c, part, least, enough):
    """Satisfy all active pairs and all bonds; changes of velocity below `least` do not count. The largest change that contact makes.

    After some sweeps changes of velocity below `enough` will do.
    """
    before = whole = 0.0
    weigh_bonds(c)
    for sweep in range(MOST_SWEEPS):
        change, square = sweep_once(c, part, sweep % 2 == 0)
        if sweep == 0:
            whole = largest(c)
        if change <= max(least, CLOSE_ENOUGH * whole) or (sweep >= ENOUGH_SWEEPS - 1 and change <= enough) or sweep == MOST_SWEEPS - 1:
            break
        go_on(c, part, square / before if sweep > 0 and square <= before else 0.0)
        before = square
    return whole
