"""The server as it stands: a page from the disk, many requests, a client that never reads, the end of its runs."""

import re
import socket
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor

import httpx
import pytest
from browsing import findings, shown, until
from explorer_words import LONG, TUBE
from pace import PATIENCE

import hugoniot
from hugoniot.explorer.impact import impact
from hugoniot.materials import library
from hugoniot.theory.hugoniot import shock
from hugoniot.theory.impedance import match

pytestmark = pytest.mark.slow


def test_an_export_opens_from_the_disk(visit, tube, opened, tmp_path):
    from hugoniot.explorer.export import export
    from hugoniot.explorer.places import places_of

    export(places_of([*(str(opened[0] / name) for name in opened[1]), "copper", "aluminum", "comp_b"]), tmp_path / "page")
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
    assert page.text_content("[data-table=match] tr[data-field=pressure] td.number") == shown(met.pressure * 1e-9)
    page = here.go("#/match?layers=iron,water,tungsten,comp_b&v=1000&sigma=5&bands=1&deck=0")       # of materials that were not named, too
    until(page, "document.querySelectorAll('[data-table=match] tr[data-field=pressure] .quiet').length === 3")
    theirs = impact(["iron", "water", "tungsten", "comp_b"], 1000.0, 5.0, True)["states"]
    cells = page.locator("[data-table=match] tr[data-field=pressure] td.number").all_text_contents()
    assert cells == [f"{shown(s['pressure'] * 1e-9)} ± {shown(s['uncertainty']['pressure'] * 1e-9, 2)}" for s in theirs]
    page = here.go("#/materials?sel=copper&at=particle_velocity:1234.5", "[data-table='state on the Hugoniot']")     # between the exported states
    assert page.text_content("tr[data-field=temperature] td.number") == shown(float(shock(library.find("copper"), particle_velocity=1234.5).temperature))
    for view in ("#/materials?sel=copper,aluminum&at=particle_velocity:1500", "#/sweeps?sweep=0", "#/decks?deck=0", "#/fits?fit=0", "#/runs?run=1&f=pressure&z=5",
                 "#/materials?sel=copper&plane=surface", "#/materials?sel=copper&plane=isotherms"):
        here.go(view)


def test_a_report_is_read_without_scripts_and_walked_with_them(visit, browser, tube, tmp_path):
    import shutil

    from hugoniot.report import write_report

    path = write_report(shutil.copytree(tube, tmp_path / "tube.run"))
    plain = browser.new_context(java_script_enabled=False)
    page = plain.new_page()
    page.goto(path.as_uri())
    assert page.locator("svg.picture:visible").count() >= 3 and page.locator("header:visible, footer:visible").count() == 0
    assert page.locator("h2:visible").first.text_content() and page.locator("main img").count() == 0
    plain.close()
    linked = visit(start=path.as_uri()).go("#/runs?k=3")       # a link to the run in the report
    assert linked.locator("#main").is_visible() and not linked.locator("#report").is_visible()
    here, rows = visit(start=path.as_uri()), hugoniot.load(tube).arrays("snapshots")
    page = here.page
    page.goto(path.as_uri())
    assert page.locator("svg.picture:visible").count() >= 3
    page.click("nav a:has-text('Run')")
    page.evaluate("location.hash = '#/runs?run=0&f=pressure'")
    until(page, "document.querySelector('.chart')?.chart.spec.bar?.label.startsWith('pressure')")
    assert findings(page) == [] and page.locator("svg.picture:visible").count() == 0
    for across, up in ((0.3, 0.4), (0.5, 0.3), (0.55, 0.7)):
        here.point(across, up)
        zone, record = (int(page.get_attribute("[data-readout]", f"data-{key}")) for key in ("zone", "record"))
        value, unit = here.readout()["pressure"].split()
        assert value == shown(rows["pressure"][record, zone] * {"MPa": 1e-6, "kPa": 1e-3, "GPa": 1e-9}[unit])
    page.click("nav a:has-text('Report')")
    assert page.locator("svg.picture:visible").count() >= 3


def test_many_requests_and_a_client_that_never_reads_do_not_stop_it(address):
    host, port = re.match(r"http://([^:/]+):(\d+)/", address).groups()
    deaf = [socket.create_connection((host, int(port))) for _ in range(3)]
    for client in deaf:
        client.sendall(f"GET /{address.split('/')[3]}/api/materials HTTP/1.1\r\nHost: {host}:{port}\r\n\r\n".encode() * 30)

    with httpx.Client(timeout=PATIENCE, verify=False, limits=httpx.Limits(max_connections=1000)) as client, ThreadPoolExecutor(200) as pool:
        def asked(k):
            return client.get(f"{address}api/state", params={"name": "copper", "by": "particle_velocity", "value": 500 + k}).json()["state"]["particle_velocity"]

        assert list(pool.map(asked, range(1000))) == [500 + k for k in range(1000)]
    assert httpx.get(address, timeout=PATIENCE).status_code == 200 and httpx.get(address, headers={"host": "evil.example"}, timeout=PATIENCE).status_code == 404
    for client in deaf:
        client.close()


def test_the_end_of_the_server_is_the_end_of_its_runs_with_a_checkpoint(tmp_path):
    with subprocess.Popen([sys.executable, "-m", "hugoniot.cli.main", "explore", "--no-browser", "--work", str(tmp_path)], stdout=subprocess.PIPE, text=True) as server:
        address = re.search(r"http://\S+", server.stdout.readline()).group(0)
        httpx.post(f"{address}api/job", content=TUBE.replace('"20 us"', LONG), timeout=PATIENCE)
        end = time.monotonic() + PATIENCE
        while httpx.get(f"{address}api/job/0", timeout=PATIENCE).json()["progress"].get("cycle", 0) < 10 and time.monotonic() < end:
            time.sleep(0.1)
        server.terminate()
        assert server.wait(PATIENCE) == 0
    assert list((tmp_path / "tube-of-gas.run" / "checkpoint").glob("[0-9]*.json")) and not (tmp_path / "tube-of-gas.run" / ".lock").exists()
