"""Killed and resumed runs that carry a history: burn fraction and phases of two integrators, and the crushing of pores."""

import os
import random
import signal
import sys
from types import SimpleNamespace

import pytest
from faults import in_a_copy_of_this_process
from killed_runs import finish, same_bytes

from hugoniot import simulate
from hugoniot.output.run import load

THRESHOLD = """title = "threshold burn in the leapfrog"
geometry = "spherical"
stop_time = "1.6 us"
[[region]]
name = "charge"
material = "kb"
from = "0 mm"
to = "20 mm"
zones = {zones}
[boundary]
right = {pressure = "40 GPa"}
[[gauge]]
name = "middle"
at = "10 mm"
[solver]
integrator = "wilkins"
courant = 0.25
viscosity = { law = "kb_two_sided" }
[material.kb]
detonation_energy = "6.27 MJ/kg"
eos = { law = "ideal_gas", gamma = 3.0, rho0 = "1770 kg/m^3", specific_heat = 1000.0 }
unreacted = { law = "mie_gruneisen", rho0 = "1770 kg/m^3", c0 = "3080 m/s", s = 2.01, gamma0 = 1.0 }
burn = { law = "threshold", initiation_pressure = "20 GPa" }
"""
GROWTH = """title = "ignition and growth"
geometry = "planar"
stop_time = "1 us"
[[region]]
name = "charge"
material = "LX-17 reactive"
from = "0 mm"
to = "8 mm"
zones = {zones}
[boundary]
left = {velocity = "1.6 km/s"}
[[gauge]]
name = "late"
at = "6 mm"
"""
PORES = """title = "crushed powder"
geometry = "planar"
stop_time = "5 us"
[[region]]
name = "plate"
material = "copper"
from = "-3 mm"
to = "0 mm"
zones = 60
velocity = "600 m/s"
[[region]]
name = "powder"
material = "porous"
from = "0 mm"
to = "8 mm"
zones = {zones}
[[gauge]]
name = "middle"
at = "4 mm"
[material.porous.eos]
law = "p_alpha"
alpha0 = 1.4
elastic_pressure = "0.1 GPa"
compaction_pressure = "2 GPa"
[material.porous.eos.base]
law = "mie_gruneisen"
rho0 = "8930 kg/m^3"
c0 = "3940 m/s"
s = 1.489
gamma0 = 1.99
"""
DECKS = {"threshold": (THRESHOLD, 100, "burn_fraction"), "ignition_growth": (GROWTH, 120, "burn_fraction"),
         "p_alpha": (PORES, 100, "compaction")}
ENDING = """[output]
snapshots = "0.2 us"
report = false
checkpoint_cycles = {every}
"""
killing = pytest.mark.skipif(sys.platform == "win32", reason="kill -9 is a Unix matter")


def undisturbed(folder, name, scale, every):
    """(deck, folder of its run that nothing disturbed); the history it carries has moved somewhere, or the test would be of nothing."""
    text, zones, field = DECKS[name]
    path = folder / f"{name}.toml"
    path.write_text(text.replace("{zones}", str(scale * zones)) + ENDING.replace("{every}", str(every)))
    simulate.run(path, folder / f"{name}.whole")
    history = load(folder / f"{name}.whole").arrays("snapshots")[field]
    assert history[-1].max() > history[0].max() or history[-1].min() < history[0].min()
    return path, folder / f"{name}.whole"


@killing
@pytest.mark.parametrize("name", DECKS)
def test_killed_once_a_history_goes_on_to_the_same_bytes(tmp_path, name):
    path, whole = undisturbed(tmp_path, name, 1, 80)
    folder = tmp_path / "killed.run"

    def strike(report):
        if list((folder / "checkpoint").glob("[0-9]*.json")):
            os.kill(os.getpid(), signal.SIGKILL)

    assert os.WIFSIGNALED(in_a_copy_of_this_process(lambda: simulate.run(path, folder, progress=SimpleNamespace(update=strike))))
    assert not (folder / "summary.json").exists()
    simulate.resume(folder)
    same_bytes(whole, folder)


@pytest.mark.slow
@killing
@pytest.mark.parametrize("name", DECKS)
def test_killed_many_times_a_history_goes_on_to_the_same_bytes(tmp_path, name):
    path, whole = undisturbed(tmp_path, name, 2, 11)
    hits, chance, turn = 0, random.Random(2), 0
    while hits < 12:
        hits += finish(path, tmp_path / f"{turn}.run", 6, chance, 0.6)
        same_bytes(whole, tmp_path / f"{turn}.run")
        turn += 1
        assert turn < 12, "the runs end before they are killed"
