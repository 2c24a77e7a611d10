"""Zones in which a captured shock is still forming: those beside the faces at which it starts, where its stress overshoots.

A shock starts where bodies that move differently meet, at a driven end, and at a wall that a body is thrown against; and it starts again
where it enters another material. Until it has its own thickness the viscous stress is too high, by up to a third in the first zone.
"""

import numpy as np

from hugoniot.problem.plane.contact import may_meet
from hugoniot.problem.plane.model import velocity_at
from hugoniot.problem.profiles import end_velocities

START_UP = 12         # zones in which it forms
OVERSHOOT = 2.0       # times the highest of all others: more than a third above it was never seen in a shock that has left those zones
ALONG = 1e-9          # of its speed: what moves along a wall is not thrown against it
DRIVEN = ("velocity", "pressure")


def forming(problem) -> np.ndarray:
    """Whether a captured shock may still be forming in a zone (nzone,), of a `Problem` or `Problem2D` for a hydrocode."""
    return _of_blocks(problem) if problem.solver.kind == "lagrange2d" else _of_line(problem)


def settled(values: np.ndarray, form: np.ndarray) -> np.ndarray:
    """Values of zones (nzone,) with -inf where a shock is forming, or all where those have more than this can explain."""
    counted = np.where(form, -np.inf, values)
    return values if np.max(values) > OVERSHOOT * max(np.max(counted), 0.0) else counted


def _of_line(problem) -> np.ndarray:
    """Zones of the regions, from left to right; of a narrow region its middle third counts as formed."""
    regions, found = problem.regions, []
    for k, region in enumerate(regions):
        before, after = (regions[i] if 0 <= i < len(regions) else None for i in (k - 1, k + 1))
        few, zone = min(START_UP, region.zones // 3), np.arange(region.zones)
        found.append((zone < few) & _starts(region, before, problem.left)
                     | (zone >= region.zones - few) & _starts(region, after, problem.right))
    return np.concatenate(found)


def _starts(region, neighbour, end) -> bool:
    """Whether a shock may start at one end of a region, where a neighbour is, or the end of all."""
    return neighbour is not None or end.kind in DRIVEN or (end.kind == "fixed" and any(end_velocities(region)))


def _of_blocks(problem) -> np.ndarray:
    """Zones of the blocks, in layers from each side and joint at which a shock may start."""
    mesh, blocks, found = problem.mesh, problem.blocks, np.zeros(len(problem.mesh.block_of), dtype=bool)
    for joint in mesh.joints.values():
        one, other = (blocks[k] for k in joint.blocks)
        if one.material != other.material or one.velocity != other.velocity:
            for k, zones in zip(joint.blocks, joint.zones.T):
                found |= _layers(mesh, k, zones)
    starts = {"free": may_meet(problem), "velocity": True, "pressure": True}
    for name, boundary in problem.chain_boundaries().items():
        chain = mesh.chains[name]
        if starts.get(boundary.kind, boundary.kind == "wall" and _thrown(mesh, chain, blocks[chain.block].velocity)):
            found |= _layers(mesh, chain.block, chain.zones)
    return found


def _thrown(mesh, chain, motion) -> bool:
    """Whether a block that has the velocity field `motion` is thrown against what stands at one of its sides."""
    (x1, y1), (x2, y2) = mesh.nodes[:, chain.edges[:, 0]], mesh.nodes[:, chain.edges[:, 1]]
    u, v = velocity_at(motion, 0.5 * (x1 + x2), 0.5 * (y1 + y2))
    outward = chain.outward * (u * (y2 - y1) - v * (x2 - x1)) / np.hypot(x2 - x1, y2 - y1)
    return bool(np.any(outward > ALONG * np.hypot(u, v)))


def _layers(mesh, block: int, first) -> np.ndarray:
    """Zones of a block within START_UP layers from the zones `first`, or as many layers as are no more than a third of it."""
    mine, found = mesh.block_of == block, np.zeros(len(mesh.block_of), dtype=bool)
    layers = np.zeros_like(found)
    layers[first] = True
    for _ in range(START_UP):
        layers &= mine
        if 3 * np.count_nonzero(layers) > np.count_nonzero(mine):
            break
        found, touched = layers, np.zeros(mesh.nodes.shape[1], dtype=bool)
        touched[mesh.zone_nodes[found]] = True
        layers = touched[mesh.zone_nodes].any(axis=1)
    return found
