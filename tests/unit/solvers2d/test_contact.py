"""Bodies that meet in the plane: what is conserved, what friction and bonds do, what a resumed run and other threads give."""

import dataclasses

import numpy as np
import pytest
from contact_builders import (
    Boundary2D,
    Contact2D,
    N,
    Pulse,
    Rigid2D,
    al,
    angular_momentum,
    askew,
    bars,
    mean_velocity,
    meeting,
    moment,
    moment_of_contact,
    ran,
    rebound,
    sphere,
    strip,
    walls,
)
from plane_builders import Viscosity2D, box, gas

from hugoniot.core import team
from hugoniot.errors import OutOfRange
from hugoniot.mesh.shapes import Curve, Edges
from hugoniot.problem.plane.contact_model import inertia_of
from hugoniot.problem.plane.model import Block2D, VelocityField
from hugoniot.solvers.lagrange2d.contact import layout as C
from hugoniot.solvers.lagrange2d.contact.corners import crosses
from hugoniot.solvers.lagrange2d.solver import Lagrange2D


def slider(friction, stop, floor=True):
    """A block on an incline of 30 degrees, in 1e6 m/s2."""
    rigid = (Rigid2D("floor", ((-10e-3, 0.0), (30e-3, 0.0))),)
    return meeting([al(6, 4, 6e-3, 4e-3)], stop, rigid=rigid, contacts=(Contact2D(None, "sliding", friction),),
                   body_force=(0.5e6, -np.sqrt(0.75) * 1e6))


def test_momentum_and_energy_are_exact_and_bodies_separate():
    solver = Lagrange2D(askew())
    turning = angular_momentum(solver)
    solver.march(9e-6, 10**6)
    errors, results = solver.errors(), solver.results()
    assert errors["momentum_error"] < 1e-13
    assert errors["energy_error"] < 1e-13
    assert results["contact_heat"] > 0.0
    assert results["contact_depth"] < 1e-3
    assert abs(angular_momentum(solver) - turning) < 1e-12 * abs(turning)
    assert not solver.contact.tables.of_points[:, C.FORCE_X].any()
    assert np.nanmin(solver.state().nodes["gap"]) > 0.0


def test_contact_and_friction_have_no_moment():
    """Friction across what is left of a gap neither, nor the forces of zones, at the places in the middle of the step where both are found:
    the angular momentum stays what it was."""
    solver = Lagrange2D(askew(contacts=(Contact2D(None, "sliding", 0.3),)))
    before, n, moments, of_zones = angular_momentum(solver), solver.nodes, [], []
    while solver.time < 6e-6:
        solver.march(6e-6, 1)
        moments.append(abs(moment_of_contact(solver)))
        of_zones.append(solver.step * abs(moment(n[[N.xh, N.yh]], n[[N.fx, N.fy]])))
    assert max(sum(moments), sum(of_zones), abs(angular_momentum(solver) - before)) < 1e-12 * abs(before)
    assert solver.errors()["momentum_error"] < 1e-13 and solver.errors()["energy_error"] < 1e-13
    assert solver.results()["friction_work"] > 0.0


def test_a_point_that_goes_round_a_corner_does_not_cross_its_edges():
    """Gaps to the edges y = 0 and x = 0 of a quarter plane before and after a step along a straight way."""
    crosses_first = [crosses.py_func(y, after_y, x, after_x) for x, y, after_x, after_y in
                     [(-1.0, 0.5, 0.2, -2.0), (-1.0, 0.5, 2.0, -0.2), (1.0, 0.5, 2.0, -0.2), (-1.0, -0.1, 0.2, -2.0)]]
    assert crosses_first == [True, False, False, False]


def test_exchanging_the_bodies_changes_nothing_that_matters():
    one, other = ran(askew()), ran(askew(swapped=True))
    difference = [np.abs(mean_velocity(one, k) - mean_velocity(other, 1 - k)).max() for k in (0, 1)]
    assert max(difference) < 1e-9 * 300.0


