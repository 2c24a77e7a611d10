"""The line of every key, over everything TOML can put in the way."""

import tomllib

import pytest

from hugoniot.problem.lines import key_lines, line_finder

AWKWARD = '''# a comment = 1
title = """multi
line = 3
[x]
"quoted" ""\\"
"""
a.b = {c = [1, "x]", {d = 'q#'}], e = 2}
arr = [ # comment ]
  1.5,
  "z",
  [3, 4],
]
[[region]]
name = "a" # hi = 3
"from" = "0 mm"
[[region]]
name = "b"
[region.sub]
x = 1
[[region.deep]]
y = 1
[[region.deep]]
y = 2
[material.'al b'.eos]
law = \'\'\'x
\'\'\'
rho = 3
last = 1979-05-27T07:32:00Z'''

EXPECTED = {
    ("title",): 2, ("a", "b"): 7, ("a", "b", "c", 2, "d"): 7, ("arr",): 8, ("arr", 0): 9, ("arr", 2, 0): 11, ("region", 0): 13,
    ("region", 0, "name"): 14, ("region", 0, "from"): 15, ("region", 1): 16, ("region", 1, "name"): 17, ("region", 1, "sub", "x"): 19,
    ("region", 1, "deep", 0, "y"): 21, ("region", 1, "deep", 1, "y"): 23, ("material", "al b", "eos"): 24,
    ("material", "al b", "eos", "law"): 25, ("material", "al b", "eos", "rho"): 27, ("material", "al b", "eos", "last"): 28,
}


def paths(value, here=()):
    """Every path of a parsed text."""
    if here:
        yield here
    if isinstance(value, dict):
        for key, inner in value.items():
            yield from paths(inner, (*here, key))
    elif isinstance(value, list):
        for index, inner in enumerate(value):
            yield from paths(inner, (*here, index))


def test_the_lines_of_an_awkward_text():
    found = key_lines(AWKWARD)
    assert {path: found[path] for path in EXPECTED} == EXPECTED


def test_every_key_the_parser_finds_has_a_line():
    found = key_lines(AWKWARD)
    assert set(paths(tomllib.loads(AWKWARD))) == set(found)


def test_windows_line_ends_count_once():
    assert key_lines("a = 1\r\nb = 2\r\n[c]\r\nd = 3\r\n") == {("a",): 1, ("b",): 2, ("c",): 3, ("c", "d"): 4}


@pytest.mark.parametrize("path, line", [
    (("region", 0, "missing"), 13), (("region", 7), 13), (("material", "al b", "eos", "c0"), 24), (("nothing",), None),
])
def test_a_missing_key_is_placed_at_the_table_around_it(path, line):
    assert line_finder(AWKWARD)(path) == line


def test_a_text_that_is_not_toml_has_no_lines_but_does_no_harm():
    assert line_finder("][ = \"")(("a",)) is None
