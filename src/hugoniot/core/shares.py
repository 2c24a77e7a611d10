"""A command of a step carried out by a team: each member does its part of the shares of a plan.

A plan has `share_out`, the address of its function (plan, command, member) that does one member's part. Which shares are whose stands in
the plan, so that no bit depends on who does them.
"""

import numba as nb
from numba.extending import overload

from hugoniot.core.passes import call_entry
from hugoniot.core.target import GUARD, INLINE
from hugoniot.core.team import DISMISSED, Alone, await_call, begin, gather_team, sign


def everyone(plan, command, team):
    """One command over all its shares, by everyone if there is a team."""
    raise NotImplementedError("compiled only")


@overload(everyone, jit_options=INLINE)
def _(plan, command, team):
    def alone(plan, command, team):
        call_entry(plan.share_out, plan, command, 0)

    def together(plan, command, team):
        for member in range(begin(team.board, command, team.threads)):
            call_entry(plan.share_out, plan, command, member)
        gather_team(team.board, team.threads)

    return alone if team.instance_class is Alone else together


@nb.njit(**GUARD)
def serve(member, phase, plan, team):
    """What every other thread of a team does during a march: the leader's commands on its own part, until dismissed."""
    while True:
        phase = await_call(team.board, phase, member)
        command = team.board[1]
        if command != DISMISSED:
            call_entry(plan.share_out, plan, command, member)
        sign(team.board, member, phase)
        if command == DISMISSED:
            return
