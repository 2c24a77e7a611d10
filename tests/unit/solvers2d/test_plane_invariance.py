"""What no mesh, frame or geometry may change: uniform states, linear motion, mirrored and turned frames, strips, conservation."""

import dataclasses

import numpy as np
import pytest
from plane_builders import Boundary2D, Pulse, Viscosity2D, aluminium, box, gas, problem, ran, walls

from hugoniot.errors import OutOfRange
from hugoniot.laws.eos.contract import EOS
from hugoniot.laws.fracture.spall_stress import SpallStress
from hugoniot.materials.material import Material
from hugoniot.mesh.shapes import Curve, Edges, Sector
from hugoniot.problem.model import Boundary, OutputOptions, Problem, Region, SolverOptions
from hugoniot.problem.plane.model import Block2D, VelocityField
from hugoniot.solvers.lagrange1d.solver import Lagrange1D
from hugoniot.solvers.lagrange2d.assemble import N, Z
from hugoniot.solvers.lagrange2d.solver import Lagrange2D

SCHEMES = [("plane", "true_volume"), ("axisymmetric", "true_volume"), ("axisymmetric", "area_weighted")]
SHAPES = {"quadrilaterals": {}, "triangles": {"cells": "triangles", "diagonal": "crossed"}}


def twisted(material="gas", zones=(6, 5), turn=0.0, offset=(0.0, 0.0), **state):
    """A block with no right angle in it, at its left on x = 0."""
    corners = np.array([(0.0, 0.0), (1.0, 0.12), (0.9, 1.1), (0.0, 0.95)]) + offset
    c, s = np.cos(turn), np.sin(turn)
    a, b, d, e = (tuple(p) for p in corners @ np.array([[c, s], [-s, c]]))
    line = lambda p, q: Curve("line", (p, q))  # noqa: E731
    return Block2D("b", material, Edges(line(a, e), line(b, d), line(a, b), line(e, d)), zones, **state)


@pytest.mark.parametrize("geometry, scheme", SCHEMES)
def test_uniform_pressure_held_from_outside_moves_nothing(geometry, scheme):
    """The pressure of the gas on all sides: no node moves, on the axis neither."""
    held = tuple(Boundary2D((f"b.{side}",), "pressure", Pulse("constant", 0.7)) for side in ("right", "bottom", "top"))
    left = Boundary2D(("b.left",), "wall" if geometry == "plane" else "axis")
    solver = ran(problem(twisted(density=1.0, pressure=0.7), gas(), 0.5, (*held, left), geometry, scheme=scheme))
    assert np.abs(solver.nodes[[N.u, N.v]]).max() < 2e-13
    assert solver.errors()["energy_error"] < 1e-14


@pytest.mark.parametrize("geometry, scheme", SCHEMES)
def test_a_pressure_on_one_face_pushes_along_the_axis(geometry, scheme):
    """A plate under pressure on its lower face gains pressure times area times time, and every node of the face the same speed at first."""
    plate = problem(box(4, 3, 0.8, 0.3, density=1.0, pressure=0.01), gas(), 1e-3,
                    (Boundary2D(("b.bottom",), "pressure", Pulse("constant", 2.0)), *(walls("b.left") if geometry == "plane" else ())),
                    geometry, scheme=scheme)
    solver = ran(plate)
    area = 0.8 if geometry == "plane" else 0.5 * 0.8**2
    gained = np.sum(solver.nodes[N.own] * solver.nodes[N.v])
    assert gained == pytest.approx(2.0 * area * 1e-3, rel=1e-6)
    assert np.ptp(solver.nodes[N.v].reshape(5, 4)[:, 0]) < 1e-7


