"""The Riemann problem of the solvers: two materials, a material and a wall, a material and a given pressure.

The stress between the waves is where both wave curves have one velocity: Newton's method in the stress with the curves' own slopes, inside
a bracket. Bodies that are not bonded separate rather than bear tension; a gas then expands completely.

Written apart from `theory.riemann`, which serves to check it.
"""

import math
from dataclasses import dataclass

from hugoniot.errors import NoSolution, OutOfRange
from hugoniot.laws.riemann.branch import Matter, State, has_memory, wave_speed_squared
from hugoniot.laws.riemann.curve import Curve, Wave
from hugoniot.laws.riemann.fan import SPRAY
from hugoniot.laws.riemann.medium import has_pieces, name_of

AT_REST = 1e-11       # of the sound speeds: bodies that part no faster are at rest side by side
TORN = 1e-6      # of the sound speeds: a difference of velocity that is no rounding
CROSSED = 1e-6   # of the sound speed: the tail of a fan may outrun its head by so much
WEAK = 1e-3      # strength of shocks that are not checked: their speed differs from the sound speeds by no more
KINKED = 0.05    # by how much a shock may miss the sound on its sides in a law of many pieces (a table), whose slopes leap
SPLITS = ("the shock of law '{}' to {:.6g} Pa {}: it would break up into several waves, which are not followed (use lagrange1d, or a law "
          "that is convex there)")
BENDS = ("law '{}' is not convex between {:.6g} and {:.6g} kg/m3: the characteristics of this release would cross and form a rarefaction "
         "shock, which is not followed (use lagrange1d, or a law that is convex there)")


@dataclass(frozen=True)
class Solution:
    """What leaves a meeting.

    left, right      waves on either side, outermost first; a wall or a surface has waves on one side only
    velocity         of the contact, m/s, or of each surface (left, right) where a vacuum opens
    stress           at the contact, Pa
    vacuum           whether the two sides separate
    """

    left: list[Wave]
    right: list[Wave]
    velocity: tuple[float, float]
    stress: float
    vacuum: bool = False


def contact(left: Curve, right: Curve, bonded: bool = False, start: float | None = None) -> Solution:
    """Solve for the stress and velocity at which the two sides meet; `NoSolution` where the curves do not. start: a guess of the stress."""
    zl, zr = left.state.rho * left.c, right.state.rho * right.c
    floor = -math.inf if bonded else 0.0
    if not bonded and (apart := _apart(left, right)) is not None:
        return apart

    def gap(sigma):
        a, slope_a, _ = left.at(sigma)
        b, slope_b, _ = right.at(sigma)
        return b.u - a.u, slope_a + slope_b

    if not start or start <= 0.0:
        start = 0.5 * (left.state.sigma + right.state.sigma) if zl + zr == 0.0 else (
            zr * left.state.sigma + zl * right.state.sigma + zl * zr * (left.state.u - right.state.u)) / (zl + zr)
    thrust = min(left.state.rho, right.state.rho) * (left.state.u - right.state.u) ** 2
    scale = max(left.stiffness, right.stiffness, thrust)
    start = start if start > 0.0 or zl * zr > 0.0 else thrust      # cold gases have no sound to guess by
    sigma = _root(gap, start, floor, scale, (left, right))
    a, _, waves_left = left.at(sigma)
    b, _, waves_right = right.at(sigma)
    _hold(b.u - a.u, sigma, (left, right))
    _spread(left, waves_left)
    _spread(right, waves_right)
    u = 0.5 * (a.u + b.u)
    return Solution(waves_left, waves_right, (u, u), sigma)


def wall(side: Curve, velocity: float, bonded: bool = True) -> Solution:
    """A material against a wall or piston of given velocity; unless bonded it separates from one that runs away."""
    d = side.direction     # the waves run away from the wall: d = +1 for a wall on the left
    start = side.state.sigma + d * side.state.rho * side.c * (velocity - side.state.u)
    # a wall that is pushed against is not left; nor where the acoustic answer presses, for a release follows its chord from above
    if not bonded and (side.state.u - velocity) * d > 0.0 and not start > 0.0:
        edge, waves = side.surface()
        if (edge - velocity) * d > 0.0:
            return _one_sided(side, waves, edge, 0.0, True)

    def gap(sigma):
        a, slope, _ = side.at(sigma)
        return d * (a.u - velocity), slope

    thrust = side.state.rho * (velocity - side.state.u) ** 2
    sigma = _root(gap, start if side.c else thrust, -math.inf, max(side.stiffness, thrust), (side,))
    _hold(gap(sigma)[0], sigma, (side,))
    return _one_sided(side, side.at(sigma)[2], velocity, sigma, False)


def surface(side: Curve, pressure: float) -> Solution:
    """A material under a given pressure at its surface (0: a free surface)."""
    if pressure == 0.0:
        edge, waves = side.surface()
        return _one_sided(side, waves, edge, 0.0, False)
    after, _, waves = side.at(pressure)
    return _one_sided(side, waves, after.u, pressure, False)


def _one_sided(side: Curve, waves: list[Wave], velocity: float, sigma: float, vacuum: bool) -> Solution:
    _spread(side, waves)
    left, right = (waves, []) if side.direction < 0 else ([], waves)
    return Solution(left, right, (velocity, velocity), sigma, vacuum)


