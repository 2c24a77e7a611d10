"""Users' own materials: the library's schema, units anywhere, nothing shadowed silently, every error with its place."""

import pytest

from hugoniot.dossier import checks
from hugoniot.dossier.describe import described
from hugoniot.dossier.wording import reference_name
from hugoniot.errors import DeckError, FileTrouble
from hugoniot.materials import library, users
from hugoniot.materials.reach import reach
from hugoniot.materials.record import material_record
from hugoniot.materials.users import read_materials

ALLOY = """
title = "My alloy"
valid_up_to = "2.5 km/s"
missing = ["spall"]
[eos]
law = "mie_gruneisen"
reason = "measured here"
others = ["U003"]
rho0 = { value = "2.71 g/cm^3", source = "our laboratory, 2024", status = "verified" }
c0 = "5.3 km/s"
s = 1.36
gamma0 = "U003.gamma0"
specific_heat = "U003.heat_capacity"
[strength]
row = "S003"
yield_stress = "310 MPa"
"""


@pytest.fixture
def alloy(tmp_path):
    path = tmp_path / "my_alloy.toml"
    path.write_text(ALLOY)
    return path


def test_a_file_in_the_librarys_schema(alloy):
    entry = users.user_materials([alloy])["my_alloy"]
    assert entry.title == "My alloy" and entry.reasons["eos"] == "measured here" and entry.others["eos"] == ("U003",)
    par = entry.material.eos
    assert (par.rho0, par.c0, par.s, par.gamma0) == (2710.0, 5300.0, 1.36, 1.97)
    assert par.specific_heat == pytest.approx(885.0 / (1.0 + 1.97 ** 2 * 885.0 * 298.15 / 5300.0 ** 2), rel=1e-12)
    assert entry.material.strength.yield_stress == 310e6 and entry.material.strength.shear_modulus == 27.6e9
    assert entry.material.valid_up_to == 2500.0
    said = {r["quantity"]: r for r in material_record(entry.material)}
    assert said["eos.rho0"]["source"] == "our laboratory, 2024"
    assert said["eos.c0"]["status"] == "user" and said["eos.c0"]["mark"] == "user's own value"
    assert said["strength.shear_modulus"]["source"].startswith("Steinberg")
    findings = list(checks.check_entry(entry))
    assert not [f for f in findings if f.verdict == "fail"]
    assert any(f.check == "source" and "eos.c0" in f.text for f in findings)


def test_tables_as_in_a_deck_and_overriding_a_library_material(tmp_path):
    path = tmp_path / "several.toml"
    path.write_text('[material.stiff_copper]\nbase = "copper"\n[material.stiff_copper.eos]\nc0 = "4 km/s"\n'
                    '[material.gas.eos]\nlaw = "ideal_gas"\ngamma = 1.3\n')
    found = users.user_materials([tmp_path])
    assert set(found) == {"stiff_copper", "gas"}
    assert found["stiff_copper"].material.eos.c0 == 4000.0
    row = next(r for r in material_record(found["stiff_copper"].material) if r["quantity"] == "eos.c0")
    assert row["value"] == 4000.0 and "Steinberg" not in row["source"]


@pytest.mark.parametrize("name", ["copper", "Cu", "aluminium_6061"])
def test_a_name_of_the_library_is_refused(tmp_path, name):
    (tmp_path / "mine.toml").write_text(f'[material."{name}".eos]\nlaw = "ideal_gas"\ngamma = 1.4\n')
    with pytest.raises(DeckError, match="taken by the library"):
        users.user_materials([tmp_path])


def test_the_same_name_in_two_files_or_in_the_deck_is_refused(tmp_path):
    for file in ("a.toml", "b.toml"):
        (tmp_path / file).write_text('[material.mine.eos]\nlaw = "ideal_gas"\ngamma = 1.4\n')
    with pytest.raises(DeckError, match=r"b\.toml.*taken by .*a\.toml"):
        users.user_materials([tmp_path])
    with pytest.raises(DeckError, match="taken by the deck"):
        users.user_materials([tmp_path / "a.toml"], beside=["Mine"])


