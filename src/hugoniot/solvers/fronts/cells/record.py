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
        self.kinds: list[str] = []
        self.rows: list[list[float]] = []
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
            self.kinds.append(front.kind)
            self.rows.append(_row(front, time, x))

    def drain(self, mesh: Mesh, work: tables.Work, regions: int) -> None:
        """Take over what the march has noted: the lines of all fronts end there, and new ones begin.

        The fronts are those of the mesh, unchanged since the march began.
        """
        rows = work.trace[:int(work.numbers[tables.SAMPLED])].tolist()
        work.numbers[tables.SAMPLED] = 0.0
        faces, now = mesh.faces(), [front.strength for front in mesh.fronts]
        for time, k, x, strength, *states in rows:
            front, f = mesh.fronts[int(k)], int(faces[int(k)])
            front.strength = strength
            self.end(front, time, x)
            front.since, front.start, front.sides = time, x, (tuple(states[:5]), tuple(states[5:10]))
            if "shock" in front.kind:
                region = int(max(mesh.region[f - 1], mesh.region[f])) % regions
                self.jumps[region] = max(self.jumps.get(region, 0.0), abs(states[1] - states[6]))
        for front, strength in zip(mesh.fronts, now):      # the strengths noted are older than those the march came back with
            front.strength = strength

    def table(self, mesh: Mesh, time: float) -> tuple[list[str], np.ndarray]:
        """(kinds, rows of COLUMNS) so far, in the order in which the lines began."""
        now = [(front, float(x)) for front, x in zip(mesh.fronts, mesh.x[mesh.faces()]) if time > front.since]
        kinds = [*self.kinds, *(front.kind for front, _ in now)]
        found = np.array([*self.rows, *(_row(front, time, x) for front, x in now)], dtype=float).reshape(-1, len(COLUMNS))
        order = np.lexsort((found[:, 1], found[:, 0]))
        return [kinds[k] for k in order], found[order]


def _row(front: Front, time: float, x: float) -> list[float]:
    speed = (x - front.start) / (time - front.since)
    return [front.since, front.start, time, x, speed, float(front.direction), front.strength, *front.sides[0], *front.sides[1]]
