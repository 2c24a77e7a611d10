"""SESAME-format ASCII files: tables of the equation of state, of its parts, and of the curves on which phases coexist.

| table | contents |
|---|---|
| 301 | total equation of state |
| 303 | ions with the cold curve |
| 304 | thermal electrons |
| 305 | ions with zero-point motion |
| 306 | cold curve without zero-point motion |
| 401 | vaporization curve |
| 411 | solid on the melting curve |
| 412 | liquid on the melting curve |

The parts add up, in pressure and in energy. With the number of the table as the index,

$$p_{301} = p_{303} + p_{304} = p_{304} + p_{305} + p_{306}$$

Two styles of text are read: the records of the ASCII exchange format, which begin like `0 3720 301`, and the Sandia style of ANEOS, which
begins with `RECORD TYPE = 301 NWDS = ...`. The units in the file are g/cm3, K, GPa and MJ/kg; results are in SI. Any problem raises a
DeckError with the file, the line and a remedy.

Source: Lyon and Johnson, LA-UR-92-3407 (1992): a table holds the numbers of densities and temperatures, the densities, the temperatures,
then pressure, energy and, in some files, free energy, with the density varying fastest.
"""

import re
from typing import Any, NamedTuple

import numpy as np

from hugoniot.errors import DeckError
from hugoniot.materials.collect import listed

PARTS = {301: "total", 303: "ions with the cold curve", 304: "thermal electrons", 305: "ions with zero-point motion", 306: "cold curve"}
CURVES = {401: "vaporization", 411: "solid on the melting line", 412: "liquid on the melting line"}
SUMS = ((303, 304), (304, 305, 306))
UNITS = (1e3, 1.0, 1e9, 1e6)      # SI values of the units of density, temperature, pressure and energy
_EXCHANGE = re.compile(r"^\s*[012]\s+(\d{1,18})\s+(\d{3})\s+(\d+)\s+[A-Za-z]")
_SANDIA = re.compile(r"^\s*RECORD\s+TYPE\s*=\s*(\d{3})\s+NWDS\s*=\s*(\d+)")
_INDEX = re.compile(r"^\s*INDEX\s+MATID\s*=\s*(\d{1,18})")
_NUMBER = re.compile(r"[+-]?(?:\d+\.\d*|\.\d+)(?:[EeDd][+-]?\d+|[+-]\d+)?|[+-]?(?:nan|inf)(?:inity)?\b", re.IGNORECASE)
_FLAGS = re.compile(r"^(.*[EeDd][+-]\d\d)[01]{5}\s*$")
_ANEOS_INPUT = re.compile(r"^ANEOS[12]?\s", re.MULTILINE)


class Record(NamedTuple):
    """A table as given in the file: numbers of the material (None where the file gives none) and of the table, its line, its rows."""

    material: int | None
    number: int
    line: int
    rows: list[str]


class Grid(NamedTuple):
    """A table of density (n,) and temperature (m,), SI, with pressure and energy (n, m), and free_energy, None where the file has none."""

    number: int
    line: int
    density: Any
    temperature: Any
    pressure: Any
    energy: Any
    free_energy: Any


class Curve(NamedTuple):
    """A coexistence curve, SI: temperature, pressure, density and energy of a phase; in table 401 of both phases, (2, n), vapour first."""

    number: int
    line: int
    temperature: Any
    pressure: Any
    density: Any
    energy: Any


def looks_like(line: str) -> bool:
    """Whether a line begins a record of the exchange format."""
    return _EXCHANGE.match(line) is not None


def records(text: str, name: str = "sesame.txt") -> list[Record]:
    """Every record of the text of a file with a table number above 200, in order; DeckError where there is none.

    name   name of the file for messages
    """
    found: list[Record] = []
    rows: list[str] | None = None
    sandia_material = None
    for line_number, line in enumerate(text.splitlines(), 1):
        if index := _INDEX.match(line):
            sandia_material, rows = int(index.group(1)), None
        elif (exchange := _EXCHANGE.match(line)) or (sandia := _SANDIA.match(line)):
            number = int(exchange.group(2) if exchange else sandia.group(1))
            rows = []
            if number > 200:      # 101 and on are comments
                found.append(Record(int(exchange.group(1)) if exchange else sandia_material, number, line_number, rows))
        elif line.lstrip().startswith(("INDEX", "RECORD")):
            rows = None
        elif rows is not None:
            rows.append(line)
    if not found and _ANEOS_INPUT.search(text):
        raise DeckError.single(name, None, "table", "is the input of the ANEOS program, not a table",
                               "run ANEOS and give the file it writes, such as NEW-SESAME-STD.TXT")
    return found


