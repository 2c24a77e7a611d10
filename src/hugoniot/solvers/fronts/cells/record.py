"""The lives of fronts that bend: chains of short straight lines, each with the states on both sides where it begins."""

import numpy as np

from hugoniot.solvers.fronts.cells import tables
from hugoniot.solvers.fronts.cells.mesh import Front, Mesh
from hugoniot.solvers.fronts.record import COLUMNS


class Trace:
    """Lines of `record.COLUMNS`; `jumps` is the largest velocity change across a shock of each region.

    tensions   region -> largest tension (Pa) in the middle of its cells, at the times of gauges and snapshots
    """

    def __init__(self):
        self._kinds: list[str] = []
        self._rows: list[list[float]] = []
        self._noted: list[tuple] = []             # what the march has noted and `lines` has yet to write down
        self.jumps: dict[int, float] = {}
        self.tensions: dict[int, float] = {}

    def pulled(self, region: np.ndarray, pressure: np.ndarray) -> None:
        """Note the tension in cells, given the region and pressure (Pa) of each."""
        for cell in np.flatnonzero(pressure < 0.0).tolist():
            k = int(region[cell])
            self.tensions[k] = max(self.tensions.get(k, 0.0), float(-pressure[cell]))

    def end(self, front: Front, time: float, x: float) -> None:
        """A line of a front ends at a time and place."""
        if time > front.since:
            self.lines()
            self._kinds.append(front.kind)
            self._rows.append(_row(front, time, x))

    def drain(self, mesh: Mesh, work: tables.Work, regions: int) -> None:
        """Take over what the march has noted: the lines of all fronts end there, and new ones begin.

        The fronts are those of the mesh, unchanged since the march began.
        """
        count, sampled = len(mesh.fronts), int(work.numbers[tables.SAMPLED])
        work.numbers[tables.SAMPLED] = 0.0
        if not sampled:
            return
        noted = work.trace[:sampled].reshape(-1, count, tables.TRACE).copy()       # every time all fronts, in their order
        first = [(front.kind, float(front.direction), front.since, front.start, front.sides) for front in mesh.fronts]
        self._noted.append((noted, first))
        faces = mesh.faces()
        for k, (front, last) in enumerate(zip(mesh.fronts, noted[-1].tolist())):
            front.since, front.start, front.sides = last[0], last[2], (tuple(last[4:9]), tuple(last[9:14]))
            if "shock" in front.kind:
                region = int(max(mesh.region[faces[k] - 1], mesh.region[faces[k]])) % regions
                self.jumps[region] = max(self.jumps.get(region, 0.0), float(np.abs(noted[:, k, 5] - noted[:, k, 10]).max()))

    def lines(self) -> tuple[list[str], list[list[float]]]:
        """(kinds, rows of COLUMNS) of the lines that have ended, in the order in which they did."""
        for noted, first in self._noted:
            for j, block in enumerate(noted.tolist()):
                for k, (kind, way, since, start, sides) in enumerate(first):
                    time, x, strength = block[k][0], block[k][2], block[k][3]
                    states = (*sides[0], *sides[1])
                    if j:
                        since, start, states = noted[j - 1, k, 0], noted[j - 1, k, 2], noted[j - 1, k, 4:14].tolist()
                    if time > since:
                        self._kinds.append(kind)
                        self._rows.append([since, start, time, x, (x - start) / (time - since), way, strength, *states])
        self._noted = []
        return self._kinds, self._rows

    def replace(self, kinds: list[str], rows: list[list[float]]) -> None:
        """Lines from a checkpoint."""
        self._kinds, self._rows, self._noted = kinds, rows, []

    def table(self, mesh: Mesh, time: float) -> tuple[list[str], np.ndarray]:
        """(kinds, rows of COLUMNS) so far, in the order in which the lines began."""
        now = [(front, float(x)) for front, x in zip(mesh.fronts, mesh.x[mesh.faces()]) if time > front.since]
        ended, rows = self.lines()
        kinds = [*ended, *(front.kind for front, _ in now)]
        found = np.array([*rows, *(_row(front, time, x) for front, x in now)], dtype=float).reshape(-1, len(COLUMNS))
        order = np.lexsort((found[:, 1], found[:, 0]))
        return [kinds[k] for k in order], found[order]


def _row(front: Front, time: float, x: float) -> list[float]:
    speed = (x - front.start) / (time - front.since)
    return [front.since, front.start, time, x, speed, float(front.direction), front.strength, *front.sides[0], *front.sides[1]]
