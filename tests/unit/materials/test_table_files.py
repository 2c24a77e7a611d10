"""Tables of decks and material files that stand in files of their own: CSV, HDF5, SESAME-format ASCII, and what is said to bad ones."""

import json

import h5py
import numpy as np
import pytest
from typer.testing import CliRunner

from hugoniot.cli.main import build_app
from hugoniot.errors import DeckError
from hugoniot.laws.eos.contract import pressure, reference_state, temperature
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.laws.eos.table import Table, from_law
from hugoniot.materials.library import find
from hugoniot.materials.material import Material
from hugoniot.materials.plausible import unlikely
from hugoniot.materials.table_hdf5 import read_table, write_table
from hugoniot.materials.tables_io import load
from hugoniot.materials.users import read_materials
from hugoniot.problem.deck import read_deck, read_deck_text

SOLID = MieGruneisen(2785.0, 5328.0, 1.338, 2.0, 863.0)
DECK = """
title = "tables"
geometry = "planar"
stop_time = "1 us"
[[region]]
name = "plate"
material = "al"
from = "0 mm"
to = "1 mm"
zones = 10
velocity = "100 m/s"
[material.al.eos]
law = "table"
file = "{}"
rho0 = "2785 kg/m^3"
density_range = ["2.6 g/cm^3", "4.0 g/cm^3"]
"""


@pytest.fixture(scope="module")
def solid():
    return from_law(SOLID, np.linspace(2500.0, 4200.0, 12), np.linspace(200.0, 4000.0, 9), rho0=2785.0)


def csv_rows(made):
    return [[rho, t, made.pressure_table[i, j], made.energy_table[i, j]]
            for i, rho in enumerate(made.density.tolist()) for j, t in enumerate(made.temperatures.tolist())]


def write_csv(path, rows, header="density,temperature,pressure,energy"):
    path.write_text("\n".join([header, *(",".join(str(v) for v in row) for row in rows)]) + "\n", encoding="utf-8")


def write_301(path, made):
    """The ASCII exchange format, density fastest, in g/cm3, K, GPa and MJ/kg."""
    n, m = made.pressure_table.shape
    words = [n, m, *(made.density / 1e3), *made.temperatures, *(made.pressure_table.T.ravel() / 1e9), *(made.energy_table.T.ravel() / 1e6)]
    lines = [f" 0  3720   301  {len(words)}  r 82993"] + ["".join(f"{float(w):22.14E}" for w in words[k:k + 5]) for k in range(0, len(words), 5)]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def write_file(folder, kind, made):
    path = folder / f"al.{kind}"
    if kind == "csv":
        write_csv(path, csv_rows(made))
    elif kind == "h5":
        write_table(path, *made[:2], made.pressure_table, made.energy_table, "aluminium")
    else:
        write_301(path, made)
    return path


@pytest.mark.parametrize("kind", ["csv", "h5", "ses"])
def test_a_deck_reads_a_table_beside_it(tmp_path, solid, kind):
    write_file(tmp_path, kind, solid)
    (tmp_path / "deck.toml").write_text(DECK.format(f"al.{kind}"), encoding="utf-8")
    deck = read_deck(tmp_path / "deck.toml")
    law = deck.problem.materials["al"].eos
    assert isinstance(law, Table) and law.density[0] > 2600.0 and law.density[-1] < 4000.0
    rho, e = 3100.0, 7.0e5
    assert pressure(rho, e, law) == pytest.approx(pressure(rho, e, solid), rel=1e-11)
    assert reference_state(law) == pytest.approx(reference_state(solid), rel=1e-11)
    again = read_deck_text(deck.resolved, "resolved").problem.materials["al"].eos
    assert all(np.array_equal(a, b) for a, b in zip(law, again)), "a saved problem must hold the table itself"


