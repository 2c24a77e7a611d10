"""Cells of two triangles: what no frame, mesh or geometry may change, forces as derivatives of volumes, what a shared pressure does."""

import dataclasses

import numpy as np
import pytest
from contact_builders import Rigid2D, al, askew, meeting
from plane_builders import QUIET, Boundary2D, Pulse, Viscosity2D, aluminium, box, gas, noh, problem, ran, walls
from test_plane_burning import SPEED, gamma_products, lx17
from test_plane_invariance import EDGE, HERRMANN, SCHEMES, moving, strip_1d, twisted

from hugoniot.campaign.plane import PLANE
from hugoniot.campaign.plane.smooth import set_pressure
from hugoniot.core import team
from hugoniot.diagnostics.gauges2d import Sampler
from hugoniot.errors import OutOfRange, UnphysicalState
from hugoniot.laws.fracture.spall_stress import SpallStress
from hugoniot.laws.strength.linear_hardening import LinearHardening
from hugoniot.mesh.blocks import MeshError
from hugoniot.mesh.shapes import Curve, Edges
from hugoniot.mesh.triangles import DIAGONALS
from hugoniot.problem.model import Boundary, Problem, Region, SolverOptions
from hugoniot.problem.plane.model import Block2D, Gauge2D, Lighting2D, VelocityField
from hugoniot.solvers.lagrange1d.solver import Lagrange1D
from hugoniot.solvers.lagrange2d import layout as L
from hugoniot.solvers.lagrange2d import post_mortem
from hugoniot.solvers.lagrange2d.assemble import N, Z
from hugoniot.solvers.lagrange2d.solver import Lagrange2D
from hugoniot.solvers.lagrange2d.zone_shapes import volumes

TRIANGLES = {"cells": "triangles"}


def one_of(geometry, scheme, diagonal):
    return dict(geometry=geometry, scheme=scheme, cells="triangles", diagonal=diagonal)


# -- the mesh ---------------------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("diagonal, meet", [("one_way", {6}), ("alternating", {6}), ("crossed", {4, 8})])
def test_cells_are_divided_by_one_diagonal(diagonal, meet):
    """Areas add up to the cells', as many triangles meet in a node inside as the pattern says, and edges have their own triangle behind."""
    blocks = [twisted(zones=(6, 5)), box(4, 5, 1.0, 0.95, (-1.0, 0.0), "l", density=1.0, pressure=1.0)]
    mesh = problem(blocks, gas(), 1.0, **TRIANGLES, diagonal=diagonal).mesh
    x, y = mesh.nodes[:, mesh.zone_nodes.T]
    qx, qy = mesh.nodes[:, mesh.quads.zone_nodes.T]
    area, whole = volumes(x, y, 0), volumes(qx, qy, 0)
    assert area.min() > 0.0
    for block, cells in zip(mesh.blocks, mesh.quads.blocks):
        own = area[block.first_zone : block.first_zone + block.zones].reshape(block.ni, 2, block.nj).sum(axis=1).ravel()
        assert np.allclose(own, whole[cells.first_zone : cells.first_zone + block.ni * block.nj], rtol=1e-13)
        assert block.place(block.first_zone + 2 * block.nj + 1) == (1, 1) == block.place(block.first_zone + 3 * block.nj + 1)
    count = np.bincount(mesh.zone_nodes.ravel())
    inside = mesh.blocks[0].nodes[1:-1, 1:-1]
    assert set(count[inside].ravel().tolist()) == meet
    edges = [*mesh.chains.values(), *mesh.joints.values()]
    assert len(mesh.joints) == 1
    for chain in edges:
        for edge, zones in zip(chain.edges.tolist(), np.atleast_2d(chain.zones.T).T.tolist()):
            assert all(set(edge) <= set(mesh.zone_nodes[zone].tolist()) for zone in zones)


