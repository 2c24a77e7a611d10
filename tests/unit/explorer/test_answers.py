"""What the explorer answers is what the package computes: the same functions, the same digits."""

import contextlib
import json
import math
from types import SimpleNamespace

import numpy as np
import pytest
from explorer_words import TOKEN
from typer.testing import CliRunner

import hugoniot
from hugoniot.cli.main import build_app
from hugoniot.dossier import fits
from hugoniot.explorer import catalogue, curves, impact, subjects, tables
from hugoniot.materials import library, schema
from hugoniot.page import run_data
from hugoniot.theory.hugoniot import shock
from hugoniot.theory.impedance import match


def ask(client, question, **query):
    answer = client.get(f"/{TOKEN}/api/{question}", params=query)
    assert answer.status_code == 200 and "error" not in answer.json(), answer.text
    return answer.json()


def printed(*arguments):
    result = CliRunner().invoke(build_app("eos"), ["eos", *arguments, "--json"])
    assert result.exit_code == 0, result.output
    return json.loads(result.output)


# -- materials -------------------------------------------------------------------------------------------------------
def test_the_list_holds_every_material_and_every_row_once(client):
    found = ask(client, "materials")
    names = [m["name"] for m in found["materials"] + found["rows"]]
    assert len(names) == len(set(names)) and {row.id for row in schema.all_rows()} <= set(names) | {i for m in found["materials"] for i in _rows_of(m)}
    assert set(library.index()) <= set(names) and found["points"] == len(schema.points())
    copper = next(m for m in found["materials"] if m["name"] == "copper")
    assert copper["density"] == 8930.0 and copper["bulk_sound_speed"] == 3940.0 and copper["curated"]
    doubted = [m for m in found["materials"] if m["mark"]]
    assert doubted and all(m["source"] for m in found["materials"])


def _rows_of(material):
    return library.index()[material["name"]].rows if material["curated"] else ()


def test_a_state_is_that_of_the_command(client):
    for name, by, value, unit in (("copper", "particle_velocity", 1500.0, "m/s"), ("water", "pressure", 5e9, "Pa"), ("pmma", "shock_velocity", 4000.0, "m/s")):
        mine = ask(client, "state", name=name, by=by, value=value)["state"]
        theirs = printed("hugoniot", name, "--at", f"{by} = {value} {unit}")
        assert all(mine[key] == theirs[key] for key in ("pressure", "density", "particle_velocity", "shock_velocity", "specific_internal_energy", "temperature", "entropy"))


def test_curves_are_sampled_at_round_velocities_and_hold_the_commands_numbers(client):
    found = ask(client, "material", name="copper")
    up, step = found["hugoniot"]["particle_velocity"], found["hugoniot"]["particle_velocity"][1]
    assert len(up) <= curves.MOST + 1 and step == curves.round_step(up[-1]) and up[3] == pytest.approx(3 * step, rel=1e-11)
    theirs = printed("hugoniot", "copper", "--at", f"particle_velocity = {up[7]} m/s")
    assert all(found["hugoniot"][key][7] == pytest.approx(theirs[key], rel=2e-12) for key in ("pressure", "density", "shock_velocity", "temperature", "sound_speed", "entropy"))
    assert sum(len(m["up"]) for m in found["measured"]) > 100 and found["sources"] and len(found["releases"]) == 4
    for release in found["releases"]:
        assert release["pressure"][-1] == 0.0 and release["particle_velocity"][-1] > release["particle_velocity"][0]


@pytest.mark.parametrize("span", [0.3, 1.0, 1234.5, 3535.2, 9.99e5])
def test_steps_are_round_and_few(span):
    step = curves.round_step(span)
    assert span / step <= curves.MOST * (1 + 1e-9) and span / step > curves.MOST / 2.6
    assert round(step / 10 ** math.floor(math.log10(step) + 1e-9), 9) in (1.0, 2.0, 2.5, 5.0)


