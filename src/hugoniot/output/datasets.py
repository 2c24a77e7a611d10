"""Columns of result.h5 as an xarray Dataset; importing xarray takes half a second, so this file is imported where one is asked for."""

from collections.abc import Collection, Mapping
from typing import Any

import numpy as np
import xarray
from xarray.backends import BackendArray
from xarray.core import indexing

from hugoniot.output.result_columns import Columns


class LargeColumn(BackendArray):
    """A column too large to be kept. What an index selects is read from the file when its values are needed."""

    def __init__(self, columns: Columns, name: str):
        self._columns, self._name = columns, name
        self.shape, self.dtype = columns.shapes[name], columns.kinds[name]

    def __getitem__(self, key) -> np.ndarray:
        # BASIC: slices of positive step and integers, the selections that HDF5 knows; xarray makes the others from these
        return indexing.explicit_indexing_adapter(key, self.shape, indexing.IndexingSupport.BASIC, self._part)

    def _part(self, key: tuple) -> np.ndarray:
        return self._columns.part(self._name, key)


def dataset(columns: Columns, dims: Mapping[str, tuple[str, ...]], attributes: Mapping[str, dict], coordinates: Collection[str],
            about: dict[str, Any]) -> xarray.Dataset:
    """The Dataset of a group: large columns of numbers stay in the file, and each selection of them is read from it anew.

    dims, attributes   of every column: names of its axes, units and long name
    coordinates        names of the columns that are coordinates
    about              attributes of the Dataset
    """
    variables = {}
    for name in columns:
        values = columns[name] if not columns.is_large(name) else indexing.CopyOnWriteArray(
            indexing.LazilyIndexedArray(LargeColumn(columns, name)))
        variables[name] = xarray.Variable(dims[name], values, attributes[name])
    coords = {name: variables.pop(name) for name in sorted(coordinates)}
    return xarray.Dataset(variables, coords, about)
