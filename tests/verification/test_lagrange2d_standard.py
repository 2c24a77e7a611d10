"""Standard problems of the two-dimensional solver against their exact solutions and the field's bands, with one set of defaults each."""

import sys
from pathlib import Path

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).parents[1] / "unit" / "solvers2d"))
from plane_builders import Boundary2D, Pulse, box, centres, gas, noh, problem, ran, walls

from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.laws.strength.linear_hardening import LinearHardening
from hugoniot.materials.material import Material
from hugoniot.mesh.shapes import Sector
from hugoniot.problem.plane.model import Block2D, VelocityField
from hugoniot.solvers.lagrange2d.assemble import N, Z


def areas(solver):
    x, y = solver._corners(N.x), solver._corners(N.y)
    return 0.5 * ((x[2] - x[0]) * (y[3] - y[1]) - (y[2] - y[0]) * (x[3] - x[1]))


def noh_error(solver, plateau, power):
    """L1 error of the density inside r < 0.39 over the plateau, and the largest density."""
    x, y = centres(solver)
    r, rho, area = np.hypot(x, y), solver.zones[Z.rho], areas(solver)
    exact, inside = np.where(r < 0.2, plateau, (1.0 + 0.6 / r) ** power), r < 0.39
    return np.sum((area * np.abs(rho - exact))[inside]) / area[inside].sum() / plateau, rho.max()


def test_noh_on_a_square_mesh():
    """50 x 50: no jets on the axes, error below half of the best of the open codes' (0.053)."""
    error, highest = noh_error(ran(noh(50)), 16.0, 1)
    assert error < 0.026 and highest < 16.5


def test_noh_in_r_z():
    """The spherical implosion on a square mesh of 50 x 50: below PENNANT's 0.058."""
    for scheme, bound in (("true_volume", 0.046), ("area_weighted", 0.054)):
        error, _ = noh_error(ran(noh(50, geometry="axisymmetric", scheme=scheme)), 64.0, 2)
        assert error < bound


@pytest.mark.slow
def test_noh_in_r_z_on_a_polar_mesh():
    """Area weighted, 100 x 30: below PENNANT's 0.038, the rings round to round-off, and energy kept."""
    block = Block2D("b", "gas", Sector((0.0, 0.0), (0.005, 1.0), (0.0, 0.5 * np.pi)), (100, 30), density=1.0, pressure=1e-10,
                    velocity=VelocityField(radial=-1.0))
    hole = Boundary2D(("b.left",), "velocity", Pulse("constant", 0.0), slip=False)
    solver = ran(problem(block, gas(), 0.6, (hole, *walls("b.bottom")), "axisymmetric", scheme="area_weighted"))
    error, _ = noh_error(solver, 64.0, 2)
    radius = np.hypot(solver.nodes[N.x], solver.nodes[N.y]).reshape(101, 31)
    assert error < 0.030 and np.ptp(radius, axis=1).max() < 1e-12 and solver.errors()["energy_error"] < 1e-12


def test_noh_on_a_polar_mesh():
    """75 x 30: symmetric to round-off."""
    block = Block2D("b", "gas", Sector((0.0, 0.0), (0.005, 1.0), (0.0, 0.5 * np.pi)), (75, 30), density=1.0, pressure=1e-10,
                    velocity=VelocityField(radial=-1.0))
    hole = Boundary2D(("b.left",), "velocity", Pulse("constant", 0.0), slip=False)
    solver = ran(problem(block, gas(), 0.6, (hole, *walls("b.bottom", "b.top"))))
    error, _ = noh_error(solver, 16.0, 1)
    assert error < 0.018
    radius = np.hypot(solver.nodes[N.x], solver.nodes[N.y]).reshape(76, 31)
    assert np.ptp(radius, axis=1).max() < 1e-10


def test_saltzman():
    """100 x 10 skewed zones at t = 0.6: shock at 0.8, density 4, straight front, little motion across."""
    shape = box(100, 10, 1.0, 0.1, density=1.0, energy=1e-4)
    driven = Boundary2D(("b.left",), "velocity", Pulse("constant", 1.0), direction=(1.0, 0.0))
    given = problem(shape, gas(), 0.6, (driven, *walls("b.right", "b.bottom", "b.top")))
    block = given.mesh.blocks[0]
    i, j = np.meshgrid(np.arange(101), np.arange(11), indexing="ij")
    block.x[...] = 0.01 * i + (10 - j) * 0.01 * np.sin(np.pi * i / 100)
    given.mesh.nodes[0, block.nodes.ravel()] = block.x.ravel()
    solver = ran(given)
    x, _ = centres(solver)
    area, rho = areas(solver), solver.zones[Z.rho]
    error = np.sum(area * np.abs(rho - np.where(x < 0.8, 4.0, 1.0))) / area.sum()
    profile, place = rho.reshape(100, 10), x.reshape(100, 10)
    last = [np.max(np.nonzero(profile[:, j] > 2.5)[0]) for j in range(10)]
    front = [np.interp(2.5, profile[[k + 1, k], j], place[[k + 1, k], j]) for j, k in enumerate(last)]
    assert error < 0.06 and np.mean(front) == pytest.approx(0.8, abs=2e-3) and np.std(front) < 1e-3
    assert np.abs(solver.nodes[N.v]).max() < 0.05
    assert solver.errors()["energy_error"] < 1e-12


def copper_bar(n):
    young, poisson = 117e9, 0.35
    bulk, shear = young / 3.0 / (1.0 - 2.0 * poisson), young / 2.0 / (1.0 + poisson)
    material = Material("cu", MieGruneisen(8930.0, np.sqrt(bulk / 8930.0), 1.49, 2.0), LinearHardening(shear, 400e6, 100e6))
    bar = box(n, round(n * 32.4 / 3.2), 3.2e-3, 32.4e-3, material="cu", velocity=VelocityField(base=(0.0, -227.0)))
    return problem(bar, material, 80e-6, walls("b.bottom"), "axisymmetric")


def test_taylor_bar_of_copper():
    """Length, foot and plastic strain within the band of the codes already at five zones; the filter takes under 1 % of the energy."""
    solver = ran(copper_bar(5))
    heat = np.sum(solver.zones[Z.mass] * solver.zones[Z.e])
    assert 21.42e-3 < solver.nodes[N.y].max() < 21.66e-3
    assert 6.95e-3 < solver.nodes[N.x].max() < 7.24e-3
    assert 2.5 < solver.zones[Z.plastic_strain].max() < 3.25
    assert solver.results()["filter_work"] < 0.01 * heat
    assert solver.errors()["energy_error"] < 1e-12 and solver.errors()["momentum_y_error"] < 1e-12
