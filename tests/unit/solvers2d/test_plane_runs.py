"""Runs of the two-dimensional solver as such: resuming, threads, what is refused, what ends a run, turning stress."""

import dataclasses
import math

import numpy as np
import pytest
from plane_builders import TENSOR, aluminium, box, gas, noh, problem, ran, walls

from hugoniot.campaign.plane import PLANE, run_plane
from hugoniot.core import team
from hugoniot.errors import OutOfRange
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.laws.fracture.spall_stress import SpallStress
from hugoniot.materials.material import Material
from hugoniot.problem.model import Pulse
from hugoniot.problem.plane.contact_model import Rigid2D
from hugoniot.problem.plane.model import Boundary2D, VelocityField
from hugoniot.solvers.lagrange2d.assemble import N, Z
from hugoniot.solvers.lagrange2d.solver import Lagrange2D
from hugoniot.solvers.lagrange2d.zone_shapes import areas


def flyer(**options):
    """A plate that hits a longer one under an angle, yields and spalls."""
    blocks = [box(6, 10, 2e-3, 6e-3, name="a", material="al", velocity=VelocityField(base=(500.0, 100.0))),
              box(9, 10, 3e-3, 6e-3, (2e-3, 0.0), name="b", material="al")]
    return problem(blocks, aluminium(fracture=SpallStress(1e9)), 1.5e-6, walls("a.bottom", "b.bottom"), **options)


def test_a_resumed_run_has_the_same_bits():
    whole, first = ran(flyer()), ran(flyer(), cycles=37)
    payload = first.payload()
    rest = Lagrange2D(flyer())
    rest.restore(payload)
    while rest.time < rest.problem.stop_time:
        rest.march(rest.problem.stop_time, 11)
    assert whole.capped > 0
    assert rest.cycle == whole.cycle
    for name in ("zones", "nodes", "chains"):
        assert np.array_equal(getattr(rest, name), getattr(whole, name))
    assert rest.errors() == whole.errors()


def test_fields_that_no_step_keeps_are_those_of_the_state_that_stands():
    solver = ran(flyer(), cycles=37)
    assert solver.stale
    z, state = solver.zones, solver.state()
    assert not solver.stale
    assert np.allclose(z[Z.rho] * areas(*(solver._corners(row) for row in (N.x, N.y))), z[Z.mass], rtol=1e-13)
    assert np.abs(state.zones["viscous_pressure"]).max() > 0.0
    assert np.array_equal(state.zones["viscous_pressure"], z[Z.qxx] + z[Z.qyy] + z[Z.qhoop])
    middle, size = z[Z.p] - 0.5 * (z[Z.sxx] + z[Z.syy]), np.hypot(0.5 * (z[Z.sxx] - z[Z.syy]), z[Z.sxy])
    largest = np.where(middle + size > size - middle, middle + size, middle - size)
    assert np.allclose(z[Z.sigma], largest, rtol=1e-12, atol=1e-12 * np.abs(largest).max())
    assert (solver.peaks()["peak_stress"] >= z[Z.sigma] * (1.0 - 1e-12) - 1e-6).all()


@pytest.mark.skipif(not team.possible(), reason="no threads that share a march here")
def test_two_threads_give_the_same_bits(monkeypatch):
    monkeypatch.setattr("hugoniot.solvers.lagrange2d.solver.WORTH_SHARING", 1)
    monkeypatch.setattr("os.cpu_count", lambda: 2)
    one, two = ran(noh(30, stop=0.05)), ran(noh(30, stop=0.05, threads=2))
    assert two.team.threads == 2
    assert np.array_equal(one.zones, two.zones)


@pytest.mark.parametrize("options", [{"cells": "hexagons"}, {"viscosity": dataclasses.replace(TENSOR, kind="kb")}])
def test_what_it_does_not_have_is_refused(options):
    with pytest.raises(OutOfRange, match="not available"):
        Lagrange2D(noh(4, **options))


def test_a_bent_wall_is_refused():
    from test_plane_invariance import Sector

    block = dataclasses.replace(box(3, 3, density=1.0, pressure=1.0), shape=Sector((0.0, 0.0), (0.5, 1.0), (0.0, 1.0)))
    with pytest.raises(OutOfRange, match="b.right.*not straight"):
        Lagrange2D(problem(block, gas(), 1.0, walls("b.right")))