def test_a_cell_that_is_not_convex_is_refused_where_the_diagonal_leaves_it():
    line = lambda *points: Curve("polyline", points, "points")  # noqa: E731
    shape = Edges(line((0.0, 0.0), (0.0, 1.0)), line((1.0, 0.0), (0.42, 0.45)), line((0.0, 0.0), (1.0, 0.0)), line((0.0, 1.0), (0.42, 0.45)))
    block = Block2D("dart", "gas", shape, (1, 1), density=1.0, pressure=1.0)
    assert problem(block, gas(), 1.0, **TRIANGLES).mesh.zone_nodes.shape == (2, 3)
    shape = Edges(line((0.0, 1.0), (0.42, 0.45)), line((0.0, 0.0), (1.0, 0.0)), line((0.0, 1.0), (0.0, 0.0)), line((0.42, 0.45), (1.0, 0.0)))
    with pytest.raises(MeshError, match=r"triangle of cell \(0, 0\) of block 'dart'.*not convex"):
        _ = problem(dataclasses.replace(block, shape=shape), gas(), 1.0, **TRIANGLES).mesh


# -- forces -----------------------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("geometry", ["plane", "axisymmetric"])
@pytest.mark.parametrize("diagonal", DIAGONALS)
def test_forces_of_pressure_are_derivatives_of_volume(geometry, diagonal):
    """Every node: the sum of p dV/dx over its triangles, by differences of their volumes; the gradient is the transpose."""
    given = problem(twisted(zones=(3, 4), density=1.0, pressure=1.0), gas(), 1.0, (), **one_of(geometry, "true_volume", diagonal))
    solver, kind, mesh = Lagrange2D(given), 0 if geometry == "plane" else 1, given.mesh
    pressure = np.random.default_rng(1).uniform(0.5, 2.0, len(mesh.zone_nodes))
    set_pressure(solver, pressure, 5.0 / 3.0)
    solver.begin()
    solver.march(1e-12, 1)      # from rest: the middle of the step is its start

    def work(nodes):
        return float(np.sum(pressure * volumes(*nodes[:, mesh.zone_nodes.T], kind)))

    place = mesh.nodes
    for node in range(place.shape[1]):
        for row, force in ((0, N.fx), (1, N.fy)):
            step = np.zeros_like(place)
            step[row, node] = 1e-6
            assert solver.nodes[force, node] == pytest.approx((work(place + step) - work(place - step)) / 2e-6, abs=1e-8)


@pytest.mark.parametrize("geometry, scheme", SCHEMES)
@pytest.mark.parametrize("diagonal", DIAGONALS)
def test_uniform_pressure_held_from_outside_moves_nothing(geometry, scheme, diagonal):
    """On the axis neither."""
    held = tuple(Boundary2D((f"b.{side}",), "pressure", Pulse("constant", 0.7)) for side in ("right", "bottom", "top"))
    left = Boundary2D(("b.left",), "wall" if geometry == "plane" else "axis")
    solver = ran(problem(twisted(density=1.0, pressure=0.7), gas(), 0.5, (*held, left), **one_of(geometry, scheme, diagonal)))
    assert np.abs(solver.nodes[[N.u, N.v]]).max() < 2e-13
    assert solver.errors()["energy_error"] < 1e-14


@pytest.mark.parametrize("turn", [0.0, np.radians(37.0)])
def test_a_linear_velocity_field_gives_its_own_rates(turn):
    """The volume rate is exact to the order of the step, and gauges read the field exactly."""
    gradient = np.array(((0.3, -0.7), (0.2, 0.5)))
    at = tuple(np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]]) @ (0.31, 0.47))
    given = problem(twisted(turn=turn, density=1.0, pressure=0.0, velocity=VelocityField(gradient=tuple(map(tuple, gradient)))), gas(), 1.0,
                    initial_step=1e-6, largest_step=1e-6, **TRIANGLES)
    given = dataclasses.replace(given, gauges=(Gauge2D("g", "point", at),))
    solver = Lagrange2D(given)
    read = Sampler(given)(solver.state())
    assert np.allclose([read["velocity_x"][0], read["velocity_y"][0]], gradient @ at, rtol=1e-12)
    assert np.allclose([read["position_x"][0], read["position_y"][0]], at, rtol=1e-12)
    before = solver.zones[Z.rho].copy()
    solver.march(1.0, 1)
    assert np.allclose((before / solver.zones[Z.rho] - 1.0) / solver.step, 0.8, rtol=0, atol=2e-6)


