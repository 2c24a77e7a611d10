"""Heat conduction against the error function, heat sources against their energy, physical viscosity against the steady shock."""

import numpy as np
import pytest
from scipy.special import erf

from hugoniot import simulate
from hugoniot.errors import DeckError
from hugoniot.laws.eos.contract import temperature
from hugoniot.laws.transport.contract import make
from hugoniot.problem.deck import read_deck_text
from hugoniot.solvers.lagrange1d.solver import Lagrange1D
from hugoniot.theory.structure.profile import steady

BLOCK = """
[material.block.eos]
law = "mie_gruneisen"
rho0 = 1000.0
c0 = 1000.0
s = 1.5
gamma0 = 1e-9                      # heat makes no pressure: nothing moves
specific_heat = 1000.0
"""


def conducting(zones, conductivity, stop, integrator="compatible"):
    """Two halves of a bar, 300 K and 900 K."""
    return f"""stop_time = {stop}
[[region]]
name = "cold"
material = "block"
from = -0.05
to = 0.0
zones = {zones}
temperature = 300.0
[[region]]
name = "hot"
material = "block"
from = 0.0
to = 0.05
zones = {zones}
temperature = 900.0
{BLOCK}
[transport.block]
conduction = {{law = "constant", conductivity = {conductivity}}}
[solver]
integrator = "{integrator}"
"""


def finished(text):
    problem = read_deck_text(text, "deck.toml").problem
    run = Lagrange1D(problem)
    while run.time < problem.stop_time:
        run.march(problem.stop_time, 1000)
        run.take_gauges()
    return run


# -- conduction --------------------------------------------------------------------------------------------------------
def miss(zones, conductivity, stop, integrator):
    """(largest error of the temperature over the jump, steps taken)."""
    run = finished(conducting(zones, conductivity, stop, integrator))
    state, eos = run.state(), run.problem.materials["block"].eos
    found = np.array([temperature(rho, e, eos) for rho, e in zip(state.zones["density"], state.zones["energy"])])
    x = 0.5 * (state.position_left + state.position_right)
    exact = 600.0 + 300.0 * erf(x / np.sqrt(4.0 * conductivity / 1e6 * stop))
    assert run.errors()["energy_error"] < 1e-12
    return np.abs(found - exact).max() / 600.0, run.cycle


@pytest.mark.parametrize("conductivity, stop, integrator", [(1e5, 5e-4, "compatible"), (1e7, 5e-6, "compatible"), (1e7, 5e-6, "wilkins")])
def test_conduction_follows_the_error_function_in_second_order(conductivity, stop, integrator):
    """Bound: 0.1 %; 1e7 W/m/K would ask an explicit scheme for 400 steps on the finest grid, the viscosity of a fluid at rest for 66."""
    (coarse, _), (middle, _), (fine, steps) = (miss(zones, conductivity, stop, integrator) for zones in (25, 50, 100))
    assert fine < 1e-4 and middle < 1e-3
    assert np.log2(coarse / middle) > 1.9 and np.log2(middle / fine) > 1.9
    assert conductivity < 1e7 or steps < 80


def test_conduction_in_a_sphere_keeps_the_heat_and_the_range_of_temperatures():
    """Far beyond the stable step of an explicit scheme, a hot core cools into its shell."""
    text = conducting(20, 1e9, 1e-6).replace("from = -0.05\nto = 0.0", "from = 0.0\nto = 0.05").replace("from = 0.0\nto = 0.05\nzones = 20\ntemperature = 900.0",
                                                                                                 "from = 0.05\nto = 0.1\nzones = 20\ntemperature = 900.0")
    run = finished('geometry = "spherical"\n' + text)
    eos = run.problem.materials["block"].eos
    found = [temperature(rho, e, eos) for rho, e in zip(run.state().zones["density"], run.state().zones["energy"])]
    assert run.errors()["energy_error"] < 1e-12 and min(found) >= 300.0 and max(found) <= 900.0
    assert all(np.diff(found) > 0.0) and found[-1] - found[0] < 500.0


