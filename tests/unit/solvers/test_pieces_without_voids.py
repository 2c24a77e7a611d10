"""Pieces of zones in which no voids stand take a shorter list of passes, which changes no bit."""

import lagrange_builders as build
import numpy as np
import pytest

from hugoniot.simulate import make_solver
from hugoniot.solvers.lagrange1d.layout import PIECE, Z
from hugoniot.solvers.lagrange1d.plan import FROM, INTACT, INTACT_TO, TO, Planner, pieces_alike


def ended(problem, planned=None, monkeypatch=None):
    """The solver at the end of its run, plans changed by `planned`."""
    if planned is not None:
        plan = Planner.plan
        monkeypatch.setattr(Planner, "plan", lambda *arguments: planned(plan(*arguments)))
    solver = make_solver(problem)
    while solver.time < problem.stop_time:
        solver.march(problem.stop_time, 100_000)
        solver.take_gauges()
    return solver


def with_voids_everywhere(plan):
    plan.shares[:, [INTACT, INTACT_TO]] = plan.shares[:, [FROM, TO]]
    return plan


@pytest.mark.parametrize("integrator, geometry", [("compatible", "planar"), ("compatible", "cylindrical"), ("wilkins", "planar")])
def test_the_shorter_list_changes_no_bit(integrator, geometry, monkeypatch):
    """A flyer of 3 pieces in which voids grow and a body opens, against one whose pieces are all taken as holding voids."""
    problem = build.flyer((120, 240), geometry=geometry, origin=1e-2 if geometry != "planar" else 0.0, integrator=integrator, stop=1.4e-6)
    one = ended(problem)
    other = ended(problem, with_voids_everywhere, monkeypatch)
    assert one.zones.tobytes() == other.zones.tobytes() and one.nodes.tobytes() == other.nodes.tobytes()
    pieces = [one.zones[Z.voids, k:k + PIECE].any() for k in range(0, one.zones.shape[1], PIECE)]
    assert any(pieces) and not all(pieces)


def test_pieces_are_taken_together_while_they_are_alike():
    voids = np.zeros(600)
    voids[300], voids[599] = 1e-9, np.nan
    assert pieces_alike(voids.ctypes.data, 0, 600, 128) == (False, 256)
    assert pieces_alike(voids.ctypes.data, 256, 600, 128) == (True, 384)
    assert pieces_alike(voids.ctypes.data, 384, 600, 128) == (False, 512)
    assert pieces_alike(voids.ctypes.data, 512, 600, 128) == (True, 600)
