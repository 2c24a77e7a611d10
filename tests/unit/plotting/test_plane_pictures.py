"""Maps, profiles, films and reports of two-dimensional runs show what the run holds."""

import json
from types import SimpleNamespace

import matplotlib
import numpy as np
import pytest
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure
from PIL import Image
from plane_builders import aluminium, box, problem
from plane_runs import GROWTH, STRETCH, record

import hugoniot
from hugoniot.cli.main import main
from hugoniot.diagnostics.stress2d import lode_angle, principal_angle, principal_deviators, von_mises
from hugoniot.errors import DeckError
from hugoniot.plotting.animate import Gif, animate
from hugoniot.plotting.plane import borders, plane_setup
from hugoniot.plotting.records import gauge
from hugoniot.problem.model import Pulse
from hugoniot.problem.plane.model import Boundary2D, Erosion2D, VelocityField
from hugoniot.report import write_report

matplotlib.use("Agg")


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    return record(tmp_path_factory.mktemp("plane") / "rod.run")


def test_a_map_shows_every_zone_where_it_is_with_its_value(run):
    ax = run.plot.map("pressure", time="4 us", mirror=False)
    (zones,) = [part for part in ax.collections if isinstance(part, PolyCollection)]
    rows, corners = run.arrays("snapshots"), run.arrays("mesh")["zone_nodes"]
    assert len(zones.get_paths()) == len(corners)
    first = zones.get_paths()[7].vertices[:4]
    assert np.allclose(first[:, 0], 1e3 * rows["position_x"][2][corners[7]]) and np.allclose(first[:, 1], 1e3 * rows["position_y"][2][corners[7]])
    assert np.allclose(zones.get_array(), rows["pressure"][2] * 1e-3)       # kPa
    assert ax.get_xlabel() == "r (mm)" and ax.get_ylabel() == "z (mm)" and "4" in ax.get_title(loc="left")


def test_very_many_zones_are_painted_in_parts_to_the_same_picture(run, monkeypatch):
    """A path of each zone would take gigabytes where there are a million."""
    def painted():
        figure = run.plot.map("pressure", time="4 us", mesh=False).figure
        figure.canvas.draw()
        return np.asarray(figure.canvas.buffer_rgba()).copy()

    plain = painted()
    monkeypatch.setattr("hugoniot.plotting.polygons.MOST_VECTORS", 7)
    assert np.array_equal(painted(), plain)


def test_the_mirrored_half_is_the_same_on_the_left(run):
    ax = run.plot.map("pressure", time=0.0)
    right, left = [part for part in ax.collections if isinstance(part, PolyCollection)]
    assert np.allclose(left.get_paths()[3].vertices * [-1.0, 1.0], right.get_paths()[3].vertices)


def test_borders_are_the_outline_and_the_interface(run):
    mesh = run.arrays("mesh")
    outline, interface = borders(mesh["zone_nodes"], mesh["block_of"])
    assert len(outline) == 2 * (9 + 10) and len(interface) == 10
    x = run.arrays("snapshots")["position_x"][0]
    assert np.allclose(x[interface], 2e-3)


def test_a_profile_gives_the_value_of_the_zones_along_the_line(run):
    ax = run.plot.profile("pressure", time="0 us", start=(1e-3, 0.0), end=(1e-3, 10e-3))
    place, value = ax.lines[0].get_data()
    middle = np.floor(place[1:-1]) + 0.5
    inner = np.abs(place[1:-1] - np.round(place[1:-1])) > 0.02
    assert np.allclose(value[1:-1][inner], middle[inner], rtol=1e-9)      # kPa and mm: the pressure is 1 kPa for each mm of z
    with pytest.raises(DeckError, match="crosses no material"):
        run.plot.profile("pressure", start=(1.0, 0.0), end=(1.0, 1.0))


def test_a_derived_field_and_an_unknown_one(run):
    ax = run.plot.map("speed", time=0.0, mirror=False)
    assert max(ax.collections[0].get_array()) == pytest.approx(np.hypot(GROWTH * 4.75e-3, STRETCH * 9.5e-3), rel=0.05)
    with pytest.raises(DeckError, match="did you mean 'pressure'"):
        run.plot.map("presure")


