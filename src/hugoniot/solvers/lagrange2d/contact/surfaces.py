"""Surfaces of the blocks and rigid bodies of a problem as tables of contact."""

import numpy as np

from hugoniot.problem.plane.contact_model import Contact2D, centre_of, inertia_of
from hugoniot.problem.plane.model import Problem2D
from hugoniot.solvers.lagrange1d.pulses import pulse_value
from hugoniot.solvers.lagrange2d import layout as L
from hugoniot.solvers.lagrange2d.assemble import N
from hugoniot.solvers.lagrange2d.boundaries import Pulses
from hugoniot.solvers.lagrange2d.contact import layout as C
from hugoniot.solvers.lagrange2d.contact.faces import surface_faces

CLOSED_TO_CONTACT = ("wall", "axis", "transmitting")      # boundaries that stand for what is outside
KINDS = {"bonded": C.BONDED, "sliding": C.SLIDING, "separable": C.SEPARABLE}
PAIRS_OF_A_POINT = 4      # room at the start
PIECES = 4.0              # mean edges: how long an edge of a rigid body may be


def rigid_polyline(body, mesh, longest):
    """Vertices (n, 2) of a rigid body with the solid on their left, edges no longer than `longest`, and whether it is closed."""
    points = np.array(body.points, dtype=float)
    if body.closed:
        ahead = np.roll(points, -1, axis=0)
        if np.sum(points[:, 0] * ahead[:, 1] - ahead[:, 0] * points[:, 1]) < 0.0:
            points = points[::-1]
    elif _material_on_left(points, mesh):
        points = points[::-1]
    ends = np.concatenate([points, points[:1]]) if body.closed else points
    pieces = []
    for a, b in zip(ends[:-1], ends[1:]):
        count = max(int(np.ceil(np.hypot(*(b - a)) / longest)), 1)
        pieces.append(a + (b - a) * (np.arange(count) / count)[:, None])
    return np.concatenate([*pieces, *([] if body.closed else [ends[-1:]])])


def _material_on_left(points, mesh) -> bool:
    """Whether the mesh lies to the left of an open polyline: the side of the boundary node nearest to it, of those not on it."""
    nodes = mesh.nodes[:, np.unique(np.concatenate([chain.edges.ravel() for chain in mesh.chains.values()]))].T
    best, left = np.inf, False
    for a, b in zip(points[:-1], points[1:]):
        along = b - a
        length = np.hypot(*along)
        share = np.clip((nodes - a) @ along / length**2, 0.0, 1.0)
        away = np.hypot(*(nodes - a - share[:, None] * along).T)
        side = (along[0] * (nodes[:, 1] - a[1]) - along[1] * (nodes[:, 0] - a[0])) / length
        away = np.where(np.abs(side) > 1e-9 * length, away, np.inf)
        if away.min() < best:
            best, left = float(away.min()), bool(side[away.argmin()] > 0.0)
    return left


def law_tables(problem: Problem2D, lengths):
    """(law_of (part, part), laws): -1 between rigid bodies; twice the laws of the problem, for the side that is tied and the other.

    lengths: mean edge of each part; of two that are bonded the one with the shorter edges is tied, never a rigid one.
    """
    names = [block.name for block in problem.blocks] + [body.name for body in problem.rigid]
    given = {tuple(sorted(c.between)): c for c in problem.contacts if c.between}
    default = next((c for c in problem.contacts if c.between is None), Contact2D())
    every = [default, *given.values()]
    laws = [(KINDS[c.kind], c.friction, c.strength or 0.0, ties) for c in every for ties in (1.0, 0.0)]
    law_of = np.full((len(names), len(names)), -1, dtype=np.int64)
    count = len(problem.blocks)
    for a in range(len(names)):
        for b in range(len(names)):
            if a < count or b < count:
                contact = given.get(tuple(sorted((names[a], names[b]))), default)
                tied = b >= count or (a < count and (lengths[a], a) < (lengths[b], b))
                law_of[a, b] = 2 * next(k for k, c in enumerate(every) if c is contact) + (0 if tied else 1)
    return law_of, np.array(laws, dtype=float)