@pytest.mark.parametrize("turn", [0.0, np.radians(37.0)])
def test_a_linear_velocity_field_gives_its_own_rates(turn):
    """Strain rates and spin of a linear field are exact in the first step; so is the volume rate, to the order of the step."""
    gradient = ((0.3, -0.7), (0.2, 0.5))
    given = problem(twisted(turn=turn, density=1.0, pressure=0.0, energy=None, velocity=VelocityField(gradient=gradient)), gas(), 1.0,
                    initial_step=1e-6, largest_step=1e-6, subzonal_pressure=0.0)
    solver = Lagrange2D(given)
    before = solver.zones[Z.rho].copy()
    solver.march(1.0, 1)
    rate = (before / solver.zones[Z.rho] - 1.0) / solver.step
    assert np.allclose(rate, 0.8, rtol=0, atol=2e-6)


def strip_1d(n, material, stop, left, right, steps, **state):
    """The run in one dimension, with its default viscosity."""
    region = Region("b", material.name, 0.0, 1.0, n, **state)
    given = Problem("strip", "planar", stop, (region,), {material.name: material}, left, right, output=OutputOptions(report=False),
                    solver=SolverOptions(courant=0.4, options={"heat_flux": 0.0}, **steps))
    solver = Lagrange1D(given)
    while solver.time < stop:
        solver.march(stop, 1000)
    return solver


@pytest.mark.parametrize("geometry", ["plane", "axisymmetric"])
@pytest.mark.parametrize("kind", ["gas", "liquid", "solid", "porous"])
def test_a_strip_is_the_one_dimensional_solver(geometry, kind):
    """A shock along y, in the plane and as a slab of a cylinder: the one-dimensional run, zone by zone, with the default viscosity of both.

    Condensed matter takes steps of given length: in one dimension the foot of a wave, however faint, limits the step, in two in proportion only.
    Its end starts to move between two steps, by a jump; the zones have sizes without rounding, so that none of it decides what the limiter
    does before.
    """
    n, solid = 32, kind != "gas"
    material = {"gas": gas(1.4), "solid": aluminium(), "porous": Material("foam", EOS.get("p_alpha").example),
                "liquid": dataclasses.replace(aluminium(), strength=None)}[kind]
    state = {} if solid else {"density": 1.0, "pressure": 1.0}
    speed, stop = (300.0, 2.5e-5) if solid else (1.0, 0.15)
    steps = dict(initial_step=2e-7, largest_step=2e-7) if solid else {}
    pulse = Pulse("constant", speed, 3.3e-6 if solid else 0.0)
    one = strip_1d(n, material, stop, Boundary("velocity", pulse), Boundary("fixed"), steps, **state)
    shape = dict(width=0.375, height=1.0, material=material.name, **state)
    driven = Boundary2D(("b.bottom",), "velocity", pulse, direction=(0.0, 1.0))
    given = problem(box(3, n, **shape), material, stop, (driven, *walls("b.top", "b.right"), *(walls("b.left") if geometry == "plane" else ())),
                    geometry, viscosity=Viscosity2D(heat_flux=0.0), **steps)
    solver = ran(given)
    assert solver.cycle == one.cycle
    state = one.state()
    for name, row in (("density", Z.rho), ("energy", Z.e), ("pressure", Z.p)):
        field = solver.zones[row].reshape(3, n)
        assert np.allclose(field, state.zones[name], rtol=0, atol=1e-10 * np.abs(state.zones[name]).max())
    if kind == "solid":
        assert np.allclose(solver.zones[Z.syy].reshape(3, n), state.zones["deviator_radial"], rtol=0, atol=2e-10 * 0.2e9)


def moving(material, **options):
    """A block that shears, yields, is driven on one side and has free ones."""
    solid = material.strength is not None
    speed = 400.0 if solid else 1.0
    state = {} if solid else {"density": 1.0, "pressure": 0.4}
    block = twisted(material.name, (8, 7), velocity=VelocityField(base=(0.1 * speed, 0.2 * speed), gradient=((0.0, speed), (-0.5 * speed, 0.0))),
                    **state)
    stop = 1.2e-4 if solid else 0.1
    sides = (Boundary2D(("b.bottom",), "velocity", Pulse("half_sine", speed, 0.0, stop)), Boundary2D(("b.top",), "pressure",
             Pulse("constant", 1e9 if solid else 0.5)), Boundary2D(("b.left",), "wall" if options.get("geometry", "plane") == "plane" else "axis"))
    return problem(block, material, stop, sides, **options)


