"""Normal modes of the plane detonation against published stability boundaries and the wave's own numbers."""

import json
import math

import pytest
from typer.testing import CliRunner

from hugoniot.cli.main import build_app
from hugoniot.errors import OutOfRange
from hugoniot.theory.stability import Wave, neutral_activation


def test_the_steady_wave_has_the_numbers_of_the_field():
    assert Wave(1.2, 50.0, 26.0, 1.001).rate_constant == pytest.approx(42.03968, rel=1e-6)
    assert Wave(1.2, 50.0, 25.0, 1.001).rate_constant == pytest.approx(35.86721, rel=1e-6)
    strong = Wave(1.2, 50.0, 50.0, 1.6)
    assert strong.velocity == pytest.approx(8.61337980, rel=1e-8) and strong.rate_constant == pytest.approx(231.16, rel=1e-5)
    rho, u, p = strong.state(0.0)
    assert p == pytest.approx(67.354829, rel=1e-7) and rho * u == pytest.approx(-strong.velocity, rel=1e-13)
    for burned in (0.0, 0.3, 1.0):      # energy through the front: h + u^2/2 is what it was, and the heat
        rho, u, p = strong.state(burned)
        assert 6.0 * p / rho + 0.5 * u * u == pytest.approx(6.0 + 0.5 * strong.velocity**2 + 50.0 * burned, rel=1e-12)


def test_the_shock_slopes_are_the_derivatives_of_the_jump():
    wave = Wave(1.2, 50.0, 30.0, 1.2)
    h = 1e-5 * wave.overdrive
    high, low = (Wave(1.2, 50.0, 30.0, wave.overdrive + s * h) for s in (1, -1))
    step = high.velocity - low.velocity
    slopes = [(a - b) / step for a, b in zip(high.state(0.0), low.state(0.0))]
    found = wave._shock_slopes
    assert (found[0], found[2]) == pytest.approx((slopes[0], slopes[2]), rel=1e-7)
    assert found[1] == pytest.approx(1.0 + slopes[1], rel=1e-7)      # the velocity is seen from the front, which moves


def test_a_mode_is_a_zero_whatever_the_guess():
    wave = Wave(1.2, 50.0, 50.0, 1.6)
    modes = [wave.mode(guess) for guess in (0.1 + 0.85j, 0.2 + 1.0j)]
    assert modes[0].growth == pytest.approx(modes[1].growth, rel=1e-8) and modes[0].residual < 1e-8
    assert abs(wave.residual(complex(modes[0].growth, -modes[0].frequency))) < 1e-8      # and its conjugate
    assert abs(wave.residual(1.01 * complex(modes[0].growth, modes[0].frequency))) > 1e-3
    assert 6.8 < 2.0 * math.pi / modes[0].frequency < 7.5      # near the period of the finite pulsation, 7.3 to 7.5


def test_the_neutral_boundary_of_the_cj_wave():
    """E = 25.26 for gamma 1.2, Q 50 (Henrick, Aslam and Powers give 25.265): from two overdrives to f = 1."""
    near, nearer = (neutral_activation(1.2, 50.0, f, 25.0, 25.6, 0.0 + 0.53j) for f in (1.002, 1.001))
    limit = 2.0 * nearer.growth - near.growth
    assert limit == pytest.approx(25.263, abs=0.005)
    assert nearer.frequency == pytest.approx(0.5317, abs=1e-3)
    assert Wave(1.2, 50.0, 26.0, 1.001).mode(0.03 + 0.52j).growth > 0.0 > Wave(1.2, 50.0, 25.0, 1.001).mode(0.03 + 0.52j).growth


def test_the_command_prints_the_modes_and_refuses_a_sonic_end():
    out = CliRunner().invoke(build_app("eos"), ["eos", "stability", "--activation", "26", "--overdrive", "1.1", "--highest", "0.6", "--json"])
    assert out.exit_code == 0, out.output
    assert json.loads(out.stdout)["rate_constant"] == pytest.approx(Wave(1.2, 50.0, 26.0, 1.1).rate_constant, rel=1e-12)
    with pytest.raises(OutOfRange, match="at least 1.0005"):
        Wave(1.2, 50.0, 26.0, 1.0)
