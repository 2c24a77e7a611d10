"""Steady shock structure in every registered equation of state, with and without heat conduction, from Mach 1.01 to 20."""

import math

import numpy as np
import pytest

from hugoniot.errors import NoSolution, OutOfRange
from hugoniot.laws import eos as _laws  # noqa: F401
from hugoniot.laws.eos import table
from hugoniot.laws.eos.contract import EOS, has_temperature
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.laws.transport.contract import make
from hugoniot.theory.structure import equations, steady


@pytest.mark.parametrize("law", list(EOS), ids=lambda law: law.name)
def test_every_registered_equation_of_state_has_a_structure(law):
    """End states of the same law to round-off; where the law has an entropy, production through the shock equals its jump."""
    par = law.example
    for conduction in (None, {"law": "prandtl", "prandtl": 1.0}):
        if conduction and not has_temperature(par):
            with pytest.raises(OutOfRange, match="temperature"):
                steady(par, make({"law": "constant", "shear_viscosity": 1e-3}, conduction), mach=1.5)
            continue
        profile = steady(par, make({"law": "constant", "shear_viscosity": 1e-3}, conduction), mach=1.5)
        assert profile.thickness() > 0.0
        assert profile.steps <= 300
        ends = profile.ends
        assert abs(ends.excess(1.0 / ends.downstream.density)) < 1e-12 * ends.downstream.pressure
        terms = profile.balance_terms(np.linspace(*profile.extent(1e-2), 9))
        for kind in ("momentum", "energy"):
            parts = [value for name, value in terms.items() if name.startswith(kind)]
            # the slope of energy conduction follows the identity of a consistent law; difference quotients reach 1e-6
            assert np.abs(sum(parts)).max() < 2e-6 * max(np.abs(p).max() for p in parts)
        if math.isfinite(ends.entropy_jump):
            assert profile.entropy_produced == pytest.approx(ends.entropy_jump, rel=1e-8)


# (law, conducting) -> Mach numbers of (1.01, 1.1, 2, 5, 20) that have no steady shock, and the words that say so
NO_SHOCK = {
    ("mie_gruneisen_quadratic", False): ((20.0,), "has no such shock.*compression limit"),
    ("mie_gruneisen_quadratic", True): ((20.0,), "has no such shock.*compression limit"),
    ("mie_gruneisen_cubic", False): ((20.0,), "has no such shock.*beyond the fit"),
    ("mie_gruneisen_cubic", True): ((5.0, 20.0), "has no such shock.*(c_p is negative|beyond the fit)"),
    ("p_lambda", True): ((20.0,), "has no such shock with this heat conduction.*no single stable state"),
    ("temperature_power", True): ((20.0,), "has no such shock with this heat conduction.*no single stable state"),
    ("table", False): ((2.0, 5.0, 20.0), "has no such shock.*the Hugoniot ends at density 4300"),
    ("table", True): ((2.0, 5.0, 20.0), "has no such shock.*the Hugoniot ends at density 4300"),
    ("tait", False): ((20.0,), "has no such shock.*compression limit"),
    ("tait", True): ((20.0,), "has no such shock.*compression limit"),
}


def check_shock_of(name, conducting, mach):
    par = EOS.get(name).example
    fluid = make({"law": "constant", "shear_viscosity": 1e-3}, {"law": "prandtl", "prandtl": 1.0} if conducting else None)
    refused, words = NO_SHOCK.get((name, conducting), ((), ""))
    if conducting and not has_temperature(par):
        refused, words = (mach,), "no temperature"
    if mach in refused:
        with pytest.raises((OutOfRange, NoSolution), match=words):
            steady(par, fluid, mach=mach)
        return
    profile = steady(par, fluid, mach=mach)
    assert profile.thickness() > 0.0 and profile.ends.mach == pytest.approx(mach, rel=1e-12)
    assert profile.steps <= NODES.get((name, conducting, mach), 300)
    low, high = profile.extent(1e-6)
    density = profile.at(np.linspace(low, high, 41))["density"]
    assert np.all(np.diff(density) > 0.0)
    scale = profile.ends.downstream.density - profile.ends.upstream.density
    assert density[0] == pytest.approx(profile.ends.upstream.density + 1e-6 * scale, abs=1e-9 * scale)
    assert density[-1] == pytest.approx(profile.ends.downstream.density - 1e-6 * scale, abs=1e-9 * scale)
    if math.isfinite(profile.ends.entropy_jump):
        assert profile.entropy_produced == pytest.approx(profile.ends.entropy_jump, rel=1e-7)


@pytest.mark.parametrize("name, conducting, mach", [
    ("snow_plough", True, 20.0), ("p_alpha", True, 1.01), ("p_lambda", True, 5.0), ("p_lambda", True, 20.0), ("mie_gruneisen_cubic", False, 5.0),
    ("mie_gruneisen_cubic", True, 5.0), ("table", True, 1.01), ("table", False, 20.0), ("tait", True, 20.0), ("jwl", True, 20.0)])
def test_from_mach_1_01_to_20_sampled(name, conducting, mach):
    check_shock_of(name, conducting, mach)


@pytest.mark.slow
@pytest.mark.parametrize("law", list(EOS), ids=lambda law: law.name)
def test_from_mach_1_01_to_20_with_and_without_conduction(law):
    """The matrix of docs/theory/shock_structure_numbers.md."""
    for conducting in (False, True):
        for mach in (1.01, 1.1, 2.0, 5.0, 20.0):
            check_shock_of(law.name, conducting, mach)


