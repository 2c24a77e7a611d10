"""A nested dictionary of arrays, numbers and words as an HDF5 file, and back, bit for bit.

Arrays are datasets; everything else stands in one JSON text, whose numbers Python reads back exactly.
"""

import contextlib
import functools
import io
import json
from collections.abc import Callable
from typing import Any

import numpy as np

from hugoniot.errors import FileTrouble
from hugoniot.output.hdf5 import CHUNK_BYTES, h5py, image_bytes, new_image, sound_layout, write_hdf5

_MARK = "__array__"


def _pack(value: Any, arrays: list) -> Any:
    if isinstance(value, np.ndarray):
        arrays.append(value)
        return {_MARK: len(arrays) - 1}
    if isinstance(value, np.generic):
        return value.item()
    if isinstance(value, dict):
        return {str(key): _pack(inner, arrays) for key, inner in value.items()}
    if isinstance(value, (list, tuple)):
        return [_pack(inner, arrays) for inner in value]
    if value is None or isinstance(value, (bool, int, float, str)):
        return value
    raise TypeError(f"a checkpoint cannot hold {type(value).__name__}; give arrays, numbers, strings, and lists and dictionaries of these")


def _unpack(value: Any, array: Callable[[str], Any]) -> Any:
    if isinstance(value, dict):
        if _MARK in value:
            return array(str(value[_MARK]))
        return {key: _unpack(inner, array) for key, inner in value.items()}
    if isinstance(value, list):
        return [_unpack(inner, array) for inner in value]
    return value


def _fill(file, document: str, arrays: list[np.ndarray], check: Callable[[], None]) -> None:
    file["document"] = document
    group = file.create_group("arrays")
    for k, array in enumerate(arrays):
        check()
        group.create_dataset(str(k), data=array, **(sound_layout(array.shape, array.itemsize) if array.nbytes > CHUNK_BYTES else {}))


def encode(payload: dict) -> bytes:
    """The bytes of an HDF5 file that holds `payload`: arrays of numbers, floats, ints, bools, words, None, lists, nested dictionaries."""
    arrays: list[np.ndarray] = []
    document = json.dumps(_pack(payload, arrays))
    with new_image() as file:
        _fill(file, document, arrays, lambda: None)
        return image_bytes(file)


def store(path, payload: dict, durable: bool = True):
    """Write what `encode` gives to a file, whole or not at all, large arrays straight to the disk; its length and SHA-256 (`Written`)."""
    arrays: list[np.ndarray] = []
    document = json.dumps(_pack(payload, arrays))
    size = len(document) + sum(array.nbytes for array in arrays)
    return write_hdf5(path, lambda file, check: _fill(file, document, arrays, check), size, durable)


class Stored:
    """An array in an open file, which is looked for only when something is asked of it."""

    def __init__(self, group, name: str):
        self._group, self._name = group, name

    @functools.cached_property
    def _data(self):
        return self._group[self._name]

    @property
    def shape(self) -> tuple[int, ...]:
        return self._data.shape

    @property
    def dtype(self) -> np.dtype:
        return self._data.dtype

    def __len__(self) -> int:
        return len(self._data)

    def __getitem__(self, part):
        return self._data[part]


@contextlib.contextmanager
def opened(source):
    """The payload in a file (its path, or its bytes), whose arrays are read only when they are indexed: `array[()]`, `array[3:9]`."""
    try:
        with h5py().File(io.BytesIO(source) if isinstance(source, bytes) else source, "r") as file:
            stored = file["arrays"]
            yield _unpack(json.loads(file["document"].asstr()[()]), lambda name: Stored(stored, name))
    except (OSError, KeyError, ValueError, RuntimeError) as error:
        if isinstance(error, FileTrouble):
            raise
        raise FileTrouble(f"the stored data cannot be read: not an HDF5 file written by hugoniot, or damaged ({error})") from error


def _read(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _read(inner) for key, inner in value.items()}
    if isinstance(value, list):
        return [_read(inner) for inner in value]
    return value[()] if isinstance(value, Stored) else value


def decode(source) -> dict:
    """The payload of `encode` or `store`, from its bytes or its path; tuples come back as lists."""
    with opened(source) as payload:
        return _read(payload)
