"""LS-DYNA cards: the same pressures as its own formula, units, fields by columns and by commas, and what is refused."""

import tomllib

import pytest

from hugoniot.cli import main as front
from hugoniot.errors import DeckError
from hugoniot.laws.eos.contract import pressure
from hugoniot.materials.ls_dyna import material_tables, read_cards, scale_of, tension_note
from hugoniot.materials.read import build_material


def columns(*fields):
    """A card of fields ten columns wide."""
    return "".join(f"{field:>10}" for field in fields) + "\n"


def long_card(*fields):
    """A card of the long format, fields twenty columns wide."""
    return "".join(f"{field:>20}" for field in fields) + "\n"


STEEL = ("*KEYWORD\n*MAT_JOHNSON_COOK_TITLE\n4340 steel\n$      mid        ro         g\n" + columns(1, 7.83, 0.818)
         + columns("0.00792", "0.0051", 0.26, 0.014, 1.03, 1793.0, 294.0, "1e-6")
         + columns("4.77e-6", "-9.0", 2.0, 0.0, 0.05, 3.44, -2.12, 0.002) + columns(0.61)
         + "*EOS_GRUNEISEN\n1,0.4569,1.49,0.3,-0.2,2.17,0.46,0.0\n1.0\n*END\n")
TNT = "*MAT_008\n1,1.63,0.693,0.21\n*EOS_002\n1,3.712,0.03231,4.15,0.95,0.3,0.07,1.0\n"


def built(text, units="g cm us", **more):
    tables, left = material_tables(read_cards(text, "m.k"), scale_of(units), "m.k", **more)
    problems = []
    made = build_material("m", tables, problems, "m.k", lambda path: None)
    assert problems == []
    return made, left


def test_the_pressure_is_that_of_the_manuals_formula():
    """Compressed, in Mbar and per initial volume, with every constant at work."""
    steel, left = built(STEEL)
    c, s1, s2, s3, g, a = 0.4569, 1.49, 0.3, -0.2, 2.17, 0.46
    for mu, energy in ((0.02, 0.0), (0.1, 0.004), (0.25, 0.03)):
        below = 1.0 - (s1 - 1.0) * mu - s2 * mu**2 / (mu + 1.0) - s3 * mu**3 / (mu + 1.0) ** 2
        printed = 7.83 * c**2 * mu * (1.0 + (1.0 - 0.5 * g) * mu - 0.5 * a * mu**2) / below**2 + (g + a * mu) * energy
        assert float(pressure(7830.0 * (1.0 + mu), energy * 1e11 / 7830.0, steel.eos)) == pytest.approx(printed * 1e11, rel=1e-9)
    assert steel.strength.yield_stress == pytest.approx(0.792e9) and steel.strength.shear_modulus == pytest.approx(81.8e9)
    assert steel.strength.reference_rate == pytest.approx(1.0) and steel.eos.specific_heat == pytest.approx(477.0)
    assert any("D1 to D5" in text for text in left) and any("PC" in text for text in left)


def test_two_systems_of_units_give_one_material():
    cards = "*MAT_HIGH_EXPLOSIVE_BURN\n1,{},{}\n*EOS_JWL\n1,{},{},4.15,0.95,0.3,{},1.0\n"
    one, _ = built(cards.format("1.63", "0.693", "3.712", "0.03231", "0.07"))
    two, left = built(cards.format("1.63e-9", "6.93e6", "371200.0", "3231.0", "7000.0"), "tonne mm s")
    assert two.eos == pytest.approx(one.eos, rel=1e-12, nan_ok=True)
    assert any("6930 m/s" in text for text in left)


@pytest.mark.parametrize("first, mark", [("*KEYWORD LONG=Y\n", ""), ("*KEYWORD\n", "+"), ("*KEYWORD\n", " +")])
def test_the_long_format_has_fields_of_twenty_columns(first, mark):
    """A card written in both formats is one material; read in tens, C would be the blank or the next number."""
    card, v0 = (1, 0.4569, 1.49, 0.3, -0.2, 2.17, 0.46, 0.0), (1.0,)
    short, _ = built("*KEYWORD\n*EOS_GRUNEISEN\n" + columns(*card) + columns(*v0), density=7830.0)
    long, _ = built(f"{first}*EOS_GRUNEISEN{mark}\n" + long_card(*card) + long_card(*v0), density=7830.0)
    assert long.eos == pytest.approx(short.eos, nan_ok=True) and long.eos.c0 == pytest.approx(4569.0)
    back, _ = built("*KEYWORD LONG=Y\n*EOS_GRUNEISEN-\n" + columns(*card) + columns(*v0), density=7830.0)
    assert back.eos.c0 == pytest.approx(4569.0)


