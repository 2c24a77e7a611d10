"""The page in a browser: every view by pointer and keys, the digits under the pointer, nothing asked of any other host.

Chromium is looked for on PATH; where there is none these tests are skipped. Screenshots stay in the folder of the test run.
"""

import json
import re
import shutil
import socket
import subprocess
import sys
import time
import xml.etree.ElementTree as ET
from concurrent.futures import ThreadPoolExecutor

import httpx
import numpy as np
import pytest
from explorer_words import LONG, TUBE
from typer.testing import CliRunner

import hugoniot
from hugoniot.cli.main import build_app
from hugoniot.materials import library
from hugoniot.theory.impedance import match

pytestmark = pytest.mark.slow
CHROMIUM = next((found for name in ("chromium", "chromium-browser", "google-chrome", "chrome") if (found := shutil.which(name))), None)
FLAGS = ["--headless", "--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync",
         "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1"]
VIEWS = ["#/materials?sel=copper,aluminum&plane=us-up&at=particle_velocity:1500", "#/materials?sel=copper,aluminum&plane=p-up&releases=1&sources=1",
         "#/materials?sel=copper,aluminum&plane=p-v", "#/materials?sel=copper,aluminum&plane=t-p", "#/materials?sel=copper&plane=isentropes",
         "#/materials?sel=comp_b,tnt&plane=detonation", "#/materials?sel=comp_b,tnt&plane=expansion", "#/materials?sel=comp_b&plane=gurney",
         "#/materials?sel=comp_b,pbx_9501&plane=pop", "#/match?layers=tungsten,copper,pmma&v=800&sigma=5", "#/runs?run=0&f=pressure&z=12&k=9", "#/decks?deck=0", "#/sweeps?sweep=0"]


@pytest.fixture(scope="module")
def browser():
    if CHROMIUM is None:
        pytest.skip("no chromium on PATH: install the package chromium to test the explorer's page")
    playwright = pytest.importorskip("playwright.sync_api", reason="playwright is not installed: pip install 'hugoniot[test]'")
    with playwright.sync_playwright() as driver:
        found = driver.chromium.launch(executable_path=CHROMIUM, args=FLAGS)
        yield found
        found.close()


@pytest.fixture(scope="module")
def arguments(tube, tmp_path_factory):
    """A run, a table and a deck whose names try to be HTML."""
    folder = tmp_path_factory.mktemp("open")
    lines = [f"c{k},{100 + 7 * k},{(k * 37) % 11},{k ** 1.5:.4f},<img src=x onerror=alert(4)>" for k in range(40)]
    (folder / "cases.csv").write_text("\n".join(["case,velocity [m/s],<b onclick=alert(5)>seed</b>,peak (GPa),note", *lines]) + "\n")
    (folder / "deck.toml").write_text((tube / "deck.toml").read_text())
    return [str(tube), str(folder), str(folder / "deck.toml")], folder / "work"


@pytest.fixture(scope="module")
def address(arguments):
    command = [sys.executable, "-m", "hugoniot.cli.main", "explore", *arguments[0], "--no-browser", "--work", str(arguments[1])]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        yield re.search(r"http://\S+", process.stdout.readline()).group(0)
        process.terminate()


def until(page, expression, seconds=30.0):
    """Wait for an expression of the page to hold; asked from outside, as the page's policy lets no text be evaluated inside it."""
    end = time.monotonic() + seconds
    while not page.evaluate(expression):
        assert time.monotonic() < end, f"never came true: {expression}"
        page.wait_for_timeout(40)


