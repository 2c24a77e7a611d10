"""Passes of the solver over rows: like the law passes of `core.passes`, compiled alone, kept on disk and called by their address.

A march that had them all inlined would be one function that takes minutes to compile. A pass takes

    pass(count, given, dt, numbers, law)

`given` a NamedTuple whose fields are rows or NamedTuples of rows, as their annotations say; `numbers` a row of further numbers.
"""

import functools
from typing import get_type_hints

import numba as nb
from llvmlite import ir
from numba import types
from numba.extending import intrinsic

from hugoniot.core.passes import ROW
from hugoniot.core.target import PASS


def given_type(cls):
    """Compiled type of a NamedTuple of rows, nested ones included."""
    hints = get_type_hints(cls)
    fields = [given_type(hints[name]) if hasattr(hints.get(name), "_fields") else ROW for name in cls._fields]
    return types.NamedUniTuple(ROW, len(fields), cls) if all(f is ROW for f in fields) else types.NamedTuple(fields, cls)


class RowPass:
    """A pass that is compiled once."""

    def __init__(self, function, given):
        self.function, self.given = function, given
        self.compiled = nb.njit(**PASS)(function)

    @functools.cached_property
    def address(self) -> int:
        """Address of the compiled pass; compiled now unless it is on disk."""
        arguments = (types.int64, given_type(self.given), types.float64, ROW, types.TypeRef(nb.typeof(None)))
        self.compiled.compile(arguments)
        result = self.compiled.overloads[arguments]
        return result.library.get_pointer_to_function(result.fndesc.llvm_func_name)


def row_pass(given):
    """Decorator: make a `RowPass` that takes the NamedTuple class `given`."""
    return lambda function: functools.update_wrapper(RowPass(function, given), function)


@intrinsic
def spread(typingctx, cls, table, first):
    """The rows of a table (rows, zones) from zone `first` on as a NamedTuple of class `cls`, one pointer each: what a pass is given."""
    kind = given_type(cls.instance_class)

    def codegen(context, builder, sig, args):
        array = context.make_array(sig.args[1])(context, builder, args[1])
        start = builder.ptrtoint(builder.gep(array.data, [args[2]]), ir.IntType(64))
        pitch = builder.extract_value(array.strides, 0)
        places = [builder.add(start, builder.mul(pitch, context.get_constant(types.intp, k))) for k in range(len(kind))]
        return context.make_tuple(builder, kind, [builder.inttoptr(place, ir.DoubleType().as_pointer()) for place in places])

    return kind(cls, table, types.intp), codegen
