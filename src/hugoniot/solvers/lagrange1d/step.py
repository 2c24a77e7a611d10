"""One time step, as a numbered list, and the march over many of them without leaving compiled code.

compatible                                             wilkins (Wilkins B.2)
 1. step: Courant, growth, closing gaps, events          1. the same
 2. nodes: drift to the middle by the velocities at n    2. leap nodes and ends by the stresses at n
 3. transmitting ends and gradients beyond the ends      3. zones: strains, yield, q, energy with pressure
 4. zones: stress in the middle of the step              4. watch
 5. nodes: kick by it, drift to the end; boundary work
 6. zones: energy, stress, signal rate at the end
 7. heat flux, conduction, watch: soundness and peaks, failing zones, interfaces, gaps, gauges

The work on zones and nodes is defined by lists of passes (`compatible`, `leapfrog`), which the `plan` executes. A march returns when
its cycles are done, an event time is reached, a gauge buffer is full, a void opens or closes, or a state is invalid; the codes are in
`layout`. The march does not depend on the laws, so it is compiled once for an integrator and a geometry.
"""

from collections import namedtuple
from typing import NamedTuple

import numba as nb
from numba.extending import overload

from hugoniot.core.binder import only_if
from hugoniot.core.passes import Entry, call_entry
from hugoniot.core.shares import everyone
from hugoniot.core.target import BY_ADDRESS, GUARD, INLINE
from hugoniot.mesh import line
from hugoniot.solvers.lagrange1d import layout as L
from hugoniot.solvers.lagrange1d.at_nodes import fail_at_nodes
from hugoniot.solvers.lagrange1d.conduction import conduct
from hugoniot.solvers.lagrange1d.field import AMOUNT
from hugoniot.solvers.lagrange1d.layout import H, Z
from hugoniot.solvers.lagrange1d.nodes import add_impulse, end_node, end_pull, follow_end, leap_end
from hugoniot.solvers.lagrange1d.plan import ADVANCE, AHEAD, CORRECT, DRIFT, DT, DT_HALF, DT_MEAN, FLOW, LEAP, MOVE, PREDICT, gather
from hugoniot.solvers.lagrange1d.pulses import pulse_mean
from hugoniot.solvers.lagrange1d.ring import mix_seam, ring_ghosts, seam_flux
from hugoniot.solvers.lagrange1d.sources import book_force, book_supply, heated_step
from hugoniot.solvers.lagrange1d.terms import Marching
from hugoniot.solvers.lagrange1d.transmitting import ghosts
from hugoniot.solvers.lagrange1d.watch import (
    cavity_closed,
    closing_time,
    failing_node,
    pass_times,
    record_gauges,
    separating_interface,
    touching_gap,
)
from hugoniot.zones.soundness import FOUND_CAPPED, FOUND_FAILURE, FOUND_IMPULSE, FOUND_RATE, FOUND_UNSOUND


class Compatible(NamedTuple):
    """The default integrator; its class, part of the compiled type, chooses the steps that are compiled."""

    staggered: bool = False


class Leapfrog(NamedTuple):
    """Wilkins' integrator."""

    staggered: bool = True


SCHEMES = {"compatible": Compatible(), "wilkins": Leapfrog()}


class Arrays(namedtuple("Arrays", "zones charge nodes gradient control counters segments interfaces passed criteria gauges weights "
                        "gauge_times gauge_buffer asking watching")):
    """What a march works on besides its plan: the tables of `layout`, control numbers, bodies and weak interfaces, times it passes;
    fracture criteria at nodes (`at_nodes`); where gauges sit (`probes`), and the buffer of what they saw; addresses of `ask_at_nodes`, 0
    where no node is asked, and `watch`."""


# -- parts of the step -----------------------------------------------------------------------------------------------
@nb.njit(**GUARD)
def gap_step(zones, nodes, segments, dt_old, staggered, geometry):
    """Shortest time in which a gap closes, from the accelerations of its two free surfaces."""
    shortest = 1e300
    for k in range(segments.shape[0] - 1):
        zl, zr = segments[k, L.SEG_LAST] - 1, segments[k + 1, L.SEG_FIRST]
        left, right = zl + 1 + k, zr + k + 1
        if staggered:
            per_left, pull_left = end_pull(zones, nodes, (left, zl, L.FREE), geometry)
            per_right, pull_right = end_pull(zones, nodes, (right, zr, L.FREE), geometry)
            al, ar = zones[Z.sigma, zl] * per_left + pull_left, -zones[Z.sigma, zr] * per_right + pull_right
        else:
            al = (line.area(nodes[H.r, left], geometry) * zones[Z.sigma, zl] - zones[Z.hoop, zl]) * nodes[H.inverse_mass, left]
            ar = (-line.area(nodes[H.r, right], geometry) * zones[Z.sigma, zr] - zones[Z.hoop, zr]) * nodes[H.inverse_mass, right]
        gap, approach = nodes[H.r, right] - nodes[H.r, left], nodes[H.u, right] - nodes[H.u, left]
        shortest = min(shortest, closing_time(max(gap, 0.0), approach, ar - al, dt_old if staggered else 0.0))
    return shortest


