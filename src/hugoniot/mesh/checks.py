"""What is wrong with a mesh: folded zones, blocks that run clockwise, overlap, nearly touch, or touch without common nodes."""

import itertools
from collections.abc import Collection, Sequence
from dataclasses import dataclass

import numpy as np

from hugoniot.errors import HugoniotError
from hugoniot.mesh import joining
from hugoniot.mesh.shapes import SIDES

TOUCHING = 0.02     # of an edge: a node of a curved surface this near the other body's polygon touches it


@dataclass(frozen=True)
class MeshDefect:
    """One thing wrong: index of the block, the key of its deck table that is to blame, message and way out."""

    block: int
    key: str
    message: str
    hint: str = ""


class MeshError(HugoniotError):
    """Shapes that make no mesh; carries every defect found."""

    exit_code = 2

    def __init__(self, defects: list[MeshDefect]):
        self.defects = list(defects)
        super().__init__("\n".join(d.message + (f"; {d.hint}" if d.hint else "") for d in self.defects))


def corner_areas(nodes: np.ndarray) -> np.ndarray:
    """Areas (4, ni, nj) of the triangles at the corners of each zone: at (i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)."""
    corners = nodes[:, :-1, :-1], nodes[:, 1:, :-1], nodes[:, 1:, 1:], nodes[:, :-1, 1:]
    found = []
    for k in range(4):
        u, v = corners[(k + 1) % 4] - corners[k], corners[(k + 3) % 4] - corners[k]
        found.append(0.5 * (u[0] * v[1] - u[1] * v[0]))
    return np.array(found)


def subzone_areas(nodes: np.ndarray) -> np.ndarray:
    """Areas (4, ni, nj) of the quarters of each zone between a corner, the middles of its two edges and the zone's centre."""
    corners = nodes[:, :-1, :-1], nodes[:, 1:, :-1], nodes[:, 1:, 1:], nodes[:, :-1, 1:]
    centre = 0.25 * sum(corners)
    found = []
    for k in range(4):
        # diagonals of the quarter: corner to centre, and middle to middle
        u, v = centre - corners[k], 0.5 * (corners[(k + 3) % 4] - corners[(k + 1) % 4])
        found.append(0.5 * (u[0] * v[1] - u[1] * v[0]))
    return np.array(found)


def check_block(k: int, name: str, nodes: np.ndarray, axisymmetric: bool) -> list[MeshDefect]:
    """Defects of one block's nodes (2, ni + 1, nj + 1): not finite, beyond the axis, clockwise, a zone or a quarter of one not positive."""
    if not np.isfinite(nodes).all():
        return [MeshDefect(k, "shape", "its nodes are not finite numbers")]
    if axisymmetric and (nodes[0] < 0.0).any():
        i, j = (int(n) for n in np.unravel_index(nodes[0].argmin(), nodes.shape[1:]))
        return [MeshDefect(k, "shape", f"node ({i}, {j}) of block '{name}' lies at r = {nodes[0, i, j]:g} m, beyond the axis",
                           "radii are not negative; the axis is r = 0")]
    quarters = subzone_areas(nodes)
    areas = quarters.sum(axis=0)
    if (areas < 0.0).all():
        return [MeshDefect(k, "shape", f"block '{name}' runs clockwise", "exchange left and right, or bottom and top")]
    size = np.abs(areas).max()
    folded = ~(quarters.min(axis=0) > 1e-9 * np.maximum(areas, 1e-9 * size))
    if not folded.any():
        return []
    i, j = (int(n) for n in np.argwhere(folded)[0])
    where = nodes[:, i : i + 2, j : j + 2].reshape(2, -1).mean(axis=1)
    what = f"has the area {areas[i, j]:.3g} m^2" if areas[i, j] <= 0.0 else "has a folded corner"
    more = f" ({int(folded.sum())} such zones)" if folded.sum() > 1 else ""
    return [MeshDefect(k, "shape", f"zone ({i}, {j}) of block '{name}' near ({where[0]:.4g}, {where[1]:.4g}) m {what}{more}",
                       "use fill = \"winslow\", or divide the block")]


def check_neighbours(names: Sequence[str], maps: Sequence[np.ndarray], nodes: np.ndarray, sides: Sequence[dict],
                     apart: Collection[tuple[int, int]] = ()) -> None:
    """Raise `MeshError` where blocks overlap, or touch without common nodes and are not in `apart`, pairs that may."""
    defects = _crowded(names, sides)
    if not defects and (misfits := _misfits(names, maps, nodes, sides, apart)):
        # sides that cross touch too: what lies clearly inside another block is an overlap
        defects = _overlaps(names, maps, nodes, set(itertools.combinations(range(len(names)), 2))) or misfits
    defects = defects or _overlaps(names, maps, nodes, apart)
    if defects:
        raise MeshError(defects)


