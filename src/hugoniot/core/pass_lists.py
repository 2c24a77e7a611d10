"""Lists of passes: a step written down as data, and the loop that carries it out.

A solver writes its step in Python, once, as a list of passes with the rows each works on. Stored as numbers (`write`), the list needs no
compilation of its own: one small loop, `carry_out`, compiled once on a machine, executes the passes of any list in order. The passes that a
material needs are chosen in Python while the list is made; nothing is decided while it runs.

The position of a row is a `Place`: its address for zone 0 and the number of the *origin* that moves it, so that one list serves every piece
of zones. The caller gives the origins, in bytes; origin `FIXED` stays at 0, for scratch memory and for constants.
"""

from collections.abc import Iterable, Iterator
from typing import Any, NamedTuple

import numba as nb
import numpy as np
from llvmlite import ir
from numba import types
from numba.core import cgutils
from numba.extending import intrinsic

from hugoniot.core.compile_ahead import Job
from hugoniot.core.kinds import key_of_value
from hugoniot.core.passes import Pass
from hugoniot.core.rows import ROW, row_at
from hugoniot.core.target import BY_ADDRESS

FIXED = 0            # the origin that never moves
MOST_ROWS = 40       # that one pass may take
ADDRESS, NUMBERS, STEP, ROWS, FIRST_ROW = range(5)      # columns of the table of operations


class Place(NamedTuple):
    """Where a row begins: the address of its element 0, and the origin that moves it."""

    address: int
    origin: int


def place(array: np.ndarray, origin: int = FIXED) -> Place:
    """The place of a contiguous row of float64. The array must outlive the lists that name it."""
    return Place(array.ctypes.data, origin)


def places(cls, table: np.ndarray, origin: int, first: int = 0) -> Any:
    """The rows of a table (rows, n) from column `first` on, by the names of the NamedTuple class `cls`."""
    pitch, step = table.strides
    start = table.ctypes.data + first * step
    return cls(*(Place(start + k * pitch, origin) for k in range(len(cls._fields))))


class Operation(NamedTuple):
    """A pass with what it works on: its law or geometry (None: none), rows (`Place`s, or tuples of them), numbers, time step."""

    of: Pass
    law: Any
    rows: tuple
    numbers: np.ndarray
    step: Place


class Written(NamedTuple):
    """Lists in numbers, as compiled code reads them.

    operations   (n, 5): the columns ADDRESS to FIRST_ROW
    operands     (m, 2): the `Place` of each of their rows
    """

    operations: np.ndarray
    operands: np.ndarray


def jobs(lists: Iterable[list[Operation]]) -> list[Job]:
    """The passes of lists that have yet to be compiled."""
    each = {(operation.of, key_of_value(operation.law)): operation for one in lists for operation in one}
    return [job for operation in each.values() if (job := operation.of.job(operation.law)) is not None]


def write(lists: Iterable[list[Operation]]) -> tuple[Written, list[tuple[int, int]]]:
    """(the lists in numbers, first and last operation of each). The lists must outlive them; compiles the passes that are not on disk."""
    lists = list(lists)
    every = [operation for one in lists for operation in one]
    operations, operands = np.zeros((len(every), 5), dtype=np.int64), [Place(0, FIXED)]
    for line, operation in zip(operations, every):
        rows = list(_flat(operation.rows))
        if len(rows) > MOST_ROWS or len(operation.rows) != len(operation.of.rows._fields):
            raise ValueError(f"{operation.of.__name__} takes {operation.of.rows._fields}, at most {MOST_ROWS} rows, not {operation.rows}")
        line[:] = operation.of.address(operation.law), operation.numbers.ctypes.data, operation.step.address, len(rows), len(operands)
        operands += rows
    ends = np.cumsum([0, *map(len, lists)]).tolist()
    return Written(operations, np.array(operands, dtype=np.int64)), list(zip(ends[:-1], ends[1:]))


