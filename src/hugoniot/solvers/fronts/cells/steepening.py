r"""Compressions that have steepened into shocks inside an interval become fronts.

A shock that the cells capture stands over two or three of them. It is found where most of a pressure difference over four cells lies
between two of them (Colella and Woodward's measure, $|p_{i+1}-p_{i-1}| > 0.8\,|p_{i+2}-p_{i-2}|$) and the flow converges. Its cells become
two: the state ahead on one side, and behind it what is left of mass, momentum and energy, the front placed by the mass. Where that is not
the state of the next cell behind, to a quarter of the jump, there is no shock yet (a smooth wave beside an extremum can meet the measure).
"""

import numba as nb
import numpy as np

from hugoniot.core.target import GUARD
from hugoniot.laws.riemann.branch import State
from hugoniot.solvers.fronts.cells.gas import averages
from hugoniot.solvers.fronts.cells.mesh import Front, Mesh, mean_area
from hugoniot.solvers.fronts.cells.tables import DIMENSION, FACE, RHO, STEEP_WAY, WEAKEST, C, P, U

STEEP = 0.8
FORMED = 2.0      # times the weakest wave: a shock that has formed is that strong
ROOM = 4          # cells between a new front and the next one
ALIKE = 0.25      # of the jump: what the two states behind a new front may differ by, velocity and pressure due to energy


@nb.njit(**GUARD)
def steep_cell(grid, rules, work, fronts, count):
    """The last cell, from left to right, that holds a shock stronger than twice the weakest wave; the strongest of its interval, else -1.

    `work.numbers` says in which direction it runs (STEEP_WAY).
    """
    n, w = len(grid.q), work.w
    averages(grid, rules, work, n, int(rules.numbers[DIMENSION]))
    found = -1
    for k in range(count - 1):
        a, b = int(fronts[k, FACE]), int(fronts[k + 1, FACE])
        if b - a < 2 * ROOM + 2 or grid.region[a] < 0:
            continue
        best, cell = FORMED * rules.numbers[WEAKEST], -1
        for i in range(a + ROOM, b - ROOM):
            near, far = w[P, i + 1] - w[P, i - 1], w[P, i + 2] - w[P, i - 2]
            if abs(near) > STEEP * abs(far) and near * far > 0.0 and w[U, i - 1] > w[U, i + 1]:
                size = max(abs(w[P, i - 1]), abs(w[P, i + 1]), w[RHO, i - 1] * w[C, i - 1] ** 2, w[RHO, i + 1] * w[C, i + 1] ** 2)
                if abs(near) > best * size:
                    best, cell = abs(near) / size, i
        if cell >= 0:
            found = cell
            work.numbers[STEEP_WAY] = -1.0 if w[P, cell + 1] > w[P, cell - 1] else 1.0
    return found


def _alike(kept: np.ndarray, near: np.ndarray, far: np.ndarray, jump: float) -> bool:
    """Whether what is left behind a front is the state `near` of the next cell; contents per volume, jump of the pressure."""
    u, u_near, u_far = (float(one[1] / one[0]) for one in (kept, near, far))
    e, e_near = float(kept[2] / kept[0]) - 0.5 * u * u, float(near[2] / near[0]) - 0.5 * u_near * u_near
    return abs(u - u_near) <= ALIKE * abs(u_near - u_far) and abs(e - e_near) * float(near[0]) <= ALIKE * jump


def track(mesh: Mesh, w: np.ndarray, cell: int, direction: int, time: float) -> Front | None:
    """Make a captured shock around a cell a front, and return it; None where its cells allow none.

    w   the table, with the averages of the cells
    """
    a, b = cell - 1, cell + 2                                   # the cells that are to become two: a to b
    ahead, behind = (b + 1, a - 1) if direction > 0 else (a - 1, b + 1)
    volume = mesh.volume()
    whole, content = float(volume[a:b + 1].sum()), mesh.q[a:b + 1].sum(axis=0)
    far, near = mesh.q[ahead] / volume[ahead], mesh.q[behind] / volume[behind]
    if not near[0] > far[0]:
        return None
    share = (content[0] / whole - far[0]) / (near[0] - far[0])  # of the volume that is behind the front
    if not 0.15 < share < 0.85:
        return None
    lost = far * whole * (1.0 - share)
    kept = content - lost
    if not _alike(kept / (share * whole), near, far, abs(float(w[P, behind] - w[P, ahead]))):
        return None
    inner = share if direction > 0 else 1.0 - share
    left, right = (kept, lost) if direction > 0 else (lost, kept)
    x, end, d = float(mesh.x[a]), float(mesh.x[b + 1]), mesh.d
    place = x + inner * (end - x) if d == 1 else (x**d + inner * d * (end - x) * float(mean_area(x, end, d))) ** (1.0 / d)
    speed = float((far[1] - near[1]) / (far[0] - near[0]))      # by mass
    states = [State(*w[:3, k].tolist(), float(w[P, k])) for k in (a - 1, b + 1)]
    for _ in range(3):
        mesh.remove_face(a + 1)
    mesh.insert_face(a, place, left, right)
    mesh.marked[a + 1] = True
    strength = abs(states[0].sigma - states[1].sigma) / max(abs(states[0].sigma), abs(states[1].sigma),
                                                            float(w[RHO, ahead] * w[C, ahead] ** 2))
    front = Front("shock", speed, direction, strength, 1, time, place, (tuple(states[0])[:5], tuple(states[1])[:5]))
    mesh.fronts.insert(int(np.count_nonzero(mesh.marked[:a + 1])), front)
    return front
