"""What keeps single questions quick: a compiled curve, and a match that loads no compiler."""

import subprocess
import sys

import numpy as np
import pytest
from pace import PATIENCE, in_loops
from typer.testing import CliRunner

import hugoniot.laws.eos  # noqa: F401  (enrols the laws)
from hugoniot import theory
from hugoniot.cli.main import build_app
from hugoniot.laws.eos.contract import EOS
from hugoniot.laws.eos.jwl import JWL
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.theory.hugoniot import curve, shock
from hugoniot.theory.mixture import mixture, solve

COPPER = MieGruneisen(8930.0, 3940.0, 1.489, 1.99, 390.0)


def test_a_thousand_points_of_a_curve_are_compiled():
    """A twentieth of the plain loop of 200 000 turns; point by point in the interpreter it would be twenty of them."""
    states = curve(COPPER, points=1000, up_to=3000.0)
    assert np.isfinite(states.pressure).all() and len(states) == 1000
    assert in_loops(lambda: curve(COPPER, points=1000, up_to=3000.0)) < 0.5


@pytest.mark.slow
@pytest.mark.parametrize("name", [law.name for law in EOS if "reacted" not in law.flags])
def test_a_thousand_points_of_every_law(name):
    par = EOS.get(name).example
    curve(par, points=1000)
    assert in_loops(lambda: curve(par, points=1000), 30) < 1.0


UNREACTED = JWL(7.781e13, -5.031e9, 11.3, 1.13, 0.8938, 1895.0, 0.0, 2.487e6 / 1895.0)
SOLID = MieGruneisen(1895.0, 2900.0, 1.68, 1.1, 1100.0)     # its isentropes are integrals


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["thermal_isolation", "thermal_equilibrium", "weighted_pressures"])
@pytest.mark.parametrize("reactants", [UNREACTED, SOLID], ids=["jwl", "mie_gruneisen"])
def test_cold_mixtures_are_compiled(kind, reactants):
    """States and slopes, each from the shocked reactant alone: 20 000 of them in the time of the loop, two million a second."""
    products = JWL(1.36177e12, 7.199e10, 6.2, 2.2, 0.5, 1895.0, 6.9e9, 1.0e6 / 1895.0)
    par = mixture(kind, reactants, products, None if reactants is UNREACTED else 4.0e6)
    ahead = shock(reactants, pressure=30e9)
    q, count, rng = par.detonation_energy, 20_000, np.random.default_rng(3)
    burnt, rho = rng.uniform(0.05, 0.95, count), ahead.density * rng.uniform(0.9, 1.0, count)
    e = ahead.specific_internal_energy + q * rng.uniform(0.95, 1.05, count)
    assert in_loops(lambda: solve(rho, e, burnt, par, (ahead.density, ahead.specific_internal_energy + q)), 40) < 1.0


@pytest.mark.parametrize("words", [["copper"], ["copper", "--points", "2000"], ["pbx_9404", "--reaction", "--points", "2000"]])
def test_the_curves_of_a_command_need_no_compiler(words, monkeypatch):
    """Each is asked once; compiling takes as long as a hundred thousand states in Python."""
    monkeypatch.setitem(sys.modules, "hugoniot.theory.kernels", None)
    monkeypatch.delattr(theory, "kernels", raising=False)
    result = CliRunner().invoke(build_app("eos"), ["eos", "hugoniot", *words])
    assert result.exit_code == 0, result.output


def test_match_loads_neither_compiler_nor_scipy():
    code = ("import sys, time; start = time.perf_counter()\n"
            "from hugoniot.cli.main import build_app\n"
            "from typer.testing import CliRunner\n"
            "result = CliRunner().invoke(build_app('eos'), ['eos', 'match', 'copper', 'aluminum', '--velocity', '1 km/s'])\n"
            "assert result.exit_code == 0, result.output\n"
            "heavy = [m for m in ('numba', 'scipy', 'matplotlib', 'h5py', 'xarray', 'pint') if m in sys.modules]\n"
            "print(heavy)\n")
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=PATIENCE, check=True)
    assert done.stdout.strip() == "[]"
