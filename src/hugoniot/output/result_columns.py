"""Columns of one group of result.h5, read when they are asked for."""

import weakref
from collections.abc import Callable, Iterator, Mapping
from typing import Any

import numpy as np

from hugoniot.errors import FileTrouble
from hugoniot.output.hdf5 import h5py

ORDER = "columns"   # attribute of a group: the names of its columns in the order in which they were recorded
KEPT = 32_000_000   # bytes up to which a column stays in memory; of a larger one only as long as somebody uses it


class Columns(Mapping):
    """Arrays by name. A column is read once, and when it is large read again after everybody has let it go.

    shapes   {name: shape}, known without reading
    """

    def __init__(self, open_file: Callable, place: str, group: str, shapes: dict[str, tuple]):
        self._open, self._place, self._group, self.shapes = open_file, place, group, shapes
        self._kept: dict[str, np.ndarray] = {}
        self._lent: Any = weakref.WeakValueDictionary()

    @classmethod
    def described(cls, open_file: Callable, place: str, group) -> "tuple[Columns, dict, dict]":
        """The columns of an open group, their attributes, and the names of the axes of each."""
        shapes, attributes, dims = {}, {}, {}
        try:
            written = str(group.attrs.get(ORDER, "")).split()   # HDF5 itself keeps names in the order of the alphabet
            for name in sorted(group, key=lambda name: (written.index(name) if name in written else -1, name)):
                data = group[name]
                shapes[name] = data.shape
                attributes[name] = {k: data.attrs[k] for k in ("units", "long_name") if k in data.attrs}
                dims[name] = (name,) if data.is_scale else tuple(data.dims[k][0].name.rpartition("/")[2] for k in range(data.ndim))
        except (OSError, RuntimeError, AttributeError, ValueError) as error:
            raise FileTrouble(f"{place}: cannot be read ({error})") from error
        return cls(open_file, place, group.name, shapes), attributes, dims

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

    def _read(self, name: str) -> np.ndarray:
        try:
            with self._open() as file:
                data = file[self._group][name]
                text = h5py().check_string_dtype(data.dtype) is not None
                return np.array(data.asstr()[()], dtype=object) if text else data[()]
        except FileTrouble:
            raise
        except (OSError, RuntimeError, KeyError, ValueError) as error:
            raise FileTrouble(f"{self._place}/{name}: damaged, cannot be read ({error})") from error
