"""Energy and momentum of a two-dimensional state by region (block).

internal_energy, plastic_work, viscous_work   of the region's zones, also of those that have left the mesh and whose mass is kept
kinetic_energy                                the solver's own, shared between regions by quarters of their zones' masses
momentum_x, momentum_y                        zone mass times the mean velocity of the zone's nodes
All per metre of depth (plane) or per radian (axisymmetric).
"""

from collections.abc import Mapping

import numpy as np

from hugoniot.problem.plane.model import Problem2D
from hugoniot.state import State2D

_PER_MASS = {"energy": "internal_energy", "plastic_work": "plastic_work", "viscous_work": "viscous_work"}


class PlaneBudget:
    """Sums a state region by region: {part: (nregion,)}."""

    def __init__(self, problem: Problem2D):
        self.block_of, self.count = problem.mesh.block_of, len(problem.blocks)

    def _sum(self, per_zone) -> np.ndarray:
        return np.bincount(self.block_of, weights=per_zone, minlength=self.count)

    def __call__(self, state: State2D, kinetic: float | None = None, per_mass: Mapping | None = None) -> dict[str, np.ndarray]:
        """The parts; `kinetic` is the solver's kinetic energy (J), to which that of the regions is made to add up.

        per_mass   energy, plastic_work and viscous_work of all zones, (nzone,) J/kg: a state has none of those that have left the mesh
        """
        mass = state.zones["mass"]
        u, v = (state.nodes[name][state.zone_nodes] for name in ("velocity_x", "velocity_y"))
        moving = self._sum(mass * (u * u + v * v).mean(axis=1) * 0.5)
        if kinetic is not None and moving.sum() > 0.0:
            moving = moving * (kinetic / moving.sum())
        per_mass = state.zones if per_mass is None else per_mass
        parts = {word: self._sum(mass * per_mass[name]) for name, word in _PER_MASS.items() if name in per_mass}
        momentum = {name: self._sum(mass * w.mean(axis=1)) for name, w in (("momentum_x", u), ("momentum_y", v))}
        return {"kinetic_energy": moving, **parts, **momentum}
