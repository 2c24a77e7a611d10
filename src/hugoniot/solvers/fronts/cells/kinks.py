"""Edges of fans where they meet something: kinks in states that are continuous.

They go on through contacts and through each other, and come back from ends; a kink that only the cells carry would spread over more of them
the longer it runs, with an error of first order. What lies between two fronts that part is the exact state between those on both sides.
"""

import math

import numpy as np

from hugoniot.errors import NoSolution, OutOfRange
from hugoniot.laws.riemann.branch import elastic, wave_speed_squared
from hugoniot.solvers.fronts import line
from hugoniot.solvers.fronts.cells.births import COARSE, part
from hugoniot.solvers.fronts.cells.mesh import Front, Mesh
from hugoniot.solvers.fronts.line import Piece
from hugoniot.solvers.fronts.meeting import Bench, solve


def transmit(mesh: Mesh, face: int, edge: Front, left: Piece, right: Piece, time: float, bench: Bench) -> bool:
    """Let the edge of a fan that has reached a contact go on behind it; False in solids, and where there is no material on both sides."""
    d = edge.direction
    return _fluid(left, bench) and _fluid(right, bench) and _with_what_moves(mesh, face, edge, d, (left, right), time, bench)


def reflect(mesh: Mesh, face: int, edge: Front, left: Piece, right: Piece, time: float, bench: Bench) -> bool:
    """Send back the edge of a fan that has reached an end that holds the material; False elsewhere, in solids, in coarse regions."""
    inner, outer = (left, right) if edge.direction > 0 else (right, left)
    held = outer.kind in ("wall", "pressure") and _fluid(inner, bench) and _fine(inner, bench)
    return held and _with_what_moves(mesh, face, edge, -edge.direction, (left, right), time, bench)


def cross(mesh: Mesh, face: int, edges, left: Piece, right: Piece, time: float, bench: Bench) -> bool:
    """Let two edges of fans that have met go on through each other; False where they run the same way, in solids and coarse regions."""
    if sorted(edge.direction for edge in edges) != [-1, 1] or left.region != right.region or not _fluid(left, bench):
        return False
    between = _between(left, right, -1, bench) if _fine(left, bench) else None
    if between is None:
        return False
    fronts = [_kink(edge, edge.direction, between, time, bench) for edge in sorted(edges, key=lambda edge: edge.direction)]
    part(mesh, face, [left, between, right], fronts, time, bench)
    return True


def _with_what_moves(mesh: Mesh, face: int, edge: Front, d: int, sides, time: float, bench: Bench) -> bool:
    """Put the front at a face and a kink that leaves it in direction d in its place."""
    between = _between(*sides, d, bench)
    if between is None:
        return False
    old = mesh.fronts[int(np.count_nonzero(mesh.marked[:face]))]
    fronts = [line.Front(old.kind, 0.0, time, between.state.u, 0, old.strength), _kink(edge, d, between, time, bench)][::d]
    part(mesh, face, [sides[0], between, sides[1]], fronts, time, bench)
    return True


def _fluid(piece: Piece, bench: Bench) -> bool:
    return piece.kind == "state" and not bench.of(piece).yield_stress


def _fine(piece: Piece, bench: Bench) -> bool:
    """Whether a region has cells enough for kinks: intervals of a few cells, each with stencils of its own, make the errors larger."""
    return bench.zones[piece.region] >= COARSE


def _between(left: Piece, right: Piece, side: int, bench: Bench) -> Piece | None:
    """What the exact waves leave between two states, of the material on one side; None where the sides part or nothing is found."""
    try:
        found = solve(left, right, bench, False)
    except (OutOfRange, NoSolution):
        return None
    if found.vacuum:
        return None
    waves, own = (found.left, left) if side < 0 else (found.right, right)
    return Piece("state", own.region, waves[-1].behind if waves else own.edge(-side), matter=own.matter)


def _kink(edge: Front, d: int, where: Piece, time: float, bench: Bench) -> line.Front:
    """The edge of a fan runs with the sound."""
    state = where.state
    c = math.sqrt(max(wave_speed_squared(state.rho, state.e, elastic(bench.of(where), state)), 0.0))
    return line.Front(edge.kind, 0.0, time, state.u + d * c, d, edge.strength)
