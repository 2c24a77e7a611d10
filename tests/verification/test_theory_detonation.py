"""Detonation: verification.md A2 (K-2), A6, B23, B25, H-5."""

import math

import numpy as np
import pytest

from hugoniot.errors import OutOfRange
from hugoniot.laws.eos import contract
from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.laws.eos.jwl import JWL
from hugoniot.theory.chapman_jouguet import cj, overdriven
from hugoniot.theory.hugoniot import Initial, residual, shock
from hugoniot.theory.znd import znd

ONE_STEP = IdealGas(1.2)
AHEAD = Initial(1.0, 1.0, 5.0, heat=50.0)


def test_k2_composition_b_of_the_source():
    found = cj(IdealGas(3.0), Initial(1770.0, 0.0, 0.0, heat=6.27e6))
    assert found.state.particle_velocity == pytest.approx(2503.997, abs=5e-4)
    assert found.state.pressure == pytest.approx(44.3916e9, rel=1e-6)
    assert found.detonation_velocity == pytest.approx(10015.987, abs=5e-4)
    assert (found.state.density, found.state.sound_speed, found.state.specific_internal_energy) == pytest.approx((2360.0, 7511.99, 9.405e6), rel=1e-6)
    # the rounded numbers the source prints
    assert (round(found.state.pressure / 1e9, 2), round(found.state.particle_velocity / 1e3, 2)) == (44.39, 2.50)


def test_h5_pentolite_gamma_law():
    energy = 7991.0**2 / (2 * (2.77**2 - 1))
    assert energy == pytest.approx(4.7847e6, rel=2e-5)
    found = cj(IdealGas(2.77), Initial(1714.0, 0.0, 0.0, heat=energy))
    assert found.detonation_velocity == pytest.approx(7991.0, rel=1e-10)
    assert (found.state.density, found.state.pressure, found.state.particle_velocity) == pytest.approx((2332.77, 29.0317e9, 2119.6), rel=2e-5)


@pytest.mark.parametrize("gamma", [1.2, 1.7, 3.0])
def test_gamma_law_closed_form_with_pressure_ahead(gamma):
    """D^2 = (H + 1) c0^2 + ... : M = sqrt(1 + H) + sqrt(H), H = (gamma^2 - 1) q / (2 c0^2)."""
    p0, rho0, q = 2.0e5, 1.3, 3.0e6
    found = cj(IdealGas(gamma), Initial(rho0, p0, p0 / ((gamma - 1) * rho0), velocity=33.0, heat=q))
    c0 = math.sqrt(gamma * p0 / rho0)
    h = (gamma**2 - 1) * q / (2 * c0**2)
    assert found.detonation_velocity == pytest.approx(c0 * (math.sqrt(1 + h) + math.sqrt(h)), rel=1e-11)


@pytest.mark.parametrize(("numbers", "velocity", "pressure"), [
    ((524.229e9, 7.678e9, 4.2, 1.1, 0.34, 1717.0, 8.5e9), 7980.0, 29.5e9), ((371.213e9, 3.231e9, 4.15, 0.95, 0.30, 1630.0, 7.0e9), 6929.4, 21.0e9),
    ((852.4e9, 18.02e9, 4.6, 1.3, 0.38, 1840.0, 10.2e9), 8800.1, 37.001e9)])
def test_a6_jwl_sets_close_on_their_cj_states(numbers, velocity, pressure):
    found = cj(JWL(*numbers))
    assert found.detonation_velocity == pytest.approx(velocity, rel=3e-4)
    assert found.state.pressure == pytest.approx(pressure, rel=1e-3)
    assert found.tangency < 1e-10


@pytest.mark.parametrize("name", [law.name for law in contract.EOS if "reacted" in law.flags or law.name in ("ideal_gas", "stiffened_gas")])
def test_tangency_off_the_defaults(name):
    """Loose and dense charges, other constants, heat released besides, explosive that moves."""
    law, rng = contract.EOS.get(name), np.random.default_rng(3)
    for _ in range(15):
        par = type(law.example)(*(v * rng.uniform(0.9, 1.1) for v in law.example))
        heat = rng.choice([1e6, 4e6] if "reacted" not in law.flags else [0.0, 1e6, 4e6])
        ahead = Initial(par.rho0 * rng.uniform(0.6, 1.1), 0.0, contract.reference_state(par)[1], velocity=rng.uniform(-500.0, 500.0), heat=heat)
        found = cj(par, ahead)
        assert found.tangency < 1e-10
        assert residual(par, ahead, found.state) < 1e-12


