"""The search for the state of a mixture: where it ends, what it leaves to others, what it refuses (Starkenberg sections 5.1 to 5.9)."""

import numpy as np
import pytest
from mixture_states import KINDS, PAIRS, PRODUCTS, UNREACTED, Q, shocked, solve_all, states

import hugoniot.laws.eos  # noqa: F401  (enrols the equations of state)
from hugoniot.errors import NoSolution, OutOfRange
from hugoniot.laws.eos import contract as eos
from hugoniot.laws.mixture import contract, equilibrium
from hugoniot.laws.mixture.isentrope import isentrope_energy
from hugoniot.theory import mixture as tool


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("pair", PAIRS)
def test_an_attempt_is_the_answer_of_the_search_or_says_that_it_is_none(pair, kind):
    """From the state of a step before, near or far: where two trials converge they give what the search gives, to 1e-12."""
    par, v, e, lam, reference = states(pair, kind, 40)
    rng, near, far = np.random.default_rng(5), 0, 0
    for k in range(len(v)):
        before = contract.solve(1.0 / v[k], e[k], lam[k], contract.at_rest(*reference), par)
        for size in (1e-4, 1e-3, 0.05, 0.5):
            rho, more = 1.0 / v[k] * (1.0 + size * rng.uniform(-1.0, 1.0)), e[k] * (1.0 + 0.1 * size * rng.uniform(-1.0, 1.0))
            fraction = min(1.0, max(0.0, lam[k] + size * rng.uniform(-1.0, 1.0)))
            tried = contract.attempt(rho, more, fraction, before, par)
            if tried.status == contract.CONVERGED:
                answer = contract.solve(rho, more, fraction, before, par)
                assert answer.status == contract.CONVERGED and np.allclose(tried, answer, rtol=1e-12, atol=0.0)
                near, far = near + (size < 0.01), far + (size > 0.01)
            else:
                assert tried == (*before[:5], contract.NOT_CONVERGED)
    closed = pair != "mie-grueneisen, jwl" or kind == "thermal_equilibrium"      # a Hugoniot's isentrope is integrated
    assert (near >= 60 and far < 60) if closed else near == far == 0


@pytest.mark.parametrize("strange", [
    {"burn_fraction": 0.0}, {"burn_fraction": 1e-9}, {"burn_fraction": 1e-4}, {"burn_fraction": 1.0}, {"rho_r": 0.0}, {"rho_p": 0.0},
    {"rho_p": 1e-3}, {"rho_p": 1e7}, {"rho": 1.0}, {"rho": 1e6}, {"e": -1e9}, {"e": float("nan")}, {"rho": float("nan")}])
