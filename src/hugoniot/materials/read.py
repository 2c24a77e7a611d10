"""A material of a deck or of a file: its tables, and the material of the library that they override by `base = "copper"`.

Every problem is collected, none raised.
"""

from typing import Any

from hugoniot.errors import DeckError, DeckProblem
from hugoniot.materials import library
from hugoniot.materials.build import assembled
from hugoniot.materials.collect import Collector, LineOf, nearest, printable
from hugoniot.materials.material import Material


def build_material(name: str, tables: dict, problems: list[DeckProblem], file: str, line_of: LineOf) -> Material | None:
    """The material described by the tables of `[material.<name>]`; None after adding to `problems` what is wrong.

    tables    parsed TOML: one table per family (`eos` is needed, `strength`, `fracture`, `burn` may be left out), and optionally
              `base` (a name of the library that the tables override), `sources`, `valid_up_to` (m/s), `warnings`
    file      what messages call the file
    line_of   line of a key path such as ("material", "al", "eos", "rho0"), or None
    """
    collector = Collector(problems, file, line_of)
    return read_material(name, tables, collector, ("material", name))


def read_material(name: str, tables: Any, collector: Collector, path: tuple) -> Material | None:
    """As `build_material`, for a caller that has its `Collector` and the path of the tables."""
    return assembled(name, tables, base_of(tables, collector, path), collector, path)


def base_of(tables: Any, collector: Collector, path: tuple) -> Material | None:
    """The library's material that tables override; None where they name none, or an unknown one, which is reported."""
    return from_library(tables["base"], collector, (*path, "base")) if isinstance(tables, dict) and "base" in tables else None


def from_library(name: Any, collector: Collector, path: tuple, others: tuple[str, ...] = ()) -> Material | None:
    """A material of the library by name; `others` are names the hint should offer too."""
    if not isinstance(name, str):
        collector.add(path, "a material is named by a text")
        return None
    try:
        return library.find(name[:200])
    except DeckError as error:
        told = error.problems[0]
        collector.add(path, printable(told.message, 200), nearest(name, others, printable(told.hint, 300)))
        return None
