r"""Energies of a zone in the partition of Herrmann A.6, and its entropy, in one dimension and in two.

$$e_d = \frac{s:s}{4G\rho}, \qquad w = e - e(0) - e_d - w_p - w_q$$

elastic_deviator_energy  A.44 less A.43 per mass: what release gives back of the energy of distortion
pressure_work_and_heat   the rest of the internal energy since the start: the work of the pressure, A.38, and, where there is any, the heat
                         that was conducted, supplied or set free, and what physical viscosity made
entropy                  of the material's own law, up to a constant of the material; nan where the law has none, and in what burns
von_mises, lode_angle    of the stress deviators (`stress2d`)

plastic_work (A.43) and viscous_work (A.39) are the solver's. Source: Herrmann A.34 to A.44, 3.31 and 3.32.
"""

import numpy as np

from hugoniot.diagnostics.stress2d import lode_angle, von_mises
from hugoniot.diagnostics.temperature import solid_density
from hugoniot.laws.arrays import entropy_array, shear_modulus_array
from hugoniot.laws.strength.contract import STRENGTH
from hugoniot.problem.output_fields import gives_entropy


def distortion_energy(zones, squares, region_of, regions, materials, temperature=None) -> np.ndarray:
    """Elastic energy of distortion of every zone, J/kg; 0 for fluids, and for the burned mass fraction, which has no strength.

    squares      s:s of every zone, Pa2
    regions      regions or blocks in the order of the numbers in `region_of`, each with the name of its `material`
    temperature  of every zone, K, where strength laws ask for one
    """
    energy = np.zeros_like(squares)
    for k, region in enumerate(regions):
        law = materials[region.material].strength
        here = np.flatnonzero((region_of == k) & (squares > 0.0))
        if law is None or not here.size:
            continue
        rho, p, c = solid_density(zones)[here], zones["pressure"][here], zones["sound_speed"][here]
        heat = temperature[here] if temperature is not None and "needs_temperature" in STRENGTH.of(law).flags else 0.0
        modulus = shear_modulus_array(rho, p, heat, rho * c * c, law)
        if "burn_fraction" in zones:
            modulus = modulus * (1.0 - zones["burn_fraction"][here])
        solid = modulus > 1e-9 * rho * c * c     # a melt holds no energy of distortion
        energy[here] = np.where(solid, squares[here] / (4.0 * np.where(solid, modulus, 1.0) * rho), 0.0)
    return energy


def has_entropy(material) -> bool:
    """Whether a material's zones have an entropy: an inert one whose law gives it."""
    return material.burn is None and gives_entropy(material.eos)


class EnergyModes:
    """Finds the fields asked for that a solver does not carry; made once per run, since what is subtracted is the start.

    A subclass names what it finds in `derived`, gives one function `_name(state)` for each, and the stress deviators of its states.
    """

    derived: tuple[str, ...] = ("elastic_deviator_energy", "pressure_work_and_heat", "entropy", "von_mises", "lode_angle")

    def __init__(self, asked, regions, materials, region_of: np.ndarray, first_state):
        self.names = [name for name in self.derived if name in asked]
        self.regions, self.materials, self.region_of = regions, materials, region_of
        self.start, self.temperature = first_state.zones["energy"].copy(), None

    def __call__(self, state, temperature=None) -> dict[str, np.ndarray]:
        """{name: (nzone,)}; temperature of every zone, K, where strength laws ask for one."""
        self.temperature = temperature
        return {name: getattr(self, f"_{name}")(state) for name in self.names}

    def deviators(self, state):
        """(s_xx, s_yy, s_xy, s_zz) of every zone, Pa."""
        raise NotImplementedError

    def _elastic_deviator_energy(self, state):
        xx, yy, xy, zz = self.deviators(state)
        squares = xx * xx + yy * yy + zz * zz + 2.0 * xy * xy
        return distortion_energy(state.zones, squares, self.region_of, self.regions, self.materials, self.temperature)

    def _pressure_work_and_heat(self, state):
        zones, none = state.zones, np.zeros_like(state.zones["energy"])
        spent = zones.get("plastic_work", none) + zones.get("viscous_work", none)
        return zones["energy"] - self.start - self._elastic_deviator_energy(state) - spent

    def _entropy(self, state):
        found = np.full(self.region_of.shape, np.nan)
        for k, region in enumerate(self.regions):
            material, here = self.materials[region.material], self.region_of == k
            if has_entropy(material):
                found[here] = entropy_array(solid_density(state.zones)[here], state.zones["energy"][here], material.eos)
        return found

    def _von_mises(self, state):
        return von_mises(*self.deviators(state))

    def _lode_angle(self, state):
        return lode_angle(*self.deviators(state))
