"""The command and the Python of decks and sweeps give what the page shows; a refused question is told on the page and nowhere else."""

import contextlib
import csv
import re
import shlex
import subprocess
import sys

import numpy as np
import pytest
from browsing import Visit, until
from typer.testing import CliRunner

import hugoniot
from hugoniot.cli.main import build_app
from hugoniot.theory.impedance import match

pytestmark = pytest.mark.slow
DECK = """title = "Quick"
stop_time = "20 us"
[[region]]
name = "a"
material = "gas"
from = 0
to = "1 cm"
zones = 10
pressure = "1 bar"
density = 1
velocity = "10 m/s"
[boundary]
left = "fixed"
[material.gas.eos]
law = "ideal_gas"
gamma = 1.4
[[gauge]]
name = "wall"
at = "0.1 mm"
[output]
report = false
"""
FIELDS = ("time", "pressure", "velocity", "density")


def executed(page):
    """What the Python of the page makes and prints."""
    page.click("#as-python")
    found = []
    names = {"print": lambda *values: found.append(values)}
    exec(page.text_content("#command"), names)
    page.click("#as-shell")
    return names, found


def test_command_and_python_of_a_deck_give_the_run_of_the_page(visit, opened, tmp_path, monkeypatch):
    page = visit().go("#/decks", ".editor textarea")
    page.locator(".editor textarea").fill(DECK)
    page.wait_for_selector("text=Quick, 10 zones")
    end = "document.querySelector('.chart').chart.spec.marks.filter(m => m.kind === 'polygon').map(m => Math.max(...m.xs)).join()"
    until(page, f"{end} === '10'")
    page.locator(".editor textarea").fill(DECK.replace('"1 cm"', '"2 cm"'))
    until(page, f"{end} === '20'")      # the set-up follows what is typed
    page.locator(".editor textarea").fill(DECK)
    until(page, f"{end} === '10'")
    with page.expect_download() as waiting:
        page.get_by_role("button", name="Save", exact=True).click()
    assert waiting.value.suggested_filename == "deck.toml"
    waiting.value.save_as(tmp_path / "deck.toml")
    assert (tmp_path / "deck.toml").read_text() == DECK
    page.click("button:has-text('Run')")
    page.wait_for_selector("[data-state=done]")
    mine = hugoniot.load(opened[0] / "work" / page.text_content("[data-state] strong"))
    monkeypatch.chdir(tmp_path)
    for line in page.text_content("#command").splitlines():
        words = shlex.split(line)
        assert words[0] == "hugoniot" and CliRunner().invoke(build_app(words[1]), words[1:]).exit_code == 0, line
    theirs = hugoniot.load(tmp_path / "deck.run")
    (tmp_path / "deck.run").rename(tmp_path / "by-command.run")
    names, found = executed(page)
    for name in FIELDS:
        first = mine.arrays("gauges")[name][:]
        assert first.size and np.array_equal(first, hugoniot.load(tmp_path / "by-command.run").arrays("gauges")[name][:])
        assert np.array_equal(first, names["run"].arrays("gauges")[name][:])
    assert found[0][0]["energy_error"] == mine.summary["energy_error"] == theirs.summary["energy_error"]
    assert names["run"].summary["deck_sha256"] == theirs.summary["deck_sha256"]


def test_command_and_python_of_a_sweep_give_the_cases_that_are_kept(visit, browser, opened, monkeypatch):
    page = visit().go("#/sweeps?sweep=0&x=1&y=3&brush=1:150:250;3:10:120")
    page.wait_for_selector("[data-table=cases]")
    kept = page.locator("[data-table=cases] tbody tr").count()
    drawn = page.evaluate("document.querySelectorAll('.chart')[1].chart.spec.series.filter(s => s.hover).flatMap(s => s.rows.map((r, i) => [r, s.x[i], s.y[i]])).sort((a, b) => a[0] - b[0])")
    with (opened[0] / "sweep" / "cases.csv").open() as file:
        rows = [(float(r["velocity [m/s]"]), float(r["peak (GPa)"])) for r in csv.DictReader(file)]
    expected = [(v, p) for v, p in rows if 150 <= v <= 250 and 10 <= p <= 120]
    monkeypatch.chdir(opened[0])
    count, scatter = executed(page)[1][0]
    assert 3 < count == kept == len(expected) < len(rows) and scatter == expected == [(x, y) for _, x, y in drawn]
    words = shlex.split(page.text_content("#command"))
    command = [sys.executable, "-m", "hugoniot.cli.main", *words[1:], "--no-browser", "--no-runs"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True, cwd=opened[0]) as server, contextlib.ExitStack() as last:
        last.callback(server.terminate)
        address = re.search(r"http://\S+", server.stdout.readline()).group(0)
        again = Visit(browser, address)
        last.callback(again.context.close)
        again.page.goto(address)
        again.settled("[data-table=cases]")
        assert again.page.locator("[data-table=cases] tbody tr").count() == kept and again.wrong == []


