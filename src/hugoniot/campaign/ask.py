"""From what a user says (command line, Python, [sweep] table) to a plan and its answer."""

import contextlib
import os
import pathlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from typing import Any

from hugoniot.campaign.analysis import write_constants
from hugoniot.campaign.designs import KINDS, design_of
from hugoniot.campaign.plan import Plan, sweep_table, ties_of
from hugoniot.campaign.pool import LocalPool
from hugoniot.campaign.questions import Deck, Match
from hugoniot.campaign.sweep import Progress, Swept, cores, list_files, sweep
from hugoniot.campaign.uncertain import SAMPLES, Known, records_of, rows_of, uncertain
from hugoniot.campaign.variables import read_variable, refuse
from hugoniot.errors import DeckError, FileTrouble
from hugoniot.materials.collect import nearest
from hugoniot.problem.arithmetic import Trouble
from hugoniot.report import write_or_note
from hugoniot.units import UnitError, parse
from hugoniot.version import __version__


@dataclass
class Wishes:
    """What a sweep is asked for: the keys of a [sweep] table.

    deck        path of the deck that is varied; match: names of the layers of an impedance match instead
    vary        texts as of `variables.read_variable`; tie: as of `plan.ties_of`
    design      "grid", "sobol", "lhs", "saltelli", "morris" or the path of a table of cases; samples, seed: of the sampled ones
    output      patterns of the results wanted; record: "GAUGE.field" of which every case keeps a record
    keep        keep the full run folders
    time_limit  seconds a case may take (compiling apart)
    uncertain   "library": the constants vary by what the library knows of their uncertainty (`campaign.uncertain`)
    """

    deck: str | None = None
    match: Sequence[str] | None = None
    vary: Sequence[str] = ()
    tie: Sequence[str] = ()
    design: str = "grid"
    samples: int | None = None
    seed: int = 0
    output: Sequence[str] = ()
    record: Sequence[str] = ()
    keep: bool = False
    time_limit: float | None = None
    uncertain: str | None = None

    def words(self) -> dict[str, Any]:
        """As plain data; what was not asked for is left out."""
        found = {f.name: getattr(self, f.name) for f in fields(self)}
        return {key: list(value) if isinstance(value, (tuple, list)) else value for key, value in found.items()
                if value not in (None, (), [])}


_KINDS = {"deck": (str,), "match": (list,), "vary": (list,), "tie": (list,), "design": (str,), "samples": (int,), "seed": (int,),
          "output": (list,), "record": (list,), "keep": (bool,), "time_limit": (float, int), "uncertain": (str,)}
_NAMES = {str: "a string", list: "an array of strings", int: "a whole number", bool: "true or false", float: "a number"}


def with_table(wishes: Wishes, table: Mapping[str, Any], name: str) -> Wishes:
    """The wishes of a [sweep] table, over which those that were given otherwise take precedence. Raises `DeckError`."""
    for key, value in table.items():
        if key not in _KINDS:
            raise DeckError.single(name, None, f"sweep.{key}", "unknown key", nearest(key, _KINDS))
        texts = isinstance(value, list) and not all(isinstance(each, str) for each in value)
        if not isinstance(value, _KINDS[key]) or texts or isinstance(value, bool) and bool not in _KINDS[key]:
            raise DeckError.single(name, None, f"sweep.{key}", f"expected {_NAMES[_KINDS[key][0]]}")
    default = Wishes()
    changed = {f.name: getattr(wishes, f.name) for f in fields(wishes) if getattr(wishes, f.name) != getattr(default, f.name)}
    return Wishes(**{**table, **changed})


