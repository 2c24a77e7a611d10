"""The package as a new user meets it in Python: what can be found by looking, and what is said to the wrong kind of input."""

import inspect

import numpy as np
import pytest

import hugoniot
from hugoniot.errors import DeckError, FileTrouble, OutOfRange
from hugoniot.laws.eos.contract import EOS
from hugoniot.problem.deck import read_deck_text
from hugoniot.theory.hugoniot import curve, shock
from hugoniot.theory.impedance import match
from hugoniot.theory.isentrope import state

DECK = ('stop_time = "1 us"\n[[region]]\nname = "a"\nmaterial = "copper"\nfrom = "0 mm"\nto = "1 mm"\nzones = 10\n')


def test_everything_public_is_found_and_explained():
    assert set(hugoniot.__all__) <= set(dir(hugoniot))
    for name in set(hugoniot.__all__) - {"__version__"}:
        thing = getattr(hugoniot, name)
        assert inspect.getdoc(thing) and f"`{name}`" in hugoniot.__doc__
        members = [m for m, value in vars(thing).items() if not m.startswith("_") and (callable(value) or isinstance(value, property))]
        assert all(inspect.getdoc(getattr(thing, m)) for m in members), name
    with pytest.raises(AttributeError, match="no attribute 'runn'"):
        _ = hugoniot.runn


@pytest.mark.parametrize("wrong", [5, None, {}, ["flyer.toml"], b"flyer.toml"])
def test_what_is_no_deck_is_told(wrong):
    with pytest.raises(TypeError, match="give the path of a deck, a Deck or a Problem, not "):
        hugoniot.run(wrong)


def test_a_deck_that_is_read_takes_no_changes():
    with pytest.raises(DeckError, match="run: stop_time: changes cannot be made to a deck that has been read"):
        hugoniot.run(read_deck_text(DECK), stop_time="2 us")
    with pytest.raises(FileTrouble, match="no such deck"):
        hugoniot.run("missing.toml", stop_time="2 us")


def test_tools_name_what_they_were_not_given():
    for tool in (shock, curve, state):
        with pytest.raises(TypeError, match=r"'copper' is neither a material nor the parameters of a law; hugoniot\.materials\.library\.find"):
            tool("copper", pressure=1e9) if tool is not curve else tool("copper")
    copper = hugoniot.materials.library.find("copper")
    with pytest.raises(OutOfRange, match="needs points = 2 or more, got 0"):
        curve(copper, points=0)
    assert np.all(np.diff(curve(copper, points=2).pressure) > 0.0)


@pytest.mark.parametrize("name", EOS.names())
def test_values_that_are_no_state_are_refused_in_words(name):
    """Of every law, never an exception of arithmetic or a missing function."""
    par = EOS.get(name).example
    for asked in ({"density": 0.0, "temperature": 300.0}, {"density": 1000.0, "temperature": -1.0}, {"density": np.nan, "pressure": 1e9}):
        with pytest.raises(OutOfRange):
            state(par, **asked)
    if "temperature" not in EOS.get(name).functions:
        with pytest.raises(OutOfRange, match="has no temperature"):
            state(par, temperature=300.0, energy=1e5)
    for asked in ({"density": 0.0}, {"shock_velocity": 0.0}, {"pressure": np.nan}):
        with pytest.raises(OutOfRange):
            shock(par, **asked)
    with pytest.raises(OutOfRange, match="positive impact velocity"):
        match([par, par], np.nan)
