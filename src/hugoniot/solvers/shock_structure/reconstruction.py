"""Values and gradients at the faces of cells from averages over them: WENO-Z, its linear weights, and sixth-order gradients."""

import numba as nb

from hugoniot.core.target import INLINE

_TINY = 1e-40


@nb.njit(**INLINE)
def weno(a, b, c, d, e):
    """Fifth-order value at the right face of the cell with average c, from the averages of five cells in a row (WENO-Z)."""
    smooth0 = 13.0 / 12.0 * (a - 2.0 * b + c) ** 2 + 0.25 * (a - 4.0 * b + 3.0 * c) ** 2
    smooth1 = 13.0 / 12.0 * (b - 2.0 * c + d) ** 2 + 0.25 * (b - d) ** 2
    smooth2 = 13.0 / 12.0 * (c - 2.0 * d + e) ** 2 + 0.25 * (3.0 * c - 4.0 * d + e) ** 2
    scale = 1e-12 * (c * c) + _TINY   # below it, differences are round-off and the weights are the linear ones
    spread = (smooth0 - smooth2) ** 2
    w0 = 0.1 * (1.0 + spread / (smooth0 + scale) ** 2)
    w1 = 0.6 * (1.0 + spread / (smooth1 + scale) ** 2)
    w2 = 0.3 * (1.0 + spread / (smooth2 + scale) ** 2)
    value = w0 * (2.0 * a - 7.0 * b + 11.0 * c) + w1 * (5.0 * c - b + 2.0 * d) + w2 * (2.0 * c + 5.0 * d - e)
    return value / (6.0 * (w0 + w1 + w2))


@nb.njit(**INLINE)
def upwind(a, b, c, d, e):
    """The same with the linear weights."""
    return (2.0 * a - 13.0 * b + 47.0 * c + 27.0 * d - 3.0 * e) / 60.0


@nb.njit(**INLINE)
def slope(row, r, rough, h):
    """Gradient of a row of averages at the face left of cell r: sixth order, or of its two neighbours."""
    near = row[r] - row[r - 1]
    if rough:
        return near / h
    return (245.0 * near - 25.0 * (row[r + 1] - row[r - 2]) + 2.0 * (row[r + 2] - row[r - 3])) / (180.0 * h)


@nb.njit(**INLINE)
def sides(row, r, part):
    """Values left and right of the face left of cell r: linear, with `part` of the way to the nonlinear ones."""
    l3, l2, l1, r1, r2, r3 = row[r - 3], row[r - 2], row[r - 1], row[r], row[r + 1], row[r + 2]
    left, right = upwind(l3, l2, l1, r1, r2), upwind(r3, r2, r1, l1, l2)
    if part > 0.0:
        left += part * (weno(l3, l2, l1, r1, r2) - left)
        right += part * (weno(r3, r2, r1, l1, l2) - right)
    return left, right
