"""Triangles from quadrilaterals: every cell of a mesh of blocks divided by one of its diagonals.

A diagonal runs from corner 0 to corner 2 of its cell (the corner at (i, j) to the one at (i + 1, j + 1)), or from corner 1 to corner 3.

    one_way       all from 0 to 2; six triangles meet in every node inside
    alternating   turned from each row of cells to the next along j; six triangles meet in every node inside, and no direction is preferred
                  from row to row
    crossed       turned from each cell to the next, along i and along j, so that diagonals cross in every other node; four and eight
                  triangles meet in the nodes in turn

The lower triangle of a cell holds the side between the corners 0 and 1, the upper one that between 2 and 3. Zones are numbered block by
block, row by row of cells, first the lower triangles of a row and then its upper ones: zone = block.first_zone + (2 i + k) nj + j.
"""

from dataclasses import replace

import numpy as np

from hugoniot.errors import OutOfRange
from hugoniot.mesh.blocks import Block, Blocks, Chain, Joint
from hugoniot.mesh.checks import MeshDefect, MeshError

DIAGONALS = ("one_way", "alternating", "crossed")
_LOWER = np.array([(0, 1, 3), (0, 1, 2)])       # corners of the lower triangle, by whether the diagonal runs from 0 to 2
_UPPER = np.array([(2, 3, 1), (2, 3, 0)])


def ways(ni: int, nj: int, diagonal: str) -> np.ndarray:
    """Whether the diagonal of each cell (ni, nj) runs from corner 0 to corner 2. Raises OutOfRange for a pattern there is not."""
    if diagonal not in DIAGONALS:
        raise OutOfRange(f"unknown pattern of diagonals {diagonal!r}; use {' or '.join(map(repr, DIAGONALS))}")
    i, j = np.indices((ni, nj))
    return {"one_way": np.ones((ni, nj), dtype=bool), "alternating": j % 2 == 0, "crossed": (i + j) % 2 == 0}[diagonal]


def corners_of(way: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Corners (n, 3) of their cells that lower and upper triangles have, from which way (n,) the diagonals run."""
    return _LOWER[way.astype(int)], _UPPER[way.astype(int)]


def by_rows(lower: np.ndarray, upper: np.ndarray, block: Block) -> np.ndarray:
    """Values (ni nj, ...) of the lower and the upper triangles of a block in the order of its zones."""
    shape = (block.ni, 1, block.nj, *lower.shape[1:])
    return np.concatenate([lower.reshape(shape), upper.reshape(shape)], axis=1).reshape(-1, *lower.shape[1:])


def divided(cells: Blocks, diagonal: str) -> Blocks:
    """The mesh of the triangles of a mesh of quadrilaterals. Raises `MeshError` where a triangle is turned over or flat."""
    blocks, corners, way, first = [], [], [], 0
    for block in cells.blocks:
        of_block = ways(block.ni, block.nj, diagonal).ravel()
        quads = cells.zone_nodes[block.first_zone : block.first_zone + block.zones]
        lower, upper = (np.take_along_axis(quads, which, axis=1) for which in corners_of(of_block))
        new = replace(block, first_zone=first, per_cell=2)
        corners.append(by_rows(lower, upper, block))
        blocks.append(new)
        way.append(of_block)
        first += new.zones
    way = np.concatenate(way)
    mesh = replace(cells, blocks=tuple(blocks), zone_nodes=np.concatenate(corners), block_of=np.repeat(cells.block_of, 2),
                   quads=cells, ways=way)
    _check(mesh)
    chains = {name: _chain(mesh, chain) for name, chain in cells.chains.items()}
    joints = {name: _joint(mesh, joint) for name, joint in cells.joints.items()}
    return replace(mesh, chains=chains, joints=joints)


def _triangles_of(mesh: Blocks, cell: int, block: int) -> tuple[int, int]:
    """Numbers of the lower and the upper triangle of a cell of a block."""
    here, of_cells = mesh.blocks[block], mesh.cells.blocks[block]
    i, j = divmod(cell - of_cells.first_zone, here.nj)
    lower = here.first_zone + 2 * i * here.nj + j
    return lower, lower + here.nj


def _behind(mesh: Blocks, edge, cell: int, block: int) -> int:
    """The triangle of a cell that has an edge (two nodes)."""
    return next(zone for zone in _triangles_of(mesh, cell, block) if set(edge) <= set(mesh.zone_nodes[zone].tolist()))


def _chain(mesh: Blocks, chain: Chain) -> Chain:
    zones = [_behind(mesh, edge, cell, chain.block) for edge, cell in zip(chain.edges.tolist(), chain.zones.tolist())]
    return replace(chain, zones=np.array(zones, dtype=chain.zones.dtype))


def _joint(mesh: Blocks, joint: Joint) -> Joint:
    zones = [[_behind(mesh, edge, cell, block) for cell, block in zip(pair, joint.blocks)]
             for edge, pair in zip(joint.edges.tolist(), joint.zones.tolist())]
    return replace(joint, zones=np.array(zones, dtype=joint.zones.dtype))


def _check(mesh: Blocks) -> None:
    """Raise `MeshError` where an area is not positive."""
    x, y = mesh.nodes[:, mesh.zone_nodes.T]
    areas = 0.5 * ((x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]))
    longest = np.max([np.hypot(x[k] - x[k - 1], y[k] - y[k - 1]) for k in range(3)], axis=0)
    wrong = np.flatnonzero(~(areas > 1e-9 * longest**2))
    defects = []
    for k, block in enumerate(mesh.blocks):
        mine = wrong[mesh.block_of[wrong] == k]
        if len(mine):
            row, j = divmod(int(mine[0]) - block.first_zone, block.nj)
            where = f"near ({x[:, mine[0]].mean():.4g}, {y[:, mine[0]].mean():.4g}) m"
            more = f" ({len(mine)} such triangles)" if len(mine) > 1 else ""
            defects.append(MeshDefect(k, "shape", f"a triangle of cell ({row // 2}, {j}) of block '{block.name}' {where} has the area "
                                      f"{areas[mine[0]]:.3g} m^2{more}", "the cell is not convex: use another diagonal, "
                                      'or fill = "winslow"'))
    if defects:
        raise MeshError(defects)
