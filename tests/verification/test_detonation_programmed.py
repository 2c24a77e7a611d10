"""Programmed burn against the CJ state of the same products, plates against Gurney, pentolite in aluminium (Herrmann, H-5 to H-9)."""

import dataclasses

import numpy as np
import pytest
from reactive_builders import (
    PENTOLITE,
    PENTOLITE_CJ,
    PENTOLITE_HEAT,
    PENTOLITE_SPEED,
    QUIET,
    charge,
    comp_b,
    gamma_explosive,
    run,
)

from hugoniot.diagnostics.detonation import body_motion, front_speed
from hugoniot.errors import UnphysicalState
from hugoniot.laws.burn.programmed import Beta, Programmed, ProgrammedBeta
from hugoniot.laws.eos import contract
from hugoniot.laws.eos.contract import EOS
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.laws.fracture.pressure_volume_at_nodes import PressureVolumeAtNodes
from hugoniot.laws.fracture.spall_stress import SpallStress
from hugoniot.laws.strength.contract import STRENGTH
from hugoniot.materials import library
from hugoniot.materials.material import Material
from hugoniot.problem.model import Boundary, Interface, Lighting, Problem, Pulse, Region
from hugoniot.simulate import make_solver
from hugoniot.theory.chapman_jouguet import cj
from hugoniot.theory.exact.ehep import ehep
from hugoniot.theory.exact.kenamond import nested, single
from hugoniot.theory.exact.mader import mader
from hugoniot.theory.exact.plate_push import gurney


def test_comp_b_runs_at_its_speed_with_the_energy_closed():
    """100 zones/cm: D within 0.3 %, CJ pressure within 3 %, energy to 1e-12, heat released equal to the mass burned times Q."""
    material = comp_b()
    point = cj(material.eos)
    solver, seen = run(charge(material))
    assert front_speed(seen.times, seen.path(), 0.005) == pytest.approx(point.detonation_velocity, rel=3e-3)
    assert seen.states[-1].zones["pressure"].max() == pytest.approx(point.state.pressure, rel=0.03)
    assert seen.energy_error < 1e-12
    burned = np.sum(seen.states[-1].zones["burn_fraction"] * seen.states[-1].zones["mass"])
    assert solver.exchanges()["released_heat"] == pytest.approx(burned * material.eos.e0 / material.eos.rho0, rel=1e-12)
    assert solver.warnings() == []


@pytest.mark.parametrize("courant", [0.5, 0.25])
def test_the_pressure_of_a_long_charge_tends_to_the_cj_pressure_from_below(courant):
    """Viscosity in the linear part would compress what is not lit yet: 5 % above it after 720 zones, and more the further it runs."""
    problem = charge(comp_b(), zones=800)
    problem = dataclasses.replace(problem, solver=dataclasses.replace(problem.solver, courant=courant))
    _, seen = run(problem)
    highest = np.array([state.zones["pressure"].max() for state in seen.states[5::5]]) / cj(problem.materials["comp_b"].eos).state.pressure
    assert (np.diff(highest) > 0.0).all() and 0.98 < highest[-1] < 1.0


def test_a_burning_run_continues_from_a_checkpoint_to_the_same_bits():
    problem = charge(comp_b(), zones=100)
    whole, half = make_solver(problem), make_solver(problem)
    half.march(problem.stop_time, 150)
    again = make_solver(problem)
    again.restore(half.payload())
    for solver in (whole, again):
        while solver.time < problem.stop_time:
            solver.march(problem.stop_time, 10**6)
    assert whole.cycle == again.cycle and np.array_equal(whole.zones, again.zones) and np.array_equal(whole.nodes, again.nodes)


