"""One time step, as a numbered list, and the march over many of them without leaving compiled code.

compatible                                             wilkins (Wilkins B.2)
 1. step: Courant, growth, closing gaps, events          1. the same
 2. predictor: accelerate nodes, ends, mid positions     2. leap nodes and ends by the stresses at n
 3. gradient ghosts                                      3. zones: strains, q, energy with pressure, yield
 4. zones: stress in the middle of the step              4. watch
 5. corrector: move nodes, ends, book boundary work
 6. zones: energy, stress, signal rate at the end
 7. watch: soundness and peaks, failing zones, interfaces, gaps, gauges

A march returns when its cycles are done, an event time is reached, a gauge buffer is full, a void opens or closes, or a
state is bad; the codes are in `layout`. Which laws a run of zones follows is part of the compiled type: `kinds` is a tuple
of (eos, strength, fracture, viscosity) parameter tuples, `tables` their numbers, a row for each material of that kind.
"""

import importlib
from typing import NamedTuple

import numba as nb
from numba.extending import overload

from hugoniot.core import compile as binding
from hugoniot.core.compile import GUARD, INLINE
from hugoniot.core.team import DISMISSED, Alone, await_call, call, gather_team, sign
from hugoniot.laws.burn.contract import Reactive
from hugoniot.laws.eos import contract as eos_contract
from hugoniot.laws.fracture import contract as fracture_contract
from hugoniot.laws.strength import contract as strength_contract
from hugoniot.laws.viscosity import contract as viscosity_contract
from hugoniot.mesh import line
from hugoniot.solvers.lagrange1d import constitutive
from hugoniot.solvers.lagrange1d import layout as L
from hugoniot.solvers.lagrange1d.node_sweeps import accelerate, end_node, move
from hugoniot.solvers.lagrange1d.watch import (
    cavity_closed,
    closing_time,
    failing_node,
    first_unsound,
    look_over,
    parting_interface,
    record,
    touching_gap,
)
from hugoniot.solvers.lagrange1d.wilkins_sweeps import advance, end_acceleration, leap, leap_end
from hugoniot.solvers.lagrange1d.zone_sweeps import conduct, correct, predict

ACCELERATE, PREDICT, MOVE, CORRECT = range(4)
LEAP, ADVANCE = range(2)


class Compatible(NamedTuple):
    """The default integrator; its class, part of the compiled type, chooses the steps that are compiled."""

    staggered: bool = False


class Leapfrog(NamedTuple):
    """Wilkins' integrator."""

    staggered: bool = True


SCHEMES = {"compatible": Compatible(), "wilkins": Leapfrog()}


def bind_laws():
    """Make every registered law callable from the sweeps; once per process."""
    for family, contract in ((eos_contract.EOS, eos_contract), (strength_contract.STRENGTH, strength_contract),
                             (fracture_contract.FRACTURE, fracture_contract), (viscosity_contract.VISCOSITY, viscosity_contract),
                             (line.GEOMETRY, line)):
        binding.bind_family(family, contract.GENERICS)
    constitutive.bind()


bind_laws()


# -- runs of zones, law by law -----------------------------------------------------------------------------------
def predict_runs(zones, nodes, gradient, runs, found, dt, kinds, tables, geometry, share, of, kind=0):
    """Step 4 over one share of the pieces; recursion over the tuple of kinds is unrolled at compile time."""
    raise NotImplementedError("compiled only")


def correct_runs(zones, nodes, gradient, runs, found, dt, kinds, tables, geometry, share, of, kind=0):
    """Step 6 over one share; a row of `found` takes a piece's (rate, failure, impulse, capped zones)."""
    raise NotImplementedError("compiled only")


def advance_runs(zones, nodes, gradient, runs, found, dt, kinds, tables, geometry, share, of, kind=0):
    """Step 3 of `wilkins` over one share."""
    raise NotImplementedError("compiled only")


