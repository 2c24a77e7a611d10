"""Sweeps: the numbers are those of `hugoniot run`, nothing is run twice, failures are rows, and the table depends on the plan alone."""

import csv
import json
import os
import pathlib
import random
import shutil

import matplotlib.pyplot as plt
import numpy as np
import pytest
from faults import flip
from typer.testing import CliRunner

import hugoniot
from hugoniot.campaign.ask import Wishes, run_sweep
from hugoniot.campaign.numbers import numbers_of, unit_of
from hugoniot.campaign.sweep import CASES, JOURNAL, TABLE
from hugoniot.cli.main import build_app, main
from hugoniot.errors import DeckError, FileTrouble
from hugoniot.explorer import tables
from hugoniot.output.run_numbers import warnings_of
from hugoniot.output.sweep_file import open_sweep
from hugoniot.output.verify import verify
from hugoniot.plotting.sweep import draw
from hugoniot.problem import catalogue

EXAMPLES = pathlib.Path(__file__).parents[3] / "examples"
SPEEDS = "region.flyer.velocity = 500..900 m/s : 3"


def swept(deck, out, inline, report=False, **wishes):
    return run_sweep(deck, Wishes(**wishes), out, engine=inline, report=report)


def bytes_of(folder):
    return [(folder / name).read_bytes() for name in (CASES, TABLE)]


def test_a_case_has_the_numbers_of_a_run(deck, tmp_path, inline):
    deck.write_text(deck.read_text().replace("zones = 8\n", "zones = 20\n").replace("zones = 16\n", "zones = 40\n"))   # fine enough for a reading
    table = swept(deck, tmp_path / "s", inline, vary=[SPEEDS]).table
    run = hugoniot.run(deck, tmp_path / "one.run", report=False, **{"region.flyer.velocity": "700 m/s"})
    alone = numbers_of(run)
    assert {c.name: c.values[1] for c in table.results if not np.isnan(c.values[1])} == {k: v for k, v in alone.items() if v == v}
    assert alone["spall.pull_back"] > 10.0 and unit_of("spall.pull_back") == "m/s" and unit_of("free surface.arrival") == "s"
    assert alone["free surface.plateau_velocity"] == pytest.approx(700.0, rel=0.03)


def test_a_lower_bound_is_not_called_a_spall_strength(tmp_path, inline):
    """The flyer of the templates: its elastic front erodes more than the pull-back, and says nothing about the 1 GPa of its deck."""
    path = tmp_path / "flyer.toml"
    path.write_text(catalogue.deck_text("flyer").replace("zones = 200", "zones = 100").replace("zones = 400", "zones = 200"))
    table = swept(path, tmp_path / "s", inline, vary=["region.flyer.velocity = 600, 700 m/s"], output=["spall.*"]).table
    names = {column.name: column.values for column in table.results}
    assert np.all((names["spall.spall_strength_at_least"] > 0.2e9) & (names["spall.spall_strength_at_least"] < 1e9))
    assert not {"spall.spall_strength_acoustic", "spall.spall_strength_stepanov"} & set(names)
    assert unit_of("spall.spall_strength_at_least") == "Pa"


def test_the_table_opens_with_parameters_as_coordinates(deck, tmp_path, inline):
    swept(deck, tmp_path / "s", inline, vary=[SPEEDS, "material.al.fracture.strength = 1, 2 GPa"], record=["free surface.velocity"],
          tie=["region.target.to = region.flyer.to + 4 mm"], output=["*.arrival", "spall.*"])
    found = open_sweep(tmp_path / "s" / TABLE)
    assert found["free surface.arrival"].dims == ("region.flyer.velocity", "material.al.fracture.strength")
    assert found["region.flyer.velocity"].values.tolist() == [500.0, 700.0, 900.0]
    assert found["material.al.fracture.strength"].attrs["units"] == "Pa"
    assert np.all(found["region.target.to"] == 0.006) and "region.target.to" in found.coords
    assert "free surface.peak_velocity" not in found
    record = found["record free surface.velocity"].sel({"region.flyer.velocity": 900.0})
    assert record.sizes["time"] == 400 and float(record.max()) == pytest.approx(900.0, rel=0.08)
    faster = found["free surface.arrival"].values
    assert np.all(np.diff(faster, axis=0) < 0.0)      # a stronger shock comes sooner


