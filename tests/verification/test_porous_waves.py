"""Waves in laws with a memory: crushed pores stay crushed in Riemann solutions and wave diagrams, as in runs and in `release`."""

import dataclasses

import numpy as np
import pytest

from hugoniot.laws.eos.contract import EOS, compacted, pressure, remembered, unloading
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.materials.material import Material
from hugoniot.problem.model import Boundary, OutputOptions, Problem, Region
from hugoniot.simulate import make_solver
from hugoniot.theory.hugoniot import shock
from hugoniot.theory.impedance import match
from hugoniot.theory.isentrope import isentrope, reference, release, state
from hugoniot.theory.riemann import riemann
from hugoniot.theory.waves import wave_diagram

SOFT = MieGruneisen(1000.0, 1450.0, 1.9, 0.5)
CU = MieGruneisen(8930.0, 3940.0, 1.489, 1.99)
LAWS = ("p_alpha", "p_lambda", "snow_plough")


@pytest.mark.parametrize("name", LAWS)
@pytest.mark.parametrize("up", [40.0, 200.0, 320.0])
def test_a_fan_in_crushed_material_is_elastic_and_a_reshock_follows_it_back(name, up):
    par = EOS.get(name).example
    loaded = shock(par, particle_velocity=up)
    done = compacted(0.0, loaded.density, loaded.specific_internal_energy, loaded.pressure, par)
    elastic = unloading(remembered(done, par))
    fan = riemann(par, loaded, SOFT, reference(SOFT, up))
    assert fan.left.kind == "fan"
    expected = isentrope(elastic, loaded, pressure=fan.pressure, direction=-1)
    assert fan.left.behind.density == pytest.approx(expected.density, rel=1e-12)
    assert fan.velocity == pytest.approx(expected.particle_velocity, rel=1e-9)
    assert fan.left.head == pytest.approx(up - release(par, loaded, loaded.pressure).sound_speed, rel=1e-9)
    middle = 0.5 * (fan.left.head + fan.left.tail)
    inside = fan(middle)
    assert inside["pressure"] == pytest.approx(pressure(inside["density"], inside["energy"], elastic), rel=1e-9)
    # struck again below the first peak, it goes back along the elastic branch: a weak shock there is an isentrope to third order
    again = riemann(par, fan.left.behind, CU, state(CU, fan.velocity, pressure=0.5 * (fan.pressure + loaded.pressure)))
    assert fan.pressure < again.pressure < loaded.pressure
    back = isentrope(elastic, loaded, pressure=again.pressure)
    assert again.left.behind.density == pytest.approx(back.density, rel=1e-6)


@pytest.mark.parametrize("name", LAWS)
def test_a_free_surface_moves_as_the_elastic_release_says(name):
    par = EOS.get(name).example
    met = match([CU, par], 250.0)[0]
    found = wave_diagram([CU, par], [20e-3, 2e-3], 250.0, 2.1e-3 / met.right.shock_velocity)
    surface = found.fronts[-1]
    assert surface.kind == "surface"
    assert surface.velocity == pytest.approx(release(par, met.right).particle_velocity, rel=1e-3)
    freed = found.profile()[-1][3]
    assert freed.density == pytest.approx(release(par, met.right).density, rel=1e-3)


@pytest.mark.slow
def test_the_diagram_is_what_a_run_gives():
    """Copper on porous aluminium, 250 m/s: velocity and density of the released end behind the free surface."""
    par = EOS.get("snow_plough").example       # no precursor runs ahead of the crush, which the diagram's single shock would leave out
    stop = 2.2e-3 / match([CU, par], 250.0)[0].right.shock_velocity
    diagram = wave_diagram([CU, par], [8e-3, 2e-3], 250.0, stop)
    expected = diagram.profile()[-1][3]
    regions = (Region("flyer", "cu", -8e-3, 0.0, 400, velocity=250.0), Region("target", "porous", 0.0, 2e-3, 200))
    problem = Problem("release", "planar", stop, regions, {"cu": Material("cu", CU), "porous": Material("porous", par)},
                      Boundary("free"), Boundary("free"), output=OutputOptions(report=False))
    solver = make_solver(problem)
    while solver.time < problem.stop_time:
        solver.march(problem.stop_time, 10_000)
        solver.take_gauges()
    end = solver.state()
    last = slice(-30, -10)
    assert np.mean(end.velocity_right[last]) == pytest.approx(expected.particle_velocity, rel=1e-3)
    assert np.mean(end.zones["density"][last]) == pytest.approx(expected.density, rel=1e-4)


def test_laws_without_memory_keep_their_states():
    answer = riemann(CU, shock(CU, particle_velocity=200.0), SOFT, reference(SOFT))
    assert answer.left.ahead.par is answer.left.behind.par is CU
    assert dataclasses.is_dataclass(answer.left)
