"""Every solver a deck may name gives the time loop, the run and its checkpoints what `solvers.protocol` promises."""

import importlib.util
import inspect

import numpy as np
import pytest

from hugoniot.core.fields import FIELDS
from hugoniot.problem.deck import read_deck_text
from hugoniot.problem.solver_kinds import available_solvers
from hugoniot.simulate import make_solver
from hugoniot.solvers.lagrange2d.solver import Lagrange2D
from hugoniot.solvers.protocol import COUNTS, Event, LineSolver, PlaneSolver, Solver, SolverState
from hugoniot.state import State

GAS = """
[material.gas.eos]
law = "ideal_gas"
gamma = 1.4
rho0 = 1.2
specific_heat = 717.5
"""

IMPACT = """
title = "impact"
stop_time = "2 us"
[[region]]
name = "flyer"
material = "aluminium 6061-T6"
from = "0 mm"
to = "1 mm"
zones = 10
velocity = "700 m/s"
[[region]]
name = "target"
material = "aluminium 6061-T6"
from = "1 mm"
to = "3 mm"
zones = 20
[[gauge]]
name = "inside"
at = "2 mm"
"""

FLOW = """
title = "flow"
stop_time = "20 ns"
[[region]]
name = "gas"
material = "gas"
from = "0 um"
to = "4 um"
zones = 40
velocity = ["300 m/s", "0 m/s"]
density = 1.2
pressure = "0.1 MPa"
[solver]
kind = "shock_structure"
[solver.transport]
viscosity = {law = "power_law", shear_viscosity = 1.8e-5, exponent = 0.75, reference_temperature = 290.0}
conduction = {law = "prandtl", prandtl = 0.7}
""" + GAS

WAVES = IMPACT.replace("aluminium 6061-T6", "al") + """
[solver]
kind = "fronts"
[material.al.eos]
law = "mie_gruneisen"
rho0 = 2700.0
c0 = 5200.0
s = 1.5
gamma0 = 2.0
[material.al.strength]
law = "perfectly_plastic"
shear_modulus = "24.8 GPa"
yield_stress = "0.3 GPa"
"""

DECKS = {"lagrange1d": IMPACT, "shock_structure": FLOW, "fronts": WAVES}
STEPS = {"lagrange1d": 30, "shock_structure": 30, "fronts": 6}


def solver_of(kind):
    return make_solver(read_deck_text(DECKS[kind], f"{kind}.toml").problem)


def alike(a, b):
    """Whether two payloads hold the same bits."""
    if isinstance(a, dict):
        return a.keys() == b.keys() and all(alike(a[name], b[name]) for name in a)
    return np.array_equal(np.asarray(a), np.asarray(b))


def promised(protocol):
    """Names of the public members of a protocol, and its methods."""
    members = {name: member for cls in protocol.__mro__ for name, member in vars(cls).items() if not name.startswith("_")}
    return set(members), {name: member for name, member in members.items() if inspect.isfunction(member)}


@pytest.fixture(scope="module", params=sorted(DECKS))
def solver(request):
    """A solver that has taken some steps."""
    made = solver_of(request.param)
    made.march(made.problem.stop_time, STEPS[request.param])
    return made


def test_every_solver_of_the_house_is_asked():
    there = [kind for kind in available_solvers() if importlib.util.find_spec(f"hugoniot.solvers.{kind}")]
    assert sorted([*DECKS, "lagrange2d"]) == sorted(there)


def test_the_two_dimensional_solver_has_the_names_promised():
    """Of the class, since its runs are tested in unit/solvers2d: what is no member of it is set where it is made."""
    names, methods = promised(PlaneSolver)
    assert sorted(name for name in names if not hasattr(Lagrange2D, name)) == ["problem", "region_of"]
    for name, method in methods.items():
        assert list(inspect.signature(method).parameters) == list(inspect.signature(getattr(Lagrange2D, name)).parameters), name


def test_it_has_every_name_and_takes_the_arguments_promised(solver):
    names, methods = promised(LineSolver)
    assert {"march", "state", "initial_nodes", "gauge_zones", "payload"} <= names
    assert [name for name in sorted(names) if not hasattr(solver, name)] == []
    assert isinstance(solver, Solver) and isinstance(solver, LineSolver)
    for name, method in methods.items():
        wanted, given = (list(inspect.signature(f).parameters)[1:] for f in (method, getattr(type(solver), name)))     # but for the solver
        assert wanted == given, name


def test_the_clock_runs_and_the_end_is_hit_exactly(solver):
    assert 0 < solver.cycle <= STEPS[solver.problem.solver.kind] and 0.0 < solver.time < solver.problem.stop_time and solver.step > 0.0
    assert solver.zone_updates >= solver.cycle - 1
    zone, region = solver.limiting()
    assert solver.problem.regions[solver.region_of[zone]].name == region
    again = solver_of(solver.problem.solver.kind)
    half = 0.5 * solver.time
    while again.time < half:
        assert all(isinstance(event, Event) and event.text for event in again.march(half, 10_000))
    assert again.time == half and again.march(half, 10) == []


def test_states_are_copies_of_named_fields(solver):
    state, count = solver.state(), len(solver.region_of)
    assert isinstance(state, SolverState) and isinstance(state, State) and (state.time, state.cycle) == (solver.time, solver.cycle)
    assert {"mass", "energy", "density", "pressure"} <= set(state.zones) and set(state.zones) - {"mass"} <= set(FIELDS)
    assert all(values.shape == (count,) for values in state.fields().values())
    left, right = solver.initial_nodes
    assert left.shape == right.shape == (count,) and np.all(right > left)
    before = {name: values.copy() for name, values in state.fields().items()}
    for values in state.fields().values():
        values += 1.0
    assert all(np.array_equal(values, before[name]) for name, values in solver.state().fields().items())


def test_gauges_are_handed_over_once(solver):
    times, values = solver.take_gauges()
    assert all(block.shape[:2] == (len(times), len(solver.gauge_zones)) for block in values.values())
    assert np.all(np.diff(times) > 0.0) and len(solver.take_gauges()[0]) == 0
    assert len(solver.gauge_zones) == 0 or solver.gauge_zones.max() < len(solver.region_of)
    assert all(name.startswith("peak_") and len(values) == len(solver.region_of)
                                       for name, values in solver.peaks().items())


def test_accounts_and_words(solver):
    errors = solver.errors()
    assert all(name.endswith("_error") for name in errors) and 0.0 <= errors["energy_error"] < 1e-9
    assert set(solver.counts()) <= set(COUNTS) and all(isinstance(n, int) and n >= 0 for n in solver.counts().values())
    assert all(np.isfinite(value) for value in (*solver.exchanges().values(), *solver.results().values()))
    assert set(solver.largest_velocity_jump()) <= set(solver.problem.materials)
    assert all(isinstance(text, str) for text in solver.warnings()) and all(len(note) == 2 for note in solver.notes())
    table = solver.front_table()
    assert table is None or table[2].shape == (len(table[1]), len(table[0]))
    assert solver.phases() is None


def test_a_payload_continues_to_the_same_bits(solver):
    again = solver_of(solver.problem.solver.kind)
    again.restore(solver.payload())
    assert (again.time, again.cycle) == (solver.time, solver.cycle)
    whole = solver_of(solver.problem.solver.kind)
    whole.march(whole.problem.stop_time, solver.cycle)
    for one in (again, whole):
        one.take_gauges()
        one.march(one.problem.stop_time, 20)
        one.take_gauges()
    assert alike(again.payload(), whole.payload())