def test_records_go_as_far_as_the_longest_case(deck, tmp_path, inline):
    table = swept(deck, tmp_path / "s", inline, vary=["stop_time = 1.2, 1.8 us"], record=["free surface.velocity"]).table
    assert table.times[-1] == 1.8e-6
    short, long = table.records[0].values
    assert np.isnan(short[table.times > 1.2001e-6]).all() and np.isfinite(long).all()


def test_the_table_of_cases_can_be_asked_again(deck, tmp_path, inline):
    swept(deck, tmp_path / "s", inline, vary=[SPEEDS], output=["free surface.arrival"])
    rows = list(csv.reader((tmp_path / "s" / CASES).open()))
    assert rows[0] == ["case", "region.flyer.velocity [m/s]", "free surface.arrival [s]", "reason"]
    table = tmp_path / "cases.csv"
    table.write_text("\n".join(",".join(row[1:2]) for row in rows))
    again = swept(deck, tmp_path / "s", inline, design=str(table), output=["free surface.arrival"])
    assert again.progress.known == 3
    assert again.table.column("free surface.arrival").values.tolist() == [float(row[2]) for row in rows[1:]]


def test_what_has_run_is_not_run_again(deck, tmp_path, inline):
    first = swept(deck, tmp_path / "s", inline, vary=[SPEEDS])
    before = bytes_of(tmp_path / "s")
    assert inline.worked_out == 3 and first.progress.known == 0
    deck.write_text("# a remark changes nothing\n" + deck.read_text())
    assert swept(deck, tmp_path / "s", inline, vary=[SPEEDS]).progress.known == 3
    assert inline.worked_out == 3 and bytes_of(tmp_path / "s") == before
    larger = swept(deck, tmp_path / "s", inline, vary=["region.flyer.velocity = 500..900 m/s : 5"])
    assert inline.worked_out == 5 and len(larger.table) == 5
    deck.write_text(deck.read_text().replace("1.0 GPa", "1.1 GPa"))
    swept(deck, tmp_path / "s", inline, vary=[SPEEDS])
    assert inline.worked_out == 8


def test_a_torn_journal_loses_its_last_line_only(deck, tmp_path, inline):
    swept(deck, tmp_path / "s", inline, vary=[SPEEDS])
    before, journal = bytes_of(tmp_path / "s"), tmp_path / "s" / JOURNAL
    data = journal.read_bytes()
    for cut in (len(data) - 1, data.rindex(b"\n", 0, len(data) - 1) + 20, len(data) - 200):
        journal.write_bytes(data[:cut])
        inline.worked_out = 0
        swept(deck, tmp_path / "s", inline, vary=[SPEEDS])
        assert inline.worked_out == 1 and bytes_of(tmp_path / "s") == before
    journal.write_bytes(data.replace(b'"spall.pull_back": ', b'"spall.pull_back": 1', 1))      # somebody's hand: the checksum notices
    inline.worked_out = 0
    swept(deck, tmp_path / "s", inline, vary=[SPEEDS])
    assert inline.worked_out == 1 and bytes_of(tmp_path / "s") == before
    for torn in (b"", b'{"format": "hug'):      # killed as it began
        journal.write_bytes(torn)
        swept(deck, tmp_path / "s", inline, vary=[SPEEDS])
        assert bytes_of(tmp_path / "s") == before


@pytest.mark.parametrize("name", ["cases.csv", "sweep.h5", "sweep.json", "report.html", "constants.csv", "cases.jsonl", ".cases.csv.part", "runs"])
def test_a_file_that_no_sweep_wrote_is_not_replaced(deck, tmp_path, inline, name):
    (tmp_path / "s").mkdir()
    (tmp_path / "s" / name).write_text("precious")
    with pytest.raises(FileTrouble, match="no cases.jsonl written by a sweep, so it is not recognised as the folder of one"):
        swept(deck, tmp_path / "s", inline, vary=[SPEEDS])
    assert {path.name: path.read_text() for path in (tmp_path / "s").iterdir()} == {name: "precious"}


