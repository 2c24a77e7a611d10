"""The two-dimensional examples run, keep their energy, and show what their comments promise as far as a coarse mesh can."""

from pathlib import Path

import numpy as np
import pytest

from hugoniot import simulate
from hugoniot.problem.deck import read_deck

pytest.importorskip("hugoniot.solvers.lagrange2d.solver")
EXAMPLES = Path(__file__).parents[2] / "examples"

# zones of a quick run, by block; and a stop time where the whole run takes long
COARSE: dict[str, dict] = {
    "taylor-copper": {"block.bar.zones": [3, 30]},
    "noh-plane": {"block.gas.zones": [20, 20]},
    "taylor": {"block.bar.zones": [3, 30]},
    "saltzman": {"stop_time": "0.2 s"},
    "sedov-plane": {"stop_time": "0.2 s"},
    "shell-implosion": {"block.shell.zones": [4, 8], "stop_time": "60 us"},
    "wall-impact": {"block.cylinder.zones": [8, 16], "stop_time": "2 us"},
    "flyer-disc": {"block.target.zones": [20, 24], "block.flyer.zones": [20, 12], "stop_time": "1.2 us"},
    "cylinder-test": {},
    "kb2": {"block.base.zones": [12, 4], "block.cover.zones": [12, 4]},
    "gap-disc": {"block.target.zones": [20, 20], "block.flyer.zones": [25, 10], "stop_time": "2.4 us"},
    "rod": {"block.target.zones": [6, 32], "block.around.zones": [8, 32], "block.rod.zones": [2, 24], "stop_time": "10 us"},
}
QUICK = ("noh-plane", "kb2")


@pytest.fixture(scope="module")
def ran(tmp_path_factory):
    """Function from an example's name to its coarse run, each run once."""
    done = {}

    def run(name):
        if name not in done:
            deck = read_deck(EXAMPLES / f"{name}.toml", COARSE[name])
            done[name] = simulate.run(deck, tmp_path_factory.mktemp("plane") / f"{name}.run", report=False)
        return done[name]

    return run


def test_every_example_of_two_dimensions_is_run():
    plane = {path.stem for path in EXAMPLES.glob("*.toml") if 'kind = "lagrange2d"' in path.read_text()}
    assert plane == set(COARSE)


@pytest.mark.parametrize("name", [name if name in QUICK else pytest.param(name, marks=pytest.mark.slow) for name in COARSE])
def test_an_example_runs_and_keeps_its_energy(name, ran):
    summary = ran(name).summary
    assert summary["status"] == "done"
    assert abs(summary["mass_error"]) < 1e-12 and abs(summary["energy_error"]) < 1e-12


def test_pressure_on_a_curved_surface_pushes_with_the_width_of_the_body(ran):
    """100 N s down, to round-off, on zones of three nodes; both triangles of a cell at one pressure."""
    run = ran("kb2")
    rows, budget = run.arrays("snapshots"), run.arrays("budget")
    corners = run.arrays("mesh")["zone_nodes"]
    assert corners.shape == (2 * (12 * 4 + 12 * 4), 3)
    assert budget["impulse_y cover.top"][-1] == pytest.approx(-100.0, rel=1e-12)
    assert budget["momentum_y_error"][-1] < 1e-12
    mass = run.arrays("peaks")["mass"]
    speed = np.sum(mass * rows["velocity_y"][-1][corners].mean(axis=1)) / mass.sum()
    assert speed == pytest.approx(-100.0 / mass.sum(), rel=1e-3)
    assert mass.sum() == pytest.approx(1.89, rel=0.01)
    lower, upper = rows["pressure"][-1][: 2 * 12 * 4].reshape(12, 2, 4).transpose(1, 0, 2)
    assert np.array_equal(lower, upper)


def test_noh_is_round(ran):
    """Behind the shock 16, the shock near 0.2 m, the same along the diagonal as along the sides."""
    run = ran("noh-plane")
    rows, mesh = run.arrays("snapshots"), run.arrays("mesh")
    x, y = (rows[name][-1][mesh["zone_nodes"]].mean(axis=1) for name in ("position_x", "position_y"))
    r, angle, rho = np.hypot(x, y), np.arctan2(y, x), rows["density"][-1]
    plateau = (r > 0.08) & (r < 0.14)
    assert rho[plateau].mean() == pytest.approx(16.0, rel=0.15)
    for sector in range(3):
        mine = (angle >= sector * np.pi / 6) & (angle <= (sector + 1) * np.pi / 6) & (rho > 8.0)
        assert r[mine].max() == pytest.approx(0.2, abs=0.03)


@pytest.mark.slow
def test_the_copper_bar_has_its_length(ran):
    rows = ran("taylor-copper").arrays("snapshots")
    assert rows["position_y"][-1].max() == pytest.approx(21.54e-3, abs=0.4e-3)
    assert rows["position_x"][-1].max() == pytest.approx(7.1e-3, rel=0.1)


@pytest.mark.slow
def test_the_axis_at_the_wall_has_the_one_dimensional_state_first(ran):
    """A symmetric impact at twice the speed: 16.82 GPa for this series (H-1), without strength."""
    time, pressure = ran("wall-impact").gauge("pressure", "axis at the wall")
    inside = (time > 0.6e-6) & (time < 1.0e-6)
    assert pressure[inside].mean() == pytest.approx(16.82e9, rel=0.03)


@pytest.mark.slow
def test_the_wall_of_the_cylinder_test_moves_as_in_the_experiment(ran):
    """Composition B, 25.4 mm: 1.386 and 1.631 mm/us (E = 0.960 and 1.330 kJ/g of copper) by the slit's observable."""
    run = ran("cylinder-test")
    time, place = run.gauge("line_position", "streak at 100 mm")
    for travel, measured in ((6e-3, 1386.0), (18.9e-3, 1631.0)):
        near = np.abs(place - place[0] - travel) < 0.7e-3      # one period of the wall's ringing
        assert np.polyfit(time[near], place[near], 1)[0] == pytest.approx(measured, rel=0.02)


@pytest.mark.slow
def test_the_shell_moves_as_the_rigid_plastic_one_does(ran):
    """Incompressible: r^2 u stays the same over the shell; after 60 us of 150 the inner radius is between start and rest, and round."""
    rows = ran("shell-implosion").arrays("snapshots")
    radius = np.hypot(rows["position_x"][-1], rows["position_y"][-1])
    inner, outer = np.sort(radius)[:9], np.sort(radius)[-9:]
    assert np.ptp(inner) < 0.01 * inner.mean() and 0.040 < inner.mean() < 0.048
    assert outer.mean() ** 3 - inner.mean() ** 3 == pytest.approx(0.1**3 - 0.08**3, rel=0.01)
