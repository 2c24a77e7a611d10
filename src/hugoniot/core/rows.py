"""Rows of zones as compiled code sees them: bare pointers to float64 numbers, and views that name the rows of a table.

In a kernel `z.rho[j]` reads the j-th number of the row `rho` of a view of a table, or of a NamedTuple of rows; in Python the same source
works on a NamedTuple of numpy arrays. Bare pointers make a call as cheap as in C, and an index into them is never wrapped around, which
would prevent vectorisation.
"""

import operator

from llvmlite import ir
from numba import types
from numba.core import cgutils
from numba.core.datamodel import models
from numba.core.extending import register_model
from numba.core.imputils import lower_builtin, lower_getattr_generic
from numba.core.typing.templates import AbstractTemplate, AttributeTemplate, infer_getattr, infer_global, signature
from numba.extending import intrinsic, overload


class RowType(types.Type):
    """Compiled type of a row: a pointer to float64."""

    def __init__(self):
        super().__init__(name="Row")


ROW = RowType()


@register_model(RowType)
class _RowModel(models.PrimitiveModel):
    def __init__(self, manager, kind):
        super().__init__(manager, kind, ir.DoubleType().as_pointer())


@infer_global(operator.getitem)
class _ReadRow(AbstractTemplate):
    def generic(self, args, kws):
        if len(args) == 2 and args[0] is ROW and isinstance(args[1], types.Integer):
            return signature(types.float64, ROW, types.intp)
        return None


@infer_global(operator.setitem)
class _WriteRow(AbstractTemplate):
    def generic(self, args, kws):
        if len(args) == 3 and args[0] is ROW and isinstance(args[1], types.Integer):
            return signature(types.none, ROW, types.intp, types.float64)
        return None


@lower_builtin(operator.getitem, RowType, types.Integer)
def _read(context, builder, sig, args):
    return builder.load(builder.gep(args[0], [args[1]]))


@lower_builtin(operator.setitem, RowType, types.Integer, types.Float)
def _write(context, builder, sig, args):
    builder.store(args[2], builder.gep(args[0], [args[1]]))
    return context.get_dummy_value()


class ViewType(types.Type):
    """Compiled type of what is read by name out of a table: its rows from one zone on, or the numbers of one of its lines.

    A view is an address; what is asked of it is computed where it is asked, so that a view of forty rows costs no more than one.
    """

    def __init__(self, kind, cls, dtype=types.float64):
        self.kind, self.cls, self.dtype = kind, cls, dtype
        super().__init__(name=f"{kind}({cls.__module__}.{cls.__qualname__}, {dtype})")


@register_model(ViewType)
class _ViewModel(models.StructModel):
    def __init__(self, manager, view):
        super().__init__(manager, view, [("start", types.intp), ("pitch", types.intp)])


@infer_getattr
class _ViewFields(AttributeTemplate):
    key = ViewType

    def generic_resolve(self, view, field):
        if field in view.cls._fields:
            return ROW if view.kind == "rows" else view.dtype
        return None


@lower_getattr_generic(ViewType)
def _field_of_view(context, builder, view, value, field):
    parts = cgutils.create_struct_proxy(view)(context, builder, value)
    place = context.get_constant(types.intp, view.cls._fields.index(field))
    address = builder.add(parts.start, builder.mul(parts.pitch, place))
    if view.kind == "rows":
        return builder.inttoptr(address, ir.DoubleType().as_pointer())
    return builder.load(builder.inttoptr(address, context.get_value_type(view.dtype).as_pointer()))


def _view(context, builder, view, start, pitch):
    parts = cgutils.create_struct_proxy(view)(context, builder)
    parts.start, parts.pitch = builder.ptrtoint(start, ir.IntType(64)), pitch
    return parts._getvalue()


def rows(cls, table, first):
    """The rows of a table (rows, zones) from zone `first` on, by the names of the NamedTuple class `cls`: its k-th is the k-th row."""
    return cls(*(row[first:] for row in table[:len(cls._fields)]))


@intrinsic
def _rows(typingctx, cls, table, first):
    view = ViewType("rows", cls.instance_class)

    def codegen(context, builder, sig, args):
        array = context.make_array(sig.args[1])(context, builder, args[1])
        return _view(context, builder, view, builder.gep(array.data, [args[2]]), builder.extract_value(array.strides, 0))

    return view(cls, table, types.intp), codegen


@overload(rows, jit_options={"_nrt": False, "forceinline": True})
def _(cls, table, first):
    return lambda cls, table, first: _rows(cls, table, first)


@intrinsic
def row_at(typingctx, address):
    """The row at an address (an integer)."""
    return ROW(types.intp), lambda context, builder, sig, args: builder.inttoptr(args[0], ir.DoubleType().as_pointer())


@intrinsic
def rows_apart(typingctx):
    """Promise that the rows (and float arrays) a function takes do not overlap where one is written; said once, at its top.

    Without the promise the vectoriser compares every pair of rows each time the loop is entered, and must store what it has only read.
    """
    def codegen(context, builder, sig, args):
        for argument in builder.function.args[2:]:   # after the return value and the exception
            if isinstance(argument.type, ir.PointerType) and argument.type.pointee == ir.DoubleType():
                argument.add_attribute("noalias")
        return context.get_dummy_value()

    return types.void(), codegen