def materials(found: list[Record]) -> list[int | None]:
    """Numbers of the materials in the order of the file."""
    return list(dict.fromkeys(record.material for record in found))


def grid(found: list[Record], number: int = 301, material: int | None = None, name: str = "sesame.txt", units=UNITS) -> Grid:
    """A table of pressure and energy.

    found      result of `records`
    number     number of the table; 301 is formed from its parts if the file does not have it
    material   number of the material; None: the first
    name       name of the file for messages
    units      SI values of the units of density, temperature, pressure and energy in the file
    """
    record = _first(found, number, material)
    if record is not None:
        return _grid(record, name, units)
    for one in (materials(found) if material is None else [material]) if number == 301 else ():
        for parts in SUMS:
            stored = [part for number in parts if (part := _first(found, number, one))]
            if len(stored) == len(parts):
                return _total([_grid(part, name, units) for part in stored], name)
    raise _absent(found, number, material, name)


def _absent(found: list[Record], number: int, material: int | None, name: str) -> DeckError:
    """That a table is not in the file, and what to choose instead."""
    what, numbered = f"no {number} table", [m for m in materials(found) if m is not None]
    if material is not None and material not in numbered and numbered:
        return DeckError.single(name, None, "table", f"{what} of material {material} in this file",
                                f"choose a material of this file: {listed(numbered)}")
    here = sorted({r.number for r in found if material in (None, r.material)} & {*PARTS, *CURVES})
    tables = [n for n in here if n in PARTS and n != 306]      # the cold curve alone is no table of temperatures
    which = "" if material is None else f" of material {material}"
    return DeckError.single(name, None, "table", f"{what}{which} in this file" + (f"; it has {listed(here)}" if here else ""), (
        f"choose table {' or '.join(map(str, tables))}, or give a file that has {number}" if tables else
        f"give a file that has {number}" if here else "give a SESAME-format ASCII file or a CSV with a header"))


def curve(found: list[Record], number: int, material: int | None = None, name: str = "sesame.txt") -> Curve | None:
    """The table 401, 411 or 412, or None where the file has none; arguments as in `grid`."""
    record = _first(found, number, material)
    if record is None:
        return None
    words = _words(record)
    n = _count(words, 0, record, name)
    if number == 401:
        if len(words) < 1 + 6 * n:
            raise _short(record, name, f"temperatures: {n}, numbers needed: {1 + 6 * n}", words)
        p, t, *rest = np.array(words[1:1 + 6 * n]).reshape(6, n)
        return Curve(number, record.line, t, p * UNITS[2], np.array(rest[:2]) * UNITS[0], np.array(rest[2:]) * UNITS[3])
    if len(words) < 3 + 4 * n:
        raise _short(record, name, f"densities: {n}, numbers needed: {3 + 4 * n}", words)
    t, p, e = np.array(words[3 + n:3 + 4 * n]).reshape(3, n)
    return Curve(number, record.line, t, p * UNITS[2], np.array(words[2:2 + n]) * UNITS[0], e * UNITS[3])


def constants(found: list[Record], material: int | None = None) -> dict[str, float]:
    """Table 201: mean atomic number, mean atomic mass (g/mol) and reference density (kg/m3). Its bulk modulus is omitted, because files
    differ in its unit."""
    record = _first(found, 201, material)
    words = _words(record) if record else []
    return dict(zip(("atomic_number", "atomic_mass", "density"), (w * unit for w, unit in zip(words, (1.0, 1.0, UNITS[0])))))


