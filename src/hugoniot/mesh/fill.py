r"""Nodes inside a block: box, sector, and four curved edges filled by transfinite interpolation or Winslow's equipotential zoning.

Transfinite interpolation (Gordon and Hall, Int. J. Numer. Meth. Eng. 7 (1973) 461) blends opposite edges linearly.

Winslow (J. Comput. Phys. 1 (1966) 149) lets the two families of mesh lines be equipotentials: two functions $s$ and $t$, harmonic in
the block, $s$ from 0 on the left to 1 on the right and $t$ from bottom to top. Exchanging dependent and independent variables,

$$\alpha\,\mathbf x_{ss} - 2\beta\,\mathbf x_{st} + \gamma\,\mathbf x_{tt} = 0,\qquad
  \alpha = |\mathbf x_t|^2,\quad \beta = \mathbf x_s\cdot\mathbf x_t,\quad \gamma = |\mathbf x_s|^2 .$$

The mixed derivative is taken on six neighbours, with the diagonal along which all weights stay positive: (1, 1) where $\beta < 0$ and
(1, -1) elsewhere. Grading enters through unequal steps of s and t.
"""

import numpy as np

from hugoniot.mesh.curves import cosine_and_sine, nodes_on, reversed_curve
from hugoniot.mesh.line import graded_nodes
from hugoniot.mesh.shapes import SIDES, Box, Curve, Edges, Sector, Shape

_MEET = 1e-6        # of the shorter edge: how near the ends of two curves must come to meet
_CONVERGED = 1e-10  # of the smallest edge: largest shift of a node in the last iteration
_MOST = 400


class ShapeError(ValueError):
    """A shape that makes no mesh: `key` is the part of the shape that is wrong, message and hint are for the user."""

    def __init__(self, key: str, message: str, hint: str = ""):
        self.key, self.message, self.hint = key, message, hint
        super().__init__(message)


def positions(shape: Shape, zones: tuple[int, int], ratio: tuple[float, float]) -> np.ndarray:
    """Node positions (2, ni + 1, nj + 1), m. Raises `ShapeError`."""
    (ni, nj), (qi, qj) = zones, ratio
    if isinstance(shape, Box):
        return np.array(np.meshgrid(graded_nodes(*shape.x, ni, qi), graded_nodes(*shape.y, nj, qj), indexing="ij"))
    if isinstance(shape, Sector):
        radius = graded_nodes(*shape.radius, ni, qi)[:, None]
        cosine, sine = cosine_and_sine(graded_nodes(*shape.angle, nj, qj))
        return np.array([shape.centre[0] + radius * cosine, shape.centre[1] + radius * sine])
    edges = _edges(shape, zones, ratio)
    s, t = graded_nodes(0.0, 1.0, ni, qi), graded_nodes(0.0, 1.0, nj, qj)
    nodes = transfinite(edges, s, t)
    return winslow(nodes, s, t) if shape.fill == "winslow" else nodes


def _edges(shape: Edges, zones, ratio) -> dict[str, np.ndarray]:
    """Nodes of the four sides, left and right from bottom to top, bottom and top from left to right."""
    given = {side: getattr(shape, side) for side in SIDES}
    ends = {side: (np.array(curve.points[0]), np.array(curve.points[-1])) for side, curve in given.items()}
    near = _MEET * min(_length(curve) for curve in given.values())

    def meet(a, b):
        return bool(np.hypot(*(a - b)) <= near)

    bottom, left, right, top = (ends[side] for side in ("bottom", "left", "right", "top"))
    turned: dict[str, bool] = {}
    corners = [(x, end) for x in (0, 1) for end in (0, 1) if meet(bottom[x], left[end])]
    if not corners:
        raise ShapeError("left", "does not meet the bottom edge", _ends_in_words(ends, "left", "bottom"))
    for at, from_left in corners:   # a lens has two such corners: the one that closes the outline is meant
        found = [end for end in (0, 1) if meet(bottom[1 - at], right[end])]
        for from_right in found:
            upper = (left[1 - from_left], right[1 - from_right])
            for along in (0, 1):
                if meet(top[along], upper[0]) and meet(top[1 - along], upper[1]):
                    turned = {"bottom": at == 1, "left": from_left == 1, "right": from_right == 1, "top": along == 1}
    if not turned:
        wrong = "right" if not any(meet(b, r) for b in bottom for r in right) else "top"
        other = "bottom" if wrong == "right" else "left and right edges"
        raise ShapeError(wrong, f"does not meet the {other}{' edge' if wrong == 'right' else ''}", _ends_in_words(ends, wrong, "bottom"))
    found = {}
    for side, curve in given.items():
        n, q = (zones[1], ratio[1]) if side in ("left", "right") else (zones[0], ratio[0])
        try:
            found[side] = nodes_on(reversed_curve(curve) if turned[side] else curve, n, q)
        except ValueError as error:
            raise ShapeError(side, str(error)) from None
    return _same_corners(found)


