"""Tabulated equations of state from files: CSV, HDF5, and SESAME-format ASCII (table 301).

    load(path)        the law `table` of a file, by its suffix and content
    read_csv(text)    four columns named density, temperature, pressure, energy (SI), one row per grid point in any order
    read_301(text)    the 301 table of a SESAME-format ASCII file (g/cm3, K, GPa, MJ/kg; other units by arguments)

Both styles of SESAME text are read: the records of the ASCII exchange format (` 0 3720 301 ...`) and the Sandia style of ANEOS
(` RECORD TYPE = 301 NWDS = ...`). Every trouble is one DeckError with the file, the line or place, and the way out.
Source: Lyon and Johnson, LA-UR-92-3407 (1992), table 301: NR, NT, densities, temperatures, then p, e (and A) with density fastest.
"""

import csv
import io
import math
import pathlib
import re
from typing import NamedTuple

import numpy as np

from hugoniot.errors import DeckError, FileTrouble, OutOfRange
from hugoniot.files import read_text
from hugoniot.laws.eos.table import Table, build

COLUMNS = ("density", "temperature", "pressure", "energy")
HDF5 = (".h5", ".hdf5")
_EXCHANGE = re.compile(r"^\s*[012]\s+(\d{1,18})\s+(\d{3})\s+(\d+)\s+[A-Za-z]")
_SANDIA = re.compile(r"^\s*RECORD\s+TYPE\s*=\s*(\d{3})\s+NWDS\s*=\s*(\d+)")
_NUMBER = re.compile(r"[+-]?(?:\d+\.\d*|\.\d+)(?:[EeDd][+-]?\d+|[+-]\d+)?|[+-]?(?:nan|inf)(?:inity)?\b", re.IGNORECASE)
_FLAGS = re.compile(r"^(.*[EeDd][+-]\d\d)[01]{5}\s*$")
_LARGEST = 64 * 1024 * 1024
_FILL = "a table gives every density at every temperature: fill the hole or leave that density out"


class Window(NamedTuple):
    """What of a file is wanted: its rest state, the ranges kept (kg/m3, K), the number of the material where the file holds several."""

    rho0: float = math.nan
    reference_temperature: float = 298.15
    density_range: tuple[float, float] = (0.0, math.inf)
    temperature_range: tuple[float, float] = (0.0, math.inf)
    material: int | None = None


def load(path, rho0: float = math.nan, reference_temperature: float = 298.15, density_range=(0.0, math.inf),
         temperature_range=(0.0, math.inf), material: int | None = None) -> Table:
    """The law `table` of a file: HDF5 by its suffix, CSV where the first line names columns, else SESAME-format ASCII.

    rho0 (kg/m3) and reference_temperature (K) fix the rest state; without rho0 it is where the isotherm has zero pressure.
    density_range (kg/m3) and temperature_range (K) cut the grid; `material` is the number of a SESAME material.
    """
    path, window = pathlib.Path(path), Window(rho0, reference_temperature, density_range, temperature_range, material)
    try:
        if path.stat().st_size > _LARGEST:
            raise DeckError.single(path, None, "table", f"the file is larger than {_LARGEST >> 20} MB", "thin the table out")
        if path.suffix.lower() in HDF5:
            from hugoniot.materials.table_hdf5 import read_table

            return _build(str(path), *read_table(path), window)
        text = read_text(path, _LARGEST)
    except UnicodeDecodeError:
        raise DeckError.single(path, None, "table", "not a text file", "give a CSV, an .h5 or a SESAME-format ASCII file") from None
    except FileTrouble:
        raise
    except OSError as error:
        raise FileTrouble(f"{path}: {error.strerror or error}") from None
    first = next((line for line in text.splitlines() if line.strip() and not line.startswith("#")), "")
    if "," in first and not _EXCHANGE.match(first):
        return _csv(text, str(path), window)
    return read_301(text, str(path), rho0=rho0, reference_temperature=reference_temperature, material=material,
                    density_range=density_range, temperature_range=temperature_range)


