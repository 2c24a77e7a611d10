"""A state no material can be in stops the run in its cycle, with the zone, the place, the time and the cause."""

import dataclasses

import lagrange_builders as build
import numpy as np
import pytest

from hugoniot.cli.main import main
from hugoniot.errors import OutOfRange, UnphysicalState
from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.laws.eos.stiffened_gas import StiffenedGas
from hugoniot.materials.material import Material
from hugoniot.output.run import read_post_mortem
from hugoniot.problem.advice import advice
from hugoniot.problem.model import Boundary, Interface, Problem, Profile, Pulse, Region
from hugoniot.simulate import make_solver
from hugoniot.solvers.lagrange1d import layout as L
from hugoniot.solvers.lagrange1d.layout import H, Z
from hugoniot.solvers.lagrange1d.post_mortem import diagnose


def stopped(solver, cycles=100_000, stop=1.0):
    """The error a run ends in."""
    with pytest.raises(UnphysicalState) as caught:
        while solver.time < stop and solver.cycle < cycles:
            solver.march(stop, 2000)
            solver.take_gauges()
    error = caught.value
    assert error.zone is not None and error.time == solver.time and error.cycle == solver.cycle
    assert error.cause and error.remedy and np.isfinite(error.position)
    return error


@pytest.mark.parametrize("table, row", [("zones", Z.e), ("zones", Z.inverse_mass), ("nodes", H.u), ("nodes", H.r)])
def test_a_number_that_is_none_is_found_in_the_same_cycle(table, row):
    solver = make_solver(build.flyer((20, 40)))
    build.march_cycles(solver, 30)
    getattr(solver, table)[row, 27] = np.nan
    error = stopped(solver)
    assert error.cycle == 31 and 25 <= error.zone <= 29 and error.region == "target"
    assert 2e-3 < error.position < 3.5e-3 and "not a number" in error.cause
    assert error.region in str(error) and "cycle 31" in str(error)


def test_a_node_that_flies_through_its_neighbours_is_found_in_the_same_cycle():
    solver = make_solver(build.flyer((20, 40)))
    build.march_cycles(solver, 30)
    solver.nodes[H.u, 33] = -1e7
    error = stopped(solver)
    assert error.cycle == 31 and 30 <= error.zone <= 34


@pytest.mark.parametrize("code, change, left, cause, remedy", [
    (L.BAD_STATE, {}, 1.1, "zone is inverted", "courant"),
    (L.BAD_STATE, {}, np.nan, "not a number", "boundaries"),
    (L.BAD_STATE, {"density": -1.0}, 0.9, "density", "courant"),
    (L.BAD_STATE, {"pressure": -1e9}, 0.9, "imaginary in tension", "fracture"),
    (L.BAD_STATE, {}, 0.9, "range of its equation of state", "compression limit"),
    (L.STEP_COLLAPSED, {}, 0.9, "step collapsed", "zones")])
def test_each_cause_has_its_words_and_its_remedy(code, change, left, cause, remedy):
    values = {"density": 2700.0, "pressure": 1e9, **change}
    found = diagnose(code, values, left, 1.0, False)
    assert cause in found[0] and remedy in found[1]


def test_nobody_is_told_to_give_a_fracture_law_to_what_has_one():
    values = {"density": 2700.0, "pressure": -1e9}
    assert "add a fracture law" in diagnose(L.BAD_STATE, values, 0.9, 1.0, False)[1]
    assert "lower the limits of the fracture law" in diagnose(L.BAD_STATE, values, 0.9, 1.0, True)[1]


def test_a_gas_squeezed_for_ever_collapses_the_step():
    """A wall drives the gas against another: the step falls below its floor or a zone tangles, and the run says so."""
    problem = build.gas_tube((20, 20), left=build.constant("velocity", 1.0), stop=2.0)
    error = stopped(make_solver(problem), stop=2.0, cycles=2_000_000)
    assert error.time == pytest.approx(1.0, abs=0.02)
    assert "collapsed" in error.cause or "zone is inverted" in error.cause or "range" in error.cause


def test_tension_without_a_fracture_law_ends_with_the_remedy():
    """Pulled apart, a solid that never parts reaches the imaginary sound speed of its law: the cure is named."""
    solid = dataclasses.replace(build.aluminium(1e12), strength=build.STRENGTH._replace(shear_modulus=1e3, yield_stress=1e3))
    base = build.flyer((20, 40), stop=2e-6)
    problem = dataclasses.replace(base, materials={"al": solid}, gauges=(), left=build.constant("velocity", -3000.0),
                                  right=build.constant("velocity", 3000.0),
                                  regions=(Region("bar", "al", 0.0, 2e-3, 60),))
    error = stopped(make_solver(problem), stop=2e-6)
    assert "tension" in error.cause and "fracture" in error.remedy
    assert error.values["pressure"] < 0.0


