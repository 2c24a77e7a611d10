"""The one place where the parts are put together: a deck or a Problem goes in, a run folder comes out."""

import dataclasses
import os
import pathlib
import re
import shlex
import time
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from hugoniot.errors import DeckError, FileTrouble, UnphysicalState
from hugoniot.materials.validity import beyond, range_of
from hugoniot.output.line_record import LineRecorder, line_meta
from hugoniot.output.origin import check_program, other_machine
from hugoniot.output.plane_record import PlaneRecorder, plane_meta
from hugoniot.output.run_folder import RunFolder
from hugoniot.problem import windows
from hugoniot.problem.defaults import completed
from hugoniot.problem.model import Problem
from hugoniot.problem.plane.model import Problem2D
from hugoniot.report import write_or_note
from hugoniot.signals import end_like_interrupt
from hugoniot.solvers.protocol import Solver
from hugoniot.solvers.run import Outcome, Schedule, march_to_end, snapshot_times
from hugoniot.units import format_si
from hugoniot.version import __version__

if TYPE_CHECKING:
    from hugoniot.output.run import Run

MUCH_ENERGY = 0.01      # energy error of which a run warns


def make_solver(problem: Problem) -> Any:
    """The solver a problem asks for by name: a `solvers.protocol.LineSolver`, or of two dimensions a `PlaneSolver`."""
    if problem.solver.kind == "lagrange1d":
        from hugoniot.solvers.lagrange1d.solver import Lagrange1D
        return Lagrange1D(problem)
    if problem.solver.kind == "shock_structure":
        from hugoniot.problem.structure_start import shock_start
        from hugoniot.solvers.shock_structure.solver import ShockStructure
        return ShockStructure(problem, shock_start(problem))
    if problem.solver.kind == "fronts":
        if problem.solver.options.get("mode") == "cells":
            from hugoniot.solvers.fronts.cells.solver import Cells
            return Cells(problem)
        from hugoniot.solvers.fronts.solver import Fronts
        return Fronts(problem)
    if problem.solver.kind == "lagrange2d":
        from hugoniot.diagnostics.gauges2d import Sampler
        from hugoniot.solvers.lagrange2d.solver import Lagrange2D
        return Lagrange2D(problem, Sampler(problem) if problem.gauges else None)
    hint = "known: fronts, lagrange1d, lagrange2d, shock_structure"
    raise DeckError.single("problem", None, "solver.kind", f"unknown solver '{problem.solver.kind}'", hint)


def _recorder(folder: RunFolder, problem, solver, progress, warned=()):
    """What hands the states of a run to its folder."""
    recorder = PlaneRecorder if problem.solver.kind == "lagrange2d" else LineRecorder
    return recorder(folder, problem, solver, progress, warned)


def run(deck_or_problem, out=None, *, deck_text: str | None = None, progress=None, overwrite: bool = False,
        report: bool | Callable = True, **overrides) -> "Run":
    """Run a deck or a problem, and return the finished `Run`.

    deck_or_problem   path of a deck, a `Deck` that `read_deck` returned, or a `Problem`
    out         run folder to write (default: the deck's name, or the problem's title, with `.run`, in the current folder)
    deck_text   of a `Problem` only: text to keep as deck.toml (default: its deck, with every default written out)
    progress    object with a method `update(report)` that is called while the run advances, or None
    overwrite   whether a run that is already in the folder is replaced
    report      whether report.html is written, or a function that writes it into the folder of a finished run
    overrides   with the path of a deck: keys to change, stop_time="3 us", solver={"courant": 0.3}; with a `Problem`: fields to replace,
                numbers in SI; not with a `Deck`

    Raises `DeckError` for a deck that cannot be used, `UnphysicalState` if the run fails (the folder then holds the last state, in
    post_mortem.h5), and `FileTrouble` if the folder cannot be written.

    >>> run = hugoniot.run("flyer.toml", stop_time="3 us")
    >>> time, velocity = run.gauge("velocity", "free surface")     # s, m/s
    """
    begun = time.perf_counter()
    problem, text, warnings, name = _read(deck_or_problem, deck_text, overrides)
    solver = make_solver(problem)
    with end_like_interrupt(), RunFolder(out or f"{name}.run", overwrite=overwrite) as folder:
        folder.start(problem, text, _meta(problem, solver))
        for warning in warnings:
            folder.event(0.0, 0, "warning", warning)
        return _drive(_recorder(folder, problem, solver, progress, warnings), 0, begun, report)


