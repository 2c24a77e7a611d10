"""Expressions between keys: what they give, with units, and everything that is no expression."""

import math

import pytest

from hugoniot.problem.arithmetic import Expression, Number, Trouble

KNOWN = {"region.flyer.to": Number(0.002, (1, 0, 0, 0, 0)), "region.back plate.to": Number(0.007, (1, 0, 0, 0, 0)),
         "speed": Number(700.0, (1, 0, -1, 0, 0)), "ratio": Number(1.5)}


def value(text):
    return Expression(text).value(KNOWN.__getitem__)


@pytest.mark.parametrize("text, number, unit", [
    ("region.flyer.to + 4 mm", 0.006, "m"),
    ("2 * (region.flyer.to - 1 mm) / 4", 0.0005, "m"),
    ('"region.back plate.to" - region.flyer.to', 0.005, "m"),
    ("region.flyer.to / speed", 0.002 / 700.0, "s"),
    ("0.5 * 2700 kg/m^3 * speed ** 2", 0.5 * 2700.0 * 700.0**2, "Pa"),
    ("sqrt(speed * speed)", 700.0, "m/s"),
    ("max(1 mm, region.flyer.to, 0.5 mm)", 0.002, "m"),
    ("min(ratio, 2)", 1.5, "1"),
    ("exp(log(2)) ** 3", 8.0, "1"),
    ("-abs(-ratio)", -1.5, "1"),
    ("1e-3 m + 2.5E-3 m", 0.0035, "m"),
    ("0.002 + 1 mm", 0.003, "m"),       # a bare number is SI
])
def test_expressions_have_values_and_units(text, number, unit):
    found = value(text)
    assert found.value == pytest.approx(number, rel=1e-14)
    assert found.unit() == unit


def test_a_value_goes_into_a_deck_with_its_unit():
    from hugoniot.units import parse

    for text, unit in (("region.flyer.to + 4 mm", "m"), ("2700 kg/m^3 * speed ** 2", "Pa"), ("speed / region.flyer.to", "1/s"),
                       ("8 J/kg/K * 3", "J/kg/K")):
        assert parse(value(text).text(), unit) == value(text).value
    assert value("ratio * 3").text() == 4.5
    zones = value("round(7.4 * ratio)").text()
    assert zones == 11 and isinstance(zones, int)


@pytest.mark.parametrize("text, words", [
    ("region.flyer.to + speed", "different kinds"),
    ("max(1 mm, 2 us)", "different kinds"),
    ("2 ** (1 mm)", "exponent"),
    ("sqrt(region.flyer.to)", "fractional unit"),
    ("log(speed)", "log needs a number without a unit"),
    ("1 / (ratio - 1.5)", "does not give a finite number"),
    ("log(0 - 1)", "does not give a finite number"),
    ("10.0 ** 400", "does not give a finite number"),
    ("2 furlongz", "unknown unit"),
    ("", "not an expression"),
    ("1 +", "not an expression"),
    ("f'{speed}'", "not an expression"),
    ("speed.real", "not given"),
    ("__import__('os')", "not allowed in an expression"),
    ("(lambda: 1)()", "not allowed in an expression"),
    ("[1, 2][0]", "not allowed in an expression"),
    ("speed if ratio else speed", "not allowed in an expression"),
    ("speed > 1", "not allowed in an expression"),
    ("ratio // 2", "this operator"),
    ("True + 1", "not allowed in an expression"),
    ("sqrt(2, 3)", "one value"),
    ("min(2)", "two to 20 values"),
    ("(" * 300 + "1" + ")" * 300, "expression"),
    ("1+" * 300 + "1", "more than 400"),
])
def test_what_is_no_expression_is_refused_in_words(text, words):
    def lookup(key):
        if key not in KNOWN:
            raise Trouble(f"'{key}' is not given")
        return KNOWN[key]

    with pytest.raises(Trouble, match=words):
        Expression(text).value(lookup)


def test_nothing_runs_and_towers_of_powers_end_at_once():
    with pytest.raises(Trouble):
        value("9.0**9**9**9")
    assert math.isclose(value("2 ** 10").value, 1024.0)
