"""Contact in a step: the operations that `march` calls.

    READY     before the step: pairs that may touch; False if there is no room for them
    CLOSE     at its start: surfaces that would interpenetrate only close their gap; the kinetic energy lost becomes heat
    PUSH      mean velocities of the step: no point ends behind an edge, no surface pulls
    MOVE, TAKE_BACK     rigid bodies
    ACCEPT    after it: heat and work of friction into zones, forces, bonds that break

Only the leader computes contact, so results do not depend on the number of threads.
"""

import numba as nb

from hugoniot.core.by_address import ByAddress
from hugoniot.core.compile_ahead import Job
from hugoniot.core.passes import Entry, call_entry, row_at
from hugoniot.core.target import BY_ADDRESS, INLINE
from hugoniot.solvers.lagrange2d import layout as L
from hugoniot.solvers.lagrange2d.contact import layout as C
from hugoniot.solvers.lagrange2d.contact.accounts_of_step import accept, book_heat, book_holds
from hugoniot.solvers.lagrange2d.contact.active import forget, list_pushed
from hugoniot.solvers.lagrange2d.contact.impulses import movers, restart
from hugoniot.solvers.lagrange2d.contact.meeting import (
    CLOSING_ENOUGH,
    activate,
    ask_closing,
    ask_mean,
    bind_points,
    start_velocity,
)
from hugoniot.solvers.lagrange2d.contact.near import ANY_WAY, SPARE, look, stray_ends
from hugoniot.solvers.lagrange2d.contact.relaxation import relax
from hugoniot.solvers.lagrange2d.contact.rigid import arm, drift, drive, lead_on, move_rigid, velocity_from, velocity_to
from hugoniot.solvers.lagrange2d.contact.search import make_ready

READY, CLOSE, PUSH, MOVE, TAKE_BACK, ACCEPT = range(6)
U, UM = (L.Nodes._fields.index(name) for name in ("u", "um"))      # rows of the node table
ROUNDS = 6                             # at most, of finding who meets and what follows; one at the start of a step
SLACK = 1e-7                           # of an edge: what closes by less in a step is left to the forces
SMALL = 1e-5                           # of an edge: what would be behind by less after a round is left to the next step
DEPTH = 5e-5                           # of the mean edge: how far behind surfaces nodes may end for sweeps to stop early
NEGLIGIBLE = 1e-14                     # of the mean edge in a step: velocities below are round-off


@nb.njit(**BY_ADDRESS)
def take(c, nodes, row):
    """Velocities of movers from two rows of the nodes."""
    n = c.mover_numbers
    for i in range(c.sizes[C.LISTED]):
        m = c.listed[i]
        if c.movers[m, C.MOVER_RIGID] < 0:
            k = c.movers[m, C.MOVER_NODE]
            n[m, C.U], n[m, C.V] = nodes[row, k], nodes[row + 1, k]
        else:
            velocity_from(c, m, row == UM)
        n[m, C.U0], n[m, C.V0], n[m, C.W0] = n[m, C.U], n[m, C.V], n[m, C.W]
        n[m, C.JX], n[m, C.JY], n[m, C.JW] = 0.0, 0.0, 0.0


@nb.njit(**BY_ADDRESS)
def give(c, nodes, row, dt):
    """Velocities of movers back into two rows of the nodes that are one with them."""
    n = c.mover_numbers
    for k in range(c.sizes[C.PUSHED]):
        m = c.pushed[k]
        if n[m, C.JX] == 0.0 and n[m, C.JY] == 0.0:
            continue
        if c.movers[m, C.MOVER_RIGID] >= 0:
            velocity_to(c, nodes, m, row == UM, dt)
            continue
        for i in range(c.copies_start[m], c.copies_start[m + 1]):
            k = c.copies[i]
            nodes[row, k], nodes[row + 1, k] = n[m, C.U], n[m, C.V]


@nb.njit(**BY_ADDRESS)
def aim_bonds(c, nodes, closing):
    """Bonds start without impulse; both ends move alike at the end of the step."""
    for i in range(c.sizes[C.BONDS]):
        p = c.bound[i]
        q, e = c.bond_numbers[p], c.edges[c.bonds[p, C.BOND_EDGE]]
        q[C.BOND_X], q[C.BOND_Y], q[C.BOND_AIM_X], q[C.BOND_AIM_Y] = 0.0, 0.0, 0.0, 0.0
        if not closing:
            q[C.BOND_X], q[C.BOND_Y] = q[C.BOND_LAST_X], q[C.BOND_LAST_Y]
            at, at_a, at_b = c.points[p, C.POINT_NODE], c.points[e[C.EDGE_A], C.POINT_NODE], c.points[e[C.EDGE_B], C.POINT_NODE]
            u, v = start_velocity(nodes, at, at_a, at_b, q[C.BOND_SHARE])
            q[C.BOND_AIM_X], q[C.BOND_AIM_Y] = 0.5 * u, 0.5 * v
    return c.sizes[C.BONDS] > 0


