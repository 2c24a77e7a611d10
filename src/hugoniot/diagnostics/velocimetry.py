r"""Free-surface velocity as an interferometer sees it, and what follows from it: pull-back, spall strength, spall thickness.

A velocity interferometer with delay $\tau$ and light of wavelength $\lambda$ counts fringes in proportion to the displacement x of the
surface over the delay, $F = 2\,[x(t) - x(t-\tau)] / \lambda$. This gives the velocity averaged over $[t-\tau, t]$, assigned to
$t - \tau/2$ (L. M. Barker, R. E. Hollenbach, J. Appl. Phys. 43 (1972) 4669).

The spall strength $\sigma$ follows from the pull-back $\Delta u$ of the free-surface velocity. Here $\rho_0$ is the initial density, $c_b$
the bulk sound speed and $c_l$ the longitudinal sound speed, both in the initial state. In the acoustic approximation

$$\sigma = \tfrac12\,\rho_0\,c_b\,\Delta u$$

(S. A. Novikov, I. I. Divnov, A. G. Ivanov, Phys. Met. Metall. 21 (1966) 608). In an elastic-plastic body the front of the spall pulse
runs at $c_l$ and overtakes the release, which runs at $c_b$. This lowers the observed pull-back:

$$\sigma = \rho_0\,c_l\,\Delta u\,\frac{1}{1 + c_l/c_b}$$

(V. I. Romanchenko, G. V. Stepanov, J. Appl. Mech. Tech. Phys. 21 (1980) 555). Over the distance h from the spall plane to the surface the
elastic front also erodes a short tension pulse. G. I. Kanel, J. Appl. Mech. Tech. Phys. 42 (2001) 358, therefore adds to the pull-back

$$\delta = \left(\frac{h}{c_b} - \frac{h}{c_l}\right)\frac{|\dot u_1|\,\dot u_2}{|\dot u_1| + \dot u_2}$$

with the slopes $\dot u_1$ and $\dot u_2$ of the record before and after its minimum. All of these formulas neglect the rate of fracture.
"""

from typing import NamedTuple

import numpy as np

QUARTILES = (0.25, 0.5, 0.75)
BANDS = (0.05, 0.02)     # of the height of a record, to both sides of it, in which a flat top is sought


class PullBack(NamedTuple):
    """The pull-back of a free-surface record: velocities in m/s and times in s.

    peak, peak_time         level before the drop (see `plateau`), and when it ends
    minimum, minimum_time   at the bottom of the drop
    rebound, rebound_time   highest value after the drop
    """

    peak: float
    peak_time: float
    minimum: float
    minimum_time: float
    rebound: float
    rebound_time: float

    @property
    def drop(self) -> float:
        """Pull-back velocity, m/s."""
        return self.peak - self.minimum


def visar_velocity(time, velocity, delay: float, start: float = 0.0):
    """The record that a VISAR shows of a surface velocity: (times, velocities).

    time       (n,) s, increasing
    velocity   (n,) m/s, of the surface
    delay      of the interferometer, s
    start      velocity of the surface before the record begins, m/s

    The velocities are means over the delay, at the times in its middle.
    """
    time, velocity = np.asarray(time, dtype=float), np.asarray(velocity, dtype=float)
    if delay <= 0.0:
        return time, velocity

    def displacement(t):
        k = np.clip(np.searchsorted(time, t, side="right") - 1, 0, len(time) - 2)
        step = np.clip(t - time[k], 0.0, time[k + 1] - time[k])
        slope = (velocity[k + 1] - velocity[k]) / (time[k + 1] - time[k])
        return whole[k] + velocity[k] * step + 0.5 * slope * step**2

    velocity = velocity - start
    whole = np.append(0.0, np.cumsum(np.diff(time) * (velocity[1:] + velocity[:-1]) / 2))
    return time - delay / 2, (displacement(time) - displacement(time - delay)) / delay + start


def fringes(time, velocity, delay: float, wavelength: float = 532e-9):
    """Fringe count of a VISAR, 2 delay u / wavelength, at the times of the record.

    time         (n,) s
    velocity     (n,) m/s, of the surface
    delay        of the interferometer, s
    wavelength   of the light, m
    """
    return 2.0 * delay / wavelength * visar_velocity(time, velocity, delay)[1]


