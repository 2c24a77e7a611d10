"""Further problems of the field in two dimensions: imploding shells, Kidder's compression, Gresho's vortex, the triple point, plates' edges."""

import dataclasses
import sys
from pathlib import Path

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).parents[1] / "unit" / "solvers2d"))
from plane_builders import Boundary2D, Pulse, Viscosity2D, box, centres, gas, problem, ran, walls

from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.laws.strength.perfectly_plastic import PerfectlyPlastic
from hugoniot.materials.material import Material
from hugoniot.mesh.shapes import Sector
from hugoniot.problem.forming import forming
from hugoniot.problem.plane.model import Block2D, VelocityField
from hugoniot.solvers.lagrange2d.assemble import N, Z
from hugoniot.solvers.lagrange2d.solver import Lagrange2D
from hugoniot.theory.exact.kidder import kidder
from hugoniot.theory.exact.shell_stopping import howell_ball, verney

BERYLLIUM = Material("be", MieGruneisen(1845.0, 7998.0, 1.124, 1.11), PerfectlyPlastic(151e9, 330e6))


def radii(solver, shape):
    return np.hypot(solver.nodes[N.x], solver.nodes[N.y]).reshape(shape[0] + 1, shape[1] + 1)


def shell(zones, speed, power, geometry, stop):
    """A quarter of a beryllium shell of 8 to 10 cm that falls inward as if it were incompressible."""
    block = Block2D("s", "be", Sector((0.0, 0.0), (0.08, 0.10), (0.0, 0.5 * np.pi)), zones,
                    velocity=VelocityField(radial=-speed, radius=0.08, power=power))
    sides = walls("s.bottom", "s.top") if geometry == "plane" else walls("s.bottom")
    return problem(block, BERYLLIUM, stop, sides, geometry, scheme="area_weighted", viscosity=Viscosity2D())


@pytest.mark.parametrize("geometry, exact, power, band", [("plane", howell_ball, -1.0, 0.01), ("axisymmetric", verney, -2.0, 0.12)])
def test_an_imploding_shell_stops_where_its_strength_has_taken_the_energy(geometry, exact, power, band):
    """Howell and Ball's ring and Verney's sphere with 8 zones: the rigid-plastic radius, nearer with finer zones; round, energy kept."""
    zones, answer = (8, 8), exact().numbers
    speed = 417.1 if geometry == "plane" else 675.036
    solver = ran(shell(zones, speed, power, geometry, 1.02 * answer["stop_time"]))
    inside = radii(solver, zones)[0]
    assert inside.mean() == pytest.approx(answer["stop_radius"], rel=band)
    assert np.ptp(inside) < 0.003 * inside.mean()
    assert solver.errors()["energy_error"] < 1e-12


def kidder_ring(n, angles, part):
    """(problem, exact solution) of Kidder's ring under the pressures of its exact solution, up to a part of its collapse time."""
    exact = kidder()
    stop, faces = part * exact.numbers["tau"], np.linspace(0.9, 1.0, n + 1)
    start = exact.profile(0.5 * (faces[1:] + faces[:-1]), 0.0)
    blocks = [Block2D(f"r{k}", "gas", Sector((0.0, 0.0), (faces[k], faces[k + 1]), (0.0, 0.5 * np.pi)), (1, angles),
                      density=float(start["density"][k]), pressure=float(start["pressure"][k])) for k in range(n)]
    times = np.linspace(0.0, stop, 2000)
    growth = (1.0 - (times / exact.numbers["tau"]) ** 2) ** -2.0       # of pressures where gamma is 2
    loads = [Boundary2D((chain,), "pressure", Pulse("table", times=tuple(times), values=tuple(edge * growth)))
             for chain, edge in (("r0.left", 0.1), (f"r{n - 1}.right", 10.0))]
    sides = walls(*(f"{block.name}.{side}" for block in blocks for side in ("bottom", "top")))
    return problem(blocks, gas(2.0), stop, (*loads, *sides), viscosity=Viscosity2D()), exact


