"""What leaves a place where fronts meet: the Riemann problem of the outermost states, and its waves as new fronts and pieces."""

from dataclasses import dataclass, field

from hugoniot.laws.riemann import solver as exact
from hugoniot.laws.riemann.branch import Matter, elastic, has_memory, wave_speed_squared
from hugoniot.laws.riemann.curve import Curve, Wave
from hugoniot.solvers.fronts.line import OUTSIDE, Front, Piece

NOISE = 2e-13    # strength of a wave that is rounding alone
MERGED = 2.5     # slices of a fan may reflect or join before they count as a new fan


@dataclass
class Bench:
    """What the meetings of a run need.

    matters      material of each region
    grips        stress (Pa) that holds each region to the next one: inf bonded, 0 separable, a bond's strength
    weakest      strength below which a wave inside one material is not followed; elastic   share of it that holds for elastic waves
    narrow       elastic releases count as jumps (cells mode)
    zones        cells aimed at in every region (cells mode)
    cylinder     plastic releases of solids are not followed: they are no centred fans there (cells mode)
    fan_step     change of velocity over the sound speed below which a release is one jump
    dropped      waves left out so far; crushing   those of them that close pores (cells mode)
    strongest    region -> strength of the strongest wave followed in it, and of the strongest left out (cells mode)
    unburned     number from which on regions are unburned explosive (cells mode); ideal  Chapman-Jouguet fronts found so far
    walls        velocity of the left and right wall; pressures  at the left and right end
    """

    matters: list[Matter]
    grips: list[float]
    weakest: float
    fan_step: float
    walls: dict[int, float] = field(default_factory=dict)
    pressures: dict[int, float] = field(default_factory=dict)
    dropped: int = 0
    crushing: int = 0
    strongest: dict[int, tuple[float, float]] = field(default_factory=dict)
    unburned: int = 1 << 60
    ideal: dict = field(default_factory=dict)
    elastic: float = 1.0
    narrow: bool = False
    cylinder: bool = False
    zones: list[int] = field(default_factory=list)

    def least(self, kind: str) -> float:
        """Strength from which on a front of a kind is followed."""
        return self.weakest * (self.elastic if kind.startswith("elastic") else 1.0)

    def of(self, piece: Piece) -> Matter:
        """What a piece is made of."""
        return piece.matter or self.matters[piece.region]


def solve(left: Piece, right: Piece, bench: Bench, sliced: bool) -> exact.Solution:
    """The Riemann problem of two neighbouring pieces (states or outsides); `sliced`: among slices of a fan, whose releases are jumps."""
    if not sliced:
        return _solved(left, right, bench, (left.broken, right.broken))
    first = _solved(left, right, bench, (True, True))
    jumps = tuple(piece.broken or _feeble(waves, bench) for piece, waves in ((left, first.left), (right, first.right)))
    return first if all(jumps) else _solved(left, right, bench, jumps)


def _feeble(waves: list[Wave], bench: Bench) -> bool:
    """Whether all fans among the waves are so weak that jumps do for them."""
    least = MERGED * bench.fan_step
    return all((w.behind.sigma >= w.ahead.sigma and not w.smooth) or abs(w.behind.u - w.ahead.u) < least * abs(w.head - w.ahead.u)
               for w in waves)


