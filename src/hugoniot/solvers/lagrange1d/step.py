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

import numba as nb
from numba.extending import overload

from hugoniot.core import compile as binding
from hugoniot.core.compile import GUARD, SWEEP
from hugoniot.laws.eos import contract as eos_contract
from hugoniot.laws.fracture import contract as fracture_contract
from hugoniot.laws.strength import contract as strength_contract
from hugoniot.laws.viscosity import contract as viscosity_contract
from hugoniot.mesh import line
from hugoniot.solvers.lagrange1d import constitutive, wilkins_sweeps
from hugoniot.solvers.lagrange1d.layout import *  # noqa: F403
from hugoniot.solvers.lagrange1d.node_sweeps import accelerate, end_node, move, outside_stress
from hugoniot.solvers.lagrange1d.watch import closing_time, failing_node, parting_interface, record, touching_gap, unsound
from hugoniot.solvers.lagrange1d.wilkins_sweeps import advance, end_acceleration, leap, leap_end
from hugoniot.solvers.lagrange1d.zone_sweeps import correct, predict


def bind_laws():
    """Make every registered law callable from the sweeps; once per process."""
    for family, contract in ((eos_contract.EOS, eos_contract), (strength_contract.STRENGTH, strength_contract),
                             (fracture_contract.FRACTURE, fracture_contract), (viscosity_contract.VISCOSITY, viscosity_contract),
                             (line.GEOMETRY, line)):
        binding.bind_family(family, contract.GENERICS)
    constitutive.bind()


bind_laws()


# -- runs of zones, law by law -----------------------------------------------------------------------------------
def predict_runs(zones, nodes, gradient, runs, dt, kinds, tables, geometry, kind=0):
    """Step 4 over every run; recursion over the tuple of kinds is unrolled at compile time."""
    raise NotImplementedError("compiled only")


def correct_runs(zones, nodes, gradient, runs, dt, kinds, tables, geometry, totals, kind=0):
    """Step 6 over every run; `totals` gathers (rate, failure, impulse, capped)."""
    raise NotImplementedError("compiled only")


def advance_runs(zones, nodes, gradient, runs, dt, kinds, tables, geometry, totals, kind=0):
    """Step 3 of `wilkins` over every run."""
    raise NotImplementedError("compiled only")


@nb.njit(**GUARD)
def gather(totals, found):
    totals[0] = max(totals[0], found[0])
    totals[1] = max(totals[1], found[1])
    totals[2] += found[2]
    totals[3] += found[3]


@overload(predict_runs)
def _(zones, nodes, gradient, runs, dt, kinds, tables, geometry, kind=0):
    if len(kinds) == 0:
        return lambda zones, nodes, gradient, runs, dt, kinds, tables, geometry, kind=0: None

    def impl(zones, nodes, gradient, runs, dt, kinds, tables, geometry, kind=0):
        law, table = kinds[0], tables[0]
        for i in range(runs.shape[0]):
            if runs[i, RUN_KIND] == kind:
                m = runs[i, RUN_MATERIAL]
                rows = (table[0][m], table[1][m], table[2][m], table[3][m], table[4][m])
                predict(zones, nodes, gradient, runs[i, RUN_FIRST], runs[i, RUN_LAST], runs[i, RUN_SEGMENT], dt, law, rows, geometry)
        predict_runs(zones, nodes, gradient, runs, dt, kinds[1:], tables[1:], geometry, kind + 1)
    return impl


def _gathering(sweep, again):
    def resolve(zones, nodes, gradient, runs, dt, kinds, tables, geometry, totals, kind=0):
        if len(kinds) == 0:
            return lambda zones, nodes, gradient, runs, dt, kinds, tables, geometry, totals, kind=0: None

        def impl(zones, nodes, gradient, runs, dt, kinds, tables, geometry, totals, kind=0):
            law, table = kinds[0], tables[0]
            for i in range(runs.shape[0]):
                if runs[i, RUN_KIND] == kind:
                    m = runs[i, RUN_MATERIAL]
                    rows = (table[0][m], table[1][m], table[2][m], table[3][m], table[4][m])
                    gather(totals, sweep(zones, nodes, gradient, runs[i, RUN_FIRST], runs[i, RUN_LAST], runs[i, RUN_SEGMENT], dt,
                                         law, rows, geometry))
            again(zones, nodes, gradient, runs, dt, kinds[1:], tables[1:], geometry, totals, kind + 1)
        return impl
    return resolve