def turning_points(values, least: float) -> list[int]:
    """Indices of successive maxima and minima that differ by more than `least` (in the unit of `values`), starting with a maximum."""
    points, rising, best = [], True, 0
    values = np.asarray(values, dtype=float)
    # swings end where a climb or a fall does: at the first of equal values, or at the end of the record
    changed = np.append(0, np.flatnonzero(np.diff(values)) + 1) if len(values) else np.zeros(0, dtype=int)
    ways = np.sign(np.diff(values[changed]))
    extremes = changed[np.append(np.append(True, ways[1:] != ways[:-1]), True)] if len(changed) > 1 else changed
    for k, value in zip(extremes.tolist(), values[extremes].tolist()):
        swing = values[best] - value if rising else value - values[best]
        if swing > least:
            points.append(best)
            rising, best = not rising, k
        elif swing < 0:
            best = k
    return points


def pull_back(time, velocity, least: float = 0.02, start: float = 0.0) -> PullBack | None:
    """The first pull-back of a free-surface record as a `PullBack`, or None if there is none.

    It is a drop from at least 0.8 of the highest rise above `start` that is followed by a rebound.

    time       (n,) s
    velocity   (n,) m/s
    least      smallest change that counts, as a fraction of the largest change from `start`, so that numerical ringing is ignored; the
               drop must be twice as large
    start      velocity of the surface before the first wave, m/s
    """
    # a body that moves as a whole shows the same waves as one at rest
    velocity = np.asarray(velocity, dtype=float) - start
    top, size = float(np.max(velocity, initial=0.0)), float(np.max(np.abs(velocity), initial=0.0))
    points = turning_points(velocity, least * size)
    for n in range(0, len(points) - 1, 2):
        high, low = points[n], points[n + 1]
        drop = velocity[high] - velocity[low]
        if velocity[high] < 0.8 * top or drop < 2 * least * size:
            continue
        # a flat top ends where the velocity last stood within a percent of it
        near = np.flatnonzero(velocity[: low + 1] >= velocity[high] - 0.01 * drop)
        last = points[n + 2] if n + 2 < len(points) else low + int(np.argmax(velocity[low:]))
        return PullBack(plateau(time[: low + 1], velocity[: low + 1]) + start, float(time[near[-1]]), float(velocity[low]) + start,
                        float(time[low]), float(velocity[last]) + start, float(time[last]))
    return None


def plateau(time, velocity) -> float:
    """Level of the flat top of a velocity record, m/s; the highest velocity if the top is not flat.

    time       (n,) s
    velocity   (n,) m/s
    """
    level = flat_top(time, velocity)
    return level if np.isfinite(level) else float(np.max(velocity))


def flat_top(time, values) -> float:
    """Level of the flat top of a record, without an overshoot at its front; NaN if the top is not flat.

    time     (n,) s
    values   (n,), of any quantity
    """
    return flat_stretch(durations(time), values)[1]


def durations(time) -> np.ndarray:
    """The time that each point of a record represents, s; time (n,) s."""
    time = np.asarray(time, dtype=float)
    return np.gradient(time) if len(time) > 1 else np.zeros(len(time))


def flat_stretch(weight, values) -> tuple[slice, float]:
    """(where a record is on its flat top for the first time, its level there as of `level_over`); empty and NaN if the top is not flat.

    weight (n,) s of `durations`, values (n,), n >= 1. The height of the record is what it exceeds for a twentieth of the time that it
    spends above half of its highest value. Of the stretches that last at least as long within 5 % of that height, it is the first that is
    flat: its quartiles over time differ by no more than 0.5 % of the height. If none is, the same within 2 %, which leaves out more of
    the slopes on both sides (of a rounded peak, a parabola, the quartiles then differ by 1 %). Fewer points than four have no quartiles:
    a single one, on the slope of a peak, would always be flat.
    """
    values = np.asarray(values, dtype=float)
    highest = float(np.max(values))
    if len(values) < 3 or not highest > 0.0:
        return slice(0, 0), float("nan")
    above = values >= 0.5 * highest
    height = float(_over_time(values[above], weight[above], [0.95])[0])
    least = 0.05 * np.sum(weight[above])
    for band in BANDS:
        near = np.concatenate([[False], np.abs(values - height) <= band * height, [False]])
        edges = np.flatnonzero(near[1:] != near[:-1])
        # none, where the height lies between the points of a coarse record
        stretches = [slice(int(i), int(k)) for i, k in zip(edges[::2], edges[1::2])]
        for part in stretches:
            if part.stop - part.start > len(QUARTILES) and np.sum(weight[part]) >= least:
                quartiles = _over_time(values[part], weight[part], QUARTILES)
                if np.isfinite(_level(quartiles, height)):
                    return part, _level(quartiles)
    return slice(0, 0), float("nan")