def test_lit_in_the_middle_it_burns_both_ways_alike():
    """Mirror symmetry, and a front to each side that keeps its schedule."""
    problem = charge(comp_b(), zones=200, lit=(0.02,), part=0.4, left="free")
    _, seen = run(problem)
    p = seen.states[-1].zones["pressure"]
    assert p == pytest.approx(p[::-1], abs=2e-8 * p.max())
    toward_left = seen.path(toward="left")
    assert front_speed(seen.times, toward_left, 0.003, 0.016) == pytest.approx(7980.0, rel=3e-3)
    assert (toward_left + seen.path())[1:] == pytest.approx(0.04, abs=1e-9)


@pytest.mark.slow
def test_h5_pentolite_reaches_the_cj_state_of_the_report():
    """H-5: 290.3 kb and 2.333 g/cm3 at 7.991 km/s; E0 = 4.7847 MJ/kg, which the report leaves out, follows from them."""
    material = Material("pentolite", PENTOLITE, burn=Programmed(PENTOLITE_SPEED), detonation_energy=PENTOLITE_HEAT)
    assert pytest.approx(4.7847e6, rel=2e-4) == PENTOLITE_HEAT
    solver, seen = run(charge(material, zones=400))
    peak = int(np.argmax(seen.states[-1].zones["pressure"]))
    assert seen.states[-1].zones["pressure"][peak] == pytest.approx(29.03e9, rel=0.03)
    assert seen.states[-1].zones["density"].max() == pytest.approx(2332.77, rel=0.015)
    assert seen.states[-1].velocity_left.max() == pytest.approx(2119.6, rel=0.03)
    assert front_speed(seen.times, seen.path(), 0.005) == pytest.approx(PENTOLITE_SPEED, rel=3e-3)


@pytest.mark.slow
@pytest.mark.parametrize("geometry", ["cylindrical", "spherical"])
def test_a_diverging_front_keeps_its_schedule_below_the_cj_pressure(geometry):
    material = comp_b()
    _, seen = run(charge(material, geometry=geometry, part=0.85))
    assert front_speed(seen.times, seen.path(), 0.008, 0.032) == pytest.approx(7980.0, rel=3e-3)
    assert seen.energy_error < 1e-12
    ideal = cj(material.eos).state.pressure
    assert 0.75 * ideal < seen.states[-1].zones["pressure"].max() < ideal


def with_compression(material):
    """Herrmann's maximum of schedule and compression."""
    point = cj(material.eos)
    return dataclasses.replace(material, burn=ProgrammedBeta(7980.0, material.eos.rho0, float(point.state.density)))


@pytest.mark.slow
@pytest.mark.parametrize("geometry", ["cylindrical", "spherical"])
def test_a_converging_front_starts_on_schedule_and_ends_overdriven(geometry):
    """Lit at the outer radius: D at first, above it and above the CJ pressure later, ahead of the schedule of 7.98 km/s."""
    material = with_compression(comp_b())
    _, seen = run(charge(material, geometry=geometry, inner=0.02, lit=(0.06,), part=0.9))
    path = seen.path(toward="left")
    assert front_speed(seen.times, path, 0.045, 0.058) == pytest.approx(7980.0, rel=3e-3)
    assert seen.states[-1].zones["pressure"].max() > 1.1 * cj(material.eos).state.pressure
    lead = 0.06 - 7980.0 * seen.times - path
    assert lead[-1] - lead[4] > 3e-5
    assert seen.energy_error < 1e-12


@pytest.mark.slow
def test_a_schedule_too_slow_for_convergence_is_refused_with_the_way_out():
    with pytest.raises(UnphysicalState, match="programmed_beta"):
        run(charge(comp_b(), geometry="spherical", inner=0.02, lit=(0.06,), part=0.9))


@pytest.mark.slow
def test_beta_burn_alone_is_a_detonation_started_by_compression():
    """The CJ-volume burn needs no lighting: a piston at the CJ velocity drives a front at D (pure products, gamma = 3)."""
    base = gamma_explosive()
    material = dataclasses.replace(base, burn=Beta(1600.0, 1600.0 * 4.0 / 3.0))
    left = Boundary("velocity", Pulse("constant", amplitude=2000.0))
    problem = Problem("beta", "planar", 4e-6, (Region("charge", "gas", 0.0, 0.04, 400),), {"gas": material}, left, Boundary("free"),
                      output=QUIET)
    _, seen = run(problem)
    assert front_speed(seen.times, seen.path(), 0.01) == pytest.approx(8000.0, rel=0.01)


