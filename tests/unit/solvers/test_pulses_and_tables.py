"""Boundary pulses, tables of runs, pieces and spans, graded nodes, gauges in place."""

import dataclasses
import math

import lagrange_builders as build
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from hugoniot.errors import OutOfRange
from hugoniot.mesh.line import graded_nodes
from hugoniot.problem.model import Boundary, Gauge, Problem, Pulse, Region
from hugoniot.simulate import make_solver
from hugoniot.solvers.lagrange1d import layout as L
from hugoniot.solvers.lagrange1d.assemble import history
from hugoniot.solvers.lagrange1d.bodies import SHARE, run_table, shares_of
from hugoniot.solvers.lagrange1d.layout import H, Z
from hugoniot.solvers.lagrange1d.pulses import pulse_mean, pulse_value

A, T0, D = 3.0, 0.2, 0.5
SHAPES = {
    "constant": lambda s: A,
    "exponential": lambda s: A * math.exp(-s / D),
    "half_sine": lambda s: A * math.sin(math.pi * s / D) if s < D else 0.0,
    "square": lambda s: A if s < D else 0.0,
    "ramp": lambda s: A * min(s / D, 1.0),
}


def value(pulse, time):
    return pulse_value.py_func(time, *history(pulse))


@pytest.mark.parametrize("shape", SHAPES)
def test_a_pulse_is_zero_before_it_starts_and_its_formula_after(shape):
    pulse = Pulse(shape, amplitude=A, start=T0, duration=D)
    assert value(pulse, 0.19) == 0.0
    for since in (0.0, 0.1, 0.25, 0.499, 0.501, 3.0):
        assert value(pulse, T0 + since) == pytest.approx(SHAPES[shape]((T0 + since) - T0), rel=1e-15, abs=1e-15)


@given(st.floats(-1.0, 5.0))
def test_a_table_is_linear_between_and_held_outside(time):
    pulse = Pulse("table", times=(0.0, 1.0, 1.5, 4.0), values=(2.0, -1.0, 5.0, 5.5))
    assert value(pulse, time) == pytest.approx(float(np.interp(time, pulse.times, pulse.values)), rel=1e-14, abs=1e-14)


@pytest.mark.parametrize("shape", [*SHAPES, "table"])
def test_the_mean_of_a_pulse_is_that_of_its_values(shape):
    """Stretches before, across, inside and after the pulse and its corners, against the midpoint rule."""
    pulse = Pulse(shape, amplitude=A, start=T0, duration=D) if shape != "table" else Pulse("table", times=(0.2, 0.3, 0.7), values=(1.0, 5.0, 0.0))
    for begin, end in ((0.0, 0.1), (0.0, 2.0), (0.1, 0.4), (0.25, 0.28), (0.3, 0.9), (0.9, 1.5)):
        times = begin + (end - begin) * (np.arange(20_000) + 0.5) / 20_000
        assert pulse_mean(begin, end, *history(pulse)) == pytest.approx(np.mean([value(pulse, t) for t in times]), rel=1e-3, abs=1e-12)


SHORT = {"square": (Pulse("square", 1e10, 1e-7, 3e-9), 30.0), "sine": (Pulse("half_sine", 1e9, 1e-7, 1e-8), 20.0 / math.pi),
         "decay": (Pulse("exponential", 1e9, 1e-7, 2e-9), 2.0),
         "table": (Pulse("table", times=(1e-7, 1.01e-7, 1.02e-7), values=(0.0, 1e10, 0.0)), 10.0)}


@pytest.mark.parametrize("integrator", ["compatible", "wilkins"])
@pytest.mark.parametrize("shape", SHORT)
def test_a_pulse_shorter_than_a_step_has_its_whole_impulse(shape, integrator):
    """Steps are 8 to 10 ns: at their middles a pressure of 3 ns was missed or counted threefold, and a velocity of 6 ns moved nothing."""
    pulse, impulse = SHORT[shape]
    region = Region("plate", "al", 0.0, 4e-3, 20)
    problem = Problem("short", "planar", 3e-7, (region,), {"al": build.aluminium()}, left=Boundary("pressure", pulse))
    problem = dataclasses.replace(problem, solver=dataclasses.replace(problem.solver, integrator=integrator))
    solver, _ = build.run(problem)
    assert solver.exchanges()["impulse_left"] == pytest.approx(impulse, rel=1e-9)
    moved = Pulse("table", times=(1e-7, 1.03e-7, 1.06e-7), values=(0.0, 1e3, 0.0))
    solver, _ = build.run(dataclasses.replace(problem, left=Boundary("velocity", moved)))
    assert solver.nodes[H.r, 0] == pytest.approx(3e-6, rel=1e-9)
    assert integrator == "wilkins" or solver.errors()["energy_error"] < 1e-12


def test_every_pulse_of_the_model_has_a_code():
    assert set(L.PULSES) == set(SHAPES) | {"table"}


bodies = st.lists(st.lists(st.integers(1, 3000), min_size=1, max_size=4), min_size=1, max_size=4)


