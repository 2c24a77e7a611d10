"""When the fronts of programmed burns reach the zones: from detonators, around inert obstacles, through explosives of several speeds.

Zones of one detonation velocity that hang together are one body; within it fronts take the shortest path (`laws.burn.paths`). A front
that comes to the border of another body starts there anew from every node of the border (Huygens), which lights the other body, and
perhaps this one again where the other is faster; this is repeated until nothing comes earlier. A zone is lit when the front reaches
the first of its nodes, as in one dimension it is when the front reaches its nearer face.
"""

from dataclasses import dataclass

import numpy as np

from hugoniot.errors import OutOfRange
from hugoniot.laws.burn.paths import Walls, first_arrivals
from hugoniot.mesh.blocks import Blocks
from hugoniot.mesh.locate import find_zone
from hugoniot.problem.explosives import front_speed

_NEAR = 1e-6       # of a body's size: a detonator this near its outline stands on it
_EARLIER = 1e-12   # of the time so far: what counts as earlier
_ON_A_LINE = 65    # points of a line of detonators, at which it is seen in which bodies it lies


@dataclass(frozen=True, eq=False)
class Body:
    """Blocks of one detonation velocity (m/s) that hang together, their zones, nodes and outline."""

    blocks: tuple[int, ...]
    speed: float
    zones: np.ndarray
    nodes: np.ndarray
    walls: Walls


def bodies(problem) -> list[Body]:
    """The bodies of a problem that burn by programme."""
    mesh: Blocks = problem.mesh
    speeds = [front_speed(problem, block) for block in problem.blocks]
    group = list(range(len(speeds)))
    for joint in mesh.joints.values():
        a, b = joint.blocks
        if speeds[a] == speeds[b] > 0.0:
            low, high = sorted((group[a], group[b]))
            group = [low if g == high else g for g in group]
    firsts = [first for first in sorted(set(group)) if speeds[first] > 0.0]
    return [_body(mesh, [k for k, g in enumerate(group) if g == first], speeds[first]) for first in firsts]


def _body(mesh: Blocks, members: list[int], speed: float) -> Body:
    zones = np.flatnonzero(np.isin(mesh.block_of, members))
    corners = mesh.zone_nodes[zones]
    sides = range(corners.shape[1])
    edges = np.concatenate([corners[:, [k, (k + 1) % len(sides)]] for k in sides])     # counter-clockwise: the explosive on the left
    ordered = np.sort(edges, axis=1)
    _, first, count = np.unique(ordered, axis=0, return_index=True, return_counts=True)
    outline = edges[first[count == 1]]
    return Body(tuple(members), speed, zones, np.unique(corners), Walls(mesh.nodes[:, outline].transpose(1, 2, 0)))


def node_lighting_times(problem) -> np.ndarray:
    """Time (nnode,) at which a front reaches each node, s; inf where none comes.

    Raises OutOfRange for a detonator that stands in no explosive, and for an explosive that no front reaches.
    """
    mesh, found = problem.mesh, bodies(problem)
    for body in unlit(problem, found):
        names = ", ".join(f"'{problem.blocks[k].name}'" for k in body.blocks)
        raise OutOfRange(f"no detonation front reaches {names}: add [[lighting]] there, or let it touch a lit explosive")
    times = np.full(mesh.nodes.shape[1], np.inf)
    sources = _started(problem, found)
    waiting = [k for k in range(len(found)) if sources[k]]
    borders = {(a, b): np.intersect1d(found[a].nodes, found[b].nodes) for a in range(len(found)) for b in range(len(found)) if a != b}
    while waiting:
        k = waiting.pop(0)
        body = found[k]
        entered = np.unique(np.concatenate([border for (a, _), border in borders.items() if a == k] or [np.empty(0, dtype=int)]))
        entered = entered[np.isfinite(times[entered])]
        places = [line for line, _ in sources[k]] + [np.array([place, place]) for place in mesh.nodes[:, entered].T]
        when = [time for _, time in sources[k]] + list(times[entered])
        arrival = first_arrivals(mesh.nodes[:, body.nodes].T, body.walls, places, when, body.speed)
        better = body.nodes[arrival < times[body.nodes] * (1.0 - _EARLIER)]
        times[body.nodes] = np.minimum(times[body.nodes], arrival)
        for (a, b), border in borders.items():
            if a == k and b not in waiting and np.isin(border, better).any():
                waiting.append(b)
    return times


def unlit(problem, found: list[Body]) -> list[Body]:
    """The bodies that no front reaches: neither a detonator stands in them, nor do they border on a body that is lit."""
    lit = {k for k, started in enumerate(_started(problem, found)) if started}
    grown = True
    while grown:
        new = {k for k, body in enumerate(found) if k not in lit and any(np.isin(body.nodes, found[a].nodes).any() for a in lit)}
        lit |= new
        grown = bool(new)
    return [body for k, body in enumerate(found) if k not in lit]


def zone_lighting_times(problem) -> np.ndarray:
    """Time (nzone,) at which a front reaches each zone, s; inf where nothing burns by programme. Raises as `node_lighting_times`."""
    times = np.full(len(problem.mesh.zone_nodes), np.inf)
    found = bodies(problem)
    if found:
        lit = node_lighting_times(problem)
        for body in found:
            times[body.zones] = lit[problem.mesh.zone_nodes[body.zones]].min(axis=1)
    return times


def _started(problem, found: list[Body]) -> list[list[tuple[np.ndarray, float]]]:
    """Of every body the detonators in it: (both ends of a line, which are one place for a point, time)."""
    started: list[list[tuple[np.ndarray, float]]] = [[] for _ in found]
    for point in problem.lighting:
        places = np.array([point.at]) if point.to is None else np.linspace(point.at, point.to, _ON_A_LINE)
        held = np.array([[holds(problem.mesh, body, place) for place in places] for body in found])
        for k, within in enumerate(held):
            edges = np.flatnonzero(np.diff(np.concatenate(([0], within, [0]))))      # the pieces of a line that lie in the body
            started[k] += [(places[[first, last - 1]], point.time) for first, last in zip(edges[::2], edges[1::2])]
        if not held.any():
            raise OutOfRange(f"the detonator at ({point.at[0]:g}, {point.at[1]:g}) m is not inside an explosive with a programmed burn")
    return started


def holds(mesh: Blocks, body: Body, place: np.ndarray) -> bool:
    """Whether a place lies in a body or on its outline."""
    if find_zone(mesh.nodes, mesh.zone_nodes[body.zones], place) is not None:
        return True
    low, high = mesh.nodes[:, body.nodes].min(axis=1), mesh.nodes[:, body.nodes].max(axis=1)
    near = _NEAR * float(np.hypot(*(high - low)))
    return bool((np.hypot(*(mesh.nodes[:, body.nodes] - place[:, None])) <= near).any())
