"""Detonation solutions: printed numbers (B21, B22, B24), conservation, the equations of motion, shortest paths by another route."""

import numpy as np
import pytest
from flow_checks import jump_residual, residuals, total
from scipy.integrate import solve_ivp
from scipy.optimize import minimize

from hugoniot.errors import OutOfRange
from hugoniot.theory.exact import SOLUTIONS
from hugoniot.theory.exact.kenamond import nested, obstacle, single
from hugoniot.theory.exact.plate_push import asymmetric_sandwich, gurney, terminal_velocity


@pytest.mark.parametrize("ratio,speed", [(0.1, 4510.3), (0.5, 2358.0), (1.0, 1543.8), (2.0, 926.6), (5.0, 425.0)])
def test_printed_plate_speeds(ratio, speed):
    assert terminal_velocity(ratio, 8000.0) == pytest.approx(speed, abs=0.0502)  # 926.54993 is printed 926.6


@pytest.mark.parametrize("ratio", [0.1, 0.7, 4.0])
def test_plate_obeys_its_equation_of_motion(ratio):
    solution = SOLUTIONS["plate_push"](ratio, 7000.0, 1700.0, 0.05)
    arrival, mass = 0.05 / 7000.0, ratio * 1700.0 * 0.05

    def rates(t, y):
        return [y[1], 16.0 / 27.0 * 1700.0 * (y[0] / t - y[1]) ** 3 / 7000.0 / mass]

    run = solve_ivp(rates, (arrival, 40 * arrival), [0.05, 0.0], method="DOP853", rtol=1e-12, atol=1e-12, dense_output=True)
    for time in (1.5 * arrival, 6 * arrival, 40 * arrival):
        fields = solution(np.zeros(1), time)
        assert [fields["position"][0], fields["velocity"][0]] == pytest.approx(run.sol(time), rel=1e-8)
    late = solution(np.zeros(1), 1e6 * arrival)
    assert late["velocity"][0] == pytest.approx(solution.numbers["terminal_velocity"], rel=1e-5)
    cj = 1700.0 * 7000.0**2 / 4.0
    assert solution(np.zeros(1), arrival * (1 + 1e-12))["pressure"][0] == pytest.approx(64.0 / 27.0 * cj, rel=1e-9)


@pytest.mark.parametrize("configuration,speed", [("open", 1.4789), ("symmetric", 2.3383), ("cylinder", 2.2045), ("sphere", 2.1345)])
def test_printed_gurney_speeds(configuration, speed):
    assert gurney(configuration, 1.0, 2.7) == pytest.approx(speed, abs=5.1e-5)


@pytest.mark.parametrize("ratio", [0.2, 1.0, 5.0])
def test_gurney_formulas_balance_energy_and_momentum(ratio):
    """Unit charge mass with 2E = 1, velocity linear from rest (or from the free face of the open sandwich) to the plate."""
    v = {name: gurney(name, ratio, 1.0) for name in ("symmetric", "cylinder", "sphere", "open")}
    for name, d in (("symmetric", 1), ("cylinder", 2), ("sphere", 3)):
        r = (np.arange(100000) + 0.5) / 100000
        gas = np.mean(d * r ** (d - 1) * r**2)
        assert v[name] ** 2 * (ratio + gas) == pytest.approx(1.0, rel=1e-8)
    rear = -v["open"] * (1.0 + 2.0 * ratio)  # momentum: gas mean velocity = -M v
    assert 0.5 * (rear + v["open"]) == pytest.approx(-ratio * v["open"], rel=1e-13)
    assert v["open"] ** 2 * ratio + (rear**2 + rear * v["open"] + v["open"] ** 2) / 3.0 == pytest.approx(1.0, rel=1e-13)
    with pytest.raises(OutOfRange, match="configuration"):
        gurney("torus", 1.0, 2.7)


@pytest.mark.parametrize("plate, tamper", [(0.3, 2.0), (1.0, 0.4), (4.0, 4.0), (0.5, 0.0)])
def test_a_tamped_plate_balances_momentum_and_energy_of_uniform_gas(plate, tamper):
    """Unit charge mass with 2E = 1, spread evenly between the plates; momentum and energy summed over thin layers of gas."""
    v, w = asymmetric_sandwich(plate, tamper, 1.0)
    gas = -w + (v + w) * (np.arange(100000) + 0.5) / 100000
    assert plate * v - tamper * w + np.mean(gas) == pytest.approx(0.0, abs=1e-12)
    assert plate * v**2 + tamper * w**2 + np.mean(gas**2) == pytest.approx(1.0, rel=1e-8)


def test_a_tamper_as_heavy_as_the_plate_is_the_symmetric_sandwich_and_a_wall_the_limit():
    assert asymmetric_sandwich(0.7, 0.7, 2.7) == pytest.approx([gurney("symmetric", 1.4, 2.7)] * 2, rel=1e-13)
    assert asymmetric_sandwich(0.7, 1e9, 2.7) == pytest.approx([gurney("symmetric", 0.7, 2.7), 0.0], rel=1e-8, abs=1e-8)
    with pytest.raises(OutOfRange, match="tamper"):
        asymmetric_sandwich(0.7, -0.1, 2.7)


