r"""The march of the cells as one compiled loop; it comes back where a front is born, meets or ends, or the number of cells has to change.

One step is a numbered list:

1. averages, parabolas                                  2. the step: Courant, burning, meetings, the next event
3. speeds of all faces: fronts as before, cells evenly between them, drawn gently to where they should be
4. half a step on (Hancock); HLLC at plain faces, the exact Riemann problem at fronts; a meeting within the step ends it
5. contents by fluxes over exact areas of the moving faces, the pressure's part in curved geometry, reaction
6. what the ends exchange is booked

Conservation: one flux per face, and volumes that are those the faces swept. Momentum is conserved in planar geometry.
"""

import math

import numba as nb

from hugoniot.core.target import BY_ADDRESS, GUARD
from hugoniot.solvers.fronts.cells.exact import at_fronts
from hugoniot.solvers.fronts.cells.fans import forget, let_go
from hugoniot.solvers.fronts.cells.gas import averages, evaluate, move, predict, unsound
from hugoniot.solvers.fronts.cells.hllc import hllc
from hugoniot.solvers.fronts.cells.pace import face_speeds, known_speeds, meeting_time, step_length
from hugoniot.solvers.fronts.cells.parabolas import reconstruct
from hugoniot.solvers.fronts.cells.refining import paces, watch
from hugoniot.solvers.fronts.cells.solids import deviator_of, is_solid, yielded
from hugoniot.solvers.fronts.cells.spacing import extent, share_of, wanted
from hugoniot.solvers.fronts.cells.steepening import steep_cell
from hugoniot.solvers.fronts.cells.tables import (
    BURNS,
    CROWDED,
    CYCLE,
    DIMENSION,
    FACE,
    FEWER,
    HIGH,
    HOOP,
    LEAST,
    LENGTH,
    LIMITING,
    LINES,
    LOW,
    MEETS,
    MORE,
    MOST,
    OPEN,
    PENDING,
    SAMPLED,
    SLIVER,
    SPEED_OF,
    STALLED,
    STEP,
    STOP,
    STRENGTH,
    TIME,
    TOUCHING,
    UNRESOLVED,
    UPDATES,
    VOLUME,
    WIDTH,
    E,
    P,
    U,
)
from hugoniot.solvers.fronts.cells.zones import look_at_zones

LOOK = 5              # steps between looks for shocks that have formed
PATHS = 400           # lines into which the paths of fronts are cut over a run
SLOWEST = 1e-12       # of the stop time: a step shorter than this has no future
DONE, UNSOUND, ASK_PYTHON, CHANGE, STEEP, FULL_TRACE, REFINE = range(7)      # why the march comes back
SQUARE, CONSTANT, HALF_SINE, RAMP, EXPONENTIAL, TABLE, NONE = range(7)


@nb.njit(**GUARD)
def drive(end, times, values, t):
    """A driven quantity at a time; at a jump the value after it."""
    shape, amplitude, s, duration = end[1], end[2], t - end[3], end[4]
    if shape == NONE:
        return 0.0
    if shape == TABLE:
        k, last = 0, len(times) - 1
        while k < last and times[k + 1] <= t:
            k += 1
        if t <= times[0] or k == last:
            return values[0] if t <= times[0] else values[last]
        return values[k] + (values[k + 1] - values[k]) * (t - times[k]) / (times[k + 1] - times[k])
    if s < 0.0:
        return 0.0
    if shape == CONSTANT:
        return amplitude
    if shape == EXPONENTIAL:
        return amplitude * math.exp(-s / duration)
    if shape == RAMP:
        return amplitude * min(s / duration, 1.0)
    if s >= duration:
        return 0.0
    return amplitude * (math.sin(math.pi * s / duration) if shape == HALF_SINE else 1.0)


@nb.njit(**BY_ADDRESS)
def open_step(grid, rules, work, fronts, count, longest):
    """Items 1 to 4 but for the fronts: (length of the step, or nan; whether fronts are to meet in it)."""
    n, d = len(grid.q), int(rules.numbers[DIMENSION])
    w, burns = work.w, rules.numbers[BURNS] > 0.0
    averages(grid, rules, work, n, d)
    bad = unsound(grid, w, n)
    if bad >= 0:
        work.numbers[LIMITING] = bad
        return math.nan, False
    look_at_zones(grid, rules, work, n)
    let_go(grid, w, fronts, count)
    reconstruct(grid, w, n, d, grid.q.shape[1])
    if burns:
        paces(grid, rules, work, n)
        if work.numbers[CYCLE] % LOOK == 0.0:
            watch(grid, rules, work, fronts, count)
    known_speeds(grid, work, fronts, count)
    dt, meets = step_length(grid, rules, work, fronts, count, longest, d)
    face_speeds(grid, work, dt, d)
    predict(grid, rules, work, n, d, dt, burns)
    hllc(grid, rules, work, n)
    return dt, meets


@nb.njit(**GUARD)
def close_step(grid, rules, work, fronts, count, dt, longest, goal):
    """Items 4 (a meeting ends the step) to 6; moves the clock."""
    n, d, numbers = len(grid.q), int(rules.numbers[DIMENSION]), work.numbers
    dt = meeting_time(grid, work, fronts, count, dt, longest)
    move(grid, rules, work, n, d, dt, rules.numbers[BURNS] > 0.0)
    forget(grid, fronts, count)
    numbers[STEP] = dt
    left = goal - numbers[TIME] - dt
    numbers[TIME] = goal if left <= 1e-15 * goal else numbers[TIME] + dt
    numbers[CYCLE] += 1.0
    numbers[UPDATES] += n
    numbers[STALLED] = numbers[STALLED] + 1.0 if dt < SLOWEST * rules.numbers[STOP] else 0.0


