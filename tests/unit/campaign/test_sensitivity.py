"""Sensitivity through the path of a sweep: Ishigami's function to 0.01, linear functions exactly, bands, failing cases."""

import csv

import matplotlib.pyplot as plt
import numpy as np
import pytest

from hugoniot.campaign.ask import Wishes, run_sweep
from hugoniot.campaign.designs import design_of
from hugoniot.campaign.sensitivity import LEVELS, Index, bands
from hugoniot.campaign.variables import read_variable
from hugoniot.errors import DeckError
from hugoniot.output.sweep_file import Column, SweepTable
from hugoniot.plotting.sensitivity import draw_indices
from hugoniot.plotting.sweep import draw_records

# three keys of the deck stand for the three unknowns of a function
KEYS = ("region.flyer.velocity", "region.flyer.density", "stop_time")
VARY = [f"{KEYS[0]} = 1..2 m/s", f"{KEYS[1]} = 1..2 kg/m^3", f"{KEYS[2]} = 1..2 s"]


def engine(function, fails=lambda x: False):
    """A pool that answers with a function of the three keys, each from 0 to 1, instead of runs."""

    class Pool:
        def __init__(self, question, known):
            pass

        def __enter__(self):
            return self

        def __exit__(self, *_):
            pass

        def run(self, tasks):
            for case, changes in tasks:
                x = np.array([float(changes[key].split()[0]) - 1.0 for key in KEYS])
                if fails(x):
                    yield {"case": case, "reason": "failed"}
                else:
                    yield {"case": case, "key": f"{case:032d}", "numbers": {"y": function(x)}}

    return Pool


def analysis(deck, tmp_path, function, design, samples, fails=lambda x: False, seed=0):
    wishes = Wishes(vary=VARY, design=design, samples=samples, seed=seed)
    return run_sweep(deck, wishes, tmp_path / design, engine=engine(function, fails), report=design == "morris").analysis


def ishigami(x):
    a, b, c = np.pi * (2.0 * x - 1.0)
    return np.sin(a) + 7.0 * np.sin(b) ** 2 + 0.1 * c**4 * np.sin(a)


@pytest.mark.parametrize("base, error", [(1024, 0.05), pytest.param(8192, 0.01, marks=pytest.mark.slow)])
def test_sobol_indices_of_ishigami(deck, tmp_path, base, error):
    found = analysis(deck, tmp_path, ishigami, "saltelli", base).sensitivity["y"]
    # T. Ishigami, T. Homma (1990): a = 7, b = 0.1
    for row, first, total in zip(found, (0.3139, 0.4424, 0.0), (0.5576, 0.4424, 0.2437)):
        assert row.first == pytest.approx(first, abs=error) and row.total == pytest.approx(total, abs=error)
        assert row.first_low <= first + 0.005 and first - 0.005 <= row.first_high
        assert row.total_low <= total + 0.005 and total - 0.005 <= row.total_high
        assert 0.0 < row.first_high - row.first_low < 10.0 / np.sqrt(base)
    rows = list(csv.DictReader((tmp_path / "saltelli" / "sensitivity.csv").open()))
    assert [row["parameter"] for row in rows] == list(KEYS) and float(rows[0]["first"]) == found[0].first


def test_a_large_mean_does_not_spoil_the_indices(deck, tmp_path):
    found = analysis(deck, tmp_path, lambda x: 1e6 + ishigami(x), "saltelli", 256).sensitivity["y"]
    assert [row.first for row in found] == pytest.approx([0.3139, 0.4424, 0.0], abs=0.06)


def test_failed_base_cases_are_left_out_and_counted(deck, tmp_path):
    found = analysis(deck, tmp_path, lambda x: x[0] + 2.0 * x[1], "saltelli", 256, fails=lambda x: x[2] > 0.98).sensitivity["y"]
    assert 0 < found[0].lost < 30
    assert [row.first for row in found] == pytest.approx([0.2, 0.8, 0.0], abs=0.05)


def test_morris_sees_slopes_and_what_is_not_straight(deck, tmp_path):
    found = analysis(deck, tmp_path, lambda x: 3.0 * x[0] - 2.0 * x[1] + (x[2] - 0.5) ** 2, "morris", 30).sensitivity["y"]
    by_name = {row.parameter: row for row in found}
    assert by_name[KEYS[0]].magnitude == pytest.approx(3.0) and by_name[KEYS[0]].deviation == pytest.approx(0.0, abs=1e-12)
    assert by_name[KEYS[1]].mean == pytest.approx(-2.0) and by_name[KEYS[1]].magnitude == pytest.approx(2.0)
    assert by_name[KEYS[2]].deviation > 0.1
    page = (tmp_path / "morris" / "report.html").read_text()
    assert "Sensitivity" in page and "Morris" in page


