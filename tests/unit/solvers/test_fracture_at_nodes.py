"""Fracture criteria asked at nodes: Wilkins B.4 (a) as written, and a strength that grows with the gradient of the tension."""

import dataclasses

import lagrange_builders as build
import numpy as np
import pytest

from hugoniot.errors import OutOfRange
from hugoniot.laws.fracture.contract import FRACTURE
from hugoniot.laws.fracture.pressure_volume_at_nodes import PressureVolumeAtNodes
from hugoniot.materials.material import Material
from hugoniot.problem.model import Boundary, OutputOptions, Problem, Pulse, Region, SolverOptions
from hugoniot.solvers.lagrange1d import layout as L
from hugoniot.solvers.lagrange1d.at_nodes import COLUMNS, fail_at_nodes
from hugoniot.solvers.lagrange1d.layout import H, Z

AT_NODES = PressureVolumeAtNodes(-1.0e9, 1.01)


@pytest.mark.parametrize("pressures, volumes, fails", [
    ((-1.5e9, -0.6e9), (1.02, 1.02), True),       # the mean is low enough, one of the zones is not
    ((-1.5e9, -0.4e9), (1.02, 1.02), False),      # one zone is, the mean is not
    ((-1.5e9, -1.5e9), (1.03, 0.98), False),      # the mean volume is too small
    ((-1.5e9, -1.5e9), (1.03, 1.00), True)])
def test_the_means_of_both_zones_at_the_node_count(pressures, volumes, fails):
    zones, nodes = np.zeros((len(Z), 4)), np.zeros((len(H), 5))
    nodes[H.r], zones[Z.rho] = np.arange(5.0), 2700.0
    zones[Z.p, 1:3], zones[Z.rho, 1:3] = pressures, 2700.0 / np.array(volumes)
    segments = np.array([(0, 4, L.FREE, L.FREE)])
    criteria = np.array([[0.0, 4.0, 0.0, 2700.0, *AT_NODES, 0.0]])
    assert criteria.shape[1] == COLUMNS
    fail_at_nodes.py_func(zones, nodes, segments, criteria)
    assert bool(zones[Z.failure, 1] > 1.0) is bool(zones[Z.failure, 2] > 1.0) is fails


@pytest.mark.parametrize("geometry, integrator", [("planar", "compatible"), ("spherical", "wilkins")])
def test_a_flyer_spalls_where_the_single_zones_would_let_it(geometry, integrator):
    """Within two zones of the place of `pressure_volume` with the same limits; the gap beside it belongs to no node."""
    def opened(law):
        given = build.flyer((40, 80), geometry=geometry, origin=0.05 if geometry == "spherical" else 0.0, stop=1.6e-6, integrator=integrator)
        material = dataclasses.replace(build.aluminium(), fracture=FRACTURE.get(law).build(pressure_limit=-1.2e9, volume_limit=1.01))
        solver, watcher = build.run(dataclasses.replace(given, materials={"al": material}))
        return solver, next(event for event in watcher.events if event.kind == "void_opened")

    solver, found = opened("pressure_volume_at_nodes")
    assert abs(found.position - opened("pressure_volume")[1].position) < 2 * 5e-5
    assert integrator == "wilkins" or solver.errors()["energy_error"] < 1e-13


@pytest.mark.parametrize("integrator", ["compatible", "wilkins"])
def test_a_triangular_pulse_spalls_at_the_depth_its_gradient_says(integrator):
    """Peak P and length L: tension 2 P x / L behind a free surface, so that A sqrt(2 P / L) is reached at the depth A sqrt(L / (2 P))."""
    peak, duration, depth, width, c = 1e9, 0.5e-6, 0.5e-3, 4e-3, build.EOS.c0
    gradient = 2.0 * peak / (c * duration)
    law = FRACTURE.get("stress_gradient").build(strength=gradient * depth, gradient=gradient, least=0.6 * gradient * depth)
    pulse = Boundary("pressure", Pulse("table", times=(0.0, duration, 1.0), values=(peak, 0.0, 0.0)))
    given = Problem("pulse", "planar", width / c + 0.15e-6, (Region("plate", "al", 0.0, width, 400),), {"al": Material("al", build.EOS, None, law)},
                    pulse, build.FREE, solver=SolverOptions(integrator=integrator), output=OutputOptions(report=False))
    solver, watcher = build.run(given)
    assert [event.kind for event in watcher.events][:1] == ["void_opened"]
    first = solver.segments[-1, L.SEG_FIRST]
    assert solver.zones[Z.mass, first:].sum() / 2700.0 == pytest.approx(depth, rel=0.06)


def test_an_explosive_is_refused():
    from hugoniot.materials.library import find
    from hugoniot.simulate import make_solver
    charge = dataclasses.replace(find("Composition B"), fracture=AT_NODES)
    given = Problem("charge", "planar", 1e-6, (Region("charge", charge.name, 0.0, 0.01, 20),), {charge.name: charge}, build.FIXED, build.FREE,
                    output=OutputOptions(report=False))
    with pytest.raises(OutOfRange, match="burn fraction of a zone"):
        make_solver(given)
