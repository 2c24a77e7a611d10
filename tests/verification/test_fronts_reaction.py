"""Burning behind tracked shocks: the steady zone of an overdriven wave, the exact reference state of isolated reactants, conservation."""

import dataclasses
from types import MappingProxyType

import numpy as np
import pytest
from steady_zone import CELLS, SteadyZone, crests, grown, material_of, zone_errors

from hugoniot.errors import OutOfRange
from hugoniot.laws.burn.contract import Reactive
from hugoniot.laws.burn.ignition_growth import IgnitionGrowth
from hugoniot.laws.riemann.branch import Matter, State
from hugoniot.laws.riemann.curve import Curve
from hugoniot.laws.riemann.medium import Frozen, mixed_answer, mixed_phases
from hugoniot.laws.riemann.wave import Side, jumps, reach
from hugoniot.materials import burning, library
from hugoniot.problem.model import Boundary, Problem, Pulse, Region, SolverOptions
from hugoniot.simulate import make_solver
from hugoniot.theory.hugoniot import Initial, shock
from hugoniot.theory.stability import Wave

LX17 = dataclasses.replace(library.find("LX-17 reactive"), name="lx-17")
REST = Initial.at_rest(LX17.unreacted)


def marched(problem):
    solver = make_solver(problem)
    solver.march(problem.stop_time, 10**9)
    assert max(solver.errors().values()) < 1e-12
    return solver


# -- the steady zone ---------------------------------------------------------------------------------------------------
CALM, PULSATING = SteadyZone(Wave(1.2, 50.0, 20.0, 1.6)), SteadyZone(Wave(1.2, 50.0, 50.0, 1.6))


@pytest.mark.parametrize("zone", [CALM, pytest.param(PULSATING, marks=pytest.mark.slow)])
def test_the_reaction_zone_is_of_second_order(zone):
    """Started from the steady zone: errors of the front's place, of density, velocity and burn fraction in eight half-reaction lengths."""
    coarse, fine = (zone_errors(zone, n) for n in (10, 20))
    assert (np.log2(coarse / fine) > 1.9).all()
    assert (fine < (2.5e-5, 2.5e-5, 2.5e-5, 5e-5)).all()


@pytest.mark.slow
@pytest.mark.parametrize("wave, guess, behind, stop, sharp", [(PULSATING.wave, 0.12 + 0.88j, 21.0, 10.0, 2e-3),
                                                              (Wave(1.2, 50.0, 28.0, 1.0005), 0.13 + 0.49j, 9.0, 14.0, 5e-3)])
def test_a_normal_mode_grows_as_it_should(wave, guess, behind, stop, sharp):
    """f = 1.6 and E = 50, and E = 28 near Chapman-Jouguet: growth to 1 %, frequency to 0.5 %, at ten zones in a half-reaction length.

    The piston stands so far behind that its sound does not reach the front.
    """
    mode = wave.mode(guess)
    growth, frequency = grown(SteadyZone(wave), mode, 10, behind, stop)
    assert growth == pytest.approx(mode.growth, rel=1e-2) and frequency == pytest.approx(mode.frequency, rel=sharp)


@pytest.mark.slow
def test_neutral_stability_lies_between_two_near_activation_energies():
    """Near Chapman-Jouguet, 20 zones in a half-reaction length: the mode of E = 25.25 falls, that of 25.28 grows."""
    for activation, way in ((25.25, -1.0), (25.28, 1.0)):
        wave = Wave(1.2, 50.0, activation, 1.0005)
        mode = wave.mode(0.53j)
        growth, frequency = grown(SteadyZone(wave), mode, 20, 9.0, 14.0)
        assert growth * way > 3e-4 and mode.growth * way > 3e-4 and frequency == pytest.approx(mode.frequency, rel=5e-4)


@pytest.mark.slow
def test_limit_cycles_near_chapman_jouguet():
    """Crests of E = 27 tend to one height, period 1; of E = 27.35 every second one is the same, period 2 (Henrick, Aslam and Powers)."""
    single, double = (crests(Wave(1.2, 50.0, activation, 1.0005), 10, 150.0)[-6:] for activation in (27.0, 27.35))
    heights = np.abs(np.diff(single[:, 1]))
    assert (heights[1:] < heights[:-1]).all() and heights[-1] < 0.03      # one crest less than the last by less and less
    assert np.diff(single[:, 0]).mean() == pytest.approx(11.89, abs=0.03)
    assert np.abs(np.diff(double[:, 1])).min() > 0.6
    assert np.abs(double[2:, 1] - double[:-2, 1]).max() < 5e-3
    assert np.diff(double[:, 0])[:2].sum() == pytest.approx(23.83, abs=0.05)