@pytest.mark.parametrize("kind", KINDS)
def test_an_attempt_leaves_ends_of_burning_and_bad_states_to_the_search(strange, kind):
    par, v, e, lam, reference = states("jwl, jwl", kind)
    if kind == "thermal_isolation":
        par = par._replace(nascent_limit=1e-3)
    elif strange == {"burn_fraction": 1e-4}:
        strange = {"burn_fraction": 1e-8}       # nothing is vanishing in equilibrium before that
    before = contract.solve(1.0 / v[0], e[0], lam[0], contract.at_rest(*reference), par)
    before = before._replace(**{name: value for name, value in strange.items() if name in before._fields})
    values = {"rho": 1.0 / v[0], "e": e[0], "burn_fraction": lam[0]} | {k: x for k, x in strange.items() if k not in before._fields}
    with np.errstate(all="ignore"):
        assert contract.attempt(*values.values(), before, par).status == contract.NOT_CONVERGED


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("pair", PAIRS)
def test_no_search_fails_where_a_state_exists(pair, kind):
    """2000 states from tension to compression, burn fractions to 1e-9 of both ends: solved; refusals are checked by a dense scan.

    A Mie-Grueneisen solid of constant rho Gamma cannot release below its thermal pressure: as hot as products, it may have no equilibrium.
    """
    par = tool.mixture(kind, *PAIRS[pair], Q)
    rho_k, e_k = shocked(par.reactants)
    rng = np.random.default_rng(5)
    n = 2000
    rho = rho_k * rng.uniform(0.6, 1.1, n)
    lam = np.concatenate([10.0 ** rng.uniform(-9, 0, n // 2), 1.0 - 10.0 ** rng.uniform(-9, 0, n // 2)])
    along = np.array([isentrope_energy(1.0 / rho_k, e_k, 1.0 / r, par.reactants) for r in rho])
    e = along + Q * (1.0 + lam * rng.uniform(-0.1, 0.3, n))
    phases = np.zeros((6, n))
    phases[1], phases[2] = rho_k, e_k + Q
    solve_all(rho, e, lam, phases, par)
    refused = np.flatnonzero(phases[5] != contract.CONVERGED)
    if (pair, kind) != ("mie-grueneisen, jwl", "thermal_equilibrium"):
        assert refused.size == 0
    else:
        assert 0 < refused.size < 0.05 * n
    for j in refused[:5]:
        v, f, rest = 1.0 / rho[j], lam[j], 1.0 - lam[j]
        tight = (v - 1.001 / par.reactant_density_limit) / max(f, rest)
        for w in np.linspace(-tight, 0.7 * v, 141):
            z = equilibrium.share_energy(v + f * w, v - rest * w, e[j], f, 0.0, par)
            p_r = eos.pressure(1.0 / (v + f * w), e[j] + f * z - Q, par.reactants)
            assert p_r > eos.pressure(1.0 / (v - rest * w), e[j] - rest * z, par.products)


def test_heat_shared_by_both_phases_does_not_all_go_to_the_products():
    """A weak viscous shock in a zone of burn fraction 1e-3: 10 kJ/kg must not raise the nascent gas by 10 MJ/kg."""
    par = tool.mixture("thermal_isolation", *PAIRS["jwl, jwl"], Q)
    rho, e_th = shocked(par.reactants)
    quiet = contract.solve(rho, e_th + Q, 1e-3, contract.at_rest(rho, e_th + Q), par)
    heat = 1.0e4
    left_behind = contract.solve(rho, e_th + Q + heat, 1e-3, quiet, par)
    shared = contract.solve(rho, e_th + Q + heat, 1e-3, contract.heated(quiet, heat), par)
    assert abs(shared.e_p - quiet.e_p) < 3.0 * heat
    assert left_behind.e_p - quiet.e_p > 100.0 * heat
    assert shared.pressure == pytest.approx(eos.pressure(rho, e_th + heat, par.reactants), rel=2e-3)


@pytest.mark.parametrize("pair", PAIRS)
def test_a_marched_reference_gives_the_fixed_one(pair):
    """A solver hands each step's phases to the next: after 300 steps the pressure is that of one search from the shocked state."""
    par = tool.mixture("thermal_isolation", *PAIRS[pair], Q)
    rho_k, e_k = shocked(par.reactants)
    steps = 300
    phases = np.zeros((6, 1))
    phases[1], phases[2] = rho_k, e_k + Q
    for k in range(1, steps + 1):
        rho = np.array([rho_k * (1.0 - 0.2 * k / steps)])
        lam = np.array([0.9 * k / steps])
        e = isentrope_energy(1.0 / rho_k, e_k, 1.0 / rho[0], par.reactants) + Q * np.array([1.0 + 0.1 * lam[0]])
        solve_all(rho, e, lam, phases, par)
        assert phases[5, 0] == contract.CONVERGED
    assert phases[0, 0] == pytest.approx(float(tool.solve(rho[0], e[0], lam[0], par, (rho_k, e_k + Q)).pressure), rel=1e-10)


def test_refusals_name_the_state_and_the_cause():
    par = tool.mixture("thermal_isolation", *PAIRS["mie-grueneisen, jwl"], Q)
    rho_k, e_k = shocked(par.reactants)
    with pytest.raises(NoSolution, match="burn fraction 0.5"):
        tool.solve(3.0 * rho_k, 1e6, 0.5, par, (rho_k, e_k + Q))
    with pytest.raises(OutOfRange, match="reference"):
        tool.solve(rho_k, e_k + Q, 0.5, par)
    with pytest.raises(OutOfRange, match="between 0 and 1"):
        tool.solve(rho_k, e_k + Q, 1.2, par, (rho_k, e_k + Q))
    with pytest.raises(OutOfRange, match="positive"):
        tool.solve(-1.0, e_k + Q, 0.2, par, (rho_k, e_k + Q))
    with pytest.raises(OutOfRange, match="vanishing_series"):
        tool.solve(rho_k, e_k + Q, 0.0, par, (rho_k, e_k + Q)).phase_slopes()
    cold = PRODUCTS._replace(specific_heat=float("nan"))
    with pytest.raises(OutOfRange, match="products.*specific_heat"):
        tool.mixture("thermal_equilibrium", UNREACTED, cold)
    isolated = tool.solve(rho_k, e_k + Q, 0.3, tool.mixture("thermal_isolation", PAIRS["mie-grueneisen, jwl"][0], cold, Q), (rho_k, e_k + Q))
    assert isolated.pressure > 0.0
    with pytest.raises(OutOfRange, match="temperature"):
        _ = isolated.temperature
    with pytest.raises(OutOfRange, match="reactants"):
        tool.mixture("weighted_pressures", None, PRODUCTS)
    with pytest.raises(OutOfRange, match="no specific heat"):
        _ = tool.solve(rho_k, e_k + Q, 0.3, tool.mixture("weighted_pressures", UNREACTED, PRODUCTS)).specific_heat
