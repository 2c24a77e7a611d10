"""What ends a run in two dimensions, and how it says so; what is refused before it begins."""

import numpy as np
import pytest
from plane_builders import Viscosity2D, aluminium, box, gas, problem

from hugoniot.errors import OutOfRange, UnphysicalState
from hugoniot.laws.fracture.contract import FRACTURE
from hugoniot.mesh.blocks import MeshError
from hugoniot.mesh.shapes import Curve, Edges
from hugoniot.problem.plane.model import Block2D, VelocityField
from hugoniot.solvers.lagrange2d.assemble import N, Z
from hugoniot.solvers.lagrange2d.solver import Lagrange2D


def at_rest():
    solver = Lagrange2D(problem(box(4, 4, density=1.0, pressure=1.0), gas(), 1.0))
    solver.march(1.0, 3)
    return solver


@pytest.mark.parametrize("table, row, column, zone", [("zones", Z.e, 5, 5), ("zones", Z.p, 6, 6), ("nodes", N.u, 7, 1), ("nodes", N.y, 0, 0)])
def test_a_state_that_is_no_number_ends_the_run_in_its_cycle(table, row, column, zone):
    """The zone is named, or the first one at the node whose motion is no number."""
    solver = at_rest()
    getattr(solver, table)[row, column] = np.nan
    solver.begin()
    with pytest.raises(UnphysicalState, match="not a number") as caught:
        solver.march(1.0, 5)
    assert caught.value.zone == zone and caught.value.region == "b"
    assert solver.cycle <= 4


def test_a_zone_that_becomes_flat_ends_the_run_with_place_and_energy_kept():
    """Cold gas that nothing holds falls into one point: steps are repeated smaller, then the run ends; what came before is kept."""
    given = problem(box(6, 6, density=1.0, pressure=1e-9, velocity=VelocityField(centre=(0.5, 0.5), radial=-1.0)), gas(), 5.0,
                    subzonal_pressure=0.0, viscosity=Viscosity2D("tensor", True, 0.0, 0.0, 0.0, 0.0))
    solver = Lagrange2D(given)
    with pytest.raises(UnphysicalState, match="flat|inside out") as caught:
        solver.march(5.0, 10_000)
    i, j = caught.value.values["i"], caught.value.values["j"]
    assert i in (2, 3) and j in (2, 3) and caught.value.values["x"] == pytest.approx(0.5, abs=0.02)
    assert solver.results()["steps_repeated"] > 0 and solver.time == pytest.approx(1.0 / 6.0, rel=1e-3)
    assert solver.errors()["energy_error"] < 1e-12
    assert np.isfinite(solver.payload()["zones"]).all()


def line(p, q):
    return Curve("line", (p, q))


def test_a_mesh_that_runs_clockwise_is_refused():
    mirrored = Edges(line((1, 0), (1, 1)), line((0, 0), (0, 1)), line((1, 0), (0, 0)), line((1, 1), (0, 1)))
    with pytest.raises(MeshError, match="block 'b' runs clockwise"):
        Lagrange2D(problem(Block2D("b", "gas", mirrored, (3, 3), density=1.0, pressure=1.0), gas(), 1.0))


def test_a_mesh_that_is_folded_is_refused():
    """A side that bends so far inward that zones beside it have no area."""
    bent = Curve("polyline", ((0, 0), (1.8, 0.5), (0, 1)))
    folded = Edges(bent, line((1, 0), (1, 1)), line((0, 0), (1, 0)), line((0, 1), (1, 1)))
    with pytest.raises(MeshError, match="block 'b'.*zone"):
        Lagrange2D(problem(Block2D("b", "gas", folded, (4, 4), density=1.0, pressure=1.0), gas(), 1.0))


@pytest.mark.parametrize("origin, words", [((0.5, 0.0), "overlaps block 'a'"), ((1.0, 0.1), "their nodes do not coincide")])
def test_blocks_that_do_not_fit_are_refused(origin, words):
    blocks = [box(3, 3, name="a", density=1.0, pressure=1.0), box(3, 3, origin=origin, name="c", density=1.0, pressure=1.0)]
    with pytest.raises(MeshError, match=words):
        Lagrange2D(problem(blocks, gas(), 1.0))


def test_a_criterion_at_nodes_is_refused():
    law = FRACTURE.get("stress_gradient").build(strength=1e9, gradient=1e12, least=0.5e9)
    with pytest.raises(OutOfRange, match="opens voids at nodes, but in two dimensions"):
        Lagrange2D(problem(box(2, 2, material="al"), aluminium(fracture=law), 1.0))
