"""The library keeps its own rules: every row, every measured state, every curated material, every name."""

import csv
import math
import os
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import second_routes
from pace import in_starts

from hugoniot.dossier import checks, derived, fits
from hugoniot.dossier.describe import described, summary
from hugoniot.laws.eos.contract import EOS, pressure, reference_state
from hugoniot.laws.eos.jwl import JWL
from hugoniot.materials import library, marks, schema
from hugoniot.materials.counts import known
from hugoniot.materials.record import material_record
from hugoniot.problem.deck import read_deck_text
from hugoniot.theory.chapman_jouguet import cj

ISSUE = """aluminium 1100, aluminum 2024, al6061, 7075-T6, copper, iron, ss304, 4340, tungsten, tantalum, titanium, Ti-6Al-4V, beryllium,
magnesium, lead, tin, uranium, gold, silver, nickel, zinc, molybdenum, water, PMMA, polycarbonate, polyethylene, epoxy, Teflon, LiF,
quartz, fused silica, basalt, granite, ice, soil, sand, foam, air, argon, helium, nitrogen, TNT, Comp B, PETN, HMX, RDX, PBX-9404,
PBX-9501, PBX-9502, LX-14, LX-17, C-4, pentolite, nitromethane, ANFO"""


@pytest.fixture(scope="module")
def findings():
    return checks.check_all()


def test_no_rule_is_broken(findings):
    assert [f for f in findings if f.verdict == "fail"] == []
    assert len(findings) > 7000


def test_every_misfit_is_seen_where_the_row_is_used(findings):
    """A mark a check computes for a row of products or reactants must be among the sentences shown wherever that row is used."""
    bad = [f for f in findings if f.verdict == "mark" and f.check.startswith(("CJ closure of", "constants of an unreacted")) and not math.isnan(f.value)]
    assert {f.where for f in bad} >= {"J001", "J003", "J005", "J010", "J013", "J040", "J045"}
    for finding in bad:
        said = " ".join(marks.marks(schema.row(finding.where)))
        assert "does not reproduce its stated CJ state" in said or "does not give zero pressure" in said, finding


def test_closures_repeat_the_recorded_ones():
    """The CJ states entered when the tables were made came from another program."""
    rows = [r for r in schema.table("jwl").values() if "recorded_d" in r]
    assert len(rows) >= 50
    for row in rows:
        state = derived.closure(row.id)
        assert state.closes == marks.recorded_closure(row).closes
        assert state.velocity == pytest.approx(row["recorded_d"], rel=1.5e-5), row.id
        assert state.pressure == pytest.approx(row["recorded_p"], rel=5e-5), row.id


@pytest.mark.parametrize("identity, velocity, gigapascal", [("J009", 7980.0, 29.5), ("J011", 8800.1, 37.001), ("J002", 6929.4, 21.0),
                                                            ("J074", 7589.6, 29.894), ("J012", 8300.8, 33.509)])
def test_closure_against_the_verification_list(identity, velocity, gigapascal):
    """Values computed elsewhere from constants given to four digits."""
    state = derived.closure(identity)
    assert state.velocity == pytest.approx(velocity, rel=2.5e-5)
    assert state.pressure == pytest.approx(gigapascal * 1e9, rel=5e-5)


def test_closure_is_a_minimum_of_the_detonation_velocity():
    """The CJ state is also where the velocity of the Rayleigh line to the Hugoniot is least: found without any sound speed."""
    row = schema.row("J009")
    par = JWL(row["a"], row["b"], row["r1"], row["r2"], row["omega"], row["rho0"], row["e0"])
    rho = row["rho0"] * np.linspace(1.2, 1.6, 40001)
    p = np.array([second_routes.hugoniot_pressure(r, row["rho0"], row["e0"] / row["rho0"], par) for r in rho])
    speed = np.sqrt(p / (1.0 - row["rho0"] / rho) / row["rho0"])
    point = cj(par)
    assert speed.min() == pytest.approx(point.detonation_velocity, rel=1e-8)
    assert rho[speed.argmin()] == pytest.approx(point.state.density, rel=2e-4)


def test_misprints_are_caught():
    """Two digits of A exchanged, a unit slip in c0, a missing source, a hidden recollection: the rules must not pass them."""
    good = schema.row("J009")
    par = JWL(542.2e9, good["b"], good["r1"], good["r2"], good["omega"], good["rho0"], good["e0"])
    assert good["a"] == 524.2e9
    assert abs(cj(par).detonation_velocity / 7980.0 - 1.0) > marks.VELOCITY_LIMIT
    from dataclasses import replace
    copper = schema.row("U007")
    slipped = replace(copper, values={**copper.values, "c0": 3.94})
    assert any(f.verdict == "fail" and f.check == "range of c0" for f in checks.check_row(slipped))
    assert any(f.verdict == "fail" and f.check == "provenance" for f in checks.check_row(replace(copper, source="")))
    hidden = replace(copper, status="verified", via="recalled, unverified")
    assert any(f.verdict == "fail" and f.check == "provenance" for f in checks.check_row(hidden))