def read_csv(text: str, name: str = "table.csv", rho0: float = math.nan, reference_temperature: float = 298.15) -> Table:
    """The law `table` of rows density (kg/m3), temperature (K), pressure (Pa), energy (J/kg); lines starting with # are skipped."""
    return _csv(text, name, Window(rho0, reference_temperature))


def _csv(text: str, name: str, window: Window) -> Table:
    lines = [(n, line) for n, line in enumerate(text.splitlines(), 1) if line.strip() and not line.lstrip().startswith("#")]
    if not lines:
        raise DeckError.single(name, None, "table", "the file has no rows", f"first line: {','.join(COLUMNS)}")
    header = [h.strip().lower() for h in next(csv.reader([lines[0][1]]))]
    wrong = [c for c in COLUMNS if header.count(c) != 1]
    if wrong:
        raise DeckError.single(name, lines[0][0], "header", f"needs exactly one column '{wrong[0]}', found {', '.join(header)}",
                               f"the first line is {','.join(COLUMNS)} (kg/m3, K, Pa, J/kg)")
    place = [header.index(c) for c in COLUMNS]
    points: dict[tuple[float, float], tuple[float, float]] = {}
    origin: dict[tuple[float, float], int] = {}
    for line_number, line in lines[1:]:
        rho, t, p, e = _row(line, place, len(header), name, line_number)
        if (rho, t) in points:
            raise DeckError.single(name, line_number, "row", f"density {rho:.6g}, temperature {t:.6g} is given twice, first on line "
                                   f"{origin[rho, t]}", "remove one")
        points[rho, t], origin[rho, t] = (p, e), line_number
    return _assemble(points, origin, name, window)


def _row(line: str, place: list[int], count: int, name: str, line_number: int) -> list[float]:
    """The four numbers of a row."""
    cells = [cell.strip() for cell in next(csv.reader(io.StringIO(line)))]
    if len(cells) != count:
        raise DeckError.single(name, line_number, "row", f"{len(cells)} values, but the header names {count} columns",
                               "give one value per column, with a point as decimal sign")
    found = []
    for column, k in zip(COLUMNS, place):
        try:
            found.append(float(cells[k]))
        except ValueError:
            shown = f"'{cells[k][:40]}' is not a number" if cells[k] else "a hole: no value"
            raise DeckError.single(name, line_number, column, shown, "write a number in SI" if cells[k] else _FILL) from None
    if not (0.0 < found[0] < math.inf and 0.0 <= found[1] < math.inf):
        raise DeckError.single(name, line_number, "row", f"density {found[0]:.6g} kg/m3, temperature {found[1]:.6g} K is not a valid state",
                               "densities are positive, temperatures not negative")
    return found


def _assemble(points, origin, name, window: Window) -> Table:
    rho, t = sorted({key[0] for key in points}), sorted({key[1] for key in points})
    if len(rho) * len(t) > 100 * max(len(points), 1):
        raise DeckError.single(name, None, "table", f"{len(points)} points do not form a grid of densities and temperatures",
                               "give every density at every temperature")
    for r in rho:
        for x in t:
            if (r, x) not in points:
                before = max((origin[key] for key in origin if key[0] == r), default=None)
                raise DeckError.single(name, before, "table", f"a hole: no row gives density {r:.6g} kg/m3 at temperature {x:.6g} K "
                                       f"({len(rho) * len(t) - len(points)} missing in all)", _FILL)
    p, e = (np.array([[points[r, x][k] for x in t] for r in rho]) for k in (0, 1))
    return _build(name, np.array(rho), np.array(t), p, e, window, origin)


