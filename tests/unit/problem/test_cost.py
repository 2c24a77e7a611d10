"""The estimate of memory and disk that `hugoniot check` prints, against runs."""

import json

import pytest

from hugoniot import simulate
from hugoniot.cli.main import main
from hugoniot.materials import library
from hugoniot.problem import catalogue
from hugoniot.problem.cost import estimate
from hugoniot.problem.deck import read_deck_text
from hugoniot.theory.impedance import match


@pytest.mark.parametrize("fields", ["", '["pressure", "density"]'])
def test_the_snapshots_of_a_result_have_the_size_that_was_estimated(tmp_path, fields):
    text = catalogue.deck_text("sod").replace("zones = 100", "zones = 400")
    (tmp_path / "deck.toml").write_text(text)
    changes = {"output.report": False} | ({"output.fields": json.loads(fields)} if fields else {})
    run = simulate.run(tmp_path / "deck.toml", tmp_path / "run", **changes)
    rows = run.arrays("snapshots")
    size = sum(values.nbytes for values in rows.values() if values.ndim == 2)
    cost = estimate(read_deck_text(run.deck).problem)
    assert cost.zones == 800 and cost.snapshots == len(rows["time"])
    assert cost.result == pytest.approx(size, rel=0.3)


def test_a_million_zones_with_a_hundred_snapshots_are_expected_to_need_less_than_three_gigabytes(tmp_path, capsys):
    (tmp_path / "deck.toml").write_text(
        'stop_time = "1 us"\n[[region]]\nname = "a"\nmaterial = "copper"\nfrom = "0 m"\nto = "1 m"\nzones = 1000000\n')
    with pytest.raises(SystemExit):
        main(["check", str(tmp_path / "deck.toml"), "--json"])
    told = json.loads(capsys.readouterr().out)["estimate"]
    assert told["memory"] < 3e9 and 1e10 < told["result"] < 2e10
    with pytest.raises(SystemExit):
        main(["check", str(tmp_path / "deck.toml")])
    assert "1000000 zones, 101 snapshots: about 1.2 GB of memory, result.h5 about 11 GB" in capsys.readouterr().out


FAST = """stop_time = "1 us"
[[region]]
name = "a"
material = "own"
from = 0.0
to = 1e-3
zones = 10
velocity = {velocity}
[[region]]
name = "b"
material = "own"
from = 1e-3
to = 2e-3
zones = 10
[material.own.eos]
"""
FAST_BLOCKS = """geometry = "plane"
stop_time = "1 us"
solver.kind = "lagrange2d"
[[block]]
name = "a"
material = "own"
x = [0.0, 1e-3]
y = [0.0, 1e-3]
zones = [4, 4]
velocity = [{velocity}, 0.0]
[[block]]
name = "b"
material = "own"
x = [1e-3, 2e-3]
y = [0.0, 1e-3]
zones = [4, 4]
[material.own.eos]
"""
SOLID = 'law = "mie_gruneisen"\nrho0 = 2700.0\nc0 = 5200.0\ns = 1.5\ngamma0 = 2.0\n'
GAS = 'law = "ideal_gas"\ngamma = 1.4\nrho0 = 1.2\n'


@pytest.mark.parametrize("law, velocity, warned", [(SOLID, 50e3, True), (SOLID, 10e3, False), (GAS, 1e8, True), (GAS, 3e3, False)])
def test_speeds_that_ionise_a_material_without_a_stated_range_are_warned_of(law, velocity, warned):
    """50 km/s of aluminium give 312 MJ/kg, 87 eV for each atom."""
    for deck in (FAST, FAST_BLOCKS):
        warnings = read_deck_text(deck.format(velocity=velocity) + law).warnings
        assert any("its atoms are ionised" in words for words in warnings) == warned



@pytest.mark.parametrize("velocity, warned", [(1e8, True), (1e5, False)])
def test_speeds_beside_that_of_light_are_warned_of(velocity, warned):
    """A part of one body alone moves: nothing meets anything."""
    for deck in (FAST, FAST_BLOCKS):
        warnings = read_deck_text(deck.format(velocity=velocity) + GAS).warnings
        assert any("not relativistic" in words for words in warnings) == warned


@pytest.mark.parametrize("deck, solver, warned", [
    (FAST, "solver.courant = 0.9", True), (FAST, "solver.courant = 0.6", False), (FAST, "", False),
    (FAST, 'solver = {{integrator = "wilkins", courant = 1.0}}', True), (FAST_BLOCKS, "solver.courant = 0.6", True),
    (FAST_BLOCKS, "solver.courant = 0.4", False)])
def test_steps_with_which_shocks_overshoot_are_warned_of(deck, solver, warned):
    warnings = read_deck_text(f"{solver}\n{deck}".format(velocity=300.0) + SOLID).warnings
    assert any("overshoot and ring" in words for words in warnings) == warned


def test_blocks_faster_than_the_data_of_their_material_are_warned_of():
    text = FAST_BLOCKS.partition("[material")[0].replace('"own"', '"copper"')
    assert any("'a' moves at 40000 m/s relative to 'b'; their impact would drive 'copper' to a particle velocity of about 2e+04 m/s, but the data of 'copper' end at" in words for words in read_deck_text(text.format(velocity=4e4)).warnings)
    assert not any("data of" in words for words in read_deck_text(text.format(velocity=300.0)).warnings)


def test_of_two_materials_the_one_that_the_impact_drives_beyond_its_data_is_named():
    """Tantalum hits PMMA at 7 km/s: the match of the Hugoniots has 1.0 km/s in the metal, whose data end at 2.3, and 6.0 in the plastic."""
    blocks = "".join(f'[[block]]\nname = "{name}"\nmaterial = "{material}"\nx = [{x}e-3, {x + 1}e-3]\ny = [0.0, 1e-3]\nzones = [4, 4]\n{more}\n'
                     for name, material, x, more in (("rod", "tantalum", 0, "velocity = [7000.0, 0.0]"), ("plate", "pmma", 2, "")))
    told = read_deck_text(f'geometry = "plane"\nstop_time = "1 us"\nsolver.kind = "lagrange2d"\n{blocks}').warnings
    met = match([library.find("tantalum"), library.find("pmma")], 7000.0)[0].particle_velocity
    assert len(told) == 1 and "data of 'pmma'" in told[0] and f"about {met:.3g} m/s" in told[0]