@pytest.mark.slow
def test_crests_of_the_overdriven_pulsation_are_those_of_a_mesh_twice_as_fine():
    """f = 1.6, E = 50: half the reaction at a crest takes a quarter of the steady length, five and ten zones. The piston is out of reach."""
    wave = Wave(1.2, 50.0, 50.0, 1.6)
    coarse, fine = (crests(wave, n, 38.0, behind=75.0, piece=1.0, guess=0.12 + 0.88j, keeps_all=True)[-2:] for n in (20, 40))
    pressure, other = ((2.0 * found[:, 1] ** 2 - 0.2) / 2.2 for found in (coarse, fine))
    assert pressure == pytest.approx(other, rel=1e-3)      # 0.6e-3 and 0.8e-3; with 16 and 32 zones 0.6e-3 and 1.1e-3
    assert other == pytest.approx(np.full(2, 99.1), rel=3e-3)
    assert np.diff(fine[:, 0]) == pytest.approx([7.36], abs=0.03)


def overdriven(per_half_length, stop):
    """A piston that moves as the material behind the steady front."""
    wave = CALM.wave
    kept = np.unique(np.searchsorted(CALM.s, np.geomspace(1e-3, 24.0, 800)))
    kept = np.concatenate([[0], kept[CALM.time[kept] < 2.0 * stop]])
    length = wave.velocity * stop + 2.0
    region = Region("gas", "gas", 0.0, length, round(per_half_length * length), density=1.0, pressure=1.0)
    pulse = Pulse("table", times=tuple(CALM.time[kept]), values=tuple(CALM.velocity[kept]))
    return Problem("overdriven", "planar", stop, (region,), {"gas": material_of(wave)}, Boundary("velocity", pulse), Boundary("fixed"),
                   solver=CELLS)


def driven_errors(per_half_length):
    """(of the front's place over its way, of the pressure in three half lengths behind it over that of the spike)."""
    solver = marched(overdriven(per_half_length, 1.0))
    mesh = solver.mesh
    front = float(mesh.x[mesh.faces()[1]])
    behind = front - mesh.middle
    inside = (behind > 0.0) & (behind < 3.0)
    found = solver.flow.look(mesh)[6, :len(inside)][inside]
    error = np.abs(found - np.interp(behind[inside], CALM.y, CALM.pressure)).mean() / CALM.pressure[0]
    return np.array([abs(front / CALM.wave.velocity - 1.0), float(error)])


def test_a_driven_reaction_zone_has_no_viscous_width():
    place, pressure = driven_errors(10)
    assert place < 2e-5 and pressure < 1.5e-4


@pytest.mark.slow
def test_a_driven_reaction_zone_converges():
    coarse, fine = driven_errors(10), driven_errors(40)
    assert np.log2(coarse[1] / fine[1]) / 2.0 > 1.8 and fine[1] < 1e-5


# -- the reference state -------------------------------------------------------------------------------------------------
def slow_burn(per_mm, rate):
    """LX-17 behind a shock of 15 GPa that burns at an even rate (1/s): products' energy at four material points, J/kg."""
    behind = shock(LX17.unreacted, REST, pressure=15e9)
    law = IgnitionGrowth(1905.0, 0.0, 0.0, 0.0, 1.0, rate / 15e9, 0.0, 0.0, 1.0)
    material = dataclasses.replace(LX17, burn=law)
    pulse = Pulse("constant", float(behind.particle_velocity))
    region = Region("charge", "lx-17", 0.0, 4e-3, 4 * per_mm)
    solver = marched(Problem("slow", "planar", 0.6e-6, (region,), {"lx-17": material}, Boundary("velocity", pulse), Boundary("free"), solver=CELLS))
    found = []
    for fraction in (0.1, 0.2, 0.3, 0.4):
        _, state, matter, burned = solver.column(0).point(fraction)
        par = matter.par
        mixed = mixed_phases(state.rho, state.e, burned, par.volume, par.energy, par.mixture)
        found.append((burned, mixed.e_p, par.volume, par.energy))
    return np.array(found), behind, solver


@pytest.mark.parametrize("rate", [5e3, pytest.param(1e5, marks=pytest.mark.slow)])
def test_the_products_energy_behind_a_tracked_shock_is_independent_of_the_mesh(rate):
    """003 section 4.3: where a few thousandths have burned the products' energy is a difference that a smeared shock spoils."""
    coarse, fine = slow_burn(5, rate)[0], slow_burn(20, rate)[0]
    assert 1e-3 < fine[:, 0].min() < fine[:, 0].max() < 0.1
    assert coarse[:, 1] == pytest.approx(fine[:, 1], rel=1e-3)


