r"""Between the fronts, compiled: states and their laws, half a step on, the states at faces, and what passes them.

Face states move half a step on with the flow equations (d = 1, 2, 3) and the reaction,

$$\rho_t = -u\rho_x - \rho\left(u_x + \tfrac{d-1}{r}u\right), \quad u_t = -uu_x - p_x/\rho, \quad
  e_t = -ue_x - \tfrac{p}{\rho}\left(u_x + \tfrac{d-1}{r}u\right), \quad \lambda_t = -u\lambda_x + \dot\lambda,$$

and with their own face (velocity w): $q + \tfrac12\Delta t\,(q_t + w q_x)$. The two states at a face meet in an HLLC problem, read
off at w. Where a mixture burns, in solids and where slopes leap, $p_x$ is the difference of the pressures (stresses) at both faces.

A solid has its stress for p, and its stretch z (laws.riemann.medium) obeys the equation of the density. A cell keeps the integral of
z, whose flux is that of the mass times $z/\rho$; after the step what lies beyond the yield surface returns to it. In curved geometry
$\dot z = -z(u_x - \tfrac{d-1}{2}u/r)$ along the flow, and the hoop stress, $\tfrac32 s_1 - Gh$ above the radial one, pushes on the sides
of a cell; in a cylinder $\dot h = u/r$ (solids.py).

Sources: van Leer, J. Comput. Phys. 32 (1979) 101 (MUSCL, Hancock's predictor); Toro, Riemann Solvers, 10.4 and 14.4.
"""

import math

import numba as nb

from hugoniot.core.pass_lists import call_pass
from hugoniot.core.rows import row_at
from hugoniot.core.target import BY_ADDRESS, GUARD
from hugoniot.solvers.fronts.cells.pores import is_porous
from hugoniot.solvers.fronts.cells.solids import hoop_excess, is_solid, settle, yielded
from hugoniot.solvers.fronts.cells.spacing import path_mean
from hugoniot.solvers.fronts.cells.tables import (
    BURNED,
    CENTRE,
    COLD,
    ELASTIC,
    F_E,
    F_P,
    F_RHO,
    F_U,
    FIRST,
    FROM,
    FULL,
    HIGH,
    HOOP,
    INTO_LEFT,
    INTO_RIGHT,
    KINKED,
    KINKS,
    LAM,
    LEFT,
    LOW,
    MEAN,
    MIDDLE,
    P_E,
    P_RHO,
    PACE,
    RHO,
    RIGHT,
    SPEED,
    STATE,
    VOLUME,
    C,
    E,
    P,
    U,
)


@nb.njit(**BY_ADDRESS)
def ask(rules, work, which, region, rows, first, count, dt):
    """Call a pass of a region on cells first to first + count - 1; `rows` are numbers of rows of the table (at most 8)."""
    w = work.w
    pitch = w.shape[1]
    base = w.ctypes.data
    for i in range(len(rows)):
        work.pointers[i] = base + 8 * (rows[i] * pitch + first)
    call_pass(rules.passes[region, which], count, len(rows), work.pointers, dt, row_at(rules.words[region]))


@nb.njit(**BY_ADDRESS)
def evaluate(grid, rules, work, n, block):
    """Pressures, slopes and sound speeds of a block of states; zero where there is no material, nan where a state is not sound."""
    w, a = work.w, 0
    while a < n:
        region, b = grid.region[a], a + 1
        while b < n and grid.region[b] == region and w[FULL, b] == w[FULL, a]:
            b += 1
        if region < 0 or w[FULL, a] == 0.0 or rules.passes[region, 0] == 0:
            for i in range(a, b):
                w[block + P, i] = w[block + P_RHO, i] = w[block + P_E, i] = w[block + C, i] = 0.0
        else:
            rows = (block + RHO, block + E, block + LAM, block + LAM + 1, block + LAM + 2, block + P, block + P_RHO, block + P_E)
            ask(rules, work, 0, region, rows, a, b - a, 0.0)
            for i in range(a, b):
                rho = max(w[block + RHO, i], 1e-150)
                square = w[block + P_RHO, i] + w[block + P, i] * w[block + P_E, i] / (rho * rho)
                if square < 0.0 and square > -COLD * w[block + U, i] ** 2:
                    square = 0.0
                w[block + C, i] = math.sqrt(square) if square >= 0.0 else math.nan
        a = b


@nb.njit(**BY_ADDRESS)
def close_pores(grid, rules, work, n):
    """The compaction of cells that keep their pores crushed, after the states that they are in."""
    w, a = work.w, 0
    while a < n:
        region, b = grid.region[a], a + 1
        while b < n and grid.region[b] == region and w[FULL, b] == w[FULL, a]:
            b += 1
        if w[FULL, a] > 0.0 and is_porous(rules, region):
            ask(rules, work, 3, region, (MEAN, MEAN + E, MEAN + P, MEAN + HOOP), a, b - a, 0.0)
            for i in range(a, b):
                grid.q[i, HOOP] = grid.q[i, 0] * w[MEAN + HOOP, i]
        a = b


