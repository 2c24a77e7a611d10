"""How a run starts (states from any two quantities) and how it chooses its steps (event times hit exactly)."""

import dataclasses

import lagrange_builders as build
import numpy as np
import pytest

from hugoniot.core.ops import NO_LIMIT
from hugoniot.errors import OutOfRange
from hugoniot.laws.eos.contract import EOS, density_limits, pressure, reference_state, temperature
from hugoniot.materials.initial_state import initial_state
from hugoniot.mesh.line import GEOMETRY
from hugoniot.simulate import make_solver
from hugoniot.solvers.lagrange1d import layout as L
from hugoniot.solvers.lagrange1d.layout import H, Z
from hugoniot.solvers.lagrange1d.step import choose_step
from hugoniot.solvers.run import snapshot_times
from hugoniot.zones.viscosity import OWN, signal_speed


def laws_with_pressure_slope():
    return [law for law in EOS if "energy" in law.functions or "linear_in_energy" in law.flags]


@pytest.mark.parametrize("law", laws_with_pressure_slope(), ids=lambda law: law.name)
def test_density_and_pressure_give_the_energy_back(law):
    eos = law.example
    rho0, e0 = reference_state(eos)
    low, high = density_limits(eos)
    for factor in (0.98, 1.0, 1.05):
        rho = rho0 * factor
        if not low < rho < high:
            continue
        e = e0 + 0.01 * (abs(e0) + 1e5)
        p = pressure(rho, e, eos)
        found = initial_state(eos, density=rho, pressure_=p)
        assert found[0] == rho
        assert pressure(*found, eos) == pytest.approx(p, rel=1e-12, abs=1e-9 * max(abs(p), 1.0))


@pytest.mark.parametrize("eos", [build.EOS, build.GAS.eos], ids=["mie_gruneisen", "ideal_gas"])
def test_every_pair_of_quantities_fixes_the_same_state(eos):
    rho0, e0 = reference_state(eos)
    rho, e = 1.07 * rho0, e0 + (2e4 if e0 == 0.0 else 0.3 * e0)
    p = pressure(rho, e, eos)
    pairs = [dict(density=rho, energy=e), dict(density=rho, pressure_=p), dict(pressure_=p, energy=e)]
    if "temperature" in EOS.of(eos).functions and np.isfinite(t := temperature(rho, e, eos)):
        pairs += [dict(density=rho, temperature_=t), dict(pressure_=p, temperature_=t)]
    for pair in pairs:
        found = initial_state(eos, **pair)
        assert found == (pytest.approx(rho, rel=1e-11), pytest.approx(e, rel=1e-9)), pair


def test_one_quantity_and_none():
    assert initial_state(build.EOS) == reference_state(build.EOS)
    rho, e = initial_state(build.EOS, density=2800.0)
    assert rho == 2800.0 and abs(pressure(rho, e, build.EOS)) < 1.0
    assert pressure(*initial_state(build.EOS, pressure_=1e9), build.EOS) == pytest.approx(1e9, rel=1e-12)


def test_three_quantities_are_too_many():
    with pytest.raises(OutOfRange, match="at most two"):
        initial_state(build.EOS, density=2700.0, pressure_=0.0, energy=0.0)


def chooser(rate=1.0, natural=0.5, time=0.0, event=10.0, largest=NO_LIMIT):
    control = np.zeros(L.CONTROL_FLOATS)
    control[[L.COURANT, L.RATE, L.GROWTH, L.DT_NATURAL, L.DT_LARGEST]] = 0.5, rate, 1.1, natural, largest
    control[[L.TIME, L.EVENT_TIME]] = time, event
    segments = np.array([(0, 4, L.FREE, L.FREE)])
    return control, lambda: choose_step.py_func(None, None, control, segments, False, GEOMETRY.get("planar").example)


def test_the_step_is_courant_growth_or_the_largest():
    assert chooser(rate=1.0, natural=10.0)[1]() == 0.5
    assert chooser(rate=1e-3, natural=0.1)[1]() == pytest.approx(0.11, rel=1e-15)
    assert chooser(rate=1e-3, natural=10.0, largest=0.02)[1]() == 0.02


@pytest.mark.parametrize("remaining", [0.5, 0.51, 0.75, 0.999999, 1.0, 1.3, 1e-9])
def test_an_event_is_approached_in_two_halves_and_hit(remaining):
    control, choose = chooser(rate=1.0, natural=10.0, event=remaining)
    steps, time = [], 0.0
    while time < remaining:
        dt = choose()
        steps.append(dt)
        at = dt >= control[L.EVENT_TIME] - control[L.TIME]
        time = control[L.TIME] = control[L.EVENT_TIME] if at else control[L.TIME] + dt
        assert dt <= 0.5 * (1.0 + 1e-9) and len(steps) < 10
    assert time == remaining and len(steps) == int(np.ceil(remaining / 0.5 * (1.0 - 2e-9)))
    assert min(steps) > 0.4 * max(steps)


def test_a_short_step_to_an_event_does_not_slow_the_run_down():
    control, choose = chooser(rate=1.0, natural=0.5, event=1e-6)
    assert choose() == 1e-6
    control[L.TIME], control[L.EVENT_TIME] = 1e-6, 10.0
    assert choose() == 0.5


def test_a_solver_stops_at_odd_times_exactly():
    solver = make_solver(build.flyer((20, 40)))
    for until in (1e-9, 3.3333e-8, 3.3334e-8, 7.7e-8, 1.234567890123e-7):
        while solver.time < until:
            solver.march(until, 1000)
        assert solver.time == until