@pytest.mark.parametrize("cells", ["quads", "triangles"])
def test_stress_turns_with_a_spinning_square(cells):
    """A free square, in 100 steps a turn: the stress turns by the very angle of the square and keeps its size. Turned by the tangent of
    the angle to second order it would be 6e-3 off."""
    spinning = PLANE["spinning_square"]
    found = spinning.measure(run_plane(spinning, 100, cells=cells))
    assert found["stress_drift"] < 1e-9
    assert found["angle_error"] < 1e-6


def test_the_overshoot_of_a_shock_that_forms_is_not_what_drives_a_material():
    """Copper thrown against a wall at 3 km/s is driven to just that; its first zones overshoot, to what a shock of 3155 m/s has."""
    copper = Material("cu", MieGruneisen(8930.0, 3940.0, 1.489, 2.02))
    block = box(20, 2, 1e-2, 1e-3, material="cu", velocity=VelocityField((-3000.0, 0.0)))
    solver = ran(problem(block, copper, 0.4 * 1e-2 / (3940.0 + 1.489 * 3000.0), walls("b.left", "b.bottom", "b.top")))
    assert solver.largest_velocity_jump()["cu"] == pytest.approx(3000.0, rel=0.015)


def test_a_pressure_pulse_shorter_than_a_step_has_its_whole_impulse():
    """10 GPa for 3 ns on 6 mm, in steps of 50 ns; at the middle of a step it was missed."""
    push = Boundary2D(("body.left",), "pressure", Pulse("square", 1e10, 1e-6, 3e-9))
    solver = ran(problem([box(8, 4, 8e-3, 6e-3, name="body", material="al")], aluminium(), 1.3e-6, (push, *walls("body.bottom", "body.top"))))
    assert solver.exchanges()["impulse_x body.left"] == pytest.approx(30.0 * 6e-3, rel=1e-9)


MOVED = Pulse("table", times=(1e-6, 1.003e-6, 1.006e-6), values=(0.0, 1e3, 0.0))      # for 6 ns: 3 um


@pytest.mark.parametrize(("slip", "direction"), [(True, None), (False, None), (False, (math.cos(0.3), math.sin(0.3)))])
def test_a_velocity_pulse_shorter_than_a_step_moves_its_edge_whole(slip, direction):
    """By the values at the ends of steps of 50 ns it moved nothing; the corners are held along two directions."""
    push = Boundary2D(("body.left",), "velocity", MOVED, slip=slip, direction=direction)
    sides = () if direction else walls("body.bottom", "body.top")
    solver = ran(problem([box(8, 4, 8e-3, 6e-3, name="body", material="al")], aluminium(), 1.3e-6, (push, *sides)))
    moved = solver.nodes[[N.x, N.y], :5].T - solver.initial_nodes[:, :5].T
    assert moved @ np.array(direction or (1.0, 0.0)) == pytest.approx([3e-6] * 5, rel=1e-8)
    assert np.abs(solver.nodes[[N.u, N.v], :5]).max() < 1e-9
    assert solver.errors()["energy_error"] < 1e-12
    assert solver.errors()["momentum_error"] < 1e-12
    assert abs(solver.exchanges()["impulse_x body.left"]) > 0.1


def test_a_driven_rigid_body_moves_by_the_whole_of_its_history():
    """A punch at rest on a block, with the velocity of 6 ns in steps of 50 ns, and back to rest."""
    punch = Rigid2D("punch", ((-1e-3, 0.0), (0.0, 0.0), (0.0, 6e-3), (-1e-3, 6e-3)), closed=True, direction=(1.0, 0.0), pulse=MOVED)
    given = problem([box(8, 4, 8e-3, 6e-3, name="body", material="al")], aluminium(), 1.3e-6)
    solver = ran(dataclasses.replace(given, rigid=(punch,)))
    assert solver.exchanges()["moved_x punch"] == pytest.approx(3e-6, rel=1e-9)
    assert solver.contact.rigid_velocity()["punch"] == (0.0, 0.0, 0.0)
    assert solver.errors()["energy_error"] < 1e-12
    assert solver.exchanges()["work rigid punch"] > 0.0
