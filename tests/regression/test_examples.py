"""Every example is the deck `hugoniot init` writes, runs, and shows the numbers its comments promise."""

from importlib.resources import files
from pathlib import Path

import numpy as np
import pytest

from hugoniot import simulate
from hugoniot.problem import catalogue
from hugoniot.problem.deck import read_deck

EXAMPLES = Path(__file__).parents[2] / "examples"
ALL = [entry.name for entry in catalogue.problems()]
NAMES = [name for name in ALL if 'kind = "lagrange2d"' not in (EXAMPLES / f"{name}.toml").read_text()]    # two dimensions: test_plane_examples


@pytest.fixture(scope="module")
def ran(tmp_path_factory):
    """Function from an example's name to its finished run, each run once."""
    done = {}

    def run(name):
        if name not in done:
            done[name] = simulate.run(EXAMPLES / f"{name}.toml", tmp_path_factory.mktemp("examples") / f"{name}.run", report=False)
        return done[name]

    return run


def plateau(run, field, gauge, start, end):
    """Mean of a gauge record between two times (s)."""
    time, values = run.gauge(field, gauge)
    inside = (time >= start) & (time <= end)
    return float(np.mean(values[inside]))


def test_examples_and_templates_are_the_same():
    for name in ALL:
        assert (EXAMPLES / f"{name}.toml").read_text() == (files("hugoniot.problem") / "templates" / f"{name}.toml").read_text()


@pytest.mark.parametrize("name", ALL)
def test_an_example_is_short_commented_and_without_a_warning(name):
    text = (EXAMPLES / f"{name}.toml").read_text()
    assert len(text.splitlines()) < 80
    assert text.startswith("# ") and "Expected" in text
    assert read_deck(EXAMPLES / f"{name}.toml").warnings == ()


@pytest.mark.parametrize("name", NAMES)
def test_an_example_runs_and_keeps_its_energy(name, ran):
    summary = ran(name).summary
    assert summary["status"] == "done"
    for error in ("mass_error", "momentum_error", "energy_error"):
        assert abs(summary[error]) < 1e-12, error


@pytest.mark.parametrize("changes, stress, step", [({}, 16.91e9, 1.00e9), ({"k1": 2.184, "k2": 1.793, "k3": -0.72}, 17.66e9, 1.09e9)])
def test_plates(ran, tmp_path, changes, stress, step):
    """Both readings of Herrmann's aluminium at 2 us: the plateau, and the stress over which the release turns the deviator round."""
    run = ran("plates")
    if changes:
        short = {f"material.aluminium.eos.{k}": v for k, v in changes.items()} | {"stop_time": "2 us", "region.target.to": "16 mm",
                                                                                  "region.target.zones": 160}
        run = simulate.run(read_deck(EXAMPLES / "plates.toml", short), tmp_path / "other.run", report=False)
    else:
        last = run.arrays("snapshots")["stress"][-1]
        assert last.max() == pytest.approx(12.5e9, rel=0.01)
    snapshots = run.arrays("snapshots")
    at = int(np.argmin(abs(snapshots["time"] - 2e-6)))
    found, deviator = snapshots["stress"][at], snapshots["deviator_radial"][at]
    assert found.max() == pytest.approx(stress, rel=2e-3)
    limit = 0.99 * 2.0 / 3.0 * 0.276e9
    released = np.flatnonzero(deviator[:np.argmax(found)] > limit)[-1]
    loaded = released + np.flatnonzero(deviator[released:] < -limit)[0]
    assert found[loaded] - found[released] == pytest.approx(step, rel=0.02)


def test_flyer(ran):
    run = ran("flyer")
    for gauge, start in (("1 mm into target", 0.4e-6), ("2 mm into target", 0.5e-6)):
        assert plateau(run, "stress", gauge, start, start + 0.1e-6) == pytest.approx(5.510e9, rel=3e-3)
    time, velocity = run.gauge("velocity", "free surface")
    assert np.interp(0.655e-6, time, velocity) == pytest.approx(76.0, abs=1.5)
    assert plateau(run, "velocity", "free surface", 0.8e-6, 1.0e-6) == pytest.approx(692.3, rel=2e-3)
    assert velocity[time > 1.1e-6].min() < 0.95 * 692.3, "no pull-back"
    assert run.summary["voids_opened"] >= 1
    assert run.arrays("peaks")["peak_tension"].max() < 1.05e9


