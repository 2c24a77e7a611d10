"""Cases in memory: they march through the times of snapshots without coming back, and have the very numbers of `hugoniot run`."""

import pathlib

import numpy as np
import pytest
from aluminium_decks import EOS, FRACTURE, gauge, impact, region

import hugoniot
from hugoniot.campaign.memory_run import MemoryRun
from hugoniot.campaign.numbers import numbers_of
from hugoniot.output.spall_records import spalled_regions
from hugoniot.problem.deck import read_deck
from hugoniot.simulate import make_solver
from hugoniot.solvers.run import snapshot_times

EXAMPLES = pathlib.Path(__file__).parents[3] / "examples"
COARSE = {"region.flyer.zones": 24, "region.target.zones": 48}
WILKINS = {"solver.integrator": "wilkins"}
BONDED = f"""title = "An interface that breaks as the material does"
geometry = "planar"
stop_time = "2 us"
{impact(20, 23, end="4.3 mm")}{region("back", "4.3 mm", "6 mm", 17)}\
[[interface]]
between = ["target", "back"]
kind = "bonded"
{EOS}{FRACTURE}{gauge("free surface", "free surface right")}"""


def same(one, other):
    return one.keys() == other.keys() and all(one[key] == other[key] or one[key] != one[key] and other[key] != other[key] for key in one)


def test_a_pulse_that_decays_has_a_peak_and_no_plateau():
    found = numbers_of(MemoryRun(read_deck(EXAMPLES / "pulse.toml", overrides={"region.plate.zones": 150}).problem))
    assert found["3 mm.peak_stress"] > found["12 mm.peak_stress"] > 1e9      # the peak stood for the plateau
    assert all(np.isnan(found[f"{gauge}.plateau_{field}"]) for gauge in ("3 mm", "12 mm") for field in ("stress", "velocity"))


@pytest.mark.parametrize("name, changes", [
    ("flyer", COARSE), ("flyer", {**COARSE, **WILKINS}), ("flyer", {**COARSE, "output.fields": ["pressure"]}), ("gap", {}), ("shell", {}),
    ("precursor", {}), ("overdriven", {})])
def test_a_case_has_the_very_numbers_of_a_run(tmp_path, name, changes):
    path = EXAMPLES / f"{name}.toml"
    found = numbers_of(MemoryRun(read_deck(path, overrides=changes).problem))
    assert same(found, numbers_of(hugoniot.run(path, tmp_path / "one.run", report=False, **changes)))


def test_a_void_between_two_regions_is_read_from_the_places_of_snapshots(tmp_path):
    deck = tmp_path / "bonded.toml"
    deck.write_text(BONDED)
    case = MemoryRun(read_deck(deck).problem)
    assert any("between 'target' and 'back'" in text for text in case.arrays("events")["text"])
    run = hugoniot.run(deck, tmp_path / "one.run", report=False)
    assert same(numbers_of(case), numbers_of(run)) and list(spalled_regions(case)) == list(spalled_regions(run)) == ["back"]


@pytest.mark.parametrize("courant", [0.4, 0.5, 0.6, 0.7])
def test_a_void_opens_whatever_the_length_of_a_step(tmp_path, courant):
    """In the step in which a zone reaches its strength voids may grow in it by more than those of an older spall plane: the plane that
    fails first opens at the same place, to half a zone."""
    deck = tmp_path / "bonded.toml"
    deck.write_text(BONDED)
    case = MemoryRun(read_deck(deck, overrides={"solver.courant": courant}).problem)
    places = [float(text.split()[-2]) for text in case.arrays("events")["text"] if text.startswith("void opened")]
    assert len(places) == 1 and abs(places[0] - 4.552e-3) < 5e-5


@pytest.mark.parametrize("changes", [{}, WILKINS])
def test_times_that_are_passed_change_no_bit(changes):
    problem = read_deck(EXAMPLES / "gap.toml", overrides=changes).problem
    times = snapshot_times(problem.stop_time, None, 40)
    stopping, passing = make_solver(problem), make_solver(problem)
    seen = []
    for time in times:
        while stopping.time < time:
            stopping.march(time, 10_000)
            stopping.take_gauges()
        state = stopping.motion()
        speed = max(np.abs(state.velocity_left).max(), np.abs(state.velocity_right).max())
        seen.append((time, speed, np.abs(stopping.state().zones["stress"]).max(), state.velocity_right[-1]))
    assert passing.pass_through(times)
    marches = 0
    while passing.time < problem.stop_time:
        passing.march(problem.stop_time, 10_000)
        passing.take_gauges()
        marches += 1
    assert marches < len(times) / 2 and passing.cycle == stopping.cycle
    assert passing.zones.tobytes() == stopping.zones.tobytes() and passing.nodes.tobytes() == stopping.nodes.tobytes()
    found = passing.seen_in_passing()
    assert np.array_equal(np.column_stack([found[name] for name in ("time", "velocity", "stress", "velocity_right")]), np.array(seen))


def test_a_march_ends_where_it_is_told_to_between_times_that_are_passed():
    problem = read_deck(EXAMPLES / "flyer.toml", overrides=COARSE).problem
    solver = make_solver(problem)
    solver.pass_through([0.0, 1e-7, 3e-7, 5e-7])
    solver.march(2e-7, 100_000)
    assert solver.time == 2e-7 and solver.seen_in_passing()["time"].tolist() == [0.0, 1e-7]
    solver.march(6e-7, 100_000)
    assert solver.time == 6e-7 and len(solver.seen_in_passing()["time"]) == 4
