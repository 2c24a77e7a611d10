"""Gauges of the two-dimensional hydrocode: what a material point, the mean over an edge and a line of sight record of a state."""

from typing import NamedTuple, cast

import numpy as np

from hugoniot.errors import OutOfRange
from hugoniot.mesh.locate import bilinear_weights, find_zone, linear_weights
from hugoniot.problem.plane.model import Gauge2D, Problem2D
from hugoniot.state import State2D

NODAL = ("position_x", "position_y", "velocity_x", "velocity_y")
OF_SURFACES = ("contact_pressure", "gap", "sliding_distance")      # of nodes, in runs in which bodies may meet; NaN inside
OF_LINES = ("line_position", "line_velocity")
OF_SIDES = ("normal_velocity",)
_KEPT_OUT = ("mass",)
NOTHING = (np.empty(0, dtype=int), np.empty(0), np.empty(0, dtype=int), np.empty(0))


def blocks_of(problem: Problem2D) -> list[int | None]:
    """Of every gauge the block whose zones it reads; None for one that reads two."""
    mesh = problem.mesh
    found: list[int | None] = []
    for gauge in problem.gauges:
        if gauge.kind == "point":
            found.append(int(mesh.block_of[_place(gauge, mesh)[0]]))
        else:
            found.append(mesh.chains[gauge.on].block if gauge.on in mesh.chains else None)
    return found


class Sampler:
    """Reads the gauges of a problem: `Sampler(problem)(state)` gives {field: (ngauge,)}, SI.

    Every gauge has the state's zone fields, and position and velocity. Lines of sight have `line_position` and `line_velocity` besides,
    sides and joints `normal_velocity`; these are NaN for other gauges. Means over an edge count the area at t = 0. What has left the mesh
    (`eroded`) counts no more: a mean is over what is left, and NaN where nothing is, as is a line of sight that meets nothing.

    normal_velocity   mean of the velocity along the normal of each edge as it is now, outward or from the first block of a joint to the
                      second, m/s: of a shell that closes evenly it is the speed at which it closes, where the mean vector is shorter
    """

    def __init__(self, problem: Problem2D):
        self.gauges, mesh = problem.gauges, problem.mesh
        self.points = {k: _point(gauge, mesh) for k, gauge in enumerate(self.gauges) if gauge.kind == "point"}
        self.sides = {k: _side(str(gauge.on), mesh) for k, gauge in enumerate(self.gauges) if gauge.kind == "edge"}
        self.slits = {k: mesh.chains[str(gauge.on)] for k, gauge in enumerate(self.gauges) if gauge.kind == "slit"}

    def __call__(self, state: State2D) -> dict[str, np.ndarray]:
        names = [name for name in state.zones if name not in _KEPT_OUT]
        gone = state.zones["eroded"] > 0.0 if "eroded" in state.zones else np.zeros(len(state.zone_nodes), dtype=bool)
        read = [self._read(k, state, gone) for k in range(len(self.gauges))]
        found = {}
        for name in (*state.nodes, *names):
            values = (state.nodes if name in state.nodes else state.zones)[name]
            place = 0 if name in state.nodes else 2
            found[name] = np.array([_mean(values, table[place : place + 2]) for table, _ in read])
        for names, kinds in ((OF_LINES, self.slits), (OF_SIDES, self.sides)):
            for n, name in enumerate(names if kinds else ()):
                found[name] = np.array([more[n] if k in kinds and more else np.nan for k, (_, more) in enumerate(read)])
        return found

    def _read(self, k: int, state: State2D, gone: np.ndarray) -> tuple[tuple, tuple]:
        """((nodes, weights, zones, weights) that gauge k reads, its OF_LINES or OF_SIDES); nothing where there is nothing to read."""
        if k in self.slits:
            return self._slit(k, state, gone)
        if k in self.points:
            return (NOTHING if gone[self.points[k][2]].any() else self.points[k]), ()
        side = self.sides[k].left(gone)
        if not len(side.edges):
            return NOTHING, ()
        x, y, u, v = (state.nodes[name][side.edges] for name in NODAL)
        along = x[:, 1] - x[:, 0], y[:, 1] - y[:, 0]
        through = side.facing * (u.mean(axis=1) * along[1] - v.mean(axis=1) * along[0])
        each = np.repeat(side.area / side.zones.shape[1], side.zones.shape[1])
        table = side.edges.ravel(), np.repeat(0.5 * side.area, 2), side.zones.ravel(), each
        return table, (float(side.area @ (through / np.maximum(np.hypot(*along), 1e-300))),)

    def _slit(self, k: int, state: State2D, gone: np.ndarray) -> tuple[tuple, tuple]:
        """What is read where the line meets its chain farthest along, and position and velocity there; nothing if nowhere."""
        gauge, chain = self.gauges[k], self.slits[k]
        x, y = (state.nodes[name][chain.edges] - start for name, start in zip(NODAL, gauge.at))
        u, v = (state.nodes[name][chain.edges] for name in NODAL[2:])
        a, b = cast(tuple, gauge.direction)      # a slit has one
        aside, along, drift, speed = a * y - b * x, a * x + b * y, a * v - b * u, a * u + b * v
        crossed = ((aside[:, 0] > 0.0) != (aside[:, 1] > 0.0)) & ~gone[chain.zones]
        if not crossed.any():
            return NOTHING, ()
        gap = np.where(crossed, aside[:, 0] - aside[:, 1], 1.0)
        share = aside[:, 0] / gap
        place = np.where(crossed, (1.0 - share) * along[:, 0] + share * along[:, 1], -np.inf)
        n = int(place.argmax())
        s, slide = share[n], (drift[n, 0] * (1.0 - share[n]) + drift[n, 1] * share[n]) / gap[n]
        velocity = (1.0 - s) * speed[n, 0] + s * speed[n, 1] + slide * (along[n, 1] - along[n, 0])
        table = chain.edges[n], np.array([1.0 - s, s]), chain.zones[n : n + 1], np.ones(1)
        return table, (float(place[n]), float(velocity))


