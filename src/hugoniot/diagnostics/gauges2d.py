"""Gauges of the two-dimensional hydrocode: what a material point, the mean over an edge and a line of sight record of a state."""

from typing import cast

import numpy as np

from hugoniot.errors import OutOfRange
from hugoniot.mesh.locate import bilinear_weights, find_zone, linear_weights
from hugoniot.problem.plane.model import Gauge2D, Problem2D
from hugoniot.state import State2D

NODAL = ("position_x", "position_y", "velocity_x", "velocity_y")
OF_SURFACES = ("contact_pressure", "gap", "sliding_distance")      # of nodes, in runs in which bodies may meet; NaN inside
OF_LINES = ("line_position", "line_velocity")
_KEPT_OUT = ("mass",)


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

    Every gauge has the state's zone fields, and position and velocity; lines of sight have `line_position` and `line_velocity` besides,
    which are NaN for other gauges. A line of sight that meets nothing gives NaN. Means over an edge count the area at t = 0.
    """

    def __init__(self, problem: Problem2D):
        self.gauges, mesh = problem.gauges, problem.mesh
        self.slits = [k for k, gauge in enumerate(self.gauges) if gauge.kind == "slit"]
        self.chains = {k: mesh.chains[str(self.gauges[k].on)] for k in self.slits}
        self.fixed = {k: _weights(gauge, mesh) for k, gauge in enumerate(self.gauges) if gauge.kind != "slit"}

    def __call__(self, state: State2D) -> dict[str, np.ndarray]:
        names = [name for name in state.zones if name not in _KEPT_OUT]
        lines = [self._slit(k, state) if k in self.chains else None for k in range(len(self.gauges))]
        read = [self.fixed[k] if line is None else line for k, line in enumerate(lines)]
        found = {}
        for name in (*state.nodes, *names):
            values = (state.nodes if name in state.nodes else state.zones)[name]
            place = 0 if name in state.nodes else 2
            found[name] = np.array([_mean(values, table[place : place + 2]) for table in read])
        if self.slits:
            for n, name in enumerate(OF_LINES):
                found[name] = np.array([np.nan if line is None or len(line) == 4 else line[4 + n] for line in lines])
        return found

    def _slit(self, k: int, state: State2D) -> tuple:
        """(nodes, weights, zones, weights, position, velocity) where the line meets its chain farthest along; nothing if nowhere."""
        gauge, chain = self.gauges[k], self.chains[k]
        x, y = (state.nodes[name][chain.edges] - start for name, start in zip(NODAL, gauge.at))
        u, v = (state.nodes[name][chain.edges] for name in NODAL[2:])
        a, b = cast(tuple, gauge.direction)      # a slit has one
        aside, along, drift, speed = a * y - b * x, a * x + b * y, a * v - b * u, a * u + b * v
        crossed = (aside[:, 0] > 0.0) != (aside[:, 1] > 0.0)
        if not crossed.any():
            nothing = np.empty(0, dtype=int), np.empty(0)
            return (*nothing, *nothing)
        gap = np.where(crossed, aside[:, 0] - aside[:, 1], 1.0)
        share = aside[:, 0] / gap
        place = np.where(crossed, (1.0 - share) * along[:, 0] + share * along[:, 1], -np.inf)
        n = int(place.argmax())
        s, slide = share[n], (drift[n, 0] * (1.0 - share[n]) + drift[n, 1] * share[n]) / gap[n]
        velocity = (1.0 - s) * speed[n, 0] + s * speed[n, 1] + slide * (along[n, 1] - along[n, 0])
        return chain.edges[n], np.array([1.0 - s, s]), chain.zones[n : n + 1], np.ones(1), float(place[n]), float(velocity)


def _mean(values: np.ndarray, table: tuple) -> float:
    places, weights = table
    return float(values[places] @ weights) if len(places) else np.nan


def _place(gauge: Gauge2D, mesh) -> tuple[int, float, float]:
    """(zone, a, b) of a point gauge at t = 0, a and b its place in the zone. Raises OutOfRange where there is no material."""
    found = find_zone(mesh.nodes, mesh.zone_nodes, gauge.at)
    if found is None:
        raise OutOfRange(f"gauge '{gauge.name}': no material at {gauge.at} m at t = 0")
    return found


def _weights(gauge: Gauge2D, mesh) -> tuple:
    """(nodes, weights, zones, weights) of a point or an edge."""
    if gauge.kind == "point":
        zone, a, b = _place(gauge, mesh)
        weights = linear_weights(a, b) if mesh.zone_nodes.shape[1] == 3 else bilinear_weights(a, b)
        return mesh.zone_nodes[zone], weights, np.array([zone]), np.ones(1)
    edges, zones = (mesh.chains[gauge.on].edges, mesh.chains[gauge.on].zones[:, None]) if gauge.on in mesh.chains else (
        mesh.joints[gauge.on].edges, mesh.joints[gauge.on].zones)
    ends = mesh.nodes[:, edges]
    area = np.hypot(*(ends[:, :, 1] - ends[:, :, 0]))
    if mesh.axisymmetric:
        area = area * ends[0].mean(axis=1)
    area = area / area.sum() if area.sum() > 0.0 else np.full(len(area), 1.0 / len(area))
    each = np.repeat(area[:, None] / zones.shape[1], zones.shape[1], axis=1)
    return edges.ravel(), np.repeat(0.5 * area, 2), zones.ravel(), each.ravel()