@pytest.mark.parametrize("kind", ["csv", "h5", "301"])
def test_a_material_file_reads_a_table_beside_it(tmp_path, solid, kind):
    write_file(tmp_path, kind, solid)
    (tmp_path / "mine.toml").write_text(f'[eos]\nlaw = "table"\nfile = "al.{kind}"\nrho0 = "2.785 g/cm^3"\n', encoding="utf-8")
    law = read_materials(tmp_path / "mine.toml")["mine"].material.eos
    assert temperature(3100.0, 7.0e5, law) == pytest.approx(temperature(3100.0, 7.0e5, solid), rel=1e-11)
    found = CliRunner().invoke(build_app("eos"), ["eos", "hugoniot", str(tmp_path / "mine.toml"), "--at", "pressure = 10 GPa", "--json"])
    assert found.exit_code == 0, found.output
    u = json.loads(found.stdout)["particle_velocity"]
    assert 2785.0 * (5328.0 + 1.338 * u) * u == pytest.approx(1e10, rel=0.01), "the jump of the tabulated law, to the table's coarseness"


@pytest.mark.parametrize("kind", ["csv", "h5"])
@pytest.mark.parametrize("key", ["number = 3720", "table = 303"])
def test_keys_of_sesame_files_are_refused_for_other_files(tmp_path, solid, kind, key):
    write_file(tmp_path, kind, solid)
    (tmp_path / "deck.toml").write_text(DECK.format(f"al.{kind}") + key + "\n", encoding="utf-8")
    with pytest.raises(DeckError, match="applies to SESAME-format files only"):
        read_deck(tmp_path / "deck.toml")


@pytest.mark.parametrize("option", ["csv", "hdf5"])
def test_what_the_table_command_writes_a_deck_runs_on(tmp_path, option):
    out = tmp_path / f"copper.{'h5' if option == 'hdf5' else 'csv'}"
    done = CliRunner().invoke(build_app("eos"), ["eos", "table", "copper", "--points", "40", "--temperatures", "200 K, 3000 K", f"--{option}", str(out)])
    assert done.exit_code == 0, done.output
    (tmp_path / "deck.toml").write_text(DECK.format(out.name).replace("2785", "8930").replace("2.6", "8").replace("4.0", "14"), encoding="utf-8")
    law = read_deck(tmp_path / "deck.toml").problem.materials["al"].eos
    assert pressure(10100.0, 3.0e5, law) == pytest.approx(pressure(10100.0, 3.0e5, find("copper").eos), rel=3e-3)


def broken_rows(solid, what):
    """(rows, line of the trouble) of a CSV with one thing wrong; nine temperatures per density, the header is line 1."""
    rows = csv_rows(solid)
    if what == "gap":
        del rows[13]
        return rows, 18
    if what == "empty":
        rows[13][2] = ""
    elif what == "nan":
        rows[13][3] = "nan"
    elif what == "falls":
        rows[13][3] = rows[12][3] - 1.0
    elif what == "pressure":
        rows[13][2] = 9e12
        return rows, 15
    elif what == "word":
        rows[13][2] = "1,2"
    elif what == "twice":
        rows[13][:2] = rows[12][:2]
    elif what == "negative":
        rows[13][0] = -2785.0
    return rows, 15


@pytest.mark.parametrize("what, message", [
    ("gap", "no row gives density"), ("empty", "pressure: the value is missing; a table needs a value at every density"), ("nan", "no energy is given at density"),
    ("falls", "energy must rise with temperature"), ("pressure", "squared sound speed is not positive"), ("word", "values: 5, column headers: 4"),
    ("twice", "is given twice, first on line 14"), ("negative", "is not a valid state; densities are positive")])
def test_a_bad_row_is_told_with_its_line(tmp_path, solid, what, message):
    rows, line = broken_rows(solid, what)
    write_csv(tmp_path / "al.csv", rows)
    (tmp_path / "deck.toml").write_text(DECK.format("al.csv"), encoding="utf-8")
    with pytest.raises(DeckError) as told:
        read_deck(tmp_path / "deck.toml")
    (problem,) = told.value.problems
    assert message in str(problem) and problem.file == str(tmp_path / "al.csv")
    assert problem.line == line