EDGE, HERRMANN = Viscosity2D("edge"), Viscosity2D("herrmann", limited=False)


@pytest.mark.parametrize("geometry, scheme", SCHEMES)
@pytest.mark.parametrize("kind", ["gas", "solid", "spall", "edge", "herrmann"])
def test_energy_and_momentum_are_kept(geometry, scheme, kind):
    """To round-off in every geometry, with each viscosity, filters, strength and failure; the area-weighted scheme keeps no axial momentum."""
    material = {"gas": gas(), "spall": aluminium(fracture=SpallStress(0.5e9))}.get(kind) or aluminium()
    viscosity = {"edge": EDGE, "herrmann": HERRMANN}.get(kind, Viscosity2D())
    solver = ran(moving(material, geometry=geometry, scheme=scheme, viscosity=viscosity))
    errors = solver.errors()
    assert solver.cycle > 10
    assert errors["energy_error"] < 1e-12
    assert errors["mass_error"] == 0.0
    if scheme == "true_volume":
        assert errors["momentum_error"] < 1e-12
    if kind == "spall":
        assert solver.capped > 0


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("solid", [False, True])
def test_mirror_image(solid, shape):
    """The mirrored problem gives the mirrored run, with the numbering of the zones reversed: round-off decides nothing.

    Crossed diagonals of an even number of cells are their own mirror image.
    """
    material, speed = (aluminium(), 300.0) if solid else (gas(), 1.0)
    state = {} if solid else {"density": 1.0, "pressure": 0.1}
    ways = []
    for sign in (1.0, -1.0):
        velocity = VelocityField(base=(0.3 * sign * speed, 0.1 * speed), gradient=((0.0, sign * 0.4 * speed), (0.0, 0.0)))
        block = box(12, 8, origin=(-0.5, 0.0), material=material.name, velocity=velocity, **state)
        ways.append(ran(problem(block, material, 3e-4 if solid else 0.3, walls("b.left", "b.right", "b.bottom"), **SHAPES[shape])))
    for row in (Z.rho, Z.e):
        one, other = (way.zones[row].reshape(12, -1) for way in ways)
        assert np.abs(one - other[::-1]).max() < 1e-12 * np.abs(one).max()
    assert ways[0].cycle == ways[1].cycle


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("kind", ["tensor", "edge"])
@pytest.mark.parametrize("solid", [False, True])
def test_a_moving_and_a_turned_frame_change_nothing(solid, kind, shape):
    """Galilean shift and a frame turned by 37 degrees: the same densities and energies, free boundaries and a pressure."""
    material = aluminium() if solid else gas()
    speed, stop = (300.0, 8e-5) if solid else (1.0, 0.2)
    state = {} if solid else {"density": 1.0, "pressure": 0.5}
    found = []
    for base, turn in (((0.0, 0.0), 0.0), ((7.0 * speed, -3.0 * speed), 0.0), ((0.0, 0.0), np.radians(37.0))):
        c, s = np.cos(turn), np.sin(turn)
        rotation = np.array([[c, -s], [s, c]])
        gradient = rotation @ np.array([[-1.0, 0.5], [0.2, -0.4]]) @ rotation.T * speed
        velocity = VelocityField(base=base, gradient=tuple(map(tuple, gradient)))
        block = twisted(material.name, turn=turn, velocity=velocity, **state)
        pressure = Boundary2D(("b.top",), "pressure", Pulse("constant", 2e9 if solid else 0.8))
        found.append(ran(problem(block, material, stop, (pressure,), initial_step=stop / 400, largest_step=stop / 300,
                                 viscosity=Viscosity2D(kind), **SHAPES[shape])))
    scale = found[0].zones[Z.e].max()
    for other in found[1:]:
        assert np.allclose(other.zones[Z.rho], found[0].zones[Z.rho], rtol=1e-9)
        assert np.allclose(other.zones[Z.e], found[0].zones[Z.e], rtol=0, atol=1e-8 * scale)


