"""A step that is taken band by band: the height of the bands changes no bit, neither alone nor in a team, nor where a step is repeated."""

import dataclasses

import numpy as np
import pytest
from plane_builders import Boundary2D, Pulse, aluminium, box, gas, noh, problem, walls

from hugoniot.core import team
from hugoniot.problem.plane.model import VelocityField
from hugoniot.solvers.lagrange2d import rewind
from hugoniot.solvers.lagrange2d.bands import local
from hugoniot.solvers.lagrange2d.solver import Lagrange2D

WHOLE = 1000      # rows, more than any mesh here has


def bar(**options):
    """A rod on a wall, about the axis, pushed from behind by a pressure that changes in time."""
    push = Boundary2D(("b.top", "b.right"), "pressure", Pulse("half_sine", 2e9, duration=2e-6))
    block = box(13, 9, 4e-3, 6e-3, material="al", velocity=VelocityField(base=(0.0, -300.0)))
    sides = Boundary2D(("b.left",), "axis"), *walls("b.bottom"), push
    return problem(block, aluminium(), 2e-6, sides, "axisymmetric", scheme="area_weighted", **options)


def marched(given, height, cycles):
    """What a run leaves behind after some cycles whose bands have a height, in rows."""
    solver = Lagrange2D(given)
    solver.planner.height = height
    solver.march(given.stop_time, cycles)
    return solver, [solver.zones.copy(), solver.nodes[rewind.NODE_ROWS], solver.chains.copy(), solver.control.copy()]


def same(one, other):
    return all(np.array_equal(*pair) for pair in zip(one, other))


@pytest.mark.parametrize("given", [bar(), bar(cells="triangles"), noh(12)], ids=["quads", "triangles", "gas"])
def test_bands_give_the_same_bits(given):
    """One row at a time, some rows, the whole mesh at once."""
    solver, whole = marched(given, WHOLE, 40)
    assert local(solver.run, False)
    for height in (1, 2, 5):
        assert same(marched(given, height, 40)[1], whole)


@pytest.mark.skipif(not team.possible(), reason="no threads that share a march here")
def test_bands_of_a_team_give_the_same_bits(monkeypatch):
    _, whole = marched(bar(), WHOLE, 40)
    monkeypatch.setattr("hugoniot.solvers.lagrange2d.solver.WORTH_SHARING", 1)
    monkeypatch.setattr("hugoniot.solvers.lagrange2d.plan.BAND", 20)
    monkeypatch.setattr("os.cpu_count", lambda: 3)
    solver, shared = marched(bar(threads=3), 6, 40)
    assert solver.team.threads == 3 and same(shared, whole)


@pytest.mark.parametrize("kept_for", [rewind.KEPT_FOR, 3])
def test_a_step_repeated_after_some_bands_were_led_on(monkeypatch, kept_for):
    """Steps far too long for a mesh that is crushed: found tangled in a late band, taken again from a copy; the energy is kept."""
    monkeypatch.setattr(rewind, "KEPT_FOR", kept_for)
    block = box(14, 6, density=1.0, pressure=0.1, velocity=VelocityField(gradient=((-1.0, 0.0), (0.0, -1.0))))
    given = dataclasses.replace(problem(block, gas(), 0.3, initial_step=0.3, courant=6.0), stop_time=10.0)
    solver, whole = marched(given, WHOLE, 30)
    assert solver.results()["steps_repeated"] > 2
    solver, bands = marched(given, 1, 30)
    assert solver.rewind.whole_until > 30 and same(bands, whole)
    assert solver.errors()["energy_error"] < 1e-12


def test_blocks_that_share_nodes_are_one_band():
    """What acts on rows that are not neighbours is no matter of a band."""
    blocks = [box(4, 5, name="a", density=1.0, pressure=0.1), box(4, 5, origin=(1.0, 0.0), name="b", density=1.0, pressure=0.2)]
    solver = Lagrange2D(problem(blocks, gas(), 1.0))
    assert not local(solver.run, False)
