"""Elastic-plastic piston and stopping shells: printed numbers (B14 to B17), jump conditions, and an independent motion in time."""

from importlib import import_module

import numpy as np
import pytest
from flow_checks import jump_residual
from scipy.integrate import solve_ivp

from hugoniot.errors import NoSolution, OutOfRange
from hugoniot.theory.exact import SOLUTIONS
from hugoniot.theory.exact.shell_stopping import shell_stopping

ep = import_module("hugoniot.theory.exact.elastic_plastic_piston")  # the package's name of it is the function


@pytest.mark.parametrize("name,printed", [
    ("aluminium_piston", dict(elastic_stress=0.635878e9, elastic_velocity=35.1784, elastic_wave_speed=6490.43, plastic_stress=6.635879e9,
                              plastic_pressure=6.435879e9, plastic_density=2985.629, plastic_wave_speed=5908.52)),
    ("copper_piston", dict(elastic_stress=0.199030e9, elastic_velocity=4.71982, elastic_wave_speed=4722.18, plastic_stress=0.741591e9,
                           plastic_pressure=0.681591e9, plastic_density=8973.453, plastic_wave_speed=3976.95)),
    ("udaykumar_piston", dict(elastic_stress=0.537991e9, plastic_stress=1.618843e9))])
def test_printed_waves(name, printed):
    numbers = SOLUTIONS[name]().numbers
    for key, value in printed.items():
        # every printed figure: relative half unit of the last digit, at most 1.6e-6
        assert numbers[key] == pytest.approx(value, rel=1.6e-6), key


def test_yield_density_and_pressure_of_exactpack():
    assert ep.yield_density(ep.EXACTPACK, "hypo") == pytest.approx(2802.7106842, rel=1e-9 / 28)
    assert ep.yield_density(ep.EXACTPACK, "hyper") == pytest.approx(2802.7397260, rel=1e-9 / 28)
    constant_gamma = ep.EXACTPACK._replace(rho_gamma_constant=False)
    assert ep.pressure(2802.7397260, 438.933, constant_gamma) == pytest.approx(0.3655008605e9, rel=1e-7)
    limit = ep.shock_to(ep.yield_density(constant_gamma, "hyper"), ep.State(2790.0, 0, 0, 0, 0, 0), constant_gamma, "hyper")
    assert limit.energy == pytest.approx(438.933, abs=5e-4)
    assert limit.pressure == pytest.approx(0.3655008605e9, rel=1e-9)


@pytest.mark.parametrize("solid", [ep.ALUMINIUM, ep.COPPER, ep.EXACTPACK, ep.EXACTPACK._replace(rho_gamma_constant=False)])
@pytest.mark.parametrize("strain", ["hypo", "hyper"])
@pytest.mark.parametrize("speed", [3.0, 120.0, 600.0, 2500.0])
def test_waves_obey_the_jump_conditions_and_the_law(solid, strain, speed):
    solution = ep.elastic_plastic_piston(solid, speed, strain)
    for index in range(int(solution.numbers["wave_count"])):
        assert jump_residual(solution, 1e-6, index, stress="stress") < 1e-6
    assert solution.numbers["plastic_velocity"] == pytest.approx(speed, rel=1e-8)
    rho, e = solution.numbers["plastic_density"], solution.numbers["plastic_energy"]
    eps = 1.0 - solid.rho0 / rho
    gamma = solid.gamma0 * (solid.rho0 / rho if solid.rho_gamma_constant else 1.0)
    on_hugoniot = solid.rho0 * solid.c0**2 * eps / (1.0 - solid.s * eps) ** 2
    energy = 0.5 * on_hugoniot * eps / solid.rho0
    assert solution.numbers["plastic_pressure"] == pytest.approx(on_hugoniot + rho * gamma * (e - energy), rel=1e-9)
    strength = solution.numbers["plastic_stress"] - solution.numbers["plastic_pressure"]
    assert strength <= 2.0 / 3.0 * solid.yield_stress * (1 + 1e-9)


