"""What a standard problem in two dimensions consists of, and the measures its problems share."""

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.materials.material import Material
from hugoniot.mesh.shapes import Box, Sector
from hugoniot.problem.model import OutputOptions, Pulse
from hugoniot.problem.plane.model import Block2D, Boundary2D, Problem2D, Solver2D
from hugoniot.problem.standard.parts import Bar
from hugoniot.solvers.lagrange2d.assemble import N, Z
from hugoniot.solvers.lagrange2d.solver import Lagrange2D
from hugoniot.solvers.lagrange2d.zone_shapes import areas as zone_areas

QUARTER = (0.0, 0.5 * np.pi)
HOLE = 0.005           # radius of the hole of a polar mesh, in units of its outer radius


class PlaneProblem(NamedTuple):
    """A problem in two dimensions with a known answer.

    start      (zones, options of the solver) -> a solver at t = 0
    stop       when it is measured
    measure    solver at the stop time -> {measure: value}
    bars       numbers to beat
    zones      grids: zones along the first direction; of `noh_ring` and the like what its description says
    before_step   solver -> None, called before every step: what the problem asks for and the solver does not have
    """

    name: str
    description: str
    start: Callable[[int, Mapping[str, Any]], Lagrange2D]
    stop: float
    measure: Callable[[Lagrange2D], dict[str, float]]
    bars: tuple[Bar, ...]
    zones: tuple[int, ...]
    before_step: Callable[[Lagrange2D], None] | None = None


# -- building -----------------------------------------------------------------------------------------------------------
def gas(gamma: float, name: str = "gas") -> Material:
    """A dimensionless ideal gas."""
    return Material(name, IdealGas(gamma, 1.0, 1.0))


def box(zones, x, y, name="b", material="gas", **state) -> Block2D:
    """A rectangle of `zones` (ni, nj) from x[0] to x[1] and y[0] to y[1]."""
    return Block2D(name, material, Box(tuple(x), tuple(y)), tuple(zones), **state)


def quarter_ring(zones, radii, name="b", material="gas", **state) -> Block2D:
    """A quarter of a ring or of a sphere."""
    return Block2D(name, material, Sector((0.0, 0.0), tuple(radii), QUARTER), tuple(zones), **state)


def walls(*names: str) -> tuple[Boundary2D, ...]:
    """Rigid frictionless walls."""
    return tuple(Boundary2D((name,), "wall") for name in names)


def still(name: str) -> Boundary2D:
    """Edges that stay where they are."""
    return Boundary2D((name,), "velocity", Pulse("constant", 0.0), slip=False)


def solver_of(title: str, geometry: str, stop: float, blocks, materials, boundaries, asked: Mapping[str, Any], **more) -> Lagrange2D:
    """A solver at t = 0; `asked` are options of `Solver2D` that go before the problem's own in `more`.

    `sampler` and `interval` in `more`: what is read of a state, and how often (s).
    """
    sampler, output = more.pop("sampler", None), OutputOptions(report=False, gauge_interval=more.pop("interval", 0.0))
    blocks = blocks if isinstance(blocks, (list, tuple)) else (blocks,)
    names = {material.name: material for material in materials}
    options = replace(Solver2D(), **{**more, **asked})
    return Lagrange2D(Problem2D(title, geometry, stop, tuple(blocks), names, tuple(boundaries), solver=options,
                                output=output), sampler)


# -- measuring ------------------------------------------------------------------------------------------------------------
def at_corners(solver: Lagrange2D, row: int) -> np.ndarray:
    """A row of nodes at the corners of every zone, (4, zones), or (3, zones) of triangles."""
    return solver.nodes[row, solver.numbering.representative][solver.problem.mesh.zone_nodes.T]


def areas(solver: Lagrange2D) -> np.ndarray:
    """Area of every zone, m2."""
    return zone_areas(at_corners(solver, N.x), at_corners(solver, N.y))


def centres(solver: Lagrange2D) -> tuple[np.ndarray, np.ndarray]:
    """Mean position of the corners of every zone."""
    return at_corners(solver, N.x).mean(axis=0), at_corners(solver, N.y).mean(axis=0)


def l1(solver: Lagrange2D, exact: np.ndarray, inside=None) -> float:
    """Mean of |density - exact| by area, over the zones `inside`."""
    weight = areas(solver) * (1.0 if inside is None else inside)
    return float(np.sum(weight * np.abs(solver.zones[Z.rho] - exact)) / weight.sum())


def node_radii(solver: Lagrange2D) -> np.ndarray:
    """Distance of the nodes of the first block from the origin, (ni + 1, nj + 1)."""
    block = solver.problem.mesh.blocks[0]
    count = (block.ni + 1) * (block.nj + 1)
    return np.hypot(solver.nodes[N.x, :count], solver.nodes[N.y, :count]).reshape(block.ni + 1, block.nj + 1)


def asymmetry(solver: Lagrange2D) -> float:
    """Largest difference of the radii of nodes that began on one ring."""
    return float(np.ptp(node_radii(solver), axis=1).max())


def sectors(solver: Lagrange2D, count: int = 9) -> np.ndarray:
    """Sector of the quadrant, 0 to count - 1, that the centre of every zone is in."""
    x, y = centres(solver)
    return np.minimum((np.arctan2(y, x) / (0.5 * np.pi) * count).astype(int), count - 1)


__all__ = ["Bar", "HOLE", "N", "PlaneProblem", "QUARTER", "Z", "areas", "asymmetry", "at_corners", "box", "centres", "gas", "l1",
           "node_radii", "quarter_ring", "sectors", "solver_of", "still", "walls"]
