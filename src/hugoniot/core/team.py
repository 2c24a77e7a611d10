"""A team of threads inside compiled code: one leads, the others wait on a word in memory and do their share.

A conventional parallel region costs some microseconds, as long as a thousand zones take; a phase here costs a fraction of
that. The leader issues a command by raising the phase counter, every member does its own pieces, and the leader
continues when all have signed off. Shares are fixed by the number of the piece, so results depend neither on the number of threads nor on
which thread does a share.

On a loaded machine a member may lose its core in the middle of a share, and the leader then waits some
milliseconds where a phase takes a hundredth of one. No thread therefore spins for longer than PATIENCE, and the leader compares
the time that phases of the team take with the time it needs for the same commands alone. When the accumulated loss exceeds a limit, the
leader does all shares itself for REST times as long as was lost, and then tries again: a team costs at most about 1/REST more time than one
thread. If the next attempt fails as well, the rest is doubled, up to LONGEST_REST, until the team has gained its CREDIT: on a machine that
stays busy hardly any time is lost. A march that begins during a rest has no other threads at all (`at_work`), because threads that only
sleep and poll would still take some hundredths of the leader's time.

Words of the board, in lines of 8 (cache lines): line 0: phase, command, rest; line 1, the leader's: account (ns), when to share again (ns),
when this phase began (ns), whether it is shared, its command, their number; line m + 1, of member m: its signature; words 6 and 7 of these
lines are for reading the clock; last two lines: how long each command takes alone (ns).
"""

import os
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from typing import NamedTuple

import numba as nb
import numpy as np
from llvmlite import ir
from numba import types
from numba.core import cgutils
from numba.extending import intrinsic

from hugoniot.core.target import BY_ADDRESS, GUARD

DISMISSED = -1
AWAY = -2                   # signature of a member whose thread has not begun
LINE = 8
SPINS = 2000
PATIENCE = 100_000          # ns of waiting before a thread sleeps
SHORTEST_SLEEP, LONGEST_SLEEP = 50, 1000     # microseconds
OVERDRAWN, CREDIT = -500_000, 5_000_000     # ns: bounds of the account
REST = 10
LONGEST_REST = 1_000_000_000      # ns, or REST times what was lost if that is longer
NEVER = 2**62
COMPARES = 251              # each such phase is done alone, to know how long it takes; a prime, so that it meets every command
RESTING = 2                 # by how much longer than what was lost the next rest is
ACCOUNT, SHARE_AGAIN, BEGAN, SHARED, COMMAND, PHASES = range(LINE, LINE + 6)
COMMANDS = 2 * LINE          # counted apart
FORGETS = 64                # share by which a known time grows while longer ones are met


class Team(NamedTuple):
    """Threads, the leader's own among them, and the board they meet at."""

    threads: int
    board: np.ndarray


def board(threads: int) -> np.ndarray:
    """A fresh board for a team."""
    fresh = np.zeros((threads + 1) * LINE + COMMANDS, dtype=np.int64)
    fresh[RESTING] = REST
    return fresh


def possible() -> bool:
    """Whether this system has what a team needs (POSIX yield, sleep and clock)."""
    return os.name == "posix"


def team_of(threads: int, zones: int, worth_sharing: int) -> Team:
    """A team of at most `threads`, or one thread where there are fewer zones than are worth sharing."""
    threads = min(threads, os.cpu_count() or 1) if zones >= worth_sharing and possible() else 1
    return Team(threads, board(threads))