def test_an_explosive_has_products_gurney_and_pop_plot(client):
    found = ask(client, "material", name="comp_b")
    theirs = printed("cj", "comp_b")
    assert found["products"]["cj"]["pressure"] == theirs["pressure"] and found["products"]["cj"]["shock_velocity"] == theirs["detonation_velocity"]
    falling = np.array(found["products"]["isentrope"]["pressure"])
    assert falling[-1] == pytest.approx(1e5) and (np.diff(falling) < 0).all()
    assert found["gurney"]["value"] == 2700.0 and found["gurney"]["velocity"]["cylinder"][20] == pytest.approx(2700.0 / math.sqrt(1.0 + 0.5))
    assert found["pop"] and found["pop"][0]["pressure_high"] > found["pop"][0]["pressure_low"]


def test_every_material_of_the_library_has_curves_or_says_why():
    """A sample through the whole list; the export walks all of it."""
    listed = [m for m in catalogue.listing()["materials"] if m["alone"]]
    for material in listed[::60]:
        found = curves.curves_of(material["name"])
        assert found["hugoniot"] or found["products"] or found["notes"], material["name"]


def test_unknown_names_are_refused_with_the_nearest(client):
    answer = client.get(f"/{TOKEN}/api/material", params={"name": "coper"})
    assert answer.status_code == 200 and "copper" in answer.json()["error"][0]
    for query in ({"name": "copper", "by": "particle_velocity", "value": "nan"}, {"name": "copper", "by": "colour", "value": "1"}, {"name": "copper", "by": "pressure"},
                  {"name": "copper", "by": "particle_velocity", "value": "1e400"}, {"name": "x" * 100, "by": "pressure", "value": "1e9"}):
        assert list(client.get(f"/{TOKEN}/api/state", params=query).json()) == ["error"]


# -- impacts ---------------------------------------------------------------------------------------------------------
def test_a_match_is_that_of_the_command():
    mine = impact.impact(["tungsten", "copper", "pmma"], 800.0, 5.0)
    theirs = printed("match", "tungsten", "copper", "pmma", "--velocity", "800 m/s", "--error", "velocity = 5 m/s")
    for own, other in zip(mine["states"], theirs["states"], strict=True):
        assert own["interface"] == other["interface"]
        for key in ("pressure", "particle_velocity", "shock_velocity", "density"):
            assert own[key] == other[key] and own["uncertainty"][key] == other["uncertainty"][key]["sigma"]
    explosive, theirs = (answer["states"][0]["interface"] for answer in (impact.impact(["tnt", "copper"], 900.0), printed("match", "tnt", "copper", "--velocity", "900 m/s")))
    assert explosive == theirs == "tnt (unreacted)/copper"
    mine = impact.impact(["iron", "water"], 1500.0, 0.0, True)["states"][0]["uncertainty"]
    theirs = printed("match", "iron", "water", "--velocity", "1500 m/s", "--error", "library")["states"][0]["uncertainty"]
    assert all(mine[key] == theirs[key]["sigma"] for key in mine)
    with pytest.raises(hugoniot.errors.OutOfRange):
        impact.impact(["copper"], 800.0)


@pytest.mark.parametrize("layers, beyond", [(("U012", "M010"), ("U012", "M010")), (("copper", "lif"), ("lif",)), (("copper", "air"), ()), (("tnt", "copper"), ("tnt",))])
def test_a_match_is_warned_of_as_by_the_command(layers, beyond):
    """Data that end, data whose range is unknown, and a gas, of which nothing is said; the page gets the same words."""
    mine, theirs = impact.impact(layers, 9000.0)["warnings"], printed("match", *layers, "--velocity", "9 km/s")["warnings"]
    assert mine == theirs
    for name in layers:
        given = impact.layer(subjects.entry_of(name))["beyond"]
        said = given is not None and any(text.startswith(given["words"].partition("{up}")[0]) for text in mine)
        assert said == (name in beyond)


