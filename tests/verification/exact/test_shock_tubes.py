"""Riemann problems: printed star states (B1, B2, B3, B13), jumps, fans, conservation, and random gases off the defaults."""

import numpy as np
import pytest
from flow_checks import jump_residual, residuals, total

from hugoniot.errors import OutOfRange
from hugoniot.theory.exact import SOLUTIONS
from hugoniot.theory.exact.riemann_ideal import Side, riemann_ideal

PRINTED = {
    "sod": dict(star_pressure=0.3031301780, star_velocity=0.9274526200, star_density_left=0.4263194281, star_density_right=0.2655737117,
                right_head=1.7521557320),
    "leblanc": dict(star_pressure=5.155779277e-4, star_velocity=0.6218386714, star_density_left=0.05407933535,
                    star_density_right=0.00399999806, right_head=0.8291183625),
    "two_rarefactions": dict(star_pressure=0.00189387342, star_velocity=0.0),
    "collision": dict(star_pressure=1691.646955, star_velocity=8.689774412),
    "water_gas": dict(star_pressure=1.41904772e7, star_velocity=482.610412, star_density_left=804.444632, star_density_right=288.168063,
                      right_head=583.927609),
}


@pytest.mark.parametrize("name", PRINTED)
def test_printed_star_states(name):
    numbers = SOLUTIONS[name]().numbers
    for key, value in PRINTED[name].items():
        assert numbers[key] == pytest.approx(value, rel=3e-9, abs=1e-14), key


def test_leblanc_shock_at_the_printed_place():
    assert SOLUTIONS["leblanc"]().jumps(6.0)[1] == pytest.approx(7.97471, abs=5e-6)


@pytest.mark.parametrize("name", ["sod", "leblanc", "collision", "water_gas"])
def test_every_jump_obeys_rankine_hugoniot(name):
    solution = SOLUTIONS[name]()
    time = {"water_gas": 1e-4, "leblanc": 6.0}.get(name, 0.1)
    for index in range(len(solution.jumps(time))):
        assert jump_residual(solution, time, index) < 1e-6


@pytest.mark.parametrize("name,scale", [("sod", 1.0), ("two_rarefactions", 1.0), ("water_gas", 1e-4)])
def test_fans_obey_the_equations_of_motion(name, scale):
    solution, time = SOLUTIONS[name](), 0.2 * scale
    head, tail = solution.numbers["left_head"], solution.numbers["left_tail"]
    x0 = 0.7 if name == "water_gas" else 0.5
    x = x0 + time * np.linspace(head + 0.05 * (tail - head), tail - 0.05 * (tail - head), 40)
    assert residuals(solution, x, time, 1e-3) < 1e-8


@pytest.mark.parametrize("name,stop,edge", [("sod", 0.2, (0.0, 1.0)), ("leblanc", 6.0, (0.0, 9.0)), ("water_gas", 2e-4, (0.0, 1.0))])
def test_mass_momentum_and_energy_are_conserved_in_a_closed_tube(name, stop, edge):
    solution = SOLUTIONS[name]()
    x0 = {"sod": 0.5, "leblanc": 3.0, "water_gas": 0.7}[name]
    waves = [x0 + stop * solution.numbers[k] for k in ("left_head", "left_tail")]
    edges = sorted({*edge, *waves, *solution.jumps(stop)})
    before = [total(solution, 0.0, (edge[0], x0, edge[1]), f) for f in (mass, energy)]
    assert total(solution, stop, edges, mass) == pytest.approx(before[0], rel=1e-10)
    assert total(solution, stop, edges, energy) == pytest.approx(before[1], rel=1e-9)
    ends = solution(np.array([edge[0], edge[1]]), 0.0)["pressure"]
    assert total(solution, stop, edges, momentum) == pytest.approx((ends[0] - ends[1]) * stop, rel=1e-9)


def mass(f, x):
    return f["density"]


def momentum(f, x):
    return f["density"] * f["velocity"]


def energy(f, x):
    return f["density"] * (f["energy"] + 0.5 * f["velocity"] ** 2)


def test_random_gases_obey_all_relations():
    random = np.random.default_rng(11)
    for _ in range(40):
        left, right = (Side(10 ** random.uniform(-2, 2), random.uniform(-1, 1), 10 ** random.uniform(-2, 2), random.uniform(1.1, 4.0),
                            random.choice([0.0, 5.0])) for _ in range(2))
        solution = riemann_ideal(left, right)
        for index in range(len(solution.jumps(1.0))):
            assert jump_residual(solution, 1.0, index) < 2e-5
        mirrored = riemann_ideal(right._replace(velocity=-right.velocity), left._replace(velocity=-left.velocity))
        x = np.linspace(-8.0, 8.0, 64)
        for name in ("density", "pressure", "energy"):
            assert solution(x, 1.0)[name] == pytest.approx(mirrored(-x, 1.0)[name], rel=1e-10)


def test_vacuum_opens_between_fast_receding_gases():
    gamma = 1.4
    solution = riemann_ideal(Side(1.0, -20.0, 1.0, gamma), Side(2.0, 20.0, 1.0, gamma))
    escape = [-20.0 + 2.0 * np.sqrt(gamma) / (gamma - 1.0), 20.0 - 2.0 * np.sqrt(gamma / 2.0) / (gamma - 1.0)]
    fields = solution(np.array([-26.0, 0.5 * sum(escape), 26.0]), 1.0)
    assert fields["density"].tolist() == [1.0, 0.0, 2.0]
    inside = total(solution, 1.0, [-30.0, -20.0 - np.sqrt(gamma), escape[0]], mass)
    assert inside == pytest.approx(10.0, rel=1e-10)


def test_impossible_states_are_refused():
    with pytest.raises(OutOfRange, match="density > 0"):
        riemann_ideal(Side(-1.0, 0.0, 1.0), Side(1.0, 0.0, 1.0))
    with pytest.raises(OutOfRange, match="holds for times"):
        SOLUTIONS["sod"]()(np.zeros(1), -1.0)
