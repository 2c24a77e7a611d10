"""`hugoniot exact`: every solution answers, in the field's words, with units, files and pictures; bad input is told with the way out."""

import csv
import json

import numpy as np
import pytest
from typer.testing import CliRunner

from hugoniot.cli.main import build_app
from hugoniot.theory.exact import SOLUTIONS, Solution


def exact(*arguments):
    return CliRunner().invoke(build_app("exact"), ["exact", *arguments])


def answer(*arguments):
    result = exact(*arguments, "--json")
    assert result.exit_code == 0, result.output
    return json.loads(result.stdout)


def test_the_list_names_every_solution_with_its_source():
    rows = answer()
    assert [row["solution"] for row in rows] == list(SOLUTIONS)
    assert all(len(row["what"]) > 10 and len(row["source"]) > 10 for row in rows)
    for row in rows:
        if row["solution"] != "guderley":  # its numbers take seconds
            assert answer(row["solution"])["source"] == row["source"]


def test_fields_are_those_of_the_callable_in_si():
    found = answer("sedov", "gamma=1.4", "energy=1 MJ", "density=1.2 g/l", "--time", "1 ms", "--at", "0.3 m, 90 cm, 2 m")
    solution = SOLUTIONS["sedov"](gamma=1.4, energy=1e6, density=1.2)
    there = solution(np.array([0.3, 0.9, 2.0]), 1e-3)
    state = found["states"][0]
    assert state["time"] == 1e-3 and state["jumps"] == pytest.approx(solution.jumps(1e-3), rel=1e-14)
    for word, name in (("particle_velocity", "velocity"), ("density", "density"), ("pressure", "pressure"), ("specific_internal_energy", "energy")):
        assert state[word] == pytest.approx(there[name], rel=1e-14)
    assert found["numbers"]["alpha"] == pytest.approx(solution.numbers["alpha"], rel=1e-14)
    planar = answer("sedov", "geometry=planar", "energy=2 J/m^2")
    assert planar["parameters"]["energy"] == 2.0 and planar["states"] == []


def test_both_sides_of_a_jump_are_given(tmp_path):
    out = tmp_path / "sod.csv"
    assert exact("sod", "--time", "0.1", "--time", "0.2", "--csv", str(out)).exit_code == 0
    rows = [row for row in csv.DictReader(out.open()) if float(row["time (s)"]) == 0.2]
    x, rho = (np.array([float(row[k]) for row in rows]) for k in ("position (m)", "density (kg/m^3)"))
    shock = SOLUTIONS["sod"]().jumps(0.2)[-1]
    near = np.abs(x - shock) < 1e-8
    assert near.sum() == 2 and np.ptp(rho[near]) == pytest.approx(0.2655737 - 0.125, abs=1e-6)


def test_records_take_dotted_names_or_a_material():
    sod = answer("riemann_ideal", "left.density=1", "left.velocity=0", "left.pressure=1", "right.density=0.125", "right.velocity=0", "right.pressure=0.1")
    assert sod["numbers"]["star_pressure"] == pytest.approx(SOLUTIONS["sod"]().numbers["star_pressure"], rel=1e-14)
    piston = answer("elastic_plastic_piston", "solid=aluminum_6061", "solid.yield_stress=0.3 GPa", "piston=400 m/s", "--time", "1 us")
    assert piston["parameters"]["solid.rho0"] == 2703.0 and piston["parameters"]["solid.yield_stress"] == 3e8
    assert piston["numbers"]["wave_count"] == 2.0 and len(piston["states"][0]["jumps"]) == 2


def test_plates_points_and_burn_times():
    plate = answer("plate_push", "mass_ratio=0.5", "--time", "50 us", "--time", "500 us")["states"][0]
    there = SOLUTIONS["plate_push"](mass_ratio=0.5)(0.0, 5e-4)
    assert plate["particle_velocity"][1] == pytest.approx(float(there["velocity"]), rel=1e-14)
    burn = answer("kenamond", "problem=2", "--at", "0, 4 m; 3 m, 2 m")["states"][0]
    assert burn["burn_time"] == pytest.approx(SOLUTIONS["kenamond"]()["2"]([[0.0, 4.0], [3.0, 2.0]]), rel=1e-14)
    pair = answer("coggeshall", "--time", "0.5", "--at", "0.1, 0.2")["states"][0]
    assert pair["radial_velocity"] == pytest.approx([-0.2]) and pair["axial_position"] == [0.2]


