r"""Fields of zones in one dimension that the solver does not carry, found for a snapshot when a deck asks for them.

$$k = \tfrac14(u_l^2 + u_r^2), \qquad m = \tfrac12 M (u_l + u_r)$$

kinetic_energy   A.35 per mass with the nodes' masses, so that its sum over the zones is the energy the solver conserves
momentum         A.34, of the zone, with the same masses

and those of `energy_modes`; along the motion and around it the deviators are principal. Source: Herrmann A.34 and A.35.
"""

import numpy as np

from hugoniot.diagnostics.energy_modes import EnergyModes


class LineFields(EnergyModes):
    """Those of the names asked for that are `derived`."""

    derived: tuple[str, ...] = ("kinetic_energy", "momentum", *EnergyModes.derived)

    def __init__(self, asked, problem, region_of: np.ndarray, first_state):
        super().__init__(asked, problem.regions, problem.materials, region_of, first_state)

    def _kinetic_energy(self, state):
        return 0.25 * (state.velocity_left**2 + state.velocity_right**2)

    def _momentum(self, state):
        return 0.5 * state.zones["mass"] * (state.velocity_left + state.velocity_right)

    def deviators(self, state):
        none = np.zeros_like(state.zones["energy"])
        s1, s2 = state.zones.get("deviator_radial", none), state.zones.get("deviator_hoop", none)
        return s1, s2, none, -s1 - s2