def distance(state, solution, field):
    """L1 distance of a zone field to an exact profile (means of seven points in a zone), relative to the profile's own L1."""
    width = state.position_right - state.position_left
    points = [solution.profile(state.position_left + (k + 0.5) / 7.0 * width, state.time)[field] for k in range(7)]
    exact = np.mean(np.nan_to_num(points), axis=0)
    found = state.zones[field] if field in state.zones else 0.5 * (state.velocity_left + state.velocity_right)
    return float(np.sum(np.abs(found - exact) * width) / np.sum(np.abs(exact) * width))


def from_a_piston(name, speed, density, length, piston, stop, zones=400):
    """States of a gamma = 3 charge lit at a wall or a piston."""
    gas = gamma_explosive(3.0, speed, density)
    left = Boundary("velocity", Pulse("constant", amplitude=piston)) if piston else Boundary("fixed")
    problem = Problem(name, "planar", stop, (Region("charge", "gas", 0.0, length, zones),), {"gas": gas}, left, Boundary("free"),
                      lighting=(Lighting(0.0),), output=QUIET)
    return run(problem, 3)[1].states


@pytest.mark.slow
def test_b24_escape_of_products():
    """EHEP at 2 and 3 us, when all has burned and escapes: L1 below 0.5 % at 400 zones, of order 0.7."""
    solution = ehep()
    errors = {}
    for zones in (200, 400):
        states = from_a_piston("ehep", 8500.0, 1600.0, 0.01, 500.0, 3e-6, zones)
        errors[zones] = [distance(state, solution, field) for state in states[-2:] for field in ("pressure", "density", "velocity")]
    assert max(errors[400]) < 5e-3
    assert np.all(np.array(errors[200]) > 1.6 * np.array(errors[400]))


@pytest.mark.slow
def test_b24_taylor_wave():
    """Mader: 30 GPa at 8 km/s and 1875 kg/m3 behind a wall, 5 cm. The burn spread over 2.5 zones costs 1.4 % of the pressure at 400 zones."""
    solution = mader()
    assert solution.numbers["cj_pressure"] == pytest.approx(30e9, rel=1e-12)
    state = from_a_piston("mader", 8000.0, 1875.0, 0.05, 0.0, 5.94e-6)[-1]
    assert distance(state, solution, "density") < 4e-3
    assert distance(state, solution, "pressure") < 1.4e-2
    assert distance(state, solution, "velocity") < 3e-2


@pytest.mark.slow
@pytest.mark.parametrize(("geometry", "points", "expected"), [
    ("planar", ((0.01, 0.0), (0.03, 2e-6), (0.05, 5e-7)), "single"),
    ("spherical", ((0.0, 0.0),), "nested"), ("cylindrical", ((0.0, 0.0),), "nested")])
