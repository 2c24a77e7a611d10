"""Shapes of logically rectangular blocks: box, sector of a ring or sphere, four curved edges. Coordinates in m, angles in radians.

A block's index i runs along its first direction, j along its second, and (i, j) is right-handed with the coordinates: x to the right
and y upwards in the plane, r to the right and z upwards in axisymmetric geometry (axis at r = 0). Box: i along x (or r), j along y
(or z). Sector: i along the radius, j along the angle, counted counter-clockwise from the first coordinate's direction, so that in
axisymmetric geometry 0 is the equator and 90 degrees the axis. Sides: left i = 0, right i = ni, bottom j = 0, top j = nj.
"""

from dataclasses import dataclass

SIDES = ("left", "right", "bottom", "top")
Point = tuple[float, float]


@dataclass(frozen=True)
class Curve:
    """One edge of a block, in either direction.

    kind      "line" (two points), "arc" (start, a point on it, end: a circle through three points) or "polyline" (two points or more)
    points    ((x, y), ...) in m
    spacing   "length": nodes divide the arc length by the block's ratio; "points": the nodes are the points of a polyline themselves
    """

    kind: str
    points: tuple[Point, ...]
    spacing: str = "length"


@dataclass(frozen=True)
class Box:
    """x from x[0] to x[1] and y from y[0] to y[1], m (r and z in axisymmetric geometry)."""

    x: tuple[float, float]
    y: tuple[float, float]


@dataclass(frozen=True)
class Sector:
    """A ring's sector about `centre`: radii (inner > 0, outer) in m, angles (start, end) in rad, counter-clockwise."""

    centre: Point
    radius: tuple[float, float]
    angle: tuple[float, float]


@dataclass(frozen=True)
class Edges:
    """Four curves whose ends meet at the corners; `fill`: "transfinite" interpolation, or "winslow" equipotential zoning."""

    left: Curve
    right: Curve
    bottom: Curve
    top: Curve
    fill: str = "transfinite"


Shape = Box | Sector | Edges