def test_kidders_ring_is_compressed_without_a_shock():
    """20 zones, to 0.8 of the collapse: radii within 1e-3, the ring round to round-off, and hardly any viscous work."""
    given, exact = kidder_ring(20, 24, 0.8)
    solver = ran(given)
    radius = np.hypot(solver.nodes[N.x], solver.nodes[N.y]).reshape(20, 2, 25)
    scale = np.sqrt(1.0 - 0.8**2)
    assert radius[0, 0].mean() == pytest.approx(0.9 * scale, rel=2e-3) and radius[-1, 1].mean() == pytest.approx(scale, rel=1e-3)
    assert np.ptp(radius, axis=2).max() < 1e-11
    work = np.sum(solver.zones[Z.mass] * solver.zones[Z.viscous_work])
    assert abs(work) < 1e-3 * np.sum(solver.zones[Z.mass] * solver.zones[Z.e])


def gresho(n, stop):
    """Gresho's vortex in the unit square, gamma 5/3."""
    given = problem(box(n, n, 1.0, 1.0, (-0.5, -0.5), density=1.0, pressure=5.0), gas(), stop,
                    walls("b.left", "b.right", "b.bottom", "b.top"), viscosity=Viscosity2D())
    solver = Lagrange2D(given)
    x, y = solver.nodes[N.x], solver.nodes[N.y]
    r = np.hypot(x, y)
    spin = np.where(r < 0.2, 5.0, np.where(r < 0.4, 2.0 / np.where(r > 0.0, r, 1.0) - 5.0, 0.0))
    solver.nodes[N.u], solver.nodes[N.v] = -spin * y, spin * x
    r = np.hypot(*centres(solver))
    pressure = np.where(r < 0.2, 5.0 + 12.5 * r**2, np.where(r < 0.4, 9.0 - 4.0 * np.log(0.2) + 12.5 * r**2 - 20.0 * r + 4.0 * np.log(r),
                                                             3.0 + 4.0 * np.log(2.0)))
    solver.zones[Z.p], solver.zones[Z.e] = pressure, pressure / (2.0 / 3.0)
    solver.zones[Z.c] = np.sqrt(5.0 / 3.0 * pressure)
    return solver


def test_a_vortex_keeps_its_speed_and_energy():
    """Gresho: pressure holds the rotation. After half a radian the peak, a kink of the profile, has lost 9 % on 40 zones, 8 % of it
    without any viscosity; the motion has lost less than 2 % of its energy."""
    solver = gresho(40, 0.1)
    before = solver.kinetic_energy()
    solver.begin()
    while solver.time < 0.1:
        solver.march(0.1, 1000)
    assert np.hypot(solver.nodes[N.u], solver.nodes[N.v]).max() > 0.90
    assert 0.98 * before < solver.kinetic_energy() < before


def triple(n, stop):
    """The triple point, n zones to the unit length: four blocks of two gases."""
    states = {"a": dict(density=1.0, pressure=1.0), "b": dict(density=1.0, pressure=1.0), "c": dict(density=1.0, pressure=0.1),
              "d": dict(density=0.125, pressure=0.1)}
    half = 3 * n // 2
    blocks = [box(n, half, 1.0, 1.5, (0.0, 0.0), "a", "light", **states["a"]), box(n, half, 1.0, 1.5, (0.0, 1.5), "b", "light", **states["b"]),
              box(6 * n, half, 6.0, 1.5, (1.0, 0.0), "c", "heavy", **states["c"]),
              box(6 * n, half, 6.0, 1.5, (1.0, 1.5), "d", "light", **states["d"])]
    gases = [Material("light", IdealGas(1.5, 1.0, 1.0)), Material("heavy", IdealGas(1.4, 1.0, 1.0))]
    outside = walls("a.left", "b.left", "a.bottom", "c.bottom", "b.top", "d.top", "c.right", "d.right")
    return problem(blocks, gases, stop, outside, viscosity=Viscosity2D())


def test_the_triple_point_lives_and_keeps_its_energy():
    """Shear rolls the interface up: alive at t = 3 with 8 zones to the unit length, energy and momentum in the walls kept."""
    solver = ran(triple(8, 3.0))
    assert solver.errors()["energy_error"] < 1e-12 and solver.errors()["momentum_error"] < 1e-12
    assert solver.zones[Z.rho].min() > 0.05


