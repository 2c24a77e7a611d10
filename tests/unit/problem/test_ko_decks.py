"""Decks of pyKO and KO: their own runs, their units, what is refused.

Figures of pyKO come from runs of v0.8 (github.com/ImpactsWiki/pyko, commit 9bccb4a1, 2023-07-08) on the two decks below, written for this
test: first step 1 ns, a sixth of Wilkins' step for the plates, the whole one for the gas.
"""

import re
import tomllib

import numpy as np
import pytest

import hugoniot
from hugoniot.cli import main as front
from hugoniot.errors import DeckError
from hugoniot.problem.deck import read_deck_text
from hugoniot.problem.ko_columns import read_columns
from hugoniot.problem.ko_decks import deck_tables
from hugoniot.problem.ko_yaml import read_yaml
from hugoniot.problem.write import to_toml

UNITS = ("units: {time: second, length: meter, velocity: meter/second, density: kg/m^3, pressure: Pa, temperature: K, sp_energy: J/kg, "
         "sp_heat_cap: J/K/kg, gravity: m/s^2}\n")
PLATES = """
name: own plates
tstop: 0.8002734725840855
dtstart: 0.001
dtoutput: 0.4
mat1:
  mesh: {cells: 25, xstart: -1.05, length: 1.0}
  init: {up0: 0.5, rho0: 2.785, p0: 0.0, e0: 0.0, t0: 300.0}
  eos: {name: plate A, type: MGR, rhoref: 2.785, c0: 5.328, s1: 1.338, gamma0: 2.0, cv: 0.9}
  str: {type: VM, gmod: 27.6, ys: 0.3}
mat2:
  mesh: {cells: 50, xstart: 0.0, length: 2.0}
  init: {up0: 0.0, rho0: 8.93, p0: 0.0, e0: 0.0, t0: 300.0}
  eos: {name: plate B, type: MGR, rhoref: 8.93, c0: 3.94, s1: 1.489, gamma0: 2.0, cv: 0.385}
  str: {type: VM, gmod: 45.0, ys: 0.09}
  frac: {pfrac: 1E20, nrhomin: 0.9}
boundaries: {ibc: FREE, ip0: 0.0, obc: FIXED}
geometry: PLA
gravity: 0.0
units: {time: microsecond, length: millimeter, velocity: kilometer/second, density: g/cm^3, pressure: gigapascal, temperature: K,
        sp_energy: kJ/g, sp_heat_cap: kJ/kg/K, gravity: m/s^2}
"""
GAS = """
name: own gas
tstop: 30.0237340316212E-6
dtstart: 1.0E-9
dtoutput: 10.0E-6
mat1:
  mesh: {cells: 40, xstart: 0.01, length: 0.02}
  init: {up0: 0.0, rho0: 8.0, p0: 1.6E6, e0: 5.0E5}
  eos: {name: gas, type: IDG, gamma: 1.4, cv: 700.0}
  str: {type: HYDRO}
  frac: {pfrac: 0.0}
mat2:
  mesh: {cells: 40, xstart: 0.03, length: 0.02}
  init: {up0: 0.0, rho0: 1.0, p0: 1.0E5, e0: 2.5E5}
  eos: {name: gas, type: IDG, gamma: 1.4, cv: 700.0}
  str: {type: HYDRO}
boundaries: {ibc: FIXED, obc: FIXED}
geometry: SPH
gravity: 0.0
""" + UNITS
COLUMNS = ("heading\n   iEOS  Nodes ...\n"
           "      1     50    0.1   -0.1    0.0   0.05  2.785    0.0  2.785   0.5328    1.338     0.00    2.0   .003  0.276  1.0e9 9.0e-6\n"
           "      1    100    0.2    0.0    0.0   0.00   8.93    0.0   8.93    0.394    1.489     0.00    2.0  .0009   0.45  .005  3.8e-6\n"
           "\nends\n   iend  P_0\n     -1 0.0000     .0\n      4 0.0000     .0\n\ntime\n0.8\ndimension\n1.0\n")
# every fifth zone of the plates at the end: pressure (GPa), velocity (km/s); every 30th: temperature (K)
PLATE_PRESSURE = [0.1265, -0.20696, -0.2386, -0.22812, -0.49603, -0.68846, -1.63158, -1.87399, -1.87664, -1.66203, 0.9859, 3.70223, 6.73397,
                  9.26391, 10.93855]
