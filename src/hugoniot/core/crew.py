"""The threads of a team (`team`): how many a run is given, and their presence while it marches."""

import os
import threading
from contextlib import contextmanager

from hugoniot.core import team


def crew(threads: int, worthwhile: bool) -> team.Alone | team.Together:
    """The team of a run that asks for `threads`: no more than the machine has, and one where sharing is not worthwhile or not possible."""
    threads = min(threads, os.cpu_count() or 1)
    if threads < 2 or not worthwhile or not team.possible():
        return team.Alone()
    return team.Together(threads, team.board(threads))


@contextmanager
def at_work(which: team.Alone | team.Together, serve, plan):
    """The other threads of a team, each in `serve(member, phase, plan, team)`, until the block ends."""
    if isinstance(which, team.Alone):
        yield
        return
    phase = int(which.board[0])
    members = [threading.Thread(target=serve, args=(k, phase, plan, which), daemon=True) for k in range(1, which.threads)]
    for member in members:
        member.start()
    try:
        yield
    finally:
        team.call(which.board, team.DISMISSED)
        for member in members:
            member.join()
