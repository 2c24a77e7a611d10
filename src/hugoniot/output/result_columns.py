"""Columns of one group of result.h5, read when they are asked for."""

import weakref
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from hugoniot.errors import FileTrouble
from hugoniot.output.hdf5 import h5py
from hugoniot.output.result_layout import AXES, ORDER, Described, axes_of, in_order, places_of

KEPT = 32_000_000   # bytes up to which a column stays in memory; of a larger one only as long as somebody uses it
BLOCK = 8_000_000   # bytes of a large column that are read at a time where its records are asked for one by one


class Records(Sequence):
    """Arrays by their numbers, each made by `read(k)` when it is asked for: a column of which one record at a time is in memory."""

    def __init__(self, count: int, read: Callable):
        self._count, self._read = count, read

    def __len__(self) -> int:
        return self._count

    def __getitem__(self, k):
        if not -self._count <= k < self._count:
            raise IndexError(f"no record {k} of {self._count}")
        return self._read(int(k) % self._count)


def record_by_record(rows: Mapping, name: str) -> "np.ndarray | Records":
    """The records of a column of `Columns` (a large one is not read as a whole), or of other arrays by name. KeyError if there is none."""
    return rows.records(name) if isinstance(rows, Columns) else rows[name]


def shape_of(rows: Mapping, name: str) -> tuple[int, ...]:
    """The shape of a column, which is not read for it."""
    return rows.shapes[name] if isinstance(rows, Columns) else np.shape(rows[name])


def extent(rows: Mapping, name: str) -> tuple[float, float]:
    """The least and the largest value of a column, without those that are missing (NaN); NaN if all are."""
    return rows.extent(name) if isinstance(rows, Columns) else _extent_of(rows[name])


def _extent_of(found) -> tuple[float, float]:
    blocks = [found] if isinstance(found, np.ndarray) else found
    ends = np.array([(np.fmin.reduce(block, axis=None), np.fmax.reduce(block, axis=None)) for block in blocks], dtype=float)
    return float(np.fmin.reduce(ends[:, 0])), float(np.fmax.reduce(ends[:, 1]))


def history(rows: Mapping, name: str, k: int) -> np.ndarray:
    """The entry k of every record of a column."""
    return rows.history(name, k) if isinstance(rows, Columns) else rows[name][:, k]


class Columns(Mapping):
    """Arrays by name. A column is read once, and when it is large read again after everybody has let it go.

    shapes   {name: shape} and
    kinds    {name: dtype in the file}, known without reading
    """

    def __init__(self, open_file: Callable, place: str, group: str, shapes: dict[str, tuple], kinds: dict[str, np.dtype]):
        self._open, self._place, self._group, self.shapes, self.kinds = open_file, place, group, shapes, kinds
        self._kept: dict[str, np.ndarray] = {}
        self._extents: dict[str, tuple[float, float]] = {}
        self._lent: Any = weakref.WeakValueDictionary()

    @classmethod
    def described(cls, open_file: Callable, place: str, group) -> "tuple[Columns, dict, dict]":
        """The columns of an open group, their attributes, and the names of the axes of each."""
        shapes, kinds, attributes, dims = {}, {}, {}, {}
        try:
            axes = {name: group[name] for name in AXES.get(str(group.name).strip("/"), ()) if name in group}
            places = places_of(axes)
            written = in_order(str(group.attrs.get(ORDER, "")), group)[0]   # HDF5 itself keeps names in the order of the alphabet
            for name in sorted(group, key=lambda name: (written.index(name) if name in written else -1, name)):
                data = group[name]
                shapes[name], kinds[name] = data.shape, data.dtype
                attributes[name] = {k: data.attrs[k] for k in ("units", "long_name") if k in data.attrs}
                dims[name] = (name,) if name in axes else axes_of(data, places)
        except (OSError, RuntimeError, AttributeError, ValueError, IndexError, KeyError) as error:
            raise FileTrouble(f"{place}: damaged, cannot be read ({error})") from error
        return cls(open_file, place, group.name, shapes, kinds), attributes, dims

    @classmethod
    def of(cls, open_file: Callable, place: str, group: str, found: Described) -> "tuple[Columns, dict, dict]":
        """As `described`, of a group that was looked at already."""
        return cls(open_file, place, group, found.shapes, found.kinds), found.attributes, found.dims

    def __iter__(self) -> Iterator[str]:
        return iter(self.shapes)

    def __len__(self) -> int:
        return len(self.shapes)

    def __contains__(self, name) -> bool:
        return name in self.shapes

    def __getitem__(self, name: str) -> np.ndarray:
        if name not in self.shapes:
            raise KeyError(name)
        found = self._kept.get(name)
        found = self._lent.get(name) if found is None else found
        if found is None:
            found = self._read(name)
            (self._kept if found.nbytes <= KEPT else self._lent)[name] = found
        return found

    def records(self, name: str) -> "np.ndarray | Records":
        """The column, if it is small or in memory; else its records, of which a block at a time is read."""
        if name not in self.shapes:
            raise KeyError(name)
        count, *entries = self.shapes[name] or (1,)
        size = self.kinds[name].itemsize * int(np.prod(entries))
        if not self.is_large(name) or name in self._lent:
            return self[name]
        rows, held = max(1, BLOCK // size), {}

        def read(k: int) -> np.ndarray:
            first = k - k % rows
            if first not in held:
                held.clear()
                held[first] = self._read(name, slice(first, first + rows))
            return held[first][k - first]

        return Records(count, read)

    def extent(self, name: str) -> tuple[float, float]:
        """The least and the largest value of a column, looked for once."""
        if name not in self._extents:
            self._extents[name] = _extent_of(self.records(name))
        return self._extents[name]

    def history(self, name: str, k: int) -> np.ndarray:
        """The entry k of every record."""
        return self._read(name, (slice(None), k)) if self.is_large(name) else self[name][:, k]

    def is_large(self, name: str) -> bool:
        """Whether a column is of numbers and too large to be kept in memory."""
        return self.kinds[name].kind in "fiub" and self.kinds[name].itemsize * int(np.prod(self.shapes[name])) > KEPT

    def part(self, name: str, key: tuple) -> np.ndarray:
        """What `key`, of integers and slices of positive step, selects of a column; nothing else is read."""
        return self._read(name, key)

    def _read(self, name: str, part=()) -> np.ndarray:
        try:
            with self._open() as file:
                data = file[self._group][name]
                text = h5py().check_string_dtype(data.dtype) is not None
                return np.array(data.asstr()[part], dtype=object) if text else data[part]
        except FileTrouble:
            raise
        except (OSError, RuntimeError, KeyError, ValueError) as error:
            raise FileTrouble(f"{self._place}/{name}: damaged, cannot be read ({error})") from error
