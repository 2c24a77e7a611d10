"""Small runs, the explorer's application in this process, and one server and one browser for all tests of the page."""

import os
import re
import subprocess
import sys

import pytest
from browsing import CHROMIUM, FLAGS, Visit
from explorer_words import HOST, PLANE, STEEL, TOKEN, write_fit

import hugoniot
from hugoniot.output.sweep_file import SweepTable, write_table

pytest.importorskip("starlette", reason="the explorer's server needs hugoniot[explore]")
pytest.importorskip("httpx", reason="the test client needs httpx")


TUBE = """title = "<img src=x onerror=alert(1)> & \\"tube\\""
stop_time = "20 us"
[[region]]
name = "<svg onload=alert(2)>"
material = "gas"
from = "0 mm"
to = "10 mm"
zones = 20
pressure = "2 bar"
density = "1 kg/m^3"
[[region]]
name = "right"
material = "gas"
from = "10 mm"
to = "20 mm"
zones = 20
pressure = "1 bar"
density = "1 kg/m^3"
[material.gas.eos]
law = "ideal_gas"
gamma = 1.4
[[gauge]]
name = "<b onclick=alert(3)>middle"
at = "10.1 mm"
[output]
snapshots = "1 us"
report = false
"""


@pytest.fixture(scope="session")
def tube(tmp_path_factory):
    """The run folder of a small shock tube whose names try to be HTML."""
    from hugoniot.problem.deck import read_deck_text

    return hugoniot.run(read_deck_text(TUBE), tmp_path_factory.mktemp("runs") / "tube.run").folder


@pytest.fixture(autouse=True)
def _no_files_of_others():
    """Materials of files are known for the life of a process: here for that of a test."""
    from hugoniot.explorer import subjects

    yield
    subjects.own.clear()


@pytest.fixture
def places(tube, tmp_path):
    from hugoniot.explorer.places import places_of

    (tmp_path / "table").mkdir()
    (tmp_path / "table" / "cases.csv").write_text('case,velocity [m/s],peak (GPa),"<b>note</b>"\nrun0,100,1.5,a\nrun1,200,nan,"=1+1"\n../../etc,300,2.5,c\n')
    (tmp_path / "deck.toml").write_text(TUBE)
    return places_of([str(tube), str(tmp_path / "table"), str(tmp_path / "deck.toml"), "Cu"], tmp_path / "work")


@pytest.fixture
def client(places):
    from starlette.testclient import TestClient

    from hugoniot.explorer.app import application
    from hugoniot.explorer.jobs import Jobs

    jobs = Jobs(places)
    with TestClient(application(places, jobs, TOKEN, (HOST,)), base_url=f"http://{HOST}", raise_server_exceptions=False) as found:
        yield found
    jobs.close()


# -- the page in a browser ---------------------------------------------------------------------------------------------
@pytest.fixture(scope="session")
def plane(tmp_path_factory):
    """The run folder of a small plane run."""
    from hugoniot.problem.deck import read_deck_text

    return hugoniot.run(read_deck_text(PLANE), tmp_path_factory.mktemp("runs2") / "plane.run").folder


@pytest.fixture(scope="session")
def opened(tube, plane, tmp_path_factory):
    """The folder in which the explorer is started, and its arguments: runs, a table, a fit, a material and a deck; names try to be HTML."""
    folder = tmp_path_factory.mktemp("open")
    for run in (tube, plane):
        (folder / run.name).symlink_to(run)
    (folder / "sweep").mkdir()
    lines = [f"tube{k},{100 + 7 * k},{(k * 37) % 11},{k ** 1.5:.4f},<img src=x onerror=alert(4)>" for k in range(40)]
    (folder / "sweep" / "cases.csv").write_text("\n".join(["case,velocity [m/s],<b onclick=alert(5)>seed</b>,peak (GPa),note", *lines]) + "\n")
    write_table(folder / "sweep" / "sweep.h5", SweepTable((), (), (), attributes={"warnings": "<b onclick=alert(6)>extrapolated</b>\nrecalled"}))
    (folder / "sweep" / "spread.csv").write_text("result,unit,mean,standard deviation\n<b onclick=alert(7)>peak</b>,GPa,2.5,0.125\n")
    (folder / "sweep" / "tube3.run").mkdir()
    for name in ("result.h5", "summary.json", "deck.toml", "run.log", "gauges.csv"):
        (folder / "sweep" / "tube3.run" / name).write_bytes((tube / name).read_bytes())
    write_fit(folder / "spall.fit")
    (folder / "my_steel.toml").write_text(STEEL)
    (folder / "deck.toml").write_text((tube / "deck.toml").read_text())
    return folder, ["tube.run", "plane.run", "sweep", "spall.fit", "my_steel.toml", "deck.toml"]


@pytest.fixture(scope="session")
def address(opened):
    folder, arguments = opened
    command = [sys.executable, "-m", "hugoniot.cli.main", "explore", *arguments, "--no-browser", "--work", "work"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True, cwd=folder, env=os.environ) as process:
        yield re.search(r"http://\S+", process.stdout.readline()).group(0)
        process.terminate()


@pytest.fixture(scope="session")
def browser():
    if CHROMIUM is None:
        pytest.skip("no chromium on PATH: install the package chromium to test the explorer's page")
    from playwright.sync_api import sync_playwright

    with sync_playwright() as driver:
        found = driver.chromium.launch(executable_path=CHROMIUM, args=FLAGS)
        yield found
        found.close()


@pytest.fixture
def visit(browser, address):
    """Windows on the page that must not have printed, asked or opened anything they should not."""
    made = []

    def start(**options):
        made.append(Visit(browser, options.pop("start", address), **options))
        return made[-1]

    yield start
    for found in made:
        found.context.close()
        assert found.wrong == []