def test_wrong_columns_are_told_with_the_right_ones(tmp_path, solid):
    write_csv(tmp_path / "al.csv", csv_rows(solid), "density,temperature,pressure,enthalpy")
    with pytest.raises(DeckError, match=r"al.csv:1: header: needs exactly one column 'energy', found .*enthalpy; the columns, in any order, are density"):
        load(tmp_path / "al.csv")


def test_hdf5_files_keep_their_units_and_shapes(tmp_path, solid):
    path = write_file(tmp_path, "h5", solid)
    assert all(np.array_equal(a, b) for a, b in zip(read_table(path), solid))
    with h5py.File(path) as file:
        assert {k: v.attrs["unit"] for k, v in file.items()} == {"density": "kg/m^3", "temperature": "K", "pressure": "Pa", "energy": "J/kg"}
    for change, message in ((lambda f: f["pressure"].attrs.modify("unit", "GPa"), "pressure: is in 'GPa'; write it in Pa"),
                            (lambda f: f.__delitem__("energy"), "no dataset 'energy'"),
                            (lambda f: (f.__delitem__("energy"), f.create_dataset("energy", data=np.ones((3, 4)))), "12 densities and 9 temp"),
                            (lambda f: f["energy"].__setitem__((4, 2), np.nan), "no energy is given at density")):
        path = write_file(tmp_path, "h5", solid)
        with h5py.File(path, "a") as file:
            change(file)
        with pytest.raises(DeckError) as told:
            load(path)
        assert message in str(told.value) and str(path) in str(told.value)
    (tmp_path / "no.h5").write_text("density", encoding="utf-8")
    with pytest.raises(DeckError, match="not an HDF5 file"):
        load(tmp_path / "no.h5")


@pytest.mark.parametrize("change, message", [
    (('file = "al.csv"', 'file = "cu.csv"'), "deck.toml:14: material.al.eos.file: no readable table at"), (('file = "al.csv"', "file = 3"), "expected the name of a file"),
    (('density_range = ["2.6 g/cm^3", "4.0 g/cm^3"]', 'density_range = ["4 g/cm^3", "2 g/cm^3"]'), "deck.toml:16: material.al.eos.density_range: the second value must exceed the first"),
    (('["2.6 g/cm^3", "4.0 g/cm^3"]', '["9 g/cm^3", "14 g/cm^3"]'), "in the requested range, densities: 0, temperatures: 9"),
    (("rho0", "rho_0"), "did you mean 'rho0'?"), (('"2785 kg/m^3"', '"2785 K"'), "eos.rho0")])
def test_bad_keys_are_told_with_their_line(tmp_path, solid, change, message):
    write_file(tmp_path, "csv", solid)
    (tmp_path / "deck.toml").write_text(DECK.format("al.csv").replace(*change), encoding="utf-8")
    with pytest.raises(DeckError) as told:
        read_deck(tmp_path / "deck.toml")
    assert message in str(told.value)


@pytest.mark.parametrize("law, more", [
    ("p_alpha", "alpha0 = 1.3\nelastic_pressure = 1e8\ncompaction_pressure = 1e9"), ("snow_plough", "rho_porous = 2100.0\ncrush_pressure = 1e8"),
    ("p_lambda", "rho_porous = 2100.0\nmatrix_modulus = 25e9\ncrush_strength = 4e8")])
def test_porous_laws_of_a_deck_warn_only_where_the_history_is_not_kept(law, more):
    base = "rho0 = 2785.0\nc0 = 5328.0\ns = 1.338\ngamma0 = 2.0\n"
    text = DECK.split("[material")[0] + (f'[material.al.eos]\nlaw = "{law}"\n{more}\n[material.al.eos.base]\nlaw = "mie_gruneisen"\n{base}'
                                         '[material.al.strength]\nlaw = "perfectly_plastic"\nshear_modulus = 2e10\nyield_stress = 3e8\n')
    assert not any("pores" in w for w in read_deck_text(text).warnings)
    solid = f'law = "mie_gruneisen"\n{base}'
    deck = read_deck_text(text.split("[material")[0] + (
        '[material.al]\ndetonation_energy = 5e6\n[material.al.eos]\nlaw = "ideal_gas"\ngamma = 3.0\nrho0 = 2000.0\n'
        f'[material.al.unreacted]\nlaw = "{law}"\n{more}\n[material.al.unreacted.base]\n{solid}'
        '[material.al.burn]\nlaw = "threshold"\ninitiation_pressure = 1e10\n'))
    assert [("pores reopen" in w) for w in deck.warnings].count(True) == 1
    assert [("pores reopen" in w) for w in read_deck_text(deck.resolved).warnings].count(True) == 1