def test_snapshot_times_include_both_ends_once():
    assert snapshot_times(1.0, 0.25) == [0.0, 0.25, 0.5, 0.75, 1.0]
    assert snapshot_times(1.0, 0.3) == pytest.approx([0.0, 0.3, 0.6, 0.9, 1.0])
    assert snapshot_times(1.0, (0.7, 0.2, 2.0)) == [0.0, 0.2, 0.7, 1.0]
    assert len(snapshot_times(2.0, None)) == 101
    assert snapshot_times(0.3, 0.1) == [0.0, 0.1, 0.2, 0.3]


def test_a_whole_number_in_a_law_is_the_same_number():
    """A law made in Python with 5200 for 5200.0: its sweeps still find every number of it in its own column."""
    problem, ends = build.flyer((20, 40)), []
    for speed in (5200.0, 5200):
        materials = {name: dataclasses.replace(m, eos=m.eos._replace(c0=speed)) for name, m in problem.materials.items()}
        solver = make_solver(dataclasses.replace(problem, materials=materials))
        while solver.time < 2e-7:
            solver.march(2e-7, 1000)
        ends.append(solver.zones[Z.p].copy())
    assert np.array_equal(*ends) and ends[0].max() > 1e9


def largest_growth(courant, w, share):
    """Largest modulus of the roots of a linear wave in the steps of `compatible`, of all wave lengths; c, width and density 1.

    share   of the stiffness, of what follows the velocities led on to the middle of the step (shear modulus, energy), not its positions
    """
    dt, largest = courant / signal_speed(1.0, w, 0.0, 1.0), 0.0
    strain, jump, acceleration, q = np.eye(4)          # of a zone: strain, velocity jump; acceleration of the jump and q of the step before
    led_on = jump + 0.5 * dt * acceleration
    for wave in np.linspace(0.05, np.pi, 60):
        mobility = OWN * dt
        new_q = -w * (led_on - mobility * q) / (1.0 + mobility * w)
        stress = strain + 0.5 * dt * ((1.0 - share) * jump + share * led_on)
        new_acceleration = 4.0 * np.sin(0.5 * wave) ** 2 * (new_q - stress)
        new_jump = jump + dt * new_acceleration
        new_strain = strain + 0.5 * dt * (jump + new_jump)
        roots = np.linalg.eigvals(np.array([new_strain, new_jump, new_acceleration, new_q]))
        largest = max(largest, float(np.abs(roots).max()))
    return largest


@pytest.mark.parametrize("share", [0.0, 0.3, 0.5, 0.7])
@pytest.mark.parametrize("w", [0.05, 0.1, 0.2, 0.3, 0.5, 1.0, 2.0, 10.0, 1000.0])
def test_weak_waves_are_damped_by_any_viscosity_in_steps_of_seven_tenths(w, share):
    assert largest_growth(0.7, w, share) < 1.0 + 1e-12 and largest_growth(0.5, w, share) < 1.0 + 1e-12


def test_a_viscosity_counts_six_times_as_much_in_a_shock_as_in_noise():
    c, w, rho = 5000.0, 1500.0, 8900.0
    shock, noise = (rho * w * jump for jump in (100.0, 1e-3))
    assert signal_speed(c, w, shock, rho) == c + 2.0 * w
    assert signal_speed(c, w, noise, rho) == pytest.approx(c + w / 3.0, rel=1e-15)
    assert signal_speed(c, 0.0, 0.0, rho) == c


def rest_with_random_motions(problem, amplitude):
    """(solver, largest velocity) of a problem whose inner nodes have random velocities up to about this one."""
    solver = make_solver(problem)
    motion = amplitude * np.random.default_rng(7).standard_normal(solver.nodes.shape[1] - 2)
    solver.nodes[H.u, 1:-1] = solver.nodes[H.u_mean, 1:-1] = motion
    return solver, np.abs(motion).max()


@pytest.mark.parametrize("courant", [0.5, 0.7])
def test_small_random_motions_of_a_gas_die_out(courant):
    """Velocities of a millionth of the sound speed at random, in a gas at rest between walls."""
    tube = build.gas_tube(courant=courant, stop=20.0)
    tube = dataclasses.replace(tube, regions=tuple(dataclasses.replace(region, density=1.0, pressure=1.0) for region in tube.regions))
    solver, largest = rest_with_random_motions(tube, 1e-6)
    solver.march(20.0, 3000)
    assert solver.cycle > 1000 and np.abs(solver.nodes[H.u]).max() < 0.3 * largest


@pytest.mark.parametrize("linear", [0.3, 1.0, 3.0])
def test_small_random_motions_of_a_stiff_solid_die_out(linear):
    """Two thirds of the square of its sound speed are due to its shear modulus, as in beryllium and diamond."""
    problem = build.flyer((60, 120), speed=0.0, stop=1.0, spall=1e12, courant=0.7, viscosity=("limited", (("linear", linear),)))
    stiff = {name: dataclasses.replace(m, strength=build.STRENGTH._replace(shear_modulus=100e9, yield_stress=1e12)) for name, m in problem.materials.items()}
    solver, largest = rest_with_random_motions(dataclasses.replace(problem, materials=stiff), 1e-3)
    for _ in range(10):
        solver.march(1.0, 400)
        solver.take_gauges()
    assert solver.cycle >= 4000 and np.abs(solver.nodes[H.u]).max() < 0.5 * largest