@nb.njit(**BY_ADDRESS)
def arm_bonds(c, t):
    """Where the impulses of bonds act on bodies that turn, after the part t of a step."""
    for i in range(c.sizes[C.BONDS]):
        p = c.bound[i]
        q, e = c.bond_numbers[p], c.bonds[p, C.BOND_EDGE]
        s, a, _ = movers(c, p, e)
        ends = c.edges[e, C.EDGE_A], c.edges[e, C.EDGE_B]
        q[C.BOND_SIDE], q[C.BOND_ARM_X], q[C.BOND_ARM_Y] = arm(c, s, a, ends, q[C.BOND_SHARE], t)


@nb.njit(**BY_ADDRESS)
def ask(c, nodes, dt, closing):
    """What pairs and bonds require of the velocities, with the directions of the start of the step or of its middle."""
    arm_bonds(c, 0.0 if closing else 0.5)
    if closing:
        ask_closing(c, dt)
    else:
        ask_mean(c, nodes, dt)


@nb.njit(**BY_ADDRESS)
def solve(c, nodes, dt, closing):
    """Velocities of movers that contact allows; whether anything touched."""
    part, least, change = 1.0 if closing else 0.5, NEGLIGIBLE * c.numbers[C.MEAN_EDGE] / dt, 0.0
    if closing:
        least = max(least, CLOSING_ENOUGH * c.numbers[C.CHANGE])
    forget(c)
    if closing and c.binds:
        bind_points(c)
        list_pushed(c)
    if c.sizes[C.NEAR] + c.sizes[C.BONDS] == 0:
        c.numbers[C.CHANGE] = 0.0
        return False
    touched = aim_bonds(c, nodes, closing)
    for again in range(1 if closing else ROUNDS):
        slack = SMALL if again > 0 else SLACK if closing else 0.0
        lead_on(c, dt)
        if not activate(c, dt, closing, slack) and (again > 0 or not touched):
            break
        touched = True
        ask(c, nodes, dt, closing)
        restart(c, part)
        change = relax(c, part, least, 1e300 if closing else DEPTH * c.numbers[C.MEAN_EDGE] / dt)
    if touched:
        restart(c, part)
    if not closing:
        c.numbers[C.CHANGE] = change
    return touched


@nb.njit(**BY_ADDRESS)
def push(c, dt):
    """Mean velocities of movers that contact allows; whether anything touched. Found again where points have gone farther astray than
    the list of near pairs reckons with."""
    while True:
        change, sweeps = c.numbers[C.CHANGE], c.counts[C.SWEEPS]
        take(c, c.nodes, UM)
        drift(c, dt)
        touched = solve(c, c.nodes, dt, False)
        if c.looked[C.ASTRAY] == ANY_WAY:
            return touched
        astray = stray_ends(c, c.nodes, dt)
        c.looked[C.FARTHEST] = max(c.looked[C.FARTHEST], astray)
        if astray <= c.looked[C.ASTRAY]:
            return touched
        c.numbers[C.CHANGE], c.counts[C.SWEEPS] = change, sweeps      # the list of near pairs leaves no trace in the state
        look(c, c.nodes, dt, SPARE * astray)


@nb.njit(**BY_ADDRESS)
def of_step(c, time, dt, moment):
    """One of the moments at the top of the file."""
    if moment == READY:
        return make_ready(c, c.nodes, dt)
    if moment in (MOVE, TAKE_BACK):
        move_rigid(c, c.nodes, time, dt)
    elif moment == ACCEPT:
        accept(c, dt)
    elif moment == CLOSE and c.sizes[C.NEAR] + c.sizes[C.BONDS] > 0:
        take(c, c.nodes, U)
        if solve(c, c.nodes, dt, True):
            book_heat(c, 1.0, dt)
            book_holds(c, 1.0)
            give(c, c.nodes, U, dt)
    elif moment == PUSH:
        drive(c, time, dt)
        if push(c, dt):
            book_holds(c, 0.0)
            give(c, c.nodes, UM, dt)
    return True


def at_moment(c, asked, moment):
    """The same called by its address, so that it is compiled once, not into each function of the march again; asked: time, step, answer."""
    asked[2] = of_step(c, asked[0], asked[1], moment)


AT_MOMENT = Entry(at_moment)


def job_of_contact(tables: ByAddress, run) -> Job:
    """What may have yet to be compiled for a run with these tables."""
    return AT_MOMENT.job(tables, run.asked, READY)


def with_contact(run, tables: ByAddress):
    """A run that knows these tables, and where its contact is compiled."""
    return run._replace(touch=AT_MOMENT.address(tables, run.asked, READY), tables_of_contact=tables.address)


@nb.njit(**INLINE)
def touch(run, time, dt, moment):
    """What contact does at a moment of the step; False where it has no room for its pairs."""
    if run.touch == 0:
        return True
    run.asked[0], run.asked[1] = time, dt
    call_entry(run.touch, row_at(run.tables_of_contact), run.asked, moment)
    return run.asked[2] != 0.0