@nb.njit(**BY_ADDRESS)
def choose_step(zones, nodes, control, segments, staggered, geometry):
    """Step 1: Courant, growth, a closing gap (landed on), an event time (hit exactly, approached in two halves)."""
    dt = min(control[L.COURANT] / control[L.RATE], control[L.GROWTH] * control[L.DT_NATURAL], control[L.DT_LARGEST])
    control[L.DT_NATURAL] = dt
    if segments.shape[0] > 1:
        closing = gap_step(zones, nodes, segments, control[L.DT], staggered, geometry)
        if closing <= 1.2 * dt:
            dt = max(closing, 1e-9 * dt)
    if line.hoops(geometry) > 0.0 and segments[0, L.SEG_LEFT] != L.FIXED and nodes[H.u, 0] < 0.0:
        collapse = -nodes[H.r, 0] / nodes[H.u, 0]     # of a cavity on the axis or the origin
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


@nb.njit(**INLINE)
def end_of(segments, end):
    """((node, zone, boundary code), whether it is a left one) of an end of a segment: two for each, left and right."""
    k, left = end // 2, end % 2 == 0
    if left:
        return (segments[k, L.SEG_FIRST] + k, segments[k, L.SEG_FIRST], segments[k, L.SEG_LEFT]), left
    return (segments[k, L.SEG_LAST] + k, segments[k, L.SEG_LAST] - 1, segments[k, L.SEG_RIGHT]), left


def take_step(a, plan, scheme, geometry, boundaries):
    """Steps 2 to 6 of the scheme."""
    raise NotImplementedError("compiled only")


def step_compatible(a, plan, scheme, geometry, boundaries):
    """Steps 2 to 6 of the compatible integrator, and the heat flux."""
    dt, segments = plan.dts[DT], a.segments
    everyone(plan, DRIFT)
    for end in range(2 * segments.shape[0]):
        ends, left = end_of(segments, end)
        follow_end(a.zones, a.nodes, a.control, ends, left, dt, boundaries[0 if left else 1])
    ghosts(a.gradient, a.control, segments)
    ring_ghosts(a.gradient, segments)
    everyone(plan, PREDICT)
    everyone(plan, MOVE)
    for end in range(2 * segments.shape[0]):
        ends, left = end_of(segments, end)
        end_node(a.zones, a.nodes, a.control, ends, left, dt, boundaries[0 if left else 1], geometry)
    everyone(plan, CORRECT)
    through = seam_flux(a.zones, a.nodes, a.control, dt, boundaries[0])
    everyone(plan, FLOW)
    mix_seam(a.zones, through, boundaries[0])


def step_wilkins(a, plan, scheme, geometry, boundaries):
    """Steps 2 and 3 of the leapfrog."""
    everyone(plan, LEAP)
    for end in range(2 * a.segments.shape[0]):
        ends, left = end_of(a.segments, end)
        leap_end(a.zones, a.nodes, a.control, ends, left, plan.dts, boundaries[0 if left else 1], geometry)
    everyone(plan, ADVANCE)


@overload(take_step, jit_options=INLINE)
def _(a, plan, scheme, geometry, boundaries):
    return step_wilkins if scheme.instance_class is Leapfrog else step_compatible


def ask_at_nodes(a, geometry, found):
    """Fracture criteria that are asked at nodes, compiled for the runs that have some."""
    fail_at_nodes(a.zones, a.nodes, a.segments, a.criteria)


AT_NODES = Entry(ask_at_nodes)


@nb.njit(**BY_ADDRESS)
def event_of(a, geometry, found):
    """(what happens to the bodies now, where), or (PAUSED, -1)."""
    gap = touching_gap(a.zones, a.nodes, a.segments) if a.segments.shape[0] > 1 else -1
    if gap >= 0:
        return L.VOID_CLOSES, gap
    if a.asking != 0:
        call_entry(a.asking, a, geometry, found)
    if a.control[L.WORST_FAILURE] >= 1.0 or a.counters[L.FRACTURING] > 0 or a.asking != 0:
        node = failing_node(a.zones, a.segments, a.control, a.counters)
        if node >= 0:
            return L.VOID_OPENS, node
    separating = separating_interface(a.zones, a.nodes, a.interfaces)
    return (L.INTERFACE_OPENS, separating) if separating >= 0 else (L.PAUSED, -1)