PLATE_VELOCITY = [0.06237, 0.06211, 0.05946, 0.0545, 0.02158, -0.01942, -0.04597, -0.05414, -0.056, -0.0637, -0.13785, -0.19924, -0.12507,
                  -0.06369, -0.01839]
PLATE_TEMPERATURE = [301.770, 313.190, 297.307, 295.827, 330.465]
# every eighth zone of the gas: pressure (Pa), velocity (m/s)
GAS_PRESSURE = [1599906.3, 1479219.0, 922242.7, 444549.4, 183380.8, 275730.5, 279895.0, 286348.9, 291707.5, 306470.0]
GAS_VELOCITY = [0.01543, 27.87374, 174.97394, 362.8765, 534.05544, 384.08261, 371.95, 361.64784, 350.24855, 317.07539]


def tables_of(text, read=read_yaml):
    return deck_tables(read(text, "own"), "own")


def ended(tmp_path, tables):
    deck = read_deck_text(to_toml(tables), "own.toml")
    return hugoniot.run(deck.problem, out=tmp_path / "own.run", report=False)


def last(run):
    final = run.snapshots.isel(time=-1)
    return final, 0.5 * (final.velocity_left.values + final.velocity_right.values)


def test_plates_over_a_gap_give_pyKOs_own_numbers(tmp_path):
    """Impact, release, tension at the glued contact, reflection at the wall; the contact's first velocity is all that differs."""
    tables, left = tables_of(PLATES)
    run = ended(tmp_path, tables)
    final, velocity = last(run)
    assert left == [] and run.summary["interfaces_separated"] == 0 and float(final.time) == pytest.approx(0.8002734725840855e-6, rel=1e-9)
    assert np.mean(np.abs(final.pressure.values[::5] / 1e9 - PLATE_PRESSURE)) < 0.002 * 11.13
    assert np.mean(np.abs(velocity[::5] / 1e3 - PLATE_VELOCITY)) < 0.004 * 0.2
    assert final.temperature.values[::15] == pytest.approx(PLATE_TEMPERATURE, abs=0.5)


def test_without_the_bond_the_same_plates_come_apart(tmp_path):
    tables, _ = tables_of(PLATES)
    del tables["interface"]
    assert ended(tmp_path, tables).summary["interfaces_separated"] > 0


def test_a_bond_over_a_gap_is_refused():
    tables, _ = tables_of(PLATES)
    tables["interface"][0] |= {"kind": "bond", "strength": 1e8}
    with pytest.raises(DeckError, match="do not touch"):
        read_deck_text(to_toml(tables), "own.toml")


def test_a_gas_between_spheres_gives_pyKOs_own_numbers(tmp_path):
    tables, _ = tables_of(GAS)
    assert all("fracture" not in table for table in tables["material"].values()) and tables["solver"]["courant"] == pytest.approx(2 / 3)
    final, velocity = last(ended(tmp_path, tables))
    assert np.max(np.abs(final.pressure.values[::8] - GAS_PRESSURE)) < 1e-3 * 1.6e6
    assert np.max(np.abs(velocity[::8] - GAS_VELOCITY)) < 5e-3 * 534.0


def test_columns_and_yaml_of_the_same_plates_make_one_deck():
    columns, left = tables_of(COLUMNS, read_columns)
    assert [text[:7] for text in left] == ["layer 2"] and "KO compares the longitudinal stress" in left[0]
    text = PLATES.replace("-1.05", "-1.0").replace("1E20", "0.5").replace("nrhomin: 0.9", "nrhomin: 1.0")
    text = text.replace("cv: 0.9", "cv: 0.9").replace("cv: 0.385", "cv: 0.38")
    yaml, _ = tables_of(text)
    for mine, theirs in zip(columns["region"], yaml["region"]):
        assert {k: v for k, v in mine.items() if k not in ("name", "material")} == pytest.approx(
            {k: v for k, v in theirs.items() if k not in ("name", "material")})
    for mine, theirs in zip(columns["material"].values(), yaml["material"].values()):
        theirs["eos"].pop("reference_temperature")
        assert {key: {k: v for k, v in table.items() if k != "law"} for key, table in mine.items()} == {
            key: pytest.approx({k: v for k, v in table.items() if k != "law"}) for key, table in theirs.items()}
        assert mine["eos"]["law"] == theirs["eos"]["law"] == "wilkins_cubic"
    assert columns["boundary"] == {"left": "free", "right": "fixed"} and columns["stop_time"] == pytest.approx(0.8e-6)


