"""Results of a run with contact: fields of nodes, numbers of the summary, balances of rigid bodies, checkpoint data."""

import numpy as np

from hugoniot.core.by_address import ByAddress
from hugoniot.core.compile_ahead import Job
from hugoniot.problem.plane.contact import bodies
from hugoniot.problem.plane.contact_model import centre_of
from hugoniot.solvers.lagrange2d.assemble import N
from hugoniot.solvers.lagrange2d.contact import layout as C
from hugoniot.solvers.lagrange2d.contact.step import job_of_contact, with_contact
from hugoniot.solvers.lagrange2d.contact.surfaces import Surfaces, contact_tables
from hugoniot.solvers.lagrange2d.quads import AREA_WEIGHTED, PLANAR

NEAREST = 8      # edges that are looked at for the gap of a point


class ContactResults:
    """Owns the tables of contact of a run, and reads them."""

    def __init__(self, problem, surfaces, nodes, kind: int, tables: C.Contact):
        self.nodes, self.problem, self.kind, self.tables = nodes, problem, kind, tables
        self.globals, self.movers = np.array(surfaces.point_nodes, dtype=np.int64), len(surfaces.nodes)
        self.count = problem.mesh.nodes.shape[1]
        points, edges = np.array(surfaces.points, dtype=np.int64), np.array(surfaces.edges, dtype=np.int64)
        self.columns, self.starts, self.ends = points[:, C.POINT_NODE], edges[:, C.EDGE_A], edges[:, C.EDGE_B]
        body = np.concatenate([bodies(problem.mesh), len(problem.blocks) + np.arange(len(problem.rigid))])
        self.body_of_edge, self.body_of_point = body[edges[:, C.EDGE_PART]], body[points[:, C.POINT_PART]]

    # -- for the march ---------------------------------------------------------------------------------------
    def jobs(self, run) -> list[Job]:
        """What has yet to be compiled."""
        return [job_of_contact(ByAddress(self.tables), run)]

    def given_to(self, run):
        """The run that the march takes, which knows these tables by their address."""
        self._at = ByAddress(self.tables)
        return with_contact(run, self._at)

    def enlarged(self, run):
        """The same with room for twice as many pairs."""
        self.tables = larger(self.tables)
        return self.given_to(run)

    def payload(self) -> dict:
        """What a bitwise restart needs of contact."""
        return {f"contact_{name}": getattr(self.tables, name).copy() for name in C.KEPT}

    def restored(self, run, kept: dict):
        """The run with the tables as they were kept."""
        self.tables = larger(self.tables, len(kept["contact_pairs"]))
        for name in C.KEPT:
            getattr(self.tables, name)[...] = kept[f"contact_{name}"]
        return self.given_to(run)

    # -- for observers ---------------------------------------------------------------------------------------
    def fields(self) -> dict[str, np.ndarray]:
        """Contact pressure (Pa, the normal force on a node over its area), gap (m) and distance slid (m) of every node; NaN inside."""
        found = {name: np.full(self.count, np.nan) for name in ("contact_pressure", "gap", "sliding_distance")}
        places, own = self.nodes[[N.x, N.y]][:, self.columns], len(self.globals)
        normal, area = self._normals(places)
        force = self.tables.of_points[:, [C.FORCE_X, C.FORCE_Y]].T
        with np.errstate(invalid="ignore", divide="ignore"):
            pressure = np.where(area > 0.0, -(force * normal).sum(axis=0) / area, 0.0)
        found["contact_pressure"][self.globals] = pressure[:own]
        found["sliding_distance"][self.globals] = self.tables.of_points[:own, C.SLID]
        found["gap"][self.globals] = self._gaps(places)[:own]
        return found

    def _normals(self, places):
        """(unit outward normal (2, n), area (n,)) of every point."""
        a, b = self.starts, self.ends
        along = places[:, b] - places[:, a]
        length = np.hypot(*along)
        normal, area = np.zeros_like(places), np.zeros(places.shape[1])
        for this, other in ((a, b), (b, a)):
            radius = np.ones(len(a)) if self.kind == PLANAR else places[0, this] if self.kind == AREA_WEIGHTED else (
                2.0 * places[0, this] + places[0, other]) / 3.0
            np.add.at(area, this, 0.5 * length * radius)
            for k, part in enumerate((along[1], -along[0])):
                np.add.at(normal[k], this, part / length)
        size = np.hypot(*normal)
        return normal / np.where(size > 0.0, size, 1.0), area

    def _gaps(self, places):
        """Distance of every point to the nearest edge of another body, NaN where there is none."""
        from scipy.spatial import cKDTree

        found, start, end = np.full(places.shape[1], np.nan), places[:, self.starts], places[:, self.ends]
        for body in np.unique(self.body_of_point):
            others, mine = np.flatnonzero(self.body_of_edge != body), np.flatnonzero(self.body_of_point == body)
            if not len(others) or not len(mine):
                continue
            near = cKDTree(0.5 * (start + end)[:, others].T).query(places[:, mine].T, k=min(NEAREST, len(others)))[1].reshape(len(mine), -1)
            a, along = start[:, others[near]], (end - start)[:, others[near]]
            offset = places[:, mine][:, :, None] - a
            share = np.clip((offset * along).sum(axis=0) / (along**2).sum(axis=0), 0.0, 1.0)
            found[mine] = np.hypot(*(offset - share * along)).min(axis=1)
        return found

    def summary(self) -> dict[str, float]:
        """Heat of surfaces that closed and work of friction, J; largest depth of a node behind a surface over the length of its edge."""
        n, counts = self.tables.numbers, self.tables.counts
        found = {"contact_heat": float(n[C.HEAT]), "friction_work": float(n[C.FRICTION]), "contact_depth": float(n[C.DEEPEST]),
                 "contact_sweeps": int(counts[C.SWEEPS]), "contact_searches": int(counts[C.SEARCHES]),
                 "bonds_broken": int(counts[C.BROKEN_BONDS])}
        return found

    def exchanges(self) -> dict[str, float]:
        """Heat and work of friction so far, J; how far each rigid body has moved, m, and by which angle one that turns has turned, rad."""
        numbers = self.tables.numbers
        found = {"contact_heat": float(numbers[C.HEAT]), "friction_work": float(numbers[C.FRICTION])}
        for body, row in zip(self.problem.rigid, self.tables.rigid):
            if body.name in self.problem.mesh.chains:      # a wall that lets go stays where it is
                continue
            x, y = centre_of(body)
            found |= {f"moved_x {body.name}": float(row[C.CENTRE_X] - x), f"moved_y {body.name}": float(row[C.CENTRE_Y] - y)}
            if body.turns:
                found[f"turned {body.name}"] = float(row[C.ANGLE])
        return found

    def rigid_velocity(self) -> dict[str, tuple[float, float, float]]:
        """Velocity of the centre of each rigid body, m/s, and its rate of turning, rad/s."""
        rows = zip(self.problem.rigid, self.tables.rigid)
        return {body.name: (float(row[C.SPEED_X]), float(row[C.SPEED_Y]), float(row[C.SPIN])) for body, row in rows}


