"""Tabulated equations of state as HDF5 files, which the law `table` reads and `hugoniot eos table --hdf5` writes.

Four datasets at the root, each with its `unit` and `long_name`:

    density (n,) kg/m^3    temperature (m,) K    pressure (n, m) Pa    energy (n, m) J/kg

Its library is slow to load: `materials.tables_io` imports this module when it meets such a file.
"""

import os
from pathlib import Path

import h5py
import numpy as np

from hugoniot.errors import DeckError, FileTrouble
from hugoniot.files import hdf5_texts_end
from hugoniot.materials.collect import listed

UNITS = {"density": "kg/m^3", "temperature": "K", "pressure": "Pa", "energy": "J/kg"}
_LONG = {"density": "densities of the grid", "temperature": "temperatures of the grid", "pressure": "pressure, row by density",
         "energy": "specific internal energy, row by density"}
_MOST_VALUES = 20_000_000
_SPELLINGS = {"kg/m^3": ("kg/m3", "kg m-3", "kg/m**3"), "J/kg": ("J kg-1",)}


def write_table(path, density, temperature, pressure, energy, about: str = "") -> None:
    """Write a grid: density (n,) and temperature (m,) increasing, pressure and energy (n, m), SI; `about` names what is tabulated.

    The file appears whole or not at all. Raises FileTrouble if it cannot be written.
    """
    path = Path(path)
    unfinished = path.with_name(f".{path.name}.part")
    try:
        unfinished.unlink(missing_ok=True)
        with h5py.File(unfinished, "x", libver=("v110", "v110")) as file:     # a new file, never one behind a link
            file.attrs["format"] = "hugoniot equation-of-state table, version 1"
            file.attrs["about"] = about
            for (name, unit), values in zip(UNITS.items(), (density, temperature, pressure, energy), strict=True):
                data = file.create_dataset(name, data=np.asarray(values, dtype=np.float64), fletcher32=True)
                data.attrs["unit"] = unit
                data.attrs["long_name"] = _LONG[name]
        os.replace(unfinished, path)
    except OSError as error:
        unfinished.unlink(missing_ok=True)
        raise FileTrouble(f"cannot write {path}: {os.strerror(error.errno) if error.errno else error}") from None


def read_table(path) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """(density (n,), temperature (m,), pressure (n, m), energy (n, m)) in SI of an HDF5 file.

    DeckError for a file that is no HDF5, lacks a dataset, or gives one with a wrong shape or unit; the law judges the values.
    """
    try:
        if not hdf5_texts_end(path):
            raise RuntimeError("its strings are not terminated")
        with h5py.File(path, "r") as file:
            grid = [_dataset(file, name, path) for name in UNITS]
    except FileTrouble:
        raise
    except OSError:
        raise DeckError.single(path, None, "table", "not an HDF5 file, or a damaged one", "hugoniot eos table --hdf5 writes one") from None
    except (RuntimeError, KeyError, ValueError, TypeError, MemoryError) as error:
        why = f"a damaged HDF5 file ({_printable(str(error))})"
        raise DeckError.single(path, None, "table", why, "hugoniot eos table --hdf5 writes one") from None
    n, m = grid[0].size, grid[1].size
    for name, values, shape in zip(UNITS, grid, ((n,), (m,), (n, m), (n, m))):
        if values.shape != shape:
            raise DeckError.single(path, None, name, f"has {_size(values.shape)} values, but {n} densities and "
                                   f"{m} temperatures need {_size(shape)}", "rows are densities, columns temperatures")
    return grid[0], grid[1], grid[2], grid[3]


def _size(shape: tuple) -> str:
    return " x ".join(map(str, shape)) or "1"


def _dataset(file, name: str, path) -> np.ndarray:
    found = file.get(name)
    if not isinstance(found, h5py.Dataset):
        raise DeckError.single(path, None, name, f"the file has no dataset '{name}'; its datasets: {_names(file) or 'none'}",
                               f"it needs {', '.join(UNITS)}")
    if found.dtype.kind not in "fiu":
        raise DeckError.single(path, None, name, f"the dataset '{name}' does not consist of numbers",
                               f"write it as numbers in {UNITS[name]}")
    if found.external or found.is_virtual:
        raise DeckError.single(path, None, name, "its numbers are stored in another file", "copy them into this one")
    if not 0 < (found.size or 0) <= _MOST_VALUES or found.ndim > 2:
        raise DeckError.single(path, None, name, f"has {_size(found.shape)} values in {found.ndim} dimensions",
                               f"a table has at most {_MOST_VALUES} values in one or two dimensions")
    unit = found.attrs.get("unit", UNITS[name])
    unit = unit.decode("utf-8", "replace") if isinstance(unit, bytes) else str(unit)
    if unit not in (UNITS[name], *_SPELLINGS.get(UNITS[name], ())):
        raise DeckError.single(path, None, name, f"is in '{unit[:40]}'", f"write it in {UNITS[name]}")
    return np.asarray(found[()], dtype=np.float64)


def _names(file) -> str:
    return listed(file, 20)


def _printable(text: str, limit: int = 120) -> str:
    return "".join(c if c.isprintable() else f"\\x{ord(c):02x}" for c in text[:limit])