@pytest.mark.parametrize("across", [3, 5])
def test_a_flyer_over_a_gap_does_what_it_does_when_it_touches(across):
    """One-dimensional between walls; matched nodes, and five against three."""
    joined = ran(strip(gap=0.0, along=20, stop=1.1e-6))
    apart = ran(strip(across_flyer=across, along=20, gap=1e-3, stop=1.1e-6))
    height = apart.problem.mesh.blocks[1]
    momentum = [mean_velocity(s, 0)[1] for s in (joined, apart)]
    surface = [s.state().nodes["velocity_y"][height.nodes[0, -1]] if s is apart else s.state().nodes["velocity_y"][
        joined.problem.mesh.blocks[1].nodes[0, -1]] for s in (joined, apart)]
    assert momentum[1] == pytest.approx(momentum[0], rel=4e-3)
    assert surface[1] == pytest.approx(surface[0], abs=0.01 * 700.0)
    assert apart.errors()["momentum_y_error"] < 1e-12
    assert apart.results()["contact_depth"] < 1e-3


def test_a_plate_cut_by_a_frictionless_line_is_as_one():
    """Pressure at one end, walls at the sides: the cut lies across the load."""
    found = []
    for contacts in ((), (Contact2D(("a", "b")),)):
        blocks = [al(4, 20, 1e-3, 4e-3), al(4, 10, 1e-3, 2e-3, (0.0, 4e-3), "b")]
        sides = (*walls("a.left", "b.left", "a.right", "b.right"), Boundary2D(("b.top",), "pressure", Pulse("constant", 2e9)))
        found.append(ran(meeting(blocks, 0.9e-6, sides, contacts=contacts)).state().zones["pressure"])
    assert np.abs(found[1] - found[0]).max() < 0.01 * found[0].max()


def test_a_block_slides_down_an_incline_as_coulomb_says():
    solver = Lagrange2D(slider(0.2, 60e-6))
    solver.march(20e-6, 10**6)
    start, impulse = mean_velocity(solver, 0), solver.exchanges()
    solver.march(60e-6, 10**6)
    along = (mean_velocity(solver, 0) - start)[0] / 40e-6
    pushed = {axis: solver.exchanges()[f"impulse_{axis} rigid floor"] - impulse[f"impulse_{axis} rigid floor"] for axis in "xy"}
    assert pushed["x"] == pytest.approx(-0.2 * pushed["y"], rel=1e-6)
    assert along == pytest.approx(1e6 * (0.5 - 0.2 * np.sqrt(0.75)), rel=5e-3)
    assert solver.results()["friction_work"] > 0.0
    assert solver.errors()["energy_error"] < 1e-10


def test_friction_beyond_the_slope_holds_the_block():
    """It quivers by less than a hundredth of what it would have slid."""
    solver = ran(slider(3.0, 40e-6))
    x = solver.nodes[N.x, : solver.numbering.total]
    assert abs(x.mean() - 3e-3) < 0.01 * 0.5 * 0.5e6 * 40e-6**2


def test_two_bars_rebound():
    """Equal bars exchange their velocities; contact lasts while a wave runs to the free end and back, 2 L / c."""
    time, speed = rebound(bars(40))
    assert time == pytest.approx(1.0, rel=0.02)
    assert speed == pytest.approx(1.0, rel=0.04)


def test_a_sphere_rebounds_from_a_plate():
    """At 200 m/s, coarse: it leaves with a part of its speed, and nothing is lost."""
    plate = al(8, 4, 16e-3, 6e-3, (0.0, -6e-3), "plate")
    solver = ran(meeting([plate, sphere(4, 4e-3, 4.05e-3, -200.0)], 40e-6, walls("plate.bottom"), "axisymmetric"))
    assert 5.0 < mean_velocity(solver, 1)[1] < 100.0
    assert solver.errors()["energy_error"] < 1e-12
    assert solver.results()["contact_depth"] < 1e-3


