"""Where fronts go and what passes them, compiled: the exact Riemann problem of the states on both sides, half a step on.

What is rare (a gap that opens, an expansion to nothing, a search that fails)
is left to Python, which has it all (tracked.py): the functions then answer nan.
"""

import math

import numba as nb

from hugoniot.core.target import BY_ADDRESS, GUARD
from hugoniot.solvers.fronts.cells.pores import is_porous
from hugoniot.solvers.fronts.cells.solids import is_solid
from hugoniot.solvers.fronts.cells.tables import (
    BORN_HOOP,
    BORN_LEFT,
    BORN_RIGHT,
    DIRECTION,
    ELASTIC,
    ELASTIC_EXPANSION,
    ELASTIC_SHOCK,
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
    SHEAR,
    SPEED,
    SPEED_OF,
    STRENGTH,
    UNBURNED,
    VACUUM,
    WALL,
    WEAKEST,
    C,
    P,
    U,
)
from hugoniot.solvers.fronts.cells.two_sides import (
    E_B,
    ENERGY_B,
    FLUX,
    LIMIT_E,
    LIMIT_FLUX,
    LIMIT_P,
    LIMIT_RHO,
    LIMIT_RISE,
    RHO_B,
    RISE,
    VOLUME_B,
    meet,
    press,
    take_side,
    wave_to,
)

ROOM = 4           # cells ahead of a plastic shock that an elastic one needs to leave it
DIVIDES = 0.1      # of the elastic range: an elastic wave that strong leaves a plastic shock as a front of its own
SAME = 1e-9        # of a stretch: what elastic strain changes less


@nb.njit(**BY_ADDRESS)
def at_rest_with(work, f, u, p):
    """A front that moves with the material: nothing but momentum and work passes."""
    w = work.w
    w[SPEED, f], w[F_RHO, f], w[F_U, f], w[F_E, f], w[F_P, f] = u, 0.0, u, 0.0, p


@nb.njit(**BY_ADDRESS)
def elastic_strain(s):
    """Whether a wave leaves the volume without stress as it is."""
    return abs(s[VOLUME_B] * s[1] - s[6] * s[RHO_B]) <= SAME * s[6] * s[RHO_B]


@nb.njit(**BY_ADDRESS)
def shock(rules, work, fronts, k, d, p, region):
    """A shock that runs in the direction d: what is ahead passes it, and takes a new reference state.

    In a solid a plastic shock passes what the elastic wave ahead of it leaves, an elastic shock what is ahead of both; where the followed
    shock is one and the waves are two, or the other way, the front is to be solved anew (flags).
    """
    w, side = work.w, 0 if d < 0 else 1
    s, front = work.io[side], fronts[k]
    f, elastic = int(front[FACE]), front[KIND] >= ELASTIC_SHOCK
    way = -1.0 if front[KIND] == ELASTIC_EXPANSION else 1.0
    if p > s[3] and s[LIMIT_FLUX] > 0.0 and not elastic:
        rho, u, e, passing = s[LIMIT_RHO], s[11] + d * s[LIMIT_RISE], s[LIMIT_E], s[LIMIT_P]
        soft = s[FLUX] ** 2 / rho if is_porous(rules, region) else s[1] * s[4]
        speed, strength = u + d * s[FLUX] / rho, (p - passing) / max(abs(p), abs(s[3]), soft)
        room = fronts[k + 1, FACE] - front[FACE] if d > 0.0 else front[FACE] - fronts[k - 1, FACE]
        split = room >= ROOM and (passing - s[3]) / (s[1] * s[4]) > DIVIDES * rules.numbers[ELASTIC]
        work.flags[1, k] = 1.0 if split else 0.0
    elif (p - s[3]) * way > 0.0 and s[LIMIT_FLUX] > 0.0:
        speed, strength = s[11] + d * s[LIMIT_FLUX] / s[1], way * (s[LIMIT_P] - s[3]) / (s[1] * s[4])
        rho, u, e, passing = s[1], s[11], s[2], s[3]
    elif way < 0.0 and p < s[3] and elastic_strain(s):
        speed, strength = s[11] + d * s[FLUX] / s[1], (s[3] - p) / (s[1] * s[4])
        rho, u, e, passing = s[1], s[11], s[2], s[3]
    elif p > s[3] and way > 0.0:
        soft = s[FLUX] ** 2 / s[1] if is_porous(rules, region) else s[1] * s[4]
        speed, strength = s[11] + d * s[FLUX] / s[1], (p - s[3]) / max(abs(p), abs(s[3]), soft)
        rho, u, e, passing = s[1], s[11], s[2], s[3]
    else:       # it has become a release: the face goes on with the sound behind it, and is released
        rho, u, e, passing = s[RHO_B], s[11] + d * s[RISE], s[E_B], p
        speed, strength = u + d * s[FLUX] / rho, 0.0
    w[SPEED, f], w[F_RHO, f], w[F_U, f], w[F_E, f], w[F_P, f] = speed, rho, u, e + 0.5 * u * u, passing
    for j in range(3):
        w[INTO_LEFT + j, f] = w[INTO_RIGHT + j, f] = s[5 + j]
    behind = INTO_LEFT if d > 0 else INTO_RIGHT
    w[behind + 1, f], w[behind + 2, f] = s[VOLUME_B], s[ENERGY_B]
    if rules.traits[region, SHEAR] > 0.0:       # elastic strain leaves the volume without stress as it is
        w[INTO_LEFT + 1, f] = w[INTO_RIGHT + 1, f] = s[6] / s[1]
        caught = elastic and strength > 0.0 and s[LIMIT_FLUX] == 0.0 and not elastic_strain(s)      # by the plastic wave
        if not elastic or caught:
            w[behind + 1, f] = s[VOLUME_B] / s[RHO_B]
        else:
            w[behind + 2, f] = s[7]
        if caught:
            work.flags[1, k] = 1.0
    elif elastic and is_porous(rules, region):       # a precursor closes no pores, unless the wave that does has caught up
        if strength > 0.0 and s[LIMIT_FLUX] == 0.0 and s[ENERGY_B] > s[7] + SAME:
            work.flags[1, k] = 1.0
        else:
            w[behind + 2, f] = s[7]
    front[STRENGTH] = strength