@pytest.mark.parametrize("cut", ["left and right", "below and above"])
@pytest.mark.parametrize("limited", [True, False])
def test_blocks_that_share_nodes_are_one_block(cut, limited):
    """Two blocks that meet: the run of the undivided block; the limiter looks across."""
    options = dict(viscosity=Viscosity2D("tensor", limited))
    velocity = VelocityField(gradient=((-1.0, 0.3), (0.0, -0.2)), radial=-0.4)
    state = dict(density=1.0, pressure=0.3, velocity=velocity)
    whole = ran(problem(box(8, 6, **state), gas(), 0.2, walls("b.left", "b.bottom"), **options))
    across = cut == "left and right"
    size, zones = ((0.5, 1.0), (4, 6)) if across else ((1.0, 0.5), (8, 3))
    halves = [box(*zones, *size, (0.5 * k * across, 0.5 * k * (not across)), name, **state) for k, name in enumerate("lr")]
    sides = walls("l.left", "l.bottom", *(("r.bottom",) if across else ("r.left",)))
    parts = ran(problem(halves, gas(), 0.2, sides, **options))
    field = parts.zones[Z.rho].reshape(2, *zones)
    assert np.allclose(np.concatenate(field, axis=0 if across else 1), whole.zones[Z.rho].reshape(8, 6), rtol=1e-12)
    assert parts.errors()["energy_error"] < 1e-13


@pytest.mark.parametrize("geometry", ["plane", "axisymmetric"])
def test_the_heat_flux_cools_the_wall_and_keeps_the_energy(geometry):
    """A gas against a wall: the first zone comes nearer to the density behind the shock, 4, and nothing of the energy is lost."""
    first = []
    for coefficient in (0.0, 1.0):
        block = box(3, 40, 0.1, 1.0, density=1.0, energy=1e-6, velocity=VelocityField(base=(0.0, -1.0)))
        sides = walls("b.bottom", "b.right", *(("b.left",) if geometry == "plane" else ()))
        solver = ran(problem(block, gas(), 1.0, sides, geometry, viscosity=Viscosity2D(heat_flux=coefficient)))
        assert solver.errors()["energy_error"] < 1e-13
        first.append(solver.zones[Z.rho].reshape(3, 40)[:, 0].mean())
    assert first[0] < 3.4 and first[1] > first[0] + 0.15


def test_herrmanns_viscosity_knows_the_axes_of_the_frame():
    """A pure shear rate at 45 degrees is resisted twice as much as along the axes: the quadratic terms of B.20; it has no limiter."""
    works = []
    for gradient in (((-1.0, 0.0), (0.0, 1.0)), ((0.0, 1.0), (1.0, 0.0))):
        block = box(4, 4, density=1.0, pressure=1e-6, velocity=VelocityField(gradient=gradient))
        quadratic = Viscosity2D("herrmann", limited=False, linear=0.0)
        works.append(ran(problem(block, gas(), 1e-3, viscosity=quadratic, initial_step=1e-3, largest_step=1e-3)))
    axes, diagonal = (np.sum(work.zones[Z.mass] * work.zones[Z.viscous_work]) for work in works)
    assert axes > 0.0 and diagonal / axes == pytest.approx(2.0, rel=0.01)
    with pytest.raises(OutOfRange, match="no limiter"):
        Lagrange2D(problem(box(2, 2, density=1.0, pressure=1.0), gas(), 1.0, viscosity=Viscosity2D("herrmann")))
    with pytest.raises(OutOfRange, match="'tensor' or 'edge' or 'herrmann'"):
        Lagrange2D(problem(box(2, 2, density=1.0, pressure=1.0), gas(), 1.0, viscosity=Viscosity2D("kb")))


