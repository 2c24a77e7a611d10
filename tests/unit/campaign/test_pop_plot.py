"""The Pop plot: pistons, run distances, the line, and the command. One small set of runs serves all."""

import dataclasses
import json
import math

import numpy as np
import pytest

from hugoniot.campaign.pop_plot import detonation_velocity, pop_plot
from hugoniot.cli.main import main
from hugoniot.errors import OutOfRange
from hugoniot.materials import library
from hugoniot.theory.chapman_jouguet import cj
from hugoniot.theory.hugoniot import Initial, shock

PRESSURES = (13e9, 15e9, 17e9)
LX17 = library.find("LX-17 reactive")


@pytest.fixture(scope="module")
def plot():
    return pop_plot(LX17, PRESSURES, zone_size=5e-5)


def call(capsys, *arguments):
    with pytest.raises(SystemExit) as ended:
        main(["pop-plot", *arguments])
    out, err = capsys.readouterr()
    return ended.value.code or 0, out, err


def test_pistons_are_those_of_the_unreacted_hugoniot(plot):
    assert plot.detonation_velocity == pytest.approx(cj(LX17.eos).detonation_velocity, rel=1e-9)
    for point, pressure in zip(plot.points, PRESSURES):
        behind = shock(LX17.unreacted, Initial.at_rest(LX17.unreacted), particle_velocity=point.piston_velocity)
        assert point.pressure == pressure == pytest.approx(float(behind.pressure), rel=1e-9)
        assert point.shock_velocity == pytest.approx(float(behind.shock_velocity), rel=1e-9)


def test_shocks_turn_sooner_the_stronger_they_are(plot):
    """x-t starts with the inert shock at the face and ends at the detonation velocity; mean speed to x* lies between both."""
    distances = [p.distance for p in plot.points]
    assert distances == sorted(distances, reverse=True) and plot.line.b < -0.2 and plot.line.deviation < 0.02
    for point in plot.points:
        times, path = point.path
        assert times[0] == path[0] == 0.0
        assert path[2] / times[2] == pytest.approx(point.shock_velocity, rel=0.03)
        assert np.polyfit(times[-10:], path[-10:], 1)[0] == pytest.approx(plot.detonation_velocity, rel=0.03)
        assert point.shock_velocity < point.distance / point.time < plot.detonation_velocity


def test_runs_are_no_measurements(plot, capsys):
    """A run is repeated bit for bit: the scatter about the line is its curvature, no standard deviation of a and b."""
    from hugoniot.cli.pop_plot import _tell

    _tell(plot, [])
    told = next(row for row in capsys.readouterr().out.splitlines() if row.startswith("log10"))
    assert "+-" not in told and f"the {len(plot.points)} runs scatter about this line by {plot.line.deviation:.2g} in log10 p" in told
    assert math.isnan(plot.line.a_deviation) and math.isnan(plot.line.b_deviation)


def test_several_runs_at_a_time_give_the_same_numbers(plot):
    again = pop_plot(LX17, PRESSURES[::-1], zone_size=5e-5, jobs=3)
    assert [(p.distance, p.time) for p in again.points] == [(p.distance, p.time) for p in plot.points] and again.line == plot.line


def test_a_charge_too_short_and_zones_too_coarse_are_told():
    found = pop_plot(LX17, (9e9, 40e9), zone_size=5e-5, longest=5e-3)
    assert "no detonation within 5 mm" in found.points[0].note and "overdriven" in found.points[1].note
    coarse = pop_plot(LX17, (17e9,), zone_size=1.5e-4, longest=3e-2)
    assert "make the zones" in coarse.points[0].note
    assert [point.at_once for point in (*found.points, *coarse.points)] == [False, True, True]
    assert found.line is coarse.line is None and all(np.isnan(p.distance) for p in (*found.points, *coarse.points))


def test_a_front_that_is_a_detonation_from_its_first_reading_detonated_at_once():
    """The rate of LX-17 raised a million times burns a zone within a step."""
    burn = LX17.burn._replace(**{name: 1e6 * getattr(LX17.burn, name) for name in ("i", "g1", "g2")})
    point, = pop_plot(dataclasses.replace(LX17, burn=burn), (10e9,), zone_size=5e-5, longest=5e-3).points
    assert point.at_once and "within fewer than 8 zones" in point.note and np.isnan(point.distance)
    speeds = np.diff(point.path[1]) / np.diff(point.path[0])
    assert np.median(speeds) == pytest.approx(7600.0, rel=0.05)      # of LX-17: its CJ velocity


@pytest.mark.parametrize(("material", "words"), [
    (library.find("comp_b"), "has no rate-based burn law"), (library.find("copper"), "has no rate-based burn law"),
    (dataclasses.replace(LX17, unreacted=None), "unreacted")])
def test_what_has_no_rate_or_no_reactant_is_refused(material, words):
    with pytest.raises(OutOfRange, match=words):
        pop_plot(material, (1e10,))


def test_every_complete_set_is_a_material_by_its_row():
    for row in library.schema.table("ignition_growth").values():
        if "unreacted_a" in row:
            assert 6000.0 < detonation_velocity(library.find(row.id)) < 9000.0
    assert [row.id for row in library.pop_lines("G014")] == ["R001"] == [row.id for row in library.pop_lines("PBX-9404 reactive")]
    assert {row.id for row in library.pop_lines("G007")} == {"R002", "R003"} and library.pop_lines("G008") == ()


def test_the_command_prints_json_csv_and_a_picture(capsys, tmp_path):
    arguments = ("LX-17 reactive", "-p", "14, 17 GPa", "--zone-size", "50 um", "--published", "pbx_9502", "--csv", str(tmp_path / "a.csv"),
                 "--plot", str(tmp_path / "a.png"))
    code, out, _ = call(capsys, *arguments, "--json")
    told = json.loads(out)
    assert code == 0 and [p["pressure"] for p in told["points"]] == [14e9, 17e9]
    ratio = told["published"][0]["distance_ratios"]
    assert told["published"][0]["status"] == "recalled" and 0.1 < ratio[0] < 2.0 and ratio[1] is None
    assert (tmp_path / "a.png").read_bytes()[:4] == b"\x89PNG" and len((tmp_path / "a.csv").read_text().splitlines()) == 3


@pytest.mark.parametrize(("arguments", "words"), [
    (("LX-17 reactive", "-p", "15..3 GPa"), "not a range"), (("LX-17 reactive", "-p", "3 s"), "--pressures"),
    (("LX-17 reactive", "-p", "0..3 GPa"), "not positive"), (("LX-17 reactive", "--closure", "thermal"), "--closure"),
    (("LX-17 reactive", "--published", "copper"), "PBX-9502"), (("comp_b",), "has no rate-based burn law"), (("G010",), "no equation of state of the products"),
    (("LX-17 reactive", "--zone-size", "-1 um"), "--zone-size")])
def test_what_the_command_refuses(capsys, arguments, words):
    code, _, err = call(capsys, *arguments)
    assert code == 2 and words in err