class Side(NamedTuple):
    """Edges (n, 2) of a chain or joint, the zones (n, 1 or 2) beside each, each edge's part of the area at t = 0, and +1 where an edge,
    rotated clockwise, points away from its first zone, else -1."""

    edges: np.ndarray
    zones: np.ndarray
    area: np.ndarray
    facing: np.ndarray

    def left(self, gone: np.ndarray) -> "Side":
        """The edges whose zones are all in the mesh."""
        stays = ~gone[self.zones].any(axis=1)
        if stays.all():
            return self
        side = Side(*(values[stays] for values in self))
        return side._replace(area=_parts(side.area))


def _parts(area: np.ndarray) -> np.ndarray:
    return area / area.sum() if area.sum() > 0.0 else np.full(len(area), 1.0 / max(len(area), 1))


def _mean(values: np.ndarray, table: tuple) -> float:
    places, weights = table
    return float(values[places] @ weights) if len(places) else np.nan


def _place(gauge: Gauge2D, mesh) -> tuple[int, float, float]:
    """(zone, a, b) of a point gauge at t = 0, a and b its place in the zone. Raises OutOfRange where there is no material."""
    found = find_zone(mesh.nodes, mesh.zone_nodes, gauge.at)
    if found is None:
        raise OutOfRange(f"gauge '{gauge.name}': no material at {gauge.at} m at t = 0")
    return found


def _point(gauge: Gauge2D, mesh) -> tuple:
    """(nodes, weights, zones, weights) of a material point."""
    zone, a, b = _place(gauge, mesh)
    weights = linear_weights(a, b) if mesh.zone_nodes.shape[1] == 3 else bilinear_weights(a, b)
    return mesh.zone_nodes[zone], weights, np.array([zone]), np.ones(1)


def _side(name: str, mesh) -> Side:
    """A chain or joint at t = 0."""
    edges, zones = (mesh.chains[name].edges, mesh.chains[name].zones[:, None]) if name in mesh.chains else (
        mesh.joints[name].edges, mesh.joints[name].zones)
    (x, y), (zx, zy) = mesh.nodes[:, edges], mesh.nodes[:, mesh.zone_nodes[zones[:, 0]]].mean(axis=2)
    along = x[:, 1] - x[:, 0], y[:, 1] - y[:, 0]
    area = np.hypot(*along) * (x.mean(axis=1) if mesh.axisymmetric else 1.0)
    away = (x.mean(axis=1) - zx) * along[1] - (y.mean(axis=1) - zy) * along[0]
    return Side(edges, zones, _parts(area), np.where(away > 0.0, 1.0, -1.0))
