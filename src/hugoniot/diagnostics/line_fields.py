r"""Fields of zones in one dimension that the solver does not carry, found for a snapshot when a deck asks for them.

$$k = \tfrac14(u_l^2 + u_r^2), \qquad m = \tfrac12 M (u_l + u_r), \qquad
  e_d = \frac{s:s}{4G\rho}, \qquad e_v = e - e(0) - e_d - w_p - w_q$$

kinetic_energy           A.35 per mass with the nodes' masses, so that its sum over the zones is the energy the solver conserves
momentum                 A.34, of the zone, with the same masses
elastic_deviator_energy  A.44 less A.43 per mass: what release gives back of the energy of distortion
elastic_volume_energy    A.38 per mass: the rest of the internal energy since the start, of compression and its heat
entropy                  of the material's own law, up to a constant of the material; nan where the law has none, and in what burns
von_mises, lode_angle    of the stress deviators, as in two dimensions (`stress2d`); along the motion and around it they are principal

plastic_work (A.43) and viscous_work (A.39) are the solver's. Source: Herrmann A.34 to A.44, 3.31 and 3.32.
"""

import numpy as np

from hugoniot.diagnostics.budgets import distortion_energy
from hugoniot.diagnostics.stress2d import lode_angle, von_mises
from hugoniot.laws.arrays import entropy_array
from hugoniot.laws.eos.contract import flagged, gives, remembered

DERIVED = ("kinetic_energy", "momentum", "elastic_deviator_energy", "elastic_volume_energy", "entropy", "von_mises", "lode_angle")


class LineFields:
    """Finds those of the names asked for that are `DERIVED`; made once per run, since what is subtracted is the start."""

    def __init__(self, asked, problem, region_of: np.ndarray, first_state):
        self.names = [name for name in DERIVED if name in asked]
        self.problem, self.region_of = problem, region_of
        self.start = first_state.zones["energy"].copy() if self.names else None

    def __call__(self, state, temperature=None) -> dict[str, np.ndarray]:
        """{name: (nzone,)}; temperature of every zone, K, where strength laws ask for one."""
        self.temperature = temperature
        return {name: getattr(self, f"_{name}")(state) for name in self.names}

    def _kinetic_energy(self, state):
        return 0.25 * (state.velocity_left**2 + state.velocity_right**2)

    def _momentum(self, state):
        return 0.5 * state.zones["mass"] * (state.velocity_left + state.velocity_right)

    def _elastic_deviator_energy(self, state):
        if "deviator_radial" not in state.zones:
            return np.zeros_like(state.zones["energy"])
        return distortion_energy(state, self.region_of, self.problem, self.temperature)

    def _elastic_volume_energy(self, state):
        zones, none = state.zones, np.zeros_like(state.zones["energy"])
        spent = zones.get("plastic_work", none) + zones.get("viscous_work", none)
        return zones["energy"] - self.start - self._elastic_deviator_energy(state) - spent

    def _entropy(self, state):
        found = np.full(self.region_of.shape, np.nan)
        for k, region in enumerate(self.problem.regions):
            material, here = self.problem.materials[region.material], self.region_of == k
            if not has_entropy(material):
                continue
            rho, e = state.zones["density"][here], state.zones["energy"][here]
            if "compaction" in state.zones and flagged(material.eos, "remembers"):
                each = zip(rho, e, state.zones["compaction"][here])
                found[here] = [entropy_array(x, y, remembered(z, material.eos)) for x, y, z in each]
            else:
                found[here] = entropy_array(rho, e, material.eos)
        return found

    def _deviators(self, state):
        none = np.zeros_like(state.zones["energy"])
        s1, s2 = state.zones.get("deviator_radial", none), state.zones.get("deviator_hoop", none)
        return s1, s2, none, -s1 - s2

    def _von_mises(self, state):
        return von_mises(*self._deviators(state))

    def _lode_angle(self, state):
        return lode_angle(*self._deviators(state))


def has_entropy(material) -> bool:
    """Whether a material's zones have an entropy: an inert one whose law gives it."""
    return material.burn is None and gives(material.eos, "entropy")
