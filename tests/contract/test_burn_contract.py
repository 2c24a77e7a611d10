"""Every registered burn law: bounds, fixed points, monotony, composition of steps, and the rate as the slope of the advance."""

import numpy as np
import pytest

import hugoniot.laws.burn  # noqa: F401  (enrols the laws)
from hugoniot.errors import OutOfRange
from hugoniot.laws.burn import contract
from hugoniot.laws.burn.contract import BURN

RATED = [law for law in BURN if not law.flags & {"programmed", "instantaneous"} and law.name != "beta"]
FRACTIONS = (0.0, 1e-9, 1e-3, 0.02, 0.3, 0.8, 0.97, 1.0 - 1e-9, 1.0)


def states(law, count=30):
    """Random states of the law's box, as (rho, p, temperature)."""
    rng = np.random.default_rng(7)
    box = {"rho": (1500.0, 3000.0), "p": (1e9, 5e10), "temperature": (500.0, 5000.0)} | dict(law.box)
    return [tuple(float(rng.uniform(*box[k])) for k in ("rho", "p", "temperature")) for _ in range(count)]


@pytest.mark.parametrize("law", list(BURN), ids=lambda law: law.name)
def test_fraction_stays_in_bounds_and_never_falls(law):
    """Also for steps far too long: the end is 1, not beyond."""
    par = law.example
    for rho, p, temperature in states(law):
        for lam in FRACTIONS:
            for dt in (0.0, 1e-12, 1e-9, 1e-6, 1.0):
                new = contract.advance(lam, dt, rho, p, temperature, par)
                assert lam <= new <= 1.0
                time = dt + 2e-6
                planned = contract.scheduled(lam, time, 1e-6, 1e-4, rho, par)
                assert lam <= planned <= 1.0


@pytest.mark.parametrize("law", list(BURN), ids=lambda law: law.name)
def test_nothing_burns_without_cause(law):
    """No pressure, no compression, no heat, no lighting: the fraction stays as it is; and burned stays burned, at rate 0."""
    par = law.example
    rho = getattr(par, "rho0", 1700.0)
    for lam in FRACTIONS:
        for p in (0.0, -1e9):
            assert contract.advance(lam, 1e-3, rho, p, 0.0, par) == lam
            assert contract.rate(lam, rho, p, 0.0, par) == 0.0
        assert contract.scheduled(lam, 1.0, 2.0, 1e-4, rho, par) == lam
    for rho, p, temperature in states(law, 10):
        assert contract.rate(1.0, rho, p, temperature, par) == 0.0
        assert contract.advance(1.0, 1e-6, rho, p, temperature, par) == 1.0


@pytest.mark.parametrize("law", RATED, ids=lambda law: law.name)
def test_rate_is_the_slope_of_the_advance(law):
    par = law.example
    checked = 0
    for rho, p, temperature in states(law):
        for lam in (1e-3, 0.1, 0.5, 0.9):
            speed = contract.rate(lam, rho, p, temperature, par)
            if speed == 0.0:
                continue
            h = 1e-5 * lam / speed
            two, one = (contract.advance(lam, k * h, rho, p, temperature, par) - lam for k in (2, 1))
            assert (4.0 * one - two) / (2.0 * h) == pytest.approx(speed, rel=1e-6)
            checked += 1
    assert checked > 20


@pytest.mark.parametrize("law", RATED, ids=lambda law: law.name)
def test_two_half_steps_are_one_step(law):
    """Closed laws to round-off; sub-cycled ones to their tolerance."""
    par = law.example
    tolerance = 3e-5 if "subcycled" in law.flags else 1e-12
    burned = 0
    for rho, p, temperature in states(law):
        for lam in (0.0, 0.01, 0.4, 0.9):
            speed = contract.rate(max(lam, 0.3), rho, p, temperature, par)
            if speed == 0.0:
                continue
            dt = 0.4 / speed
            whole = contract.advance(lam, dt, rho, p, temperature, par)
            halves = contract.advance(contract.advance(lam, 0.5 * dt, rho, p, temperature, par), 0.5 * dt, rho, p, temperature, par)
            assert whole == pytest.approx(halves, abs=tolerance)
            burned += whole > lam
    assert burned > 20


@pytest.mark.parametrize("law", list(BURN), ids=lambda law: law.name)
def test_parameters_are_described(law):
    assert law.summary and law.references
    assert all(law.units[k] and law.meaning[k] for k in law.example._fields)
    if law.build is law.parameters:
        assert law.build(**law.example._asdict()) == law.example


@pytest.mark.parametrize("law", list(BURN), ids=lambda law: law.name)
def test_a_short_advance_is_the_advance_or_says_that_it_is_none(law):
    """Steps from nothing to all, at every burn fraction: the same number to round-off, and a step in which little burns is done."""
    par = law.example
    for rho, p, temperature in states(law, 8):
        for state in ((rho, p, temperature), (rho, -p, temperature), (getattr(par, "rho0", rho), p, temperature)):
            for lam in (*FRACTIONS, 0.8 - 1e-12, 0.02 - 1e-12):
                for dt in (0.0, 1e-12, 1e-10, 1e-9, 1e-7, 1e-4):
                    new, sure = contract.short_advance(lam, dt, *state, par)
                    assert not sure or new == pytest.approx(contract.advance(lam, dt, *state, par), rel=1e-13, abs=0.0)
                    assert sure or lam != 0.3 or dt > 1e-12


def test_an_explosive_at_rest_costs_no_sub_steps(monkeypatch):
    """Composition B (no threshold of compression, lambda^0.222): round-off in the density of a zone at rest is no ignition to be resolved."""
    from hugoniot.laws.burn import ignition_growth as law

    par = BURN.get("ignition_growth").build(1717.0, 4e12, 0.667, 0.0, 7.0, 8.5e-14, 0.667, 0.222, 2.0, g2=6.6e-25, e=1.0, g=0.333, z=3.0,
                                             ignition_limit=0.022, growth_limit=0.6)
    calls = []
    plain = law.burning
    monkeypatch.setattr(law, "burning", lambda *state: calls.append(1) or plain(*state))
    for rho, p in ((1717.0 * (1.0 + 1e-15), 1e-3), (1717.0 * (1.0 + 1e-9), 1e2), (1720.0, 3e7)):
        calls.clear()
        assert law.advance(0.0, 1e-9, rho, p, 0.0, par) < 1e-6
        assert len(calls) <= 16, (rho, len(calls))

@pytest.mark.parametrize(("name", "values", "words"), [
    ("pressure_power", (-1e6, 1.0, 1.0), "rate_constant"), ("pressure_power", (1e6, 1.0, -1.0), "depletion_exponent"),
    ("arrhenius", (1e12, -2e4), "activation_temperature"), ("jwl_plus_plus", (-1e-7, 1.3), "g must"), ("threshold", (-1e9,), "initiation"),
    ("arrhenius", (float("nan"), 2e4), "frequency")])
def test_rates_that_would_run_backwards_are_refused(name, values, words):
    with pytest.raises(OutOfRange, match=words):
        BURN.get(name).build(*values)
