"""The exact Riemann problem of two states of the table, or of one and a wall, compiled; waves are asked of the laws by address.

What is rare (a gap that opens, an expansion to nothing, a search that fails) is answered by nan.
"""

import math

import numba as nb

from hugoniot.core.pass_lists import call_pass
from hugoniot.core.rows import row_at
from hugoniot.core.target import BY_ADDRESS, GUARD
from hugoniot.solvers.fronts.cells.tables import GAS, LAM, C, E, P, U

ROUNDING = 1e-13   # of a pressure or stiffness: a step of Newton's that small, and against the last ones, is rounding
AT_REST = 1e-11    # of the stiffness: tension of bodies side by side that rounding in their cells has made
SLOW = 0.5         # of the last step: where Newton's steps shrink no faster, they are rounding
RISE, BY_P, RHO_B, E_B, FLUX, VOLUME_B, ENERGY_B, LIMIT_P, LIMIT_RISE, LIMIT_RHO, LIMIT_E, LIMIT_FLUX = range(12, 24)


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
    """The waves of one side to a pressure: into io[RISE] and on."""
    work.io[side, 0] = p
    start = work.io.ctypes.data + 8 * side * work.io.shape[1]
    work.pointers[0], work.pointers[1] = start, start + 8 * RISE
    call_pass(rules.passes[region, 1], 1, 2, work.pointers, 0.0, row_at(rules.words[region]))


@nb.njit(**BY_ADDRESS)
def meet(rules, work, left, right, bonded, start):
    """(pressure, velocity) between two sides; nan where they part or are not found. start: a first guess, nan for the acoustic one."""
    a, b = work.io[0], work.io[1]
    za, zb = a[1] * math.sqrt(a[4]), b[1] * math.sqrt(b[4])
    closing, lowest = a[11] - b[11], min(a[3], b[3])
    acoustic = zb * a[3] + za * b[3] + za * zb * closing
    if not bonded and not (lowest >= 0.0 and (closing >= 0.0 or acoustic > 0.0)):
        if abs(acoustic) <= AT_REST * max(a[1] * a[4], b[1] * b[4]) * (za + zb):      # bodies at rest side by side: rounding parts nothing
            return 0.0, (za * a[11] + zb * b[11]) / (za + zb) if za + zb > 0.0 else math.nan
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
            if not (high < 1e300 and p < high):
                return math.nan, math.nan
            low, p, last = p, 0.5 * (p + high), 1e300      # a step of Newton's has left the law on release
            if not (low < p < high):
                return math.nan, math.nan
            continue
        if value < 0.0:
            low = p
        else:
            high = p
        new = p - value / slope
        noise = abs(new - p) <= ROUNDING * max(abs(p), size, scale) and not (low < new < high)
        if value == 0.0 or noise or abs(new - p) <= 4e-16 * abs(p):
            return p, 0.5 * (a[11] - a[RISE] + b[11] + b[RISE])
        if not (low < new < high):
            new = 0.5 * (low + high) if high < 1e300 and low > -1e300 else math.nan
            if new != new:
                return math.nan, math.nan
        moved = abs(new - p)
        if moved <= 1e-16 * max(abs(p), 1e-3 * size) or (moved >= SLOW * last and moved <= 1e-12 * max(abs(p), size, 1e-3 * scale)):
            return p, 0.5 * (a[11] - a[RISE] + b[11] + b[RISE])
        last, p = moved, new
    return math.nan, math.nan


@nb.njit(**BY_ADDRESS)
def press(rules, work, side, region, velocity):
    """Pressure on a wall of that velocity; nan where the material may leave it."""
    a, d = work.io[side], 2.0 * side - 1.0
    z = a[1] * math.sqrt(a[4])
    p = a[3] + d * z * (velocity - a[11]) if z > 0.0 else a[1] * (velocity - a[11]) ** 2
    if rules.traits[region, GAS] > 0.0 and p <= 0.0:
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