# -- names -------------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("name", [n.strip() for n in ISSUE.replace("\n", " ").split(",")])
def test_every_material_asked_for_is_found(name):
    assert library.entry(name).curated


@pytest.mark.parametrize("spelled, name", [
    ("al6061", "aluminum_6061"), ("aluminum 6061-T6", "aluminum_6061"), ("aluminium 6061", "aluminum_6061"), ("AL 6061", "aluminum_6061"),
    ("Cu", "copper"), ("OFHC copper", "copper"), ("Plexiglas", "pmma"), ("Lucite", "pmma"), ("H2O", "water"), ("comp-b", "comp_b"),
    ("PBX 9404", "pbx_9404"), ("ti64", "ti_6al_4v"), ("ss304", "steel_304"), ("PTFE", "teflon"), ("U007", "U007")])
def test_spellings(spelled, name):
    assert library.find(spelled).name == name


def test_every_alias_finds_its_material():
    for listing in library.index().values():
        for text in (listing.name, listing.title, *listing.aliases):
            assert library.find(text).name == listing.name


def test_unknown_names_offer_near_ones():
    with pytest.raises(library.UnknownMaterial, match="copper"):
        library.find("coper")
    with pytest.raises(KeyError):
        library.find("unobtainium")
    with pytest.raises(library.UnknownMaterial, match="Soda-lime glass"):
        library.find("soda lime glas")


def test_a_name_with_several_uncurated_sources_asks_which():
    name = next(k for k, rows in library.uncurated().items() if len(rows) > 1)
    with pytest.raises(library.UnknownMaterial, match=" and ".join(library.uncurated()[name][:1])):
        library.find(name)


def test_counts():
    counts = summary()
    assert counts["curated_materials"] >= 50
    assert counts["searchable_materials"] >= 430
    recalled = sum(r.status == "recalled" for r in schema.all_rows())
    assert counts["rows_unverified_against_print"] == recalled == 47
    assert counts["measured_states"] == 1954


def test_the_page_on_provenance_counts_as_the_library_does():
    text = " ".join((Path(__file__).parents[2] / "docs" / "materials" / "provenance.md").read_text(encoding="utf-8").split())
    rows, ranges, states, deviations, errors, presses, highest, spread, spall = known().values()
    assert f"Of {rows} Us-up rows {ranges} have a range in particle velocity: * For {states} of them the range is that of the measured states" in text
    assert f"{deviations} rows have a deviation of the shock velocities and {errors} have standard deviations of c0 and s" in text
    assert f"Of {presses} static compressions {highest} have a highest pressure and {spread} a standard deviation" in text
    used = [name for name in library.index() if library.find(name).fracture is not None]
    assert f"{spall} rows have a spall strength" in text and f". {len(used)} curated materials use one" in text
    assert f"has {summary()['measured_states']} states" in text and f"{rows - ranges} rows have no range" in text
    table = re.findall(r"\| (\d+) \| [^|]+\|", text[text.index("rows have no range"):text.index("No public copy")])
    assert sum(map(int, table)) == rows - ranges


def test_curated_files_and_index_agree():
    files = {p.stem for p in (library.HERE / "curated").glob("*.toml")}
    assert files == set(library.index())


# -- what every curated material owes ----------------------------------------------------------------------------
@pytest.mark.parametrize("name", library.names())
def test_a_curated_material_tells_everything(name):
    entry = library.entry(name)
    material = entry.material
    assert entry.reasons["eos"], "no reason for the choice"
    assert entry.missing, "nothing is said to be missing: no material is that complete"
    record = material_record(material)
    for constant in record:
        assert constant["source"] not in ("", "not stated"), constant
        assert constant["status"] in (*schema.STATUSES, "default"), constant
    for s in material.sources:
        if s.status == "recalled":
            assert any(schema.UNVERIFIED in w for w in material.warnings), "a recalled constant without its mark"
    for place, identity in enumerate(entry.rows):      # of the rows after the first single constants are used, and no Us-up fit
        for mark in marks.marks(schema.row(identity), "" if place == 0 else "gamma0"):
            assert mark in material.warnings
    assert described(entry)["constants"] == record