def test_a_wave_that_splits_is_said_to_in_matches_curves_and_states(client):
    """In porous aluminium behind a precursor of 7 m/s, as the command says; a shock faster than the precursor holds together."""
    theirs = " ".join(printed("match", "copper", "aluminum_porous", "--velocity", "1 km/s")["warnings"])
    mine = impact.impact(["copper", "aluminum_porous"], 1000.0)
    up = f"no single shock leads to up = {mine['states'][0]['particle_velocity']:.6g} m/s"
    assert up[:-5] in theirs and any(text.startswith(up) for text in mine["warnings"])
    split = ask(client, "layers")["aluminum_porous"]["split"]
    assert split["low"] == pytest.approx(7.05, abs=0.2) and split["high"] == pytest.approx(1653.0, abs=20.0)     # tests of theory.split
    assert any("no single shock exists" in text for text in curves.curves_of("aluminum_porous")["notes"])
    for value, splits in ((500.0, True), (1800.0, False)):
        found = ask(client, "state", name="aluminum_porous", by="particle_velocity", value=value)["warnings"]
        assert any("no single shock" in text for text in found) == splits and any("is not known" in text for text in found)
    assert not any("no single shock" in text for text in curves.curves_of("copper")["notes"])


def test_the_curve_of_strongly_porous_material_goes_on_beyond_its_highest_density(tmp_path):
    """Of distension 2.5, whose density falls again from 400 m/s on; up to which the elastic wave outruns it, from the law itself."""
    solid = "base = {law = 'mie_gruneisen', rho0 = 2700.0, c0 = 5350.0, s = 1.34, gamma0 = 2.0}"
    (tmp_path / "crumbs.toml").write_text(f"[eos]\nlaw = 'p_alpha'\nalpha0 = 2.5\nelastic_pressure = 1e7\ncompaction_pressure = 3e8\n{solid}\n")
    subjects.admit(tmp_path / "crumbs.toml")
    drawn = curves.curves_of("crumbs")["hugoniot"]
    assert drawn["particle_velocity"][-1] == pytest.approx(2000.0) and max(drawn["density"]) > drawn["density"][-1] * 1.02
    split = impact.layer(subjects.entry_of("crumbs"))["split"]
    assert float(shock(subjects.own["crumbs"].material, particle_velocity=split["high"]).shock_velocity) == pytest.approx(5350.0, rel=0.02)


def test_a_law_of_shocks_alone_has_no_releases(tmp_path, client):
    """Its pressure does not depend on the density: the command prints no Grüneisen parameter and calls releases meaningless."""
    (tmp_path / "kb.toml").write_text('[eos]\nlaw = "shock_energy"\nrho0 = 1770.0\nc0 = 3080.0\ns = 2.01\n')
    subjects.admit(tmp_path / "kb.toml")
    found, state = curves.curves_of("kb"), ask(client, "state", name="kb", by="particle_velocity", value=1000)
    assert found["releases"] == [] and found["isentrope"] is None and any("meaningless" in text for text in found["notes"])
    assert state["release"] is None and "gruneisen" not in state["state"] and any("meaningless" in text for text in state["warnings"])
    assert state["state"]["pressure"] == pytest.approx(1770.0 * (3080.0 + 2.01 * 1000.0) * 1000.0)


def test_the_page_is_given_every_material_that_a_shock_may_meet(client):
    """With the parameters of its law, to the last bit, so that the page computes what the command prints."""
    found = ask(client, "layers")
    assert len(found) > 400 and found["copper"]["law"] == {"$": "mie_gruneisen_linear_gamma", **library.find("copper").eos._asdict()}
    assert "only the detonation products" in next(entry["none"] for entry in found.values() if "none" in entry)
    assert found["iron"]["bands"]["names"] == ["c0", "s1", "s2"] and found["pbx_9501"]["burns"] and not found["copper"]["burns"]


def test_bands_of_the_librarys_fits_count_with_their_covariance():
    """Against Monte Carlo over the same covariance, by its own sampling."""
    found = impact.impact(["iron", "water"], 1500.0, 0.0, True)
    iron, water = library.find("iron"), library.find("water")
    draws, draw = [], np.random.default_rng(5)
    for _ in range(150):
        layers = []
        for material in (iron, water):
            names, covariance = fits.of_law(library.entry(material.name).rows, material.eos)
            values = [getattr(material.eos, n) for n in names]
            layers.append(material.eos._replace(**dict(zip(names, draw.multivariate_normal(values, covariance, method="svd").tolist()))))
        draws.append(match(layers, 1500.0)[0].pressure)
    assert found["states"][0]["uncertainty"]["pressure"] == pytest.approx(np.std(draws), rel=0.2)
    assert set(found["uncertain"]) == {"iron", "water"} and fits.of_law(library.entry("copper").rows, library.find("copper").eos) is None
    assert "uncertainty" not in impact.impact(["copper", "aluminum"], 1500.0, 0.0, True)["states"][0]