def test_a_bar_on_a_broad_anvil_of_its_own_metal_shortens_less_than_on_a_rigid_one():
    """And more than at half the speed on the rigid one, as it would if the anvil were a bar like itself."""
    def length(below, speed, **rigid):
        bar = al(3, 12, 3e-3, 12e-3, (0.0, 0.0), "bar", (0.0, -speed))
        solver = ran(meeting([*below, bar], 20e-6, (), "axisymmetric", contacts=[Contact2D(("anvil", "bar"))] if below else (), **rigid))
        assert solver.results()["contact_depth"] < 1e-3 and solver.errors()["energy_error"] < 1e-12
        return np.ptp(solver.nodes[N.y, solver.numbering.first[len(below)]:solver.numbering.total])

    floor = [Rigid2D("floor", ((0.0, 0.0), (12e-3, 0.0)))]
    anvil = [al(8, 6, 10e-3, 10e-3, (0.0, -10e-3), "anvil")]
    assert length([], 250.0, rigid=floor) < length(anvil, 250.0) < length([], 125.0, rigid=floor) < 12e-3


@pytest.mark.parametrize("across", [4, 7])
def test_bonds_hold_pull_and_break(across):
    def pulled(kind, **law):
        blocks = [al(4, 8, 2e-3, 4e-3, velocity=(0.0, -30.0)), al(across, 8, 2e-3, 4e-3, (0.0, 4e-3), "b", (0.0, 30.0))]
        return ran(meeting(blocks, 2e-6, contacts=(Contact2D(("a", "b"), kind, **law),)))

    def joined(columns):
        blocks = [al(columns, 8, 2e-3, 4e-3, velocity=(0.0, -30.0)), al(columns, 8, 2e-3, 4e-3, (0.0, 4e-3), "b", (0.0, 30.0))]
        return mean_velocity(ran(meeting(blocks, 2e-6)), 1)[1]

    bonded, weak, loose = pulled("bonded"), pulled("separable", strength=0.1e9), pulled("sliding")
    coarse, fine = joined(4), joined(across)      # which differ by 1 %: bonds add nothing to what the meshes do
    assert min(coarse, fine) - 0.01 < mean_velocity(bonded, 1)[1] < max(coarse, fine) + 0.01
    assert bonded.results()["bonds_broken"] == 0
    assert weak.results()["bonds_broken"] > 0
    assert mean_velocity(loose, 1)[1] == pytest.approx(30.0, rel=1e-12)
    assert max(s.errors()["energy_error"] for s in (bonded, weak, loose)) < 1e-12


def test_a_free_punch_gives_what_the_material_takes():
    punch = Rigid2D("punch", ((8e-3, 11e-3), (8e-3, 10.1e-3), (12e-3, 10.1e-3), (12e-3, 11e-3)), True, mass=0.1, start=(0.0, -200.0))
    solver = ran(meeting([al(20, 10, 20e-3, 10e-3)], 6e-6, walls("a.bottom"), rigid=(punch,)))
    taken, speed = solver.exchanges(), solver.contact.rigid_velocity()["punch"]
    assert taken["impulse_y rigid punch"] == pytest.approx(-0.1 * (speed[1] + 200.0), rel=1e-12)
    assert taken["work rigid punch"] == pytest.approx(0.05 * (200.0**2 - speed[0] ** 2 - speed[1] ** 2), rel=1e-12)
    assert solver.errors()["energy_error"] < 1e-12
    assert abs(speed[0]) < 1e-3 * 200.0
    assert taken["moved_y punch"] < -0.4e-3


def bar(spin=0.0, **motion):
    """A free rigid bar of 10 x 2 mm that turns, above the origin."""
    return Rigid2D("bar", ((-5e-3, 2e-3), (5e-3, 2e-3), (5e-3, 4e-3), (-5e-3, 4e-3)), True, mass=0.1, turns=True, spin=spin, **motion)