def _over_runs(inert_sweep, burning_module, burning_sweep, ends_step, again):
    """The overload of a function over runs: every piece of the first kind that is in this share, then the other kinds.

    burning_sweep   name in `burning_module`, which is imported when a kind comes whose first law is a `Reactive`
    ends_step       whether the state is then that of the end of the step, and is looked over while it is at hand
    """
    def nothing(zones, nodes, gradient, runs, found, dt, kinds, tables, geometry, share, of, kind=0):
        return None

    def over(sweep):
        def impl(zones, nodes, gradient, runs, found, dt, kinds, tables, geometry, share, of, kind=0):
            law, table = kinds[0], tables[0]
            for i in range(share, runs.shape[0], of):
                if runs[i, L.RUN_KIND] == kind:
                    m = runs[i, L.RUN_MATERIAL]
                    rows = (table[0][m], table[1][m], table[2][m], table[3][m], table[4][m])
                    sweep(zones, nodes, gradient, runs[i, L.RUN_FIRST], runs[i, L.RUN_LAST], runs[i, L.RUN_SEGMENT], dt, law, rows,
                          geometry, found[i])
                    if ends_step:
                        found[i, L.FOUND_UNSOUND] = look_over(zones, runs[i, L.RUN_FIRST], runs[i, L.RUN_LAST])
            again(zones, nodes, gradient, runs, found, dt, kinds[1:], tables[1:], geometry, share, of, kind + 1)
        return impl

    def choose(zones, nodes, gradient, runs, found, dt, kinds, tables, geometry, share, of, kind=0):
        if len(kinds) == 0:
            return nothing
        if kinds[0][0].instance_class is not Reactive:
            return over(inert_sweep)
        return over(getattr(importlib.import_module("hugoniot.solvers.lagrange1d." + burning_module), burning_sweep))

    overload(again, jit_options=INLINE)(choose)


_over_runs(predict, "reactive_sweeps", "predict_burning", False, predict_runs)
_over_runs(correct, "reactive_sweeps", "correct_burning", True, correct_runs)
_over_runs(advance, "reactive_leapfrog", "advance_burning", True, advance_runs)


# -- sharing the sweeps ------------------------------------------------------------------------------------------
def do_share(command, scheme, zones, nodes, gradient, pieces, found, dts, kinds, tables, geometry, share, of):
    """One command over one share of the pieces; `pieces` = (runs in pieces, node spans, regions), `dts` = (dt, mean dt)."""
    raise NotImplementedError("compiled only")


@overload(do_share, jit_options=INLINE)
def _(command, scheme, zones, nodes, gradient, pieces, found, dts, kinds, tables, geometry, share, of):
    def compatible(command, scheme, zones, nodes, gradient, pieces, found, dts, kinds, tables, geometry, share, of):
        runs, spans, _ = pieces
        dt = dts[0]
        if command == PREDICT:
            predict_runs(zones, nodes, gradient, runs, found, dt, kinds, tables, geometry, share, of)
        elif command == CORRECT:
            correct_runs(zones, nodes, gradient, runs, found, dt, kinds, tables, geometry, share, of)
        else:
            for i in range(share, spans.shape[0], of):
                if command == ACCELERATE:
                    accelerate(zones, nodes, spans[i, 0], spans[i, 1], spans[i, 2], dt, geometry)
                else:
                    move(zones, nodes, spans[i, 0], spans[i, 1], spans[i, 2], dt, geometry)

    def leapfrog(command, scheme, zones, nodes, gradient, pieces, found, dts, kinds, tables, geometry, share, of):
        runs, spans, _ = pieces
        if command == ADVANCE:
            advance_runs(zones, nodes, gradient, runs, found, dts[0], kinds, tables, geometry, share, of)
        else:
            for i in range(share, spans.shape[0], of):
                leap(zones, nodes, spans[i, 0], spans[i, 1], spans[i, 2], dts[0], dts[1], geometry)

    return leapfrog if scheme.instance_class is Leapfrog else compatible


