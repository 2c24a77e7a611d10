"""The common problems `hugoniot init` writes decks for: commented TOML files kept with the package."""

from importlib.resources import files
from typing import NamedTuple

from hugoniot.errors import DeckError
from hugoniot.materials.collect import nearest, printable


class Entry(NamedTuple):
    """A problem of the catalogue: the name to ask for, and the first comment line of its deck."""

    name: str
    summary: str


def _folder():
    return files("hugoniot.problem") / "templates"


def problems() -> list[Entry]:
    """Every problem, by name."""
    found = [Entry(item.name.removesuffix(".toml"), item.read_text(encoding="utf-8").splitlines()[0].lstrip("# "))
             for item in _folder().iterdir() if item.name.endswith(".toml")]
    return sorted(found)


def deck_text(name: str) -> str:
    """The deck of a problem. Raises `DeckError` for an unknown name."""
    known = [entry.name for entry in problems()]
    if name not in known:
        raise DeckError.single("init", None, "problem", f"unknown problem '{printable(name)}'", nearest(name, known))
    return (_folder() / f"{name}.toml").read_text(encoding="utf-8")