def turning_momentum(solver, body):
    """Momentum (x, y) and angular momentum about the origin of the material and a rigid body."""
    row, n = solver.contact.tables.rigid[0], solver.nodes
    x, y, _, u, v, spin = row[:6]
    moment = angular_momentum(solver) + body.mass * (x * v - y * u) + inertia_of(body) * spin
    return np.array([np.sum(n[N.own] * n[N.u]) + body.mass * u, np.sum(n[N.own] * n[N.v]) + body.mass * v, moment])


def test_a_free_body_turns_about_its_centre_for_ever():
    body = bar(2e5, start=(10.0, 20.0))
    solver = ran(meeting([al(2, 2, 1e-3, 1e-3, (20e-3, 0.0))], 20e-6, rigid=(body,)))
    angle = solver.exchanges()["turned bar"]
    assert angle == pytest.approx(4.0, rel=1e-12)
    places = solver.nodes[[N.x, N.y]][:, solver.numbering.total:]
    corners = np.array(body.points) - (0.0, 3e-3)
    turn = np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])
    wanted = corners @ turn + np.array([10.0, 20.0]) * 20e-6 + (0.0, 3e-3)
    for corner in wanted:
        assert np.hypot(*(places.T - corner).T).min() < 1e-13
    assert solver.contact.rigid_velocity()["bar"] == (10.0, 20.0, 2e5)


@pytest.mark.parametrize("friction", [0.0, 0.5])
def test_a_body_that_turns_takes_the_angular_momentum_of_what_strikes_it(friction):
    """Aluminium that strikes a bar near its end, which it touches: the bar flies off turning, and what both have together stays."""
    body = bar()
    solver = Lagrange2D(meeting([al(3, 4, 1.5e-3, 2e-3, (3.2e-3, 0.0), velocity=(20.0, 200.0))], 6e-6, rigid=(body,),
                                contacts=(Contact2D(None, "sliding", friction),)))
    before = turning_momentum(solver, body)
    solver.march(6e-6, 10**6)
    after, taken = turning_momentum(solver, body), solver.exchanges()
    assert after[:2] == pytest.approx(before[:2], rel=1e-12)
    assert after[2] == pytest.approx(before[2], rel=1e-12)
    u, v, spin = solver.contact.rigid_velocity()["bar"]
    assert spin > 500.0 and v > 1.0
    assert taken["work rigid bar"] == pytest.approx(-0.5 * (body.mass * (u * u + v * v) + inertia_of(body) * spin**2), rel=1e-12)
    assert solver.errors()["energy_error"] < 1e-12
    assert solver.results()["contact_depth"] < 1e-3


def test_dust_and_a_body_that_turns_keep_their_angular_momentum():
    """Zones of a gas of hardly any pressure, whatever its energy: what is left is contact, and it is exact."""
    body = bar()
    dust = box(3, 3, 1.5e-3, 1.5e-3, (3.2e-3, 0.2e-3), density=8000.0, pressure=1e-9, velocity=VelocityField(base=(40.0, 200.0)))
    solver = Lagrange2D(meeting([dust], 3e-6, material=gas(1.0 + 1e-12), rigid=(body,), contacts=(Contact2D(None, "sliding", 0.3),),
                                viscosity=Viscosity2D("tensor", True, 0.0, 0.0, 0.0, 0.0), largest_step=2e-8))
    before = turning_momentum(solver, body)
    solver.march(3e-6, 10**6)
    assert solver.contact.rigid_velocity()["bar"][2] > 100.0
    assert turning_momentum(solver, body) == pytest.approx(before, rel=1e-12)


