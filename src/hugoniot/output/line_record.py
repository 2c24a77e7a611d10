"""What the run folder keeps of a run in one dimension: the record of its set-up, and the recorder that hands it states."""

from typing import Any

from hugoniot.diagnostics.apparent import with_apparent_velocity
from hugoniot.diagnostics.budgets import RegionBudget
from hugoniot.diagnostics.interface_gauges import without_mixtures
from hugoniot.diagnostics.line_fields import LineFields
from hugoniot.diagnostics.temperature import gauge_temperature, laws_with_temperature, zone_temperature
from hugoniot.output.recorder import Recorder
from hugoniot.problem.explosives import burns
from hugoniot.problem.model import Problem
from hugoniot.solvers.protocol import LineSolver

FACES = {"position_left", "position_right", "velocity_left", "velocity_right"}     # of the zones: kept whatever a deck asks for


def line_meta(problem: Problem, solver: LineSolver, version: str) -> dict[str, Any]:
    """What `RunFolder.start` is given of a run in one dimension."""
    left, right = solver.initial_nodes
    return {
        "solver": problem.solver.kind, "version": version, "viscosity": solver.viscosity, "transport": solver.transport,
        "region": [problem.regions[k].name for k in solver.region_of], "mass": solver.state().zones["mass"],
        "centre": 0.5 * (left + right), "left": left, "right": right, "gauges": [gauge.name for gauge in problem.gauges],
    }


class LineRecorder(Recorder):
    """Keeps the states of a run in one dimension."""

    def __init__(self, folder, problem: Problem, solver: LineSolver, show=None, warned=()):
        super().__init__(folder, problem, solver, show, warned)
        self.fields = set(problem.output.fields)
        self.budget = RegionBudget(problem, solver.region_of, solver.state())
        self.derived = LineFields(self.fields, problem, solver.region_of, solver.state())
        self.laws = laws_with_temperature(problem) if problem.solver.kind in ("lagrange1d", "fronts") else []
        if problem.solver.kind == "fronts":      # whose burning regions have no phases to take a temperature from
            self.laws = [None if burns(problem, region) else law for region, law in zip(problem.regions, self.laws)]
        self.hot = any(law is not None for law in self.laws)

    def gauges(self, times, values):
        if len(times) and self.problem.gauges:
            share, phases = values.pop("share", None), values.pop("phases", None)
            if self.hot:
                laws = [self.laws[self.solver.region_of[zone]] for zone in self.solver.gauge_zones]
                values = {**values, "temperature": gauge_temperature({**values, "share": share, "phases": phases}, laws)}
            self.folder.gauges(times, with_apparent_velocity(self.problem, without_mixtures(values, self.problem)))

    def snapshot(self, state):
        heat = zone_temperature(state, self.solver.region_of, self.laws, self.solver.phases()) if self.hot else None
        fields = {**state.fields(), **self.derived(state, heat)}
        if heat is not None:
            fields["temperature"] = heat
        if self.fields:
            fields = {name: value for name, value in fields.items() if name in self.fields | FACES}
        fields.pop("mass", None)     # it stands in the result once
        self.keep(state, fields, self.budget(state, heat))
