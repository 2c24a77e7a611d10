"""Where fronts go and what passes them, compiled: the exact Riemann problem of the states on both sides, half a step on.

Waves are asked of the laws by address (passes.wave_pass). What is rare (a gap that opens, an expansion to nothing, a search that fails)
is left to Python, which has it all (tracked.py): the functions then answer nan.
"""

import math

import numba as nb

from hugoniot.core.pass_lists import call_pass
from hugoniot.core.rows import row_at
from hugoniot.core.target import GUARD
from hugoniot.solvers.fronts.cells.tables import (
    DIRECTION,
    END,
    F_E,
    F_P,
    F_RHO,
    F_U,
    FACE,
    HEAD,
    INTO_LEFT,
    INTO_RIGHT,
    KIND,
    LAM,
    LEFT,
    OPEN,
    PRESSURE,
    RIGHT,
    SPEED,
    SPEED_OF,
    STRENGTH,
    UNBURNED,
    VACUUM,
    WALL,
    WEAKEST,
    C,
    E,
    P,
    U,
)

RISE, BY_P, RHO_B, E_B, FLUX, VOLUME_B, ENERGY_B = range(12, 19)


@nb.njit(**GUARD)
def take_side(rules, work, side, region, block, cell):
    """Put a state of the table on one side of a Riemann problem (0 left, 1 right)."""
    w, io = work.w, work.io[side]
    io[1], io[2], io[3], io[4] = w[block, cell], w[block + E, cell], w[block + P, cell], w[block + C, cell] ** 2
    io[5], io[6], io[7] = min(max(w[block + LAM, cell], 0.0), 1.0), w[block + LAM + 1, cell], w[block + LAM + 2, cell]
    io[8], io[9], io[10] = rules.limits[region, 0], rules.limits[region, 1], rules.limits[region, 2]
    io[11] = w[block + U, cell]
    return region


@nb.njit(**GUARD)
def wave_to(rules, work, side, region, p):
    """The wave of one side to a pressure: into io[RISE] and on."""
    work.io[side, 0] = p
    start = work.io.ctypes.data + 8 * side * work.io.shape[1]
    work.pointers[0], work.pointers[1] = start, start + 8 * RISE
    call_pass(rules.passes[region, 1], 1, 2, work.pointers, 0.0, row_at(rules.words[region]))


@nb.njit(**GUARD)
def meet(rules, work, left, right, bonded, start):
    """(pressure, velocity) between two sides; nan where they part or are not found. start: a first guess, nan for the acoustic one."""
    a, b = work.io[0], work.io[1]
    za, zb = a[1] * math.sqrt(a[4]), b[1] * math.sqrt(b[4])
    closing, lowest = a[11] - b[11], min(a[3], b[3])
    acoustic = zb * a[3] + za * b[3] + za * zb * closing
    if not bonded and not (lowest >= 0.0 and (closing >= 0.0 or acoustic > 0.0)):
        return math.nan, math.nan
    thrust = min(a[1], b[1]) * closing**2
    scale = max(a[1] * a[4], b[1] * b[4], thrust)
    p = acoustic / (za + zb) if za + zb > 0.0 else 0.5 * (a[3] + b[3])
    p = p if p > 0.0 or za * zb > 0.0 else thrust
    p = start if start > 0.0 else p
    low, high, last = -1e300 if bonded else 0.0, 1e300, 1e300
    if not p > low:
        p = 0.5 * lowest if lowest > 0.0 else 1e-6 * scale
    size = max(abs(a[3]), abs(b[3]), 1e-300)
    for _ in range(100):
        wave_to(rules, work, 0, left, p)
        wave_to(rules, work, 1, right, p)
        value, slope = (b[11] + b[RISE]) - (a[11] - a[RISE]), a[BY_P] + b[BY_P]
        if value != value:
            return math.nan, math.nan
        if value < 0.0:
            low = p
        else:
            high = p
        new = p - value / slope
        if value == 0.0 or abs(new - p) <= 4e-16 * abs(p):
            return p, 0.5 * (a[11] - a[RISE] + b[11] + b[RISE])
        if not (low < new < high):
            new = 0.5 * (low + high) if high < 1e300 and low > -1e300 else math.nan
            if new != new:
                return math.nan, math.nan
        moved = abs(new - p)
        if moved <= 1e-16 * max(abs(p), 1e-3 * size) or (moved >= last and moved <= 1e-12 * max(abs(p), size, 1e-3 * scale)):
            return p, 0.5 * (a[11] - a[RISE] + b[11] + b[RISE])
        last, p = moved, new
    return math.nan, math.nan


