"""Surfaces of the blocks and rigid bodies of a problem as tables of contact."""

import numpy as np

from hugoniot.problem.plane.contact_model import Contact2D
from hugoniot.problem.plane.model import Problem2D
from hugoniot.solvers.lagrange1d.nodes import pulse_value
from hugoniot.solvers.lagrange2d import layout as L
from hugoniot.solvers.lagrange2d.assemble import N
from hugoniot.solvers.lagrange2d.boundaries import Pulses
from hugoniot.solvers.lagrange2d.contact import layout as C

CLOSED_TO_CONTACT = ("wall", "axis", "transmitting")      # boundaries that stand for what is outside
KINDS = {"bonded": C.BONDED, "sliding": C.SLIDING, "separable": C.SEPARABLE}
PAIRS_OF_A_POINT = 4      # room at the start
PIECES = 4.0              # mean edges: how long an edge of a rigid body may be


def surface_edges(problem: Problem2D, shut_nodes):
    """Boundary edges (a, b, block, zone) of global nodes, the material on their left, without those that hold a node of `shut_nodes`."""
    mesh, found = problem.mesh, []
    for name, boundary in problem.chain_boundaries().items():
        chain = mesh.chains[name]
        if boundary.kind in CLOSED_TO_CONTACT:
            continue
        for (a, b), zone in zip(chain.edges.tolist(), chain.zones.tolist()):
            if a not in shut_nodes and b not in shut_nodes:
                found.append((a, b, chain.block, zone) if chain.outward > 0 else (b, a, chain.block, zone))
    return sorted(found, key=lambda row: _place(mesh.nodes, row))


def _place(nodes, row):
    """What edges are sorted by: their middle, then their direction. The order of the blocks plays no part in how contact is found."""
    (ax, ay), (bx, by) = nodes[:, row[0]], nodes[:, row[1]]
    return ax + bx, ay + by, bx - ax, by - ay


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
    """Points and edges of a problem; `extra` (2, n) the places of the vertices of rigid bodies, behind the nodes of the blocks."""

    def __init__(self, problem: Problem2D, numbering, boundaries):
        mesh, first = problem.mesh, numbering.total
        shut = {int(numbering.nodes[k]) for k in boundaries.gates[:, 0]}
        rows = surface_edges(problem, shut)
        ends = np.array([(a, b) for a, b, _, _ in rows], dtype=np.int64).reshape(-1, 2)
        lengths = np.hypot(*(mesh.nodes[:, ends[:, 1]] - mesh.nodes[:, ends[:, 0]]))
        self.mean = float(lengths.mean()) if len(lengths) else 1.0
        blocks = len(problem.blocks)
        parts = np.array([row[2] for row in rows], dtype=np.int64)
        self.lengths = [float(lengths[parts == k].mean()) if (parts == k).any() else np.inf for k in range(blocks)]
        self.nodes = list(dict.fromkeys(ends.ravel().tolist()))          # global nodes in the order of the points
        point_of = {node: k for k, node in enumerate(self.nodes)}
        part_of = {}
        for (a, b), part in zip(ends.tolist(), parts.tolist()):
            part_of.setdefault(a, part)
            part_of.setdefault(b, part)
        self.edges = [(point_of[a], point_of[b], part, zone) for a, b, part, zone in rows]
        self.points = [(int(numbering.representative[node]), k, part_of[node]) for k, node in enumerate(self.nodes)]
        self.copies = [numbering.all_copies(node).tolist() for node in self.nodes]
        extra = []
        for r, body in enumerate(problem.rigid):
            vertices = rigid_polyline(body, mesh, PIECES * self.mean)
            start, column = len(self.points), first + sum(map(len, extra))
            mover = len(self.nodes) + r
            self.points += [(column + k, mover, blocks + r) for k in range(len(vertices))]
            last = len(vertices) if body.closed else len(vertices) - 1
            self.edges += [(start + k, start + (k + 1) % len(vertices), blocks + r, -1) for k in range(last)]
            self.copies.append(list(range(column, column + len(vertices))))
            extra.append(vertices)
        self.extra = np.concatenate(extra).T if extra else np.zeros((2, 0))


