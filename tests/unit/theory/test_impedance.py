"""Impedance matching: closed forms, the published Cu/PMMA/Cu ring-up, release into softer layers, error bars."""

import numpy as np
import pytest

from hugoniot.errors import OutOfRange
from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.theory.hugoniot import Initial, residual
from hugoniot.theory.impedance import free_surface, match, ring_up
from hugoniot.theory.uncertainty import propagate, vary

CU = MieGruneisen(8930.0, 3940.0, 1.489, 1.99)
PMMA = MieGruneisen(1186.0, 2598.0, 1.516, 0.97)
AL = MieGruneisen(2785.0, 5328.0, 1.338, 2.0)


def test_symmetric_impact_and_quadratic_formula():
    first = match([AL, AL], 1000.0)[0]
    assert first.particle_velocity == pytest.approx(500.0, rel=1e-13)
    # two linear Us-up laws from rest: rho1 (c1 + s1 (v - u)) (v - u) = rho2 (c2 + s2 u) u
    v = 1000.0
    a = 2785.0 * 1.338 - 8930.0 * 1.489
    b = 2785.0 * 5328.0 + 8930.0 * (3940.0 + 2 * 1.489 * v)
    c = -8930.0 * (3940.0 + 1.489 * v) * v
    u = (-b + np.sqrt(b * b - 4 * a * c)) / (2 * a)
    found = match([CU, AL], v)[0]
    assert found.particle_velocity == pytest.approx(u, rel=1e-12)
    assert found.wave_left == found.wave_right == "shock"


def test_copper_pmma_copper_of_the_source():
    """Jordan fig. 4.2.3: plateau 1.989 GPa and 499.8 m/s, reshock 4.198 GPa and 114.4 m/s, ring-up to 10.79 GPa."""
    met = ring_up([CU, PMMA, CU], 555.0, bounces=30)
    assert (met[0].pressure, met[0].particle_velocity) == pytest.approx((1.989e9, 499.8), rel=1e-3)
    assert (met[1].pressure, met[1].particle_velocity) == pytest.approx((4.198e9, 114.4), rel=1e-3)
    # the ring-up ends at the direct impact of copper on copper but for the entropy of the steps
    assert met[-1].pressure == pytest.approx(10.79e9, rel=2e-3)
    assert met[-1].particle_velocity == pytest.approx(277.5, abs=0.3)
    assert all(np.diff([m.pressure for m in met]) > 0.0)
    assert [m.interface for m in met[:5]] == [0, 1, 0, 1, 0]


def test_layers_in_time_order_with_reshock_and_release():
    met = match([CU, PMMA, AL, PMMA], 800.0)
    assert [m.interface for m in met] == [0, 1, 2]
    assert [m.wave_left for m in met] == ["shock", "shock", "fan"]
    assert met[1].pressure > met[0].pressure > 0 and met[2].pressure < met[1].pressure
    for k, m in enumerate(met):
        assert m.left.pressure == pytest.approx(m.right.pressure, rel=1e-9)
        assert m.left.particle_velocity == pytest.approx(m.right.particle_velocity, abs=1e-6)
        layer = (PMMA, AL, PMMA)[k]
        assert residual(layer, Initial.at_rest(layer), m.right) < 1e-12
    assert residual(PMMA, Initial.of(met[0].right), met[1].left) < 1e-12  # the reshock


def test_release_into_gas_is_nearly_the_free_surface():
    met = match([AL, AL, IdealGas(1.4)], 1000.0)
    surface = free_surface(AL, met[0].right)
    assert surface.pressure == 0.0
    assert met[1].particle_velocity == pytest.approx(surface.particle_velocity, rel=2e-3)
    assert met[1].wave_left == "fan"


def test_nothing_to_match_is_refused():
    with pytest.raises(OutOfRange, match="does not strike"):
        match([CU, AL], -10.0)
    with pytest.raises(OutOfRange, match="at least one target"):
        match([CU], 10.0)
    with pytest.raises(OutOfRange, match="does not have two neighbours"):
        ring_up([CU, AL], 100.0)


def answer(v, c0, s):
    found = match([vary(CU, c0=c0, s=s), vary(CU, c0=c0, s=s)], v)[0]
    return {"p": found.pressure, "u": found.particle_velocity}


VALUES, SIGMAS = {"v": 1000.0, "c0": 3940.0, "s": 1.489}, {"v": 8.0, "c0": 30.0, "s": 0.02}


def test_linear_error_bars_are_the_analytic_ones():
    """Symmetric impact: p = rho0 (c0 + s v/2) v/2, so every derivative is known."""
    found = propagate(answer, VALUES, SIGMAS, correlation={("c0", "s"): -0.8})
    rho, v = 8930.0, 1000.0
    parts = np.array([rho * (3940.0 / 2 + 1.489 * v / 2) * 8.0, rho * v / 2 * 30.0, rho * v * v / 4 * 0.02])
    variance = (parts**2).sum() - 2 * 0.8 * parts[1] * parts[2]
    assert found["p"].sigma == pytest.approx(np.sqrt(variance), rel=1e-7)
    assert found["u"].sigma == pytest.approx(4.0, rel=1e-9)
    assert found["u"].shares["v"] == pytest.approx(1.0, abs=1e-9)


def test_monte_carlo_agrees_and_repeats():
    linear = propagate(answer, VALUES, SIGMAS, correlation={("c0", "s"): -0.8})["p"]
    sampled = propagate(answer, VALUES, SIGMAS, correlation={("c0", "s"): -0.8}, samples=500, seed=4)["p"]
    assert sampled.sigma == pytest.approx(linear.sigma, rel=0.1)  # three times 1/sqrt(2 x 500)
    assert sampled == propagate(answer, VALUES, SIGMAS, correlation={("c0", "s"): -0.8}, samples=500, seed=4)["p"]
    assert sampled.low == pytest.approx(linear.low, rel=2e-3)


def test_impossible_error_bars():
    with pytest.raises(OutOfRange, match="no such parameter: x"):
        propagate(answer, VALUES, {"x": 1.0})
    with pytest.raises(OutOfRange, match="finite"):
        propagate(answer, VALUES, {"v": -1.0})
    with pytest.raises(OutOfRange, match="contradict"):
        propagate(answer, VALUES, SIGMAS, correlation={("c0", "s"): 0.9, ("c0", "v"): 0.9, ("s", "v"): -0.9})
    with pytest.raises(OutOfRange, match="it has rho0"):
        vary(CU, gama0=1.0)
    assert propagate(answer, VALUES, {})["u"].sigma == 0.0
