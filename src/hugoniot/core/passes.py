"""Passes: small compiled loops over rows of zones, one for each law, which a march calls by their address.

A *pass* is a function

    pass(count, rows, dt, numbers, law)

of the number of zones, a NamedTuple of rows (`core.rows`), the time step, a row of numbers (the law's parameters), and the type of the
law's parameter tuple. `Pass.address` compiles it for one law, keeps the machine code on disk, and gives its address. Whoever calls it
(`core.pass_lists`) knows the rows but not the law, so that one compiled march serves every law and every combination of laws. Passes of the
geometry are compiled for a geometry instead of a law, others for neither. With one call per some hundred zones, the cost of the call is
negligible.
"""

import functools
from collections import namedtuple
from typing import get_type_hints

import numba as nb
import numpy as np
from llvmlite import ir
from numba import types
from numba.core import cgutils
from numba.extending import intrinsic

from hugoniot.core.binder import bind_callees, bind_choice
from hugoniot.core.compile_ahead import Job, job_of, job_of_types
from hugoniot.core.kinds import key_of_value, kind_of_value, kinds_of
from hugoniot.core.registry import Registry
from hugoniot.core.rows import ROW, row_at, rows, rows_apart
from hugoniot.core.target import BY_ADDRESS, EXACT_PASS, NAN_PASS, PASS

# whoever writes passes takes the words for rows and for passes from here
__all__ = ["ROW", "Entry", "Pass", "bind_flag", "call_entry", "flag_of", "kind_of", "law_of", "named", "numbers_of",
           "row_at", "rows", "rows_apart", "zone_pass"]


# -- laws as numbers -----------------------------------------------------------------------------------------------
def numbers_of(par) -> np.ndarray:
    """A law's parameters, laws inside it included, as one row of numbers: floats in order, of an array its address and sizes.

    The arrays must live as long as the numbers are used.
    """
    words: list[float] = []

    def put(value):
        if isinstance(value, tuple):
            for part in value:
                put(part)
        elif isinstance(value, np.ndarray):
            words.extend(np.array([value.ctypes.data, *value.shape], dtype=np.int64).view(np.float64))
        else:
            words.append(float(value))

    put(par)
    return np.array(words or [0.0])


@intrinsic
def law_of(typingctx, law, numbers):
    """The parameter tuple of the type `law` refers to, its fields read from the row `numbers` (see `numbers_of`)."""
    def codegen(context, builder, sig, args):
        at = 0

        def word(kind):
            nonlocal at
            pointer = builder.gep(args[1], [context.get_constant(types.intp, at)])
            at += 1
            if kind != types.float64:
                pointer = builder.bitcast(pointer, context.get_value_type(types.int64).as_pointer())
            return builder.load(pointer)

        def fill(kind):
            if isinstance(kind, types.BaseTuple):
                return context.make_tuple(builder, kind, [fill(field) for field in kind.types])
            if isinstance(kind, types.Array):
                return _array(context, builder, kind, word)
            return word(types.float64)

        return fill(sig.return_type)

    return law.instance_type(law, numbers), codegen


@intrinsic
def kind_of(typingctx, law):
    """A value of the type `law` refers to without numbers: for what is chosen by type alone, such as a geometry."""
    return law.instance_type(law), lambda context, builder, sig, args: cgutils.get_null_value(context.get_value_type(sig.return_type))


@intrinsic
def named(typingctx, cls, numbers):
    """The first numbers of a row as a NamedTuple of class `cls`."""
    kind = types.NamedTuple([types.float64] * len(cls.instance_class._fields), cls.instance_class)

    def codegen(context, builder, sig, args):
        found = [builder.load(builder.gep(args[1], [context.get_constant(types.intp, k)])) for k in range(len(kind))]
        return context.make_tuple(builder, kind, found)

    return kind(cls, numbers), codegen


def _array(context, builder, kind, word):
    """An array of the compiled type `kind` from words: its address and its sizes."""
    address = word(types.int64)
    sizes = [word(types.int64) for _ in range(kind.ndim)]
    steps, step = [], context.get_constant(types.intp, 8)
    for size in reversed(sizes):
        steps.insert(0, step)
        step = builder.mul(step, size)
    array = context.make_array(kind)(context, builder)
    data = builder.inttoptr(address, ir.DoubleType().as_pointer())
    count = functools.reduce(builder.mul, sizes, context.get_constant(types.intp, 1))
    context_array = dict(data=data, shape=cgutils.pack_array(builder, sizes), strides=cgutils.pack_array(builder, steps),
                         itemsize=context.get_constant(types.intp, 8), nitems=count,
                         meminfo=cgutils.get_null_value(array.meminfo.type), parent=cgutils.get_null_value(array.parent.type))
    for name, value in context_array.items():
        setattr(array, name, value)
    return array._getvalue()


