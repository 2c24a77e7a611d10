"""A run in two dimensions that is killed goes on from its checkpoint and ends in the same bytes."""

import random
import signal
import subprocess
import sys

import pytest

from hugoniot import simulate

DECK = """\
title = "Two plates"
geometry = "axisymmetric"
stop_time = "1.2 us"

[[block]]
name = "flyer"
material = "al"
r = ["0 mm", "3 mm"]
z = ["0 mm", "1 mm"]
zones = [6, 4]
velocity = [0, "700 m/s"]

[[block]]
name = "target"
material = "al"
r = ["0 mm", "3 mm"]
z = ["1 mm", "3 mm"]
zones = [6, 8]

[material.al.eos]
law = "mie_gruneisen"
rho0 = "2700 kg/m^3"
c0 = "5200 m/s"
s = 1.5
gamma0 = 2.0
[material.al.strength]
law = "perfectly_plastic"
shear_modulus = "24.8 GPa"
yield_stress = "0.30 GPa"

[[gauge]]
name = "inside"
at = ["1 mm", "2 mm"]

[solver]
kind = "lagrange2d"

[output]
snapshots = "0.1 us"
checkpoint_cycles = 5
report = false
"""
# the flyer tied to nothing, across another mesh, sliding with friction
SLIDING = DECK.replace("zones = [6, 4]", "zones = [4, 4]").replace('[0, "700 m/s"]', '["10 m/s", "700 m/s"]').replace(
    'geometry = "axisymmetric"', 'geometry = "plane"').replace("r = ", "x = ").replace("z = ", "y = ") + """
[[contact]]
between = ["flyer", "target"]
friction = 0.2
"""
CHILD = """
import os, signal, sys
from hugoniot import simulate
from hugoniot.solvers.lagrange2d.solver import Lagrange2D
whole = Lagrange2D.march
def march(self, until, cycles):
    if self.cycle >= int(sys.argv[2]):
        os.kill(os.getpid(), signal.SIGKILL)
    return whole(self, until, min(cycles, 3))
Lagrange2D.march = march
simulate.run(sys.argv[1], sys.argv[3])
"""


def same_bytes(a, b):
    return all((a / name).read_bytes() == (b / name).read_bytes() for name in ("result.h5", "gauges.csv", "deck.toml"))


@pytest.mark.skipif(sys.platform == "win32", reason="kill -9 is a Unix matter")
@pytest.mark.parametrize("text, moments", [(DECK, 2), pytest.param(DECK, 30, marks=pytest.mark.slow),
                                           pytest.param(SLIDING, 6, marks=pytest.mark.slow)])
def test_a_killed_run_ends_in_the_same_bytes(tmp_path, text, moments):
    deck = tmp_path / "plates.toml"
    deck.write_text(text)
    whole = simulate.run(deck, tmp_path / "whole", report=False)
    chance = random.Random(20)
    for k in range(moments):
        folder = tmp_path / f"killed {k}"
        child = subprocess.run([sys.executable, "-c", CHILD, str(deck), str(chance.randrange(1, whole.summary["cycles"])), str(folder)],
                               timeout=300, capture_output=True)
        assert child.returncode == -signal.SIGKILL, child.stderr.decode()
        again = simulate.resume(folder, report=False)
        assert again.summary["cycles"] == whole.summary["cycles"]
        assert same_bytes(tmp_path / "whole", folder)
