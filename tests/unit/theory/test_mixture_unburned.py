"""At burn fraction 0 a mixture is the unreacted explosive, also at its reference state, where the first products have no state."""

import math

import numpy as np
import pytest

from hugoniot.errors import NoSolution
from hugoniot.laws.eos import contract as eos
from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.laws.eos.stiffened_gas import StiffenedGas
from hugoniot.materials import library
from hugoniot.theory import mixture as tool
from hugoniot.theory.hugoniot import shock
from hugoniot.theory.mixture_shocks import unburned

KINDS = ("thermal_isolation", "thermal_equilibrium")


def rest(kind):
    """(mixture, (density, energy with Q)) of LX-17 in its reference state."""
    explosive = library.find("LX-17 reactive")
    par = tool.mixture(kind, explosive.unreacted, explosive.eos)
    rho, e = eos.reference_state(explosive.unreacted)
    return par, (rho, e + par.detonation_energy)


@pytest.mark.parametrize("kind", KINDS)
def test_the_reference_state_has_the_numbers_of_the_unreacted_law_by_hand(kind):
    """A stiffened gas at zero pressure: c^2 = gamma p_inf / rho, Gamma = gamma - 1, e = p_inf / (rho (gamma - 1)) gamma."""
    gamma, stiff, rho, heat = 3.0, 3e9, 1600.0, 1200.0
    par = tool.mixture(kind, StiffenedGas(gamma, stiff, rho, heat), IdealGas(2.8, 1000.0, rho), 5e6)
    e = eos.reference_state(par.reactants)[1] + 5e6
    state = tool.solve(rho, e, 0.0, par, (rho, e))
    assert abs(state.pressure) < 1e-6 * stiff and state.sound_speed == pytest.approx(math.sqrt(gamma * stiff / rho), rel=1e-12)
    assert state.gruneisen == pytest.approx(gamma - 1.0, rel=1e-12) and state.volume_fraction == 0.0
    assert state.specific_heat == pytest.approx(heat, rel=1e-12)


@pytest.mark.parametrize("kind", KINDS)
def test_what_is_of_the_products_has_no_number_there(kind):
    par, reference = rest(kind)
    state = tool.solve(*reference, np.array([0.0, 0.5, 1.0]), par, reference)
    alone = unburned(*reference, par)
    assert np.isnan(state.product_density).tolist() == [True, False, False] == np.isnan(state.pressure_by_burn_fraction).tolist()
    assert state.pressure[0] == alone.pressure and state.sound_speed[0] == alone.sound_speed and state.temperature[0] == pytest.approx(298.0)
    assert np.all(np.diff(state.pressure) > 0.0) and np.array_equal(state.volume_fraction[[0, 2]], [0.0, 1.0])
    with pytest.raises(NoSolution, match="no state at density.*give another density or energy"):
        tool.vanishing_series(*reference, par)


@pytest.mark.parametrize("kind", KINDS)
def test_shocks_and_adiabats_from_it_are_those_of_the_unreacted_explosive(kind):
    par, reference = rest(kind)
    start = tool.solve(*reference, 0.0, par, reference)
    found = tool.frozen_hugoniot(start, [5e9, 20e9])
    alone = shock(par.reactants, pressure=np.array([5e9, 20e9]))
    assert found.shock_velocity == pytest.approx(alone.shock_velocity, rel=1e-9)
    assert np.isnan(found.product_density).all()
    way = tool.adiabat(start, np.linspace(1.0, 0.9, 4) / reference[0])
    entropy = [eos.entropy(rho, e - par.detonation_energy, par.reactants) for rho, e in zip(way.density, way.energy)]
    assert np.ptp(entropy) < 1e-9 * 1305.5 and np.all(np.diff(way.pressure) > 0.0)


@pytest.mark.parametrize("kind", KINDS)
def test_an_energy_below_absolute_zero_is_no_state(kind):
    par, reference = rest(kind)
    assert tool.energy_with(reference[0], 0.0, par, reference, pressure=0.0) == pytest.approx(reference[1], rel=1e-12)
    with pytest.raises(NoSolution, match="below absolute zero"):
        tool.energy_with(reference[0], 0.25, par, reference, pressure=0.0)
