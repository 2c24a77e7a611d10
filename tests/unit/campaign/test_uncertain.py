"""Sweeps over the library's own uncertainties: cases follow its covariance, bands come of them, and hand-made choices go first."""

import csv

import numpy as np
import pytest

from hugoniot.campaign.ask import Wishes, run_sweep
from hugoniot.cli.sweep import _echo_constants
from hugoniot.dossier.uncertainty import AT_LEAST, uncertainty_of
from hugoniot.errors import DeckError
from hugoniot.materials import library

WATER = """title = "Water on water"
geometry = "planar"
stop_time = "1 us"
[[region]]
name = "flyer"
material = "water"
from = "0 mm"
to = "1 mm"
zones = 10
velocity = "2 km/s"
[[region]]
name = "target"
material = "water"
from = "1 mm"
to = "3 mm"
zones = 20
[[gauge]]
name = "middle"
at = "2 mm"
"""


@pytest.fixture
def water(tmp_path):
    deck = tmp_path / "water.toml"
    deck.write_text(WATER)
    return deck


def test_constants_vary_as_their_covariance_says(water, tmp_path, inline, capsys):
    swept = run_sweep(water, Wishes(uncertain="library", samples=32), tmp_path / "s", engine=inline)
    table, known = swept.table, uncertainty_of(library.entry("water"))
    assert not any(table.reasons) and len(table) == 32
    z = np.array([table.column(f"water_{d.source.replace(' ', '_')}").values for d in known.directions])
    for name, value in (("eos.c0", 1535.4), ("eos.s1", 1.97562)):
        expected = value + sum(d.shifts.get(name, 0.0) * row for d, row in zip(known.directions, z))
        assert np.allclose(table.column(f"material.water.{name}").values, expected, rtol=1e-5)
    assert table.column("material.water.eos.c0").values.std() == pytest.approx(known.deviations["eos.c0"], rel=0.15)
    assert {column.name for column in table.records} >= {"middle.velocity"}
    heads = next(csv.reader((tmp_path / "s" / "bands.csv").open()))
    assert "middle.velocity 0.975 quantile [m/s]" in heads
    rows = list(csv.reader((tmp_path / "s" / "constants.csv").open()))
    assert rows[1][:2] == ["water", "eos.c0"] and float(rows[1][4]) == pytest.approx(known.deviations["eos.c0"], rel=1e-3)
    page = (tmp_path / "s" / "report.html").read_text()
    assert "Constants of the library" in page and "relative to the median" in page
    _echo_constants(swept.constants)
    assert AT_LEAST in capsys.readouterr().out and AT_LEAST[1:] in page and "lower bound" in AT_LEAST


def test_one_material_under_two_names_varies_as_one(water, tmp_path, inline):
    """Water on water: half the velocity of the flyer behind the shock, whatever the constants are."""
    text = WATER.replace('"water"', '"left"', 1).replace('"water"', '"right"', 1)
    water.write_text(text + '[material.left]\nbase = "water"\n[material.right]\nbase = "water"\n')
    table = run_sweep(water, Wishes(uncertain="library", samples=8), tmp_path / "s", engine=inline, report=False).table
    left, right = (table.column(f"material.{name}.eos.c0").values for name in ("left", "right"))
    assert left.std() > 0.0 and np.array_equal(left, right)
    assert table.column("middle.peak_velocity").values == pytest.approx(1000.0, rel=5e-3)      # a coarse mesh


def test_a_constant_that_is_varied_by_hand_is_not_varied_twice(water, tmp_path, inline):
    wishes = Wishes(vary=["material.water.eos.c0 = 1500 +- 5 m/s"], uncertain="library", samples=8, record=["middle.velocity"])
    table = run_sweep(water, wishes, tmp_path / "s", engine=inline, report=False).table
    assert table.column("material.water.eos.c0").values.std() < 12.0
    assert table.column("material.water.eos.s1").values.std() > 0.0 and len(table.records) == 1


def test_what_has_no_uncertainty_is_refused(deck, water, tmp_path, inline):
    with pytest.raises(DeckError, match="gives no uncertainty for any constant"):
        run_sweep(deck, Wishes(uncertain="library"), tmp_path / "s", engine=inline)
    with pytest.raises(DeckError, match="known: library"):
        run_sweep(water, Wishes(uncertain="guess"), tmp_path / "s", engine=inline)
    with pytest.raises(DeckError, match="no deck"):
        run_sweep(None, Wishes(match=["copper", "aluminum"], vary=["velocity = 500 m/s"], uncertain="library"), tmp_path / "s", engine=inline)
