"""Problems of the two-dimensional solver that its tests share."""

import numpy as np

from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.laws.strength.perfectly_plastic import PerfectlyPlastic
from hugoniot.materials.material import Material
from hugoniot.mesh.shapes import Box
from hugoniot.problem.model import OutputOptions, Pulse
from hugoniot.problem.plane.model import Block2D, Boundary2D, Problem2D, Solver2D, VelocityField, Viscosity2D
from hugoniot.solvers.lagrange2d.solver import Lagrange2D

QUIET = OutputOptions(report=False)
TENSOR = Viscosity2D("tensor", True, 0.3, 2.0 / 3.0, 0.06, 2.0 / 3.0)
SIDES = ("left", "right", "bottom", "top")


def gas(gamma=5.0 / 3.0):
    return Material("gas", IdealGas(gamma, 1.0, 1.0))


def aluminium(**laws):
    return Material("al", MieGruneisen(2700.0, 5200.0, 1.5, 2.0), PerfectlyPlastic(24.8e9, 0.30e9), **laws)


def box(nx, ny, width=1.0, height=1.0, origin=(0.0, 0.0), name="b", material="gas", **state):
    shape = Box((origin[0], origin[0] + width), (origin[1], origin[1] + height))
    return Block2D(name, material, shape, (nx, ny), **state)


def walls(*names):
    return tuple(Boundary2D((name,), "wall") for name in names)


def problem(blocks, materials, stop, boundaries=(), geometry="plane", **options):
    blocks = tuple(blocks) if isinstance(blocks, (list, tuple)) else (blocks,)
    materials = {m.name: m for m in (materials if isinstance(materials, (list, tuple)) else (materials,))}
    options.setdefault("viscosity", TENSOR)
    extra = {name: options.pop(name) for name in ("body_force",) if name in options}
    return Problem2D("test", geometry, stop, blocks, materials, tuple(boundaries), solver=Solver2D(**options), output=QUIET, **extra)


def ran(given, cycles=10**7, until=None):
    """A solver that has marched to the stop time (or some cycles)."""
    solver = Lagrange2D(given)
    while solver.time < (until or given.stop_time) and solver.cycle < cycles:
        solver.march(until or given.stop_time, min(1000, cycles - solver.cycle))
    return solver


def noh(n, stop=0.6, gamma=5.0 / 3.0, geometry="plane", **options):
    """The quadrant of Noh's implosion on a square mesh."""
    block = box(n, n, density=1.0, pressure=1e-10, velocity=VelocityField(radial=-1.0))
    sides = walls("b.left", "b.bottom") if geometry == "plane" else walls("b.bottom")
    return problem(block, gas(gamma), stop, sides, geometry, **options)


def centres(solver):
    """Coordinates of zone centres, (2, nzone)."""
    state = solver.state()
    return np.array([state.nodes[f"position_{a}"][state.zone_nodes].mean(axis=1) for a in "xy"])


__all__ = ["QUIET", "SIDES", "Boundary2D", "Pulse", "Viscosity2D", "aluminium", "box", "centres", "gas", "noh", "problem", "ran", "walls"]
