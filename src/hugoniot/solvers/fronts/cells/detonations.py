"""Programmed detonations: unburned explosive, its lighting, and the fronts that turn it into products.

A region that burns has two numbers in the mesh: its own for the products, and its own plus the number of regions for what is unburned. The
unburned explosive has no pressure and stays as it is until a front comes; the front runs at the Chapman-Jouguet speed of the products, or
faster where what follows drives it.
"""

from dataclasses import replace

import numpy as np

from hugoniot.errors import OutOfRange
from hugoniot.laws.riemann import detonation
from hugoniot.laws.riemann import solver as exact
from hugoniot.laws.riemann.branch import State
from hugoniot.laws.riemann.curve import Curve
from hugoniot.solvers.fronts.line import OUTSIDE, Front, Piece
from hugoniot.solvers.fronts.meeting import Bench, _units

UNLIT = ("a wave runs into unburned explosive, which this solver cannot follow: light it earlier, or use lagrange1d "
         "with an unreacted equation of state")
REST = 1e-3       # velocity, over the sound speed of the neighbour, that counts as none where explosive and neighbour touch


def slowest(bench: Bench, region: int, state: State, direction: int) -> detonation.Front:
    """The Chapman-Jouguet front into an unburned state, found once for a state that stays as it is to ten digits."""
    key = (region, direction, *(float(f"{value:.9e}") for value in state[:3]))
    if key not in bench.ideal:
        bench.ideal[key] = detonation.chapman_jouguet(state._replace(sigma=0.0), bench.matters[region].par, direction)
    return bench.ideal[key]._replace(ahead=state)


def driven(bench: Bench, direction: int, region: int, followers: list[State], ahead: tuple[int, State]) -> detonation.Front:
    """The front in the step: `ahead` is (region, state) ahead of it, `followers` those at the front and in the middle of the cell behind.

    A front is driven only if both drive it: at the head of a Taylor wave what is extrapolated may press a little too hard.
    """
    base = found = slowest(bench, *ahead, direction)
    for state in followers[::-1]:
        par = bench.matters[region].par
        found = detonation.driven(base, Curve(bench.matters[region], state, -direction), par)
        if found is base:
            break
    return found


def beside(curve: Curve, unburned: State) -> float:
    """Velocity of the face between unburned explosive and a neighbour at rest with it; `OutOfRange` where the neighbour moves into it."""
    after, _, _ = curve.at(0.0)
    if abs(after.u - unburned.u) > REST * curve.c:
        raise OutOfRange(UNLIT)
    return unburned.u


def lit(left: Piece, right: Piece, x: float, t: float, bench: Bench):
    """(fronts, pieces, solution) that leave a face at which unburned explosive, on one side or both, is lit."""
    fronts: dict[int, detonation.Front] = {}
    sides = []
    for piece, d in ((left, -1), (right, 1)):
        if piece.kind == "state" and piece.region >= bench.unburned:
            fronts[d] = slowest(bench, piece.region, piece.state, d)
            piece = Piece("state", piece.region - bench.unburned, fronts[d].behind)
        sides.append(piece)
    found = _solved(*sides, bench)
    for d, waves in ((-1, found.left), (1, found.right)):
        if d in fronts and waves and waves[0].kind != "fan":
            found, fronts[d] = _overdriven(sides, d, found, fronts[d], bench)
    units, middles = _units(*sides, found, x, t, bench)
    made, between = [], []
    for k, unit in enumerate(units):
        if k:
            between.append(middles[k - 1])
        made += unit.fronts
        between += unit.inside
    for d, front in fronts.items():
        _lead(made, between, d, front, sides, x, t)
    return made, between, found


def _solved(left: Piece, right: Piece, bench: Bench) -> exact.Solution:
    if left.kind in OUTSIDE or right.kind in OUTSIDE:
        inner, outer, d = (right, left, 1) if left.kind in OUTSIDE else (left, right, -1)
        side = Curve(bench.of(inner), inner.state, d)
        if outer.kind == "wall":
            return exact.wall(side, bench.walls[-d], bonded=not side.gas)
        return exact.surface(side, bench.pressures[-d] if outer.kind == "pressure" else 0.0)
    return exact.contact(Curve(bench.of(left), left.state, -1), Curve(bench.of(right), right.state, 1))


def _overdriven(sides, d: int, found: exact.Solution, front: detonation.Front, bench: Bench):
    """(solution without that shock, strong front): what follows drives the detonation from the start."""
    follower = sides[0 if d > 0 else 1]
    if follower.kind in OUTSIDE:
        raise OutOfRange("a piston overdrives the detonation from the start; start the piston more slowly, or use lagrange1d")
    curve = Curve(bench.of(follower), follower.state, -d)
    own = sides[1 if d > 0 else 0]
    strong = detonation.driven(front, curve, bench.matters[own.region].par)
    after, _, waves = curve.at(strong.behind.sigma)
    left, right = (waves, []) if d > 0 else ([], waves)
    sides[1 if d > 0 else 0] = replace(own, state=strong.behind)
    return exact.Solution(left, right, (after.u, after.u), strong.behind.sigma), strong


def _lead(made: list[Front], between: list[Piece], d: int, front: detonation.Front, sides, x: float, t: float) -> None:
    """Put the detonation at the head of its side: in the place of the fan's head, or ahead of everything."""
    at = 0 if d < 0 else len(made) - 1
    lead = Front("detonation", x, t, front.speed, d, 1.0)
    if made[at].kind.startswith("fan head") and made[at].direction == d:
        made[at] = lead
    elif d < 0:
        made.insert(0, lead)
        between.insert(0, sides[0])
    else:
        made.append(lead)
        between.append(sides[1])


def passed(front: detonation.Front) -> tuple[float, float, float, float]:
    """What passes a detonation: (density, velocity, energy per mass, pressure) of the state ahead."""
    s = front.ahead
    return s.rho, s.u, s.e + 0.5 * s.u * s.u, 0.0


def light_face(mesh, x: float) -> int:
    """The face at which a lighting point is: a front there, an end or interface, or a new one inside a region."""
    near = int(np.argmin(np.abs(mesh.x - x)))
    if abs(mesh.x[near] - x) > 1e-9 * (mesh.x[-1] - mesh.x[0]):
        cell = int(np.searchsorted(mesh.x, x, side="right")) - 1
        share = (x - mesh.x[cell]) / (mesh.x[cell + 1] - mesh.x[cell]) if mesh.d == 1 else (
            (x**mesh.d - mesh.x[cell] ** mesh.d) / (mesh.x[cell + 1] ** mesh.d - mesh.x[cell] ** mesh.d))
        mesh.insert_face(cell, x, mesh.q[cell] * share, mesh.q[cell] * (1.0 - share))
        near = cell + 1
    return near
