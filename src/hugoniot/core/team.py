"""A team of threads inside compiled code: one leads, the others wait on a word in memory and do their share.

A parallel region of the usual kind costs some microseconds, as long as a thousand zones take; a phase here costs a fraction of
one. The leader publishes a command by raising the phase counter, every member does the pieces that are its own, and the leader
goes on when all have signed off. Shares are fixed by the piece's number, so the number of threads changes no bit.

Words of the board: 0 phase, 1 command, then one signature for each member, a cache line (8 words) apart.
"""

import os
from typing import NamedTuple

import numba as nb
import numpy as np
from numba import types
from numba.extending import intrinsic

from hugoniot.core.target import GUARD

DISMISSED = -1
LINE = 8
SPINS = 2000


class Alone(NamedTuple):
    """One thread."""

    threads: int = 1


class Together(NamedTuple):
    """Several threads and the board they meet at."""

    threads: int
    board: np.ndarray


def board(threads: int) -> np.ndarray:
    """A fresh board for a team."""
    return np.zeros((threads + 2) * LINE, dtype=np.int64)


def possible() -> bool:
    """Whether this system has what a team needs (POSIX yield)."""
    return os.name == "posix"


@intrinsic
def _read(typingctx, array, index):
    def codegen(context, builder, signature, args):
        data = context.make_array(signature.args[0])(context, builder, args[0]).data
        return builder.load_atomic(builder.gep(data, [args[1]]), "acquire", 8)
    return types.int64(array, types.intp), codegen


@intrinsic
def _write(typingctx, array, index, value):
    def codegen(context, builder, signature, args):
        data = context.make_array(signature.args[0])(context, builder, args[0]).data
        builder.store_atomic(args[2], builder.gep(data, [args[1]]), "release", 8)
        return context.get_dummy_value()
    return types.void(array, types.intp, types.int64), codegen


_yield = types.ExternalFunction("sched_yield", types.int32())


@nb.njit(**GUARD)
def call(board, command):
    """Leader: start a phase with a command."""
    board[1] = command
    _write(board, 0, board[0] + 1)


@nb.njit(**GUARD)
def gather_team(board, threads):
    """Leader: wait until every member has signed the phase."""
    phase = board[0]
    for member in range(1, threads):
        spins = 0
        while _read(board, LINE * (member + 1)) != phase:
            spins += 1
            if spins > SPINS:
                _yield()


@nb.njit(**GUARD)
def await_call(board, phase):
    """Member: wait for the phase after `phase`; its number."""
    spins = 0
    while _read(board, 0) == phase:
        spins += 1
        if spins > SPINS:
            _yield()
    return _read(board, 0)


@nb.njit(**GUARD)
def sign(board, member, phase):
    """Member: done with this phase."""
    _write(board, LINE * (member + 1), phase)
