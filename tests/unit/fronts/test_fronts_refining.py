"""Cells that burn faster than they resolve: halved and joined without loss, said in the log, resumed to the same bits, switched off."""

import json

import numpy as np
import pytest

import hugoniot
from hugoniot.errors import DeckError
from hugoniot.output.codec import decode, encode
from hugoniot.problem.deck import read_deck_text
from hugoniot.report import sections
from hugoniot.report.page import key_numbers
from hugoniot.simulate import make_solver
from hugoniot.solvers.fronts.cells import refining

DECK = """
title = "Shock into an explosive"
stop_time = "0.3 us"
[[region]]
name = "charge"
material = "lx17"
from = "0 mm"
to = "4 mm"
zones = 20
[material.lx17]
base = "LX-17 reactive"
[boundary]
left = {velocity = "1800 m/s"}
[solver]
kind = "fronts"
[solver.options]
mode = "cells"
"""


def solver_of(text=DECK):
    return make_solver(read_deck_text(text).problem)


@pytest.fixture(scope="module")
def whole():
    solver = solver_of()
    solver.lines = solver.march(3e-7, 10**9)
    return solver


def test_cells_that_burn_fast_are_halved_and_the_log_says_where(whole):
    assert whole.refining.halved > 10 and whole.refining.joined > 0 and whole.mesh.level.max() > 0
    lines = [event for event in whole.lines if event.kind == "refined"]
    assert len(lines) == max(whole.refining.deepest) > 2       # one for every size
    assert all("'charge'" in event.text and "burn_step = 0.15" in event.text and 0.0 < event.position < 4e-3 for event in lines)
    assert whole.results()["cells_halved"] == whole.refining.halved
    halved = whole.mesh.level > 0
    assert whole.mesh.width[halved].max() < whole.mesh.width[~halved].min()
    steps = np.abs(np.diff(whole.mesh.level))[~whole.mesh.marked[1:-1]]
    assert steps.max() == 1      # no cell is beside one halved twice more


def test_halving_and_joining_lose_nothing(monkeypatch):
    """Mass, momentum, energy, burned mass and the reference state of the reactants, each against its own size."""
    changed, plain = [], refining.Refining.after_step

    def watched(self, mesh, time):
        before, count = mesh.q.copy(), len(mesh.q)
        plain(self, mesh, time)
        lost = np.abs(mesh.q.sum(axis=0) - before.sum(axis=0)) / np.abs(before).sum(axis=0)
        changed.append((len(mesh.q) - count, lost.max()))
        assert (mesh.q[:, 0] > 0.0).all() and (mesh.q[:, 3] >= 0.0).all() and (mesh.q[:, 3] <= mesh.q[:, 0]).all()

    monkeypatch.setattr(refining.Refining, "after_step", watched)
    solver = solver_of()
    solver.march(3e-7, 10**9)
    counts, lost = np.array(changed).T
    assert counts.max() > 0 and counts.min() < 0 and lost.max() < 1e-15
    assert max(solver.errors().values()) < 1e-12


def test_a_run_broken_off_while_cells_are_halved_goes_on_with_the_same_bits(whole):
    broken, stops = solver_of(), 0
    while broken.time < 3e-7:
        before = broken.refining.halved + broken.refining.joined
        broken.march(3e-7, 7)
        if broken.refining.halved + broken.refining.joined > before and broken.time < 3e-7:
            again = solver_of()
            again.restore(decode(encode(broken.payload())))
            broken, stops = again, stops + 1
    assert stops > 5 and broken.cycle == whole.cycle
    for name in ("x", "q", "level"):
        assert np.array_equal(getattr(broken.mesh, name), getattr(whole.mesh, name)), name
    assert broken.results() == whole.results()


def test_it_can_be_switched_off():
    solver = solver_of(DECK + "burn_step = 0\n")
    events = solver.march(3e-7, 10**9)
    assert solver.refining.halved == 0 and not solver.mesh.level.any() and "cells_halved" not in solver.results()
    assert not [event for event in events if event.kind == "refined"]


def test_halving_has_a_bound_and_a_warning_says_when_it_is_reached(whole):
    assert whole.warnings() == []
    solver = solver_of(DECK + "burn_step = 0.02\n")
    solver.march(2.5e-7, 10**9)
    assert solver.mesh.level.max() == refining.DEEPEST
    assert [text for text in solver.warnings() if text.startswith("burning was not resolved")]


def test_the_option_is_checked_and_kept_in_the_resolved_deck():
    deck = read_deck_text(DECK + "burn_step = 0.1\n")
    assert deck.problem.solver.options["burn_step"] == 0.1 and read_deck_text(deck.resolved).problem == deck.problem
    assert read_deck_text(DECK).problem.solver.options["burn_step"] == 0.15
    for wrong in ("-0.1", "1.5", '"off"'):
        with pytest.raises(DeckError, match="burn_step"):
            read_deck_text(DECK + f"burn_step = {wrong}\n")


def test_the_run_folder_tells_of_it(tmp_path):
    path = tmp_path / "burning.toml"
    path.write_text(DECK)
    run = hugoniot.run(path, tmp_path / "burning.run", report=False)
    summary = json.loads((run.folder / "summary.json").read_text())
    assert summary["cells_halved"] > 10 and summary["finest_halving"] > 2
    assert "are halved to 1/2" in sections.events(run)
    assert dict(key_numbers(run))["cells halved where they burn fast"].startswith(f"{summary['cells_halved']:.0f}<small>to 1/")