def test_columns_that_run_together_are_read_by_their_widths():
    line = "      1    200    2.0    0.0    0.0   0.05    2.74.34e-3    2.7    0.520      1.5     0.00    2.0  6.e-3   .248  1.0e92.43e-5"
    source = read_columns(COLUMNS.replace(COLUMNS.splitlines()[2], line), "own")
    assert source.layers[0].energy == pytest.approx(4.34e-3 * 1e11 / 2700.0)
    assert source.layers[0].tables["eos"]["specific_heat"] == pytest.approx(2430.0)


def test_an_energy_that_ko_itself_would_ignore_is_named():
    """KO v11 takes P_0/(gamma - 1) whatever E_0 is: 0 for a plate at rest, and what E_0 says for a gas whose columns agree."""
    gas = "      2     40    2.0    0.0    0.5    0.0   10.0   {}    0.0    0.0    0.0    0.0    1.4    0.0    0.0    0.0   25.0"
    plate = COLUMNS.splitlines()[2].replace("2.785    0.0", "2.785 4.3e-3")
    assert [text for text in tables_of(COLUMNS.replace(COLUMNS.splitlines()[2], gas.format(1.25)), read_columns)[1] if "E_0" in text] == []
    for line, own in ((plate, "= 0 Mbar$"), (gas.format(2.0), "= 1.25 Mbar$")):
        left = [text for text in tables_of(COLUMNS.replace(COLUMNS.splitlines()[2], line), read_columns)[1] if "E_0" in text]
        assert len(left) == 1 and re.search(own, left[0])


def test_a_reference_density_that_their_codes_do_not_take_is_refused():
    with pytest.raises(DeckError, match="Rho_00.*2785 kg/m3 is not the initial density 2000"):
        tables_of(COLUMNS.replace("2.785    0.0  2.785", "2.000    0.0  2.785"), read_columns)
    with pytest.raises(DeckError, match="mat1.eos.rhoref"):
        tables_of(PLATES.replace("rhoref: 2.785", "rhoref: 2.7"))


def test_steinberg_guinan_and_tillotson_keep_their_meaning():
    text = PLATES.replace("str: {type: VM, gmod: 27.6, ys: 0.3}",
                          "str: {type: SG, Y0: 0.29, Ymax: 0.68, beta: 125.0, n: 0.1, b: 8.0, h: 6.2E-4, Tm0: 1220.0, mu0: 27.6}")
    tables, _ = tables_of(text.replace("eos: {name: plate B, type: MGR, rhoref: 8.93, c0: 3.94, s1: 1.489, gamma0: 2.0, cv: 0.385}",
                                       "eos: {name: B, type: TIL, rhoref: 8.93, a: 0.5, b: 1.5, AA: 139.0, BB: 110.0, E0: 32.5, alpha: 5.0,"
                                       " beta: 5.0, EIV: 1.38, ECV: 6.92, cv: 0.385}"))
    strength = tables["material"]["plate A"]["strength"]
    assert strength["pressure_coefficient"] == pytest.approx(8e-11) and strength["melt_a"] == strength["melt_gruneisen"] == 2.0
    assert tables["material"]["B"]["eos"]["e_complete"] == pytest.approx(6.92e6)
    read_deck_text(to_toml(tables), "own.toml")


@pytest.mark.parametrize("old, new, words", [
    ("type: MGR, rhoref: 2.785", "type: SES, filestd: none.txt", "no table at 'none.txt'"),
    ("type: MGR, rhoref: 2.785", "type: ANE", "known: IDG, MGR, TIL, SES"),
    ("geometry: PLA", "geometry: CUBE", "PLA, CYL or SPH"),
    ("tstop: 0.8002734725840855", "tstop: soon", "not a number"),
    ("ibc: FREE", "ibc: OPEN", "FREE or FIXED"),
    ("c0: 5.328, ", "", "mat1.c0: is not given"),
    ("ys: 0.3}", "ys: 0.3", "not YAML"),
    ("length: millimeter", "length: parsnip", "unknown unit"),
    ("cells: 25", "cells: 0", "0 is not a number of cells"),
])
def test_what_a_deck_of_theirs_lacks_is_said_with_its_key(old, new, words):
    with pytest.raises(DeckError, match=words):
        tables, _ = tables_of(PLATES.replace(old, new))
        read_deck_text(to_toml(tables), "own.toml")


