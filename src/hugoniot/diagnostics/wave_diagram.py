"""The x-t field: recorded zones resampled to an even raster of position and time, with holes where there is no material."""

from typing import NamedTuple

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view


class Raster(NamedTuple):
    """values (nt, nx), NaN in voids and outside the bodies; time (nt,) s and position (nx,) m of the points."""

    values: np.ndarray
    time: np.ndarray
    position: np.ndarray


def raster(time, left, right, field, size=(360, 640), window=None, follow: bool = True) -> Raster:
    """Resample a zone field.

    time (nt,) s; left, right (nt, nzone) m faces of the zones; field (nt, nzone); size (times, positions); faces and field may be any
    sequences of records, of which two at a time are held;
    window (lowest, highest) position in m, default all that the material ever occupies;
    follow   carry waves between two records along the direction in which they match best, so that a shock is a line and not
             a staircase; False: linear in time in each zone

    At the times of the records the field is the recorded one. Between them faces are linear in time.
    """
    time = np.asarray(time, dtype=float)
    low, high = window or extent(left, right)
    times = np.linspace(time[0], time[-1], size[0])
    x = low + (high - low) * (np.arange(size[1]) + 0.5) / size[1]
    image = np.full(size, np.nan)
    after = np.clip(np.searchsorted(time, times, side="right"), 1, max(len(time) - 1, 1))
    lowest, highest = extent(field, field)
    before = behind = _record(left, right, field, 0)
    first = last = shift = np.zeros(0, dtype=int)
    current = -1
    for row, (t, k) in enumerate(zip(times, after)):
        k, weight = (k, (t - time[k - 1]) / (time[k] - time[k - 1])) if len(time) > 1 else (0, 0.0)
        if k != current:
            before = behind if k == current + 1 else _record(left, right, field, k - 1)
            behind, current = _record(left, right, field, k), k
            first, last = _bodies(*behind[:2])
            count = len(first)
            shift = _best_shifts(before[2], behind[2], first, last, highest - lowest) if follow and k else np.zeros(count, dtype=int)
        face_left = (1 - weight) * before[0] + weight * behind[0]
        face_right = (1 - weight) * before[1] + weight * behind[1]
        zone = np.clip(np.searchsorted(face_left, x, side="right") - 1, 0, len(first) - 1)
        inside = (x >= face_left[zone]) & (x <= face_right[zone])
        way, start, end = 2 * shift[zone], first[zone], last[zone]
        origin = np.clip(zone - np.rint(way * weight).astype(int), start, end)
        aim = np.clip(zone + np.rint(way * (1 - weight)).astype(int), start, end)
        values = (1 - weight) * before[2][origin] + weight * behind[2][aim]
        if len(time) > 1:      # a zone is between what it was and what it will be, whatever looks alike elsewhere
            values = np.clip(values, *(bound(before[2], behind[2])[zone] for bound in (np.minimum, np.maximum)))
        image[row] = np.where(inside, values, np.nan)
    return Raster(image, times, x)


def _record(left, right, field, k: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    return np.asarray(left[k], float), np.asarray(right[k], float), np.asarray(field[k], float)


def extent(left, right) -> tuple[float, float]:
    """The least of all records of `left` and the largest of all of `right`."""
    return float(np.min([np.min(record) for record in left])), float(np.max([np.max(record) for record in right]))


def paths(records, zones) -> np.ndarray:
    """What the zones (n,) have in every record, (nt, n)."""
    return np.array([np.asarray(record)[zones] for record in records], dtype=float).reshape(len(records), len(zones))


def _bodies(left, right) -> tuple[np.ndarray, np.ndarray]:
    """First and last zone of the body that each zone belongs to, (nzone,) each, from the faces at one time."""
    least = 1e-6 * (right[-1] - left[0])
    starts = np.flatnonzero(np.append(True, left[1:] - right[:-1] > least))
    ends = np.append(starts[1:] - 1, len(left) - 1)
    lengths = ends - starts + 1
    return np.repeat(starts, lengths), np.repeat(ends, lengths)


def _best_shifts(a, b, first, last, spread: float) -> np.ndarray:
    """Half the number of zones by which the field around each zone moved from record `a` to record `b` (nzone,), body by body."""
    shift = np.zeros(len(a), dtype=int)
    for start, end in zip(np.unique(first), np.unique(last)):
        body = slice(start, end + 1)
        shift[body] = _shifts_in(a[body], b[body], spread, len(a))
    return shift


def _shifts_in(a, b, spread: float, of: int, window: int = 7) -> np.ndarray:
    """The shift m for which a[z - m] and b[z + m] agree best over a window, for each zone z of one body; small ones win where many agree.

    of    zones of the whole field: a picture needs no more places than it has points across, some 1200
    """
    count, step = len(a), -(-of // 1200)
    most, aside = min(40, of // (6 * step)), window // 2
    places = step * np.arange(-most - aside - 1, -(-count // step) + most + aside)
    # row m + most of the one holds a[z - m], of the other b[z + m]
    from_a, to_b = (sliding_window_view(x.take(places, mode="clip"), len(places) - 2 * most) for x in (a, b))
    sums = np.cumsum(np.abs(from_a[::-1] - to_b), axis=1)
    moves = np.arange(-most, most + 1)
    cost = sums[:, window:] - sums[:, :-window] + (2e-2 * window * spread / max(most, 1)) * np.abs(moves)[:, None]
    return np.repeat(step * moves[np.argmin(cost, axis=0)], step)[:count]


def gaps(left, right, least: float) -> list[int]:
    """Zones k behind which (between k and k+1) a gap wider than `least` (m) is open in any record; left, right (nt, nzone)."""
    wide = np.zeros(len(left[0]) - 1, dtype=bool)
    for before, behind in zip(left, right):
        wide |= before[1:] - behind[:-1] > least
    return [int(k) for k in np.flatnonzero(wide)]


def interfaces(region) -> list[int]:
    """Zones k that are the last of their region, from the region name of each zone (nzone,)."""
    region = list(region)
    return [k for k in range(len(region) - 1) if region[k] != region[k + 1]]
