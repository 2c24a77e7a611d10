"""What result.h5 must be like for those who read it: its groups, their columns, and the axes and kinds of these.

A file that another program wrote may have the right checksums. What departs from `result_file.write_result` is named as soon as the file is
opened, so that no reader has to expect it. Nothing outside the file is read for it: links and numbers that lie elsewhere are refused.
"""

import math
from collections.abc import Iterable
from typing import NamedTuple

import numpy as np

from hugoniot.output.hdf5 import h5py

ORDER = "columns"   # attribute of a group: the names of its columns in the order in which they were recorded
AXES = {"snapshots": ("time", "zone", "node"), "gauges": ("time", "gauge"), "budget": ("time", "region"), "peaks": ("zone",),
        "events": ("event",), "mesh": ("zone", "corner")}
_LISTED = ("snapshots", "gauges", "budget")     # groups that have listed their columns for as long as there are checksums
_NEEDED = {"snapshots": ("cycle", "region", "mass"), "peaks": ("region", "mass"), "events": ("time", "cycle", "kind", "text", "numbers"),
           "mesh": ("zone_nodes", "block_of")}
_SHOWN = ("units", "long_name")                 # attributes of a column
_TEXTS = ("region", "gauge", "kind", "text", "numbers")
_WHOLE = ("cycle", "zone", "node", "corner", "event", "zone_nodes", "block_of")


def in_order(written: str, names: Iterable[str]) -> tuple[list[str], list[str]]:
    """(columns in the order that the attribute `ORDER` tells, names in it that no column has); names may contain blanks themselves."""
    known, words = set(names), written.split(" ") if written else []
    longest = max((name.count(" ") for name in known), default=0) + 1
    found, lost, k = [], [], 0
    while k < len(words):
        name = next((name for n in range(longest, 0, -1) if (name := " ".join(words[k:k + n])) in known), None)
        if name is None:
            lost.append(words[k])
        else:
            found.append(name)
        k += 1 if name is None else name.count(" ") + 1
    return found, lost


class Misfit(ValueError):
    """A file that is not as a run leaves it; says in what."""


class Described(NamedTuple):
    """Shape, kind, attributes and names of the axes of every column of a group, in the order in which they were recorded."""

    shapes: dict[str, tuple]
    kinds: dict
    attributes: dict[str, dict[str, str]]
    dims: dict[str, tuple[str, ...]]


def described(file, listed: bool) -> dict[str, Described]:
    """The groups of an open result. Raises `Misfit`, such as "gauges: the dataset 'velocity' is missing", and what HDF5 raises for damage.

    listed   whether the columns must be listed; those of early runs were not
    """
    holder = _own(file, "setup")
    if not isinstance(holder, h5py().Group):
        raise Misfit("the group 'setup' is missing")
    for name in ("document", "deck"):
        data = _own(holder, name)
        if not isinstance(data, h5py().Dataset):
            raise Misfit(f"setup: the dataset '{name}' is missing")
        if data.external or data.is_virtual or data.shape != () or h5py().check_string_dtype(data.dtype) is None:
            raise Misfit(f"setup/{name}: is not a single string")
    found = {group: _described(_own(file, group), group, listed) for group in AXES if group != "mesh" or "mesh" in file}
    for name in ("centre", "centre_x", "centre_y"):
        if name in found["peaks"].shapes and name not in found["snapshots"].shapes:
            raise Misfit(f"snapshots: the dataset '{name}' is missing")
    return found


def _described(table, group: str, listed: bool) -> Described:
    if not isinstance(table, h5py().Group):
        raise Misfit(f"the group '{group}' is missing")
    axes, names, order = AXES[group], list(table), []
    wanted = [*(name for name in axes if name != "node"), *_NEEDED.get(group, ())]
    if ORDER in table.attrs or group in _LISTED and listed:
        written = table.attrs.get(ORDER)
        if not isinstance(written, str):
            state = "missing" if written is None else "not a string"
            raise Misfit(f"{group}: the attribute '{ORDER}', which lists what was recorded, is {state}")
        order, lost = in_order(written, names)
        wanted += lost
    lost = [name for name in wanted if name not in names]
    if lost:
        raise Misfit(f"{group}: the dataset '{lost[0]}' is missing")
    found, own = Described({}, {}, {}, {}), {name: _own(table, name) for name in names}
    places = places_of({name: data for name, data in own.items() if name in axes and data is not None})
    for name in sorted(names, key=lambda name: name not in axes):      # the lengths of the axes are asked for by the others
        try:
            _describe_column(own[name], group, name, places, found)
        except Misfit as error:
            raise Misfit(f"{group}/{name}: {error}") from None
    inside = {name: place for place, name in enumerate(order)}
    ordered = sorted(names, key=lambda name: (inside.get(name, -1), name))      # HDF5 itself keeps names in the order of the alphabet
    return Described(*({name: part[name] for name in ordered} for part in found))


