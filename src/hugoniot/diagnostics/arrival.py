"""When a wave arrives: at one gauge, or at every zone of a recorded field."""

import numpy as np


def first_crossing(time, values, level: float) -> float:
    """First time at which a record passes `level` from the side it starts on, linear between points; NaN if it never does.

    time (n,) s, values (n,) and level in one unit.
    """
    values = np.asarray(values, dtype=float)
    passed = values >= level if values[0] < level else values <= level
    if values[0] == level or not passed.any():
        return float(time[0]) if values[0] == level else float("nan")
    k = int(np.argmax(passed))
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
