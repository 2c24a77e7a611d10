"""Two-dimensional meshes of logically rectangular blocks that share nodes where their sides meet.

`build` makes `Blocks` from shapes (`mesh.shapes` says which index runs which way): one numbering of nodes and zones, the table of nodes
that blocks share, the chains of boundary edges and the joints between blocks. All lengths in m.

Zones are numbered block by block, (i, j) in C order: zone = block.first_zone + i * nj + j. Its nodes are (i, j), (i + 1, j),
(i + 1, j + 1), (i, j + 1): counter-clockwise. `mesh.triangles` divides them.
"""

from collections.abc import Collection, Sequence
from dataclasses import dataclass

import numpy as np

from hugoniot.mesh import joining
from hugoniot.mesh.checks import MeshDefect, MeshError, check_block, check_neighbours
from hugoniot.mesh.fill import ShapeError, positions
from hugoniot.mesh.shapes import SIDES, Shape

__all__ = ["Block", "BlockShape", "Blocks", "Chain", "Joint", "MeshError", "build"]

_ON_AXIS = 1e-9     # of the shortest edge at a node: a radius below this is that of the axis


@dataclass(frozen=True)
class BlockShape:
    """What a block is made from: name, shape, zones (ni, nj) and ratios of neighbouring widths along i and j."""

    name: str
    shape: Shape
    zones: tuple[int, int]
    ratio: tuple[float, float] = (1.0, 1.0)


@dataclass(frozen=True, eq=False)
class Block:
    """One block: cells ni by nj, first_zone its first zone's number, x and y (ni + 1, nj + 1) of its nodes, nodes their global numbers.

    per_cell   zones in a cell: 1, or 2 triangles
    """

    name: str
    ni: int
    nj: int
    first_zone: int
    x: np.ndarray
    y: np.ndarray
    nodes: np.ndarray
    per_cell: int = 1

    @property
    def zones(self) -> int:
        """How many zones it has."""
        return self.per_cell * self.ni * self.nj

    def place(self, zone: int) -> tuple[int, int]:
        """Cell (i, j) of a zone of the block."""
        row, j = divmod(zone - self.first_zone, self.nj)
        return row // self.per_cell, j


@dataclass(frozen=True, eq=False)
class Chain:
    """Boundary edges of one side of one block.

    edges     (n, 2) global nodes, by rising index along the side
    zones     (n,) zone behind each edge
    spans     stretches (from, to) of the side's edges that are on the boundary: ((0, n),) unless the side is joined in part
    outward   +1 if the outward normal lies to the right of edges as they run (edge rotated clockwise), -1 if to the left
    on_axis   whether all of it lies on r = 0 in axisymmetric geometry
    """

    name: str
    block: int
    side: str
    edges: np.ndarray
    zones: np.ndarray
    spans: tuple[tuple[int, int], ...]
    outward: int
    on_axis: bool

    @property
    def nodes(self) -> np.ndarray:
        """Global nodes of the chain, each once, in order along the side."""
        return np.array(list(dict.fromkeys(self.edges.ravel().tolist())), dtype=np.int64)


@dataclass(frozen=True, eq=False)
class Joint:
    """Edges two blocks share (or one with itself): edges (n, 2) global nodes, zones (n, 2) on the side of the first and of the second."""

    name: str
    blocks: tuple[int, int]
    edges: np.ndarray
    zones: np.ndarray


@dataclass(frozen=True, eq=False)
class Blocks:
    """A mesh.

    blocks         in the order given
    nodes          (2, nnode) coordinates, one column per node
    zone_nodes     (nzone, 4) nodes of every zone, counter-clockwise; (nzone, 3) where zones are triangles (`mesh.triangles`)
    block_of       (nzone,) block of every zone
    shared_start, shared   local nodes that are one: members shared[shared_start[k]:shared_start[k + 1]] = (block, i, j) of group k, in
                   fixed order (groups by global number, members by block, i, j)
    chains         boundary edges by name, "<block>.<side>"; sides that are joined all along have none
    joints         shared edges by name, "<block>/<block>" in block order
    axisymmetric   whether the first coordinate is a radius
    quads, ways    of triangles: the mesh of the cells they divide, and whether each cell's diagonal runs from its corner 0 to 2
    """

    blocks: tuple[Block, ...]
    nodes: np.ndarray
    zone_nodes: np.ndarray
    block_of: np.ndarray
    shared_start: np.ndarray
    shared: np.ndarray
    chains: dict[str, Chain]
    joints: dict[str, Joint]
    axisymmetric: bool = False
    quads: "Blocks | None" = None
    ways: np.ndarray | None = None

    @property
    def cells(self) -> "Blocks":
        """The mesh of the quadrilaterals: this one, or the one that triangles divide."""
        return self if self.quads is None else self.quads

    def outward_normals(self, chain: Chain) -> np.ndarray:
        """Unit outward normal (2, n) of each edge of a chain at t = 0."""
        along = self.nodes[:, chain.edges[:, 1]] - self.nodes[:, chain.edges[:, 0]]
        return chain.outward * np.array([along[1], -along[0]]) / np.hypot(*along)

    def straight_normal(self, chain: Chain, tolerance: float = 1e-6) -> np.ndarray | None:
        """Unit outward normal (2,) of a straight chain; None where it bends by more than `tolerance` of its length.

        Normals along an axis of coordinates are exact.
        """
        points = self.nodes[:, chain.nodes]
        start, end = self.nodes[:, chain.edges[0, 0]], self.nodes[:, chain.edges[-1, 1]]
        along = end - start
        length = float(np.hypot(*along))
        if length == 0.0:
            return None
        normal = chain.outward * np.array([along[1], -along[0]]) / length
        if np.abs(normal @ (points - start[:, None])).max() > tolerance * length:
            return None
        normal = np.where(np.abs(normal) < tolerance, 0.0, normal)
        return normal / np.hypot(*normal)


