"""The energy of distortion in budgets: with the shear modulus the solver steps with, zone by zone, however many there are."""

from types import SimpleNamespace

import numpy as np
import pytest

from hugoniot.diagnostics.budgets import PARTS
from hugoniot.diagnostics.energy_modes import distortion_energy
from hugoniot.laws.strength.contract import STRENGTH, shear_modulus
from hugoniot.output.columns import describe

LAW = STRENGTH.get("steinberg_guinan").example
PROBLEM = SimpleNamespace(regions=[SimpleNamespace(material="al"), SimpleNamespace(material="water")],
                          materials={"al": SimpleNamespace(strength=LAW), "water": SimpleNamespace(strength=None)})


def state(count):
    """Compressed and heated zones, some of them without shear stress, the last ones a fluid's."""
    at = np.linspace(0.0, 1.0, count)
    zones = {"density": 2703.0 * (1.0 + 0.3 * at), "pressure": 4e10 * at, "sound_speed": 5200.0 + 3000.0 * at,
             "deviator_radial": np.where(np.arange(count) % 3, -2e8 * (1.0 + at), 0.0)}
    zones["deviator_hoop"] = -0.5 * zones["deviator_radial"]
    return SimpleNamespace(zones=zones), (at > 0.9).astype(int), 298.15 + 900.0 * at


def energies(given, region_of, heat):
    s1, s2 = given.zones["deviator_radial"], given.zones["deviator_hoop"]
    return distortion_energy(given.zones, s1**2 + s2**2 + (s1 + s2) ** 2, region_of, PROBLEM.regions, PROBLEM.materials, heat)


@pytest.mark.parametrize("count", [30, 9000])       # by Python, and compiled
def test_the_energy_of_distortion_is_that_of_the_modulus_at_the_zones_own_temperature(count):
    given, region_of, heat = state(count)
    z, found = given.zones, energies(given, region_of, heat)
    for j in range(count):
        g = shear_modulus(z["density"][j], z["pressure"][j], heat[j], z["density"][j] * z["sound_speed"][j] ** 2, LAW)
        sheared = 1.5 * z["deviator_radial"][j] ** 2 / (4.0 * g * z["density"][j])
        assert found[j] == pytest.approx(0.0 if region_of[j] else sheared, rel=1e-12)
    assert found.max() > 1.0 and (found == 0.0).sum() > count // 3


def test_burned_mass_holds_no_energy_of_distortion():
    given, region_of, heat = state(9)
    whole = energies(given, region_of, heat)
    given.zones["burn_fraction"] = np.full(9, 0.75)
    assert energies(given, region_of, heat) == pytest.approx(4.0 * whole)     # the same stress in a quarter of the stiffness
    given.zones["burn_fraction"][:] = 1.0
    assert not energies(given, region_of, heat).any()


@pytest.mark.parametrize("geometry, per", [("planar", "/m^2"), ("cylindrical", "/m/rad"), ("spherical", "/sr"), ("axisymmetric", "/rad")])
def test_the_parts_of_a_budget_have_one_unit(geometry, per):
    """They are summed over regions; the fields of zones of the same name are per unit mass."""
    for name in PARTS[:-1]:
        assert describe(name, geometry)[0] == f"J{per}", name
        assert describe(name)[0] == ("J" if name == "internal_energy" else "J/kg")
    assert describe(PARTS[-1], geometry)[0] == f"kg m/s{per}"
