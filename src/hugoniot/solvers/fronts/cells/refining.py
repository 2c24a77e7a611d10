r"""Cells that burn faster than they resolve are halved, and joined again when that has passed.

The change of the burn fraction that a cell has to resolve is $\dot\lambda h/c$, what burns while sound crosses it; behind a tracked shock
it is also the difference to the burn fraction ahead, because a reaction may run to its end within the first cell. Where it exceeds
`solver.options.burn_step`, in that first cell an eighth of it (FIRST), the cell is halved, at most DEEPEST times; two that are halved alike
are joined where together they change it by less than half of what they may. Cells beside each other differ by one halving at most. Contents
only move from cell to cell (`mesh.split`).
"""

import numba as nb
import numpy as np

from hugoniot.core.target import BY_ADDRESS, GUARD
from hugoniot.solvers.fronts.cells.gas import averages, each_burning
from hugoniot.solvers.fronts.cells.mesh import Mesh, split
from hugoniot.solvers.fronts.cells.tables import (
    BURN_STEP,
    CHANGES,
    DIMENSION,
    DIRECTION,
    FACE,
    FULL,
    KIND,
    LAM,
    MEAN,
    PACE,
    PLAN,
    SHOCK,
    UNRESOLVED,
    UNSPLIT,
    C,
    E,
)

DEEPEST = 5        # times a cell may be halved
MOST = 400         # cells that may be halved at a time
FIRST = 8.0        # behind a shock terms of a rate end at burn fractions of a few hundredths, and all that follows depends on where
CALM = 0.5         # of what a cell may change: two cells that together change the burn fraction by less are joined
NOTED = 1.5        # times what a cell may change: where one that can be halved no more changes that, a warning says so
SPLIT, JOIN, GROW = 1.0, -1.0, -2.0      # entries of the row PLAN: JOIN with the cell on the right, GROW to the share of one a level lower


@nb.njit(**GUARD)
def paces(grid, rules, work, n):
    """Rates of burning of all cells, 1/s, into the row PACE."""
    work.w[PACE, :n] = 0.0
    each_burning(grid, rules, work, n, 3, (MEAN, MEAN + E, MEAN + LAM, MEAN + LAM + 1, MEAN + LAM + 2, PACE, PACE, PACE), 0.0)


@nb.njit(**BY_ADDRESS)
def changes(grid, work, fronts, count, n):
    """What every cell has to resolve of the burn fraction, into the row CHANGES; times FIRST in the first cell behind a shock."""
    w = work.w
    for i in range(n):
        w[CHANGES, i] = 0.0
        if w[FULL, i] > 0.0 and w[MEAN + C, i] > 0.0:
            w[CHANGES, i] = w[PACE, i] * (grid.x[i + 1] - grid.x[i]) / w[MEAN + C, i]
    for k in range(1, count - 1):
        f, way = int(fronts[k, FACE]), fronts[k, DIRECTION]
        if int(fronts[k, KIND]) != SHOCK or way == 0.0:
            continue
        behind, ahead = (f - 1, f) if way > 0.0 else (f, f - 1)
        if grid.region[behind] == grid.region[ahead] and w[FULL, behind] > 0.0 and w[FULL, ahead] > 0.0:
            w[CHANGES, behind] = FIRST * max(w[CHANGES, behind], w[MEAN + LAM, behind] - w[MEAN + LAM, ahead])


@nb.njit(**GUARD)
def plan(grid, rules, work, fronts, count):
    """What is to be done with every cell, into the row PLAN; to how many something is to be done. Needs averages and paces."""
    n, w, most = len(grid.q), work.w, rules.numbers[BURN_STEP]
    changes(grid, work, fronts, count, n)
    halved = 0
    for i in range(n):
        halved += grid.level[i] > 0
    for i in range(n):               # the level that is wanted
        level, burns = grid.level[i], w[FULL, i] > 0.0 and rules.passes[grid.region[i], 2] != 0
        w[PLAN, i] = level
        if burns and w[CHANGES, i] > most:
            if level < DEEPEST and halved < MOST:
                w[PLAN, i] = level + 1
            else:
                work.numbers[UNSPLIT] = max(work.numbers[UNSPLIT], w[CHANGES, i] / most)
        elif level > 0 and 2.0 * w[CHANGES, i] < CALM * most:
            w[PLAN, i] = level - 1
    for i in range(1, n):            # in steps of one from cell to cell, but for fronts
        if not grid.marked[i]:
            w[PLAN, i] = max(w[PLAN, i], w[PLAN, i - 1] - 1.0, grid.level[i - 1] - 1.0)
    for i in range(n - 2, -1, -1):
        if not grid.marked[i + 1]:
            w[PLAN, i] = max(w[PLAN, i], w[PLAN, i + 1] - 1.0, grid.level[i + 1] - 1.0)
    done, i = 0, 0
    while i < n:
        level, less = grid.level[i], w[PLAN, i] < grid.level[i]
        beside = i + 1 < n and not grid.marked[i + 1] and grid.level[i + 1] == level
        before = i > 0 and not grid.marked[i] and grid.level[i - 1] == level
        pair = less and beside and w[PLAN, i + 1] < level
        alone = less and not (beside or before)
        w[PLAN, i] = SPLIT if w[PLAN, i] > level and w[FULL, i] > 0.0 else JOIN if pair else GROW if alone else 0.0
        done += w[PLAN, i] != 0.0
        if pair:
            w[PLAN, i + 1] = 0.0
        i += 2 if pair else 1
    return done