# -- runs ------------------------------------------------------------------------------------------------------------
def test_columns_of_a_run_are_those_of_its_file(client, tube):
    run = hugoniot.load(tube)
    said = ask(client, "run", run=0)
    assert said["times"] == run.arrays("snapshots")["time"].tolist() and not said["plane"] and said["zones"] == 40
    for name in [f["name"] for f in said["fields"]]:
        answer = client.get(f"/{TOKEN}/api/array", params={"run": 0, "group": "snapshots", "name": name})
        mine = np.frombuffer(answer.content, "<f8").reshape([int(n) for n in answer.headers["x-shape"].split(",")])
        rows = run.arrays("snapshots")
        theirs = rows[name] if name in rows else 0.5 * (rows[f"{name}_left"] + rows[f"{name}_right"])
        assert np.array_equal(mine, theirs), name
    time = np.frombuffer(client.get(f"/{TOKEN}/api/array", params={"run": 0, "group": "gauges", "name": "time"}).content, "<f8")
    assert np.array_equal(time, run.arrays("gauges")["time"])
    history = np.frombuffer(client.get(f"/{TOKEN}/api/array", params={"run": 0, "group": "snapshots", "name": "pressure", "zone": 7}).content, "<f8")
    assert np.array_equal(history, run.arrays("snapshots")["pressure"][:, 7])
    assert [r["last"] for r in said["regions"]] == [19, 39]


def test_long_runs_are_thinned_and_say_so(tube, monkeypatch):
    monkeypatch.setattr(run_data, "MOST_BYTES", 40 * 8 * 7)
    said, whole = run_data.description(tube), hugoniot.load(tube).arrays("snapshots")
    assert said["every"] == 3 and np.array_equal(said["times"], whole["time"][::3])
    found = run_data.column(tube, "snapshots", "pressure", {})
    assert np.array_equal(found, whole["pressure"][::3]) and found.base is None     # a view would keep the whole column in memory


# -- tables and the command ------------------------------------------------------------------------------------------
def test_a_table_of_cases_keeps_numbers_words_and_units(client):
    found = ask(client, "sweep", sweep=0)
    assert [(c["name"], c["unit"], c["numeric"]) for c in found["columns"]] == [
        ("case", "", False), ("velocity", "m/s", True), ("peak", "GPa", True), ("<b>note</b>", "", False)]
    assert found["columns"][1]["cells"] == [100, 200, 300] and found["rows"] == 3 and found["runs"] == []


def test_a_row_of_more_values_than_columns_is_refused(tmp_path):
    """A decimal comma: 1,5 would be 1 in one column and 5 in the next."""
    (tmp_path / "cases.csv").write_text("velocity [m/s],peak (GPa)\n100,1.5\n200,2,5\n")
    with pytest.raises(hugoniot.errors.FileTrouble, match="row 2: values: 3, column headers: 2"):
        tables.table(tmp_path / "cases.csv")


