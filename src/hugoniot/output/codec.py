"""A nested dictionary of arrays, numbers and words as the bytes of an HDF5 file, and back, bit for bit.

The file is built in memory, so that it can be hashed before it touches the disk and checked before HDF5 opens it.
Arrays are datasets; everything else stands in one JSON text, whose numbers Python reads back exactly.
"""

import io
import json
from typing import Any

import numpy as np

from hugoniot.errors import FileTrouble

_MARK = "__array__"


def h5py():
    """The h5py module, imported when the first file is written or read."""
    import h5py

    return h5py


def new_image(name: str = "memory"):
    """An HDF5 file in memory, open for writing; `image_bytes` gives its bytes."""
    return h5py().File(name, "w", driver="core", backing_store=False, block_size=1 << 20)


def image_bytes(file) -> bytes:
    """The bytes the in-memory file would have on disk."""
    file.flush()
    return file.id.get_file_image()


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
    raise TypeError(f"a checkpoint cannot hold {type(value).__name__}; give arrays, numbers, words, lists and dictionaries of them")


def _unpack(value: Any, arrays) -> Any:
    if isinstance(value, dict):
        if _MARK in value:
            return arrays[str(value[_MARK])][()]
        return {key: _unpack(inner, arrays) for key, inner in value.items()}
    if isinstance(value, list):
        return [_unpack(inner, arrays) for inner in value]
    return value


def encode(payload: dict) -> bytes:
    """The bytes of an HDF5 file that holds `payload`: arrays of numbers, floats, ints, bools, words, None, lists, nested dictionaries."""
    arrays: list[np.ndarray] = []
    document = json.dumps(_pack(payload, arrays))
    with new_image() as file:
        file["document"] = document
        group = file.create_group("arrays")
        for k, array in enumerate(arrays):
            group.create_dataset(str(k), data=array)
        return image_bytes(file)


def decode(data: bytes) -> dict:
    """The payload of `encode`; tuples come back as lists."""
    try:
        with h5py().File(io.BytesIO(data), "r") as file:
            return _unpack(json.loads(file["document"].asstr()[()]), file["arrays"])
    except (OSError, KeyError, ValueError) as error:
        raise FileTrouble(f"the stored data cannot be read: {error}") from error