def resume(folder, progress=None, report: bool | Callable = True, restore_deck: bool = False) -> "Run":
    """Continue an interrupted run from its newest intact checkpoint, and return the finished `Run`.

    The result is the same, bit for bit, as that of an uninterrupted run. If only files are missing (gauges.csv, the deck or the report),
    they are written.

    folder         the run folder
    progress       as for `run`
    report         as for `run`
    restore_deck   whether deck.toml is first replaced by the copy kept with the checkpoints

    Raises `FileTrouble` if another process is using the folder, or if its deck was changed since the run started.
    """
    with end_like_interrupt(), RunFolder(folder, resume=True) as place:
        return _completed(place, report) if place.finished else _continued(place, progress, report, restore_deck)


def _completed(place: RunFolder, report: bool | Callable) -> "Run":
    from hugoniot.output.finishing import complete
    from hugoniot.plotting import load
    from hugoniot.problem.deck import read_deck_text

    found = complete(place)
    wanted = report and not (place.folder / "report.html").is_file()
    if wanted and read_deck_text(found.deck, "deck.toml").problem.output.report:
        write_or_note(place.folder, report if callable(report) else None)
    return load(place.folder)


def so_far(folder, room) -> "Run":
    """The results of an unfinished run up to its newest intact checkpoint, as a run folder made inside `room`.

    The folder of the run is only read, so the run may be in progress. Raises `FileTrouble` if there are no results yet.
    """
    from hugoniot.output.finishing import copied
    from hugoniot.plotting import load

    again = f"`hugoniot resume {shlex.quote(str(folder))}`"
    with RunFolder(copied(folder, room), resume=True) as place:
        recorder, _ = _restored(place, None, restore_deck=True)
        problem, solver = recorder.problem, recorder.solver
        if not solver.cycle:
            raise FileTrouble(f"{folder}: the run is unfinished and has no intact checkpoint with results; continue with {again}")
        place.event(solver.time, solver.cycle, "warning",
                    f"the results end at {format_si(solver.time, 's', 4)}, the time of the last checkpoint; continue with {again}")
        _finish(recorder, Outcome(f"partial (stop time {format_si(problem.stop_time, 's', 4)})", 0.0), None)
    return load(place.folder)


def _continued(place: RunFolder, progress, report: bool | Callable, restore_deck: bool) -> "Run":
    begun = time.perf_counter()
    return _drive(*_restored(place, progress, restore_deck), begun, report)


def _restored(place: RunFolder, progress, restore_deck: bool) -> tuple[Any, int]:
    """The recorder of a run that goes on, its solver in the state of the newest intact checkpoint, and the next snapshot."""
    from hugoniot.problem.deck import read_deck_text

    folder = place.folder
    text = place.checked_deck(restore_deck)
    deck = read_deck_text(text, "deck.toml", beside=folder)
    problem, solver = deck.problem, make_solver(deck.problem)
    place.start(problem, text, _meta(problem, solver))
    recorder = _recorder(place, problem, solver, progress, deck.warnings)   # before the state is restored: budgets count from the start
    payload = place.latest_checkpoint()
    next_snapshot = 0
    if payload is None:
        for warning in deck.warnings:
            place.event(0.0, 0, "warning", warning)
    else:
        check_program(folder, payload.get("program", {}))
        solver.restore(payload["solver"])
        if strange := other_machine(payload.get("machine", {})):
            place.event(solver.time, solver.cycle, "warning", strange)
        next_snapshot = int(payload["next_snapshot"])
    return recorder, next_snapshot


