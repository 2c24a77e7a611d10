"""Where the material of a region is, and in what state, read from cells: positions by mass, states by the parabolas of the flow."""

import numpy as np

from hugoniot.laws.eos.contract import pressure
from hugoniot.laws.riemann.branch import State
from hugoniot.solvers.fronts.cells.flow import Media, averages, reconstruct
from hugoniot.solvers.fronts.cells.mesh import EMPTY, Mesh, mean_area


class Readable:
    """All cells now, reconstructed once."""

    def __init__(self, mesh: Mesh, media: Media):
        self.mesh, self.media = mesh, media
        self.mean = averages(mesh, media).w
        self.left, self.right = reconstruct(mesh, self.mean)
        self.full = mesh.full()


class CellColumn:
    """The cells of one region at one time, from left to right: `mass`, cumulated, and at(fraction)."""

    def __init__(self, flow: Readable, region: int):
        self.flow, self.laws = flow, flow.media.laws
        own = flow.mesh.region % (len(self.laws) // 2)
        self.cells = np.flatnonzero((own == region) & (flow.mesh.region != EMPTY) & flow.full)
        self.mass = np.concatenate([[0.0], np.cumsum(flow.mesh.q[self.cells, 0])])

    def at(self, fraction: float) -> tuple[float, State]:
        """(position, state) of the point that has this fraction of the region's mass on its left."""
        mass = min(max(fraction, 0.0), 1.0) * self.mass[-1]
        k = min(max(int(np.searchsorted(self.mass, mass, side="right")) - 1, 0), len(self.cells) - 1)
        cell, mesh = int(self.cells[k]), self.flow.mesh
        share = min(max((mass - self.mass[k]) / (self.mass[k + 1] - self.mass[k]), 0.0), 1.0)
        a, b = float(mesh.x[cell]), float(mesh.x[cell + 1])
        if mesh.d == 1:
            x = a + share * (b - a)
        else:
            x = (a**mesh.d + share * mesh.d * (b - a) * float(mean_area(a, b, mesh.d))) ** (1.0 / mesh.d)
        return self._state(cell, x, (x - a) / (b - a))

    def _state(self, cell: int, x: float, s: float):
        low, high, mean = (row[cell, :3] for row in (self.flow.left, self.flow.right, self.flow.mean))
        bend = 6.0 * (mean - 0.5 * (low + high))
        law = self.laws[self.flow.mesh.region[cell]]
        if law is None:
            return x, State(*mean.tolist(), 0.0)
        rho, u, e = (low + s * (high - low + bend * (1.0 - s))).tolist()
        if not (rho > 0.0 and np.isfinite(pressure(rho, e, law))):
            rho, u, e = mean.tolist()
        return x, State(rho, u, e, float(pressure(rho, e, law)))