@nb.njit(**GUARD)
def calls_for_change(grid, rules, work, fronts, count):
    """Whether fronts have met, are to be released or part, or an interval has too many or too few cells."""
    if work.numbers[CROWDED] > 0.0:
        return True
    d = int(rules.numbers[DIMENSION])
    for k in range(count):
        if work.flags[0, k] > 0.0 or work.flags[1, k] > 0.0:
            return True
    for k in range(count - 1):
        a, b = int(fronts[k, FACE]), int(fronts[k + 1, FACE])
        start, end, cells = grid.x[a], grid.x[b], b - a
        closed = cells == 1 and end - start <= TOUCHING * rules.numbers[LENGTH]
        if closed and (grid.region[a] >= 0 or fronts[k, SPEED_OF] >= fronts[k + 1, SPEED_OF]):      # a gap that opens has no width at first
            return True
        if grid.region[a] < 0:
            continue
        h = work.w[WIDTH, a]
        least = fronts[k, LEAST] if fronts[k, SPEED_OF] < fronts[k + 1, SPEED_OF] else 1.0
        want, smallest, whole, shares = wanted(start, end, h, d), 1e300, 0.0, 0.0
        for i in range(a, b):
            share = share_of(grid.level[i])
            size = extent(grid.x[i], grid.x[i + 1], start, end, h, d) / share
            smallest, whole, shares = min(smallest, size), whole + size, shares + share
        if cells > least and (shares > max(FEWER * want + 0.5, least) or smallest < SLIVER * whole / cells):
            return True
        if shares < MORE * want - 0.25:
            return True
    return False


@nb.njit(**BY_ADDRESS)
def newborn(grid):
    """Whether cells are about to be born."""
    count = 0
    for i in range(len(grid.push)):
        count += not math.isnan(grid.push[i])
    return count > 0


@nb.njit(**BY_ADDRESS)
def sample(grid, rules, work, fronts, count):
    """Put where the fronts are, and the states on both sides, into the trace."""
    w, n, at = work.w, len(grid.q), int(work.numbers[SAMPLED])
    for k in range(count):
        line, f = work.trace[at + k], int(fronts[k, FACE])
        line[0], line[1], line[2], line[3] = work.numbers[TIME], k, grid.x[f], fronts[k, STRENGTH]
        for side in range(2):
            cell, block = (f - 1, HIGH) if side == 0 else (f, LOW)
            outside = cell < 0 or cell >= n
            kind = rules.ends[0 if f == 0 else 1, 0]
            if outside and kind == OPEN:
                cell, block, outside = (f, LOW, False) if side == 0 else (f - 1, HIGH, False)
            line[4 + 5 * side:9 + 5 * side] = 0.0
            if not outside and grid.region[cell] >= 0:
                line[4 + 5 * side], line[5 + 5 * side], line[6 + 5 * side] = w[block, cell], w[block + U, cell], w[block + E, cell]
                line[7 + 5 * side] = w[block + P, cell]
                if is_solid(rules, grid.region[cell]):
                    stretch, _ = yielded(rules, grid.region[cell], w[block + VOLUME, cell], w[block + HOOP, cell])
                    line[8 + 5 * side] = deviator_of(rules, grid.region[cell], stretch)
    work.numbers[SAMPLED] += count


@nb.njit(**GUARD)
def march(grid, rules, work, fronts, count, goal, cycles):
    """Steps until `goal` (s) or so many cycles, or until something happens: why it came back."""
    numbers, drives = work.numbers, work.sums[-2:]
    while numbers[TIME] < goal and cycles > 0:
        now, longest = numbers[TIME], goal - numbers[TIME]
        dt, meets = open_step(grid, rules, work, fronts, count, longest)
        if dt != dt:
            return UNSOUND
        if now * PATHS >= (numbers[LINES] + 1.0) * rules.numbers[STOP] and not newborn(grid):
            if numbers[SAMPLED] + count > work.trace.shape[0]:
                return FULL_TRACE
            numbers[LINES] += 1.0
            evaluate(grid, rules, work, len(grid.q), LOW)
            evaluate(grid, rules, work, len(grid.q), HIGH)
            sample(grid, rules, work, fronts, count)
        for j in range(2):
            drives[j] = drive(rules.ends[j], rules.times[j], rules.values[j], now + 0.5 * dt)
        if not at_fronts(grid, rules, work, fronts, count, drives):
            numbers[PENDING] = dt
            numbers[MEETS] = 1.0 if meets else 0.0
            return ASK_PYTHON
        close_step(grid, rules, work, fronts, count, dt, longest if meets else dt, goal)
        cycles -= 1
        if calls_for_change(grid, rules, work, fronts, count):
            return CHANGE
        looks = numbers[CYCLE] % LOOK == 0.0 and count < rules.numbers[MOST] and not newborn(grid)
        if looks and steep_cell(grid, rules, work, fronts, count) >= 0:
            return STEEP
        if numbers[UNRESOLVED] > 0.0:
            return REFINE
    return DONE
