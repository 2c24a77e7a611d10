"""A command of a step carried out by a team: each member does its part of the shares of a plan.

A plan has `threads`, the `board` of their team, `share_out`, the address of its function (plan, command, member) that does one member's
part, and `lead`, the address of what does all parts: of the same function where there is one thread, else of `by_team`. So a march calls an
address and is compiled once for any number of threads. The plan assigns the shares, so results do not depend on which thread does them.
"""

from typing import Any

import numba as nb

from hugoniot.core.compile_ahead import Job
from hugoniot.core.passes import Entry, call_entry
from hugoniot.core.target import GUARD, INLINE
from hugoniot.core.team import DISMISSED, Team, await_call, begin, gather_team, sign


@nb.njit(**INLINE)
def everyone(plan, command):
    """One command over all its shares, by everyone if there is a team."""
    call_entry(plan.lead, plan, command, 0)


def by_team(plan, command, _):
    """One command over all its shares, the leader doing the first and those that the others are spared."""
    for member in range(begin(plan.board, command, plan.threads)):
        call_entry(plan.share_out, plan, command, member)
    gather_team(plan.board, plan.threads)


BY_TEAM = Entry(by_team)


def jobs_of_team(share_out: Entry, plan, team: Team) -> list[Job]:
    """What has yet to be compiled for a team to carry out plans of this type."""
    return [entry.job(plan, 0, 0) for entry in ([share_out, BY_TEAM] if team.threads > 1 else [share_out])]


def led(plan, share_out: Entry, team: Team) -> Any:
    """A plan with the addresses for a team and its board."""
    alone = share_out.address(plan, 0, 0)
    return plan._replace(share_out=alone, lead=BY_TEAM.address(plan, 0, 0) if team.threads > 1 else alone, board=team.board)


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
