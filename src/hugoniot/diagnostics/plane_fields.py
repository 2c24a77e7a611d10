r"""Fields of zones in two dimensions that the solver does not carry, found for a snapshot when a deck asks for them.

$$k = \tfrac12\,\overline{u^2 + v^2}, \qquad m_x = M\,\overline{u}, \qquad m_y = M\,\overline{v}$$

kinetic_energy           A.35 per mass, the mean over the zone's corners; where corners weigh the same, as in plane rectangles, its sum
                         over the zones is the energy the solver conserves
momentum_x, momentum_y   A.34, of the zone, with the mean velocity of its corners

and those of `energy_modes`, with the principal angle. Source: Herrmann A.34, A.35 and B.33 to B.35.
"""

from hugoniot.diagnostics.energy_modes import EnergyModes
from hugoniot.diagnostics.stress2d import principal_angle


class PlaneFields(EnergyModes):
    """Those of the names asked for that are `derived`."""

    derived: tuple[str, ...] = ("kinetic_energy", "momentum_x", "momentum_y", "principal_angle", *EnergyModes.derived)

    def __init__(self, asked, problem, first_state):
        super().__init__(asked, problem.blocks, problem.materials, problem.mesh.block_of, first_state)

    def _at_corners(self, state, name):
        return state.nodes[name][state.zone_nodes]

    def _kinetic_energy(self, state):
        return 0.5 * sum(self._at_corners(state, name) ** 2 for name in ("velocity_x", "velocity_y")).mean(axis=1)

    def _momentum_x(self, state):
        return state.zones["mass"] * self._at_corners(state, "velocity_x").mean(axis=1)

    def _momentum_y(self, state):
        return state.zones["mass"] * self._at_corners(state, "velocity_y").mean(axis=1)

    def _principal_angle(self, state):
        return principal_angle(*self.deviators(state)[:3])

    def deviators(self, state):
        return tuple(state.zones[f"deviator_{part}"] for part in ("xx", "yy", "xy", "zz"))
