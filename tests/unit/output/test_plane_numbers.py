"""The numbers of gauges in two dimensions: which velocity each has, and what a lost line of sight or an eroded zone leaves of them."""

from types import SimpleNamespace

import numpy as np
import pytest

from hugoniot.diagnostics.gauges2d import Sampler
from hugoniot.output.compare import Choice, Record, run_records
from hugoniot.output.run_numbers import gauge_rows
from hugoniot.problem.deck import read_deck_text
from hugoniot.state import State2D

TIME = np.linspace(0.0, 1e-6, 201)
FRONT = 1.0 / (1.0 + np.exp(-(TIME - 4e-7) / 1e-8))     # a wave that arrives at 0.4 us
SHELL = """
geometry = "{geometry}"
stop_time = "1 us"
[[block]]
name = "shell"
material = "copper"
shape = "sector"
radius = ["8 cm", "10 cm"]
angle = ["{first} deg", "{last} deg"]
zones = [2, {n}]
[[block]]
name = "liner"
material = "copper"
shape = "sector"
radius = ["7 cm", "8 cm"]
angle = ["{first} deg", "{last} deg"]
zones = [2, {n}]
[[gauge]]
name = "outside"
on = "shell.right"
[[gauge]]
name = "inside"
on = "liner.left"
[[gauge]]
name = "between"
on = "shell/liner"
[solver]
kind = "lagrange2d"
"""


def run_of(kinds, columns):
    """A run of gauges of these kinds (name -> kind) with these columns, (n, ngauge)."""
    none = np.full((len(TIME), len(kinds)), np.nan)
    table = {"time": TIME, "line_velocity": none, "normal_velocity": none} | columns
    setup = {"axes": ["x", "y"], "gauges": [{"name": name, "kind": kind, "at": None} for name, kind in kinds.items()]}
    return SimpleNamespace(setup=setup, gauge_names=lambda: list(kinds), arrays=lambda group: table if group == "gauges" else {})


def test_a_line_of_sight_that_loses_its_surface_leaves_the_other_gauges_their_numbers():
    lost = np.where(TIME < 6e-7, 50.0 * FRONT, np.nan)
    point = 100.0 * FRONT
    run = run_of({"point": "point", "slit": "slit"}, {
        "velocity_x": np.stack([-point, np.where(np.isnan(lost), np.nan, 0.0)], axis=1), "velocity_y": np.stack([0.0 * point, lost], axis=1),
        "line_velocity": np.stack([np.full(len(TIME), np.nan), lost], axis=1), "pressure": np.stack([1e9 * FRONT, lost], axis=1)})
    at_point, at_slit = gauge_rows(run)
    assert at_point["arrival"] == pytest.approx(4e-7, abs=2e-9) and at_point["plateau_velocity"] == pytest.approx(100.0, rel=1e-3)
    assert at_point["plateau_pressure"] == pytest.approx(1e9, rel=1e-3)
    assert at_slit["arrival"] == pytest.approx(4e-7, abs=2e-9) and at_slit["peak_velocity"] == pytest.approx(50.0, rel=1e-3)
    assert np.isnan(at_slit["last_velocity"]) and np.isnan(at_slit["peak_pressure"])


def test_a_body_that_is_thrown_back_as_fast_as_it_came_has_an_arrival():
    """Its speed is the same before and after: the wave is in the vector."""
    v = 200.0 - 400.0 * FRONT
    row, = gauge_rows(run_of({"point": "point"}, {"velocity_x": v[:, None], "velocity_y": 0.0 * v[:, None]}))
    assert row["arrival"] == pytest.approx(4e-7, abs=2e-9)


def test_a_side_has_its_velocity_along_the_outward_normal():
    velocity = np.stack([-300.0 * FRONT, 0.0 * FRONT], axis=1)
    run = run_of({"side": "edge", "other": "edge"}, {"velocity_x": velocity, "velocity_y": 0.0 * velocity, "normal_velocity": velocity})
    assert gauge_rows(run)[0]["last_velocity"] == pytest.approx(-300.0, rel=1e-6)


@pytest.mark.parametrize("geometry, first, last", [("axisymmetric", 0, 90), ("axisymmetric", -90, 90), ("plane", 0, 360), ("plane", 10, 50)])
def test_a_shell_that_closes_evenly_closes_at_its_speed(geometry, first, last):
    """Whatever part of the circle it is: the mean of the vector would be less, and 0 all around. Chords move slower by cos(half an angle)."""
    n = (last - first) // 5
    problem = read_deck_text(SHELL.format(geometry=geometry, first=first, last=last, n=n)).problem
    x, y = problem.mesh.nodes
    nodes = {"position_x": x, "position_y": y, "velocity_x": -500.0 * x / np.hypot(x, y), "velocity_y": -500.0 * y / np.hypot(x, y)}
    zones = {"pressure": np.zeros(len(problem.mesh.zone_nodes))}
    read = Sampler(problem)(State2D(0.0, 0, zones, nodes, problem.mesh.zone_nodes))["normal_velocity"]
    assert read == pytest.approx(np.array([-500.0, 500.0, 500.0]) * np.cos(np.radians(2.5)), rel=1e-9)


def test_records_are_compared_up_to_where_they_are_lost():
    lost = np.where(TIME < 6e-7, 50.0 * FRONT, np.nan)
    run = run_of({"slit": "slit", "point": "point"}, {"velocity_x": np.stack([lost, FRONT], axis=1)})
    run.unit = lambda group, field: "m/s"
    records = {(r.gauge, r.field): r for r in run_records(run)}
    assert set(records) == {("slit", "velocity_x"), ("point", "velocity_x")}
    assert records["slit", "velocity_x"].time[-1] == pytest.approx(6e-7, abs=6e-9) and len(records["point", "velocity_x"].time) == len(TIME)
    assert np.isfinite(records["slit", "velocity_x"].values).all()


def test_data_may_name_a_gauge_as_the_file_of_the_run_does(tmp_path):
    """gauges.csv has a semicolon where a name has a comma."""
    own = [Record("rear face, axis", "velocity_y", "m/s", TIME, FRONT)]
    there = Record("rear face; axis", "velocity_y", "m/s", TIME, FRONT)
    assert Choice(None, None, "", []).counterpart(there, own) is own[0]


def test_round_off_of_a_body_in_balance_is_no_wave():
    """A compressed body whose edges are pressed as much as its inside: forces of 2 GPa leave a few picometres per second."""
    noise = 3e-12 * np.sin(np.arange(len(TIME)) ** 2)
    run = run_of({"point": "point"}, {"velocity_x": noise[:, None], "velocity_y": 0.0 * noise[:, None],
                                      "pressure": np.full((len(TIME), 1), 2e9), "sound_speed": np.full((len(TIME), 1), 4000.0)})
    row, = gauge_rows(run)
    assert np.isnan(row["arrival"]) and row["peak_velocity"] == 0.0 and row["peak_pressure"] == 2e9
