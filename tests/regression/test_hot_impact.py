"""Library metals at speeds where they melt: the run goes through, has temperatures, and says once that its data end below."""

import numpy as np
import pytest

import hugoniot

DECK = """
title = "Copper on aluminium"
geometry = "planar"
stop_time = "0.6 us"
[[region]]
name = "flyer"
material = "copper"
from = "0 mm"
to = "2 mm"
zones = 60
velocity = "8 km/s"
[[region]]
name = "target"
material = "al6061"
from = "2 mm"
to = "8 mm"
zones = 180
[[gauge]]
name = "inside"
at = "4 mm"
"""


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    place = tmp_path_factory.mktemp("hot")
    (place / "hot.toml").write_text(DECK, encoding="utf-8")
    return hugoniot.run(place / "hot.toml", out=place / "hot.run", report=False)


def test_energy_and_momentum_are_kept_through_melting(run):
    assert run.summary["status"] == "done"
    assert run.summary["energy_error"] < 1e-12 and run.summary["momentum_error"] < 1e-12


def test_the_shock_is_the_one_impedance_matching_gives(run):
    """Hydrodynamic at these pressures: the plateau at the gauge against the jump conditions, 0.5 %."""
    from hugoniot.materials import library
    from hugoniot.theory import impedance

    met = impedance.match([library.find("copper"), library.find("al6061")], 8000.0)
    time, stress = run.gauge("stress", "inside")
    plateau = stress[(time > 0.2e-6) & (time < 0.25e-6)]
    assert float(np.mean(plateau)) == pytest.approx(float(met[0].pressure), rel=5e-3)


def test_gauges_and_snapshots_have_temperatures(run):
    time, temperature = run.gauge("temperature", "inside")
    assert temperature[0] == pytest.approx(298.15, abs=1.0)
    assert 3000.0 < temperature.max() < 30000.0
    assert run.snapshots["temperature"].attrs["units"] == "K"


def test_the_end_of_the_data_is_told_once_of_the_material_that_is_driven_beyond_it(run):
    """Aluminium takes 5.4 of the 8 km/s, copper 2.6, which is within its data; half of 8 km/s would be beyond both."""
    from hugoniot.materials import library
    from hugoniot.theory import impedance

    up = impedance.match([library.find("copper"), library.find("al6061")], 8000.0)[0].particle_velocity
    events = run.arrays("events")
    warnings = [text for kind, text in zip(events["kind"], events["text"]) if kind == "warning" and "its data" in text or "the data of" in text]
    assert up > 3844.0 and 8000.0 - up < 2946.0
    assert len(warnings) == 1 and "'al6061'" in warnings[0] and "3844" in warnings[0]
