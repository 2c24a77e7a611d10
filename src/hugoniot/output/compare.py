"""Two runs, or a run and measured data, side by side: norms of every quantity both have.

Data come as a table of comma-separated columns whose first line names each with its unit, such as
`time [us], velocity [m/s]`, or `time [us], mid-target stress [GPa]` where the run has several gauges.
"""

import math
import pathlib
from dataclasses import dataclass

import numpy as np

from hugoniot.core.fields import FIELDS
from hugoniot.diagnostics.apparent import APPARENT
from hugoniot.diagnostics.gauges2d import OF_LINES, OF_SIDES
from hugoniot.diagnostics.interface_gauges import CONTINUOUS, sides
from hugoniot.diagnostics.norms import Difference, difference
from hugoniot.errors import DeckError, DeckProblem
from hugoniot.files import csv_rows, read_regular
from hugoniot.materials.collect import listed
from hugoniot.output.atomic import legible
from hugoniot.output.run import Run, load
from hugoniot.output.run_numbers import recorded
from hugoniot.output.spall_records import hit_regions
from hugoniot.output.spall_records import records as surface_records
from hugoniot.units import UnitError, convert, format_si

OPPOSITE = 0.5     # of the root mean square difference: with less after a change of its sign a record has the other one
_HEADS = "use column headers such as 'time [us], velocity [m/s]' or 'time (us), velocity (m/s)'"


@dataclass(frozen=True)
class Record:
    """One quantity over time, SI. gauge "" where the data name none."""

    gauge: str
    field: str
    unit: str
    time: np.ndarray
    values: np.ndarray


@dataclass(frozen=True)
class Pair:
    """A record of `a` and its counterpart in `b`, with their difference b - a."""

    a: Record
    b: Record
    norms: Difference

    def row(self) -> dict:
        """For tables and JSON."""
        n = self.norms
        shift = None if math.isnan(n.shift) else n.shift
        return {"gauge": self.a.gauge, "field": self.a.field, "unit": self.a.unit, "l1": n.l1, "l2": n.l2, "linf": n.linf, "scale": n.scale,
                "l1_relative": n.relative[0], "l2_relative": n.relative[1], "linf_relative": n.relative[2], "time_shift": shift,
                "from": n.start, "to": n.end}


@dataclass(frozen=True)
class Comparison:
    """name_a, name_b; the pairs found; records that only one side has; which gauge was taken where the data name none."""

    name_a: str
    name_b: str
    pairs: tuple[Pair, ...]
    unmatched: tuple[str, ...]
    notes: tuple[str, ...] = ()

    def rows(self) -> list[dict]:
        return [pair.row() for pair in self.pairs]


def _table_error(path, line, key, message, hint=""):
    return DeckError([DeckProblem(str(path), line, key, message, hint)])


def split_unit(text: str) -> tuple[str, str | None]:
    """(name, unit) of a column header with its unit in square or round brackets at the end; None without brackets."""
    text = text.strip()
    for opening, closing in (("[", "]"), ("(", ")")):
        if text.endswith(closing) and opening in text:
            name, _, unit = text[:-1].rpartition(opening)
            return name.strip(), unit.strip()
    return text, None


def _head(path, text: str, column: int) -> tuple[str, str, float]:
    """(name, SI unit, factor to SI) of a column header such as `free surface velocity [km/s]`."""
    name, unit = split_unit(text)
    last = name.split()[-1] if name else ""
    field = name if name in FIELDS else next((f for f in sorted(FIELDS, key=len, reverse=True) if name.endswith(f)), last)
    if unit is None:
        raise _table_error(path, 1, f"column {column + 1}", f"'{text.strip()}' has no unit", _HEADS)
    si = "s" if column == 0 else FIELDS[field].unit if field in FIELDS else unit
    try:
        return name, si, convert(1.0, unit or "1", si or "1")
    except UnitError as error:
        raise _table_error(path, 1, f"column {column + 1}", error.message, error.hint or f"give a unit that converts to {si}") from error


