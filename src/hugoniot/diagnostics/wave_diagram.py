"""The x-t field: recorded zones resampled to an even raster of position and time, with holes where there is no material."""

from typing import NamedTuple

import numpy as np


class Raster(NamedTuple):
    """values (nt, nx), NaN in voids and outside the bodies; time (nt,) s and position (nx,) m of the points."""

    values: np.ndarray
    time: np.ndarray
    position: np.ndarray


def raster(time, left, right, field, size=(360, 640), window=None) -> Raster:
    """Resample a zone field.

    time (nt,) s; left, right (nt, nzone) m faces of the zones; field (nt, nzone); size (times, positions);
    window (lowest, highest) position in m, default all that the material ever occupies.
    Between two records faces and values are linear in time along each zone (the material carries them).
    """
    time, left, right, field = (np.asarray(x, dtype=float) for x in (time, left, right, field))
    low, high = window if window else (float(np.min(left)), float(np.max(right)))
    times = np.linspace(time[0], time[-1], size[0])
    x = low + (high - low) * (np.arange(size[1]) + 0.5) / size[1]
    image = np.full(size, np.nan)
    after = np.clip(np.searchsorted(time, times, side="right"), 1, max(len(time) - 1, 1))
    for row, (t, k) in enumerate(zip(times, after)):
        if len(time) == 1:
            k, weight = 0, 0.0
        else:
            weight = (t - time[k - 1]) / (time[k] - time[k - 1])
        face_left = (1 - weight) * left[k - 1] + weight * left[k]
        face_right = (1 - weight) * right[k - 1] + weight * right[k]
        values = (1 - weight) * field[k - 1] + weight * field[k]
        zone = np.clip(np.searchsorted(face_left, x, side="right") - 1, 0, len(values) - 1)
        inside = (x >= face_left[zone]) & (x <= face_right[zone])
        image[row] = np.where(inside, values[zone], np.nan)
    return Raster(image, times, x)


def gaps(left, right, least: float) -> list[int]:
    """Zones k behind which (between k and k+1) a gap wider than `least` (m) is open in any record; left, right (nt, nzone)."""
    wide = (np.asarray(left)[:, 1:] - np.asarray(right)[:, :-1]) > least
    return [int(k) for k in np.flatnonzero(wide.any(axis=0))]


def interfaces(region) -> list[int]:
    """Zones k that are the last of their region, from the region name of each zone (nzone,)."""
    region = list(region)
    return [k for k in range(len(region) - 1) if region[k] != region[k + 1]]
