"""Runs, tables, fits and decks in the browser: the pointer reads the file, histories follow a picked zone, a run is written, started and opened."""

import json
import re

import numpy as np
import pytest
from browsing import shown, until
from explorer_words import PLANE

import hugoniot
from hugoniot.page import run_data

pytestmark = pytest.mark.slow
FACTORS = {"GPa": 1e-9, "MPa": 1e-6, "kPa": 1e-3, "Pa": 1}
SERIES = "[...document.querySelectorAll('.chart')].flatMap(c => c.chart.spec.series)"


def test_the_pointer_on_a_run_reads_its_file(visit, tube):
    here, rows = visit(), hugoniot.load(tube).arrays("snapshots")
    page = here.go("#/runs?run=0&f=pressure", ".chart canvas")
    until(page, "document.querySelector('.chart canvas').width > 10")
    box = page.locator(".chart svg").first.bounding_box()
    for across, up in ((0.3, 0.4), (0.5, 0.3), (0.55, 0.7), (0.4, 0.85)):
        page.mouse.move(box["x"] + across * box["width"], box["y"] + up * box["height"])
        zone, record = (int(page.get_attribute("[data-readout]", f"data-{key}")) for key in ("zone", "record"))
        said = here.readout()
        value, unit = said["pressure"].split()
        factor = {"GPa": 1e-9, "MPa": 1e-6, "kPa": 1e-3, "Pa": 1}[unit]
        x = float(said["position"].split()[0]) * 1e-3
        assert value == shown(rows["pressure"][record, zone] * factor)
        assert rows["position_left"][record, zone] - 1e-6 <= x <= rows["position_right"][record, zone] + 1e-6
        assert said["record, time"].split()[1] == shown(rows["time"][record] * 1e6)
    assert page.text_content("[data-axis=y]").endswith(f", {len(rows['time'])} snapshots")
    page.mouse.click(box["x"] + 0.5 * box["width"], box["y"] + 0.3 * box["height"])
    until(page, "location.hash.includes('z=')")
    zone = int(re.search(r"z=(\d+)", page.url).group(1))
    page.select_option("select[aria-label='Field of the histories']", "pressure")
    until(page, f"[...document.querySelectorAll('.chart')].some(c => c.chart.spec.y.label.startsWith('pressure') && c.chart.spec.series.some(s => s.label === 'zone {zone}'))")
    drawn = page.evaluate(f"[...document.querySelectorAll('.chart')].flatMap(c => c.chart.spec.series).find(s => s.label === 'zone {zone}').si[1]")
    assert np.array_equal(drawn, rows["pressure"][:, zone])


def test_a_run_is_shown_with_its_warnings_and_what_its_spall_is_of(visit):
    """As the terminal and the report give them, and of many events how many there are."""
    def more(route):
        answer = route.fetch()
        found = answer.json() | {"event_count": 812, "events": [{"time": 1e-6, "kind": "void", "text": "a void opened"}] * 500}
        found["numbers"] |= {"warnings": ["the mesh is coarse"], "spall": {"region": "target", "gauge": "free surface", "window": None, "pull_back": 84.0}}
        route.fulfill(response=answer, json=found)

    here = visit()
    here.context.route(re.compile(r"/api/run\?"), more)
    said = here.go("#/runs?run=0", ".chart canvas").text_content("#main")
    assert "warning: the mesh is coarse" in said and "spall of target (gauge free surface)" in said and "the first 500 of 812 events" in said


def test_a_match_that_fails_leaves_no_picture_of_the_one_before(visit):
    here = visit()
    page = here.go("#/match?layers=copper,tnt&v=1500", "[data-table=match]")
    assert "copper/tnt (unreacted)" in page.text_content("[data-table=match]")
    page = here.go("#/match?layers=copper,nonesuch&v=1500", ".bad")
    assert page.evaluate(f"{SERIES}.length") == 0 and page.query_selector("[data-table=match]") is None