def read_asked(path, wishes: Wishes) -> tuple[Wishes, str | None, pathlib.Path | None]:
    """(all wishes, text of the deck or None, its path) of a deck, or of a sweep file that names one. Raises `DeckError`, `FileTrouble`."""
    if path is None:
        return wishes, None, None
    path = pathlib.Path(path)
    text = _text(path)
    table = sweep_table(text, path.name)
    if table is None:
        if wishes.match is not None:
            raise refuse("--match", ",".join(wishes.match), f"an impedance match takes nothing from {path.name}",
                         "omit one of them")
        return wishes, text, path
    if str(table.get("design", "")).lower().endswith(".csv"):
        table = {**table, "design": str(path.parent / table["design"])}
    found = with_table(wishes, table, path.name)
    if found.match is not None:
        if "deck" in table:
            raise refuse("sweep.deck", table["deck"], "an impedance match takes nothing from a deck", "omit it, or omit match")
        return found, None, path
    if "deck" not in table:
        return found, text, path
    deck = path.parent / str(found.deck)
    return found, _text(deck), deck


def _text(path: pathlib.Path) -> str:
    from hugoniot.files import read_text

    try:
        return read_text(path)
    except FileTrouble:
        raise
    except OSError as error:
        raise FileTrouble(f"cannot read {path}: {error.strerror or error}; hugoniot init writes a deck to start from") from None
    except UnicodeDecodeError:
        raise DeckError.single(path.name, None, "deck", "not a UTF-8 text file", "a deck is a TOML file") from None


def question_for(wishes: Wishes, text: str | None, path: pathlib.Path | None, materials: Sequence = (), runs: pathlib.Path | None = None):
    """The question that a deck or a match asks. Raises `DeckError`."""
    places = [os.path.abspath(place) for place in materials]
    if wishes.match is not None:
        if wishes.keep or wishes.record:
            raise refuse("--keep" if wishes.keep else "--record", "", "an impedance match produces no run", "leave it out")
        if len(wishes.match) < 2:
            raise refuse("--match", ",".join(wishes.match), "an impact needs a flyer and a target", "write --match copper,aluminum")
        return Match(wishes.match, places)
    if text is None or path is None:
        raise refuse("DECK", "", "no deck is given", "name one, or give a match: --match copper,aluminum")
    kept = None if runs is None else os.path.abspath(runs)
    question = Deck(text, path.name, os.path.abspath(path.parent), places, wishes.record, runs=kept)
    if wishes.record:
        base = question.read({}).problem
        question.until = base.stop_time
        names = [gauge.name for gauge in base.gauges]
        for name in wishes.record:
            gauge, dot, _ = name.rpartition(".")
            if not dot or gauge not in names:
                raise refuse("--record", name, "no such gauge in the deck", f"write it like '{(names or ['GAUGE'])[0]}.velocity'; "
                             f"the gauges are: {', '.join(names) or 'none'}")
    return question


def plan_of(wishes: Wishes, question) -> tuple[Plan, list[Known]]:
    """(the plan of a question, what the library knows of its materials where that was asked for). Raises `DeckError`."""
    variables, ties, known = [read_variable(text) for text in wishes.vary], [], []
    kind, samples = wishes.design, wishes.samples
    if wishes.uncertain is not None:
        own, ties, known = uncertain(question, wishes.uncertain)
        variables += own
        if kind == "grid":
            kind, samples = "sobol", samples or SAMPLES
    design = design_of(variables, kind, samples, wishes.seed)
    given = [variable.name for variable in design.variables]
    taken = {*given, *(text.partition("=")[0].strip() for text in wishes.tie)}       # what is varied by hand is not the library's
    return Plan(question, design, (*ties_of(wishes.tie, given), *(tie for tie in ties if tie.key not in taken))), known


def local(workers: int | None = None, time_limit: float | None = None) -> Callable:
    """The engine of local processes: one for each processor unless a number is given."""
    if workers is not None and workers < 1:
        raise refuse("--workers", str(workers), "not a valid number of workers", "give 1 or more")
    if time_limit is not None and not time_limit > 0.0:
        raise refuse("--time-limit", str(time_limit), "not a time", "give seconds above 0")
    return lambda question, known: LocalPool(question, workers or cores(), known, time_limit)


