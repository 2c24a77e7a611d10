"""From a problem to its first mesh: cells of the regions, gaps, ends, and the fronts that leave every line between two bodies."""

import numpy as np

from hugoniot.laws.burn.contract import BURN
from hugoniot.laws.riemann.branch import Branch, State, elastic, has_memory, stress, wave_speed_squared
from hugoniot.problem.model import Boundary, Problem
from hugoniot.problem.profiles import velocities_at
from hugoniot.solvers.fronts import setup
from hugoniot.solvers.fronts.cells import pores
from hugoniot.solvers.fronts.cells.mesh import EMPTY, Front, Mesh
from hugoniot.solvers.fronts.cells.solids import with_deviator
from hugoniot.solvers.fronts.cells.spacing import Spacing, cells_of, count, place
from hugoniot.solvers.fronts.cells.tables import COLD, HIGH, LAM, LOW, MEAN
from hugoniot.solvers.fronts.line import Piece

OUTSIDE = {"free": "vacuum", "fixed": "wall", "velocity": "wall", "pressure": "pressure", "transmitting": "open"}
BEND = 1e-3
_GAUSS = (0.5 - np.sqrt(0.15), 0.5, 0.5 + np.sqrt(0.15)), (5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0)


def first_mesh(problem: Problem, spacing: Spacing, variables: int) -> Mesh:
    """The cells at t = 0, with a front on every line between regions and at both ends; no wave has left yet."""
    x, region, marked = [problem.regions[0].start], [], [True]
    cells = cells_of(problem)
    for k, r in enumerate(problem.regions):
        if k and r.start > x[-1]:
            x.append(r.start)
            region.append(EMPTY)
            marked.append(True)
        faces = np.linspace(r.start, r.end, cells[k] + 1)[1:]
        if spacing.d > 1 and (r.start > 0.0 or velocities_at(r, faces[:1])[0] < 0.0):      # a wave will leave the axis or origin
            faces = _graded(r.start, r.end, cells[k], spacing)
        x += faces.tolist()
        region += [k] * len(faces)
        marked += [False] * (len(faces) - 1) + [True]
    mesh = Mesh(np.array(x), np.zeros((len(region), variables)), np.array(region), np.array(marked), [], spacing.d)
    for k, r in enumerate(problem.regions):
        _fill(mesh, np.flatnonzero(mesh.region == k), r, problem.materials[r.material])
        if _programmed(problem.materials[r.material]):
            mesh.region[mesh.region == k] += len(problem.regions)
    at = mesh.faces()
    mesh.fronts = [_first_front(mesh, f) for f in at.tolist()]
    return mesh


def _graded(start: float, end: float, cells: int, spacing: Spacing) -> np.ndarray:
    """Inner faces and the end of a region in curved geometry: finer towards the axis or origin, where waves leave it."""
    h = (end - start) / cells
    low, high = float(count(start, h, spacing.d)), float(count(end, h, spacing.d))
    faces = np.array([place(eta, h, spacing.d) for eta in np.linspace(low, high, max(round(high - low), 1) + 1)[1:]])
    faces[-1] = end
    return faces


def _first_front(mesh: Mesh, face: int) -> Front:
    n = len(mesh.q)
    if face in (0, n):
        return Front("end", 0.0)
    return Front("surface" if EMPTY in (mesh.region[face - 1], mesh.region[face]) else "interface", 0.0)


def _fill(mesh: Mesh, cells, region, material) -> None:
    """Contents of a region's cells, from what stands at three places in each."""
    a, h = mesh.x[cells], mesh.width[cells]
    for node, weight in zip(*_GAUSS):
        x = a + node * h
        (rho, e), u = setup.start_states(region, material, x), velocities_at(region, x)
        mass = weight * h * x ** (mesh.d - 1) * rho
        mesh.q[cells, :3] += np.column_stack([mass, mass * u, mass * (e + 0.5 * u * u)])
        if mesh.q.shape[1] > 3 and has_memory(material.eos):
            mesh.q[cells, 5] += mass * [pores.start(material.eos, *one) for one in zip(rho, e)]
        elif mesh.q.shape[1] > 3:       # nothing has burned; reactants are on the isentrope they rest on; solids have no deviator
            mesh.q[cells, 4:6] += np.column_stack([mass / rho, mass * e if material.burn is not None else 0.0 * mass])


def _programmed(material) -> bool:
    return material.burn is not None and "programmed" in BURN.of(material.burn).flags


def breaks(end: Boundary) -> list[float]:
    """Times after 0 at which a driven end jumps or kinks: steps end there. Of a table, the points at which it bends noticeably."""
    pulse = end.pulse
    if pulse is None:
        return []
    times = _bends(np.array(pulse.times), np.array(pulse.values)) if pulse.shape == "table" else [pulse.start]
    if pulse.shape in ("half_sine", "square", "ramp"):
        times.append(pulse.start + pulse.duration)
    return [t for t in times if t > 0.0]


def _bends(times: np.ndarray, values: np.ndarray) -> list[float]:
    """Points of a table that lie off the line between their neighbours by more than BEND of all it spans; its ends."""
    line = values[:-2] + (values[2:] - values[:-2]) * (times[1:-1] - times[:-2]) / (times[2:] - times[:-2])
    off = np.abs(values[1:-1] - line) > BEND * max(np.abs(values).max(), 1e-300)
    return [float(times[0]), *times[1:-1][off].tolist(), float(times[-1])]


def pieces_at(flow, mesh: Mesh, face: int, averages: bool = False) -> tuple[Piece, Piece]:
    """What stands on the left and right of a front: the values of the parabolas there, or the averages of the cells."""
    w, found = flow.look(mesh), []
    for cell, block, end in ((face - 1, HIGH, 0), (face, LOW, 1)):
        if not 0 <= cell < len(mesh.q):
            found.append(Piece(flow.outside[end]))
        elif mesh.region[cell] == EMPTY:
            found.append(Piece("vacuum"))
        elif mesh.region[cell] >= flow.bench.unburned:
            found.append(Piece("state", int(mesh.region[cell]), State(*w[MEAN:MEAN + 3, cell].tolist(), 0.0)))
        else:
            found.append(_piece(flow, w, MEAN if averages else block, cell, int(mesh.region[cell])))
    for piece, other, way in ((found[0], found[1], -1), (found[1], found[0], 1)):
        if piece.kind == "open":
            piece.state = other.edge(way)
    return found[0], found[1]


def _piece(flow, w, block: int, cell: int, region: int) -> Piece:
    """The state at a face of a cell, or its average where that is not sound."""
    if flow.porous[region % len(flow.porous)]:
        return _porous_piece(flow, w, block, cell, region)
    for rows in (block, MEAN):
        rho, u, e, *mixed = w[rows:rows + LAM + 3, cell].tolist()
        matter = flow.matter(region, *mixed)
        branch = Branch(matter.par)
        if rho > 0.0 and wave_speed_squared(rho, e, branch) > -COLD * u * u:
            break
    return Piece("state", region, with_deviator(rho, u, e, mixed[1], matter, float(stress(rho, e, branch))), matter=matter)


def _porous_piece(flow, w, block: int, cell: int, region: int) -> Piece:
    """The same of material whose pores stay crushed."""
    found = []
    for rows in (block, MEAN):
        rho, u, e, *scalars = w[rows:rows + LAM + 3, cell].tolist()
        matter = flow.matter(region, *scalars)
        found.append(pores.state_of(max(rho, 1e-150), u, e, scalars, matter))
        if rho > 0.0 and wave_speed_squared(rho, e, elastic(matter, found[-1])) > 0.0:
            break
    return Piece("state", region, found[-1])