def test_a_law_around_a_porous_one_is_refused_and_so_are_porous_products():
    solid = 'law = "mie_gruneisen"\nrho0 = 2785.0\nc0 = 5328.0\ns = 1.338\ngamma0 = 2.0\n'
    porous = 'law = "snow_plough"\nrho_porous = 2100.0\ncrush_pressure = 1e8\n'
    head = DECK.split("[material")[0]
    with pytest.raises(DeckError, match="'tension_cutoff' around a porous law would lose the history"):
        read_deck_text(f'{head}[material.al.eos]\nlaw = "tension_cutoff"\ntension = 1e9\n[material.al.eos.base]\n{porous}[material.al.eos.base.base]\n{solid}')
    with pytest.raises(DeckError, match="products of an explosive cannot have the law 'snow_plough'"):
        read_deck_text(f'{head}[material.al.eos]\n{porous}[material.al.eos.base]\n{solid}[material.al.burn]\nlaw = "threshold"\ninitiation_pressure = 1e10\n')


@pytest.mark.parametrize(("base", "told"), [("mie_gruneisen_cold_series", 1), ("mie_gruneisen_cold", 0)])
def test_grains_over_a_truncated_cold_curve_are_told_of(base, told):
    """Order 3 to 6 sweeps a powder up to its grains in the first shock: 417 for 509 m/s at 0.10 g/cm3 and 405 m/s."""
    deck = read_deck_text('stop_time = 1e-6\n[[region]]\nname = "powder"\nmaterial = "silica"\nfrom = 0.0\nto = 1e-3\nzones = 5\n'
                          '[material.silica.eos]\nlaw = "grain_contact"\ngrain_density = 2200.0\ngrain_modulus = 23.4e9\n'
                          f'grain_modulus_slope = 4.34\n[material.silica.eos.base]\nlaw = "{base}"\nrho0 = 100.0\nc0 = 121.0\ns = 0.9736\ngamma0 = 0.3\n')
    assert [("too soft in the first shock" in w) for w in deck.warnings].count(True) == told
    assert [("too soft in the first shock" in w) for w in read_deck_text(deck.resolved).warnings].count(True) == told


def test_a_table_of_a_gas_is_no_solid_with_a_forgotten_unit(tmp_path):
    """Air in a table has the density of air; of copper in g/cm3 taken for kg/m3 the doubt stays."""
    assert CliRunner().invoke(build_app("eos"), ["eos", "table", "air", "--densities", "0.5 kg/m^3, 8 kg/m^3", "--temperatures", "200 K, 4000 K",
                                                 "--points", "15", "--csv", str(tmp_path / "air.csv")]).exit_code == 0
    gas = load(tmp_path / "air.csv", rho0=1.184)
    assert unlikely("air", Material("air", gas)) == []
    light = gas._replace(pressure_table=gas.pressure_table - 101325.0)      # no pressure at rest: condensed
    assert any("rho0" in text for text in unlikely("light", Material("light", light)))


def test_a_table_of_a_porous_law_says_that_it_forgets_the_pores(tmp_path):
    said = CliRunner().invoke(build_app("eos"), ["eos", "table", "aluminum_porous", "--densities", "2120 kg/m^3, 3700 kg/m^3", "--points", "5", "--json"])
    assert "does not keep crushed pores closed" in json.loads(said.stdout)["warnings"][0]
    assert json.loads(CliRunner().invoke(build_app("eos"), ["eos", "table", "copper", "--points", "5", "--json"]).stdout)["warnings"] == []