def test_decks_in_the_folder_are_left_alone(tmp_path, alloy):
    (tmp_path / "deck.toml").write_text('geometry = "planar"\n[material.al.eos]\nlaw = "nonsense"\n')
    assert set(users.user_materials([tmp_path])) == {"my_alloy"}


def test_errors_name_file_line_and_key(tmp_path):
    path = tmp_path / "bad.toml"
    path.write_text('[eos]\nlaw = "mie_gruneisen"\nrho0 = "2700 kg/m^2"\nc0 = "5 km/s"\ns = 1.4\n[strength]\nrow = "S999"\n')
    with pytest.raises(DeckError) as caught:
        users.read_materials(path)
    text = str(caught.value)
    assert f"{path}:3" in text and "rho0" in text and f"{path}:7" in text and "S999" in text and "gamma0" in text


@pytest.mark.parametrize("text, words", [
    ("title = 'nothing'\n", "describes no material"), ("material = 3\n", "a material must be a table"), ("[eos\n", "TOML"),
    ('[eos]\nlaw = "ideal_gas"\ngamma = {value = 1.4, surce = "x"}\n', "surce"),
    ('[eos]\nlaw = "ideal_gas"\ngamma = {value = 1.4, status = "sure"}\n', "unknown status"),
    ('[eos]\nrow = "U160"\n', "exponential|ulh"), ('[eos]\nrow = "U184"\n', "no density"),
    ('[eos]\nrow = "U007"\ngamma0 = "U116.gamma0"\n', "no value"),
    ('[eos]\nrow = "U007"\n[detonation]\nspeed = 3\n', "speed")])
def test_what_is_wrong_is_said(tmp_path, text, words):
    path = tmp_path / "mine.toml"
    path.write_text(text)
    with pytest.raises(DeckError, match=words):
        users.read_materials(path)


def test_a_recalled_value_carries_its_mark(tmp_path):
    path = tmp_path / "mine.toml"
    path.write_text('[eos]\nlaw = "ideal_gas"\ngamma = {value = 1.31, source = "from memory", status = "recalled"}\n')
    (entry,) = users.read_materials(path).values()
    assert any("not checked against the printed source" in w for w in entry.material.warnings)


def test_finding_among_both(alloy):
    own = users.user_materials([alloy])
    assert users.find("My Alloy", own).name == "my_alloy"
    assert users.find("Cu", own).name == "copper"
    with pytest.raises(library.UnknownMaterial, match="my_alloy"):
        users.find("my_aloy", own)


def test_a_place_that_is_not_there(tmp_path):
    with pytest.raises(FileTrouble, match="no file or folder"):
        users.user_materials([tmp_path / "nowhere"])


def test_tables_a_saved_problem_holds_read_back_with_their_sources(tmp_path):
    from hugoniot.materials.tables import material_tables
    from hugoniot.problem.write import to_toml
    path = tmp_path / "saved.toml"
    path.write_text(to_toml({"material": {"mine": material_tables(library.find("copper"))}}))
    (entry,) = users.read_materials(path).values()
    mine, theirs = material_record(entry.material), material_record(library.find("copper"))
    assert entry.material.eos == library.find("copper").eos
    assert {(r["quantity"], r["source"]) for r in mine} == {(r["quantity"], r["source"]) for r in theirs}