def test_a_start_outside_the_law_is_refused_before_the_first_step():
    base = build.flyer((20, 40))
    dense = dataclasses.replace(base.regions[0], density=9000.0, energy=0.0)
    with pytest.raises(OutOfRange, match="flyer"):
        make_solver(dataclasses.replace(base, regions=(dense, base.regions[1])))


def squeeze_deck():
    return """title = "squeeze"
geometry = "planar"
stop_time = "2 s"
[[region]]
name = "gas"
material = "gas"
from = "1 m"
to = "2 m"
zones = 40
density = 1.0
pressure = 1.0
[material.gas.eos]
law = "ideal_gas"
gamma = 1.4
[boundary]
left = {velocity = 1.0}
right = "fixed"
[output]
report = false
"""


def test_the_post_mortem_and_exit_code_three(tmp_path):
    deck, folder = tmp_path / "squeeze.toml", tmp_path / "squeeze.run"
    deck.write_text(squeeze_deck())
    with pytest.raises(SystemExit) as left:
        main(["run", str(deck), "--out", str(folder)])
    assert left.value.code == 3
    text = (folder / "post_mortem.txt").read_text()
    assert "zone" in text and "of region 'gas'" in text and "cycle" in text and "Remedy" in text
    solver = read_post_mortem(folder)["solver"]
    assert solver["zones"].shape[1] == 40 and not (folder / "summary.json").exists()


# -- boundaries -------------------------------------------------------------------------------------------------------
def pulse_tube(right, amplitude=0.01, zones=400):
    """Gas at rest between 1 and 2, a half-sine of pressure from the left, then the left side held at the gas's pressure."""
    length = 0.25
    table = tuple(np.linspace(0.0, length, 101))
    values = tuple(1.0 + amplitude * np.sin(np.pi * np.array(table) / length))
    left = Boundary("pressure", Pulse("table", times=table, values=values))
    base = build.gas_tube(left=left, right=right, stop=3.0)
    region = Region("gas", "gas", 1.0, 2.0, zones, density=1.0, pressure=1.0)
    return dataclasses.replace(base, regions=(region,), interfaces=())


@pytest.mark.parametrize("integrator", ["compatible", "wilkins"])
def test_a_stream_passes_a_transmitting_boundary_undisturbed(integrator):
    """Gas that runs through both ends at a quarter of its sound speed for two transits of sound."""
    moving = build.gas_tube(left=Boundary("transmitting"), right=Boundary("transmitting"), velocity=0.3, stop=1.5, integrator=integrator)
    alike = tuple(dataclasses.replace(region, density=1.0, pressure=1.0) for region in moving.regions)
    solver, _ = build.run(dataclasses.replace(moving, regions=alike))
    state = solver.state()
    assert np.allclose(state.zones["pressure"], 1.0, rtol=1e-9) and np.allclose(state.velocity_left, 0.3, rtol=1e-9)
    assert solver.errors()["momentum_error"] < 1e-12


@pytest.mark.parametrize("options", [{}, {"integrator": "wilkins", "viscosity": ("wilkins", {"linear": 0.25})}], ids=["compatible", "wilkins"])
def test_a_transmitting_boundary_lets_a_pulse_out(options):
    """The echo of a 1 % pulse, seen in the middle after it has left, is below a hundredth of it; a wall gives all of it back."""
    heights = {}
    for name, right in (("transmitting", Boundary("transmitting")), ("fixed", build.FIXED)):
        solver = make_solver(build.changed(pulse_tube(right), **options))
        passing = echo = 0.0
        while solver.time < 1.35:       # sound goes 1 in 0.845; the echo is in the middle from 1.27 on
            solver.march(1.35, 5)
            solver.take_gauges()
            height = abs(solver.zones[Z.p, 200] - 1.0)
            if solver.time < 0.8:
                passing = max(passing, height)
            elif solver.time > 1.05:
                echo = max(echo, height)
        heights[name] = echo / passing
    assert heights["fixed"] > 0.7
    assert heights["transmitting"] < 0.01