@nb.njit(**GUARD)
def averages(grid, rules, work, n, d):
    """States of the cells; those of a gap, and of cells about to be born, are zero."""
    w, variables = work.w, grid.q.shape[1]
    for i in range(n):
        full = grid.region[i] >= 0 and math.isnan(grid.push[i])
        w[FULL, i] = 1.0 if full else 0.0
        for v in range(STATE):
            w[MEAN + v, i] = 0.0
        if full:
            mass = grid.q[i, 0]
            volume = (grid.x[i + 1] - grid.x[i]) * path_mean(grid.x[i], grid.x[i + 1], d)
            w[MEAN, i] = mass / volume
            for v in range(1, variables):
                w[MEAN + v, i] = grid.q[i, v] / mass
            if is_solid(rules, grid.region[i]):
                w[MEAN + VOLUME, i], w[MEAN + HOOP, i] = yielded(rules, grid.region[i], grid.q[i, VOLUME] / volume, w[MEAN + HOOP, i])
            w[MEAN + E, i] -= 0.5 * w[MEAN + U, i] ** 2
    evaluate(grid, rules, work, n, MEAN)
    close_pores(grid, rules, work, n)


@nb.njit(**BY_ADDRESS)
def unsound(grid, w, n):
    """The first cell without a sound state, or stretched so far that no wave runs in it; -1 if there is none."""
    for i in range(n):
        if w[FULL, i] > 0.0 and not (w[MEAN, i] > 0.0 and w[MEAN + C, i] >= 0.0 and abs(w[MEAN + P, i]) < 1e300
                                     and grid.x[i + 1] > grid.x[i] and (w[MEAN + P, i] >= 0.0 or w[MEAN + C, i] > 0.0)):
            return i
    return -1


@nb.njit(**BY_ADDRESS)
def each_burning(grid, rules, work, n, which, rows, dt):
    """Call a pass (burning or pace) on every run of cells whose material burns by a rate."""
    a = 0
    while a < n:
        region, b = grid.region[a], a + 1
        while b < n and grid.region[b] == region and work.w[FULL, b] == work.w[FULL, a]:
            b += 1
        if region >= 0 and work.w[FULL, a] > 0.0 and rules.passes[region, 2] != 0:
            ask(rules, work, which, region, rows, a, b - a, dt)
        a = b


@nb.njit(**BY_ADDRESS)
def predict(grid, rules, work, n, d, dt, burns):
    """States of every cell at its left and right face and in its middle half a step on, with their pressures."""
    w, variables, half = work.w, grid.q.shape[1], 0.5 * dt
    if burns:
        for i in range(n):
            w[BURNED, i] = w[MEAN + LAM, i]
        each_burning(grid, rules, work, n, 2, (MEAN + LAM, MEAN, MEAN + E, MEAN + LAM, MEAN + LAM + 1, MEAN + LAM + 2, BURNED), half)
    if burns or rules.numbers[ELASTIC] > 0.0 or rules.numbers[KINKED] > 0.0:
        evaluate(grid, rules, work, n, LOW)
        evaluate(grid, rules, work, n, HIGH)
    for i in range(n):
        full = w[FULL, i] > 0.0
        solid = full and is_solid(rules, grid.region[i])
        h = grid.x[i + 1] - grid.x[i] if full else 1.0
        rho, u, p = w[MEAN, i], w[MEAN + U, i], w[MEAN + P, i]
        r = w[CENTRE, i] + w[FIRST, i]                           # where a velocity that grows with r has its average
        round_ = u / r if d > 1 and full else 0.0                # rate of strain along a circle
        spread = (w[HIGH + U, i] - w[LOW + U, i]) / h + (d - 1) * round_
        pull = (d - 1) * hoop_excess(rules, grid.region[i], w[MEAN + VOLUME, i], w[MEAN + HOOP, i]) / (rho * r) if solid and d > 1 else 0.0
        p_x = (w[MEAN + P_RHO, i] * (w[HIGH, i] - w[LOW, i]) + w[MEAN + P_E, i] * (w[HIGH + E, i] - w[LOW + E, i])) / h
        if solid or (full and rules.traits[grid.region[i], KINKS] > 0.0) or (burns and full and rules.passes[grid.region[i], 2] != 0):
            by_faces = (w[HIGH + P, i] - w[LOW + P, i]) / h
            p_x = by_faces if abs(by_faces) < 1e300 else p_x
        for v in range(STATE):
            low, high = w[LOW + v, i], w[HIGH + v, i]
            slope = (high - low) / h
            rate = -u * slope
            if full and v == RHO:
                rate -= rho * spread
            elif full and v == U:
                rate += pull - p_x / rho
            elif full and v == E:
                rate -= p / rho * spread + pull * u
            elif solid and v == VOLUME:
                rate -= w[MEAN + v, i] * (spread - 1.5 * (d - 1) * round_)
            elif solid and v == HOOP and d == 2:
                rate += round_
            if v >= variables or not full:
                rate = 0.0
            gain, shift = half * rate, 0.25 * dt * (w[SPEED, i] + w[SPEED, i + 1]) * slope
            if burns and v == LAM:
                w[FROM, i] = w[MEAN + v, i] + gain + shift
                gain += w[BURNED, i] - w[MEAN + v, i]
            w[LEFT + v, i] = low + gain + half * w[SPEED, i] * slope
            w[RIGHT + v, i] = high + gain + half * w[SPEED, i + 1] * slope
            w[MIDDLE + v, i] = w[MEAN + v, i] + gain + shift
        if solid:
            for block in (LEFT, RIGHT, MIDDLE):
                w[block + VOLUME, i], w[block + HOOP, i] = yielded(rules, grid.region[i], w[block + VOLUME, i], w[block + HOOP, i])
    for block in (LEFT, RIGHT, MIDDLE):
        evaluate(grid, rules, work, n, block)
    for i in range(n):
        for block in (LEFT, RIGHT, MIDDLE):
            if not (w[block, i] > 0.0 and w[block + C, i] >= 0.0 and abs(w[block + P, i]) < 1e300):
                for row in range(10):      # a cell in which one of them is not sound keeps its average
                    w[LEFT + row, i] = w[RIGHT + row, i] = w[MIDDLE + row, i] = w[MEAN + row, i]
                break


