"""A run that keeps in memory what the numbers of a run are read from, and writes nothing: a case of a sweep.

It gives `output.run_numbers` what a run folder gives it, so a case has the very numbers that `hugoniot run` prints for its deck.
"""

import json
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from hugoniot.diagnostics.apparent import with_apparent_velocity
from hugoniot.diagnostics.interface_gauges import without_mixtures
from hugoniot.output.plane_record import plane_record
from hugoniot.output.setup_record import setup_record
from hugoniot.output.spall_records import region_named
from hugoniot.simulate import final_warnings, make_solver, steady_numbers
from hugoniot.solvers.run import Outcome, Schedule, march_to_end, snapshot_times

WORTH_A_BURST = 1_000_000      # updates of zones: some hundredths of a second
_KEPT = ("velocity", "position_left", "position_right")     # of a snapshot: what the readings of a run look at


class _Columns(Mapping):
    """Columns that are put together when somebody asks for them: most of those of a case nobody does."""

    def __init__(self, names: Sequence[str], make: Callable[[str], np.ndarray]):
        self.names, self.make, self.made = names, make, {}

    def __getitem__(self, name: str) -> np.ndarray:
        if name not in self.names:
            raise KeyError(name)
        if name not in self.made:
            self.made[name] = self.make(name)
        return self.made[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self.names)

    def __len__(self) -> int:
        return len(self.names)


class MemoryRun:
    """A finished run of a problem, of which only the gauges, the events and what readings ask of the snapshots were kept.

    `setup` as of a run folder; `summary` has cycles, time, errors and counts; `warnings` those of a run, without those that were given
    before it (`warned`). Raises what a run raises.
    """

    def __init__(self, problem, warned: Sequence[str] = ()):
        self.problem = replace(problem, solver=replace(problem.solver, threads=1)) if problem.solver.threads > 1 else problem
        flat = problem.solver.kind == "lagrange2d"
        self._names = [block.name for block in problem.blocks] if flat else [region.name for region in problem.regions]
        solver, outcome, snapshots = self._marched(passing=True)
        if any(event["kind"] == "void_opened" and not region_named(event["text"], self._names) for event in self._events):
            solver, outcome, snapshots = self._marched(passing=False)     # which region broke is then read from the places in snapshots
        meta = {"solver": problem.solver.kind, "viscosity": solver.viscosity, "transport": solver.transport}
        self.setup = plane_record(problem, meta) if flat else setup_record(problem, meta)
        self.summary: dict[str, Any] = {"status": outcome.status, "cycles": solver.cycle, "time": solver.time, **solver.errors(),
                                        **solver.counts(), **solver.results(), **steady_numbers(self.problem)}
        self.warnings = [event["text"] for event in self._events if event["kind"] == "warning"]
        self.warnings += final_warnings(self.problem, solver, warned)
        self._tables: dict[str, Mapping] = {"events": {name: [event[name] for event in self._events] for name in
                                                       ("kind", "text", "time", "numbers")}, "snapshots": snapshots}

    def _marched(self, passing: bool) -> tuple[Any, Outcome, Mapping]:
        """(solver at the end, outcome, columns of the snapshots): their extremes alone where the solver can pass through their times."""
        self._gauges: list[tuple[np.ndarray, dict]] = []
        self._shots: list[dict] = []
        self._events: list[dict] = []
        problem, solver = self.problem, make_solver(self.problem)
        times = snapshot_times(problem.stop_time, problem.output.snapshots)
        passing = passing and solver.pass_through(times)
        self.motion = None if passing else self._keep_motion
        looks = [times[0], times[-1]] if passing else times
        burst = max(WORTH_A_BURST // len(solver.region_of), 1)
        outcome = march_to_end(solver, Schedule(problem.stop_time, looks, max_cycles=problem.solver.max_cycles, first_burst=burst), (self,))
        return solver, outcome, self._extremes(solver) if passing else self._snapshots([self._names[k] for k in solver.region_of])

    # -- what the time loop hands over -------------------------------------------------------------------------------
    def gauges(self, times, values) -> None:
        """Keep gauge records."""
        if len(times) and self.problem.gauges:
            values = {name: value for name, value in values.items() if name not in ("share", "phases")}
            flat = self.problem.solver.kind == "lagrange2d"
            kept = values if flat else with_apparent_velocity(self.problem, without_mixtures(values, self.problem))
            self._gauges.append((times, kept))

    def _keep_motion(self, state) -> None:
        self._shots.append({"time": state.time, **{name: value for name, value in state.fields().items() if name.startswith(_KEPT)}})

    def event(self, event) -> None:
        """Keep what happened."""
        self._events.append({"kind": event.kind, "text": event.text, "time": event.time,
                             "numbers": json.dumps({"position": event.position}, sort_keys=True)})

    # -- what the readings ask for -----------------------------------------------------------------------------------
    def _extremes(self, solver) -> Mapping:
        found = solver.seen_in_passing()
        fields = self.problem.output.fields
        if fields and "stress" not in fields:       # of which a run's snapshots have none
            found.pop("stress")
        return {**found, "velocity_right": found["velocity_right"][:, None]}

    def _snapshots(self, regions: list[str]) -> Mapping:
        names = [*(self._shots[0] if self._shots else ()), "region"]
        return _Columns(names, lambda name: np.array(regions, dtype=object) if name == "region" else
                        np.array([shot[name] for shot in self._shots]))

    def arrays(self, group: str) -> Mapping:
        """Columns of `gauges`, `snapshots` or `events`, SI."""
        if group == "gauges" and group not in self._tables:
            times, blocks = zip(*self._gauges) if self._gauges else ((np.empty(0),), ({},))
            self._tables[group] = _Columns(["time", *blocks[0]], lambda name: np.concatenate(
                times if name == "time" else [block[name] for block in blocks]))
        return self._tables[group]

    def gauge_names(self) -> list[str]:
        """Names of the gauges, in the order of the deck."""
        return [gauge.name for gauge in self.problem.gauges]

    def gauge(self, field: str, name: str) -> tuple[np.ndarray, np.ndarray]:
        """(time (n,) s, value (n,) SI) of one field at one gauge."""
        rows = self.arrays("gauges")
        return rows["time"], rows[field][:, self.gauge_names().index(name)]
