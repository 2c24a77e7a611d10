"""Erosion: zones leave the mesh because of their plastic strain, their time step, or because the mesh would tangle in them.

An eroded zone is skipped: its row of zones is processed in the runs on both sides of it, its corner forces are zero, and
its faces towards other zones become surfaces that may touch others. Its mass stays with its nodes and moves with them; a node without
remaining zones moves on as a point mass. Alternatively the mass is dropped and accounted for. Its internal energy does no more work.
"""

import numpy as np

from hugoniot.errors import OutOfRange
from hugoniot.solvers.lagrange2d import layout as L
from hugoniot.solvers.lagrange2d.assemble import N, Z, corner_shares, quad_corners
from hugoniot.solvers.lagrange2d.contact import layout as C
from hugoniot.solvers.lagrange2d.contact.corners import DEEP, EDGE_END
from hugoniot.solvers.lagrange2d.contact.results import contact_of, larger
from hugoniot.solvers.lagrange2d.contact.surfaces import Surfaces
from hugoniot.solvers.lagrange2d.rows_of_blocks import cells

EVERY = 10      # cycles between two looks at the zones
NOTHING = (Z.p, Z.q, Z.sxx, Z.syy, Z.sxy, Z.qxx, Z.qyy, Z.qxy, Z.qhoop, Z.c, Z.viscous_speed, Z.sigma)
STEEPEST = 0.1       # square of the cosine between a normal and the direction in which a point on the axis or a wall may move
WEIGHTLESS = 1e-200      # kg: of a node whose zones have all been dropped, on which nothing acts