@nb.njit(**BY_ADDRESS)
def move(grid, rules, work, n, d, dt, burns):
    """Move the faces, let the fluxes pass, burn; no cell is newborn any more."""
    w, variables = work.w, grid.q.shape[1]
    if burns:        # burning goes on from what the flow alone leaves in the middle of the step
        for i in range(n):
            w[BURNED, i] = w[FROM, i]
        each_burning(grid, rules, work, n, 2, (FROM, MIDDLE, MIDDLE + E, MIDDLE + LAM, MIDDLE + LAM + 1, MIDDLE + LAM + 2, BURNED), dt)
        for i in range(n):
            w[PACE, i] = grid.q[i, 0]
    for i in range(n):       # a cell that is being born has the stretch and hoop strain, or the compaction, of the exact solution
        if (is_solid(rules, grid.region[i]) or is_porous(rules, grid.region[i])) and not math.isnan(grid.push[i]):
            w[FROM, i], w[BURNED, i] = grid.q[i, VOLUME], grid.q[i, HOOP]
    before = 0.0
    for f in range(n + 1):
        speed = w[SPEED, f]
        place = grid.x[f] + speed * dt
        area = path_mean(grid.x[f], place, d)
        mass = w[F_RHO, f] * (w[F_U, f] - speed) * area * dt
        push = w[F_P, f] * area * dt
        for v in range(variables):
            if v == 0:
                out = into = mass
            elif v == 1:
                out = into = mass * w[F_U, f] + push
            elif v == 2:
                out = into = mass * w[F_E, f] + push * w[F_U, f]
            else:
                out, into = mass * w[INTO_LEFT + v - 3, f], mass * w[INTO_RIGHT + v - 3, f]
            if f > 0:
                grid.q[f - 1, v] -= out
            if f < n:
                grid.q[f, v] += into
            if f == 0:
                work.passed[0, v] += into
            if f == n:
                work.passed[1, v] -= out
        if d > 1 and f > 0:
            born = not math.isnan(grid.push[f - 1])
            p = grid.push[f - 1] if born else w[MIDDLE + P, f - 1]
            if is_solid(rules, grid.region[f - 1]):
                p += hoop_excess(rules, grid.region[f - 1], w[FROM if born else MIDDLE + VOLUME, f - 1],
                                 w[BURNED if born else MIDDLE + HOOP, f - 1])
            grid.q[f - 1, 1] += p * (area - before) * dt
        grid.x[f] = place
        before = area
    for i in range(n):
        if burns and w[FULL, i] > 0.0:
            lam = grid.q[i, 3] + 0.5 * (grid.q[i, 0] + w[PACE, i]) * (w[BURNED, i] - w[FROM, i])
            grid.q[i, 3] = min(max(lam, 0.0), grid.q[i, 0])
        if is_solid(rules, grid.region[i]):
            settle(grid, rules, w, i, d, dt)
        elif is_porous(rules, grid.region[i]) and not math.isnan(grid.push[i]):
            grid.q[i, HOOP] = grid.q[i, 0] * w[BURNED, i]
        grid.push[i] = math.nan
