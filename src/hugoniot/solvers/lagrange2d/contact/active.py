"""The pairs that are active in a step, and what is kept of them for the next one."""

import numba as nb

from hugoniot.core.target import BY_ADDRESS, INLINE
from hugoniot.solvers.lagrange2d.contact import layout as C
from hugoniot.solvers.lagrange2d.contact.impulses import movers, of_pair
from hugoniot.solvers.lagrange2d.contact.near import ANY_WAY


@nb.njit(**BY_ADDRESS)
def list_active(c):
    """List the active pairs."""
    count = 0
    for i in range(c.sizes[C.NEAR]):
        k = c.near[i, 0]
        if c.pairs[k, C.PAIR_ACTIVE] == C.ON:
            c.active[count] = k
            count += 1
    c.counts[C.ACTIVE] = count
    list_pushed(c)


@nb.njit(**BY_ADDRESS)
def list_pushed(c):
    """List the movers of active pairs and of bonds that are not in the list yet; all movers stand in it where all pairs are near."""
    if c.looked[C.ASTRAY] == ANY_WAY:
        return
    for i in range(c.counts[C.ACTIVE]):
        for m in of_pair(c, c.active[i]):
            include_pushed(c, m)
    for i in range(c.sizes[C.BONDS]):
        p = c.bound[i]
        for m in movers(c, p, c.bonds[p, C.BOND_EDGE]):
            include_pushed(c, m)


@nb.njit(**INLINE)
def include_pushed(c, m):
    """List a mover that is pushed."""
    if c.movers[m, C.MOVER_LISTED] == 1:
        c.movers[m, C.MOVER_LISTED], c.pushed[c.sizes[C.PUSHED]] = 2, m
        c.sizes[C.PUSHED] += 1


@nb.njit(**BY_ADDRESS)
def forget(c):
    """No pair is active, no mover is pushed but those of bonds."""
    for i in range(c.counts[C.ACTIVE]):
        c.pairs[c.active[i], C.PAIR_ACTIVE] = C.OFF
    c.counts[C.ACTIVE] = 0
    if c.looked[C.ASTRAY] != ANY_WAY:
        for i in range(c.sizes[C.PUSHED]):
            c.movers[c.pushed[i], C.MOVER_LISTED] = 1
        c.sizes[C.PUSHED] = 0
        list_pushed(c)


@nb.njit(**BY_ADDRESS)
def remember(c):
    """Keep the impulses of this step for the next one, before which no pair is active."""
    for i in range(c.sizes[C.BONDS]):
        q = c.bond_numbers[c.bound[i]]
        q[C.BOND_LAST_X], q[C.BOND_LAST_Y] = q[C.BOND_X], q[C.BOND_Y]
    for i in range(c.sizes[C.TOUCHED]):
        q = c.pair_numbers[c.touched[i]]
        q[C.LAST], q[C.LAST_TAU] = 0.0, 0.0
    count = 0
    for i in range(c.counts[C.ACTIVE]):
        k = c.active[i]
        q, c.pairs[k, C.PAIR_ACTIVE] = c.pair_numbers[k], C.OFF
        if q[C.LAMBDA] != 0.0:
            q[C.LAST], q[C.LAST_TAU], c.touched[count] = q[C.LAMBDA], q[C.TAU], k
            count += 1
    c.sizes[C.TOUCHED] = count