def _drive(recorder, next_snapshot: int, begun: float, report: bool | Callable) -> "Run":
    from hugoniot.plotting import load

    folder, problem, solver = recorder.folder, recorder.problem, recorder.solver
    output = problem.output
    schedule = Schedule(problem.stop_time, snapshot_times(problem.stop_time, output.snapshots), output.checkpoint_seconds,
                        output.checkpoint_cycles, problem.solver.max_cycles)
    try:
        outcome = march_to_end(solver, schedule, (recorder,), next_snapshot)
    except UnphysicalState as error:
        folder.post_mortem(error, {"solver": solver.payload(), "next_snapshot": -1})
        raise
    _finish(recorder, outcome, begun)
    if report and output.report:
        write_or_note(folder.folder, report if callable(report) else None)
    return load(folder.folder)


def _finish(recorder, outcome: Outcome, begun: float | None) -> None:
    """Hand the folder what is known at the end of a run."""
    folder, problem, solver = recorder.folder, recorder.problem, recorder.solver
    for text in final_warnings(problem, solver, recorder.warned):
        folder.event(solver.time, solver.cycle, "warning", text)
    for kind, text in solver.notes():
        folder.event(solver.time, solver.cycle, kind, text)
    if (table := solver.front_table()) is not None:
        folder.fronts(*table)
    folder.finish(_summary(problem, solver, outcome, begun), _peaks(problem, solver))


def _peaks(problem: Problem, solver: Solver) -> dict[str, np.ndarray]:
    """Peak fields of every zone, and where they may be the overshoot of a shock that forms."""
    from hugoniot.problem.forming import forming

    peaks = solver.peaks()
    return peaks | {"forming": forming(problem).astype(np.uint8)} if problem.solver.kind in ("lagrange1d", "lagrange2d") else peaks


def _summary(problem: Problem, solver: Solver, outcome: Outcome, begun: float | None) -> dict[str, Any]:
    from hugoniot.core.compile_watch import compile_seconds

    return {
        "status": outcome.status, "cycles": solver.cycle, "zone_updates": solver.zone_updates, "time": solver.time,
        "wall_seconds": None if begun is None else time.perf_counter() - begun, "kernel_seconds": outcome.kernel_seconds,
        "compile_seconds": 0.0 if begun is None else compile_seconds(begun),
        **{name: None if value != value else value for name, value in solver.errors().items()},
        **solver.counts(), **solver.results(), **steady_numbers(problem),
    }


def steady_numbers(problem: Problem) -> dict[str, float]:
    """What the steady wave of a shock-structure run has, beside which the run's own thickness is reported."""
    if not getattr(problem.solver, "options", {}).get("shock"):
        return {}
    from hugoniot.problem.structure_start import profile_of
    from hugoniot.theory.structure.sweep import measures

    found = measures(profile_of(problem))
    sizes = [name for name in found if "thickness" in name or "width" in name]
    others = ["mach", "shock_velocity", "particle_velocity", *(name for name in found if name.startswith("entropy"))]
    return {f"steady_{name}": found[name] for name in sizes} | {name: found[name] for name in others}


def final_warnings(problem: Problem, solver: Solver, warned: Sequence[str]) -> list[str]:
    """What must be said of a finished run; `warned` of it before."""
    return [*_extrapolations(problem, solver, warned), *solver.warnings(), *_doubts(problem, solver)]


def _extrapolations(problem: Problem, solver: Solver, warned: Sequence[str]) -> list[str]:
    """A warning for each material driven beyond the particle velocities its equation of state was fitted to, unless warned of before."""
    found = []
    for name, speed in solver.largest_velocity_jump().items():
        end = range_of(problem.materials[name])
        foretold = any(f"data of '{name}'" in text or f"material '{name}' is driven to" in text for text in warned)
        if speed > end.up and not foretold:
            reach = f", but its data reach only {end.up:.4g} m/s" if end.stated else f": {beyond(end)}, and no range of its data is stated"
            found.append(f"material '{name}' was compressed as strongly as by a shock with a particle velocity of {speed:.4g} m/s{reach}")
    return found