@settings(max_examples=60)
@given(bodies, st.randoms())
def test_every_zone_is_in_one_piece_and_every_inner_node_in_one_span(sizes, chance):
    """Any number of bodies (lists of region sizes), whatever the multiples of a piece they are."""
    ends, segments, z = [], [], 0
    for body in sizes:
        first = z
        for n in body:
            ends.append((z, z + n))
            z += n
        segments.append((first, z, L.FREE, L.FREE))
    segments = np.array(segments)
    recipe_of = [chance.randint(0, 3) for _ in ends]
    runs = run_table(segments, ends, recipe_of)
    shares, spans, ranges = shares_of(runs, segments, [(a, b, False) for a, b in ends])
    for table in (runs, shares, ranges):
        assert np.array_equal(np.concatenate([np.arange(row[0], row[1]) for row in table]), np.arange(z))
    region_of = np.repeat(np.arange(len(ends)), [b - a for a, b in ends])
    for first, last, segment, recipe in shares:
        assert last - first <= SHARE and segments[segment, 0] <= first and last <= segments[segment, 1]
        assert {recipe_of[k] for k in set(region_of[first:last])} == {recipe}
    inner = [node for k, (a, b, _, _) in enumerate(segments) for node in range(a + k + 1, b + k)]
    spanned = [node for a, b, k in spans for node in range(a + k + 1, b + k)]
    assert sorted(spanned) == inner


def test_neighbouring_regions_of_one_material_are_one_run():
    segments = np.array([(0, 30, L.FREE, L.FREE), (30, 40, L.FREE, L.FREE)])
    ends = [(0, 10), (10, 20), (20, 30), (30, 40)]
    assert run_table(segments, ends, [0, 0, 1, 1]).tolist() == [[0, 20, 0, 0], [20, 30, 0, 1], [30, 40, 1, 1]]


@given(st.floats(-1.0, 1.0), st.floats(1e-3, 2.0), st.integers(1, 500), st.floats(0.97, 1.03))
def test_graded_nodes_have_exact_ends_and_a_constant_ratio(start, length, zones, ratio):
    nodes = graded_nodes(start, start + length, zones, ratio)
    assert nodes[0] == start and nodes[-1] == start + length and len(nodes) == zones + 1
    widths = np.diff(nodes)
    assert np.all(widths > 0.0)
    if zones > 1:
        noise = 1e-14 * (abs(start) + length) / widths.min()
        assert np.max(np.abs(widths[1:] / widths[:-1] / ratio - 1.0)) <= 4.0 * noise + 1e-12


def with_gauges(*places, geometry="planar", ratio=1.0):
    regions = (Region("a", "al", 1e-3, 3e-3, 20, ratio=ratio), Region("b", "al", 3e-3, 7e-3, 20))
    return Problem("gauges", geometry, 1e-6, regions, {"al": build.aluminium()}, gauges=tuple(Gauge(str(p), p) for p in places))


@pytest.mark.parametrize("geometry", ["planar", "cylindrical", "spherical"])
def test_a_point_gauge_stands_in_the_fraction_of_mass_it_was_put_at_and_interpolates(geometry):
    """Position: exact in mass coordinates. A field linear in the mass coordinate is read without error inside a region."""
    places = (1.0e-3, 1.234e-3, 2.0e-3, 2.777e-3, 6.999e-3)
    solver = make_solver(with_gauges(*places, geometry=geometry))
    d = solver.problem.dimension
    mass = np.concatenate(([0.0], np.cumsum(solver.zones[Z.mass])))
    middle = 0.5 * (mass[1:] + mass[:-1])
    for i, place in enumerate(places):
        a, b, face, node = solver.gauges[i]
        w, f, _ = solver.weights[i]
        left, right = solver.nodes[H.r, node], solver.nodes[H.r, node + 1]
        assert (left**d + f * (right**d - left**d)) ** (1.0 / d) == pytest.approx(place, rel=1e-12)
        at = 2700.0 * (place**d - 1e-3**d) / d
        inside = middle[0] <= at <= middle[19] or middle[20] <= at <= middle[-1]
        if inside:
            assert (1.0 - w) * middle[a] + w * middle[b] == pytest.approx(at, rel=1e-12)
        else:
            assert w == 0.0 and a == b


def test_named_gauges_sit_on_their_faces():
    solver = make_solver(with_gauges("free surface left", "free surface right", "a/b", "a:right", "b:left"))
    faces = [1e-3, 7e-3, 3e-3, 3e-3, 3e-3]
    for (_, _, _, node), (_, f, _), place in zip(solver.gauges, solver.weights, faces):
        assert (1.0 - f) * solver.nodes[H.r, node] + f * solver.nodes[H.r, node + 1] == pytest.approx(place, rel=1e-14)


def test_an_interface_gauge_reads_the_traction_its_node_feels():
    solver = make_solver(with_gauges("a/b"))
    a, b, _, _ = solver.gauges[0]
    w = solver.weights[0, 0]
    m = solver.zones[Z.mass]
    assert (a, b) == (19, 20) and w == pytest.approx(m[19] / (m[19] + m[20]), rel=1e-15)


def test_a_gauge_where_nothing_stands_is_refused():
    with pytest.raises(OutOfRange, match="there is no material at 0.009 m"):
        make_solver(with_gauges(9e-3))
