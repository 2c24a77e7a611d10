"""When a wave arrives: at one gauge, or at every zone of a recorded field."""

from typing import NamedTuple

import numpy as np

SMALLEST_WAVE = 0.01     # of the record's largest change: a rise that ends below this is no wave
LEVELLED_OFF = 0.1       # of the steepest rate of a rise: below it the rise has ended
SLOWED = 0.5             # of the same: a rise that slows to less and then steepens by a fifth is two
STEEPENS = 1.2


class Wave(NamedTuple):
    """One rise of a record away from its first value.

    arrival       s, when it passes half of its height
    begin, end    s, when it passes a tenth and nine tenths of it
    level         the change from the record's first value that it reaches, in the unit of the record
    """

    arrival: float
    begin: float
    end: float
    level: float


def waves(time, values, most: int | None = None) -> list[Wave]:
    """The waves of a record, first to last, up to its largest change, or the first few of them (`most`); none if it never changes.

    time (n,) s, not decreasing; values (n,) in any unit. The first wave is the first rise, of either sign, that takes the record further
    than a hundredth of its largest change from its first value. It ends where its rate has fallen to a tenth of its steepest, or where
    it has fallen below half of it and grows again: there the next wave begins. The later ones rise in the direction of the first. A wave
    that still rises at half of its steepest rate or more when the record ends is left out: it is not known how high it goes.

    Half of the height is where a captured shock stands, however thick it is: the viscous profile is nearly symmetric about it.
    """
    time, change = np.asarray(time, dtype=float), np.asarray(values, dtype=float) - values[0]
    size = np.abs(change)
    largest = float(np.max(size, initial=0.0))
    if largest == 0.0:
        return []
    change = change * np.sign(change[np.argmax(size >= SMALLEST_WAVE * largest)])
    with np.errstate(divide="ignore", invalid="ignore"):
        rates = (change[1:] - change[:-1]) / (time[1:] - time[:-1])
    if not np.isfinite(rates).all():
        rates = np.nan_to_num(rates, nan=0.0)
    found, k, top = [], 0, int(np.argmax(change))
    while k < top and len(found) != most:
        low, (k, over) = k, _end_of_rise(change, rates, k, SMALLEST_WAVE * largest)
        if not over or change[k] - change[low] < SMALLEST_WAVE * largest:
            break
        heights = change[low] + np.array((0.1, 0.5, 0.9)) * (change[k] - change[low])
        begin, arrival, end = (first_crossing(time[low : k + 1], change[low : k + 1], height) for height in heights)
        found.append(Wave(arrival, begin, end, float(change[k])))
    return found


def _end_of_rise(change, rates, start: int, least: float) -> tuple[int, bool]:
    """Where the rise ends that takes `change` by `least` above its value at `start`, or the record does; whether the rise is over there."""
    # what comes before the first value that far above cannot end the rise: of it only the steepest rate and the slowest since count
    above = change[start:-1] - change[start] >= least
    first = start + int(np.argmax(above)) if above.any() else len(rates)
    before = rates[start:first]
    steepest, slowest, end = float(before.max(initial=0.0)), 0.0, start
    if first > start:
        since = before[np.argmax(before) if steepest > 0.0 else 0:][::-1]
        slowest, end = float(since.min()), first - 1 - int(np.argmin(since))
    for k, (rate, risen) in enumerate(zip(rates[first:], above[first - start:]), first):
        if risen:
            if rate <= LEVELLED_OFF * steepest:
                return k, True
            if slowest < SLOWED * steepest and rate > STEEPENS * slowest:
                return end, True
        if rate > steepest:
            steepest = slowest = rate
        if rate <= slowest:
            slowest, end = rate, k
    return len(rates), rates[-1] < SLOWED * steepest


