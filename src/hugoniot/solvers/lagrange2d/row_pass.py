"""Passes of the solver over rows: like the law passes of `core.passes`, compiled alone, kept on disk and called by their address.

A march that had them all inlined would be one function that takes minutes to compile. A pass takes

    pass(count, given, dt, numbers, law)

`given` a NamedTuple whose fields are rows or NamedTuples of rows, as their annotations say; `numbers` a row of further numbers.
"""

import functools
from typing import NamedTuple, get_type_hints

import numba as nb
from numba import types

from hugoniot.core.compile import PASS
from hugoniot.core.passes import ROW


class NoLaw(NamedTuple):
    """In the place of a law's parameters."""

    nothing: float = 0.0


def given_type(cls):
    """Compiled type of a NamedTuple of rows, nested ones included."""
    hints = get_type_hints(cls)
    fields = [given_type(hints[name]) if hasattr(hints[name], "_fields") else ROW for name in cls._fields]
    return types.NamedUniTuple(ROW, len(fields), cls) if all(f is ROW for f in fields) else types.NamedTuple(fields, cls)


class RowPass:
    """A pass that is compiled once."""

    def __init__(self, function, given):
        self.function, self.given = function, given
        self.compiled = nb.njit(**PASS)(function)

    @functools.cached_property
    def address(self) -> int:
        """Address of the compiled pass; compiled now unless it is on disk."""
        arguments = (types.int64, given_type(self.given), types.float64, ROW, types.TypeRef(nb.typeof(NoLaw())))
        self.compiled.compile(arguments)
        result = self.compiled.overloads[arguments]
        return result.library.get_pointer_to_function(result.fndesc.llvm_func_name)


def row_pass(given):
    """Decorator: make a `RowPass` that takes the NamedTuple class `given`."""
    return lambda function: functools.update_wrapper(RowPass(function, given), function)