def test_the_pointer_on_a_plane_reads_its_file_and_a_picked_zone_has_a_history(visit, plane):
    here, run = visit(), hugoniot.load(plane)
    page, rows = here.go("#/runs?run=1&f=pressure&k=3&mesh=1", ".chart canvas"), run.arrays("snapshots")
    until(page, "document.querySelector('.chart canvas').width > 10")
    for across, up in ((0.4, 0.5), (0.5, 0.6), (0.45, 0.3)):
        box = here.point(across, up)
        zone, said = int(page.get_attribute("[data-readout]", "data-zone")), here.readout()
        value, unit = said["pressure"].split()
        assert zone >= 0 and value == shown(rows["pressure"][3, zone] * FACTORS[unit])
    page.mouse.click(box["x"] + 0.45 * box["width"], box["y"] + 0.3 * box["height"])
    until(page, f"{SERIES}.some(s => s.label === 'zone {zone}')")
    assert np.array_equal(page.evaluate(f"{SERIES}.find(s => s.label === 'zone {zone}').si[1]"), rows["pressure"][:, zone])
    page.locator("input[aria-label=Record]").focus()
    page.keyboard.press("Home")
    until(page, "location.hash.includes('k=0')")
    here.settled()
    here.point(0.45, 0.3)
    assert page.get_attribute("[data-readout]", "data-record") == "0"


def test_the_python_of_a_run_gives_the_record_that_is_shown(visit, tube, opened, monkeypatch):
    monkeypatch.chdir(opened[0])
    page = visit().go("#/runs?run=0&f=pressure&k=7")
    page.click("#as-python")
    words = page.text_content("#command")
    assert "snapshots[\"pressure\"].isel(time=7)" in words and 'load("tube.run")' in words
    names = {}
    exec(words.replace("run.plot.xt", "picture = run.plot.xt").replace('.figure.savefig("xt.png")', "").replace("run.snapshots", "values = run.snapshots"), names)
    drawn = page.evaluate(f"{SERIES}.filter(s => s.first !== undefined).flatMap(s => s.si[1])")
    assert np.array_equal(drawn, names["values"].values)


def test_measured_data_is_dropped_over_a_run_and_wrong_data_refused(visit, tmp_path):
    here = visit()
    page = here.go("#/runs?run=0&gf=velocity")
    (tmp_path / "visar.csv").write_text("time [us], velocity [m/s]\n0,0\n5,10\n10,<img>\n")
    page.set_input_files("input[type=file]", tmp_path / "visar.csv")
    until(page, "document.querySelector('#said').textContent.includes(\"visar.csv:4: '<img>' is not a number\")")
    (tmp_path / "visar.csv").write_text("# digitiser 3\ntime [us];velocity [m/s]\n0,0;0,0\n0,5;10,5\n")      # would be 0 m/s at 0, and 5 m/s at 0
    page.set_input_files("input[type=file]", tmp_path / "visar.csv")
    until(page, "document.querySelector('#said').textContent.includes('visar.csv:3: values: 4, column headers: 2; numbers need a decimal point')")
    (tmp_path / "visar.csv").write_text("time [us], velocity [km/s]\n0,0\n5,0.01\n10,0.02\n")
    page.set_input_files("input[type=file]", tmp_path / "visar.csv")
    until(page, "[...document.querySelectorAll('.chart')].some(c => c.chart.spec.series.some(s => s.label === 'visar.csv: velocity'))")
    drawn = page.evaluate("[...document.querySelectorAll('.chart')].flatMap(c => c.chart.spec.series).find(s => s.label === 'visar.csv: velocity').si")
    assert np.allclose(drawn, [[0, 5e-6, 1e-5], [0, 10, 20]], rtol=1e-15, atol=0)
    hostile = "time [us], <script>alert(8)</script> [m/s]\n0,1\n1,2\n"
    page.evaluate("""text => { const data = new DataTransfer(); data.items.add(new File([text], '<img src=x onerror=alert(9)>.csv'));
      const box = document.querySelector('.drop'); for (const kind of ['dragover', 'drop']) box.dispatchEvent(new DragEvent(kind, {dataTransfer: data, bubbles: true, cancelable: true})); }""", hostile)
    until(page, f"{SERIES}.some(s => (s.label || '').includes('script>alert(8)'))")
    assert not page.query_selector("main script, main img")


