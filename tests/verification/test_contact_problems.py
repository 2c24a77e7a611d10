"""Bodies that meet, against answers that do not come from a mesh, or come from runs without contact."""

import dataclasses
import math

import numpy as np
import pytest
from contact_builders import Boundary2D, Contact2D, MieGruneisen, N, Rigid2D, al, bars, mean_velocity, meeting, ran, rebound, sphere, strip
from plane_builders import aluminium, box

from hugoniot.laws.strength.linear_hardening import LinearHardening
from hugoniot.laws.strength.perfectly_plastic import PerfectlyPlastic
from hugoniot.materials.material import Material
from hugoniot.problem.deck import read_deck_text
from hugoniot.problem.plane.model import Erosion2D, VelocityField, Viscosity2D
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
[solver]
courant = 0.5
""" + ALUMINIUM


@pytest.mark.parametrize("below, above", [(3, 3), (3, 5), (10, 17)])
def test_a_flyer_over_a_gap_equals_the_run_in_one_dimension(below, above):
    """Pressure in the middle of the target and both free surfaces on their plateaus: matched nodes, and 1.7 to 1, in every column."""
    line = make_solver(read_deck_text(LINE, "line.toml").problem)
    plane = Lagrange2D(strip(below, above, along=40, viscosity=Viscosity2D(), courant=0.5))
    target, flyer = plane.problem.mesh.blocks
    pressures, surfaces = [], []
    for time in 1e-3 / 700.0 + np.array([0.4, 0.5, 0.6, 0.65, 1.2, 1.3]) * 1e-6:
        while line.time < time:      # it comes back where the gap closes
            line.march(time, 10**6)
        plane.march(time, 10**6)
        one, two = line.state(), plane.state()
        pressures.append(np.abs(two.zones["pressure"][40:80 * below:80] - one.zones["pressure"][40]).max())
        for nodes, value in ((target.nodes[:, 0], one.velocity_left[0]), (flyer.nodes[:, -1], one.velocity_right[-1])):
            surfaces.append(np.abs(two.nodes["velocity_y"][nodes] - value).max())
    assert max(pressures) < 0.002 * 5.31e9
    assert max(surfaces) < 0.002 * 700.0
    assert plane.errors()["momentum_y_error"] < 1e-12
    assert plane.results()["contact_depth"] < 1e-3


def test_two_bars_of_a_hundred_zones_rebound():
    """They exchange their velocities after the time 2 L / c, within 2 %."""
    assert rebound(bars(100)) == pytest.approx((1.0, 1.0), rel=0.02)


CHARGE = """
geometry = "{geometry}"
stop_time = "8 us"
[[boundary]]
on = [{walls}]
kind = "wall"
[[lighting]]
at = ["0 mm", "0 mm"]
to = {lit_to}
[solver]
kind = "lagrange2d"
"""


def charge(block, driven, zones, **words):
    """A deck of Comp B and copper beside it: places (x, y) in mm and zones of both."""
    r, z = ("r", "z") if words["geometry"] == "axisymmetric" else ("x", "y")
    rows = [f'[[block]]\nname = "{name}"\nmaterial = "{material}"\n{r} = {list(x)}\n{z} = {list(y)}\nzones = {list(n)}\n'.replace("'", '"')
            for (name, (x, y)), material, n in zip((block, driven), ("comp_b", "copper"), zones)]
    return CHARGE.format(**words) + "".join(rows)


FLYER = (("charge", (("0 mm", "1 mm"), ("0 mm", "20 mm"))), ("plate", (("0 mm", "1 mm"), ("20 mm", "23 mm"))))
LINER = (("charge", (("0 mm", "10 mm"), ("0 mm", "1 mm"))), ("liner", (("10 mm", "12 mm"), ("0 mm", "1 mm"))))


@pytest.mark.parametrize("bodies, zones, axis, words", [
    (FLYER, lambda across: ((2, 120), (across, 20)), 1, {"geometry": "plane", "lit_to": '["1 mm", "0 mm"]', "walls":
                                                         '"charge.left", "charge.right", "plate.left", "plate.right", "charge.bottom"'}),
    (LINER, lambda along: ((60, 2), (16, along)), 0, {"geometry": "axisymmetric", "lit_to": '["0 mm", "1 mm"]', "walls":
                                                      '"charge.bottom", "charge.top", "liner.bottom", "liner.top"'})],
    ids=["flyer", "liner"])
def test_a_charge_drives_what_is_not_glued_to_it(bodies, zones, axis, words):
    """A plate, and a ring about a charge lit along its axis: as it drives one of common nodes, with the same nodes and three against two."""
    cut = f'[[contact]]\nbetween = ["charge", "{bodies[1][0]}"]\n'
    speeds = []
    for count, extra in ((2, ""), (2, cut), (3, cut)):
        solver = ran(read_deck_text(charge(*bodies, zones(count), **words) + extra, "charge.toml").problem)
        speeds.append(mean_velocity(solver, 1)[axis])
        assert solver.errors()["energy_error"] < 1e-10
    assert speeds[0] > 500.0
    assert speeds[1:] == pytest.approx([speeds[0]] * 2, rel=5e-3)


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


HARD = Material("hard", MieGruneisen(100.0 * 8930.0, 3940.0, 1.49, 2.0), LinearHardening(100.0 * 43.3e9, 1e15, 0.0, 1e15))


def on_anvil(material, zones, speed=-227.0, stop=60e-6):
    """Length and foot (m) of a Taylor bar on an anvil four times as broad and as long as itself, whose zones are not those of the bar."""
    width = 4.0 * 3.2e-3
    anvil = dataclasses.replace(box(*zones, width, 32.4e-3, (0.0, -32.4e-3), "anvil", material), ratio=(1.0, 1.0))
    solver = ran(meeting([anvil, rod("bar", 0.0, speed)], stop, (), "axisymmetric", contacts=(Contact2D(("anvil", "bar")),),
                         material=[COPPER, HARD]))
    bar = slice(solver.numbering.first[1], solver.numbering.first[2])
    errors = solver.errors()
    assert errors["momentum_y_error"] < 1e-12 and errors["energy_error"] < 1e-10
    assert solver.results()["contact_depth"] < 1e-3
    return np.ptp(solver.nodes[N.y, bar]), solver.nodes[N.x, bar].max()


def test_a_taylor_bar_on_a_deformable_anvil_broader_than_itself():
    """On a hundredfold denser and stiffer anvil it ends as on a rigid floor. On one of its own metal its length is between that and the
    length of one that strikes its like, which is that at half the speed; and twice as fine an anvil changes little."""
    floor = Rigid2D("floor", ((0.0, 0.0), (12e-3, 0.0)))
    fast, slow = (ran(meeting([rod("bar", 0.0, -speed)], 60e-6, (), "axisymmetric", rigid=(floor,), material=COPPER)) for speed in (227.0, 113.5))
    longest, shortest = (np.ptp(s.nodes[N.y, :s.numbering.total]) for s in (slow, fast))
    hard, own, finer = on_anvil("hard", (12, 30)), on_anvil("cu", (12, 30)), on_anvil("cu", (24, 60))
    assert hard[0] == pytest.approx(shortest, rel=5e-3)
    assert hard[1] == pytest.approx(fast.nodes[N.x, :fast.numbering.total].max(), rel=2e-2)
    assert shortest < own[0] < longest
    assert finer[0] == pytest.approx(own[0], rel=5e-3)


STEEL = Material("steel", MieGruneisen(7850.0, 4570.0, 1.49, 1.93), PerfectlyPlastic(80e9, 0.5e9))


@pytest.mark.parametrize("ball, least, most", [("al", 10.0, 80.0), ("steel", 10.0, 100.0)])
def test_a_sphere_rebounds_from_a_plate(ball, least, most):
    """At 200 m/s from aluminium: it comes to rest, leaves with a part of its speed, and nothing is lost."""
    plate = al(16, 8, 16e-3, 6e-3, (0.0, -6e-3), "plate")
    solver = Lagrange2D(meeting([plate, sphere(8, 4e-3, 4.05e-3, -200.0, ball)], 60e-6, (Boundary2D(("plate.bottom",), "wall"),),
                                "axisymmetric", material=[aluminium(), STEEL]))
    speeds = []
    for time in np.arange(1, 13) * 5e-6:
        solver.march(time, 10**6)
        speeds.append(mean_velocity(solver, 1)[1])
    assert np.diff(speeds).min() > -1e-6
    assert least < speeds[-1] < most
    assert speeds[-1] == pytest.approx(speeds[-2], rel=1e-9)
    assert solver.errors()["energy_error"] < 1e-12
    assert solver.results()["contact_depth"] < 1e-3


def resistance(strength, u, rho=7850.0, shear=80e9):
    """Resistance of a target to penetration at the velocity u: 7/3 ln(alpha) Y, alpha the extent of the plastic zone over the radius of
    the crater, with the bulk modulus rho U^2 of a shock of particle velocity u (J. D. Walker, C. E. Anderson, Int. J. Impact Eng. 16
    (1995) 19; as open code of that model has it, `awlib` of DearDeer; not seen in the paper itself)."""
    bulk = rho * (4570.0 + 1.49 * u) ** 2

    def excess(alpha):
        right = (1.0 + rho * (alpha * u) ** 2 / (2.0 * shear)) * math.sqrt(bulk - rho * u * u)
        return (1.0 + rho * u * u / strength) * math.sqrt(max(bulk - rho * (alpha * u) ** 2, 0.0)) - right

    low, high = 1.0, math.sqrt(bulk / rho) / u
    for _ in range(80):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if excess(middle) > 0.0 else (low, middle)
    return 7.0 / 3.0 * math.log(low) * strength


def penetration(strength, speed, length, depths):
    """Mean velocity between two depths by the modified Bernoulli equation, rho (v - u)^2 / 2 + Y = rho u^2 / 2 + R, and the rod's
    deceleration Y / (rho l) (A. Tate, J. Mech. Phys. Solids 15 (1967) 387; V. P. Alekseevskii, Combust. Explos. Shock Waves 2 (1966) 63)."""
    rho, dt, u, depth, time, reached = 7850.0, 1e-8, 0.5 * speed, 0.0, 0.0, []
    while depth < depths[1]:
        for _ in range(3):
            u = (speed**2 - 2.0 * (resistance(strength, u) - strength) / rho) / (2.0 * speed)
        depth, time, length = depth + u * dt, time + dt, length - (speed - u) * dt
        speed -= strength / (rho * length) * dt
        if depth >= depths[len(reached)]:
            reached.append(time)
    return (depths[1] - depths[0]) / (reached[1] - reached[0])


def crater(mass, growth, strength, wide, speed):
    """Velocity of penetration between 1.5 and 5 diameters on a mesh whose zones widen by `growth` from one to the next beside the path."""
    rod = box(6, 72, 0.5 * wide, 6 * wide, (0.0, 1e-5), "rod", "steel", velocity=VelocityField(base=(0.0, -speed)))
    target = box(18, 96, 1.5 * wide, 8 * wide, (0.0, -8 * wide), "target", "steel")
    around = dataclasses.replace(box(27, 96, 10.5 * wide, 8 * wide, (1.5 * wide, -8 * wide), "around", "steel"), ratio=(growth, 1.0))
    steel = dataclasses.replace(STEEL, strength=PerfectlyPlastic(80e9, strength))
    given = meeting([target, rod, around], 44e-6, (), "axisymmetric", material=steel, erosion=Erosion2D(1.5, None, mass))
    solver, found = Lagrange2D(given), []
    for time in np.linspace(8.8e-6, 44e-6, 33):
        solver.march(time, 10**6)
        live = solver.erosion.live[:18 * 96].reshape(18, 96)
        top = solver._corners(N.y)[:, :18 * 96].max(axis=0).reshape(18, 96)
        found.append((time, -np.mean([top[i][live[i]].max() for i in range(3)])))
    assert solver.errors()["energy_error"] < 1e-12 and solver.errors()["momentum_y_error"] < 1e-12
    times, depth = np.array(found).T
    part = (depth > 1.5 * wide) & (depth < 5.0 * wide)
    assert depth[-1] > 5.0 * wide
    return np.polyfit(times[part], depth[part], 1)[0]


@pytest.mark.parametrize("mass", ["kept", "dropped"])
def test_a_rod_penetrates_as_the_modified_bernoulli_equation_says(mass):
    """Five diameters of steel at 2.5 km/s; a target twelve diameters wide, so that its side has no part in the resistance.

    Which zone leaves first depends on round-off, and velocities of single runs scatter by 1 to 2 %: a mean of three meshes. Zones of 5/6 mm;
    with 5/4 mm the rod is 0.5 % faster.
    """
    wide, strength, speed = 10e-3, 0.5e9, 2500.0
    found = np.mean([crater(mass, growth, strength, wide, speed) for growth in (1.1014, 1.104, 1.1065)])
    assert found == pytest.approx(penetration(strength, speed, 6 * wide, (1.5 * wide, 5.0 * wide)), rel=0.05)
