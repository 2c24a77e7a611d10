"""Reads a deck: TOML text to a frozen `Problem`, with every problem of the text reported at once by file, line, key and hint."""

import os
import tomllib
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from hugoniot.errors import DeckError, FileTrouble
from hugoniot.files import DEEPEST, LONG_KEY, open_regular, toml_trouble
from hugoniot.materials.collect import Collector, listed, nearest, printable
from hugoniot.materials.read import read_material
from hugoniot.materials.users import for_deck
from hugoniot.problem import schema
from hugoniot.problem.lines import line_finder
from hugoniot.problem.solver_kinds import available_solvers, solver_module
from hugoniot.problem.write import to_toml

LARGEST = 20_000_000  # characters: a deck with long tables, not a file given by mistake


@dataclass(frozen=True)
class Deck:
    """A deck that was read and found valid.

    problem    the `Problem` that it describes
    resolved   text of the deck with every default written out, in SI
    warnings   strings that point to likely mistakes
    text       text of the deck as it was read
    name       name of the deck in messages
    """

    problem: Any
    resolved: str
    warnings: tuple[str, ...]
    text: str
    name: str


def read_deck(path: str | Path, overrides: dict[str, Any] | None = None, materials: Sequence[str | Path] = ()) -> Deck:
    """Read and check a deck, and return it as a `Deck`.

    path        the deck, a TOML file
    overrides   keys to change, with dots, and their new values: {"region.flyer.velocity": "800 m/s"}
    materials   files and folders with your own materials; a file NAME.toml beside the deck is found without being listed

    Raises `DeckError` with all problems found, and `FileTrouble` if the file cannot be read.

    >>> deck = read_deck("flyer.toml", {"region.flyer.velocity": "800 m/s"})
    >>> run = hugoniot.run(deck)
    """
    path = Path(path)
    try:
        with os.fdopen(open_regular(path), "rb") as file:
            if os.fstat(file.fileno()).st_size > 4 * LARGEST:   # four bytes a character at the most: a result given by mistake is not read
                raise _too_long(path.name)
            data = file.read(4 * LARGEST + 1)
    except FileTrouble:
        raise
    except OSError as error:
        near = sorted(p.name for p in path.parent.glob("*.toml")) if path.parent.is_dir() else []
        hint = f"; decks here: {listed(near, 5)}" if near else "; hugoniot init writes one"
        raise FileTrouble(f"cannot read {path}: {error.strerror or error}{hint}") from None
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        raise DeckError.single(path.name, line, "deck", "not a UTF-8 text file",
                               "a deck is a TOML file; hugoniot init writes one") from None
    return read_deck_text(text, path.name, overrides, materials, path.parent)


def read_deck_text(text: str, name: str = "deck", overrides: dict[str, Any] | None = None, places: Sequence[str | Path] = (),
                   beside: Path | None = None) -> Deck:
    """Read a deck given as text; `name` is what messages call it. Raises `DeckError` with every problem found.

    places, beside   where users' own materials are looked for: files and folders, and the deck's own folder
    """
    return read_tables(parse_deck(text, name), text, name, overrides, places, beside)


def read_tables(raw: dict, text: str, name: str, overrides: dict[str, Any] | None = None, places: Sequence[str | Path] = (),
                beside: Path | None = None) -> Deck:
    """As `read_deck_text`, for a caller that has parsed the text already (`parse_deck`); the overrides are put into `raw` itself."""
    collector = Collector([], name, line_finder(text), raw, beside)
    changed: list[tuple] = []
    for key, value in (overrides or {}).items():
        _open_library_material(raw, key)
        changed += _override(raw, key, value, collector)
    if changed:
        collector.line_of = partial(_line_unless, changed, collector.line_of)
    kind = _solver_kind(raw, collector)
    if kind is None:
        _add_what_every_solver_refuses(raw, collector)
        raise collector.error()
    module = solver_module(kind)
    model = schema.validate(module.Model, raw, collector)
    materials = {**_materials(raw, collector), **_own_materials(raw, places, beside)}
    collector.texts(("title",), raw.get("title"))
    with np.errstate(all="ignore"):   # a state that no law reaches is told in words
        problem, warnings = module.read(raw, model, materials, collector)
    if collector.problems or problem is None:
        raise collector.error()
    if not problem.title:
        problem = replace(problem, title=printable(Path(name).stem, 200))
    marked = [f"material '{n}': {w}" for n, m in getattr(problem, "materials", {}).items() for w in getattr(m, "warnings", ())]
    return Deck(problem, write_deck(problem, kind), (*warnings, *collector.warnings, *marked), text, name)


