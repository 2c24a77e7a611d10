"""Parameter tuples as rows of a table, and rows that do not overlap: what a kernel is handed."""

from llvmlite import ir
from numba import types
from numba.extending import intrinsic


@intrinsic
def parameters(typingctx, proto, row):
    """A parameter tuple of the class of `proto` with its float fields read in order from the 1-D array `row`.

    Fields that are not floats (tables) are taken from `proto` itself. Lets one compiled sweep serve any number of
    materials of one law: their numbers live in an array, only the law's class is part of the compiled type.
    """
    def codegen(context, builder, signature, args):
        array = context.make_array(signature.args[1])(context, builder, args[1])
        column = 0

        def fill(kind, value):
            nonlocal column
            parts = []
            for i, field in enumerate(kind.types):
                inner = builder.extract_value(value, i)
                if field == types.float64:
                    pointer = builder.gep(array.data, [context.get_constant(types.intp, column)])
                    parts.append(builder.load(pointer))
                    column += 1
                else:
                    parts.append(fill(field, inner) if isinstance(field, types.BaseTuple) else inner)
            return context.make_tuple(builder, kind, parts)

        return fill(signature.return_type, args[0])

    return proto(proto, row), codegen


@intrinsic
def rows_apart(typingctx):
    """Promise that the float arrays a function takes as arguments do not overlap; said once, at the top of a sweep over rows of a table.

    Without the promise the vectoriser compares every pair of rows each time the sweep is entered, most of a microsecond for
    twenty-five rows, and must store what it has only read.
    """
    def codegen(context, builder, signature, args):
        for argument in builder.function.args[2:]:   # after the return value and the exception
            if isinstance(argument.type, ir.PointerType) and argument.type.pointee == ir.DoubleType():
                argument.add_attribute("noalias")
        return context.get_dummy_value()

    return types.void(), codegen


def float_row(par) -> list[float]:
    """The float fields of a parameter tuple in order, nested laws included: one row of the table that `parameters` reads."""
    row: list[float] = []
    for value in par:
        if isinstance(value, tuple):
            row += float_row(value)
        elif isinstance(value, (int, float)):
            row.append(float(value))
    return row
