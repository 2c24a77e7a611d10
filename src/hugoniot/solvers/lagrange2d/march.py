"""One time step, as a numbered list, and the march over many of them without leaving compiled code.

 1. step: Courant, growth, events
 2. nodes: forces of the state at the start; mean velocity and position of the middle of the step
 3. zones: stress, viscosity and filters in the middle; their forces
 4. nodes: those forces; mean velocity, motion to the end of the step
 5. a zone tangled, or robbed of a third of its area? back to 2 with half the step
 6. zones: energy by the work of the forces that moved the nodes, state at the end, its forces, signal rate

A march returns when its cycles are done, an event time is reached, a gauge is due or a state is bad; the codes are in `layout`. Threads
share pieces of zones and rows of nodes; boundaries, blocks' shared nodes and the choice of the step are the leader's alone. Nothing that
is shared out is added up across pieces but in their order, so the number of threads changes no bit.
"""

from typing import Any, NamedTuple

import numba as nb
from numba.extending import overload

from hugoniot.core.passes import Entry, call_entry, record, row, rows
from hugoniot.core.target import GUARD, INLINE
from hugoniot.core.team import DISMISSED, Alone, await_call, begin, gather_team, sign
from hugoniot.solvers.lagrange2d import layout as L
from hugoniot.solvers.lagrange2d import node_step, zone_step
from hugoniot.zones.constants import Constants
from hugoniot.zones.recipe import Recipe
from hugoniot.zones.soundness import FOUND_CAPPED, FOUND_FAILURE, FOUND_RATE, FOUND_UNSOUND

PREDICT_NODES, PREDICT_ZONES, MOVE_NODES, MOVE, TAKE_BACK, LOOK, CORRECT_ZONES, START = range(8)
CONSTANTS = len(Constants._fields)
MOST_TRIES = 12      # of a step, each with half the one before


class Run(NamedTuple):
    """Arrays of a run; columns of the integer tables are in `layout`."""

    nodes: Any
    zones: Any
    charge: Any
    scratch: Any             # (threads, SCRATCH_ROWS, SCRATCH_WIDTH)
    pieces: Any
    lines: Any
    passes: Any              # (1, fields of zone_step.Passes)
    entries: Any             # addresses of ENTRIES
    recipes: Any
    constants: Any
    limited: Any             # (1,) 1 where the viscosity has a limiter
    near: Any                # (1,) the same as in Options, for passes
    mirrors: Any             # (4 blocks, 2) normals of the walls at blocks' sides, 0 where there is none
    beyond: Any              # (edges of blocks, 2) nodes on the far side, -1 where there are none
    filters: Any             # (recipe; merit of the subzonal pressure, coefficient of the viscous filter)
    found: Any               # (pieces + 1, FOUND_COLUMNS), the last row for totals
    steps: Any               # (dt, whether it is the first try)
    loads: Any
    given: Any
    gates: Any
    gate_normals: Any
    held: Any
    held_normals: Any
    pulses: Any
    tables: Any
    starts: Any
    members: Any
    special: Any
    axis: Any
    axis_ratio: Any
    chains: Any              # (chains, 3): work and impulse of what stands outside
    kept: Any                # the same at the start of the step


class Options(NamedTuple):
    """Geometry (codes of `geometry`), radius that stands for the axis, body force per mass."""

    kind: int
    near: float
    gx: float
    gy: float


# -- shares ---------------------------------------------------------------------------------------------------------------------
def predict_piece(a, i, member):
    """Stress and forces of piece i in the middle of the step."""
    piece = a.pieces[i]
    k, found = piece[L.P_RECIPE], row(a.found, i * L.FOUND_COLUMNS)
    found[L.FOUND_TANGLED] = 0.0
    zone_step.predict(a, record(zone_step.Passes, a.passes, 0), a.limited[0] > 0.0, piece, a.scratch[member], record(Recipe, a.recipes, k),
                      row(a.constants, k * CONSTANTS), row(a.found, i * L.FOUND_COLUMNS + L.FOUND_TANGLED), a.steps[0])


def correct_piece(a, i, member):
    """State of piece i at the end of the step."""
    piece = a.pieces[i]
    k, found = piece[L.P_RECIPE], row(a.found, i * L.FOUND_COLUMNS)
    for n in range(L.FOUND_COLUMNS):
        found[n] = 0.0
    zone_step.correct(a, record(zone_step.Passes, a.passes, 0), piece, a.scratch[member], record(Recipe, a.recipes, k),
                      row(a.constants, k * CONSTANTS), found, a.steps[0])