def watch(a, geometry, found):
    """Step 7: why the march must stop here, or PAUSED, into counters[STOP]; found: totals of the step.

    Called by its address, and so compiled beside the march, not inside it.
    """
    counters = a.counters
    if found[FOUND_UNSOUND] > 0.0:
        counters[L.STOP] = L.BAD_STATE
        return
    code, culprit = event_of(a, geometry, found)
    if culprit >= 0:
        counters[L.CULPRIT] = culprit
    hollow = line.hoops(geometry) > 0.0 and cavity_closed(a.nodes, a.segments)
    counters[L.STOP] = L.VOID_CLOSES if hollow else code


WATCH = Entry(watch)


@only_if(lambda terms: terms is Marching)
def begin_terms(a, scheme, terms):
    """Force and heat of the step that begins, and the time step they allow."""
    if terms.supply.sums.shape[0] > 0:
        heated_step(a.nodes, a.control, a.segments, terms.supply)
    if terms.force.pulse[0] >= 0.0:     # over the step, or the mean step about its start where velocities stand half a step behind
        dt = a.control[L.DT]
        close = a.control[L.TIME] + (0.5 * dt if scheme.staggered else dt)
        begin = close - (0.5 * (dt + a.control[L.DT_OLD]) if scheme.staggered else dt)
        terms.force.field[AMOUNT] = pulse_mean(begin, close, terms.force.pulse, terms.force.table)


@only_if(lambda terms: terms is Marching)
def end_terms(a, plan, scheme, geometry, terms):
    """What body force and heat sources have done in the step, recorded; conduction."""
    if terms.force.pulse[0] >= 0.0:
        book_force(a.nodes, a.control, plan.dts, scheme.staggered, terms.force)
    if terms.supply.sums.shape[0] > 0:
        book_supply(a.control, terms.supply)
    if terms.conduction.scratch.shape[1] > 0:
        conduct(a.zones, a.nodes, a.segments, plan.dts[DT], terms.conduction, geometry)


@nb.njit(**GUARD)
def march(cycles, a, plan, scheme, geometry, boundaries, terms):
    """Take up to `cycles` steps; returns the code of `layout` that says why it came back."""
    control, counters, zone_count = a.control, a.counters, a.segments[-1, L.SEG_LAST]
    totals, recording = plan.found[plan.found.shape[0] - 1], a.gauges.shape[0] > 0
    pass_times(a.zones, a.nodes, control, counters, a.segments, a.passed)
    for _ in range(cycles):
        if recording and counters[L.GAUGE_ROWS] >= a.gauge_times.shape[0]:
            return L.BUFFER_FULL
        choose_step(a.zones, a.nodes, control, a.segments, scheme.staggered, geometry)
        if not control[L.DT_NATURAL] > control[L.DT_SMALLEST]:
            return L.STEP_COLLAPSED
        begin_terms(a, scheme, terms)
        dt = control[L.DT]
        plan.dts[DT], plan.dts[DT_MEAN], plan.dts[DT_HALF] = dt, 0.5 * (dt + control[L.DT_OLD]), 0.5 * dt
        plan.dts[AHEAD] = min(dt / control[L.DT_OLD], L.LONGEST_AHEAD) if control[L.DT_OLD] > 0.0 else 0.0
        take_step(a, plan, scheme, geometry, boundaries)
        end_terms(a, plan, scheme, geometry, terms)
        gather(plan.found)
        at_event = dt >= control[L.EVENT_TIME] - control[L.TIME]
        control[L.TIME] = control[L.EVENT_TIME] if at_event else control[L.TIME] + dt
        counters[L.CYCLE] += 1
        counters[L.ZONE_STEPS] += zone_count
        control[L.RATE], control[L.WORST_FAILURE] = totals[FOUND_RATE], totals[FOUND_FAILURE]
        add_impulse(control, L.RADIAL_IMPULSE, dt * totals[FOUND_IMPULSE])
        counters[L.CAP_COUNT] += int(totals[FOUND_CAPPED])
        call_entry(a.watching, a, geometry, totals)
        if recording and (control[L.TIME] >= control[L.NEXT_GAUGE] or at_event):
            at = counters[L.GAUGE_ROWS]
            a.gauge_times[at] = control[L.TIME]
            record_gauges(a.zones, a.charge, a.nodes, a.gauges, a.weights, a.gauge_buffer[at])
            counters[L.GAUGE_ROWS] = at + 1
            while control[L.NEXT_GAUGE] <= control[L.TIME] and control[L.GAUGE_INTERVAL] > 0.0:
                control[L.NEXT_GAUGE] += control[L.GAUGE_INTERVAL]
        if counters[L.STOP] != L.PAUSED:
            return counters[L.STOP]
        if at_event and not pass_times(a.zones, a.nodes, control, counters, a.segments, a.passed):
            return L.AT_EVENT
    return L.PAUSED
