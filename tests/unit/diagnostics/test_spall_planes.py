"""Coarse spall planes are named in a warning: in a run at 100 zones, not at 200, and not where regions merely separate."""

import numpy as np
import pytest

from hugoniot import run
from hugoniot.diagnostics.spall_planes import unresolved
from hugoniot.output.run_numbers import warnings_of
from hugoniot.problem import catalogue
from hugoniot.problem.deck import read_deck_text


@pytest.mark.parametrize("zones, warned", [(100, True), (200, False)])
def test_the_flyer_on_a_coarse_mesh(tmp_path, zones, warned):
    deck = read_deck_text(catalogue.deck_text("flyer"), "flyer.toml", {"region.flyer.zones": zones, "region.target.zones": 2 * zones,
                                                                       "stop_time": "1.2 us"})
    found = run(deck.problem, tmp_path / "run", report=False)
    assert found.summary["voids_opened"] >= 1
    assert any("void opened in 'target' 77 zones" in text for text in warnings_of(found)) == warned


def test_which_planes_count():
    problem = read_deck_text(catalogue.deck_text("flyer"), "flyer.toml", {"region.flyer.zones": 50, "region.target.zones": 400}).problem
    region_of = np.repeat([0, 1], [50, 400])

    def bodies(*starts):
        return np.array([[first, last, 0, 0] for first, last in zip((0, *starts), (*starts, 450))])

    assert unresolved(problem, bodies(), region_of) == unresolved(problem, bodies(50), region_of) == []
    assert unresolved(problem, bodies(150, 350), region_of) == []
    (text,) = unresolved(problem, bodies(50, 149, 400), region_of)
    assert "'target' 50 zones" in text and 'zone_size = "5 um"' in text
