"""Positions of gauges: the zones and faces that each gauge reads, updated whenever bodies split or join."""

import bisect

import numpy as np

from hugoniot.errors import OutOfRange
from hugoniot.solvers.lagrange1d import layout as L
from hugoniot.solvers.lagrange1d.layout import Z
from hugoniot.solvers.lagrange1d.pulses import pulse_value


def probe_tables(solver):
    """(table, weights) of `watch.record_gauges` for the problem's gauges.

    A point gauge interpolates zone fields linearly in mass between zone centres of its own region and body, and the velocity
    between the faces of its zone. An interface gauge reads the traction of the common node (mass-weighted, as the node feels it)
    and, once the bodies separate, the left side. A surface gauge reads the outermost face and its zone, but not that zone's stress: the
    stress of a surface is the one applied to it (`applied_stress`), zero where it is free.
    """
    table, weights = [], []
    for gauge, place in zip(solver.problem.gauges, solver.gauge_places):
        entry = _named(solver, gauge.at) if place is None else _point(solver, *place)
        zone_a, zone_b, face_zone, w, f = entry
        segment = _segment(solver, face_zone)
        table.append((zone_a, zone_b, face_zone, face_zone + segment))
        weights.append((w, f, 0.0 if _surface(solver, face_zone, f) in (L.FREE, L.PRESSURE) else 1.0))
    return np.array(table, dtype=np.int64).reshape(-1, 4), np.array(weights, dtype=float).reshape(-1, 3)


def gauge_places(solver) -> list[tuple[int, float] | None]:
    """(zone, share of its mass on the left) of every point gauge, where it stays; None for other gauges."""
    return [_place(solver, gauge.at) if isinstance(gauge.at, (int, float)) else None for gauge in solver.problem.gauges]


def _segment(solver, zone):
    return bisect.bisect_right(solver.segments[:, L.SEG_LAST], zone)


def _surface(solver, zone, f):
    """Boundary code of the surface that a gauge sits on, at the left (f = 0) or right face (1) of a zone; None inside a body."""
    segment = solver.segments[_segment(solver, zone)]
    if f == 0.0 and zone == segment[L.SEG_FIRST]:
        return segment[L.SEG_LEFT]
    return segment[L.SEG_RIGHT] if f == 1.0 and zone + 1 == segment[L.SEG_LAST] else None


def applied_stress(solver, times):
    """What the ends of the run apply to the gauges that sit on them, Pa, (n, ngauge): the pressure of a driven end, zero elsewhere."""
    found = np.zeros((len(times), len(solver.gauges)))
    ends = zip((0, solver.zones.shape[1] - 1), (0.0, 1.0), solver.boundaries)
    for zone, f, boundary in ends:
        here = (solver.gauges[:, 2] == zone) & (solver.weights[:, 1] == f)
        if here.any() and _surface(solver, zone, f) == L.PRESSURE:
            found[:, here] = np.array([pulse_value(t, boundary.pulse, boundary.table) for t in times])[:, None]
    return found


def _place(solver, place):
    left, right = solver.initial_nodes
    d = solver.problem.dimension
    span = right[-1] - left[0]
    inside = np.flatnonzero((left <= place + 1e-12 * span) & (place <= right + 1e-12 * span))
    if inside.size == 0:
        raise OutOfRange(f"there is no material at {place:g} m at t = 0")
    z = int(inside[-1])
    return z, min(max((place**d - left[z]**d) / (right[z]**d - left[z]**d), 0.0), 1.0)


def _point(solver, z, f):
    other = z + 1 if f >= 0.5 else z - 1
    if not 0 <= other < solver.zones.shape[1] or solver.region_of[z] != solver.region_of[other] \
            or _segment(solver, z) != _segment(solver, other):
        return z, z, z, 0.0, f
    mass = solver.zones[Z.mass]
    w = abs(f - 0.5) * mass[z] / (0.5 * (mass[z] + mass[other]))
    return z, other, z, w, f


def _named(solver, at):
    count = solver.zones.shape[1]
    if at == "free surface left":
        return 0, 0, 0, 0.0, 0.0
    if at == "free surface right":
        return count - 1, count - 1, count - 1, 0.0, 1.0
    names = [region.name for region in solver.problem.regions]
    if ":" in at:
        name, side = (part.strip() for part in at.split(":", 1))
        first, last = solver.region_ranges[names.index(name)]
        return (first, first, first, 0.0, 0.0) if side == "left" else (last - 1, last - 1, last - 1, 0.0, 1.0)
    a, b = (names.index(part.strip()) for part in at.split("/", 1))
    left, right = min(a, b), max(a, b)
    z = solver.region_ranges[left][1] - 1
    other = solver.region_ranges[right][0]
    joined = other == z + 1 and _segment(solver, z) == _segment(solver, other)
    mass = solver.zones[Z.mass]
    return (z, other, z, mass[z] / (mass[z] + mass[other]), 1.0) if joined else (z, z, z, 0.0, 1.0)
