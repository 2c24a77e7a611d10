"""The compiled march seen from Python: laws and ends as numbers, scratch, mesh and fronts as arrays and back."""

from typing import Any

import numpy as np

from hugoniot.core.passes import numbers_of
from hugoniot.errors import UnphysicalState
from hugoniot.laws.arrays import float_parameters
from hugoniot.laws.burn.contract import BURN, Reactive
from hugoniot.laws.eos.contract import EOS, density_limits, flagged
from hugoniot.laws.mixture.contract import MIXTURE
from hugoniot.laws.riemann.branch import Matter, State, has_memory
from hugoniot.laws.riemann.fan import SPRAY
from hugoniot.laws.riemann.medium import Frozen, Porous, Solid, mixture_limit
from hugoniot.materials import burning
from hugoniot.problem.model import Problem
from hugoniot.solvers.fronts import extremes, setup
from hugoniot.solvers.fronts.cells import march, parabolas, solids, steepening, tables, tracked
from hugoniot.solvers.fronts.cells.gas import averages
from hugoniot.solvers.fronts.cells.mesh import Mesh
from hugoniot.solvers.fronts.cells.passes import burn_pass, crush_pass, pace_pass, states_pass, wave_pass
from hugoniot.solvers.fronts.cells.spacing import Spacing, cells_of
from hugoniot.solvers.fronts.cells.tables import MEAN, C, Grid, P, Rules
from hugoniot.solvers.fronts.meeting import Bench

NEAR = 0.95        # of the highest density of a law
EXACT = 1e-4       # burn fraction from which isolated reactants keep the isentrope behind their shock, which is exact here
NO_DRIVE = ("none", 0.0, 0.0, 1.0)
SHAPES = ("square", "constant", "half_sine", "ramp", "exponential", "table", "none")


def law_of_region(material) -> Any:
    """What the cells ask: the equation of state, a solid's with its strength, or rate and mixture of a material that burns by a rate."""
    if material.burn is None or "programmed" in BURN.of(material.burn).flags:
        matter = setup.matter_of(material)
        if has_memory(matter.par):
            return float_parameters(Porous(matter.par))
        return float_parameters(Solid(*matter[:3]) if matter.yield_stress else material.eos)
    pair = burning.reactive(material)
    if hasattr(pair.mixture, "nascent_limit"):
        pair = pair._replace(mixture=pair.mixture._replace(nascent_limit=EXACT))
    return float_parameters(pair)


