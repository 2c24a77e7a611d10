"""The plan of a march: for each command of the step the lists of passes that carry it out, and the rows of zones or nodes they take.

Lists are written once for a run, one for each material and member of the team, whose scratch they use. A share is one row of zones or of
nodes of a block. The rows of a mesh are those of its nodes, block by block, each with the row of zones behind it, if there is one. A
command is carried out over a band of rows, every member doing those that are its own, and totals are taken over the shares in their
order, so that no bit of a result depends on the number of threads or the height of the bands.
"""

from typing import Any, NamedTuple

import numba as nb
import numpy as np

from hugoniot.core.compile_ahead import Job
from hugoniot.core.pass_lists import Operation, Place, Written, carry_out, jobs, place, places, write
from hugoniot.core.passes import Entry, call_entry
from hugoniot.core.shares import jobs_of_team, led
from hugoniot.core.target import BY_ADDRESS, GUARD
from hugoniot.solvers.lagrange2d import closing, heat_flux, node_step, smoothness, triangle_passes, triangle_step, zone_passes, zone_step
from hugoniot.solvers.lagrange2d import layout as L
from hugoniot.solvers.lagrange2d.plane_rows import (
    AT_GRADIENTS,
    AT_GRADIENTS_BEFORE,
    AT_GRADIENTS_BEHIND,
    AT_HIGH,
    AT_LOW,
    AT_LOW_HALF,
    BEFORE_ONLY,
    BEHIND_ONLY,
    BOTH,
    DT,
    DT_BACK,
    OF_ZONES,
    ORIGINS,
    RowsOfRun,
)
from hugoniot.zones.soundness import FOUND_FAILURE, FOUND_RATE
from hugoniot.zones.steps import MaterialSteps

GRADIENTS, PREDICT, CORRECT, START, LOOK, ACCELERATE, PUSH, MOVE, TAKE_BACK, GATHER = range(COMMANDS := 10)     # commands
OF_NODES = (ACCELERATE, PUSH, MOVE, TAKE_BACK, GATHER)
FIRST, LAST, COUNT, PIECE, MEMBER, ORIGIN = range(6)          # columns of the table of shares, the last one the first of the origins
FROM, TO, HEIGHT = range(3)                                   # of the band: its first row and the one after its last, rows of a band
BAND = 4_000                                                  # zones of a band for each member: what a step reads of them stays in cache


class Plan(NamedTuple):
    """What compiled code carries out.

    written    the lists of passes in numbers
    commands   (command): first share
    before     (command; row): shares of the command before a row
    shares     (share; columns FIRST to ORIGIN and the origins, in bytes)
    band       rows that commands take: FROM, TO, HEIGHT
    share_out, lead   addresses of `do_share` and of what does all shares (`core.shares`)
    threads, board    of the team
    origins    (member, ORIGINS) in bytes: where the member is
    seen       (member, FOUND_COLUMNS): what passes find in a share
    found      a row for each share of a command, and the totals behind them
    dts        dt, half of it, minus dt
    """

    written: Written
    commands: Any
    before: Any
    shares: Any
    band: Any
    share_out: int
    lead: int
    threads: int
    board: Any
    origins: Any
    seen: Any
    found: Any
    dts: Any


def _empty() -> Plan:
    table, floats = np.zeros((1, 1), dtype=np.int64), np.zeros((1, 1))
    return Plan(Written(table, table), table[0], table, table, table[0], 0, 0, 1, table[0], table, floats, floats, np.zeros(3))


EMPTY = _empty()     # of the compiled type of every plan


