"""Pictures show what the folder holds: the drawn numbers are read back from the axes."""

import pathlib
import sys

import numpy as np
import pytest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "output"))

import acoustic_flyer

from hugoniot.errors import DeckError, FileTrouble
from hugoniot.output.compare import compare
from hugoniot.plotting import load


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    folder = tmp_path_factory.mktemp("pictures") / "run"
    acoustic_flyer.run(folder)
    return load(folder)


def test_every_picture_is_drawn_and_saved(run, tmp_path):
    from hugoniot.plotting.accessor import PICTURES

    for name in set(PICTURES) - {"pi_plane"}:     # the plates have no strength
        ax = getattr(run.plot, name)()
        ax.figure.savefig(tmp_path / f"{name}.png", dpi=50)
        assert (tmp_path / f"{name}.png").stat().st_size > 2000
        assert ax.get_xlabel() and "(" in ax.get_xlabel(), name


def test_gauge_lines_are_the_record_in_the_axis_units(run):
    ax = run.plot.gauge("stress", "middle")
    x, y = ax.lines[0].get_data()
    time, stress = run.gauge("stress", "middle")
    assert np.array_equal(x, time * 1e6) and np.allclose(y, stress * 1e-9, rtol=1e-15)
    assert "µs" in ax.get_xlabel() and "GPa" in ax.get_ylabel() and [t.get_text() for t in ax.texts] == ["middle"]


def test_every_gauge_that_is_named_is_drawn(run, tmp_path):
    """The command line takes several, and more of them than there are colours."""
    from hugoniot.cli.main import main

    assert len(run.plot.gauge("velocity", ["middle"] * 11).lines) == len(run.plot.gauge("velocity", ["middle"] * 11).texts) == 11
    named = [word for name in run.gauge_names() for word in ("--gauge", name)]
    with pytest.raises(SystemExit) as ended:
        main(["plot", str(run.folder), "gauge", "velocity", *named, "--out", str(tmp_path / "all.svg")])
    assert not ended.value.code and len(run.gauge_names()) > 1
    assert all(f">{name}</text>" in (tmp_path / "all.svg").read_text() or f"<!-- {name} -->" in (tmp_path / "all.svg").read_text()
               for name in run.gauge_names())


DRIVEN = """stop_time = "1 us"
[[region]]
name = "plate"
material = "own"
from = "0 mm"
to = "4 mm"
zones = 40
[material.own]
eos = {law = "mie_gruneisen", rho0 = 2700.0, c0 = 5200.0, s = 1.5, gamma0 = 2.0}
strength = {law = "perfectly_plastic", shear_modulus = "26 GPa", yield_stress = "0.3 GPa"}
[boundary]
left = {pressure = "2 GPa"}
[body_force]
acceleration = "1e8 m/s^2"
[[heat_source]]
region = "plate"
power = "1e10 W/kg"
"""


def test_no_part_of_the_energy_is_left_out_for_want_of_a_colour(tmp_path):
    """What enters is what there is more of: the lines of work and heat supplied sum to those of kinetic and internal energy."""
    from hugoniot import run as run_problem
    from hugoniot.problem.deck import read_deck_text

    ax = run_problem(read_deck_text(DRIVEN, "deck.toml").problem, tmp_path / "run", report=False).plot.budget()
    end = {text.get_text(): line.get_ydata()[-1] for text, line in zip(ax.texts, ax.lines, strict=True)}
    assert len(end) == 9
    assert end["boundary work"] + end["heat supplied"] + end["work of the body force"] == pytest.approx(end["kinetic"] + end["internal"], rel=1e-9)


def test_the_pull_back_is_written_on_the_free_surface(run):
    ax = run.plot.free_surface()
    assert any("pull-back 70 m/s" in text.get_text() for text in ax.texts)
    x, y = ax.lines[0].get_data()
    assert np.allclose(y, run.gauge("velocity", "free surface")[1])
    seen = run.plot.free_surface(delay=2e-8).lines[1].get_ydata()
    assert seen.max() < y.max() and seen.max() > 0.9 * y.max()


