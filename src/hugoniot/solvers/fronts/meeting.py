"""What leaves a place where fronts meet: the Riemann problem of the outermost states, and its waves as new fronts and pieces."""

from dataclasses import dataclass, field

from hugoniot.laws.eos.contract import pressure
from hugoniot.laws.riemann import solver as exact
from hugoniot.laws.riemann.branch import Matter, State
from hugoniot.laws.riemann.curve import Curve, Wave
from hugoniot.solvers.fronts.line import OUTSIDE, Front, Piece, densities, fan_growth, fluxes


MERGED = 2.5     # slices of a fan may reflect or join before they count as a new fan


@dataclass
class Bench:
    """What the meetings of a run need.

    matters      material of each region
    grips        stress (Pa) that holds each region to the next one: inf bonded, 0 separable, a bond's strength
    weakest      strength below which a wave between two tracked ones is left out
    fan_step     change of velocity over the sound speed below which a release is one jump
    walls        velocity of the left and right wall; pressures  at the left and right end
    """

    matters: list[Matter]
    grips: list[float]
    weakest: float
    fan_step: float
    walls: dict[int, float] = field(default_factory=dict)
    pressures: dict[int, float] = field(default_factory=dict)
    dropped: int = 0


def solve(left: Piece, right: Piece, bench: Bench) -> exact.Solution:
    """The Riemann problem of two neighbouring pieces (states or outsides)."""
    first = _solved(left, right, bench, (left.broken, right.broken))
    jumps = tuple(piece.broken or _feeble(waves, bench) for piece, waves in ((left, first.left), (right, first.right)))
    return first if jumps == (left.broken, right.broken) else _solved(left, right, bench, jumps)


def _feeble(waves: list[Wave], bench: Bench) -> bool:
    """Whether all fans among the waves are so weak that jumps do for them."""
    fans = [w for w in waves if w.kind == "fan"]
    return bool(fans) and all(abs(w.behind.u - w.ahead.u) < MERGED * bench.fan_step * w.path.speed(w.path.nodes[0]) for w in fans)


