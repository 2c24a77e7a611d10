"""A material of a deck or of a file: its tables, and the materials of the library that they name.

`base = "copper"` of a material is what its tables override; of a law around another, as porous ones are, it is that material's law.

Every problem is collected, none raised.
"""

from functools import partial
from typing import Any

from hugoniot.errors import DeckError, DeckProblem
from hugoniot.laws.eos.contract import EOS
from hugoniot.materials import library
from hugoniot.materials.build import assembled
from hugoniot.materials.collect import Collector, LineOf, nearest, printable
from hugoniot.materials.material import Material
from hugoniot.materials.tables import law_table


def build_material(name: str, tables: dict, problems: list[DeckProblem], file: str, line_of: LineOf) -> Material | None:
    """The material described by the tables of `[material.<name>]`; None after adding to `problems` what is wrong.

    tables    parsed TOML: one table per family (`eos` is needed, `strength`, `fracture`, `burn` may be left out), and optionally
              `base` (a name of the library that the tables override), `library` (a name of the library: the same substance),
              `sources`, `valid_up_to` (m/s), `warnings`
    file      what messages call the file
    line_of   line of a key path such as ("material", "al", "eos", "rho0"), or None
    """
    collector = Collector(problems, file, line_of)
    return read_material(name, tables, collector, ("material", name))


def read_material(name: str, tables: Any, collector: Collector, path: tuple) -> Material | None:
    """As `build_material`, for a caller that has its `Collector` and the path of the tables."""
    base = base_of(tables, collector, path)
    return assembled(name, with_named_laws(tables, base, collector, path), base, collector, path)


def base_of(tables: Any, collector: Collector, path: tuple) -> Material | None:
    """The library's material that tables override; None where they name none, or an unknown one, which is reported."""
    if not isinstance(tables, dict):
        return None
    found = {key: from_library(tables[key], collector, (*path, key)) for key in ("base", "library") if key in tables}
    return found.get("base")


def with_named_laws(tables: Any, base: Material | None, collector: Collector, path: tuple) -> Any:
    """The tables in which a law that stands inside a law, given by the name of a material, is the table of that material's law."""
    if not isinstance(tables, dict):
        return tables
    found = dict(tables)
    for family, inherited in (("eos", base.eos if base else None), ("unreacted", base.unreacted if base else None)):
        if family in tables:
            found[family] = _named_inside(tables[family], inherited, collector, (*path, family))
    return found


def _named_inside(table: Any, inherited: Any, collector: Collector, path: tuple) -> Any:
    if not isinstance(table, dict):
        return table
    name = table.get("law", EOS.of(inherited).name if inherited is not None else None)
    if not isinstance(name, str) or name not in EOS.names():
        return table
    found = dict(table)
    for key, value in table.items():
        if not EOS.knows(getattr(EOS.get(name).example, key, None)):
            continue
        if isinstance(value, dict):
            found[key] = _named_inside(value, getattr(inherited, key, None), collector, (*path, key))
        elif isinstance(value, str) and (named := from_library(value, collector, (*path, key))) is not None:
            found[key] = law_table(EOS, named.eos)
    return found


def from_library(name: Any, collector: Collector, path: tuple, others: tuple[str, ...] = ()) -> Material | None:
    """A material of the library by name; `others` are names the hint should offer too."""
    if not isinstance(name, str):
        collector.add(path, "expected the name of a material in quotes")
        return None
    try:
        return library.find(name[:200], brief=collector.full)
    except DeckError as error:
        told = error.problems[0]
        collector.add(path, printable(told.message, 200), partial(nearest, name, others, printable(told.hint, 300)))
        return None
