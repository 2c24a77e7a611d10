r"""What a fit is fitted to: measured records and measured numbers, each with its uncertainty, beside what the model has for them.

A record's residual at a measured time t is

$$r = \frac{(1 + s)\,m(t - \tau) - d(t)}{\sigma(t)}$$

with the model m, the data d, a shift $\tau$ of the measured clock and a scale s, both shared by the columns of one file. The uncertainty
$\sigma$ is a column of the file (`velocity sigma [m/s]`), or given for all, or else estimated from the record itself: for data with
independent noise the second differences have the standard deviation $\sqrt6\,\sigma$; their median separates it from the signal.
"""

import pathlib
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from hugoniot.campaign.variables import refuse
from hugoniot.errors import DeckError
from hugoniot.materials.collect import listed, nearest, printable
from hugoniot.output.columns import describe
from hugoniot.output.compare import Choice, Record, read_table
from hugoniot.units import UnitError, convert, parse

LEAST_SIGMA = 2e-3      # of the largest value: what an estimate of the noise may not be below (digitised curves have none)
MOST_SHOWN = 20          # gauges, or fields, that a message lists
_MEDIAN = 1.4826        # standard deviation over median of the magnitude, normal distribution
_NUMBER = re.compile(r"(?P<name>[^=]+)=(?P<value>[^=]+?)(?:\+-|±)(?P<sigma>[^=]+)")


@dataclass(frozen=True)
class Target:
    """A measured record (time and values (n,), SI) or number (n = 1, time 0).

    name       "GAUGE.field" of the model's record, or the name of one of its numbers
    sigma      (n,) standard deviations; `estimated` where they come from the record itself
    clock      index of the file whose shift and scale it shares; -1 for numbers, which have neither
    """

    label: str
    name: str
    unit: str
    time: np.ndarray
    values: np.ndarray
    sigma: np.ndarray
    clock: int = -1
    estimated: bool = False

    def model(self, answer: Mapping, shift: float = 0.0, scale: float = 0.0) -> np.ndarray:
        """What the model has at the target's times; not-a-number where it has nothing."""
        if self.clock < 0:
            return np.array([float(answer["numbers"].get(self.name, np.nan))])
        times, values = answer["records"][self.name]
        return (1.0 + scale) * np.interp(self.time - shift, times, values)

    def residuals(self, answer: Mapping, shift: float = 0.0, scale: float = 0.0) -> np.ndarray:
        """`beside` the data; where the model has nothing, as if it said zero."""
        return self.beside(np.nan_to_num(self.model(answer, shift, scale)))

    def beside(self, model: np.ndarray) -> np.ndarray:
        """(model - data) / sigma."""
        return (model - self.values) / self.sigma


def read_targets(texts: Sequence[str], run, *, gauge: str | None = None, sigma: str | None = None,
                 windows: Sequence[str] = ()) -> tuple[list[Target], list[str]]:
    """The targets that texts name, and notes on what was taken for what.

    texts     files of measured records, or numbers such as "free surface.arrival = 0.63 +- 0.01 us"
    run       a run of the model (`MemoryRun`), which says what gauges and numbers there are
    gauge     which one the columns that name none belong to
    sigma     standard deviation of records that bring none
    windows   "LOW..HIGH UNIT" of times that count, for all files, or "FILE = LOW..HIGH UNIT" for one
    Raises `DeckError`, `FileTrouble`.
    """
    found: list[Target] = []
    notes: list[str] = []
    spans = _windows(windows)
    clock = 0
    for text in texts:
        number = _NUMBER.fullmatch(text)
        if number is not None:
            found.append(_measured(number, text, run))
            continue
        of_file = _records(text, run, gauge, sigma, clock, notes)
        found += [_within(target, text, [*spans.get("", []), *spans.get(text, [])], run.summary["time"], notes) for target in of_file]
        clock += 1
    if not found:
        raise refuse("--to", "", "nothing to fit to", "name a file with measured records, such as visar.csv")
    unknown = [name for name in spans if name and name not in texts]
    if unknown:
        raise refuse("--window", unknown[0], "no such file is given with --to", nearest(unknown[0], [t for t in texts if "=" not in t]))
    return found, notes


def _measured(match: re.Match, text: str, run) -> Target:
    """A measured number."""
    from hugoniot.campaign.numbers import numbers_of, unit_of

    name, known = match["name"].strip(), numbers_of(run)
    if name not in known:
        raise refuse("--to", text, f"no result has the name '{printable(name)}'", nearest(name, known))
    unit = unit_of(name)
    value, spread = match["value"].strip(), match["sigma"].strip()
    named = re.search(r"[A-Za-zµ].*$", spread)
    if named and not re.search(r"[A-Za-zµ]", value.replace("e", "").replace("E", "")):
        value = f"{value} {named.group(0)}"
    try:
        numbers = [parse(_plain(part), unit) for part in (value, spread)]
    except UnitError as error:
        raise refuse("--to", text, error.message, error.hint) from None
    if not numbers[1] > 0.0:
        raise refuse("--to", text, "the uncertainty must be above 0", "write it like 0.63 +- 0.01 us")
    return Target(name, name, unit, np.zeros(1), np.array([numbers[0]]), np.array([numbers[1]]))


