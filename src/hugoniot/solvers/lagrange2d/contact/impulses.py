r"""The velocities closest to the free ones that no constraint forbids, by Gauss's principle of least constraint.

Movers have masses $M$ and free velocities $u^*$. Contact prevents penetration: $n\cdot(u_s - (1-t)u_a - t u_b) \ge \ell$ for every
pair of a point s and an edge from a to b. The velocities that minimise $\sum M|u - u^*|^2$ under these inequalities are unique. The
Lagrange multipliers $\lambda \ge 0$ are the impulses of contact, equal and opposite on both sides, zero where surfaces separate. There is
no distinction between master and slave. The impulses are found by relaxation: each pair in turn receives the impulse that just satisfies
its inequality (never a tensile one), and friction the tangential impulse that stops the sliding, at most its coefficient times $\lambda$
(J. J. Moreau, Int. Centre Mech. Sci. 302 (1988) 1; M. Jean, Comput. Methods Appl. Mech. Eng. 177 (1999) 235). The change made by a sweep is
the gradient in a method of conjugate gradients, without which nodes that nearly face each other would take hundreds of sweeps (M.
Silcowitz-Hansen, S. Niebe, K. Erleben, The Visual Computer 26 (2010) 893).
"""

import numba as nb

from hugoniot.core.target import BY_ADDRESS, INLINE
from hugoniot.solvers.lagrange2d.contact import layout as C


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
def push(c, m, x, y):
    """Change the velocity of a mover by that of an impulse."""
    n, (u, v) = c.mover_numbers, response(c, m, x, y)
    n[m, C.U], n[m, C.V] = n[m, C.U] + u, n[m, C.V] + v


@nb.njit(**INLINE)
def exchange(c, s, a, b, t, arm, x, y):
    """Change velocities by an impulse on mover s and the opposite one on movers a and b."""
    push(c, s, x, y)
    push(c, a, -(1.0 - t) * x, -(1.0 - t) * y)
    push(c, b, -t * x, -t * y)
    if arm[0] != 0.0:
        m, n = turner(s, a, arm), c.mover_numbers
        n[m, C.W] += n[m, C.II] * arm[0] * (arm[1] * y - arm[2] * x)


@nb.njit(**INLINE)
def add(c, m, x, y):
    """Add an impulse to those of a mover."""
    n = c.mover_numbers
    n[m, C.JX], n[m, C.JY] = n[m, C.JX] + x, n[m, C.JY] + y


@nb.njit(**INLINE)
def add_to_all(c, s, a, b, t, arm, x, y):
    """Add an impulse to those of mover s and the opposite one to those of movers a and b."""
    add(c, s, x, y)
    add(c, a, -(1.0 - t) * x, -(1.0 - t) * y)
    add(c, b, -t * x, -t * y)
    if arm[0] != 0.0:
        c.mover_numbers[turner(s, a, arm), C.JW] += arm[0] * (arm[1] * y - arm[2] * x)


@nb.njit(**INLINE)
def slip(c, q, s, a, b, u):
    """How fast a pair slides: along the edge, in the frame that turns with it, where the point is; u as in `relative`."""
    n = c.mover_numbers
    x, y = relative(c, s, a, b, q[C.SHARE], arm_of(q), u)
    turn = (n[b, u] - n[a, u]) * q[C.NX] + (n[b, u + 1] - n[a, u + 1]) * q[C.NY]
    return y * q[C.NX] - x * q[C.NY] + q[C.LIFT] * turn


@nb.njit(**INLINE)
def rub(c, q, s, a, b, more):
    """Change velocities by `more` of an impulse of a pair along its edge. Across a gap it has a moment, which a couple of impulses on the
    ends takes back."""
    exchange(c, s, a, b, q[C.SHARE], arm_of(q), -more * q[C.NY], more * q[C.NX])
    if a != b:
        x, y = q[C.LIFT] * more * q[C.NX], q[C.LIFT] * more * q[C.NY]
        push(c, a, -x, -y)
        push(c, b, x, y)


@nb.njit(**INLINE)
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
    """Change velocities by `more` of an impulse of a pair along its normal."""
    n = c.mover_numbers
    n[s, C.U], n[s, C.V] = n[s, C.U] + more * q[C.SX], n[s, C.V] + more * q[C.SY]
    n[a, C.U], n[a, C.V] = n[a, C.U] + more * q[C.AX], n[a, C.V] + more * q[C.AY]
    n[b, C.U], n[b, C.V] = n[b, C.U] + more * q[C.BX], n[b, C.V] + more * q[C.BY]
    if q[C.MORE] != 0.0 and q[C.SIDE] != 0.0:
        n[turner(s, a, arm_of(q)), C.W] += more * q[C.TURN]


@nb.njit(**BY_ADDRESS)
def restart(c, part):
    """Velocities from those before and the impulses of all pairs and bonds, along their present directions."""
    n = c.mover_numbers
    for i in range(c.sizes[C.PUSHED]):
        m = c.pushed[i]
        n[m, C.JX], n[m, C.JY], n[m, C.JW] = 0.0, 0.0, 0.0
    for i in range(c.counts[C.ACTIVE]):
        k = c.active[i]
        q, (s, a, b) = c.pair_numbers[k], of_pair(c, k)
        x, y, t = q[C.LAMBDA] * q[C.NX], q[C.LAMBDA] * q[C.NY], q[C.SHARE]
        if q[C.MORE] == 0.0:
            add_to_all(c, s, a, b, t, (0.0, 0.0, 0.0), x, y)
            continue
        arm = arm_of(q)
        add_to_all(c, s, a, b, t, arm, x, y)
        if q[C.TAU] != 0.0:
            add_to_all(c, s, a, b, t, arm, -q[C.TAU] * q[C.NY], q[C.TAU] * q[C.NX])
            if a != b:
                x, y = q[C.LIFT] * q[C.TAU] * q[C.NX], q[C.LIFT] * q[C.TAU] * q[C.NY]
                add(c, a, -x, -y)
                add(c, b, x, y)
    for i in range(c.sizes[C.BONDS]):
        p = c.bound[i]
        q, (s, a, b) = c.bond_numbers[p], movers(c, p, c.bonds[p, C.BOND_EDGE])
        add_to_all(c, s, a, b, q[C.BOND_SHARE], arm_of_bond(q), q[C.BOND_X], q[C.BOND_Y])
    for i in range(c.sizes[C.PUSHED]):
        m = c.pushed[i]
        u, v = response(c, m, n[m, C.JX], n[m, C.JY])
        n[m, C.U], n[m, C.V], n[m, C.W] = n[m, C.U0] + part * u, n[m, C.V0] + part * v, n[m, C.W0] + part * n[m, C.II] * n[m, C.JW]
