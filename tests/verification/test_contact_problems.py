"""Bodies that meet, against answers that do not come from a mesh, or come from runs without contact."""


import math

import numpy as np
import pytest
from contact_builders import Boundary2D, Contact2D, MieGruneisen, N, Rigid2D, al, mean_velocity, meeting, ran, strip
from plane_builders import box

from hugoniot.laws.strength.linear_hardening import LinearHardening
from hugoniot.materials.material import Material
from hugoniot.mesh.shapes import Curve, Edges
from hugoniot.problem.deck import read_deck_text
from hugoniot.problem.plane.model import Block2D, VelocityField, Viscosity2D
from hugoniot.simulate import make_solver
from hugoniot.solvers.lagrange2d.solver import Lagrange2D

pytestmark = pytest.mark.slow

ALUMINIUM = """
[material.al.eos]
law = "mie_gruneisen"
rho0 = "2700 kg/m^3"
c0 = "5200 m/s"
s = 1.5
gamma0 = 2.0
[material.al.strength]
law = "perfectly_plastic"
shear_modulus = "24.8 GPa"
yield_stress = "0.30 GPa"
"""
LINE = """
geometry = "planar"
stop_time = "4 us"
[[region]]
name = "target"
material = "al"
from = "-4 mm"
to = "0 mm"
zones = 80
[[region]]
name = "flyer"
material = "al"
from = "1 mm"
to = "3 mm"
zones = 40
velocity = "-700 m/s"
""" + ALUMINIUM
AS_IN_A_LINE = Viscosity2D("tensor", True, 0.3, 2.0 / 3.0, 0.3, 2.0 / 3.0)


@pytest.mark.parametrize("across", [3, 5])
def test_a_flyer_over_a_gap_equals_the_run_in_one_dimension(across):
    """Pressure in the middle of the target and both free surfaces on their plateaus, matched nodes and five against three."""
    line = make_solver(read_deck_text(LINE, "line.toml").problem)
    plane = Lagrange2D(strip(3, across, along=40, viscosity=AS_IN_A_LINE, courant=0.5))
    target, flyer = plane.problem.mesh.blocks
    pressures, surfaces = [], []
    for time in 1e-3 / 700.0 + np.array([0.4, 0.5, 0.6, 0.65, 1.2, 1.3]) * 1e-6:
        while line.time < time:      # it comes back where the gap closes
            line.march(time, 10**6)
        plane.march(time, 10**6)
        one, two = line.state(), plane.state()
        pressures.append((two.zones["pressure"][40], one.zones["pressure"][40]))
        for node, value in ((target.nodes[1, 0], one.velocity_left[0]), (flyer.nodes[1, -1], one.velocity_right[-1])):
            surfaces.append((two.nodes["velocity_y"][node], value))
    assert np.abs(np.diff(pressures)).max() < 0.002 * 5.31e9
    assert np.abs(np.diff(surfaces)).max() < 0.002 * 700.0
    assert plane.errors()["momentum_y_error"] < 1e-12
    assert plane.results()["contact_depth"] < 1e-3


CHARGE = """
stop_time = "8 us"
[[block]]
name = "charge"
material = "comp_b"
x = ["0 mm", "1 mm"]
y = ["0 mm", "20 mm"]
zones = [2, 120]
[[block]]
name = "plate"
material = "copper"
x = ["0 mm", "1 mm"]
y = ["20 mm", "23 mm"]
zones = [{across}, 20]
[[boundary]]
on = ["charge.left", "charge.right", "plate.left", "plate.right", "charge.bottom"]
kind = "wall"
[[lighting]]
at = ["0 mm", "0 mm"]
to = ["1 mm", "0 mm"]
[solver]
kind = "lagrange2d"
"""


