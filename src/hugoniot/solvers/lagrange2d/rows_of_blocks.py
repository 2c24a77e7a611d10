"""Rows of zones and of nodes of the blocks, their positions in the tables, and the ghost cells around the blocks."""

import numpy as np

from hugoniot.solvers.lagrange2d import plane_rows
from hugoniot.solvers.lagrange2d.assemble import Numbering, Z
from hugoniot.solvers.lagrange2d.heat_flux import Carried
from hugoniot.solvers.lagrange2d.smoothness import Gradients

XI, ETA = Gradients._fields.index("xix"), Gradients._fields.index("etax")
WORD = 8      # bytes of a number


def cells(mesh):
    """First cell of each block in the table of gradients, which has a line of cells around every block; the last one is the size."""
    return np.concatenate(([0], np.cumsum([(block.ni + 2) * (block.nj + 2) for block in mesh.blocks])))


def gradient_rows(problem) -> int:
    """Rows of the table of gradients: those of `smoothness` and, where artificial heat flows (`Planner.conducts`), of `heat_flux`."""
    options, materials = problem.solver, [problem.materials[block.material] for block in problem.blocks]
    fluid = any(material.strength is None and material.burn is None for material in materials)
    flows = fluid and options.viscosity.heat_flux > 0.0 and options.cells != "triangles"
    return len(Gradients._fields) + (len(Carried._fields) if flows else 0)


def zone_rows(mesh, numbering: Numbering, material_of, live=None):
    """For every row of nodes what stands behind it: (count, material, origins in the order of `plane_rows`) of the row of cells, or of
    every stretch of it that is live; nothing behind the last row of a block."""
    found, start = [], cells(mesh)
    for k, block in enumerate(mesh.blocks):
        for i in range(block.ni):
            zone, node = _row_of_zones(block, i), int(numbering.local(k, i, 0))
            cell, upper = int(start[k]) + (i + 1) * (block.nj + 2) + 1, _upper(block, zone)
            places = zone, zone, node, node + block.nj + 1, cell, cell - block.nj - 2, cell + block.nj + 2, upper, upper
            found.append([(last - first, material_of[k], *(WORD * (place + first) for place in places))
                          for first, last in ([(0, block.nj)] if live is None else stretches(live[zone:zone + block.nj]))])
        found.append([])
    return found


def _row_of_zones(block, i: int) -> int:
    """First zone of row i of the cells of a block."""
    return block.first_zone + block.per_cell * i * block.nj


def _upper(block, zone: int) -> int:
    """First upper triangle of the row of cells whose first zone is `zone`."""
    return zone + (block.per_cell - 1) * block.nj


def stretches(live) -> list[tuple[int, int]]:
    """(first, one after the last) of every run of true values."""
    turns = np.flatnonzero(np.diff(np.concatenate(([False], live, [False])).astype(np.int8)))
    return list(zip(turns[::2].tolist(), turns[1::2].tolist()))


def node_rows(mesh, numbering: Numbering):
    """(count, rows of zones beside it, origins) of every row of nodes."""
    found = []
    for k, block in enumerate(mesh.blocks):
        for i in range(block.ni + 1):
            beside = plane_rows.BEHIND_ONLY if i == 0 else plane_rows.BEFORE_ONLY if i == block.ni else plane_rows.BOTH
            behind, before = _row_of_zones(block, min(i, block.ni - 1)), _row_of_zones(block, max(i - 1, 0))
            places = behind, before, int(numbering.local(k, i, 0)), 0, 0, 0, 0, _upper(block, behind), _upper(block, before)
            found.append((block.nj + 1, beside, *(WORD * place for place in places)))
    return found


def block_sides(block):
    """Zones along the left, right, bottom and top side of a block, each with the corner at which its edge on that side starts."""
    number = block.first_zone + np.arange(block.ni * block.nj).reshape(block.ni, block.nj)
    return [[(int(zone), k) for zone in zones] for zones, k in ((number[0], 3), (number[-1], 1), (number[:, 0], 0), (number[:, -1], 2))]


def ghost_tables(mesh, numbering: Numbering, mirrors, alike):
    """The cells around the blocks (columns of `smoothness`), in the order of the rows of zones they lie beside: integers, normals of walls
    with the way to the cell, and how many come before a row of nodes.

    mirrors: (4 blocks, 2) normals of the walls that are whole sides of blocks, 0 elsewhere; alike: whether heat flows between two zones
    at a joint.
    """
    mesh = mesh.cells
    owners: dict[tuple[int, int], list[tuple[int, int]]] = {}
    corners, start = mesh.zone_nodes, cells(mesh)
    for block in mesh.blocks:
        for zone, k in (edge for side in block_sides(block) for edge in side):
            owners.setdefault(tuple(sorted((corners[zone, k], corners[zone, (k + 1) % 4]))), []).append((zone, k))
    places, numbers, firsts, beside, rows = [], [], [block.first_zone for block in mesh.blocks], [], 0

    def cell_of(zone):
        n = int(np.searchsorted(firsts, zone, side="right")) - 1
        i, j = divmod(zone - firsts[n], mesh.blocks[n].nj)
        return int(start[n]) + (i + 1) * (mesh.blocks[n].nj + 2) + j + 1

    for n, block in enumerate(mesh.blocks):
        for side, edges in enumerate(block_sides(block)):
            direction, way = (ETA, XI)[side // 2], (-1.0, 1.0)[side % 2]
            step = (block.nj + 2 if direction == ETA else 1) * int(way)
            for zone, k in edges:
                own = cell_of(zone)
                ends = corners[zone, k], corners[zone, (k + 1) % 4]
                others = [(z, c) for z, c in owners[tuple(sorted(ends))] if (z, c) != (zone, k)]
                far = [corners[z, (c + m) % 4] for z, c in others[:1] for m in (2, 3)]
                nodes = [int(numbering.representative[node]) for node in (*ends, *far)]
                heat = [cell_of(z) for z, _ in others[:1] if alike(zone, z)]
                places.append((own + step, own, direction, *nodes, *([-1, -1] if not far else []), *(heat or [-1])))
                numbers.append((*mirrors[4 * n + side], way))
                beside.append(rows + (zone - block.first_zone) // block.nj)
        rows += block.ni + 1
    order = np.argsort(beside, kind="stable")
    return np.array(places, dtype=np.int64)[order], np.array(numbers)[order], np.searchsorted(np.sort(beside), np.arange(rows + 1))


def alike(problem, zones):
    """What says whether two zones are of one material and start alike."""
    blocks, number, start = problem.blocks, problem.mesh.block_of, zones[[Z.rho, Z.e]].copy()

    def answer(zone, other) -> bool:
        same = blocks[number[zone]].material == blocks[number[other]].material
        return same and np.allclose(start[:, zone], start[:, other], rtol=1e-9, atol=0.0)

    return answer