@nb.njit(**GUARD)
def press(rules, work, side, region, velocity):
    """Pressure on a wall of that velocity; nan where the material may leave it."""
    a, d = work.io[side], 2.0 * side - 1.0
    z = a[1] * math.sqrt(a[4])
    p = a[3] + d * z * (velocity - a[11]) if z > 0.0 else a[1] * (velocity - a[11]) ** 2
    if rules.traits[region, 2] > 0.0 and p <= 0.0:
        return math.nan
    low, high, last = -1e300, 1e300, 1e300
    size = max(abs(a[3]), a[1] * a[4], a[1] * (velocity - a[11]) ** 2)
    for _ in range(100):
        wave_to(rules, work, side, region, p)
        value = a[RISE] - d * (velocity - a[11])
        if value != value:
            return math.nan
        if value < 0.0:
            low = p
        else:
            high = p
        new = p - value / a[BY_P]
        if value == 0.0 or abs(new - p) <= 4e-16 * abs(p):
            return p
        if not (low < new < high):
            if not (high < 1e300 and low > -1e300):
                return math.nan
            new = 0.5 * (low + high)
        moved = abs(new - p)
        if moved <= 1e-16 * max(abs(p), 1e-3 * size) or (moved >= last and moved <= 1e-12 * max(abs(p), size)):
            return p
        last, p = moved, new
    return math.nan


@nb.njit(**GUARD)
def at_rest_with(work, f, u, p):
    """A front that moves with the material: nothing but momentum and work passes."""
    w = work.w
    w[SPEED, f], w[F_RHO, f], w[F_U, f], w[F_E, f], w[F_P, f] = u, 0.0, u, 0.0, p


@nb.njit(**GUARD)
def shock(work, front, f, d, p):
    """A shock that runs in the direction d: what is ahead passes it, and takes a new reference state."""
    w, side = work.w, 0 if d < 0 else 1
    s = work.io[side]
    if p > s[3]:
        speed, strength = s[11] + d * s[FLUX] / s[1], (p - s[3]) / max(abs(p), abs(s[3]), s[1] * s[4])
        rho, u, e, passing = s[1], s[11], s[2], s[3]
    else:       # it has become a release: the face goes on with the sound behind it, and is released
        rho, u, e, passing = s[RHO_B], s[11] + d * s[RISE], s[E_B], p
        speed, strength = u + d * s[FLUX] / rho, 0.0
    w[SPEED, f], w[F_RHO, f], w[F_U, f], w[F_E, f], w[F_P, f] = speed, rho, u, e + 0.5 * u * u, passing
    for k in range(3):
        w[INTO_LEFT + k, f] = w[INTO_RIGHT + k, f] = s[5 + k]
    behind = INTO_LEFT if d > 0 else INTO_RIGHT
    w[behind + 1, f], w[behind + 2, f] = s[VOLUME_B], s[ENERGY_B]
    front[STRENGTH] = strength


@nb.njit(**GUARD)
def edge(work, front, f):
    """Speed of the edge of a fan: u +- c, of the side outside the fan."""
    d, w = front[DIRECTION], work.w
    on_left = (d < 0) == (front[KIND] == HEAD)
    block, cell = (RIGHT, f - 1) if on_left else (LEFT, f)
    w[SPEED, f] = w[block + U, cell] + d * w[block + C, cell]


@nb.njit(**GUARD)
def between(rules, work, front, f, left, right):
    """A front between two materials; False where Python is asked."""
    take_side(rules, work, 0, left, RIGHT, f - 1)
    take_side(rules, work, 1, right, LEFT, f)
    d = front[DIRECTION]
    grip = math.inf if left == right else rules.traits[left, 1]
    if rules.traits[left, 2] > 0.0 or rules.traits[right, 2] > 0.0:
        grip = 0.0
    start = math.nan if d == 0.0 else work.io[0 if d > 0.0 else 1, 3]      # behind a shock the pressure is nearly that of the meeting
    p, u = meet(rules, work, left, right, d != 0.0 or grip > 0.0, start)
    if p != p or (d == 0.0 and grip > 0.0 and p < -grip):
        return False
    if d != 0.0:
        shock(work, front, f, d, p)
        return True
    a, b = work.io[0, RHO_B], work.io[1, RHO_B]
    at_rest_with(work, f, u, p)
    front[STRENGTH] = abs(a - b) / max(a, b, 1e-300)
    return True


