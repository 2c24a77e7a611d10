"""What keeps single questions quick: a compiled curve, and a match that loads no compiler."""

import subprocess
import sys
import time

import numpy as np
import pytest

import hugoniot.laws.eos  # noqa: F401  (enrols the laws)
from hugoniot.laws.eos.contract import EOS
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.theory.hugoniot import curve

COPPER = MieGruneisen(8930.0, 3940.0, 1.489, 1.99, 390.0)


def test_a_thousand_points_in_under_ten_milliseconds_warm():
    curve(COPPER, points=1000, up_to=3000.0)
    walls = []
    for _ in range(5):
        start = time.perf_counter()
        states = curve(COPPER, points=1000, up_to=3000.0)
        walls.append(time.perf_counter() - start)
    assert min(walls) < 0.010
    assert np.isfinite(states.pressure).all() and len(states) == 1000


@pytest.mark.slow
@pytest.mark.parametrize("name", [law.name for law in EOS if "reacted" not in law.flags])
def test_a_thousand_points_of_every_law(name):
    par = EOS.get(name).example
    curve(par, points=1000)
    walls = []
    for _ in range(30):
        start = time.perf_counter()
        curve(par, points=1000)
        walls.append(time.perf_counter() - start)
    assert min(walls) < 0.010


def test_match_loads_neither_compiler_nor_scipy():
    code = ("import sys, time; start = time.perf_counter()\n"
            "from hugoniot.cli.main import build_app\n"
            "from typer.testing import CliRunner\n"
            "result = CliRunner().invoke(build_app('eos'), ['eos', 'match', 'copper', 'aluminum', '--velocity', '1 km/s'])\n"
            "assert result.exit_code == 0, result.output\n"
            "heavy = [m for m in ('numba', 'scipy', 'matplotlib', 'h5py', 'xarray', 'pint') if m in sys.modules]\n"
            "print(heavy)\n")
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60, check=True)
    assert done.stdout.strip() == "[]"
