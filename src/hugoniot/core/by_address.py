"""A NamedTuple of arrays passed to compiled code by its address: one pointer, however many arrays it has.

A NamedTuple of arrays is passed from one compiled function to the next as six to ten words for each array, in every call: several
hundred for a large one, which costs as much as a short loop. By its address it is one word. What a function needs is read from a list
of words where it is used and, because nothing writes to that list, only once.
"""

from typing import Any

import numpy as np
from llvmlite import ir
from numba import types
from numba.core import cgutils
from numba.core.datamodel import models
from numba.core.extending import register_model
from numba.core.imputils import lower_getattr_generic
from numba.core.typing.templates import AttributeTemplate, infer_getattr
from numba.extending import typeof_impl

from hugoniot.core.kinds import kind_of_value

WORD = ir.IntType(64)


class ByAddress:
    """Makes the words of a NamedTuple of C-ordered arrays and numbers; compiled code reads it from `address` as long as this lives."""

    def __init__(self, value: Any):
        self.value, self.words = value, np.array([word for part in value for word in _words(part)], dtype=np.int64)
        self.address = int(self.words.ctypes.data)


def _words(part) -> list[int]:
    """An array as its address and its sizes, a number as its own word."""
    if isinstance(part, np.ndarray):
        if not part.flags.c_contiguous:
            raise ValueError("an array that is reached by its address alone must be in C order")
        return [part.ctypes.data, *part.shape]
    return [int(np.float64(part).view(np.int64)) if isinstance(part, float) else int(part)]


class AddressType(types.Type):
    """Compiled type of a `ByAddress`; kind: that of its NamedTuple."""

    def __init__(self, kind):
        self.kind = kind
        super().__init__(name=f"ByAddress({kind})")


@typeof_impl.register(ByAddress)
def _kind(value, _):
    return AddressType(kind_of_value(value.value))


@register_model(AddressType)
class _AddressModel(models.PrimitiveModel):
    def __init__(self, manager, kind):
        super().__init__(manager, kind, WORD.as_pointer())


@infer_getattr
class _Fields(AttributeTemplate):
    key = AddressType

    def generic_resolve(self, address, field):
        return address.kind.types[address.kind.fields.index(field)] if field in address.kind.fields else None


@lower_getattr_generic(AddressType)
def _field(context, builder, address, value, field):
    at = address.kind.fields.index(field)
    first, kind = sum(_size(each) for each in address.kind.types[:at]), address.kind.types[at]

    def word(k, pointer=value):
        found = builder.load(builder.gep(pointer, [WORD(first + k)]))
        found.set_metadata("invariant.load", builder.module.add_metadata([]))
        return found

    if isinstance(kind, types.Array):
        return _array(context, builder, kind, word)
    if isinstance(kind, types.Float):
        return word(0, builder.bitcast(value, ir.DoubleType().as_pointer()))
    return builder.trunc(word(0), context.get_value_type(kind)) if kind == types.boolean else word(0)


def _size(kind) -> int:
    """How many words a field has."""
    return 1 + kind.ndim if isinstance(kind, types.Array) else 1


def _array(context, builder, kind, word):
    """An array in C order from its words."""
    made, sizes = context.make_array(kind)(context, builder), [word(1 + k) for k in range(kind.ndim)]
    item = context.get_abi_sizeof(context.get_data_type(kind.dtype))
    steps, count = [], WORD(1)
    for size in reversed(sizes):
        steps.insert(0, builder.mul(count, WORD(item)))
        count = builder.mul(count, size)
    made.data = builder.inttoptr(word(0), context.get_data_type(kind.dtype).as_pointer())
    made.shape, made.strides = cgutils.pack_array(builder, sizes), cgutils.pack_array(builder, steps)
    made.itemsize, made.nitems = WORD(item), count
    made.meminfo, made.parent = cgutils.get_null_value(made.meminfo.type), cgutils.get_null_value(made.parent.type)
    return made._getvalue()