def test_a_density_is_given_once_and_temperatures_are_kelvin():
    with pytest.raises(DeckError, match="already gives the density"):
        built(STEEL, density=2000.0)
    assert not any("kelvin" in text for text in built(STEEL)[1])
    assert any("kelvin" in text for text in built(STEEL.replace("1793.0", "1520.0").replace("294.0", "20.0"))[1])


def test_the_note_on_tension_states_the_difference_of_the_two_laws():
    """Isentrope of the law at E = 0 against rho0 C^2 mu, by hand: eta (1 - a eta/2)(1 - ...)/(1 - a eta)^2, a = 4 s/3."""
    card = {"C": 0.4569}
    made, _ = built("*EOS_GRUNEISEN\n1,0.4569,1.49,0,0,2.17,0,0\n1.0\n", density=7830.0)
    eta, a = -0.02, 4.0 / 3.0 * 1.49      # a volume of 1.02
    cold = eta * (1.0 - 0.5 * a * eta) / (1.0 - a * eta) ** 2 - 2.17 * 0.5 * eta**2 / (1.0 - a * eta)
    less = 100.0 * (1.0 - cold / (-0.02 / 1.02))
    assert f"{less:.1f}% lower" in tension_note(card, made.eos, scale_of("g cm us"))


def test_numbers_of_keywords_and_a_density_of_the_user():
    assert built(TNT)[0].eos.rho0 == pytest.approx(1630.0)
    alone = TNT[TNT.index("*EOS"):]
    assert built(alone, density=1630.0)[0].eos.e0 == pytest.approx(7e9)
    with pytest.raises(DeckError, match="the density is not given"):
        built(alone)


@pytest.mark.parametrize("text, words", [
    ("*PART\n1,1\n", "one equation of state is needed"),
    ("*MAT_ELASTIC\n1,7.8\n" + TNT, "MAT_ELASTIC: this card is not supported"),
    (STEEL[:STEEL.index("   4.77e-6")] + STEEL[STEEL.index("*EOS"):], "ends before the line with CP"),
    (STEEL.replace(columns(1, 7.83, 0.818), columns(1, 7.83, 0.818, 0, 0, 0, 0, 3)), "RATEOP = 3 is not supported"),
    (STEEL + TNT[TNT.index("*EOS"):], r"found \*EOS_GRUNEISEN and \*EOS_JWL; supported: "),
    (STEEL.replace("0.4569", "&cs"), "parameters"),
    (STEEL.replace(",0.46,0.0", ",0.46,0.1"), "give the state in the region of the deck"),
    (STEEL + STEEL, "appears twice"),
    (STEEL.replace("0.46,0.0\n1.0\n", "0.46,0.0\n1.0,,7\n"), "energy deposition"),
    (STEEL[:STEEL.index("*EOS")] + "*EOS_GRUNEISEN\n" + long_card(1, 0.4569, 1.49, 0.0, 0.0, 2.17) + long_card(1.0), "beyond its 8 fields"),
])
def test_files_that_are_no_single_material(text, words):
    with pytest.raises(DeckError, match=words):
        built(text)


def test_the_command_writes_a_table_that_a_deck_takes(tmp_path, capsys):
    (tmp_path / "steel.k").write_text(STEEL)
    with pytest.raises(SystemExit) as ended:
        front.main(["import", str(tmp_path / "steel.k"), "--units", "g cm us", "--name", "steel"])
    out, err = capsys.readouterr()
    assert not ended.value.code and "omitted" in err
    assert tomllib.loads(out)["material"]["steel"]["eos"]["gamma_slope"] == 0.46
    with pytest.raises(SystemExit) as ended:
        front.main(["import", str(tmp_path / "steel.k"), "--units", "g cm"])
    assert ended.value.code == 2


def test_cards_are_checked_as_a_deck_would_be(tmp_path, capsys):
    """Constants that soften at 4 % of compression pass the laws' own checks; a deck with the material warns of it, and so does the import."""
    path = tmp_path / "soft.k"
    path.write_text(STEEL.replace("1,0.4569,1.49,0.3,-0.2", "1,0.4569,1.49,-200.0,0.0"))
    with pytest.raises(SystemExit):
        front.main(["import", str(path), "--units", "g cm us"])
    assert "its pressure falls with compression there" in capsys.readouterr().err