class Surfaces:
    """Points and edges of a problem; `extra` (2, n) the places of the vertices of rigid bodies, behind the nodes of the blocks.

    live    whether each zone is in the mesh; with debris, nodes that zones have left behind are points without edges
    before  the surfaces before zones left, whose rigid bodies stay as they are

    nodes         global nodes that move by themselves, in the order of their movers
    point_nodes   global node of each point that is not of a rigid body
    """

    def __init__(self, problem: Problem2D, numbering, boundaries, live=None, before=None, debris=True):
        mesh = problem.mesh
        live = np.ones(len(mesh.zone_nodes), dtype=bool) if live is None else live
        shut = np.array([int(numbering.nodes[k]) for k in boundaries.gates[:, 0]], dtype=np.int64)
        outside = [mesh.chains[name].edges for name, b in problem.chain_boundaries().items() if b.kind in CLOSED_TO_CONTACT]
        faces, follows = surface_faces(mesh, live, np.concatenate([np.zeros((0, 2), dtype=np.int64), *outside]), shut)
        ahead = np.roll(mesh.zone_nodes, -1, axis=1)
        ends = np.array([(mesh.zone_nodes[face], ahead[face]) for face in faces], dtype=np.int64).reshape(-1, 2)
        lengths = np.hypot(*(mesh.nodes[:, ends[:, 1]] - mesh.nodes[:, ends[:, 0]]))
        self.mean = before.mean if before else float(lengths.mean()) if len(lengths) else 1.0
        parts = mesh.block_of[[zone for zone, _ in faces]] if faces else np.zeros(0, dtype=np.int64)
        self.lengths = before.lengths if before else [float(lengths[parts == k].mean()) if (parts == k).any() else np.inf
                                                      for k in range(len(problem.blocks))]
        across = np.array([np.roll(mesh.zone_nodes[zone], -face)[[2, -1]] for zone, face in faces], dtype=np.int64).reshape(-1, 2)
        self._join(faces, follows, ends, across, parts, numbering)
        if debris:
            self._add_debris(mesh, live, numbering)
        self.vertices = before.vertices if before else [rigid_polyline(body, mesh, PIECES * self.mean) for body in problem.rigid]
        self._add_rigid(problem, numbering.total)

    def _join(self, faces, follows, ends, across, parts, numbering):
        """Edges of faces, with a point wherever one follows another, ends or starts."""
        point_of, mover_of, self.points, self.edges, self.point_nodes = {}, {}, [], [], []
        follows = np.array(follows, dtype=np.int64)
        followed = np.isin(np.arange(len(faces)), follows)
        for e, ((zone, _), nodes) in enumerate(zip(faces, ends.tolist())):
            behind = int(follows[e])
            keys = (e if followed[e] else ("starts", e)), (behind if behind >= 0 else ("ends", e))
            for key, node in zip(keys, nodes):
                if key not in point_of:
                    point_of[key] = len(self.points)
                    mover = mover_of.setdefault(node, len(mover_of))
                    self.points.append((int(numbering.representative[node]), mover, int(parts[e])))
                    self.point_nodes.append(node)
            self.edges.append((point_of[keys[0]], point_of[keys[1]], int(parts[e]), zone, *numbering.representative[across[e]].tolist()))
        self.nodes = list(mover_of)
        self.copies = [numbering.all_copies(node).tolist() for node in self.nodes]

    def _add_debris(self, mesh, live, numbering):
        """Nodes that zones have left behind."""
        gone = np.unique(mesh.zone_nodes[~live])
        for node in gone[~np.isin(gone, mesh.zone_nodes[live])].tolist():
            zone = int(np.flatnonzero((mesh.zone_nodes == node).any(axis=1))[0])
            self.points.append((int(numbering.representative[node]), len(self.nodes), int(mesh.block_of[zone])))
            self.point_nodes.append(node)
            self.nodes.append(node)
            self.copies.append(numbering.all_copies(node).tolist())

    def _add_rigid(self, problem, first):
        """Points and edges of rigid bodies."""
        blocks, movers = len(problem.blocks), len(self.nodes)
        for r, (body, vertices) in enumerate(zip(problem.rigid, self.vertices)):
            start, count = len(self.points), len(vertices)
            self.points += [(first + k, movers + r, blocks + r) for k in range(count)]
            self.edges += [(start + k, start + (k + 1) % count, blocks + r, -1, -1, -1) for k in range(count if body.closed else count - 1)]
            self.copies.append(list(range(first, first + count)))
            first += count
        self.extra = np.concatenate(self.vertices).T if self.vertices else np.zeros((2, 0))


