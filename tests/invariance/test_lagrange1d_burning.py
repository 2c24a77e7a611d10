"""Energy with the released heat closes to round-off for every burn law in every geometry, and with every closure it can burn with."""

import dataclasses

import pytest

from hugoniot.laws.burn.arrhenius import Arrhenius
from hugoniot.laws.burn.contract import BURN
from hugoniot.laws.burn.programmed import Beta, Programmed, ProgrammedBeta
from hugoniot.laws.burn.threshold import Threshold
from hugoniot.materials import burning, library
from hugoniot.problem.explosives import front_speed
from hugoniot.problem.model import Boundary, Lighting, OutputOptions, Problem, Pulse, Region
from hugoniot.simulate import make_solver

LX17 = library.find("LX-17 reactive")
OWN = {"programmed": Programmed(7680.0), "beta": Beta(1905.0, 2500.0), "programmed_beta": ProgrammedBeta(7680.0, 1905.0, 2500.0),
       "threshold": Threshold(8e9), "arrhenius": Arrhenius(1e8, 3000.0)}
CLOSURES = ("thermal_isolation", "thermal_equilibrium", "weighted_pressures")
GEOMETRIES = ("planar", "cylindrical", "spherical")
# each law in each geometry, the closures taking turns, and what burns by schedule also without reactants
CASES = [(law.name, geometry, CLOSURES[(i + j) % 3]) for i, law in enumerate(BURN) for j, geometry in enumerate(GEOMETRIES)]
CASES += [(law.name, geometry, "burned_products") for law in BURN if "programmed" in law.flags for geometry in GEOMETRIES]


def test_every_law_and_closure_is_among_the_cases():
    assert {case[0] for case in CASES} == set(BURN.names()) and {case[2] for case in CASES} == {*CLOSURES, "burned_products"}
    assert {case[:2] for case in CASES} == {(name, geometry) for name in BURN.names() for geometry in GEOMETRIES}


@pytest.mark.slow
@pytest.mark.parametrize(("name", "geometry", "closure"), CASES)
def test_released_heat_is_in_the_budget(name, geometry, closure):
    """A piston of 2 km/s pushes 10 mm of explosive of outer radius 20 mm: energy to 1e-12 while 5 % to all of it burns."""
    bare = closure == "burned_products"
    material = dataclasses.replace(LX17, name="x", burn=OWN.get(name, BURN.get(name).example), mixture=closure,
                                   unreacted=None if bare else LX17.unreacted)
    region = Region("charge", "x", 0.01, 0.02, 50)
    left = Boundary("fixed") if bare else Boundary("velocity", Pulse("constant", amplitude=2000.0))
    problem = Problem("budget", geometry, 1.0e-6, (region,), {"x": material}, left, Boundary("fixed"), output=OutputOptions(report=False))
    if front_speed(problem, region) > 0.0:
        problem = dataclasses.replace(problem, lighting=(Lighting(0.01),))
    solver = make_solver(problem)
    largest = 0.0
    while solver.time < problem.stop_time:
        solver.march(problem.stop_time, 40)
        largest = max(largest, solver.errors()["energy_error"])
    state = solver.state()
    burned = float((state.zones["mass"] * state.zones["burn_fraction"]).sum() / state.zones["mass"].sum())
    assert largest < 1e-12 and burned > 0.05
    assert solver.exchanges()["released_heat"] == pytest.approx(burning.heat_of(material) * burned * state.zones["mass"].sum(), rel=1e-12)
