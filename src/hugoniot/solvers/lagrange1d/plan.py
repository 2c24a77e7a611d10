"""The plan of a march: for each command of the step, the lists of passes that carry it out and the shares of zones or nodes.

Lists are made once per run, one for each material and member of the team, whose scratch memory they use. Shares are recomputed when
bodies open or close. Every share is processed by one thread, and totals are taken over the shares in a fixed order, so results do not
depend on the number of threads, to the last bit.
"""

from typing import Any, NamedTuple

import numba as nb
import numpy as np

from hugoniot.core.compile_ahead import Job
from hugoniot.core.pass_lists import FIXED, Operation, Place, Written, carry_out, jobs, place, places, write
from hugoniot.core.passes import Entry, row_at
from hugoniot.core.shares import jobs_of_team, led
from hugoniot.core.target import BY_ADDRESS, GUARD
from hugoniot.core.team import Team
from hugoniot.solvers.lagrange1d import compatible, leapfrog, nodes, sources
from hugoniot.solvers.lagrange1d import layout as L
from hugoniot.solvers.lagrange1d.layout import ChargeRows, NodeRows, WorkRows, ZoneRows
from hugoniot.zones.soundness import FOUND_FAILURE, FOUND_FLOATS, FOUND_IMPULSE, FOUND_RATE
from hugoniot.zones.steps import MaterialSteps

DRIFT, PREDICT, MOVE, CORRECT, FLOW, LEAP, ADVANCE = range(7)     # commands; FLOW is the artificial heat flux
COMMANDS = 7
AT_ZONES, AT_NODES, AT_GRADIENTS, ORIGINS = range(1, 5)                # origins of the lists
# columns of the table of shares: zones FIRST to LAST - 1, operations FROM to TO - 1, and of pieces without voids INTACT to INTACT_TO - 1
FIRST, LAST, SEGMENT, PIECE, FROM, TO, INTACT, INTACT_TO, FOUND = range(9)
SHARE_COLUMNS = 9
NOT_FOUND = -1
DT, DT_MEAN, DT_HALF, AHEAD = range(4)                                 # of the row of time steps


class LineRows(NamedTuple):
    """Rows of a piece of zones: those of `zones.steps.MaterialSteps`, its nodes h, and velocity gradients g from the left neighbour's on.

    t           rows of `zones.transport`, of a material with the laws `transport`; `bulk` its numbers of bulk viscosity
    supplied    (weights of the zones, amounts) of every heat source of the material
    """

    z: Any
    b: Any
    w: Any
    h: Any
    g: Place
    found: Place
    whole: Place
    half: Place
    t: Any = None
    transport: Any = None
    bulk: Any = None
    supplied: tuple = ()


class Plan(NamedTuple):
    """What compiled code carries out.

    written    the lists of passes in numbers
    commands   (command; first, last share)
    shares     (share; columns FIRST to FOUND)
    voids      address of the row of voids
    share_out, lead   addresses of `do_share` and of what does all shares (`core.shares`)
    threads, board    of the team
    origins    (member, ORIGINS) in bytes
    seen       (member, FOUND_FLOATS): what passes find in a share
    found      a row for each share that finds something, and the totals of a step behind them
    dts        dt, mean of the last two, half of dt, dt over the last one
    """

    written: Written
    commands: Any
    shares: Any
    voids: int
    share_out: int
    lead: int
    threads: int
    board: Any
    origins: Any
    seen: Any
    found: Any
    dts: Any


def _empty() -> Plan:
    table = np.zeros((1, 1), dtype=np.int64)
    return Plan(Written(table, table), table, table, 0, 0, 0, 1, table[0], table, np.zeros((1, 1)), np.zeros((1, 1)), np.zeros(4))


EMPTY = _empty()     # of the compiled type of every plan