def everyone(command, scheme, zones, nodes, gradient, pieces, found, dts, kinds, tables, geometry, team):
    """One command over all pieces, shared out if there is a team."""
    raise NotImplementedError("compiled only")


@overload(everyone, jit_options=INLINE)
def _(command, scheme, zones, nodes, gradient, pieces, found, dts, kinds, tables, geometry, team):
    def alone(command, scheme, zones, nodes, gradient, pieces, found, dts, kinds, tables, geometry, team):
        do_share(command, scheme, zones, nodes, gradient, pieces, found, dts, kinds, tables, geometry, 0, 1)

    def together(command, scheme, zones, nodes, gradient, pieces, found, dts, kinds, tables, geometry, team):
        call(team.board, command)
        do_share(command, scheme, zones, nodes, gradient, pieces, found, dts, kinds, tables, geometry, 0, team.threads)
        gather_team(team.board, team.threads)

    return alone if team.instance_class is Alone else together


@nb.njit(**GUARD)
def serve(member, phase, scheme, zones, nodes, gradient, pieces, found, dts, kinds, tables, geometry, team):
    """What every other thread of a team does during a march: the leader's commands on its own share, until dismissed."""
    while True:
        phase = await_call(team.board, phase)
        command = team.board[1]
        if command != DISMISSED:
            do_share(command, scheme, zones, nodes, gradient, pieces, found, dts, kinds, tables, geometry, member, team.threads)
        sign(team.board, member, phase)
        if command == DISMISSED:
            return


@nb.njit(**GUARD)
def gather(found):
    """Totals of one step over the pieces, in their order, into the row behind theirs."""
    totals = found[found.shape[0] - 1]
    totals[:] = 0.0
    for i in range(found.shape[0] - 1):
        totals[L.FOUND_RATE] = max(totals[L.FOUND_RATE], found[i, L.FOUND_RATE])
        totals[L.FOUND_FAILURE] = max(totals[L.FOUND_FAILURE], found[i, L.FOUND_FAILURE])
        for k in range(L.FOUND_IMPULSE, L.FOUND_FLOATS):
            totals[k] += found[i, k]


# -- pieces of the step ------------------------------------------------------------------------------------------
@nb.njit(**GUARD)
def ghosts(gradient, segments):
    """Step 3: beyond an end the field goes on as inside, so that a wall or a free surface is no extremum."""
    for k in range(segments.shape[0]):
        left = segments[k, L.SEG_FIRST] + 2 * k
        right = segments[k, L.SEG_LAST] + 2 * k + 1
        gradient[left] = gradient[left + 1]
        gradient[right] = gradient[right - 1]


@nb.njit(**GUARD)
def gap_step(zones, nodes, segments, dt_old, staggered, geometry):
    """Shortest time in which a gap closes, from the accelerations of its two free surfaces."""
    shortest = 1e300
    for k in range(segments.shape[0] - 1):
        zl, zr = segments[k, L.SEG_LAST] - 1, segments[k + 1, L.SEG_FIRST]
        left, right = zl + 1 + k, zr + k + 1
        if staggered:
            al = end_acceleration(zones, nodes, (left, zl, L.FREE), False, 0.0, geometry)
            ar = end_acceleration(zones, nodes, (right, zr, L.FREE), True, 0.0, geometry)
        else:
            al = (line.area(nodes[L.R, left], geometry) * zones[L.SIGMA, zl] - zones[L.HOOP, zl]) * nodes[L.INVERSE_NODE_MASS, left]
            ar = (-line.area(nodes[L.R, right], geometry) * zones[L.SIGMA, zr] - zones[L.HOOP, zr]) * nodes[L.INVERSE_NODE_MASS, right]
        gap, approach = nodes[L.R, right] - nodes[L.R, left], nodes[L.U, right] - nodes[L.U, left]
        shortest = min(shortest, closing_time(max(gap, 0.0), approach, ar - al, dt_old if staggered else 0.0))
    return shortest