def start_piece(a, i, member):
    """Forces of piece i at t = 0."""
    piece, passes = a.pieces[i], record(zone_step.Passes, a.passes, 0)
    at = zone_step.rows_of(a, piece, a.scratch[member])
    zone_step.shape_at_end(passes, row(a.near, 0), piece, a.nodes, a.scratch[member])
    zone_step.push(a, passes, piece, at)


ENTRIES = (Entry(predict_piece), Entry(correct_piece), Entry(start_piece))


@nb.njit(**INLINE)
def do_pieces(command, run, share, of):
    """A command over one share of the pieces of zones."""
    count = run.pieces.shape[0]
    for i in range(count * share // of, count * (share + 1) // of):
        if command == PREDICT_ZONES:
            call_entry(run.entries[0], run, i, share)
        elif command == CORRECT_ZONES:
            call_entry(run.entries[1], run, i, share)
        elif command == START:
            call_entry(run.entries[2], run, i, share)
        else:
            piece, bad = run.pieces[i], 0
            for r in range(piece[L.P_ROWS]):
                first, stride = piece[L.P_NODE] + r * piece[L.P_STRIDE], piece[L.P_STRIDE]
                bad += node_step.tangled(piece[L.P_COUNT], rows(L.Nodes, run.nodes, first), rows(L.Nodes, run.nodes, first + stride))
            run.found[i, L.FOUND_TANGLED] += bad


@nb.njit(**INLINE)
def do_lines(command, run, options, share, of):
    """A command over one share of the rows of nodes."""
    dt, count = run.steps[0], run.lines.shape[0]
    for i in range(count * share // of, count * (share + 1) // of):
        line = run.lines[i]
        n, size = rows(L.Nodes, run.nodes, line[L.N_NODE]), line[L.N_COUNT]
        if command == MOVE:
            node_step.move(size, n, dt)
        elif command == TAKE_BACK:
            node_step.move(size, n, -dt)
        elif command == PREDICT_NODES:
            if run.steps[1] > 0.0:
                node_step.gather(line, run.nodes, run.zones, node_step.GX)
            node_step.mean_motion(size, n, L.Vector(n.gx, n.gy), dt, options.gx, options.gy)
            node_step.middle_position(size, n, dt)
        else:
            node_step.gather(line, run.nodes, run.zones, node_step.FX)
            node_step.mean_motion(size, n, L.Vector(n.fx, n.fy), dt, options.gx, options.gy)


def everyone(command, run, options, team):
    """One command over all pieces or rows, shared out if there is a team."""
    raise NotImplementedError("compiled only")


@overload(everyone, jit_options=INLINE)
def _(command, run, options, team):
    def alone(command, run, options, team):
        do_share(command, run, options, 0, 1)

    def together(command, run, options, team):
        for member in range(begin(team.board, command, team.threads)):
            do_share(command, run, options, member, team.threads)
        gather_team(team.board, team.threads)

    return alone if team.instance_class is Alone else together


@nb.njit(**GUARD)
def do_share(command, run, options, share, of):
    """One command over one share."""
    if command in (PREDICT_ZONES, CORRECT_ZONES, LOOK, START):
        do_pieces(command, run, share, of)
    else:
        do_lines(command, run, options, share, of)


@nb.njit(**GUARD)
def serve(member, phase, run, options, team):
    """What every other thread of a team does during a march: the leader's commands on its own share, until dismissed."""
    while True:
        phase = await_call(team.board, phase, member)
        command = team.board[1]
        if command != DISMISSED:
            do_share(command, run, options, member, team.threads)
        sign(team.board, member, phase)
        if command == DISMISSED:
            return


# -- the step ---------------------------------------------------------------------------------------------------------------------
@nb.njit(**GUARD)
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


@nb.njit(**GUARD)
def total(found, column):
    """Sum of a column over the pieces, in their order."""
    so_far = 0.0
    for i in range(found.shape[0] - 1):
        so_far += found[i, column]
    return so_far


@nb.njit(**GUARD)
def largest(found, column):
    """Largest of a column over the pieces."""
    found_so_far = 0.0
    for i in range(found.shape[0] - 1):
        found_so_far = max(found_so_far, found[i, column])
    return found_so_far


@nb.njit(**GUARD)
def hold_specials(run, options, time, dt, first, which, book):
    """Steps 2 and 4 for the nodes that something besides their own zones acts on; `first`: whether forces were gathered anew."""
    at_start = which == node_step.GX
    if first:
        node_step.load(run.nodes, run.loads, run.given, (run.pulses, run.tables), time + 0.5 * dt, at_start, (options.kind, options.near))
        node_step.exchange(run.nodes, which, run.starts, run.members)
    node_step.free_motion(run.nodes, run.special, which, dt, options.gx, options.gy)
    node_step.transmit(run.nodes, run.gates, run.gate_normals, run.chains, dt, book)
    node_step.hold(run.nodes, run.held, run.held_normals, run.pulses, run.tables, run.chains, time + dt, book)
    if at_start:
        node_step.special_middle(run.nodes, run.special, dt)
    elif book:
        node_step.book_loads(run.nodes, run.loads, run.given, run.chains, dt)


@nb.njit(**GUARD)
def copy(table, to):
    """Copy a table of the chains."""
    for i in range(table.shape[0]):
        for k in range(table.shape[1]):
            to[i, k] = table[i, k]


@nb.njit(**GUARD)
def book_body_force(run, options, control, dt):
    """Work of the body force."""
    n = rows(L.Nodes, run.nodes, 0)
    gx, gy, work = options.gx, options.gy, 0.0
    for i in range(run.lines.shape[0]):
        for j in range(run.lines[i, L.N_COUNT]):
            k = run.lines[i, L.N_NODE] + j
            work += (gx * n.um[k] + gy * n.vm[k]) * n.own[k]
    control[L.GRAVITY_WORK] += dt * work


@nb.njit(**GUARD)
def take_step(run, options, control, counters, team):
    """Steps 1 to 6; the code of `layout` that says how it went."""
    run.steps[0] = choose_step(control)
    if not control[L.DT_NATURAL] > control[L.DT_SMALLEST]:
        return L.STEP_COLLAPSED
    run.steps[1], tries, time = 1.0, 0, control[L.TIME]
    copy(run.chains, run.kept)
    while True:
        dt = run.steps[0]
        node_step.axis_masses(run.nodes, run.axis, run.axis_ratio, options.near, False)
        everyone(PREDICT_NODES, run, options, team)
        hold_specials(run, options, time, dt, run.steps[1] > 0.0, node_step.GX, False)
        everyone(PREDICT_ZONES, run, options, team)
        wrong = total(run.found, L.FOUND_TANGLED)
        if wrong == 0.0:
            node_step.axis_masses(run.nodes, run.axis, run.axis_ratio, options.near, True)
            everyone(MOVE_NODES, run, options, team)
            hold_specials(run, options, time, dt, True, node_step.FX, True)
            everyone(MOVE, run, options, team)
            everyone(LOOK, run, options, team)
            wrong = total(run.found, L.FOUND_TANGLED)
            if wrong == 0.0:
                break
            everyone(TAKE_BACK, run, options, team)
            copy(run.kept, run.chains)
        tries += 1
        counters[L.REPEATED] += 1
        run.steps[0], run.steps[1], control[L.DT_NATURAL] = 0.5 * dt, 0.0, 0.5 * dt
        if tries > MOST_TRIES:
            return L.TANGLED
    control[L.DT] = dt
    if options.gx != 0.0 or options.gy != 0.0:
        book_body_force(run, options, control, dt)
    everyone(CORRECT_ZONES, run, options, team)
    at_event = dt >= control[L.EVENT_TIME] - time
    control[L.TIME] = control[L.EVENT_TIME] if at_event else time + dt
    counters[L.CYCLE] += 1
    control[L.RATE], control[L.WORST_FAILURE] = largest(run.found, FOUND_RATE), largest(run.found, FOUND_FAILURE)
    counters[L.CAP_COUNT] += int(total(run.found, FOUND_CAPPED))
    if total(run.found, FOUND_UNSOUND) > 0.0:
        return L.BAD_STATE
    return L.AT_EVENT if at_event else L.PAUSED


@nb.njit(**GUARD)
def march(cycles, run, options, control, counters, team):
    """Take up to `cycles` steps; returns the code of `layout` that says why it came back."""
    zone_count = run.zones.shape[1]
    for _ in range(cycles):
        code = take_step(run, options, control, counters, team)
        if code == L.STEP_COLLAPSED or code == L.TANGLED:
            return code
        counters[L.ZONE_STEPS] += zone_count
        if code != L.PAUSED:
            return code
        if control[L.TIME] >= control[L.NEXT_GAUGE]:
            return L.GAUGE_DUE
    return L.PAUSED


@nb.njit(**GUARD)
def start(run, options):
    """Forces of the state at t = 0."""
    do_share(START, run, options, 0, 1)
