r"""Shortest paths of a programmed burn in the plane: along straight lines where there is one, around inert obstacles where there is none.

In an explosive of one detonation velocity the front reaches a point along the shortest path that stays in the explosive. In a polygon
such a path is straight between its re-entrant corners,

$$t(x) = \min_k \left(t_k + \frac{|x - x_k|}{D}\right)\quad\text{over the sources and corners } k \text{ that see } x ,$$

so the times of the corners follow from those of the sources by Dijkstra's search over the corners that see each other, and those of all
other points from both. A smooth obstacle is the polygon of its nodes: its arc is shortened by a part (angle between nodes)^2 / 24.

In axisymmetric geometry a path stays in its half-plane (r, z), so the same search holds.

Source: Lozano-Perez and Wesley, Commun. ACM 22 (1979) 560 (visibility graph); Kenamond, LA-UR-11-03096, problem 3 (tangent, arc, tangent).
"""

import numpy as np

_ASIDE = 1e-6      # of an edge: how far the walls are moved out of the explosive, so that a path along a wall meets none
_CHUNK = 4_000_000   # pairs of path and wall looked at together


class Walls:
    """The outline of an explosive in the plane: edges with the explosive on their left, and its re-entrant corners.

    edges   (n, 2, 2): start and end of each edge, x and y, m; ends that meet must be equal bit for bit
    """

    def __init__(self, edges):
        edges = np.asarray(edges, dtype=float).reshape(-1, 2, 2)
        along = edges[:, 1] - edges[:, 0]
        length = np.hypot(along[:, 0], along[:, 1])
        normal = np.stack([along[:, 1], -along[:, 0]], axis=1) / length[:, None]      # out of the explosive
        corners, place = np.unique(edges.reshape(-1, 2), axis=0, return_inverse=True)
        place = place.reshape(-1, 2)
        shift = np.zeros_like(corners)
        step = np.zeros(len(corners))
        for end in (0, 1):
            np.add.at(shift, place[:, end], normal)
            np.maximum.at(step, place[:, end], length)
        size = np.hypot(shift[:, 0], shift[:, 1])
        aside = shift / np.where(size > 0.0, size, 1.0)[:, None] * (_ASIDE * step)[:, None]
        moved = corners + aside
        hiding = ~_on_hull(edges, corners)
        used, number = np.unique(place[hiding], return_inverse=True)
        self.ends, self.first, self.last = moved[used], number.reshape(-1, 2)[:, 0], number.reshape(-1, 2)[:, 1]
        into, out = np.zeros_like(corners), np.zeros_like(corners)
        into[place[:, 1]], out[place[:, 0]] = along / length[:, None], along / length[:, None]
        turn = into[:, 0] * out[:, 1] - into[:, 1] * out[:, 0]
        bent = turn < -1e-9          # the outline runs counter-clockwise about the explosive: a turn to the right is re-entrant
        self.corners, self.before, self.after = corners[bent], -into[bent], out[bent]

    def supports(self, points) -> np.ndarray:
        """Whether the line from each corner to each point (n, 2) leaves both walls of the corner on one side: (n, ncorner).

        Only along such a line does a shortest path bend around a corner.
        """
        along = points[:, None] - self.corners
        slack = _ASIDE * np.hypot(along[..., 0], along[..., 1])
        left, right = _cross(along, self.before), _cross(along, self.after)
        return ((left >= -slack) & (right >= -slack)) | ((left <= slack) & (right <= slack))

    def hide(self, a, b) -> np.ndarray:
        """Whether a wall crosses the straight path from a to b, each (n, 2)."""
        hidden = np.zeros(len(a), dtype=bool)
        if not len(self.first):       # a convex outline hides nothing
            return hidden
        for first in range(0, len(a), max(1, _CHUNK // len(self.first))):
            part = slice(first, first + max(1, _CHUNK // len(self.first)))
            hidden[part] = self._crossed(a[part], b[part])
        return hidden

    def _crossed(self, a, b) -> np.ndarray:
        along = b - a
        left = (along[:, :1] * (self.ends[:, 1] - a[:, 1:]) - along[:, 1:] * (self.ends[:, 0] - a[:, :1])) > 0.0
        path, wall = np.nonzero(left[:, self.first] != left[:, self.last])      # the wall's ends lie on both sides of the line a-b
        start, along = self.ends[self.first[wall]], self.ends[self.last[wall]] - self.ends[self.first[wall]]
        crossed = (_cross(along, a[path] - start) > 0.0) != (_cross(along, b[path] - start) > 0.0)
        return np.bincount(path[crossed], minlength=len(a)) > 0


def _on_hull(edges, corners) -> np.ndarray:
    """Which edges (n, 2, 2) lie on the convex hull of all corners: no path between two places of the explosive crosses those."""
    along = edges[:, 1] - edges[:, 0]
    slack = 1e-12 * np.hypot(along[:, 0], along[:, 1]) * float(np.ptp(corners, axis=0).max())
    return np.array([(_cross(u, corners - a) >= -s).all() for u, a, s in zip(along, edges[:, 0], slack)], dtype=bool)


def _cross(u, v):
    return u[..., 0] * v[..., 1] - u[..., 1] * v[..., 0]


def first_arrivals(points, walls: Walls, sources, times, detonation_velocity: float) -> np.ndarray:
    """Time at which the front reaches each point, s; inf where no path leads.

    points           (n, 2), m, in the explosive or on its outline
    sources, times   (m, 2) or (m, 2, 2), and (m,): where fronts start, at points or along straight lines (both ends), and when
    """
    points, times = np.asarray(points, float), np.asarray(times, float)
    sources = np.asarray(sources, float)
    sources = np.repeat(sources.reshape(-1, 1, 2), 2, axis=1) if sources.ndim < 3 else sources
    corners = _corner_times(walls, sources, times, detonation_velocity)
    lit = np.isfinite(corners)
    places = np.concatenate([sources, np.repeat(walls.corners[lit][:, None], 2, axis=1)])
    when = np.concatenate([times, corners[lit]])
    best = np.full(len(points), np.inf)
    rows = max(1, _CHUNK // max(1, len(places)))
    for first in range(0, len(points), rows):
        part = points[first : first + rows]
        usable = np.ones((len(part), len(places)), dtype=bool)
        usable[:, len(sources) :] = walls.supports(part)[:, lit]
        best[first : first + rows] = _earliest_seen(part, walls, places, when, detonation_velocity, usable)
    return best


def _earliest_seen(points, walls: Walls, places, when, speed: float, usable=None) -> np.ndarray:
    """Of every point the earliest arrival from a place that sees it: tried in order of arrival, the first that sees it counts.

    places   (nplace, 2, 2): both ends of each; of a line the point nearest to each point counts, from where the shortest path to it leaves
    usable   (npoint, nplace): which places to try; default all
    """
    start, along = places[:, 0], places[:, 1] - places[:, 0]
    share = ((points[:, None] - start) * along).sum(axis=2) / np.maximum((along**2).sum(axis=1), 1e-300)
    nearest = start + np.clip(share, 0.0, 1.0)[..., None] * along
    arrival = when + np.hypot(*(points[:, None] - nearest).transpose(2, 0, 1)) / speed
    if usable is not None:
        arrival[~usable] = np.inf
    best = np.full(len(points), np.inf)
    waiting = np.arange(len(points))
    while waiting.size and len(places):
        chosen = arrival[waiting].argmin(axis=1)
        first = arrival[waiting, chosen]
        seen = ~walls.hide(nearest[waiting, chosen], points[waiting])
        best[waiting[seen]] = first[seen]
        arrival[waiting, chosen] = np.inf
        waiting = waiting[~seen & np.isfinite(first)]
    return best


def _corner_times(walls: Walls, sources, times, speed: float) -> np.ndarray:
    """Arrival at the re-entrant corners, by Dijkstra's search."""
    corners = walls.corners
    best = _earliest_seen(corners, walls, sources, times, speed) if len(corners) and len(sources) else np.full(len(corners), np.inf)
    taut = walls.supports(corners) if len(corners) else np.zeros((0, 0), dtype=bool)
    taut &= taut.T
    done = np.zeros(len(corners), dtype=bool)
    while (open_ := ~done & np.isfinite(best)).any():
        k = int(np.where(open_, best, np.inf).argmin())
        done[k] = True
        reach = best[k] + np.hypot(*(corners - corners[k]).T) / speed
        nearer = np.flatnonzero(~done & taut[k] & (reach < best))
        seen = nearer[~walls.hide(np.broadcast_to(corners[k], (len(nearer), 2)), corners[nearer])]
        best[seen] = reach[seen]
    return best
