"""The common problems `hugoniot init` writes decks for: commented TOML files kept with the package."""

from pathlib import Path
from typing import NamedTuple

from hugoniot.errors import DeckError
from hugoniot.materials.collect import nearest, printable

TEMPLATES = Path(__file__).parent / "templates"


class Entry(NamedTuple):
    """A problem of the catalogue: the name to ask for, and the first comment line of its deck."""

    name: str
    summary: str


def problems() -> list[Entry]:
    """Every problem, by name."""
    found = [Entry(item.name.removesuffix(".toml"), item.read_text(encoding="utf-8").splitlines()[0].lstrip("# "))
             for item in TEMPLATES.iterdir() if item.name.endswith(".toml")]
    return sorted(found)


def deck_text(name: str) -> str:
    """The deck of a problem. Raises `DeckError` for an unknown name."""
    known = [entry.name for entry in problems()]
    if name not in known:
        raise DeckError.single("init", None, "problem", f"unknown problem '{printable(name)}'", nearest(name, known))
    return (TEMPLATES / f"{name}.toml").read_text(encoding="utf-8")
