"""Gauges that look through a window: the apparent velocity against the optical path of the run itself, and decks that are wrong."""

import numpy as np
import pytest

from hugoniot import run
from hugoniot.diagnostics.apparent import with_apparent_velocity
from hugoniot.errors import DeckError
from hugoniot.materials import library
from hugoniot.output.run_numbers import warnings_of
from hugoniot.problem.deck import read_deck_text

DECK = """
stop_time = "1.2 us"
[[region]]
name = "flyer"
material = "aluminum"
from = "-1 mm"
to = "0 mm"
zones = 40
velocity = "500 m/s"
[[region]]
name = "target"
material = "aluminum"
from = "0 mm"
to = "1 mm"
zones = 40
[[region]]
name = "glass"
material = "LiF"
from = "1 mm"
to = "3 mm"
zones = 80
[[gauge]]
name = "visar"
at = "target/glass"
window = "glass"
"""


def test_the_window_factor_follows_the_material_the_window_is_based_on_not_its_name():
    named = DECK.replace('"LiF"', '"w"')
    deck = read_deck_text(named + '[material.w]\nbase = "LiF"\n')
    assert deck.problem.gauges[0].window_factor == 1.2769 and any("is not checked against" in w for w in deck.warnings)
    again = read_deck_text(deck.resolved)
    assert again.problem == deck.problem and again.problem.materials["w"].library == "lithium_fluoride"
    with pytest.raises(DeckError, match="does not say how the index"):
        read_deck_text(DECK + '[material.LiF]\nbase = "copper"\n')
    with pytest.raises(DeckError, match="unknown material 'lithia'"):
        read_deck_text(named + '[material.w]\nbase = "LiF"\nlibrary = "lithia"\n')


def test_the_apparent_velocity_is_that_of_the_optical_path(tmp_path):
    """-d/dt of the path in vacuum before the far surface, of n dx over the zones, and of the gap that opens behind the window."""
    deck = read_deck_text(DECK + '[output]\nsnapshots = "20 ns"\nreport = false\n')
    a, b = (library.windows("LiF")[-2][key] for key in ("index_intercept", "index_slope"))
    assert deck.problem.gauges[0].window_factor == a == 1.2769 and any("is not checked against" in w for w in deck.warnings)
    assert read_deck_text(deck.resolved).problem == deck.problem
    found = run(deck.problem, tmp_path / "run")
    rows, snaps = found.arrays("gauges"), found.arrays("snapshots")
    glass = np.array(snaps["region"]) == "glass"
    left, right, rho = (snaps[key][:, glass] for key in ("position_left", "position_right", "density"))
    mirror = snaps["position_right"][:, np.flatnonzero(glass)[0] - 1]
    assert left[-1, 0] - mirror[-1] > 1e-5      # a gap has opened
    path = -right[:, -1] + np.sum((a + b * rho) * (right - left), axis=1) + left[:, 0] - mirror
    time, seen = found.gauge("apparent_velocity", "visar")
    moved = np.interp(snaps["time"], time, np.concatenate(([0.0], np.cumsum(0.5 * (seen[1:] + seen[:-1]) * np.diff(time)))))
    assert np.ptp(right[:, -1]) > 5e-5      # the far surface has moved
    assert moved == pytest.approx(path[0] - path, abs=2e-3 * moved.max())
    others = [k for k, gauge in enumerate(deck.problem.gauges) if not gauge.window]
    assert np.isnan(rows["apparent_velocity"][:, others]).all()
    for side in ("left", "right"):       # one traction, not that of the zone beside the face
        assert np.array_equal(found.gauge("stress", f"visar {side}")[1], found.gauge("stress", "visar")[1])
    early = (time > 0.22e-6) & (time < 0.30e-6)
    assert seen[early] == pytest.approx(1.2769 * found.gauge("velocity", "visar")[1][early], rel=1e-6)


@pytest.mark.parametrize("gauge", (("free surface right", "3 mm"), ("back", "free surface right"), ("back", "glass:right")))
def test_a_gauge_of_the_deck_on_the_far_surface_counts_like_the_automatic_one(gauge):
    """u + (a - 1)(u - u_f) with u = 100 and u_f = 30 m/s, however that gauge is called."""
    name, at = gauge
    problem = read_deck_text(DECK + f'[[gauge]]\nname = "{name}"\nat = "{at}"\n').problem
    far = [gauge.at in ("free surface right", "glass:right") for gauge in problem.gauges]
    seen = with_apparent_velocity(problem, {"velocity": np.where(far, 30.0, 100.0)[None, :]})["apparent_velocity"]
    assert seen[0, 0] == pytest.approx(100.0 + 0.2769 * 70.0, rel=1e-12)