def sum_differences(found: list[Record], material: int | None = None, name: str = "sesame.txt") -> dict[tuple[int, ...], tuple | None]:
    """Differences between the total and the sums of its parts, for each sum whose tables are all in the file.

    Returns a dict: numbers of the parts -> (largest difference of the pressure, of the energy, and the density and temperature of the
    former). A difference is relative to the sum of the magnitudes of the parts. None where the grids differ.
    """
    result: dict[tuple[int, ...], tuple | None] = {}
    for parts in SUMS:
        if not all(_first(found, number, material) for number in (301, *parts)):
            continue
        total, *shares = (grid(found, number, material, name) for number in (301, *parts))
        if not _same_grids(total, shares):
            result[parts] = None
            continue
        misses = []
        for field in ("pressure", "energy"):
            values = np.array([np.broadcast_to(getattr(share, field), total.pressure.shape) for share in shares])
            scale = np.abs(values).sum(axis=0)
            misses.append(np.abs(getattr(total, field) - values.sum(axis=0)) / np.where(scale > 0.0, scale, 1.0))
        i, j = np.unravel_index(np.argmax(misses[0]), misses[0].shape)
        result[parts] = (float(misses[0].max()), float(misses[1].max()), float(total.density[i]), float(total.temperature[j]))
    return result


def _same_grids(total: Grid, parts: list[Grid]) -> bool:
    """Whether the parts can be added: equal densities, and equal temperatures but for a cold curve."""
    return all(np.array_equal(part.density, total.density) and (
        part.temperature.size == 1 or np.array_equal(part.temperature, total.temperature)) for part in parts)


def _total(parts: list[Grid], name: str) -> Grid:
    most = max(parts, key=lambda part: part.temperature.size)
    if not _same_grids(most, parts):
        numbers = " and ".join(str(part.number) for part in parts)
        raise DeckError.single(name, parts[0].line, "301", f"the file has no table 301, and {numbers} are on different grids",
                               "give a file with table 301")
    p, e = (sum(np.broadcast_to(getattr(part, field), most.pressure.shape) for part in parts) for field in ("pressure", "energy"))
    return most._replace(number=301, pressure=p, energy=e, free_energy=None)


def _first(found: list[Record], number: int, material: int | None) -> Record | None:
    """The first such record; one in a file that does not number its materials is any material's."""
    return next((r for r in found if r.number == number and (material is None or r.material in (None, material))), None)


def _grid(record: Record, name: str, units) -> Grid:
    words = _words(record)
    n = _count(words, 0, record, name)
    m = _count(words, 1, record, name)
    needed = 2 + n + m + 2 * n * m
    if len(words) < needed:
        raise _short(record, name, f"densities: {n}, temperatures: {m}, numbers needed: {needed}", words)
    if len(words) >= needed + 2 * n * m:
        raise DeckError.single(name, record.line, str(record.number), "has four values or more at each point instead of pressure, energy "
                               "and free energy: this ANEOS file also contains entropies and sound speeds", "give NEW-SESAME-STD.TXT")
    arrays = [np.array(words[k:k + n * m]).reshape(m, n).T for k in range(2 + n + m, len(words) - n * m + 1, n * m)]
    free = arrays[2] * units[3] if len(arrays) > 2 else None
    return Grid(record.number, record.line, np.array(words[2:2 + n]) * units[0], np.array(words[2 + n:2 + n + m]) * units[1],
                arrays[0] * units[2], arrays[1] * units[3], free)


def _count(words: list[float], place: int, record: Record, name: str) -> int:
    """A number of densities or temperatures; a cold curve and tables of curves have one temperature."""
    least = 1.0 if record.number == 306 and place == 1 else 2.0
    if len(words) <= place or not (least <= words[place] < 1e9 and words[place] == int(words[place])):
        what = "number of points" if record.number in CURVES else "numbers of densities and temperatures"
        raise DeckError.single(name, record.line, str(record.number), f"the table does not begin with its {what}")
    return int(words[place])


def _short(record: Record, name: str, needs: str, words: list[float]) -> DeckError:
    return DeckError.single(name, record.line, str(record.number), f"{needs}, found: {len(words)}",
                            "the file is truncated or contains no energies")


def _words(record: Record) -> list[float]:
    """The numbers of a record. They may touch ("1.0E+00-2.0E+00"), and so may the five flags that end a line of the exchange format."""
    found: list[float] = []
    for row in record.rows:
        flagged = _FLAGS.match(row)
        found += [_word(w) for w in _NUMBER.findall(flagged.group(1) if flagged else row)]
    return found


def _word(word: str) -> float:
    word = word.replace("D", "E").replace("d", "E")
    if re.fullmatch(r"[+-]?[\d.]+[+-]\d+", word):
        word = re.sub(r"(?<=[\d.])([+-]\d+)$", r"E\1", word)
    return float(word)
