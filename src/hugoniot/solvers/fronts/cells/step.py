r"""One step of the cells, a numbered list:

1. averages, parabolas (flow.py)                       2. the step: Courant, meetings, the next event
3. speeds of all faces: fronts as before, cells evenly between them, drawn gently to where they should be (mesh.Spacing)
4. half a step on (Hancock); HLLC at plain faces, the exact Riemann problem at fronts; a meeting within the step ends it
5. contents by fluxes over exact areas of the moving faces, the pressure's part in curved geometry, reaction
6. what the ends exchange is booked; fronts that met are handed back

Conservation: one flux per face, and volumes that are those the faces swept. Momentum is conserved in planar geometry.
"""

from dataclasses import dataclass, field

import numpy as np

from hugoniot.laws.riemann.branch import State
from hugoniot.solvers.fronts.cells import tracked
from hugoniot.solvers.fronts.cells.flow import Cells, Faces, Media, Sides, averages, check, fluxes, hllc, predict, reconstruct, sides
from hugoniot.solvers.fronts.cells.mesh import EMPTY, Mesh, Spacing, mean_area
from hugoniot.solvers.fronts.meeting import Bench

SHIFT = 0.15       # of a cell: how far a step moves a face towards its place
SQUEEZE = 0.5      # of its width: how much a step may close a cell
AMPLE = 0.3        # of the width aimed at: cells no narrower set the step that is normal
CROWDED = 0.01     # of the normal step: a step that small means waves too close to each other to be followed
GROWS = 0.01       # growth per step of an interval that soon makes room for longer steps
LONGER = 1.3       # a step may be this much longer to end in a meeting


@dataclass
class Flow:
    """What a step needs beside the mesh.

    ends      ((kind, value(t)), (kind, value(t))) of the left and right end
    passed    contents that have come in through the left and right end, (2, nvar)
    limiting, crowded   cell that limits the last step, and whether that is much shorter than the other cells ask
    released, parting   faces of fronts that have decayed, and of contacts that open
    """

    media: Media
    bench: Bench
    spacing: Spacing
    ends: tuple
    courant: float
    passed: np.ndarray
    reaction: object = None
    limiting: int = 0
    crowded: bool = False
    released: list[int] = field(default_factory=list)
    parting: list[int] = field(default_factory=list)


def advance(mesh: Mesh, flow: Flow, time: float, longest: float, cycle: int) -> float:
    """Take one step of at most `longest` seconds; its length. `flow.released` and `flow.parting` name fronts (faces) to look at."""
    cells = averages(mesh, flow.media)
    check(mesh, cells, time, cycle)
    left, right = reconstruct(mesh, cells.w)
    known = _known(mesh)
    dt, meeting = _length(mesh, flow, cells, known, longest)
    speed = _speeds(mesh, flow, known, dt)
    predicted = predict(mesh, cells, left, right, speed, dt)
    half = sides(mesh, cells, flow.media, predicted)
    face = hllc(half, speed)
    _at_fronts(mesh, flow, half, face, time + 0.5 * dt)
    dt = _meeting_time(mesh, face.speed, dt, longest if meeting else dt)
    _move(mesh, flow, half, face, dt)
    return dt


def _known(mesh: Mesh) -> np.ndarray:
    """Speeds of all faces as far as known now: of fronts their last ones, of newborn faces their own, linear between."""
    at = mesh.faces()
    known = np.interp(mesh.x, mesh.x[at], [front.speed for front in mesh.fronts])
    known[at] = [front.speed for front in mesh.fronts]
    born = ~np.isnan(mesh.given[:, 0])
    known[born] = mesh.given[born, 0]
    return known


def _length(mesh: Mesh, flow: Flow, cells: Cells, known, longest: float) -> tuple[float, bool]:
    """(length of the step, whether fronts are to meet in it)."""
    h, u, c = mesh.width, cells.w[:, 1], cells.c
    closing = known[:-1] - known[1:]
    full = mesh.full()
    with np.errstate(all="ignore"):
        signal = np.where(full, h / (c + np.maximum(np.abs(u - known[:-1]), np.abs(u - known[1:]))), np.inf) * flow.courant
        squeeze = np.where(full & (closing > 0.0), SQUEEZE * h / closing, np.inf)
    first, counts = mesh.intervals()
    single = first[counts == 1]
    with np.errstate(all="ignore"):
        meets = np.where((closing[single] > 0.0) & (h[single] > 0.0), h[single] / closing[single], np.inf)
    own = np.minimum(signal, squeeze)
    others = own.copy()
    others[single[np.isfinite(meets)]] = np.inf
    dt = min(float(others.min(initial=np.inf)), longest)
    late = single[meets > dt]
    if len(late):
        dt = min(dt, float(own[late].min()))
    soonest = float(meets.min(initial=np.inf))
    flow.limiting = int(np.argmin(own))
    ample = flow.spacing.extents(mesh) > AMPLE
    at = mesh.faces()
    k = int(np.searchsorted(at, flow.limiting, side="right")) - 1
    wide, opening = mesh.x[at[k + 1]] - mesh.x[at[k]], known[at[k + 1]] - known[at[k]]
    normal = min(float(own[ample].min(initial=np.inf)), longest)
    flow.crowded = bool(np.isnan(mesh.push).all()) and dt < CROWDED * normal and opening * dt < GROWS * wide
    return (soonest, True) if soonest <= dt else (dt, False)


