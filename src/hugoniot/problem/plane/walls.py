"""Walls that let go: a boundary of kind wall with `separable` is a rigid body at rest, which is met by contact and holds no tension."""

from dataclasses import replace

import numpy as np

from hugoniot.errors import OutOfRange
from hugoniot.problem.plane.contact_model import Rigid2D
from hugoniot.problem.plane.model import Problem2D

BEYOND = 3.0      # largest extents of the mesh by which such a wall goes on at both ends


def with_walls(problem: Problem2D) -> Problem2D:
    """The problem with its separable walls as rigid bodies, named like their chains; the same one where there are none."""
    walls = [name for boundary in problem.boundaries if boundary.separable for name in boundary.on]
    if not walls:
        return problem
    kept = tuple(boundary for boundary in problem.boundaries if not boundary.separable)
    found = replace(problem, boundaries=kept, rigid=(*problem.rigid, *(wall(problem, name) for name in walls)))
    found.__dict__["mesh"] = problem.mesh      # it is the same, and takes long to make
    return found


def wall(problem: Problem2D, name: str) -> Rigid2D:
    """The straight line through a chain, beyond its ends as far as material may come; about an axis it ends there."""
    mesh = problem.mesh
    normal = mesh.straight_normal(mesh.chains[name])
    if normal is None:
        raise OutOfRange(f"the boundary '{name}' is a wall, but it is not straight; divide the block so that each straight part "
                         "is a side of its own")
    middle = mesh.nodes[:, mesh.chains[name].nodes].mean(axis=1)
    along = np.array([-normal[1], normal[0]])
    reach = BEYOND * float(np.ptp(mesh.nodes, axis=1).max())
    ends = [middle + way * reach * along for way in (-1.0, 1.0)]
    if mesh.axisymmetric:
        ends = [end if end[0] >= 0.0 else middle + (end - middle) * (middle[0] / (middle[0] - end[0])) for end in ends]
    return Rigid2D(name, tuple((max(float(x), 0.0) if mesh.axisymmetric else float(x), float(y)) for x, y in ends))