@nb.njit(**GUARD)
def edge(grid, rules, work, front, f):
    """Speed of the edge of a fan: u +- c, of the side outside the fan; in a solid c of plastic waves."""
    d, w = front[DIRECTION], work.w
    on_left = (d < 0) == (front[KIND] == HEAD)
    block, cell = (RIGHT, f - 1) if on_left else (LEFT, f)
    c, region = w[block + C, cell], grid.region[cell]
    if is_solid(rules, region):
        c = math.sqrt(max(c * c - rules.traits[region, SHEAR] / w[block, cell], 0.0))
    w[SPEED, f] = w[block + U, cell] + d * c


@nb.njit(**GUARD)
def between(rules, work, fronts, k, left, right):
    """A front between two materials; False where Python is asked."""
    front, f = fronts[k], int(fronts[k, FACE])
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
        shock(rules, work, fronts, k, d, p, right if d > 0.0 else left)
        return True
    a, b = work.io[0, RHO_B], work.io[1, RHO_B]
    at_rest_with(work, f, u, p)
    front[STRENGTH] = abs(a - b) / max(a, b, 1e-300)
    return True


@nb.njit(**BY_ADDRESS)
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


@nb.njit(**BY_ADDRESS)
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
            edge(grid, rules, work, front, f)
            front[SPEED_OF] = w[SPEED, f]
            continue
        left = grid.region[f - 1] if f > 0 else -1
        right = grid.region[f] if f < n else -1
        if max(left, right) >= rules.numbers[UNBURNED]:
            return False
        if left >= 0 and right >= 0:
            done = between(rules, work, fronts, k, left, right)
        else:
            kind, value = VACUUM, 0.0
            if f == 0 or f == n:
                j = 0 if f == 0 else 1
                kind, value = int(rules.ends[j, 0]), drives[j]
            if left < 0 and right < 0:      # a wall that the material has left
                at_rest_with(work, f, value, 0.0)
                front[STRENGTH], done = 0.0, True
            else:
                done = at_end(rules, work, front, f, max(left, right), right >= 0, kind, value)
        if not done:
            return False
        front[SPEED_OF] = w[SPEED, f]
        least = 0.5 * rules.numbers[WEAKEST]
        if front[KIND] >= ELASTIC_SHOCK:
            least *= rules.numbers[ELASTIC]
        if front[DIRECTION] != 0.0 and front[STRENGTH] < least:
            work.flags[0, k] = 1.0
    newborn(grid, rules, work, n)
    for j in range(2):
        f, k = (0, 0) if j == 0 else (n, count - 1)
        if rules.ends[j, 0] == WALL and fronts[k, KIND] == END:      # a piston goes on as it is driven
            fronts[k, SPEED_OF] = w[SPEED, f] = w[F_U, f] = drives[j]
    return True


@nb.njit(**GUARD)
def newborn(grid, rules, work, n):
    """The states of faces that were just born; a cell beside them that is not newborn keeps its own scalars; a solid gives its own away."""
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
                if k == 1 and is_solid(rules, grid.region[f - 1]):
                    w[INTO_LEFT + k, f] = given[BORN_LEFT] / given[1] if given[2] < given[0] else w[INTO_LEFT + k, f] / w[RIGHT, f - 1]
            elif k == 2 and f > 0 and is_solid(rules, grid.region[f - 1]):
                w[INTO_LEFT + k, f] = given[BORN_HOOP]
            if f < n and math.isnan(grid.push[f]) and grid.region[f] >= 0:
                w[INTO_RIGHT + k, f] = w[LEFT + LAM + k, f]
                if k == 1 and is_solid(rules, grid.region[f]):
                    w[INTO_RIGHT + k, f] = given[BORN_RIGHT] / given[1] if given[2] > given[0] else w[INTO_RIGHT + k, f] / w[LEFT, f]
            elif k == 2 and f < n and is_solid(rules, grid.region[f]):
                w[INTO_RIGHT + k, f] = given[BORN_HOOP]