class NothingMeets:
    """What there is to say of a run without contact: nothing."""

    tables = None

    def fields(self) -> dict:
        return {}

    summary = exchanges = payload = fields

    def jobs(self, run) -> list[Job]:
        return []

    def given_to(self, run):
        return run

    def restored(self, run, kept: dict):
        return run


def contact_of(solver, surfaces: Surfaces | None) -> ContactResults | NothingMeets:
    """The contact of a run with these surfaces."""
    if surfaces is None:
        return NothingMeets()
    tables = contact_tables(solver.problem, surfaces, solver.boundaries, solver.numbering, solver.run, solver.options)
    return ContactResults(solver.problem, surfaces, solver.nodes, solver.kind, tables)


def larger(contact: C.Contact, room: int | None = None) -> C.Contact:
    """The same tables with room for `room` pairs, twice as many as before if not said."""
    room = room or 2 * len(contact.pairs)
    made = {}
    for name in ("pairs", "pair_numbers", "old_pairs", "old_numbers"):
        table = getattr(contact, name)
        made[name] = C.table(room, table.shape[1]) if table.dtype == float else np.zeros((room, table.shape[1]), dtype=table.dtype)
        made[name][:min(room, len(table))] = table[:room]
    made |= {name: np.zeros(room, dtype=C.UNSIGNED) for name in ("touched", "active", "candidates")}
    made |= {"near": np.zeros((room, 4), dtype=C.UNSIGNED)}
    contact.sizes[C.NEAR] = -1
    return contact._replace(**made)