def test_a_cylinder_rolls_down_an_incline():
    """With friction enough it rolls: it has two thirds of the acceleration of one that slides without. 30 degrees, 1e6 m/s2."""
    angles = np.linspace(0.0, 2.0 * np.pi, 96, endpoint=False)
    points = tuple((float(3e-3 + 2e-3 * np.sin(a)), float(2e-3 - 2e-3 * np.cos(a))) for a in angles)
    found = []
    for friction in (0.0, 0.6):
        body = Rigid2D("roll", points, True, mass=0.03, turns=True)
        solver = Lagrange2D(meeting([al(24, 3, 8e-3, 1e-3, (0.0, -1e-3))], 50e-6, walls("a.bottom", "a.left", "a.right"), rigid=(body,),
                                    contacts=(Contact2D(None, "sliding", friction),), body_force=(0.5e6, -np.sqrt(0.75) * 1e6)))
        solver.march(10e-6, 10**6)
        start = solver.contact.rigid_velocity()["roll"]
        solver.march(50e-6, 10**6)
        end = solver.contact.rigid_velocity()["roll"]
        found.append((end[0] - start[0]) / 40e-6)
    assert found[0] == pytest.approx(0.5e6, rel=1e-2)
    assert found[1] == pytest.approx(0.5e6 / 1.5, rel=1e-2)
    assert end[2] == pytest.approx(-end[0] / 2e-3, rel=0.025)     # a polygon on an elastic floor creeps a little


def test_a_driven_punch_stays_on_its_way():
    drive = Rigid2D("punch", ((8e-3, 11e-3), (8e-3, 10.1e-3), (12e-3, 10.1e-3), (12e-3, 11e-3)), True, Pulse("constant", 100.0),
                    direction=(0.0, -1.0))
    solver = ran(meeting([al(10, 5, 20e-3, 10e-3)], 4e-6, walls("a.bottom"), rigid=(drive,)))
    assert solver.exchanges()["moved_y punch"] == pytest.approx(-0.4e-3, rel=1e-9)
    assert solver.exchanges()["work rigid punch"] > 0.0
    assert solver.errors()["energy_error"] < 1e-12


def test_a_run_resumed_while_it_slides_has_the_same_bits():
    given = dataclasses.replace(slider(0.2, 20e-6))
    whole, first = ran(given), ran(given, cycles=151)
    assert first.contact.tables.of_points[:, C.FORCE_X].any()
    rest = Lagrange2D(given)
    rest.restore(first.payload())
    while rest.time < given.stop_time:
        rest.march(given.stop_time, 13)
    assert rest.cycle == whole.cycle
    for name in ("zones", "nodes", "chains"):
        assert np.array_equal(getattr(rest, name), getattr(whole, name))
    assert rest.results() == whole.results()


@pytest.mark.slow       # the march with contact and a team is compiled for it: a minute
@pytest.mark.skipif(not team.possible(), reason="no threads that share a march here")
def test_two_threads_give_the_same_bits(monkeypatch):
    monkeypatch.setattr("hugoniot.solvers.lagrange2d.solver.WORTH_SHARING", 1)
    monkeypatch.setattr("os.cpu_count", lambda: 2)
    one, two = ran(askew()), ran(askew(threads=2))
    assert two.team.threads == 2
    assert np.array_equal(one.zones, two.zones)
    assert np.array_equal(one.nodes[N.x], two.nodes[N.x])


def discs(inner, scheme, across=11):
    blocks = [al(8, 8, 4e-3, 4e-3, (inner, 0.0), "target"), al(across, 5, 4e-3, 2e-3, (inner, 4.05e-3), "flyer", (0.0, -500.0))]
    return meeting(blocks, 1e-6, geometry="axisymmetric", scheme=scheme)


@pytest.mark.parametrize("across", [8, 11])
@pytest.mark.parametrize("inner, scheme", [(0.0, "true_volume"), (1e-3, "true_volume"), (1e-3, "area_weighted")])
def test_discs_meet_on_the_axis_and_off_it(inner, scheme, across):
    solver = ran(discs(inner, scheme, across))
    errors = solver.errors()
    assert errors["energy_error"] < 1e-12
    assert errors["momentum_y_error"] < (1e-12 if scheme == "true_volume" else 1e-5)
    assert solver.results()["contact_depth"] < 1e-3
    struck = solver.state().nodes["velocity_y"][solver.problem.mesh.blocks[0].nodes[0, -1]]
    assert -500.0 < struck < -100.0


