"""Sharing the work of a step: a command over all pieces, done alone or by the threads of a team, and the totals of what they found.

A command names one loop over zones or nodes. Every piece is worked on by one thread, and totals are taken over the pieces in their
order, so that no bit of a result depends on the number of threads.
"""

import numba as nb
from numba.extending import overload

from hugoniot.core.passes import call_entry, call_pass, record, row, rows
from hugoniot.core.target import GUARD, INLINE
from hugoniot.core.team import DISMISSED, Alone, await_call, begin, gather_team, sign
from hugoniot.solvers.lagrange1d.layout import NodeRows, ZoneRows
from hugoniot.solvers.lagrange1d.nodes import AccelerateRows, LeapRows, MoveRows
from hugoniot.solvers.lagrange1d.work import Steps
from hugoniot.zones.soundness import FOUND_FAILURE, FOUND_FLOATS, FOUND_IMPULSE, FOUND_RATE

ACCELERATE, PREDICT, MOVE, CORRECT = range(4)
LEAP, ADVANCE = range(2)


@nb.njit(**INLINE)
def nodes_of(a, command, scheme, i):
    """One command over span i of inner nodes."""
    first, segment = a.spans[i, 0], a.spans[i, 2]
    count, steps = a.spans[i, 1] - first - 1, record(Steps, a.steps, 0)
    z, h, dt = rows(ZoneRows, a.zones, first), rows(NodeRows, a.nodes, first + segment), a.dts[0]
    if scheme.staggered:
        call_pass(steps.leap, count, LeapRows(z.sigma, z.pull, z.width, h.inverse_mass, h.u, h.r), dt, row(a.dts, 1))
    elif command == ACCELERATE:
        call_pass(steps.accelerate, count, AccelerateRows(z.sigma, z.hoop, h.r, h.u, h.inverse_mass, h.u_mean, h.r_half), dt, row(a.dts, 1))
    else:
        call_pass(steps.move, count, MoveRows(z.sigma_half, z.hoop_half, h.r_half, h.inverse_mass, h.u, h.u_mean, h.r), dt, row(a.dts, 1))


@nb.njit(**INLINE)
def moves_zones(command, scheme):
    """Whether a command is one for zones."""
    return command == ADVANCE if scheme.staggered else command in (PREDICT, CORRECT)


@nb.njit(**INLINE)
def do_share(a, command, scheme, member, of):
    """One command over one member's share of the pieces."""
    if moves_zones(command, scheme):
        steps = record(Steps, a.steps, 0)
        address = steps.advance if scheme.staggered else steps.predict if command == PREDICT else steps.correct
        for i in range(member, a.runs.shape[0], of):
            call_entry(address, a, i, member)
    else:
        for i in range(member, a.spans.shape[0], of):
            nodes_of(a, command, scheme, i)


def everyone(a, command, scheme, team):
    """One command over all pieces, shared out if there is a team."""
    raise NotImplementedError("compiled only")


@overload(everyone, jit_options=INLINE)
def _(a, command, scheme, team):
    def alone(a, command, scheme, team):
        do_share(a, command, scheme, 0, 1)

    def together(a, command, scheme, team):
        for share in range(begin(team.board, command, team.threads)):
            do_share(a, command, scheme, share, team.threads)
        gather_team(team.board, team.threads)

    return alone if team.instance_class is Alone else together


@nb.njit(**GUARD)
def serve(member, phase, a, scheme, team):
    """What every other thread of a team does during a march: the leader's commands on its own share, until dismissed."""
    while True:
        phase = await_call(team.board, phase, member)
        command = team.board[1]
        if command != DISMISSED:
            do_share(a, command, scheme, member, team.threads)
        sign(team.board, member, phase)
        if command == DISMISSED:
            return


@nb.njit(**GUARD)
def gather(found):
    """Totals of one step over the pieces, in their order, into the row behind theirs."""
    totals = found[found.shape[0] - 1]
    totals[:] = 0.0
    for i in range(found.shape[0] - 1):
        totals[FOUND_RATE] = max(totals[FOUND_RATE], found[i, FOUND_RATE])
        totals[FOUND_FAILURE] = max(totals[FOUND_FAILURE], found[i, FOUND_FAILURE])
        for k in range(FOUND_IMPULSE, FOUND_FLOATS):
            totals[k] += found[i, k]
