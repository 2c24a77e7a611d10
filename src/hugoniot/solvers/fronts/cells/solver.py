"""The cells mode of tracked fronts: owns mesh and fronts, marches them, hands out states and checkpoints.

Knows a problem's numbers and laws; never files, decks or plots.
"""

import math

import numpy as np

from hugoniot.errors import HugoniotError, UnphysicalState
from hugoniot.problem.model import Problem
from hugoniot.problem.profiles import velocities_at
from hugoniot.solvers.fronts import setup
from hugoniot.solvers.fronts.cells import checkpoint, march, start, tables
from hugoniot.solvers.fronts.cells.births import FAN_WEAKEST
from hugoniot.solvers.fronts.cells.changes import REST, Changes
from hugoniot.solvers.fronts.cells.column import CellColumn, Readable
from hugoniot.solvers.fronts.cells.flow import Flow
from hugoniot.solvers.fronts.cells.mesh import EMPTY
from hugoniot.solvers.fronts.cells.record import Trace
from hugoniot.solvers.fronts.cells.refining import Refining
from hugoniot.solvers.fronts.cells.solids import elastic_share
from hugoniot.solvers.fronts.cells.spacing import cells_of
from hugoniot.solvers.fronts.meeting import Bench
from hugoniot.solvers.fronts.reading import Reading
from hugoniot.solvers.fronts.record import COLUMNS
from hugoniot.solvers.protocol import NO_COUNTS, Event

STUCK = 200           # steps in a row without a future


