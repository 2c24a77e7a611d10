"""Faces on which bodies of the plane that touch collide or part at t = 0: waves start there at once."""

from typing import cast

import numpy as np

from hugoniot.mesh.joining import distance_to_edges
from hugoniot.problem.plane.model import Gauge2D, Problem2D, velocity_at

TOUCHING = 1e-6      # of an edge: what is farther away is not on it
ALIKE = 1e-9         # of the larger speed: a difference of velocities that is round-off


def struck_gauges(problem: Problem2D) -> list[str]:
    """Names of the gauges on a face at which two bodies that touch collide along its normal at t = 0, or part if they hold each other.

    Their records begin at the velocity of the impact, or between those of the bodies.
    """
    if len(problem.blocks) < 2 or not problem.gauges:
        return []
    faces = {name: edges for name, edges in _struck(problem).items() if len(edges)}
    return [gauge.name for gauge in problem.gauges if _sees(gauge, problem.mesh, faces)]


def _struck(problem: Problem2D) -> dict[str, np.ndarray]:
    """Edges (n, 2) of every joint and every free side at which two blocks collide, or part against what binds them."""
    mesh, found = problem.mesh, {}
    for name, joint in mesh.joints.items():
        found[name] = joint.edges[_closing(problem, joint.edges, *(np.full(len(joint.edges), k) for k in joint.blocks)) != 0.0]
    free = {name: mesh.chains[name] for name, boundary in problem.chain_boundaries().items() if boundary.kind == "free"}
    for name, chain in free.items():
        others = [other for other in free.values() if other.block != chain.block]
        if not others:
            continue
        edges, block = np.concatenate([c.edges for c in others]), np.concatenate([np.full(len(c.edges), c.block) for c in others])
        away, nearest = distance_to_edges(mesh.nodes[:, chain.edges].mean(axis=2), *np.moveaxis(mesh.nodes[:, edges], 2, 0))
        speed = chain.outward * _closing(problem, chain.edges, np.full(len(chain.edges), chain.block), block[nearest])
        bound = np.array([_bound(problem, chain.block, k) for k in range(len(problem.blocks))])[block[nearest]]
        found[name] = chain.edges[(away < TOUCHING) & ((speed > 0.0) | bound & (speed != 0.0))]
    return found


def _bound(problem: Problem2D, one: int, other: int) -> bool:
    """Whether two blocks that touch hold each other: others part without a wave."""
    pair = {problem.blocks[one].name, problem.blocks[other].name}
    own, every = ([law.kind for law in problem.contacts if wanted(law)] for wanted in (
        lambda law: law.between and set(law.between) == pair, lambda law: not law.between))
    return (own or every or ["sliding"])[0] != "sliding"


def _closing(problem: Problem2D, edges, one, other) -> np.ndarray:
    """Velocity of one block towards another, given for each edge, to the right of the edge as it runs, m/s; 0 for round-off."""
    (x1, y1), (x2, y2) = np.moveaxis(problem.mesh.nodes[:, edges], 2, 0)
    velocity = [velocity_at(block.velocity, 0.5 * (x1 + x2), 0.5 * (y1 + y2)) for block in problem.blocks]
    (u1, v1), (u2, v2) = (np.stack(velocity)[blocks, :, np.arange(len(edges))].T for blocks in (one, other))
    through = ((u1 - u2) * (y2 - y1) - (v1 - v2) * (x2 - x1)) / np.hypot(x2 - x1, y2 - y1)
    return np.where(np.abs(through) > ALIKE * np.maximum(np.hypot(u1, v1), np.hypot(u2, v2)), through, 0.0)


def _sees(gauge: Gauge2D, mesh, faces: dict[str, np.ndarray]) -> bool:
    """Whether a gauge is on an edge of these faces."""
    if gauge.kind == "point":
        place = np.array(gauge.at).reshape(2, 1)
        return any(distance_to_edges(place, *np.moveaxis(mesh.nodes[:, edges], 2, 0))[0][0] < TOUCHING for edges in faces.values())
    if gauge.on not in faces or gauge.kind == "edge":
        return gauge.on in faces
    edges = mesh.chains[gauge.on].edges
    # a line of sight, which has a direction
    (x, y), (a, b) = mesh.nodes[:, edges] - np.array(gauge.at).reshape(2, 1, 1), cast(tuple, gauge.direction)
    aside = a * y - b * x
    crossed = (aside[:, 0] > 0.0) != (aside[:, 1] > 0.0)
    farthest = np.where(crossed, (a * x + b * y).mean(axis=1), -np.inf).argmax()
    return bool(crossed.any() and (faces[gauge.on] == edges[farthest]).all(axis=1).any())