overload(correct_runs)(_gathering(correct, correct_runs))
overload(advance_runs)(_gathering(advance, advance_runs))


# -- pieces of the step ------------------------------------------------------------------------------------------
@nb.njit(**GUARD)
def ghosts(gradient, segments):
    """Step 3: beyond an end the field goes on as inside, so that a wall or a free surface is no extremum."""
    for k in range(segments.shape[0]):
        left = segments[k, SEG_FIRST] + 2 * k
        right = segments[k, SEG_LAST] + 2 * k + 1
        gradient[left] = gradient[left + 1]
        gradient[right] = gradient[right - 1]


@nb.njit(**GUARD)
def gap_step(zones, nodes, segments, dt_old, staggered, geometry):
    """Shortest time in which a gap closes, from the accelerations of its two free surfaces."""
    shortest = 1e300
    for k in range(segments.shape[0] - 1):
        zl, zr = segments[k, SEG_LAST] - 1, segments[k + 1, SEG_FIRST]
        left, right = zl + 1 + k, zr + k + 1
        if staggered:
            al = end_acceleration(zones, nodes, (left, zl, FREE), False, 0.0, geometry)
            ar = end_acceleration(zones, nodes, (right, zr, FREE), True, 0.0, geometry)
        else:
            al = (line.area(nodes[R, left], geometry) * zones[SIGMA, zl] - zones[HOOP, zl]) * nodes[INVERSE_NODE_MASS, left]
            ar = (-line.area(nodes[R, right], geometry) * zones[SIGMA, zr] - zones[HOOP, zr]) * nodes[INVERSE_NODE_MASS, right]
        gap, approach = nodes[R, right] - nodes[R, left], nodes[U, right] - nodes[U, left]
        shortest = min(shortest, closing_time(max(gap, 0.0), approach, ar - al, dt_old if staggered else 0.0))
    return shortest


@nb.njit(**GUARD)
def choose_step(zones, nodes, control, segments, staggered, geometry):
    """Step 1: Courant, growth, a closing gap (landed on), an event time (hit exactly, approached in two halves)."""
    dt = min(control[COURANT] / control[RATE], control[GROWTH] * control[DT_NATURAL], control[DT_LARGEST])
    control[DT_NATURAL] = dt
    if segments.shape[0] > 1:
        closing = gap_step(zones, nodes, segments, control[DT], staggered, geometry)
        if closing <= 1.2 * dt:
            dt = max(closing, 1e-9 * dt)
    remaining = control[EVENT_TIME] - control[TIME]
    if remaining <= dt * (1.0 + 1e-9):
        dt = remaining
    elif remaining < 2.0 * dt:
        dt = min(dt, 0.5 * remaining)
    control[DT_OLD] = control[DT]
    control[DT] = dt
    return dt


@nb.njit(**SWEEP)
def step_compatible(zones, nodes, gradient, control, segments, runs, kinds, tables, geometry, boundaries, totals, dt):
    """Steps 2 to 6 of the compatible integrator."""
    count = segments.shape[0]
    for stage in range(2):
        corrector = stage == 1
        if corrector:
            ghosts(gradient, segments)
            predict_runs(zones, nodes, gradient, runs, dt, kinds, tables, geometry)
        for k in range(count):
            first, last = segments[k, SEG_FIRST], segments[k, SEG_LAST]
            if corrector:
                move(zones, nodes, first, last, k, dt, geometry)
            else:
                accelerate(zones, nodes, first, last, k, dt, geometry)
            end_node(zones, nodes, control, (first + k, first, segments[k, SEG_LEFT]), True, corrector, dt, boundaries[0], geometry)
            end_node(zones, nodes, control, (last + k, last - 1, segments[k, SEG_RIGHT]), False, corrector, dt, boundaries[1], geometry)
    correct_runs(zones, nodes, gradient, runs, dt, kinds, tables, geometry, totals)