def flyer(columns, rows, radius, geometry="axisymmetric"):
    al = Material("al", MieGruneisen(2700.0, 5200.0, 1.5, 2.0), PerfectlyPlastic(24.8e9, 0.30e9))
    blocks = [box(columns, rows, radius, 3e-3, (0.0, 0.0), "flyer", "al", velocity=VelocityField(base=(0.0, 700.0))),
              box(columns, 2 * rows, radius, 6e-3, (0.0, 3e-3), "target", "al")]
    edges = () if geometry == "axisymmetric" else walls("flyer.left", "flyer.right", "target.left", "target.right")
    return problem(blocks, al, 1.0e-6, edges, geometry, viscosity=Viscosity2D(), initial_step=4e-9, largest_step=4e-9)


@pytest.mark.parametrize("speed", [200.0, 700.0, 2000.0, 5000.0])
def test_a_shock_in_a_solid_keeps_to_its_plateau(speed):
    """Two plates of aluminium with 60 zones in the flyer, the default viscosity: with that of plastic flow it was 3, 10 and 25 % above."""
    plates = flyer(1, 60, 3e-3 / 60, "plane")
    blocks = (dataclasses.replace(plates.blocks[0], velocity=VelocityField(base=(0.0, speed))), plates.blocks[1])
    steps = dataclasses.replace(plates.solver, initial_step=1e-11, largest_step=None)
    plates = dataclasses.replace(plates, blocks=blocks, solver=steps)
    solver, highest = Lagrange2D(plates), 0.0
    while solver.time < 0.35e-6:
        solver.march(0.35e-6, 10)
        highest = max(highest, solver.zones[Z.sigma].max()) if solver.time > 0.2e-6 else 0.0
    plateau, peaks = solver.zones[Z.sigma, 62:72].mean(), solver.peaks()["peak_stress"]
    assert highest < 1.01 * plateau
    assert peaks.max() > 1.03 * plateau and peaks[~forming(plates)].max() < 1.01 * plateau      # where it started, and elsewhere


def test_the_centre_of_a_plate_knows_nothing_of_its_edge_at_first():
    """3 mm on 6 mm of aluminium, radius 10 mm: until the release from the edge arrives the axis is that of a plate without edges to 0.3 %,
    in steps of the same length."""
    disc, plate = ran(flyer(20, 12, 10e-3)), ran(flyer(1, 12, 10e-3, "plane"))
    target, strip = disc.zones[Z.p, 20 * 12:].reshape(20, 24), plate.zones[Z.p, 12:]
    assert np.allclose(target[0], strip, rtol=0, atol=3e-3 * strip.max())
    assert target[-1].max() < 0.9 * strip.max()


LIQUID = MieGruneisen(8930.0, 3940.0, 1.489, 1.99)
PLASTIC = MieGruneisen(1186.0, 2600.0, 1.52, 1.0)


@pytest.mark.parametrize("law, strength, speed, cells", [
    (LIQUID, None, 1000.0, "quads"), (LIQUID, None, 1000.0, "triangles"), (LIQUID, PerfectlyPlastic(47e9, 0.12e9), 9000.0, "quads"),
    (PLASTIC, None, 5000.0, "quads"), (PLASTIC, PerfectlyPlastic(2.3e9, 0.4e9), 5000.0, "quads"),
    (PLASTIC, PerfectlyPlastic(2.3e9, 0.4e9), 5000.0, "triangles")])
def test_a_shock_in_condensed_matter_does_not_overshoot(law, strength, speed, cells):
    """Symmetric impact, half of it on a wall: behind the first ten zones no zone exceeds the pressure of the jump conditions by 0.6 %, nor
    does a node rebound with more than 0.4 % of its velocity. Strength takes up to 1 % off this pressure here."""
    count, length, half = 60, 5e-3, 0.5 * speed
    shock = law.c0 + law.s * half
    given = problem(box(1, count, length / count, length, material="m", velocity=VelocityField(base=(0.0, -half))),
                    Material("m", law, strength), 0.7 * length / shock, walls("b.bottom", "b.left", "b.right"), viscosity=Viscosity2D(),
                    cells=cells)
    solver, peak, rebound = Lagrange2D(given), 0.0, 0.0
    while solver.time < given.stop_time:
        solver.march(given.stop_time, 1)
        peak = max(peak, solver.zones[Z.p].reshape(-1, count)[:, 10:].max())
        rebound = max(rebound, solver.nodes[N.v].reshape(2, -1)[:, 10:].max())
    level = law.rho0 * shock * half
    assert 0.99 * level < peak < 1.006 * level
    assert rebound < 0.004 * half