def write_deck(problem: Any, kind: str | None = None) -> str:
    """Text of a deck that describes a problem, with every default written out, in SI. Reading it gives an equal problem.

    problem   a `Problem`
    kind      name of the solver (default: that of the problem)
    """
    kind = kind or problem.solver.kind
    return "# Written by hugoniot: every default is written out, every number is SI.\n" + to_toml(solver_module(kind).write(problem))


def _too_long(name: str) -> DeckError:
    return DeckError.single(name, None, "deck", f"a TOML deck cannot have more than {LARGEST:,} characters".replace(",", " "),
                            "is this the right file?")


def parse_deck(text: str, name: str) -> dict:
    """The tables of a deck's text, not looked at yet. Raises `DeckError` where it is not TOML."""
    if len(text) > LARGEST:
        raise _too_long(name)
    long = LONG_KEY.search(text)
    if long is not None:
        line = text.count("\n", 0, long.start()) + 1
        raise DeckError.single(name, line, "deck", f"a key of more than {DEEPEST} parts", "is this the right file?")
    try:
        raw = tomllib.loads(text)
        _check_values(raw, name)
        return raw
    except tomllib.TOMLDecodeError as error:
        line, message, hint = toml_trouble(error, text)
        raise DeckError.single(name, line, "deck", message, hint) from None
    except RecursionError:
        raise DeckError.single(name, None, "deck", "not a deck: arrays nested too deeply") from None
    except ValueError:  # numbers with more digits than the language converts
        raise DeckError.single(name, None, "deck", "not a deck: a whole number has thousands of digits",
                               "is this the right file?") from None


def _check_values(raw: Any, name: str) -> None:
    """Raise `DeckError` for nesting and whole numbers that no deck has: what follows may go down without a limit, and print numbers."""
    waiting: list[tuple[Any, int, str]] = [(raw, 0, "deck")]
    while waiting:
        value, depth, key = waiting.pop()
        if isinstance(value, int) and not -2**63 <= value < 2**63:
            raise DeckError.single(name, None, printable(key), "not a deck: a whole number of more than 64 bits")
        if isinstance(value, (dict, list)):
            if depth > DEEPEST:
                raise DeckError.single(name, None, "deck", "not a deck: tables and arrays nested too deeply")
            inner = value.items() if isinstance(value, dict) else ((key, v) for v in value)
            waiting += [(v, depth + 1, str(k)) for k, v in inner]


def _solver_kind(raw: dict, collector: Collector) -> str | None:
    """The solver the deck asks for; None after reporting that there is none of that name."""
    solver = raw.get("solver", {})
    kind = solver.get("kind", "lagrange1d") if isinstance(solver, dict) else "lagrange1d"
    known = available_solvers()
    if kind not in known:
        shown = printable(kind) if isinstance(kind, str) else "not a string"
        collector.add(("solver", "kind"), f"unknown solver '{shown}'", nearest(shown, known))
        return None
    if _plane(raw) and kind != "lagrange2d":
        message = f"the solver '{kind}' takes [[region]], not [[block]]"
        raise DeckError.single(collector.file, collector.line_of(("block",)), "block", message,
                               'for two dimensions write [solver] with kind = "lagrange2d"')
    return kind


def _plane(raw: dict) -> bool:
    return "block" in raw and "region" not in raw