# -- writing -----------------------------------------------------------------------------------------------------------
class Planner:
    """Writes the lists of a run and lays out its shares.

    tables    (zones, charge, nodes, gradient, scratch), which stay where they are as long as the run
    laws      `zones.laws.Laws` of each material
    terms     `terms.Terms` of the run
    """

    def __init__(self, tables, laws, terms, geometry, staggered: bool, heat_flux: float, team: Team):
        self.team, self.laws, self.geometry, self.staggered, self.terms = team, laws, geometry, staggered, terms
        self.dts, self.seen, self.led = np.zeros(4), np.zeros((team.threads, FOUND_FLOATS)), EMPTY
        zones, charge, node_table, gradient, scratch = tables
        z, b, h = places(ZoneRows, zones, AT_ZONES), places(ChargeRows, charge, AT_ZONES), places(NodeRows, node_table, AT_NODES)
        in_place = dict(grown=z.grown, **(dict(v=z.v, t1=z.s1, t2=z.s2) if staggered else {}))
        scratches = [places(WorkRows, scratch, FIXED, member * L.PIECE)._replace(**in_place) for member in range(team.threads)]
        self._at = [LineRows(z, b, w, h, place(gradient, AT_GRADIENTS), place(seen), place(self.dts[DT:]), place(self.dts[DT_HALF:]))
                    for w, seen in zip(scratches, self.seen)]
        self._heat_flux = heat_flux
        self.written, self._ends = EMPTY.written, {}
        self._lists = dict(self._of_materials()) | dict(self._of_motion())

    def jobs(self) -> list[Job]:
        """What has yet to be compiled for the plan."""
        return [*jobs_of_team(DO_SHARE, EMPTY, self.team), *jobs(self._lists.values())]

    def _of_materials(self):
        """((command, material, member, whether for pieces without voids), list) of every material."""
        commands = {ADVANCE: leapfrog.advance} if self.staggered else {PREDICT: compatible.predict, CORRECT: compatible.correct}
        for command, add in commands.items():
            for k, laws in enumerate(self.laws):
                for member, at in enumerate(self._at):
                    for intact in (False, True) if laws.grows_voids else (False,):
                        steps = MaterialSteps(laws, self.terms.rows(at, k, AT_ZONES), not self.staggered, intact)
                        add(steps, self.geometry)
                        yield (command, k, member, intact), steps.operations

    def _of_motion(self):
        """((command, k, 0, False), list) of every motion of nodes, and of the artificial heat flux where nothing burns (k = 0) and does."""
        at, dts, geometry, field = self._at[0], self.dts, self.geometry, self.terms.force.field
        z, h = at.z, at.h
        if self.staggered:
            kick = Operation(sources.kick, None, (h.r, h.u), field, place(dts[DT_MEAN:]))
            leap = Operation(nodes.leap, geometry, (z.sigma, z.pull, z.width, h.inverse_mass, h.u, h.r), dts[DT_MEAN:], at.whole)
            yield (LEAP, 0, 0, False), [kick, leap] if self.terms.forced else [leap]
            return
        yield (DRIFT, 0, 0, False), [Operation(nodes.drift, None, (h.r, h.u, h.u_mean, h.r_half), dts[AHEAD:], at.half)]
        moved = (z.sigma_half, z.hoop_half, h.r_half, h.inverse_mass, h.u, h.u_mean, h.r)
        move = Operation(nodes.move, geometry, moved, dts, at.whole)
        fall = Operation(sources.fall, None, (h.r_half, h.u, h.u_mean, h.r), field, at.whole)
        yield (MOVE, 0, 0, False), [move, fall] if self.terms.forced else [move]
        if self._heat_flux > 0.0:
            flux = (h.r_half, h.u_mean, at.b.lam, z.q, z.rho, z.inverse_mass, z.e, z.face_flux)
            for k in (0, 1):
                yield (FLOW, k, 0, False), [Operation(compatible.heat_flux, geometry, flux, np.array([self._heat_flux, k]), at.whole)]

    def plan(self, runs, spans, ranges) -> Plan:
        """The plan for runs (first, last, segment, material), spans of nodes (first, last, segment) and ranges between which heat flows
        (first, last, segment, whether they burn)."""
        if self.written is EMPTY.written:
            self.written, ends = write(self._lists.values())
            self.led = led(EMPTY, DO_SHARE, self.team)
            self._ends = dict(zip(self._lists, ends))
        # as many zones as there are nodes: inside a span, and with its ends
        inner, every = ([(first, last + more, segment, 0) for first, last, segment in spans.tolist()] for more in (-1, 1))
        shares, commands = [], np.zeros((COMMANDS, 2), dtype=np.int64)
        of_zones, stretches = runs.tolist(), {DRIFT: every, MOVE: inner, LEAP: inner, FLOW: ranges.tolist()}
        for command in {command for command, *_ in self._ends}:
            rows, scratch, finds = stretches.get(command, of_zones), command not in stretches, command in (CORRECT, ADVANCE)
            commands[command] = len(shares), len(shares) + len(rows)
            for i, (first, last, segment, k) in enumerate(rows):
                which = command, k, i % self.team.threads if scratch else 0
                ends = self._ends[*which, False]
                ends += self._ends.get((*which, True), ends)
                shares.append((first, last, segment, L.PIECE if scratch else last - first, *ends, i if finds else NOT_FOUND))
        table = np.array(shares, dtype=np.int64).reshape(-1, SHARE_COLUMNS)
        return self.led._replace(written=self.written, commands=commands, shares=table, voids=self._at[0].z.voids.address,
                                 threads=self.team.threads, origins=np.zeros((self.team.threads, ORIGINS), dtype=np.int64),
                                 seen=self.seen, found=np.zeros((len(runs) + 1, FOUND_FLOATS)), dts=self.dts)


