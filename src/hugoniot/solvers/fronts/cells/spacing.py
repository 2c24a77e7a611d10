r"""Where faces should stand between fronts: a coordinate eta counts cells, and faces stand at equal steps of it.

Cells have a region's own width as long as the region is now; in curved geometry they are no wider than SLOPE times their radius.
"""

import math

import numba as nb
import numpy as np

from hugoniot.core.target import BY_ADDRESS, GUARD

SLOPE = 0.05       # width over radius
FINEST = 1e-3      # of the region's width: where the slope ends
LEAST = 8          # cells of a region with fewer zones: one cell has a single velocity, and holds energy back when it expands
CENTRE = 6.0       # cells, at least, of an interval that reaches the axis or origin (when it is narrower than six cells)


@nb.njit(**GUARD)
def path_mean(a, b, d):
    """Mean of r^(d-1) over a path from a to b: exact volumes, and exact areas of faces that move at constant speed."""
    if d == 1:
        return 1.0
    return 0.5 * (a + b) if d == 2 else (a * a + a * b + b * b) / 3.0


@nb.njit(**GUARD)
def count(r, h, d):
    """eta(r): cells from the origin."""
    if d == 1:
        return r / h
    floor = FINEST * h
    near, far = floor / SLOPE, h / SLOPE
    if r <= near:
        return r / floor
    if r <= far:
        return (1.0 + math.log(r / near)) / SLOPE
    return (1.0 + math.log(far / near)) / SLOPE + (r - far) / h


@nb.njit(**GUARD)
def place(eta, h, d):
    """The radius of a count."""
    if d == 1:
        return eta * h
    floor = FINEST * h
    near, far = floor / SLOPE, h / SLOPE
    start, whole = 1.0 / SLOPE, (1.0 + math.log(far / near)) / SLOPE
    if eta <= start:
        return eta * floor
    return near * math.exp(eta * SLOPE - 1.0) if eta <= whole else far + (eta - whole) * h


@nb.njit(**BY_ADDRESS)
def central_count(r, start, h, d):
    """eta(r) in an interval that begins at `start`: one that reaches the axis or origin has even cells."""
    if d > 1 and start == 0.0:
        return r / max(min(h, r / CENTRE), FINEST * h)
    return count(r, h, d)


@nb.njit(**GUARD)
def widths(x, region, zones, sums, out, n):
    """Width (m) aimed at in every cell, before the radius is looked at; `sums` (regions,) is scratch."""
    regions = len(zones)
    sums[:] = 0.0
    for i in range(n):
        if region[i] >= 0:
            sums[region[i] % regions] += x[i + 1] - x[i]      # unburned explosive counts with its products
    for i in range(n):
        own = region[i] % regions
        out[i] = sums[own] / zones[own] if region[i] >= 0 else 1.0


@nb.njit(**GUARD)
def share_of(level):
    """How wide a cell is to be beside one that is not halved."""
    return 1.0 / (1 << level)


@nb.njit(**BY_ADDRESS)
def targets(marked, level, widths, at, out, n, d):
    """Where faces should stand, given where the fronts will be (`at` the marked faces); a cell has half the share of one a level lower."""
    first = 0
    for f in range(1, n + 1):
        if not marked[f]:
            continue
        cells, h = f - first, widths[first]
        a, b = at[first], at[f]
        central = d > 1 and a == 0.0
        low, high = (0.0, 0.0) if central or d == 1 else (count(a, h, d), count(b, h, d))
        out[first] = a
        whole = 0.0
        for i in range(first, f):
            whole += share_of(level[i])
        passed = 0.0
        for k in range(1, cells):
            passed += share_of(level[first + k - 1])
            share = passed / whole
            if d == 1:
                out[first + k] = a + share * (b - a)
            else:
                out[first + k] = share * b if central else place(low + share * (high - low), h, d)
        first = f
    out[n] = at[n]


@nb.njit(**GUARD)
def extent(a, b, start, end, h, d):
    """Cells of the width aimed at that one from a to b is wide, in an interval from `start` to `end`."""
    if d == 1:
        return (b - a) / h
    if start == 0.0:
        return (b - a) / max(end, 1e-300) * central_count(end, start, h, d)
    return count(b, h, d) - count(a, h, d)


@nb.njit(**GUARD)
def wanted(start, end, h, d):
    """Number of cells (a real number) an interval should have."""
    return (end - start) / h if d == 1 else central_count(end, start, h, d) - central_count(start, start, h, d)


def cells_of(problem) -> list[int]:
    """Cells aimed at in every region: its zones, or LEAST where it has fewer (or the mean zones of a region, where that is less)."""
    counts = [region.zones for region in problem.regions]
    least = min(LEAST, sum(counts) // len(counts))
    return [max(count, least) for count in counts]


class Spacing:
    """The mesh that is aimed at. zones (regions,): the cells of every region (`cells_of`)."""

    def __init__(self, d: int, zones: np.ndarray):
        self.d, self.zones = d, zones

    def widths(self, mesh) -> np.ndarray:
        """Width (m) aimed at in every cell, before the radius is looked at."""
        out = np.empty(len(mesh.q))
        widths(mesh.x, mesh.region, self.zones, np.empty(len(self.zones)), out, len(out))
        return out

    def wanted(self, mesh) -> list[float]:
        """Number of cells (a real number) each interval should have."""
        at, h = mesh.faces(), self.widths(mesh)
        if self.d == 1:
            return ((mesh.x[at[1:]] - mesh.x[at[:-1]]) / h[at[:-1]]).tolist()
        return [float(wanted(mesh.x[a], mesh.x[b], h[a], self.d)) for a, b in zip(at[:-1], at[1:])]

    def extents(self, mesh, first: int, count: int, h: float) -> np.ndarray:
        """Cells of the width aimed at that every cell of an interval is wide."""
        x = mesh.x[first:first + count + 1]
        if self.d == 1:
            return (x[1:] - x[:-1]) / h
        return np.array([extent(a, b, x[0], x[-1], h, self.d) for a, b in zip(x[:-1], x[1:])])