def _speeds(mesh: Mesh, flow: Flow, known, dt: float) -> np.ndarray:
    """Speeds of all faces for the step."""
    aim = flow.spacing.targets(mesh, mesh.x + known * dt)
    h = mesh.width
    near = np.minimum(np.append(h, h[-1]), np.insert(h, 0, h[0])) * SHIFT
    moved = np.clip(aim - (mesh.x + known * dt), -near, near)
    free = ~mesh.marked & np.isnan(mesh.given[:, 0])
    return np.where(free, known + moved / dt, known)


def _at_fronts(mesh: Mesh, flow: Flow, half: Sides, face: Faces, time: float) -> None:
    """Put the speeds and states of fronts, and of newborn faces, into the row of faces."""
    flow.released, flow.parting = [], []
    n = len(mesh.q)
    for front, f in zip(mesh.fronts, mesh.faces().tolist()):
        if not np.isnan(mesh.given[f, 0]):
            continue
        if front.kind.startswith("fan"):
            front.speed = _edge(front, half, f)
            face.speed[f] = front.speed
            continue
        left = None if f == 0 or mesh.region[f - 1] == EMPTY else _state(mesh, half, f - 1, 1)
        right = None if f == n or mesh.region[f] == EMPTY else _state(mesh, half, f, 0)
        if any(side is not None and side[0] >= flow.bench.unburned for side in (left, right)):
            behind = f - 1 if front.direction > 0 else min(f, n - 1)
            moved = tracked.explosive(front, left, right, _state(mesh, half, behind, 2)[1], flow.bench)
        elif left is not None and right is not None:
            moved = tracked.between(front, left, right, flow.bench)
        else:
            region, state = next(material for material in (left, right) if material is not None)
            at_end = f in (0, n)
            kind, value = flow.ends[0 if f == 0 else 1] if at_end else ("vacuum", None)
            moved = tracked.end(kind, front, region, state, 1 if left is None else -1, value(time) if value else 0.0, flow.bench)
        front.speed, front.strength = moved.speed, moved.strength
        face.speed[f] = moved.speed
        face.rho[f], face.u[f], face.energy[f], face.p[f] = moved.state
        if moved.parts:
            flow.parting.append(f)
        if front.direction and moved.strength < 0.5 * flow.bench.weakest:
            flow.released.append(f)
    born = np.flatnonzero(~np.isnan(mesh.given[:, 0]))
    face.speed[born], face.rho[born], face.u[born], face.p[born] = mesh.given[born][:, [0, 1, 2, 4]].T
    face.energy[born] = mesh.given[born, 3] + 0.5 * mesh.given[born, 2] ** 2
    for f, (kind, value) in zip((0, n), flow.ends):
        if kind == "wall" and mesh.fronts[0 if f == 0 else -1].kind == "end":      # a piston goes on as it is driven
            mesh.fronts[0 if f == 0 else -1].speed = face.speed[f] = face.u[f] = value(time)


def _state(mesh: Mesh, half: Sides, cell: int, edge: int):
    rho, u, e = half.w[cell, edge, :3].tolist()
    return int(mesh.region[cell]), State(rho, u, e, float(half.p[cell, edge]))


def _edge(front, half: Sides, f: int) -> float:
    """Speed of the edge of a fan: u +- c, of the side outside the fan."""
    d = front.direction
    on_left = (d < 0) == front.kind.endswith("head")
    cell, edge = (f - 1, 1) if on_left else (f, 0)
    return float(half.w[cell, edge, 1] + d * half.c[cell, edge])


def _meeting_time(mesh: Mesh, speed, dt: float, longest: float) -> float:
    """The step with the speeds found: to a meeting of two fronts, if there is one in it or shortly after it."""
    first, counts = mesh.intervals()
    single = first[counts == 1]
    closing = speed[single] - speed[single + 1]
    h = mesh.width[single]
    with np.errstate(all="ignore"):
        meets = np.where((closing > 0.0) & (h > 0.0), h / closing, np.inf)
    soonest = float(meets.min(initial=np.inf))
    return soonest if soonest <= min(LONGER * dt, longest) or soonest < dt else dt


def _move(mesh: Mesh, flow: Flow, half: Sides, face: Faces, dt: float) -> None:
    """Move the faces and let the fluxes pass."""
    new = mesh.x + face.speed * dt
    swept = mean_area(mesh.x, new, mesh.d)
    flux = fluxes(face) * (swept * dt)[:, None]
    mesh.q += flux[:-1] - flux[1:]
    if mesh.d > 1:
        mesh.q[:, 1] += np.where(np.isnan(mesh.push), half.p[:, 2], mesh.push) * np.diff(swept) * dt
    flow.passed[0] += flux[0]
    flow.passed[1] -= flux[-1]
    mesh.x = new
    mesh.given[:], mesh.push[:] = np.nan, np.nan


def met(mesh: Mesh, length: float) -> list[tuple[int, int]]:
    """Runs of fronts (first face, last face) that have met."""
    first, counts = mesh.intervals()
    closed = [f for f, n in zip(first.tolist(), counts.tolist()) if n == 1 and mesh.x[f + 1] - mesh.x[f] <= 1e-13 * length]
    runs: list[list[int]] = []
    for f in closed:
        if runs and runs[-1][1] == f:
            runs[-1][1] = f + 1
        else:
            runs.append([f, f + 1])
    return [(a, b) for a, b in runs]