def test_b25_tangency_for_every_law_of_products():
    checked = 0
    for law in contract.EOS:
        if "reacted" in law.flags:
            found = cj(law.example)
            assert found.tangency < 1e-10, law.name
            assert residual(law.example, found.initial, found.state) < 1e-12, law.name
            # least velocity: neighbours on the detonation Hugoniot need a faster front
            near = shock(law.example, found.initial, density=found.state.density * np.array([0.99, 1.01]))
            assert (near.shock_velocity > found.state.shock_velocity).all(), law.name
            # sonic: u + c = D
            assert found.state.particle_velocity + found.state.sound_speed == pytest.approx(found.detonation_velocity, rel=1e-9)
            checked += 1
    assert checked >= 2


def test_overdriven_branches_meet_at_cj():
    law = JWL(371.213e9, 3.231e9, 4.15, 0.95, 0.30, 1630.0, 7.0e9)
    point = cj(law)
    speeds = point.detonation_velocity * np.array([1.0, 1.0001, 1.05, 1.2])
    strong, weak = (overdriven(law, shock_velocity=speeds, branch=b) for b in ("strong", "weak"))
    assert strong.shock_velocity == pytest.approx(speeds, rel=1e-10) and weak.shock_velocity == pytest.approx(speeds, rel=1e-10)
    assert strong.pressure[0] == pytest.approx(point.state.pressure, rel=1e-9)
    assert (strong.pressure[1:] > point.state.pressure).all() and (weak.pressure[1:] < point.state.pressure).all()
    for s, d in zip(np.asarray(strong.sound_speed + strong.particle_velocity)[1:], speeds[1:]):
        assert s > d  # subsonic behind an overdriven front
    with pytest.raises(OutOfRange, match="slower than the Chapman-Jouguet"):
        overdriven(law, shock_velocity=6500.0)
    with pytest.raises(OutOfRange, match="no Chapman-Jouguet point"):
        cj(IdealGas(1.4), Initial(1.2, 1e5, 1e5 / 0.48))


def test_b23_one_step_detonation():
    rate = arrhenius(1.0)
    plain = znd(ONE_STEP, AHEAD, rate)
    assert plain.velocity == pytest.approx(6.80947463, abs=1e-8)
    assert (plain.von_neumann.pressure, 1 / plain.von_neumann.density) == pytest.approx((42.06268, 0.114436), rel=5e-6)
    driven = znd(ONE_STEP, AHEAD, rate, overdrive=1.6)
    assert driven.velocity == pytest.approx(8.61337980, abs=1e-8)
    assert driven.von_neumann.pressure == pytest.approx(67.354829, abs=1e-6)
    assert driven.half_reaction_length == pytest.approx(231.16, abs=5e-3)  # k that makes L1/2 = 1
    assert znd(ONE_STEP, AHEAD, arrhenius(231.16), overdrive=1.6).half_reaction_length == pytest.approx(1.0, abs=3e-5)


def arrhenius(k):
    return lambda rho, e, p, fraction: k * (1.0 - fraction) * math.exp(-50.0 * rho / p)


def test_zone_obeys_the_conservation_laws_and_its_rate():
    found = znd(ONE_STEP, AHEAD, arrhenius(1.0), overdrive=1.3, points=60)
    s = found.states
    w = found.velocity - s.particle_velocity
    fraction = s.extra["reaction"]
    assert s.density * w == pytest.approx(np.full(60, found.velocity), rel=1e-12)
    assert s.pressure + s.density * w**2 == pytest.approx(np.full(60, 1.0 + found.velocity**2), rel=1e-12)
    enthalpy = s.specific_internal_energy + s.pressure / s.density + 0.5 * w**2 - 50.0 * fraction
    assert enthalpy == pytest.approx(np.full(60, enthalpy[0]), rel=1e-11)
    # rate: an independent integration of d(fraction)/dt with the energy of an ideal gas on the Rayleigh line
    assert found.half_reaction_time == pytest.approx(half_time_by_runge_kutta(found.velocity), rel=1e-7)


def half_time_by_runge_kutta(d):
    """RK4 for the fraction in time; the state by the quadratic of the gamma law on the Rayleigh line."""
    def pressure_and_density(z):
        g, m2 = 1.2, d * d
        # e = p v/(g-1) on p = 1 + m2 x, v = 1 - x: a x^2 + b x + c = 0
        a = m2 * (-1 / (g - 1) - 0.5)
        b = (m2 - 1) / (g - 1) - 1.0
        c = 1 / (g - 1) - 5.0 - 50.0 * z
        x = (-b - math.sqrt(b * b - 4 * a * c)) / (2 * a)
        return 1 + m2 * x, 1 / (1 - x)

    def rate(z):
        p, rho = pressure_and_density(z)
        return (1 - z) * math.exp(-50.0 * rho / p)

    z, t, n = 0.0, 0.0, 4000
    step = 0.5 / n
    for _ in range(n):  # dt/dz
        k1, k2, k4 = 1 / rate(z), 1 / rate(z + 0.5 * step), 1 / rate(z + step)
        t += step / 6 * (k1 + 4 * k2 + k4)
        z += step
    return t
