"""What a sweep varies: `KEY = 300..1200 m/s : 10` and its relatives, as text from the command line or from a [sweep] table.

    KEY = LOW..HIGH UNIT : COUNT        equal steps; `: COUNT log` for equal ratios; a sampled design needs no count
    KEY = A, B, C UNIT                  these values; the last unit holds for those without one
    KEY = "al", "cu"                    texts, such as names of materials
    KEY = MEAN +- SIGMA UNIT            normal, for sampled designs
"""

import math
import re
from dataclasses import dataclass
from typing import Any

from scipy.special import ndtri

from hugoniot.errors import DeckError
from hugoniot.materials.collect import printable
from hugoniot.problem.arithmetic import Number
from hugoniot.units import UnitError, convert, parse, powers_of, si_name

EXAMPLE = 'write it like "region.flyer.velocity = 300..1200 m/s : 10"'
_ENDS = re.compile(r"\s*(?P<low>[^\s].*?)\s*\.\.\s*(?P<high>.+?)\s*")
_WHOLE = re.compile(r"[+-]?\d+")
MOST_DIGITS = 12      # of a count: more is refused before it is turned into a number


@dataclass(frozen=True)
class Variable:
    """One thing that is varied.

    name     a key of the deck such as region.flyer.velocity, or a name of its own that ties use
    kind     "range", "log", "normal" (low: mean, high: standard deviation) or "values"
    unit     as the user wrote it; "" for bare numbers and texts
    values   of "values": what the deck is given
    count    of a range: how many values, None where none was given
    """

    name: str
    kind: str
    unit: str = ""
    low: float = 0.0
    high: float = 0.0
    count: int | None = None
    values: tuple[Any, ...] = ()
    whole: bool = False

    @property
    def si(self) -> str:
        """SI unit of its numbers; "" for texts."""
        return "" if self.texts else si_name(self.unit) if self.unit else "1"

    @property
    def texts(self) -> bool:
        """Whether its values are words, not quantities."""
        return self.kind == "values" and any(isinstance(value, str) and self.unit == "" for value in self.values)

    def at(self, share: float) -> Any:
        """The value at a share in [0, 1] of its range, or below which that share of its distribution lies."""
        if self.kind == "values":
            return self.values[min(int(share * len(self.values)), len(self.values) - 1)]
        if self.kind == "log":
            number = self.low * (self.high / self.low) ** share if share < 1.0 else self.high
        elif self.kind == "normal":
            number = self.low + self.high * float(ndtri(min(max(share, 1e-12), 1.0 - 1e-12)))
        else:
            number = self.low + share * (self.high - self.low) if share < 1.0 else self.high
        return self.given(number)

    def across(self, share: float) -> Any:
        """The same, but a normal distribution as the range with its standard deviation: sqrt(3) of them to either side of the mean."""
        if self.kind != "normal":
            return self.at(share)
        return self.given(self.low + self.high * math.sqrt(3.0) * (2.0 * share - 1.0))

    def step(self, k: int) -> Any:
        """The k-th of its values in a grid."""
        if self.kind == "values":
            return self.values[k]
        return self.at(k / (self.count - 1) if self.count and self.count > 1 else 0.0)

    def given(self, number: float) -> Any:
        """What the deck is given for a number in the unit of this variable."""
        if self.unit:
            return f"{float(number)!r} {self.unit}"
        return int(number) if self.whole and float(number).is_integer() else float(number)

    def number(self, value: Any) -> float:
        """The SI number of one of its values; not-a-number for a text."""
        if self.texts:
            return math.nan
        return parse(value, self.si)

    def known(self, value: Any) -> Number:
        """The same for an expression."""
        if not self.unit:
            return Number(float(value))
        return Number(*powers_of(value))


def refuse(where: str, text: str, message: str, hint: str = EXAMPLE) -> DeckError:
    """The error for something that stands at `where` (an option, or a key of a sweep file)."""
    file, _, key = where.rpartition(": ")
    return DeckError.single(file or "command line", None, f"{key} '{printable(text, 60)}'" if text else key, message, hint)


def read_variable(text: str, where: str = "--vary") -> Variable:
    """The variable that a text describes. Raises `DeckError` that says what is wrong with it."""
    name, equals, rest = (part.strip() for part in text.partition("="))
    name = name.replace('"', "")        # a key may be quoted as in TOML: material."LX-17 reactive".burn.g1
    if not equals or not name or not rest:
        raise refuse(where, text, "expected KEY = VALUES")
    try:
        if "+-" in rest or "±" in rest:
            return _normal(name, rest.replace("±", "+-"), where, text)
        return _range(name, rest, where, text) if ".." in rest else _listed(name, rest, where, text)
    except UnitError as error:
        raise refuse(where, text, error.message, error.hint) from None


