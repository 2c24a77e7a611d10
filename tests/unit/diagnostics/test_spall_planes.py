"""Coarse spall planes are named in a warning: in a run at 100 zones, not at 200, and not where regions merely separate."""

import numpy as np
import pytest

from hugoniot import run
from hugoniot.diagnostics.spall_planes import unresolved
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.laws.fracture.spall_stress import SpallStress
from hugoniot.materials.material import Material
from hugoniot.output.run_numbers import warnings_of
from hugoniot.problem import catalogue
from hugoniot.problem.deck import read_deck_text
from hugoniot.problem.model import Boundary, Problem, Region


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

    def said(*opened):
        return unresolved(problem, np.array(opened, dtype=int), region_of)

    assert said() == said(50) == said(150, 350) == []
    (text,) = said(50, 149, 400)
    assert "'target' 50 zones" in text and 'zone_size = "5 um"' in text


def test_a_plane_counts_when_its_void_has_closed(tmp_path):
    """A foil spalls, and a wall ahead of it closes the void again before the run ends."""
    law, speed = MieGruneisen(2700.0, 5200.0, 1.5, 2.0), 500.0
    materials = {"flyer": Material("flyer", law), "foil": Material("foil", law, fracture=SpallStress(0.5e9))}
    regions = (Region("flyer", "flyer", -0.5e-3, 0.0, 25, velocity=speed), Region("foil", "foil", 0.0, 1e-3, 50),
               Region("wall", "flyer", 1.05e-3, 3e-3, 97))
    problem = Problem("foil", "planar", 1e-6, regions, materials, left=Boundary("free"), right=Boundary("fixed"))
    done = run(problem, tmp_path / "run", report=False)
    events = [str(kind) for kind in done.arrays("events")["kind"]]
    assert events.count("void_opened") >= 1 and "void_closed" in events[events.index("void_opened"):]
    closed = [str(text) for text in done.arrays("events")["text"] if "between 'foil' and 'foil' closed" in str(text)]
    assert closed and any("a void opened in 'foil'" in text for text in warnings_of(done))