# -- heat sources ------------------------------------------------------------------------------------------------------
def heated(source, geometry="planar", integrator="compatible", stop="2 us"):
    return f"""stop_time = "{stop}"
geometry = "{geometry}"
[[region]]
name = "slab"
material = "block"
from = 0.01
to = 0.02
zones = 50
temperature = 300.0
{BLOCK}
[boundary]
left = "fixed"
right = "fixed"
[[heat_source]]
region = "slab"
{source}
[solver]
integrator = "{integrator}"
"""


# each geometry and each integrator, but not each pair of them: a pair is a march of its own, which takes seconds to compile
CURVED = [("cylindrical", "wilkins"), ("spherical", "compatible"),
          *(pytest.param(*pair, marks=pytest.mark.slow) for pair in (("cylindrical", "compatible"), ("spherical", "wilkins")))]


@pytest.mark.parametrize("geometry, integrator", [("planar", "compatible"), ("planar", "wilkins"), *CURVED])
@pytest.mark.parametrize("source, energy", [
    ('intensity = {shape = "half_sine", amplitude = 1e12, duration = "1 us"}\nabsorption_length = "2 mm"',
     lambda face, mass: face * 2e6 / np.pi * (1.0 - np.exp(-5.0))),
    ('intensity = {shape = "exponential", amplitude = 1e12, duration = "0.3 us", start = "0.1 us"}\nside = "right"',
     lambda face, mass: face * 3e5 * (1.0 - np.exp(-19.0 / 3.0))),
    ('intensity = {times = ["0 us", "0.5 us", "1 us"], values = [0, 1e12, 0]}\ndepths = ["1 mm", "3 mm"]\nweights = [2, 1]',
     lambda face, mass: face * 5e5),
    ('power = {shape = "ramp", amplitude = 1e10, duration = "1 us"}', lambda face, mass: mass * 1.5e4),
], ids=["absorbed", "even", "table", "power"])
def test_a_heat_source_supplies_its_energy(source, energy, geometry, integrator):
    run = finished(heated(source, geometry, integrator))
    d = {"planar": 1, "cylindrical": 2, "spherical": 3}[geometry]
    face = (0.02 if "right" in source else 0.01) ** (d - 1)
    expected = energy(face, run.zones[0].sum())
    assert run.exchanges()["supplied_heat"] == pytest.approx(expected, rel=1e-12)
    assert run.total_energy() - run.start_energy == pytest.approx(expected, rel=1e-11)
    assert run.errors()["energy_error"] < 1e-12


def test_absorption_falls_with_depth_as_beer_says():
    run = finished(heated('intensity = {shape = "square", amplitude = 1e12, duration = "1 us"}\nabsorption_length = "2 mm"'))
    state = run.state()
    depth = 0.5 * (state.position_left + state.position_right) - 0.01
    gained = (state.zones["energy"] - 1850.0) * 1000.0
    width = 0.0002 / 0.002
    assert gained == pytest.approx(1e6 / 0.002 * np.exp(-depth / 0.002) * np.sinh(0.5 * width) / (0.5 * width), rel=1e-6)


def test_a_pulse_shorter_than_the_first_step_is_resolved():
    """Deposited in a nanosecond, the heat of a gas becomes pressure at constant volume before anything moves."""
    text = heated('power = {shape = "square", amplitude = 1e17, duration = "1 ps"}', stop="2 ps")
    run = finished(text.replace(BLOCK, '[material.block.eos]\nlaw = "ideal_gas"\ngamma = 1.4\nrho0 = 1.2\nspecific_heat = 717.5\n'))
    assert run.state().zones["pressure"] == pytest.approx(0.4 * 1.2 * (1e5 + 717.5 * 300.0), rel=1e-9)


