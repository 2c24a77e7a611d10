"""Simple waves and the gamma = 3 standing wave (B12): the equations of motion, conservation, and known limits."""

import numpy as np
import pytest
from flow_checks import residuals, total

from hugoniot.errors import OutOfRange
from hugoniot.theory.exact import SOLUTIONS
from hugoniot.theory.exact.riemann_ideal import Side, riemann_ideal


@pytest.mark.parametrize("amplitude,half_waves", [(0.1, 2), (-0.3, 1), (0.6, 3)])
def test_standing_wave_obeys_the_equations_and_conserves(amplitude, half_waves):
    solution = SOLUTIONS["double_burgers"](1.7, 2.3, amplitude, 1.4, half_waves)
    time = 0.6 * solution.numbers["breaking_time"]
    assert residuals(solution, np.linspace(0.02, 1.38, 200), time, 5e-4) < 1e-7
    assert solution(np.array([0.0, 1.4]), time)["velocity"] == pytest.approx(0.0, abs=1e-13)
    for content in (lambda f, x: f["density"], lambda f, x: f["density"] * (f["energy"] + 0.5 * f["velocity"] ** 2)):
        assert total(solution, time, (0.0, 1.4), content) == pytest.approx(total(solution, 0.0, (0.0, 1.4), content), rel=1e-11)


def test_standing_wave_steepens_without_bound_at_breaking():
    solution = SOLUTIONS["double_burgers"]()
    assert solution.numbers["breaking_time"] == pytest.approx(1.0 / (0.1 * 2.0 * np.pi), rel=1e-14)
    x = np.linspace(0.0, 1.0, 20001)
    steepest = [np.max(np.abs(np.gradient(solution(x, f * solution.numbers["breaking_time"])["velocity"], x))) for f in (0.5, 0.98)]
    assert steepest[1] > 15.0 * steepest[0]
    with pytest.raises(OutOfRange, match="holds for times"):
        solution(x, solution.numbers["breaking_time"])


def test_the_last_time_of_a_solution_that_ends_in_a_singularity_is_just_below_it():
    solution = SOLUTIONS["coggeshall_noh"](rate=-0.5)
    with pytest.raises(OutOfRange, match="holds for times above 0 s to just below 2 s, not at 2 s"):
        solution(np.array([1.0]), 2.0)


@pytest.mark.parametrize("gamma", [1.2, 1.4, 5.0 / 3.0, 3.0])
def test_piston_pulse_obeys_the_equations_and_keeps_its_mass(gamma):
    solution = SOLUTIONS["piston_pulse"](gamma, 1.3, 0.9, 0.08, 1.0)
    c0, time = np.sqrt(gamma * 0.9 / 1.3), 1.5
    assert solution.numbers["final_position"] == pytest.approx(0.04, rel=1e-14)
    x = np.linspace(0.04 + 0.55 * c0, 1.45 * c0, 100)
    assert residuals(solution, x, time, 1e-3) < 1e-7
    # the third derivative of the pulse jumps at its edges, hence panels and tolerance
    far = 2.5 * c0
    assert total(solution, time, (0.04, 0.5 * c0 + 0.04, 1.5 * c0, far), lambda f, x: f["density"]) == pytest.approx(1.3 * far, rel=1e-9)
    quiet = solution(np.array([0.05, far]), time)
    assert quiet["velocity"] == pytest.approx(0.0, abs=1e-14)


@pytest.mark.parametrize("gamma", [1.1, 1.4, 3.0])
def test_centred_rarefaction_is_half_of_a_riemann_problem(gamma):
    slow = SOLUTIONS["centred_rarefaction"](gamma, 2.0, 3.0, 0.4)
    pair = riemann_ideal(Side(2.0, -0.8, 3.0, gamma), Side(2.0, 0.0, 3.0, gamma))
    x = np.linspace(-0.39, 4.0, 300)
    for name in ("density", "velocity", "pressure", "energy"):
        assert slow(x, 1.0)[name] == pytest.approx(pair(x, 1.0)[name], rel=1e-11, abs=1e-13)


def test_fast_withdrawal_leaves_a_vacuum():
    solution = SOLUTIONS["centred_rarefaction"](1.4, 1.0, 1.0, 10.0)
    escape = solution.numbers["escape_speed"]
    assert escape == pytest.approx(5.0 * np.sqrt(1.4), rel=1e-14)
    fields = solution(np.array([-1.1 * escape, -0.9 * escape, 5.0]), 1.0)
    assert fields["density"][0] == 0.0 and fields["density"][1] > 0.0 and fields["density"][2] == 1.0
    mass = total(solution, 1.0, (-escape, np.sqrt(1.4)), lambda f, x: f["density"])
    assert mass == pytest.approx(np.sqrt(1.4), rel=1e-9)