def build(shapes: Sequence[BlockShape], axisymmetric: bool = False, apart: Collection[tuple[int, int]] = ()) -> Blocks:
    """The mesh of some blocks. Raises `MeshError` with everything that is wrong with it.

    apart   pairs (lower, higher) of blocks that are not joined where they touch
    """
    made: list[np.ndarray | None] = []
    defects: list[MeshDefect] = []
    for k, block in enumerate(shapes):
        try:
            nodes = positions(block.shape, block.zones, block.ratio)
            if axisymmetric:
                nodes = _snapped_to_axis(nodes)
            wrong = check_block(k, block.name, nodes, axisymmetric)
        except ShapeError as error:
            nodes, wrong = None, [MeshDefect(k, error.key, error.message, error.hint)]
        made.append(None if wrong else nodes)
        defects += wrong
    sound = [nodes for nodes in made if nodes is not None]
    if defects or len(sound) < len(shapes):
        raise MeshError(defects)
    maps, nodes = joining.join(sound, apart)
    blocks, first = [], 0
    for block, numbers in zip(shapes, maps):
        ni, nj = block.zones
        blocks.append(Block(block.name, ni, nj, first, nodes[0, numbers], nodes[1, numbers], numbers))
        first += ni * nj
    sides = [_side_edges(block) for block in blocks]
    check_neighbours([b.name for b in blocks], maps, nodes, sides, apart)
    chains, joints = _chains_and_joints(blocks, sides, nodes, axisymmetric)
    starts, shared = joining.shared_nodes(maps, nodes.shape[1])
    block_of = np.repeat(np.arange(len(blocks)), [b.ni * b.nj for b in blocks])
    return Blocks(tuple(blocks), nodes, np.concatenate([_zone_nodes(b.nodes) for b in blocks]), block_of, starts, shared, chains, joints,
                  axisymmetric)


def _snapped_to_axis(nodes: np.ndarray) -> np.ndarray:
    """The nodes, radii of a rounding error's size made exactly 0."""
    near = np.abs(nodes[0]) <= _ON_AXIS * joining.shortest_edges(nodes)
    return np.array([np.where(near, 0.0, nodes[0]), nodes[1]])


def _zone_nodes(numbers: np.ndarray) -> np.ndarray:
    return np.stack([numbers[:-1, :-1], numbers[1:, :-1], numbers[1:, 1:], numbers[:-1, 1:]], axis=-1).reshape(-1, 4)


def _side_edges(block: Block) -> dict[str, tuple[np.ndarray, np.ndarray]]:
    """(edges (n, 2) of global nodes, zones (n,)) of each side, by rising index."""
    found = {}
    zone = block.first_zone + np.arange(block.ni * block.nj).reshape(block.ni, block.nj)
    behind = {"left": zone[0], "right": zone[-1], "bottom": zone[:, 0], "top": zone[:, -1]}
    for side, local in joining.outline(block.ni, block.nj).items():
        numbers = block.nodes[local[:, 0], local[:, 1]]
        found[side] = np.stack([numbers[:-1], numbers[1:]], axis=1), behind[side]
    return found


def _chains_and_joints(blocks, sides, nodes, axisymmetric) -> tuple[dict[str, Chain], dict[str, Joint]]:
    holders: dict[tuple[int, int], list[tuple[int, str, int, int]]] = {}
    for k, by_side in enumerate(sides):
        for side in SIDES:
            edges, zones = by_side[side]
            for n, (pair, zone) in enumerate(zip(edges.tolist(), zones.tolist())):
                holders.setdefault((min(pair), max(pair)), []).append((k, side, n, zone))
    chains: dict[str, Chain] = {}
    for k, by_side in enumerate(sides):
        for side in SIDES:
            edges, zones = by_side[side]
            free = np.array([len(holders[min(pair), max(pair)]) == 1 for pair in edges.tolist()])
            if free.any():
                name = f"{blocks[k].name}.{side}"
                axis = axisymmetric and bool((nodes[0, edges[free]] == 0.0).all())
                chains[name] = Chain(name, k, side, edges[free], zones[free], _spans(free), 1 if side in ("right", "bottom") else -1, axis)
    found: dict[tuple[int, int], list[tuple[tuple[int, int], int, int]]] = {}
    for pair, held in holders.items():
        if len(held) == 2:
            (a, _, _, zone_a), (b, _, _, zone_b) = held
            found.setdefault((a, b), []).append((pair, zone_a, zone_b))
    joints = {}
    for (a, b), rows in sorted(found.items()):
        name = f"{blocks[a].name}/{blocks[b].name}"
        joints[name] = Joint(name, (a, b), np.array([row[0] for row in rows]), np.array([row[1:] for row in rows]))
    return chains, joints


def _spans(free: np.ndarray) -> tuple[tuple[int, int], ...]:
    steps = np.diff(np.concatenate(([0], free.astype(int), [0])))
    return tuple(zip(np.flatnonzero(steps == 1).tolist(), np.flatnonzero(steps == -1).tolist()))