def test_the_edge_viscosity_keeps_a_polar_mesh_round():
    """Noh's implosion on equal angles, in the plane and about the axis: rings stay rings."""
    for geometry, plateau in (("plane", 16.0), ("axisymmetric", 64.0)):
        block = Block2D("b", "gas", Sector((0.0, 0.0), (0.005, 1.0), (0.0, 0.5 * np.pi)), (40, 9), density=1.0, pressure=1e-10,
                        velocity=VelocityField(radial=-1.0))
        hole = Boundary2D(("b.left",), "velocity", Pulse("constant", 0.0), slip=False)
        sides = walls("b.bottom", "b.top") if geometry == "plane" else walls("b.bottom")
        solver = ran(problem(block, gas(), 0.6, (hole, *sides), geometry, scheme="area_weighted", viscosity=EDGE))
        radius = np.hypot(solver.nodes[N.x], solver.nodes[N.y]).reshape(41, 10)
        assert np.ptp(radius, axis=1).max() < 1e-10
        assert 0.8 * plateau < solver.zones[Z.rho].max() < 1.05 * plateau


def test_a_step_that_would_turn_a_zone_inside_out_is_repeated_smaller():
    """A first step far too long is halved until the mesh survives it, and energy is kept."""
    block = box(4, 4, density=1.0, pressure=0.1, velocity=VelocityField(gradient=((-1.0, 0.0), (0.0, -1.0))))
    given = dataclasses.replace(problem(block, gas(), 0.3, initial_step=3.0, courant=1e3), stop_time=10.0)
    solver = Lagrange2D(given)
    solver.march(10.0, 1)
    assert solver.results()["steps_repeated"] > 0
    assert solver.zones[Z.rho].min() > 0.0
    assert solver.errors()["energy_error"] < 1e-12


def test_a_closed_ring_in_balance_keeps_its_momentum_to_round_off():
    """Gas at 1 Pa between pressures of 1 Pa: impulses cancel along a closed side, and round-off was measured by round-off, 0.08 of it."""
    ring = Block2D("ring", "gas", Sector((0.0, 0.0), (0.5, 1.0), (0.0, 2.0 * np.pi)), (6, 24), density=1.0, pressure=1.0)
    loads = [Boundary2D((f"ring.{side}",), "pressure", Pulse("constant", 1.0)) for side in ("left", "right")]
    solver = ran(problem(ring, gas(), 0.5, loads))
    assert solver.cycle > 10 and solver.errors()["momentum_error"] < 1e-13


@pytest.mark.parametrize("geometry, rings, exact", [("plane", 24, 16.0), ("axisymmetric", 40, 64.0)])
def test_a_polar_mesh_keeps_its_symmetry(geometry, rings, exact):
    """Noh's implosion on equal angles: rings stay rings, to round-off, in the plane and area weighted with the axis."""
    block = Block2D("b", "gas", Sector((0.0, 0.0), (0.005, 1.0), (0.0, 0.5 * np.pi)), (rings, 9), density=1.0, pressure=1e-10,
                    velocity=VelocityField(radial=-1.0))
    hole = Boundary2D(("b.left",), "velocity", Pulse("constant", 0.0), slip=False)
    sides = walls("b.bottom", "b.top") if geometry == "plane" else walls("b.bottom")
    solver = ran(problem(block, gas(), 0.6, (hole, *sides), geometry, scheme="area_weighted"))
    radius = np.hypot(solver.nodes[N.x], solver.nodes[N.y]).reshape(rings + 1, 10)
    assert np.ptp(radius, axis=1).max() < 1e-12
    assert 0.5 * exact < solver.zones[Z.rho].max() < exact
    assert solver.errors()["energy_error"] < 1e-12
