"""What is varied and which cases that makes; everything that cannot be varied is refused in one sentence."""

import numpy as np
import pytest

from hugoniot.campaign.designs import design_of
from hugoniot.campaign.variables import read_variable
from hugoniot.errors import DeckError


def values(text):
    variable = read_variable(text)
    return [variable.step(k) for k in range(len(variable.values) or variable.count)]


@pytest.mark.parametrize("text, wanted", [
    ("region.flyer.velocity = 300..1200 m/s : 4", ["300.0 m/s", "600.0 m/s", "900.0 m/s", "1200.0 m/s"]),
    ("region.flyer.to = 900 um..2 mm : 2", ["0.9 mm", "2.0 mm"]),
    ("region.flyer.zones = 100..400 : 3", [100, 250, 400]),
    ("region.flyer.ratio = 1.0..1.2 : 3", [1.0, 1.1, 1.2]),
    ("x = 1..100 : 3 log", [1, 10, 100]),
    ("material.al.fracture.strength = 1, 2.5, 300 MPa", ["1.0 MPa", "2.5 MPa", "300.0 MPa"]),
    ("material.al.fracture.strength = 1 GPa, 300 MPa", ["1000.0 MPa", "300.0 MPa"]),
    ('region.flyer.material = "al", "copper"', ["al", "copper"]),
    ("title = 'one'", ["one"]),
    ("T = 20, 30 degC", ["20.0 degC", "30.0 degC"]),
])
def test_values(text, wanted):
    found = values(text)
    assert [type(v) for v in found] == [type(v) for v in wanted]
    assert all(v == w if isinstance(w, str) else v == pytest.approx(w, rel=1e-12) for v, w in zip(found, wanted))


def test_the_ends_of_a_range_are_exact():
    for text in ("a.b = 0.1..0.7 mm : 7", "a.b = 0.1..0.7 mm : 7 log"):
        found = values(text)
        assert found[0] == "0.1 mm" and found[-1] == "0.7 mm"


@pytest.mark.parametrize("text, words", [
    ("region.flyer.velocity", "expected KEY = VALUES"),
    ("= 3..4 m/s : 2", "expected KEY = VALUES"),
    ("a.b = 1200..300 m/s : 10", "an empty range"),
    ("a.b = 300..300 m/s : 10", "an empty range"),
    ("a.b = 300..1200 mm/ss : 10", "unknown unit"),
    ("a.b = 3 mm..4 us : 2", "not units of one kind"),
    ("a.b = 1..2 m : 1", "too few values in a range: 1"),
    ("a.b = 1..2 m : ten", "not a number of values"),
    ("a.b = 1..2 m : 10 20", "not a number of values"),
    ("a.b = 1..2 m :", "not a number of values"),
    ("a.b = 1..2 m : 99999999999999999999", "too many"),
    ("a.b = 0..2 m : 3 log", "above 0"),
    ("a.b = one..two", "not a quantity"),
    ('a.b = "al", 3', "text values and numbers"),
    ("a.b = 1 +- 0 GPa", "must be above 0"),
    ("a.b = 1e400..2 m : 2", "too large|not a quantity"),
])
def test_what_cannot_be_varied(text, words):
    with pytest.raises(DeckError, match=words) as found:
        read_variable(text)
    assert "--vary" in str(found.value) and "\n" not in str(found.value)


def test_a_grid_has_every_combination_the_last_parameter_fastest():
    grid = design_of([read_variable("a.b = 1..3 : 3"), read_variable('c.d = "x", "y"')])
    assert len(grid) == 6 and grid.shape == (3, 2)
    assert [grid.values(k) for k in range(4)] == [[1, "x"], [1, "y"], [2, "x"], [2, "y"]]


def test_samples_fill_the_ranges_and_come_again_with_their_seed():
    variables = [read_variable("a.b = 2..4 km/s"), read_variable("c.d = 1..100 : log"),
                 read_variable("e.f = 5 +- 0.5 GPa")]
    for kind in ("sobol", "lhs"):
        design = design_of(variables, kind, 256, seed=3)
        rows = np.array([[v.number(x) for v, x in zip(variables, design.values(k))] for k in range(256)])
        assert rows[:, 0].min() >= 2000.0 and rows[:, 0].max() <= 4000.0
        assert np.mean(rows[:, 0]) == pytest.approx(3000.0, abs=10.0)
        assert np.median(rows[:, 1]) == pytest.approx(10.0, rel=0.05)
        assert np.mean(rows[:, 2]) == pytest.approx(5e9, rel=2e-3) and np.std(rows[:, 2]) == pytest.approx(0.5e9, rel=0.03)
        again = design_of(variables, kind, 256, seed=3)
        assert [again.values(k) for k in range(256)] == [design.values(k) for k in range(256)]
        assert design_of(variables, kind, 256, seed=4).values(1) != design.values(1)


@pytest.mark.parametrize("texts, keywords, words", [
    (["a.b = 0..1 : 32000", "c.d = 0..1 : 31250"], {}, "1 000 000 000 cases .32000 x 31250. are too many"),
    (["a.b = 0..1"], {}, "a grid needs the number of values"),
    (["a.b = 0..1 : 3", "a.b = 2..3 : 3"], {}, "varied twice"),
    (["a.b = 0 +- 1"], {}, "a grid cannot contain a normal distribution"),
    (["a.b = 0..1"], {"kind": "sobol"}, "needs a number of cases"),
    (["a.b = 0..1"], {"kind": "sobol", "samples": 100}, "64 or 128"),
    (["a.b = 0..1"], {"kind": "lhs", "samples": 10**9}, "1 000 000 000 cases are too many"),
    (["a.b = 0..1"], {"kind": "lhs", "samples": 0}, "not a valid number of cases"),
    (["a.b = 0..1 : 3"], {"samples": 4}, "follows from its values"),
    (["a.b = 0..1 : 3"], {"kind": "magic"}, "unknown design"),
    ([], {}, "nothing is varied"),
])
def test_designs_that_are_refused(texts, keywords, words):
    with pytest.raises(DeckError, match=words):
        design_of([read_variable(text) for text in texts], **keywords)


def test_a_table_of_cases(tmp_path):
    path = tmp_path / "cases.csv"
    path.write_text("# mine\nregion.flyer.velocity [km/s], region.flyer.material\n0.3, al\n0.5, copper\n")
    design = design_of([], str(path))
    assert [design.values(k) for k in range(len(design))] == [["0.3 km/s", "al"], ["0.5 km/s", "copper"]]


@pytest.mark.parametrize("text, words", [
    ("region.flyer.velocity\n300\n", "the column has no unit; write 'region.flyer.velocity .m/s.'"),
    ("region.flyer.velocity [m/s]\nfast\n", "'fast' is not a number"),
    ("region.flyer.velocity [m/ss]\n3\n", "unknown unit"),
    ("a [m], b [m]\n3\n", "values: 1, column headers: 2"),
    ("a [m]\n", "needs a line of column headers"),
])
def test_tables_that_are_refused(tmp_path, text, words):
    path = tmp_path / "cases.csv"
    path.write_text(text)
    with pytest.raises(DeckError, match=words):
        design_of([], str(path))
