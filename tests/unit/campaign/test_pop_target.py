"""Pop plots as records of a fit: read with their units, fitted beside other records or alone, and refused where they make no sense."""

import dataclasses
import pathlib

import numpy as np
import pytest

from hugoniot.campaign import pop_target
from hugoniot.campaign.pop_plot import Initiation
from hugoniot.campaign.pop_target import ROOM, distances, is_pop_plot, read_pop_plot, run_distance
from hugoniot.campaign.questions import Deck, question_of
from hugoniot.campaign.run_fit import FitWishes, run_fit
from hugoniot.errors import DeckError
from hugoniot.materials import library

DECK = (pathlib.Path(__file__).parents[3] / "examples" / "initiation.toml").read_text()
RATE = "material.LX-17 reactive.burn.g1"
PRESSURES = [15e9, 18e9]


def written(path, rows, head="pressure [GPa], distance [mm], distance sigma [mm]"):
    path.write_text(head + "\n# a remark\n" + "".join(", ".join(map(repr, row)) + "\n" for row in rows))
    return str(path)


def test_a_sigma_of_the_wrong_kind_is_an_error_of_its_option(tmp_path):
    path = written(tmp_path / "pop.csv", [(18, 1.75), (12, 5.5)], head="pressure [GPa], distance [mm]")
    with pytest.raises(DeckError, match="command line: --sigma: expected a length"):
        read_pop_plot(path, 1, "5 us", [])


@pytest.fixture
def coarse(tmp_path, monkeypatch):
    """A deck whose own run is short, and run distances of some 60 zones."""
    monkeypatch.setattr(pop_target, "ZONES", 60)
    deck = tmp_path / "charge.toml"
    deck.write_text(DECK.replace('"20 mm"', '"2 mm"').replace('"16 um"', '"100 um"').replace("2.4 us", "0.25 us").replace('"15 mm"', '"1.5 mm"'))
    return deck


def test_a_pop_plot_is_read_in_rising_order(tmp_path):
    notes: list[str] = []
    path = written(tmp_path / "pop.csv", [(18, 1.75, 0.1), (12, 5.5, 0.3)])
    found = read_pop_plot(path, 1, None, notes)
    assert is_pop_plot(path) and not notes and found.name == "pop plot 1.distance"
    assert np.allclose(found.time, [12e9, 18e9]) and np.allclose(found.values, [5.5e-3, 1.75e-3]) and np.allclose(found.sigma, [3e-4, 1e-4])
    model = np.array([5.5e-3, 1.75e-3]) * [1.1, 1.0]
    assert found.beside(model) == pytest.approx([np.log(1.1) * 5.5 / 0.3, 0.0])
    bare = read_pop_plot(written(tmp_path / "bare.csv", [(18, 1.75)], "pressure [GPa], distance [mm]"), 2, None, notes)
    assert bare.sigma == pytest.approx([0.05 * 1.75e-3]) and "5 % of each run distance" in notes[0]


@pytest.mark.slow
def test_the_rate_behind_a_pop_plot_is_found_again(coarse, tmp_path, inline):
    wanted = distances(library.find("LX-17 reactive"), PRESSURES, [2.9e-3, 1.75e-3])
    path = written(tmp_path / "pop.csv", [(p * 1e-9, x * 1e3, 0.03 * x * 1e3) for p, x in zip(PRESSURES, wanted)])
    wishes = FitWishes([path], [f"{RATE} = 2e-24..9e-24 : log"], starts=1, local=True)
    found = run_fit(coarse, wishes, tmp_path / "f", engine=inline)
    rate = found.fit.parameters[0]
    assert rate.low < 4.5e-24 < rate.high and abs(rate.value / 4.5e-24 - 1.0) < 0.05 and found.fit.matches
    assert "run distance" in (tmp_path / "f" / "report.html").read_text() and "4." in found.deck