class Visit:
    """A page that remembers everything it should not have done."""

    def __init__(self, browser, start, width=1280, **options):
        self.context = browser.new_context(viewport={"width": width, "height": 900}, accept_downloads=True, **options)
        self.page, self.start, self.wrong = self.context.new_page(), start, []
        self.context.route("**/*", self._loopback_only)
        self.page.on("console", lambda message: self.wrong.append(f"console: {message.text}"))
        self.page.on("pageerror", lambda error: self.wrong.append(f"error: {error}"))
        self.page.on("dialog", lambda dialog: (self.wrong.append(f"dialog: {dialog.message}"), dialog.dismiss()))

    def _loopback_only(self, route):
        if re.match(r"http://127\.0\.0\.1:\d+/|file:|blob:|data:", route.request.url):
            route.continue_()
        else:
            self.wrong.append(f"asked {route.request.url}")
            route.abort()

    def go(self, view, ready=None):
        self.page.goto("about:blank")
        self.page.goto(self.start + view)
        until(self.page, "document.querySelector('#command')?.textContent.length > 3")
        if ready:
            self.page.wait_for_selector(ready)
        until(self.page, "!document.querySelector('.chart') || [...document.querySelectorAll('.chart')].some(c => c.querySelectorAll('svg path, svg polygon').length > 1)")
        return self.page

    def readout(self):
        return dict(self.page.eval_on_selector_all("[data-readout] dl > div", "rows => rows.map(r => [r.children[0].textContent, r.children[1].textContent])"))


@pytest.fixture
def visit(browser, address):
    made = []

    def start(**options):
        made.append(Visit(browser, options.pop("start", address), **options))
        return made[-1]

    yield start
    for found in made:
        found.context.close()
        assert found.wrong == []


def shown(value, digits=6):
    """A number as the page prints it."""
    text = f"{float(f'{value:.{digits}g}'):.15g}"
    return text.replace("-", "−")


# What a reader needs of every view: names for all controls, text that stands out from its ground, nothing wider than the window.
ACCESSIBLE = """() => {
  const wrong = [], light = c => { const [r, g, b] = c.map(v => { v /= 255; return v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4; }); return 0.2126 * r + 0.7152 * g + 0.0722 * b; };
  const parts = t => t.match(/[\\d.]+/g).map(Number), ground = e => { for (; e; e = e.parentElement) { const c = parts(getComputedStyle(e).backgroundColor); if (c.length < 4 || c[3] > 0.99) return c.slice(0, 3); } return [255, 255, 255]; };
  if (document.documentElement.scrollWidth > innerWidth) wrong.push(`wider than the window: ${document.documentElement.scrollWidth}`);
  for (const e of document.querySelectorAll('button, a, input, select, textarea, [role=listbox], svg[tabindex]')) {
    if (!e.checkVisibility()) continue;
    const name = e.getAttribute('aria-label') || e.textContent.trim() || e.labels?.[0]?.textContent.trim() || e.title;
    if (!name) wrong.push('no name: ' + e.outerHTML.slice(0, 80));
  }
  for (const e of document.querySelectorAll('body *')) {
    if (!e.checkVisibility() || e.closest('svg') || e.disabled || ![...e.childNodes].some(n => n.nodeType === 3 && n.textContent.trim())) continue;
    const style = getComputedStyle(e), a = light(parts(style.color).slice(0, 3)), b = light(ground(e)), ratio = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
    if (ratio < 4.5) wrong.push(`contrast ${ratio.toFixed(2)}: ${e.textContent.trim().slice(0, 40)}`);
  }
  if (new Set([...document.querySelectorAll('[id]')].map(e => e.id)).size !== document.querySelectorAll('[id]').length) wrong.push('an id twice');
  return wrong;
}"""


@pytest.mark.parametrize("width, scheme", [(1280, "light"), (1280, "dark"), (420, "light"), (420, "dark")])
def test_every_view_is_drawn_readable_and_quiet(visit, width, scheme, tmp_path):
    here = visit(width=width, color_scheme=scheme)
    for number, view in enumerate(VIEWS):
        page = here.go(view)
        page.wait_for_load_state("networkidle")
        assert page.evaluate(ACCESSIBLE) == [], view
        assert all(re.search(r"\(.+\)|M/C", words) for words in page.eval_on_selector_all(".chart text[data-axis]", "t => t.map(e => e.textContent).filter(Boolean)")), view
        page.screenshot(path=tmp_path / f"{number:02d}-{width}-{scheme}.png", full_page=True)
    assert not page.query_selector("main img, main [onload], main [onclick], main [onerror]")