def test_each_flip_in_a_finished_sweep_is_found(deck, tmp_path, inline):
    """Before HDF5 or a page reads the damaged file."""
    swept(deck, tmp_path / "s", inline, vary=[SPEEDS], design="lhs", samples=3, report=True)
    names = sorted(path.name for path in (tmp_path / "s").iterdir())
    assert names == ["cases.csv", "cases.jsonl", "report.html", "spread.csv", "sweep.h5", "sweep.json"]
    assert [f.file for f in verify(tmp_path / "s") if f.state == "sound"] and not any(f.bad for f in verify(tmp_path / "s"))
    chance, readers = random.Random(5), {TABLE: open_sweep, "cases.csv": tables.table}
    for k in range(120):
        path = tmp_path / "s" / names[k % len(names)]
        data = path.read_bytes()
        flip(path, chance)
        assert [f.file for f in verify(tmp_path / "s") if f.bad] == [path.name], k
        for name, read in readers.items():
            if path.name in (name, "sweep.json"):
                with pytest.raises(FileTrouble, match="changed since it was written"):
                    read(tmp_path / "s" / name)
        path.write_bytes(data)


def test_a_failing_case_is_a_row_with_its_reason(deck, tmp_path, inline):
    found = swept(deck, tmp_path / "s", inline, vary=["region.flyer.to = 1, 2, 3 mm"], report=True)
    assert [bool(reason) for reason in found.table.reasons] == [False, False, True]
    assert "deck: region" in found.table.reasons[2] and found.progress.failed == 1
    assert np.isnan(found.table.column("free surface.arrival").values[2])
    page = (tmp_path / "s" / "report.html").read_text()
    assert "Cases that failed" in page and "<svg" in page


def test_a_tie_without_a_value_is_a_failing_case(deck, tmp_path, inline):
    found = swept(deck, tmp_path / "s", inline, vary=["x = 1..2 : 2"], tie=["region.flyer.velocity = 500 m/s / (x - 1)"])
    assert found.table.reasons == ("tie: '500 m/s / (x - 1)' does not give a finite number", "")


def test_a_tied_face_may_move_inwards(deck, tmp_path, inline):
    """Thinner than in the deck, the flyer ends where the target begins; with the change of the target alone they would overlap."""
    tie = ["region.target.from = region.flyer.to", "region.target.to = region.flyer.to + 4 mm"]
    found = swept(deck, tmp_path / "s", inline, vary=["region.flyer.to = 1.5, 2 mm"], tie=tie)
    assert found.table.reasons == ("", "")


def test_full_runs_are_kept_where_asked(deck, tmp_path, inline):
    out = tmp_path / "s"
    table = swept(deck, out, inline, vary=["region.flyer.velocity = 500, 700 m/s"], keep=True).table
    runs = sorted((out / "runs").iterdir())
    assert len(runs) == 2 and all((run / "summary.json").is_file() for run in runs)
    speeds = {float(hugoniot.load(run).gauge("velocity", "free surface")[1].max()) for run in runs}
    assert speeds == set(table.column("free surface.peak_velocity").values)
    shutil.rmtree(runs[0])
    inline.worked_out = 0
    swept(deck, out, inline, vary=["region.flyer.velocity = 500, 700 m/s"], keep=True)
    assert inline.worked_out == 1 and runs[0].is_dir()


def test_a_material_of_the_library_can_be_varied(deck, tmp_path, inline):
    text = deck.read_text()
    deck.write_text(text[:text.index("[material.al.eos]")].replace('"al"', '"aluminum 6061-t6"') + text[text.index("[[gauge]]"):])
    found = swept(deck, tmp_path / "s", inline, vary=["material.aluminum 6061-t6.strength.yield_stress = 0.1, 0.6 GPa"])
    assert found.table.reasons == ("", "")
    low, high = found.table.column("free surface.arrival").values
    assert low != high


def test_a_match_is_varied_too(tmp_path, inline):
    from hugoniot.materials.library import find
    from hugoniot.theory.impedance import match

    table = swept(None, tmp_path / "m", inline, match=["copper", "aluminum"],
                  vary=["velocity = 500, 1000 m/s", 'target = "aluminum", "iron"']).table
    for k in range(4):
        layers = [find("copper"), find(str(table.column("target").values[k]))]
        wanted = match(layers, float(table.column("velocity").values[k]))[0]
        assert table.column("pressure").values[k] == wanted.pressure
    stiffer = swept(None, tmp_path / "m", inline, match=["copper", "aluminum"], vary=["velocity = 500 m/s", "material.copper.eos.c0 = 3, 4 km/s"])
    assert np.diff(stiffer.table.column("pressure").values) > 0.0


