"""Where a front goes in a step and what passes it, in Python: for what the compiled march leaves to it (exact.py).

These are detonations, gaps that open, expansions to nothing, and searches that fail there. The exact Riemann problem of the states on
both sides, half a step on, answers.
"""

import math
from dataclasses import dataclass

from hugoniot.errors import HugoniotError
from hugoniot.laws.riemann import solver as exact
from hugoniot.laws.riemann.branch import Branch, Matter, State, elastic, has_memory, wave_speed_squared
from hugoniot.laws.riemann.curve import Curve
from hugoniot.solvers.fronts.cells import detonations, two_sides
from hugoniot.solvers.fronts.cells import exact as compiled
from hugoniot.solvers.fronts.cells.mesh import EMPTY, Front
from hugoniot.solvers.fronts.cells.pores import state_of
from hugoniot.solvers.fronts.cells.solids import with_deviator
from hugoniot.solvers.fronts.cells.tables import (
    F_E,
    F_P,
    F_RHO,
    F_U,
    INTO_LEFT,
    INTO_RIGHT,
    KIND,
    KINDS,
    LAM,
    LEFT,
    MEAN,
    MIDDLE,
    RIGHT,
    SPEED,
    SPEED_OF,
    STRENGTH,
    P,
)
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


@dataclass(frozen=True)
class Side:
    """What stands on one side of a front: region, state, matter."""

    region: int
    state: State
    matter: Matter

    def curve(self, direction: int) -> Curve:
        """Its wave curve."""
        return Curve(self.matter, warm(self.state, self.matter), direction)


def warm(state: State, matter: Matter) -> State:
    """The state, lifted by rounding where rounding has made it colder than cold: c^2 < 0."""
    branch = elastic(matter, state) if has_memory(matter.par) else Branch(matter.par)
    for share in (0.0, 1e-16, 1e-15, 1e-14, 1e-13, 1e-12):
        e = state.e + share * (state.u * state.u + abs(state.e))
        if wave_speed_squared(state.rho, e, branch) >= 0.0:
            return state._replace(e=e)
    return state


def at_fronts(flow, grid, mesh, rows, time: float) -> None:
    """Put the speeds and states of all fronts, and of newborn faces, into the table of the march; `rows` is the table of fronts."""
    w, n, flags = flow.work.w, len(grid.q), flow.work.flags
    flags[:, :len(rows)] = 0.0
    compiled.newborn(grid, flow.rules, flow.work, n)
    for k, (front, f) in enumerate(zip(mesh.fronts, mesh.faces().tolist())):
        if grid.given[f, 0] == grid.given[f, 0]:
            continue
        if "fan" in front.kind:
            compiled.edge(grid, flow.rules, flow.work, rows[k], f)
            rows[k, SPEED_OF] = w[SPEED, f]
            continue
        if front.direction and (flow.solid | flow.porous)[grid.region[f - 1] % len(flow.solid)]:
            _tried(_in_solid, flow, grid, f, (rows, k, f))
            continue
        moved = _tried(_moved, flow, grid, f, (front, f, n, time))
        if front.kind not in ("detonation",) and front.direction:
            _scalars(flow, grid, front.direction, f)
        rows[k, SPEED_OF], rows[k, STRENGTH], w[SPEED, f] = moved.speed, moved.strength, moved.speed
        w[F_RHO, f], w[F_U, f], w[F_E, f], w[F_P, f] = moved.state
        flags[1, k] = float(moved.parts)
        flags[0, k] = float(bool(front.direction) and moved.strength < 0.5 * flow.bench.weakest)
    for j, f in ((0, 0), (-1, n)):
        if flow.outside[j] == "wall" and mesh.fronts[j].kind == "end":      # a piston goes on as it is driven
            rows[j, SPEED_OF] = w[SPEED, f] = w[F_U, f] = flow.drive(j % 2, time)


def _tried(solve, flow, grid, f: int, given):
    """What a front does; by the averages of the cells beside it where the states at the face have left the range of a law."""
    try:
        return solve(flow, grid, *given)
    except (HugoniotError, ArithmeticError, ValueError):
        w, n = flow.work.w, len(grid.q)
        if grid.region[max(f - 1, 0):f + 1].max() >= flow.bench.unburned:
            raise
        for block, cell in ((RIGHT, f - 1), (LEFT, f)):
            if 0 <= cell < n:
                w[block:block + 10, cell] = w[MEAN:MEAN + 10, cell]
        return solve(flow, grid, *given)


