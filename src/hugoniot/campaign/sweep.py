"""A sweep: the cases of a plan answered by workers, kept in a journal as they come, and put into a table in the order of the plan.

    folder/sweep.json   what was asked          cases.csv, sweep.h5   the table
           cases.jsonl  the answers             report.html           pictures and the table
           runs/KEY/    full runs, with keep    .lock                 while a sweep works here

The same command goes on where a killed one stopped, and a larger design adds to what is there: nothing that has run runs again. The table
depends on the plan alone, not on how many workers there were, nor on how often they were interrupted.
"""

import fnmatch
import os
import pathlib
import re
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from hugoniot.campaign.analysis import CONSTANTS, FILES, Analysis, analysis_of, write_analysis
from hugoniot.campaign.journal import Journal, is_journal
from hugoniot.campaign.plan import Plan
from hugoniot.campaign.questions import MATCHED, POINTS, Deck
from hugoniot.campaign.variables import refuse
from hugoniot.errors import FileTrouble
from hugoniot.output.atomic import explained, write_whole
from hugoniot.output.columns import describe
from hugoniot.output.listed import write_listed
from hugoniot.output.lock import Lock
from hugoniot.output.seal import sealed_json
from hugoniot.output.sweep_file import Column, SweepTable, write_cases, write_table
from hugoniot.problem.arithmetic import Trouble

_NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:[eE][+-]?\d+)?")
JOURNAL, TABLE, CASES, ASKED = "cases.jsonl", "sweep.h5", "cases.csv", "sweep.json"


@dataclass
class Progress:
    """How far a sweep is: cases in all, answered, of them failed and known from before; rate in cases/s, seconds left."""

    total: int
    done: int = 0
    failed: int = 0
    known: int = 0
    rate: float = 0.0
    left: float = float("inf")


@dataclass(frozen=True)
class Swept:
    """A finished sweep: its table, where it is, how it went, what a sample says about its parameters, and lines of
    `uncertain.rows_of` where constants varied by their uncertainty in the library."""

    table: SweepTable
    folder: pathlib.Path
    progress: Progress
    seconds: float
    analysis: Analysis | None = None
    constants: list[list[str]] = field(default_factory=list)


