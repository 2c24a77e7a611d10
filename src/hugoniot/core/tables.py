"""Interpolation in tables: bracketing on a grid, bilinear values with their slopes, and the inverse along one axis.

Plain arithmetic and comparisons only, so that a law may call these with floats, dual numbers or inside a kernel. Outside the grid the
nearest cell is extrapolated; nothing is clipped.
"""


def bracket(grid, x):
    """Index i of the cell with grid[i] <= x < grid[i + 1] (the first or last cell outside); `grid` increasing, 1-D."""
    low, length = 0, grid.shape[0] - 1
    # quarters first: their three comparisons do not wait for one another; written as a sum, the compiler makes no branches of them
    while length > 3:
        q = length // 4
        first, second, third = x >= grid[low + q], x >= grid[low + 2 * q], x >= grid[low + 3 * q]
        low += q * (int(first) + int(second) + int(third))
        length -= 3 * q
    while length > 1:
        half = length // 2
        low = low + half if x >= grid[low + half] else low
        length -= half
    return low


def bracket_blend(table, i, f, x):
    """Index j of the cell of x in the row (1 - f) table[i] + f table[i + 1], increasing in j."""
    low, length = 0, table.shape[1] - 1
    while length > 3:
        q = length // 4
        a, b, c = low + q, low + 2 * q, low + 3 * q
        first = x >= table[i, a] + f * (table[i + 1, a] - table[i, a])
        second = x >= table[i, b] + f * (table[i + 1, b] - table[i, b])
        third = x >= table[i, c] + f * (table[i + 1, c] - table[i, c])
        low += q * (int(first) + int(second) + int(third))
        length -= 3 * q
    while length > 1:
        half = length // 2
        k = low + half
        low = k if x >= table[i, k] + f * (table[i + 1, k] - table[i, k]) else low
        length -= half
    return low


def bilinear(table, i, j, f, g):
    """(value, slope by f, slope by g) in the cell (i, j) at the fractions f (first axis) and g (second axis)."""
    a, b, c, d = table[i, j], table[i + 1, j], table[i, j + 1], table[i + 1, j + 1]
    low, high = a + f * (b - a), c + f * (d - c)
    return low + g * (high - low), (b - a) + g * ((d - c) - (b - a)), high - low