def _same_corners(edges: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    """The corners made equal bit for bit; those of bottom and top stand."""
    edges["left"][:, 0], edges["right"][:, 0] = edges["bottom"][:, 0], edges["bottom"][:, -1]
    edges["left"][:, -1], edges["right"][:, -1] = edges["top"][:, 0], edges["top"][:, -1]
    return edges


def _length(curve: Curve) -> float:
    return float(np.hypot(*np.diff(np.array(curve.points, dtype=float).T, axis=1)).sum())


def _ends_in_words(ends, *sides) -> str:
    words = [f"{side} runs from ({a[0]:g}, {a[1]:g}) m to ({b[0]:g}, {b[1]:g}) m" for side in sides for a, b in [ends[side]]]
    return "; ".join(words)


def transfinite(edges: dict[str, np.ndarray], s: np.ndarray, t: np.ndarray) -> np.ndarray:
    """Nodes (2, ni + 1, nj + 1) blended from the four edges; s (ni + 1,) and t (nj + 1,) run from 0 to 1."""
    left, right, bottom, top = (edges[side] for side in SIDES)
    s, t = s[None, :, None], t[None, None, :]
    across = (1.0 - s) * left[:, None, :] + s * right[:, None, :]
    upward = (1.0 - t) * bottom[:, :, None] + t * top[:, :, None]
    corners = (1.0 - s) * ((1.0 - t) * bottom[:, 0, None, None] + t * top[:, 0, None, None])
    corners = corners + s * ((1.0 - t) * bottom[:, -1, None, None] + t * top[:, -1, None, None])
    nodes = across + upward - corners
    nodes[:, 0, :], nodes[:, -1, :], nodes[:, :, 0], nodes[:, :, -1] = left, right, bottom, top
    return nodes


def winslow(nodes: np.ndarray, s: np.ndarray, t: np.ndarray) -> np.ndarray:
    """The inner nodes moved onto equipotentials of the block; the boundary stays. Raises `ShapeError` where no solution is found."""
    nodes = nodes.copy()
    if min(nodes.shape[1:]) < 3:
        return nodes
    steps = [np.hypot(*np.diff(nodes[:, :, k], axis=1)).min() for k in (0, -1)]
    steps += [np.hypot(*np.diff(nodes[:, k, :], axis=1)).min() for k in (0, -1)]
    smallest, shift = min(steps), np.inf
    for _ in range(_MOST):
        moved = _solved(nodes, s, t)
        shift = np.abs(moved - nodes).max()
        nodes = moved
        if shift <= _CONVERGED * smallest:
            return nodes
    raise ShapeError("fill", f"equipotential zoning still moves nodes by {shift:.2g} m after {_MOST} iterations",
                     "divide the block, or use fill = \"transfinite\"")


def _solved(nodes: np.ndarray, s: np.ndarray, t: np.ndarray) -> np.ndarray:
    """One Picard iteration: Winslow's equations with the coefficients of the present nodes."""
    from scipy.sparse import csc_matrix
    from scipy.sparse.linalg import splu

    inner = nodes[:, 1:-1, 1:-1]
    shape = inner.shape[1:]
    weights = _weights(nodes, s, t)
    number = np.full(nodes.shape[1:], -1)
    number[1:-1, 1:-1] = np.arange(inner[0].size).reshape(shape)
    rows, columns, values = [number[1:-1, 1:-1].ravel()], [number[1:-1, 1:-1].ravel()], [-sum(weights.values()).ravel()]
    known = np.zeros((2, inner[0].size))
    for (di, dj), weight in weights.items():
        view = (slice(1 + di, nodes.shape[1] - 1 + di), slice(1 + dj, nodes.shape[2] - 1 + dj))
        there, flat = number[view].ravel(), weight.ravel()
        free = there >= 0
        rows.append(number[1:-1, 1:-1].ravel()[free])
        columns.append(there[free])
        values.append(flat[free])
        known -= np.where(free, 0.0, flat) * nodes[(slice(None), *view)].reshape(2, -1)
    matrix = csc_matrix((np.concatenate(values), (np.concatenate(rows), np.concatenate(columns))))
    moved = nodes.copy()
    moved[:, 1:-1, 1:-1] = splu(matrix).solve(known.T).T.reshape(2, *shape)
    return moved


def _weights(nodes: np.ndarray, s: np.ndarray, t: np.ndarray) -> dict[tuple[int, int], np.ndarray]:
    """Weight of each neighbour (di, dj) of every inner node; the node's own is minus their sum."""
    ahead, back = np.diff(s)[1:, None], np.diff(s)[:-1, None]
    up, down = np.diff(t)[None, 1:], np.diff(t)[None, :-1]
    along = (nodes[:, 2:, 1:-1] - nodes[:, :-2, 1:-1]) / (ahead + back)
    upward = (nodes[:, 1:-1, 2:] - nodes[:, 1:-1, :-2]) / (up + down)
    alpha, gamma, beta = (upward**2).sum(axis=0), (along**2).sum(axis=0), (along * upward).sum(axis=0)
    weights = {(1, 0): 2.0 * alpha / (ahead * (ahead + back)), (-1, 0): 2.0 * alpha / (back * (ahead + back)),
               (0, 1): 2.0 * gamma / (up * (up + down)), (0, -1): 2.0 * gamma / (down * (up + down))}
    falling, rising = np.maximum(beta, 0.0), np.maximum(-beta, 0.0)
    for (di, dj), strength in (((1, 1), rising), ((-1, -1), rising), ((1, -1), falling), ((-1, 1), falling)):
        # -2 beta x_st as the mean of two quadrants, (x_diagonal - x_side - x_side + x_0) / (h k) each
        part = strength / ((ahead if di > 0 else back) * (up if dj > 0 else down))
        weights[di, dj] = part
        weights[di, 0] = weights[di, 0] - part
        weights[0, dj] = weights[0, dj] - part
    return weights
