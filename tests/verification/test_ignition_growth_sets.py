"""Every complete ignition-and-growth set of the library in a run: unreacted Hugoniot, CJ state and steady speed of the theory tool."""

import dataclasses

import numpy as np
import pytest
from reactive_builders import driven, run

from hugoniot.campaign.pop_plot import pop_plot
from hugoniot.diagnostics.detonation import front_speed
from hugoniot.materials import library
from hugoniot.materials.material import Material
from hugoniot.theory.chapman_jouguet import cj
from hugoniot.theory.hugoniot import Initial, shock

# set: zones per mm, length of the charge in mm (about ten reaction zones)
SETS = {"G001": (50, 20), "G002": (50, 20), "G003": (50, 30), "G004": (50, 30), "G005": (50, 30), "G006": (100, 15), "G007": (100, 15),
        "G014": (200, 10), "G015": (50, 30), "G016": (50, 30), "G017": (200, 10), "G018": (200, 10), "G019": (100, 15), "G020": (50, 30)}


def the_set(name) -> Material:
    return dataclasses.replace(library.find(name), name="explosive")


@pytest.mark.parametrize("name", list(SETS))
def test_the_unreacted_explosive_follows_its_hugoniot(name):
    """A piston of 700 m/s: pressure of the plateau within 0.1 % of the jump conditions."""
    law = the_set(name).unreacted
    _, seen = run(driven(Material("explosive", law), 0.01, 200, 700.0, 1.5e-6), 4)
    exact = float(shock(law, Initial.at_rest(law), particle_velocity=700.0).pressure)
    assert np.median(seen.states[-1].zones["pressure"][10:60]) == pytest.approx(exact, rel=1e-3)


@pytest.mark.slow
@pytest.mark.parametrize("name", list(SETS))
def test_a_piston_at_the_cj_velocity_drives_the_cj_detonation(name):
    """Speed over the last third of the charge and pressure at the piston within 1 % of the products' CJ state; energy closed."""
    material, (per_mm, length) = the_set(name), SETS[name]
    point = cj(material.eos)
    speed, pressure = point.detonation_velocity, float(point.state.pressure)
    end = length * 1e-3
    _, seen = run(driven(material, end, per_mm * length, float(point.state.particle_velocity), 0.93 * end / speed), 80)
    path = seen.path("pressure", 0.4 * pressure)
    assert front_speed(seen.times, path, 0.6 * end, 0.97 * end) == pytest.approx(speed, rel=0.01)
    burned = seen.states[-1].zones["pressure"][:per_mm * length // 10]
    assert np.median(burned) == pytest.approx(pressure, rel=0.01) and seen.states[-1].zones["burn_fraction"][:50].min() > 1.0 - 1e-9
    assert seen.energy_error < 1e-12


@pytest.mark.slow
@pytest.mark.parametrize(("name", "pressure", "sizes", "change"), [
    ("G001", 15e9, (2e-5, 1e-5, 5e-6), 0.007), ("G003", 15e9, (4e-5, 2e-5, 1e-5), 0.006)])
def test_the_run_distance_converges_with_the_mesh(name, pressure, sizes, change):
    """Halving the zones twice changes it by less than `change` each time, the second time by less than the first."""
    x = [pop_plot(library.find(name), (pressure,), size).points[0].distance for size in sizes]
    first, second = abs(x[1] / x[0] - 1.0), abs(x[2] / x[1] - 1.0)
    assert second < first < change


@pytest.mark.slow
def test_slopes_of_the_pop_plots():
    """PBX-9502 (Tarver and McGuire, G003), 12 to 16 GPa: -0.31 as measured, at 1.6 times the run distance."""
    found = pop_plot(library.find("G003"), np.linspace(12e9, 16e9, 3), 4e-5)
    (row,) = library.pop_lines("G003")
    assert found.line.b == pytest.approx(row["b"], abs=0.02)
    assert found.line.distance(12e9) == pytest.approx(1.6 * 10.0 ** ((np.log10(12.0) - row["a"]) / row["b"]) * 1e-3, rel=0.05)
