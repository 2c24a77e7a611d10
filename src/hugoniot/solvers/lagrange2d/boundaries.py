"""Boundaries of a Problem2D as tables for the march: loaded edges, transmitting nodes, held nodes, pulses."""

from dataclasses import dataclass, field

import numpy as np

from hugoniot.errors import OutOfRange
from hugoniot.mesh.shapes import SIDES
from hugoniot.problem.model import Pulse
from hugoniot.problem.plane.model import Problem2D
from hugoniot.solvers.lagrange1d.layout import PULSES
from hugoniot.solvers.lagrange2d.assemble import Numbering
from hugoniot.solvers.lagrange2d.transmitting import open_edge_table

PARALLEL = 1e-6       # sine of the angle below which two directions are one


@dataclass
class Tables:
    """What `march.Run` takes; columns are in `layout`."""

    loads: np.ndarray
    gates: np.ndarray
    open_edges: np.ndarray
    held: np.ndarray
    held_normals: np.ndarray
    pulses: np.ndarray
    tables: np.ndarray
    special: np.ndarray
    mirrors: np.ndarray
    chains: list[str]


@dataclass
class _Hold:
    """What holds a global node: unit directions with their pulse (-1: none) and chain, at most two that are independent."""

    directions: list[tuple[np.ndarray, int, int]] = field(default_factory=list)

    def add(self, direction, pulse: int, chain: int):
        direction = np.asarray(direction, dtype=float)
        for k, (known, old, _) in enumerate(self.directions):
            if abs(known[0] * direction[1] - known[1] * direction[0]) < PARALLEL:
                if pulse >= 0 and old < 0:       # what is driven goes before what stands
                    self.directions[k] = (direction, pulse, chain)
                return
        if len(self.directions) < 2:
            self.directions.append((direction, pulse, chain))


class Pulses:
    """Pulses of a problem as numbers."""

    def __init__(self):
        self.found: list[Pulse] = []

    def put(self, pulse: Pulse) -> int:
        if pulse not in self.found:
            self.found.append(pulse)
        return self.found.index(pulse)

    def arrays(self):
        length = max([len(p.times) for p in self.found if p.shape == "table"], default=1)
        numbers, tables = np.zeros((len(self.found), 4)), np.zeros((len(self.found), 2, length))
        for k, p in enumerate(self.found):
            numbers[k] = PULSES[p.shape], p.amplitude, p.start, p.duration
            if p.shape == "table":
                more = length - len(p.times)
                tables[k, 0] = [*p.times, *(p.times[-1] + 1e30 * (n + 1) for n in range(more))]
                tables[k, 1] = [*p.values, *[p.values[-1]] * more]
        return numbers, tables


def boundary_tables(problem: Problem2D, numbering: Numbering) -> Tables:
    """Tables of all chains. OutOfRange where a wall is not straight."""
    mesh, given = problem.mesh, problem.chain_boundaries()
    pulses, holds, loads, gates, opened = Pulses(), {}, [], {}, 0
    for index, (name, boundary) in enumerate(given.items()):
        chain = mesh.chains[name]
        if boundary.kind == "wall":
            normal = mesh.straight_normal(chain)
            if normal is None:
                raise OutOfRange(f"the boundary '{name}' is a wall, but it is not straight; divide the block so that each straight part "
                                 "is a side of its own")
            directions = [normal] if boundary.slip else [normal, np.array([-normal[1], normal[0]])]
            for node in chain.nodes.tolist():
                for direction in directions:
                    holds.setdefault(node, _Hold()).add(direction, -1, index)
        elif boundary.kind == "axis":
            for node in chain.nodes.tolist():
                holds.setdefault(node, _Hold()).add((1.0, 0.0), -1, index)
        elif boundary.kind == "velocity":
            _drive(mesh, chain, boundary, pulses.put(boundary.pulse), index, holds)
        elif boundary.kind in ("pressure", "transmitting"):
            for edge, zone in zip(chain.edges.tolist(), chain.zones.tolist()):
                opened += boundary.kind == "transmitting"
                pulse = pulses.put(boundary.pulse) if boundary.kind == "pressure" else -opened
                a, b = _table_nodes(numbering, chain.block, edge)
                loads.append((a, b, zone, index, pulse, chain.outward))
            if boundary.kind == "transmitting":
                gates |= dict.fromkeys((int(node), index) for node in chain.nodes)
    held, normals = _held(numbering, holds)
    gate_rows = [(int(copy), chain, int(m == 0)) for (node, chain) in gates for m, copy in enumerate(numbering.all_copies(node))]
    loads = np.array(loads, dtype=np.int64).reshape(-1, 6)
    numbers, tables = pulses.arrays()
    copies = numbering.copies[numbering.nodes] > 1
    around = np.unique(numbering.nodes[np.concatenate([loads[:, 0], loads[:, 1], held[:, 0]])]) if len(loads) + len(held) else []
    touched = {int(n) for n in around} | {node for node, _ in gates}
    special = np.flatnonzero(copies | np.isin(numbering.nodes, list(touched)))
    gate_table = np.array(gate_rows, dtype=np.int64).reshape(-1, 3)
    open_edges = open_edge_table(mesh, numbering, list(given), gate_table, loads)
    return Tables(loads, gate_table, open_edges, held, normals, numbers, tables, special.astype(np.int64), _mirrors(mesh, given),
                  list(given))


def _mirrors(mesh, given):
    """Normals of the walls (and the axis) that are whole sides of blocks, (4 blocks, 2); 0 elsewhere."""
    found = np.zeros((4 * len(mesh.blocks), 2))
    for name, boundary in given.items():
        chain = mesh.chains[name]
        block = mesh.blocks[chain.block]
        whole = len(chain.edges) == (block.nj if chain.side in ("left", "right") else block.ni)
        normal = mesh.straight_normal(chain) if boundary.kind in ("wall", "axis") and whole else None
        if normal is not None:
            found[4 * chain.block + SIDES.index(chain.side)] = normal
    return found


def _table_nodes(numbering: Numbering, block: int, edge):
    """Places in the table of an edge's nodes, as copies of the chain's own block."""
    low, high = numbering.first[block], numbering.first[block + 1]
    return [int(next(c for c in numbering.all_copies(node) if low <= c < high)) for node in edge]


def _drive(mesh, chain, boundary, pulse: int, index: int, holds):
    """Hold the nodes of a driven chain."""
    normals = mesh.outward_normals(chain)
    inward: dict[int, np.ndarray] = {}
    for k, edge in enumerate(chain.edges.tolist()):
        for node in edge:
            inward[node] = inward.get(node, np.zeros(2)) - normals[:, k]
    for node, direction in inward.items():
        way = direction / np.hypot(*direction) if boundary.direction is None else np.asarray(boundary.direction, dtype=float)
        holds.setdefault(node, _Hold()).add(way, pulse, index)
        if not boundary.slip:
            holds[node].add((-way[1], way[0]), -1, index)


def _held(numbering: Numbering, holds):
    rows, normals = [], []
    for node, hold in sorted(holds.items()):
        (first, pulse, chain), *more = hold.directions
        second, other_pulse, other = more[0] if more else (np.zeros(2), -1, -1)
        for m, copy in enumerate(numbering.all_copies(node)):
            rows.append((int(copy), chain, pulse, other, other_pulse, int(m == 0)))
            normals.append((*first, *second))
    return np.array(rows, dtype=np.int64).reshape(-1, 6), np.array(normals, dtype=float).reshape(-1, 4)