class Erosion:
    """The zones of a run that have left the mesh.

    live     (nzone,) whether a zone is in the mesh
    dropped  mass, momentum (x, y) and energy that have left with them, and mass times time until then: what a body force has pushed
    """

    def __init__(self, solver, surfaces):
        self.solver, self.law, self.surfaces = solver, solver.problem.solver.erosion, surfaces
        mesh = solver.problem.mesh
        if solver.problem.solver.cells != "quads":
            raise OutOfRange("erosion works with quads only; use solver.cells = 'quads'")
        if any(boundary.kind == "transmitting" for boundary in solver.problem.boundaries):
            raise OutOfRange("erosion and transmitting edges cannot be combined: zones at such an edge may erode; use another boundary")
        self.live, self.dropped = np.ones(len(mesh.zone_nodes), dtype=bool), np.zeros(5)
        self.shares = np.concatenate([corner_shares(*quad_corners(block), solver.kind) for block in mesh.blocks], axis=1)
        start = cells(mesh)
        self.cells = np.concatenate([int(start[k]) + np.add.outer((np.arange(b.ni) + 1) * (b.nj + 2), np.arange(b.nj) + 1).ravel()
                                     for k, b in enumerate(mesh.blocks)])

    def pause(self, end: int) -> int:
        """The cycle, at most `end`, at which the zones are looked at next."""
        return min(end, (self.solver.cycle // EVERY + 1) * EVERY)

    def due(self, code: int) -> np.ndarray:
        """Zones that leave now; `code` says why the march came back."""
        solver, z, law = self.solver, self.solver.zones, self.law
        leave = np.zeros(len(self.live), dtype=bool)
        if law.plastic_strain is not None:
            leave |= z[Z.plastic_strain] >= law.plastic_strain
        if law.smallest_step is not None:
            rate = (z[Z.c] + 2.0 * z[Z.viscous_speed]) * solver._inverse_altitudes()
            leave |= solver.problem.solver.courant < law.smallest_step * rate
        leave &= self.live
        if code in (L.TANGLED, L.STEP_COLLAPSED) and not leave.any():
            leave[self.flattest()] = True
        return np.flatnonzero(leave)

    def flattest(self) -> int:
        """The zone of those in the mesh that is nearest to having no area at a corner."""
        x, y = self.solver._corners(N.x), self.solver._corners(N.y)
        ahead, back = (-1, 1)
        triangle = 0.5 * ((np.roll(x, ahead, 0) - x) * (np.roll(y, back, 0) - y) - (np.roll(y, ahead, 0) - y) * (np.roll(x, back, 0) - x))
        area = 0.5 * ((x[2] - x[0]) * (y[3] - y[1]) - (y[2] - y[0]) * (x[3] - x[1]))
        return int(np.argmin(np.where(self.live, triangle.min(axis=0) / np.maximum(np.abs(area), 1e-300), np.inf)))

    def act(self, code: int) -> bool:
        """Let zones leave that are due; whether any did."""
        if self.solver.cycle % EVERY and code not in (L.TANGLED, L.STEP_COLLAPSED):
            return False
        zones = self.due(code)
        if len(zones):
            if self.law.mass == "dropped":
                self._drop(zones)
            self.live[zones] = False
            z = self.solver.zones
            self.solver.forces[:, zones] = 0.0
            for row in NOTHING:
                z[row, zones] = 0.0
            known = _places(self.solver.contact.tables)[1]
            self.take_out()
            corners = self.solver.numbering.representative[self.solver.problem.mesh.zone_nodes]
            lift_debris(self.solver.contact.tables, known, self.solver.nodes, self.surfaces.copies, corners)
            control = self.solver.control
            if code in (L.TANGLED, L.STEP_COLLAPSED):      # the step had shrunk for a zone that is gone
                control[L.RATE] = np.max(np.where(self.live, z[Z.c] + 2.0 * z[Z.viscous_speed], 0.0) * self.solver._inverse_altitudes())
                control[L.DT_NATURAL] = max(control[L.DT_NATURAL], 0.1 * control[L.COURANT] / control[L.RATE])
        return len(zones) > 0

    def _drop(self, zones):
        """Take the mass of zones off their nodes, with the momentum and the energy it has, and book them."""
        solver, z, n = self.solver, self.solver.zones, self.solver.nodes
        mesh, numbering = solver.problem.mesh, solver.numbering
        part = np.bincount(mesh.zone_nodes[zones].ravel(), (self.shares[:, zones] * z[Z.mass, zones]).T.ravel(), mesh.nodes.shape[1])
        at = numbering.representative
        whole = n[N.own, at] * numbering.copies
        part = np.where(np.isin(np.arange(len(part)), mesh.zone_nodes[self.live & ~np.isin(np.arange(len(self.live)), zones)]),
                        part, np.where(part > 0.0, whole, 0.0))      # nothing of a node is left without a zone, to the last bit
        u, v = n[N.u, at], n[N.v, at]
        self.dropped += (z[Z.mass, zones].sum(), (part * u).sum(), (part * v).sum(),
                         0.5 * (part * (u * u + v * v)).sum() + (z[Z.mass, zones] * z[Z.e, zones]).sum(), part.sum() * solver.time)
        z[Z.mass, zones] = 0.0
        left = whole - part
        n[N.own, :numbering.total] = (left / numbering.copies)[numbering.nodes]
        n[N.im, :numbering.total] = (1.0 / np.where(left > 0.0, left, WEIGHTLESS))[numbering.nodes]

    def take_out(self):
        """Give the march its lists, loads and surfaces without the zones that have left."""
        solver = self.solver
        solver.run.gradients[:, self.cells[~self.live]] = 0.0
        solver.plan = solver.plan_of(self.live)
        run = solver.run
        loads = run.loads[self.live[run.loads[:, L.LOAD_ZONE]]]
        problem, boundaries = solver.problem, solver.boundaries
        self.surfaces = Surfaces(problem, solver.numbering, boundaries, self.live, self.surfaces, self.law.mass == "kept")
        old, solver.contact = solver.contact.tables, contact_of(solver, self.surfaces)
        solver.contact.tables = carried_over(old, solver.contact.tables)
        solver.run = solver.contact.given_to(run._replace(loads=loads, given=np.zeros((len(loads), 4))))

    def seen(self, fields: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
        """Fields of zones as observers see them: no numbers where a zone has left the mesh."""
        found = {name: values if name == "mass" else np.where(self.live, values, np.nan) for name, values in fields.items()}
        return found | {"eroded": np.where(self.live, 0.0, 1.0)}

    def payload(self) -> dict:
        """What a bitwise restart needs."""
        return {"live": self.live.copy(), "dropped": self.dropped.copy()}

    def restore(self, payload: dict) -> None:
        """Take the zones out that had left."""
        self.dropped[...], live = payload["dropped"], np.array(payload["live"], dtype=bool)
        if not np.array_equal(live, self.live):
            self.live[...] = live
            self.take_out()

    def results(self) -> dict[str, float]:
        """Zones that have left the mesh, and what they weighed; with dropped mass, the energy and momentum that went with it."""
        z, gone = self.solver.zones, ~self.live
        found = {"zones_eroded": int(gone.sum())}
        if self.law.mass == "dropped":
            return found | self.exchanges()
        return found | {"eroded_mass": float(z[Z.mass, gone].sum()), "eroded_energy": float((z[Z.mass, gone] * z[Z.e, gone]).sum())}

    def exchanges(self) -> dict[str, float]:
        """Mass, momentum and energy that have been dropped so far; of zones whose mass is kept they are still among those of the body."""
        names = ("eroded_mass", "eroded_momentum_x", "eroded_momentum_y", "eroded_energy")
        return dict(zip(names, map(float, self.dropped))) if self.law.mass == "dropped" else {}


class NoErosion:
    """A run whose zones all stay."""

    live, dropped, surfaces = None, np.zeros(5), None

    def pause(self, end: int) -> int:
        return end

    def act(self, code: int) -> bool:
        return False

    def seen(self, fields: dict) -> dict:
        return fields

    def payload(self) -> dict:
        return {}

    results = exchanges = payload

    def restore(self, payload: dict) -> None:
        pass


def _places(contact) -> tuple[dict[int, int], dict[tuple[int, int], int]]:
    """Point by its node, edge by its nodes."""
    return {int(k): p for p, k in enumerate(contact.points[:, C.POINT_NODE])}, {
        (int(contact.points[a, C.POINT_NODE]), int(contact.points[b, C.POINT_NODE])): e for e, (a, b) in enumerate(contact.edges[:, :2])}


def lift_debris(contact: C.Contact, known: dict, nodes, copies, corners) -> None:
    """Put points without zones that are a little behind a surface that is not `known`, inside its zone, onto that surface.

    A zone that was folded on itself leaves them there. What is nearer to another surface of the zone came by that one and stays on it,
    where another body may be close. corners: node columns of the corners of every zone.
    """
    points, edge_of = contact.points, _places(contact)[1]
    free = np.flatnonzero((points[:, C.POINT_BEFORE] < 0) & (points[:, C.POINT_AFTER] < 0))
    places, fresh = nodes[[N.x, N.y]], [e for ends, e in edge_of.items() if ends not in known]
    for zone in dict.fromkeys(contact.edges[fresh, C.EDGE_ZONE].tolist()):
        sides = list(zip(corners[zone].tolist(), np.roll(corners[zone], -1).tolist()))
        outer = [k for k, ends in enumerate(sides) if ends in edge_of]
        start = places[:, corners[zone], None]
        way, offset = np.roll(start, -1, axis=1) - start, places[:, None, points[free, C.POINT_NODE]] - start
        length = np.hypot(*way)
        depth = (way[0] * offset[1] - way[1] * offset[0]) / length
        for i in np.flatnonzero((depth >= 0.0).all(axis=0)):
            k = outer[int(np.argmin(depth[outer, i]))]
            x, y = way[:, k, 0] / length[k, 0]
            mover, at = contact.mover_numbers[points[free[i], C.POINT_MOVER]], points[free[i], C.POINT_NODE]
            way_out = mover[[[C.PXX, C.PXY], [C.PXY, C.PYY]]] @ (y, -x)
            if sides[k] in known or not 0.0 < depth[k, i] < DEEP * length[k, 0] or way_out @ (y, -x) <= STEEPEST:
                continue
            place = places[:, at] + depth[k, i] / (way_out @ (y, -x)) * way_out
            if -EDGE_END <= (place - start[:, k, 0]) @ (x, y) / length[k, 0] <= 1.0 + EDGE_END:
                places[:, at] = place
                nodes[np.ix_([N.x, N.y], copies[points[free[i], C.POINT_MOVER]])] = place[:, None]


def carried_over(old: C.Contact, new: C.Contact) -> C.Contact:
    """New tables of contact with what the old ones know of points, pairs and bonds that are in both; the next step searches anew."""
    point_of, edge_of = _places(new)
    new.numbers[...], new.counts[...], new.rigid[...] = old.numbers, old.counts, old.rigid
    new.numbers[C.REACH] = -1.0      # less than nothing: a search is due
    ends = old.points[old.edges[:, :2], C.POINT_NODE]
    edge_now = np.array([edge_of.get((int(a), int(b)), -1) for a, b in ends], dtype=np.int64)
    point_now = np.array([point_of.get(int(k), -1) for k in old.points[:, C.POINT_NODE]], dtype=np.int64)
    stay = np.flatnonzero(point_now >= 0)
    new.of_points[point_now[stay]] = old.of_points[stay]
    bound = stay[(old.bonds[stay, C.BOND_STATE] != C.BOUND) | (edge_now[old.bonds[stay, C.BOND_EDGE]] >= 0)]
    new.bonds[point_now[bound]], new.bond_numbers[point_now[bound]] = old.bonds[bound], old.bond_numbers[bound]
    new.bonds[point_now[bound], C.BOND_EDGE] = edge_now[old.bonds[bound, C.BOND_EDGE]]
    pairs = old.pairs[:old.counts[C.PAIRS]]
    rows = np.flatnonzero((point_now[pairs[:, C.PAIR_POINT]] >= 0) & (edge_now[pairs[:, C.PAIR_EDGE]] >= 0))
    rows = rows[np.argsort(point_now[pairs[rows, C.PAIR_POINT]], kind="stable")]
    if len(rows) > len(new.pairs):
        new = larger(new, 2 * len(rows))
    new.pairs[:len(rows)], new.pair_numbers[:len(rows)] = pairs[rows], old.pair_numbers[rows]
    new.pairs[:len(rows), C.PAIR_POINT] = point_now[pairs[rows, C.PAIR_POINT]]
    new.pairs[:len(rows), C.PAIR_EDGE] = edge_now[pairs[rows, C.PAIR_EDGE]]
    new.counts[C.PAIRS], new.counts[C.ACTIVE], new.counts[C.FULL] = len(rows), 0, 0
    return new