# -- runs -------------------------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("geometry, scheme", SCHEMES)
@pytest.mark.parametrize("kind", ["gas", "alone", "spall", "edge", "herrmann"])
def test_energy_and_momentum_are_kept(geometry, scheme, kind):
    """To round-off with each viscosity, strength, failure, a shared pressure or none; the axial momentum in area weights too, but for the
    forces of edges, which no stress gives."""
    material = {"gas": gas(), "spall": aluminium(fracture=SpallStress(0.5e9))}.get(kind) or aluminium()
    viscosity = {"edge": EDGE, "herrmann": HERRMANN}.get(kind, Viscosity2D())
    diagonal = "crossed" if kind == "spall" else "one_way"
    solver = ran(moving(material, viscosity=viscosity, average_pressure=kind != "alone", **one_of(geometry, scheme, diagonal)))
    errors = solver.errors()
    assert solver.cycle > 10
    assert errors["energy_error"] < 1e-12
    assert errors["mass_error"] == 0.0
    if scheme == "true_volume" or kind != "edge":
        assert errors["momentum_error"] < 1e-12
    if kind == "spall":
        assert solver.capped > 0
        assert -solver.zones[Z.peak_tension].min() < 0.5e9 * (1.0 + 1e-12)      # the strength holds behind the mean of the pressures
    if kind != "gas" and kind != "alone":      # of triangles that share their pressure
        block = solver.problem.mesh.blocks[0]
        (lower, upper), density = (solver.zones[row].reshape(block.ni, 2, block.nj).transpose(1, 0, 2) for row in (Z.p, Z.rho))
        assert np.array_equal(*density)
        assert np.mean(lower == upper) > 0.5 if kind == "spall" else np.array_equal(lower, upper)      # voids relieve their own triangle


@pytest.mark.parametrize("geometry, scheme, viscosity", [("plane", "true_volume", "tensor"), ("plane", "true_volume", "edge"),
                                                        ("axisymmetric", "true_volume", "tensor"), ("axisymmetric", "area_weighted", "tensor")])
@pytest.mark.parametrize("solid", [False, True])
def test_a_strip_is_the_one_dimensional_solver(geometry, scheme, viscosity, solid):
    """A shock along y, in the plane and as a slab of a cylinder: the one-dimensional run, zone by zone."""
    n, material = 30, aluminium() if solid else gas(1.4)
    state = {} if solid else {"density": 1.0, "pressure": 1.0}
    speed, stop, step = (300.0, 2.5e-5, 2e-7) if solid else (1.0, 0.15, 1e-3)
    steps = dict(initial_step=step, largest_step=step)
    one = strip_1d(n, material, stop, Boundary("velocity", Pulse("constant", speed)), Boundary("fixed"), steps, **state)
    driven = Boundary2D(("b.bottom",), "velocity", Pulse("constant", speed), direction=(0.0, 1.0))
    sides = (driven, *walls("b.top", "b.right", *(("b.left",) if geometry == "plane" else ())))
    solver = ran(problem(box(3, n, 0.3, 1.0, material=material.name, **state), material, stop, sides, geometry, scheme=scheme,
                         viscosity=Viscosity2D(viscosity), **TRIANGLES, **steps))
    assert solver.cycle == one.cycle
    for name, row in (("density", Z.rho), ("energy", Z.e), ("pressure", Z.p)):
        expected = one.state().zones[name]
        assert np.allclose(solver.zones[row].reshape(6, n), expected, rtol=0, atol=1e-10 * np.abs(expected).max())


