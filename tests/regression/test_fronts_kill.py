"""Runs of tracked fronts, killed while waves meet and resumed: the same bytes, fronts and all, as a run that nothing disturbed."""

import random
import sys

import pytest
from killed_runs import finish, same_bytes

from hugoniot import simulate

PLATES = """title = "plate on plate"
stop_time = "2.2 us"
[[region]]
name = "flyer"
material = "al"
from = "0 mm"
to = "2 mm"
zones = {zones}
velocity = "700 m/s"
[[region]]
name = "target"
material = "al"
from = "2.1 mm"
to = "6 mm"
zones = {zones}
[material.al.eos]
law = "mie_gruneisen"
rho0 = "2700 kg/m^3"
c0 = "5200 m/s"
s = 1.5
gamma0 = 2.0
[[gauge]]
name = "middle"
at = "4 mm"
[solver]
kind = "fronts"
options = { mode = "{mode}"{more} }
[output]
snapshots = "0.2 us"
report = false
checkpoint_cycles = {every}
"""
# mode: (zones, options, steps or meetings between checkpoints)
RUNS = {"algebraic": (20, ", fan_step = 0.05, weakest = 1e-6", 40), "cells": (60, "", 480)}
killing = pytest.mark.skipif(sys.platform == "win32", reason="kill -9 is a Unix matter")


def undisturbed(folder, mode, scale):
    """(deck, folder of its run that nothing disturbed); waves meet before its first checkpoint, and after it."""
    zones, more, every = RUNS[mode]
    text = PLATES.replace("{mode}", mode).replace("{more}", more).replace("{zones}", str(scale * zones)).replace("{every}", str(every))
    path = folder / f"{mode}.toml"
    path.write_text(text)
    run = simulate.run(path, folder / f"{mode}.whole")
    met = run.arrays("events")["cycle"]
    assert (met < every).any() and (met > every).sum() >= 4
    return path, folder / f"{mode}.whole"


def same_run(whole, killed):
    same_bytes(whole, killed)
    assert (whole / "fronts.csv").read_bytes() == (killed / "fronts.csv").read_bytes()


@killing
@pytest.mark.parametrize("mode", RUNS)
def test_killed_once_while_waves_meet_a_run_goes_on_to_the_same_bytes(tmp_path, mode):
    path, whole = undisturbed(tmp_path, mode, 1)
    assert finish(path, tmp_path / "killed.run", 1, random.Random(3), 0.02) == 1
    same_run(whole, tmp_path / "killed.run")


@pytest.mark.slow
@killing
@pytest.mark.parametrize("mode", RUNS)
def test_killed_many_times_a_run_goes_on_to_the_same_bytes(tmp_path, mode):
    path, whole = undisturbed(tmp_path, mode, 4)
    hits, chance, turn = 0, random.Random(4), 0
    while hits < 8:
        hits += finish(path, tmp_path / f"{turn}.run", 5, chance, 0.4)
        same_run(whole, tmp_path / f"{turn}.run")
        turn += 1
        assert turn < 12, "the runs end before they are killed"
