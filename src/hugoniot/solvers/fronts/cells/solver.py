"""The cells mode of tracked fronts: owns mesh and fronts, marches them, hands out states and checkpoints.

Knows a problem's numbers and laws; never files, decks or plots.
"""

import math

import numpy as np

from hugoniot.errors import HugoniotError, UnphysicalState
from hugoniot.problem.model import Problem
from hugoniot.solvers.fronts import setup
from hugoniot.solvers.fronts.cells import checkpoint, start
from hugoniot.solvers.fronts.cells.changes import Changes
from hugoniot.solvers.fronts.cells.column import CellColumn, Readable
from hugoniot.solvers.fronts.cells.flow import Media
from hugoniot.solvers.fronts.cells.mesh import EMPTY, Spacing
from hugoniot.solvers.fronts.cells.record import Trace
from hugoniot.solvers.fronts.cells.step import Flow, advance
from hugoniot.solvers.fronts.meeting import Bench
from hugoniot.solvers.fronts.reading import Reading
from hugoniot.solvers.fronts.record import COLUMNS
from hugoniot.solvers.protocol import NO_COUNTS, Event

LOOK = 5              # steps between looks for shocks that have formed
LINES = 400           # into which the paths of fronts are cut over a run
SLOWEST = 1e-12       # of the stop time: a step shorter than this has no future
STUCK = 200           # such steps in a row


