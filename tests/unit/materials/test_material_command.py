"""`hugoniot material`: list, show, search, compare, check, for people and for programs."""

import json

import numpy as np
import pytest

from hugoniot.cli import main as front
from hugoniot.dossier import curves
from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.materials import library, schema
from hugoniot.materials.search import matches, nearest, spelling
from hugoniot.theory.chapman_jouguet import cj
from hugoniot.theory.hugoniot import Initial


def call(capsys, *arguments):
    """(exit code, output, errors) of `hugoniot material ...`."""
    with pytest.raises(SystemExit) as ended:
        front.main(["material", *map(str, arguments)])
    out, err = capsys.readouterr()
    return ended.value.code or 0, out, err


def test_list(capsys):
    code, out, _ = call(capsys, "list")
    assert code == 0 and all(name in out for name in library.names())
    metals = json.loads(call(capsys, "list", "metal", "--json")[1])
    assert {m["category"] for m in metals} == {"metal"} and "copper" in {m["name"] for m in metals}
    everything = json.loads(call(capsys, "list", "--all", "--json")[1])
    assert len(everything) >= 180
    code, _, err = call(capsys, "list", "cheese")
    assert code == 2 and "cheese" in err and "explosive" in err


def test_explosives_as_gamma_laws_detonate_as_their_products_do(capsys):
    """The search for the tangency, which knows no gamma law, finds the CJ state of the products again."""
    laws = {law["name"]: law for law in json.loads(call(capsys, "list", "explosive", "--gamma-law", "--json")[1])}
    assert set(laws) == {hit.name for hit in library.listings() if hit.curated and hit.category == "explosive"}
    for name in ("comp_b", "tnt", "anfo", "hmx"):
        law, products = laws[name], cj(library.find(name).eos)
        found = cj(IdealGas(law["gamma"]), Initial(law["density"], 0.0, 0.0, heat=law["heat"]))
        assert found.detonation_velocity == pytest.approx(products.detonation_velocity, rel=1e-9) and law["derived"]
        assert found.state.pressure == pytest.approx(products.state.pressure, rel=1e-9)
        assert found.state.density == pytest.approx(products.state.density, rel=1e-9)
    code, out, _ = call(capsys, "list", "--gamma-law", "--all")
    assert code == 0 and "Cyclotol 77/23" in out and "derived" in out and "(unreacted)" not in out
    assert call(capsys, "list", "metal", "--gamma-law")[0] == 2


def test_summary_counts_what_is_unverified(capsys):
    code, out, _ = call(capsys, "list", "--summary")
    assert code == 0 and "rows neither from a public file nor checked against the printed source" in out
    counts = json.loads(call(capsys, "list", "--summary", "--json")[1])
    assert counts["rows_unverified_against_print"] == sum(t["unverified"] for t in counts["tables"].values()) == 47
    assert counts["rows"] == sum(t["rows"] for t in counts["tables"].values())


@pytest.mark.parametrize("name, words", [
    ("copper", ["3940", "bulk sound speed", "Hugoniot elastic limit", "Steinberg", "repository irisvogon", "up to 2946 m/s", "3900 ± 11"]),
    ("pentolite", ["WARNING", "not checked against the printed source", "CJ detonation velocity", "25.5"]),
    ("rdx", ["WARNING", "is doubtful"]), ("petn", ["does not give zero pressure", "unreacted.a"]), ("iron", ["without its last term", "U208", "3531 ± 164"]),
    ("U160", ["6278", "exponential_amplitude", "form: ulh"]), ("G009", ["growth1"]), ("S089", ["WARNING", "0.276"]), ("uranium", ["s = 2.20"])])
def test_show(capsys, name, words):
    code, out, _ = call(capsys, "show", name)
    assert code == 0 and all(word in out for word in words), out


