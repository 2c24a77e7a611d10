"""Collects what is wrong with a deck or a material file, so that the user hears of everything at once."""

import difflib
import re
from collections.abc import Callable, Iterable
from functools import partial
from pathlib import Path

from hugoniot.errors import DeckError, DeckProblem
from hugoniot.units import UnitError, parse

LineOf = Callable[[tuple], int | None]
Hint = str | Callable[[], str]      # a function where finding the words takes long: those of a problem that is only counted are not needed
_NAMED = ("region", "block", "gauge", "interface")
MOST = 50           # problems worth listing: whoever has more reads the first ones
COUNTED = 20_000    # problems after which the reading of a hopeless file ends
_CONTROLS = re.compile(r"[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f]")      # but for tabs and ends of lines
_MOST_KNOWN = 400   # names worth comparing with one that is not known
_ALIKE = 0.7      # of `difflib`: "body" is no slip of the finger for "boundary" (0.67)


def printable(text, limit: int = 60) -> str:
    """A user's text as a message may show it: short, one line, control characters escaped."""
    text = str(text)
    text = text if len(text) <= limit else text[: limit - 3] + "..."
    return "".join(c if c.isprintable() else f"\\u{ord(c):04x}" for c in text)


def listed(names: Iterable, most: int = 40, limit: int = 60) -> str:
    """The names with commas between them, and how many more there are than `most`."""
    names = [printable(name, limit) for name in names]
    return ", ".join(names[:most]) + (f" and {len(names) - most} more" if len(names) > most else "")


def nearest(name: str, known: Iterable[str], otherwise: str = "") -> str:
    """The hint `did you mean '...'?`, or the whole (short) list where nothing is near."""
    known = sorted(known)
    if len(known) > _MOST_KNOWN:
        alike = [word for word in known if abs(len(word) - len(str(name))) <= 2][:_MOST_KNOWN]
        near = difflib.get_close_matches(str(name)[:100], alike, 1, _ALIKE)
        return f"did you mean '{printable(near[0])}'?" if near else otherwise or f"one of {len(known)} names"
    near = difflib.get_close_matches(str(name)[:100], known, 1, _ALIKE)
    if near:
        return f"did you mean '{printable(near[0])}'?"
    if otherwise or not known:
        return otherwise
    return f"known: {listed(known, limit=40)}"


def explained(key: str, meaning: str) -> str:
    """What a key is, as the end of a message: in brackets, because after a semicolon it would read as advice."""
    return f" ({key}: {meaning})" if meaning else ""


def shown_value(value) -> str:
    """A value of the wrong kind, as a user of TOML knows it."""
    if isinstance(value, bool):
        return str(value).lower()
    kinds = {dict: "a table", list: "an array"}
    return kinds.get(type(value)) or (f"'{printable(value, 40)}'" if isinstance(value, str) else printable(value, 40))


class Collector:
    """Adds a `DeckProblem` per finding; a path is the tuple of keys and array indices from the root of the file.

    Problems beyond the first `MOST` are counted only (`more`). The reading ends with a `DeckError` at number `COUNTED`, so that the work on
    a hopeless file is bounded.

    raw      the parsed file, from which array elements get the name shown in a message (`region.flyer.from`)
    folder   where data files that this one names are looked for; by default the folder of `file`
    warnings what a reader of data files found to report of a material; whoever builds the material takes them

    `findings` counts every finding, one that is worded like an earlier one too (two blocks of one name lack the same key): whoever wants to
    know whether a part of the file was found sound compares it, as `problems` holds each wording once.
    """

    def __init__(self, problems: list[DeckProblem], file: str, line_of: LineOf, raw: dict | None = None, folder: Path | None = None):
        self.problems, self.file, self.line_of, self.raw = problems, file, line_of, raw or {}
        self.folder = Path(file).parent if folder is None else folder
        self.findings = len(problems)
        self.more = 0
        self.warnings: list[str] = []
        self._told = {(p.line, p.key, p.message) for p in problems}
        self._keys = {p.key for p in problems}

    def add(self, path: tuple, message: str, hint: Hint = "") -> None:
        self.findings += 1
        place = self.line_of(path), self.key(path)
        if (*place, message) not in self._told:
            self._told.add((*place, message))
            self._keys.add(place[1])
            if self.full:
                self.more += 1
            else:
                self.problems.append(DeckProblem(self.file, *place, message, hint() if callable(hint) else hint))
        if len(self._told) >= COUNTED:
            raise self.error(at_least=True)

    def count(self, number: int) -> None:
        """As `add` of a number of problems that are found already, and would not be listed."""
        self.findings += number
        self.more += number

    def take(self, error: DeckError) -> None:
        """Add the problems of another file that this one names."""
        new = [problem for problem in error.problems if problem not in self.problems]
        room = MOST - len(self.problems)
        self.problems += new[:room]
        self.more += error.more + len(new[room:])
        self.findings += error.more + len(error.problems)

    @property
    def full(self) -> bool:
        """Whether further problems are only counted: whoever adds them need not look for words."""
        return len(self.problems) >= MOST

    def error(self, at_least: bool = False) -> DeckError:
        """The error that tells of everything found, in the order of the lines; `at_least` as of `DeckError`."""
        return DeckError(sorted(self.problems, key=lambda p: p.line or 0), self.more, at_least)

    def reported(self, path: tuple) -> bool:
        """Whether something is reported of this key already."""
        return self.key(path) in self._keys

    def texts(self, path: tuple, value) -> None:
        """Report every text in a value, tables and arrays searched, that no terminal and no file of results could hold."""
        if isinstance(value, (dict, list)):
            for part, inner in value.items() if isinstance(value, dict) else enumerate(value):
                self.texts((*path, part), inner)
        elif isinstance(value, str) and _CONTROLS.search(value):
            self.add(path, f"'{printable(value)}' contains control characters", "write it without")

    def unknown(self, path: tuple, known: Iterable[str]) -> None:
        """Report a key that nobody reads."""
        self.add(path, "unknown key", partial(nearest, path[-1], known))

    def quantity(self, path: tuple, value, unit: str) -> float | None:
        """The SI value of a quantity, or None after reporting why not."""
        try:
            return parse(value, unit)
        except UnitError as error:
            self.add(path, error.message, error.hint)
            return None

    def key(self, path: tuple) -> str:
        """`region.flyer.from` for ("region", 0, "from"); elements without a name are counted from 1."""
        words: list[str] = []
        here = self.raw
        for part in path:
            try:
                here = here[part]
            except (KeyError, IndexError, TypeError):
                here = None
            if isinstance(part, int):
                name = here.get("name") if isinstance(here, dict) and words and words[0] in _NAMED else None
                if isinstance(name, str) and name.strip():
                    words.append(printable(name, 40))
                elif words:
                    words[-1] += f"[{part + 1}]"
            else:
                words.append(printable(part, 40))
        return ".".join(words) or "deck"
