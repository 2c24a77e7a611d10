"""After a step: fronts that met, bodies that part, shocks that have decayed, compressions that have steepened; the number of cells."""

import dataclasses
import math

import numpy as np

from hugoniot.errors import NoSolution, OutOfRange
from hugoniot.solvers.fronts.cells import pores, tables
from hugoniot.solvers.fronts.cells.births import bear, collapse, ignite, note_strengths
from hugoniot.solvers.fronts.cells.detonations import UNLIT, light_face
from hugoniot.solvers.fronts.cells.flow import Flow
from hugoniot.solvers.fronts.cells.kinks import cross, reflect, transmit
from hugoniot.solvers.fronts.cells.mesh import EMPTY, Front, Mesh, adjust
from hugoniot.solvers.fronts.cells.start import pieces_at
from hugoniot.solvers.fronts.cells.steepening import track
from hugoniot.solvers.fronts.meeting import solve

CRUSHED = 0.02     # difference of compaction on both sides of a shock that has decayed from which on a contact is left there
REST = 1e-9        # strength of a wave that counts as none
EDGE = 10          # cells from a vacuum within which one without a valid state is merged with its neighbour


class Changes:
    """What happens to the fronts of a run; counts of it, and the lines of the log.

    log      called as log(kind, time, position, text)
    ended    called as ended(front, time, position) for every front that is no more
    most     number of fronts beyond which new waves are left to the cells
    asked    weakest wave to be followed, of the options; strongest   that has arisen so far
    share    of the strongest wave from which on waves are followed where that is less than asked; more where more than the default is asked
    """

    def __init__(self, flow: Flow, length: float, most: int, log, ended):
        self.flow, self.length, self.most, self.log, self.ended = flow, length, most, log, ended
        self.meetings = self.captured = self.untracked = self.formed = self.joined = 0
        self.asked, self.strongest = flow.bench.weakest, 0.0
        self.share = max(0.1, 10.0 * self.asked)

    def after_step(self, mesh: Mesh, time: float) -> None:
        """Do what the step calls for."""
        runs = met(mesh, self.length)
        parting = [mesh.x[f] for f in self.flow.flagged(1, mesh)]
        if not runs:
            self._release(mesh, time)
        for first, last in reversed(runs):
            self._meet(mesh, first, last, time)
        for x in parting if not runs else ():
            face = int(np.flatnonzero(mesh.x == x)[0])
            self._renew(mesh, face, time, "divides" if mesh.fronts[_order(mesh, face)].direction else "parts")
        self.flow.clear()
        if np.isnan(mesh.push).all():      # what stands beside cells of no width has its place after their first step only
            adjust(mesh, self.flow.spacing, self.flow.slopes, self.flow.solid)

    def steepen(self, mesh: Mesh, time: float) -> None:
        """Follow the shocks that have formed among the cells."""
        cell, direction = self.flow.steep(mesh)
        x = float(mesh.middle[cell])
        region = int(mesh.region[cell])
        if cell >= 0 and (front := track(mesh, self.flow.work.w, cell, direction, time)) is not None:
            self.formed += 1
            self._met(front.strength)
            note_strengths([(front, True)], (region, region), self.flow.bench)
            self.log("formed", time, x, "a compression has become a shock, which is now tracked")

    def join(self, mesh: Mesh) -> bool:
        """Merge the cell without a valid state with its neighbour if it is one of the last of a gas that expands into vacuum.

        There the sound speed falls to zero, and the internal energy is no larger than the error of the total energy.
        """
        flow, at = self.flow, mesh.faces()
        k = int(flow.work.numbers[tables.LIMITING])
        right = int(np.searchsorted(at, k, side="right"))
        low, high = int(at[right - 1]), int(at[right])
        if flow.rules.traits[mesh.region[k] % len(flow.laws), tables.GAS] == 0.0 or high - low < 3:
            return False
        for away, cell, outside in ((k - low, low - 1, flow.outside[0]), (high - 1 - k, high, flow.outside[1])):
            nothing = mesh.region[cell] == EMPTY if 0 <= cell < len(mesh.q) else outside == "vacuum"
            if nothing and away < EDGE:
                mesh.remove_face(k if k > low else k + 1)
                self.joined += 1
                return True
        return False

    def _meet(self, mesh: Mesh, first: int, last: int, time: float) -> None:
        inside = mesh.fronts[_order(mesh, first):_order(mesh, last) + 1]
        ends = [f for f, front in zip((first, last), (inside[0], inside[-1])) if front.kind == "end"]
        x = float(mesh.x[ends[0]] if ends else np.mean(mesh.x[first:last + 1]))
        for front in inside:
            self.ended(front, time, x)
        kinds = [front.kind for front in inside]
        solid = [front for front in inside if "fan" not in front.kind]
        face = collapse(mesh, first, last, x, self.flow.bench.unburned)
        self.meetings += 1
        if len(solid) < 2:      # at the edge of a fan no state jumps: it ends where it meets anything but a contact; what it meets goes on
            edges = [front for front in inside if "fan" in front.kind]
            went_on = self._pass(mesh, face, solid, edges, time)
            self.log("meeting", time, x, f"{' with '.join(kinds)}: {', '.join(front.kind for front in (*solid, *went_on)) or 'nothing'}")
            return
        made, word = self._bear(mesh, face, time, "detonation" in kinds)
        self.log("meeting", time, x, f"{' with '.join(kinds)}: {', '.join(made) or 'nothing'} ({word})")

    def _pass(self, mesh: Mesh, face: int, solid, edges, time: float) -> list[Front]:
        """Leave the one front that jumps, or none, at a face; the edges of fans that go on behind it."""
        bench, crowded = self.flow.bench, len(mesh.fronts) >= self.most
        left, right = self._sides(mesh, face, time)
        if not solid:
            if not crowded and cross(mesh, face, edges, left, right, time, bench):
                return edges
            mesh.release(face)
            return []
        k, old = _order(mesh, face), solid[0]
        mesh.fronts[k] = dataclasses.replace(old, least=1, since=time, start=float(mesh.x[face]),
                                             sides=(tuple(left.edge(1))[:5], tuple(right.edge(-1))[:5]))
        if len(edges) != 1 or old.direction or crowded:
            return []
        passes = transmit if old.kind != "end" else reflect
        return edges if passes(mesh, face, edges[0], left, right, time, bench) else []

    def renew_end(self, mesh: Mesh, side: int, time: float) -> None:
        """The left (0) or right (1) end drives anew: solve its Riemann problem."""
        self._renew(mesh, 0 if side == 0 else len(mesh.q), time, "changes")

    def _renew(self, mesh: Mesh, face: int, time: float, verb: str) -> None:
        front, x = mesh.fronts[_order(mesh, face)], float(mesh.x[face])
        self.ended(front, time, x)
        made, word = self._bear(mesh, face, time)
        self.log("meeting", time, x, f"{front.kind} {verb}: {', '.join(made) or 'nothing'} ({word})")

    def _bear(self, mesh: Mesh, face: int, time: float, burning: bool = False):
        followed = len(mesh.fronts) < self.most
        bench = self.flow.bench
        mesh.touch(face, face)
        left, right = self._sides(mesh, face, time)
        if any(piece.region >= self.flow.bench.unburned for piece in (left, right)):
            if not burning:
                raise OutOfRange(UNLIT)
            self._met(math.inf)
            return ignite(mesh, face, left, right, time, bench)
        self._follow_down_to(mesh, (face,), time)
        self.captured += not followed
        try:
            return bear(mesh, face, left, right, time, bench, followed)
        except (OutOfRange, NoSolution):      # what the parabolas give at the face is beyond the range of a law
            return bear(mesh, face, *self._sides(mesh, face, time, averages=True), time, bench, followed)

    def _sides(self, mesh: Mesh, face: int, time: float, averages: bool = False):
        """What stands on the left and right of a face (averages: in the cells there), the ends driven as they are at a time."""
        bench = self.flow.bench
        for k, side in enumerate((-1, 1)):
            if self.flow.outside[k] in ("wall", "pressure"):
                (bench.walls if self.flow.outside[k] == "wall" else bench.pressures)[side] = self.flow.drive(k, time)
        return pieces_at(self.flow, mesh, face, averages)

    def _follow_down_to(self, mesh: Mesh, faces, time: float) -> None:
        """Measure the waves that leave some faces: waves down to a share of the strongest so far are followed.

        Elastic waves have their own measure; waves that close pores are measured by the stiffness of the material, as others are. At the
        ends of a profile small waves are those of its interpolation.
        """
        if self.share * self.strongest >= self.asked:
            return
        bench = self.flow.bench
        for face in faces:
            if not self._beside_explosive(mesh, face):
                left, right = self._sides(mesh, face, time)
                found = solve(left, right, bench, False)
                waves = [(wave, piece) for piece, some in ((left, found.left), (right, found.right)) for wave in some if not wave.elastic]
                self._met(max((pores.strength(wave, bench.of(piece)) for wave, piece in waves), default=0.0))

    def _met(self, strength: float) -> None:
        """A wave of this strength has arisen."""
        self.strongest = max(self.strongest, strength)
        if self.strongest > REST and not any(region.profile is not None for region in self.flow.problem.regions):
            self.flow.follow(min(self.asked, self.share * self.strongest))

    def begin(self, mesh: Mesh, lit: list[float]) -> None:
        """The waves that leave every line at t = 0, and the explosive at the places `lit`."""
        self._follow_down_to(mesh, mesh.faces().tolist(), 0.0)
        fired = {self._mark(mesh, x) for x in lit}
        fired = {float(mesh.x[f]) for f in range(len(mesh.x)) if float(mesh.x[f]) in fired}
        for face in reversed(mesh.faces().tolist()):
            if float(mesh.x[face]) in fired:
                self._bear(mesh, face, 0.0, True)
            elif not self._beside_explosive(mesh, face):
                self._bear(mesh, face, 0.0)

    def light(self, mesh: Mesh, x: float, time: float) -> None:
        """Fire a detonator; in products it does nothing."""
        cell = min(max(int(np.searchsorted(mesh.x, x, side="right")) - 1, 0), len(mesh.q) - 1)
        if mesh.region[cell] >= self.flow.bench.unburned:
            place = self._mark(mesh, x)
            self._bear(mesh, int(np.argmin(np.abs(mesh.x - place))), time, True)
            self.log("lighting", time, x, "a detonator fires")

    def _mark(self, mesh: Mesh, x: float) -> float:
        """Make a place a front unless it is one already; gives where that front is."""
        face = light_face(mesh, x)
        if not mesh.marked[face]:
            mesh.marked[face] = True
            mesh.fronts.insert(_order(mesh, face), Front("contact", 0.0))
        return float(mesh.x[face])

    def _beside_explosive(self, mesh: Mesh, face: int) -> bool:
        return bool((mesh.region[max(face - 1, 0):face + 1] >= self.flow.bench.unburned).any())

    def _crowded(self, mesh: Mesh) -> list[int]:
        """Waves on both sides of the interval that asks for a step out of proportion; in pores the edge of a fan rather than the shock."""
        at = mesh.faces()
        k = int(np.searchsorted(at, self.flow.work.numbers[tables.LIMITING], side="right")) - 1
        found = [j for j in (k, k + 1) if mesh.fronts[j].direction and mesh.fronts[j].kind != "detonation"]
        edges = [j for j in found if "fan" in mesh.fronts[j].kind]
        if edges and self.flow.porous[mesh.region[int(at[k])] % len(self.flow.porous)]:      # cells alone crush with too little heat
            found = edges
        return [int(at[j]) for j in found]

    def _release(self, mesh: Mesh, time: float) -> None:
        crowd = self._crowded(mesh) if self.flow.work.numbers[tables.CROWDED] > 0.0 else []
        self.captured += bool(crowd)
        for f in sorted({*self.flow.flagged(0, mesh), *crowd}, reverse=True):
            front = mesh.fronts[_order(mesh, f)]
            pores_end = front.kind == "shock" and self._ends_pores(mesh, f)
            self.flow.bench.crushing += pores_end and f in crowd
            pores_end = pores_end and f not in crowd
            why = "other waves are too close" if f in crowd else "it has decayed, and leaves a contact" if pores_end else "it has decayed"
            self.ended(front, time, float(mesh.x[f]))
            self.log("released", time, float(mesh.x[f]), f"{front.kind} is no longer tracked: {why}")
            if pores_end:
                self._leave_contact(mesh, f, time)
            else:
                mesh.release(f)
            self.untracked += 1

    def _ends_pores(self, mesh: Mesh, f: int) -> bool:
        """Whether crushed and uncrushed material of one region meet at a face: the cells there would mix them."""
        if mesh.region[f - 1] != mesh.region[f] or not self.flow.porous[mesh.region[f] % len(self.flow.porous)]:
            return False
        k = mesh.q[f - 1:f + 1, tables.HOOP] / mesh.q[f - 1:f + 1, 0]
        return bool(abs(k[1] - k[0]) > CRUSHED)

    def _leave_contact(self, mesh: Mesh, f: int, time: float) -> None:
        """A contact in the place of a shock that has decayed."""
        left, right = self._sides(mesh, f, time)
        mesh.touch(f, f)
        sides = tuple(left.edge(1))[:5], tuple(right.edge(-1))[:5]
        mesh.fronts[_order(mesh, f)] = Front("contact", float(left.edge(1).u), since=time, start=float(mesh.x[f]), sides=sides)


def met(mesh: Mesh, length: float) -> list[tuple[int, int]]:
    """Runs of fronts (first face, last face) that have met."""
    first, counts = mesh.intervals()
    speeds = [front.speed for front in mesh.fronts]
    opens = [mesh.region[f] == EMPTY and a < b for f, a, b in zip(first.tolist(), speeds, speeds[1:])]      # a gap has no width at first
    closed = [f for f, n, new in zip(first.tolist(), counts.tolist(), opens)
              if n == 1 and not new and mesh.x[f + 1] - mesh.x[f] <= tables.TOUCHING * length]
    runs: list[list[int]] = []
    for f in closed:
        if runs and runs[-1][1] == f:
            runs[-1][1] = f + 1
        else:
            runs.append([f, f + 1])
    return [(a, b) for a, b in runs]


def _order(mesh: Mesh, face: int) -> int:
    """Which of the fronts stands at a face."""
    return int(np.count_nonzero(mesh.marked[:face]))