def test_every_material_can_be_shown(capsys):
    for name in library.names():
        code, out, _ = call(capsys, "show", name, "--json")
        about = json.loads(out)
        assert code == 0 and about["constants"] and (about["derived"] or about["category"] == "gas")
        call(capsys, "show", name)


def test_show_an_unknown_name(capsys):
    code, _, err = call(capsys, "show", "coper")
    assert code == 2 and "copper" in err and "Traceback" not in err


def test_search(capsys):
    assert "steel_304" in call(capsys, "search", "stainless 304")[1]
    found = json.loads(call(capsys, "search", "rhenium", "--json")[1]) + json.loads(call(capsys, "search", "Re", "--json")[1])
    assert any("U071" in hit["rows"] for hit in found)
    code, out, err = call(capsys, "search", "xyzzy")
    assert code == 2 and not out and "nothing found for 'xyzzy'; hugoniot material list" in err


def test_compare_writes_a_picture_and_data(capsys, tmp_path):
    picture = tmp_path / "iron.png"
    code, out, _ = call(capsys, "compare", "iron", "-o", picture, "--up-to", "4 km/s")
    assert code == 0 and "U215" in out and picture.read_bytes()[:4] == b"\x89PNG" and picture.stat().st_size > 20_000
    data = json.loads(call(capsys, "compare", "cu", "al6061", "--up-to", "2 km/s", "--json")[1])
    assert len(data["curves"]) == 2 and data["states"]
    copper = data["curves"][0]
    assert np.interp(1000.0, copper["up"], copper["us"]) == pytest.approx(3940.0 + 1489.0, rel=1e-6)
    assert np.interp(1000.0, copper["up"], copper["p"]) == pytest.approx(8930.0 * 5429.0 * 1e3, rel=1e-3)
    assert max(data["states"][0]["up"]) <= 2060.0
    picture.unlink()
    assert json.loads(call(capsys, "compare", "cu", "--json", "-o", picture)[1])["curves"] and picture.is_file()
    assert call(capsys, "compare", "rdx", "-o", picture)[0] == 2


def test_check_a_users_file(capsys, tmp_path):
    path = tmp_path / "mine.toml"
    path.write_text('[eos]\nlaw = "mie_gruneisen"\nrho0 = {value = 2700, source = "lab"}\nc0 = {value = "5.2 m/s", source = "lab"}\n'
                    's = {value = 1.4, source = "lab"}\ngamma0 = {value = 2.0, source = "lab"}\n')
    code, out, _ = call(capsys, "check", path)
    assert code == 2 and "c0 = 5.2 is outside" in out
    path.write_text(path.read_text().replace("5.2 m/s", "5.2 km/s"))
    code, out, _ = call(capsys, "check", path)
    assert code == 0 and "outside" not in out and "failed: 0" in out
    assert call(capsys, "check")[0] == 2


@pytest.mark.parametrize("arguments, code, words", [
    (("compare", "copper", "--up-to", "fast"), 2, "--up-to: 'fast' is not a quantity"), (("compare", "copper", "--up-to", "-1 km/s"), 2, "give a positive one"),
    (("compare", "copper", "-o", "copper.doc"), 2, "--out: cannot draw 'copper.doc'"),
    (("compare", "copper", "-o", "nowhere/copper.png"), 4, "no picture is written"),
    (("check", "empty"), 2, "no material in empty"), (("check", "missing.toml"), 4, "no file or folder"),
    (("check", "noise.toml"), 2, "noise.toml: material: not a UTF-8 text file"), (("show", "steel", "-m", "noise.toml"), 2, "not a UTF-8 text file")])
def test_bad_input_is_answered_with_the_way_out(capsys, tmp_path, monkeypatch, arguments, code, words):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "empty").mkdir()
    (tmp_path / "noise.toml").write_bytes(bytes(range(256)))
    ended, _, err = call(capsys, *arguments)
    assert ended == code and words in err and "defect" not in err


