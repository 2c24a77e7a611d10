"""Tabulated equations of state from files: CSV, HDF5, and SESAME-format ASCII.

    load(path)        the law `table` of a file, by its suffix and content
    read(path, ...)   the same, and what has to be reported of it
    read_csv(text)    four columns named density, temperature, pressure, energy (SI), one row per grid point in any order
    read_301(text)    a table of a SESAME-format ASCII file (g/cm3, K, GPa, MJ/kg; other units by arguments)

Every problem is one DeckError with the file, the line or place, and the remedy.
"""

import math
import pathlib
from typing import NamedTuple

import numpy as np

from hugoniot.errors import DeckError, FileTrouble, OutOfRange
from hugoniot.files import csv_rows, read_text
from hugoniot.laws.eos.table import Table, build, unstable_corners
from hugoniot.materials import sesame
from hugoniot.materials.table_repair import risen

COLUMNS = ("density", "temperature", "pressure", "energy")
HDF5 = (".h5", ".hdf5")
_LARGEST = 64 * 1024 * 1024
_FILL = "a table needs a value at every density and temperature: add the missing one, or leave that density out"


class Window(NamedTuple):
    """What of a file is wanted: its rest state, the ranges kept (kg/m3, K), the numbers of a SESAME material and of its table.

    repair              replace energies that do not rise with temperature (`materials.table_repair`)
    least_sound_speed   m/s, used where the table has none; 0 to refuse such a table
    """

    rho0: float = math.nan
    reference_temperature: float = 298.15
    density_range: tuple[float, float] = (0.0, math.inf)
    temperature_range: tuple[float, float] = (0.0, math.inf)
    material: int | None = None
    table: int = 301
    repair: bool = False
    least_sound_speed: float = 0.0


def load(path, **wanted) -> Table:
    """The law `table` of a file: HDF5 by its suffix, CSV where the first line names columns, else SESAME-format ASCII.

    wanted: fields of `Window`. rho0 (kg/m3) and reference_temperature (K) fix the rest state; without rho0 it is where the isotherm has
    zero pressure. density_range (kg/m3) and temperature_range (K) cut the grid.
    """
    return read(path, Window(**wanted))[0]


def read(path, window: Window) -> tuple[Table, tuple[str, ...]]:
    """The law of a file, as of `load`, and what was repaired in it or has to be known of it."""
    path = pathlib.Path(path)
    try:
        if path.stat().st_size > _LARGEST:
            raise DeckError.single(path, None, "table", f"the file is larger than {_LARGEST >> 20} MB", "thin the table out")
        if path.suffix.lower() in HDF5:
            from hugoniot.materials.table_hdf5 import read_table

            _not_sesame(path, window)
            return _build(str(path), *read_table(path), window)
        text = read_text(path, _LARGEST)
    except UnicodeDecodeError:
        raise DeckError.single(path, None, "table", "not a text file", "give a CSV, an .h5 or a SESAME-format ASCII file") from None
    except FileTrouble:
        raise
    except OSError as error:
        raise FileTrouble(f"{path}: {error.strerror or error}") from None
    first = next((line for line in text.splitlines() if line.strip() and not line.startswith("#")), "")
    if "," in first and not sesame.looks_like(first):
        _not_sesame(path, window)
        return _csv(text, str(path), window)
    return _sesame(text, str(path), window)


def _not_sesame(path, window: Window) -> None:
    """Refuse numbers of a material and of its table for a file that holds one table only."""
    for key, asked in (("number", window.material is not None), ("table", window.table != 301)):
        if asked:
            raise DeckError.single(path, None, key, "applies to SESAME-format files only", "this file holds one table: leave the key out")


def read_csv(text: str, name: str = "table.csv", rho0: float = math.nan, reference_temperature: float = 298.15) -> Table:
    """The law `table` of rows density (kg/m3), temperature (K), pressure (Pa), energy (J/kg); lines starting with # are skipped."""
    return _csv(text, name, Window(rho0, reference_temperature))[0]


def _csv(text: str, name: str, window: Window) -> tuple[Table, tuple[str, ...]]:
    lines = [(n, line) for n, line in enumerate(text.splitlines(), 1) if line.strip() and not line.lstrip().startswith("#")]
    if not lines:
        raise DeckError.single(name, None, "table", "the file has no rows",
                               f"begin it with the line {','.join(COLUMNS)}, in kg/m3, K, Pa and J/kg")
    header = [h.strip().lower() for h in csv_rows(lines[0][1], name, lines[0][0])[0][1]]
    wrong = [c for c in COLUMNS if header.count(c) != 1]
    if wrong:
        raise DeckError.single(name, lines[0][0], "header", f"needs exactly one column '{wrong[0]}', found {', '.join(header)}",
                               f"the columns, in any order, are {', '.join(COLUMNS)}, in kg/m3, K, Pa and J/kg")
    place = [header.index(c) for c in COLUMNS]
    points: dict[tuple[float, float], tuple[float, float]] = {}
    origin: dict[tuple[float, float], int] = {}
    for line_number, line in lines[1:]:
        rho, t, p, e = _row(line, place, len(header), name, line_number)
        if (rho, t) in points:
            raise DeckError.single(name, line_number, "row", f"density {rho:.6g} kg/m3, temperature {t:.6g} K is given twice, first on "
                                   f"line {origin[rho, t]}", "remove one")
        points[rho, t], origin[rho, t] = (p, e), line_number
    return _assemble(points, origin, name, window)