def test_the_state_under_the_pointer_is_that_of_the_command(visit):
    here = visit()
    page = here.go("#/materials?sel=copper,aluminum&plane=p-up")
    box = page.locator(".chart svg").first.bounding_box()
    for across, up in ((0.3, 0.6), (0.45, 0.5), (0.5, 0.2)):
        page.mouse.move(box["x"] + across * box["width"], box["y"] + up * box["height"])
        said, name = here.readout(), page.text_content("[data-readout] strong")
        result = CliRunner().invoke(build_app("eos"), ["eos", "hugoniot", name, "--at", f"particle_velocity = {said['particle velocity']}", "--json"])
        theirs = json.loads(result.output)
        for word, key, factor, unit in (("pressure", "pressure", 1e-9, "GPa"), ("density", "density", 1, "kg/m³"), ("shock velocity", "shock_velocity", 1, "m/s"),
                                        ("temperature", "temperature", 1, "K"), ("internal energy", "specific_internal_energy", 1e-3, "kJ/kg"), ("entropy", "entropy", 1, "J/kg/K")):
            assert said[word] == f"{shown(theirs[key] * factor)} {unit}"


def test_a_pinned_state_stands_in_the_address_and_has_a_command_that_gives_it(visit):
    here = visit()
    page = here.go("#/materials?sel=copper&at=particle_velocity:1234.5", "[data-table='state on the Hugoniot']")
    number = page.text_content("tr[data-field=pressure] td.number")
    words = page.text_content("#command")
    state = re.fullmatch(r'hugoniot eos hugoniot copper --at "([^"]+)" --axes us-up --plot hugoniots.png', words).group(1)
    result = CliRunner().invoke(build_app("eos"), ["eos", "hugoniot", "copper", "--at", state, "--json"])
    assert number == shown(json.loads(result.output)["pressure"] * 1e-9)
    page.fill("input[aria-label='Value of the state']", "2000")
    page.get_by_role("button", name="Pin", exact=True).click()
    until(page, "location.hash.includes('particle_velocity:2000')")
    page.click("#as-python")
    assert "shock(m, particle_velocity=2000)" in page.text_content("#command")


def test_the_flyer_is_dragged_and_the_match_follows(visit):
    here = visit()
    page = here.go("#/match?layers=copper,aluminum&v=1000", "[data-table=match]")
    handle = page.locator("[data-handle=velocity]").bounding_box()
    page.mouse.move(handle["x"] + handle["width"] / 2, handle["y"] + handle["height"] / 2)
    page.mouse.down()
    for step in range(1, 16):
        page.mouse.move(handle["x"] + handle["width"] / 2 - 12 * step, handle["y"] + handle["height"] / 2)
    page.mouse.up()
    page.wait_for_timeout(400)
    velocity = float(re.search(r"v=(\d+)", page.url).group(1))
    assert 300 < velocity < 900 and page.input_value("input[aria-label='Impact velocity in m/s']") == f"{velocity:g}"
    met = match([library.find("copper"), library.find("aluminum")], velocity)[0]
    assert page.text_content("[data-table=match] tr[data-field=pressure] td.number") == shown(met.pressure * 1e-9)
    assert page.text_content("[data-table=match] tr[data-field=particle_velocity] td.number") == shown(met.particle_velocity)
    assert f'--velocity "{velocity:g} m/s"' in page.text_content("#command")
    page.click("summary:has-text('The deck')")
    until(page, "document.querySelector('details pre')?.textContent.includes('[[region]]')")
    page.click("text=Open in the deck editor")
    page.wait_for_selector("text=The deck is valid")


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
    page.mouse.click(box["x"] + 0.5 * box["width"], box["y"] + 0.3 * box["height"])
    until(page, "location.hash.includes('z=')")
    zone = int(re.search(r"z=(\d+)", page.url).group(1))
    page.select_option("select[aria-label='Field of the histories']", "pressure")
    until(page, f"[...document.querySelectorAll('.chart')].some(c => c.chart.spec.y.label.startsWith('pressure') && c.chart.spec.series.some(s => s.label === 'zone {zone}'))")
    drawn = page.evaluate(f"[...document.querySelectorAll('.chart')].flatMap(c => c.chart.spec.series).find(s => s.label === 'zone {zone}').si[1]")
    assert np.array_equal(drawn, rows["pressure"][:, zone])