def test_a_charge_drives_a_plate_that_is_not_glued_to_it():
    """As it drives one of common nodes, with the same nodes and three against two."""
    cut = '[[contact]]\nbetween = ["charge", "plate"]\n'
    speeds = []
    for across, extra in ((2, ""), (2, cut), (3, cut)):
        solver = ran(read_deck_text(CHARGE.format(across=across) + extra, "charge.toml").problem)
        speeds.append(mean_velocity(solver, 1)[1])
        assert solver.errors()["energy_error"] < 1e-10
    assert speeds[0] > 500.0
    assert speeds[1] == pytest.approx(speeds[0], rel=5e-3)
    assert speeds[2] == pytest.approx(speeds[0], rel=5e-3)


COPPER = Material("cu", MieGruneisen(8930.0, 3940.0, 1.49, 2.0), LinearHardening(43.3e9, 0.4e9, 0.1e9, 0.7e9))


def rod(name, start, speed, radius=3.2e-3, length=32.4e-3, zones=(5, 50)):
    return box(*zones, radius, length, (0.0, start), name, "cu", velocity=VelocityField(base=(0.0, speed)))


def test_two_equal_rods_are_each_a_taylor_bar_at_half_the_speed():
    """A rod at 454 m/s on its like at rest: what either is in the end, a rod at 227 m/s on a rigid body is too.

    A boundary of kind wall does not let the rim of the foot lift off, as a body does.
    """
    stop, floor = 60e-6, Rigid2D("floor", ((0.0, 0.0), (12e-3, 0.0)))
    wall = ran(meeting([rod("bar", 0.0, -227.0)], stop, (), "axisymmetric", rigid=(floor,), material=COPPER))
    pair = ran(meeting([rod("anvil", -32.4e-3, 0.0), rod("bar", 0.0, -454.0)], stop, (), "axisymmetric",
                       contacts=(Contact2D(("anvil", "bar")),), material=COPPER))

    def measured(solver, block):
        part = slice(solver.numbering.first[block], solver.numbering.first[block + 1])
        return np.ptp(solver.nodes[N.y, part]), solver.nodes[N.x, part].max()

    reference = measured(wall, 0)
    for block in (0, 1):
        length, foot = measured(pair, block)
        assert length == pytest.approx(reference[0], rel=1e-3)
        assert foot == pytest.approx(reference[1], rel=1e-3)
    errors = pair.errors()
    assert errors["momentum_y_error"] < 1e-12
    assert errors["energy_error"] < 1e-10
    assert pair.results()["contact_depth"] < 1e-3


def sphere(n, radius, centre, speed):
    """A sphere of four arcs about the axis."""
    q, e = radius * math.sqrt(0.5), radius * math.sin(math.pi / 8)
    f = radius * math.cos(math.pi / 8)
    shape = Edges(Curve("line", ((0.0, centre - radius), (0.0, centre + radius))), Curve("arc", ((q, centre - q), (radius, centre), (q, centre + q))),
                  Curve("arc", ((0.0, centre - radius), (e, centre - f), (q, centre - q))),
                  Curve("arc", ((0.0, centre + radius), (e, centre + f), (q, centre + q))), "winslow")
    return Block2D("ball", "al", shape, (n, 2 * n), velocity=VelocityField(base=(0.0, speed)))


def test_a_sphere_rebounds_from_a_plate():
    """Aluminium at 200 m/s: it comes to rest, leaves with a part of its speed, and nothing is lost."""
    plate = al(16, 8, 16e-3, 6e-3, (0.0, -6e-3), "plate")
    solver = Lagrange2D(meeting([plate, sphere(8, 4e-3, 4.05e-3, -200.0)], 40e-6, (Boundary2D(("plate.bottom",), "wall"),), "axisymmetric"))
    speeds = []
    for time in np.arange(1, 7) * 5e-6:
        solver.march(time, 10**6)
        speeds.append(mean_velocity(solver, 1)[1])
    assert np.diff(speeds).min() > -1e-6
    assert 10.0 < speeds[-1] < 80.0
    assert speeds[-1] == pytest.approx(speeds[-2], rel=1e-9)
    assert solver.errors()["energy_error"] < 1e-12
    assert solver.results()["contact_depth"] < 1e-3