@pytest.mark.parametrize("source, words", [
    ("", "one of power and intensity"),
    ("power = -1e9", "below absolute zero"),
    ("power = {times = [0.0, 1e-6], values = [1e9, -1e9]}", "below absolute zero"),
    ("power = 1e9\nintensity = 1e9", "one of power and intensity"),
    ('power = 1e9\nabsorption_length = "1 mm"', "applies to an intensity"),
    ('power = 1e9\ndepths = ["1 mm", "3 mm"]', "as many weights as depths"),
    ('power = 1e9\ndepths = ["11 mm", "13 mm"]\nweights = [1, 1]', "weights are 0 throughout 'slab'"),
    ('power = 1e9\ndepths = ["0 mm", "10 mm", "13 mm"]\nweights = [0, 0, 1]', "weights are 0 throughout 'slab'"),
    ('intensity = 1e9\ndepths = ["0 mm", "10 mm", "13 mm"]\nweights = [0, 0, 1]', "weights are 0 throughout 'slab'"),
])
def test_sources_that_cannot_be(source, words):
    with pytest.raises(DeckError, match=words):
        read_deck_text(heated(source), "deck.toml")


# -- viscosity ---------------------------------------------------------------------------------------------------------
ARGON = """
[material.argon.eos]
law = "ideal_gas"
gamma = 1.6666666666666667
specific_heat = 312.15
rho0 = 1.62
"""
TRANSPORT = """
[transport.argon]
viscosity = {law = "constant", shear_viscosity = 2.27e-5}
conduction = {law = "prandtl", prandtl = 0.6666666666666667}
"""


def viscous_shock(zones, integrator):
    """Thickness of a shock of Mach 2 in argon, driven without artificial viscosity, over that of the steady wave; its energy error."""
    law = {"compatible": "limited", "wilkins": "wilkins"}[integrator]
    run = finished(f"""stop_time = "7 ns"
[[region]]
name = "gas"
material = "argon"
from = 0.0
to = "5 um"
zones = {zones}
{ARGON}{TRANSPORT}
[boundary]
left = {{velocity = 363.0}}
right = "fixed"
[solver]
integrator = "{integrator}"
[solver.viscosity]
law = "{law}"
quadratic = 0.0
linear = 0.0
""")
    transport = make({"law": "constant", "shear_viscosity": 2.27e-5}, {"law": "prandtl", "prandtl": 2.0 / 3.0})
    profile = steady(run.problem.materials["argon"].eos, transport, particle_velocity=363.0)
    state = run.state()
    x, rho = 0.5 * (state.position_left + state.position_right), state.zones["density"]
    front = x > 0.363e-6 * 7.0 + 0.3e-6     # beyond the piston, where heat is left as the shock is made
    steepest = np.abs(np.diff(rho) / np.diff(x))[front[1:]].max()
    return (profile.ends.downstream.density - 1.62) / steepest / profile.thickness(), run.errors()["energy_error"]


@pytest.mark.parametrize("integrator", ["compatible", "wilkins"])
def test_a_viscous_conducting_shock_has_its_steady_thickness(integrator):
    """Against the steady wave's own equations, with 6 and with 12 zones of the undisturbed gas in its thickness."""
    (coarse, _), (fine, energy) = (viscous_shock(zones, integrator) for zones in (200, 400))
    assert abs(fine - 1.0) < 6e-3 and abs(fine - 1.0) < abs(coarse - 1.0)
    assert energy < (1e-12 if integrator == "compatible" else 1e-3)


@pytest.mark.parametrize("integrator, options", [("compatible", ""), ("compatible", "courant = 1.0"), ("wilkins", "")])
def test_a_step_of_velocity_diffuses(integrator, options):
    """u0 (1 + erf(x / sqrt(4 nu t)))/2: in 10 ns sound goes 4 um and the motion 0.2 mm. The first step, too, is that of the viscosity,
    600 times shorter than that of sound."""
    text = """stop_time = "10 ns"
[[region]]
name = "slow"
material = "cu"
from = "-1 mm"
to = "0 mm"
zones = 40
[[region]]
name = "fast"
material = "cu"
from = "0 mm"
to = "1 mm"
zones = 40
velocity = "1 m/s"
[[interface]]
between = ["slow", "fast"]
kind = "bonded"
[material.cu.eos]
law = "mie_gruneisen"
rho0 = 8930.0
c0 = 394.0
s = 1.489
gamma0 = 1.99
[transport.cu]
viscosity = {law = "constant", shear_viscosity = 1e4}
"""
    run = finished(text + f'[solver]\nintegrator = "{integrator}"\n{options}\n')
    nu, nodes = 4.0 / 3.0 * 1e4 / 8930.0, run.state()
    exact = 0.5 * (1.0 + erf(nodes.position_right / np.sqrt(4.0 * nu * 1e-8)))
    assert nodes.velocity_right == pytest.approx(exact, abs=2e-3)