def flyer(**options):
    """A plate that hits a longer one under an angle, yields and spalls."""
    blocks = [box(6, 10, 2e-3, 6e-3, name="a", material="al", velocity=VelocityField(base=(500.0, 100.0))),
              box(9, 10, 3e-3, 6e-3, (2e-3, 0.0), name="b", material="al")]
    return problem(blocks, aluminium(fracture=SpallStress(1e9)), 1.5e-6, walls("a.bottom", "b.bottom"), **TRIANGLES, diagonal="crossed",
                   **options)


def test_a_resumed_run_has_the_same_bits():
    whole, first, rest = ran(flyer()), ran(flyer(), cycles=37), Lagrange2D(flyer())
    rest.restore(first.payload())
    while rest.time < rest.problem.stop_time:
        rest.march(rest.problem.stop_time, 11)
    assert whole.capped > 0 and whole.errors()["energy_error"] < 1e-12
    for name in ("zones", "nodes", "chains"):
        assert np.array_equal(getattr(rest, name), getattr(whole, name))


@pytest.mark.skipif(not team.possible(), reason="no threads that share a march here")
def test_two_threads_give_the_same_bits(monkeypatch):
    monkeypatch.setattr("hugoniot.solvers.lagrange2d.solver.WORTH_SHARING", 1)
    monkeypatch.setattr("os.cpu_count", lambda: 2)
    one, two = (ran(dataclasses.replace(flyer(), solver=dataclasses.replace(flyer().solver, threads=k)), cycles=60) for k in (1, 2))
    assert two.team.threads == 2
    assert np.array_equal(one.zones, two.zones)


def test_bodies_of_triangles_meet():
    """Two boxes that strike each other off centre, and one that falls on a rigid floor: momentum and energy exact, no overlap."""
    solver = ran(askew(**TRIANGLES))
    assert solver.errors()["momentum_error"] < 1e-13 and solver.errors()["energy_error"] < 1e-13
    assert solver.results()["contact_heat"] > 0.0 and solver.results()["contact_depth"] < 1e-3
    floor = Rigid2D("floor", ((-10e-3, -0.1e-3), (30e-3, -0.1e-3)))
    fallen = ran(meeting([al(5, 4, 5e-3, 4e-3, velocity=(0.0, -200.0))], 2e-6, rigid=(floor,), **TRIANGLES))
    assert fallen.errors()["energy_error"] < 1e-13
    assert fallen.exchanges()["impulse_y rigid floor"] > 0.0


def test_a_charge_of_triangles_burns_at_its_velocity():
    """A plane detonation: the front where the programme has it, the whole heat of what is burned, energy kept."""
    sides = walls("b.left", "b.right", "b.bottom")
    block = box(4, 40, 0.01, 0.05, material="hx")
    given = problem(block, gamma_products(), 5e-6, sides, viscosity=Viscosity2D(), **TRIANGLES, diagonal="crossed")
    solver = ran(dataclasses.replace(given, lighting=(Lighting2D((0.0, 0.0), 0.0, (0.01, 0.0)),)))
    lam, state = solver.state().zones["burn_fraction"], solver.state()
    height = state.nodes["position_y"][state.zone_nodes].mean(axis=1)
    assert height[lam > 0.5].max() == pytest.approx(SPEED * 5e-6, abs=2.0 * 0.05 / 40)
    assert solver.errors()["energy_error"] < 1e-12


