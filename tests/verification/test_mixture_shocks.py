"""Reaction inside a shock, the chemical potential, and CTH's two-state closure: 003 sections 4.1, 4.4 and 5.8."""

import numpy as np
import pytest
from mixture_states import PAIRS, RHO0, Q, derivative, shocked, states

from hugoniot.errors import NoSolution, OutOfRange
from hugoniot.laws.eos import contract as eos
from hugoniot.theory import mixture as tool
from hugoniot.theory.chapman_jouguet import cj
from hugoniot.theory.hugoniot import Initial, shock
from hugoniot.theory.mixture_shocks import chemical_potential, reacting_hugoniot, unburned

PRESSURES = np.array([2e10, 3.2e10, 4.5e10])


def at_rest():
    """Upstream explosive of the pair of JWL laws, and its thermal energy at rest."""
    par = tool.mixture("thermal_isolation", *PAIRS["jwl, jwl"], Q)
    e = float(eos.energy(RHO0, 0.0, par.reactants))
    return unburned(RHO0, e + Q, par), e


def test_nothing_reacted_is_the_frozen_hugoniot():
    start, e = at_rest()
    inert = shock(start.par.reactants, Initial(RHO0, 0.0, e), pressure=PRESSURES)
    assert np.allclose(reacting_hugoniot(start, PRESSURES, 0.0).density, inert.density, rtol=1e-12)
    assert np.allclose(reacting_hugoniot(start, PRESSURES, 1e-7).density, inert.density, rtol=1e-6)
    rho, thermal = shocked(start.par.reactants, 5e9)
    half = tool.solve(rho, thermal + Q, 0.3, start.par, (rho, thermal + Q))
    assert np.array_equal(tool.frozen_hugoniot(half, PRESSURES).density, reacting_hugoniot(half, PRESSURES, 0.0).density)


def test_all_reacted_is_the_detonation_hugoniot():
    """Least velocity, and its pressure, are those of the tangency, which shares nothing with this search."""
    start, e = at_rest()
    point = cj(PAIRS["jwl, jwl"][1], Initial(RHO0, 0.0, e, heat=Q))
    at = reacting_hugoniot(start, [float(point.state.pressure)], 1.0)
    assert at.shock_velocity[0] == pytest.approx(point.detonation_velocity, rel=1e-9)
    assert at.density[0] == pytest.approx(float(point.state.density), rel=1e-6)
    around = reacting_hugoniot(start, float(point.state.pressure) * np.array([0.95, 1.05]), 1.0).shock_velocity
    assert min(around) > at.shock_velocity[0]


@pytest.mark.parametrize("reacted", [0.2, 0.6, 1.0])
def test_jumps_of_partly_reacted_shocks_close(reacted):
    start, _ = at_rest()
    found = reacting_hugoniot(start, PRESSURES, reacted)
    v_u, e_u = 1.0 / float(start.density), float(start.energy)
    v, par = 1.0 / found.density, start.par
    assert np.allclose(found.energy - e_u, 0.5 * (PRESSURES + float(start.pressure)) * (v_u - v), rtol=1e-12)
    if reacted == 1.0:
        assert np.all(np.isnan(found.reactant_density)) and np.allclose(found.product_density, found.density, rtol=1e-12)
    else:
        assert np.allclose((1 - reacted) / found.reactant_density + reacted / found.product_density, v, rtol=1e-12)
        assert np.allclose((1 - reacted) * found.reactant_energy + reacted * found.product_energy, found.energy, rtol=1e-12)
    for k, p in enumerate(PRESSURES):
        assert eos.pressure(found.product_density[k], found.product_energy[k], par.products) == pytest.approx(p, rel=1e-9)
        if reacted < 1.0:
            assert eos.pressure(found.reactant_density[k], found.reactant_energy[k] - Q, par.reactants) == pytest.approx(p, rel=1e-9)
    assert np.all(np.diff(found.particle_velocity) > 0.0)


def test_a_model_of_the_reacted_part_may_follow_the_pressure():
    start, _ = at_rest()
    found = reacting_hugoniot(start, PRESSURES, lambda p: p / 1e11)
    each = [reacting_hugoniot(start, [p], p / 1e11).density[0] for p in PRESSURES]
    assert np.allclose(found.density, each, rtol=1e-14)
    with pytest.raises(OutOfRange, match="mass fraction that burns"):
        reacting_hugoniot(start, PRESSURES, 1.2)
    with pytest.raises(NoSolution):
        reacting_hugoniot(start, [1e9], 1.0)