@pytest.mark.parametrize("geometry, integrator", CURVED)
def test_viscous_stresses_of_a_linear_velocity_field_in_curved_geometry(geometry, integrator):
    """u = a + b r: rates b along the radius and u/r around it, and what they dissipate in a short time."""
    d = {"cylindrical": 2, "spherical": 3}[geometry]
    mu, zeta = 20.0, 3.0 + 0.5 * 20.0
    text = f"""stop_time = "1 us"
geometry = "{geometry}"
[[region]]
name = "gas"
material = "argon"
from = 1.0
to = 2.0
zones = 100
temperature = 300.0
velocity = [10.0, 30.0]
{ARGON}
[transport.argon]
viscosity = {{law = "constant", shear_viscosity = {mu}}}
bulk_ratio = 0.5
bulk_viscosity = 3.0
[solver]
integrator = "{integrator}"
initial_step = 1e-10
"""
    run = Lagrange1D(read_deck_text(text, "deck.toml").problem)
    run.march(1e-6, 1)
    r = 1.0 + (np.arange(100) + 0.5) * 0.01
    around = (20.0 * r - 10.0) / r
    volume_rate = 20.0 + (d - 1) * around
    radial = 2.0 * mu * (20.0 - volume_rate / 3.0) + zeta * volume_rate
    hoop = 2.0 * mu * (around - volume_rate / 3.0) + zeta * volume_rate
    found = run.terms.conduction.rows[:, 1:99]
    assert found[5] == pytest.approx(radial[1:99], rel=1e-4) and found[6] == pytest.approx(hoop[1:99], rel=1e-4)
    assert run.errors()["energy_error"] < (1e-12 if integrator == "compatible" else 1e-6)


@pytest.mark.parametrize("table, words", [
    ('[transport.iron]\nviscosity = {law = "constant", shear_viscosity = 1.0}', "no region is made of 'iron'"),
    ("[transport.block]\nbulk_ratio = 1.0", "needs a shear viscosity"),
    ('[transport.block]\nconduction = {law = "prandtl", prandtl = 0.7}', "a Prandtl number needs a viscosity"),
    ('[transport.block]\nconduction = {law = "constant", conductivity = -1.0}', "must"),
])
def test_transport_that_cannot_be(table, words):
    with pytest.raises(DeckError, match=words):
        read_deck_text(heated("power = 1e9") + table + "\n", "deck.toml")


def test_conduction_asks_for_a_temperature():
    text = conducting(10, 1.0, 1e-6).replace("specific_heat = 1000.0\n", "").replace("temperature = 300.0\n", "").replace("temperature = 900.0\n", "")
    with pytest.raises(DeckError, match="needs a temperature"):
        read_deck_text(text, "deck.toml")


def test_a_run_books_the_heat_and_names_the_laws_of_transport(tmp_path):
    text = heated('power = {shape = "square", amplitude = 1e9, duration = "1 us"}')
    run = simulate.run(read_deck_text(text + '[transport.block]\nconduction = {law = "constant", conductivity = 100.0}\n', "deck.toml"),
                       tmp_path / "run", report=False)
    assert run.arrays("budget")["supplied_heat"][-1] == pytest.approx(1e3 * 10.0, rel=1e-12)
    assert any(law["family"] == "conduction" for law in run.setup["materials"]["block"]["laws"])
    assert any("Bird, Stewart" in reference for reference in run.setup["references"])
