"""From a problem to its first mesh: cells of the regions, gaps, ends, and the fronts that leave every line between two bodies."""

import numpy as np

from hugoniot.laws.eos.contract import pressure, sound_speed_squared
from hugoniot.laws.riemann.branch import State
from hugoniot.materials import burning
from hugoniot.materials.initial_state import initial_state
from hugoniot.problem.model import Boundary, Problem, Pulse
from hugoniot.solvers.fronts.cells.flow import COLD, Media, averages, reconstruct
from hugoniot.solvers.fronts.cells.mesh import EMPTY, Front, Mesh, Spacing
from hugoniot.solvers.fronts.line import Piece

OUTSIDE = {"free": "vacuum", "fixed": "wall", "velocity": "wall", "pressure": "pressure", "transmitting": "open"}
_GAUSS = (0.5 - np.sqrt(0.15), 0.5, 0.5 + np.sqrt(0.15)), (5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0)


def first_mesh(problem: Problem, spacing: Spacing) -> Mesh:
    """The cells at t = 0, with a front on every line between regions and at both ends; no wave has left yet."""
    x, region, marked = [problem.regions[0].start], [], [True]
    for k, r in enumerate(problem.regions):
        if k and r.start > x[-1]:
            x.append(r.start)
            region.append(EMPTY)
            marked.append(True)
        faces = np.linspace(r.start, r.end, r.zones + 1)[1:]
        inwards = r.velocity[0] if isinstance(r.velocity, tuple) else r.velocity
        if spacing.d > 1 and (r.start > 0.0 or inwards < 0.0):      # a wave will leave the axis or origin
            faces = _graded(r.start, r.end, r.zones, spacing)
        x += faces.tolist()
        region += [k] * len(faces)
        marked += [False] * (len(faces) - 1) + [True]
    mesh = Mesh(np.array(x), np.zeros((len(region), 3)), np.array(region), np.array(marked), [], spacing.d)
    for k, r in enumerate(problem.regions):
        _fill(mesh, np.flatnonzero(mesh.region == k), r, problem.materials[r.material])
        if problem.materials[r.material].burn is not None:
            mesh.region[mesh.region == k] += len(problem.regions)
    at = mesh.faces()
    mesh.fronts = [_first_front(mesh, f) for f in at.tolist()]
    return mesh


def _graded(start: float, end: float, zones: int, spacing: Spacing) -> np.ndarray:
    """Inner faces and the end of a region in curved geometry: finer towards the axis or origin, where waves leave it."""
    h = (end - start) / zones
    low, high = float(spacing.count(start, h)), float(spacing.count(end, h))
    faces = spacing.place(np.linspace(low, high, max(round(high - low), 1) + 1)[1:], h)
    faces[-1] = end
    return faces


def _first_front(mesh: Mesh, face: int) -> Front:
    n = len(mesh.q)
    if face in (0, n):
        return Front("end", 0.0)
    return Front("surface" if EMPTY in (mesh.region[face - 1], mesh.region[face]) else "interface", 0.0)


def _fill(mesh: Mesh, cells, region, material) -> None:
    """Contents of a region's cells: constant density and energy, a velocity that is constant or linear."""
    start = (region.density, region.pressure, region.temperature, region.energy)
    rho, e = initial_state(material.eos, *start) if material.burn is None else burning.start_state(material, *start)
    ends = region.velocity if isinstance(region.velocity, tuple) else (region.velocity, region.velocity)
    a, h = mesh.x[cells], mesh.width[cells]
    for node, weight in zip(*_GAUSS):
        x = a + node * h
        u = ends[0] + (ends[1] - ends[0]) * (x - region.start) / (region.end - region.start)
        mass = weight * h * x ** (mesh.d - 1) * rho
        mesh.q[cells, :3] += np.column_stack([mass, mass * u, mass * (e + 0.5 * u * u)])


def history(end: Boundary):
    """value(t) of a driven end; None for one that is not driven."""
    if end.kind == "fixed":
        return lambda t: 0.0
    return None if end.pulse is None else lambda t, pulse=end.pulse: pulse_value(pulse, t)


def pulse_value(pulse: Pulse, t: float) -> float:
    """A driven quantity at a time; at a jump the value after it."""
    if pulse.shape == "table":
        return float(np.interp(t, pulse.times, pulse.values))
    s = t - pulse.start
    if s < 0.0:
        return 0.0
    if pulse.shape == "constant":
        return pulse.amplitude
    if pulse.shape == "exponential":
        return pulse.amplitude * float(np.exp(-s / pulse.duration))
    if pulse.shape == "ramp":
        return pulse.amplitude * min(s / pulse.duration, 1.0)
    if s >= pulse.duration:
        return 0.0
    return pulse.amplitude * (float(np.sin(np.pi * s / pulse.duration)) if pulse.shape == "half_sine" else 1.0)


def breaks(end: Boundary) -> list[float]:
    """Times after 0 at which a driven end jumps or kinks: steps end there."""
    pulse = end.pulse
    if pulse is None:
        return []
    times = list(pulse.times) if pulse.shape == "table" else [pulse.start]
    if pulse.shape in ("half_sine", "square", "ramp"):
        times.append(pulse.start + pulse.duration)
    return [t for t in times if t > 0.0]


def _sound(rho: float, u: float, e: float, law) -> bool:
    """Whether a state has a pressure and a speed of sound."""
    if not rho > 0.0:
        return False
    square = sound_speed_squared(rho, e, law)
    return bool(np.isfinite(pressure(rho, e, law)) and square > -COLD * u * u)


def pieces_at(mesh: Mesh, face: int, media: Media, outside) -> tuple[Piece, Piece]:
    """What stands on the left and right of a front: `outside` are the kinds of the two ends."""
    cells = averages(mesh, media)
    left, right = reconstruct(mesh, cells.w)
    found = []
    for cell, values, end in ((face - 1, right, 0), (face, left, 1)):
        if not 0 <= cell < len(mesh.q):
            found.append(Piece(outside[end]))
        elif mesh.region[cell] == EMPTY:
            found.append(Piece("vacuum"))
        else:
            law = media.laws[mesh.region[cell]]
            if law is None:
                found.append(Piece("state", int(mesh.region[cell]), State(*cells.w[cell, :3].tolist(), 0.0)))
                continue
            rho, u, e = values[cell, :3].tolist() if _sound(*values[cell, :3].tolist(), law) else cells.w[cell, :3].tolist()
            found.append(Piece("state", int(mesh.region[cell]), State(rho, u, e, float(pressure(rho, e, law)))))
    for piece, other, way in ((found[0], found[1], -1), (found[1], found[0], 1)):
        if piece.kind == "open":
            piece.state = other.edge(way)
    return found[0], found[1]