def _apart(left: Curve, right: Curve) -> Solution | None:
    """The solution with a vacuum between the sides, if their surfaces run apart."""
    closing = left.state.u - right.state.u
    lowest = min(left.state.sigma, right.state.sigma)
    zl, zr = left.state.rho * left.c, right.state.rho * right.c
    # a release follows its chord from above: where the acoustic answer presses, the exact one does
    if lowest >= 0.0 and (closing >= 0.0 or zr * left.state.sigma + zl * right.state.sigma + zl * zr * closing > 0.0):
        return None
    (ul, waves_left), (ur, waves_right) = left.surface(), right.surface()
    if ul - ur >= -AT_REST * (left.c + right.c):
        return None
    _spread(left, waves_left)
    _spread(right, waves_right)
    return Solution(waves_left, waves_right, (ul, ur), 0.0, True)


def _root(gap, sigma: float, floor: float, scale: float, sides) -> float:
    """The stress at which the rising function `gap(sigma) -> (value, slope)` vanishes."""
    low, high = floor, math.inf
    tallest = max(abs(side.state.sigma) for side in sides)
    if sigma <= floor or not math.isfinite(sigma):
        positive = [s.state.sigma for s in sides if s.state.sigma > 0.0]
        sigma = 0.5 * min(positive) if positive else 1e-6 * scale
    last, size = math.inf, max(tallest, 1e-300)
    for _ in range(200):
        value, slope = _tried(gap, sigma, low)
        if value == 0.0:
            return sigma
        low, high = (sigma, high) if value < 0.0 else (low, sigma)
        new = sigma - value / slope if slope > 0.0 and math.isfinite(slope) else math.nan
        if abs(new - sigma) <= 4e-16 * abs(sigma):      # a step of rounding, which a bracket of rounding would only send astray
            return sigma
        if not low < new < high:
            new = _inside(sigma, low, high, scale, value)
        moved = abs(new - sigma)
        if moved <= 1e-16 * max(abs(sigma), 1e-3 * size) or (moved >= last and moved <= 1e-12 * max(abs(sigma), size, 1e-3 * scale)):
            return sigma if moved >= last else new
        last, sigma = moved, new
    if last <= 1e-10 * max(abs(sigma), scale):
        return sigma
    names = " and ".join(f"'{name_of(side.matter.par)}'" for side in sides)
    raise NoSolution(f"the wave curves of {names} did not intersect between {low:.6g} and {high:.6g} Pa")


def _hold(gap: float, sigma: float, sides) -> None:
    """Raise `OutOfRange` where the sides separate under the largest tension that their laws support: the search ends there with a gap."""
    if sigma < 0.0 and abs(gap) > TORN * sum(side.c for side in sides):
        raise OutOfRange(SPRAY.format("' or '".join(dict.fromkeys(name_of(side.matter.par) for side in sides)), -sigma))


def _spread(side: Curve, waves: list[Wave]) -> None:
    """Raise `OutOfRange` where waves would not last, as in a law that is not convex: characteristics of a release that run into each other,
    shocks of fluids that are slower than the sound ahead or faster than the sound behind (Lax)."""
    law = side.matter.par
    plain = not side.solid and not has_memory(law)
    for wave in waves:
        if wave.kind == "fan" and (wave.tail - wave.head) * wave.direction > CROSSED * side.c:
            raise OutOfRange(BENDS.format(name_of(law), *sorted((wave.ahead.rho, wave.behind.rho))))
        if plain and wave.kind == "shock" and wave.behind.sigma > wave.ahead.sigma and wave.strength > WEAK:
            flux = (wave.head - wave.ahead.u) * wave.direction * wave.ahead.rho
            ahead, behind = (state.rho * math.sqrt(max(wave_speed_squared(state.rho, state.e, side.branch), 0.0))
                             for state in (wave.ahead, wave.behind))
            loose = KINKED if has_pieces(law) else CROSSED
            if flux < ahead * (1.0 - loose):
                raise OutOfRange(SPLITS.format(name_of(law), wave.behind.sigma, "is slower than the sound ahead of it"))
            if flux > behind * (1.0 + loose):
                raise OutOfRange(SPLITS.format(name_of(law), wave.behind.sigma, "is faster than the sound behind it"))


def _tried(gap, sigma: float, low: float):
    """The gap at a trial; a tension that a law cannot support counts as too low."""
    try:
        return gap(sigma)
    except (NoSolution, ArithmeticError, ValueError):
        if sigma > 0.0:
            raise
        return -math.inf, math.nan


def _inside(sigma, low, high, scale, value) -> float:
    """Another trial inside the bracket."""
    if math.isfinite(low) and math.isfinite(high):
        return math.sqrt(low * high) if low > 0.0 else (0.1 * high if low == 0.0 and high > 0.0 else 0.5 * (low + high))
    if value > 0.0:      # only an upper end is known
        return sigma - max(abs(sigma), 1e-3 * scale)
    return sigma + max(10.0 * abs(sigma), 1e-3 * scale)


def riemann(left: Matter, left_state: State, right: Matter, right_state: State, bonded: bool = False) -> Solution:
    """The Riemann problem of two materials with exact shocks and fans."""
    return contact(Curve(left, left_state, -1), Curve(right, right_state, 1), bonded)
