"""One time step, as a numbered list, and the march over many of them without leaving compiled code.

 1. step: Courant, growth, events
 2. nodes: drift to the middle of the step by the velocities at its start
 3. zones: stress, viscosity and filters in the middle; their forces
 4. nodes: kick by those forces; mean velocity, motion to the end of the step
 5. if a zone is tangled or has lost a third of its area: back to 2 with half the step
 6. zones: energy by the work of the forces that moved the nodes, state at the end, signal rate

Items 2 to 6 are done band by band (`bands`). If a band is not the whole mesh, the rows before a tangled zone have already been advanced:
the march returns, and the step is repeated from a copy (`rewind`).

A march returns when its cycles are done, an event time is reached, a gauge is due or a state is invalid; the codes are in `layout`. Threads
share rows of zones and of nodes (`plan`); the leader alone handles boundaries, shared nodes of blocks and the choice of the step.
"""

from typing import Any, NamedTuple

import numba as nb
import numpy as np

from hugoniot.core.passes import rows
from hugoniot.core.shares import everyone
from hugoniot.core.target import BY_ADDRESS, GUARD
from hugoniot.solvers.lagrange1d.layout import LONGEST_AHEAD
from hugoniot.solvers.lagrange2d import bands, special_nodes, transmitting
from hugoniot.solvers.lagrange2d import layout as L
from hugoniot.solvers.lagrange2d.bands import between, take_rows
from hugoniot.solvers.lagrange2d.commands import (
    CORRECT,
    DRIFT,
    GRADIENTS,
    HEIGHT,
    LOOK,
    MOVE,
    PREDICT,
    PUSH,
    TAKE_BACK,
    gather,
    tangled,
)
from hugoniot.solvers.lagrange2d.contact import step as contact_step
from hugoniot.solvers.lagrange2d.contact.step import touch
from hugoniot.solvers.lagrange2d.plane_rows import AHEAD, DT, DT_BACK, DT_HALF
from hugoniot.solvers.lagrange2d.smoothness import fill_ghosts
from hugoniot.zones.soundness import FOUND_CAPPED, FOUND_FAILURE, FOUND_RATE, FOUND_UNSOUND

VISCOUS = np.array([L.Zones._fields.index(name) for name in ("qxx", "qyy", "qxy", "qhoop", "viscous_speed")])
MOST_TRIES = 12      # of a step, each with half the one before


class Run(NamedTuple):
    """Arrays of a run besides its plan; columns of the integer tables are in `layout`."""

    zones: Any
    nodes: Any
    gradients: Any           # of `smoothness`, with the table of ghosts and its numbers
    ghosts: Any
    ghost_numbers: Any
    loads: Any
    given: Any
    gates: Any
    gate_normals: Any        # of nodes on transmitting edges: outward, with the impedance
    open_edges: Any
    ends: Any                # (transmitting edges, columns of `lagrange1d.layout`): what they know
    ends_kept: Any           # the same at the start of the step
    seen: Any                # scratch of theirs
    held: Any
    held_normals: Any
    pulses: Any
    tables: Any
    starts: Any
    members: Any
    special: Any
    axis: Any
    axis_ratio: Any
    before: Any              # (kinds of `bands`, rows): how many of each come before a row
    chains: Any              # (chains, 3): work and impulse of what stands outside
    kept: Any                # the same at the start of the step
    middle: Any              # where what a node has in the middle of the step stands in its rows (`rings`)
    touch: int               # address of what contact does at a moment of the step (0: nothing meets),
    tables_of_contact: int   # of its tables (`contact.layout.Contact`),
    asked: Any               # and the time and the step it is called with, and its answer


class Options(NamedTuple):
    """Geometry (codes of `quads`), radius used for the axis, body force per mass."""

    kind: int
    near: float
    gx: float
    gy: float


# -- the step ---------------------------------------------------------------------------------------------------------------------
@nb.njit(**BY_ADDRESS)
def choose_step(control):
    """Courant, growth, an event time (hit exactly, approached in two halves)."""
    dt = min(control[L.COURANT] / control[L.RATE], control[L.GROWTH] * control[L.DT_NATURAL], control[L.DT_LARGEST])
    control[L.DT_NATURAL] = dt
    remaining = control[L.EVENT_TIME] - control[L.TIME]
    if remaining <= dt * (1.0 + 1e-9):
        dt = remaining
    elif remaining < 2.0 * dt:
        dt = min(dt, 0.5 * remaining)
    return dt


