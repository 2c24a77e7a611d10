"""The deck editor's side: errors as the command prints them, what is drawn, words for completion, runs with progress and stop."""

import time

import pytest
from explorer_words import LONG, TOKEN, TUBE
from pace import PATIENCE

from hugoniot.errors import DeckError, FileTrouble
from hugoniot.explorer import decks, jobs
from hugoniot.explorer.places import Places, places_of
from hugoniot.page import live, run_data
from hugoniot.problem.catalogue import deck_text, problems
from hugoniot.problem.deck import read_deck_text


def test_errors_are_those_of_the_command_with_their_lines(client):
    text = 'stop_time = "1 us"\n[[region]]\nname = "a"\nmaterial = "coper"\nfrom = "0 mmm"\nto = "1 mm"\nzones = 5\n'
    found = client.post(f"/{TOKEN}/api/check", content=text).json()
    with pytest.raises(DeckError) as error:
        read_deck_text(text, decks.NAME)
    assert [p["text"] for p in found["problems"]] == [str(p) for p in error.value.problems]
    assert {p["line"] for p in found["problems"]} == {4, 5} and not found["ok"]


@pytest.mark.parametrize("text", ["", "\0", "title = ", "[" * 5000, "a = 1" + "0" * 5000, "\ufeff", "title = 3", "[[region]]\n" * 200])
def test_no_text_brings_the_check_down(client, text):
    answer = client.post(f"/{TOKEN}/api/check", content=text.encode())
    assert answer.status_code == 200 and not answer.json()["ok"] and answer.json()["problems"][0]["text"].startswith("deck.toml")


@pytest.mark.parametrize("name", [entry.name for entry in problems()])
def test_every_deck_of_init_is_drawn(name):
    found = decks.check(deck_text(name), None)
    assert found["ok"], found["problems"]
    drawn = found["drawing"]
    assert len(drawn["blocks" if drawn["plane"] else "regions"]) >= 1
    for block in drawn.get("blocks", ()):
        assert len(block["x"]) == len(block["y"]) >= 4
    for region in drawn.get("regions", ()):
        assert region["end"] > region["start"]


def test_words_name_every_table_with_units_and_laws():
    for kind in ("lagrange1d", "lagrange2d", "fronts", "shock_structure"):
        found = decks.words(kind)
        assert found["tables"]["solver"] and "mie_gruneisen" in found["laws"]["eos"]
    found = decks.words("lagrange1d")
    assert found["tables"]["region"]["from"]["unit"] == "m" and found["tables"]["region"]["from"]["text"]
    assert found["tables"][""]["geometry"]["choices"] == ["planar", "cylindrical", "spherical"] and found["tables"][""]["region"]["many"]
    assert found["laws"]["eos"]["mie_gruneisen"]["keys"]["c0"]["unit"] == "m/s"
    assert "material.*" in found["tables"] and "boundary" in found["tables"]


def ended(job, seconds=PATIENCE):
    until = time.monotonic() + seconds
    while job.running and time.monotonic() < until:
        time.sleep(0.02)
    job.reader.join(5.0)
    return job.shown()


@pytest.mark.slow
def test_a_run_is_started_reports_and_opens(tmp_path, tube):
    places = Places(work=tmp_path / "work")
    (tmp_path / "work" / "tube-of-gas.run").mkdir(parents=True)
    started = jobs.Jobs(places)
    said = ended(started.job(started.start(TUBE)["job"]))
    assert said["state"] == "done" and said["progress"]["time"] == pytest.approx(20e-6) and said["progress"]["cycle"] > 10
    assert [p.name for p in places.runs] == ["tube-of-gas-2.run"]
    assert run_data.line(places.runs[0].path)["status"] == "done" and run_data.finished(places.runs[0].path)
    started.close()


def test_a_stopped_run_leaves_a_checkpoint_that_the_page_shows(tmp_path, tube):
    """The folder of an unfinished run is read as it stands: its pieces, its log, nothing written."""
    places = Places(work=tmp_path)
    started = jobs.Jobs(places)
    job = started.job(started.start(TUBE.replace('"20 us"', LONG))["job"])
    until = time.monotonic() + PATIENCE
    while not live.column(job.folder, "snapshots", "time").size and job.running and time.monotonic() < until:
        time.sleep(0.05)
    found = run_data.description(job.folder)
    assert found["live"] and found["status"] == "in progress" and found["stop_time"] == 20e-3 and found["regions"][1]["last"] == 39
    names = {f["name"] for f in found["fields"]}
    assert {"pressure", "density", "velocity"} <= names and any("start:" in line for line in found["log"])
    assert run_data.column(job.folder, "snapshots", "pressure", {}).shape[1] == 40
    job.stop()
    said = ended(job)
    assert said["state"] == "stopped" and said["code"] in (130, -15) and any((job.folder / "checkpoint").glob("[0-9]*.json"))
    assert run_data.line(places_of([str(job.folder)]).runs[0].path)["status"] == "unfinished"
    before = sorted((p.name, p.stat().st_mtime_ns) for p in job.folder.rglob("*"))
    run_data.description(job.folder)
    run_data.column(job.folder, "snapshots", "velocity", {})
    assert sorted((p.name, p.stat().st_mtime_ns) for p in job.folder.rglob("*")) == before
    started.close()


def test_runs_are_refused_where_none_may_run_and_for_wrong_decks(tmp_path):
    with pytest.raises(FileTrouble, match="--work"):
        jobs.Jobs(Places()).start(TUBE)
    with pytest.raises(DeckError):
        jobs.Jobs(Places(work=tmp_path / "w")).start(TUBE.replace("ideal_gas", "no_gas"))
    assert not (tmp_path / "w").exists()
