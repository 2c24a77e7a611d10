"""What leaves a place where fronts meet, or where bodies touch at the start: new fronts, and between them cells that begin at no width.

The waves are those of the algebraic mode (`meeting.outgoing`). A new cell has neither width nor content; its faces keep the states of the
exact self-similar solution for one step (in planar fans longer, see fans.py), so that the fluxes through them give it its exact
content. Until then the contents of a solid's new cell hold the stretch and hoop strain that it begins with. Waves too weak to be followed
are left out: what they carry passes into the cells beside, and nothing is lost.
"""

import math

import numpy as np

from hugoniot.laws.burn.contract import Reactive
from hugoniot.laws.eos.contract import density_limits
from hugoniot.laws.riemann.branch import Branch, has_memory, wave_speed_squared
from hugoniot.laws.riemann.medium import Frozen, mixture_limit
from hugoniot.laws.riemann.wave import Side, jumps
from hugoniot.solvers.fronts import line
from hugoniot.solvers.fronts.cells import detonations
from hugoniot.solvers.fronts.cells.fans import SAME, lasting
from hugoniot.solvers.fronts.cells.mesh import EMPTY, Front, Mesh
from hugoniot.solvers.fronts.cells.solids import strains_of, stretch_of
from hugoniot.solvers.fronts.cells.tables import BORN_LEFT, BORN_RIGHT, HOOP, VOLUME
from hugoniot.solvers.fronts.line import OUTSIDE, Piece
from hugoniot.solvers.fronts.meeting import Bench, outgoing

FAN_WEAKEST = 3.0    # times the weakest wave: a fan that is weaker has no edges to follow
MOST_IN_FAN = 32
FEWEST = 4           # cells at the start of a fan that is not exact
COARSE = 25          # zones of a region from which on a fan that is not exact starts with more cells, in proportion
NARROW = 2.0         # of a fan that changes the velocity by less than two of its steps: it starts with as many cells as if by two
LEAST_GROWTH = 0.003 # per step, at Courant number 1, of a fan that starts with more cells: it soon has the width of ordinary cells
CLOSED = 1e-3        # difference of compaction on both sides of a wave that closes pores
NEWBORN = 3          # cells between two waves that part: a parabola has three averages


def collapse(mesh: Mesh, first: int, last: int, x: float, unburned: int) -> int:
    """Remove the cells between the faces first and last, which meet at x; the face that is left there, a front.

    What is left in the cells, an error of the method, goes to a neighbour of the same region.
    """
    n = len(mesh.q)
    mesh.touch(first, last)
    for cell in range(first, last):
        region = mesh.region[cell]
        if region == EMPTY:
            continue
        near = [k for k in (first - 1, last) if 0 <= k < n and mesh.region[k] != EMPTY and mesh.region[k] % unburned == region % unburned]
        if not near:
            raise ArithmeticError("a body vanished between two fronts")
        for k in near:
            mesh.q[k] += mesh.q[cell] / len(near)
    keep = np.ones(n + 1, dtype=bool)
    keep[first + 1:last + 1] = False
    order = np.cumsum(mesh.marked) - 1
    gone = {int(order[f]) for f in range(first + 1, last + 1) if mesh.marked[f]}
    mesh.fronts = [front for k, front in enumerate(mesh.fronts) if k not in gone]
    mesh.x, mesh.marked, mesh.given = mesh.x[keep], mesh.marked[keep], mesh.given[keep]
    mesh.x[first] = x
    mesh.q = np.delete(mesh.q, range(first, last), axis=0)
    mesh.region, mesh.push, mesh.level = (np.delete(row, range(first, last)) for row in (mesh.region, mesh.push, mesh.level))
    return first