def test_the_colours_of_a_film_are_those_of_its_scale(tmp_path):
    """Beside a map of many reds, to which a palette of the frame's own would be fitted: twice half a step of the palette, 6 of 255."""
    figure = Figure(figsize=(3.0, 2.0))
    colours, writer = matplotlib.colormaps["viridis"], Gif(fps=1)
    with writer.saving(figure, str(tmp_path / "film.gif"), 100):
        reds = np.random.default_rng(1).random((200, 200, 3)) * [1.0, 0.3, 0.3]
        figure.add_axes((0.0, 0.0, 0.8, 1.0)).imshow(reds, aspect="auto")
        figure.add_axes((0.8, 0.0, 0.2, 1.0)).imshow(np.linspace(1.0, 0.0, 200)[:, None], cmap=colours, aspect="auto")
        for ax in figure.axes:
            ax.set_axis_off()
        writer.grab_frame()
        writer.keep_colours(colours)
    with Image.open(tmp_path / "film.gif") as film:
        seen = np.asarray(film.convert("RGB"), dtype=float)[:, 270]
    assert np.abs(seen - 255.0 * colours(np.linspace(1.0, 0.0, 200))[:, :3]).max() < 6.0


def test_a_film_has_a_frame_per_snapshot_and_an_mp4_asks_for_ffmpeg(run, tmp_path, monkeypatch):
    assert animate(run, "pressure", tmp_path / "film.gif", every=2) == 2
    with Image.open(tmp_path / "film.gif") as film:
        assert film.n_frames == 2 and film.size == (704, 528)
    monkeypatch.setattr("matplotlib.animation.FFMpegWriter.isAvailable", classmethod(lambda cls: False))
    with pytest.raises(DeckError, match="needs the program ffmpeg"):
        animate(run, "pressure", tmp_path / "film.mp4")
    with pytest.raises(DeckError, match="end its name with .gif or .mp4"):
        animate(run, "pressure", tmp_path / "film.avi")


def call(capsys, *arguments):
    with pytest.raises(SystemExit) as ended:
        main(list(map(str, arguments)))
    caught = capsys.readouterr()
    return ended.value.code, caught.out, caught.err


def test_the_commands_draw_and_refuse(run, tmp_path, capsys):
    code, out, _ = call(capsys, "plot", run.folder, "map", "speed", "--layers", "contours, one half", "--x", "0..3 mm", "-o", tmp_path / "c.png")
    assert code == 0, out
    code, out, _ = call(capsys, "plot", run.folder, "-o", tmp_path / "a.png")
    assert code == 0 and (tmp_path / "a.png").stat().st_size > 5000, out
    code, _, _ = call(capsys, "plot", run.folder, "profile", "pressure", "--line", "1 mm, 0 mm .. 1 mm, 9 mm", "-o", tmp_path / "b.svg")
    assert code == 0
    for arguments, words in ((("xt",), "no picture 'xt'"), (("map", "pressure", "--line", "0 mm, 0 mm"), "a profile"),
                             (("profile", "pressure", "--line", "0 mm"), "two points"), (("map", "--layers", "mash"), "did you mean 'mesh'")):
        code, _, err = call(capsys, "plot", run.folder, *arguments)
        assert code == 2 and words in err, err
    code, out, _ = call(capsys, "info", run.folder, "--json")
    assert code == 0 and json.loads(out)["gauges"][3]["peak_velocity"] == pytest.approx(5e-3 * GROWTH)


def test_gauges_show_their_pressure_unless_told_otherwise_also_one_that_is_lost(run):
    plain = run.plot.gauge()
    assert plain.get_ylabel() == run.plot.gauge("pressure").get_ylabel() and "pressure" in plain.get_ylabel()
    names, rows = run.gauge_names(), run.arrays("gauges")
    lost = type("Lost", (dict,), {"shapes": rows.shapes, "kinds": rows.kinds})({**rows, "pressure": rows["pressure"].copy()})
    lost["pressure"][-2:, names.index("inside")] = np.nan
    seen = SimpleNamespace(setup=run.setup, folder=run.folder, gauge_names=run.gauge_names, unit=run.unit, arrays=lambda group: lost)
    ax = gauge(seen, "pressure")
    shown = {text.get_text(): text.get_position()[1] for text in ax.texts}
    assert set(shown) == set(names) and np.isfinite(list(shown.values())).all()


