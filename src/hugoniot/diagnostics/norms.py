"""How far two records of one quantity lie apart: norms of the difference over the time both cover, and the shift in time."""

from typing import NamedTuple

import numpy as np

from hugoniot.diagnostics.arrival import first_crossing


class Difference(NamedTuple):
    """Difference b - a of two records.

    l1, l2, linf   mean absolute, root mean square and largest difference over the common time, in the quantity's unit
    scale          largest magnitude of either record there: what the norms are to be measured against
    shift          s, time in b less time in a of the first passage of one level, `time_shift`; NaN where either does not pass it
    start, end     s, the common time
    """

    l1: float
    l2: float
    linf: float
    scale: float
    shift: float
    start: float
    end: float

    @property
    def relative(self) -> tuple[float, float, float]:
        """(l1, l2, linf) over the scale; zero where both records are zero."""
        scale = self.scale or 1.0
        return self.l1 / scale, self.l2 / scale, self.linf / scale


def difference(time_a, a, time_b, b) -> Difference:
    """Norms of b - a, both taken as linear between their points and compared on the union of their times.

    time_a, a (n,); time_b, b (m,): s, increasing, and any unit. The integrals of the piecewise linear difference are
    exact for L2 and by trapezoid for L1. Raises ValueError if the records have no time in common.
    """
    time_a, a, time_b, b = (np.asarray(x, dtype=float) for x in (time_a, a, time_b, b))
    if not len(time_a) or not len(time_b) or max(time_a[0], time_b[0]) > min(time_a[-1], time_b[-1]):
        raise ValueError("the records have no time in common")
    start, end = max(time_a[0], time_b[0]), min(time_a[-1], time_b[-1])
    grid = np.union1d(time_a, time_b)
    grid = grid[(grid >= start) & (grid <= end)]
    on_a, on_b = np.interp(grid, time_a, a), np.interp(grid, time_b, b)
    d = on_b - on_a
    scale = float(max(np.max(np.abs(on_a)), np.max(np.abs(on_b))))
    shift = time_shift(time_a, a, time_b, b)
    if end == start:
        gap = float(abs(d[0]))
        return Difference(gap, gap, gap, scale, shift, float(start), float(end))
    step = np.diff(grid)
    l1 = float(np.sum(step * (np.abs(d[1:]) + np.abs(d[:-1])) / 2) / (end - start))
    square = float(np.sum(step * (d[1:] ** 2 + d[1:] * d[:-1] + d[:-1] ** 2) / 3) / (end - start))
    return Difference(l1, float(np.sqrt(square)), float(np.max(np.abs(d))), scale, shift, float(start), float(end))


def time_shift(time_a, a, time_b, b) -> float:
    """How much later b passes the level that a passes half-way through its largest change over the common time, s.

    One level for both records, so that it is the same wave in both where their amplitudes differ; half-way, where neither the thickness of
    a captured shock nor a weak precursor counts. It is that of the wave which brings the largest change, not of the first arrival. Nothing
    is shifted by it: the norms are those of the records as they are. NaN where b begins on the far side of that level, or never passes it.
    """
    common = (time_a >= max(time_a[0], time_b[0])) & (time_a <= min(time_a[-1], time_b[-1]))
    change = (a - a[0])[common]
    largest = change[np.argmax(np.abs(change))] if len(change) else 0.0
    level = a[0] + 0.5 * largest
    if largest == 0.0 or (b[0] - level) * largest >= 0.0:
        return float("nan")
    return float(first_crossing(time_b, b, level) - first_crossing(time_a, a, level))