def test_b24_kenamond_burn_times_in_a_run(geometry, points, expected):
    """Fronts to both sides of several points lit at their own times, and from the centre through a fast explosive into a slow one.

    The heat is small, so that nothing moves and only the schedule is seen. A zone burns from the arrival at it on, over 2.5 zones.
    """
    fast, slow = (dataclasses.replace(gamma_explosive(3.0, speed), detonation_energy=10.0, name=name)
                  for name, speed in (("fast", 8000.0), ("slow", 4000.0)))
    regions = (Region("inner", "fast", 0.0, 0.03, 150), Region("outer", "fast" if expected == "single" else "slow", 0.03, 0.06, 150))
    problem = Problem("kenamond", geometry, 1.2e-5, regions, {"fast": fast, "slow": slow}, Boundary("fixed"), Boundary("free"),
                      (Interface("inner", "outer", "bonded"),), lighting=tuple(Lighting(*point) for point in points), output=QUIET)
    _, seen = run(problem, 40)
    centre = np.linspace(0.0, 0.06, 301)[:-1] + 1e-4
    where = np.stack((centre, np.zeros(300)), axis=1)
    if expected == "single":
        arrival = single(where, 8000.0, [(x, 0.0) for x, _ in points], [t for _, t in points])
        speed = np.full(300, 8000.0)
    else:
        arrival = nested(where, 0.03, 8000.0, 4000.0, (), ())
        speed = np.where(centre < 0.03, 8000.0, 4000.0)
    half = 1e-4 / speed
    for state in seen.states:
        burned = state.zones["burn_fraction"]
        assert np.all(burned[state.time < arrival - 1.01 * half] == 0.0)
        assert np.all(burned[state.time > arrival + 6.01 * half] == 1.0)
        ramp = np.clip((state.time - arrival + half) / (5.0 * half), 0.0, 1.0)
        assert np.sum(np.abs(burned - ramp) > 1e-3) <= 4     # but where a front starts or two meet
    assert seen.states[-1].zones["burn_fraction"].min() == 1.0


@pytest.mark.slow
@pytest.mark.parametrize("ratio", [0.2, 0.5, 1.0, 2.0, 5.0])
@pytest.mark.parametrize(("configuration", "geometry"), [("open", "planar"), ("symmetric", "planar"), ("cylinder", "cylindrical"),
                                                         ("sphere", "spherical")])
def test_b21_gurney(configuration, geometry, ratio):
    """Composition B burned at once on copper, within 5 % of Gurney with sqrt(2E) = 2.735 km/s (handbooks: 2.70 to 2.77).

    Read when the gas has grown sevenfold, where Gurney velocities are measured (or in the end, if the plate is too heavy for that).
    """
    d, size, zones = {"planar": 1, "cylindrical": 2, "spherical": 3}[geometry], 0.02, 100
    explosive = dataclasses.replace(comp_b(), burn=None)
    copper = Material("copper", MieGruneisen(8930.0, 3940.0, 1.489, 1.99))
    thick = (size**d + ratio * 1717.0 * size**d / 8930.0) ** (1.0 / d) - size
    regions = (Region("charge", "comp_b", 0.0, size, zones), Region("wall", "copper", size, size + thick, max(8, round(zones * thick / size))))
    problem = Problem("gurney", geometry, 6e-5 if ratio < 3.0 else 1e-4, regions, {"comp_b": explosive, "copper": copper},
                      Boundary("free" if configuration == "open" else "fixed"), Boundary("free"),
                      (Interface("charge", "wall", "bonded"),), output=QUIET)
    solver, seen = run(problem, 100)
    state = next((s for s in seen.states if s.position_left[zones] ** d > 7.0 * size**d), seen.states[-1])
    wall = body_motion(state, solver.region_of, 1)
    found = wall["velocity"] if d == 1 else np.sqrt(2.0 * wall["kinetic_energy"] / wall["mass"])
    assert found == pytest.approx(gurney(configuration, ratio, 2735.0), rel=0.05)


# -- pentolite sphere in aluminium ---------------------------------------------------------------------------------
SERIES = {"literal": (1.014, 2.36, 5.13), "RMW": (2.184, 1.793, -0.72)}
SPALL = {"literal": 1.12e9, "RMW": 1.05e9}     # what puts the outermost spall where the report has it, 7.55 cm (H-9)


