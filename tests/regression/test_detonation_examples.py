"""The examples with explosives show the numbers their comments promise."""

from pathlib import Path

import numpy as np
import pytest

from hugoniot import simulate
from hugoniot.diagnostics.detonation import body_history, front_path, front_speed, run_to_detonation
from hugoniot.errors import OutOfRange
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.materials import library
from hugoniot.theory.chapman_jouguet import cj, overdriven
from hugoniot.theory.exact.plate_push import gurney
from hugoniot.theory.hugoniot import shock

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
    assert run_to_detonation(snapshots["time"], path, 7680.0)[0] == pytest.approx(2.24e-3, rel=0.02)
    assert "warning" not in list(run.arrays("events")["kind"])


def test_gurney(tmp_path):
    """The open sandwich: Gurney's velocity at sevenfold expansion, and all momentum of the plate in the gas."""
    run = ran("gurney", tmp_path)
    budget, snapshots = run.arrays("budget"), run.arrays("snapshots")
    plate, gas = (body_history(budget, snapshots, name) for name in ("plate", "charge"))
    far = snapshots["time"][np.argmax(snapshots["position_left"][:, 200] > 0.14)]
    velocity = float(np.interp(far, plate["time"], plate["velocity"]))
    assert velocity == pytest.approx(gurney("open", 1.0, 2735.0), rel=0.05)
    assert velocity == pytest.approx(1531.0, rel=1e-3) and far == pytest.approx(85e-6, abs=1e-6)
    assert plate["mass"] == pytest.approx(gas["mass"], rel=1e-4)
    assert plate["momentum"] + gas["momentum"] == pytest.approx(0.0, abs=1e-9 * plate["momentum"][-1])
    assert 1.0 <= plate["energy_velocity"][-1] / plate["velocity"][-1] < 1.003     # a plate that rings has more
    with pytest.raises(OutOfRange, match="charge, plate"):
        body_history(budget, snapshots, "wall")


def test_overdriven(tmp_path):
    """Front, pressure and velocity where the Hugoniots of products and copper cross, above the CJ state."""
    run = ran("overdriven", tmp_path)
    products, copper = library.find("comp_b").eos, MieGruneisen(8930.0, 3940.0, 1.489, 1.99)
    state = overdriven(products, particle_velocity=3467.49)
    assert float(state.pressure) == pytest.approx(float(shock(copper, particle_velocity=4500.0 - 3467.49).pressure), rel=1e-5)
    assert float(state.pressure) > 1.7 * float(cj(products).state.pressure)
    snapshots = run.arrays("snapshots")
    path = front_path(snapshots["burn_fraction"], snapshots["position_left"], snapshots["position_right"])
    assert front_speed(snapshots["time"], path, 0.005, 0.038) == pytest.approx(float(state.shock_velocity), rel=3e-3)
    time, pressure = run.gauge("pressure", "1 cm")
    after = (time > time[np.argmax(pressure > 1e10)] + 1e-7) & (time < time[np.argmax(pressure > 1e10)] + 5e-7)
    assert pressure[after].mean() == pytest.approx(float(state.pressure), rel=5e-3)
    assert run.gauge("velocity", "1 cm")[1][after].mean() == pytest.approx(3467.49, rel=5e-3)
    assert run.gauge("density", "1 cm")[1][after].mean() == pytest.approx(float(state.density), rel=5e-3)