def test_measured_data_is_dropped_over_a_run_and_wrong_data_refused(visit, tmp_path):
    here = visit()
    page = here.go("#/runs?run=0&gf=velocity")
    (tmp_path / "visar.csv").write_text("time [us], velocity [m/s]\n0,0\n5,10\n10,<img>\n")
    page.set_input_files("input[type=file]", tmp_path / "visar.csv")
    until(page, "document.querySelector('#said').textContent.includes(\"visar.csv:4: '<img>' is not a number\")")
    (tmp_path / "visar.csv").write_text("time [us], velocity [km/s]\n0,0\n5,0.01\n10,0.02\n")
    page.set_input_files("input[type=file]", tmp_path / "visar.csv")
    until(page, "[...document.querySelectorAll('.chart')].some(c => c.chart.spec.series.some(s => s.label === 'visar.csv: velocity'))")
    drawn = page.evaluate("[...document.querySelectorAll('.chart')].flatMap(c => c.chart.spec.series).find(s => s.label === 'visar.csv: velocity').si")
    assert np.allclose(drawn, [[0, 5e-6, 1e-5], [0, 10, 20]], rtol=1e-15, atol=0)


def test_everything_is_reached_by_keys(visit):
    here = visit()
    page = here.go("")
    for number, view in enumerate(("materials", "match", "runs", "decks", "sweeps"), 1):
        page.keyboard.press(f"Alt+{number}")
        until(page, f"location.hash.startsWith('#/{view}')")
        page.wait_for_load_state("networkidle")
        page.evaluate("document.activeElement.blur()")
        seen = set()
        for _ in range(60):
            page.keyboard.press("Tab")
            seen.add(page.evaluate("(e => e.id || e.getAttribute('aria-label') || e.getAttribute('data-view') || e.textContent.slice(0, 30))(document.activeElement)"))
            if "theme" in seen and "command" in seen:
                break
        assert {"materials", "match", "runs", "decks", "sweeps", "theme"} <= seen, (view, seen)
    page.keyboard.press("Alt+1")
    page.locator("ul[role=listbox]").focus()
    for press in ("ArrowDown", "Enter", "ArrowDown", "Enter"):
        page.keyboard.press(press)
    until(page, "location.hash.split('sel=')[1].split(',').length === 6")
    until(page, "document.querySelector('.chart').chart.spec.series.length >= 2")
    page.locator(".chart svg").first.focus()
    page.keyboard.press("ArrowRight")
    page.keyboard.press("Enter")
    until(page, "location.hash.includes('at=particle_velocity')")
    page.keyboard.press("+")
    until(page, "location.hash.includes('zoom=')")
    page.keyboard.press("0")
    until(page, "!location.hash.includes('zoom=')")


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
    page.wait_for_selector("ol.problems li")
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
    page.wait_for_selector("[data-state=done]", timeout=90_000)
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


def test_pictures_are_saved(visit, tmp_path):
    here = visit(color_scheme="dark")
    for view in ("#/materials?sel=copper&plane=us-up", "#/runs?run=0&f=pressure"):
        page = here.go(view)
        page.wait_for_load_state("networkidle")
        for kind in ("SVG", "PNG"):
            with page.expect_download() as waiting:
                page.locator(f"button:has-text('{kind}')").first.click()
            waiting.value.save_as(tmp_path / f"picture.{kind.lower()}")
        root = ET.parse(tmp_path / "picture.svg").getroot()
        texts = ["".join(e.itertext()) for e in root.iter("{http://www.w3.org/2000/svg}text")]
        assert any("(km/s)" in t or "(mm)" in t for t in texts) and root.find("{http://www.w3.org/2000/svg}rect").get("fill") == "#ffffff"
        assert (tmp_path / "picture.png").read_bytes()[:8] == b"\x89PNG\r\n\x1a\n" and (tmp_path / "picture.png").stat().st_size > 10_000


