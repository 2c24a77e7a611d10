"""Normal modes of the plane detonation against published stability boundaries and the wave's own numbers."""

import json
import math

import pytest
from typer.testing import CliRunner

from hugoniot.cli.eos.input import find_reactive
from hugoniot.cli.main import build_app
from hugoniot.errors import OutOfRange
from hugoniot.laws.burn.arrhenius import Arrhenius
from hugoniot.laws.burn.ignition_growth import IgnitionGrowth
from hugoniot.laws.burn.pressure_power import PressurePower
from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.theory.mixture import mixture
from hugoniot.theory.normal_modes import ModesOfZone
from hugoniot.theory.stability import Wave, neutral_activation
from hugoniot.theory.upstream import Initial
from hugoniot.theory.znd import zone_of


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


# -- any law, mixture and rate ---------------------------------------------------------------------------------------------
GAS = IdealGas(1.2, 5.0, 1.0)


@pytest.mark.parametrize("law, heat", [(GAS, 50.0), (mixture("weighted_pressures", GAS, GAS, 50.0), 0.0)])
def test_the_general_problem_has_the_modes_of_the_one_step_wave(law, heat):
    wave = Wave(1.2, 50.0, 50.0, 1.6)
    wanted = wave.mode(0.12 + 0.88j)
    zone = ModesOfZone(law, Initial(1.0, 1.0, 5.0, heat=heat), Arrhenius(wave.rate_constant, 50.0), 1.6)
    assert (zone.velocity, zone.length) == pytest.approx((wave.velocity, 1.0), rel=1e-12)
    found = zone.mode((0.12 + 0.88j) / wave.velocity)      # times there are lengths over D
    assert (found.growth, found.frequency) == pytest.approx((wanted.growth / wave.velocity, wanted.frequency / wave.velocity), rel=1e-7)


def lx_17():
    material = find_reactive("lx_17")[0].material
    return mixture("thermal_isolation", material.unreacted, material.eos, material.detonation_energy), material


@pytest.mark.parametrize("case", ["gases", "lx_17"])
def test_without_time_the_perturbation_is_the_change_of_the_zone_with_its_velocity(case):
    """Isolated reactants, whose isentrope starts from the shock, and a rate whose terms set in and end at burn fractions."""
    if case == "gases":
        law = mixture("thermal_isolation", IdealGas(1.3, 5.0, 1.0), GAS, 50.0)
        ahead, rate, overdrive = Initial(1.0, 1.0, 1.0 / 0.3), PressurePower(1.0, 2.0, 1.0, 40.0), 1.3
    else:
        law, material = lx_17()
        ahead, rate, overdrive = Initial.at_rest(material.unreacted), material.burn, 1.1
    zone, h, ends = ModesOfZone(law, ahead, rate, overdrive), 1e-4, []
    for faster in (1.0 + h, 1.0 - h):
        other, _, _ = zone_of(law, ahead, rate, overdrive=overdrive * faster**2)
        other.at(0.5)
        end = other.at(1.0 - 1e-10)
        ends.append((end.density / ahead.density, faster * (1.0 - ahead.density / end.density),
                     end.pressure / (ahead.density * zone.velocity**2)))
    change = [(a - b) / (2.0 * h) for a, b in zip(*ends)]
    assert zone.perturbation(0.0)[:3].real == pytest.approx(change, rel=2e-6)
    assert abs(zone.residual(0.5j)) > 0.1 and zone.perturbation(0.0)[4] == 1.0


def test_a_rate_without_a_beginning_has_no_linear_answer_and_options_are_not_mixed():
    with pytest.raises(OutOfRange, match="positive at zero burn fraction"):
        ModesOfZone(GAS, Initial(1.0, 1.0, 5.0, heat=50.0), IgnitionGrowth(1.0, 0.0, 0.7, 0.0, 4.0, 1.0, 0.7, 0.3, 1.0, 0.0), 1.6)
    for arguments, words in ((["lx_17", "--gamma", "1.3"], "ideal gas"), (["--rate", "pressure_power: k = 1"], "name one")):
        out = CliRunner().invoke(build_app("eos"), ["eos", "stability", *arguments])
        assert out.exit_code != 0 and words in out.output + str(out.exception)