def test_area_weighted_bodies_do_not_meet_on_the_axis():
    with pytest.raises(OutOfRange, match="bodies cannot meet on the axis"):
        Lagrange2D(discs(0.0, "area_weighted"))


def test_a_body_meets_itself():
    """A fork whose prongs are driven together: joined at the root, they meet at the tips and go no farther."""
    blocks = [al(2, 6, 2e-3, 6e-3, name="root"), al(8, 2, 8e-3, 2e-3, (2e-3, 0.0), "low", (0.0, 100.0)),
              al(8, 2, 8e-3, 2e-3, (2e-3, 4e-3), "high", (0.0, -100.0))]
    solver = ran(meeting(blocks, 14e-6, contacts=(Contact2D(("low", "high")),)))
    first = solver.numbering.first
    low, high = (solver.nodes[N.y, first[k]:first[k + 1]].reshape(9, 3) for k in (1, 2))
    assert (high[:, 0] - low[:, -1]).min() > -1e-3 * 1e-3
    assert solver.results()["contact_heat"] > 0.0
    assert solver.errors()["momentum_error"] < 1e-12


@pytest.mark.parametrize("layers", [1, 2])
def test_a_thin_sheet_does_not_meet_itself_through_its_thickness(layers):
    """Sheet of a 25th of the length of its edges, pressed together, beside a body that is far from it."""
    sheet = dataclasses.replace(al(4, layers, 4e-3, 0.04e-3, name="sheet"),
                                velocity=VelocityField(centre=(0.0, 0.02e-3), gradient=((0.0, 0.0), (0.0, -1e6))))
    solver = ran(meeting([sheet, al(1, 1, 1e-3, 1e-3, (0.0, 5e-3), "far")], 1e-7))
    assert solver.results()["contact_sweeps"] == 0
    assert solver.results()["contact_heat"] == 0.0


def test_a_notch_that_is_driven_shut_closes_to_its_bottom():
    """The node above the bottom of the notch meets the edge on the other side, which begins at that bottom: it does not pass through it."""
    top = Curve("polyline", tuple((0.5e-3 * k, 4e-3 - (3e-3 - 1e-3 * abs(k - 4) if 1 <= k <= 7 else 0.0)) for k in range(9)), "points")
    sides = (Curve("line", ((x, 0.0), (x, 4e-3))) for x in (0.0, 4e-3))
    block = Block2D("a", "al", Edges(*sides, Curve("line", ((0.0, 0.0), (4e-3, 0.0))), top), (8, 4),
                    velocity=VelocityField(centre=(2e-3, 0.0), gradient=((-2e5, 0.0), (0.0, 0.0))))
    solver = ran(meeting([block], 8e-6, contacts=(Contact2D(("a", "a")),)))
    x, y = (solver.nodes[row, :45].reshape(9, 5) for row in (N.x, N.y))
    assert solver.results()["contact_heat"] > 0.0
    for k in (3, 5):      # beside the bottom, in front of the other side of the notch
        a, b = ((x[j, -1], y[j, -1]) for j in (4, 8 - k))
        way, at = np.subtract(b, a), np.subtract((x[k, -1], y[k, -1]), a)
        assert (1.0 if k == 3 else -1.0) * (way[0] * at[1] - way[1] * at[0]) > -1e-3 * way @ way


def test_a_body_slides_past_the_end_of_another():
    blocks = [al(8, 3, 8e-3, 3e-3, name="base"), al(4, 4, 4e-3, 4e-3, (6e-3, 3e-3), "rider", (400.0, -20.0))]
    solver = ran(meeting(blocks, 6e-6, contacts=(Contact2D(("base", "rider")),)))
    x = solver.nodes[N.x, solver.numbering.first[1]:solver.numbering.first[2]]
    assert x.min() > 8e-3
    assert solver.results()["contact_depth"] < 1e-3
    assert solver.errors()["energy_error"] < 1e-12