def _plain(text: str) -> float | str:
    try:
        return float(text)
    except ValueError:
        return text


def _records(path: str, run, gauge, sigma, clock: int, notes: list[str]) -> list[Target]:
    """The columns of one file with the gauges they belong to."""
    columns = read_table(path)
    spreads = {_base(c): c for c in columns if _base(c) is not None}
    mine = [Record(name, field, describe(field)[0], np.empty(0), np.empty(0)) for name in run.gauge_names()
            for field, values in run.arrays("gauges").items() if values.ndim == 2]
    if gauge is not None and gauge not in run.gauge_names():
        raise refuse("--gauge", gauge, "no such gauge in the deck", nearest(gauge, run.gauge_names()))
    choice, found = Choice(run, gauge, path, notes), []
    for column in columns:
        if _base(column) is not None:
            continue
        own = choice.counterpart(column, mine)
        name = f"{column.gauge} {column.field}".strip()
        if own is None:
            gauges, fields = (listed(sorted({getattr(r, of) for r in mine}), MOST_SHOWN) for of in ("gauge", "field"))
            raise DeckError.single(path, 1, name, "no gauge of the deck records this", f"gauges: {gauges}; each records: {fields}")
        values, estimated = _sigma(path, column, spreads.get(name), sigma)
        found.append(Target(f"{pathlib.Path(path).name}: {name}", f"{own.gauge}.{own.field}", own.unit, column.time, column.values, values,
                            clock, estimated))
    return found


def _base(column: Record) -> str | None:
    """The column whose standard deviation this one is, or None."""
    name = f"{column.gauge} {column.field}".strip()
    return name[:-6].strip() if name.endswith(" sigma") else None


def _sigma(path: str, column: Record, spread: Record | None, given: str | None) -> tuple[np.ndarray, bool]:
    """(standard deviations (n,), whether they were estimated)."""
    where = f"{path}: {column.field} sigma"
    try:
        if spread is not None:
            values = spread.values * convert(1.0, spread.unit or "1", column.unit or "1")
        elif given is not None:
            where = "--sigma"
            values = np.full(len(column.values), parse(_plain(given), column.unit or "1"))
        else:
            return np.full(len(column.values), noise_of(column.values)), True
    except UnitError as error:
        raise refuse(where, "", error.message, error.hint) from None
    if not np.all(values > 0.0):
        raise refuse(where, "", "an uncertainty must be above 0", "give a standard deviation such as 5 m/s")
    return values, False


def noise_of(values: np.ndarray) -> float:
    """Standard deviation of independent noise upon a record, at least LEAST_SIGMA of its largest value."""
    second = np.diff(np.asarray(values, dtype=float), 2)
    noise = _MEDIAN * float(np.median(np.abs(second))) / np.sqrt(6.0) if second.size else 0.0
    return max(noise, LEAST_SIGMA * float(np.max(np.abs(values), initial=0.0)), 1e-300)


def _windows(texts: Sequence[str]) -> dict[str, list[tuple[float, float]]]:
    found: dict[str, list[tuple[float, float]]] = {}
    for text in texts:
        name, _, body = text.rpartition("=")
        low, dots, high = (part.strip() for part in body.partition(".."))
        named = re.search(r"[A-Za-zµ].*$", high)
        low = f"{low} {named.group(0)}" if named and not re.search(r"[A-Za-zµ]\s*$", low) else low
        if not dots:
            raise refuse("--window", text, "not a range of times", 'write it like "0.5..2 us"')
        try:
            ends = parse(_plain(low), "s"), parse(_plain(high), "s")
        except UnitError as error:
            raise refuse("--window", text, error.message, error.hint) from None
        if not ends[0] < ends[1]:
            raise refuse("--window", text, "not a range of times", 'write it like "0.5..2 us"')
        found.setdefault(name.strip(), []).append(ends)
    return found


def _within(target: Target, path: str, spans: list[tuple[float, float]], end: float, notes: list[str]) -> Target:
    """The part of a record that lies in one of the windows and before the end of the model's run."""
    kept = np.zeros(len(target.time), dtype=bool)
    for low, high in spans or [(-np.inf, np.inf)]:
        kept |= (target.time >= low) & (target.time <= high)
    late = kept & (target.time > end)
    if late.any():
        notes.append(f"{target.label}: {int(late.sum())} of {int(kept.sum())} points are later than the deck's stop_time, and left out")
    kept &= ~late
    if kept.sum() < 3:
        raise DeckError.single(path, None, target.label.rpartition(": ")[2],
                               "fewer than 3 of its points lie in the window and before the deck's stop_time",
                               "give another --window, or a later stop_time")
    return replace(target, time=target.time[kept], values=target.values[kept], sigma=target.sigma[kept])
