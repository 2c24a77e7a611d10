r"""A fan that another wave reaches is cut into slices of constant state, each with exactly the content it had.

The slices lie between characteristics; their averages follow from the fan's own identity (line.py), so that nothing is lost. Neighbouring
slices differ by a feeble release: their Riemann problem, solved with jumps, loses nothing either.
"""

import math

import numpy as np

from hugoniot.laws.riemann.branch import State, elastic, plastic, stress
from hugoniot.solvers.fronts.line import Front, Piece, content
from hugoniot.solvers.fronts.meeting import Bench, outgoing

FEWEST, MOST = 2, 64


def slices(piece: Piece, left: float, right: float, time: float, bench: Bench) -> tuple[list[float], list[Piece]]:
    """(n + 1 positions, n constant pieces) that replace a fan between its edges at a time."""
    wave = piece.wave
    edges = _edges_of_compaction(piece, left, right, time, bench) if wave.path.way > 0.0 else _edges(wave, left, right, bench)
    matter = bench.matters[piece.region]
    branch = wave.path.branch
    found = []
    for a, b in zip(edges, edges[1:]):
        mass, momentum, energy = content(piece, a, b, time) / (b - a)
        u = momentum / mass
        e = energy / mass - 0.5 * u * u
        s = wave.ahead.s - (branch.b * math.log(mass / wave.ahead.rho) if branch.b else 0.0)
        state = State(float(mass), float(u), float(e), float(stress(mass, e, branch)), float(s), wave.ahead.compaction)
        found.append(Piece("state", piece.region, wave.path.kept(state)))
    _keep_on_branch(matter, found, branch)
    if wave.behind.rho == 0.0:
        found[0 if wave.direction > 0 else -1].broken = True
    return edges, found


def _edges(wave, left: float, right: float, bench: Bench) -> list[float]:
    """Evenly spaced: in a release the sound speed changes about as much as the velocity."""
    fall = abs(wave.behind.u - wave.ahead.u)
    count = min(max(math.ceil(fall / (bench.fan_step * wave.path.speed(wave.path.nodes[0]))), FEWEST), MOST)
    return np.linspace(left, right, count + 1).tolist()


def _edges_of_compaction(piece: Piece, left: float, right: float, time: float, bench: Bench) -> list[float]:
    """Of a compaction fan, along which the sound speed may fall several times while the velocity changes by a tenth of it.

    There are as many slices as ln c and u/c together take steps of `fan_step`; both ln c and the stress change little from edge to edge.
    """
    wave, age = piece.wave, time - piece.t0
    d, path = wave.direction, wave.path
    speeds = [path.speed(node) for node in path.nodes]
    places = [piece.x0 + age * (wave.ahead.u + d * (node[2] + c)) for node, c in zip(path.nodes, speeds)]
    softer = np.log(speeds[0] / np.array(speeds))
    rise = np.array([path.state(node, d).sigma for node in path.nodes])
    count = (softer[-1] + abs(wave.behind.u - wave.ahead.u) / speeds[-1]) / bench.fan_step
    count = min(max(math.ceil(count), FEWEST), MOST)
    passed = softer / softer[-1] + (rise - rise[0]) / (rise[-1] - rise[0])
    inner = np.interp(np.linspace(0.0, 2.0, count + 1)[1:-1], passed, places).tolist()
    return [left, *(inner if d < 0 else inner[::-1]), right]


def _keep_on_branch(matter, pieces, branch) -> None:
    """Slices of a plastic fan keep the yield stress that goes with it, to the last bit."""
    if matter.yield_stress and not branch.b:
        own = plastic(matter, 1 if pieces[0].state.s < 0.0 else -1)
        for piece in pieces:
            piece.state = piece.state._replace(s=math.copysign(2.0 / 3.0 * matter.yield_stress, piece.state.s),
                                               sigma=stress(piece.state.rho, piece.state.e, own))
    elif matter.yield_stress:
        for piece in pieces:
            piece.state = piece.state._replace(sigma=stress(piece.state.rho, piece.state.e, elastic(matter, piece.state)))


def cut(pieces: list[Piece], fronts: list[Front], k: int, time: float, bench: Bench) -> int:
    """Replace the fan pieces[k] by slices and the waves between them, in place; the number of slices."""
    fan, (left, right) = pieces[k], (fronts[k - 1].at(time), fronts[k].at(time))
    edges, found = slices(fan, left, right, time, bench)
    kept = [piece.broken for piece in found]
    for piece in found:
        piece.broken = True        # what parts two slices is feeble by construction, whatever the local speed of sound
    outer = [pieces[k - 1], *found, pieces[k + 1]]
    new_fronts: list[Front] = []
    new_pieces: list[Piece] = []
    for j, x in enumerate(edges):
        if j:
            new_pieces.append(outer[j])
        some, between, _ = outgoing(outer[j], outer[j + 1], x, time, bench, True)
        if not some:               # two equal slices: the line between them stays
            some, between = [Front("contact", x, time, outer[j].edge(1).u, sliced=True)], []
        new_fronts += some
        new_pieces += between
    for piece, flag in zip(found, kept):
        piece.broken = flag
    fronts[k - 1:k + 1] = new_fronts
    pieces[k:k + 1] = new_pieces
    return len(found)
