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
    """A rigid body that does not turn.

    points      its surface, m; material may be on one side of it: outside a closed polygon, or where blocks are at t = 0
    closed      whether the last point is joined to the first
    pulse       its velocity along `direction` over time, m/s; None: at rest, or free with `mass`
    mass        kg per metre of depth (plane), kg of the whole ring (axisymmetric)
    start       velocity at t = 0 of a body with mass, m/s
    direction   unit vector; of a body with mass: what guides it (None: nothing)
    """

    name: str
    points: tuple[Point, ...]
    closed: bool = False
    pulse: Pulse | None = None
    mass: float | None = None
    start: Point = (0.0, 0.0)
    direction: Point | None = None


def apart(contacts: Sequence[Contact2D], names: Sequence[str]) -> frozenset[tuple[int, int]]:
    """Pairs (lower, higher) of blocks that are not joined because a contact names both."""
    found = set()
    for contact in contacts:
        if contact.between and all(name in names for name in contact.between):
            a, b = sorted(names.index(name) for name in contact.between)
            found |= {(a, b)} if a != b else set()
    return frozenset(found)