# -- carried out -------------------------------------------------------------------------------------------------------
@nb.njit(**GUARD)
def voids_stand(voids, first, count):
    """Whether there are voids in zones first to first + count - 1; their row begins at the address `voids`."""
    row, bits = row_at(voids + 8 * first), np.uint64(0)
    for j in range(count):
        bits |= np.float64(row[j]).view(np.uint64)
    return bits << np.uint64(1) != 0      # but for the sign


@nb.njit(**GUARD)
def pieces_alike(voids, first, last, piece):
    """(whether voids stand in the piece of zones that begins with `first`, end of the pieces from there on that are like it)."""
    end = min(first + piece, last)
    broken = voids_stand(voids, first, end - first)
    while end < last:
        until = min(end + piece, last)
        if voids_stand(voids, end, until - end) != broken:
            break
        end = until
    return broken, end


@nb.njit(**BY_ADDRESS)
def carry_out_by_voids(plan, share, origins):
    """One share of a material that has a list for pieces without voids."""
    first = share[FIRST]
    while first < share[LAST]:
        broken, until = pieces_alike(plan.voids, first, share[LAST], share[PIECE])
        begin, end = (share[FROM], share[TO]) if broken else (share[INTACT], share[INTACT_TO])
        carry_out(plan.written, begin, end, until - first, share[PIECE], origins)
        for k in range(FIXED + 1, ORIGINS):
            origins[k] += 8 * (until - first)
        first = until


def do_share(plan, command, member):
    """One command over one member's part of the shares."""
    origins, seen = plan.origins[member], plan.seen[member]
    for i in range(plan.commands[command, 0] + member, plan.commands[command, 1], plan.threads):
        share = plan.shares[i]
        first, segment = share[FIRST], share[SEGMENT]
        for k in range(FOUND_FLOATS):
            seen[k] = 0.0
        origins[AT_ZONES], origins[AT_NODES], origins[AT_GRADIENTS] = 8 * first, 8 * (first + segment), 8 * (first + 2 * segment)
        if share[INTACT] == share[FROM]:
            carry_out(plan.written, share[FROM], share[TO], share[LAST] - first, share[PIECE], origins)
        else:
            carry_out_by_voids(plan, share, origins)
        if share[FOUND] != NOT_FOUND:
            for k in range(FOUND_FLOATS):
                plan.found[share[FOUND], k] = seen[k]


DO_SHARE = Entry(do_share)


@nb.njit(**BY_ADDRESS)
def gather(found):
    """Totals of one step over the shares, in their order, into the row behind theirs."""
    totals = found[found.shape[0] - 1]
    totals[:] = 0.0
    for i in range(found.shape[0] - 1):
        totals[FOUND_RATE] = max(totals[FOUND_RATE], found[i, FOUND_RATE])
        totals[FOUND_FAILURE] = max(totals[FOUND_FAILURE], found[i, FOUND_FAILURE])
        for k in range(FOUND_IMPULSE, FOUND_FLOATS):
            totals[k] += found[i, k]
