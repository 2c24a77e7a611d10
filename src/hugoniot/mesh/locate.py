"""Where a point lies in a mesh of quadrilaterals or triangles: its zone and its place in it."""

import numpy as np

_EDGE = 1e-9   # of a zone: how far outside still counts as on its edge


def logical_place(corners: np.ndarray, point: np.ndarray) -> tuple[float, float] | None:
    """(a, b) in [0, 1] with point = bilinear(corners (2, 4), a, b), counter-clockwise corners from a = b = 0; None if outside."""
    a = b = 0.5
    c00, c10, c11, c01 = corners.T
    for _ in range(50):
        here = (1 - a) * (1 - b) * c00 + a * (1 - b) * c10 + a * b * c11 + (1 - a) * b * c01
        along, up = (1 - b) * (c10 - c00) + b * (c11 - c01), (1 - a) * (c01 - c00) + a * (c11 - c10)
        area = along[0] * up[1] - along[1] * up[0]
        if area == 0.0:
            return None
        gap = point - here
        da, db = (gap[0] * up[1] - gap[1] * up[0]) / area, (along[0] * gap[1] - along[1] * gap[0]) / area
        a, b = a + da, b + db
        if abs(da) + abs(db) < 1e-14:
            break
        if max(abs(a), abs(b)) > 1e3:
            return None
    if not (-_EDGE <= a <= 1 + _EDGE and -_EDGE <= b <= 1 + _EDGE):
        return None
    return min(max(a, 0.0), 1.0), min(max(b, 0.0), 1.0)


def place_in_triangle(corners: np.ndarray, point: np.ndarray) -> tuple[float, float] | None:
    """(a, b) with point = corners (2, 3) weighted by 1 - a - b, a and b, none negative; None if outside."""
    first, along, up = corners[:, 0], corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    area, gap = along[0] * up[1] - along[1] * up[0], point - first
    if area == 0.0:
        return None
    a, b = (gap[0] * up[1] - gap[1] * up[0]) / area, (along[0] * gap[1] - along[1] * gap[0]) / area
    return (a, b) if min(a, b, 1.0 - a - b) >= -_EDGE else None


def find_zone(nodes: np.ndarray, zone_nodes: np.ndarray, point) -> tuple[int, float, float] | None:
    """(zone, a, b) of the first zone that holds a point; None if none does.

    nodes (2, nnode), zone_nodes (nzone, 4) or (nzone, 3); in a quadrilateral a runs along i, b along j, from 0 to 1, in a triangle
    they are the weights of the second and the third corner
    """
    place_in = logical_place if zone_nodes.shape[1] == 4 else place_in_triangle
    point = np.asarray(point, dtype=float)
    corners = nodes[:, zone_nodes]
    low, high = corners.min(axis=2), corners.max(axis=2)
    margin = _EDGE * (high - low).max(axis=0)
    near = ((point[:, None] >= low - margin) & (point[:, None] <= high + margin)).all(axis=0)
    for zone in np.flatnonzero(near):
        place = place_in(corners[:, zone], point)
        if place is not None:
            return int(zone), *place
    return None


def bilinear_weights(a: float, b: float) -> np.ndarray:
    """Weights (4,) of the corners, counter-clockwise from a = b = 0."""
    return np.array([(1 - a) * (1 - b), a * (1 - b), a * b, (1 - a) * b])


def linear_weights(a: float, b: float) -> np.ndarray:
    """Weights (3,) of the corners of a triangle."""
    return np.array([1.0 - a - b, a, b])


def crossings(points: np.ndarray, edges: np.ndarray, through, direction) -> np.ndarray:
    """Positions along the line `through` + s `direction` (unit vector), m, where it crosses the edges (n, 2) of points (2, nnode)."""
    direction = np.asarray(direction, dtype=float)
    offset = points[:, edges] - np.asarray(through, dtype=float)[:, None, None]
    aside = direction[0] * offset[1] - direction[1] * offset[0]
    along = direction[0] * offset[0] + direction[1] * offset[1]
    first, last = aside.T
    crossed = (first == 0.0) | (last == 0.0) | ((first > 0.0) != (last > 0.0))
    crossed &= ~((first == 0.0) & (last == 0.0))
    share = first[crossed] / (first[crossed] - last[crossed])
    return (1.0 - share) * along[crossed, 0] + share * along[crossed, 1]
