r"""Lighting times of programmed burns: when the front reaches a zone, from points and lines, in any geometry.

$$t_b = \min_k\left(t_k + \frac{d_k}{D}\right), \qquad d_k = \text{distance from detonator } k \text{ to the nearer face of the zone}$$

Source: Herrmann WL-TR-64-107 A.27, there for one point on the left; here for any number of points, on either side or inside. Straight
distances are correct as long as there is no obstacle between detonator and zone.
"""

import numpy as np

from hugoniot.errors import OutOfRange


def lighting_times(edges, detonators, detonation_velocity: float) -> np.ndarray:
    """Lighting time of each zone of a 1-D explosive, s.

    edges                 positions of the zone faces at t = 0, rising, m, shape (n + 1,); radii in cylinders and spheres
    detonators            pairs (position m, time s)
    detonation_velocity   m/s
    Raises OutOfRange without detonators, or for one outside the explosive.
    """
    edges = np.asarray(edges, float)
    if not detonation_velocity > 0.0:
        raise OutOfRange(f"the detonation velocity must be positive, got {detonation_velocity:.6g} m/s")
    if len(detonators) == 0:
        raise OutOfRange("a programmed burn needs a lighting point: give at least one (position, time)")
    low, high = edges[:-1], edges[1:]
    first = np.full(low.shape, np.inf)
    for position, time in detonators:
        if not edges[0] <= position <= edges[-1]:
            raise OutOfRange(f"the lighting point at {position:.6g} m lies outside the explosive, which extends from {edges[0]:.6g} "
                             f"to {edges[-1]:.6g} m: move it inside")
        distance = np.maximum(np.maximum(low - position, position - high), 0.0)
        first = np.minimum(first, time + distance / detonation_velocity)
    return first


def distance_to_segment(points, start, end) -> np.ndarray:
    """Distance of points (..., d) from the straight segment start-end (each of shape (d,)), m; a point where both ends coincide."""
    points, start, end = np.asarray(points, float), np.asarray(start, float), np.asarray(end, float)
    along = end - start
    length2 = float(along @ along)
    share = np.clip((points - start) @ along / length2, 0.0, 1.0) if length2 > 0.0 else np.zeros(points.shape[:-1])
    return np.linalg.norm(points - start - share[..., None] * along, axis=-1)


def lighting_times_of_points(points, detonators, detonation_velocity: float) -> np.ndarray:
    """Lighting time at points (..., d) from segments (start, end, time), each end of shape (d,), s; a point detonator has start = end."""
    if not detonation_velocity > 0.0:
        raise OutOfRange(f"the detonation velocity must be positive, got {detonation_velocity:.6g} m/s")
    if len(detonators) == 0:
        raise OutOfRange("a programmed burn needs a lighting point or line: give at least one")
    return np.min([time + distance_to_segment(points, start, end) / detonation_velocity for start, end, time in detonators], axis=0)