@pytest.mark.slow
def test_a_pop_plot_counts_beside_a_gauge(coarse, tmp_path, inline):
    wanted = distances(library.find("LX-17 reactive"), PRESSURES[:1], [2.9e-3])
    path = written(tmp_path / "pop.csv", [(15.0, wanted[0] * 1e3, 0.1)])
    wishes = FitWishes([path, "1 mm.arrival = 0.19 +- 0.02 us"], [f"{RATE} = 4.4e-24..4.6e-24"], starts=1, local=True)
    found = run_fit(coarse, wishes, False, engine=inline)
    assert [t.name for t in found.targets] == ["1 mm.arrival", "pop plot 1.distance"] and found.fit.freedom == 1
    assert found.models[1][0] == pytest.approx(wanted[0], rel=0.05)


def test_a_case_answers_pop_plots_beside_its_own_run(coarse):
    pops = [([15e9], [2.9e-3])]
    asked = {"text": coarse.read_text(), "name": "charge", "pops": pops}
    both, alone = Deck(**asked).answer({}), Deck(**asked, run=False).answer({})
    assert "1 mm.arrival" in both["numbers"] and alone["numbers"] == {} and both["key"] != alone["key"]
    assert both["records"] == alone["records"] and alone["records"]["pop plot 1.distance"][0] == pytest.approx(2.9e-3, rel=0.3)
    again = question_of(Deck(**asked, run=False).record())
    assert again.answer({})["key"] == alone["key"]


@pytest.mark.parametrize("head, row, words", [
    ("pressure [GPa], distance", (15, 3), "'distance' has no unit"), ("pressure [GPa], run [mm]", (15, 3), "not a column of a Pop plot"),
    ("pressure [mm], distance [mm]", (15, 3), "GPa|pressure|kind|unit"), ("pressure [GPa], distance [mm]", (15, -3), "above 0"),
    ("pressure [GPa], distance [mm]", (15, 3, 4), "values: 3, column headers: 2")])
def test_bad_pop_plots_are_refused(coarse, tmp_path, inline, head, row, words):
    path = written(tmp_path / "pop.csv", [row], head)
    with pytest.raises(DeckError, match=words) as found:
        run_fit(coarse, FitWishes([path], [f"{RATE} = 4e-24..5e-24"]), False, engine=inline)
    assert len(found.value.problems) == 1


def test_a_deck_without_an_explosive_and_options_of_gauges_are_refused(deck, coarse, tmp_path, inline):
    path = written(tmp_path / "pop.csv", [(15, 3, 0.1)])
    with pytest.raises(DeckError, match="a Pop plot needs an explosive with a rate law"):
        run_fit(deck, FitWishes([path], ["region.flyer.velocity = 600..800 m/s"]), False, engine=inline)
    with pytest.raises(DeckError, match="--free 'region.charge.zone_size': has no effect on a Pop plot"):
        run_fit(coarse, FitWishes([path], ["region.charge.zone_size = 10..20 um"]), False, engine=inline)
    with pytest.raises(DeckError, match="--free 'material.LX-18 reactive.burn.g1': the deck has no material 'LX-18 reactive'"):
        run_fit(coarse, FitWishes([path], ['material."LX-18 reactive".burn.g1 = 4e-24..5e-24']), False, engine=inline)
    with pytest.raises(DeckError, match="has no effect on a Pop plot, only on records in time; leave out --"):
        run_fit(coarse, FitWishes([path], [f"{RATE} = 4e-24..5e-24"], shift="20 ns"), False, engine=inline)


def test_a_charge_that_detonates_at_once_ran_less_than_wanted():
    """Neither has a run distance: that of the one is far shorter than what is wanted, that of the charge that does not detonate far longer."""
    without = Initiation(17e9, 1e3, 5e3, np.nan, np.nan, 0, (np.zeros(0), np.zeros(0)))
    assert run_distance(dataclasses.replace(without, at_once=True), 1e-3) == pytest.approx(1e-3 / ROOM)
    assert run_distance(without, 1e-3) == pytest.approx(1e-3 * ROOM)