def test_a_line_of_detonators_is_drawn_from_end_to_end(run):
    at, to = [0.0, 0.0], [2e-3, 1e-3]
    lit = SimpleNamespace(setup={**run.setup, "lighting": [{"at": at, "to": to, "time": 0.0}]}, folder=run.folder, arrays=run.arrays)
    lines = [np.array(line.get_data()).T for line in plane_setup(lit).get_lines()]
    assert any(len(line) == 2 and np.allclose(line, 1e3 * np.array([at, to])) for line in lines)


def test_the_report_has_setup_maps_gauges_and_budget(run):
    page = write_report(run.folder).read_text()
    for words in ("<h2>Set-up", "<h2>Maps", "<h2>Gauge records", "<h2>Energy and momentum", "map-pressure", "gauge-line-velocity"):
        assert words in page, words


def test_principal_stresses_turn_with_the_frame():
    """Uniaxial tension s along a direction phi: deviators 2/3 s, -1/3 s, -1/3 s."""
    for phi in (0.0, 0.3, -1.1, 1.5):
        stress, c, s = 3.0, np.cos(phi), np.sin(phi)
        sxx, syy, sxy, szz = stress * (c * c - 1 / 3), stress * (s * s - 1 / 3), stress * c * s, -stress / 3
        assert von_mises(sxx, syy, sxy, szz) == pytest.approx(stress, rel=1e-12)
        assert principal_angle(sxx, syy, sxy) == pytest.approx(phi, abs=1e-12)
        assert np.allclose(principal_deviators(sxx, syy, sxy, szz), [2.0, -1.0, -1.0])
        assert lode_angle(sxx, syy, sxy, szz) == pytest.approx(-np.pi / 6, abs=1e-7)
        assert lode_angle(-sxx, -syy, -sxy, -szz) == pytest.approx(np.pi / 6, abs=1e-7)
    assert lode_angle(1.0, -1.0, 0.0, 0.0) == pytest.approx(0.0, abs=1e-12)


@pytest.mark.parametrize("force, boundaries, words", [((0.0, -1e6), (), "work of the body force"),
                                                      ((0.0, 0.0), (Boundary2D(("b.bottom",), "velocity", Pulse("constant", amplitude=1.0)),), "boundary work")])
def test_what_is_drawn_of_the_energy_adds_up(tmp_path, force, boundaries, words):
    """A body that falls freely has the kinetic energy m (g t)^2/2, which is the work of its weight; that of a driven edge is drawn likewise."""
    given = problem(box(2, 2, 1e-3, 1e-3, material="al"), aluminium(), 1e-6, boundaries, body_force=force)
    found = hugoniot.run(given, out=tmp_path / "fall.run")
    ax = found.plot.budget()
    lines = {text.get_text(): line.get_ydata()[-1] - line.get_ydata()[0] for text, line in zip(ax.texts, ax.lines)}
    # what is less than 1e-4 of the largest is not drawn
    assert lines[words] == pytest.approx(lines["kinetic"] + lines.get("internal", 0.0), rel=1e-3) and lines[words] > 0.0
    if any(force):
        assert lines[words] == pytest.approx(0.5 * 2700.0 * 1e-6 * (1e6 * 1e-6) ** 2, rel=1e-9) and found.unit("budget", "force_work") == "J/m"


def test_the_energy_of_dropped_mass_is_drawn(tmp_path):
    """A rod on a block of its own metal, without a load: what they lose went with the zones that left."""
    block, moving = (box(*size, name=name, material="al", velocity=VelocityField(base=(0.0, speed))) for *size, name, speed in (
        (8, 8, 8e-3, 8e-3, (0.0, -8e-3), "target", 0.0), (2, 10, 2e-3, 10e-3, (0.0, 1e-5), "rod", -2000.0)))
    found = hugoniot.run(problem([block, moving], aluminium(), 3e-6, (), "axisymmetric", erosion=Erosion2D(0.5, None, "dropped")), out=tmp_path / "rod.run")
    assert found.summary["zones_eroded"] > 3
    ax = found.plot.budget()
    lines = {text.get_text(): line.get_ydata()[-1] - line.get_ydata()[0] for text, line in zip(ax.texts, ax.lines)}
    assert lines["energy of dropped mass"] > 0.0
    assert lines["kinetic"] + lines["internal"] == pytest.approx(-lines["energy of dropped mass"], rel=1e-9)
    assert found.unit("budget", "eroded_energy") == "J/rad"