class Cells(Reading):
    """A run in progress: a `protocol.LineSolver`. Raises `OutOfRange` for a problem it does not solve."""

    def __init__(self, problem: Problem):
        setup.refuse_what_is_not_solved(problem)
        super().__init__(problem)
        options = setup.options_of(problem)
        self.matters = [setup.matter_of(problem.materials[r.material]) for r in problem.regions]
        count = len(problem.regions)
        bench = Bench(2 * self.matters, 2 * setup.grips_of(problem), float(options["weakest"]), float(options["fan_step"]), unburned=count,
                      elastic=elastic_share(self.matters), narrow=True, cylinder=problem.geometry == "cylindrical",
                      zones=2 * cells_of(problem))
        outside = tuple(start.OUTSIDE[end.kind] for end in (problem.left, problem.right))
        self.flow = Flow(problem, bench, outside, options, problem.solver.courant or setup.COURANT, self.region_of, self.middles)
        self.burning = any(material.burn is not None for material in problem.materials.values())
        self.trace = self.lives = Trace()
        self.changes = Changes(self.flow, self.length, int(options["most_fronts"]), self._log, self.trace.end)
        self.refining = Refining(self.flow, self._log)
        self.mesh = start.first_mesh(problem, self.flow.spacing, self.flow.variables)
        self.start_totals, self.start_size = self.mesh.q.sum(axis=0), self._size()
        try:
            self.changes.begin(self.mesh, [point.position for point in problem.lighting if point.time <= 0.0])
        except (HugoniotError, ArithmeticError, ValueError) as error:
            raise setup.unsolved(error, "where the first waves start") from error
        self._sample_first()

    def _sample_first(self) -> None:
        """Gauges at t = 0: before any wave has left. A face between regions that move against each other has no one velocity then."""
        if self._struck():
            self.samples = 1
            return
        born, self.mesh = self.mesh, start.first_mesh(self.problem, self.flow.spacing, self.flow.variables)
        self._sample()
        self.mesh, self._read_at = born, (-1, 0)

    @property
    def time(self) -> float:
        return float(self.flow.work.numbers[tables.TIME])

    # -- marching ----------------------------------------------------------------------------------------------------
    @property
    def zone_updates(self) -> int:
        """Cells advanced, over all steps."""
        return int(self.flow.work.numbers[tables.UPDATES])

    def march(self, until: float, cycles: int) -> list[Event]:
        """At most `cycles` steps, up to the time `until` (hit exactly); what happened on the way."""
        self._events = []
        last = self.cycle + cycles
        while self.time < until and self.cycle < last:
            change, side = self._next_change()
            shot = min((point.time for point in self.problem.lighting if point.time > self.time), default=math.inf)
            goal = min(until, change, shot, self._next_sample())
            self._steps(goal, last - self.cycle)
            try:
                if self.time >= change:
                    self._drive(side)
                if self.time >= shot:
                    self._fire()
            except (HugoniotError, ArithmeticError, ValueError) as error:
                raise setup.unsolved(error, "where waves leave an end or a detonator", time=self.time, cycle=self.cycle) from error
            if self.time >= self._next_sample():
                self._sample()
        return self._events

    def _steps(self, goal: float, cycles: int) -> None:
        """Steps until something happens, and what that calls for."""
        numbers = self.flow.work.numbers
        try:
            with np.errstate(all="ignore"):
                why = self.flow.march(self.mesh, goal, cycles)
                self.cycle, self.step = int(numbers[tables.CYCLE]), float(numbers[tables.STEP])
                self.trace.drain(self.mesh, self.flow.work, len(self.problem.regions))
                if self.problem.dimension > 1 and self.mesh.x[0] < -1e-12 * self.length:
                    raise UnphysicalState("the inner surface has run into the axis or centre", "end the run earlier, or fill the hole "
                                          "with a body from radius 0", 0, self.problem.regions[0].name, float(self.mesh.x[0]),
                                          self.time, self.cycle)
                if why == march.UNSOUND and not self.changes.join(self.mesh):
                    self.flow.refuse(self.mesh)
                if why == march.CHANGE:
                    self.changes.after_step(self.mesh, self.time)
                if why == march.STEEP or (why == march.CHANGE and self.cycle % march.LOOK == 0):
                    self.changes.steepen(self.mesh, self.time)
                if why in (march.CHANGE, march.STEEP, march.REFINE) and numbers[tables.UNRESOLVED] > 0.0:
                    self.refining.after_step(self.mesh, self.time)
        except UnphysicalState:
            raise
        except (HugoniotError, ArithmeticError, ValueError) as error:
            self.flow.refuse_highest(self.mesh)
            raise setup.unsolved(error, "where fronts meet", time=self.time, cycle=self.cycle) from error
        if numbers[tables.STALLED] > STUCK:
            self.flow.refuse_highest(self.mesh)
            x = float(self.mesh.middle[min(int(numbers[tables.LIMITING]), len(self.mesh.q) - 1)])
            raise UnphysicalState(f"the step has fallen to {self.step:.3g} s", "raise solver.options.weakest, so that fewer waves are "
                                  "followed, or use fewer zones", None, self.limiting()[1], x, self.time, self.cycle)

    def _next_change(self) -> tuple[float, int]:
        """(time, side) of the next jump or kink of a driven end."""
        due = [(t, s) for s, end in enumerate((self.problem.left, self.problem.right)) for t in start.breaks(end) if t > self.time]
        return min(due, default=(math.inf, 0))

    def _drive(self, side: int) -> None:
        """Send out a wave where an end's drive has jumped."""
        before, after = self.flow.drive(side, self.time * (1.0 - 1e-12)), self.flow.drive(side, self.time)
        if abs(after - before) > 1e-6 * max(abs(after), abs(before)):
            self.changes.renew_end(self.mesh, side, self.time)

    def _fire(self) -> None:
        """The detonators that go off now, where the explosive has moved to."""
        for point in self.problem.lighting:
            if point.time == self.time:
                region = next(r for r in self.problem.regions if r.start <= point.position <= r.end)
                u = velocities_at(region, np.array([point.position]))[0]
                self.changes.light(self.mesh, point.position + float(u) * self.time, self.time)

    def _extremes_so_far(self) -> np.ndarray:
        return self.flow.work.zones[1:].copy()

    def limiting(self) -> tuple[int, str]:
        """(zone, region name) of the cell that limits the step."""
        region = int(self.mesh.region[min(int(self.flow.work.numbers[tables.LIMITING]), len(self.mesh.q) - 1)])
        region = max(region, 0) % len(self.problem.regions)
        return int(np.searchsorted(self.region_of, region)), self.problem.regions[region].name

    def _ends_of(self, region: int) -> tuple[int, int]:
        """First and last cell of a region."""
        mesh = self.mesh
        own = np.flatnonzero((mesh.region != EMPTY) & (mesh.region % len(self.problem.regions) == region))
        return int(own[0]), int(own[-1])

    def _velocity(self, region: int, fraction: float, point) -> float:
        """Velocity at a gauge, m/s: at the edge of a gas in vacuum that of the edge, as its last cell is wide and nearly empty."""
        if fraction not in (0.0, 1.0) or not self.flow.rules.traits[region, tables.GAS]:
            return point.u
        mesh, side = self.mesh, int(fraction)
        face = self._ends_of(region)[side] + side
        front = mesh.fronts[int(np.count_nonzero(mesh.marked[:face]))]
        return front.speed if front.kind == "surface" and mesh.region[face - side] < self.flow.bench.unburned else point.u

    def _stress(self, region: int, fraction: float, point) -> float:
        """Stress at a gauge, Pa: on a surface the pressure applied to it, which the parabola of its cell meets only in the mean."""
        if fraction not in (0.0, 1.0):
            return point.sigma
        mesh, side = self.mesh, int(fraction)
        beyond = self._ends_of(region)[side] + (1 if side else -1)
        if not 0 <= beyond < len(mesh.region):
            kind = (self.problem.left, self.problem.right)[side].kind
            return {"free": 0.0, "pressure": self.flow.drive(side, self.time)}.get(kind, point.sigma)
        return 0.0 if mesh.region[beyond] == EMPTY else point.sigma

    def _point(self, region: int, column: CellColumn, fraction: float):
        return column.point(fraction)

    def column(self, region: int) -> CellColumn:
        """The material of a region now."""
        if self._read_at != (self.cycle, id(self.mesh)):
            self._read_at, self._read = (self.cycle, id(self.mesh)), Readable(self.mesh, self.flow)
            solid = np.flatnonzero(self._read.full & (self.mesh.region >= 0) & (self.mesh.region < self.flow.bench.unburned))
            self.trace.pulled(self.mesh.region[solid], self._read.pressure[solid])
        return CellColumn(self._read, region)

    _read_at: tuple = (-1, 0)

    # -- accounts ----------------------------------------------------------------------------------------------------
    def _size(self) -> np.ndarray:
        """Scale of each total: mass, momentum, energies without regard to sign."""
        mass, momentum, energy = self.mesh.q[self.mesh.region != EMPTY, :3].T
        return np.array([mass.sum(), np.abs(momentum).sum(), np.abs(energy).sum()])

    def errors(self) -> dict[str, float]:
        """Relative mass, momentum (planar) and energy errors against the impulse and work of the ends."""
        given = self.flow.work.passed.sum(axis=0)[:3]
        missing = np.abs(self.mesh.q.sum(axis=0)[:3] - self.start_totals[:3] - given)
        size = np.maximum(np.maximum(self._size(), self.start_size), np.abs(given))
        found = {f"{name}_error": float(m / max(s, 1e-300)) for name, m, s in zip(("mass", "momentum", "energy"), missing, size)}
        return found if self.problem.dimension == 1 else {**found, "momentum_error": math.nan}

    def exchanges(self) -> dict[str, float]:
        """Work and impulse of the two ends so far."""
        (_, il, wl), (_, ir, wr) = self.flow.work.passed[:, :3].tolist()
        return {"work_left": wl, "work_right": wr, "impulse_left": il, "impulse_right": ir}

    def counts(self) -> dict[str, int]:
        """Gaps that opened between bodies, and surfaces that met."""
        return {**NO_COUNTS, "voids_opened": self.voids_opened, "voids_closed": self.voids_closed}

    def results(self) -> dict[str, float]:
        """What a summary adds."""
        changes = self.changes
        return {"meetings": float(changes.meetings), "fronts_released": float(changes.untracked), "waves_captured": float(
            self.flow.bench.dropped), "shocks_formed": float(changes.formed), "fronts": float(len(self.mesh.fronts)),
            "cells": float(len(self.mesh.q)), **self.refining.results()}

    def front_table(self) -> tuple[tuple[str, ...], list[str], np.ndarray]:
        """(columns, kinds, rows) of the lines of every front there was."""
        return (COLUMNS, *self.trace.table(self.mesh, self.time))

    def warnings(self) -> list[str]:
        """Sentences about waves that were left to the cells, and cells that were merged."""
        joined = [f"cells at the edge of an expansion into vacuum were merged with their neighbours {_times(self.changes.joined)} because "
                  "their internal energy was negative: the edge is resolved to a few cells only"] if self.changes.joined else []
        crushing = self.flow.bench.crushing
        pores = [f"waves that close pores were left to the cells {_times(crushing)}: cells alone crush with too little heat, and pressure, "
                 "energy and density behind such a wave may be far off; track it with a smaller solver.options.weakest, or use "
                 'solver.options.mode = "algebraic" or lagrange1d'] if crushing else []
        found = [*joined, *pores, *self._too_weak(), *self.refining.warnings()]
        if not self.changes.captured:
            return found
        return [*found, f"waves were left to be captured by the cells {_times(self.changes.captured)}; a shock is then smeared over two "
                f"or three cells: the waves were too close, or {self.changes.most} fronts were followed already "
                "(solver.options.most_fronts)"]

    def _too_weak(self) -> list[str]:
        """Bodies in which the strongest waves, or nearly, were too weak to be followed."""
        bench = self.flow.bench
        found = {k: left for k, (followed, left) in sorted(bench.strongest.items()) if left > max(0.5 * followed, REST)}
        if not found:
            return []
        names = " and ".join(f"'{self.problem.regions[k].name}' (strength {left:.1e})" for k, left in found.items())
        return [f"waves in {names} were weaker than solver.options.weakest (releases: three times that) and left to the cells, which "
                "capture them over a few zones: stress and velocity behind them may overshoot, at interfaces by as much as 40 %; "
                f"make solver.options.weakest smaller than {min(found.values()) / FAN_WEAKEST:.1e}"]

    # -- checkpoints -------------------------------------------------------------------------------------------------
    def payload(self) -> dict:
        """Everything a bitwise restart needs."""
        return checkpoint.payload(self)

    def restore(self, payload: dict) -> None:
        """Continue from a payload of the same problem."""
        checkpoint.restore(self, payload)


def _times(n: int) -> str:
    return "once" if n == 1 else f"{n} times"