@pytest.mark.slow
@pytest.mark.parametrize("geometry, scheme", [("plane", "true_volume"), ("axisymmetric", "area_weighted")])
def test_ignition_and_growth_in_a_strip_is_the_one_dimensional_run(geometry, scheme):
    """LX-17 with strength, pushed at 1.2 km/s; reactants in thermal isolation."""
    material, n, stop = lx17("thermal_isolation", strength=LinearHardening(4e9, 0.1e9, 0.05e9)), 40, 2e-6
    steps = dict(initial_step=stop / 1000, largest_step=stop / 1000)
    region, pulse = Region("b", "hx", 0.0, 0.02, n), Pulse("constant", 1200.0)
    one = Lagrange1D(Problem("strip", "planar", stop, (region,), {"hx": material}, Boundary("velocity", pulse), Boundary("fixed"),
                             output=QUIET, solver=SolverOptions(courant=0.4, **steps, options={"heat_flux": 0.0})))
    one.march(stop, 10_000)
    sides = (Boundary2D(("b.bottom",), "velocity", pulse, direction=(0.0, 1.0)), *walls("b.right", "b.top"))
    sides += walls("b.left") if geometry == "plane" else ()
    two = ran(problem(box(3, n, 0.01, 0.02, material="hx"), material, stop, sides, geometry, scheme=scheme, viscosity=Viscosity2D(),
                      **TRIANGLES, **steps))
    assert two.cycle == one.cycle and two.errors()["energy_error"] < 1e-12
    for name in ("density", "energy", "pressure", "burn_fraction"):
        expected = one.state().zones[name]
        assert np.allclose(two.state().zones[name].reshape(6, n), expected, rtol=0, atol=1e-10 * np.abs(expected).max()), name


# -- what a shared pressure is for --------------------------------------------------------------------------------------------
@pytest.fixture(scope="module")
def taylor_lengths():
    """(length, foot) of a copper bar after its impact, by its coarse cells: quadrilaterals, and triangles with a shared pressure or none."""
    start, found = PLANE["taylor_copper"].start, {}
    for name, options in {"quads": {}, **{d: dict(TRIANGLES, diagonal=d) for d in DIAGONALS},
                          "alone": dict(TRIANGLES, diagonal="alternating", average_pressure=False)}.items():
        solver = start(3, options)
        while solver.time < 80e-6:
            solver.march(80e-6, 10_000)
        found[name] = float(solver.nodes[N.y].max()), float(solver.nodes[N.x].max())
    return found


def test_a_taylor_bar_of_triangles_is_that_of_quads(taylor_lengths):
    """In length for every pattern; the goal is 2 %."""
    length, _ = taylor_lengths["quads"]
    for diagonal in DIAGONALS:
        assert taylor_lengths[diagonal][0] == pytest.approx(length, rel=0.005)


def test_triangles_alone_are_too_stiff_in_plastic_flow(taylor_lengths):
    """The foot of the bar spreads less where each triangle has a volume of its own to keep."""
    assert taylor_lengths["alone"][1] < 0.95 * taylor_lengths["alternating"][1]


# -- what goes wrong ------------------------------------------------------------------------------------------------------------
def test_a_tangled_mesh_is_reported_by_its_cell():
    """The post-mortem names the cell of the triangle that is worst."""
    solver = Lagrange2D(noh(4, **TRIANGLES))
    block = solver.problem.mesh.blocks[0]
    solver.nodes[N.x, solver.numbering.local(0, 2, 2)] = solver.nodes[N.x, solver.numbering.local(0, 3, 3)] + 0.2
    error = post_mortem.diagnose(solver, L.TANGLED)
    assert isinstance(error, UnphysicalState) and "would invert" in str(error)
    assert (error.values["i"], error.values["j"]) == block.place(error.zone)
    assert error.values["area"] < 0.0
    assert "check the initial velocities and the mesh" in str(error)      # nothing can stop before cycle 0
    solver.counters[L.CYCLE] = 1
    assert "stop earlier" in str(post_mortem.diagnose(solver, L.TANGLED))


@pytest.mark.parametrize("options", [{"cells": "hexagons"}, {"cells": "triangles", "diagonal": "both"}])
def test_what_it_does_not_have_is_refused(options):
    with pytest.raises(OutOfRange, match="hexagons|both"):
        Lagrange2D(noh(4, **options))