@nb.njit(**SWEEP)
def step_wilkins(zones, nodes, gradient, control, segments, runs, kinds, tables, geometry, boundaries, totals, dt):
    """Steps 2 and 3 of the leapfrog."""
    dt_mean = 0.5 * (dt + control[DT_OLD])
    for k in range(segments.shape[0]):
        first, last = segments[k, SEG_FIRST], segments[k, SEG_LAST]
        leap_end(zones, nodes, control, (first + k, first, segments[k, SEG_LEFT]), True, dt, dt_mean, boundaries[0], geometry)
        leap(zones, nodes, first, last, k, dt, dt_mean, geometry)
        leap_end(zones, nodes, control, (last + k, last - 1, segments[k, SEG_RIGHT]), False, dt, dt_mean, boundaries[1], geometry)
    advance_runs(zones, nodes, gradient, runs, dt, kinds, tables, geometry, totals)


@nb.njit(**GUARD)
def watch(zones, nodes, control, counters, segments, interfaces, zone_count):
    """Step 7: why the march must stop here, or PAUSED."""
    bad = unsound(zones, zone_count)
    if bad >= 0:
        counters[CULPRIT] = bad
        return BAD_STATE
    if segments.shape[0] > 1:
        gap = touching_gap(zones, nodes, segments)
        if gap >= 0:
            counters[CULPRIT] = gap
            return VOID_CLOSES
    if control[WORST_FAILURE] >= 1.0 or counters[FRACTURING] > 0:
        node = failing_node(zones, segments, control, counters)
        if node >= 0:
            counters[CULPRIT] = node
            return VOID_OPENS
    parting = parting_interface(zones, nodes, interfaces)
    if parting >= 0:
        counters[CULPRIT] = parting
        return INTERFACE_OPENS
    return PAUSED


@nb.njit(**GUARD)
def march(cycles, staggered, zones, nodes, gradient, control, counters, segments, runs, kinds, tables, geometry, boundaries,
          interfaces, gauges, weights, gauge_times, gauge_buffer):
    """Take up to `cycles` steps; returns the code of `layout` that says why it came back."""
    zone_count = zones.shape[1]
    totals = control[CONTROL_FLOATS - 4:]
    for _ in range(cycles):
        if gauges.shape[0] > 0 and counters[GAUGE_ROWS] >= gauge_times.shape[0]:
            return BUFFER_FULL
        dt = choose_step(zones, nodes, control, segments, staggered, geometry)
        if not control[DT_NATURAL] > control[DT_SMALLEST]:
            return STEP_COLLAPSED
        totals[:] = 0.0
        if staggered:
            step_wilkins(zones, nodes, gradient, control, segments, runs, kinds, tables, geometry, boundaries, totals, dt)
        else:
            step_compatible(zones, nodes, gradient, control, segments, runs, kinds, tables, geometry, boundaries, totals, dt)
        at_event = dt >= control[EVENT_TIME] - control[TIME]
        control[TIME] = control[EVENT_TIME] if at_event else control[TIME] + dt
        counters[CYCLE] += 1
        counters[ZONE_STEPS] += zone_count
        control[RATE], control[WORST_FAILURE] = totals[0], totals[1]
        control[RADIAL_IMPULSE] += dt * totals[2]
        counters[CAP_COUNT] += int(totals[3])
        code = watch(zones, nodes, control, counters, segments, interfaces, zone_count)
        if gauges.shape[0] > 0 and (control[TIME] >= control[NEXT_GAUGE] or at_event):
            row = counters[GAUGE_ROWS]
            gauge_times[row] = control[TIME]
            record(zones, nodes, gauges, weights, gauge_buffer[row])
            counters[GAUGE_ROWS] = row + 1
            while control[NEXT_GAUGE] <= control[TIME] and control[GAUGE_INTERVAL] > 0.0:
                control[NEXT_GAUGE] += control[GAUGE_INTERVAL]
        if code != PAUSED:
            return code
        if at_event:
            return AT_EVENT
    return PAUSED