def test_slow_pistons_stay_elastic_and_fast_ones_overdrive():
    assert ep.elastic_plastic_piston(ep.ALUMINIUM, 20.0).numbers["wave_count"] == 1
    slow = ep.elastic_plastic_piston(ep.ALUMINIUM, 1e-3).numbers["plastic_wave_speed"]
    assert slow == pytest.approx(np.sqrt(5328.0**2 + 4.0 / 3.0 * 27.6e9 / 2785.0), rel=1e-4)
    assert ep.elastic_plastic_piston(ep.ALUMINIUM, 400.0).numbers["wave_count"] == 2
    assert ep.elastic_plastic_piston(ep.ALUMINIUM, 2000.0).numbers["wave_count"] == 1
    with pytest.raises(OutOfRange, match="positive"):
        ep.elastic_plastic_piston(ep.ALUMINIUM, -1.0)


def test_without_strength_it_is_the_linear_hugoniot():
    fluid = ep.ALUMINIUM._replace(yield_stress=0.0)
    assert ep.elastic_plastic_piston(fluid, 400.0).numbers["plastic_wave_speed"] == pytest.approx(5328.0 + 1.338 * 400.0, rel=1e-9)


@pytest.mark.parametrize("geometry,speed,stop", [("cylindrical", 417.079, 0.05), ("spherical", 675.036, 0.03), ("spherical", 619.787, 0.04)])
def test_printed_stopping_radii(geometry, speed, stop):
    assert shell_stopping(geometry, speed=speed).numbers["stop_radius"] == pytest.approx(stop, rel=4e-6)


@pytest.mark.parametrize("geometry,d", [("cylindrical", 2), ("spherical", 3)])
@pytest.mark.parametrize("inner,outer,yield_stress,speed", [(0.08, 0.10, 330e6, 380.0), (0.02, 0.06, 90e6, 200.0)])
def test_shell_against_its_equation_of_motion(geometry, d, inner, outer, yield_stress, speed):
    """Integrates the radial momentum balance, from which the solution (an energy balance) was not made."""
    density, volume = 1845.0, outer**d - inner**d
    solution = shell_stopping(geometry, density, yield_stress, inner, outer, speed)

    def rates(time, state):
        # rho (du/dt + u du/dr) = ds_r/dr + (d-1)(s_r - s_t)/r integrated from a to b with free surfaces; u = -C / r^(d-1)
        a, c = state
        b = (a**d + volume) ** (1.0 / d)
        span = np.log(b / a) if d == 2 else 1.0 / a - 1.0 / b
        flow = yield_stress * (2.0 / np.sqrt(3.0) if d == 2 else 2.0) * np.log(b / a)
        kinetic = 0.5 * c * c * (b ** (2 - 2 * d) - a ** (2 - 2 * d))
        return [-c / a ** (d - 1), (kinetic - flow / density) / span]

    def stopped(time, state):
        return state[1]

    stopped.terminal = True
    run = solve_ivp(rates, (0.0, 1e-2), [inner, speed * inner ** (d - 1)], method="DOP853", rtol=1e-12, atol=1e-16, events=stopped, dense_output=True)
    assert run.y[0, -1] == pytest.approx(solution.numbers["stop_radius"], rel=1e-8)
    assert run.t[-1] == pytest.approx(solution.numbers["stop_time"], rel=1e-6)
    for fraction in (0.2, 0.7, 0.95):
        time = fraction * run.t[-1]
        a, c = run.sol(time)
        assert solution.jumps(time)[0] == pytest.approx(a, rel=1e-7)
        assert solution(np.array([1.01 * a]), time)["velocity"][0] == pytest.approx(-c / (1.01 * a) ** (d - 1), rel=1e-5)


def test_a_shell_too_fast_is_refused():
    with pytest.raises(NoSolution, match="kinetic energy"):
        shell_stopping("cylindrical", speed=5000.0)
