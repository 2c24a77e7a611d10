"""Compiled types of Python values, remembered by their structure: numba takes them apart anew each time it is asked."""

from typing import Any

import numba as nb
import numpy as np

_known: dict[Any, Any] = {}
_PLAIN = (float, int, bool, type(None))     # of which one value is compiled as any other


def kind_of_value(value) -> Any:
    """The compiled type of an argument, as `numba.typeof` has it."""
    shape = _structure(value)
    if shape is None:
        return nb.typeof(value)
    if shape not in _known:
        _known[shape] = nb.typeof(value)
    return _known[shape]


def key_of_value(value) -> Any:
    """What values of one compiled type share, to look things up by: numba works the hash of a type out anew each time it is asked."""
    shape = _structure(value)
    return nb.typeof(value) if shape is None else shape


def kinds_of(arguments: tuple) -> tuple:
    """The compiled types of arguments."""
    return tuple(kind_of_value(argument) for argument in arguments)


def _structure(value) -> Any:
    """What decides the compiled type of a value: classes, and of arrays the layout; None for a value of which that is not known."""
    cls = type(value)
    if cls in _PLAIN:
        return cls if cls is not int or -2**63 <= value < 2**63 else None
    if cls is np.ndarray:
        flags = value.flags
        return value.dtype, value.ndim, flags.c_contiguous, flags.f_contiguous, flags.writeable, flags.aligned
    if not isinstance(value, tuple):
        return None
    parts = [cls]
    for part in value:
        found = _structure(part)
        if found is None:
            return None
        parts.append(found)
    return tuple(parts)