def _add_what_every_solver_refuses(raw: dict, collector: Collector) -> None:
    """Report what is wrong with a deck whatever its solver: materials, and keys that no solver for its regions or blocks takes."""
    rest = {key: value for key, value in raw.items() if key != "solver"}
    refused = []
    for kind in available_solvers():
        model = solver_module(kind).Model
        if ("block" in schema.keys_of(model)) == _plane(raw):
            own = Collector([], collector.file, collector.line_of, raw, collector.folder)
            schema.validate(model, rest, own)
            refused.append({(p.line, p.key, p.message.partition(" (")[0]): p for p in own.problems if p.key != "solver"})
    alike = [problem for place, problem in refused[0].items() if all(place in other for other in refused[1:])]
    collector.take(DeckError(alike))
    _materials(raw, collector)
    collector.texts(("title",), raw.get("title"))


def _materials(raw: dict, collector: Collector) -> dict:
    tables = raw.get("material", {})
    if not isinstance(tables, dict):
        return {}
    for name in tables:
        if not name.strip() or not name.isprintable() or len(name) > 60:
            collector.add(("material", name), f"'{printable(name)}' is not a valid name", "use up to 60 printable characters")
    return {name: read_material(name, table, collector, ("material", name)) for name, table in tables.items()}


def _own_materials(raw: dict, places: Sequence[str | Path], beside: Path | None) -> dict:
    """Materials from users' own files that the deck's regions or blocks ask for."""
    tables = raw.get("material", {})
    rows = [row for key in ("region", "block") if isinstance(raw.get(key), list) for row in raw[key]]
    names = [row["material"] for row in rows if isinstance(row, dict) and isinstance(row.get("material"), str)]
    return for_deck(dict.fromkeys(names), tables if isinstance(tables, dict) else (), places, beside)


def _open_library_material(raw: dict, key: str) -> None:
    """Where a key changes a material that the deck takes from the library, give the deck a table that begins with it."""
    family, _, rest = key.partition(".") if isinstance(key, str) else ("", "", "")
    rows = [row for part in ("region", "block") if isinstance(raw.get(part), list) for row in raw[part] if isinstance(row, dict)]
    used = [row["material"] for row in rows if isinstance(row.get("material"), str)]
    name = next((name for name in used if rest.startswith(f"{name}.")), None)
    if family == "material" and name is not None and isinstance(raw.setdefault("material", {}), dict):
        raw["material"].setdefault(name, {"base": name})


def _line_unless(changed: list[tuple], line_of: Callable[[tuple], int | None], path: tuple) -> int | None:
    """The line of a key, or None where an override took the place of what the file says there."""
    return None if any(path[: len(key)] == key for key in changed) else line_of(path)


def _override(raw: dict, key: str, value: Any, collector: Collector) -> list[tuple]:
    """Put a value under a dotted key and return the paths that change; elements of [[region]] and the like are chosen by name.

    A table is merged, not replaced.
    """
    *parents, last = key.split(".") if isinstance(key, str) else [""]
    _check_values(value, collector.file)
    if len(parents) > DEEPEST:
        raise DeckError.single(collector.file, None, printable(key), f"a key of more than {DEEPEST} parts")
    here: Any = raw
    path: tuple = ()
    for part in parents:
        if isinstance(here, list):
            at, here = next(((i, e) for i, e in enumerate(here) if isinstance(e, dict) and e.get("name") == part), (0, None))
            path = (*path, at)
        elif isinstance(here, dict):
            here = here.setdefault(part, {})
            path = (*path, part)
        if here is None:
            break
    if not isinstance(here, dict):
        hint = "write it like region.flyer.velocity"
        raise DeckError.single(collector.file, None, printable(key), "the deck has no such key to override", hint)
    if isinstance(value, dict) and isinstance(here.get(last), dict):
        return [(*path, last, *rest) for inner, v in value.items() for rest in _override(here[last], inner, v, collector)]
    here[last] = _plain(value)
    return [(*path, last)]


def _plain(value: Any) -> Any:
    """A value as a deck would hold it: numbers and arrays of numpy become those of the language, tuples arrays of the deck."""
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, dict):
        return {key: _plain(inner) for key, inner in value.items()}
    return [_plain(inner) for inner in value] if isinstance(value, (list, tuple)) else value
