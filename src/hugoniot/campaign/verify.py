"""Runs the standard problems and holds them against their exact answers and the bars of the verification table.

Every problem runs with the same default settings; only the number of zones changes. The observed order is the slope of
log(error) against log(zones) over the grids that were run.
"""

import dataclasses
import time
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from hugoniot.campaign.guderley import GUDERLEY, arrival_error, exponent_error, shock_radius, steepest
from hugoniot.campaign.plane import PLANE, PlaneProblem, run_plane
from hugoniot.campaign.tracked import FRONTS, shocks, with_fronts
from hugoniot.campaign.tracked_problems import TRACKED, TrackedProblem, run_tracked
from hugoniot.errors import DeckError
from hugoniot.problem.standard import STANDARD, Bar, Measure, StandardProblem
from hugoniot.simulate import make_solver
from hugoniot.solvers.run import Schedule, march_to_end, snapshot_times
from hugoniot.theory.exact import SOLUTIONS

SNAPSHOTS = 50
NO_ORDER = ("asymmetry", "densest_zone", "peak_scatter", "time_reached", "filter_work", "velocity_across", "front_rms", "contacts",
            "front_position", "speed_6mm", "speed_19mm", "contact_depth", "stress_drift", "angle_error")
LINE = {**STANDARD, GUDERLEY.name: GUDERLEY}
PROBLEMS: dict[str, StandardProblem | PlaneProblem | TrackedProblem] = {**LINE, **PLANE, **TRACKED}
@dataclass(frozen=True)
class Judged:
    """One measure of one run: the value, the bars it is held to, and which of them it beats."""

    problem: str
    measure: str
    zones: int
    value: float
    ko: float | None = None
    g2: float | None = None
    goal: float | None = None
    sense: str = "below"
    peer: float | None = None

    def beats(self, bar: float | None) -> bool | None:
        """Whether the value is at least as good as a bar; None where there is no bar."""
        if bar is None:
            return None
        return self.value <= bar if self.sense == "below" else self.value >= bar


@dataclass
class Verified:
    """A problem over its grids: judged values, observed orders {measure: slope}, seconds, worst conservation errors."""

    problem: StandardProblem | PlaneProblem | TrackedProblem
    judged: list[Judged]
    orders: dict[str, float]
    seconds: float
    energy_error: float
    momentum_error: float


class _Watcher:
    """Keeps what a measure needs of the course of a run: least fields and the least radius of the inner boundary."""

    def __init__(self):
        self.least: dict[str, float] = {}
        self.innermost = np.inf
        self.shock_history: list[tuple[float, float]] = []

    def snapshot(self, state):
        for name, values in state.zones.items():
            self.least[name] = min(self.least.get(name, np.inf), float(values.min()))
        self.shock_history.append((state.time, shock_radius(state)))
        self.innermost = min(self.innermost, float(state.position_left[0]))


def run_problem(problem: StandardProblem, zones: int, integrator: str = "compatible", **solver_options):
    """(solver at the stop time, watcher) of a standard problem on a grid; the integrator "fronts" stands for tracked fronts in cells."""
    asked = problem.build(zones)
    if integrator == FRONTS:
        asked = with_fronts(asked)
    else:
        asked = dataclasses.replace(asked, solver=dataclasses.replace(asked.solver, integrator=integrator, **solver_options))
    solver, watcher = make_solver(asked), _Watcher()
    march_to_end(solver, Schedule(asked.stop_time, snapshot_times(asked.stop_time, None, SNAPSHOTS)), (watcher,))
    return solver, watcher