def test_a_link_holds_measured_data_and_an_edited_deck(visit, tmp_path):
    """What the reader dropped or wrote is in the address, deflated; what is too long for one is named as missing."""
    here, other = visit(), visit()
    page = here.go("#/runs?run=0&gf=velocity")
    rows = [f"{0.01 * k:.2f},{10 * np.sin(k / 60):.4f}" for k in range(2000)]
    (tmp_path / "visar é.csv").write_text("time [us], velocity [m/s]\n" + "\n".join(rows) + "\n")
    page.set_input_files("input[type=file]", tmp_path / "visar é.csv")
    until(page, f"{SERIES}.some(s => s.label === 'visar é.csv: velocity') && location.hash.includes('csv=')")
    page.wait_for_timeout(400)
    again = other.go(page.evaluate("location.hash"))
    assert len(page.evaluate("location.hash")) < 0.8 * sum(map(len, rows))
    drawn = f"{SERIES}.find(s => s.label === 'visar é.csv: velocity').si"
    assert again.evaluate(drawn) == page.evaluate(drawn)
    page.click("button[aria-label='Remove visar é.csv']")
    until(page, f"!{SERIES}.some(s => s.label === 'visar é.csv: velocity')")
    noise = np.random.default_rng(1).standard_normal(60_000)
    (tmp_path / "long.csv").write_text("time [us], velocity [m/s]\n" + "\n".join(f"{k},{v!r}" for k, v in enumerate(noise.tolist())) + "\n")
    page.set_input_files("input[type=file]", tmp_path / "long.csv")
    page.wait_for_selector("text=a link to this page would not contain these data")
    assert "csv=" not in page.evaluate("location.hash")
    page = here.go("#/decks")
    text = page.input_value(".editor textarea") + "".join(f"# a remark of {k} lines that makes this deck long\n" for k in range(3000))
    page.evaluate("text => { const area = document.querySelector('.editor textarea'); area.value = text; area.dispatchEvent(new Event('input')); }", text)
    until(page, "location.hash.includes('text=')", 10.0)
    page.wait_for_timeout(500)
    assert len(text) > 100_000 and other.go(page.evaluate("location.hash")).input_value(".editor textarea") == text


def test_runs_lie_over_each_other(visit, tube, opened):
    """The same gauge of a second run is drawn beside that of the first."""
    here = visit()
    page = here.go("#/sweeps?sweep=0")
    page.wait_for_selector("text=40 of 40 cases, 1 with a run to open")
    assert page.locator("main p.bad").all_text_contents() == ["<b onclick=alert(6)>extrapolated</b>", "recalled"]
    assert "<b onclick=alert(7)>peak</b>GPa2.50.125" in page.text_content("details:has-text('Spread of the results')")
    page.locator("button[title='Open the run']").click()
    until(page, "/^#\\/runs\\?run=[2-9]/.test(location.hash)")      # after those that other tests have run
    here.settled()
    page.locator("input[type=checkbox]").first.check()
    until(page, "location.hash.includes('over=0')")
    until(page, f"{SERIES}.filter(s => (s.label || '').startsWith('<b onclick=alert(3)>middle')).length === 2")
    one, two = page.evaluate(f"{SERIES}.filter(s => (s.label || '').startsWith('<b onclick=alert(3)>middle')).map(s => s.si)")
    assert one == two and len(one[0]) > 10
    page.locator(".chart svg").nth(1).focus()
    page.keyboard.press("ArrowRight")
    assert "middle" in page.text_content("[data-readout] strong")
    profiles = "document.querySelectorAll('.chart')[2].chart.spec.series"
    until(page, f"{profiles}.length === 4")      # two regions of either run, of the same run here
    drawn = page.evaluate(f"{profiles}.map(s => [s.label, s.si])")
    assert [d[1] for d in drawn[:2]] == [d[1] for d in drawn[2:]] and all(d[0].endswith("tube.run") for d in drawn[2:])