@pytest.mark.parametrize("arguments", [("noh", "--time", "0.6"), ("plate_push",), ("kenamond", "problem=3"), ("mader", "--time", "2 us", "--time", "6 us"),
                                       ("coggeshall", "--time", "0.5", "--to", "1 m"), ("verney", "--time", "30 us"), ("meeting_streams",), ("dsd_rate_stick",),
                                       ("dsd_arc",), ("blake", "--time", "20 us"), ("dsd_expansion", "--time", "5 us"), ("dsd_rate_stick_start", "--time", "5 us")])
def test_pictures(tmp_path, arguments):
    out = tmp_path / "picture.png"
    result = exact(*arguments, "--plot", str(out))
    assert result.exit_code == 0, result.output
    assert out.read_bytes()[1:4] == b"PNG" and out.stat().st_size > 10_000


def test_every_solution_draws_where_it_holds():
    """The default interval of positions is never empty: a state of every solution that has one."""
    when = {"guderley": None, "kidder": "5 ms", "saltzman": "0.8", "howell_ball": "30 us", "verney": "30 us", "shell_stopping": "30 us", "coggeshall": None,
            "leblanc": "6", "ehep": "1 us", "mader": "1 us", "fickett_rivard": "1 us"}
    for name, function in SOLUTIONS.items():
        if name in ("kenamond", "woodward_colella", "riemann_ideal", "elastic_plastic_piston") or when.get(name, "") is None:
            continue
        assert isinstance(function(), Solution)
        time = when.get(name, "1e-4")
        state = answer(name, "--time", time, *(() if name == "plate_push" else ("--points", "11")))["states"][0]
        assert len(state.get("position", state["time"] if isinstance(state["time"], list) else [])) >= 1, name


@pytest.mark.parametrize(("arguments", "code", "words"), [
    (("sedv",), 2, "did you mean 'sedov'"), (("noh", "gama=1.4"), 2, "did you mean 'gamma'"), (("noh", "gamma"), 2, "PARAMETER=VALUE"),
    (("noh", "speed=2 GPa"), 2, "expected a velocity"), (("noh", "gamma=0.9"), 3, "gamma > 1"), (("noh", "geometry=sphere"), 2, "spherical"),
    (("kidder", "--time", "1 s"), 3, "the solution holds for times from 0 s"), (("riemann_ideal", "left.density=1"), 2, "right.pressure"),
    (("noh", "--csv", "x.csv"), 2, "needs a time"), (("noh", "--at", "0.1"), 2, "needs a time"), (("kenamond", "problem=7"), 2, "Kenamond's problems are"),
    (("kenamond", "problem=1", "--at", "1, 2, 3, 4"), 2, "not a list of points"), (("double_burgers", "half_waves=1.5"), 2, "not a whole number"),
    (("elastic_plastic_piston", "solid=water", "piston=1 m/s"), 2, "write its constants"), (("noh", "--time", "1", "--to", "-1 m"), 2, "is not beyond"),
    (("woodward_colella", "--time", "0.038"), 2, "reference numbers"), (("kenamond", "--time", "1"), 2, "omit --time"),
    (("noh", "--time", "1", "--at", "-0.1"), 2, "is not a radius"), (("mader", "--time", "0"), 3, "above 0"),
    (("riemann_ideal", "--time", "1"), 2, "not given: left.density"),
    (("noh", "--time", "1", "--plot", "noh.doc"), 2, "not a picture file")])
def test_bad_input_is_answered_with_the_way_out(arguments, code, words):
    result = exact(*arguments)
    assert result.exit_code == code, result.output
    assert words in result.output and "Traceback" not in result.output and "defect" not in result.output


def test_kenamond_says_what_its_problems_take():
    """It has no parameter without a usual value: an empty list of needs is not printed."""
    shown = exact("kenamond").output
    assert "needs" not in shown
    assert all(f"problem={n}" in shown for n in (1, 2, 3)) and "detonation_velocity=2.0" in shown and "--at" in shown


def test_streams_of_the_library_meet():
    found = answer("meeting_streams", "below.material=copper", "below.mach=2.5", "below.pressure=0 Pa", "above.material=copper",
                   "above.mach=2.5", "above.pressure=0 Pa", "angle_degrees=-12", "--time", "1 us")
    assert found["numbers"]["slip_angle"] == pytest.approx(-6.0, rel=1e-9)
    assert max(found["states"][0]["pressure"]) == pytest.approx(found["numbers"]["slip_pressure"], rel=1e-12)


def test_a_steady_solution_asks_for_no_time():
    found = answer("meeting_streams", "--at", "-0.1, 0.1")
    assert found["states"][0]["pressure"] == answer("meeting_streams", "--at", "-0.1, 0.1", "--time", "3 s")["states"][0]["pressure"]
    shown = exact("dsd_rate_stick").output
    assert "steady; --at, --csv or --plot" in shown and "holds for times" not in shown