def with_rigid(problem: Problem2D, surfaces: Surfaces | None, nodes):
    """The table of nodes with the vertices of rigid bodies behind those of the blocks; they have no mass there."""
    if surfaces is None:
        return nodes
    table = np.zeros((len(N), nodes.shape[1] + surfaces.extra.shape[1]))
    table[:, :nodes.shape[1]] = nodes
    table[[N.x, N.y], nodes.shape[1]:] = table[[N.xh, N.yh], nodes.shape[1]:] = surfaces.extra
    for body, columns in zip(problem.rigid, surfaces.copies[len(surfaces.nodes):]):
        start, way = np.array(body.start), np.zeros(2) if body.direction is None else np.array(body.direction)
        if body.pulse is not None:
            start = _at_start(body.pulse) * way
        elif body.direction is not None:
            start = (start @ way) * way
        table[N.u, columns], table[N.v, columns] = start
    return table


def _at_start(pulse) -> float:
    pulses = Pulses()
    pulses.put(pulse)
    numbers, tables = pulses.arrays()
    return float(pulse_value(0.0, numbers[0], tables[0]))


def contact_tables(problem: Problem2D, surfaces: Surfaces, boundaries, numbering, zones) -> C.Contact:
    """The tables of a run; chains of rigid bodies stand behind those of the edges."""
    points = np.full((len(surfaces.points), 6), -1, dtype=np.int64)
    points[:, :3] = np.array(surfaces.points, dtype=np.int64).reshape(-1, 3)
    edges = np.array(surfaces.edges, dtype=np.int64).reshape(-1, 4)
    for e, (a, b, _, _) in enumerate(edges.tolist()):
        points[a, C.POINT_AFTER], points[b, C.POINT_BEFORE] = e, e
    movers, numbers, speeds, tables = _movers(problem, surfaces, boundaries, numbering)
    law_of, laws = law_tables(problem, [*surfaces.lengths, *[np.inf] * len(problem.rigid)])
    count, room = len(points), PAIRS_OF_A_POINT * len(points) + 16
    sizes = np.concatenate(([0], np.cumsum([len(c) for c in surfaces.copies])))
    totals = np.zeros(7)
    totals[C.MEAN_EDGE] = surfaces.mean

    def of_pairs():
        return np.zeros((room, C.PAIR_INTS), dtype=np.int64), np.zeros((room, C.PAIR_FLOATS))

    ints = np.int64
    copies = np.array([k for group in surfaces.copies for k in group], dtype=ints)
    return C.Contact(
        points, edges, movers, numbers, sizes.astype(ints), copies, law_of, laws, *of_pairs(), *of_pairs(), np.zeros(room, dtype=ints),
        np.zeros((count, 2), dtype=ints), np.zeros((count, C.BOND_FLOATS)), np.zeros((count, 3)),
        np.zeros(4 * len(edges) + 17, dtype=ints), np.zeros(len(edges), dtype=ints), np.zeros((count, 2)), totals,
        np.zeros(7, dtype=ints), zones, speeds, tables)


def _movers(problem: Problem2D, surfaces: Surfaces, boundaries, numbering):
    pulses = Pulses()
    count = len(surfaces.nodes)
    movers = np.full((count + len(problem.rigid), 5), -1, dtype=np.int64)
    numbers = np.zeros((len(movers), C.MOVER_FLOATS))
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
        movers[m] = surfaces.copies[m][0], r, len(problem.mesh.chains) + r, -1, -1
        way = np.zeros(2) if body.direction is None else np.array(body.direction)
        if body.mass is not None:
            share = body.mass / (2.0 * np.pi if problem.geometry == "axisymmetric" else 1.0)
            numbers[m, C.IM] = 1.0 / share
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