class _View:
    """A final state with the exact solution beside it, and what is known of tracked shocks (`shocks`)."""

    def __init__(self, solver, watcher, exact):
        self.state, self.watcher, self.exact, self.time = solver.state(), watcher, exact, solver.time
        self.shocks = shocks(solver)
        self.left, self.right = self.state.position_left, self.state.position_right
        self.centre, self.width = self.state.position_middle, self.right - self.left

    def field(self, name: str) -> np.ndarray:
        if name == "velocity":
            return 0.5 * (self.state.velocity_left + self.state.velocity_right)
        return self.centre if name == "position" else self.state.zones[name]

    def exact_at_centres(self, name: str) -> np.ndarray:
        """The exact field where that of a zone is given: at its centre, as the bars of the verification table were taken."""
        return self.exact(self.centre, self.time)[name]

    def inside(self, window) -> np.ndarray:
        if window is None:
            return np.ones(self.centre.shape, dtype=bool)
        return (self.centre > window[0]) & (self.centre < window[1])

    def shock_now(self, window) -> float | None:
        """Where the outermost tracked shock in the window is."""
        low, high = window or (-np.inf, np.inf)
        time, place, _ = self.shocks.T
        return max(place[(time == self.time) & (place > low) & (place < high)], default=None)

    def jump_position(self, name: str, window) -> float:
        """Where the outermost jump in the window is: a tracked shock, or where a field crosses half the height of the jump."""
        if (tracked := self.shock_now(window)) is not None:
            return float(tracked)
        inside = self.inside(window)
        f, x = self.field(name)[inside], self.centre[inside]
        level = 0.5 * (f.max() + f[-1])
        k = int(np.flatnonzero(f > level)[-1])
        if k + 1 >= len(x):
            return float(x[-1])
        return float(x[k] + (x[k + 1] - x[k]) * (f[k] - level) / (f[k] - f[k + 1]))


def judge(measure: Measure, view: _View) -> float:
    """The value of a measure, as `problem.standard.parts.Measure` defines it."""
    inside, f = view.inside(measure.window), np.empty(0)
    if measure.kind not in ("boundary", "smallest", "points"):
        f = view.field(measure.field)
    target = measure.exact
    if isinstance(target, str):
        target = view.exact.numbers[target]
    match measure.kind:
        case "l1":
            gap = np.abs(f - view.exact_at_centres(measure.field))
            sound = inside & np.isfinite(gap)     # a face may stand a round-off outside the exact body
            return float(np.sum((gap * view.width)[sound]) / np.sum(view.width[sound]) / measure.scale)
        case "mean":
            return float(abs(np.sum((f * view.width)[inside]) / np.sum(view.width[inside]) / target - 1.0))
        case "value" if measure.window is not None:
            start, end = measure.window
            return float(abs(np.interp(0.5 * (start + end), view.centre, f) / target - 1.0))
        case "first":
            return float(f[0] / target)
        case "maximum":
            return float(f.max())
        case "minimum":
            return view.watcher.least[measure.field]
        case "front":
            place = target if target is not None else view.exact.jumps(view.time)[measure.at if measure.at else -1]
            return abs(view.jump_position(_front_field(measure, view), measure.window) - place) / measure.scale
        case "boundary":
            place = view.left[0] if measure.at == 0 else view.right[-1]
            return float(abs(place / target - 1.0))
        case "smallest":
            return float(abs(view.watcher.innermost / target - 1.0))
        case "exponent":
            time, place, direction = view.shocks.T
            tracked = list(zip(time[direction < 0.0], place[direction < 0.0]))
            return exponent_error(tracked or view.watcher.shock_history, view.exact)
        case "arrival":
            return arrival_error(view.shock_now((0.02, 1.2)) or steepest(view.state), view.exact)
        case "points":
            points, values = reference_points()
            return float(np.max(np.abs(np.interp(points, view.centre, view.field(measure.field)) / values - 1.0)))
    raise ValueError(f"unknown kind of measure '{measure.kind}'")


def _front_field(measure: Measure, view: _View) -> str:
    """A shock into gas at rest is seen best in the velocity."""
    return "velocity" if measure.field == "density" else measure.field


def reference_points():
    """(positions, densities) of the Woodward-Colella reference run."""
    from hugoniot.theory.exact.woodward_colella import REFERENCE
    return np.array(REFERENCE.positions), np.array(REFERENCE.density)


def _self_l1(measure: Measure, solver, fine) -> float:
    """L1 distance of mean densities (planar) from a run on a finer grid, compared at equal positions."""
    a, b = _View(solver, None, None), _View(fine, None, None)
    mass = np.concatenate(([0.0], np.cumsum(b.field("mass"))))
    edges = np.concatenate((b.left, b.right[-1:]))
    there = np.diff(np.interp(np.concatenate((a.left, a.right[-1:])), edges, mass))
    return float(np.sum(np.abs(a.field("mass") - there)) / np.sum(a.width) / measure.scale)


