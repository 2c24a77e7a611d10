"""The library's data files: tables of rows, each row a set of constants with one provenance.

A table is a CSV file with two heading lines, names and SI units (`text` for words). Every row has an `id`, unique in the whole
library and starting with the letter of its table, and says where its numbers come from:

    source    bibliographic origin as the public file states it
    via       the public file the numbers were read in (repository@commit:path)
    status    verified (read there, units converted) | corrected (a slip of that file was repaired, see note)
              | derived (computed by the package) | recalled (from no file, not checked against the printed source)
    note      remarks; what follows DOUBT: or DISAGREES: to the end of a note is shown wherever the row is used, or where the note says
              "doubted: NAME and NAME;", wherever the row or one of these constants is

Nothing here imports more than the standard library: a material is shown in milliseconds.
"""

import csv
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

from hugoniot.materials.material import Source

DATA = Path(__file__).parent / "library" / "data"
STATUSES = ("verified", "corrected", "derived", "recalled")
UNVERIFIED = "not checked against the printed source"
TABLES = {
    "U": "us_up", "S": "strength", "J": "jwl", "B": "jwlb", "G": "ignition_growth", "T": "tillotson", "P": "porous", "W": "ptw",
    "V": "gurney", "A": "argon", "N": "gases", "R": "pop_plot", "M": "compression", "O": "windows",
}
_PROVENANCE = ("id", "material", "source", "via", "status", "note")
_OF_STATES = ("up_min", "up_max", "us_deviation")
_CORRECTED = re.compile(r"corrected: (\w+(?: and \w+)*)")
_DOUBTED = re.compile(r"\bdoubted: (\w+(?: and \w+)*);")
_ASSUMED = re.compile(r"\brho0:?(?: \d+)? assumed")
_CELL = re.compile(r"([A-Z]\d{3})\.([a-z][a-z0-9_]*)")


@dataclass(frozen=True)
class Row:
    """One row of a table: `values` holds numbers in SI and words (`form`, `model`, ...); empty cells are absent."""

    table: str
    id: str
    material: str
    values: Mapping[str, Any]
    units: Mapping[str, str]
    source: str
    via: str
    status: str
    note: str

    def __getitem__(self, name: str) -> Any:
        return self.values[name]

    def get(self, name: str, default: Any = None) -> Any:
        return self.values.get(name, default)

    def __contains__(self, name: str) -> bool:
        return name in self.values

    def constant(self, name: str, quantity: str = "") -> Source:
        """One constant of the row with its provenance; `quantity` is its name in the material."""
        source, via, status = self.source, self.via, self.status
        if name.startswith("recorded_") and status != "recalled":
            status = "derived"
        elif name == "rho0" and _ASSUMED.search(self.note):
            source, via, status = "density assumed by hugoniot, because the public file does not give that of this set", "", "derived"
        elif name in _OF_STATES and (found := self.range_from()):
            source, via, status = found, "us_up_points.csv" if "states" in self else "", "derived"
        elif status == "corrected" and (said := _CORRECTED.match(self.note)) and name not in said.group(1).split(" and "):
            status = "verified"      # of a row whose note names what was corrected, the other constants stand as in the file
        found = self._found(name) if status == "derived" else ""
        if name.startswith("recorded_") and status == "recalled":
            found = f"computed from constants {UNVERIFIED}"
        return Source(quantity or name, self.values[name], self.units[name], source, via, status,
                      "; ".join(t for t in (f"row {self.id}" + (f": {found}" if found else ""), self._note_of(name)) if t))

    def _found(self, name: str) -> str:
        """How a derived number of a Us-up row or of a calibrated rate was found, in words; empty where its source or its name says it."""
        if self.table == "ignition_growth":
            return self._calibrated(name)
        if self.table != "us_up":
            return "assumed" if name == "rho0" and _ASSUMED.search(self.note) else ""
        if name in _OF_STATES:
            return "highest of the states compared" if name == "up_max" and "states" in self else ""
        if name == "rho0":
            another = re.search(r"\brow U\d{3}", self.via)
            return f"taken from {another.group()}" if another else "mean of the measured states"
        return "fitted by hugoniot"

    def _calibrated(self, name: str) -> str:
        """The note of a set that `hugoniot fit-rate` made names the constants that were adjusted; the rest is that of rows it names."""
        adjusted = re.match(r"(\w+) and (\w+) adjusted", self.note)
        if adjusted and name in [{"g1": "growth1", "g2": "growth2"}.get(n, n) for n in adjusted.groups()]:
            return "calibrated by hugoniot"
        of_states = name in ("rho0", "e0") or name.startswith(("unreacted_", "products_"))
        for identity in re.findall(r"\bG\d{3}\b", self.via if of_states else f"{self.note} {self.via}"):
            another = row(identity)
            if another.get(name) == self[name]:
                return f"taken from row {identity}" + (f" ({UNVERIFIED})" if another.status == "recalled" else "")
        return "set by hugoniot"

    def range_from(self) -> str:
        """Where the range of a Us-up row comes from if not from its own source: measured states, or what its note says; else empty."""
        if "states" in self:
            return f"range of the {self['states']:g} measured states of the library with which row {self.id} is compared"
        said = re.search(r"\brange: (the (?:particle velocity|range)[^;]*)", self.note)
        return said.group(1) if said else ""

    def constants(self) -> Iterator[Source]:
        """Every number of the row with its provenance."""
        return (self.constant(name) for name, value in self.values.items() if not isinstance(value, str))

    @property
    def marks(self) -> tuple[str, ...]:
        """What must be seen wherever the row is used: sentences, empty for a row without blemish."""
        return self.marks_of()

    def marks_of(self, constant: str = "") -> tuple[str, ...]:
        """The same of one constant, or of all."""
        found = []
        if self.status == "recalled":
            found.append(f"{self.title} is {UNVERIFIED} ({self.source})")
        if self.doubt and self._doubts(constant):
            kind = "is doubtful" if "DOUBT:" in self.note else "disagrees with other sources"
            found.append(f"{self.title} {kind}: {self.doubt}")
        return tuple(found)

    def _doubts(self, constant: str) -> bool:
        """Whether the doubt of the row is of a constant, or of any (no name)."""
        named = _DOUBTED.search(self.note)
        return not (constant and named) or constant in named[1].split(" and ")

    def _note_of(self, constant: str) -> str:
        """The note without a doubt that is of other constants."""
        return self.note if self._doubts(constant) else _DOUBTED.sub("", self.note.partition("DOUBT:")[0]).rstrip("; ")

    @property
    def title(self) -> str:
        """What messages call the row."""
        return f"row {self.id} ({self.material or self.get('quantity', '')})"

    @property
    def doubt(self) -> str:
        """What is doubtful about the row, or what other sources say, in words; empty for most rows."""
        said = re.search(r"\b(?:DOUBT|DISAGREES): (.*)", self.note)
        return said.group(1) if said else ""


