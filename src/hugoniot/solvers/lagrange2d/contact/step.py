"""What contact does in a step, at the places `march` calls it.

    READY     before the step: pairs that may meet; False where there is no room for them
    CLOSE     at its start: surfaces that would pass each other come no nearer than their gap, the kinetic energy lost is heat
    PUSH_MIDDLE         mean velocities of the half step, by the forces of contact of the last step
    PUSH      mean velocities of the step: no point ends behind an edge, no surface pulls
    MOVE, TAKE_BACK     rigid bodies
    ACCEPT    after it: heat and work of friction into zones, forces, bonds that break

Contact is the leader's alone, so that no bit depends on the number of threads.
"""

from typing import Any

import numba as nb
from numba.extending import overload

from hugoniot.core.compile_ahead import Job
from hugoniot.core.passes import Entry, call_entry
from hugoniot.core.target import BY_ADDRESS, INLINE
from hugoniot.solvers.lagrange2d.contact import layout as C
from hugoniot.solvers.lagrange2d.contact.accounts_of_step import accept, book_heat, book_holds
from hugoniot.solvers.lagrange2d.contact.impulses import columns, movers, relax, restart
from hugoniot.solvers.lagrange2d.contact.meeting import (
    activate,
    ask_closing,
    ask_mean,
    bind_points,
    forget,
    list_active,
    point,
    start_velocity,
)
from hugoniot.solvers.lagrange2d.contact.rigid import arm, drive, move_rigid, velocity_from, velocity_to
from hugoniot.solvers.lagrange2d.contact.search import make_ready
from hugoniot.solvers.lagrange2d.quads import PLANAR

READY, CLOSE, PUSH_MIDDLE, PUSH, MOVE, TAKE_BACK, ACCEPT = range(7)
X, U, XH, UM, IM = 0, 2, 4, 6, 12      # rows of the node table
ROUNDS = 6                             # at most, of finding who meets and what follows; one at the start of a step
SLACK = 1e-7                           # of an edge: what closes by less in a step is left to the forces
SMALL = 1e-5                           # of an edge: what would be behind by less after a round is left to the next step
DEPTH = 5e-5                           # of the mean edge: how far behind surfaces nodes may end for sweeps to stop early
TURNS = 3                              # of directions, for angular momentum to 1e-12
CLOSING_ENOUGH = 5e-3                  # of the change that contact made to a velocity in the last step: what surfaces that touch close by
NEGLIGIBLE = 1e-14                     # of the mean edge in a step: velocities below are round-off


@nb.njit(**BY_ADDRESS)
def take(c, nodes, row):
    """Velocities of movers from two rows of the nodes."""
    n = c.mover_numbers
    for i in range(c.sizes[C.LISTED]):
        m = c.listed[i]
        if c.movers[m, C.MOVER_RIGID] < 0:
            k = c.movers[m, C.MOVER_NODE]
            n[m, C.U], n[m, C.V], n[m, C.IM] = nodes[row, k], nodes[row + 1, k], nodes[IM, k]
        else:
            velocity_from(c, m, row == UM)
        n[m, C.U0], n[m, C.V0], n[m, C.W0] = n[m, C.U], n[m, C.V], n[m, C.W]
        n[m, C.JX], n[m, C.JY], n[m, C.JW] = 0.0, 0.0, 0.0


@nb.njit(**BY_ADDRESS)
def give(c, nodes, row, dt, middle):
    """Velocities of movers back into two rows of the nodes that are one with them; `middle`: their positions in the middle too."""
    n = c.mover_numbers
    for k in range(c.sizes[C.LISTED]):
        m = c.listed[k]
        if n[m, C.JX] == 0.0 and n[m, C.JY] == 0.0:
            continue
        if c.movers[m, C.MOVER_RIGID] >= 0:
            velocity_to(c, nodes, m, row == UM, dt)
            continue
        for i in range(c.copies_start[m], c.copies_start[m + 1]):
            k = c.copies[i]
            nodes[row, k], nodes[row + 1, k] = n[m, C.U], n[m, C.V]
            if middle:
                nodes[XH, k], nodes[XH + 1, k] = nodes[X, k] + 0.5 * dt * n[m, C.U], nodes[X + 1, k] + 0.5 * dt * n[m, C.V]


@nb.njit(**BY_ADDRESS)
def aim_bonds(c, nodes, closing):
    """Bonds start without impulse; both ends move alike at the end of the step."""
    standing = False
    for i in range(c.sizes[C.BONDS]):
        p = c.bound[i]
        q, standing = c.bond_numbers[p], True
        q[C.BOND_X], q[C.BOND_Y], q[C.BOND_AIM_X], q[C.BOND_AIM_Y] = 0.0, 0.0, 0.0, 0.0
        if not closing:
            q[C.BOND_X], q[C.BOND_Y] = q[C.BOND_LAST_X], q[C.BOND_LAST_Y]
            at, at_a, at_b = columns(c, p, c.bonds[p, C.BOND_EDGE])
            u, v = start_velocity(nodes, at, at_a, at_b, q[C.BOND_SHARE])
            q[C.BOND_AIM_X], q[C.BOND_AIM_Y] = 0.5 * u, 0.5 * v
    return standing


@nb.njit(**BY_ADDRESS)
def arm_bonds(c, nodes, dt):
    """Where the impulses of bonds act on bodies that turn, after dt."""
    for i in range(c.sizes[C.BONDS]):
        p = c.bound[i]
        q, e = c.bond_numbers[p], c.bonds[p, C.BOND_EDGE]
        (s, a, b), (_, i, j) = movers(c, p, e), columns(c, p, e)
        q[C.BOND_SIDE], q[C.BOND_ARM_X], q[C.BOND_ARM_Y] = arm(c, nodes, s, a, b, (i, j), q[C.BOND_SHARE], dt)