class Flow:
    """What a step needs beside the mesh: `bench` for the exact Riemann problems, `spacing`, the ends, and the tables of the march.

    owner, middles   region of every zone of the problem, and the share of its mass left of the zone's middle, (nzone,)
    """

    def __init__(self, problem: Problem, bench: Bench, outside, options: dict, courant: float, owner, middles):
        self.bench, self.outside, self.problem = bench, outside, problem
        self.laws = [law_of_region(problem.materials[r.material]) for r in problem.regions]
        self.burns = any(isinstance(law, Reactive) for law in self.laws)
        self.solid = np.array([isinstance(law, Solid) for law in self.laws])
        self.porous = np.array([isinstance(law, Porous) for law in self.laws])
        self.variables = 6 if self.burns or self.solid.any() or self.porous.any() else 3
        self.burns_by_rate = [isinstance(law, Reactive) for law in self.laws]
        burnt = [problem.materials[r.material].burn is not None for r in problem.regions]
        self.programmed = [one and not rate for one, rate in zip(burnt, self.burns_by_rate)]      # products of programmed fronts
        self._numbers = [numbers_of(law) for law in self.laws]
        self.spacing = Spacing(problem.dimension, np.array(cells_of(problem), dtype=float))
        self.rules = self._rules(options, courant)
        self.work = tables.make_work(64, self.variables, len(self.laws), np.vstack([middles, extremes.start(len(middles))]), owner)
        self.work.numbers[tables.RESOLUTION] = 1e300

    def follow(self, weakest: float) -> None:
        """Follow waves from this strength on."""
        self.bench.weakest = self.rules.numbers[tables.WEAKEST] = weakest

    def _rules(self, options: dict, courant: float) -> Rules:
        problem, count = self.problem, len(self.laws)
        passes, words = np.zeros((2 * count, 4), dtype=np.int64), np.zeros(2 * count, dtype=np.int64)
        limits, traits = np.zeros((2 * count, 3)), np.zeros((count, 6))
        for k, law in enumerate(self.laws):
            burns = isinstance(law, Reactive)
            last = (burn_pass.address(law), pace_pass.address(law)) if burns else (0, crush_pass.address(law) if self.porous[k] else 0)
            passes[k] = (states_pass.address(law), wave_pass.address(law), *last)
            words[k] = self._numbers[k].ctypes.data
            if burns:
                whole = min(mixture_limit(0.0, law.mixture), mixture_limit(1.0, law.mixture))
                limits[k] = whole, density_limits(law.mixture.reactants)[1], density_limits(law.mixture.products)[1]
                gas = flagged(law.mixture.products, "gas") and flagged(law.mixture.reactants, "gas")
            else:
                eos = getattr(law, "eos", law)
                limits[k], gas = density_limits(eos)[1], flagged(eos, "gas")
            traits[k] = self.spacing.zones[k], min(self.bench.grips[k], 1e300), gas, *solids.traits(law), self.porous[k]
        np.minimum(limits, 1e30, out=limits)
        ends, lists = np.zeros((2, 5)), []
        for row, end, kind in zip(ends, (problem.left, problem.right), self.outside):
            pulse = end.pulse
            shape, *rest = NO_DRIVE if pulse is None else (pulse.shape, pulse.amplitude, pulse.start, pulse.duration)
            row[:] = tables.OUTSIDE[kind], SHAPES.index(shape), *rest
            lists.append((pulse.times, pulse.values) if pulse is not None and shape == "table" else ((0.0,), (0.0,)))
        longest = max(len(times) for times, _ in lists)
        padded = [np.array([[*row, *[row[-1]] * (longest - len(row))] for row in rows], dtype=float) for rows in zip(*lists)]
        length = problem.regions[-1].end - problem.regions[0].start
        elastic = self.bench.elastic if self.solid.any() or self.porous.any() else 0.0
        numbers = np.array([problem.dimension, courant, float(options["weakest"]), length, problem.stop_time, self.burns,
                            self.bench.unburned, int(options["most_fronts"]), elastic,
                            float(options["burn_step"]), traits[:, tables.KINKS].any()], dtype=float)
        return Rules(passes, words, limits, traits, ends, *padded, numbers)

    # -- arrays --------------------------------------------------------------------------------------------------------
    def grid(self, mesh: Mesh) -> Grid:
        """The arrays of the mesh, and room for them in the scratch."""
        n = len(mesh.q)
        if n + 2 > self.work.w.shape[1]:
            more = tables.make_work(2 * n + 2, self.variables, len(self.laws), self.work.zones, self.work.owner)
            self.work = more._replace(trace=self.work.trace, passed=self.work.passed, numbers=self.work.numbers)
        return Grid(*(np.ascontiguousarray(row) for row in (mesh.x, mesh.q, mesh.region, mesh.marked, mesh.given, mesh.push,
                                                             mesh.level)))

    def look(self, mesh: Mesh) -> np.ndarray:
        """The table with the averages of the cells and their values at the faces (blocks MEAN, LOW, HIGH)."""
        grid, n = self.grid(mesh), len(mesh.q)
        averages(grid, self.rules, self.work, n, mesh.d)
        parabolas.reconstruct(grid, self.work.w, n, mesh.d, self.variables)
        return self.work.w

    def slopes(self, mesh: Mesh, cell: int) -> np.ndarray:
        """Slopes (per m) of density, velocity, energy and scalars in a cell: the halves of its parabolas differ by half a rise."""
        w, variables = self.look(mesh), self.variables
        rise = w[parabolas.HIGH:parabolas.HIGH + variables, cell] - w[parabolas.LOW:parabolas.LOW + variables, cell]
        return rise / (mesh.x[cell + 1] - mesh.x[cell])

    def drive(self, side: int, time: float) -> float:
        """What the left (0) or right (1) end is driven with, m/s or Pa."""
        return float(march.drive(self.rules.ends[side], self.rules.times[side], self.rules.values[side], time))

    def matter(self, region: int, burned: float, volume: float, energy: float) -> Matter:
        """The material of a region, of a mixture the one that is frozen at a burn fraction."""
        law = self.laws[region % len(self.laws)]
        if isinstance(law, Reactive):
            return Matter(Frozen(law.mixture, min(max(burned, 0.0), 1.0), volume, energy))
        if self.bench.cylinder and isinstance(law, Solid):
            return solids.of_hoop(law, solids.yielded.py_func(self.rules, region, volume, energy)[1])      # a parabola may lie beyond yield
        return self.bench.matters[region]

    # -- marching --------------------------------------------------------------------------------------------------------
    def march(self, mesh: Mesh, goal: float, cycles: int) -> int:
        """Steps until a time or number of cycles, or until something happens: why the march came back (march.DONE and so on)."""
        grid, numbers = self.grid(mesh), self.work.numbers
        rows = self.rows(mesh)
        while True:
            before = numbers[tables.CYCLE]
            why = march.march(grid, self.rules, self.work, rows, len(rows), goal, cycles)
            cycles -= int(numbers[tables.CYCLE] - before)
            if why != march.ASK_PYTHON:
                break
            why = self._by_python(mesh, grid, rows, goal)
            cycles -= 1
            if why != march.DONE or cycles <= 0:
                break
        mesh.x, mesh.q, mesh.given, mesh.push = grid.x, grid.q, grid.given, grid.push
        for front, row in zip(mesh.fronts, rows):
            front.speed, front.strength = float(row[tables.SPEED_OF]), float(row[tables.STRENGTH])
            front.fan = front.fan if row[tables.FAN] else None
        return why

    @staticmethod
    def rows(mesh: Mesh) -> np.ndarray:
        """The table of fronts."""
        return np.array([[f, tables.KINDS.index(front.kind), front.speed, front.direction, front.strength, front.least,
                          float(front.fan is not None)]
                         for f, front in zip(mesh.faces().tolist(), mesh.fronts)], dtype=float)

    def _by_python(self, mesh: Mesh, grid: Grid, rows: np.ndarray, goal: float) -> int:
        """The rest of a step whose fronts the compiled march left to Python."""
        numbers = self.work.numbers
        dt, longest = float(numbers[tables.PENDING]), goal - float(numbers[tables.TIME])
        tracked.at_fronts(self, grid, mesh, rows, float(numbers[tables.TIME]) + 0.5 * dt)
        march.close_step(grid, self.rules, self.work, rows, len(rows), dt, longest if numbers[tables.MEETS] else dt, goal)
        if march.calls_for_change(grid, self.rules, self.work, rows, len(rows)):
            return march.CHANGE
        return march.REFINE if numbers[tables.UNRESOLVED] > 0.0 else march.DONE

    def refuse_highest(self, mesh: Mesh) -> None:
        """Raise `UnphysicalState` if a cell has come to the highest density of its law, where pressure and sound speed have no bound.

        A converging shock in a condensed material always comes there, unless the cells at the axis or centre are coarse.
        """
        w, n = self.work.w, len(mesh.q)
        flows = (mesh.region >= 0) & (mesh.region < self.bench.unburned)
        highest = np.where(flows, self.rules.limits[mesh.region, 0], np.inf)
        k = int(np.argmax(w[MEAN, :n] / highest))
        if w[MEAN, k] < NEAR * highest[k]:
            return
        law = self.laws[mesh.region[k] % len(self.laws)]
        name = MIXTURE.of(law.mixture).name if isinstance(law, Reactive) else EOS.of(getattr(law, "eos", law)).name
        raise UnphysicalState(f"the density {w[MEAN, k]:.6g} kg/m3 (at {w[MEAN + P, k]:.3g} Pa) has reached the highest that law '{name}' "
                              f"allows, {highest[k]:.6g} kg/m3, where it ends or its pressure and sound speed grow without bound",
                              "end the run earlier; where a shock converges, put a rigid core of small radius at the axis or centre",
                              k, "", float(mesh.middle[k]), float(self.work.numbers[tables.TIME]), int(self.work.numbers[tables.CYCLE]))

    def refuse(self, mesh: Mesh) -> None:
        """Raise `UnphysicalState` for the cell that has no valid state."""
        self.refuse_highest(mesh)
        k, w = int(self.work.numbers[tables.LIMITING]), self.work.w
        rho, u, e = w[:3, k]
        if w[MEAN + P, k] < 0.0 and w[MEAN + C, k] == 0.0:
            law = self.laws[mesh.region[k] % len(self.laws)]
            name, numbers = EOS.of(getattr(law, "eos", law)).name, self.work.numbers
            raise UnphysicalState(SPRAY.partition(" (")[0].format(name, -w[MEAN + P, k]), "end the run earlier, or use lagrange1d", k, "",
                                  float(mesh.middle[k]), float(numbers[tables.TIME]), int(numbers[tables.CYCLE]))
        raise UnphysicalState(f"a cell of density {rho:.6g} kg/m3 and energy {e:.6g} J/kg has no valid state (velocity {u:.6g} m/s)",
                              "stay inside the range of the equation of state, use more zones or a smaller solver.options.courant",
                              k, "", float(mesh.middle[k]), float(self.work.numbers[tables.TIME]), int(self.work.numbers[tables.CYCLE]))

    def steep(self, mesh: Mesh) -> tuple[int, int]:
        """(cell, direction) of a shock among the cells; (-1, 0) if there is none."""
        cell = steepening.steep_cell(self.grid(mesh), self.rules, self.work, self.rows(mesh), len(mesh.fronts))
        return int(cell), int(self.work.numbers[tables.STEEP_WAY])

    def flagged(self, row: int, mesh: Mesh) -> list[int]:
        """Faces of the fronts that are to be released (row 0) or that part (row 1)."""
        return [f for k, f in enumerate(mesh.faces().tolist()) if self.work.flags[row, k] > 0.0]

    def clear(self) -> None:
        """What was flagged has been seen to."""
        self.work.flags[:] = 0.0
        self.work.numbers[tables.CROWDED] = 0.0


def state_of(w: np.ndarray, block: int, cell: int) -> State:
    """A state of the table with its pressure."""
    rho, u, e = w[block:block + 3, cell].tolist()
    return State(rho, u, e, float(w[block + tables.P, cell]))


