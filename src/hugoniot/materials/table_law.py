"""The law `table` of a deck or a material file that names a data file instead of listing the values.

    [material.copper.eos]
    law = "table"
    file = "copper.csv"                          # or .h5, or SESAME-format ASCII; relative to the file that names it
    rho0 = "8930 kg/m^3"                         # optional: reference density, else where the isotherm has zero pressure
    reference_temperature = "298.15 K"           # optional
    density_range = ["8 g/cm^3", "14 g/cm^3"]    # optional: the part of the table to use
    temperature_range = ["300 K", "3000 K"]      # optional
    number = 3720                                # optional: the material of a SESAME file that holds several
    table = 303                                  # optional: its table: 301 (total, the default), 303, 304 or 305
    repair = true                                # optional: replace energies that do not rise with temperature, with a warning
    least_sound_speed = "1 m/s"                  # optional: lower bound of the sound speed, where the table has none

A problem that is saved holds the values themselves, so that it runs again without the data file.
"""

from pathlib import Path
from typing import Any

from hugoniot.errors import DeckError, FileTrouble
from hugoniot.materials import sesame, tables_io
from hugoniot.materials.collect import Collector, explained, listed, printable, shown_value

LAW = "table"
UNITS = {"file": "text", "rho0": "kg/m^3", "reference_temperature": "K", "density_range": "kg/m^3", "temperature_range": "K",
         "number": "1", "table": "1", "repair": "1", "least_sound_speed": "m/s"}
MEANING = {"file": "name of the file, .csv, .h5 or SESAME-format ASCII, relative to the folder of the deck or material file",
           "rho0": "reference density (default: that of zero pressure at the reference temperature)",
           "reference_temperature": "reference temperature (default: 298.15 K)",
           "density_range": "array of two: lowest and highest density to use",
           "temperature_range": "array of two: lowest and highest temperature to use",
           "number": "number of the material in a SESAME file that holds several",
           "table": "number of the table in a SESAME file: 301 (total, the default), 303 (ions with the cold curve), 304 (thermal "
                    "electrons) or 305 (ions)",
           "repair": "whether energies that do not rise with temperature are replaced by interpolation, with a warning",
           "least_sound_speed": "sound speed that is used where the table has a smaller one or none; 0: such a table is refused"}
_KINDS = {"file": "string", "number": "integer", "table": "integer", "repair": "boolean",
          "density_range": "array", "temperature_range": "array"}
_SUFFIXES = (".csv", ".h5", ".hdf5", ".ses", ".301", ".txt")


def read_table_law(table: dict, collector: Collector, path: tuple) -> Any:
    """The parameters of a law table with the key `file`; None after reporting to the collector what is wrong."""
    before, given = collector.findings, {}
    for key, value in table.items():
        if key in ("law", "file"):
            continue
        if key not in UNITS:
            collector.unknown((*path, key), UNITS)
        elif key in ("number", "table"):
            given["material" if key == "number" else key] = value
            if isinstance(value, bool) or not isinstance(value, int):
                collector.add((*path, key), f"expected a whole number, got {shown_value(value)}{explained(key, MEANING[key])}")
            elif key == "table" and value not in sesame.PARTS:
                collector.add((*path, key), f"{value} is not a table of pressures and energies{explained(key, MEANING[key])}")
        elif key == "repair":
            given[key] = value
            if not isinstance(value, bool):
                collector.add((*path, key), f"expected true or false, got {shown_value(value)}{explained(key, MEANING[key])}")
        elif key.endswith("_range"):
            given[key] = _range(value, UNITS[key], collector, (*path, key))
        else:
            given[key] = collector.quantity((*path, key), value, UNITS[key])
            if key == "least_sound_speed" and given[key] is not None and not given[key] >= 0.0:
                collector.add((*path, key), f"must not be less than 0, got {given[key]:g} m/s{explained(key, MEANING[key])}")
    file = table["file"]
    if not isinstance(file, str) or not file.strip() or not file.isprintable():
        collector.add((*path, "file"), f"expected the name of a file{explained('file', MEANING['file'])}")
    if collector.findings > before:
        return None
    try:
        found, notes = tables_io.read(collector.folder / file, tables_io.Window(**given))
        collector.warnings += [f"{printable(file, 200)}: {note}" for note in notes]
        return found
    except DeckError as error:
        collector.take(error)
    except FileTrouble:
        sought = collector.folder / file
        collector.add((*path, "file"), f"no readable table at '{printable(sought, 200)}'", _others(sought))
    return None


def editor_schema() -> dict:
    """JSON Schema of such a table, for editors."""
    properties = {key: {"description": text, "unit": UNITS[key], "type": _KINDS.get(key, ["number", "string"])}
                  for key, text in MEANING.items()}
    return {"type": "object", "title": "table in a file", "properties": {"law": {"const": LAW}, **properties}, "required": ["law", "file"]}


def _range(value: Any, unit: str, collector: Collector, path: tuple) -> tuple[float, float] | None:
    if not isinstance(value, list) or len(value) != 2:
        collector.add(path, "expected two values", "write the lowest and the highest, such as [\"8 g/cm^3\", \"14 g/cm^3\"]")
        return None
    low, high = (collector.quantity((*path, i), v, unit) for i, v in enumerate(value))
    if low is not None and high is not None and not low < high:
        collector.add(path, "the second value must exceed the first", "write the lower value first")
    return None if low is None or high is None else (low, high)


def _others(path: Path) -> str:
    """The tables that lie where one was sought."""
    folder = path.parent
    found = sorted(f.name for f in folder.iterdir() if f.suffix.lower() in _SUFFIXES) if folder.is_dir() else []
    return f"tables in that folder: {listed(found, 5)}" if found else "the name is relative to the file that has it"
