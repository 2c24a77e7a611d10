"""Which nodes of several blocks are one: blocks join where the nodes of their sides coincide, whatever way their indices run."""

from collections.abc import Collection, Sequence

import numpy as np

SAME = 1e-6     # of the shortest edge at a node: nodes nearer than this are one
NEAR = 1e-3     # of an edge: a node this near another block's edge, without a partner there, was meant to join


def outline(ni: int, nj: int) -> dict[str, np.ndarray]:
    """Local nodes (n, 2) of each side, by rising index: left i = 0, right i = ni, bottom j = 0, top j = nj."""
    i, j = np.arange(ni + 1), np.arange(nj + 1)
    return {"left": np.stack([0 * j, j], axis=1), "right": np.stack([0 * j + ni, j], axis=1),
            "bottom": np.stack([i, 0 * i], axis=1), "top": np.stack([i, 0 * i + nj], axis=1)}


def rim(ni: int, nj: int) -> np.ndarray:
    """Local nodes (n, 2) of the whole outline, each once, in C order."""
    return np.unique(np.concatenate(list(outline(ni, nj).values())), axis=0)


def shortest_edges(nodes: np.ndarray) -> np.ndarray:
    """Length of the shortest edge at every node of a block, (ni + 1, nj + 1)."""
    along, upward = (np.hypot(*np.diff(nodes, axis=axis)) for axis in (1, 2))
    shortest = np.full(nodes.shape[1:], np.inf)
    for part, lengths in ((shortest[:-1], along), (shortest[1:], along), (shortest[:, :-1], upward), (shortest[:, 1:], upward)):
        np.minimum(part, lengths, out=part)
    return shortest


def join(positions: Sequence[np.ndarray], apart: Collection[tuple[int, int]] = ()) -> tuple[list[np.ndarray], np.ndarray]:
    """Global node numbers of every block, and the coordinates of the nodes.

    positions   node positions (2, ni + 1, nj + 1) of the blocks
    apart       pairs (lower, higher) of blocks that are not joined
    Returns the maps (ni + 1, nj + 1) from local to global number, counted in block order, i major, and nodes (2, nnode): where blocks
    share a node, the first block's position stands.
    """
    counts = [p[0].size for p in positions]
    starts = np.concatenate(([0], np.cumsum(counts)))
    label = np.arange(starts[-1])
    where, flat, near, block = [], [], [], []
    for k, (start, p) in enumerate(zip(starts, positions)):
        local = rim(p.shape[1] - 1, p.shape[2] - 1)
        where.append(p[:, local[:, 0], local[:, 1]])
        flat.append(start + local[:, 0] * p.shape[2] + local[:, 1])
        near.append(SAME * shortest_edges(p)[local[:, 0], local[:, 1]])
        block += [k] * len(local)
    where, flat, near = np.concatenate(where, axis=1), np.concatenate(flat), np.concatenate(near)
    for a, b in _close_pairs(where, near):
        if (min(block[a], block[b]), max(block[a], block[b])) in apart:
            continue
        low, high = sorted((_root(label, flat[a]), _root(label, flat[b])))
        label[high] = low
    label[flat] = [_root(label, k) for k in flat]
    own = label == np.arange(label.size)
    number = np.cumsum(own) - 1
    number = number[label]
    everything = np.concatenate([p.reshape(2, -1) for p in positions], axis=1)
    maps = [number[a:b].reshape(p.shape[1:]) for a, b, p in zip(starts, starts[1:], positions)]
    return maps, everything[:, own]


def _close_pairs(where: np.ndarray, near: np.ndarray) -> np.ndarray:
    """Pairs (n, 2) of rim nodes nearer to each other than the smaller of their tolerances, lower index first, in order."""
    from scipy.spatial import cKDTree

    pairs = cKDTree(where.T).query_pairs(float(near.max()), output_type="ndarray")
    if not len(pairs):
        return pairs.reshape(0, 2)
    apart = np.hypot(*(where[:, pairs[:, 0]] - where[:, pairs[:, 1]]))
    pairs = pairs[apart <= np.minimum(near[pairs[:, 0]], near[pairs[:, 1]])]
    return pairs[np.lexsort((pairs[:, 1], pairs[:, 0]))]


def _root(label: np.ndarray, k) -> int:
    while label[k] != k:
        k = label[k]
    return int(k)


def shared_nodes(maps: Sequence[np.ndarray], count: int) -> tuple[np.ndarray, np.ndarray]:
    """(starts (ngroup + 1,), members (n, 3)): local nodes (block, i, j) that are one node, by global number, then by block, i, j."""
    held = np.zeros(count, dtype=np.int64)
    for numbers in maps:
        held += np.bincount(numbers.ravel(), minlength=count)
    rows = []
    for block, numbers in enumerate(maps):
        i, j = np.nonzero(held[numbers] > 1)
        rows.append(np.stack([numbers[i, j], np.full(i.size, block), i, j], axis=1))
    rows = np.concatenate(rows)
    rows = rows[np.lexsort((rows[:, 3], rows[:, 2], rows[:, 1], rows[:, 0]))]
    return np.concatenate(([0], np.cumsum(held[held > 1]))), rows[:, 1:]


def inside(points: np.ndarray, ring: np.ndarray) -> np.ndarray:
    """Whether points (2, n) lie inside a closed polygon (2, m), by the even-odd rule."""
    x, y = points[:, :, None]
    (x0, y0), (x1, y1) = ring[:, None, :], np.roll(ring, -1, axis=1)[:, None, :]
    with np.errstate(divide="ignore", invalid="ignore"):
        crossed = ((y0 > y) != (y1 > y)) & (x < x0 + (y - y0) * (x1 - x0) / (y1 - y0))
    return (crossed.sum(axis=1) % 2).astype(bool)


def distance_to_edges(points: np.ndarray, start: np.ndarray, end: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(distance over the edge's length, index) of the edge start-end (2, m) nearest, in its own lengths, to each point (2, n)."""
    along = (end - start)[:, None, :]
    length2 = (along**2).sum(axis=0)
    offset = points[:, :, None] - start[:, None, :]
    share = np.clip((offset * along).sum(axis=0) / length2, 0.0, 1.0)
    away = np.hypot(*(offset - share * along)) / np.sqrt(length2)
    nearest = away.argmin(axis=1)
    return away[np.arange(nearest.size), nearest], nearest