def test_printed_reaction_zone():
    solution = SOLUTIONS["fickett_rivard"]()
    numbers = solution.numbers
    assert numbers["cj_pressure"] == pytest.approx(28.9e9, rel=1e-14)
    assert numbers["vn_pressure"] == pytest.approx(57.8e9, rel=1e-14)
    assert numbers["zone_length"] == pytest.approx(0.53125e-2, rel=1e-13)
    assert numbers["heat_of_reaction"] == pytest.approx(0.045156e8, rel=1e-5)
    # a particle shocked tau = 0.4 us ago: lambda = t(2 - t), p = p_j (2 - t)
    back = 8500.0 * (0.5 * 0.4 + 0.125 * 0.16) * 1e-6
    fields = solution(np.array([8500e-6 - back]), 1e-6)
    assert fields["burn_fraction"][0] == pytest.approx(0.4 * 1.6, rel=1e-12)
    assert fields["pressure"][0] == pytest.approx(28.9e9 * 1.6, rel=1e-12)


@pytest.mark.parametrize("gamma", [1.3, 2.0, 3.0])
def test_reaction_zone_obeys_flow_and_rate_equations(gamma):
    solution = SOLUTIONS["fickett_rivard"](7000.0, 1500.0, gamma, 3e6)
    time, zone = 2e-6, solution.numbers["zone_length"]
    x = 7000.0 * time - zone * np.linspace(0.1, 0.9, 30)
    assert residuals(solution, x, time, 1e-4) < 1e-7
    assert jump_residual(solution, time, 0) < 1e-6
    h, tau = 1e-4 * zone, 1e-10
    rate = (solution(x, time + tau)["burn_fraction"] - solution(x, time - tau)["burn_fraction"]) / (2 * tau)
    rate += solution(x, time)["velocity"] * (solution(x + h, time)["burn_fraction"] - solution(x - h, time)["burn_fraction"]) / (2 * h)
    assert rate == pytest.approx(3e6 * np.sqrt(1.0 - solution(x, time)["burn_fraction"]), rel=1e-5)


def test_printed_taylor_wave():
    numbers = SOLUTIONS["mader"]().numbers
    assert numbers["cj_pressure"] == pytest.approx(30e9, rel=1e-14)
    assert numbers["tail_speed"] == pytest.approx(4000.0, rel=1e-14)


@pytest.mark.parametrize("gamma,piston", [(3.0, 0.0), (3.0, 700.0), (1.4, 0.0), (2.7, -500.0)])
def test_taylor_wave_conserves_and_is_a_chapman_jouguet_detonation(gamma, piston):
    solution = SOLUTIONS["mader"](7000.0, 1600.0, gamma, piston)
    time, d = 3e-6, 7000.0
    release = solution.numbers["heat_of_reaction"]
    assert jump_residual(solution, time, 0, release) < 1e-6
    tail = solution.numbers["tail_speed"] * time
    edges = (piston * time, tail, d * time)
    assert total(solution, time, edges, lambda f, x: f["density"]) == pytest.approx(1600.0 * d * time, rel=1e-10)
    held = total(solution, time, edges, lambda f, x: f["density"] * (f["energy"] + 0.5 * f["velocity"] ** 2))
    assert held == pytest.approx(1600.0 * d * time * release + solution.numbers["tail_pressure"] * piston * time, rel=1e-10)
    assert residuals(solution, np.linspace(1.05 * tail, 0.98 * d * time, 40), time, 1e-3) < 1e-8
    behind = solution(np.array([d * time * (1 - 1e-12)]), time)
    assert behind["velocity"][0] + behind["sound_speed"][0] == pytest.approx(d, rel=1e-10)


@pytest.mark.parametrize("piston", [0.0, 500.0, 1500.0])
def test_escaping_products_conserve_mass_momentum_and_energy(piston):
    solution = SOLUTIONS["ehep"](8500.0, 1600.0, piston, 0.01)
    d, release = 8500.0, 8500.0**2 / 16.0
    work, impulse, last = 0.0, 0.0, 0.0
    pressure = lambda t: float(solution(np.array([piston * t * (1 + 1e-12) + 1e-15]), t)["pressure"][0])  # noqa: E731
    for time in (1e-6, 2.2e-6, 5e-6, 9e-6):
        cuts = np.unique(np.clip([last, solution.numbers["piston_meets_escape_wave"], time], last, time))
        for a, b in zip(cuts[:-1], cuts[1:]):
            nodes, weights = np.polynomial.legendre.leggauss(60)
            push = sum(0.5 * (b - a) * w * pressure(0.5 * (a + b) + 0.5 * (b - a) * n) for n, w in zip(nodes, weights))
            impulse, work = impulse + push, work + push * piston
        last = time
        fan, start = (2 * piston + d / 2) * time, solution.numbers["escape_time"]
        places = [piston * time, fan, 0.01 - d / 2 * (time - start), d * time, max(0.01, d * time)]
        edges = np.unique(np.clip(places, piston * time, max(0.01, d * time)))
        burnt = 1600.0 * min(0.01, d * time)
        assert total(solution, time, edges, lambda f, x: f["density"]) == pytest.approx(16.0, rel=2e-8)
        assert total(solution, time, edges, lambda f, x: f["density"] * f["velocity"]) == pytest.approx(impulse, rel=2e-7)
        held = total(solution, time, edges, lambda f, x: f["density"] * (f["energy"] + 0.5 * f["velocity"] ** 2))
        assert held == pytest.approx(burnt * release + work, rel=2e-7)


