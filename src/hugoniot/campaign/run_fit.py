"""From what a user asks of a fit to its result: reads deck, data and parameters, runs the search on workers, writes the folder.

    folder/fitted.toml    the deck with the values found, ready to run          residuals.csv   data, model, residual
           fit.json       parameters, intervals, correlations, doubts           report.html
           posterior.csv, predictive.csv   where a posterior was asked for
"""

import os
import pathlib
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from hugoniot.campaign.ask import Wishes, local, read_asked
from hugoniot.campaign.designs import Design
from hugoniot.campaign.fit import Free, Problem
from hugoniot.campaign.fit_files import claimed, write_fit
from hugoniot.campaign.fit_results import Fit, likely, weighed
from hugoniot.campaign.plan import Plan, given, ties_of
from hugoniot.campaign.planes import LOSSES
from hugoniot.campaign.pop_plot import charge_of
from hugoniot.campaign.pop_target import explosive_of, is_pop_plot, read_pop_plot
from hugoniot.campaign.posterior import Posterior, checked, posterior_of
from hugoniot.campaign.questions import Deck
from hugoniot.campaign.targets import Target, read_targets
from hugoniot.campaign.variables import read_variable, refuse
from hugoniot.units import UnitError, parse

POINTS = 2000        # of a model's record, over the times of the data


@dataclass
class FitWishes:
    """What a fit is asked for.

    to       files of measured records, or numbers "free surface.arrival = 0.63 +- 0.01 us"; free: texts of `variables.read_variable`
    gauge    of columns that name none; sigma: uncertainty of records that bring none; window: times that count (`targets`)
    shift    largest shift of the measured clock, such as "20 ns"; scale: largest relative error of the records' scale
    loss     "linear", "soft_l1", "huber" or "cauchy"; starts: searches from different places; profile: limits by profiles
    local    do not look further where no search matches the data
    posterior       "surrogate" or "runs": draw a sample of the posterior too; posterior_runs: how many runs for it
    """

    to: Sequence[str] = ()
    free: Sequence[str] = ()
    tie: Sequence[str] = ()
    gauge: str | None = None
    sigma: str | None = None
    window: Sequence[str] = ()
    shift: str | None = None
    scale: str | None = None
    loss: str = "linear"
    starts: int = 2
    seed: int = 0
    profile: bool = False
    local: bool = False
    posterior: str | None = None
    posterior_runs: int | None = None


@dataclass(frozen=True)
class Fitted:
    """A fit with its targets, what the model has for them, where it is written (None: nowhere), and the posterior that was asked for."""

    fit: Fit
    targets: tuple[Target, ...]
    models: tuple[np.ndarray, ...]
    deck: str
    notes: tuple[str, ...]
    folder: pathlib.Path | None = None
    posterior: Posterior | None = None