def _row(line: str, place: list[int], count: int, name: str, line_number: int) -> list[float]:
    """The four numbers of a row."""
    cells = [cell.strip() for cell in csv_rows(line, name, line_number)[0][1]]
    if len(cells) != count:
        raise DeckError.single(name, line_number, "row", f"values: {len(cells)}, column headers: {count}",
                               "give one value per column, with a point as decimal sign")
    found = []
    for column, k in zip(COLUMNS, place):
        try:
            found.append(float(cells[k]))
        except ValueError:
            shown = f"'{cells[k][:40]}' is not a number" if cells[k] else "the value is missing"
            raise DeckError.single(name, line_number, column, shown, "write a number in SI" if cells[k] else _FILL) from None
    if not (0.0 < found[0] < math.inf and 0.0 <= found[1] < math.inf):
        raise DeckError.single(name, line_number, "row", f"density {found[0]:.6g} kg/m3, temperature {found[1]:.6g} K is not a valid state",
                               "densities are positive, temperatures not negative")
    return found


def _assemble(points, origin, name, window: Window) -> tuple[Table, tuple[str, ...]]:
    rho, t = sorted({key[0] for key in points}), sorted({key[1] for key in points})
    if len(rho) * len(t) > 100 * max(len(points), 1):
        raise DeckError.single(name, None, "table", f"{len(points)} points do not form a grid of densities and temperatures",
                               "give every density at every temperature")
    for r in rho:
        for x in t:
            if (r, x) not in points:
                before = max((origin[key] for key in origin if key[0] == r), default=None)
                raise DeckError.single(name, before, "table", f"no row gives density {r:.6g} kg/m3 at temperature {x:.6g} K "
                                       f"({len(rho) * len(t) - len(points)} missing in all)", _FILL)
    p, e = (np.array([[points[r, x][k] for x in t] for r in rho]) for k in (0, 1))
    return _build(name, np.array(rho), np.array(t), p, e, window, origin)


def _build(name, rho, t, p, e, window: Window, lines=None) -> tuple[Table, tuple[str, ...]]:
    """The law of a grid and what is to be reported; `lines` maps (density, temperature) or None to the line of a message."""
    rows = np.flatnonzero((rho > 0.0) & (rho >= window.density_range[0]) & (rho <= window.density_range[1]))
    columns = np.flatnonzero((t >= window.temperature_range[0]) & (t <= window.temperature_range[1]))
    lines = lines or {}
    if rows.size < 2 or columns.size < 2:
        raise DeckError.single(name, lines.get(None), "table", f"in the requested range, densities: {rows.size}, temperatures: "
                               f"{columns.size}; at least two of each are needed", "widen the range or extend the table")
    keep = np.ix_(rows, columns)
    rho, t, p, e, told = rho[rows], t[columns], p[keep], e[keep], []
    if window.repair:
        p, e, told = risen(rho, t, p, e)
    try:
        table = build(rho, t, p, e, window.rho0, window.reference_temperature, window.least_sound_speed)
    except OutOfRange as trouble:
        place = getattr(trouble, "place", None)
        where = lines.get((rho[place[0]], t[place[1]])) if place else None
        message = str(trouble).removeprefix("table: ")
        raise DeckError.single(name, where or lines.get(None), "table", message) from None
    if window.least_sound_speed and (bad := unstable_corners(table._replace(least_sound_speed=0.0))):
        i, j = np.array(bad).T
        told = [*told, f"the table gives no real sound speed at corners of its cells (number: {len(bad)}; densities {rho[i.min()]:.4g} to "
                       f"{rho[i.max()]:.4g} kg/m3, temperatures {t[j.min()]:.4g} to {t[j.max()]:.4g} K): {window.least_sound_speed:g} m/s "
                       "is used there"]
    return table, tuple(told)


def read_301(text: str, name: str = "sesame.txt", *, units=sesame.UNITS, **wanted) -> Table:
    """The law `table` of a table of a SESAME-format file (of `material`, where the file holds several).

    wanted: fields of `Window`; its `table` is 301, the total (the sum of its parts where the file has no 301), or 303, 304, 305, parts
    of it (`materials.sesame`). units: SI value of the file's density, temperature, pressure and energy unit. A table with a vapour dome
    or a tension region needs a cut, or a least_sound_speed (c^2 > 0 is required where p >= 0); density 0 is always dropped.
    """
    return _sesame(text, name, Window(**wanted), units)[0]


def _sesame(text: str, name: str, window: Window, units=sesame.UNITS) -> tuple[Table, tuple[str, ...]]:
    found = sesame.grid(sesame.records(text, name), window.table, window.material, name, units)
    if found.temperature.size < 2:
        raise DeckError.single(name, found.line, str(window.table), "a cold curve has one temperature, but the law needs two or more",
                               "omit the key 'table' to use the total; hugoniot eos sesame shows the cold curve")
    return _build(name, found.density, found.temperature, found.pressure, found.energy, window, {None: found.line})
