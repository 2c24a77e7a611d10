"""A small run, and the explorer's application in this process."""

import pytest
from explorer_words import HOST, TOKEN

import hugoniot

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