def test_a_run_warns_of_a_window_that_breaks(tmp_path):
    """The light does not pass a spall plane; the formula would count the voids as glass: 22 m/s for the 4 m/s of the path."""
    thin = DECK.replace('"-1 mm"', '"-0.3 mm"').replace("zones = 40", "zones = 20").replace("zones = 80", "zones = 40").replace('"LiF"', '"w"')
    thin += '[material.w]\nbase = "LiF"\nfracture = {law = "spall_stress", strength = "0.3 GPa"}\n[output]\nreport = false\n'
    warned = [text for text in warnings_of(run(read_deck_text(thin).problem, tmp_path / "run")) if "in the window 'glass'" in text]
    assert len(warned) == 1 and "gauge 'visar'" in warned[0]


def test_plexiglas_shows_the_velocity_of_the_interface_itself():
    """Gladstone and Dale: the path lost to the window's thinning is gained by its index."""
    deck = read_deck_text(DECK.replace('"LiF"', '"pmma"'))
    assert deck.problem.gauges[0].window_factor == 1.0 and any("is not checked against" in w for w in deck.warnings)
    for wavelength, index in ((5.32e-7, 1.49341), (1.55e-6, 1.4809)):
        row = next(r for r in library.windows("PMMA") if "index_slope" in r and r["wavelength"] == wavelength)
        assert row["index_intercept"] + 1186.0 * row["index_slope"] == pytest.approx(index, abs=1e-4)


@pytest.mark.parametrize(("change", "words"), [
    (('window = "glass"', 'window = "glas"'), "no region 'glas'"),
    (('window = "glass"', 'window = "flyer"\nwindow_factor = 1.3'), "does not touch the gauge"),
    (('at = "target/glass"', 'at = "0.5 mm"'), "does not touch the gauge"),
    (('window = "glass"', 'window = "target"\nwindow_factor = 1.3'), "has to pass through other bodies"),
    (('window = "glass"', 'wavelength = "532 nm"'), "needs window"),
    (('window = "glass"', 'window = "glass"\nwindow_factor = 1.3\nwavelength = "532 nm"'), "selects the library's index"),
    (('window = "glass"', 'window = "glass"\nwavelength = "700 nm"'), "does not say how the index"),
    (('material = "LiF"', 'material = "copper"'), "does not say how the index"),
    (('stop_time', 'geometry = "spherical"\nstop_time'), "windows are plane")])
def test_windows_that_cannot_be_looked_through(change, words):
    text = DECK.replace(*change)
    if "spherical" in text:
        text = text.replace('"-1 mm"', '"10 mm"').replace('to = "0 mm"', 'to = "11 mm"').replace('from = "0 mm"', 'from = "11 mm"').replace(
            'to = "1 mm"', 'to = "12 mm"').replace('from = "1 mm"', 'from = "12 mm"').replace('to = "3 mm"', 'to = "14 mm"')
    with pytest.raises(DeckError) as caught:
        read_deck_text(text)
    assert any(words in problem.message for problem in caught.value.problems), str(caught.value)


def test_a_wrong_window_is_found_in_the_deck_behind_a_gauge_with_two_sides():
    """The gauges that an interface gauge brings along are in no deck: they do not count."""
    text = DECK + '[[gauge]]\nname = "other"\nat = "0.5 mm"\nwindow = "glass"\n'
    with pytest.raises(DeckError) as caught:
        read_deck_text(text)
    (found,) = caught.value.problems
    assert found.key == "gauge.other.window" and text.splitlines()[found.line - 1] == 'window = "glass"' and found.line > text.count("\n") - 2


def test_quartz_has_an_index_under_compression_at_one_wavelength():
    """Z-cut, elastic; at another wavelength the message names the one there is. Its line in the library is that of strong shocks: told."""
    seen = read_deck_text(DECK.replace('"LiF"', '"quartz"').replace('window = "glass"', 'window = "glass"\nwavelength = "1550 nm"'))
    assert seen.problem.gauges[0].window_factor == 1.087 and not any("is not checked against" in w for w in seen.warnings)
    assert any("the fit of row U216 (quartz) begins at a particle velocity of 5000 m/s" in w for w in seen.warnings)
    rest = next(row for row in library.windows("quartz") if "index" in row and row["wavelength"] == 1.55e-6)
    row = next(row for row in library.windows("quartz") if "index_slope" in row)
    assert row["index_intercept"] + 2650.0 * row["index_slope"] == pytest.approx(rest["index"], abs=2e-4)
    with pytest.raises(DeckError) as caught:
        read_deck_text(DECK.replace('"LiF"', '"quartz"'))
    assert "it does at 1.55 um" in str(caught.value)


def test_the_recalled_indices_join_those_at_rest():
    at_rest = {row["wavelength"]: row["index"] for row in library.windows("LiF") if "index" in row}
    rows = [row for row in library.windows("LiF") if "index_intercept" in row]
    assert len(rows) == 2
    for row in rows:
        assert row["index_intercept"] + 2638.0 * row["index_slope"] == pytest.approx(at_rest[row["wavelength"]], abs=5e-4)