def run_fit(path, wishes: FitWishes, out=None, *, workers: int | None = None, engine: Callable | None = None, materials: Sequence = (),
            show: Callable[[int], None] | None = None) -> Fitted:
    """Fit a deck to data and write the result into `out` (default: the deck's name and .fit; False: nowhere).

    show   called with the number of runs made so far
    Raises `DeckError`, `FileTrouble`, `NoSolution`.
    """
    _, text, source = read_asked(path, Wishes())
    if text is None or source is None:
        raise refuse("DECK", "", "a fit needs a deck", "name one")
    if wishes.loss not in LOSSES:
        raise refuse("--loss", wishes.loss, "unknown loss", f"known: {', '.join(LOSSES)}")
    if wishes.starts < 1:
        raise refuse("--starts", str(wishes.starts), "not a valid number of searches", "give 1 or more")
    if wishes.posterior is not None:
        checked(wishes.posterior)
    if wishes.posterior_runs is not None and wishes.posterior is None:
        raise refuse("--posterior-runs", str(wishes.posterior_runs), "no posterior is requested",
                     "add --posterior surrogate, or --posterior runs")
    if wishes.posterior_runs is not None and wishes.posterior_runs < 8:
        raise refuse("--posterior-runs", str(wishes.posterior_runs), "too few runs for a posterior", "give a few hundred runs")
    folder = None if out is False else claimed(pathlib.Path(out or f"{source.stem}.fit"))
    question = Deck(text, source.name, os.path.abspath(source.parent), [os.path.abspath(m) for m in materials], points=POINTS)
    free = tuple(Free(_range(word)) for word in wishes.free)
    if not free:
        raise refuse("--free", "", "no parameter is free", 'write --free "material.al.fracture.strength = 1..8 GPa"')
    variables = tuple(f.variable for f in free)
    plan = Plan(question, Design("shares", variables, shares=np.full((1, len(free)), 0.5)),
                ties_of(wishes.tie, [v.name for v in variables]), "--free")
    plan.check()
    targets, notes = _targets(question, plan, wishes)
    question.records = tuple(dict.fromkeys(t.name for t in targets if t.clock >= 0))
    limits = [_limit(wishes.shift, "s", "--shift"), _limit(wishes.scale, "1", "--scale")]
    look_at(question, targets, limits[0])
    clocks = 1 + max(t.clock for t in targets)
    of_records = [f"--{name}" for name in ("shift", "scale", "window", "gauge", "sigma") if getattr(wishes, name)]
    if question.run and clocks == 0 and of_records:
        raise refuse(of_records[0], "", "has no effect on measured numbers, only on records", "leave it out")
    with (engine or local(workers))(question.record(), ()) as pool:
        ask = _asking(pool, question, show)
        problem = Problem(plan, free, tuple(targets), clocks, *(limits if clocks else (0.0, 0.0)), wishes.loss, ask)
        fit = _searched(problem, wishes)
        answer = problem.answers([fit.minimum.x])[0]
        notes += [f"the run with the fitted values: {text}" for text in answer.get("warnings", ())]
        models = tuple(problem.model(fit.minimum.x, t, answer) for t in targets)
        drawn = None
        if wishes.posterior is not None:
            drawn = posterior_of(problem, fit.minimum, wishes.posterior, wishes.posterior_runs, wishes.seed)
    found = Fitted(fit, tuple(targets), models, _fitted_deck(plan, problem, fit), tuple(notes), folder, drawn)
    if folder is not None:
        write_fit(folder, found, source.name)
    return found


def _range(text: str):
    variable = read_variable(text, "--free")
    if variable.kind == "values":
        raise refuse("--free", text, "a free parameter needs a range, or a mean and an uncertainty",
                     'write "KEY = 1..8 GPa" or "KEY = 5 +- 0.1 GPa"')
    return variable


def _limit(text: str | None, unit: str, option: str) -> float:
    if text is None:
        return 0.0
    try:
        found = parse(float(text) if unit == "1" and _is_number(text) else text, unit)
    except UnitError as error:
        raise refuse(option, text, error.message, error.hint) from None
    if not found > 0.0:
        raise refuse(option, text, "not above 0", "give the largest shift that is allowed, such as '20 ns'" if unit == "s" else
                     "give the largest change of the scale that is allowed, such as '2 %'")
    return found


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True


