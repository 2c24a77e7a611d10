"""Where a front goes in a step and what passes it: the exact Riemann problem of the states on both sides, half a step on."""

import math
from dataclasses import dataclass

from hugoniot.laws.riemann import solver as exact
from hugoniot.laws.riemann.branch import Branch, State, wave_speed_squared
from hugoniot.laws.riemann.curve import Curve
from hugoniot.solvers.fronts.cells import detonations
from hugoniot.solvers.fronts.cells.mesh import Front
from hugoniot.solvers.fronts.meeting import Bench


@dataclass(frozen=True)
class Moved:
    """What a front does: its speed, the state (density, velocity, energy per mass, pressure) that passes it, its strength.

    parts   the two sides separate, and a gap opens here
    """

    speed: float
    state: tuple[float, float, float, float]
    strength: float
    parts: bool = False


def warm(state: State, bench: Bench, region: int) -> State:
    """The state, lifted by rounding where rounding has made it colder than cold: c^2 < 0."""
    branch = Branch(bench.matters[region].par)
    for share in (0.0, 1e-16, 1e-15, 1e-14, 1e-13, 1e-12):
        e = state.e + share * (state.u * state.u + abs(state.e))
        if wave_speed_squared(state.rho, e, branch) >= 0.0:
            return state._replace(e=e)
    return state


def side(bench: Bench, region: int, state: State, direction: int) -> Curve:
    """The wave curve of one side of a front."""
    return Curve(bench.matters[region], warm(state, bench, region), direction)


def between(front: Front, left, right, bench: Bench) -> Moved:
    """A front between two materials; left, right: (region, state)."""
    a, b = side(bench, *left, -1), side(bench, *right, 1)
    if front.direction:
        return _shock(front.direction, exact.contact(a, b, bonded=True), a, b)
    grip = math.inf if left[0] == right[0] else bench.grips[left[0]]
    if a.gas or b.gas:
        grip = 0.0
    found = exact.contact(a, b, bonded=grip > 0.0)
    if grip > 0.0 and found.stress < -grip:
        found = exact.contact(a, b)
    return _moving(found.velocity[0], found.stress, _contrast(found, a, b), found.vacuum)


def _contrast(found: exact.Solution, a: Curve, b: Curve) -> float:
    low = found.left[-1].behind.rho if found.left else a.state.rho
    high = found.right[-1].behind.rho if found.right else b.state.rho
    return abs(low - high) / max(low, high, 1e-300)


def _moving(u: float, p: float, strength: float = 0.0, parts: bool = False) -> Moved:
    """A front that moves with the material: nothing but momentum and work passes."""
    return Moved(u, (0.0, u, 0.0, p), strength, parts)


def _shock(d: int, found: exact.Solution, a: Curve, b: Curve) -> Moved:
    waves, ahead = (found.left, a.state) if d < 0 else (found.right, b.state)
    if waves and waves[0].kind == "shock":
        wave = waves[0]
        s = wave.ahead
        return Moved(wave.head, (s.rho, s.u, s.e + 0.5 * s.u * s.u, s.sigma), wave.strength)
    # the wave has become a release: the face goes on with the sound behind it, and is released
    s = waves[0].behind if waves else ahead
    speed = waves[0].tail if waves else s.u + d * (a if d < 0 else b).c
    return Moved(speed, (s.rho, s.u, s.e + 0.5 * s.u * s.u, s.sigma), 0.0)


def explosive(front: Front, left, right, mean: State, bench: Bench) -> Moved:
    """A front beside unburned explosive: a detonation (`mean` is the middle of the cell behind it), or a face at rest with it."""
    sides = {-1: left, 1: right}
    d = front.direction
    if front.kind == "detonation":
        region, state = sides[-d]
        found = detonations.driven(bench, d, [(region, warm(s, bench, region)) for s in (state, mean)], sides[d])
        return Moved(found.speed, detonations.passed(found), 1.0)
    unburned = next(side for side in (left, right) if side is not None and side[0] >= bench.unburned)
    for way, other in sides.items():
        if other is not None and other[0] < bench.unburned:
            return _moving(detonations.beside(side(bench, *other, way), unburned[1]), 0.0)
    return _moving(unburned[1].u, 0.0)


def end(kind: str, front: Front, region: int, state: State, d: int, value: float, bench: Bench) -> Moved:
    """The end of a body (d: the direction of waves from there: +1 at a left end).

    kind   "vacuum", "wall" (value: its velocity, m/s), "pressure" (value: Pa), "open"
    """
    if kind == "open":
        return _moving(state.u, state.sigma)
    curve = side(bench, region, state, d)
    if kind == "wall":
        found = exact.wall(curve, value, bonded=not curve.gas)
        return _moving(value, found.stress, parts=found.vacuum)
    if kind == "vacuum" and curve.gas:      # the edge of an expansion to nothing runs free of all forces
        return _moving(front.speed, 0.0)
    found = exact.surface(curve, value if kind == "pressure" else 0.0)
    return _moving(found.velocity[0], found.stress)