# -- passes ----------------------------------------------------------------------------------------------------------
def rows_type(cls):
    """Compiled type of a NamedTuple of rows; fields whose annotation is a NamedTuple hold rows of their own."""
    hints = get_type_hints(cls)
    return types.NamedTuple([rows_type(hints[name]) if hasattr(hints.get(name), "_fields") else ROW for name in cls._fields], cls)


class Pass:
    """A loop over rows of zones, compiled for each law (or geometry) it meets.

    function   the plain function (count, rows, dt, numbers, law); it must stand at the top level of a module
    rows       the NamedTuple class of its rows
    """

    def __init__(self, function, rows, options):
        self.function, self.rows, self.options = function, rows, options
        self.compiled = nb.njit(**options)(function)
        self._addresses: dict = {}

    def address(self, par=None) -> int:
        """Address of the pass compiled for the law whose parameters `par` are (None: for no law); compiled now unless it is on disk."""
        law = key_of_value(par)
        if law not in self._addresses:
            arguments = self._arguments(kind_of_value(par))
            self.compiled.compile(arguments)
            result = self.compiled.overloads[arguments]
            self._addresses[law] = result.library.get_pointer_to_function(result.fndesc.llvm_func_name)
        return self._addresses[law]

    def job(self, par=None) -> Job | None:
        """What is left to do for the law whose parameters `par` are; None if it is done."""
        if key_of_value(par) in self._addresses:
            return None
        return job_of_types(self.compiled, self._arguments(kind_of_value(par)))

    def _arguments(self, law):
        bind_callees(self.function)
        return (types.int64, rows_type(self.rows), types.float64, ROW, types.TypeRef(law))


def zone_pass(rows, exact: bool = False, finite: bool = True, **groups):
    """Decorator: make a `Pass` over `rows`: their names in one string, or a NamedTuple class of them.

    exact    without fast-math
    finite   whether fast-math may take every number for a finite one: not where one that is not is looked for
    groups   NamedTuple classes of those names that stand for rows of their own
    """
    options = EXACT_PASS if exact else PASS if finite else NAN_PASS

    def made(function):
        cls = rows if isinstance(rows, type) else namedtuple(f"{function.__name__}_rows", rows, module=function.__module__)
        if cls is not rows:
            cls.__qualname__ = f"{function.__name__}.rows"      # where whoever reads compiled code from the disk finds it
            cls.__annotations__ = groups
        return functools.update_wrapper(Pass(function, cls, options), function)

    return made


def _yes(par):
    return True


def _no(par):
    return False


def bind_flag(function, family: Registry, flag: str) -> None:
    """Let kernels ask `function(par)` whether a law of the family has a flag; the answer is known when the kernel is compiled."""
    bind_choice(function, lambda cls: _yes if flag in family.of_class(cls).flags else _no)


def flag_of(family: Registry, flag: str):
    """The function (par) -> whether a law of the family has a flag, for Python and, known when they are compiled, for kernels."""
    def has_flag(par) -> bool:
        return flag in family.of(par).flags

    bind_flag(has_flag, family, flag)
    return has_flag


# -- whole functions by address ----------------------------------------------------------------------------------------
class Entry:
    """A compiled function that others call by its address: it is not compiled once more into each of its callers."""

    def __init__(self, function):
        self.compiled = nb.njit(**BY_ADDRESS)(function)
        self._addresses: dict = {}

    def job(self, *arguments) -> Job:
        """What is left to do for arguments of these types."""
        return job_of(self.compiled, arguments)

    def address(self, *arguments) -> int:
        """Address of the function compiled for arguments of these types; compiled now unless it is on disk."""
        key = key_of_value(arguments)
        if key not in self._addresses:
            kinds = kinds_of(arguments)
            self.compiled.compile(kinds)
            result = self.compiled.overloads[kinds]
            self._addresses[key] = result.library.get_pointer_to_function(result.fndesc.llvm_func_name)
        return self._addresses[key]


@intrinsic
def call_entry(typingctx, address, one, two, three):
    """Call the `Entry` of three arguments and no result that stands at `address`; it was compiled for just these types."""
    arguments = (one, two, three)

    def codegen(context, builder, sig, args):
        function = builder.inttoptr(args[0], context.call_conv.get_function_type(types.none, arguments).as_pointer())
        context.call_conv.call_function(builder, function, types.none, arguments, args[1:])
        return context.get_dummy_value()

    return types.void(types.int64, *arguments), codegen