def _owners(sides: Sequence[dict]) -> dict[tuple[int, int], list[int]]:
    found: dict[tuple[int, int], list[int]] = {}
    for k, by_side in enumerate(sides):
        for side in SIDES:
            for a, b in by_side[side][0].tolist():
                found.setdefault((min(a, b), max(a, b)), []).append(k)
    return found


def _crowded(names, sides) -> list[MeshDefect]:
    for owners in _owners(sides).values():
        if len(owners) > 2:
            others = ", ".join(f"'{names[k]}'" for k in owners)
            return [MeshDefect(owners[-1], "shape", f"{len(owners)} sides share one edge: {others}", "blocks must not overlap")]
    return []


def _misfits(names, maps, nodes, sides, apart) -> list[MeshDefect]:
    """Rim nodes that lie on another block's boundary edge and are none of its nodes."""
    found = []
    owners = _owners(sides)
    free = {k: np.concatenate([by_side[side][0] for side in SIDES]) for k, by_side in enumerate(sides)}
    free = {k: np.array([e for e in edges.tolist() if len(owners[min(e), max(e)]) == 1]).reshape(-1, 2) for k, edges in free.items()}
    for a in range(len(names)):
        for b in range(len(names)):
            if a == b or (min(a, b), max(a, b)) in apart or not len(free[a]) or not len(free[b]):
                continue
            mine, start, end = np.unique(free[a]), nodes[:, free[b][:, 0]], nodes[:, free[b][:, 1]]
            mine = np.setdiff1d(mine, np.unique(free[b]))
            mine = mine[_near_box(nodes[:, mine], start, end)]
            if not len(mine):
                continue
            away, _ = joining.distance_to_edges(nodes[:, mine], start, end)
            close = away < joining.NEAR
            if close.any():
                x, y = nodes[:, mine[close][0]]
                message = f"touches block '{names[b]}' near ({x:.6g}, {y:.6g}) m, but their nodes do not coincide there"
                hint = ("blocks that are one body need the same nodes along the common edge, that is, the same zones and ratio; "
                        f'bodies that meet there need [[contact]] with between = ["{names[a]}", "{names[b]}"]')
                found.append(MeshDefect(a, "zones", message, hint))
                break
    return found


def _near_box(points, start, end) -> np.ndarray:
    low, high = np.minimum(start, end).min(axis=1), np.maximum(start, end).max(axis=1)
    margin = 1e-2 * np.hypot(*(end - start)).max()
    return ((points >= low[:, None] - margin) & (points <= high[:, None] + margin)).all(axis=0)


def _ring(numbers: np.ndarray) -> np.ndarray:
    return np.concatenate([numbers[:-1, 0], numbers[-1, :-1], numbers[:0:-1, -1], numbers[0, :0:-1]])


def _overlaps(names, maps, nodes, apart) -> list[MeshDefect]:
    for a in reversed(range(len(names))):
        for b in range(len(names)):
            if a == b:
                continue
            ring = nodes[:, _ring(maps[b])]
            mine = np.setdiff1d(_ring(maps[a]), _ring(maps[b]))
            points = np.concatenate([nodes[:, mine], _middles(nodes, maps[a])], axis=1)
            points = points[:, _near_box(points, ring, ring)]
            if points.size and (min(a, b), max(a, b)) in apart:
                away, _ = joining.distance_to_edges(points, ring, np.roll(ring, -1, axis=1))
                points = points[:, away > TOUCHING]
            if points.size and (covered := joining.inside(points, ring)).any():
                x, y = points[:, covered][:, 0]
                return [MeshDefect(a, "shape", f"overlaps block '{names[b]}' near ({x:.6g}, {y:.6g}) m", "blocks may only share edges")]
    return []


def _middles(nodes, numbers) -> np.ndarray:
    """Centres of a block's outer zones: they catch a block laid exactly over another."""
    quads = [numbers[:-1, :-1], numbers[1:, :-1], numbers[1:, 1:], numbers[:-1, 1:]]
    centres = np.mean([nodes[:, q] for q in quads], axis=0)
    return np.concatenate([centres[:, 0], centres[:, -1], centres[:, :, 0], centres[:, :, -1]], axis=1)
