"""Energy and momentum of a state, by region, in the parts of Herrmann A.6.

kinetic                  A.35 with the nodes' own masses (half of each neighbour), so that the sum is the one the solver conserves
internal                 A.36
elastic_deviator         s:s / (4 G rho), the energy of distortion that release gives back (A.44 less A.43)
plastic_work             A.43, summed by the solver with the return to the yield surface
viscous_work             A.39, work of the artificial viscosity; in `compatible` over the radial closing, which q resists alone
pressure_work_and_heat   the rest of the internal energy: the work of the pressure (A.38), and heat conducted, supplied or set free
"""

import numpy as np

from hugoniot.diagnostics.energy_modes import distortion_energy

PARTS = ("kinetic_energy", "internal_energy", "pressure_work_and_heat", "elastic_deviator_energy", "plastic_work", "viscous_work",
         "momentum")


class RegionBudget:
    """Sums a state region by region; made once per run, since what is subtracted is the start."""

    def __init__(self, problem, region_of: np.ndarray, first_state):
        self.problem, self.region_of = problem, region_of
        self.start = first_state.zones["energy"].copy()

    def _sum(self, per_zone):
        return np.bincount(self.region_of, weights=per_zone, minlength=len(self.problem.regions))

    def __call__(self, state, temperature=None) -> dict[str, np.ndarray]:
        """Every part, (nregion,) in J (momentum in kg m/s) per m^2, per m and radian, or per steradian.

        temperature   of every zone, K, as `energy_modes.distortion_energy` takes it
        """
        zones, mass = state.zones, state.zones["mass"]
        left, right = state.velocity_left, state.velocity_right
        s1, s2 = zones["deviator_radial"], zones["deviator_hoop"]
        distortion = distortion_energy(zones, s1 * s1 + s2 * s2 + (s1 + s2) ** 2, self.region_of, self.problem.regions,
                                       self.problem.materials, temperature)
        rest = zones["energy"] - self.start - distortion - zones["plastic_work"] - zones["viscous_work"]
        parts = (0.25 * mass * (left**2 + right**2), mass * zones["energy"], mass * rest, mass * distortion,
                 mass * zones["plastic_work"], mass * zones["viscous_work"], 0.5 * mass * (left + right))
        return {name: self._sum(part) for name, part in zip(PARTS, parts)}