def rows_of_member(rows: int, most: int, threads: int) -> int:
    """Rows of each member in a band, at most `most`: so that the last band is hardly shorter than the others, and nobody waits in it."""
    fewest = -(-rows // (most * threads))
    heights = [-(-rows // (bands * threads)) for bands in range(fewest, fewest + fewest // 4 + 1)]
    return min(heights, key=lambda height: -rows % (height * threads))


# -- writing -----------------------------------------------------------------------------------------------------------
class Planner:
    """Writes the lists of a run.

    tables     (zones, forces, charge, nodes, gradients, further fields of triangles or None), which stay where they are as long as the run
    rings      `rings.Rings`
    materials  (laws, numbers, whether it is a fluid, whether both triangles of a cell share their pressure) of each material
    viscosity  `problem.plane.model.Viscosity2D`
    """

    def __init__(self, tables, materials, geometry, viscosity, body_force, team, longest: int, rings):
        self.places, self.geometry, self.viscosity, self.team = RowsOfRun(tables, team.threads, longest), geometry, viscosity, team
        self.dts, self.seen, self.triangles = self.places.dts, self.places.seen, self.places.own is not None
        self._body_force = np.array(body_force, dtype=float)
        self._at = [self.places.rows(member, member) for member in range(team.threads)]
        self._some_conduct, self._coefficient = any(self.conducts(m[0], m[2]) for m in materials), np.array([viscosity.heat_flux])
        self._lists = dict(self._of_materials(materials)) | dict(self._of_zones()) | dict(self._of_nodes())
        self.written, self._ends, self.height, self._rings = EMPTY.written, {}, 0, rings

    def jobs(self) -> list[Job]:
        """What has yet to be compiled for the plan."""
        return [*jobs_of_team(DO_SHARE, EMPTY, self.team), *jobs(self._lists.values())]

    def _of_materials(self, materials):
        """((command, material, member), list) of every material."""
        for k, (laws, numbers, fluid, shared) in enumerate(materials):
            for member, at in enumerate(self._at):
                if self.triangles:
                    yield from self._of_cells(k, member, laws, numbers, shared)
                    continue
                predict, correct = MaterialSteps(laws, at, explicit=True), MaterialSteps(laws, at, explicit=True)
                closes = self._find_closing(predict)
                if self.viscosity.limited:
                    self._compare(predict, closes)
                zone_step.predict(predict, self.geometry, numbers, fluid, self.viscosity.kind)
                zone_step.correct(correct, self.geometry, numbers, fluid, self._conduction(at) if self.conducts(laws, fluid) else None)
                yield (PREDICT, k, member), predict.operations
                yield (CORRECT, k, member), correct.operations
                rows = zone_passes.StartOf(at.now, at.z.p, at.q, at.s, at.f)
                yield (START, k, member), [Operation(zone_passes.start, self.geometry, rows, numbers, at.whole)]

    def _of_cells(self, k, member, laws, numbers, shared):
        """The same of a material in triangles."""
        pair = self.places.pair(member)
        predict, correct, start = (triangle_step.Cell(laws, pair, self.geometry, numbers, shared) for _ in range(3))
        if self.viscosity.limited:
            self._compare(predict.steps[0], predict.steps[0].at.everywhere)
        predict.predict(self.viscosity.kind)
        correct.correct()
        start.start()
        for command, cell in ((PREDICT, predict), (CORRECT, correct), (START, start)):
            yield (command, k, member), cell.operations

    def _find_closing(self, s):
        """Write where something closes, for the viscosity that asks; the row that says where."""
        at = s.at
        if self.viscosity.kind != "tensor":
            return at.everywhere
        s.do(closing.find_closing, closing.ClosingOf(at.mid_low, at.mid_high, at.z.c, at.w.closes))
        return at.w.closes

    def _compare(self, s, closes):
        """Write how smooth the velocity field is."""
        here, left, right, before, behind = self._cells(smoothness.Gradients, 0)
        s.do(smoothness.compare, smoothness.ComparedOf(
            s.at.now_low, s.at.now_high, here, L.Vector(left.xix, left.xiy), L.Vector(right.xix, right.xiy),
            L.Vector(before.etax, before.etay), L.Vector(behind.etax, behind.etay), closes, s.at.smooth))

    def _cells(self, cls, first):
        """Rows of the table with cells around the blocks, from row `first` on: of a row of zones and of its four neighbours."""
        origins = AT_GRADIENTS, AT_GRADIENTS_BEFORE, AT_GRADIENTS_BEHIND
        here, before, behind = (places(cls, self.places.gradients[first:], origin) for origin in origins)
        left, right = (cls(*(Place(row.address + way, row.origin) for row in here)) for way in (-8, 8))
        return here, left, right, before, behind

    def conducts(self, laws, fluid) -> bool:
        """Whether artificial heat flows between the zones of a material: a gas or liquid that does not burn."""
        return fluid and not laws.burns and not self.triangles and self.viscosity.heat_flux > 0.0

    def _conduction(self, at):
        """(rows, coefficient) of the artificial heat flux."""
        nodes, cells = (at.mid_low, at.mid_high), self._cells(heat_flux.Carried, smoothness.CARRIED)
        return heat_flux.ConductOf(*(L.Positions(line.x, line.y) for line in nodes), *cells, at.z.inverse_mass, at.z.e), self._coefficient

    def _of_zones(self):
        """((command, 0, member), list) of what zones do whatever their material."""
        for member, at in enumerate(self._at):
            seen = []
            if self.viscosity.limited:
                rows = smoothness.GradientsOf(at.now_low, at.now_high, self._cells(smoothness.Gradients, 0)[0])
                seen.append(Operation(smoothness.gradients, None, rows, self.dts, at.whole))
            if self._some_conduct:
                cells = self._cells(heat_flux.Carried, smoothness.CARRIED)[0]
                rows = heat_flux.CarryOf(at.z.e, at.z.q, at.z.viscous_speed, at.z.c, cells)
                seen.append(Operation(heat_flux.carry, None, rows, self.dts, at.whole))
            if seen:
                yield (GRADIENTS, 0, member), seen
            look, rows = node_step.look, node_step.LookOf(*at.now, *(L.Positions(line.x, line.y) for line in at.mid), at.tangled)
            if self.triangles:
                look, rows = triangle_passes.look, triangle_step.look_rows(self.places.pair(member)[0])
            yield (LOOK, 0, member), [Operation(look, None, rows, self.dts, at.whole)]

    def _of_nodes(self):
        """((command, rows of zones beside, 0), list) of the motions of a row of nodes."""
        n, h, whole = *(places(L.Nodes, self.places.nodes, at) for at in (AT_LOW, AT_LOW_HALF)), place(self.dts[DT:])
        step = triangle_passes if self.triangles else node_step
        for beside in (BOTH, BEHIND_ONLY, BEFORE_ONLY):
            behind, before = self.places.beside(beside)
            first, force = L.Vector(n.gx, n.gy), L.Vector(h.fx, h.fy)
            motions = {
                GATHER: (step.gather_forces, node_step.GatherOf(behind, before, first)),
                ACCELERATE: (node_step.predict,
                             node_step.PredictOf(n.x, n.y, n.u, n.v, n.im, first, h.um, h.vm, h.xh, h.yh)),
                PUSH: (step.mean_motion, node_step.MeanOf(behind, before, n.u, n.v, n.im, force, h.um, h.vm)),
                MOVE: (node_step.move, node_step.MoveOf(n.x, n.y, n.u, n.v, h.um, h.vm))}
            for command, (motion, rows) in motions.items():
                yield (command, beside, 0), [Operation(motion, None, rows, self._body_force, whole)]
            yield (TAKE_BACK, beside, 0), [Operation(node_step.move, None, motions[MOVE][1], self._body_force, place(self.dts[DT_BACK:]))]

    def plan(self, zone_rows, node_rows) -> Plan:
        """The plan for the rows of a mesh: of nodes (count, rows of zones beside it, origins...), and of zones those behind each of them
        (count, material, origins...)."""
        self.written, ends = write(self._lists.values())
        self._ends = dict(zip(self._lists, ends))
        height = rows_of_member(len(node_rows), max(1, BAND // max(count for count, *_ in node_rows)), self.team.threads)
        self.height, of_shares = height * self.team.threads, []
        shares, commands, before = [], [], np.zeros((COMMANDS, len(node_rows) + 1), dtype=np.int64)
        for command in range(COMMANDS):
            of_nodes, known = command in OF_NODES, any(command == other for other, _, _ in self._ends)
            of_rows = [[row] for row in node_rows] if of_nodes else zone_rows
            commands.append(len(shares))
            for n, of_row in enumerate(of_rows):
                for count, kind, *origins in of_row if known else []:
                    member = n // height % self.team.threads      # whichever rows a band has: every member has as many, and always the same
                    key = (command, kind, 0) if of_nodes else (command, kind if command in (PREDICT, CORRECT, START) else 0, member)
                    kept_short = [origins[at - 1] for at in (*OF_ZONES, AT_LOW, AT_HIGH)]
                    shares.append((*self._ends[key], count, count if of_nodes else L.PIECE, member, 0, *origins, *kept_short))
                    of_shares.append(n)
                before[command, n + 1] = len(shares) - commands[-1]
        band = np.zeros(3, dtype=np.int64)
        threads, origins = self.team.threads, np.zeros((self.team.threads, ORIGINS), dtype=np.int64)
        found = np.zeros((before[LOOK, -1] + 1, L.FOUND_COLUMNS))
        plan = Plan(self.written, np.array(commands), before, np.array(shares, dtype=np.int64), band, 0, 0, threads, self.team.board,
                    origins, self.seen, found, self.dts)
        self._whole, self._of_shares = plan.shares.copy(), np.array(of_shares)
        self.set_bands(plan, False)
        return led(plan, DO_SHARE, self.team)

    def set_bands(self, plan: Plan, several: bool) -> None:
        """Have a plan take the mesh in several bands, or in one."""
        rows = plan.before.shape[1] - 1
        height = self.height if several else rows
        if plan.band[HEIGHT] == height:
            return
        plan.band[HEIGHT] = height
        for origin, bytes_moved in self._rings.move(height, self._of_shares):
            plan.shares[:, ORIGIN + origin] = self._whole[:, ORIGIN + origin] + bytes_moved


# -- carried out -------------------------------------------------------------------------------------------------------
def do_share(plan, command, member):
    """One command over one member's rows of the band."""
    seen, origins, start = plan.seen[member], plan.origins[member], plan.commands[command]
    for i in range(plan.before[command, plan.band[FROM]], plan.before[command, plan.band[TO]]):
        share = plan.shares[start + i]
        if share[MEMBER] != member:
            continue
        seen[:] = 0.0
        for k in range(ORIGINS):
            origins[k] = share[ORIGIN + k]
        carry_out(plan.written, share[FIRST], share[LAST], share[COUNT], share[PIECE], origins)
        if command < ACCELERATE:
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
def tangled(plan, command):
    """How many zones of the band a command has found tangled."""
    found = 0.0
    for i in range(plan.before[command, plan.band[FROM]], plan.before[command, plan.band[TO]]):
        found += plan.found[i, L.FOUND_TANGLED]
    return found