def test_a_strength_that_is_a_lower_bound_is_written_as_one(run, monkeypatch):
    from dataclasses import replace

    from hugoniot.plotting import records

    found = records.read_record
    for note in ("", "a lower bound"):
        monkeypatch.setattr(records, "read_record", lambda *given, note=note: replace(found(*given), note=note))
        written = any("spall strength at least" in text.get_text() for text in run.plot.free_surface().texts)
        assert written == bool(note)


def test_the_wave_diagram_keeps_voids_white_and_zero_grey(run):
    ax = run.plot.xt("stress")
    image = ax.images[0]
    values = np.where(np.ma.getmaskarray(image.get_array()), np.nan, image.get_array().data)
    x = np.linspace(*image.get_extent()[:2], values.shape[1])
    assert np.isnan(values[-1]).sum() > 20
    assert abs(np.isnan(values[0]).sum() - (x > 1.8).sum()) <= 2  # at first all is whole up to 1.8 mm, and nothing beyond
    colours = image.get_cmap()(image.norm(np.array([0.0])))[0]
    assert np.allclose(colours[:3], np.array([0xE3, 0xE1, 0xDC]) / 255, atol=0.02)
    low, high = image.get_clim()
    assert high == pytest.approx(1.4, rel=0.03) and low < 0


def test_profiles_break_at_voids(run):
    y = run.plot.profile("stress").lines[0].get_ydata()
    assert np.isnan(y).sum() == 2
    assert len(run.plot.profile("density", time=[2e-7, 5e-7]).lines) == 2
    assert len(run.plot.profile("density", time="0.2 us").lines) == len(run.plot.profile("density", time=["0.2 us"]).lines) == 1


def test_peaks_over_lagrangian_position(run):
    lines = run.plot.peaks("stress").lines
    assert len(lines) == 2 and np.concatenate([line.get_ydata() for line in lines]).max() == pytest.approx(1.404, rel=1e-12)


def test_the_setup_is_to_scale(run):
    boxes = [patch.get_bbox() for patch in run.plot.setup().patches if hasattr(patch, "get_bbox")]
    assert {round(box.width, 9) for box in boxes} == {0.6, 1.2}


def test_unknown_fields_and_gauges_are_answered_with_what_there_is(run):
    for call in (lambda: run.plot.xt("presure"), lambda: run.plot.profile("presure")):
        with pytest.raises(DeckError, match="do not contain 'presure'; did you mean 'pressure'"):
            call()
    with pytest.raises(DeckError, match="do not contain '5'; it has: "):
        run.plot.peaks(5)
    for call in (lambda: run.plot.gauge("stress", "nowhere"), lambda: run.plot.gauge(names=["nowhere"]), lambda: run.plot.free_surface("nowhere")):
        with pytest.raises(DeckError, match="no gauge 'nowhere'; this run has: middle, free surface"):
            call()
    with pytest.raises(DeckError, match="no gauge '5'"):
        run.plot.gauge(names=5)
    with pytest.raises(KeyError, match="no column 'streß' in gauges; it has: .*stress"):
        run.unit("gauges", "streß")


@pytest.mark.parametrize("time, told", [([], "no time was given"), (9, "no state at 9 s"), ([-1], "no state at -1 s"), ("9 us", "no state at 9 us")])
def test_a_time_the_run_did_not_reach_is_refused(run, time, told):
    with pytest.raises(DeckError, match=told):
        run.plot.profile("stress", time)


@pytest.mark.parametrize("delay, told", [("-1 ns", "must not be negative"), (1, "longer than the record")])
def test_a_delay_no_interferometer_has_is_refused(run, delay, told):
    assert len(run.plot.free_surface(delay="20 ns").lines) == 2
    with pytest.raises(DeckError, match=told):
        run.plot.free_surface(delay=delay)


def test_a_field_at_the_nodes_is_drawn_as_the_mean_over_each_zone(run):
    rows = run.arrays("snapshots")
    y = run.plot.profile("velocity").lines[0].get_ydata()
    mean = 0.5 * (rows["velocity_left"][-1] + rows["velocity_right"][-1])
    assert np.array_equal(y[~np.isnan(y)], mean) and np.ptp(mean) > 100.0
    assert run.plot.xt("velocity").images[0].get_clim()[1] == pytest.approx(rows["velocity_left"].max(), rel=0.1)