def sphere(series="literal", yield_stress=0.276e9, zone=1e-3, stop=2e-5, spall=1.1e9) -> Problem:
    """H-6: aluminium from 1.7 to 9.0 cm around pentolite lit at the centre."""
    k1, k2, k3 = SERIES[series]
    eos = EOS.get("herrmann_series").build(rho0=2780.0, k0=76.4e9, k1=k1, k2=k2, k3=k3, h0=5473.0, h1=1.0, h2=1.0, h3=1.0)
    strength = STRENGTH.get("herrmann").build(2780.0, 28.6e9, 5.86, 8.44, 0.0, yield_stress) if yield_stress else None
    aluminium = Material("aluminium", eos, strength, SpallStress(spall))
    pentolite = Material("pentolite", PENTOLITE, burn=ProgrammedBeta(PENTOLITE_SPEED, 1714.0, PENTOLITE_CJ), detonation_energy=PENTOLITE_HEAT)
    regions = (Region("charge", "pentolite", 0.0, 0.017, round(0.017 / zone)), Region("metal", "aluminium", 0.017, 0.09, round(0.073 / zone)))
    return Problem("sphere", "spherical", stop, regions, {"pentolite": pentolite, "aluminium": aluminium}, Boundary("fixed"),
                   Boundary("free"), (Interface("charge", "metal", "bonded"),), lighting=(Lighting(0.0),), output=QUIET)


def cavity(state, problem):
    return float(state.position_left[problem.regions[0].zones])


@pytest.mark.slow
@pytest.mark.parametrize("series", ["literal", "RMW"])
def test_h6_h7_cavity_of_the_pentolite_sphere(series):
    """2.68 +- 0.08 cm at 20 us with 1 and 0.5 mm zones, converged within 1 %; charge 35.273 g, 168.77 kJ, burned in 2.127 us; the shock
    (half of the surface's velocity, behind the elastic precursor) is outside after 15 us within 5 %."""
    radii = []
    for zone in (1e-3, 5e-4):
        problem = sphere(series, zone=zone)
        solver, seen = run(problem, 160)
        radii.append(cavity(seen.states[-1], problem))
        assert seen.energy_error < 1e-12
        inside = solver.region_of == 0
        assert 4.0 * np.pi * solver.zones[0, inside].sum() == pytest.approx(35.273e-3, rel=1e-3)
        assert 4.0 * np.pi * solver.exchanges()["released_heat"] == pytest.approx(168.77e3, rel=2e-3)
        surface = seen.velocity("right")
        assert seen.times[np.argmax(surface > 0.5 * surface.max())] == pytest.approx(15e-6, rel=0.05)
        lit = np.array([s.zones["burn_fraction"][inside].min() for s in seen.states])
        assert seen.times[np.argmax(lit > 0.5)] == pytest.approx(0.017 / PENTOLITE_SPEED, abs=seen.times[1])
    assert radii == pytest.approx([0.0268, 0.0268], abs=8e-4)
    assert radii[0] == pytest.approx(radii[1], rel=0.01)


@pytest.mark.slow
@pytest.mark.parametrize("series", ["literal", "RMW"])
def test_h8_h9_growth_and_spall(series, zone=2.5e-4):
    """The cavity goes on growing; without strength it is larger, and the outermost spall lies farther out.

    The spall stress the report does not give: 11.2 kb (literal) or 10.5 kb (RMW) puts it at 7.55 +- 0.2 cm, and then that of Y = 0 at
    8.55 +- 0.1 cm, which was not asked of it. On zones of 1 mm the short pulse is smeared, and it lies at 8.25 cm.
    """
    problem, fluid = (sphere(series, strength, zone, stop, SPALL[series]) for strength, stop in ((0.276e9, 1e-4), (0.0, 2e-5)))
    _, seen = run(problem, 50)
    _, weak = run(fluid, 20)
    at_20 = next(s for s in seen.states if s.time >= 2e-5 - 1e-12)
    assert cavity(seen.states[-1], problem) > cavity(at_20, problem)
    assert cavity(weak.states[-1], fluid) > cavity(at_20, problem) + 5e-4
    outermost = [max((e.position for e in w.events if e.kind == "void_opened"), default=0.0) for w in (seen, weak)]
    assert outermost == [pytest.approx(0.0755, abs=2e-3), pytest.approx(0.0855, abs=1e-3)]


