"""The plan of a march: for each command of the step, the lists of passes that carry it out and the rows of zones or nodes.

Lists are made once per run, one for each material and member of the team, whose scratch memory they use; `commands` executes them.
"""

import numpy as np

from hugoniot.core.compile_ahead import Job
from hugoniot.core.pass_lists import Operation, Place, jobs, place, places, write
from hugoniot.core.shares import jobs_of_team, led
from hugoniot.solvers.lagrange2d import (
    closing,
    heat_flux,
    node_step,
    shown,
    smoothness,
    triangle_passes,
    triangle_step,
    zone_step,
)
from hugoniot.solvers.lagrange2d import layout as L
from hugoniot.solvers.lagrange2d.commands import (
    BY_MATERIAL,
    COMMANDS,
    CORRECT,
    DO_SHARE,
    DRIFT,
    EMPTY,
    GRADIENTS,
    HEIGHT,
    LOOK,
    MOVE,
    NODES,
    ORIGIN,
    PREDICT,
    PUSH,
    SHOW,
    TAKE_BACK,
    ZONES,
    Plan,
)
from hugoniot.solvers.lagrange2d.plane_rows import (
    AHEAD,
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
    DT_HALF,
    OF_ZONES,
    RowsOfRun,
)
from hugoniot.zones.steps import MaterialSteps

BAND = 4_000      # zones of a band: what a step reads of them stays in cache
OF_TEAM = 2       # times as many for each member of a team, who wait for each other after every command


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
    shows      whether fields that no other step needs are found only where someone looks (`shown`)
    """

    def __init__(self, tables, materials, geometry, viscosity, body_force, team, rings, shows: bool):
        self.places, self.geometry, self.viscosity, self.team = RowsOfRun(tables, team.threads, rings.longest), geometry, viscosity, team
        self.dts, self.seen, self.triangles = self.places.dts, self.places.seen, self.places.own is not None
        self.shows = shows and not self.triangles
        self._body_force = np.array(body_force, dtype=float)
        self._at = [self.places.rows(member, member) for member in range(team.threads)]
        self._some_conduct, self._coefficient = any(self.conducts(m[0], m[2]) for m in materials), np.array([viscosity.heat_flux])
        self._lists = dict(self._of_materials(materials)) | dict(self._of_zones()) | dict(self._of_nodes())
        self.written, self.height, self._rings = EMPTY.written, 0, rings

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
                if self.shows:
                    yield (SHOW, k, member), shown.operations(at, self.geometry, numbers)
                    at = shown.left_out(at, laws)
                predict, correct = MaterialSteps(laws, at, explicit=True), MaterialSteps(laws, at, explicit=True)
                closes = self._find_closing(predict)
                if self.viscosity.limited:
                    self._compare(predict, closes)
                zone_step.predict(predict, self.geometry, numbers, fluid, self.viscosity.kind)
                conduction, keeps_trace = self._conduction(at, laws, fluid), laws.burns or self._some_conduct or not self.shows
                zone_step.correct(correct, self.geometry, numbers, conduction, keeps_trace)
                yield (PREDICT, k, member), predict.operations
                yield (CORRECT, k, member), correct.operations

    def _of_cells(self, k, member, laws, numbers, shared):
        """The same of a material in triangles."""
        pair = self.places.pair(member)
        predict, correct = (triangle_step.Cell(laws, pair, self.geometry, numbers, shared) for _ in range(2))
        if self.viscosity.limited:
            self._compare(predict.steps[0], predict.steps[0].at.everywhere)
        predict.predict(self.viscosity.kind)
        correct.correct()
        for command, cell in ((PREDICT, predict), (CORRECT, correct)):
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

    def _conduction(self, at, laws, fluid):
        """(rows, coefficient) of the artificial heat flux; None where none flows."""
        if not self.conducts(laws, fluid):
            return None
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
            moved = node_step.MoveOf(n.x, n.y, n.u, n.v, h.um, h.vm, n.du, n.dv)
            motions = {
                DRIFT: (node_step.drift, node_step.DriftOf(*moved, h.xh, h.yh), place(self.dts[DT_HALF:])),
                PUSH: (step.mean_motion, node_step.MeanOf(behind, before, n.u, n.v, n.im, L.Vector(h.fx, h.fy), h.um, h.vm), whole),
                MOVE: (node_step.move, moved, whole),
                TAKE_BACK: (node_step.move, moved, place(self.dts[DT_BACK:]))}
            for command, (motion, rows, step_time) in motions.items():
                numbers = self.dts[AHEAD:] if command == DRIFT else self._body_force
                yield (command, beside, 0), [Operation(motion, None, rows, numbers, step_time)]

    def plan(self, zone_rows, node_rows) -> Plan:
        """The plan for the rows of a mesh: of nodes (count, rows of zones beside it, origins...), and of zones those behind each of them
        (count, material, origins...)."""
        self.written, ends = write(self._lists.values())
        most = (BAND if self.team.threads == 1 else OF_TEAM * BAND) // max(count for count, *_ in node_rows)
        height = rows_of_member(len(node_rows), max(1, most), self.team.threads)
        self.height, of_shares, shares, before = height * self.team.threads, [], [], np.zeros((2, len(node_rows) + 1), dtype=np.int64)
        for kind, of_rows in ((ZONES, zone_rows), (NODES, [[row] for row in node_rows])):
            first = len(shares)
            for n, of_row in enumerate(of_rows):
                for count, which, *origins in of_row:
                    member = n // height % self.team.threads      # whichever rows a band has: every member has as many, and always the same
                    kept_short = [origins[at - 1] for at in (*OF_ZONES, AT_LOW, AT_HIGH)]
                    shares.append((count, which, member, 0, *origins, *kept_short))
                    of_shares.append(n)
                before[kind, n + 1] = len(shares) - first
        found = np.zeros((before[ZONES, -1] + 1, L.FOUND_COLUMNS))
        plan = Plan(self.written, self._table(ends), before, np.array(shares, dtype=np.int64), np.zeros(3, dtype=np.int64), 0, 0,
                    self.team.threads, self.team.board, self.seen, found, self.dts)
        self._whole, self._of_shares = plan.shares.copy(), np.array(of_shares)
        self.set_bands(plan, False)
        return led(plan, DO_SHARE, self.team)

    def _table(self, ends):
        """First and last operation of each list (command, kind of row, member; 2); none where a command has nothing to do."""
        kinds = 1 + max(kind for _, kind, _ in self._lists)
        table = np.zeros((COMMANDS, kinds, self.team.threads, 2), dtype=np.int64)
        for (command, kind, member), end in zip(self._lists, ends):
            if command >= DRIFT:
                table[command, kind] = end
            else:
                table[command, kind if command in BY_MATERIAL else slice(None), member] = end
        return table

    def set_bands(self, plan: Plan, several: bool) -> None:
        """Have a plan take the mesh in several bands, or in one."""
        rows = plan.before.shape[1] - 1
        height = self.height if several else rows
        if plan.band[HEIGHT] == height:
            return
        plan.band[HEIGHT] = height
        for origin, bytes_moved in self._rings.move(height, self._of_shares):
            plan.shares[:, ORIGIN + origin] = self._whole[:, ORIGIN + origin] + bytes_moved