def test_a_sweep_says_all_that_the_terminal_says(tmp_path):
    """Its warnings, sensitivity indices and spreads, from the files that the sweep has written."""
    from hugoniot.campaign.ask import Wishes, run_sweep
    from hugoniot.campaign.questions import question_of
    from hugoniot.cli.sweep import _record

    @contextlib.contextmanager
    def here(question, known):
        asked = question_of(question)
        yield SimpleNamespace(run=lambda tasks: ({"case": case, **asked.answer(changes, set(known))} for case, changes in tasks))

    varied = ["velocity = 4 +- 0.1 km/s", "material.copper.eos.c0 = 3.94 +- 0.02 km/s"]
    wishes = Wishes(match=["copper", "U012"], vary=varied, design="saltelli", samples=8, output=["pressure"])
    told = _record(run_sweep(None, wishes, tmp_path / "s", engine=here, report=False))
    found = tables.table(tmp_path / "s" / "cases.csv")
    assert found["warnings"] == told["warnings"] and "the range of the data of U012" in " ".join(found["warnings"])
    said = {each["title"].partition(" ")[0]: {c["name"]: c["cells"] for c in each["columns"]} for each in found["tables"]}
    assert said["Sensitivity"]["total"] == pytest.approx([row["total"] for row in told["sensitivity"]])
    assert said["Spread"]["mean"] == [row["mean"] for row in told["spread"]] and set(said) == {"Sensitivity", "Spread"}


def test_a_case_opens_the_run_beside_its_table(client, places, tube, tmp_path):
    (tmp_path / "table" / "run1").symlink_to(tmp_path / "table" / "real")
    (tmp_path / "table" / "real").mkdir()
    (tmp_path / "table" / "real" / "deck.toml").write_text("title = 'x'")
    assert ask(client, "sweep", sweep=0)["runs"] == [1]
    assert client.post(f"/{TOKEN}/api/case?sweep=0&row=1").json() == {"run": 1}


def test_the_runs_that_a_sweep_kept_are_found_by_their_results(tube, tmp_path):
    """A table and a journal as `hugoniot sweep --keep` writes them, in another order than the cases."""
    from hugoniot.campaign.journal import Journal

    answers = [{"key": f"{k:032x}", "numbers": {"peak": 0.1 + 0.2 * k, "arrival": float("nan") if k == 2 else 1e-6 / (k + 1)}} for k in range(4)]
    with Journal(tmp_path / "cases.jsonl") as journal:
        for k in (2, 0, 3, 1):
            journal.add(answers[k])
            (tmp_path / "runs" / answers[k]["key"]).mkdir(parents=True)
            (tmp_path / "runs" / answers[k]["key"] / "deck.toml").write_text("")
    (tmp_path / "runs" / answers[1]["key"] / "deck.toml").unlink()
    rows = [f"{k + 1},{100.0 * k},{a['numbers']['peak']!r},{a['numbers']['arrival']!r}," for k, a in enumerate(answers)]
    (tmp_path / "cases.csv").write_text("\n".join(["case,velocity [m/s],peak [Pa],arrival [s],reason", *rows, "5,400.0,,,no deck"]) + "\n")
    assert tables.table(tmp_path / "cases.csv")["runs"] == [0, 2, 3]
    assert [tables.run_of_case(tmp_path / "cases.csv", k).name for k in (0, 2, 3)] == [answers[k]["key"] for k in (0, 2, 3)]


def test_arguments_of_the_command_are_sorted(places, tmp_path):
    from hugoniot.errors import DeckError, FileTrouble
    from hugoniot.explorer.places import places_of

    assert [len(places.runs), len(places.sweeps), len(places.decks), places.materials] == [1, 1, 1, ["copper"]]
    assert len(places_of([str(places.runs[0].path.parent)]).runs) == 1
    for text, error in (("nowhere.run", FileTrouble), (str(tmp_path), FileTrouble), ("kopper", DeckError), ("no/such", FileTrouble)):
        (tmp_path / "deck.toml").unlink(missing_ok=True)
        with pytest.raises(error):
            places_of([text])


def test_the_pop_plot_of_a_material_of_a_file_is_that_of_the_explosive_it_is_based_on(tmp_path, monkeypatch):
    monkeypatch.setattr(subjects, "own", {})
    path = tmp_path / "charge.toml"
    path.write_text('[material.charge]\nbase = "PBX 9404"\n[material.other_reactive]\nbase = "copper"\n')
    assert subjects.admit(path) == ["charge", "other_reactive"]
    assert [line["row"] for line in curves.curves_of("charge")["pop"]] == [row.id for row in library.pop_lines("PBX 9404")] != []
    assert curves.curves_of("other_reactive")["pop"] == []