def arrivals(time, values, *loads, position=None) -> tuple[float, float]:
    """Arrival of the first wave of a record, and of the second if it is the main wave behind a precursor, s; NaN for what is not there.

    time (n,) s; values (n,) in any unit; loads: records (n,) that grow where a wave compresses, as the stress does, or at a free surface
    the velocity out of the body, of which the first that changes at all is read; without any, all waves count as compression. The second
    arrival is given where both waves compress (a release may move the material on as far as the shock before it), the second is higher
    than the first, and the plateau between them lasts at least as long as either rise: the mesh has then separated the two. What rises as
    the record begins, as a face does at its own impact, is no precursor.

    position   (n,) m, of the material whose velocity the record is, m/s: it tells when between two samples a front came that is thinner
    """
    found = waves(time, values, 2)
    if not found:
        return float("nan"), float("nan")
    if position is not None:
        found = [wave._replace(arrival=_between(time, values, position, wave)) for wave in found]
    one, two = found[0], found[1] if len(found) > 1 else None
    rise = one.end - one.begin
    if two is None or one.begin - time[0] < rise or two.level < 2.0 * one.level or two.begin - one.end < max(rise, two.end - two.begin):
        return one.arrival, float("nan")
    reached = [0, *np.minimum(np.searchsorted(time, (one.end, two.end), side="right"), len(time) - 1)]
    steps = next((step for load in loads if (step := np.diff(np.asarray(load)[reached])).any()), np.empty(0))
    return one.arrival, two.arrival if (steps > 0.0).all() else float("nan")


def _between(time, velocity, position, wave: Wave) -> float:
    """When the velocity stepped, if it did so between two samples: by how far the material came meanwhile; else the arrival of the wave."""
    k = int(np.searchsorted(time, wave.arrival))
    if k == 0 or not time[k - 1] <= wave.begin < wave.end <= time[k]:
        return wave.arrival
    # position[k] - position[k - 1] is velocity[k - 1] up to the step and velocity[k] from then on
    late = (position[k] - position[k - 1] - velocity[k - 1] * (time[k] - time[k - 1])) / (velocity[k] - velocity[k - 1])
    return float(time[k] - np.clip(late, 0.0, time[k] - time[k - 1]))


def first_crossing(time, values, level: float) -> float:
    """First time at which a record passes `level` from the side it starts on, linear between points; NaN if it never does.

    time (n,) s, values (n,) and level in one unit.
    """
    values = np.asarray(values, dtype=float)
    if values[0] == level:
        return float(time[0])
    passed = values >= level if values[0] < level else values <= level
    k = int(passed.argmax())
    if not passed[k]:
        return float("nan")
    fraction = (level - values[k - 1]) / (values[k] - values[k - 1])
    return float(time[k - 1] + fraction * (time[k] - time[k - 1]))


def arrival_times(time, field, level: float) -> np.ndarray:
    """Time at which each zone's value first reaches `level` from below, linear between records; NaN where it never does.

    time (nt,) s, field (nt, nzone). A zone that starts at or above the level has the first time.
    """
    time, field = np.asarray(time, dtype=float), np.asarray(field, dtype=float)
    reached = field >= level
    k = np.argmax(reached, axis=0)
    zone = np.arange(field.shape[1])
    before = np.maximum(k - 1, 0)
    low, high = field[before, zone], field[k, zone]
    rise = np.where(high > low, high - low, 1.0)
    result = time[before] + np.where(k > 0, (level - low) / rise, 0.0) * (time[k] - time[before])
    return np.where(reached.any(axis=0), result, np.nan)


def steepest_times(time, field) -> np.ndarray:
    """Time of the steepest rise of each zone's value (middle of the interval between two records); NaN where it never rises.

    time (nt,) s with nt >= 2, field (nt, nzone).
    """
    time, field = np.asarray(time, dtype=float), np.asarray(field, dtype=float)
    rate = np.diff(field, axis=0) / np.diff(time)[:, None]
    k = np.argmax(rate, axis=0)
    return np.where(np.max(rate, axis=0) > 0, (time[k] + time[k + 1]) / 2, np.nan)


def front_speed(arrival, position) -> tuple[float, float]:
    """(speed m/s, largest misfit of arrival s) of the straight line through arrivals (n,) s at positions (n,) m; NaNs are left out."""
    arrival, position = np.asarray(arrival, dtype=float), np.asarray(position, dtype=float)
    good = np.isfinite(arrival)
    if good.sum() < 2:
        return float("nan"), float("nan")
    slope, origin = np.polyfit(position[good], arrival[good], 1)
    misfit = np.max(np.abs(origin + slope * position[good] - arrival[good]))
    return (float(1 / slope) if slope else float("inf")), float(misfit)