@nb.njit(**GUARD)
def choose_step(zones, nodes, control, segments, staggered, geometry):
    """Step 1: Courant, growth, a closing gap (landed on), an event time (hit exactly, approached in two halves)."""
    dt = min(control[L.COURANT] / control[L.RATE], control[L.GROWTH] * control[L.DT_NATURAL], control[L.DT_LARGEST])
    control[L.DT_NATURAL] = dt
    if segments.shape[0] > 1:
        closing = gap_step(zones, nodes, segments, control[L.DT], staggered, geometry)
        if closing <= 1.2 * dt:
            dt = max(closing, 1e-9 * dt)
    if line.hoops(geometry) > 0.0 and segments[0, L.SEG_LEFT] != L.FIXED and nodes[L.U, 0] < 0.0:
        collapse = -nodes[L.R, 0] / nodes[L.U, 0]     # of a cavity on the axis or the origin
        if collapse <= 1.2 * dt:
            dt = max(collapse, 1e-9 * dt)
    remaining = control[L.EVENT_TIME] - control[L.TIME]
    if remaining <= dt * (1.0 + 1e-9):
        dt = remaining
    elif remaining < 2.0 * dt:
        dt = min(dt, 0.5 * remaining)
    control[L.DT_OLD] = control[L.DT]
    control[L.DT] = dt
    return dt


def take_step(scheme, zones, nodes, gradient, control, segments, pieces, found, dts, kinds, tables, geometry, boundaries, team):
    """Steps 2 to 6 of the scheme."""
    raise NotImplementedError("compiled only")


def step_compatible(scheme, zones, nodes, gradient, control, segments, pieces, found, dts, kinds, tables, geometry, boundaries, team):
    """Steps 2 to 6 of the compatible integrator."""
    dt, regions = dts[0], pieces[2]
    for stage in range(2):
        corrector = stage == 1
        if corrector:
            ghosts(gradient, segments)
            everyone(PREDICT, scheme, zones, nodes, gradient, pieces, found, dts, kinds, tables, geometry, team)
        everyone(MOVE if corrector else ACCELERATE, scheme, zones, nodes, gradient, pieces, found, dts, kinds, tables, geometry, team)
        for k in range(segments.shape[0]):
            first, last = segments[k, L.SEG_FIRST], segments[k, L.SEG_LAST]
            end_node(zones, nodes, control, (first + k, first, segments[k, L.SEG_LEFT]), True, corrector, dt, boundaries[0], geometry)
            end_node(zones, nodes, control, (last + k, last - 1, segments[k, L.SEG_RIGHT]), False, corrector, dt, boundaries[1], geometry)
    everyone(CORRECT, scheme, zones, nodes, gradient, pieces, found, dts, kinds, tables, geometry, team)
    if control[L.HEAT_FLUX] > 0.0:
        for i in range(regions.shape[0]):
            conduct(zones, nodes, regions[i, 0], regions[i, 1], regions[i, 2], dt, control[L.HEAT_FLUX], geometry)


def step_wilkins(scheme, zones, nodes, gradient, control, segments, pieces, found, dts, kinds, tables, geometry, boundaries, team):
    """Steps 2 and 3 of the leapfrog."""
    dt, dt_mean = dts[0], dts[1]
    everyone(LEAP, scheme, zones, nodes, gradient, pieces, found, dts, kinds, tables, geometry, team)
    for k in range(segments.shape[0]):
        first, last = segments[k, L.SEG_FIRST], segments[k, L.SEG_LAST]
        leap_end(zones, nodes, control, (first + k, first, segments[k, L.SEG_LEFT]), True, dt, dt_mean, boundaries[0], geometry)
        leap_end(zones, nodes, control, (last + k, last - 1, segments[k, L.SEG_RIGHT]), False, dt, dt_mean, boundaries[1], geometry)
    everyone(ADVANCE, scheme, zones, nodes, gradient, pieces, found, dts, kinds, tables, geometry, team)