@nb.njit(**GUARD)
def watch(grid, rules, work, fronts, count):
    """Note whether cells are to be halved or joined after this step."""
    if rules.numbers[BURN_STEP] > 0.0 and plan(grid, rules, work, fronts, count) > 0:
        work.numbers[UNRESOLVED] = 1.0


@nb.njit(**GUARD)
def look_again(grid, rules, work, fronts, count):
    """The same for the contents as they are now: row PLAN."""
    n = len(grid.q)
    averages(grid, rules, work, n, int(rules.numbers[DIMENSION]))
    paces(grid, rules, work, n)
    plan(grid, rules, work, fronts, count)


class Refining:
    """Halves and joins cells for their burning; how often, and how deep in every region.

    log   called as log(kind, time, position, text)
    """

    def __init__(self, flow, log):
        self.flow, self.log = flow, log
        self.halved = self.joined = 0
        self.deepest = [0] * len(flow.laws)

    def after_step(self, mesh: Mesh, time: float) -> None:
        """Do what the plan says."""
        flow, numbers = self.flow, self.flow.work.numbers
        numbers[UNRESOLVED] = 0.0
        n = len(mesh.q)
        look_again(flow.grid(mesh), flow.rules, flow.work, flow.rows(mesh), len(mesh.fronts))
        todo, found = flow.work.w[PLAN, :n].copy(), flow.work.w[CHANGES, :n].copy()
        slopes = {k: flow.slopes(mesh, k) for k in np.flatnonzero(todo == SPLIT).tolist()}
        for k in reversed(np.flatnonzero(todo).tolist()):       # from the right, so that the numbers on the left stay
            if todo[k] == SPLIT:
                self._note(mesh, k, float(found[k]), time)
                split(mesh, k, slopes[k])
                mesh.level[k:k + 2] += 1
                self.halved += 1
            elif todo[k] == JOIN:
                level = int(mesh.level[k])
                mesh.remove_face(k + 1)
                mesh.level[k] = level - 1
                self.joined += 1
            else:
                mesh.level[k] -= 1

    def _note(self, mesh: Mesh, cell: int, change: float, time: float) -> None:
        """A line in the log where cells of a region become finer than they ever were."""
        region, level = int(mesh.region[cell]) % len(self.deepest), int(mesh.level[cell]) + 1
        if level <= self.deepest[region]:
            return
        self.deepest[region] = level
        name, bound = self.flow.problem.regions[region].name, float(self.flow.rules.numbers[BURN_STEP])
        self.log("refined", time, float(mesh.middle[cell]), f"cells of region '{name}' are halved to 1/{2**level}, because one burns "
                 f"{change / bound:.2g} times what solver.options.burn_step = {bound:g} allows,")

    def results(self) -> dict[str, float]:
        """What a summary adds, where cells were halved."""
        if not self.halved:
            return {}
        return {"cells_halved": float(self.halved), "halved_cells_joined": float(self.joined), "finest_halving": float(max(self.deepest))}

    def warnings(self) -> list[str]:
        """A sentence where halving came to its bounds."""
        left = float(self.flow.work.numbers[UNSPLIT])
        if left < NOTED:
            return []
        return [f"burning was not resolved: a cell burned {left:.2g} times what solver.options.burn_step allows; cells are halved at most "
                f"{DEEPEST} times, at most {MOST} of them at a time: use more zones there"]

    def numbers(self) -> list[int]:
        """What a checkpoint holds."""
        return [self.halved, self.joined, *self.deepest]

    def set_numbers(self, numbers) -> None:
        """Continue from them."""
        self.halved, self.joined, *self.deepest = (int(number) for number in numbers)