@pytest.mark.parametrize("name, kind, stop", [
    ("sod.toml", "fronts", None),
    pytest.param("flyer-disc.toml", None, "0.1 us", marks=pytest.mark.slow),        # compiles two dimensions
    pytest.param("argon-mach9.toml", None, "0.02 ns", marks=pytest.mark.slow),      # and viscous flow
])
def test_every_solver_gives_the_numbers_of_its_runs(name, kind, stop, tmp_path, inline):
    from hugoniot.problem.deck import read_deck

    deck = tmp_path / name
    deck.write_text((EXAMPLES / name).read_text() + (f'\n[solver]\nkind = "{kind}"\n' if kind else ""))
    stop = stop or f"{0.5 * read_deck(deck).problem.stop_time!r} s"
    table = swept(deck, tmp_path / "s", inline, vary=[f"stop_time = {stop}"]).table
    assert table.reasons == ("",)
    alone = numbers_of(hugoniot.run(deck, tmp_path / "one.run", report=False, stop_time=stop))
    assert {c.name: c.values[0] for c in table.results if c.values[0] == c.values[0]} == {k: v for k, v in alone.items() if v == v}


def test_sweeps_can_stand_in_files(deck, tmp_path, inline):
    plan = tmp_path / "speeds.toml"
    plan.write_text(f'[sweep]\ndeck = "{deck.name}"\nvary = ["{SPEEDS}"]\noutput = ["*.arrival"]\n')
    alone = swept(plan, tmp_path / "s", inline).table
    deck.write_text(deck.read_text() + f'[sweep]\nvary = ["{SPEEDS}"]\n')
    inside = swept(deck, tmp_path / "t", inline, output=["*.arrival"]).table
    assert [c.name for c in alone.results] == ["free surface.arrival", "free surface left.arrival"]
    assert np.array_equal(alone.results[0].values, inside.results[0].values)
    asked = json.loads((tmp_path / "s" / "sweep.json").read_text())
    assert asked["vary"] == [SPEEDS]


@pytest.mark.parametrize("wishes, words", [
    ({"vary": ["region.flier.velocity = 1..2 km/s : 2"]}, "no region 'flier'; did you mean 'flyer'"),
    ({"vary": ["region.flyer.velocty = 1..2 km/s : 2"]}, "unknown key; did you mean 'velocity'"),
    ({"vary": ["region.flyer.velocity = 1..2 mm : 2"]}, "region.flyer.velocity: expected a velocity, got a length"),
    ({"vary": ["regions.flyer.velocity = 1..2 mm : 2"]}, "no such key in the deck; did you mean 'region'"),
    ({"vary": ["material.cu.eos.s = 1..2 : 2"]}, "no material 'cu'"),
    ({"vary": ["material.al.eos.c1 = 1..2 : 2"]}, "material.al.eos.c1: unknown"),
    ({"vary": ["stop_tme = 1..2 us : 2"]}, "not a key of the deck, and no tie uses it; did you mean 'stop_time'"),
    ({"vary": ["x = 1..2 : 2"]}, "not a key of the deck, and no tie uses it"),
    ({"vary": ["x = 1..2 : 2"], "tie": ["region.flyer.zones = x * y"]}, "'y' is neither a key of the deck nor varied"),
    ({"vary": ["x = 1..2 mm : 2"], "tie": ["region.flyer.velocity = x"]}, "expected a velocity"),
    ({"vary": ["x = 1..2 mm : 2"], "tie": ["region.flyer.to = x + region.flyer.velocity"]}, "different kinds"),
    ({"vary": [SPEEDS], "tie": ["region.flyer.velocity = 2 m/s"]}, "given twice"),
    ({"vary": [SPEEDS], "tie": ["region.flyer.velocity"]}, "expected KEY = EXPRESSION"),
    ({"vary": [SPEEDS], "record": ["surface.velocity"]}, "no such gauge.*'free surface.velocity'"),
    ({"vary": [SPEEDS], "output": ["*.arival"]}, "no result has such a name"),
    ({"vary": [SPEEDS], "match": ["copper"]}, "needs a flyer and a target"),
    ({"vary": ["speed = 1..2 km/s : 2"], "match": ["copper", "iron"]}, "not an input of the match, and no tie uses it; the inputs are velocity, flyer"),
    ({"vary": ["velocity = 1..2 mm : 2"], "match": ["copper", "iron"]}, "expected a velocity"),
    ({"vary": ["material.zinc.eos.c0 = 1..2 km/s : 2"], "match": ["copper", "iron"]}, "an impedance match has no such input"),
    ({"vary": ["velocity = 1..2 km/s : 2"], "match": ["copper", "iron"], "keep": True}, "produces no run"),
])
def test_what_cannot_be_asked_is_refused_at_once(deck, tmp_path, inline, wishes, words):
    with pytest.raises(DeckError, match=words) as found:
        swept(None if "match" in wishes else deck, tmp_path / "s", inline, **wishes)
    assert len(found.value.problems) == 1
    assert inline.worked_out == (3 if "output" in wishes else 0)


