"""Points along the edges of blocks: lines, arcs through three points, polylines, divided by arc length or given node by node."""

import math

import numpy as np

from hugoniot.mesh.line import graded_nodes
from hugoniot.mesh.shapes import Curve

_STRAIGHT = 1e-12   # height of an arc's middle point over its chord below which no circle can be found


def nodes_on(curve: Curve, zones: int, ratio: float) -> np.ndarray:
    """Node positions (2, zones + 1) along a curve in its own direction, the ends exact. Raises ValueError with words for a user."""
    points = np.array(curve.points, dtype=float).T
    if curve.spacing == "points":
        if points.shape[1] != zones + 1:
            raise ValueError(f"its points are the nodes, one more than the zones: needed {zones + 1}, got {points.shape[1]}")
        return points
    share = graded_nodes(0.0, 1.0, zones, ratio)
    if curve.kind == "arc":
        return _arc(points, share)
    if curve.kind == "line" and points.shape[1] != 2:
        raise ValueError(f"a line needs two points, got {points.shape[1]}")
    return _polyline(points, share)


def reversed_curve(curve: Curve) -> Curve:
    """The same curve from its other end."""
    return Curve(curve.kind, tuple(reversed(curve.points)), curve.spacing)


def _polyline(points: np.ndarray, share: np.ndarray) -> np.ndarray:
    steps = np.hypot(*np.diff(points, axis=1))
    if not (steps > 0.0).all():
        raise ValueError(f"points {int(np.argmin(steps)) + 1} and {int(np.argmin(steps)) + 2} coincide")
    length = np.concatenate(([0.0], np.cumsum(steps)))
    found = np.array([np.interp(share * length[-1], length, row) for row in points])
    found[:, 0], found[:, -1] = points[:, 0], points[:, -1]
    return found


def circle_through(points: np.ndarray) -> tuple[np.ndarray, float, float, float]:
    """(centre (2,), radius, start angle, signed swept angle) of the arc through three points (2, 3). ValueError if they lie on a line."""
    if points.shape[1] != 3:
        raise ValueError(f"an arc needs three points (start, one between, end), got {points.shape[1]}")
    a, b, c = points.T
    u, v = b - a, c - a
    cross = u[0] * v[1] - u[1] * v[0]
    if abs(cross) <= _STRAIGHT * max(u @ u, v @ v):
        raise ValueError("the three points of the arc lie on a straight line; use a line")
    towards = np.array([v[1] * (u @ u) - u[1] * (v @ v), u[0] * (v @ v) - v[0] * (u @ u)]) / (2.0 * cross)
    centre = a + towards
    first, middle, last = (math.atan2(p[1] - centre[1], p[0] - centre[0]) for p in (a, b, c))
    swept = (last - first) % (2.0 * math.pi)
    if (middle - first) % (2.0 * math.pi) > swept:
        swept -= 2.0 * math.pi
    return centre, float(np.hypot(*towards)), first, swept


def _arc(points: np.ndarray, share: np.ndarray) -> np.ndarray:
    centre, radius, first, swept = circle_through(points)
    angle = first + swept * share
    found = centre[:, None] + radius * np.array([np.cos(angle), np.sin(angle)])
    found[:, 0], found[:, -1] = points[:, 0], points[:, 2]
    return found


def cosine_and_sine(angle: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """cos and sin of angles in rad, exact at whole multiples of a right angle, so that nodes of a sector lie on the axis itself."""
    quarters = np.asarray(angle, dtype=float) / (0.5 * math.pi)
    whole = np.round(quarters)
    exact = np.abs(quarters - whole) < 1e-12
    turn = (whole % 4).astype(int)
    cosine = np.where(exact, np.array([1.0, 0.0, -1.0, 0.0])[turn], np.cos(angle))
    sine = np.where(exact, np.array([0.0, 1.0, 0.0, -1.0])[turn], np.sin(angle))
    return cosine, sine