def _split_unit(text: str) -> tuple[float, str]:
    """(number, unit) of a text such as "300 m/s"; the unit is "" for a bare number."""
    match = re.fullmatch(r"([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d{1,4})?)\s*(\S.*)?", text.strip())
    if match is None:
        raise UnitError(f"'{printable(text, 40)}' is not a quantity", EXAMPLE)
    unit = (match[2] or "").strip()
    number = float(match[1])
    if not math.isfinite(number):
        raise UnitError(f"'{printable(text, 40)}' is too large")
    if unit:
        si_name(unit)
    return number, unit


def _range(name: str, rest: str, where: str, text: str) -> Variable:
    body, colon, steps = rest.partition(":")
    ends = _ENDS.fullmatch(body)
    if ends is None:
        raise refuse(where, text, f"'{printable(body.strip(), 40)}' is not a range LOW..HIGH")
    (low, low_unit), (high, unit) = _split_unit(ends["low"]), _split_unit(ends["high"])
    if low_unit and low_unit != unit:
        low = convert(low, low_unit, unit) if unit else low
        unit = unit or low_unit
    if not low < high:
        raise refuse(where, text, f"an empty range: {low:g} is not below {high:g}", "give the lower value first")
    words = steps.split()
    log = "log" in words
    counts = [word for word in words if word != "log"]
    if colon and (len(counts) > 1 or len(words) - len(counts) > 1 or not all(_WHOLE.fullmatch(word) for word in counts) or not words):
        raise refuse(where, text, f"'{printable(steps.strip(), 30)}' is not a number of values")
    if counts and len(counts[0]) > MOST_DIGITS:
        raise refuse(where, text, f"{printable(counts[0], 30)} values are too many")
    count = int(counts[0]) if counts else None
    if count is not None and count < 2:
        raise refuse(where, text, f"too few values in a range: {count}", "give 2 or more, or a single value without a range")
    if log and not low > 0.0:
        raise refuse(where, text, "logarithmic steps need a range above 0")
    whole = not unit and all(_WHOLE.fullmatch(end.strip()) for end in (ends["low"], ends["high"]))
    return Variable(name, "log" if log else "range", unit, low, high, count, whole=whole)


def _normal(name: str, rest: str, where: str, text: str) -> Variable:
    left, _, right = rest.partition("+-")
    (mean, mean_unit), (sigma, unit) = _split_unit(left), _split_unit(right)
    if mean_unit and mean_unit != unit:
        mean = convert(mean, mean_unit, unit) if unit else mean
        unit = unit or mean_unit
    if not sigma > 0.0:
        raise refuse(where, text, f"the standard deviation is {sigma:g}", "it must be above 0")
    return Variable(name, "normal", unit, mean, sigma)


def _listed(name: str, rest: str, where: str, text: str) -> Variable:
    parts = [part.strip() for part in re.findall(r'"[^"]*"|\'[^\']*\'|[^,]+', rest) if part.strip()]
    quoted = [part[0] in "\"'" for part in parts]
    if not parts:
        raise refuse(where, text, "no values")
    if any(quoted):
        if not all(quoted):
            raise refuse(where, text, "text values and numbers in one list", "put quotes around every value, or around none")
        return Variable(name, "values", values=tuple(part[1:-1] for part in parts))
    found = [_split_unit(part) for part in parts]
    unit = found[-1][1]
    numbers = [convert(number, own, unit) if own and own != unit else number for number, own in found]
    whole = not unit and all(_WHOLE.fullmatch(part) for part in parts)
    shape = Variable(name, "values", unit, whole=whole)
    return Variable(name, "values", unit, values=tuple(shape.given(number) for number in numbers), whole=whole)


def of_column(head: str, cells: list[str], where: str) -> Variable:
    """The variable of one column of a table of cases: `region.flyer.velocity [m/s]` above its values."""
    match = re.fullmatch(r"\s*(.+?)\s*[\[(]([^\[\]()]*)[\])]\s*", head)
    name, unit = (match[1], match[2].strip()) if match else (head.strip(), None)
    numbers = [_number(cell) for cell in cells]
    if unit is None:
        if all(number is None for number in numbers):
            return Variable(name, "values", values=tuple(cell.strip() for cell in cells))
        raise refuse(where, head, "the column has no unit", f"write '{name} [m/s]', or '{name} [1]' for plain numbers")
    bad = next((cell for cell, number in zip(cells, numbers) if number is None), None)
    if bad is not None:
        raise refuse(where, head, f"'{printable(bad.strip(), 40)}' is not a number", "omit the unit for a column of text values")
    unit = "" if unit in ("", "1") else unit
    try:
        shape = Variable(name, "values", unit, whole=all(_WHOLE.fullmatch(cell.strip()) for cell in cells))
        if unit:
            si_name(unit)
    except UnitError as error:
        raise refuse(where, head, error.message, error.hint) from None
    return Variable(name, "values", unit, values=tuple(shape.given(number) for number in numbers if number is not None))


def _number(cell: str) -> float | None:
    try:
        value = float(cell)
    except ValueError:
        return None
    return value if math.isfinite(value) else None