@pytest.mark.parametrize("text", [
    "missing = 3", "aliases = 5", "category = 1", "notes = {a = 1}", "unreacted = 'x'", "detonation = 3", "valid_up_to = [1]", "base = 3",
    "[eos]\nothers = [3]", "[eos]\nothers = 3", "[eos]\nrow = 5", "[eos]\nc0 = {value = []}", "[eos]\nc0 = []", "[eos]\nc0 = true",
    "[eos]\nc0 = 'S007.yield_stress'", "[eos]\nspecific_heat = 'U116.heat_capacity'", "[eos]\nspecific_heat = 'U999.heat_capacity'",
    "[eos]\nlaw = []", "[detonation]\nvelocity = true", "[detonation]\nignition_growth = 3", "[detonation]\nignition_growth = 'U001'",
    "[strength]\nrow = 'U007'", "[burn]\nrow = 'U007'", "[unreacted]\nlaw = 'x'"])
def test_nothing_in_a_file_breaks_the_reader(tmp_path, text):
    """Whatever stands in a file is used or named as a problem, never a crash."""
    path = tmp_path / "mine.toml"
    head = "" if text.startswith("[eos]") else '[eos]\nrow = "U007"\n'
    body = text.replace("[eos]\n", '[eos]\nrow = "U007"\n') if "row" not in text else text
    path.write_text(body + "\n" + head if not text.startswith("[") else head + body + "\n")
    with pytest.raises(DeckError, match="material.mine"):
        users.read_materials(path)


def test_a_users_material_is_of_the_substance_it_is_based_on(tmp_path):
    path = tmp_path / "several.toml"
    path.write_text('[material.inox]\nbase = "steel 304"\n[material.own]\nlibrary = "LiF"\n[material.own.eos]\nlaw = "ideal_gas"\ngamma = 1.3\n'
                    '[material.gas.eos]\nlaw = "ideal_gas"\ngamma = 1.3\n')
    found = users.user_materials([path])
    assert {name: entry.material.library for name, entry in found.items()} == {"inox": "steel_304", "own": "LiF", "gas": ""}
    path.write_text('[material.own]\nlibrary = "nosuch"\n[material.own.eos]\nlaw = "ideal_gas"\ngamma = 1.3\n')
    with pytest.raises(DeckError, match="unknown material 'nosuch'"):
        users.user_materials([path])


def test_statements_of_the_library_do_not_pass_to_another_curve(tmp_path):
    """The range of copper's data belongs to its own Hugoniot, and what was stated with the constants of products to those constants."""
    (tmp_path / "mine.toml").write_text("""
[material.other]
base = "copper"
eos = {law = "mie_gruneisen", rho0 = 8930.0, c0 = 3000.0, s = 1.2, gamma0 = 2.0, specific_heat = 380.0}
[material.slow]
base = "copper"
eos = {c0 = 3700.0}
[material.warm]
base = "copper"
eos = {specific_heat = 400.0}
[material.weak]
base = "tnt"
eos = {e0 = "5 GPa"}
""")
    found = {name: entry.material for name, entry in read_materials(tmp_path / "mine.toml").items()}
    copper = library.find("copper")
    assert found["other"].valid_up_to is None and not any(s.quantity == "valid_up_to" for s in found["other"].sources)
    assert found["slow"].valid_up_to == found["warm"].valid_up_to == copper.valid_up_to
    assert reach(found["warm"]) == reach(copper) and "replaces c0, so the statement is about another curve" in reach(found["slow"])
    assert any(s.quantity == "detonation.velocity" for s in library.find("tnt").sources)
    assert not any(s.quantity.startswith("detonation.") for s in found["weak"].sources)


@pytest.mark.parametrize("law, name", [("law = 'tension_cutoff'\ntension = 1e9", "reference state"),
                                       ("law = 'p_alpha'\nalpha0 = 1.5\nelastic_pressure = 1e7\ncompaction_pressure = 1e8",
                                        "initial state of the porous material")])
def test_only_porous_materials_start_from_a_porous_state(tmp_path, law, name):
    (tmp_path / "one.toml").write_text(f"[eos]\n{law}\nbase = {{law = 'mie_gruneisen', rho0 = 2700.0, c0 = 5350.0, s = 1.34, gamma0 = 2.0}}\n")
    assert reference_name(described(read_materials(tmp_path / "one.toml")["one"])) == name
