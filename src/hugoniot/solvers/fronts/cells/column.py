"""Where the material of a region is, and in what state, read from cells: positions by mass, states by the parabolas of the flow."""

import numpy as np

from hugoniot.laws.riemann.branch import Branch, Matter, State, stress
from hugoniot.solvers.fronts.cells.flow import Flow
from hugoniot.solvers.fronts.cells.mesh import EMPTY, Mesh, mean_area
from hugoniot.solvers.fronts.cells.pores import state_of
from hugoniot.solvers.fronts.cells.solids import with_deviator
from hugoniot.solvers.fronts.cells.tables import HIGH, LAM, LOW, MEAN, STATE, P


class Readable:
    """All cells now, reconstructed once."""

    def __init__(self, mesh: Mesh, flow: Flow):
        self.mesh, self.flow = mesh, flow
        w, n = flow.look(mesh), len(mesh.q)
        self.mean, self.left, self.right = (w[block:block + STATE, :n].T.copy() for block in (MEAN, LOW, HIGH))
        self.full = mesh.full()
        self.pressure = w[MEAN + P, :n].copy()


class CellColumn:
    """The cells of one region at one time, from left to right: `mass`, cumulated, and at(fraction)."""

    def __init__(self, flow: Readable, region: int):
        self.flow = flow
        own = flow.mesh.region % len(flow.flow.laws)
        self.cells = np.flatnonzero((own == region) & (flow.mesh.region != EMPTY) & flow.full)
        self.mass = np.concatenate([[0.0], np.cumsum(flow.mesh.q[self.cells, 0])])

    def at(self, fraction: float) -> tuple[float, State]:
        """(position, state) of the point that has this fraction of the region's mass on its left."""
        return self.point(fraction)[:2]

    def point(self, fraction: float) -> tuple[float, State, Matter, float]:
        """(position, state, what it is made of, burn fraction) of that point."""
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

    def _state(self, cell: int, x: float, s: float) -> tuple[float, State, Matter, float]:
        low, high, mean = (row[cell] for row in (self.flow.left, self.flow.right, self.flow.mean))
        bend = 6.0 * (mean - 0.5 * (low + high))
        flow, region = self.flow.flow, int(self.flow.mesh.region[cell])
        if region >= flow.bench.unburned:
            return x, State(*mean[:3].tolist(), 0.0), flow.bench.matters[region], 0.0
        for values in (low + s * (high - low + bend * (1.0 - s)), mean):
            rho, u, e, *mixed = values.tolist()
            matter = flow.matter(region, *mixed)
            porous = flow.porous[region % len(flow.porous)]
            p = np.nan
            if rho > 0.0:
                p = state_of(rho, u, e, mixed, matter).sigma if porous else float(stress(rho, e, Branch(matter.par)))
            if np.isfinite(p):
                break
        burned = float(flow.programmed[region]) if not flow.burns_by_rate[region] else min(max(values[LAM], 0.0), 1.0)
        if porous:
            return x, state_of(rho, u, e, mixed, matter), matter, burned
        return x, with_deviator(rho, u, e, mixed[1], matter, p), matter, burned