@nb.njit(**BY_ADDRESS)
def hold_specials(run, options, time, dt, span):
    """Step 4 for the nodes that something besides their own zones acts on.

    span: (first row, one after the last) of the band, and the lag of the rows that are held.
    """
    last, top, lag = span
    a, b = between(run.before, bands.LOADS, last, top, lag - 1, run.loads.shape[0])
    loads, given = run.loads[a:b], run.given[a:b]
    a, b = between(run.before, bands.SPECIAL, last, top, lag, run.special.shape[0])
    special = run.special[a:b]
    a, b = between(run.before, bands.HELD, last, top, lag, run.held.shape[0])
    held, normals = run.held[a:b], run.held_normals[a:b]
    pulses, geometry = (run.pulses, run.tables), (options.kind, options.near)
    special_nodes.load(run.nodes, run.middle, loads, given, pulses, run.ends, (time, time + dt), geometry)
    special_nodes.exchange(run.nodes, run.starts, run.members)
    special_nodes.free_motion(run.nodes, run.middle, special, dt, (options.gx, options.gy))
    special_nodes.transmit(run.nodes, run.gates, run.gate_normals, run.chains, dt)
    special_nodes.hold(run.nodes, run.middle, held, normals, run.pulses, run.tables, run.chains, (time, time + dt), True)
    touch(run, time, dt, contact_step.PUSH)
    transmitting.answer(run, dt, options.kind, options.near)
    a, b = between(run.before, bands.LOADS, last, top, lag, run.loads.shape[0])
    special_nodes.book_loads(run.nodes, run.middle, run.loads[a:b], run.given[a:b], run.chains, dt)


@nb.njit(**BY_ADDRESS)
def hold_drift(run, step, last, top):
    """Apply the constraints to velocities extrapolated to the middle of the step; a velocity jump of a driven edge is not extrapolated."""
    a, b = between(run.before, bands.HELD, last, top, bands.NOW, run.held.shape[0])
    held, normals = run.held[a:b], run.held_normals[a:b]
    special_nodes.hold(run.nodes, run.middle, held, normals, run.pulses, run.tables, run.chains, step, False)


@nb.njit(**BY_ADDRESS)
def copy(table, to):
    """Copy a table of the chains or the transmitting edges."""
    for i in range(table.shape[0]):
        for k in range(table.shape[1]):
            to[i, k] = table[i, k]


@nb.njit(**BY_ADDRESS)
def power_of_body_force(run, options, power, span):
    """Power of the body force on the nodes of a band, added to that of the bands before it."""
    n, (last, top, lag) = rows(L.Nodes, run.nodes, 0), span
    a, b = between(run.before, bands.NODES, last, top, lag, run.middle.shape[0])
    for k in range(a, b):
        m = run.middle[k]
        power += (options.gx * n.um[m] + options.gy * n.vm[m]) * n.own[k]
    return power


@nb.njit(**BY_ADDRESS)
def set_step(plan, dt, ahead):
    """Give the passes the time step, and its ratio to the last one if that was taken."""
    plan.dts[DT], plan.dts[DT_HALF], plan.dts[DT_BACK], plan.dts[AHEAD] = dt, 0.5 * dt, -dt, ahead


@nb.njit(**BY_ADDRESS)
def look_around(run, plan, last, top):
    """Velocity gradients of the rows from `last` to `top` at the start of a step, and of the cells around the blocks beside them."""
    take_rows(plan, last, top, bands.NOW)
    everyone(plan, GRADIENTS)
    a, b = between(run.before, bands.GHOSTS, last, top, bands.NOW, run.ghosts.shape[0])
    fill_ghosts(run.gradients, run.nodes, run.ghosts[a:b], run.ghost_numbers[a:b])


@nb.njit(**BY_ADDRESS)
def in_bands(plan):
    """Whether a band is not the whole mesh."""
    return plan.band[HEIGHT] < plan.before.shape[1] - 1


