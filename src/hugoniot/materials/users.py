"""Users' own materials: TOML files beside the deck or in a folder, in the library's schema, shadowing nothing silently.

A file holds either one material, named as the file (`my_alloy.toml` with `[eos]`, `[strength]`, ...), or tables `[material.NAME.eos]`
as a deck does. A name that another file or the library already has is an error: a deck must mean one thing.
"""

import re
from collections.abc import Iterable
from pathlib import Path

from hugoniot.errors import DeckError, DeckProblem, FileTrouble
from hugoniot.files import read_text
from hugoniot.materials import library
from hugoniot.materials.collect import Collector
from hugoniot.materials.entry import Entry, read_entry, read_file
from hugoniot.materials.material import Material
from hugoniot.materials.read import base_of, with_named_laws
from hugoniot.materials.search import spelling

_FAMILIES = ("eos", "strength", "fracture", "burn", "base", "unreacted")


def read_materials(path: str | Path) -> dict[str, Entry]:
    """The materials of one file, by name; DeckError with every problem of the file."""
    path = Path(path)
    tables = read_file(path)
    if "material" in tables:
        named = tables["material"]
    elif any(family in tables for family in _FAMILIES):
        named = {path.stem: tables}
    else:
        raise DeckError.single(path, None, "material", "the file describes no material",
                               "write [material.NAME.eos], or [eos] for one material")
    if not isinstance(named, dict) or not named or not all(isinstance(t, dict) for t in named.values()):
        raise DeckError.single(path, None, "material", "a material must be a table", "write [material.NAME.eos]")
    collector, found = Collector([], str(path), _line_finder(read_text(path), "material" in tables)), {}
    for name, table in named.items():
        base = base_of(table, collector, ("material", name))
        found[name] = read_entry(name, with_named_laws(table, base, collector, ("material", name)), collector, base)
    if collector.findings:
        raise collector.error()
    return found


def user_materials(places: Iterable[str | Path], beside: Iterable[str] = ()) -> dict[str, Entry]:
    """The materials of files and folders, by name.

    places   files, or folders whose *.toml files that describe materials are read
    beside   names the deck itself defines: a clash with them is an error too
    Raises DeckError for every clash, with the library (any spelling or alias) or between files; FileTrouble for a place that is not there.
    """
    taken = {spelling(name): "the deck" for name in beside}
    problems: list[DeckProblem] = []
    found: dict[str, Entry] = {}
    for file in _files(places):
        for name, entry in read_materials(file).items():
            other = taken.get(spelling(name)) or _in_library(name)
            if other:
                problems.append(DeckProblem(str(file), None, f"material.{name}", f"the name is taken by {other}",
                                            f"choose another name, such as '{name}_mine'"))
            taken[spelling(name)] = str(file)
            found[name] = entry
    if problems:
        raise DeckError(problems)
    return found


def find(name: str, users: dict[str, Entry]) -> Entry:
    """A user's material, or the library's; `library.UnknownMaterial` with the nearest names of both."""
    mine = {spelling(n): n for n in users}
    if spelling(name) in mine:
        return users[mine[spelling(name)]]
    return library.entry(name, also=mine)


def for_deck(wanted: Iterable[str], defined: Iterable[str], places: Iterable[str | Path] = (),
             beside: Path | None = None) -> dict[str, Material]:
    """The users' own materials a deck asks for, under the names it uses.

    wanted    names the deck's regions use
    defined   names the deck has tables for
    places    files and folders given by an option: every material in them must be free of clashes, used or not
    beside    folder of the deck: `NAME.toml` there is read when the deck asks for NAME
    """
    defined = list(defined)
    own = user_materials(places, defined)
    found: dict[str, Material] = {}
    for name in wanted:
        if name in defined:
            continue
        match = next((n for n in own if spelling(n) == spelling(name)), None)
        if match is not None:
            found[name] = own[match].material
        elif (file := _file_beside(beside, name)) is not None:
            near = user_materials([file], [*defined, *own])
            if name in near:
                found[name] = near[name].material
    return found


def _file_beside(folder: Path | None, name: str) -> Path | None:
    """`NAME.toml` in the folder, if it is there and describes materials; a name is never a path."""
    if folder is None or Path(name).name != name or not name.isprintable() or len(name) > 60:
        return None
    file = folder / f"{name}.toml"
    return file if file.is_file() and _describes_materials(file) else None


def _in_library(name: str) -> str:
    known = library.curated_name(name)
    return f"the library's {known}" if known else ""


def _files(places: Iterable[str | Path]) -> list[Path]:
    files: list[Path] = []
    for place in map(Path, places):
        if place.is_dir():
            files += [f for f in sorted(place.glob("*.toml")) if _describes_materials(f)]
        elif place.is_file():
            files.append(place)
        else:
            raise FileTrouble(f"no file or folder of materials at {place}")
    return list(dict.fromkeys(files))


def _describes_materials(path: Path) -> bool:
    """Whether a file of a folder is a material file: decks, which have regions, lie in the same folders."""
    tables = read_file(path)
    return not {"region", "geometry", "stop_time"} & set(tables) and ("material" in tables or any(f in tables for f in _FAMILIES))


def _line_finder(text: str, several: bool):
    """Line of a key path in a TOML text, by its headings; None where the text writes it another way."""
    lines: dict[tuple[str, ...], int] = {}
    heading: tuple[str, ...] = ()
    for number, line in enumerate(text.splitlines(), 1):
        if match := re.fullmatch(r"\s*\[+([^\[\]]+)\]+\s*(#.*)?", line):
            heading = tuple(part.strip().strip("\"'") for part in match.group(1).split("."))
            lines.setdefault(heading, number)
        elif match := re.match(r"\s*([A-Za-z0-9_\"'-]+)\s*=", line):
            lines.setdefault((*heading, match.group(1).strip("\"'")), number)

    def line_of(path: tuple) -> int | None:
        key = tuple(str(part) for part in path)
        key = key if several else key[2:]
        while key:
            if key in lines:
                return lines[key]
            key = key[:-1]
        return None

    return line_of