def test_an_unknown_key_of_a_sweep_file_is_refused(deck, inline, tmp_path):
    deck.write_text(deck.read_text() + '[sweep]\nvari = ["a"]\n')
    with pytest.raises(DeckError, match="sweep.vari: unknown key; did you mean 'vary'"):
        swept(deck, tmp_path / "s", inline)
    deck.write_text(deck.read_text().replace('vari = ["a"]', 'vary = "a"'))
    with pytest.raises(DeckError, match="sweep.vary: expected an array of strings"):
        swept(deck, tmp_path / "s", inline)


def test_a_folder_that_is_no_sweep_stays_as_it_is(deck, tmp_path, inline):
    mine = tmp_path / "mine"
    mine.mkdir()
    (mine / "thesis.tex").write_text("x")
    with pytest.raises(FileTrouble, match="contains thesis.tex, but no cases.jsonl written by a sweep"):
        swept(deck, mine, inline, vary=[SPEEDS])
    assert os.listdir(mine) == ["thesis.tex"]
    other = tmp_path / "other"
    other.mkdir()
    (other / JOURNAL).write_text("my cases\n")
    with pytest.raises(FileTrouble, match="contains cases.jsonl, but no cases.jsonl written by a sweep"):
        swept(deck, other, inline, vary=[SPEEDS])
    assert (other / JOURNAL).read_text() == "my cases\n"
    file = tmp_path / "file"
    file.write_text("")
    with pytest.raises(FileTrouble, match="in the way"):
        swept(deck, file, inline, vary=[SPEEDS])


@pytest.mark.skipif(os.geteuid() == 0, reason="a superuser may write anywhere")
def test_a_folder_that_cannot_be_written(deck, tmp_path, inline):
    locked = tmp_path / "locked"
    locked.mkdir()
    locked.chmod(0o500)
    with pytest.raises(FileTrouble, match="no permission to write"):
        swept(deck, locked / "s", inline, vary=[SPEEDS])


def test_from_python(deck, tmp_path, inline, monkeypatch):
    monkeypatch.setattr("hugoniot.campaign.ask.local", lambda workers, limit: inline)
    found = hugoniot.sweep(deck, {"region.flyer.velocity": ["500 m/s", "0.7 km/s"], "region.flyer.material": ["al"], "region.flyer.zones": [6, 8]},
                           out=tmp_path / "s", output=["*.peak_velocity"], report=False)
    assert found["free surface.peak_velocity"].shape == (2, 1, 2)
    assert found.sel({"region.flyer.velocity": 700.0})["free surface.peak_velocity"].values.max() == pytest.approx(700.0, rel=0.08)