def test_gap(ran):
    events = ran("gap").arrays("events")
    closed = [t for t, kind in zip(events["time"], events["kind"]) if kind == "void_closed"]
    assert closed[0] == pytest.approx(1e-6, rel=1e-6)
    assert len(closed) == 2


def test_sandwich(ran):
    run = ran("sandwich")
    assert plateau(run, "stress", "pmma middle", 0.2e-6, 0.35e-6) == pytest.approx(1.989e9, rel=2e-2)
    assert plateau(run, "velocity", "pmma middle", 0.2e-6, 0.35e-6) == pytest.approx(499.8, rel=2e-2)
    time, stress = run.gauge("stress", "pmma middle")
    assert stress[time > 2.8e-6].mean() == pytest.approx(10.79e9, rel=2e-2)


def test_silica_powder(ran):
    run = ran("silica-powder")
    assert plateau(run, "pressure", "in the powder", 2.5e-6, 4e-6) == pytest.approx(20.28e6, rel=1e-2)
    assert plateau(run, "velocity", "in the powder", 2.5e-6, 4e-6) == pytest.approx(398.4, rel=2e-3)
    passed = [time[np.argmax(stress > 10e6)] for time, stress in (run.gauge("stress", name) for name in ("in the powder", "late in the powder"))]
    assert 1e-3 / (passed[1] - passed[0]) == pytest.approx(508.9, rel=1e-2)
    assert run.gauge("stress", "back of powder")[1].max() > 0.6e9


def test_precursor(ran):
    run = ran("precursor")
    between = plateau(run, "stress", "6 mm", 0.945e-6, 0.99e-6)
    assert between == pytest.approx(0.635879e9, rel=1e-2)
    assert plateau(run, "stress", "6 mm", 1.15e-6, 1.4e-6) == pytest.approx(6.635879e9, rel=1e-3)
    assert plateau(run, "velocity", "6 mm", 1.15e-6, 1.4e-6) == pytest.approx(400.0, rel=1e-3)


def test_sod(ran):
    run = ran("sod")
    assert plateau(run, "velocity", "contact", 0.1, 0.2) == pytest.approx(0.92745262, rel=2e-3)
    assert plateau(run, "pressure", "low side", 0.14, 0.2) == pytest.approx(0.30313018, rel=2e-3)


def test_noh(ran):
    rows = ran("noh").arrays("snapshots")
    centre = 0.5 * (rows["position_left"][-1] + rows["position_right"][-1])
    inside = (centre > 0.08) & (centre < 0.15)
    assert rows["density"][-1][inside].mean() == pytest.approx(64.0, rel=0.12)  # KO reaches 52.1 on this grid, G2 61.6


def test_sedov(ran):
    rows = ran("sedov").arrays("snapshots")
    top = int(np.argmax(rows["density"][-1]))
    assert rows["position_right"][-1][top] == pytest.approx(1.0, abs=3e-3)
    assert rows["density"][-1][top] > 5.5


def test_shell(ran):
    run = ran("shell")
    _, radius = run.gauge("position", "inner surface")
    assert radius.min() == pytest.approx(0.05, rel=2e-3)


def test_pulse(ran):
    run = ran("pulse")
    peaks = [run.gauge("stress", name)[1].max() for name in ("3 mm", "12 mm")]
    assert 3e9 > peaks[0] > peaks[1] > 0.5e9
    surface = run.gauge("velocity", "free surface")[1].max()
    inside = run.gauge("velocity", "12 mm")
    arriving = inside[1][inside[0] < 2.4e-6].max()
    assert 1.5 < surface / arriving < 2.0


def test_spall(ran):
    run = ran("spall")
    assert run.summary["voids_opened"] >= 1
    time, velocity = run.gauge("velocity", "free surface")
    peak = int(np.argmax(velocity))
    assert velocity[peak] == pytest.approx(300.0, rel=2e-2)
    assert velocity[peak:].min() < 0.95 * velocity[peak], "no pull-back"