def test_python_of_a_sweep_in_si_counts_in_the_units_shown(visit, browser, tmp_path, monkeypatch):
    """Columns in Pa and s are shown in GPa and µs, comment lines and cells without a number are left out."""
    from hugoniot.explorer.export import export
    from hugoniot.explorer.places import places_of

    lines = [f"{k},{2.5e8 * k},{1e-6 / (k + 1) if k != 3 else ''}" for k in range(12)]
    (tmp_path / "cases.csv").write_text("\n".join(["# made by hand", "case, peak [Pa], arrival [s]", *lines]) + "\n")
    monkeypatch.chdir(tmp_path)
    export(places_of(["cases.csv", "copper"]), tmp_path / "page")
    here = visit(start=(tmp_path / "page" / "index.html").as_uri())
    page = here.go("#/sweeps?sweep=0&x=1&y=2&brush=1:0.5:2")
    page.wait_for_selector("text=7 of 12 cases")
    count, scatter = executed(page)[1][0]
    drawn = page.evaluate("document.querySelectorAll('.chart')[1].chart.spec.series.filter(s => s.hover).flatMap(s => s.rows.map((r, i) => [r, s.x[i], s.y[i]])).sort((a, b) => a[0] - b[0])")
    assert count == 7 and [s for s in scatter if s[1] == s[1]] == [(x, y) for _, x, y in drawn] and drawn[0][1:] == [0.5, 1e-6 / 3 * 1e6]


def commanded(page):
    """Every line of the command of the page, executed here."""
    for line in page.text_content("#command").splitlines():
        words = shlex.split(line)
        if words[0] == "python":
            assert subprocess.run([sys.executable, *words[1:]], capture_output=True, check=True).stdout
            continue
        result = CliRunner().invoke(build_app(words[1]), words[1:])
        assert words[0] == "hugoniot" and result.exit_code == 0, (line, result.output)


def test_commands_of_runs_and_fits_are_obeyed_and_give_the_record_that_is_shown(visit, opened, plane, monkeypatch):
    monkeypatch.chdir(opened[0])
    here = visit()
    page = here.go("#/runs?run=0&f=pressure&k=7", ".chart canvas")
    commanded(page)
    page = here.go("#/runs?run=1&f=pressure&k=3", ".chart canvas")
    until(page, "document.querySelector('#command').textContent.includes('plane.run map pressure')")
    commanded(page)
    names, _ = executed(page)
    drawn = next(c.get_array() for c in names["run"].plot.map("pressure", time=names["run"].arrays("snapshots")["time"][3]).collections if c.get_array() is not None)
    assert np.allclose(np.unique(drawn), np.unique(hugoniot.load(plane).arrays("snapshots")["pressure"][3]) * (np.max(drawn) / np.max(hugoniot.load(plane).arrays("snapshots")["pressure"][3])))
    page = here.go("#/fits?fit=0", "[data-table=parameters]")
    commanded(page)


def test_a_dragged_match_of_three_layers_shows_the_states_of_the_theory(visit):
    """Every step that is drawn."""
    from hugoniot.materials import library

    names = ["tungsten", "copper", "pmma"]
    page = visit().go(f"#/match?layers={','.join(names)}&v=1500", "[data-table=match]")
    found = page.evaluate("""async () => { const chart = document.querySelector('.chart').chart, seen = [];
      for (let v = 1450; v >= 800; v -= 50) { chart.options.onDrag('velocity', v / 1000);
        while (chart.spec.handles[0].x !== v * 1e-3) await new Promise(done => setTimeout(done, 1));
        seen.push([v, chart.spec.marks.filter(m => m.kind === 'dot').map(m => m.y)]); }
      chart.options.onDrop(); return seen; }""")
    layers = [library.find(name) for name in names]
    assert len(found) == 14
    for velocity, pressures in found:
        assert pressures == pytest.approx([m.pressure * 1e-9 for m in match(layers, velocity)], rel=1e-11)


@pytest.mark.parametrize(("view", "words"), [
    ("#/match?layers=coper,aluminum&v=800", "nearest: copper"), ("#/match?layers=copper,aluminum&v=1e9", ""), ("#/materials?sel=coper", "nearest: copper"),
    ("#/materials?sel=copper&at=particle_velocity:1e9", ""), ("#/materials?sel=copper&plane=surface&rho=1,2", "densities"), ("#/runs?run=77", "no run 77"),
    ("#/sweeps?sweep=5", "no sweep 5"), ("#/fits?fit=3", "no fit 3"), ("#/decks?deck=9", "no deck 9"), ("#/decks?job=12", "no run 12")])
def test_a_refused_question_is_answered_on_the_page_with_an_empty_console(visit, view, words):
    here = visit()
    page = here.page
    page.goto(here.start + view)
    until(page, f"document.body.textContent.includes({words!r}) && document.querySelector('#command') !== null && !document.querySelector('#main').hasAttribute('aria-busy')")
    page.wait_for_timeout(200)
    assert here.wrong == []