@pytest.mark.parametrize("kind", ["thermal_isolation", "thermal_equilibrium"])
@pytest.mark.parametrize("pair", ["two gases", "jwl, jwl"])
def test_the_chemical_potential_is_the_slope_of_the_energy_at_constant_entropy(pair, kind):
    par, v, e, lam, reference = states(pair, kind, 4)
    q = par.detonation_energy

    def entropy_of(lam, e, j):
        s = tool.solve(1.0 / v[j], e, lam, par, reference)
        m = s.mixed()
        return (1 - lam) * eos.entropy(m.rho_r, m.e_r - q, par.reactants) + lam * eos.entropy(m.rho_p, m.e_p, par.products)

    for j in range(len(v)):
        state = tool.solve(1.0 / v[j], e[j], lam[j], par, reference)
        s_lambda = derivative(lambda x, j=j: entropy_of(x, e[j], j), lam[j], 2e-3 * min(lam[j], 1 - lam[j]))
        s_energy = derivative(lambda x, j=j: entropy_of(lam[j], x, j), e[j], 2e-4 * e[j])
        assert float(chemical_potential(state)) == pytest.approx(-s_lambda / s_energy, rel=1e-6, abs=1e-3 * Q * 1e-3)


@pytest.mark.parametrize("pair", ["two gases", "jwl, jwl", "stiffened gas, gas"])
def test_two_states_share_density_and_temperature_and_their_slopes_are_right(pair):
    par = tool.mixture("two_state", *PAIRS[pair], Q)
    rng = np.random.default_rng(4)
    rho, e, lam = RHO0 * rng.uniform(1.0, 1.3, 8), Q * rng.uniform(1.1, 1.5, 8), rng.uniform(0.05, 0.95, 8)
    s = tool.solve(rho, e, lam, par)
    assert np.array_equal(s.reactant_density, rho) and np.array_equal(s.product_density, rho)
    t_r = [eos.temperature(r, x - Q, par.reactants) for r, x in zip(rho, s.reactant_energy)]
    t_p = [eos.temperature(r, x, par.products) for r, x in zip(rho, s.product_energy)]
    assert np.allclose(t_r, t_p, rtol=1e-11) and np.allclose(s.temperature, t_p, rtol=1e-11)
    assert np.allclose((1 - lam) * s.reactant_energy + lam * s.product_energy, e, rtol=1e-13)
    v = 1.0 / rho
    wanted = (derivative(lambda x: tool.solve(1.0 / x, e, lam, par).pressure, v, 1e-3 * v),
              derivative(lambda x: tool.solve(rho, x, lam, par).pressure, e, 1e-3 * e),
              derivative(lambda x: tool.solve(rho, e, x, par).pressure, lam, 1e-3 * np.minimum(lam, 1 - lam)))
    scale = s.density * s.sound_speed**2
    assert np.allclose(s.pressure_by_volume, wanted[0], rtol=1e-7)
    assert np.allclose(s.pressure_by_energy, wanted[1], rtol=1e-7)
    assert np.all(np.abs(s.pressure_by_burn_fraction - wanted[2]) < 1e-7 * scale)
    heat = derivative(lambda x: tool.solve(rho, x, lam, par).temperature, e, 1e-3 * e)
    assert np.allclose(s.specific_heat, 1.0 / heat, rtol=1e-7)


def test_the_two_state_pressure_belongs_to_neither_phase():
    """Why the source rejects it: at one state the phases' pressures differ by more than the mixture's own."""
    par = tool.mixture("two_state", *PAIRS["jwl, jwl"], Q)
    s = tool.solve(RHO0 * 1.15, 1.2 * Q, 0.5, par)
    p_r = eos.pressure(RHO0 * 1.15, float(s.reactant_energy) - Q, par.reactants)
    p_p = eos.pressure(RHO0 * 1.15, float(s.product_energy), par.products)
    assert abs(p_p - p_r) > 0.5 * float(s.pressure)
    assert float(s.pressure) == pytest.approx(0.5 * (p_r + p_p), rel=1e-12)