def test_every_material_survives_a_deck():
    """A deck that names a material, written out and read again, has the same material: laws, numbers, sources, warnings."""
    deck = 'geometry = "planar"\nstop_time = "1 us"\n[[region]]\nname = "a"\nmaterial = "{0}"\nfrom = "0 mm"\nto = "1 mm"\nzones = 10\n'
    for name in library.names():
        lit = '[[lighting]]\nat = "0 mm"\n' if library.find(name).burn is not None else ""
        first = read_deck_text(deck.format(name) + lit)
        again = read_deck_text(first.resolved)
        assert repr(again.problem.materials[name]) == repr(first.problem.materials[name]), name


def test_reference_states_have_no_pressure():
    for entry in library.find_all():
        law = EOS.of(entry.material.eos)
        if not {"gas", "reacted"} & law.flags:
            assert abs(pressure(*reference_state(entry.material.eos), entry.material.eos)) < 1e-3


def test_gases_rest_at_one_atmosphere():
    for name in ("air", "argon", "helium", "nitrogen"):
        par = library.find(name).eos
        assert pressure(*reference_state(par), par) == pytest.approx(101325.0, rel=1e-12)


def test_specific_heat_conversion_agrees_with_an_independent_table():
    """c_v made from Steinberg's c_p against the c_v Kinslow prints for the same metals."""
    for mine, theirs in (("copper", "U058"), ("aluminum_2024", "U057"), ("tantalum", "U067"), ("magnesium_az31b", "U061")):
        assert library.find(mine).eos.specific_heat == pytest.approx(schema.row(theirs)["heat_capacity"], rel=0.035)


# -- the data the package carries --------------------------------------------------------------------------------
def test_disagreements_that_matter_are_what_the_sources_say():
    """Iron's line that lost its quadratic term, water's lines, copper."""
    iron, line = fits.recorded("U208"), schema.row("U165")
    assert derived.shock_velocity(line, 2500.0) / iron(2500.0) - 1.0 == pytest.approx(0.055, abs=0.002)
    assert iron.coefficients[1] == pytest.approx(1.914, abs=5e-4) and iron.deviations[1] == pytest.approx(0.146, abs=5e-4)
    water = fits.recorded("U205")
    for row, low, high in (("U110", 0.0, 0.11), ("U178", 0.09, 0.11)):
        assert low < derived.shock_velocity(schema.row(row), 2500.0) / water(2500.0) - 1.0 < high
    copper = fits.recorded("U202")
    assert (len(copper.points), round(copper.coefficients[0]), round(copper.coefficients[1], 3)) == (141, 3900, 1.517)


def test_quartz_quadratic_follows_its_curve():
    misfit = [derived.shock_velocity(schema.row("U216"), up) / derived.shock_velocity(schema.row("U160"), up) - 1.0
              for up in np.linspace(5000.0, 16000.0, 45)]
    assert 0.001 < max(map(abs, misfit)) < 0.002


def test_data_are_small_and_travel_with_the_package():
    folder = Path(library.__file__).parent
    assert sum(f.stat().st_size for f in folder.rglob("*") if f.is_file()) < 2_000_000
    for file in (folder / "data").glob("*.csv"):
        with open(file, newline="", encoding="utf-8") as handle:
            head = next(csv.reader(handle))
        assert "source" in head or file.stem == "crosscheck", file.name


def test_ids_are_unique_and_notes_are_clean():
    ids = [r.id for r in schema.all_rows()]
    assert len(ids) == len(set(ids)) >= 780
    assert all(r.id[0] in schema.TABLES for r in schema.all_rows())


def test_showing_a_material_answers_at_once(tmp_path):
    """Eight times the import of the command line's library at the most (0.5 s where that takes 0.06 s; benchmarks/answers.py has seconds).

    With the interpreter's compiled files, which some environments forbid: compiling the sources anew costs 0.2 s of each start.
    """
    env = {k: v for k, v in os.environ.items() if k != "PYTHONDONTWRITEBYTECODE"} | {"PYTHONPYCACHEPREFIX": str(tmp_path)}
    assert in_starts([["-m", "hugoniot.cli.main", "material", "show", "copper"]], ["-c", "import typer"], rounds=3, check=True, env=env)[0] < 8.0


def test_showing_a_material_imports_nothing_slow():
    code = ("import sys; from hugoniot.cli.main import main\n"
            "try: main(['material', 'show', 'copper', '--json'])\nexcept SystemExit: pass\n"
            "bad = {'numba', 'scipy', 'matplotlib', 'pandas', 'pint', 'xarray', 'h5py'} & set(sys.modules)\n"
            "sys.stderr.write('slow:' + ','.join(sorted(bad)))")
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stderr == "slow:" and '"copper"' in done.stdout
