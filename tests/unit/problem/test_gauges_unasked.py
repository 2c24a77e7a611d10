"""Gauges that are recorded unasked are part of the problem, so that the deck of a run folder is the whole of it."""

import csv
import dataclasses

import pytest

from hugoniot import simulate
from hugoniot.errors import DeckError
from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.materials.material import Material
from hugoniot.problem.deck import read_deck, read_deck_text
from hugoniot.problem.defaults import completed
from hugoniot.problem.model import Boundary, Gauge, OutputOptions, Problem, Region

DECK = """
title = "two gases"
stop_time = 1e-4
[[region]]
name = "a"
material = "gas"
from = 0.0
to = 1.0
zones = 4
density = 1.0
pressure = "1 bar"
[[region]]
name = "2nd"
material = "gas"
from = 1.0
to = 2.0
zones = 4
density = 1.0
pressure = "1 bar"
[[gauge]]
name = "contact"
at = "a/2nd"
[boundary]
right = "fixed"
[material.gas.eos]
law = "ideal_gas"
gamma = 1.4
"""
ASKED, SIDES = Gauge("contact", "a/2nd"), (Gauge("contact left", "a:right"), Gauge("contact right", "2nd:left"))


def problem(**changes):
    gas = Material("gas", IdealGas(1.4, 1.0, 717.5))
    regions = (Region("a", "gas", 1.0, 2.0, 4, density=1.0, pressure=1e5), Region("2nd", "gas", 2.0, 3.0, 4, density=1.0, pressure=1e5))
    made = Problem("two gases", "planar", 1e-4, regions, {"gas": gas}, right=Boundary("fixed"), gauges=(ASKED,),
                   output=OutputOptions(report=False))
    return dataclasses.replace(made, **changes)


@pytest.mark.parametrize("name, at", (("contact left", "0.5 m"), ("contact right", "a:right"), ("free surface left", "1.5 m")))
def test_the_name_of_an_automatic_gauge_belongs_to_its_place(name, at):
    """What is computed from the gauges beside an interface and on the ends would be computed from another place, or crash."""
    with pytest.raises(DeckError, match=f"the name '{name}' belongs to a gauge at"):
        read_deck_text(DECK + f'[[gauge]]\nname = "{name}"\nat = "{at}"\n')
    read_deck_text(DECK + '[[gauge]]\nname = "contact left"\nat = "a:right"\n[[gauge]]\nname = "free surface left"\nat = "0 m"\n')


@pytest.mark.parametrize("at, place", (("1 m", "a/2nd"), ("0.99999999999999 m", "a/2nd"), ("0 m", "a:left"), ("2 m", "2nd:right"),
                                       ("0.999999 m", 0.999999)))
def test_a_gauge_given_by_the_coordinate_of_a_face_is_on_that_face(at, place):
    """At an interface it would otherwise give the density and temperature of the right-hand body as those of both."""
    found = read_deck_text(DECK.replace('at = "a/2nd"', f'at = "{at}"')).problem
    assert found.gauges[0] == Gauge("contact", place)
    own = dataclasses.replace(found, gauges=(Gauge("contact", float(at.split()[0])),))      # of a Problem made in Python as well
    assert completed(own) == found
    assert ("contact left" in {gauge.name for gauge in found.gauges}) == (place == "a/2nd")


def test_free_ends_and_both_sides_of_interfaces_are_gauged():
    free = Boundary("free")
    assert completed(problem()).gauges == (ASKED, *SIDES, Gauge("free surface left", "free surface left"))
    assert completed(problem(geometry="spherical", right=free)).gauges == (ASKED, *SIDES, Gauge("free surface right", "free surface right"))


def test_what_is_gauged_already_is_not_gauged_again():
    own = (Gauge("front", "free surface left"), Gauge("contact left", 1.5), ASKED)
    assert completed(problem(gauges=own)).gauges == (*own, SIDES[1])


@pytest.mark.parametrize("changes", [{}, {"geometry": "spherical"}, {"gauges": ()}, {"gauges": (Gauge("contact right", 2.5), ASKED)}])
def test_a_complete_problem_is_its_own(changes):
    whole = completed(problem(**changes))
    assert completed(whole) == whole


def test_the_resolved_deck_holds_them_and_resolves_to_itself():
    first = read_deck_text(DECK)
    assert first.problem.gauges == (ASKED, *SIDES, Gauge("free surface left", "free surface left"))
    again = read_deck_text(first.resolved)
    assert again.problem == first.problem and again.resolved == first.resolved


def test_the_deck_of_a_run_folder_is_the_whole_problem(tmp_path):
    """The columns of gauges.csv are the gauges of deck.toml, whether a deck was run or a Problem."""
    for k, asked in enumerate((problem(), read_deck_text(DECK.replace("[material", "[output]\nreport = false\n[material")))):
        folder = tmp_path / f"{k}.run"
        simulate.run(asked, folder)
        deck = read_deck(folder / "deck.toml")
        names = [gauge.name for gauge in deck.problem.gauges]
        with open(folder / "gauges.csv", newline="") as file:
            header = next(row for row in csv.reader(file) if row and not row[0].startswith("#"))
        assert names == ["contact", "contact left", "contact right", "free surface left"]
        assert all(any(column.startswith(name) for column in header) for name in names)
        assert deck.resolved == (folder / "deck.toml").read_text()
        assert completed(deck.problem) == deck.problem


def test_a_name_too_long_for_its_sides_is_refused():
    text = DECK.replace('name = "contact"', f'name = "{"c" * 54}"')
    assert read_deck_text(read_deck_text(text).resolved).problem.gauges[2].name == "c" * 54 + " right"
    with pytest.raises(DeckError, match="too long a name for a gauge at an interface"):
        read_deck_text(DECK.replace('name = "contact"', f'name = "{"c" * 55}"'))


def test_gauges_beyond_the_limit_are_refused_with_those_added():
    """The gauge at the interface brings its two sides, the free end brings one."""
    def rows(count):
        return "".join(f'[[gauge]]\nname = "g{k}"\nat = 0.5\n' for k in range(count))

    assert len(read_deck_text(DECK + rows(9_996)).problem.gauges) == 10_000
    with pytest.raises(DeckError, match="10001 gauges are too many"):
        read_deck_text(DECK + rows(9_997))