def with_rigid(problem: Problem2D, surfaces: Surfaces | None, nodes):
    """The table of nodes with the vertices of rigid bodies behind those of the blocks; they have no mass there."""
    if surfaces is None:
        return nodes
    table = np.zeros((len(N), nodes.shape[1] + surfaces.extra.shape[1]))
    table[:, :nodes.shape[1]] = nodes
    table[[N.x, N.y], nodes.shape[1]:] = table[[N.xh, N.yh], nodes.shape[1]:] = surfaces.extra
    for body, columns in zip(problem.rigid, surfaces.copies[len(surfaces.nodes):]):
        start, arm = _at_start(body), table[[N.x, N.y]][:, columns] - np.array(centre_of(body))[:, None]
        table[N.u, columns], table[N.v, columns] = start[0] - body.spin * arm[1], start[1] + body.spin * arm[0]
    return table


def rigid_table(problem: Problem2D) -> np.ndarray:
    """What moves rigid bodies, at t = 0; columns are in `layout`."""
    table = np.zeros((len(problem.rigid), C.MEAN_SPIN + 1))
    for row, body in zip(table, problem.rigid):
        row[[C.CENTRE_X, C.CENTRE_Y]], row[[C.SPEED_X, C.SPEED_Y]], row[C.SPIN] = centre_of(body), _at_start(body), body.spin
    return table


def _at_start(body) -> np.ndarray:
    """Velocity of a rigid body at t = 0."""
    start, way = np.array(body.start), np.zeros(2) if body.direction is None else np.array(body.direction)
    if body.pulse is None:
        return start if body.direction is None else (start @ way) * way
    pulses = Pulses()
    pulses.put(body.pulse)
    numbers, tables = pulses.arrays()
    return float(pulse_value(0.0, numbers[0], tables[0])) * way