def test_escaping_products_obey_the_equations_in_every_region():
    solution = SOLUTIONS["ehep"]()
    for time, x in ((2e-6, np.linspace(0.0020, 0.0050, 20)), (2e-6, np.linspace(0.0075, 0.0160, 20)), (2.9e-6, np.linspace(0.0040, 0.0130, 20)),
                    (6e-6, np.linspace(0.0040, 0.0100, 20)), (6e-6, np.linspace(0.0335, 0.0500, 20))):
        assert residuals(solution, x, time, 1e-4) < 1e-7


def test_burn_times_along_straight_lines():
    points = np.array([[3.0, 4.0, 0.0], [0.0, 0.0, 2.0]])
    assert single(points, 2.0) == pytest.approx([2.5, 1.0], rel=1e-14)
    assert single(points, 2.0, ((0, 0, 0), (0, 0, 3)), (0.0, 0.1)) == pytest.approx([2.5, 0.6], rel=1e-14)


def test_nested_explosives_against_a_search_for_the_fastest_path():
    points = np.array([[0.0, 1.0], [4.0, 0.5], [1.0, 4.5], [-3.0, -3.0], [4.5, 0.0]])
    found = nested(points, 3.0, 2.0, 1.0, ((0.0, 5.0),), (2.0,))
    for point, time in zip(points, found):
        direct = np.linalg.norm(point)

        def through(angle, point=point):
            leave = 3.0 * np.array([np.cos(angle[0]), np.sin(angle[0])])
            return 1.5 + np.linalg.norm(point - leave)

        centre = direct / 2.0 if direct <= 3.0 else min(minimize(through, [a], method="Nelder-Mead", options=dict(xatol=1e-10)).fun for a in np.arange(0, 6.3, 0.7))
        outside = 2.0 + np.linalg.norm(point - [0.0, 5.0]) if direct > 3.0 else np.inf
        seen = outside if _clear(point, np.array([0.0, 5.0]), 3.0) else np.inf
        assert time == pytest.approx(min(centre, seen), rel=1e-7)
    with pytest.raises(OutOfRange, match="before the front from its centre"):
        nested(points, 3.0, 2.0, 1.0, ((0.0, 3.2),), (0.0,))


def _clear(a, b, radius):
    s = np.linspace(0.0, 1.0, 2001)[:, None]
    return np.min(np.linalg.norm(a + s * (b - a), axis=1)) >= radius * (1 - 1e-12)


def test_obstacle_against_a_string_pulled_taut():
    detonator = np.array([0.0, 5.0])
    for point in (np.array([4.0, 3.0]), np.array([1.0, -4.0]), np.array([-3.2, -1.0]), np.array([0.5, -3.1])):
        time = float(obstacle(point, 2.0, 3.0, detonator))
        side = 1.0 if point[0] >= 0 else -1.0
        start, end = np.pi / 2, np.arctan2(point[1], point[0])
        end = end if side > 0 else (end if end > 0 else end + 2 * np.pi)
        angles = np.linspace(start, end, 4001)[1:-1]
        ring = 3.0 * np.stack([np.cos(angles), np.sin(angles)], axis=1)
        if _clear(point, detonator, 3.0):
            length = np.linalg.norm(point - detonator)
        else:
            # tangent points by the least total length of leave, arc, arrive over the ring's own points
            leave = np.linalg.norm(ring - detonator, axis=1) + np.where(_seen(ring, detonator), 0.0, np.inf)
            arrive = np.linalg.norm(ring - point, axis=1) + np.where(_seen(ring, point), 0.0, np.inf)
            walk = 3.0 * np.abs(angles - start)
            best = np.minimum.accumulate(leave - walk) + walk + arrive
            length = np.min(best)
        assert time == pytest.approx(length / 2.0, rel=1e-6)
    assert np.isnan(obstacle(np.array([0.0, 1.0]), 2.0, 3.0, detonator))


def _seen(ring, place):
    """Ring points whose straight line to `place` stays outside: the outward normal must not point away from it."""
    return np.sum(ring * (place - ring), axis=1) >= -1e-3 * 9.0
