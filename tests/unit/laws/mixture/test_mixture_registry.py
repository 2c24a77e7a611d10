"""Every mixture law keeps the family's contract: pure ends, slopes of the pressure, refusal of double names."""

import pytest

import hugoniot.laws.eos
import hugoniot.laws.mixture  # noqa: F401  (enrols the laws)
from hugoniot.core.registry import UnknownName
from hugoniot.laws.eos import contract as eos
from hugoniot.laws.mixture import contract
from hugoniot.laws.mixture.contract import MIXTURE

STATE = (2200.0, 6.4e6)


@pytest.mark.parametrize("law", list(MIXTURE), ids=lambda law: law.name)
def test_ends_are_the_pure_phases(law):
    par, (rho, e) = law.example, STATE
    before = contract.at_rest(rho, e)
    unburnt = contract.solve(rho, e, 0.0, before, par)
    burnt = contract.solve(rho, e, 1.0, before, par)
    if "no_reactants" in law.flags:
        assert unburnt.pressure == 0.0
    else:
        assert unburnt.pressure == eos.pressure(rho, e - par.detonation_energy, par.reactants)
        assert contract.slopes(rho, e, 0.0, unburnt, par).by_energy == pytest.approx(
            eos.pressure_derivatives(rho, e - par.detonation_energy, par.reactants)[1])
    assert burnt.pressure == eos.pressure(rho, e, par.products)
    slope = contract.slopes(rho, e, 1.0, burnt, par)
    assert contract.sound_speed_squared(rho, burnt.pressure, slope) == pytest.approx(eos.sound_speed_squared(rho, e, par.products))


@pytest.mark.parametrize("law", list(MIXTURE), ids=lambda law: law.name)
@pytest.mark.parametrize("lam", (0.1, 0.7))
def test_slopes_of_every_law(law, lam):
    par, (rho, e) = law.example, STATE
    before = contract.at_rest(rho, e)
    mixed = contract.solve(rho, e, lam, before, par)
    slope = contract.slopes(rho, e, lam, mixed, par)
    v = 1.0 / rho

    def difference(function, h):
        return (8.0 * (function(h) - function(-h)) - (function(2 * h) - function(-2 * h))) / (12.0 * h)

    scale = abs(mixed.pressure)
    got = difference(lambda h: contract.solve(1.0 / (v + h), e, lam, before, par).pressure, 1e-3 * v)
    assert slope.by_volume == pytest.approx(got, rel=1e-7)
    got = difference(lambda h: contract.solve(rho, e + h, lam, before, par).pressure, 1e-3 * e)
    assert slope.by_energy == pytest.approx(got, rel=1e-7)
    got = difference(lambda h: contract.solve(rho, e, lam + h, before, par).pressure, 1e-3)
    assert slope.by_burn_fraction == pytest.approx(got, rel=1e-7, abs=1e-7 * scale)


def test_a_first_guess_far_off_ends_in_the_same_state():
    """The bracket catches a start with products at ten times and a hundredth of their density."""
    for name in ("thermal_isolation", "thermal_equilibrium"):
        par, (rho, e) = MIXTURE.get(name).example, STATE
        cold = contract.solve(rho, e, 0.4, contract.at_rest(rho, e), par)
        for factor in (10.0, 0.01):
            start = contract.Mixed(0.0, rho, e, cold.rho_p * factor, cold.e_p, 0.0)
            warm = contract.solve(rho, e, 0.4, start, par)
            assert warm.status == contract.CONVERGED
            assert warm.pressure == pytest.approx(cold.pressure, rel=1e-12)


def test_unknown_law_offers_the_nearest():
    with pytest.raises(UnknownName, match="thermal_isolation"):
        MIXTURE.get("thermal_isolatio")


@pytest.mark.parametrize("law", [law for law in MIXTURE if "no_reactants" not in law.flags], ids=lambda law: law.name)
@pytest.mark.parametrize("lam, side", ((0.0, 0), (1e-15, 0), (9e-9, 0), (1.0 - 9e-9, 1), (1.0 - 1e-15, 1), (1.0, 1)))
def test_sound_speed_and_temperature_where_one_phase_is_left_out(law, lam, side):
    """`solve` does not search within 1e-8 of either end: slopes and temperature must then be the remaining phase's, whatever `before` held."""
    par, (rho, e) = law.example, STATE
    stale = contract.at_rest(1.3 * rho, 1.5 * e)
    mixed = contract.solve(rho, e, lam, stale, par)
    phase, energy = (par.products, e) if side else (par.reactants, e - par.detonation_energy)
    assert mixed.pressure == pytest.approx(eos.pressure(rho, energy, phase), rel=1e-7)
    slope = contract.slopes(rho, e, lam, mixed, par)
    assert contract.sound_speed_squared(rho, mixed.pressure, slope) == pytest.approx(eos.sound_speed_squared(rho, energy, phase), rel=1e-7)
    assert contract.mixture_temperature(lam, mixed, par) == pytest.approx(eos.temperature(rho, energy, phase), rel=1e-7)
