"""What happens between two steps: a body opens where it failed or where bodies separate; gaps and cavities close.

Each of these changes the topology of the run, conserves momentum, accounts for the energy and is reported as an `Event`.
"""

import numpy as np

from hugoniot.core.ops import NO_LIMIT
from hugoniot.problem.starting import part_freely
from hugoniot.solvers.lagrange1d import layout as L
from hugoniot.solvers.lagrange1d.accounts import kinetic_energy
from hugoniot.solvers.lagrange1d.assemble import interface_bond, touching
from hugoniot.solvers.lagrange1d.bodies import join, split
from hugoniot.solvers.lagrange1d.layout import H, Z
from hugoniot.solvers.lagrange1d.start import signal_rate
from hugoniot.solvers.lagrange1d.watch import cavity_closed, mark_patch, touching_gap
from hugoniot.solvers.protocol import Event

TOUCH = 1e-12     # of the kinetic energy of a run: two surfaces that lose less as they meet had not come apart but by round-off


def events_of(solver, code: int) -> list[Event]:
    """Do what the march stopped for, by its code; the events, none for a code that asks for nothing."""
    if code == L.VOID_OPENS:
        return [open_body(solver, int(solver.counters[L.CULPRIT]), "spall")]
    if code == L.INTERFACE_OPENS:
        return [open_body(solver, int(solver.interfaces[solver.counters[L.CULPRIT], 0]), "interface")]
    return close_gaps(solver) if code == L.VOID_CLOSES else []


def open_body(solver, node: int, cause: str) -> Event:
    """Split the body at a node, for a void in a failed zone ("spall") or along an interface ("interface")."""
    k = next(k for k, (a, b, _, _) in enumerate(solver.segments) if a + k < node < b + k)
    zone = node - k
    first, last = solver.segments[k, :2]
    place = float(solver.nodes[H.r, node])
    if cause == "spall":
        mark_patch(solver.table, first, last, zone - 1)
        mark_patch(solver.table, first, last, zone)
        solver.counters[L.FRACTURING] = 1
        solver.opened = np.append(solver.opened, zone)
    else:
        solver.interfaces_separated += 1
    solver.nodes, solver.gradient, solver.segments = split(solver.zones, solver.nodes, solver.gradient, solver.segments, node)
    solver.renew_topology()
    left, right = _names(solver, zone - 1, zone)
    where = f"in '{left}'" if left == right else f"between '{left}' and '{right}'"
    kind, text = ("void_opened", "void opened") if cause == "spall" else ("interface_separated", "interface opened")
    return Event(kind, solver.time, solver.cycle, place, f"{text} {where} at {place:.6g} m")


def part_at_start(solver) -> list[Event]:
    """The events of bodies that touch and part at t = 0, which are separate from the start; given once."""
    regions, solver.fresh = solver.problem.regions, False
    pairs = [pair for pair in zip(regions, regions[1:]) if touching(*pair) and part_freely(solver.problem, *pair)]
    solver.interfaces_separated += len(pairs)
    return [Event("interface_separated", 0.0, 0, a.end, f"interface opened between '{a.name}' and '{b.name}' at {a.end:.6g} m")
            for a, b in pairs]


def close_gaps(solver) -> list[Event]:
    """Join every two bodies that touch; in curved geometry close the cavity that has reached the axis or the origin.

    A contact that costs no more kinetic energy than round-off is no event and is not counted.
    """
    curved = solver.problem.dimension > 1
    events = [close_cavity(solver)] if curved and cavity_closed(solver.nodes, solver.segments) else []
    while (k := touching_gap(solver.table, solver.nodes, solver.segments)) >= 0:
        last = int(solver.segments[k, 1])
        solver.nodes, solver.gradient, solver.segments, heat = join(solver.zones, solver.nodes, solver.gradient, solver.segments, k)
        solver.nodes[H.bond, last + k] = contact_bond(solver.problem, *(int(solver.region_of[zone]) for zone in (last - 1, last)))
        if heat > TOUCH * kinetic_energy(solver.nodes):
            solver.voids_closed += 1
            place = float(solver.nodes[H.r, last + k])
            left, right = _names(solver, last - 1, last)
            events.append(Event("void_closed", solver.time, solver.cycle, place,
                                f"gap between '{left}' and '{right}' closed at {place:.6g} m; "
                                f"{heat:.4g} {_energy_unit(solver)} of kinetic energy became heat"))
        solver.renew_topology()
        _shorten_step(solver, [last - 1, last])
    return events


def _energy_unit(solver) -> str:
    return ("J/m^2", "J/m/rad", "J/sr")[solver.problem.dimension - 1]


def contact_bond(problem, one: int, two: int) -> float:
    """Tension that a new contact of two regions carries, Pa: none, but where they are declared bonded and a gap lay between them."""
    left, right = problem.regions[one], problem.regions[two]
    sticks = two == one + 1 and not touching(left, right) and interface_bond(problem, left, right) == NO_LIMIT
    return NO_LIMIT if sticks else 0.0


def close_cavity(solver) -> Event:
    """The inner surface stops on the axis or the origin; its motion becomes heat, its momentum the impulse of the other side."""
    nodes, zones = solver.nodes, solver.zones
    speed, mass = float(nodes[H.u, 0]), float(nodes[H.mass, 0])
    heat = 0.5 * mass * speed**2
    nodes[H.u, 0] = nodes[H.u_mean, 0] = nodes[H.r, 0] = 0.0
    zones[Z.e, 0] += heat / zones[Z.mass, 0]
    solver.control[L.IMPULSE_LEFT] -= mass * speed
    solver.segments[0, L.SEG_LEFT] = L.FIXED
    _shorten_step(solver, [0])
    solver.voids_closed += 1
    return Event("void_closed", solver.time, solver.cycle, 0.0,
                 f"the cavity closed; {heat:.4g} {_energy_unit(solver)} of kinetic energy became heat")


def _shorten_step(solver, zones: list[int]) -> None:
    """Let the next step know of the shock that an impact starts in these zones."""
    solver.control[L.RATE] = max(solver.control[L.RATE], signal_rate(solver, np.array(zones)))


def _names(solver, *zones: int) -> list[str]:
    """Names of the regions of zones."""
    return [solver.problem.regions[solver.region_of[zone]].name for zone in zones]
