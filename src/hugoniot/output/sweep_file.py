"""The table of a sweep on the disk: cases.csv for people and spreadsheets, sweep.h5 for programs; both the same bits for the same cases.

sweep.h5 opens as netCDF: `xarray.open_dataset("sweep.h5", engine="h5netcdf")`. Of a grid every parameter is an axis and every result an
array over them; of other designs there is one axis, `case`, along which parameters and results stand. All in SI, with units and names as
attributes; `reason` says why a case has no numbers, and is empty for one that has.
"""

import csv
import io
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from hugoniot.output.atomic import write_parts
from hugoniot.output.hdf5 import h5py, sound_layout, write_hdf5

FORMAT = "hugoniot-sweep-1"


@dataclass(frozen=True)
class Column:
    """One parameter or result: its name, SI unit ("" for texts) and a value for each case (of a parameter of a grid: for each step)."""

    name: str
    unit: str
    values: np.ndarray


@dataclass(frozen=True)
class SweepTable:
    """The cases of a sweep.

    shape        of a grid, () of other designs
    parameters   columns of all cases; `steps` of a grid the same along each axis
    results      columns of all cases, not-a-number where a case has none
    reasons      why a case has no numbers, "" where it has
    records      name -> (ncase, ntime); `times` (ntime,) s
    attributes   words about the sweep; "warnings" of its cases, one a line
    """

    parameters: tuple[Column, ...]
    results: tuple[Column, ...]
    reasons: tuple[str, ...]
    shape: tuple[int, ...] = ()
    steps: tuple[Column, ...] = ()
    records: tuple[Column, ...] = ()
    times: np.ndarray | None = None
    attributes: dict[str, Any] = field(default_factory=dict)

    def __len__(self) -> int:
        return len(self.reasons)

    @property
    def warnings(self) -> list[str]:
        """What must be said of the cases."""
        return _lines_of(self.attributes)

    def column(self, name: str) -> Column:
        """A parameter or result by name; KeyError names what there is."""
        for column in (*self.parameters, *self.results):
            if column.name == name:
                return column
        raise KeyError(f"no column '{name}'; the table has: {', '.join(c.name for c in (*self.parameters, *self.results))}")


def _lines_of(attributes) -> list[str]:
    return [line for line in str(attributes.get("warnings", "")).split("\n") if line]


def warnings_of(path) -> list[str]:
    """What must be said of the cases, from sweep.h5. Raises `FileTrouble`."""
    from hugoniot.output.atomic import legible
    from hugoniot.output.listed import check_listed

    check_listed(path)      # before HDF5 opens it
    with legible(path), h5py().File(path, "r") as file:
        return _lines_of(file.attrs)


def together(values: np.ndarray) -> np.ndarray:
    """The records (ncase, ntime) of the cases that have one, not-a-number at times that some of these have not reached."""
    found = values[np.isfinite(values).any(axis=1)]
    return np.where(np.isfinite(found).all(axis=0), found, np.nan)


# -- cases.csv -------------------------------------------------------------------------------------------------------
def write_cases(path, table: SweepTable):
    """Write cases.csv: number, parameters and results under `name [unit]`, and the reason where a case failed."""
    return write_parts(path, _lines(table))


def _lines(table: SweepTable) -> Iterator[bytes]:
    columns = (*table.parameters, *table.results)
    yield _row(["case", *(f"{c.name} [{c.unit}]" if c.unit else c.name for c in columns), "reason"])
    for k in range(len(table)):
        yield _row([k + 1, *(_cell(c.values[k]) for c in columns), table.reasons[k]])


def _cell(value) -> str:
    if isinstance(value, str):
        return value
    number = float(value)
    return "" if number != number else repr(number)


def _row(cells: Sequence) -> bytes:
    out = io.StringIO()
    csv.writer(out, lineterminator="\n").writerow(cells)
    return out.getvalue().encode()


# -- sweep.h5 --------------------------------------------------------------------------------------------------------
def write_table(path, table: SweepTable):
    """Write sweep.h5, whole or not at all."""
    size = sum(c.values.nbytes for c in (*table.parameters, *table.results, *table.records))
    return write_hdf5(path, lambda file, check: _fill(file, table, check), size)


def dataset_name(name: str) -> str:
    """A name that HDF5 takes: a slash would make a group."""
    return re.sub(r"/", "|", name)


def _fill(file, table: SweepTable, check) -> None:
    file.attrs["format"] = FORMAT
    for key, value in table.attributes.items():
        file.attrs[key] = value
    axes, shape = _axes(file, table)
    stepped = {column.name for column in table.steps}
    for column in table.parameters:
        if column.name not in stepped:
            _attached(_put(file, column.name, column.values.reshape(shape), column.unit), axes)
    for column in table.results:
        check()
        _attached(_put(file, column.name, column.values.reshape(shape), column.unit), axes)
    _attached(_put(file, "reason", np.array(table.reasons, dtype=object).reshape(shape), ""), axes)
    if table.records and table.times is not None:
        time = _put(file, "time", table.times, "s")
        time.make_scale("time")
        for column in table.records:
            check()
            name = f"record {column.name}"
            _attached(_put(file, name, column.values.reshape(*shape, -1), column.unit), [*axes, time])


def _axes(file, table: SweepTable):
    """(the datasets that are axes, shape of a column)."""
    axes = []
    if not table.shape:
        axes.append(_put(file, "case", np.arange(1, len(table) + 1), ""))
    for column in table.steps if table.shape else ():
        axes.append(_put(file, column.name, column.values, column.unit))
    for data in axes:
        data.make_scale(data.name.lstrip("/"))
    return axes, table.shape or (len(table),)


def _put(file, name: str, values: np.ndarray, unit: str):
    place = dataset_name(name)
    if values.dtype.kind in "UO":
        data = file.create_dataset(place, data=values.astype(object), dtype=h5py().string_dtype())
    else:
        data = file.create_dataset(place, data=values, **sound_layout(values.shape, values.itemsize))
        if unit:
            data.attrs["units"] = unit
    data.attrs["long_name"] = name
    return data


def _attached(data, axes) -> None:
    for k, axis in enumerate(axes):
        data.dims[k].attach_scale(axis)


def open_sweep(path):
    """sweep.h5 as an xarray Dataset in memory, parameters as coordinates. Raises `FileTrouble`."""
    import xarray

    from hugoniot.output.atomic import legible
    from hugoniot.output.listed import check_listed

    check_listed(path)      # before HDF5 opens it
    with legible(path), xarray.open_dataset(path, engine="h5netcdf", phony_dims="sort") as found:
        loaded = found.load()
    names = [dataset_name(name) for name in str(loaded.attrs.get("parameters", "")).split("\n") if name]
    return loaded.set_coords([name for name in names if name in loaded.data_vars])