def _doubts(problem: Problem, solver: Solver) -> list[str]:
    """Warnings of a finished run of the hydrocode: tension that no solid carries, echoes of transmitting ends, coarse spall planes."""
    from hugoniot.diagnostics.tension import overstretched

    pulled = getattr(solver, "tensions", None)      # of tracked fronts, by regions
    if pulled is not None:
        return overstretched(problem, np.arange(len(pulled)), pulled)
    if problem.solver.kind not in ("lagrange1d", "lagrange2d"):
        return []
    peaks = solver.peaks()
    found = overstretched(problem, solver.region_of, peaks["peak_tension"])
    if problem.solver.kind == "lagrange2d":
        from hugoniot.diagnostics.transmitting import measured_at_edges
        from hugoniot.solvers.lagrange2d.transmitting import missing as missing_at_edges

        found += measured_at_edges(problem, peaks["peak_stress"], missing_at_edges(problem, solver.ends))
    if problem.solver.kind == "lagrange1d":
        from hugoniot.diagnostics.spall_planes import unresolved
        from hugoniot.diagnostics.transmitting import measured
        from hugoniot.solvers.lagrange1d.transmitting import missing

        error = solver.errors()["energy_error"]
        if error > MUCH_ENERGY:
            found.append(f"the energy error is {100.0 * error:.2g} %: the integrator {problem.solver.integrator} does not conserve energy, "
                         "least of all where material converges on the axis or centre, and smaller steps or zones need not help; run again "
                         "with integrator = \"compatible\" and compare")
        found += measured(problem, peaks["peak_stress"], missing(solver.control))
        found += unresolved(problem, solver.opened, solver.region_of)
        inside = [region for before, region in solver.region_of[np.add.outer(solver.opened, (-1, 0))] if before == region]
        found += windows.broken(problem, {problem.regions[region].name for region in inside})
    return found


def _meta(problem: Problem, solver) -> dict[str, Any]:
    return (plane_meta if problem.solver.kind == "lagrange2d" else line_meta)(problem, solver, __version__)


def _read(deck_or_problem, deck_text, overrides) -> tuple[Problem, str, list[str], str]:
    """(problem, resolved deck text, warnings, name for the folder)."""
    from hugoniot.problem.deck import Deck, read_deck, write_deck

    if isinstance(deck_or_problem, (Problem, Problem2D)):
        problem = completed(_replaced(deck_or_problem, overrides))
        name = re.sub(r"[^a-z0-9]+", "-", problem.title.lower()).strip("-") or "run"
        return problem, deck_text or write_deck(problem), [], name
    if isinstance(deck_or_problem, Deck):
        if overrides:
            raise DeckError.single("run", None, next(iter(overrides)), "changes cannot be made to a deck that has been read",
                                   "give its path, or the changes to read_deck")
        deck, name = deck_or_problem, re.sub(r"[^a-z0-9]+", "-", deck_or_problem.problem.title.lower()).strip("-") or "run"
    else:
        if not isinstance(deck_or_problem, (str, os.PathLike)):
            raise TypeError(f"give the path of a deck, a Deck or a Problem, not {type(deck_or_problem).__name__}")
        path = pathlib.Path(deck_or_problem)
        if not path.exists():
            raise FileTrouble(f"{path}: no such deck; `hugoniot init` writes one to start from")
        deck, name = read_deck(path, overrides=overrides), path.stem
    return deck.problem, deck.resolved, list(deck.warnings), name


def _replaced(problem: Problem, overrides: Mapping[str, Any]) -> Problem:
    """A Problem with some fields replaced; a mapping replaces fields of `solver` or `output`."""
    changes: dict[str, Any] = {}
    for key, value in overrides.items():
        if key not in {f.name for f in dataclasses.fields(problem)}:
            raise DeckError.single("run", None, key, "a Problem has no such field", "see hugoniot.Problem")
        old = getattr(problem, key)
        changes[key] = dataclasses.replace(old, **value) if isinstance(value, Mapping) and dataclasses.is_dataclass(old) else value
    return dataclasses.replace(problem, **changes)

