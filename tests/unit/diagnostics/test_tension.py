"""Tension beyond what solids carry is warned of where no fracture law limits it; scales are the library's table, read here again."""

import csv
import pathlib

import numpy as np
import pytest

import hugoniot
from hugoniot.diagnostics.tension import MULTIPLE, overstretched, spall_scale
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.laws.fracture.spall_stress import SpallStress
from hugoniot.materials.material import Material
from hugoniot.problem.deck import read_deck_text
from hugoniot.problem.model import OutputOptions, Problem, Region

TABLE = pathlib.Path(hugoniot.__file__).parent / "materials" / "library" / "data" / "strength.csv"
STEEL = MieGruneisen(7900.0, 4570.0, 1.49, 1.93)


def strengths():
    with open(TABLE, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))[1:]
    return {row["material"]: float(row["spall_strength"]) for row in rows if row["spall_strength"]}


def problem(name="steel", fracture=None, speed=0.0, library=""):
    regions = (Region("flyer", name, -2e-3, 0.0, 40, velocity=speed), Region("plate", name, 0.0, 4e-3, 80))
    return Problem("steel", "planar", 1.6e-6, regions, {name: Material(name, STEEL, fracture=fracture, library=library)}, output=OutputOptions(report=False))


def test_the_scale_is_the_materials_own_or_the_librarys_largest():
    assert spall_scale("copper")[0] == strengths()["Copper (annealed)"]
    strength, whose = spall_scale("")
    assert strength == max(strengths().values()) and "Tantalum" in whose


@pytest.mark.parametrize("part, fracture, told", [(1.01, None, 1), (0.99, None, 0), (1.01, SpallStress(2e9), 0)])
def test_only_more_than_the_stated_multiple_without_a_fracture_law_is_warned_of(part, fracture, told):
    tension = np.zeros(120)
    tension[100] = part * MULTIPLE * max(strengths().values())
    found = overstretched(problem(fracture=fracture), np.repeat([0, 1], [40, 80]), tension)
    assert len(found) == told and all("'plate'" in text and "no fracture law" in text for text in found)


@pytest.mark.parametrize("name", ["s", "steel", "steel_304", "tantalum"])
def test_what_a_material_is_based_on_decides_not_its_name(name):
    tension = np.full(120, 1.01 * MULTIPLE * strengths()["Stainless steel 304"])
    assert len(overstretched(problem(name, library="steel_304"), np.repeat([0, 1], [40, 80]), tension)) == 2
    assert overstretched(problem(name), np.repeat([0, 1], [40, 80]), tension) == []


def test_a_run_of_steel_that_cannot_break_warns(tmp_path):
    run = hugoniot.run(problem(speed=1000.0), tmp_path / "run")
    assert any("more than 3 times" in str(text) for text in run.arrays("events")["text"])


def test_in_two_dimensions_the_same_impact_warns_of_the_same_regions(tmp_path):
    """Plates of copper between frictionless walls, in one dimension and as a strip of two zones across."""
    line = 'stop_time = "1.1 us"\n' + "".join(
        f'[[region]]\nname = "{name}"\nmaterial = "copper"\nfrom = "{a} mm"\nto = "{b} mm"\nzones = {20 * (b - a)}\nvelocity = "{v} m/s"\n'
        for name, a, b, v in (("flyer", 0, 1, 1500), ("plate", 1, 3, 0)))
    strip = 'geometry = "plane"\nstop_time = "1.1 us"\n' + "".join(
        f'[[block]]\nname = "{name}"\nmaterial = "copper"\nx = ["{a} mm", "{b} mm"]\ny = ["0 mm", "0.1 mm"]\nzones = [{20 * (b - a)}, 2]\n'
        f'velocity = ["{v} m/s", "0 m/s"]\n' for name, a, b, v in (("flyer", 0, 1, 1500), ("plate", 1, 3, 0)))
    strip += '[[boundary]]\non = ["flyer.bottom", "flyer.top", "plate.bottom", "plate.top"]\nkind = "wall"\n[solver]\nkind = "lagrange2d"\n'
    warned = []
    for name, text in (("line", line + '[[interface]]\nbetween = ["flyer", "plate"]\nkind = "bonded"\n'), ("strip", strip)):
        deck = read_deck_text(text + '[material.copper]\nbase = "copper"\nfracture = "none"\n[output]\nreport = false\n')
        texts = hugoniot.run(deck, tmp_path / name).arrays("events")["text"]
        warned.append({str(text).split("'")[1] for text in texts if "more than 3 times" in str(text)})
    assert warned[0] == warned[1] != set()