def test_the_command_writes_a_deck_once(tmp_path, capsys):
    (tmp_path / "own.yml").write_text(PLATES)
    arguments = ["import", str(tmp_path / "own.yml"), "--out", str(tmp_path / "own.toml")]
    with pytest.raises(SystemExit) as done:
        front.main(arguments)
    assert not done.value.code and tomllib.loads((tmp_path / "own.toml").read_text())["title"] == "own plates"
    with pytest.raises(SystemExit) as done:
        front.main(arguments)
    assert done.value.code == 4 and "exists" in capsys.readouterr().err
    with pytest.raises(SystemExit) as done:
        front.main([*arguments[:2], "--units", "g cm us"])
    assert done.value.code == 2


@pytest.mark.parametrize(("old", "new", "message"), [
    ("cells: 25", "cells: 25.4", "mat1.mesh.cells: 25.4 is not a number of cells"),
    ("cells: 25", "cells: 1" + "0" * 400, "mat1.cells: '10+...' is not a number"),
    ("rho0: 2.785", "rho0: 0.0", "mat1.init.rho0: 0 kg/m.3 is not a density"),
    ("nrhomin: 0.9", "nrhomin: 0.0", "mat2.frac.nrhomin: 0 is not a valid limit"),
    ("pfrac: 1E20", "pfrac: -1.0", "mat2.frac.pfrac: -1e.09 is not a valid limit"),
    ("time: microsecond, ", "", "units.time: missing, but tstop needs it"),
    ("units: {", "units: !!python/object/apply:os.getcwd {", "not YAML: a value has a tag"),
    ("name: own plates", "a: &a {b: *a}", "aliases are expanded")])
def test_a_wrong_deck_of_theirs_is_refused(old, new, message):
    assert old in PLATES
    with pytest.raises(DeckError, match=message):
        tables_of(PLATES.replace(old, new, 1), read_yaml)


def test_aliases_that_stand_for_millions_of_values_are_counted_not_written_out():
    rows = "a0: &a0 [x, x, x, x, x, x, x, x]\n" + "".join(f"a{k}: &a{k} [{', '.join([f'*a{k - 1}'] * 8)}]\n" for k in range(1, 12))
    with pytest.raises(DeckError, match="aliases are expanded"):
        read_yaml(rows + PLATES.replace("name: own plates", "name: *a11"), "own")


def test_keys_of_theirs_that_mean_nothing_here_are_named():
    _, left = tables_of(PLATES.replace("up0: 0.5", "upO: 0.5").replace("gravity: 0.0", "gravitty: 9.81"), read_yaml)
    assert left == ["not used: gravitty, mat1.init.upO"]
    assert tables_of(PLATES, read_yaml)[1] == []


def write_gas_table(path, gamma=1.4, heat=700.0):
    """A SESAME text (301) of an ideal gas, in g/cm3, K, GPa, MJ/kg, with density fastest."""
    rho, warm = np.linspace(0.2, 20.0, 100), np.linspace(100.0, 2000.0, 39)
    energy = np.broadcast_to(heat * warm[:, None], (39, 100))
    words = [100, 39, *(rho / 1e3), *warm, *((gamma - 1.0) * rho * energy / 1e9).ravel(), *(energy / 1e6).ravel()]
    lines = ["".join(f"{float(w):22.14E}" for w in words[k:k + 5]) for k in range(0, len(words), 5)]
    path.write_text("\n".join([f" 0  3720   301  {len(words)}  r 82993", *lines]))


def test_a_layer_of_a_table_is_the_gas_the_table_holds(tmp_path):
    """The tube of gas with its law in a table beside the deck: pyKO's numbers for the law, to the interpolation."""
    (tmp_path / "tables").mkdir()
    (tmp_path / "runs").mkdir()
    write_gas_table(tmp_path / "tables" / "std.txt")
    text = GAS.replace("type: IDG, gamma: 1.4, cv: 700.0", "type: SES, path: '../tables/', filestd: 'std.txt', fileext: 'ext.txt'")
    with pytest.raises(DeckError, match="g/cm.3, K, GPa, MJ/kg only"):
        read_yaml(text + "tableunits: {pressure: Pa}\n", "own", (tmp_path / "runs",))
    tables, left = deck_tables(read_yaml(text, "own", (tmp_path / "none", tmp_path / "runs")), "own")
    assert left == [] and [material["eos"]["law"] for material in tables["material"].values()] == ["table", "table"]
    final, velocity = last(ended(tmp_path, tables))
    assert np.max(np.abs(final.pressure.values[::8] - GAS_PRESSURE)) < 5e-3 * 1.6e6
    assert np.max(np.abs(velocity[::8] - GAS_VELOCITY)) < 1e-2 * 534.0