def _solved(left: Piece, right: Piece, bench: Bench, jumps) -> exact.Solution:
    if left.kind in OUTSIDE or right.kind in OUTSIDE:
        inner, outer, d = (right, left, 1) if left.kind in OUTSIDE else (left, right, -1)
        side = Curve(bench.matters[inner.region], inner.edge(-d), d, jumps[(d + 1) // 2])
        if outer.kind == "vacuum":
            return exact.surface(side, 0.0)
        if outer.kind == "pressure":
            return exact.surface(side, bench.pressures[-d])
        if outer.kind == "wall":
            return exact.wall(side, bench.walls[-d], bonded=not side.gas)
        state = inner.edge(-d)
        return exact.Solution([], [], (state.u, state.u), state.sigma)
    a = Curve(bench.matters[left.region], left.edge(1), -1, jumps[0])
    b = Curve(bench.matters[right.region], right.edge(-1), 1, jumps[1])
    grip = float("inf") if left.region == right.region else bench.grips[left.region]
    if a.gas or b.gas:
        grip = 0.0
    found = exact.contact(a, b, bonded=grip > 0.0)
    return exact.contact(a, b) if grip > 0.0 and found.stress < -grip else found


@dataclass
class Unit:
    """One thing that leaves a meeting: its fronts (two of a fan or of a gap), the pieces between them, and how strong it is."""

    fronts: list[Front]
    inside: list[Piece]
    strength: float


def outgoing(left: Piece, right: Piece, x: float, t: float, bench: Bench) -> tuple[list[Front], list[Piece], exact.Solution]:
    """(fronts, pieces between them, solution) that replace what met at (x, t); the pieces left and right stay as they are."""
    found = solve(left, right, bench)
    units, middles = _units(left, right, found, x, t, bench)
    if left.kind == right.kind == "state" and left.region == right.region and not found.vacuum:
        units, middles = _without_the_weak(units, middles, left, right, bench)
    fronts, pieces = [], []
    for k, unit in enumerate(units):
        if k:
            pieces.append(middles[k - 1])
        fronts += unit.fronts
        pieces += unit.inside
    return fronts, pieces, found


def _units(left: Piece, right: Piece, found: exact.Solution, x, t, bench: Bench) -> tuple[list[Unit], list[Piece]]:
    """Everything that leaves, from left to right, and the pieces between."""
    units = [_unit(wave, left.region, x, t) for wave in found.left]
    middles = [Piece("state", left.region, wave.behind) for wave in found.left]
    contact = _contact(left, right, found, x, t, bench)
    units.append(Unit(contact, [Piece("vacuum")] * (len(contact) - 1), _contrast(left, right, found)))
    after = [Piece("state", right.region, wave.behind) for wave in found.right]
    units += [_unit(wave, right.region, x, t) for wave in reversed(found.right)]
    middles += reversed(after)
    # an expansion to nothing has no second edge: its fan reaches to the surface itself
    for k, unit in enumerate(units):
        if unit.inside and unit.inside[0].kind == "fan" and unit.inside[0].wave.behind.rho == 0.0:
            side = unit.inside[0].wave.direction
            unit.fronts = unit.fronts[:1] if side < 0 else unit.fronts[1:]
            middles[k if side < 0 else k - 1] = unit.inside.pop()
    return units, middles


def _unit(wave: Wave, region: int, x: float, t: float) -> Unit:
    head, tail = _names(wave)
    if wave.kind != "fan":
        return Unit([Front(head, x, t, wave.head, wave.direction, wave.strength)], [], wave.strength)
    edges = [Front(head, x, t, wave.head, wave.direction, wave.strength), Front(tail, x, t, wave.tail, wave.direction, wave.strength)]
    return Unit(edges if wave.direction < 0 else edges[::-1], [Piece("fan", region, wave.ahead, wave, x, t)], wave.strength)


def _names(wave: Wave) -> tuple[str, str]:
    if wave.kind == "fan":
        word = "elastic fan" if wave.elastic else "fan"
        return f"{word} head", f"{word} tail"
    kind = "shock" if wave.behind.sigma > wave.ahead.sigma else "expansion"
    return (f"elastic {kind}" if wave.elastic else kind,) * 2


def _contrast(left: Piece, right: Piece, found: exact.Solution) -> float:
    """Difference of density across the contact, over the larger."""
    a = found.left[-1].behind if found.left else left.edge(1)
    b = found.right[-1].behind if found.right else right.edge(-1)
    return abs(a.rho - b.rho) / max(a.rho, b.rho)


def _without_the_weak(units: list[Unit], middles: list[Piece], left: Piece, right: Piece, bench: Bench):
    """Leave out waves below the tolerance; a state between two others takes up what they would have carried, so that nothing is lost.

    Of one front alone no state is free: what it loses then is of the size of the waves left out, and is part of the reported errors.
    """
    strongest = max(range(len(units)), key=lambda k: units[k].strength)
    if units[strongest].strength == 0.0:
        return [], []
    kept = [k for k in range(len(units)) if units[k].strength >= bench.weakest or k == strongest]
    bench.dropped += len(units) - len(kept)
    if len(kept) == len(units):
        return units, middles
    chosen = [units[k] for k in kept]
    between = [Piece("state", left.region, middles[k].state) for k in kept[:-1]]
    if between:
        _absorb(chosen, between, left, right, bench)
    return chosen, between


def _absorb(units: list[Unit], between: list[Piece], left: Piece, right: Piece, bench: Bench) -> None:
    """Change the state that grows fastest by what is missing from mass, momentum and energy per time."""
    states = [left.edge(1), *(piece.state for piece in between), right.edge(-1)]
    missing = fluxes(states[0]) - fluxes(states[-1])
    for k, unit in enumerate(units):
        low, high = unit.fronts[0].speed, unit.fronts[-1].speed
        missing = missing - (low * densities(states[k]) - high * densities(states[k + 1]))
        for piece in unit.inside:
            missing = missing - fan_growth(piece)
    growth = [b.fronts[0].speed - a.fronts[-1].speed for a, b in zip(units, units[1:])]
    j = max(range(len(growth)), key=growth.__getitem__)
    mass, momentum, energy = (densities(between[j].state) + missing / growth[j]).tolist()
    u, s = momentum / mass, between[j].state.s
    e = energy / mass - 0.5 * u * u
    between[j].state = State(mass, u, e, pressure(mass, e, bench.matters[left.region].par) - s, s)


def _contact(left: Piece, right: Piece, found, x, t, bench: Bench) -> list[Front]:
    """The front or fronts that move with the material: an end, a contact, or two surfaces with a gap between them."""
    ul, ur = found.velocity
    if left.kind in OUTSIDE or right.kind in OUTSIDE:
        outside = left if left.kind in OUTSIDE else right
        if outside.kind == "wall" and found.vacuum:     # the material leaves the wall, which goes on by itself
            d = -1 if outside is left else 1
            end, surface = Front("end", x, t, bench.walls[d]), Front("surface", x, t, ul)
            return [end, surface] if d < 0 else [surface, end]
        return [Front("surface" if outside.kind == "vacuum" else "end", x, t, ul)]
    if found.vacuum:
        return [Front("surface", x, t, ul), Front("surface", x, t, ur)]
    return [Front("contact" if left.region == right.region else "interface", x, t, ul)]
