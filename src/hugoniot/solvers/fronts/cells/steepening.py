r"""Compressions that have steepened into shocks inside an interval become fronts.

A shock that the cells capture stands over two or three of them. It is found where most of a pressure difference over four cells lies
between two of them (Colella and Woodward's measure, $|p_{i+1}-p_{i-1}| > 0.8\,|p_{i+2}-p_{i-2}|$) and the flow converges. Its cells become
two: the state ahead on one side, and behind it what is left of mass, momentum and energy, the front placed by the mass.
"""

import numpy as np

from hugoniot.laws.riemann.branch import State
from hugoniot.solvers.fronts.cells.flow import Cells
from hugoniot.solvers.fronts.cells.mesh import EMPTY, Front, Mesh, mean_area

STEEP = 0.8
ROOM = 4          # cells between a new front and the next one


def candidates(mesh: Mesh, cells: Cells, weakest: float) -> list[tuple[int, int]]:
    """(cell, direction) of shocks among the cells, stronger than `weakest`, the strongest of each interval."""
    p, u = cells.p, cells.w[:, 1]
    stiffness = cells.w[:, 0] * cells.c**2
    found = []
    first, counts = mesh.intervals()
    for f, n in zip(first.tolist(), counts.tolist()):
        if n < 2 * ROOM + 2 or mesh.region[f] == EMPTY:
            continue
        i = np.arange(f + ROOM, f + n - ROOM)
        near, far = p[i + 1] - p[i - 1], p[i + 2] - p[i - 2]
        jump = np.abs(near) / np.maximum(np.maximum(np.abs(p[i - 1]), np.abs(p[i + 1])), np.maximum(stiffness[i - 1], stiffness[i + 1]))
        shocked = (np.abs(near) > STEEP * np.abs(far)) & (near * far > 0.0) & (u[i - 1] > u[i + 1]) & (jump > weakest)
        if shocked.any():
            k = int(np.argmax(np.where(shocked, jump, 0.0)))
            found.append((int(i[k]), -1 if near[k] > 0.0 else 1))
    return found


def track(mesh: Mesh, cells: Cells, cell: int, direction: int, time: float) -> bool:
    """Make a captured shock around a cell a front; False where its cells allow none."""
    a, b = cell - 1, cell + 2                                   # the cells that are to become two: a to b
    ahead, behind = (b + 1, a - 1) if direction > 0 else (a - 1, b + 1)
    volume = mesh.volume()
    whole, content = float(volume[a:b + 1].sum()), mesh.q[a:b + 1].sum(axis=0)
    far, near = mesh.q[ahead] / volume[ahead], mesh.q[behind] / volume[behind]
    if not near[0] > far[0]:
        return False
    share = (content[0] / whole - far[0]) / (near[0] - far[0])  # of the volume that is behind the front
    if not 0.15 < share < 0.85:
        return False
    lost = far * whole * (1.0 - share)
    kept = content - lost
    inner = share if direction > 0 else 1.0 - share
    left, right = (kept, lost) if direction > 0 else (lost, kept)
    x, end, d = float(mesh.x[a]), float(mesh.x[b + 1]), mesh.d
    place = x + inner * (end - x) if d == 1 else (x**d + inner * d * (end - x) * float(mean_area(x, end, d))) ** (1.0 / d)
    speed = float((far[1] - near[1]) / (far[0] - near[0]))      # by mass
    states = [State(*cells.w[k, :3].tolist(), float(cells.p[k])) for k in (a - 1, b + 1)]
    for _ in range(3):
        mesh.remove_face(a + 1)
    mesh.insert_face(a, place, left, right)
    mesh.marked[a + 1] = True
    strength = abs(states[0].sigma - states[1].sigma) / max(abs(states[0].sigma), abs(states[1].sigma),
                                                            float(cells.w[ahead, 0] * cells.c[ahead] ** 2))
    front = Front("shock", speed, direction, strength, 1, time, place, (tuple(states[0]), tuple(states[1])))
    mesh.fronts.insert(int(np.count_nonzero(mesh.marked[:a + 1])), front)
    return True
