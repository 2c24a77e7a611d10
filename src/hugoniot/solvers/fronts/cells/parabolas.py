r"""Parabolas in the cells between fronts: values at the faces from the averages of three cells, limited; no stencil crosses a front.

$\rho$, u, e and what goes with the mass are parabolas with the averages of three cells over their true volumes; beside a front the stencil
is one-sided. Increments to a face are limited by the differences to the neighbours, except where the curvature is about the same in
three cells.

Sources: van Leer, J. Comput. Phys. 32 (1979) 101; Colella and Woodward, J. Comput. Phys. 54 (1984) 174.
"""

import math

import numba as nb

from hugoniot.core.target import BY_ADDRESS, GUARD
from hugoniot.solvers.fronts.cells.tables import BOTH, CENTRE, CURVE, FIRST, FULL, HIGH, LOW, MEAN, SECOND, SLOPE, SMOOTH


@nb.njit(**BY_ADDRESS)
def moments(grid, w, n, d):
    """Middles of the cells, and the averages over their volumes of x - m and its square; which cells hold material and have neighbours."""
    for i in range(n):
        a, b = grid.x[i], grid.x[i + 1]
        m, h = 0.5 * (a + b), b - a
        first, second = 0.0, h * h / 12.0
        if d == 2:
            first = h * h / (12.0 * m)
        elif d == 3:
            volume = m * m + h * h / 12.0
            first, second = m * h * h / (6.0 * volume), (m * m * h * h / 12.0 + h**4 / 80.0) / volume
        w[CENTRE, i], w[FIRST, i], w[SECOND, i] = m, first, second
        full = grid.region[i] >= 0 and math.isnan(grid.push[i])
        w[FULL, i] = 1.0 if full else 0.0
        w[BOTH, i] = 1.0 if full and not grid.marked[i] and not grid.marked[i + 1] else 0.0


@nb.njit(**BY_ADDRESS)
def about(w, k, i):
    """Averages over cell i of (x - x_k) and its square, x_k the middle of cell k."""
    away = w[CENTRE, i] - w[CENTRE, k]
    return away + w[FIRST, i], away * away + 2.0 * away * w[FIRST, i] + w[SECOND, i]


@nb.njit(**BY_ADDRESS)
def bend(w, k, variables):
    """Slope and curvature (half the second derivative) in the middle of a cell with two neighbours."""
    one, two = about(w, k, k)
    right1, right2 = about(w, k, k + 1)
    left1, left2 = about(w, k, k - 1)
    a, b, c, e = right1 - one, right2 - two, left1 - one, left2 - two
    det = a * e - c * b
    for v in range(variables):
        up, down = w[MEAN + v, k + 1] - w[MEAN + v, k], w[MEAN + v, k - 1] - w[MEAN + v, k]
        w[SLOPE + v, k] = (up * e - down * b) / det
        w[CURVE + v, k] = (a * down - c * up) / det


@nb.njit(**BY_ADDRESS)
def smooth(w, k, v):
    """Whether the curvature is about the same in a cell and its neighbours: then an extremum is one of the flow, and kept."""
    own, lone = w[CURVE + v, k], True
    for j in (k - 1, k + 1):
        if w[BOTH, j] > 0.0:
            lone = False
            other = w[CURVE + v, j]
            alike = own * other > 0.0 and abs(other) < 3.0 * abs(own) and abs(own) < 3.0 * abs(other)
            if not alike:
                return 0.0
    return 0.0 if lone else 1.0


@nb.njit(**BY_ADDRESS)
def limited(value, way, up, down):
    """An increment to a face (way -1 left, 1 right) no larger than the differences to the neighbours, and of their sign."""
    if not up * down > 0.0:
        return 0.0
    sign = way if up > 0.0 else -way
    return sign * min(max(sign * value, 0.0), min(abs(up), abs(down)))


@nb.njit(**GUARD)
def reconstruct(grid, w, n, d, variables):
    """Values of every cell at its faces, into the blocks LOW and HIGH."""
    moments(grid, w, n, d)
    for k in range(n):
        if w[BOTH, k] > 0.0:
            bend(w, k, variables)
    for k in range(n):
        if w[BOTH, k] > 0.0:
            for v in range(variables):
                w[SMOOTH + v, k] = smooth(w, k, v)
    for i in range(n):
        full = w[FULL, i] > 0.0
        has_left, has_right = full and not grid.marked[i], full and not grid.marked[i + 1]
        k = i + 1 if has_right and not has_left else (i - 1 if has_left and not has_right else i)
        inside = w[BOTH, k] > 0.0
        one, two = about(w, k, i)
        for v in range(variables):
            mean = w[MEAN + v, i]
            if not (has_left or has_right):
                w[LOW + v, i] = w[HIGH + v, i] = mean
                continue
            up = w[MEAN + v, i + 1] - mean if has_right else 0.0
            down = mean - w[MEAN + v, i - 1] if has_left else up
            up = up if has_right else down
            keep = inside and w[SMOOTH + v, k] > 0.0
            for face in range(2):
                x, way = grid.x[i + face], 2.0 * face - 1.0
                if inside:
                    s = x - w[CENTRE, k]
                    value = w[SLOPE + v, k] * (s - one) + w[CURVE + v, k] * (s * s - two)
                else:       # an interval of two cells: a straight line
                    j = i + 1 if has_right else i - 1
                    gradient = (w[MEAN + v, j] - mean) / (w[CENTRE, j] + w[FIRST, j] - w[CENTRE, i] - w[FIRST, i])
                    value = gradient * (x - w[CENTRE, i] - w[FIRST, i])
                w[(HIGH if face else LOW) + v, i] = mean + (value if keep else limited(value, way, up, down))