def cores_for(threads: int) -> list[int]:
    """A core for each member of a team that needs all those the process may use; none otherwise.

    Left to the system, two members may share a core while another idles. Where there are more cores than members the system does better,
    since other processes, which may have teams of their own, need room as well.
    """
    cores = sorted(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else []
    return cores if len(cores) == threads else []


def hold(cores: set[int]) -> None:
    """Keep the calling thread on these cores, where that is allowed."""
    with suppress(OSError):
        os.sched_setaffinity(0, cores)


@contextmanager
def on_core(cores: list[int], member: int) -> Iterator[None]:
    """Keep the calling thread on the core of a member of the team, if it has one."""
    if not cores:
        yield
        return
    hold({cores[member]})
    try:
        yield
    finally:
        hold(set(cores))


@contextmanager
def at_work(team: Team, serve: Callable, plan) -> Iterator[None]:
    """The other threads of a team during a march, each in `serve(member, phase, plan, team)`; none while the team rests."""
    if team.threads == 1:
        yield
        return
    phase, again = int(team.board[0]), int(team.board[SHARE_AGAIN])
    if again > time.clock_gettime_ns(time.CLOCK_MONOTONIC):
        team.board[SHARE_AGAIN] = NEVER
        try:
            yield
        finally:
            team.board[SHARE_AGAIN] = again
        return
    cores = cores_for(team.threads)

    signatures = [LINE * (member + 1) for member in range(team.threads)]

    def work(member):
        with on_core(cores, member):
            team.board[signatures[member]] = phase
            serve(member, phase, plan, team)

    team.board[signatures[1:]] = AWAY
    members = [threading.Thread(target=work, args=(k,), daemon=True) for k in range(1, team.threads)]
    for member in members:
        member.start()
    try:
        with on_core(cores, 0):
            yield
    finally:
        call(team.board, DISMISSED)
        for member in members:
            member.join()


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


@intrinsic
def _clock(typingctx, board, line):
    """Nanoseconds of the steady clock, read by way of words 6 and 7 of a line of the board."""
    def codegen(context, builder, signature, args):
        data = context.make_array(signature.args[0])(context, builder, args[0]).data
        place = builder.gep(data, [builder.add(builder.mul(args[1], args[1].type(LINE)), args[1].type(LINE - 2))])
        kind = ir.FunctionType(ir.IntType(32), [ir.IntType(32), place.type])
        function = cgutils.get_or_insert_function(builder.module, kind, "clock_gettime")
        builder.call(function, [ir.Constant(ir.IntType(32), time.CLOCK_MONOTONIC), place])
        seconds, rest = builder.load(place), builder.load(builder.gep(place, [args[1].type(1)]))
        return builder.add(builder.mul(seconds, seconds.type(1_000_000_000)), rest)
    return types.int64(board, types.intp), codegen


_yield = types.ExternalFunction("sched_yield", types.int32())
_sleep = types.ExternalFunction("usleep", types.int32(types.uint32))


@nb.njit(**BY_ADDRESS)
def _await(board, word, value, changes, line):
    """Wait until a word is `value`, or (`changes`) until it is not; `line` of the board is the waiting thread's own."""
    spins, began, nap = 0, 0, SHORTEST_SLEEP
    while (_read(board, word) == value) == changes:
        spins += 1
        if spins == SPINS:
            began = _clock(board, line)
        elif spins > SPINS:
            if _clock(board, line) - began < PATIENCE:
                _yield()
            else:
                _sleep(nap)
                nap = min(2 * nap, LONGEST_SLEEP)


@nb.njit(**GUARD)
def call(board, command):
    """Leader: start a phase with a command, in which every member takes part."""
    board[SHARED] = 1
    board[1] = command
    _write(board, 0, board[0] + 1)


@nb.njit(**GUARD)
def begin(board, command, threads):
    """Leader: start a phase with a command; how many shares, from the first, the leader is to do: one, or all while it works alone."""
    board[COMMAND], board[BEGAN], board[PHASES] = command, _clock(board, 1), board[PHASES] + 1
    if (board[BEGAN] < board[SHARE_AGAIN] or board[PHASES] % COMPARES == 0 or board[_known(command, threads)] == 0
            or not _complete(board, threads)):
        board[SHARED] = 0
        return threads
    call(board, command)
    return 1


@nb.njit(**BY_ADDRESS)
def _complete(board, threads):
    """Whether the threads of all members have begun: until then the leader works alone instead of waiting for them."""
    away = 0
    for member in range(1, threads):
        away += _read(board, LINE * (member + 1)) == AWAY
    return away == 0


@nb.njit(**BY_ADDRESS)
def _known(command, threads):
    """Word that holds how long a command takes alone."""
    return LINE * (threads + 1) + command % COMMANDS


@nb.njit(**GUARD)
def gather_team(board, threads):
    """Leader: wait until every member has signed the phase, and settle the account."""
    known = _known(board[COMMAND], threads)
    if board[SHARED] == 0:
        took = max(_clock(board, 1) - board[BEGAN], 1)
        board[known] = took if board[known] == 0 else min(took, board[known] + board[known] // FORGETS + 1)
        return
    for member in range(1, threads):
        _await(board, LINE * (member + 1), board[0], False, 1)
    if board[1] == DISMISSED:
        return
    now = _clock(board, 1)
    board[ACCOUNT] = min(board[ACCOUNT] + board[known] - (now - board[BEGAN]), CREDIT)
    if board[ACCOUNT] == CREDIT:
        board[RESTING] = REST
    elif board[ACCOUNT] < OVERDRAWN:
        lost = -board[ACCOUNT]
        board[SHARE_AGAIN] = now + max(REST * lost, min(board[RESTING] * lost, LONGEST_REST))
        board[RESTING] = min(2 * board[RESTING], LONGEST_REST // -OVERDRAWN)
        board[ACCOUNT] = 0


@nb.njit(**BY_ADDRESS)
def await_call(board, phase, member):
    """Member: wait for the phase after `phase`; its number."""
    _await(board, 0, phase, True, member + 1)
    return _read(board, 0)


@nb.njit(**GUARD)
def sign(board, member, phase):
    """Member: done with this phase."""
    _write(board, LINE * (member + 1), phase)