def level_over(weight, values, stretch: slice, scale: float | None = None) -> float:
    """Median over the time of a stretch of a record; NaN if it is empty or its quartiles differ by more than 0.5 % of `scale`.

    weight (n,) s of `durations`, values (n,); scale in the unit of the values, default the size of the median itself.
    """
    part = np.asarray(values, dtype=float)[stretch]
    if not len(part):
        return float("nan")
    return _level(_over_time(part, weight[stretch], QUARTILES), scale)


def _level(quartiles, scale: float | None = None) -> float:
    """The median, if the quartiles lie within 0.5 % of the scale (default: its size); else NaN."""
    low, middle, high = quartiles
    return float(middle) if high - low <= 0.005 * (abs(middle) if scale is None else scale) else float("nan")


def _over_time(values, weight, shares):
    """Values below which a record stays for these shares of its time."""
    order = np.argsort(values, kind="stable")
    ordered = weight[order]
    return np.interp(shares, (np.cumsum(ordered) - 0.5 * ordered) / np.sum(weight), values[order])


def ringing_period(time, velocity, after: float, least: float = 0.01, start: float = 0.0) -> float:
    """Period in s with which a spalled layer rings: the mean time between successive minima from a time on. NaN without two minima.

    Minima are sharp, while a maximum is a flat top on which a small ripple decides where it is highest.

    time       (n,) s
    velocity   (n,) m/s
    after      time of the first minimum, that of the pull-back, s
    least      smallest change that counts, as a fraction of the largest change from `start`
    start      velocity of the surface before the first wave, m/s
    """
    time, velocity = np.asarray(time, dtype=float), np.asarray(velocity, dtype=float) - start
    tail = time >= after
    if tail.sum() < 3:
        return float("nan")
    t, u = time[tail], velocity[tail]
    minima = [after, *t[turning_points(u, least * float(np.max(np.abs(velocity))))[1::2]]]
    return float(np.mean(np.diff(minima))) if len(minima) >= 2 else float("nan")


def spall_strength(drop: float, rho0: float, c_bulk: float, c_long: float | None = None) -> float:
    """Spall strength in Pa from the pull-back of the free-surface velocity.

    drop     pull-back velocity, m/s
    rho0     initial density, kg/m3
    c_bulk   bulk sound speed, m/s
    c_long   longitudinal sound speed, m/s; if it is given, the formula of Romanchenko and Stepanov replaces the acoustic one
    """
    if c_long is None:
        return 0.5 * rho0 * c_bulk * drop
    return rho0 * c_long * drop / (1.0 + c_long / c_bulk)


def kanel_correction(time, velocity, found: PullBack, thickness: float, c_bulk: float, c_long: float) -> float:
    """Kanel's correction of the pull-back velocity, m/s, to be added to it; 0 for a material without strength.

    time, velocity   (n,) s and (n,) m/s: the record
    found            its `PullBack`
    thickness        of the spalled layer, m
    c_bulk, c_long   bulk and longitudinal sound speed, m/s
    """
    return erosion(time, velocity, found, thickness / c_bulk - thickness / c_long)


def erosion(time, velocity, found: PullBack, lead: float) -> float:
    """Kanel's correction of the pull-back velocity, m/s, for an elastic front that gains the time `lead` (s) on the tension ahead of it.

    time, velocity   (n,) s and (n,) m/s: the record
    found            its `PullBack`

    The slopes of the record are taken between 20 and 50 % of the drop and of the rebound.
    """
    time, velocity = np.asarray(time, dtype=float), np.asarray(velocity, dtype=float)
    slopes = []
    for start, end in ((found.minimum_time, found.peak_time), (found.minimum_time, found.rebound_time)):
        height = (found.peak if end < start else found.rebound) - found.minimum
        inside = (time >= min(start, end)) & (time <= max(start, end))
        t, u = (time[inside], velocity[inside]) if end > start else (time[inside][::-1], velocity[inside][::-1])
        # the times at which the record last stood at 20 and first at 50 percent, going away from the minimum
        high = int(np.argmax(u >= found.minimum + 0.5 * height))
        low = int(np.flatnonzero(u[: high + 1] <= found.minimum + 0.2 * height)[-1])
        slopes.append(abs(u[high] - u[low]) / abs(t[high] - t[low]) if high > low else np.inf)
    down, up = slopes
    if not np.isfinite(down) and not np.isfinite(up):
        return 0.0
    mean = up if not np.isfinite(down) else down if not np.isfinite(up) else down * up / (down + up)
    return float(lead * mean)


def spall_thickness(period: float, c_long: float) -> float:
    """Thickness in m of a spalled layer that rings with this period (s), for the longitudinal sound speed c_long (m/s)."""
    return 0.5 * c_long * period
