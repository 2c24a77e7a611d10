"""A deck finds users' own materials beside it or where an option says, and never a wrong one."""

import pytest

from hugoniot.cli import main as front
from hugoniot.errors import DeckError
from hugoniot.laws.eos.contract import EOS
from hugoniot.laws.fracture.contract import FRACTURE
from hugoniot.laws.strength.contract import STRENGTH
from hugoniot.materials.tables import accepted
from hugoniot.problem.deck import read_deck, read_deck_text

DECK = """
geometry = "planar"
stop_time = "1 us"
[[region]]
name = "flyer"
material = "{0}"
from = "0 mm"
to = "1 mm"
zones = 20
velocity = "500 m/s"
[[region]]
name = "target"
material = "copper"
from = "1 mm"
to = "3 mm"
zones = 40
"""
OWN = '[eos]\nlaw = "mie_gruneisen"\nrho0 = "2.7 g/cm^3"\nc0 = "5.2 km/s"\ns = 1.4\ngamma0 = 2.0\n'


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "deck.toml").write_text(DECK.format("my_alloy"))
    (tmp_path / "my_alloy.toml").write_text(OWN)
    return tmp_path


def test_beside_the_deck(folder):
    deck = read_deck(folder / "deck.toml")
    assert deck.problem.materials["my_alloy"].eos.c0 == 5200.0
    again = read_deck_text(deck.resolved)  # the resolved deck needs no file beside it
    assert again.problem.materials["my_alloy"].eos == deck.problem.materials["my_alloy"].eos


def test_in_a_folder_named_by_an_option(folder, tmp_path_factory, capsys):
    other = tmp_path_factory.mktemp("materials")
    (folder / "my_alloy.toml").rename(other / "my_alloy.toml")
    with pytest.raises(DeckError, match="my_alloy"):
        read_deck(folder / "deck.toml")
    assert read_deck(folder / "deck.toml", materials=[other]).problem.materials["my_alloy"].eos.c0 == 5200.0
    with pytest.raises(SystemExit) as ended:
        front.main(["check", str(folder / "deck.toml"), "--materials", str(other)])
    assert not ended.value.code and "my_alloy" in capsys.readouterr().out


def test_a_file_that_shadows_the_library_is_refused(folder):
    (folder / "copper.toml").write_text(OWN)
    with pytest.raises(DeckError, match="taken by the library"):
        read_deck(folder / "deck.toml")


def test_the_decks_own_table_comes_first_and_a_clash_with_an_option_is_refused(folder):
    text = DECK.format("my_alloy") + '[material.my_alloy.eos]\nlaw = "ideal_gas"\ngamma = 1.4\n'
    (folder / "deck.toml").write_text(text)
    assert read_deck(folder / "deck.toml").problem.materials["my_alloy"].laws()["eos"] == "ideal_gas"
    with pytest.raises(DeckError, match="taken by the deck"):
        read_deck(folder / "deck.toml", materials=[folder / "my_alloy.toml"])


@pytest.mark.parametrize("name", ["../my_alloy", "sub/my_alloy", "deck"])
def test_a_name_is_never_a_path(folder, name):
    (folder / "deck.toml").write_text(DECK.format(name))
    with pytest.raises(DeckError, match="unknown material"):
        read_deck(folder / "deck.toml")


def test_unverified_constants_are_told_before_a_run(folder):
    (folder / "deck.toml").write_text("lighting = [{at = 0.0}]\n" + DECK.format("octol"))
    assert any("octol" in w and "not checked against the printed source" in w for w in read_deck(folder / "deck.toml").warnings)


@pytest.mark.parametrize("registry, family", [(EOS, "eos"), (STRENGTH, "strength"), (FRACTURE, "fracture")])
def test_a_list_or_a_table_where_a_number_belongs_is_told_with_its_place(registry, family):
    """Every number of every law, and every law inside a law."""
    for law in registry:
        for key, example in zip(law.parameters._fields, law.example):
            if not isinstance(example, float) and not hasattr(example, "_fields") or key not in accepted(law)[0]:
                continue
            wrong = "1.0" if hasattr(example, "_fields") else "[1.0]"
            eos = "" if family == "eos" else OWN.replace("[eos]", "[material.odd.eos]")
            text = f'{DECK.format("odd")}{eos}[material.odd.{family}]\nlaw = "{law.name}"\n{key} = {wrong}\n'
            with pytest.raises(DeckError, match=rf"material\.odd\.{family}\.{key}: expected a "):
                read_deck_text(text)


def test_numbers_beyond_what_numbers_hold_leave_no_state():
    with pytest.raises(DeckError, match=r"material\.odd\.eos: these parameters give no reference state"):
        read_deck_text(DECK.format("odd") + OWN.replace("[eos]", "[material.odd.eos]").replace("2.7 g/cm^3", "1e-320 kg/m^3"))