def test_drawing_leaves_the_users_settings_alone(run):
    import matplotlib

    before = dict(matplotlib.rcParams)
    run.plot.xt()
    run.plot.budget()
    assert dict(matplotlib.rcParams) == before


def test_pyplot_is_not_imported_for_a_picture(run):
    import subprocess

    code = f"import sys; from hugoniot.plotting import load; load({str(run.folder)!r}).plot.xt(); assert 'matplotlib.pyplot' not in sys.modules; assert 'xarray' not in sys.modules"
    assert subprocess.run([sys.executable, "-c", code], capture_output=True).returncode == 0


def test_labels_are_spread_within_their_bounds():
    from hugoniot.plotting.style import spread

    placed = spread([0.0, 0.01, 0.02, 1.0], 0.1, 0.0, 1.0)
    assert np.all(np.diff(placed) >= 0.1 - 1e-12) and placed.min() >= 0 and placed.max() <= 1
    assert np.allclose(spread([0.0, 0.5], 0.1), [0.0, 0.5])


def test_comparison_is_drawn_with_its_difference(run, tmp_path):
    from hugoniot.plotting import save_comparison
    from hugoniot.plotting.comparison import comparison

    time, velocity = run.gauge("velocity", "free surface")
    (tmp_path / "d.csv").write_text("time [us],velocity [m/s]\n" + "\n".join(f"{t * 1e6!r},{u + 5!r}" for t, u in zip(time.tolist(), velocity.tolist())))
    found = compare(run, tmp_path / "d.csv")
    below = comparison(found).axes[1]
    assert np.allclose(below.lines[1].get_ydata(), 5.0, atol=1e-9)
    assert save_comparison(found, tmp_path / "c.png").stat().st_size > 5000
    with pytest.raises(FileTrouble):
        save_comparison(found, tmp_path / "none" / "c.png")


def test_long_labels_of_a_comparison_do_not_overlap():
    from hugoniot.core.fields import FIELDS
    from hugoniot.diagnostics.norms import difference
    from hugoniot.output.compare import Comparison, Pair, Record
    from hugoniot.plotting.comparison import comparison

    time = np.linspace(0.0, 1e-6, 5)
    for name in sorted(FIELDS, key=lambda name: -len(FIELDS[name].long_name))[:3]:
        one, two = (Record("g", name, FIELDS[name].unit, time, value * np.ones(5)) for value in (2e9, 1e9))
        figure = comparison(Comparison("a", "b", (Pair(one, two, difference(time, one.values, time, two.values)),), ()))
        figure.canvas.draw()
        above, below = (ax.yaxis.label.get_window_extent() for ax in figure.axes)
        assert not above.overlaps(below) and above.y1 <= figure.bbox.y1 and below.y0 >= 0.0, name


def test_pressures_of_gases_are_drawn_in_their_own_unit():
    from hugoniot.laws.eos.ideal_gas import IdealGas
    from hugoniot.plotting.eos import hugoniots
    from hugoniot.theory.hugoniot import Initial, curve

    gas = IdealGas(1.4)
    for speed, unit, factor in ((300.0, "kPa", 1e6), (3000.0, "MPa", 1e3)):
        ax = hugoniots([("gas", Initial.at_rest(gas), curve(gas, up_to=speed))])
        assert ax.get_ylabel() == f"pressure ({unit})"
        assert float(ax.yaxis.get_major_formatter()(0.002)) == pytest.approx(0.002 * factor)