def cores() -> int:
    """How many processors this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def sweep(plan: Plan, folder, *, engine: Callable, outputs: Sequence[str] = (), show: Callable[[Progress], None] | None = None,
          words: dict[str, Any] | None = None) -> Swept:
    """Answer every case of a plan and write the table into the folder.

    engine    engine(question record, known keys) gives a pool such as `pool.LocalPool`
    outputs   patterns such as "*.arrival" of the results that the table has; all, if there are none
    show      called with the progress after every case
    words     what was asked, kept in sweep.json

    Raises `DeckError` for a plan that cannot be asked, `FileTrouble` for a folder that cannot be used.
    """
    begun, folder = time.perf_counter(), pathlib.Path(folder)
    plan.check()
    _claim(folder)
    lock = Lock(folder)
    try:
        with Journal(folder / JOURNAL) as journal:      # first, to mark the folder as a sweep's
            write_whole(folder / ASKED, sealed_json(words or {}))
            progress = Progress(len(plan))
            keys, reasons = _asked(plan, journal, engine, progress, show)
            table = _table(plan, journal, keys, reasons, outputs)
        write_cases(folder / CASES, table)
        write_table(folder / TABLE, table)
        analysis = analysis_of(plan.design, table)
        write_analysis(folder, analysis, table)
        list_files(folder, words)
    finally:
        lock.release()
    return Swept(table, folder, progress, time.perf_counter() - begun, analysis)


def list_files(folder, words: dict[str, Any] | None) -> None:
    """Write sweep.json, with the checksums of the files beside it."""
    write_listed(pathlib.Path(folder) / ASKED, words or {}, (JOURNAL, TABLE, CASES, *FILES, CONSTANTS))


def _claim(folder: pathlib.Path) -> None:
    with explained(folder):
        folder.mkdir(parents=True, exist_ok=True)
        standing = sorted(path.name for path in folder.iterdir() if path.name not in (".lock", "run.log"))
    if standing and not is_journal(folder / JOURNAL):
        raise FileTrouble(f"{folder}: contains {standing[0]}, but no {JOURNAL} written by a sweep, so it is not recognised as the folder "
                          "of one; choose another with --out")


def _asked(plan: Plan, journal: Journal, engine, progress: Progress, show) -> tuple[list[str], dict[int, str]]:
    """(key of every case, "" where it has none; reasons of cases that are not in the journal)."""
    keys, reasons = [""] * len(plan), {}
    begun = time.monotonic()

    def tasks() -> Iterator[tuple[int, dict]]:
        for case in range(len(plan)):
            try:
                yield case, plan.changes(case)
            except Trouble as error:
                reasons[case] = f"tie: {error.message}"
                count(True)

    def count(failed: bool, known: bool = False) -> None:
        progress.done += 1
        progress.failed += failed
        progress.known += known
        fresh, spent = progress.done - progress.known, time.monotonic() - begun
        progress.rate = progress.done / spent if spent > 0.0 else 0.0
        progress.left = (progress.total - progress.done) * spent / (fresh or progress.done)
        if show is not None:
            show(progress)

    with engine(plan.question.record(), journal.places) as pool:
        for answer in pool.run(tasks()):
            case, key = answer.pop("case"), answer.get("key", "")
            known = bool(key) and not {"numbers", "reason"} & set(answer)
            if key and not known and key not in journal.places:
                journal.add(answer)
            keys[case] = key
            if not key:
                reasons[case] = _why(answer)
            count("numbers" not in answer and not known, known)
    return keys, reasons


def _why(answer: dict) -> str:
    if "late" in answer:
        return f"ended at the time limit of {answer['late']:g} s"
    return answer.get("died") or answer.get("reason") or "no answer"


# -- the table -------------------------------------------------------------------------------------------------------
def _table(plan: Plan, journal: Journal, keys: list[str], reasons: dict[int, str], outputs: Sequence[str]) -> SweepTable:
    answered = [case for case, key in enumerate(keys) if key]
    why, columns, records = ["" for _ in keys], {}, {}
    warned: list[Sequence[str]] = [() for _ in keys]
    for case, reason in reasons.items():
        why[case] = reason
    for case, answer in zip(answered, journal.answers([keys[case] for case in answered])):
        why[case], warned[case] = answer.get("reason", ""), answer.get("warnings", ())
        for name, value in answer.get("numbers", {}).items():
            if not outputs or any(fnmatch.fnmatchcase(name, pattern) for pattern in outputs):
                _column(columns, name, len(keys))[case] = value
        for name, values in answer.get("records", {}).items():
            _column(records, name, len(keys), POINTS)[case] = values
    if outputs and not columns and any(not reason for reason in why):
        _unknown_outputs(journal, keys, answered, outputs)
    parameters = _parameters(plan)
    grid = plan.design.kind == "grid"
    times = np.linspace(0.0, plan.question.until, POINTS) if isinstance(plan.question, Deck) and records else None
    return SweepTable(
        parameters, tuple(Column(name, unit_of_result(name), values) for name, values in columns.items()), tuple(why),
        plan.design.shape if grid else (), _steps(plan) if grid else (),
        tuple(Column(name, describe(name.rpartition(".")[2])[0], values) for name, values in records.items()), times,
        {"design": plan.design.kind, "seed": plan.design.seed, "parameters": "\n".join(column.name for column in parameters),
         "warnings": "\n".join(grouped(warned))})


def grouped(warned: Sequence[Sequence[str]]) -> list[str]:
    """The warnings of all cases, those that differ in their numbers alone as one, with the number of cases and the words of the first."""
    found: dict[str, list[str]] = {}
    for texts in warned:
        for kind, text in {_NUMBER.sub("#", text): text for text in texts}.items():
            found.setdefault(kind, []).append(text)
    return [texts[0] if len(texts) == len(warned) and len(set(texts)) == 1 else
            f"in {len(texts)} of {len(warned)} cases{', such as' if len(set(texts)) > 1 else ''}: {texts[0]}" for texts in found.values()]


def _column(columns: dict[str, np.ndarray], name: str, *shape: int) -> np.ndarray:
    """A column of the table, begun with not-a-number where it is not there yet."""
    if name not in columns:
        columns[name] = np.full(shape, np.nan)
    return columns[name]


def _unknown_outputs(journal: Journal, keys: list[str], answered: list[int], outputs: Sequence[str]) -> None:
    numbers = next((a["numbers"] for a in journal.answers([keys[case] for case in answered]) if "numbers" in a), {})
    raise refuse("--output", outputs[0], "no result has such a name", f"the results are: {', '.join(numbers)}")


def unit_of_result(name: str) -> str:
    """SI unit of a result of a deck or of a match."""
    from hugoniot.campaign.numbers import unit_of

    return MATCHED.get(name.rpartition(".")[2]) or unit_of(name)


def _parameters(plan: Plan) -> tuple[Column, ...]:
    """The variables, then the ties, case by case; not-a-number where a tie has no value."""
    variables, ties = plan.design.variables, plan.ties
    found: list[list] = [[] for _ in variables]
    tied: list[list[float]] = [[] for _ in ties]
    units = [""] * len(ties)
    for case in range(len(plan)):
        values = plan.design.values(case)
        for column, variable, value in zip(found, variables, values):
            column.append(value if variable.texts else variable.number(value))
        if ties:
            numbers = plan.tied(values)
            for k, number in enumerate(numbers):
                tied[k].append(number.value)
                units[k] = units[k] or number.unit()
    return (*(Column(v.name, v.si, np.array(column, dtype=object if v.texts else float)) for v, column in zip(variables, found)),
            *(Column(tie.key, unit, np.array(column)) for tie, unit, column in zip(ties, units, tied)))


def _steps(plan: Plan) -> tuple[Column, ...]:
    """The values along each axis of a grid."""
    found = []
    for variable, count in zip(plan.design.variables, plan.design.shape):
        values = [variable.step(k) for k in range(count)]
        numbers = values if variable.texts else [variable.number(value) for value in values]
        found.append(Column(variable.name, variable.si, np.array(numbers, dtype=object if variable.texts else float)))
    return tuple(found)