class Cells(Reading):
    """A run in progress: a `protocol.LineSolver`. Raises `OutOfRange` for a problem it does not solve."""

    def __init__(self, problem: Problem):
        setup.refuse_what_is_not_solved(problem)
        super().__init__(problem)
        options = setup.options_of(problem)
        self.matters = [setup.matter_of(problem.materials[r.material]) for r in problem.regions]
        count = len(problem.regions)
        bench = Bench(2 * self.matters, 2 * setup.grips_of(problem), float(options["weakest"]), float(options["fan_step"]), unburned=count)
        ends = problem.left, problem.right
        self.outside = tuple(start.OUTSIDE[end.kind] for end in ends)
        self.histories = [start.history(end) for end in ends]
        spacing = Spacing(problem.dimension, np.array([float(r.zones) for r in problem.regions]))
        media = Media([matter.par for matter in self.matters] + [None] * count)
        self.flow = Flow(media, bench, spacing, tuple(zip(self.outside, self.histories)), problem.solver.courant or setup.COURANT,
                         np.zeros((2, 3)))
        self.trace = self.lives = Trace()
        self.changes = Changes(self.flow, self.length, self.outside, int(options["most_fronts"]), self._log, self.trace.end)
        self.mesh = start.first_mesh(problem, spacing)
        self.start_totals, self.start_size = self.mesh.q.sum(axis=0), self._size()
        self.time, self.updates, self.lines, self.slow = 0.0, 0, 0, 0
        self.changes.begin(self.mesh, [point.position for point in problem.lighting if point.time <= 0.0])
        self._sample_first()

    def _sample_first(self) -> None:
        """Gauges at t = 0: before any wave has left."""
        born, self.mesh = self.mesh, start.first_mesh(self.problem, self.flow.spacing)
        self._sample()
        self.mesh = born

    # -- marching ----------------------------------------------------------------------------------------------------
    @property
    def zone_updates(self) -> int:
        """Cells advanced, over all steps."""
        return self.updates

    def march(self, until: float, cycles: int) -> list[Event]:
        """At most `cycles` steps, up to the time `until` (hit exactly); what happened on the way."""
        self._events = []
        done = 0
        while self.time < until and done < cycles:
            change, side = self._next_change()
            shot = min((point.time for point in self.problem.lighting if point.time > self.time), default=math.inf)
            goal = min(until, change, shot, self._next_sample() if self.problem.output.gauge_interval else math.inf)
            self._step(goal)
            done += 1
            if self.time >= change:
                self._drive(side)
            if self.time >= shot:
                self._fire()
            if self.time >= self._next_sample():
                self._sample()
            if self.time * LINES >= (self.lines + 1) * self.problem.stop_time and np.isnan(self.mesh.push).all():
                self.lines += 1
                self.trace.sample(self.mesh, self.flow.media, self.outside, self.time)
        return self._events

    def _step(self, goal: float) -> None:
        self.updates += len(self.mesh.q)
        try:
            with np.errstate(all="ignore"):
                dt = advance(self.mesh, self.flow, self.time, goal - self.time, self.cycle)
                self.step = dt
                self.time = goal if goal - self.time - dt <= 1e-15 * goal else self.time + dt
                self.cycle += 1
                self.changes.after_step(self.mesh, self.time)
                if self.cycle % LOOK == 0 and np.isnan(self.mesh.push).all():
                    self.changes.steepen(self.mesh, self.time)
        except UnphysicalState:
            raise
        except (HugoniotError, ArithmeticError, ValueError) as error:
            raise UnphysicalState(f"where fronts meet, {error}.", "stay inside the range of the equations of state, or choose ones that "
                                  "reach further", None, "", None, self.time, self.cycle) from error
        self.slow = self.slow + 1 if dt < SLOWEST * self.problem.stop_time else 0
        if self.slow > STUCK:
            x = float(self.mesh.middle[self.flow.limiting])
            raise UnphysicalState(f"the step has fallen to {dt:.3g} s", "raise solver.options.weakest, so that fewer waves are followed, "
                                  "or take fewer zones", None, self.limiting()[1], x, self.time, self.cycle)

    def _next_change(self) -> tuple[float, int]:
        """(time, side) of the next jump or kink of a driven end."""
        due = [(t, s) for s, end in enumerate((self.problem.left, self.problem.right)) for t in start.breaks(end) if t > self.time]
        return min(due, default=(math.inf, 0))

    def _drive(self, side: int) -> None:
        """Send out a wave where an end's drive has jumped."""
        history = self.histories[side]
        if history is None:
            return
        before, after = history(self.time * (1.0 - 1e-12)), history(self.time)
        if abs(after - before) > 1e-6 * max(abs(after), abs(before)):
            self.changes.renew_end(self.mesh, side, self.time)

    def _fire(self) -> None:
        """The detonators that go off now, where the explosive has moved to."""
        for point in self.problem.lighting:
            if point.time == self.time:
                region = next(r for r in self.problem.regions if r.start <= point.position <= r.end)
                u = region.velocity[0] if isinstance(region.velocity, tuple) else region.velocity
                self.changes.light(self.mesh, point.position + u * self.time, self.time)

    def limiting(self) -> tuple[int, str]:
        """(zone, region name) of the cell that limits the step."""
        region = int(self.mesh.region[min(self.flow.limiting, len(self.mesh.q) - 1)])
        region = max(region, 0) % len(self.problem.regions)
        return int(np.searchsorted(self.region_of, region)), self.problem.regions[region].name

    def column(self, region: int) -> CellColumn:
        """The material of a region now."""
        if self._read_at != (self.cycle, id(self.mesh)):
            self._read_at, self._read = (self.cycle, id(self.mesh)), Readable(self.mesh, self.flow.media)
        return CellColumn(self._read, region)

    _read_at: tuple = (-1, 0)

    # -- accounts ----------------------------------------------------------------------------------------------------
    def _size(self) -> np.ndarray:
        """Scale of each total: mass, momentum, energies without regard to sign."""
        mass, momentum, energy = self.mesh.q[self.mesh.region != EMPTY, :3].T
        return np.array([mass.sum(), np.abs(momentum).sum(), np.abs(energy).sum()])

    def errors(self) -> dict[str, float]:
        """Relative mass, momentum (planar) and energy errors against the impulse and work of the ends."""
        given = self.flow.passed.sum(axis=0)[:3]
        missing = np.abs(self.mesh.q.sum(axis=0)[:3] - self.start_totals[:3] - given)
        size = np.maximum(np.maximum(self._size(), self.start_size), np.abs(given))
        found = {f"{name}_error": float(m / max(s, 1e-300)) for name, m, s in zip(("mass", "momentum", "energy"), missing, size)}
        return found if self.problem.dimension == 1 else {**found, "momentum_error": math.nan}

    def exchanges(self) -> dict[str, float]:
        """Work and impulse of the two ends so far."""
        (_, il, wl), (_, ir, wr) = self.flow.passed[:, :3].tolist()
        return {"work_left": wl, "work_right": wr, "impulse_left": il, "impulse_right": ir}

    def counts(self) -> dict[str, int]:
        """Gaps that opened between bodies, and surfaces that met."""
        return {**NO_COUNTS, "voids_opened": self.voids_opened, "voids_closed": self.voids_closed}

    def results(self) -> dict[str, float]:
        """What a summary adds."""
        changes = self.changes
        return {"meetings": float(changes.meetings), "fronts_released": float(changes.untracked), "waves_captured": float(
            self.flow.bench.dropped), "shocks_formed": float(changes.formed), "fronts": float(len(self.mesh.fronts)),
            "cells": float(len(self.mesh.q))}

    def front_table(self) -> tuple[tuple[str, ...], list[str], np.ndarray]:
        """(columns, kinds, rows) of the lines of every front there was."""
        return (COLUMNS, *self.trace.table(self.mesh, self.time))

    def warnings(self) -> list[str]:
        """Sentences about waves that were left to the cells."""
        if not self.changes.captured:
            return []
        return [f"{self.changes.captured} times waves were left to the cells, where a shock is smeared over two or three of them: they "
                f"were too close to each other, or {self.changes.most} fronts were followed already (solver.options.most_fronts)"]

    # -- checkpoints -------------------------------------------------------------------------------------------------
    def payload(self) -> dict:
        """Everything a bitwise restart needs."""
        return checkpoint.payload(self)

    def restore(self, payload: dict) -> None:
        """Continue from a payload of the same problem."""
        checkpoint.restore(self, payload)