def _own(group, name: str):
    """A member of a group that lies in the group itself, not behind a link; None else."""
    try:
        return group[name] if isinstance(group.get(name, getlink=True), h5py().HardLink) else None
    except (KeyError, OSError, RuntimeError):
        return None


def _describe_column(data, group: str, name: str, places: dict[int, str], found: Described) -> None:
    """Add a column to those found before it, its axes among them, which lie at `places` of the file. Raises `Misfit`."""
    if not isinstance(data, h5py().Dataset):
        raise Misfit("is not a dataset")
    shape, kind = data.shape, data.dtype
    if name in AXES[group]:
        along = (name,)
        if len(shape or ()) != 1:
            raise Misfit("must be a one-dimensional array")
    else:
        along = axes_of(data, places)
        short = along == ("time",) and (group == "gauges" or group == "snapshots" and name not in _WHOLE)
        if not along or short or shape != tuple(found.shapes[axis][0] for axis in along if axis in found.shapes):
            raise Misfit(f"has {_size(shape)}, which do not fit the axes of '{group}'")
    _check_kind(data, name, shape, kind)
    attributes = {key: data.attrs[key] for key in _SHOWN if key in data.attrs}
    for key, words in attributes.items():
        if not isinstance(words, str):
            raise Misfit(f"the attribute '{key}' is not a string")
    for part, value in zip(found, (shape, kind, attributes, along)):
        part[name] = value


def _size(shape: tuple | None) -> str:
    return f"{' x '.join(map(str, shape))} values" if shape else "no array of values"


def axes_of(data, places: dict[int, str]) -> tuple[str, ...]:
    """The axes to which a column is tied, those of its own group; empty where it is not tied to them.

    Read from the attribute itself: HDF5's own way to them ends the process where the attribute is of another kind.
    """
    rank, found = len(data.shape or ()), []
    ties = data.attrs.get_id("DIMENSION_LIST") if "DIMENSION_LIST" in data.attrs else None
    if ties is None or ties.shape != (rank,):
        return ()
    if h5py().check_ref_dtype(h5py().check_vlen_dtype(ties.dtype) or ties.dtype) is not h5py().Reference:
        return ()
    for tied in data.attrs["DIMENSION_LIST"]:
        axis = h5py().h5r.dereference(tied[0], data.id) if np.size(tied) == 1 and tied[0] else None
        name = places.get(h5py().h5o.get_info(axis).addr) if axis else None
        if name is None:
            return ()
        found.append(name)
    return tuple(found) if 1 <= len(found) <= 2 and len(set(found)) == len(found) else ()


def places_of(axes: dict) -> dict[int, str]:
    """Where in the file the axes of a group lie: {address: name}."""
    return {h5py().h5o.get_info(data.id).addr: name for name, data in axes.items()}


def _check_kind(data, name: str, shape: tuple, kind) -> None:
    if data.external or data.is_virtual:
        raise Misfit("its values are stored in another file")
    if name in _TEXTS:
        if h5py().check_string_dtype(kind) is None:
            raise Misfit(f"holds values of type {kind}, not strings")
        return
    kinds = "iu" if name in _WHOLE else "f" if name == "time" else "fiu"
    if kind.kind not in kinds or kind.subdtype is not None or h5py().check_enum_dtype(kind) is not None:
        raise Misfit(f"holds values of type {kind}, not {'whole ' if name in _WHOLE else ''}numbers")
    if kind.kind == "f" and kind.itemsize != 8:
        raise Misfit(f"holds values of type {kind}, not float64")
    size = kind.itemsize * math.prod(shape)
    if size and data.id.get_storage_size() < size:
        raise Misfit("its values are missing")
