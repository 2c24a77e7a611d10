"""The viscous flow solver against the steady structure, linear acoustics, conservation to round-off and bitwise restarts."""

import dataclasses
import math
import re
from types import MappingProxyType

import numpy as np
import pytest

from hugoniot.errors import DeckError, OutOfRange, UnphysicalState
from hugoniot.laws import eos as _laws  # noqa: F401
from hugoniot.laws.eos.contract import EOS
from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.laws.transport.contract import make
from hugoniot.materials.material import Material
from hugoniot.problem.model import Boundary, Problem, Region, SolverOptions
from hugoniot.problem.structure_start import ample_room, profile_of, resolved, settling_times, shock_start
from hugoniot.solvers.shock_structure.measure import thickness, thickness_by_differences
from hugoniot.solvers.shock_structure.setup import conserved
from hugoniot.solvers.shock_structure.solver import ShockStructure
from hugoniot.theory.structure import jordan, steady

OPEN, WALL = Boundary("transmitting"), Boundary("fixed")
ROUND_OFF = 1e-12


def problem(eos, transport, region, stop_time, shock=None, ends=OPEN, **solver):
    options = {"transport": transport} | ({"shock": shock} if shock else {})
    return Problem("test", "planar", stop_time, (region,), {"m": Material("m", eos)}, ends, ends,
                   solver=SolverOptions("shock_structure", options=MappingProxyType(options), **solver))


def argon_problem(mach, cells, ahead=12.0, behind=12.0, times=20.0, velocity=0.0, **shock):
    """`cells` in a thickness, the domain in thicknesses, `times` to flow through a thickness behind the shock."""
    eos, state = jordan.argon()
    transport = jordan.argon_transport("power_law")
    profile = steady(eos, transport, state, mach=mach)
    size = profile.thickness() / cells
    region = Region("gas", "m", -round(ahead * cells) * size, round(behind * cells) * size, round(ahead * cells) + round(behind * cells),
                    density=1.62, temperature=300.0, velocity=velocity)
    stop = times * profile.thickness() / profile.ends.downstream.velocity
    return problem(eos, transport, region, stop, {"mach": mach, "at": 0.0, **shock}), profile