def initiated(per_mm, **options):
    """LX-17 behind a shock of 20 GPa with its own rate, when the shock has become a detonation: products' energy, J/kg."""
    behind = shock(LX17.unreacted, REST, pressure=20e9)
    piston = Boundary("velocity", Pulse("constant", float(behind.particle_velocity)))
    region = Region("charge", "lx-17", 0.0, 4e-3, 4 * per_mm)
    how = SolverOptions("fronts", options=MappingProxyType({"mode": "cells", **options}))
    solver = marched(Problem("initiated", "planar", 0.4e-6, (region,), {"lx-17": LX17}, piston, Boundary("free"), solver=how))
    found = []
    for fraction in (0.05, 0.15, 0.25, 0.35, 0.45):
        _, state, matter, burned = solver.column(0).point(fraction)
        found.append(mixed_phases(state.rho, state.e, burned, matter.par.volume, matter.par.energy, matter.par.mixture).e_p)
    return np.array(found)


def test_the_products_energy_of_an_initiation_is_independent_of_the_mesh():
    """The fast reaction behind the detonation is 0.15 mm wide: less than a cell of the coarse mesh."""
    assert initiated(5) == pytest.approx(initiated(40), rel=1.2e-2)


@pytest.mark.slow
def test_halving_cells_that_burn_fast_does_what_a_mesh_that_fine_does():
    fine = initiated(320, burn_step=0.0)
    assert initiated(160, burn_step=0.0) == pytest.approx(fine, rel=1.5e-3)
    for per_mm, plain, halved, more in ((5, 4e-2, 1.2e-2, 1.4e-2), (10, 2.3e-2, 8e-3, 5e-3), (20, 9e-3, 6e-3, 3e-3)):
        errors = [np.abs(initiated(per_mm, burn_step=step) / fine - 1.0).max() for step in (0.0, 0.15, 0.1)]
        assert errors[0] > plain and errors[1] < halved and errors[2] < more


def test_the_reference_state_is_the_exact_state_behind_the_shock():
    found, behind, _ = slow_burn(10, 5e3)
    assert found[0, 2] == pytest.approx(1.0 / float(behind.density), rel=2e-4)
    assert found[0, 3] - burning.heat_of(LX17) == pytest.approx(float(behind.specific_internal_energy), rel=2e-3)


def partly_burned():
    """(pair, side, Frozen) of LX-17 at 10 GPa, a third of it burned."""
    mixture = burning.reactive(LX17).mixture._replace(nascent_limit=1e-6)
    first = shock(LX17.unreacted, REST, pressure=10e9)
    v, e = 1.0 / float(first.density), float(first.specific_internal_energy) + mixture.detonation_energy
    rho, burned = 1.0 / (v * 1.05), 0.3
    p, p_rho, p_e = mixed_answer(rho, e, burned, v, e, mixture)
    square = p_rho + p * p_e / rho**2
    return Reactive(None, mixture), Side(rho, e, p, square, burned, v, e, 1e30, 1e30, 1e30), Frozen(mixture, burned, v, e)


def test_a_shock_on_partly_burned_explosive_obeys_the_jump_and_gives_its_reactants_their_own():
    pair, side, _ = partly_burned()
    target = side.p + 15e9
    found = reach(target, side, pair)
    x, volume, energy = jumps(target, side, pair)
    p = mixed_answer(found.rho, found.e, side.burned, volume, energy, pair.mixture)[0]
    assert p == pytest.approx(target, rel=1e-9)                  # the closure, on the new isentrope, has the pressure of the jump
    assert found.e - side.e == pytest.approx(0.5 * (target + side.p) * (1.0 / side.rho - 1.0 / found.rho), rel=1e-12)
    before = mixed_phases(side.rho, side.e, side.burned, side.volume, side.energy, pair.mixture)
    assert energy - before.e_r == pytest.approx(0.5 * (target + side.p) * (1.0 / before.rho_r - volume), rel=1e-9)
    assert found.flux == pytest.approx(np.sqrt((target - side.p) / x), rel=1e-12)


def test_the_compiled_release_is_that_of_the_exact_solver():
    pair, side, frozen = partly_burned()
    curve = Curve(Matter(frozen), State(side.rho, 0.0, side.e, side.p), 1)
    for target in (0.9 * side.p, 0.3 * side.p):
        mine, (theirs, slope, _) = reach(target, side, pair), curve.at(target)
        assert (mine.rho, mine.e, mine.rise) == pytest.approx((theirs.rho, theirs.e, theirs.u), rel=1e-9)
        assert mine.slope == pytest.approx(slope, rel=1e-9)


# -- what is not resolved --------------------------------------------------------------------------------------------------
def test_a_reference_state_that_rolls_is_refused():
    material = dataclasses.replace(LX17, reference_state="rolling")
    region = Region("charge", "lx-17", 0.0, 4e-3, 20)
    with pytest.raises(OutOfRange, match="keeps the state behind its tracked shocks"):
        make_solver(Problem("rolling", "planar", 1e-6, (region,), {"lx-17": material}, solver=CELLS))