def _in_solid(flow, grid, rows, k: int, f: int) -> None:
    """A shock in a solid or in pores, whose wave of the two the compiled march knows."""
    if not compiled.between(flow.rules, flow.work, rows, k, int(grid.region[f - 1]), int(grid.region[f])):
        raise ArithmeticError("the Riemann problem at a shock with a precursor has no solution: no stress gives both sides one velocity")
    rows[k, SPEED_OF] = flow.work.w[SPEED, f]
    flow.work.flags[0, k] = float(rows[k, STRENGTH] < 0.5 * flow.bench.least(KINDS[int(rows[k, KIND])]))


def _moved(flow, grid, front: Front, f: int, n: int, time: float) -> Moved:
    bench = flow.bench
    left = None if f == 0 or grid.region[f - 1] == EMPTY else _side(flow, grid, RIGHT, f - 1)
    right = None if f == n or grid.region[f] == EMPTY else _side(flow, grid, LEFT, f)
    if any(side is not None and side.region >= bench.unburned for side in (left, right)):
        behind = f - 1 if front.direction > 0 else min(f, n - 1)
        return explosive(front, left, right, _side(flow, grid, MIDDLE, behind).state, bench)
    if left is not None and right is not None:
        return between(front, left, right, bench)
    side = left or right
    at = 0 if f == 0 else 1
    kind = flow.outside[at] if f in (0, n) else "vacuum"
    value = flow.drive(at, time) if kind in ("wall", "pressure") else 0.0
    if side is None:          # a wall that the material has left
        return _moving(value, 0.0)
    return end(kind, front, side, 1 if left is None else -1, value)


def _side(flow, grid, block: int, cell: int) -> Side:
    w, region = flow.work.w, int(grid.region[cell])
    rho, u, e, burned, volume, energy, p = w[block:block + P + 1, cell].tolist()
    matter = flow.matter(region, burned, volume, energy)
    state = state_of(rho, u, e, (burned, volume, energy), matter) if flow.porous[region % len(flow.porous)] else with_deviator(
        rho, u, e, volume, matter, 0.0)
    return Side(region, state._replace(sigma=p), matter)


def _scalars(flow, grid, d: int, f: int) -> None:
    """What goes with the mass that passes a shock: as the compiled march has it, from the wave to the pressure behind."""
    w, side = flow.work.w, 0 if d < 0 else 1
    cell, block = (f - 1, RIGHT) if d < 0 else (f, LEFT)
    for into in (INTO_LEFT, INTO_RIGHT):
        w[into:into + 3, f] = w[block + LAM:block + LAM + 3, cell]
    region = int(grid.region[cell])
    if flow.burns and flow.rules.passes[region, 2]:
        two_sides.take_side(flow.rules, flow.work, side, region, block, cell)
        behind, inner = (f, LEFT) if d < 0 else (f - 1, RIGHT)
        p = max(float(w[inner + P, behind]), float(w[block + P, cell]))
        two_sides.wave_to(flow.rules, flow.work, side, region, p)
        into = INTO_RIGHT if d < 0 else INTO_LEFT
        w[into + 1:into + 3, f] = flow.work.io[side, two_sides.VOLUME_B:two_sides.ENERGY_B + 1]


def between(front: Front, left: Side, right: Side, bench: Bench) -> Moved:
    """A front between two materials."""
    a, b = left.curve(-1), right.curve(1)
    if front.direction:
        behind = left if front.direction > 0 else right
        return _shock(front.direction, exact.contact(a, b, bonded=True, start=behind.state.sigma), a, b)
    grip = math.inf if left.region == right.region else bench.grips[left.region]
    if not (a.bears_tension and b.bears_tension):
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
        behind, ahead = sides[-d], sides[d]
        states = [warm(s, behind.matter) for s in (behind.state, mean)]
        found = detonations.driven(bench, d, behind.region, states, (ahead.region, ahead.state))
        return Moved(found.speed, detonations.passed(found), 1.0)
    unburned = next(side for side in (left, right) if side is not None and side.region >= bench.unburned)
    for way, other in sides.items():
        if other is not None and other.region < bench.unburned:
            return _moving(detonations.beside(other.curve(way), unburned.state), 0.0)
    return _moving(unburned.state.u, 0.0)


def end(kind: str, front: Front, side: Side, d: int, value: float) -> Moved:
    """The end of a body (d: the direction of waves from there: +1 at a left end).

    kind   "vacuum", "wall" (value: its velocity, m/s), "pressure" (value: Pa), "open"
    """
    if kind == "open":
        return _moving(side.state.u, side.state.sigma)
    curve = side.curve(d)
    if kind == "wall":
        found = exact.wall(curve, value, bonded=curve.bears_tension)
        return _moving(value, found.stress, parts=found.vacuum)
    if kind == "vacuum" and curve.gas:      # the edge of an expansion to nothing runs free of all forces
        return _moving(front.speed, 0.0)
    found = exact.surface(curve, value if kind == "pressure" else 0.0)
    return _moving(found.velocity[0], found.stress)