def contact_tables(problem: Problem2D, surfaces: Surfaces, boundaries, numbering, run, options) -> C.Contact:
    """The tables of the contact of a run; chains of rigid bodies stand behind those of the edges."""
    points = np.full((len(surfaces.points), 6), -1, dtype=np.int64)
    points[:, :3] = np.array(surfaces.points, dtype=np.int64).reshape(-1, 3)
    edges = np.array(surfaces.edges, dtype=np.int64).reshape(-1, 6)
    for e, (a, b) in enumerate(edges[:, :2].tolist()):
        points[a, C.POINT_AFTER], points[b, C.POINT_BEFORE] = e, e
    movers, numbers, speeds, tables = _movers(problem, surfaces, boundaries, numbering)
    law_of, laws = law_tables(problem, [*surfaces.lengths, *[np.inf] * len(problem.rigid)])
    count, room = len(points), PAIRS_OF_A_POINT * len(points) + 16
    sizes = np.concatenate(([0], np.cumsum([len(c) for c in surfaces.copies])))
    totals = np.zeros(6)
    totals[C.MEAN_EDGE] = surfaces.mean

    def ints(*shape):
        return np.zeros(shape, dtype=np.int64)

    def numbers_of(*shape):
        return np.zeros(shape, dtype=C.UNSIGNED)

    pairs = {"pairs": numbers_of(room, C.PAIR_INTS), "old_pairs": numbers_of(room, 2), "pair_numbers": C.table(room, C.PAIR_FLOATS),
             "old_numbers": C.table(room, C.PAIR_FLOATS)}
    lists = {"near": numbers_of(room, 4), "listed": numbers_of(len(movers)), "bound": numbers_of(count), "touched": numbers_of(room),
             "near_points": numbers_of(count, 2), "marks": ints(count), "sizes": np.array([-1, 0, 0, 0, 0, 0]),
             "active": numbers_of(room), "candidates": numbers_of(room), "pushed": numbers_of(len(movers))}
    of_search = {"cells": ints(4 * len(edges) + 17), "sorted_edges": ints(len(edges)), "boxes": np.zeros((len(edges), 4)),
                 "since": np.zeros((count, 2)), "flight": C.table(count, 4), "looked": np.zeros(4)}
    return C.Contact(
        points, edges, movers, numbers, rigid_table(problem), np.flatnonzero(movers[:, C.MOVER_CHAIN_1] >= 0), sizes.astype(np.int64),
        np.array([k for group in surfaces.copies for k in group], dtype=np.int64), law_of, laws, **pairs, **lists, **of_search,
        places=C.table(count + len(problem.rigid), C.HALF_Y + 1), bonds=ints(count, 2), bond_numbers=np.zeros((count, C.BOND_FLOATS)),
        of_points=np.zeros((count, 3)), numbers=totals, counts=ints(8), zones=run.zones, nodes=run.nodes, chains=run.chains,
        kind=options.kind, gx=options.gx, gy=options.gy, binds=bool((laws[:, C.LAW_KIND] != C.SLIDING).any()), speeds=speeds,
        speed_tables=tables)


def _movers(problem: Problem2D, surfaces: Surfaces, boundaries, numbering):
    pulses = Pulses()
    count = len(surfaces.nodes)
    movers = np.full((count + len(problem.rigid), 6), -1, dtype=np.int64)
    movers[:, C.MOVER_LISTED] = 0
    numbers = C.table(len(movers), C.MOVER_FLOATS)
    numbers[:, C.PXX], numbers[:, C.PYY] = 1.0, 1.0
    held = {int(numbering.nodes[row[L.HOLD_NODE]]): (row, normal) for row, normal in zip(boundaries.held, boundaries.held_normals)}
    for m, node in enumerate(surfaces.nodes):
        movers[m, C.MOVER_NODE] = numbering.representative[node]
        if node in held:
            row, normal = held[node]
            movers[m, C.MOVER_CHAIN_1], movers[m, C.MOVER_CHAIN_2] = row[L.HOLD_CHAIN_1], row[L.HOLD_CHAIN_2]
            _project(numbers[m], normal, row[L.HOLD_CHAIN_2] >= 0)
    for r, body in enumerate(problem.rigid):
        m = count + r
        movers[m] = surfaces.copies[m][0], r, len(problem.mesh.chains) + r, -1, -1, 0
        way = np.zeros(2) if body.direction is None else np.array(body.direction)
        if body.mass is not None:
            share = body.mass / (2.0 * np.pi if problem.geometry == "axisymmetric" else 1.0)
            numbers[m, C.IM] = 1.0 / share
            if body.turns:
                numbers[m, C.II] = 1.0 / inertia_of(body)
            if body.direction is not None:
                numbers[m, [C.PXX, C.PXY, C.PYY]] = way[0] ** 2, way[0] * way[1], way[1] ** 2
        elif body.pulse is not None:
            movers[m, C.MOVER_PULSE] = pulses.put(body.pulse)
            numbers[m, [C.H1X, C.H1Y]] = way
    return movers, numbers, *pulses.arrays()


def _project(numbers, normal, both: bool):
    ax, ay, bx, by = normal
    numbers[[C.H1X, C.H1Y, C.H2X, C.H2Y]] = normal
    numbers[[C.PXX, C.PXY, C.PYY]] = (0.0, 0.0, 0.0) if both else (1.0 - ax * ax, -ax * ay, 1.0 - ay * ay)
