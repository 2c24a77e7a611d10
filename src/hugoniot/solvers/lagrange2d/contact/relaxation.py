"""Relaxation: impulses of pairs and bonds that satisfy the constraints on velocities, one after the other (`impulses`).

All sweeps run in the same order, because conjugate gradients assume that each sweep acts on an error in the same way.
"""

import numba as nb

from hugoniot.core.target import BY_ADDRESS, INLINE
from hugoniot.solvers.lagrange2d.contact import layout as C
from hugoniot.solvers.lagrange2d.contact.impulses import (
    along_normal,
    arm_of,
    arm_of_bond,
    exchange,
    inverse_mass,
    movers,
    of_pair,
    relative,
    rub,
    slip,
)

ENOUGH_SWEEPS, MOST_SWEEPS = 5, 80      # the more only where nodes would end far behind surfaces
CLOSE_ENOUGH = 5e-4      # of the largest change that contact makes to a velocity


@nb.njit(**INLINE)
def relax_pair(c, q, s, a, b, part):
    """Satisfy one pair; the change of its velocity."""
    if q[C.WN] == 0.0:
        return 0.0
    plain = q[C.MORE] == 0.0
    u, v = relative(c, s, a, b, q[C.SHARE], (0.0, 0.0, 0.0) if plain else arm_of(q), C.U)
    more = max((q[C.LEAST] - (u * q[C.NX] + v * q[C.NY])) * q[C.MASS], -part * q[C.LAMBDA])
    q[C.LAMBDA] = max(q[C.LAMBDA] + more / part, 0.0)
    along_normal(c, q, s, a, b, more)
    change = abs(more) * q[C.WN]
    return change if plain else max(change, relax_friction(c, q, s, a, b, part))


@nb.njit(**INLINE)
def relax_friction(c, q, s, a, b, part):
    """Let friction stop the sliding of a pair as far as it can; the change of its velocity."""
    most = q[C.COULOMB] * q[C.LAMBDA]
    if q[C.WT] == 0.0 or (most == 0.0 and q[C.TAU] == 0.0):
        return 0.0
    new = min(max(q[C.TAU] + (q[C.AIM] - slip(c, q, s, a, b, C.U)) / (part * q[C.WT]), -most), most)
    more = part * (new - q[C.TAU])
    q[C.TAU] = new
    rub(c, q, s, a, b, more)
    return abs(more) * q[C.WT]


@nb.njit(**INLINE)
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
            exchange(c, s, a, b, t, arm, part * more if k == 0 else 0.0, part * more if k == 1 else 0.0)
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


@nb.njit(**INLINE)
def sweep_once(c, part):
    """Satisfy all active pairs and all bonds one after the other; (largest change of a velocity, square of the change of the impulses)."""
    change, square = 0.0, 0.0
    for i in range(c.counts[C.ACTIVE]):
        k = c.active[i]
        q, (s, a, b) = c.pair_numbers[k], of_pair(c, k)
        q[C.OLD] = q[C.LAMBDA]
        if q[C.MORE] != 0.0:
            q[C.OLD_TAU] = q[C.TAU]
        change = max(change, relax_pair(c, q, s, a, b, part))
        square += q[C.WN] * (q[C.LAMBDA] - q[C.OLD]) ** 2
        if q[C.MORE] != 0.0:
            square += q[C.WT] * (q[C.TAU] - q[C.OLD_TAU]) ** 2
    for i in range(c.sizes[C.BONDS]):
        p = c.bound[i]
        q = c.bond_numbers[p]
        q[C.BOND_OLD_X], q[C.BOND_OLD_Y] = q[C.BOND_X], q[C.BOND_Y]
        change = max(change, relax_bond(c, p, part))
        square += q[C.BOND_WX] * (q[C.BOND_X] - q[C.BOND_OLD_X]) ** 2 + q[C.BOND_WY] * (q[C.BOND_Y] - q[C.BOND_OLD_Y]) ** 2
    c.counts[C.SWEEPS] += 1
    return change, square


@nb.njit(**INLINE)
def go_on(c, part, share):
    """Add `share` of the direction of search to the impulses, and the change of the last sweep to the direction."""
    for i in range(c.counts[C.ACTIVE]):
        k = c.active[i]
        q, (s, a, b) = c.pair_numbers[k], of_pair(c, k)
        x = share * q[C.WAY]
        q[C.WAY] = x + q[C.LAMBDA] - q[C.OLD]
        if x != 0.0:
            q[C.LAMBDA] += x
            along_normal(c, q, s, a, b, part * x)
        if q[C.MORE] != 0.0:
            y = share * q[C.WAY_TAU]
            q[C.WAY_TAU] = y + q[C.TAU] - q[C.OLD_TAU]
            if y != 0.0:
                q[C.TAU] += y
                rub(c, q, s, a, b, part * y)
    for i in range(c.sizes[C.BONDS]):
        p = c.bound[i]
        q = c.bond_numbers[p]
        x, y = share * q[C.BOND_WAY_X], share * q[C.BOND_WAY_Y]
        q[C.BOND_WAY_X], q[C.BOND_WAY_Y] = x + q[C.BOND_X] - q[C.BOND_OLD_X], y + q[C.BOND_Y] - q[C.BOND_OLD_Y]
        if share > 0.0:
            q[C.BOND_X] += x
            q[C.BOND_Y] += y
            s, a, b = movers(c, p, c.bonds[p, C.BOND_EDGE])
            exchange(c, s, a, b, q[C.BOND_SHARE], arm_of_bond(q), part * x, part * y)


@nb.njit(**BY_ADDRESS)
def largest(c):
    """Largest change of velocity that contact makes."""
    n, found = c.mover_numbers, 0.0
    for i in range(c.sizes[C.PUSHED]):
        m = c.pushed[i]
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
        change, square = sweep_once(c, part)
        if sweep == 0:
            whole = largest(c)
        if change <= max(least, CLOSE_ENOUGH * whole) or (sweep >= ENOUGH_SWEEPS - 1 and change <= enough) or sweep == MOST_SWEEPS - 1:
            break
        go_on(c, part, square / before if sweep > 0 and square <= before else 0.0)
        before = square
    return whole