@nb.njit(**GUARD)
def at_end(rules, work, front, f, region, on_left, kind, value):
    """The end of a body (on_left: the material's left end); False where Python is asked."""
    side, block, cell = (1, LEFT, f) if on_left else (0, RIGHT, f - 1)
    w, gas = work.w, rules.traits[region, 2] > 0.0
    front[STRENGTH] = 0.0
    if kind == OPEN:
        at_rest_with(work, f, w[block + U, cell], w[block + P, cell])
        return True
    if kind == VACUUM and gas:      # the edge of an expansion to nothing runs free of all forces
        at_rest_with(work, f, front[SPEED_OF], 0.0)
        return True
    take_side(rules, work, side, region, block, cell)
    if kind == WALL:
        p = press(rules, work, side, region, value)
        at_rest_with(work, f, value, p)
        return p == p
    p = value if kind == PRESSURE else 0.0
    if gas and p <= 0.0:
        return False
    wave_to(rules, work, side, region, p)
    u = work.io[side, 11] + (2.0 * side - 1.0) * work.io[side, RISE]
    at_rest_with(work, f, u, p)
    return u == u


@nb.njit(**GUARD)
def at_fronts(grid, rules, work, fronts, count, drives):
    """Speeds and states at all fronts, into the table; False where Python has to solve them. drives (2,): values of the ends."""
    n, w = len(grid.q), work.w
    for k in range(count):
        front = fronts[k]
        f = int(front[FACE])
        work.flags[0, k] = work.flags[1, k] = 0.0
        if not math.isnan(grid.given[f, 0]):
            continue
        if front[KIND] == HEAD or front[KIND] == HEAD + 1.0:
            edge(work, front, f)
            front[SPEED_OF] = w[SPEED, f]
            continue
        left = grid.region[f - 1] if f > 0 else -1
        right = grid.region[f] if f < n else -1
        if max(left, right) >= rules.numbers[UNBURNED]:
            return False
        if left >= 0 and right >= 0:
            done = between(rules, work, front, f, left, right)
        else:
            kind, value = VACUUM, 0.0
            if f == 0 or f == n:
                j = 0 if f == 0 else 1
                kind, value = int(rules.ends[j, 0]), drives[j]
            done = at_end(rules, work, front, f, max(left, right), right >= 0, kind, value)
        if not done:
            return False
        front[SPEED_OF] = w[SPEED, f]
        if front[DIRECTION] != 0.0 and front[STRENGTH] < 0.5 * rules.numbers[WEAKEST]:
            work.flags[0, k] = 1.0
    newborn(grid, work, n)
    for j in range(2):
        f, k = (0, 0) if j == 0 else (n, count - 1)
        if rules.ends[j, 0] == WALL and fronts[k, KIND] == END:      # a piston goes on as it is driven
            fronts[k, SPEED_OF] = w[SPEED, f] = w[F_U, f] = drives[j]
    return True


@nb.njit(**GUARD)
def newborn(grid, work, n):
    """The states of faces that were just born; a cell beside them that is not newborn keeps its own scalars."""
    w = work.w
    for f in range(n + 1):
        given = grid.given[f]
        if math.isnan(given[0]):
            continue
        w[SPEED, f], w[F_RHO, f], w[F_U, f], w[F_P, f] = given[0], given[1], given[2], given[4]
        w[F_E, f] = given[3] + 0.5 * given[2] ** 2
        for k in range(given.shape[0] - 5):
            w[INTO_LEFT + k, f] = w[INTO_RIGHT + k, f] = given[5 + k]
            if f > 0 and math.isnan(grid.push[f - 1]) and grid.region[f - 1] >= 0:
                w[INTO_LEFT + k, f] = w[RIGHT + LAM + k, f - 1]
            if f < n and math.isnan(grid.push[f]) and grid.region[f] >= 0:
                w[INTO_RIGHT + k, f] = w[LEFT + LAM + k, f]
