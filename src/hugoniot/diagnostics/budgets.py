"""Energy and momentum of a state, by region, in the parts of Herrmann A.6.

kinetic            A.35 with the nodes' own masses (half of each neighbour), so that the sum is the one the solver conserves
internal           A.36
elastic_deviator   s:s / (4 G rho), the energy of distortion that release gives back (A.44 less A.43)
plastic_work       A.43, summed by the solver with the return to the yield surface
viscous_work       A.39, work of the artificial viscosity; in `compatible` over the radial closing, which q resists alone
elastic_volume     the rest of the internal energy: compression and what heat it holds (A.38)
"""

import numpy as np

from hugoniot.laws.arrays import shear_modulus_array
from hugoniot.laws.strength.contract import STRENGTH

PARTS = ("kinetic_energy", "internal_energy", "elastic_volume_energy", "elastic_deviator_energy", "plastic_work", "viscous_work",
         "momentum")


def distortion_energy(state, region_of, problem, temperature=None) -> np.ndarray:
    """Elastic energy of distortion of every zone, J/kg; 0 for fluids, and for the burned mass fraction, which has no strength.

    temperature   of every zone, K, where strength laws ask for one
    """
    zones = state.zones
    s1, s2 = zones["deviator_radial"], zones["deviator_hoop"]
    squares = s1 * s1 + s2 * s2 + (s1 + s2) ** 2
    energy = np.zeros_like(s1)
    for k, region in enumerate(problem.regions):
        law = problem.materials[region.material].strength
        here = np.flatnonzero((region_of == k) & (squares > 0.0))
        if law is None or not here.size:
            continue
        rho, p, c = (zones[name][here] for name in ("density", "pressure", "sound_speed"))
        heat = temperature[here] if temperature is not None and "needs_temperature" in STRENGTH.of(law).flags else 0.0
        modulus = shear_modulus_array(rho, p, heat, rho * c * c, law)
        if "burn_fraction" in zones:
            modulus = modulus * (1.0 - zones["burn_fraction"][here])
        solid = modulus > 1e-9 * rho * c * c     # a melt holds no energy of distortion
        energy[here] = np.where(solid, squares[here] / (4.0 * np.where(solid, modulus, 1.0) * rho), 0.0)
    return energy


class RegionBudget:
    """Sums a state region by region; made once per run, since what is subtracted is the start."""

    def __init__(self, problem, region_of: np.ndarray, first_state):
        self.problem, self.region_of = problem, region_of
        self.start = first_state.zones["energy"].copy()

    def _sum(self, per_zone):
        return np.bincount(self.region_of, weights=per_zone, minlength=len(self.problem.regions))

    def __call__(self, state, temperature=None) -> dict[str, np.ndarray]:
        """Every part, (nregion,) in J (momentum in kg m/s) per m^2, per m and radian, or per steradian.

        temperature   of every zone, K, as `distortion_energy` takes it
        """
        zones, mass = state.zones, state.zones["mass"]
        left, right = state.velocity_left, state.velocity_right
        distortion = distortion_energy(state, self.region_of, self.problem, temperature)
        rest = zones["energy"] - self.start - distortion - zones["plastic_work"] - zones["viscous_work"]
        parts = (0.25 * mass * (left**2 + right**2), mass * zones["energy"], mass * rest, mass * distortion,
                 mass * zones["plastic_work"], mass * zones["viscous_work"], 0.5 * mass * (left + right))
        return {name: self._sum(part) for name, part in zip(PARTS, parts)}
