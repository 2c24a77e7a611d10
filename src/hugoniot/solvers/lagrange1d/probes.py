"""Where gauges sit: from a gauge's request to the zones and faces it reads, redone whenever a body splits or joins."""

import numpy as np

from hugoniot.errors import OutOfRange
from hugoniot.solvers.lagrange1d import layout as L
from hugoniot.solvers.lagrange1d.layout import Z


def probe_tables(solver):
    """(table, weights) of `watch.record` for the problem's gauges.

    A point gauge interpolates zone fields linearly in mass between zone centres of its own region and body, and the velocity
    between the faces of its zone. An interface gauge reads the traction of the common node (mass-weighted, as the node feels it)
    and, once the bodies part, the left side. A surface gauge reads the outermost face and its zone.
    """
    table, weights = [], []
    for gauge in solver.problem.gauges:
        entry = _point(solver, gauge.at) if isinstance(gauge.at, (int, float)) else _named(solver, gauge.at)
        zone_a, zone_b, face_zone, w, f = entry
        segment = int(np.searchsorted(solver.segments[:, L.SEG_LAST], face_zone, side="right"))
        table.append((zone_a, zone_b, face_zone, face_zone + segment))
        weights.append((w, f))
    return np.array(table, dtype=np.int64).reshape(-1, 4), np.array(weights, dtype=float).reshape(-1, 2)


def _point(solver, place):
    left, right = solver.initial_nodes
    d = solver.problem.dimension
    span = right[-1] - left[0]
    inside = np.flatnonzero((left <= place + 1e-12 * span) & (place <= right + 1e-12 * span))
    if inside.size == 0:
        raise OutOfRange(f"there is no material at {place:g} m at t = 0")
    z = int(inside[-1])
    f = min(max((place**d - left[z]**d) / (right[z]**d - left[z]**d), 0.0), 1.0)
    other = z + 1 if f >= 0.5 else z - 1
    if not _same_piece(solver, z, other):
        return z, z, z, 0.0, f
    mass = solver.zones[Z.mass]
    w = abs(f - 0.5) * mass[z] / (0.5 * (mass[z] + mass[other]))
    return z, other, z, w, f


def _same_piece(solver, a, b):
    if not 0 <= b < solver.zones.shape[1] or solver.region_of[a] != solver.region_of[b]:
        return False
    lasts = solver.segments[:, L.SEG_LAST]
    return np.searchsorted(lasts, a, side="right") == np.searchsorted(lasts, b, side="right")


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
    lasts = solver.segments[:, L.SEG_LAST]
    joined = other == z + 1 and np.searchsorted(lasts, z, side="right") == np.searchsorted(lasts, other, side="right")
    mass = solver.zones[Z.mass]
    return (z, other, z, mass[z] / (mass[z] + mass[other]), 1.0) if joined else (z, z, z, 0.0, 1.0)