@nb.njit(**BY_ADDRESS)
def ask(c, nodes, dt, closing):
    """What pairs and bonds ask of the velocities, with the directions of the start of the step or of its middle."""
    arm_bonds(c, nodes, 0.0 if closing else 0.5 * dt)
    if closing:
        ask_closing(c, nodes, dt)
    else:
        ask_mean(c, nodes, dt)


@nb.njit(**BY_ADDRESS)
def solve(c, nodes, dt, closing, turns):
    """Velocities of movers that contact allows; whether anything touched. turns: how often their directions are turned in the end."""
    part, least, change = 1.0 if closing else 0.5, NEGLIGIBLE * c.numbers[C.MEAN_EDGE] / dt, 0.0
    if closing:
        least = max(least, CLOSING_ENOUGH * c.numbers[C.CHANGE])
    forget(c)
    if closing:
        bind_points(c, nodes)
    if c.sizes[C.NEAR] + c.sizes[C.BONDS] == 0:
        c.numbers[C.CHANGE] = 0.0
        return False
    touched = aim_bonds(c, nodes, closing)
    for again in range(1 if closing else ROUNDS):
        slack = SMALL if again > 0 else SLACK if closing else 0.0
        if not activate(c, nodes, dt, closing, slack) and (again > 0 or not touched):
            break
        touched = True
        ask(c, nodes, dt, closing)
        restart(c, part)
        change = relax(c, part, least, 1e300 if closing else DEPTH * c.numbers[C.MEAN_EDGE] / dt)
    if touched:
        for _ in range(turns):      # directions of the middle of the step as it has come out: forces without moment
            arm_bonds(c, nodes, 0.5 * dt)
            for i in range(c.counts[C.ACTIVE]):
                point(c, nodes, c.active[i], 0.5 * dt)
            restart(c, part)
        if closing:
            restart(c, part)
    if not closing:
        c.numbers[C.CHANGE] = change
    return touched


@nb.njit(**BY_ADDRESS)
def as_before(c, dt):
    """Mean velocities of the half step by the forces of contact of the last step."""
    ratio = dt / c.numbers[C.LAST_STEP] if c.numbers[C.LAST_STEP] > 0.0 else 0.0
    for i in range(c.sizes[C.NEAR]):
        k = c.near[i]
        q = c.pair_numbers[k]
        q[C.LAMBDA], q[C.TAU] = ratio * q[C.LAST], ratio * q[C.LAST_TAU]
        c.pairs[k, C.PAIR_ACTIVE] = C.ON if q[C.LAMBDA] > 0.0 else C.OFF
    list_active(c)
    for i in range(c.sizes[C.BONDS]):
        p = c.bound[i]
        q = c.bond_numbers[p]
        q[C.BOND_X], q[C.BOND_Y] = ratio * q[C.BOND_LAST_X], ratio * q[C.BOND_LAST_Y]
    restart(c, 0.5)


@nb.njit(**BY_ADDRESS)
def of_step(c, run, options, time, dt, moment):
    """One of the moments at the top of the file."""
    if moment == READY:
        return make_ready(c, run.nodes, dt)
    if moment in (MOVE, TAKE_BACK):
        move_rigid(c, run.nodes, dt)
    elif moment == ACCEPT:
        accept(c, run.nodes, dt, options)
    elif moment == CLOSE and c.sizes[C.NEAR] + c.sizes[C.BONDS] > 0:
        take(c, run.nodes, U)
        if solve(c, run.nodes, dt, True, 0):
            book_heat(c, 1.0, dt)
            book_holds(c, run.chains, 1.0)
            give(c, run.nodes, U, dt, False)
    elif moment == PUSH_MIDDLE:
        drive(c, run, options, time, dt)
        take(c, run.nodes, UM)
        if c.sizes[C.NEAR] + c.sizes[C.BONDS] > 0:
            as_before(c, dt)
            give(c, run.nodes, UM, dt, True)
    elif moment == PUSH:
        drive(c, run, options, time, dt)
        take(c, run.nodes, UM)
        if solve(c, run.nodes, dt, False, TURNS if options.kind == PLANAR else 1):
            book_holds(c, run.chains, 0.0)
            give(c, run.nodes, UM, dt, False)
    return True


def at_moment(run, options, asked):
    """The same called by its address, so that it is compiled once, not into each function of the march again; `asked`: `march.Run`."""
    asked[3] = of_step(run.contact, run, options, asked[0], asked[1], int(asked[2]))


AT_MOMENT = Entry(at_moment)


def jobs_of_contact(run, options) -> list[Job]:
    """What has yet to be compiled for a run's contact."""
    return [] if isinstance(run.contact, C.Nowhere) else [AT_MOMENT.job(run, options, run.asked)]


def with_contact(run, options) -> Any:
    """A run that knows where its contact is compiled."""
    return run if isinstance(run.contact, C.Nowhere) else run._replace(touch=AT_MOMENT.address(run, options, run.asked))


def touch(run, options, time, dt, moment):
    """What contact does at a moment of the step; False where it has no room for its pairs."""
    raise NotImplementedError("compiled only")


@overload(touch, jit_options=INLINE)
def _(run, options, time, dt, moment):
    def nothing(run, options, time, dt, moment):
        return True

    def something(run, options, time, dt, moment):
        run.asked[0], run.asked[1], run.asked[2] = time, dt, moment
        call_entry(run.touch, run, options, run.asked)
        return run.asked[3] != 0.0

    return nothing if run.types[run.fields.index("contact")].instance_class is C.Nowhere else something