def test_an_export_opens_from_the_disk(visit, tube, arguments, tmp_path):
    from hugoniot.explorer.export import export
    from hugoniot.explorer.places import places_of

    export(places_of([*arguments[0], "copper", "aluminum", "comp_b"]), tmp_path / "page")
    here = visit(start=(tmp_path / "page" / "index.html").as_uri())
    rows = hugoniot.load(tube).arrays("snapshots")
    page = here.go("#/runs?run=0&f=pressure")
    until(page, "document.querySelector('.chart canvas').width > 10")
    box = page.locator(".chart svg").first.bounding_box()
    page.mouse.move(box["x"] + 0.5 * box["width"], box["y"] + 0.4 * box["height"])
    zone, record = (int(page.get_attribute("[data-readout]", f"data-{key}")) for key in ("zone", "record"))
    value, unit = here.readout()["pressure"].split()
    assert value == shown(rows["pressure"][record, zone] * {"MPa": 1e-6, "kPa": 1e-3, "GPa": 1e-9}[unit])
    page = here.go("#/match?layers=copper,aluminum&v=1000", "[data-table=match]")
    met = match([library.find("copper"), library.find("aluminum")], 1000.0)[0]
    assert page.text_content("[data-table=match] tr[data-field=pressure] td.number") == shown(met.pressure * 1e-9, 5)
    page.evaluate("location.hash = '#/match?layers=copper,aluminum,comp_b&v=1000'")
    page.wait_for_selector("text=reshock and release from the server")
    for view in ("#/materials?sel=copper,aluminum&at=particle_velocity:1500", "#/sweeps?sweep=0", "#/decks?deck=0"):
        here.go(view).wait_for_load_state("networkidle")


def test_many_requests_and_a_client_that_never_reads_do_not_stop_it(address):
    host, port = re.match(r"http://([^:/]+):(\d+)/", address).groups()
    deaf = [socket.create_connection((host, int(port))) for _ in range(3)]
    for client in deaf:
        client.sendall(f"GET /{address.split('/')[3]}/api/materials HTTP/1.1\r\nHost: {host}:{port}\r\n\r\n".encode() * 30)

    def asked(k):
        with httpx.Client(timeout=60.0) as client:
            return client.get(f"{address}api/state", params={"name": "copper", "by": "particle_velocity", "value": 500 + k}).json()["state"]["particle_velocity"]

    with ThreadPoolExecutor(100) as pool:
        assert list(pool.map(asked, range(300))) == [500 + k for k in range(300)]
    assert httpx.get(address).status_code == 200 and httpx.get(address, headers={"host": "evil.example"}).status_code == 404
    for client in deaf:
        client.close()


def test_the_end_of_the_server_is_the_end_of_its_runs_with_a_checkpoint(tmp_path):
    with subprocess.Popen([sys.executable, "-m", "hugoniot.cli.main", "explore", "--no-browser", "--work", str(tmp_path)], stdout=subprocess.PIPE, text=True) as server:
        address = re.search(r"http://\S+", server.stdout.readline()).group(0)
        httpx.post(f"{address}api/job", content=TUBE.replace('"20 us"', LONG))
        end = time.monotonic() + 60
        while httpx.get(f"{address}api/job/0").json()["progress"].get("cycle", 0) < 10 and time.monotonic() < end:
            time.sleep(0.1)
        server.terminate()
        assert server.wait(30) == 0
    assert list((tmp_path / "tube-of-gas.run" / "checkpoint").glob("[0-9]*.json")) and not (tmp_path / "tube-of-gas.run" / ".lock").exists()