def test_a_pressure_boundary_launches_the_shock_its_pressure_asks_for():
    """p = 3 on a gas at rest: particle velocity and density behind the shock from the jump conditions, 0.2 %."""
    base = build.gas_tube(left=build.constant("pressure", 3.0), right=Boundary("free"), stop=0.3)
    region = Region("gas", "gas", 1.0, 2.0, 400, density=1.0, pressure=1.0)
    solver, _ = build.run(dataclasses.replace(base, regions=(region,), interfaces=()))
    p, p0, g = 3.0, 1.0, 1.4
    density = ((g + 1.0) * p + (g - 1.0) * p0) / ((g - 1.0) * p + (g + 1.0) * p0)
    velocity = np.sqrt((p - p0) * (1.0 - 1.0 / density))
    state = solver.state()
    behind = slice(30, 120)
    assert np.mean(state.zones["pressure"][behind]) == pytest.approx(3.0, rel=2e-3)
    assert np.mean(state.zones["density"][behind]) == pytest.approx(density, rel=2e-3)
    assert np.mean(state.velocity_right[behind]) == pytest.approx(velocity, rel=2e-3)
    assert solver.exchanges()["work_left"] == pytest.approx(p * velocity * 0.3, rel=5e-3)


def test_a_velocity_boundary_moves_as_told():
    pulse = Pulse("table", times=(0.0, 0.1, 0.3), values=(0.0, 0.5, 0.2))
    solver, _ = build.run(build.gas_tube(left=Boundary("velocity", pulse), stop=0.3))
    state = solver.state()
    assert state.velocity_left[0] == pytest.approx(0.2, rel=1e-12)
    assert state.position_left[0] - 1.0 == pytest.approx(0.5 * 0.1 * 0.5 + 0.2 * 0.5 * (0.5 + 0.2), rel=1e-4)


# -- interfaces -------------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("kind, strength, opens", [("separable", 0.0, True), ("bond", 0.4e9, True), ("bond", 3e9, False), ("bonded", 0.0, False)])
def test_an_interface_holds_what_its_bond_carries(kind, strength, opens):
    """Plates of equal thickness: the release waves meet at the interface and pull on it with about 2 GPa."""
    base = build.flyer((40, 40), speed=0.0, spall=9e9, stop=2.0e-6)
    regions = (Region("left", "al", 0.0, 2e-3, 40, velocity=-60.0), Region("right", "al", 2e-3, 4e-3, 40, velocity=60.0))
    bond = Interface("left", "right", kind, strength)
    solver, watcher = build.run(dataclasses.replace(base, regions=regions, interfaces=(bond,), gauges=()))
    opened = [e for e in watcher.events if e.kind == "interface_separated"]
    assert bool(opened) == opens
    if opens:
        assert "between 'left' and 'right'" in opened[0].text
        assert len(opened) == 1


@pytest.mark.parametrize("density", [10.0, 50.0])
def test_no_gap_opens_between_a_liquid_and_the_gas_it_pushes(density):
    """A gas expands faster than any liquid recedes. The release of the liquid undershoots into tension in its first zones, and the half
    zones at the contact slow down together; the gas is under pressure at all times."""
    regions = (Region("liquid", "liquid", 0.0, 0.7, 70, density=1000.0, pressure=2e8),
               Region("gas", "gas", 0.7, 1.0, 30, density=density, pressure=2e5))
    materials = {"liquid": Material("liquid", StiffenedGas(4.4, 6e8, 1000.0)), "gas": Material("gas", IdealGas(1.4))}
    solver, watcher = build.run(Problem("tube", "planar", 1e-4, regions, materials, Boundary("fixed"), Boundary("fixed")))
    assert not [e.text for e in watcher.events if e.kind in ("interface_separated", "void_closed")]
    tension = solver.peaks()["peak_tension"]
    assert 5e7 < tension[:70].max() < 0.403 * 1.998e8 and tension[70:].max() <= 0.0


def test_a_sudden_release_undershoots_as_a_chain_of_zones_does_and_the_deck_says_so():
    """Masses on springs of a linear law, released at one end: the end moves at 1.470 of the velocity of the wave (the integral of J0 up to
    its first zero), the last spring drops by 1.403 of the pressure. So does a liquid whose drop is small beside its stiffness."""
    regions = (Region("liquid", "liquid", 0.0, 1.0, 60, density=1000.0, pressure=1e6),)
    problem = Problem("release", "planar", 3e-4, regions, {"liquid": Material("liquid", StiffenedGas(4.4, 6e8, 1000.0))},
                      Boundary("fixed"), Boundary("free"))
    solver, watcher = build.run(problem)
    assert solver.peaks()["peak_tension"][-1] == pytest.approx(0.403e6, rel=0.03)
    said = [text for text in advice(problem) if "undershoot" in text]
    assert len(said) == 1 and "1 MPa beside 0 Pa" in said[0] and "400 kPa" in said[0]
    gas = dataclasses.replace(problem, materials={"liquid": Material("liquid", IdealGas(1.4))})
    assert not [text for text in advice(gas) if "undershoot" in text]