def bear(mesh: Mesh, face: int, left: Piece, right: Piece, time: float, bench: Bench, followed: bool = True) -> tuple[list[str], str]:
    """Replace the front at a face by what leaves there; (kinds of the new fronts, a word on the state between).

    followed   False where no more waves can be followed: those that move with the material stay
    """
    fronts, pieces, found = outgoing(left, right, float(mesh.x[face]), time, bench)
    given = [_given(front, [left, *pieces, right][k:k + 2]) for k, front in enumerate(fronts)]
    given = _with_scalars(mesh, [left, *pieces, right], fronts, given, bench)
    rows = _without_the_weak(list(zip(fronts, given)), (left, right), pieces, bench, followed)
    if followed:
        kept = {id(front) for front, _ in rows[0]} if rows else set()
        note_strengths([(front, id(front) in kept) for front in fronts], (left.region, right.region), bench)
    position = int(np.count_nonzero(mesh.marked[:face]))
    if rows is None:                          # nothing is left to follow
        del mesh.fronts[position]
        mesh.marked[face] = False
        mesh.given[face] = given[len(given) // 2] if given else np.nan
        return [], "nothing"
    kinds = place(mesh, face, (left, right), (fronts, pieces), rows, time, bench)
    word = "vacuum opens" if found.vacuum else f"{found.stress:.6g} Pa, {found.velocity[0]:.6g} m/s"
    return kinds, word


def place(mesh: Mesh, face: int, outer, whole, rows, time: float, bench: Bench) -> list[str]:
    """Put new fronts and the cells between them in the place of a front; their kinds.

    outer   the pieces left and right; whole   (fronts, pieces between) of all waves that leave
    rows    ([(front, its state)], pieces between) of those that are followed
    """
    (left, right), (fronts, pieces), (kept, between) = outer, whole, rows
    x, position = float(mesh.x[face]), int(np.count_nonzero(mesh.marked[:face]))
    marks, values, regions, push, made, strains = [], [], [], [], [], []
    for k, (front, state) in enumerate(kept):
        if k:
            lasts = lasting(between[k - 1], mesh.d, bench) and _even(mesh, face, between[k - 1])
            marks_in, values_in, count = _inside(between[k - 1], kept[k - 1], kept[k], lasts, bench)
            marks += marks_in
            values += values_in
            regions += [between[k - 1].region if between[k - 1].kind != "vacuum" else EMPTY] * count
            ends = np.array([kept[k - 1][1], *values_in, state])
            push += [between[k - 1].state.sigma] if count == 1 else (0.5 * (ends[1:, 4] + ends[:-1, 4])).tolist()
            if between[k - 1].kind != "vacuum" and bench.of(between[k - 1]).yield_stress:
                pair = fronts.index(kept[k - 1][0]), fronts.index(front)
                strains += [strains_of([left, *pieces, right], fronts, pair, bench)] * count if bench.cylinder else [
                    (stretch, 0.0) for stretch in 0.5 * (ends[:-1, BORN_RIGHT] + ends[1:, BORN_LEFT])]
            else:       # in pores the compaction, which waves carry from there on
                strains += [(0.0, between[k - 1].state.compaction)] * count
            made[-1].least = count
            made[-1].fan = between[k - 1] if lasts else None
        marks.append(True)
        values.append(state)
        sides = (tuple([left, *pieces][fronts.index(front)].edge(1))[:5], tuple([*pieces, right][fronts.index(front)].edge(-1))[:5])
        made.append(Front(front.kind, front.speed, front.direction, front.strength, 1, time, x, sides))
    mesh.fronts[position:position + 1] = made
    mesh.x = np.concatenate([mesh.x[:face], np.full(len(marks), x), mesh.x[face + 1:]])
    mesh.marked = np.concatenate([mesh.marked[:face], np.array(marks, dtype=bool), mesh.marked[face + 1:]])
    mesh.given = np.concatenate([mesh.given[:face], np.array(values).reshape(-1, mesh.given.shape[1]), mesh.given[face + 1:]])
    born = np.zeros((len(regions), mesh.q.shape[1]))
    if born.shape[1] > 3 and regions:
        born[:, [VOLUME, HOOP]] = strains
    mesh.q = np.concatenate([mesh.q[:face], born, mesh.q[face:]])
    mesh.push = np.concatenate([mesh.push[:face], np.array(push), mesh.push[face:]])
    mesh.level = np.insert(mesh.level, face, np.zeros(len(regions), dtype=np.int64))
    mesh.region = np.concatenate([mesh.region[:face], np.array(regions, dtype=mesh.region.dtype), mesh.region[face:]])
    return [front.kind for front in made]


def part(mesh: Mesh, face: int, whole: list[Piece], fronts: list[line.Front], time: float, bench: Bench) -> None:
    """Put two fronts that part in the place of one; whole: what is on the left, between them, and on the right."""
    given = [_given(front, whole[k:k + 2]) for k, front in enumerate(fronts)]
    for row, front in zip(given, fronts):
        row[4] = whole[1].state.sigma if front.direction == 0 else row[4]      # what moves with the material feels what is between
    given = _with_scalars(mesh, whole, fronts, given, bench)
    place(mesh, face, (whole[0], whole[2]), (fronts, whole[1:2]), (list(zip(fronts, given)), whole[1:2]), time, bench)


def ignite(mesh: Mesh, face: int, left: Piece, right: Piece, time: float, bench: Bench) -> tuple[list[str], str]:
    """The same where unburned explosive is lit; all waves are followed."""
    fronts, pieces, found = detonations.lit(left, right, float(mesh.x[face]), time, bench)
    given = [_given(front, [left, *pieces, right][k:k + 2]) for k, front in enumerate(fronts)]
    given = _with_scalars(mesh, [left, *pieces, right], fronts, given, bench)
    kinds = place(mesh, face, (left, right), (fronts, pieces), (list(zip(fronts, given)), pieces), time, bench)
    return kinds, f"{found.stress:.6g} Pa, {found.velocity[0]:.6g} m/s"


def _given(front: line.Front, beside) -> list[float]:
    """(speed, density, velocity, energy, pressure) at a newborn front."""
    left, right = beside
    if front.direction == 0:
        material = right if left.kind in OUTSIDE else left
        p = 0.0 if "vacuum" in (left.kind, right.kind) else material.edge(-1 if material is right else 1).sigma
        return [front.speed, 0.0, front.speed, 0.0, p]
    if "fan" in front.kind:
        s = (left if left.kind == "fan" else right).edge(1 if left.kind == "fan" else -1)
    else:
        s = right.edge(-1) if front.direction > 0 else left.edge(1)
    return [front.speed, s.rho, s.u, s.e, s.sigma]


def _without_the_weak(rows, sides, pieces: list[Piece], bench: Bench, followed: bool):
    """(fronts with their states, pieces between) that are followed; None if there are none."""
    (left, right), rows, pieces = sides, list(rows), list(pieces)
    contrasts = {id(front): _contrast(beside) for front, beside in zip((row[0] for row in rows), zip([left, *pieces], [*pieces, right]))}
    k = 0
    while k < len(rows):
        front = rows[k][0]
        is_fan = front.direction != 0 and k < len(pieces) and pieces[k].kind == "fan" and rows[k + 1][0].direction == front.direction
        width = 2 if is_fan else 1
        weak = front.kind == "contact" or front.direction != 0
        if front.kind == "contact":
            weak = contrasts[id(front)] < bench.weakest
        elif weak:
            weak = front.strength < bench.least(front.kind) * (FAN_WEAKEST if is_fan else 1.0)
        weak = weak or (not followed and (front.kind == "contact" or front.direction != 0))
        weak = weak or (is_fan and bench.cylinder and bench.of(left if front.direction < 0 else right).yield_stress > 0.0)
        if not weak:
            k += width
            continue
        sides = pieces[k - 1] if k else left, pieces[k] if k < len(pieces) else right
        bench.crushing += front.kind == "shock" and closes_pores(*sides)
        # with a wave goes the piece behind it; with a contact one of the pieces beside it
        inner = k + width - 1 if front.direction <= 0 else k - 1
        del rows[k:k + width]
        gone = [inner] if 0 <= inner < len(pieces) else []
        if front.direction == 0 and not gone and k - 1 >= 0:
            gone = [k - 1] if k - 1 < len(pieces) else []
        if width == 2:
            gone.append(k)
        for j in sorted(gone, reverse=True):
            del pieces[j]
        bench.dropped += 1
    return (rows, pieces) if rows else None


def note_strengths(waves, regions, bench: Bench) -> None:
    """Keep the strengths of the strongest wave that is followed, and not, of the regions left and right of where they leave; waves: (front,
    whether it is followed)."""
    for front, here in waves:
        if front.direction:
            region = regions[0 if front.direction < 0 else 1]
            followed, left = bench.strongest.get(region, (0.0, 0.0))
            bench.strongest[region] = (max(followed, front.strength), left) if here else (followed, max(left, front.strength))


def closes_pores(left: Piece, right: Piece) -> bool:
    """Whether the compaction differs across a wave."""
    return left.kind == right.kind == "state" and abs(left.edge(1).compaction - right.edge(-1).compaction) > CLOSED


def _contrast(beside) -> float:
    """Difference of density between two pieces, over the larger; 1 beside a gap or an end."""
    a, b = beside
    if a.kind in OUTSIDE or b.kind in OUTSIDE:
        return 1.0
    low, high = a.edge(1).rho, b.edge(-1).rho
    return abs(low - high) / max(low, high, 1e-300)


def _even(mesh: Mesh, face: int, fan: Piece) -> bool:
    """Whether a fan that is born at a face is to last: not an expansion to nothing into a cell of another density than its first state."""
    if fan.wave.behind.rho > 0.0:
        return True
    cell, rho = (face - 1 if fan.wave.direction < 0 else face), fan.wave.ahead.rho
    return abs(mesh.q[cell, 0] / mesh.volume()[cell] - rho) <= SAME * rho


def _inside(piece: Piece, before, after, lasts: bool, bench: Bench):
    """(marks, states) of the faces inside a new piece, and how many cells it is; (front, its state) on both sides.

    lasts   a fan that stays self-similar for a while
    """
    left, right = before[0], after[0]
    if piece.kind == "vacuum" or right.speed <= left.speed:
        return [], [], 1
    if piece.kind == "fan":
        wave = piece.wave
        c = abs(wave.head - wave.ahead.u)
        fall = abs(wave.behind.u - wave.ahead.u) / (bench.fan_step * c)
        count = min(max(math.ceil(fall), 2), MOST_IN_FAN)
        if not lasts:
            finer = math.ceil(max(fall, NARROW) * bench.zones[piece.region] / COARSE)
            finer = min(finer, MOST_IN_FAN) if wave.behind.rho == 0.0 else finer
            count = max(count, FEWEST, min(finer, int((right.speed - left.speed) / (LEAST_GROWTH * c))))
    else:
        count = 1 if any(front.kind.startswith("elastic") for front in (left, right)) else NEWBORN      # the two shocks part slowly
    speeds = np.linspace(left.speed, right.speed, count + 1)[1:-1].tolist()
    states = [line.fan_state(piece, xi) if piece.kind == "fan" else piece.state for xi in speeds]
    given = (before if left.direction else after)[1][5:]
    matter = bench.of(piece)
    scalars = [[given[0], *(stretch_of(s, matter),) * 2] if matter.yield_stress else
               [*given[:2], s.compaction] if len(given) and has_memory(matter.par) else given for s in states]
    return [False] * (count - 1), [[xi, s.rho, s.u, s.e, s.sigma, *more] for xi, s, more in zip(speeds, states, scalars)], count


def _with_scalars(mesh: Mesh, whole: list[Piece], fronts, given, bench: Bench):
    """The states at newborn fronts, with what goes with the mass behind them: a shock gives isolated reactants a new reference state.

    whole   all pieces, those outside included. Of solids it is the hoop strain, which waves leave as it is, and the stretch on either side.
    """
    if mesh.given.shape[1] == 5:
        return given
    rows = []
    for k, (front, state) in enumerate(zip(fronts, given)):
        scalars, piece = [0.0, 0.0, 0.0], whole[0] if front.direction < 0 else whole[-1]
        par = piece.matter.par if piece.matter is not None else None
        if front.direction and isinstance(par, Frozen):
            scalars = [par.burned, par.volume, par.energy]
            if "shock" in front.kind:
                scalars[1:] = _new_reference(par, state, front)
        elif front.direction and has_memory(bench.of(piece).par):
            scalars[2] = whole[k + (front.direction < 0)].edge(front.direction).compaction      # behind the front
        elif front.direction and piece.matter is not None:
            scalars[0] = piece.matter.hoop
        for j, beside in enumerate(whole[k:k + 2]):
            if beside.kind in ("state", "fan") and (matter := bench.of(beside)).yield_stress:
                scalars[1 + j] = stretch_of(beside.edge(1 - 2 * j), matter)
        rows.append([*state, *scalars])
    return rows


def _new_reference(par: Frozen, state, front) -> tuple[float, float]:
    """Volume and energy of the reactants behind a shock of known speed."""
    _, rho, u, e, p = state
    square = wave_speed_squared(rho, e, Branch(par))
    flux = rho * abs(front.speed - u)
    side = Side(rho, e, p, square, par.burned, par.volume, par.energy, mixture_limit(par.burned, par.mixture),
                density_limits(par.mixture.reactants)[1], density_limits(par.mixture.products)[1])
    # the pressure behind: where the flux of the jump is that of the front, which rises with it
    low, high = p, p + flux * flux / rho
    for _ in range(200):
        middle = 0.5 * (low + high)
        if not low < middle < high:
            break
        x = jumps(middle, side, Reactive(None, par.mixture))[0]
        low, high = (middle, high) if x > 0.0 and middle - p < flux * flux * x else (low, middle)
    return jumps(0.5 * (low + high), side, Reactive(None, par.mixture))[1:]