def read_table(path) -> list[Record]:
    """The columns of a data file as records; the first column is the time. Raises `DeckError` (line and column), `FileTrouble`."""
    path = pathlib.Path(path)
    with legible(path, "no data can be read"):
        text = read_regular(path).decode("utf-8-sig", errors="replace")
    lines = csv_rows(text, path)
    if not lines or len(lines[0][1]) < 2:
        raise _table_error(path, 1, "table", "needs a line of column headers, with a time column and at least one more", _HEADS)
    if len(lines) < 2:
        raise _table_error(path, 1, "table", "no values below the column headers", "give one time and its values in each line")
    heads = [_head(path, head, k) for k, head in enumerate(lines[0][1])]
    rows = np.empty((len(lines) - 1, len(heads)))
    for k, (n, row) in enumerate(lines[1:]):
        if len(row) != len(heads):
            raise _table_error(path, n, "row", f"values: {len(row)}, column headers: {len(heads)}",
                               "give one value for each column")
        for c, cell in enumerate(row):
            try:
                rows[k, c] = float(cell) * heads[c][2]
            except ValueError:
                raise _table_error(path, n, heads[c][0], f"'{cell.strip()[:40]}' is not a number",
                                   "write a number in the unit of the header") from None
    if not np.all(np.isfinite(rows)):
        k, c = np.argwhere(~np.isfinite(rows))[0]
        raise _table_error(path, lines[k + 1][0], heads[c][0], "not a finite number")
    if (late := np.flatnonzero(np.diff(rows[:, 0]) <= 0)).size:
        raise _table_error(path, lines[late[0] + 2][0], heads[0][0], "the time is not later than that of the line before",
                           "sort the lines by time")
    return [_record(name, unit, rows[:, 0], rows[:, c + 1]) for c, (name, unit, _) in enumerate(heads[1:])]


def _record(name: str, unit: str, time, values) -> Record:
    for field in sorted([*FIELDS, *OF_LINES, *OF_SIDES, APPARENT], key=len, reverse=True):
        if name == field or name.endswith(" " + field):
            return Record(name[: -len(field)].strip(), field, unit, time, values)
    return Record("", name, unit, time, values)


def run_records(run: Run) -> list[Record]:
    """Every field of every gauge of a run, up to where it is lost."""
    rows, found = run.arrays("gauges"), []
    for k, name in enumerate(run.gauge_names()):
        for field, values in rows.items():
            if values.ndim == 2 and (end := recorded(values[:, k])):
                found.append(Record(name, field, run.unit("gauges", field), rows["time"][:end], values[:end, k]))
    return found


def _lost(run: Run) -> list[str]:
    """Which gauges of a run end before it does, and when."""
    rows = run.arrays("gauges")
    ends = {name: recorded(rows["velocity_x"][:, k]) for k, name in enumerate(run.gauge_names())} if "velocity_x" in rows else {}
    return [f"gauge '{name}' of {run.folder} is lost after {format_si(rows['time'][end - 1], 's', 4)}: it is compared up to then"
            for name, end in ends.items() if 0 < end < len(rows["time"])]


@dataclass(frozen=True)
class Choice:
    """Which gauge of a run answers data that name none: the one asked for, or the only sensible one."""

    run: Run
    asked: str | None
    table: str
    notes: list[str]

    def counterpart(self, record: Record, mine: list[Record]) -> Record | None:
        """Which of a run's own records answers a record of the data; None if none does. Raises `DeckError` where several could."""
        same = [own for own in mine if own.field == record.field]
        if record.gauge and self.asked is None:
            return next((own for own in same if record.gauge in (own.gauge, own.gauge.replace(",", ";"))), None)     # as in gauges.csv
        if self.asked is not None:
            found = next((own for own in same if own.gauge == self.asked), None)
        else:
            found = self._sensible(record, same)
        if found is not None:
            self.notes.append(f"{record.gauge} {record.field}".strip() + f" is compared with gauge '{found.gauge}'")
        return found

    def _sensible(self, record: Record, same: list[Record]) -> Record | None:
        """The only gauge; of velocities the surface of the body that was hit; else the only gauge that the deck names."""
        known = [own.gauge for own in same]
        at = {gauge["name"]: str(gauge["at"]) for gauge in self.run.setup["gauges"]}
        once = sides(self.run.setup["gauges"]) if record.field in CONTINUOUS else {}
        named = [name for name in known if at.get(name) != name and name not in once]
        hit = hit_regions(self.run.setup)
        ends = surface_records(self.run) if record.field == "velocity" else []
        seen = list(dict.fromkeys(r.gauge for r in ends if r.region in hit and r.gauge in known))
        for group in ([name for name in seen if name in named], seen, named, known):
            if len(group) == 1:
                return same[known.index(group[0])]
            if group:
                several = ", ".join(sorted({*named, *seen}))
                example = f"{group[0]} {record.field} [{record.unit}]"
                raise _table_error(self.table, None, record.field, f"names no gauge, and several record it: {several}",
                                   f"choose one with --gauge, or name it in the column header, such as '{example}'")
        return None