@pytest.mark.parametrize("beside", ["free end", "gap", "the reference state"])
@pytest.mark.parametrize("given", ["pressure", "density and energy", "profile"])
def test_a_sudden_release_is_foretold_however_the_state_is_given_and_whatever_lies_beside_it(given, beside):
    """An ideal liquid with p = (gamma - 1) rho e - gamma p_inf: 100 MPa at 1000 kg/m3 is e = (1e8 + 4.4 * 6e8)/3400, the same state."""
    state = {"pressure": {"pressure": 1e8}, "density and energy": {"density": 1000.0, "energy": (1e8 + 4.4 * 6e8) / 3400.0},
             "profile": {"profile": Profile((0.0, 1.0), (("pressure", (1e8, 1e8)),))}}[given]
    start = {"free end": 9.0, "gap": 1.1, "the reference state": 1.0}[beside]
    regions = (Region("liquid", "liquid", 0.0, 1.0, 60, **state), Region("other", "liquid", start, start + 1.0, 60))
    ends = {"free end": (Boundary("fixed"), Boundary("free"))}.get(beside, (Boundary("fixed"), Boundary("fixed")))
    problem = Problem("release", "planar", 3e-4, regions[:1] if beside == "free end" else regions,
                      {"liquid": Material("liquid", StiffenedGas(4.4, 6e8, 1000.0))}, *ends)
    said = [text for text in advice(problem) if "undershoot" in text]
    assert len(said) == 1 and "'liquid' starts at 100 MPa beside 0 Pa" in said[0] and "40 MPa" in said[0]


def test_the_jump_of_the_zone_mass_is_that_of_the_states_in_which_the_regions_start():
    """A gas at 300 K has the density p/(R T): at 10 MPa a hundred times that at 100 kPa, with zones of the same width."""
    gas = Material("gas", IdealGas(1.4, specific_heat=717.5, rho0=1.2))
    regions = tuple(Region(f"{p:g}", "gas", k, k + 1.0, 50, pressure=p, temperature=300.0) for k, p in enumerate((1e7, 1e5)))
    said = [text for text in advice(Problem("tube", "planar", 1e-4, regions, {"gas": gas})) if "zone mass" in text]
    assert len(said) == 1 and "factor of 100 " in said[0]


@pytest.mark.parametrize("pressure", [1e5, 1e8])
def test_the_speed_to_which_a_gas_is_shocked_is_counted_from_its_initial_state(pressure):
    """Gas thrown against a wall at 2 km/s is shocked to that particle velocity, whatever its pressure; a driver gas that expands is not."""
    helium = Material("helium", IdealGas(5.0 / 3.0, 3116.0, 0.1636))
    region = Region("gas", "helium", 0.0, 0.1, 60, velocity=-2000.0, pressure=pressure, temperature=300.0)
    problem = Problem("wall", "planar", 3e-5, (region,), {"helium": helium}, Boundary("fixed"), Boundary("fixed"))
    thrown, _ = build.run(problem)
    assert thrown.largest_velocity_jump()["helium"] == pytest.approx(2000.0, rel=0.1)      # wall heating and viscosity
    driver, _ = build.run(dataclasses.replace(problem, regions=(dataclasses.replace(region, velocity=0.0),), right=Boundary("free")))
    assert driver.largest_velocity_jump()["helium"] < 1.0


@pytest.mark.parametrize("energy", [0.05, 1e-4])
def test_a_cavity_closes_on_the_origin_and_stays_closed(energy):
    """An imploding shell of gas: no node passes the origin, the motion that ends there is heat, and the budget stays closed."""
    region = Region("shell", "gas", 0.3, 1.0, 100, velocity=-1.0, density=1.0, energy=energy)
    base = build.gas_tube(geometry="spherical", left=build.FREE, right=build.FREE, stop=1.0, largest_step=1e-3)
    solver, watcher = build.run(dataclasses.replace(base, regions=(region,), interfaces=()))
    assert [event.kind for event in watcher.events] == ["void_closed"] and "cavity" in watcher.events[0].text
    assert watcher.events[0].time <= 0.3 * (1.0 + 1e-6)
    assert solver.state().position_left[0] == 0.0 and np.all(np.diff(solver.state().position_left) > 0.0)
    assert solver.errors()["energy_error"] <= 1e-12 and solver.errors()["momentum_error"] <= 1e-12
