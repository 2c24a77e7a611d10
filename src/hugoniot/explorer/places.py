"""What the explorer was started with: runs, sweeps, fits, decks and materials, each known to the page by a number, never by a path."""

import threading
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple

from hugoniot.errors import DeckError, FileTrouble
from hugoniot.explorer.subjects import admit, entry_of
from hugoniot.files import read_text, toml_tables

CASES, FIT = "cases.csv", "fit.json"


class Place(NamedTuple):
    """A run folder, a table of cases, the folder of a fit or a deck: its path, and what the page calls it.

    typed   what to call it in a command, from the folder in which the explorer was started
    """

    path: Path
    name: str
    typed: str = ""


@dataclass
class Places:
    """Everything the page may read. `work` is the folder in which runs started from the page are made, None where none may be."""

    runs: list[Place] = field(default_factory=list)
    sweeps: list[Place] = field(default_factory=list)
    fits: list[Place] = field(default_factory=list)
    decks: list[Place] = field(default_factory=list)
    materials: list[str] = field(default_factory=list)
    work: Path | None = None
    _lock: threading.Lock = field(default_factory=threading.Lock)

    def add_run(self, path: Path, name: str = "", typed: str = "") -> int:
        """The number of a run folder, which is added unless it is there, under its own name or a given one."""
        path = path.resolve()
        with self._lock:
            known = [place.path for place in self.runs]
            if path not in known:
                self.runs.append(Place(path, name or path.name, typed or as_typed(path)))
                return len(known)
            return known.index(path)

    def run(self, number: int) -> Place:
        """A run by its number; `FileTrouble` for any other."""
        return _numbered(self.runs, number, "run")

    def sweep(self, number: int) -> Place:
        """A table of cases by its number; `FileTrouble` for any other."""
        return _numbered(self.sweeps, number, "sweep")

    def fit(self, number: int) -> Place:
        """The folder of a fit by its number; `FileTrouble` for any other."""
        return _numbered(self.fits, number, "fit")

    def deck(self, number: int) -> Place:
        """A deck by its number; `FileTrouble` for any other."""
        return _numbered(self.decks, number, "deck")


def as_typed(path: Path) -> str:
    """A path as the command line takes it here: from this folder on where it lies below, whole elsewhere."""
    here = Path.cwd()
    return str(path.relative_to(here)) if path.is_relative_to(here) else str(path)


def _numbered(places: list[Place], number: int, word: str) -> Place:
    if not 0 <= number < len(places):
        raise FileTrouble(f"no {word} {number} is open")
    return places[number]


def places_of(arguments: list[str], work: Path | None = None) -> Places:
    """Sort the arguments of the command: run folders, folders with cases.csv or tables, fits, decks, materials by name or file.

    Raises `FileTrouble` for a path that holds none of these, `DeckError` for an unknown material.
    """
    found = Places(work=work.resolve() if work is not None else None)
    for text in arguments:
        path = Path(text)
        if path.is_dir():
            _add_folder(found, path)
        elif path.suffix.lower() == ".csv" and path.is_file():
            found.sweeps.append(Place(path.resolve(), path.name, str(path)))
        elif path.suffix.lower() == ".toml" and path.is_file() and _only_materials(path):
            found.materials += admit(path)
        elif path.suffix.lower() == ".toml" and path.is_file():
            found.decks.append(Place(path.resolve(), path.name, str(path)))
        elif path.suffix.lower() in (".toml", ".csv", ".run") or "/" in text:
            raise FileTrouble(f"{path}: there is no such file or folder")
        else:
            found.materials.append(entry_of(text).name)
    return found


def _only_materials(path: Path) -> bool:
    """Whether a file holds the tables of materials and nothing that makes a deck; a file that cannot be read counts as a deck."""
    try:
        tables = toml_tables(read_text(path))
    except (OSError, ValueError):
        return False
    return bool({"eos", "material"} & set(tables)) and not {"region", "block", "solver", "geometry", "stop_time"} & set(tables)


def _add_folder(found: Places, path: Path) -> None:
    inner = [path / name for name in ("result.h5", "deck.toml", "run.log") if (path / name).is_file()]
    if (path / CASES).is_file():
        found.sweeps.append(Place((path / CASES).resolve(), path.resolve().name, str(path)))
    elif (path / FIT).is_file():
        found.fits.append(Place(path.resolve(), path.resolve().name, str(path)))
    elif inner:
        found.add_run(path, typed=str(path))
    else:
        below = sorted(folder for folder in path.iterdir() if folder.is_dir() and (folder / "deck.toml").is_file())
        if not below:
            raise FileTrouble(f"{path}: neither a run folder nor a folder of runs, and no {CASES} or {FIT} in it")
        for folder in below:
            found.add_run(folder, typed=str(folder))


def as_command(error: Exception) -> list[str]:
    """The messages of an error, as the command line prints them."""
    return [*map(str, error.problems), *([error.count] if error.more else [])] if isinstance(error, DeckError) else [str(error)]