@nb.njit(**BY_ADDRESS)
def try_step(run, plan, options, control):
    """Steps 2 to 6 with the step of the plan; how many zones are tangled, in which case nothing has moved if a band is the whole mesh."""
    dt, time, top, rows, power = plan.dts[DT], control[L.TIME], bands.FIRST, plan.before.shape[1] - 1, 0.0
    transmitting.listen(run, dt, options.kind, options.near)
    while top < rows:
        last, top = top, bands.next_top(plan, top)
        if in_bands(plan):
            look_around(run, plan, last, top)
        take_rows(plan, last, top, bands.NOW)
        everyone(plan, DRIFT)
        hold_drift(run, (time, time + dt), last, top)
        take_rows(plan, last, top, bands.STRESS)
        everyone(plan, PREDICT)
        wrong = tangled(plan)
        if wrong > 0.0:
            copy(run.ends_kept, run.ends)
            return wrong
        a, b = between(run.before, bands.AXIS, last, top, bands.STRESS, run.axis.shape[0])
        special_nodes.axis_masses(run.nodes, run.middle, run.axis[a:b], run.axis_ratio[a:b], options.near)
        everyone(plan, PUSH)
        hold_specials(run, options, time, dt, (last, top, bands.MOTION))
        take_rows(plan, last, top, bands.MOTION)
        everyone(plan, MOVE)
        a, b = between(run.before, bands.HELD, last, top, bands.MOTION, run.held.shape[0])
        special_nodes.settle(run.nodes, run.held[a:b], run.held_normals[a:b], run.pulses, run.tables, time + dt)
        if options.gx != 0.0 or options.gy != 0.0:
            power = power_of_body_force(run, options, power, (last, top, bands.MOTION))
        touch(run, time, dt, contact_step.MOVE)
        take_rows(plan, last, top, bands.END)
        everyone(plan, LOOK)
        wrong = tangled(plan)
        if wrong > 0.0:
            everyone(plan, TAKE_BACK)
            special_nodes.settle(run.nodes, run.held, run.held_normals, run.pulses, run.tables, time)
            touch(run, time, -dt, contact_step.TAKE_BACK)
            copy(run.kept, run.chains)
            copy(run.ends_kept, run.ends)
            return wrong
        touch(run, time, dt, contact_step.ACCEPT)
        everyone(plan, CORRECT)
    control[L.GRAVITY_WORK] += dt * power
    gather(plan.found)
    return 0.0


@nb.njit(**BY_ADDRESS)
def forget_try(zones):
    """No viscous stress in the first half of the next try: what stands there is that of a try that went wrong, maybe not a number."""
    for row in VISCOUS:
        zones[row] = 0.0


@nb.njit(**BY_ADDRESS)
def take_step(run, plan, options, control, counters):
    """Steps 1 to 6; the code of `layout` that says how it went."""
    if not touch(run, control[L.TIME], control[L.GROWTH] * control[L.DT_NATURAL], contact_step.READY):
        return L.NO_ROOM
    dt, tries, time = choose_step(control), 0, control[L.TIME]
    if not control[L.DT_NATURAL] > control[L.DT_SMALLEST]:
        return L.STEP_COLLAPSED
    set_step(plan, dt, min(dt / control[L.DT], LONGEST_AHEAD) if control[L.DT] > 0.0 else 0.0)
    touch(run, time, dt, contact_step.CLOSE)
    copy(run.chains, run.kept)
    if not in_bands(plan):      # several tries may need it, and transmitting edges follow it
        look_around(run, plan, bands.FIRST, plan.before.shape[1] - 1)
    transmitting.lag(run)
    copy(run.ends, run.ends_kept)
    while try_step(run, plan, options, control) > 0.0:
        if in_bands(plan):
            return L.LED_ON
        tries += 1
        counters[L.REPEATED] += 1
        forget_try(run.zones)
        dt *= 0.5
        set_step(plan, dt, 0.0)
        control[L.DT_NATURAL] = dt
        if tries > MOST_TRIES:
            return L.TANGLED
    control[L.DT] = dt
    totals = plan.found[-1]
    control[L.FILTER_WORK] += dt * totals[L.FOUND_FILTER]
    at_event = dt >= control[L.EVENT_TIME] - time
    control[L.TIME] = control[L.EVENT_TIME] if at_event else time + dt
    counters[L.CYCLE] += 1
    control[L.RATE], control[L.WORST_FAILURE] = totals[FOUND_RATE], totals[FOUND_FAILURE]
    counters[L.CAP_COUNT] += int(totals[FOUND_CAPPED])
    if totals[FOUND_UNSOUND] > 0.0:
        return L.BAD_STATE
    return L.AT_EVENT if at_event else L.PAUSED


@nb.njit(**GUARD)
def march(cycles, run, plan, options, control, counters):
    """Take up to `cycles` steps; returns the code of `layout` that says why it came back."""
    for _ in range(cycles):
        code = take_step(run, plan, options, control, counters)
        if code == L.STEP_COLLAPSED or code == L.TANGLED or code == L.NO_ROOM or code == L.LED_ON:
            return code
        counters[L.ZONE_STEPS] += counters[L.ZONES]
        if code != L.PAUSED:
            return code
        if control[L.TIME] >= control[L.NEXT_GAUGE]:
            return L.GAUGE_DUE
    return L.PAUSED


@nb.njit(**GUARD)
def hold_at_start(run):
    """Velocities of held nodes at t = 0: nothing is recorded."""
    n = rows(L.Nodes, run.nodes, 0)
    special_nodes.settle(run.nodes, run.held, run.held_normals, run.pulses, run.tables, 0.0)
    for k in range(run.nodes.shape[1]):
        n.um[k], n.vm[k] = n.u[k], n.v[k]