def test_a_deck_is_completed_checked_run_and_opened(visit):
    here = visit()
    page = here.go("#/decks", ".editor textarea")
    page.wait_for_selector("text=The deck is valid")
    area = page.locator(".editor textarea")
    area.press("Control+End")
    area.type("\n[solver]\nint")
    page.wait_for_selector(".offers li:has-text('integrator')")
    area.press("Enter")
    area.type('"com')
    page.wait_for_selector(".offers li:has-text('compatible')")
    area.press("Enter")
    assert area.input_value().endswith('integrator = "compatible"')
    area.type("\ncourantt = 0.3")
    page.wait_for_selector("ol.problems li:has-text('courantt')")
    line = area.input_value().count("\n") + 1
    assert page.text_content("ol.problems li").startswith(f"deck.toml:{line}: solver.courantt: unknown key")
    assert page.text_content(".editor pre b").strip() == f"▸{line}"
    page.evaluate("document.querySelector('.editor textarea').setSelectionRange(0, 0)")
    page.click("ol.problems button")
    assert page.evaluate("getSelection().toString() || (a => a.value.slice(a.selectionStart, a.selectionEnd))(document.querySelector('.editor textarea'))") == "courantt = 0.3"
    area.fill('title = "Quick"\nstop_time = "20 us"\n[[region]]\nname = "a"\nmaterial = "gas"\nfrom = 0\nto = "1 cm"\nzones = 10\npressure = "1 bar"\ndensity = 1\n[material.gas.eos]\nlaw = "ideal_gas"\ngamma = 1.4\n[output]\nreport = false\n')
    page.wait_for_selector("text=Quick, 10 zones")
    link = page.url
    page.click("button:has-text('Run')")
    page.wait_for_selector("[data-state=done]")
    page.click("text=Open the result")
    page.wait_for_selector("h2:has-text('Quick')")
    again = here.go(link[link.index("#"):])
    again.wait_for_selector("text=Quick, 10 zones")


def test_brushing_a_table_keeps_its_cases(visit):
    here = visit()
    page = here.go("#/sweeps?sweep=0")
    page.wait_for_selector("text=40 of 40 cases")
    axis = page.locator("rect[cursor=ns-resize]").first.bounding_box()
    x = axis["x"] + axis["width"] / 2
    page.mouse.move(x, axis["y"] + 0.25 * axis["height"])
    page.mouse.down()
    page.mouse.move(x, axis["y"] + 0.75 * axis["height"])
    page.mouse.up()
    until(page, "location.hash.includes('brush=')")
    low, high = (float(v) for v in re.search(r"brush=\d+:([\d.]+):([\d.]+)", page.url.replace("%3A", ":")).groups())
    expected = sum(low <= 100 + 7 * k <= high for k in range(40))
    page.wait_for_selector(f"text={expected} of 40 cases")
    assert 10 < expected < 30 and page.locator("[data-table=cases] tbody tr").count() == expected
    page.locator("rect[data-brush='1']").focus()
    page.keyboard.press("Delete")
    page.wait_for_selector("text=40 of 40 cases")
    page.keyboard.press("ArrowUp")      # the middle half of 100 to 373
    page.wait_for_selector(f"text={sum(168.25 <= 100 + 7 * k <= 304.75 for k in range(40))} of 40 cases")
    page.keyboard.press("Shift+ArrowDown")
    page.wait_for_selector(f"text={sum(168.25 <= 100 + 7 * k <= 304.75 - 0.05 * 273 for k in range(40))} of 40 cases")
    assert page.evaluate("document.activeElement.getAttribute('aria-valuetext')") == "168.3 to 291.1"


