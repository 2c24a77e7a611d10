"""The examples with explosives show the numbers their comments promise."""

from pathlib import Path

import numpy as np
import pytest

from hugoniot import simulate
from hugoniot.diagnostics.detonation import front_path, front_speed, run_to_detonation

EXAMPLES = Path(__file__).parents[2] / "examples"


def ran(name, folder):
    return simulate.run(EXAMPLES / f"{name}.toml", folder / f"{name}.run", report=False)


def test_detonation(tmp_path):
    run = ran("detonation", tmp_path)
    time, pressure = run.gauge("pressure", "3 cm")
    assert time[np.argmax(pressure > 1e9)] == pytest.approx(3.76e-6, rel=5e-3)
    assert pressure[time < 5e-6].max() == pytest.approx(29.5e9 * 0.97, rel=0.02)
    snapshots = run.arrays("snapshots")
    path = front_path(snapshots["burn_fraction"], snapshots["position_left"], snapshots["position_right"])
    assert front_speed(snapshots["time"], path, 0.005, 0.039) == pytest.approx(7980.0, rel=3e-3)


def test_pentolite(tmp_path):
    run = ran("pentolite", tmp_path)
    assert run.gauge("position", "cavity")[1][-1] == pytest.approx(0.0268, abs=8e-4)
    assert float(run.budget["released_heat"][-1]) == pytest.approx(13.43e3, rel=2e-3)


def test_initiation(tmp_path):
    run = ran("initiation", tmp_path)
    snapshots = run.arrays("snapshots")
    path = front_path(snapshots["pressure"], snapshots["position_left"], snapshots["position_right"], 5e9)
    path = np.where(path < 0.019, path, np.nan)
    assert front_speed(snapshots["time"], path, 0.01) == pytest.approx(7680.0, rel=0.01)
    assert run_to_detonation(snapshots["time"], path, 7680.0)[0] == pytest.approx(2.3e-3, rel=0.05)
    assert "warning" not in list(run.arrays("events")["kind"])