def test_heat_that_runs_ahead_of_a_porous_shock_keeps_the_flux_of_energy():
    """k dT/dx = m h with dT/dx from the profile itself: in pores temperature and energy do not follow from one potential."""
    fluid = make({"law": "constant", "shear_viscosity": 1e-3}, {"law": "prandtl", "prandtl": 1.0})
    for name, mach in (("p_lambda", 5.0), ("p_alpha", 5.0), ("snow_plough", 20.0)):
        profile = steady(EOS.get(name).example, fluid, mach=mach)
        x = np.linspace(*profile.extent(1e-2), 24)
        d = 1e-5 * profile.thickness()
        slope = (profile.at(x + d)["temperature"] - profile.at(x - d)["temperature"]) / (2.0 * d)
        fields = profile.at(x)
        assert np.allclose(-fields["conductivity"] * slope, fields["heat_flux"], rtol=1e-3, atol=1e-4 * np.abs(fields["heat_flux"]).max()), name


def test_a_strong_conducting_shock_in_a_porous_solid_is_followed_to_its_end():
    """Mach 20 in p_alpha with conduction: hundreds of viscous lengths ahead of it are warm; production equals what its state gains."""
    par = EOS.get("p_alpha").example
    profile = steady(par, make({"law": "constant", "shear_viscosity": 1e-3}, {"law": "prandtl", "prandtl": 1.0}), mach=20.0)
    m, mu = profile.ends.mass_flux, 4e-3 / 3.0
    low, _ = profile.extent(1e-3)
    assert low < -200.0 * mu / m
    assert profile.at(np.array([profile.x[0]]))["temperature"][0] == pytest.approx(profile.ends.upstream.temperature, rel=1e-3)


def test_a_table_has_the_weak_shock_of_its_law_only_on_a_fine_grid():
    """Mach 1.01, mie_gruneisen: 202.2 without and 207.9 with conduction, in units of (4/3) mu / m.

    Coarse, the temperature falls in the shock, and conduction thins the wave. An integration of v and T by the formulas of the one cell
    it lies in, with their exact slopes (Radau, rtol 1e-9), gives 190.42793.
    """
    law, coarse = MieGruneisen(2785.0, 5328.0, 1.338, 2.0, 863.0), EOS.get("table").example
    fine = table.from_law(law, 2785.0 + 0.2785 * np.arange(-4, 110), np.arange(290.15, 310.0), rho0=2785.0)
    for conduction, units in ((None, 202.50093), ({"law": "prandtl", "prandtl": 1.0}, 190.42793)):
        fluid = make({"law": "constant", "shear_viscosity": 1e-3}, conduction)
        true, near, far = (steady(par, fluid, mach=1.01) for par in (law, fine, coarse))
        assert near.thickness() == pytest.approx(true.thickness(), rel=4e-3)
        assert far.thickness() * far.ends.mass_flux / (4e-3 / 3.0) == pytest.approx(units, rel=1e-6)
    gains = [p.ends.downstream.temperature - p.ends.upstream.temperature for p in (true, near, far)]
    assert gains == pytest.approx([4.451, 4.467, -15.932], abs=1e-3)


def test_extent_reaches_beyond_the_integration():
    """Behind a thirtyfold compression the density changes 200 times as fast as the volume: 1e-6 of its jump lies in the tail."""
    profile = steady(EOS.get("mie_gruneisen_cold_series").example, make({"law": "constant", "shear_viscosity": 1e-3}), mach=20.0)
    one, two = profile.ends.upstream.density, profile.ends.downstream.density
    for part in (1e-3, 1e-6, 1e-10):
        gained = (profile.at(np.array(profile.extent(part)))["density"] - one) / (two - one)
        assert gained[0] == pytest.approx(part, rel=1e-4) and 1.0 - gained[1] == pytest.approx(part, rel=1e-4)
    assert profile.extent(1e-6)[1] > profile.x[-1]


# -- nodes (B30) ---------------------------------------------------------------------------------------------------------------
NODES = {("snow_plough", True, 20.0): 460}   # 900 viscous lengths with kinks in them; 300 elsewhere


@pytest.mark.slow
@pytest.mark.parametrize("name, mach", [("mie_gruneisen_cold_series", 20.0), ("snow_plough", 20.0), ("p_alpha", 1.01), ("p_alpha", 20.0),
                                        ("p_lambda", 10.0), ("table", 1.1), ("mie_gruneisen", 20.0)])
def test_measures_are_good_to_a_millionth(name, mach, monkeypatch):
    """The laws that need most nodes or have kinks, against the same equations at tolerances a thousand times smaller."""
    par, fluid = EOS.get(name).example, make({"law": "constant", "shear_viscosity": 1e-3}, {"law": "prandtl", "prandtl": 1.0})
    found = steady(par, fluid, mach=mach)
    monkeypatch.setattr(equations, "_DIFFERENCE", 1e-10)
    fine = steady(par, fluid, mach=mach, rtol=1e-11)
    assert fine.steps > 1.2 * found.steps
    for name in ("density", "velocity"):
        assert found.thickness(name) == pytest.approx(fine.thickness(name), rel=1e-6)
    assert found.entropy_produced == pytest.approx(fine.entropy_produced, rel=1e-6)