@overload(take_step, jit_options=INLINE)
def _(scheme, zones, nodes, gradient, control, segments, pieces, found, dts, kinds, tables, geometry, boundaries, team):
    return step_wilkins if scheme.instance_class is Leapfrog else step_compatible


@nb.njit(**GUARD)
def watch(zones, nodes, control, counters, segments, interfaces, unsound):
    """Step 7: why the march must stop here, or PAUSED."""
    if unsound:
        counters[L.CULPRIT] = first_unsound(zones, segments[-1, L.SEG_LAST])
        return L.BAD_STATE
    if segments.shape[0] > 1:
        gap = touching_gap(zones, nodes, segments)
        if gap >= 0:
            counters[L.CULPRIT] = gap
            return L.VOID_CLOSES
    if control[L.WORST_FAILURE] >= 1.0 or counters[L.FRACTURING] > 0:
        node = failing_node(zones, segments, control, counters)
        if node >= 0:
            counters[L.CULPRIT] = node
            return L.VOID_OPENS
    parting = parting_interface(zones, nodes, interfaces)
    if parting >= 0:
        counters[L.CULPRIT] = parting
        return L.INTERFACE_OPENS
    return L.PAUSED


@nb.njit(**GUARD)
def march(cycles, scheme, zones, nodes, gradient, control, counters, segments, pieces, found, dts, kinds, tables, geometry, boundaries,
          team, interfaces, gauges, weights, gauge_times, gauge_buffer):
    """Take up to `cycles` steps; returns the code of `layout` that says why it came back."""
    zone_count = segments[-1, L.SEG_LAST]
    totals = found[found.shape[0] - 1]
    for _ in range(cycles):
        if gauges.shape[0] > 0 and counters[L.GAUGE_ROWS] >= gauge_times.shape[0]:
            return L.BUFFER_FULL
        dt = choose_step(zones, nodes, control, segments, scheme.staggered, geometry)
        if not control[L.DT_NATURAL] > control[L.DT_SMALLEST]:
            return L.STEP_COLLAPSED
        dts[0], dts[1] = dt, 0.5 * (dt + control[L.DT_OLD])
        take_step(scheme, zones, nodes, gradient, control, segments, pieces, found, dts, kinds, tables, geometry, boundaries, team)
        gather(found)
        at_event = dt >= control[L.EVENT_TIME] - control[L.TIME]
        control[L.TIME] = control[L.EVENT_TIME] if at_event else control[L.TIME] + dt
        counters[L.CYCLE] += 1
        counters[L.ZONE_STEPS] += zone_count
        control[L.RATE], control[L.WORST_FAILURE] = totals[L.FOUND_RATE], totals[L.FOUND_FAILURE]
        control[L.RADIAL_IMPULSE] += dt * totals[L.FOUND_IMPULSE]
        counters[L.CAP_COUNT] += int(totals[L.FOUND_CAPPED])
        code = watch(zones, nodes, control, counters, segments, interfaces, totals[L.FOUND_UNSOUND] > 0.0)
        if line.hoops(geometry) > 0.0 and code != L.BAD_STATE and cavity_closed(nodes, segments):
            code = L.VOID_CLOSES
        if gauges.shape[0] > 0 and (control[L.TIME] >= control[L.NEXT_GAUGE] or at_event):
            row = counters[L.GAUGE_ROWS]
            gauge_times[row] = control[L.TIME]
            record(zones, nodes, gauges, weights, geometry, gauge_buffer[row])
            counters[L.GAUGE_ROWS] = row + 1
            while control[L.NEXT_GAUGE] <= control[L.TIME] and control[L.GAUGE_INTERVAL] > 0.0:
                control[L.NEXT_GAUGE] += control[L.GAUGE_INTERVAL]
        if code != L.PAUSED:
            return code
        if at_event:
            return L.AT_EVENT
    return L.PAUSED