def test_a_file_with_a_byte_order_mark_is_read(capsys, tmp_path):
    text = '[material.mine.eos]\nlaw = "mie_gruneisen"\nrho0 = "8930 kg/m^3"\nc0 = "3940 m/s"\ns = 1.489\ngamma0 = 1.99\n'
    (tmp_path / "mine.toml").write_bytes(b"\xef\xbb\xbf" + text.replace("\n", "\r\n").encode())
    assert "3940" in call(capsys, "show", "mine", "-m", tmp_path / "mine.toml")[1]


def test_check_all(capsys):
    code, out, _ = call(capsys, "check", "--all", "--json")
    found = json.loads(out)
    assert code == 0 and found["counts"]["fail"] == 0 and found["counts"]["ok"] > 7000
    code, out, _ = call(capsys, "check", "--all")
    assert code == 0 and "J010" in out and "-1.26 %" in out


# -- names and curves --------------------------------------------------------------------------------------------
def test_spelling():
    assert spelling("Aluminium 6061-T6") == spelling("aluminum_6061 t6") == "aluminum6061t6"
    assert spelling("Grüneisen") == "gruneisen"
    assert matches("304 stainless", ["Stainless steel 304"]) and not matches("305 stainless", ["Stainless steel 304"])
    assert nearest("tungstn", {"tungsten": "tungsten", "tin": "tin"})[0] == "tungsten"


@pytest.mark.parametrize("typed, name", [("304 stainless", "steel_304"), ("al2024-t4", "aluminum_2024"), ("T6 7075 aluminium", "aluminum_7075"),
                                         ("half hard OFHC copper", "copper"), ("70/30 brass", "brass")])
def test_parts_of_a_name_in_any_order(typed, name):
    assert library.entry(typed).name == name


@pytest.mark.parametrize("typed", ["alu", "6061 alu"])
def test_a_name_that_is_not_listed_is_not_taken(typed):
    """Of aluminium the library lists al and aluminum, and both spellings of the word; alu would be 6061 without saying so."""
    with pytest.raises(library.UnknownMaterial, match="nearest"):
        library.entry(typed)


def test_a_name_of_the_tables_stays_that_row():
    assert library.entry("Steel 347").name != "steel_304"
    with pytest.raises(library.UnknownMaterial, match="nearest.*steel_304"):
        library.entry("steel")


def test_sources_of_a_material_include_the_doubted_ones():
    found = curves.comparison([library.entry("water")], 5000.0)
    labels = " ".join(c.label for c in found.curves)
    assert all(i in labels for i in ("U205", "U110", "U178", "U179", "U154", "U204", "U210"))
    assert [c.default for c in found.curves].count(True) == 1
    water = found.curves[0]
    assert not water.reliable[0] and water.reliable[60] and not water.reliable[-1]  # 0.9 to 4.942 km/s are measured


def test_measured_states_of_iron_are_solid_ones():
    (iron,) = curves.measured("iron")
    rows = [p for p in schema.points() if p.material == "Iron"]
    assert 300 < len(iron.up) < len(rows)


def test_an_unreacted_explosive_is_compared_with_solids():
    found = curves.comparison([library.entry("lx_17"), library.entry("pmma")], 1000.0)
    assert len(found.curves) == 2 and found.curves[0].us[0] > 2000.0


@pytest.mark.parametrize(("name", "row"), [("comp_b", "J050"), ("c4", "G005"), ("LX-17 reactive", "G001")])
def test_the_hugoniot_of_an_explosive_names_the_source_of_its_unreacted_law(name, row):
    """Composition B: the products of row J009 have no Hugoniot that the picture could show."""
    entry = library.entry(name)
    drawn = curves.comparison([entry, library.entry("copper")], 2000.0).curves[0]
    stated = {source.source for source in entry.material.sources if source.quantity == "unreacted.rho0"}
    assert f"unreacted (row {row}, used here)" in drawn.label or not entry.curated
    assert {drawn.source} == stated