def test_a_normal_input_counts_as_the_range_of_its_standard_deviation(deck, tmp_path):
    """y = x: the range and the normal distribution of the same standard deviation have the same effect, the width of the range."""
    found = []
    for vary in ("1..2 m/s", f"1.5 +- {1.0 / 12.0**0.5!r} m/s"):
        wishes = Wishes(vary=[f"{KEYS[0]} = {vary}", *VARY[1:]], design="morris", samples=10)
        found.append(run_sweep(deck, wishes, tmp_path / "m", engine=engine(lambda x: x[0]), report=False).analysis.sensitivity["y"][0])
    assert [row.magnitude for row in found] == pytest.approx([1.0, 1.0], rel=1e-9)


def test_bands_are_those_of_the_cases_that_succeed():
    """A case without a record, and one that ends half way: no band where the cases are not all there."""
    values = np.tile(np.linspace(0.0, 1.0, 12)[:, None], (1, 4))
    values[3], values[5, 2:] = np.nan, np.nan
    record, times = Column("g.velocity", "m/s", values), np.arange(4.0)
    table = SweepTable((), (), ("",) * 12, records=(record,), times=times, attributes={"design": "lhs"})
    band = bands(table, 12)["g.velocity"]
    rest = np.delete(np.linspace(0.0, 1.0, 12), 3)
    assert band[2, :2] == pytest.approx([np.median(rest)] * 2) and np.isnan(band[:, 2:]).all()
    _, ax = plt.subplots()
    draw_records(ax, table, record)
    assert ax.get_title(loc="left") == "g, 11 cases" and ax.lines[0].get_ydata() == pytest.approx(band[2, :2])
    plt.close("all")


def test_the_names_of_results_and_of_indices_do_not_cover_each_other():
    rows = [Index("spall.spall_strength_acoustic", name, 0.5, 0.4, 0.6, 0.6, 0.5, 0.7, 0) for name in ("a", "b")]
    figure, ax = plt.subplots(figsize=(4.8, 2.9), layout="constrained")
    draw_indices(ax, rows)
    figure.canvas.draw()
    legend = ax.get_legend().get_window_extent()
    assert not any(legend.overlaps(text.get_window_extent()) for text in (ax._left_title, ax.xaxis.label))
    plt.close("all")


def test_paths_of_morris_change_one_parameter_at_a_time():
    design = design_of([read_variable(text) for text in VARY], "morris", 20, seed=4)
    paths = design.shares.reshape(20, 4, 3)
    steps = np.diff(paths, axis=1)
    assert np.all((np.abs(steps) > 0).sum(axis=2) == 1) and np.all((np.abs(steps) > 0).sum(axis=1) == 1)
    assert np.allclose(np.abs(steps).max(axis=2), LEVELS / (2.0 * (LEVELS - 1)))
    assert paths.min() >= 0.0 and paths.max() <= 1.0


def test_the_spread_of_a_sum_of_normals(deck, tmp_path):
    wishes = Wishes(vary=[f"{KEYS[0]} = 1.5 +- 0.03 m/s", f"{KEYS[1]} = 1.5 +- 0.04 kg/m^3", VARY[2]], design="sobol", samples=1024)
    swept = run_sweep(deck, wishes, tmp_path / "s", engine=engine(lambda x: x[0] + x[1]), report=False)
    spread = swept.analysis.spread["y"]
    assert spread.mean == pytest.approx(1.0, abs=1e-3) and spread.deviation == pytest.approx(0.05, rel=0.01)
    assert spread.quantiles[4] - spread.quantiles[0] == pytest.approx(2 * 1.96 * 0.05, rel=0.03)
    assert (tmp_path / "s" / "spread.csv").read_text().startswith("result,unit,mean,standard deviation")


def test_bands_of_records_of_a_real_sweep(deck, tmp_path, inline):
    wishes = Wishes(vary=["region.flyer.velocity = 700 +- 10 m/s"], design="lhs", samples=12, record=["free surface.velocity"])
    swept = run_sweep(deck, wishes, tmp_path / "s", engine=inline)
    band = swept.analysis.bands["free surface.velocity"]
    late = swept.table.times > 0.9e-6
    assert np.all(np.diff(band, axis=0) >= 0.0)
    assert np.mean(band[3] - band[1], where=late) > 5.0 and np.all(band[:, :20] == pytest.approx(0.0, abs=1e-3))
    heads = (tmp_path / "s" / "bands.csv").read_text().splitlines()[0]
    assert heads.startswith("time [s],free surface.velocity 0.025 quantile [m/s]")
    grid = run_sweep(deck, Wishes(vary=["region.flyer.velocity = 700, 701 m/s"]), tmp_path / "s", engine=inline, report=False)
    assert grid.analysis is None and not (tmp_path / "s" / "bands.csv").exists()      # nothing is left of another sweep's analysis


def test_too_many_cases_are_counted_with_the_base(deck, tmp_path):
    with pytest.raises(DeckError, match=r"2 621 440 cases \(524288 x 5\) are too many"):
        design_of([read_variable(text) for text in VARY], "saltelli", 524288)