def _build(name, rho, t, p, e, window: Window, lines=None) -> Table:
    """The law of a grid; `lines` maps (density, temperature) or None to the line of a message."""
    rows = np.flatnonzero((rho > 0.0) & (rho >= window.density_range[0]) & (rho <= window.density_range[1]))
    columns = np.flatnonzero((t >= window.temperature_range[0]) & (t <= window.temperature_range[1]))
    lines = lines or {}
    if rows.size < 2 or columns.size < 2:
        raise DeckError.single(name, lines.get(None), "table", f"{rows.size} densities and {columns.size} temperatures are in the "
                               "requested range; at least two of each are needed", "widen the range or extend the table")
    keep = np.ix_(rows, columns)
    try:
        return build(rho[rows], t[columns], p[keep], e[keep], window.rho0, window.reference_temperature)
    except OutOfRange as trouble:
        place = getattr(trouble, "place", None)
        where = lines.get((rho[rows][place[0]], t[columns][place[1]])) if place else None
        raise DeckError.single(name, where or lines.get(None), "table", str(trouble).removeprefix("table: ")) from None


def read_301(text: str, name: str = "sesame.txt", *, rho0: float = math.nan, reference_temperature: float = 298.15,
             material: int | None = None, density_range=(0.0, math.inf), temperature_range=(0.0, math.inf),
             units=(1e3, 1.0, 1e9, 1e6)) -> Table:
    """The law `table` of the first 301 table (of `material`, where the file holds several).

    units: SI value of the file's density, temperature, pressure and energy unit. density_range (kg/m3) and temperature_range (K) cut the
    grid, which a table with a vapour dome or a tension region needs (c^2 > 0 is required where p >= 0); density 0 is always dropped.
    """
    words, line_number = _record(text, name, material)
    if len(words) < 2 or not all(2.0 <= word < 1e9 and word == int(word) for word in words[:2]):
        raise DeckError.single(name, line_number, "301", "the table does not begin with its numbers of densities and temperatures")
    n, m = int(words[0]), int(words[1])
    needed = 2 + n + m + 2 * n * m
    if len(words) < needed:
        raise DeckError.single(name, line_number, "301", f"{n} densities x {m} temperatures need {needed} words, it has {len(words)}",
                               "the file is truncated or contains no energies")
    rho, t = np.array(words[2:2 + n]) * units[0], np.array(words[2 + n:2 + n + m]) * units[1]
    p = np.array(words[2 + n + m:2 + n + m + n * m]).reshape(m, n).T * units[2]
    e = np.array(words[2 + n + m + n * m:needed]).reshape(m, n).T * units[3]
    window = Window(rho0, reference_temperature, density_range, temperature_range)
    return _build(name, rho, t, p, e, window, {None: line_number})


def _record(text: str, name: str, material: int | None):
    """(words of the 301 record, its line number)."""
    found, start = None, None
    for line_number, line in enumerate(text.splitlines(), 1):
        exchange, sandia = _EXCHANGE.match(line), _SANDIA.match(line)
        if exchange or sandia:
            if found is not None:
                break
            wanted = exchange and material is not None and int(exchange.group(1)) != material
            if (exchange.group(2) if exchange else sandia.group(1)) == "301" and not wanted:
                found, start = [], line_number
        elif found is not None:
            if line.lstrip().startswith(("INDEX", "RECORD")):
                break
            # words may touch ("1.0E+00-2.0E+00"), and so may the five flags of ones and zeros that end a line of the exchange format
            flagged = _FLAGS.match(line)
            found += [_word(w) for w in _NUMBER.findall(flagged.group(1) if flagged else line)]
    if found is None:
        which = "" if material is None else f" of material {material}"
        raise DeckError.single(name, None, "301", f"no 301 table{which} in this file",
                               "give a SESAME-format ASCII file or a CSV with a header")
    return found, start


def _word(word: str) -> float:
    word = word.replace("D", "E").replace("d", "E")
    if re.fullmatch(r"[+-]?[\d.]+[+-]\d+", word):
        word = re.sub(r"(?<=[\d.])([+-]\d+)$", r"E\1", word)
    return float(word)