@cache
def table(name: str) -> Mapping[str, Row]:
    """Every row of a table by its id, in file order."""
    return {row.id: row for row in _read(name)}


def _read(name: str) -> Iterator[Row]:
    with open(DATA / f"{name}.csv", newline="", encoding="utf-8") as file:
        reader = csv.reader(file)
        names, kinds = next(reader), next(reader)
        units = {n: k for n, k in zip(names, kinds, strict=True) if n not in _PROVENANCE}
        for cells in reader:
            raw = dict(zip(names, cells, strict=True))
            values = {n: _value(raw[n], units[n]) for n in units if raw[n] != ""}
            if "unit" in raw:  # a table of single constants: each row has its own unit
                units = {**units, "value": raw["unit"].replace("-", "1")}
            yield Row(name, raw.get("id", ""), raw.get("material", ""), values, units, *(raw.get(k, "") for k in _PROVENANCE[2:]))


def _value(text: str, unit: str) -> float | str:
    """A number, unless the column holds words."""
    return text if unit == "text" else float(text)


def row(identity: str) -> Row:
    """The row of that id; KeyError for an unknown one."""
    return table(TABLES[identity[:1]])[identity]


def is_row(text: Any) -> bool:
    """Whether a text is the id of a row of the library."""
    known = isinstance(text, str) and re.fullmatch(r"[A-Z]\d{3}", text) and text[0] in TABLES
    return bool(known) and text in table(TABLES[text[0]])


def cell(reference: str) -> Source | None:
    """The constant a text like "S088.spall_strength" refers to; None for other text, KeyError for a cell that is empty."""
    match = _CELL.fullmatch(reference)
    if match is None or match.group(1)[0] not in TABLES:
        return None
    return row(match.group(1)).constant(match.group(2))


def all_rows() -> Iterator[Row]:
    """Every row of every table with ids."""
    for name in TABLES.values():
        if (DATA / f"{name}.csv").exists():
            yield from table(name).values()


@cache
def points() -> tuple[Row, ...]:
    """The measured Us-up states (rows without id)."""
    return tuple(_read("us_up_points"))
