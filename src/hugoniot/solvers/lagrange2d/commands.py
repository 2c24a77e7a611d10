"""Commands of a step, carried out over a band of rows by a team.

A command is a list of passes for each kind of row and member of the team (`plan`). A share is one row of zones or of nodes of a block; a
row of zones with eroded zones has one share for each remaining run of zones. The rows of a mesh are those of its nodes,
block by block, each with the row of zones behind it, if there is one. Every member processes its own rows, and totals are taken
over the shares in a fixed order, so results do not depend on the number of threads or the height of the bands, to the last bit.
"""

from typing import Any, NamedTuple

import numba as nb
import numpy as np

from hugoniot.core.pass_lists import Written, carry_out
from hugoniot.core.passes import Entry, call_entry
from hugoniot.core.target import BY_ADDRESS, GUARD
from hugoniot.solvers.lagrange2d import layout as L
from hugoniot.zones.soundness import FOUND_FAILURE, FOUND_RATE

# commands: those of zones, then those of nodes
GRADIENTS, PREDICT, CORRECT, LOOK, SHOW, DRIFT, PUSH, MOVE, TAKE_BACK = range(9)
COMMANDS = 9
BY_MATERIAL = (PREDICT, CORRECT, SHOW)
ZONES, NODES = range(2)                                       # rows
COUNT, KIND, MEMBER, ORIGIN = range(4)                        # columns of the table of shares, the last one the first of the origins
FROM, TO, HEIGHT = range(3)                                   # of the band: its first row and the one after its last, rows of a band


class Plan(NamedTuple):
    """What compiled code carries out.

    written    the lists of passes in numbers
    lists      (command, kind of row, member; 2): first operation and the one after the last
    before     (ZONES or NODES; row): shares before a row
    shares     (share; columns COUNT to ORIGIN and the origins, in bytes): those of zones, then those of nodes
    band       rows that commands take: FROM, TO, HEIGHT
    share_out, lead   addresses of `do_share` and of what does all shares (`core.shares`)
    threads, board    of the team
    seen       (member, FOUND_COLUMNS): what passes find in a share
    found      a row for each share of zones, and the totals behind them
    dts        dt, half of it, minus dt, dt over that of the last step
    """

    written: Written
    lists: Any
    before: Any
    shares: Any
    band: Any
    share_out: int
    lead: int
    threads: int
    board: Any
    seen: Any
    found: Any
    dts: Any


def _empty() -> Plan:
    table, floats = np.zeros((1, 1), dtype=np.int64), np.zeros((1, 1))
    return Plan(Written(table, table), np.zeros((1, 1, 1, 1), dtype=np.int64), table, table, table[0], 0, 0, 1, table[0], floats,
                floats, np.zeros(4))


EMPTY = _empty()     # of the compiled type of every plan


def do_share(plan, command, member):
    """One command over one member's rows of the band."""
    of_zones, seen = command < DRIFT, plan.seen[member]
    before, start = (plan.before[ZONES], 0) if of_zones else (plan.before[NODES], plan.found.shape[0] - 1)
    for i in range(before[plan.band[FROM]], before[plan.band[TO]]):
        share = plan.shares[start + i]
        if share[MEMBER] != member:
            continue
        first, last = plan.lists[command, share[KIND], member]
        if of_zones:
            seen[:] = 0.0
        carry_out(plan.written, first, last, share[COUNT], L.PIECE if of_zones else share[COUNT], share[ORIGIN:])
        if of_zones:
            for k in range(seen.shape[0]):
                plan.found[i, k] = seen[k]


DO_SHARE = Entry(do_share)


@nb.njit(**GUARD)
def carry_out_alone(plan, commands):
    """Some commands over all rows, band by band, by the calling thread."""
    last, rows = 0, plan.before.shape[1] - 1
    while last < rows:
        plan.band[FROM], plan.band[TO] = last, min(last + plan.band[HEIGHT], rows)
        for command in commands:
            for member in range(plan.threads):
                call_entry(plan.share_out, plan, command, member)
        last = plan.band[TO]


@nb.njit(**BY_ADDRESS)
def gather(found):
    """Totals of a command over its shares, in their order, into the row behind theirs."""
    totals = found[found.shape[0] - 1]
    totals[:] = 0.0
    for i in range(found.shape[0] - 1):
        for k in range(totals.shape[0]):
            totals[k] = max(totals[k], found[i, k]) if k in (FOUND_RATE, FOUND_FAILURE) else totals[k] + found[i, k]


@nb.njit(**BY_ADDRESS)
def tangled(plan):
    """How many zones of the band the last command has found tangled."""
    found = 0.0
    for i in range(plan.before[ZONES, plan.band[FROM]], plan.before[ZONES, plan.band[TO]]):
        found += plan.found[i, L.FOUND_TANGLED]
    return found