def longest(plan: Plan, until: float) -> float:
    """The latest stop_time of all cases where the sweep changes it, else that of the deck: how far records go."""
    names = [variable.name for variable in plan.design.variables] + [tie.key for tie in plan.ties]
    if "stop_time" not in names:
        return until
    found = []
    for case in range(len(plan)):
        with contextlib.suppress(Trouble, UnitError):
            found.append(parse(plan.changes(case)["stop_time"], "s"))
    return max(found, default=until)


def engine_of(name: str = "local", scheduler: str | None = None, workers: int | None = None, time_limit: float | None = None,
              tell: Callable[[str], None] | None = None) -> Callable:
    """The engine that is asked for: "local", or "dask" with the address of a scheduler or workers of this machine.

    tell   given the address of the scheduler's dashboard
    """
    if name == "local":
        if scheduler is not None:
            raise refuse("--scheduler", scheduler, "local workers have no scheduler", "add --engine dask")
        return local(workers, time_limit)
    if name != "dask":
        raise refuse("--engine", name, "unknown engine", "known: local, dask")
    if scheduler is not None and workers is not None:
        raise refuse("--workers", str(workers), "the scheduler has its own workers", "leave out --workers or --scheduler")
    local(workers, time_limit)      # checks the numbers

    def entered(question, known):
        from hugoniot.campaign.dask_pool import DaskPool

        class Told(DaskPool):
            def __enter__(self):
                super().__enter__()
                if tell is not None and self.dashboard:
                    tell(self.dashboard)
                return self

        return Told(question, workers or cores(), known, scheduler, time_limit)

    return entered


def run_sweep(path, wishes: Wishes, out=None, *, engine: Callable | None = None, materials: Sequence = (), workers: int | None = None,
              show: Callable[[Progress], None] | None = None, report: bool = True) -> Swept:
    """Do what was wished for of a deck, a sweep file, or None for a match; writes the folder `out` (default: the deck's name and .sweep).

    engine   as of `sweep.sweep`; local processes unless given
    Raises `DeckError`, `FileTrouble`, and KeyboardInterrupt, after which the same call goes on.
    """
    wishes, text, source = read_asked(path, wishes)
    if wishes.uncertain is not None and not wishes.record and text is not None and source is not None:
        wishes = replace(wishes, record=records_of(Deck(text, source.name, os.path.abspath(source.parent),
                                                        [os.path.abspath(place) for place in materials])))
    folder = pathlib.Path(out or (f"{source.stem}.sweep" if source else "match.sweep"))
    question = question_for(wishes, text, source, materials, folder / "runs" if wishes.keep else None)
    plan, known = plan_of(wishes, question)
    if wishes.record and isinstance(question, Deck):
        question.until = longest(plan, question.until)
    swept = sweep(plan, folder, engine=engine or local(workers, wishes.time_limit), outputs=wishes.output, show=show, words=wishes.words())
    title = f"Sweep of {source.name}" if source and wishes.match is None else f"Impedance match of {', '.join(wishes.match or ())}"
    asked = "\n".join([*wishes.vary, *wishes.tie, *(["constants of the library within their uncertainty"] if known else []),
                       *([] if wishes.design in KINDS else [f"cases of {wishes.design}"])])
    rows = list(rows_of(known))
    write_constants(folder, rows)
    list_files(folder, wishes.words())
    if report:
        write_or_note(folder, lambda place: _report(place, swept, title, asked, rows))
    return replace(swept, constants=rows)


def _report(folder, swept: Swept, title: str, asked: str, constants: list[list[str]]) -> None:
    from hugoniot.report.sweep_page import write_sweep_report

    sensitivity = swept.analysis.sensitivity if swept.analysis else None
    write_sweep_report(folder, swept.table, title, asked, __version__, sensitivity, constants)