def verify_problem(name: str, zones: Iterable[int] | None = None, integrator: str = "compatible", **solver_options) -> Verified:
    """Run a standard problem on its grids (or those given) and judge it. Raises DeckError for an unknown name."""
    if name not in PROBLEMS:
        raise DeckError.single("verify", None, "problem", f"unknown problem '{name}'", f"known: {', '.join(PROBLEMS)}")
    problem = PROBLEMS[name]
    if isinstance(problem, PlaneProblem | TrackedProblem):
        return _verify_own(problem, tuple(zones or problem.zones), integrator, solver_options)
    exact = SOLUTIONS[problem.solution](**problem.arguments) if problem.solution else None
    begun, judged, energy, momentum = time.perf_counter(), [], 0.0, 0.0
    grids = tuple(zones or problem.zones)
    fine = {m.exact: run_problem(problem, int(m.exact), integrator, **solver_options)[0] for m in problem.measure if m.kind == "self_l1"}
    for count in grids:
        solver, watcher = run_problem(problem, count, integrator, **solver_options)
        view = _View(solver, watcher, exact)
        errors = solver.errors()
        energy, momentum = max(energy, errors["energy_error"]), float(np.maximum(momentum, errors["momentum_error"]))
        for measure in problem.measure:
            value = _self_l1(measure, solver, fine[measure.exact]) if measure.kind == "self_l1" else judge(measure, view)
            judged.append(_held_to(problem, measure.key, count, value))
    orders = {m.key: slope for m in problem.measure if (slope := observed_order(judged, m.key)) is not None}
    return Verified(problem, judged, orders, time.perf_counter() - begun, energy, momentum)


def _held_to(problem: StandardProblem | PlaneProblem | TrackedProblem, key: str, count: int, value: float) -> Judged:
    """A value beside the bars of its measure on its grid."""
    bar = next((b for b in problem.bars if b.measure == key and b.zones == count), Bar(key, count))
    sense = next((b.sense for b in problem.bars if b.measure == key), "below")
    return Judged(problem.name, key, count, value, bar.ko, bar.g2, bar.goal, sense, bar.peer)


def _verify_own(problem: PlaneProblem | TrackedProblem, grids: tuple[int, ...], integrator: str, options: dict) -> Verified:
    """The same for a problem that measures itself. Of the momentum that of axisymmetric flow is not closed, and not judged."""
    tracks = isinstance(problem, TrackedProblem)
    if integrator not in ("compatible", FRONTS if tracks else "compatible"):
        raise DeckError.single("verify", None, "--integrator", f"'{problem.name}' has no integrator '{integrator}'", "use compatible")
    begun, judged, energy, momentum = time.perf_counter(), [], 0.0, float("nan")
    for count in grids:
        solver = run_tracked(problem, count) if tracks else run_plane(problem, count, **options)
        errors = solver.errors()
        energy = max(energy, errors["energy_error"])
        if solver.problem.geometry in ("plane", "planar"):
            momentum = float(np.fmax(momentum, errors["momentum_error"]))
        judged += [_held_to(problem, key, count, value) for key, value in problem.measure(solver).items()]
    keys = dict.fromkeys(row.measure for row in judged)
    orders = {key: slope for key in keys if key not in NO_ORDER and (slope := observed_order(judged, key)) is not None}
    return Verified(problem, judged, orders, time.perf_counter() - begun, energy, momentum)


ROUND_OFF = 1e-9      # relative errors below this are of arithmetic and of the tolerance of searches, not of the grid


def observed_order(judged: list[Judged], key: str) -> float | None:
    """Least-squares slope of log(error) against log(1/zones); None for fewer than two grids, values that are not errors, and round-off."""
    rows = [(j.zones, j.value) for j in judged if j.measure == key and j.sense == "below" and j.value > 0.0]
    if len(rows) < 2 or min(value for _, value in rows) < ROUND_OFF or key.startswith(("peak", "energy_minimum")):
        return None
    n, error = np.array(rows, dtype=float).T
    return float(-np.polyfit(np.log(n), np.log(error), 1)[0])