@pytest.mark.slow
def test_the_three_spalls_of_the_report():
    """Printed: 7.55, 5.70 and 3.90 cm; without strength several, the outermost at 8.55 cm. A leapfrog on 1 mm zones with one tension, asked at
    nodes, that the report does not give; on other meshes the inner planes lie elsewhere. So they do where other times of output change the
    steps: a node reaches the limit or not."""
    places, steps = [], (10, 60, 120)
    for strength in (0.276e9, 0.0):
        problem = sphere(yield_stress=strength, stop=6e-5)
        aluminium = dataclasses.replace(problem.materials["aluminium"], fracture=PressureVolumeAtNodes(-0.9e9))
        problem = dataclasses.replace(problem, materials=problem.materials | {"aluminium": aluminium},
                                      solver=dataclasses.replace(problem.solver, integrator="wilkins"))
        for count in steps if strength else steps[:1]:
            _, seen = run(problem, count)
            places.append([event.position for event in seen.events if event.kind == "void_opened"])
    for found in places[:-1]:
        assert found[:2] == pytest.approx([0.0755, 0.0570], abs=2e-3) and found[2:] == pytest.approx([0.0390], abs=4e-3)
    assert places[0] == pytest.approx([0.0755, 0.0570, 0.0390], abs=1e-3)
    assert places[-1][0] == pytest.approx(0.0855, abs=1e-3) and len(places[-1]) >= 3


EXPLOSIVES = sorted(name for name, listing in library.index().items() if listing.category == "explosive")


@pytest.mark.slow
@pytest.mark.parametrize("name", EXPLOSIVES)
def test_b25_library_explosives_at_the_cj_state_of_their_products(name):
    """100 zones/cm, front programmed at the CJ velocity of the products: D within 0.3 %, CJ pressure within 3 %.

    At the published velocity, which differs by up to 0.24 %, C-88 and PBX-9502 stay 5 % below the CJ pressure; LX-10, octol and tetryl are
    crushed after 470, 1110 and 1670 zones: `problem.explosives.advice` warns of all five.
    """
    material = dataclasses.replace(library.find(name), name="x")
    point = cj(material.eos)
    assert material.burn.detonation_velocity == pytest.approx(point.detonation_velocity, rel=3e-3)
    _, seen = run(charge(dataclasses.replace(material, burn=Programmed(point.detonation_velocity))))
    assert front_speed(seen.times, seen.path(), 0.005) == pytest.approx(point.detonation_velocity, rel=3e-3)
    assert seen.states[-1].zones["pressure"].max() == pytest.approx(float(point.state.pressure), rel=0.03)
    assert seen.energy_error < 1e-12


def test_library_explosives_burn_at_the_velocity_their_products_sustain():
    """By a scan of the detonation Hugoniot for the least D. At its stated velocity LX-10 ran to 54 GPa in 4 cm (CJ: 37.5)."""
    for name, listing in library.index().items():
        material = library.find(name) if listing.category == "explosive" and listing.curated else None
        if material is None or not isinstance(material.burn, Programmed):
            continue
        par = material.eos
        v = np.linspace(0.6, 0.9, 301)
        burned_at_rest = np.array([contract.pressure(par.rho0 / each, par.e0 / par.rho0, par) for each in v])
        p = burned_at_rest / (1.0 - 0.5 * par.omega * (1.0 - v) / v)
        assert material.burn.detonation_velocity == pytest.approx(np.sqrt(np.min(p / (par.rho0 * (1.0 - v)))), rel=5e-4), name


def test_library_explosives_can_be_burned():
    """Every explosive of the library makes a solver as it stands, given a lighting point."""
    for name, listing in library.index().items():
        if listing.category == "explosive":
            make_solver(charge(dataclasses.replace(library.find(name), name="x"), zones=4))