def test_the_command_shows_the_table_and_draws_it(deck, tmp_path, inline, monkeypatch, capsys):
    from hugoniot.cli.main import main

    monkeypatch.setattr("hugoniot.campaign.ask.local", lambda workers, limit: inline)
    monkeypatch.chdir(tmp_path)
    with pytest.raises(SystemExit) as end:
        main(["sweep", str(deck), "--vary", "region.flyer.velocity = 500..700 m/s : 2", "--plot", "a.png", "--output", "*.arrival"])
    out, err = capsys.readouterr()
    assert end.value.code == 0 and "free surface.arrival, ns" in out.replace("µs", "ns") and "2 cases in" in out
    assert "2 of 2 cases" in err and (tmp_path / "a.png").stat().st_size > 5000 and (tmp_path / "flyer.sweep" / "report.html").is_file()
    with pytest.raises(SystemExit) as end:
        main(["sweep", str(deck), "--vary", "region.flyer.velocity = 500..700 m/s : 2", "--json", "-q", "--no-report"])
    rows = json.loads(capsys.readouterr().out)
    assert end.value.code == 0 and rows["cases"] == 2 and rows["units"]["free surface.arrival"] == "s"
    with pytest.raises(SystemExit) as end:
        main(["sweep", str(deck), "--vary", "region.flyer.velocity = 500..700 : 1000000000"])
    assert end.value.code == 2 and "1 000 000 000 cases are too many" in capsys.readouterr().err


def test_warnings_of_the_cases_are_those_of_the_commands_for_one(deck, tmp_path, inline):
    """Of a match beyond the data of copper, and of a run whose spall plane lies in few zones; equal ones once, with the number of cases."""
    wishes = Wishes(match=["copper", "aluminum"], vary=["velocity = 1, 9, 10 km/s"])
    found = run_sweep(None, wishes, tmp_path / "m", engine=inline).table.warnings
    alone = CliRunner().invoke(build_app("eos"), ["eos", "match", "copper", "aluminum", "--velocity", "9 km/s", "--json"])
    assert found == [f"in 2 of 3 cases, such as: {text}" for text in json.loads(alone.stdout)["warnings"]] and len(found) == 2
    swept = run_sweep(deck, Wishes(vary=["region.flyer.velocity = 700, 710 m/s"]), tmp_path / "s", engine=inline)
    run = hugoniot.run(deck, out=tmp_path / "run", report=False)
    assert len(warnings_of(run)) == len(swept.table.warnings) > 0
    assert "spall planes" in swept.table.warnings[0] and "spall planes" in (tmp_path / "s" / "report.html").read_text()
    assert "spall planes" in open_sweep(tmp_path / "s" / "sweep.h5").attrs["warnings"]


def test_the_command_prints_sensitivities_and_spreads_as_json_too(capsys, tmp_path):
    """Of the match of copper on itself: half the velocity, so that the velocity is all that matters; one case has no deviation."""
    for design, samples in (("saltelli", 16), ("lhs", 1)):
        with pytest.raises(SystemExit):
            main(["sweep", "--match", "copper,copper", "--vary", "velocity = 1..2 km/s", "--vary", "material.copper.eos.gamma0 = 1.9..2.1",
                  "--design", design, "--samples", str(samples), "--output", "particle_velocity", "-o", str(tmp_path / design), "-w", "1", "--json"])
        told = json.loads(capsys.readouterr().out)
        spread, first = told["spread"][0], next(iter(told["sensitivity"]), None)
        if design == "lhs":
            assert spread["count"] == 1 and spread["deviation"] is None and first is None
        else:
            assert first["parameter"] == "velocity" and first["first"] > 0.5 and spread["mean"] == pytest.approx(750.0, abs=20.0)


def test_lines_of_several_materials_are_told_apart(tmp_path, inline):
    """A grid over speeds and targets: a line for each target, labelled, with the values of its cases."""
    wishes = Wishes(match=["copper", "aluminum"], vary=["velocity = 1, 2, 3 km/s", 'target = "aluminum", "iron"'])
    table = run_sweep(None, wishes, tmp_path / "m", engine=inline).table
    _, ax = plt.subplots()
    draw(ax, table, table.column("pressure"))
    expected = table.column("pressure").values.reshape(3, 2).T * 1e-9
    assert all(line.get_ydata() == pytest.approx(row) for line, row in zip(ax.lines, expected, strict=True))
    assert {text.get_text() for text in ax.texts} == {"aluminum", "iron"}
    assert "a line for each target" in (tmp_path / "m" / "report.html").read_text()
    plt.close("all")
