"""Decks of tracked fronts: what is read, what is refused and why, run folders, and resuming in mid-interaction."""

import csv
import json

import numpy as np
import pytest
from aluminium_decks import EOS, STRENGTH, gauge, impact

import hugoniot
from hugoniot.errors import DeckError
from hugoniot.output.run_numbers import gauge_rows
from hugoniot.problem.deck import read_deck_text
from hugoniot.simulate import make_solver

HEAD = 'title = "Plate on plate"\nstop_time = "3 us"\n' + impact(20, 40, "2.1 mm") + EOS
TAIL = gauge("mid-target", "2.5 mm") + """\
[solver]
kind = "fronts"
[solver.options]
weakest = 1e-5
[output]
snapshots = "1 us"
"""
DECK = HEAD + STRENGTH + TAIL
FLUID = HEAD + TAIL      # no precursors: fans alone meet


def solver_of(text):
    return make_solver(read_deck_text(text).problem)


def test_a_deck_reads_back_to_the_same_problem():
    deck = read_deck_text(DECK)
    assert deck.problem.solver.options["weakest"] == 1e-5 and deck.problem.solver.options["fan_step"] == 0.1
    assert read_deck_text(deck.resolved).problem == deck.problem


def test_a_run_leaves_its_fronts_and_gauges(tmp_path):
    path = tmp_path / "plates.toml"
    path.write_text(DECK)
    run = hugoniot.run(path, tmp_path / "plates.run", report=False, stop_time="0.45 us")
    rows = list(csv.DictReader((run.folder / "fronts.csv").open()))
    kinds = {row["kind"] for row in rows}
    assert {"shock", "elastic shock", "interface", "surface"} <= kinds
    gap = next(row for row in rows if row["kind"] == "surface" and float(row["velocity_left"]) == 700.0)
    assert float(gap["end_time"]) == pytest.approx(0.1e-3 / 700.0, rel=1e-12)      # the gap of 0.1 mm closes
    for row in rows:
        if "shock" in row["kind"]:      # mass through the front is the same on both sides
            s = float(row["velocity"])
            left, right = (float(row[f"density_{k}"]) * (s - float(row[f"velocity_{k}"])) for k in ("left", "right"))
            assert left == pytest.approx(right, rel=1e-9)
    summary = json.loads((run.folder / "summary.json").read_text())
    assert summary["status"] == "done" and summary["energy_error"] < 1e-12 and summary["mass_error"] < 1e-12
    record = run.gauges["velocity"].sel(gauge="mid-target").values
    assert record[0] == 0.0 and record.max() == pytest.approx(350.0, rel=1e-9)
    assert "meeting" in (run.folder / "run.log").read_text()


def fields_of(solver):
    state = solver.state()
    return {**state.zones, "left": state.position_left, "right": state.position_right, "u": state.velocity_left}


def test_resuming_in_mid_interaction_gives_the_same_bits():
    whole = solver_of(FLUID)
    whole.march(2.2e-6, 10**9)
    assert whole.line.cuts > 0      # the release from the back has met the other one
    broken = solver_of(FLUID)
    broken.march(2.2e-6, 25)
    broken.take_gauges()
    from hugoniot.output.codec import decode, encode

    again = solver_of(FLUID)
    again.restore(decode(encode(broken.payload())))
    again.march(2.2e-6, 10**9)
    assert again.cycle == whole.cycle and again.errors() == whole.errors()
    for name, value in fields_of(whole).items():
        assert np.array_equal(value, fields_of(again)[name]), name
    mine, theirs = again.front_table(), whole.front_table()
    assert mine[1] == theirs[1] and np.array_equal(mine[2], theirs[2])


@pytest.mark.parametrize("change, words", [
    (("yield_stress = \"0.30 GPa\"", "yield_stress = \"0.30 GPa\"\n[material.al.fracture]\nlaw = \"spall_stress\"\nstrength = \"1 GPa\""),
     "fracture law"),
    (("velocity = \"700 m/s\"", "velocity = [\"700 m/s\", \"600 m/s\"]"), "velocity profile"),
    (("law = \"perfectly_plastic\"", "law = \"linear_hardening\"\nhardening_modulus = \"1 GPa\""), "no constant yield stress"),
    (("[output]", "[boundary]\nleft = {velocity = {shape = \"ramp\", amplitude = 10, duration = 1e-6}}\n[output]"), "fan of its own"),
])
def test_what_is_not_solved_is_refused_with_the_reason(change, words):
    with pytest.raises(DeckError, match=words):
        read_deck_text(DECK.replace(*change))


