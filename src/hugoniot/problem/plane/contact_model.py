"""What is asked of surfaces that meet: laws of contact and rigid bodies. SI everywhere."""

from collections.abc import Sequence
from dataclasses import dataclass

from hugoniot.mesh.shapes import Point
from hugoniot.problem.model import Pulse


@dataclass(frozen=True)
class Contact2D:
    """What two surfaces do that meet.

    between    two blocks or rigid bodies, or one name twice; None: all that nothing else names. Blocks named here are not joined
    kind       "sliding" (they separate in tension), "bonded" (for good, once they touch), "separable" (bonded up to `strength`)
    friction   Coulomb coefficient
    strength   of "separable": tension at which a bond breaks, Pa; friction holds after it
    """

    between: tuple[str, str] | None = None
    kind: str = "sliding"
    friction: float = 0.0
    strength: float | None = None


@dataclass(frozen=True)
class Rigid2D:
    """A rigid body.

    points      its surface, m; material may be on one side of it: outside a closed polygon, or where blocks are at t = 0
    closed      whether the last point is joined to the first
    pulse       its velocity along `direction` over time, m/s; None: at rest, or free with `mass`
    mass        kg per metre of depth (plane), kg of the whole ring (axisymmetric)
    start       velocity at t = 0 of a body with mass, m/s
    direction   unit vector; of a body with mass: what guides it (None: nothing)
    turns       whether a body with mass turns, in the plane
    inertia     of what turns: moment of inertia about the centre of mass, kg m2 per metre of depth; None: of an even closed polygon
    centre      of what turns: centre of mass, m; None: of an even closed polygon
    spin        of what turns: its rate at t = 0, rad/s, counter-clockwise
    """

    name: str
    points: tuple[Point, ...]
    closed: bool = False
    pulse: Pulse | None = None
    mass: float | None = None
    start: Point = (0.0, 0.0)
    direction: Point | None = None
    turns: bool = False
    inertia: float | None = None
    centre: Point | None = None
    spin: float = 0.0


def polygon_moments(points: Sequence[Point]) -> tuple[float, float, float, float]:
    """Area, centre (x, y) and polar moment of area about it of a polygon, counted positive whichever way it runs round."""
    x0, y0 = points[0]
    area = x = y = polar = 0.0
    for (ax, ay), (bx, by) in zip(points, (*points[1:], points[0])):
        ax, ay, bx, by = ax - x0, ay - y0, bx - x0, by - y0
        cross = ax * by - bx * ay
        area, x, y = area + cross / 2.0, x + (ax + bx) * cross / 6.0, y + (ay + by) * cross / 6.0
        polar += (ax * ax + ax * bx + bx * bx + ay * ay + ay * by + by * by) * cross / 12.0
    if area == 0.0:
        return 0.0, x0, y0, 0.0
    return abs(area), x0 + x / area, y0 + y / area, abs(polar) - (x * x + y * y) / abs(area)


def centre_of(body: Rigid2D) -> Point:
    """Centre of mass of a rigid body, m: given, or that of an even closed polygon; of any other body its first point."""
    if body.centre is not None or not body.closed:
        return body.centre or body.points[0]
    return polygon_moments(body.points)[1:3]


def inertia_of(body: Rigid2D) -> float:
    """Moment of inertia of a body that turns, about its centre of mass, kg m2 per metre of depth: given, or that of an even polygon."""
    if body.inertia is not None:
        return body.inertia
    assert body.mass is not None     # of a body that turns
    area, x, y, polar = polygon_moments(body.points)
    away = 0.0 if body.centre is None else (body.centre[0] - x) ** 2 + (body.centre[1] - y) ** 2
    return body.mass * (polar / area + away)


def apart(contacts: Sequence[Contact2D], names: Sequence[str]) -> frozenset[tuple[int, int]]:
    """Pairs (lower, higher) of blocks that are not joined because a contact names both."""
    found = set()
    for contact in contacts:
        if contact.between and all(name in names for name in contact.between):
            a, b = sorted(names.index(name) for name in contact.between)
            found |= {(a, b)} if a != b else set()
    return frozenset(found)