def _flat(rows) -> Iterator[Place]:
    for each in rows:
        if isinstance(each, Place):
            yield each
        else:
            yield from _flat(each)


# -- carried out -------------------------------------------------------------------------------------------------------
@intrinsic
def call_pass(typingctx, address, count, rows, pointers, step, numbers):
    """Call a compiled pass by its address, from compiled code.

    address    of the pass, as `operations` of a written list holds it
    count      zones it works on
    rows       rows it takes, 1 to MOST_ROWS; nothing is called for any other number
    pointers   (rows,) or longer: address of the first zone of each row, in bytes
    step       the time step, s
    numbers    the pass's own numbers
    """
    def codegen(context, builder, sig, args):
        given = _words(context, builder, sig, args, 3)

        def pointer(i):
            return builder.load(builder.gep(given, [ir.IntType(64)(i)]))

        return _call_with(context, builder, args[0], args[1], args[2], pointer, args[4], args[5])

    return types.void(types.int64, types.int64, types.int64, pointers, types.float64, ROW), codegen


@intrinsic
def call_moved(typingctx, address, count, rows, operands, origins, step, numbers):
    """The same with rows that stand at places: operands (rows, 2) or longer, their `Place`s; origins (n,) in bytes."""
    def codegen(context, builder, sig, args):
        given, moved = _words(context, builder, sig, args, 3), _words(context, builder, sig, args, 4)

        def pointer(i):
            at, origin = (builder.load(builder.gep(given, [ir.IntType(64)(2 * i + k)])) for k in range(2))
            return builder.add(at, builder.load(builder.gep(moved, [origin])))

        return _call_with(context, builder, args[0], args[1], args[2], pointer, args[5], args[6])

    return types.void(types.int64, types.int64, types.int64, operands, origins, types.float64, ROW), codegen


def _words(context, builder, sig, args, k):
    return context.make_array(sig.args[k])(context, builder, args[k]).data


def _call_with(context, builder, address, count, rows, pointer, step, numbers):
    """Call the pass with `rows` pointers; it takes its rows as separate arguments, so each number of rows is a call of its own."""
    nothing = cgutils.get_null_value(context.get_value_type(types.voidptr))
    # where a compiled function puts its result and its exception: passes have neither, and one place does for the calls of all lengths
    unused = [cgutils.alloca_once(builder, kind.pointee) for kind in context.call_conv.get_function_type(types.none, ()).args[:2]]
    done = builder.append_basic_block("done")
    chosen = builder.switch(rows, done)
    for n in range(1, MOST_ROWS + 1):
        case = builder.append_basic_block(f"rows{n}")
        chosen.add_case(ir.IntType(64)(n), case)
        builder.position_at_end(case)
        kinds = (types.int64, *[ROW] * n, types.float64, ROW, types.voidptr)
        function = builder.inttoptr(address, context.call_conv.get_function_type(types.none, kinds).as_pointer())
        found = [builder.inttoptr(pointer(i), ir.DoubleType().as_pointer()) for i in range(n)]
        builder.call(function, [*unused, count, *found, step, numbers, nothing])
        builder.branch(done)
    builder.position_at_end(done)
    return context.get_dummy_value()


@nb.njit(**BY_ADDRESS)
def carry_out(written, first, last, zones, piece, origins):
    """Operations first to last - 1 of written lists over `zones` zones, `piece` of them at a time.

    origins    (n,) of the first zone in bytes, with origins[FIXED] = 0
    """
    done = 0
    while done < zones:
        count = min(zones - done, piece)
        for k in range(first, last):
            operation = written.operations[k]
            call_moved(operation[ADDRESS], count, operation[ROWS], written.operands[operation[FIRST_ROW]:], origins,
                       row_at(operation[STEP])[0], row_at(operation[NUMBERS]))
        done += count
        if zones > piece:
            step = 8 * count if done < zones else -8 * (zones - count)      # on to the next piece, in the end back to the first one
            for i in range(FIXED + 1, origins.shape[0]):
                origins[i] += step