def test_axes_are_limited_in_si_units(run, tmp_path):
    """The limits of the options, whatever units the axes are labelled with."""
    from hugoniot.cli.plot import _limits
    from hugoniot.cli.show import span
    from hugoniot.plotting.style import show_only, si_factor

    assert span("-1..6 GPa", "Pa", "--range") == (-1e9, 6e9) and span("2 um..0.005", "m", "--x") == (2e-6, 5e-3)
    assert (si_factor("µs"), si_factor("GPa"), si_factor("kg/m³"), si_factor("km/s")) == (1e-6, 1e9, 1.0, 1e3)
    end = float(run.arrays("gauges")["time"][-1])
    ax = run.plot.gauge("stress")
    show_only(ax, (0.25 * end, 0.5 * end), (-1e8, 2e8))
    unit = si_factor(ax.get_xlabel().rpartition("(")[2].rstrip(")"))
    assert ax.get_xlim() == pytest.approx((0.25 * end / unit, 0.5 * end / unit))
    with pytest.raises(DeckError, match="does not apply to the picture 'profile'"):
        _limits("profile", "", None, "1..2 us", None)
    with pytest.raises(DeckError, match="is not a range"):
        span("5..1 mm", "m", "--x")
    half = run.plot.xt("stress", window=(0.0, 1e-3), times=(0.0, 0.5 * end))
    assert half.get_xlim()[1] == pytest.approx(1.0) and half.get_ylim()[1] * unit == pytest.approx(0.5 * end)


@pytest.mark.parametrize(("shift", "where"), [(0.0, ""), (1e-3, " (below)"), (-1e-3, " (above)")])
def test_a_gauge_that_ends_outside_the_range_is_named_at_its_edge(run, shift, where):
    """The range of the option holds the last value of the record, or lies just above or below it."""
    last = run.gauge("velocity", "free surface")[1][-1]
    low, high = last + np.array([-1.0, 1.0]) * 1e-4 * abs(last) + shift * abs(last)
    ax = run.plot.gauge("velocity", "free surface", limits=(low, high))
    name, = ax.texts
    assert name.get_text() == "free surface" + where
    assert ax.get_ylim() == pytest.approx((low, high)) and low <= name.get_position()[1] <= high


def test_a_spike_does_not_flatten_the_differences():
    from matplotlib.figure import Figure

    from hugoniot.plotting.comparison import _robust

    gap = np.sin(np.linspace(0.0, 20.0, 1000))
    for spike, told in ((gap, False), (np.where(np.arange(1000) == 500, 300.0, gap), True)):
        ax = Figure().subplots()
        ax.plot(spike)
        _robust(ax, spike, "m/s")
        assert ax.get_ylim()[1] < 3.0 and ("largest 300 m/s" in [text.get_text() for text in ax.texts]) == told


def test_columns_too_large_for_memory_are_drawn_record_by_record_to_the_same_picture(run, monkeypatch):
    from hugoniot.output import result_columns

    def picture(run):
        ax = run.plot.xt("velocity")
        return ax.images[0].get_array(), [segment for part in ax.collections for segment in part.get_segments()]

    whole, lines = picture(run)
    monkeypatch.setattr(result_columns, "KEPT", 1000)
    monkeypatch.setattr(result_columns, "BLOCK", 3 * 8 * run.arrays("snapshots").shapes["pressure"][1])
    largest, read = 0, result_columns.Columns._read

    def watched(columns, *arguments):
        nonlocal largest
        found = read(columns, *arguments)
        largest = max(largest, found.nbytes if columns.shapes[arguments[0]][1:] else 0)
        return found

    monkeypatch.setattr(result_columns.Columns, "_read", watched)
    again = load(run.folder)
    image, edges = picture(again)
    assert 0 < largest <= result_columns.BLOCK
    assert np.array_equal(image, whole, equal_nan=True)
    assert all(np.array_equal(a, b, equal_nan=True) for a, b in zip(edges, lines, strict=True))
    columns, whole = again.arrays("snapshots"), run.arrays("snapshots")
    assert columns.extent("pressure") == (whole["pressure"].min(), whole["pressure"].max())
    assert np.array_equal(columns.history("velocity_right", -1), whole["velocity_right"][:, -1])
    with pytest.raises(IndexError):
        columns.records("pressure")[len(whole["time"])]


def test_a_map_of_removed_zones_is_refused():
    """They are not drawn: the map would show the zero of all that are left."""
    from types import SimpleNamespace

    from hugoniot.page.live import zone_fields
    from hugoniot.plotting.plane import map_

    with pytest.raises(DeckError, match="not drawn"):
        map_(SimpleNamespace(folder="a.run", setup={"axes": ("x", "y")}), "eroded")
    assert zone_fields({"pressure": 2, "eroded": 2}, True)[0] == "pressure" and "eroded" not in zone_fields({"eroded": 2}, True)