_SET_UP = ("geometry", "stop_time", "regions", "boundaries", "interfaces", "gauges", "materials")


def _turned(pair: Pair) -> bool:
    """Whether the data are a velocity that would agree far better with the other sign."""
    if pair.a.unit != "m/s":
        return False
    a, b = pair.a, pair.b
    return difference(a.time, -a.values, b.time, b.values).l2 < OPPOSITE * pair.norms.l2


def _solver(run: Run) -> str:
    """The solver of a run, and the mode where it has several."""
    solver = run.setup["solver"]
    mode = (solver.get("options") or {}).get("mode")
    return f"{solver['kind']} ({mode})" if mode else str(solver["kind"])


def _of_two_runs(a: Run, b: Run) -> list[str]:
    """Which solvers stand beside each other, where they differ, and what else the two decks differ in."""
    solvers = _solver(a), _solver(b)
    if solvers[0] == solvers[1]:
        return []
    apart = [name.replace("_", " ") for name in _SET_UP if a.setup.get(name) != b.setup.get(name)]
    other = f"the decks also differ in: {', '.join(apart)}" if apart else "otherwise the same problem"
    return [f"a was run with {solvers[0]}, b with {solvers[1]}; {other}"]


def compare(a, b, gauge: str | None = None) -> Comparison:
    """Compare run `a` with run or data file `b` (paths or `Run`s).

    gauge   of run `a`, for the columns of a data file; default by their headers, or the only sensible one

    Raises `FileTrouble` for what cannot be read and `DeckError` where nothing matches.
    """
    run = a if isinstance(a, Run) else load(a)
    is_table = not isinstance(b, Run) and pathlib.Path(b).suffix.lower() in (".csv", ".txt", ".dat")
    mine = run_records(run)
    others = read_table(b) if is_table else run_records(b if isinstance(b, Run) else load(b))
    if gauge is not None and gauge not in run.gauge_names():
        raise DeckError.single("compare", None, "--gauge", f"no gauge '{gauge}' in {run.folder}",
                               f"it has: {', '.join(run.gauge_names()) or 'none'}")
    if gauge is not None and not is_table:
        raise DeckError.single("compare", None, "--gauge", "two runs are always compared gauge by gauge", "omit it")
    pairs, unmatched, notes, apart = [], [], [], False
    notes += _lost(run)
    if not is_table:
        other_run = b if isinstance(b, Run) else load(b)
        notes += [*_lost(other_run), *_of_two_runs(run, other_run)]
    choice = Choice(run, gauge, str(b), notes)
    for other in others:
        own = choice.counterpart(other, mine)
        if own is None or own.time[-1] < other.time[0] or other.time[-1] < own.time[0]:
            unmatched.append(f"{other.gauge} {other.field}".strip())
            apart = apart or own is not None
            continue
        pairs.append(Pair(own, other, difference(own.time, own.values, other.time, other.values)))
        if is_table and _turned(pairs[-1]):
            notes.append(f"the {own.field.replace('_', ' ')} of b is opposite to that of gauge '{own.gauge}', which is positive towards "
                         "larger positions: change the sign of the data if theirs is positive towards the instrument")
    if not is_table:
        there = {(other.gauge, other.field) for other in others}
        unmatched += [f"{own.gauge} {own.field}" for own in mine if (own.gauge, own.field) not in there]
    name_b = str(b.folder if isinstance(b, Run) else b)
    if not pairs and apart:
        raise _table_error(name_b, None, "time", f"no record here overlaps in time with its counterpart in {run.folder}",
                           "check the unit and the origin of the times")
    if not pairs:
        known = sorted({f"{r.gauge} {r.field}" for r in mine})
        message = f"no record here matches a gauge of {run.folder}"
        raise _table_error(name_b, None, "columns", message,
                           f"{run.folder} has: {listed(known, 8)}")
    return Comparison(str(run.folder), name_b, tuple(pairs), tuple(unmatched), tuple(notes))