def test_a_fit_shows_values_residuals_and_posterior(visit, opened, monkeypatch):
    monkeypatch.chdir(opened[0])
    here, fit = visit(), json.loads((opened[0] / "spall.fit" / "fit.json").read_text())
    page = here.go("#/fits?fit=0", "[data-table=parameters]")
    first = fit["parameters"][0]
    cells = page.locator(f"tr[data-parameter='{first['name']}'] td").all_text_contents()
    assert cells[:4] == [first["name"], "GPa", "5.2", "0.11"] and cells[4] == "4.98 to 5.42" and cells[5] == "4.97 to 5.45"
    residual = page.evaluate(f"{SERIES}.find(s => s.id === 'residual').y")
    data, model = (page.evaluate(f"{SERIES}.find(s => s.id === '{name}').y") for name in ("data", "model"))
    assert residual == pytest.approx((np.array(model) - np.array(data)) / 5.0, rel=1e-12)
    inner = np.array(page.evaluate(f"(s => [s.x, s.y])({SERIES}.find(s => s.id === '68.3 %'))"))
    away = (inner - np.array([[5.2], [4.0]])) / np.array([[0.11], [1.0]])
    square = (away[0] ** 2 - 2 * 0.62 * away[0] * away[1] + away[1] ** 2) / (1 - 0.62**2)      # chi-square of two correlated parameters
    assert square == pytest.approx(2.2957, rel=1e-9)
    drawn = page.evaluate("[...document.querySelectorAll('svg text')].map(t => t.textContent)")      # a Pop plot is no record over time
    assert "input pressure (GPa)" in drawn and "run distance (mm)" in drawn and page.locator("td", has_text="0.69 µs").count() == 1
    page.click("#as-python")
    found = []
    exec(page.text_content("#command"), {"print": lambda *values: found.append(values)})
    assert [f[1] for f in found] == [p["value"] for p in fit["parameters"]]


def test_a_plane_run_in_progress_is_watched_and_stopped(visit, opened):
    """From the editor: the map grows with the checkpoints, the pointer reads their pieces, and what the page reads it leaves as it is."""
    here = visit()
    page = here.go("#/decks", ".editor textarea")
    page.wait_for_selector("text=The deck is valid")
    deck = PLANE.replace("[8, 8]", "[160, 160]").replace('"0.1 s"', '"0.6 s"').replace('"0.02 s"', '"0.0005 s"').replace("report = false", "report = false\ncheckpoint_cycles = 10")
    page.locator(".editor textarea").fill(deck)
    page.wait_for_selector("text=25600 zones")
    page.click("button:has-text('Run')")
    page.click("text=Watch")
    page.wait_for_selector("text=This run is in progress")
    until(page, "document.querySelector('.chart canvas')?.width > 10")
    folder = next((opened[0] / "work").glob("*plane*.run"))
    until(page, "+document.querySelector('input[aria-label=Record]').max >= 2")
    here.point(0.45, 0.5)
    zone, record = (int(page.get_attribute("[data-readout]", f"data-{key}")) for key in ("zone", "record"))
    value, unit = here.readout()["pressure"].split()
    assert value == shown(run_data.column(folder, "snapshots", "pressure", {"record": record})[zone] * FACTORS[unit])
    page.go_back()
    stop = page.wait_for_selector("button:has-text('Stop')")
    said = page.text_content("[data-progress]")
    until(page, f"document.querySelector('[data-progress]').textContent !== {json.dumps(said)}")
    assert stop.evaluate("button => button.isConnected")     # a button that is made anew between press and release is not clicked
    stop.click()
    page.wait_for_selector("[data-state=stopped], [data-state=done]")
    before = sorted((p.name, p.stat().st_mtime_ns) for p in folder.rglob("*"))
    times = run_data.description(folder)["times"]
    assert len(times) >= 3 and run_data.column(folder, "snapshots", "speed", {"zone": 5}).shape == (len(times),)
    assert sorted((p.name, p.stat().st_mtime_ns) for p in folder.rglob("*")) == before