def _solved(left: Piece, right: Piece, bench: Bench, jumps) -> exact.Solution:
    if left.kind in OUTSIDE or right.kind in OUTSIDE:
        inner, outer, d = (right, left, 1) if left.kind in OUTSIDE else (left, right, -1)
        side = Curve(bench.of(inner), inner.edge(-d), d, jumps[(d + 1) // 2], bench.narrow)
        if outer.kind == "vacuum":
            return exact.surface(side, 0.0)
        if outer.kind == "pressure":
            return exact.surface(side, bench.pressures[-d])
        if outer.kind == "wall":
            return exact.wall(side, bench.walls[-d], bonded=side.bears_tension)
        state = inner.edge(-d)
        return exact.Solution([], [], (state.u, state.u), state.sigma)
    a = Curve(bench.of(left), left.edge(1), -1, jumps[0], bench.narrow)
    b = Curve(bench.of(right), right.edge(-1), 1, jumps[1], bench.narrow)
    grip = float("inf") if left.region == right.region else bench.grips[left.region]
    if not (a.bears_tension and b.bears_tension):
        grip = 0.0
    found = exact.contact(a, b, bonded=grip > 0.0)
    return exact.contact(a, b) if grip > 0.0 and found.stress < -grip else found


@dataclass
class Unit:
    """One thing that leaves a meeting: its fronts (two of a fan or of a gap), the pieces between them, and how strong it is."""

    fronts: list[Front]
    inside: list[Piece]
    strength: float


def outgoing(left: Piece, right: Piece, x: float, t: float, bench: Bench,
             sliced: bool = False) -> tuple[list[Front], list[Piece], exact.Solution]:
    """(fronts, pieces between them, solution) that replace what met at (x, t); the pieces left and right stay as they are.

    sliced   one of those that met came from a slice of a fan: feeble releases are jumps, and what leaves counts as sliced too
    """
    found = solve(left, right, bench, sliced)
    units, middles = _units(left, right, found, x, t, bench)
    units, middles = _without_noise(units, middles)
    if left.kind == right.kind == "state" and left.region == right.region and not found.vacuum:
        units, middles = _without_the_weak(units, middles, bench)
    fronts, pieces = [], []
    for k, unit in enumerate(units):
        if k:
            pieces.append(middles[k - 1])
        fronts += unit.fronts
        pieces += unit.inside
    for front in fronts:
        front.sliced = sliced
    return fronts, pieces, found


def _units(left: Piece, right: Piece, found: exact.Solution, x, t, bench: Bench) -> tuple[list[Unit], list[Piece]]:
    """Everything that leaves, from left to right, and the pieces between."""
    units, middles = _side(found.left, left.region, x, t)
    contact = _contact(left, right, found, x, t, bench)
    units.append(Unit(contact, [Piece("vacuum")] * (len(contact) - 1), _contrast(left, right, found, bench)))
    after, between = _side(found.right, right.region, x, t)
    units += reversed(after)
    middles += reversed(between)
    # an expansion to nothing has no second edge: its fan reaches to the surface itself
    for k, unit in enumerate(units):
        if unit.inside and unit.inside[0].kind == "fan" and unit.inside[0].wave.behind.rho == 0.0:
            side = unit.inside[0].wave.direction
            unit.fronts = unit.fronts[:1] if side < 0 else unit.fronts[1:]
            middles[k if side < 0 else k - 1] = unit.inside.pop()
    return units, middles


def _side(waves: list[Wave], region: int, x: float, t: float) -> tuple[list[Unit], list[Piece]]:
    """(what leaves on one side, the pieces behind each), outermost first; waves that run at one speed are one unit."""
    units: list[Unit] = []
    middles: list[Piece] = []
    for wave in waves:
        unit = _unit(wave, region, x, t)
        if wave.attached and units:
            units[-1] = _joined(units[-1], unit, wave)
            middles.pop()
        else:
            units.append(unit)
        middles.append(Piece("state", region, wave.behind))
    return units, middles


def _joined(outer: Unit, inner: Unit, wave: Wave) -> Unit:
    """A unit and the wave that runs directly behind it: where both have an edge, a fan leaves its own to the jump."""
    way = -wave.direction
    first, last = outer.fronts[::way], inner.fronts[::way]
    fronts = [*first, *last[1:]] if wave.kind == "fan" else [*first[:-1], *last]
    return Unit(fronts[::way], [*outer.inside, *inner.inside], max(outer.strength, inner.strength))


def _unit(wave: Wave, region: int, x: float, t: float) -> Unit:
    head, tail = _names(wave)
    if wave.kind != "fan":
        return Unit([Front(head, x, t, wave.head, wave.direction, wave.strength)], [], wave.strength)
    edges = [Front(head, x, t, wave.head, wave.direction, wave.strength), Front(tail, x, t, wave.tail, wave.direction, wave.strength)]
    return Unit(edges if wave.direction < 0 else edges[::-1], [Piece("fan", region, wave.ahead, wave, x, t)], wave.strength)


def _names(wave: Wave) -> tuple[str, str]:
    if wave.kind == "fan":
        word = "elastic fan" if wave.elastic else "compaction fan" if wave.behind.sigma > wave.ahead.sigma else "fan"
        return f"{word} head", f"{word} tail"
    kind = "shock" if wave.behind.sigma > wave.ahead.sigma else "expansion"
    return (f"elastic {kind}" if wave.elastic else kind,) * 2


def _contrast(left: Piece, right: Piece, found: exact.Solution, bench: Bench) -> float:
    """Difference of density across the contact, over the larger; in pores also that of compaction, or of energy over c^2.

    The pressure of pores that close need not depend on the energy: then the density does not tell one side of a contact from the other.
    """
    a = found.left[-1].behind if found.left else left.edge(1)
    b = found.right[-1].behind if found.right else right.edge(-1)
    contrast = abs(a.rho - b.rho) / max(a.rho, b.rho, 1e-300)
    if left.kind != "state" or left.region != right.region or not has_memory(bench.of(left).par):
        return contrast
    square = wave_speed_squared(a.rho, a.e, elastic(bench.of(left), a))
    return max(contrast, abs(a.compaction - b.compaction), abs(a.e - b.e) / max(square, 1e-300))


def _without_noise(units: list[Unit], middles: list[Piece]) -> tuple[list[Unit], list[Piece]]:
    """Leave out waves that are rounding alone; what moves with the material stays."""
    kept = [k for k, unit in enumerate(units) if unit.strength > NOISE or unit.fronts[0].direction == 0]
    moving = [k for k in kept if units[k].fronts[0].direction == 0]
    return [units[k] for k in kept], [middles[k if k < moving[0] else kept[j + 1] - 1] for j, k in enumerate(kept[:-1])]


def _without_the_weak(units: list[Unit], middles: list[Piece], bench: Bench):
    """Leave out waves below the tolerance; the strongest stays and carries the rest.

    What the waves left out would have carried is missing from the sums of mass, momentum and energy: part of the errors a run reports.
    """
    strongest = max(range(len(units)), key=lambda k: units[k].strength)
    if units[strongest].strength == 0.0:
        return [], []
    kept = [k for k in range(len(units)) if units[k].strength >= bench.least(units[k].fronts[0].kind) or k == strongest]
    bench.dropped += len(units) - len(kept)
    return [units[k] for k in kept], [middles[k] for k in kept[:-1]]


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