def condensed_problem(name, size, cells, times, gamma0=None, **shock):
    case = jordan.CONDENSED[name]
    eos, transport = case.eos(gamma0), case.transport()
    profile = steady(eos, transport, particle_velocity=case.particle_velocity)
    region = Region("fluid", "m", -(cells // 2) * size, (cells - cells // 2) * size, cells)
    stop = times / profile.ends.downstream.velocity
    return problem(eos, transport, region, stop, {"particle_velocity": case.particle_velocity, "at": 0.0, **shock}), profile


def run(given):
    solver = ShockStructure(given, shock_start(given))
    solver.march(given.stop_time, 10**9)
    assert solver.time == given.stop_time
    for name, error in solver.errors().items():
        assert error < ROUND_OFF, name
    return solver


# -- thickness -----------------------------------------------------------------------------------------------------------
def test_step_settles_into_the_steady_profile_with_at_least_second_order():
    errors = []
    for cells in (5, 10, 20):
        given, profile = argon_problem(1.55, cells)
        solver = run(given)
        errors.append(abs(solver.thickness()[0] / profile.thickness() - 1.0))
    assert errors[0] < 1e-2 and errors[1] < 3e-4 and errors[2] < 1e-5
    slopes = np.log2(np.array(errors[:-1]) / np.array(errors[1:]))
    assert np.all(slopes > 2.0)


def orders_of(name, frame, counts):
    """(worst errors of the thickness from a step at `counts` cells in it, orders between), at nine instants of the last flow through it."""
    if name in jordan.CONDENSED:
        case = jordan.CONDENSED[name]
        asked = dict(material=case.eos(), transport=case.transport(), particle_velocity=case.particle_velocity)
    else:
        law, ahead = jordan.argon()
        asked = dict(material=law, transport=jordan.argon_transport(), upstream=ahead, mach=float(name))
    errors = []
    for cells in counts:
        given, profile = resolved(**asked, cells=cells, frame=frame)
        solver = ShockStructure(given, shock_start(given))
        flow, found = profile.thickness() / profile.ends.downstream.velocity, []
        for part in np.linspace(1.0, 0.0, 9):
            solver.march(given.stop_time - part * flow, 10**9)
            found.append(abs(solver.thickness()[0] / profile.thickness() - 1.0))
        assert max(solver.errors().values()) < ROUND_OFF
        errors.append(max(found))
    return errors, np.diff(-np.log2(errors))


def test_one_rule_lays_out_every_shock():
    """Room for the foot of a strong shock; time for the slowest wave, whichever it is, to run twelve thicknesses."""
    rooms, slowest = {}, {}
    law, ahead = jordan.argon()
    for name in ("1.05", "9", "silica_100", "silica_770"):
        case = jordan.CONDENSED.get(name)
        profile = (steady(case.eos(), case.transport(), particle_velocity=case.particle_velocity) if case
                   else steady(law, jordan.argon_transport(), ahead, mach=float(name)))
        one, two = profile.ends.upstream, profile.ends.downstream
        rooms[name] = ample_room(profile)
        waves = {"u2": two.velocity, "c2-u2": two.sound_speed - two.velocity, "u1-c1": one.velocity - one.sound_speed}
        slowest[name] = min(waves, key=lambda wave: waves[wave])
        assert settling_times(profile) == pytest.approx(12.0 * two.velocity / waves[slowest[name]], rel=1e-12)
    assert rooms["9"] == (12.0, 12.0) and rooms["silica_100"] == pytest.approx((35.8, 12.0), abs=0.1)
    assert slowest == {"1.05": "c2-u2", "9": "u2", "silica_100": "u2", "silica_770": "c2-u2"}


@pytest.mark.parametrize("name, frame", [("3.38", "standing"), ("9", "standing"), ("water_858", "moving")])
def test_order_from_a_step(name, frame):
    errors, slopes = orders_of(name, frame, (5, 10))
    assert errors[1] < 3e-3 and slopes[0] > 2.0


@pytest.mark.slow
@pytest.mark.parametrize("frame", ["standing", "moving"])
@pytest.mark.parametrize("name", ["1.55", "3.38", "9", *jordan.CONDENSED])
def test_order_from_a_step_to_twenty_cells(name, frame):
    """The table of docs/theory/shock_structure_numbers.md."""
    errors, slopes = orders_of(name, frame, (5, 10, 20))
    assert errors[1] < 3e-3
    assert np.all(slopes > 2.0)


def test_the_contact_that_a_step_leaves_is_not_the_shock():
    """Without conduction the hot spot of the start is as steep as the shock for ever; its density must not be measured."""
    case = jordan.CONDENSED["water_858"]
    given, profile = resolved(case.eos(), case.transport(), particle_velocity=858.0, cells=20, frame="moving", times=5.0)
    solver = run(given)
    wrong = thickness(solver.faces, solver.cells[0], *solver.ends[:, 0])[0]
    assert wrong < 0.7 * profile.thickness()
    assert solver.thickness()[0] == pytest.approx(profile.thickness(), rel=3e-3)


@pytest.mark.slow
def test_pores_that_close_at_a_pressure_no_heat_changes():
    """snow_plough: dp/de = 0 ahead, where the far field and entropy waves must not divide by it; its heat flow meets kinks."""
    given, profile = resolved(EOS.get("snow_plough").example, make({"law": "constant", "shear_viscosity": 1e-3}, {"law": "prandtl", "prandtl": 1.0}),
                              shock_velocity=8600.0, cells=20)
    assert run(given).thickness()[0] == pytest.approx(profile.thickness(), rel=2e-3)


@pytest.mark.slow
def test_conduction_in_p_alpha_settles_into_its_steady_wave():
    given, profile = resolved(EOS.get("p_alpha").example, make({"law": "constant", "shear_viscosity": 1e-3}, {"law": "prandtl", "prandtl": 1.0}),
                              mach=2.0, cells=10)
    assert run(given).thickness()[0] == pytest.approx(profile.thickness(), rel=6e-4)   # 8e-4 with the c_p of a law without pores


@pytest.mark.slow
@pytest.mark.parametrize("mach, tolerance", [(2.0, 4e-3), (5.0, 2e-3)])
def test_conduction_in_p_lambda_settles_into_its_steady_wave(mach, tolerance):
    """Where the pores begin to close dp/de is next to nothing: a scheme that divides by it throws the wave apart within 300 steps."""
    given, profile = resolved(EOS.get("p_lambda").example, make({"law": "constant", "shear_viscosity": 1e-3}, {"law": "prandtl", "prandtl": 1.0}),
                              mach=mach, cells=10)
    assert run(given).thickness()[0] == pytest.approx(profile.thickness(), rel=tolerance)


def test_mach_nine_to_a_third_of_a_percent_in_few_steps():
    """Work in zone updates, which every machine agrees on; benchmarks/answers.py has seconds."""
    given, profile = argon_problem(9.0, 10, ahead=7.0, behind=7.0)
    solver = run(given)
    assert solver.zone_updates < 3e6
    assert solver.thickness()[0] == pytest.approx(profile.thickness(), rel=3e-3)


def test_whole_profile_not_only_its_thickness():
    given, profile = argon_problem(3.38, 10)
    solver = run(given)
    state = solver.state().zones
    centres = 0.5 * (solver.faces[1:] + solver.faces[:-1])
    middle = 0.5 * (profile.ends.upstream.density + profile.ends.downstream.density)
    shift = np.interp(middle, state["density"], centres)
    exact = profile.at(centres - shift)
    for name in ("density", "pressure", "temperature", "energy"):
        jump = abs(exact[name][-1] - exact[name][0])
        assert np.abs(state[name] - exact[name]).max() < 5e-3 * jump, name
    tau = exact["viscous_stress"]
    assert np.abs(state["viscous_pressure"] + tau).max() < 0.02 * np.abs(tau).max()


@pytest.mark.parametrize("start", ["step", "steady"])
def test_moving_shock_keeps_its_thickness_and_speed(start):
    """The gas ahead moves at 40 m/s in the laboratory, the shock runs left into it."""
    given, profile = argon_problem(1.55, 10, ahead=40.0, behind=14.0, times=12.0, velocity=40.0, frame="moving", start=start)
    solver = ShockStructure(given, shock_start(given))
    places = []
    for part in (0.5, 1.0):
        solver.march(part * given.stop_time, 10**9)
        places.append((solver.time, solver.thickness()[1]))
    assert solver.thickness()[0] == pytest.approx(profile.thickness(), rel=3e-3)
    speed = (places[1][1] - places[0][1]) / (places[1][0] - places[0][0])
    assert speed == pytest.approx(40.0 - profile.ends.upstream.velocity, rel=2e-3 if start == "step" else 2e-4)
    assert max(solver.errors().values()) < ROUND_OFF


def test_the_steady_profile_stays():
    given, profile = argon_problem(3.38, 10, times=5.0, start="steady")
    solver = ShockStructure(given, shock_start(given))
    first = solver.cells.copy()
    assert solver.thickness()[0] == pytest.approx(profile.thickness(), rel=1e-3)
    solver.march(given.stop_time, 10**9)
    jump = np.abs(first[:, -1] - first[:, 0]).max(axis=0)
    assert np.abs(solver.cells - first)[0].max() < 4e-3 * abs(first[0, -1] - first[0, 0]) and jump > 0.0


@pytest.mark.parametrize("name", ["water_387", "water_858", "silica_770"])
def test_water_and_dense_silica_resolved(name):
    case = jordan.CONDENSED[name]
    length = steady(case.eos(), case.transport(), particle_velocity=case.particle_velocity).thickness()
    given, profile = condensed_problem(name, length / 10.0, 80, 30.0 * length)
    assert run(given).thickness()[0] == pytest.approx(profile.thickness(), rel=3e-3)


@pytest.mark.slow
@pytest.mark.parametrize("name, cells, width, times, tolerance", [("silica_100", 10, 20, 8.0, 3e-3), ("silica_250", 10, 20, 6.0, 3e-3)])
def test_light_silica_resolved(name, cells, width, times, tolerance):
    """Strong shocks with a long foot: the thin step behind it needs its cells."""
    case = jordan.CONDENSED[name]
    length = steady(case.eos(), case.transport(), particle_velocity=case.particle_velocity).thickness()
    given, profile = condensed_problem(name, length / cells, 2 * width * cells, times * length)
    region = dataclasses.replace(given.regions[0], end=3.0 * length, zones=given.regions[0].zones // 2 + 3 * cells)
    assert run(dataclasses.replace(given, regions=(region,))).thickness()[0] == pytest.approx(profile.thickness(), rel=tolerance)


def test_thickness_on_the_source_grid_is_the_grid():
    """600 cells of 7.75 and 15.5 nm, as Jordan: the thickness goes with the spacing until the spacing is below the true one, 3.6 and 1.6 nm.

    Jordan prints 310 and 868 nm: exactly 40 and 56 of its cells.
    """
    for name, printed_cells in (("water_387", 40.0), ("water_858", 56.0)):
        case = jordan.CONDENSED[name]
        assert case.printed[0] / case.spacing == pytest.approx(printed_cells, rel=1e-12)
        found = []
        for refine in (1.0, 4.0, 64.0):
            given, profile = condensed_problem(name, case.spacing / refine, 600 if refine < 64.0 else 160, 300.0 * case.spacing / refine)
            solver = run(given)
            found.append(thickness_by_differences(solver.h, solver.cells[0], *solver.ends[:, 0]))
        true = profile.thickness()
        assert found[0] > 5.0 * true and found[0] > 2.0 * case.spacing
        assert found[1] < found[0]      # unresolved, a reading rings with the grid: 113 and 42 nm differ by round-off in the law alone
        assert solver.thickness()[0] == pytest.approx(true, rel=0.01)   # the finest: 15 and 7 cells in it


# -- plain viscous flow --------------------------------------------------------------------------------------------------
def sound_problem(cells, ends, length=2e-6, amplitude=1e-4, shape=None, stop=0.0):
    eos, state = jordan.argon()
    given = problem(eos, jordan.argon_transport("power_law"), Region("gas", "m", 0.0, length, cells, density=1.62, temperature=300.0), stop, ends=ends)
    x = (np.arange(cells) + 0.5) / cells
    return given, eos, state, shape(x) * amplitude


def test_standing_sound_wave_decays_as_kirchhoff_says():
    """Closed box, first mode: amplitude exp(-Gamma t), Gamma = k^2/2 (4/3 nu + (gamma - 1) chi), frequency c k."""
    cells, length = 64, 2e-6
    given, eos, state, part = sound_problem(cells, WALL, length, shape=lambda x: np.cos(math.pi * x))
    rho, e = state.density * (1.0 + part), state.energy * (1.0 + (5.0 / 3.0 - 1.0) * part)
    c = math.sqrt(5.0 / 3.0 * 208.1 * 300.0)
    k, nu = math.pi / length, 2.27e-5 / 1.62
    rate = 0.5 * k * k * nu * (4.0 / 3.0 + (5.0 / 3.0 - 1.0) / (2.0 / 3.0))
    omega = math.sqrt((c * k) ** 2 - rate**2)
    period = 2.0 * math.pi / omega
    start = conserved(rho, np.zeros(cells), e)
    solver = ShockStructure(given, (start, start[:, [0, -1]].T))
    times, heights = [], []
    weight = np.cos(math.pi * (np.arange(cells) + 0.5) / cells)
    for i in range(1, 81):
        solver.march(0.025 * i * period, 10**9)
        times.append(solver.time)
        heights.append(2.0 * np.mean((solver.cells[0] / 1.62 - 1.0) * weight) / 1e-4)
    t = np.array(times)
    design = np.exp(-rate * t)[:, None] * np.stack([np.cos(omega * t), np.sin(omega * t)], axis=1)
    fit, *_ = np.linalg.lstsq(design, np.array(heights), rcond=None)
    assert np.abs(design @ fit - heights).max() < 0.02   # knudsen corrections of order (rate/omega)^2
    assert rate * t[-1] > 0.5                            # there was something to see
    assert abs(fit[0] - 1.0) < 0.02
    assert max(solver.errors().values()) < ROUND_OFF


def test_open_ends_let_a_pulse_out():
    given, eos, state, part = sound_problem(200, OPEN, 2e-5, 1e-2, lambda x: np.exp(-((x - 0.5) / 0.05) ** 2))
    rho, e = state.density * (1.0 + part), state.energy * (1.0 + (5.0 / 3.0 - 1.0) * part)
    start = conserved(rho, np.zeros(200), e)
    solver = ShockStructure(given, (start, conserved(np.full(2, 1.62), np.zeros(2), np.full(2, state.energy)).T.copy()))
    solver.march(2e-5 / 322.0, 10**9)   # time for an echo to come back to the middle
    pressure = solver.state().zones["pressure"] / state.pressure - 1.0
    assert np.abs(pressure).max() < 3e-5 * 1.0   # the pulse had 8e-3 in each direction
    assert max(solver.errors().values()) < ROUND_OFF


def test_walls_hold_mass_and_energy():
    given, eos, state, part = sound_problem(80, WALL, 2e-6, 0.3, lambda x: np.sin(3.0 * x))
    start = conserved(1.62 * (1.0 + part), 50.0 * part, np.full(80, state.energy))
    solver = ShockStructure(given, (start, start[:, [0, -1]].T))
    before = solver.totals()
    solver.advance(2000)
    assert solver.cycle == 2000
    assert solver.totals()[0] == pytest.approx(before[0], rel=1e-15)
    assert solver.totals()[2] == pytest.approx(before[2], rel=1e-15)


# -- trust ------------------------------------------------------------------------------------------------------------------
def test_restart_is_bitwise():
    given, _ = argon_problem(1.55, 8, ahead=8.0, behind=8.0, times=4.0)
    whole = ShockStructure(given, shock_start(given))
    whole.march(given.stop_time, 10**9)
    first = ShockStructure(given, shock_start(given))
    first.march(given.stop_time, 137)
    second = ShockStructure(given, shock_start(given))
    second.restore(first.payload())
    while second.time < given.stop_time:
        second.march(given.stop_time, 61)
    assert np.array_equal(whole.U, second.U) and np.array_equal(whole.passed, second.passed)
    assert whole.cycle == second.cycle and whole.errors() == second.errors()
    for name, value in whole.peaks().items():   # of every step, not of where the bursts happened to end
        assert np.array_equal(value, second.peaks()[name]), name


def test_galilean_shift_changes_nothing():
    eos, state = jordan.argon()
    found = []
    for velocity in (0.0, 1000.0):
        given, _ = argon_problem(1.55, 10, ahead=24.0, behind=10.0, times=4.0, velocity=velocity, frame="moving", start="steady")
        u1 = steady(eos, jordan.argon_transport(), state, mach=1.55).ends.upstream.velocity
        size = (given.regions[0].end - given.regions[0].start) / given.regions[0].zones
        stop = 50.0 * size / abs(velocity - u1) if velocity else None
        given = dataclasses.replace(given, stop_time=stop or 20.0 * size / u1)
        if velocity:   # the shock moves right here: give it the room ahead instead
            region = dataclasses.replace(given.regions[0], start=-240 * size / 2, end=240 * size, zones=360)
            given = dataclasses.replace(given, regions=(region,))
        solver = run(given)
        found.append(solver.thickness()[0])
    assert found[0] == pytest.approx(found[1], rel=1e-3)


def test_spline_measures_a_known_profile():
    faces = np.linspace(-10.0, 10.0, 161)
    length = 2.0
    mass = 1.5 * faces + 0.5 * length / 2.0 * np.log(np.cosh(2.0 * faces / length))   # density 1.5 + tanh(2x/L)/2
    found, place = thickness(faces, np.diff(mass) / np.diff(faces), 1.0, 2.0)
    assert found == pytest.approx(length, rel=2e-5) and abs(place) < 1e-3


# -- bad input ----------------------------------------------------------------------------------------------------------------
def test_domain_too_short_says_the_length_needed():
    given, profile = argon_problem(9.0, 10, ahead=1.0, behind=1.0)
    with pytest.raises(DeckError) as told:
        shock_start(given)
    low, high = profile_of(given).extent(1e-3)
    first, last = (float(x) for x in re.search(r"begin at (\S+) m or less and region 'gas' end at (\S+) m", str(told.value)).groups())
    assert (first, last) == pytest.approx((low, high), rel=1e-3) and first <= low and last >= high
    region = dataclasses.replace(given.regions[0], start=first, end=last)
    assert shock_start(dataclasses.replace(given, regions=(region,))) is not None   # the ends it names suffice


def test_of_a_domain_that_is_short_on_one_side_that_end_alone_is_named():
    given, _ = argon_problem(9.0, 10, ahead=12.0, behind=1.0)
    with pytest.raises(DeckError, match="does not hold the shock") as told:
        shock_start(given)
    assert "let region 'gas' end at" in str(told.value) and "begin" not in str(told.value) and "[solver.shock] at" not in str(told.value)


def test_moving_shock_needs_room_for_its_path():
    given, _ = argon_problem(1.55, 10, ahead=6.0, behind=6.0, times=20.0, frame="moving")
    with pytest.raises(DeckError, match="runs .* m until stop_time"):
        shock_start(given)


def test_what_a_fixed_grid_cannot_do():
    given, _ = argon_problem(1.55, 10)
    def refused(words, **changes):
        with pytest.raises(OutOfRange, match=words):
            ShockStructure(dataclasses.replace(given, **changes))
    refused("planar", geometry="spherical")
    refused("not possible on a fixed grid", left=Boundary("free"))
    refused("each is 1.01 times as wide as the one before: leave ratio out", regions=(dataclasses.replace(given.regions[0], ratio=1.01),))
    refused("at least 8 cells", regions=(dataclasses.replace(given.regions[0], zones=4),))
    refused("needs a transport law", solver=SolverOptions("shock_structure"))
    b = dataclasses.replace(given.regions[0], name="b", start=given.regions[0].end * 1.5, end=given.regions[0].end * 2.0)
    refused("gap between 'gas' and 'b'", regions=(given.regions[0], b))


def test_an_impossible_state_stops_the_run_and_keeps_the_last_sound_one():
    eos, state = jordan.argon()
    given = problem(eos, jordan.argon_transport("power_law"), Region("gas", "m", 0.0, 1e-6, 40, density=1.62, temperature=300.0), 1e-9)
    solver = ShockStructure(given)
    solver.march(1e-9, 3)
    solver.U[1, 20] = math.nan
    before = solver.U.copy()
    with pytest.raises(UnphysicalState, match="of region 'gas'.*not a valid state of law 'ideal_gas'"):
        solver.march(1e-9, 10)
    assert solver.cycle == 3 and np.array_equal(solver.cells, before[:, 3:-3], equal_nan=True)
    cold = conserved(np.full(40, 1.62), np.zeros(40), np.full(40, state.energy))
    cold[2, 17] = -1.0
    with pytest.raises(UnphysicalState, match="zone 17 .*not a valid state of law 'ideal_gas'"):
        ShockStructure(given, (cold, cold[:, [0, -1]].T))


def test_conduction_needs_a_temperature():
    gas = IdealGas(1.4, math.nan, 1.2)
    region = Region("gas", "m", 0.0, 1e-6, 40, density=1.2, pressure=1e5)
    with pytest.raises(OutOfRange, match="specific_heat|temperature"):
        ShockStructure(problem(gas, jordan.argon_transport("power_law"), region, 1e-9))
