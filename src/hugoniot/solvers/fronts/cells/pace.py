"""How long a step may be, and how fast the faces go, compiled."""

import math

import numba as nb

from hugoniot.core.target import BY_ADDRESS
from hugoniot.solvers.fronts.cells.pores import is_porous
from hugoniot.solvers.fronts.cells.spacing import extent, share_of, targets, widths
from hugoniot.solvers.fronts.cells.tables import (
    AIM,
    COURANT,
    CROWDED,
    FACE,
    FULL,
    HEAD,
    KIND,
    KNOWN,
    LIMITING,
    MEAN,
    OWN,
    PACE,
    RESOLUTION,
    SPEED,
    SPEED_OF,
    TAIL,
    WIDTH,
    C,
    U,
)
from hugoniot.zones.burn import STEP_SHARE

SHIFT = 0.15       # of a cell: how far a step moves a face towards its place
SQUEEZE = 0.5      # of its width: how much a step may close a cell
AMPLE = 0.3        # of the width aimed at: cells no narrower set the step that is normal
CLOSE = 0.01       # of the normal step: a step that small means waves too close to each other to be followed
GROWS = 0.01       # growth per step of an interval that soon makes room for longer steps
SLOW_GROWS = 0.0006  # of a fan, which starts with many cells (births.py), and of crushed pores, whose shock hardly outruns them
LONGER = 1.3       # a step may be this much longer to end in a meeting


@nb.njit(**BY_ADDRESS)
def known_speeds(grid, work, fronts, count):
    """Speeds of all faces as far as known now: of fronts their last ones, of newborn faces their own, linear between."""
    w = work.w
    for k in range(count - 1):
        a, b = int(fronts[k, FACE]), int(fronts[k + 1, FACE])
        va, vb = fronts[k, SPEED_OF], fronts[k + 1, SPEED_OF]
        wide = grid.x[b] - grid.x[a]
        for f in range(a, b):
            w[KNOWN, f] = va + (vb - va) * ((grid.x[f] - grid.x[a]) / wide if wide > 0.0 else 0.0)
        w[KNOWN, b] = vb
    for f in range(len(grid.x)):
        if not math.isnan(grid.given[f, 0]):
            w[KNOWN, f] = grid.given[f, 0]


@nb.njit(**BY_ADDRESS)
def step_length(grid, rules, work, fronts, count, longest, d):
    """(length of the step, whether fronts are to meet in it)."""
    n, w, numbers = len(grid.q), work.w, work.numbers
    courant, newborn = rules.numbers[COURANT], False
    for i in range(n):
        h, a, b = grid.x[i + 1] - grid.x[i], w[KNOWN, i], w[KNOWN, i + 1]
        own = 1e300
        newborn = newborn or not math.isnan(grid.push[i])
        if w[FULL, i] > 0.0:
            u = w[MEAN + U, i]
            signal = w[MEAN + C, i] + max(abs(u - a), abs(u - b))
            own = courant * h / signal if signal > 0.0 else 1e300
            if a > b:
                own = min(own, SQUEEZE * h / (a - b))
            if w[PACE, i] > 0.0:
                own = min(own, STEP_SHARE / w[PACE, i])
                if w[MEAN + 3, i] > 0.05:
                    numbers[RESOLUTION] = min(numbers[RESOLUTION], w[MEAN + C, i] / (w[PACE, i] * h))
        w[OWN, i] = own
    dt, soonest, least = longest, 1e300, 0
    for k in range(count - 1):
        a, b = int(fronts[k, FACE]), int(fronts[k + 1, FACE])
        for i in range(a, b):
            if w[OWN, i] < w[OWN, least]:
                least = i
        closing, h = w[KNOWN, a] - w[KNOWN, b], grid.x[b] - grid.x[a]
        if b == a + 1 and closing > 0.0 and h > 0.0:
            soonest = min(soonest, h / closing)
            continue
        for i in range(a, b):
            dt = min(dt, w[OWN, i])
    limit = dt
    for k in range(count - 1):
        a, b = int(fronts[k, FACE]), int(fronts[k + 1, FACE])
        closing, h = w[KNOWN, a] - w[KNOWN, b], grid.x[b] - grid.x[a]
        if b == a + 1 and closing > 0.0 and h > 0.0 and h / closing > limit:
            dt = min(dt, w[OWN, a])
    numbers[LIMITING] = least
    widths(grid.x, grid.region, rules.traits[:, 0], work.sums, w[WIDTH], n)
    normal, crowd = longest, 0.0
    for k in range(count - 1):
        a, b = int(fronts[k, FACE]), int(fronts[k + 1, FACE])
        start, end = grid.x[a], grid.x[b]
        for i in range(a, b):
            if extent(grid.x[i], grid.x[i + 1], start, end, w[WIDTH, i], d) > AMPLE * share_of(grid.level[i]):
                normal = min(normal, w[OWN, i])
        if a <= least < b:
            fan = (fronts[k, KIND] == HEAD and fronts[k + 1, KIND] == TAIL) or (fronts[k, KIND] == TAIL and fronts[k + 1, KIND] == HEAD)
            slow = fan or is_porous(rules, grid.region[a])
            crowd = 1.0 if (w[KNOWN, b] - w[KNOWN, a]) * dt < (SLOW_GROWS if slow else GROWS) * (end - start) else 0.0
    numbers[CROWDED] = crowd if not newborn and dt < CLOSE * normal else 0.0
    return (soonest, True) if soonest <= dt else (dt, False)


@nb.njit(**BY_ADDRESS)
def face_speeds(grid, work, dt, d):
    """Speeds of all faces for the step: fronts as before, the others drawn gently to where they should be."""
    n, w, x = len(grid.q), work.w, grid.x
    for f in range(n + 1):
        w[SPEED, f] = x[f] + w[KNOWN, f] * dt
    targets(grid.marked, grid.level, w[WIDTH], w[SPEED], w[AIM], n, d)
    for f in range(n + 1):
        known = w[KNOWN, f]
        shift = 0.0
        if not grid.marked[f] and math.isnan(grid.given[f, 0]):
            near = SHIFT * min(x[f + 1] - x[f], x[f] - x[f - 1])
            shift = min(max(w[AIM, f] - (x[f] + known * dt), -near), near) / dt
        w[SPEED, f] = known + shift


@nb.njit(**BY_ADDRESS)
def meeting_time(grid, work, fronts, count, dt, longest):
    """The step with the speeds found: to a meeting of two fronts, if there is one in it or shortly after it."""
    soonest = 1e300
    for k in range(count - 1):
        a, b = int(fronts[k, FACE]), int(fronts[k + 1, FACE])
        closing, h = work.w[SPEED, a] - work.w[SPEED, b], grid.x[b] - grid.x[a]
        if b == a + 1 and closing > 0.0 and h > 0.0:
            soonest = min(soonest, h / closing)
    return soonest if soonest <= min(LONGER * dt, longest) or soonest < dt else dt