def test_curved_geometry_and_unknown_options_are_refused_in_the_deck():
    with pytest.raises(DeckError, match="geometry"):
        read_deck_text(DECK.replace("stop_time", "geometry = \"spherical\"\nstop_time", 1))
    with pytest.raises(DeckError, match="fan_steps"):
        read_deck_text(DECK.replace("weakest", "fan_steps"))


def test_waves_left_out_are_counted_and_their_loss_is_reported():
    """Inside one material waves below the tolerance are dropped: the errors of the sums are of its size, and fall with it."""
    lost = []
    for weakest in ("1e-4", "1e-6"):
        solver = solver_of(FLUID.replace("1e-5", weakest))
        solver.march(2.0e-6, 10**9)
        assert solver.line.cuts and solver.results()["waves_left_out"] > 0 and "cut into slices" in solver.warnings()[0]
        lost.append(solver.errors()["energy_error"])
    assert lost[1] < 0.1 * lost[0] < 1e-4


def test_too_many_fronts_stop_the_run_and_say_so():
    solver = solver_of(FLUID.replace("weakest = 1e-5", "weakest = 0.0\nmost_fronts = 30"))
    from hugoniot.errors import UnphysicalState

    with pytest.raises(UnphysicalState, match="fronts, more than 30"):
        solver.march(3e-6, 10**9)


@pytest.mark.parametrize("start, stress", [("-2 us", 0.0), ("-0.5 us", 5e9)])
def test_of_a_square_pulse_only_what_lies_after_the_start_acts(start, stress):
    """1 us long: one that began 2 us before t = 0 is over then, one that began half a microsecond before it still acts until 0.5 us."""
    text = FLUID + f'[boundary]\nleft = {{pressure = {{shape = "square", amplitude = "5 GPa", duration = "1 us", start = "{start}"}}}}\n'
    solver = solver_of(text.replace("700 m/s", "0 m/s"))
    for until, pressed in ((0.2e-6, stress), (0.7e-6, 0.0)):
        solver.march(until, 10**9)
        assert solver.line.pieces[1].edge(-1).sigma == pytest.approx(pressed, abs=1.0)


PRESSED = """
stop_time = "0.5 us"
[[region]]
name = "a"
material = "{a}"
from = "-5 mm"
to = "0 mm"
zones = 5
{pressed_a}
[[region]]
name = "b"
material = "{b}"
from = "0 mm"
to = "5 mm"
zones = 5
{pressed_b}
[material.al.eos]
law = "mie_gruneisen"
rho0 = "2700 kg/m^3"
c0 = "5300 m/s"
s = 1.34
gamma0 = 2.0
[material.cu.eos]
law = "mie_gruneisen"
rho0 = "8930 kg/m^3"
c0 = "3940 m/s"
s = 1.489
gamma0 = 1.99
[[gauge]]
name = "g"
at = "a/b"
[solver]
kind = "fronts"
"""


def test_gauges_at_the_start_are_those_of_the_mirrored_problem(tmp_path):
    """Aluminium at 5 GPa on copper: at t = 0 nothing moves yet, on both sides of the interface, and free surfaces have no stress."""
    pressed, rows = 'pressure = "5 GPa"', {}
    for way, text in ((1, PRESSED.format(a="al", b="cu", pressed_a=pressed, pressed_b="")),
                      (-1, PRESSED.format(a="cu", b="al", pressed_a="", pressed_b=pressed))):
        path = tmp_path / f"{way}.toml"
        path.write_text(text)
        run = hugoniot.run(path, tmp_path / f"{way}.run", report=False)
        rows[way] = {row["gauge"]: row for row in gauge_rows(run)}
        assert set(rows[way]) == {"g", "free surface left", "free surface right"}          # both sides of a closed interface have one velocity
        assert run.gauges["velocity"].values[0] == pytest.approx(0.0, abs=1e-12)
        assert run.gauges["stress"].sel(gauge=["free surface left", "free surface right"]).values == pytest.approx(0.0, abs=1.0)
    for one, other in (("g", "g"), ("free surface left", "free surface right")):
        assert rows[1][one]["last_velocity"] == pytest.approx(-rows[-1][other]["last_velocity"], rel=1e-9)
        assert rows[1][one]["arrival"] == pytest.approx(rows[-1][other]["arrival"], rel=1e-9)


def test_an_entropy_that_no_material_has_is_refused_before_the_run():
    """Mie-Grüneisen has an entropy with a specific heat only; the deck passed the check, and the run stopped at its first snapshot."""
    asked = FLUID.replace("[output]\n", '[output]\nfields = ["entropy"]\n')
    with pytest.raises(DeckError, match="has an entropy"):
        read_deck_text(asked)