def _targets(question: Deck, plan: Plan, wishes: FitWishes) -> tuple[list[Target], list[str]]:
    """The targets, with a run in the middle of the ranges to say what gauges there are; Pop plots need none."""
    from hugoniot.campaign.memory_run import MemoryRun

    problem = question.read(plan.changes(0)).problem
    question.until = problem.stop_time
    files = [text for text in wishes.to if "=" not in text and is_pop_plot(text)]
    own: list[str] = []
    pops = [read_pop_plot(path, k, wishes.sigma if len(files) == len(wishes.to) else None, own) for k, path in enumerate(files, 1)]
    question.pops = [[pop.time.tolist(), pop.values.tolist()] for pop in pops]
    question.run = len(files) < len(wishes.to) or not files
    if pops:
        charge_of(explosive_of(problem))      # says what is missing
    if not question.run:
        of_records = {"--shift": wishes.shift, "--scale": wishes.scale, "--window": ", ".join(wishes.window), "--gauge": wishes.gauge}
        if idle := {option: text for option, text in of_records.items() if text}:
            option, text = next(iter(idle.items()))
            raise refuse(option, text, "has no effect on a Pop plot, only on records in time", f"leave out {' and '.join(idle)}")
        if idle := [key for key in plan.changes(0) if not key.startswith("material.")]:
            raise refuse("--free", idle[0], "has no effect on a Pop plot, whose runs take only the explosive from the deck",
                         "vary constants of the material instead, or also give a record of the deck itself")
        return list(pops), own
    others = [text for text in wishes.to if text not in files]
    targets, notes = read_targets(others, MemoryRun(problem), gauge=wishes.gauge, sigma=wishes.sigma, windows=wishes.window)
    return [*targets, *pops], list(dict.fromkeys([*notes, *own]))


def look_at(question: Deck, targets: list[Target], shift: float) -> None:
    """Keep the records of the runs only as far as the data need them: what is kept of them then follows the data however long the run."""
    ends = [(float(t.time[0]), float(t.time[-1])) for t in targets if t.clock >= 0]
    if ends:
        question.since = max(0.0, min(low for low, _ in ends) - shift)
        question.until = min(question.until, max(high for _, high in ends) + shift)


def _asking(pool, question: Deck, show) -> Callable[[list[dict]], list[dict]]:
    """Runs of the deck on workers, their records beside the times they are for."""
    times = question.times()
    total = 0

    def ask(changes: list[dict]) -> list[dict]:
        nonlocal total
        found: list[dict] = [{} for _ in changes]
        for answer in pool.run(enumerate(changes)):
            records = {name: (None, values) if name.startswith("pop plot ") else _ended(times, np.array(values, dtype=float))
                       for name, values in answer.get("records", {}).items()}
            found[answer["case"]] = {**answer, "records": records}
            total += 1
            if show is not None:
                show(total)
        return found

    return ask


def _ended(times: np.ndarray, values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    sound = np.isfinite(values)
    return times[sound], values[sound]


def _searched(problem: Problem, wishes: FitWishes) -> Fit:
    own = _own_values(problem)
    starts = problem.starts(own, wishes.starts, wishes.seed)
    minima = sorted((problem.search(start) for start in starts), key=lambda m: m.cost)
    if not wishes.local and not likely(problem, minima[0]):
        minima = sorted([*minima, problem.search(problem.widely([m.x for m in minima], wishes.seed))], key=lambda m: m.cost)
    return weighed(problem, minima, wishes.profile)


def _own_values(problem: Problem) -> np.ndarray | None:
    """The point at which the deck stands as it is; None where a parameter has no value there, or one outside its range."""
    question, found = problem.plan.question, []
    for f in problem.free:
        value = given(question.raw, f.variable.name) if isinstance(question, Deck) else None
        try:
            c = None if value is None else f.coordinate(parse(value, f.variable.si))
        except UnitError:
            c = None
        if c is None:
            return None
        found.append(c)
    return np.array(found + [0.0] * (len(problem.names) - len(found)))


def _fitted_deck(plan: Plan, problem: Problem, fit: Fit) -> str:
    values = [f.given(c) for f, c in zip(problem.free, fit.minimum.x)]
    question = plan.question
    text = question.read(plan.changes_of(values)).resolved if isinstance(question, Deck) else ""
    lines = [f"# {p.name} = {p.value:.6g} {p.unit}, standard deviation {p.sigma:.2g}" for p in fit.parameters]
    return "\n".join(["# Fitted: reduced chi-square " + f"{fit.reduced:.3g}", *lines, text])
