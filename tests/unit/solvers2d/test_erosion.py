"""Zones that leave the mesh: what is kept and booked, which surfaces they leave, what a resumed run and observers see."""

import dataclasses

import numpy as np
import pytest
from contact_builders import Contact2D, N, Z, al, meeting, ran
from plane_builders import aluminium, box, problem

from hugoniot.core import team
from hugoniot.diagnostics.budgets2d import PlaneBudget
from hugoniot.diagnostics.gauges2d import Sampler
from hugoniot.errors import DeckError
from hugoniot.mesh.shapes import Box
from hugoniot.problem.deck import read_deck_text, write_deck
from hugoniot.problem.plane.model import Block2D, Boundary2D, Erosion2D, Gauge2D
from hugoniot.solvers.lagrange2d import layout as L
from hugoniot.solvers.lagrange2d.contact.faces import surface_faces
from hugoniot.solvers.lagrange2d.rows_of_blocks import stretches
from hugoniot.solvers.lagrange2d.solver import Lagrange2D


def rod(mass="kept", geometry="axisymmetric", stop=6e-6, strain=1.0, **options):
    """A rod of two zones across at 2 km/s on a block of its own metal."""
    blocks = [al(8, 8, 8e-3, 8e-3, (0.0, -8e-3), "target"), al(2, 10, 2e-3, 10e-3, (0.0, 1e-5), "rod", (0.0, -2000.0))]
    boundaries = () if geometry == "axisymmetric" else (Boundary2D(("target.left", "rod.left"), "wall"),)
    return meeting(blocks, stop, boundaries, geometry, erosion=Erosion2D(strain, None, mass), **options)


@pytest.mark.parametrize("geometry", ["plane", "axisymmetric"])
@pytest.mark.parametrize("mass", ["kept", "dropped"])
def test_what_leaves_the_mesh_is_booked(mass, geometry):
    solver = ran(rod(mass, geometry))
    errors, results = solver.errors(), solver.results()
    assert results["zones_eroded"] >= 5
    assert results["eroded_mass"] > 0.0
    assert results["contact_depth"] < 1e-3
    assert errors["mass_error"] < 1e-14
    assert errors["momentum_y_error"] < 1e-12
    assert errors["energy_error"] < 1e-12
    weight = solver.nodes[N.own].sum()
    whole = solver.start_mass - (results["eroded_mass"] if mass == "dropped" else 0.0)
    assert weight == pytest.approx(whole, rel=1e-12)
    if mass == "dropped":
        assert results["eroded_momentum_y"] < 0.0


@pytest.mark.parametrize("mass", ["kept", "dropped"])
def test_a_body_force_pushes_what_is_dropped_up_to_then(mass):
    given = dataclasses.replace(rod(mass), body_force=(0.0, -1e8))
    solver = ran(given)
    assert solver.results()["zones_eroded"] >= 5
    assert solver.errors()["momentum_y_error"] < 1e-12 and solver.errors()["energy_error"] < 1e-12


def test_a_run_resumed_after_zones_have_left_has_the_same_bits():
    given = rod()
    whole, first = ran(given), ran(given, cycles=163)
    assert 0 < first.results()["zones_eroded"] < whole.results()["zones_eroded"]
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
    one, two = ran(rod(strain=0.3), cycles=50), ran(rod(strain=0.3, threads=2), cycles=50)
    assert two.team.threads == 2
    assert one.results()["zones_eroded"] > 0
    assert np.array_equal(one.zones, two.zones)
    assert np.array_equal(one.nodes[N.x], two.nodes[N.x])


def test_observers_see_no_numbers_where_zones_have_left():
    given = rod(stop=4e-6)
    solver = ran(given)
    state, gone = solver.state(), ~solver.erosion.live
    assert np.array_equal(np.isnan(state.zones["pressure"]), gone)
    assert np.array_equal(state.zones["eroded"], gone)
    first = int(np.flatnonzero(gone)[0])
    place = tuple(given.mesh.nodes[:, given.mesh.zone_nodes[first]].mean(axis=1))
    nose, tail = (given.mesh.chains[f"rod.{side}"] for side in ("bottom", "top"))
    gauges = Gauge2D("g", "point", place), Gauge2D("nose", "edge", on="rod.bottom"), Gauge2D("tail", "edge", on="rod.top")
    slit, side = Gauge2D("slit", "slit", (1e-3, 0.0), "rod.bottom", (0.0, -1.0)), Gauge2D("face", "edge", on="target.top")
    read = Sampler(dataclasses.replace(given, gauges=(*gauges, slit, side)))(state)
    assert gone[nose.zones].all() and not gone[tail.zones].any()
    lost = [True, True, False, True, False]      # what flies on of a zone is no longer the material of a gauge
    for name in ("pressure", "velocity_y", "position_x"):
        assert np.isnan(read[name]).tolist() == lost
    assert np.isnan(read["line_velocity"]).all()
    face, area = given.mesh.chains["target.top"], np.diff(given.mesh.nodes[0, given.mesh.chains["target.top"].nodes] ** 2)
    left = ~gone[face.zones]
    assert 0 < left.sum() < len(left)
    mean = (area * np.where(left, state.zones["pressure"][face.zones], 0.0))[left].sum() / area[left].sum()
    assert read["pressure"][4] == pytest.approx(mean, rel=1e-12)


@pytest.mark.parametrize("mass", ["kept", "dropped"])
def test_the_energies_of_the_regions_add_up_to_what_the_run_began_with(mass):
    solver = ran(rod(mass))
    parts = PlaneBudget(solver.problem)(solver.state(), solver.kinetic_energy(), solver.all_zones())
    gone = solver.results()["eroded_energy"] if mass == "dropped" else 0.0
    assert parts["kinetic_energy"].sum() + parts["internal_energy"].sum() + gone == pytest.approx(solver.start_energy, rel=1e-12)
    assert parts["plastic_work"].min() > 0.0


def test_a_zone_of_a_short_step_leaves():
    blocks = [box(4, 4, 4.0, 4.0, name="a", material="al")]
    solver = Lagrange2D(meeting(blocks, 1e-3, erosion=Erosion2D(smallest_step=1e-5)))
    solver.zones[Z.c, 5] = 1e5
    assert solver.erosion.due(0).tolist() == [5]


def mesh_of(ni, nj):
    block = Block2D("a", "al", Box((0.0, float(ni)), (0.0, float(nj))), (ni, nj))
    return problem([block], aluminium(), 1.0).mesh


@pytest.mark.parametrize("height, put_out", [(-1e-7, False), (-0.5e-3, True)])
def test_dust_inside_a_zone_is_put_onto_its_new_face_but_not_off_a_surface_it_lies_on(height, put_out):
    """A node that zones have left behind is beside the right face of the first zone of two when the second one leaves: in the middle of
    the face it is put onto it; on top of the zone, where another body may be close, it stays."""
    blocks = [al(2, 1, 2e-3, 1e-3, name="a"), al(1, 1, 1e-3, 1e-3, (5e-3, 0.0), "dust")]
    solver = Lagrange2D(meeting(blocks, 1e-6, contacts=(Contact2D(("a", "dust")),), erosion=Erosion2D(1.0)))
    node = solver.numbering.first[1]
    solver.nodes[[N.x, N.y], node] = place = 0.99e-3, 1e-3 + height
    solver.zones[Z.plastic_strain, 1:] = 2.0
    assert solver.erosion.act(L.PAUSED)
    assert solver.nodes[N.x, node] == pytest.approx(1e-3 if put_out else place[0], rel=1e-12)
    assert solver.nodes[N.y, node] == place[1]


def test_surfaces_go_around_what_is_left():
    """Of 3 x 3 zones without the middle one: an outer surface of 12 faces, an inner one of 4, each closed."""
    mesh, live = mesh_of(3, 3), np.ones(9, dtype=bool)
    live[4] = False
    faces, follows = surface_faces(mesh, live, np.zeros((0, 2), dtype=int), np.zeros(0, dtype=int))
    assert len(faces) == 16
    assert sorted(_rounds(follows)) == [4, 12]


def test_zones_that_touch_at_a_corner_have_surfaces_of_their_own():
    mesh, live = mesh_of(2, 2), np.array([True, False, False, True])
    faces, follows = surface_faces(mesh, live, np.zeros((0, 2), dtype=int), np.zeros(0, dtype=int))
    assert len(faces) == 8
    assert _rounds(follows) == [4, 4]


def _rounds(follows):
    """Lengths of the closed surfaces."""
    left, found = set(range(len(follows))), []
    while left:
        e, count = left.pop(), 1
        while follows[e] in left:
            e = follows[e]
            left.remove(e)
            count += 1
        found.append(count)
    return found


def test_stretches_of_a_row():
    assert stretches(np.array([True, True, False, True])) == [(0, 2), (3, 4)]
    assert stretches(np.zeros(3, dtype=bool)) == []


DECK = """
geometry = "axisymmetric"
stop_time = "1 us"
[[block]]
name = "target"
material = "al"
r = ["0 mm", "4 mm"]
z = ["0 mm", "4 mm"]
zones = [4, 4]
[material.al.eos]
law = "mie_gruneisen"
rho0 = "2700 kg/m^3"
c0 = "5200 m/s"
s = 1.5
gamma0 = 2.0
[material.al.strength]
law = "perfectly_plastic"
shear_modulus = "24.8 GPa"
yield_stress = "0.3 GPa"
[solver]
kind = "lagrange2d"
"""


def test_erosion_of_a_deck_reads_back_and_is_off_by_default():
    given = read_deck_text(DECK + '[solver.erosion]\nplastic_strain = 1.5\nmass = "dropped"\n', "deck.toml").problem
    assert given.solver.erosion == Erosion2D(1.5, None, "dropped")
    assert read_deck_text(write_deck(given), "deck.toml").problem == given
    assert read_deck_text(DECK, "deck.toml").problem.solver.erosion is None


def test_erosion_without_a_criterion_is_refused():
    with pytest.raises(DeckError, match="has no condition for removing a zone"):
        read_deck_text(DECK + '[solver.erosion]\nmass = "kept"\n', "deck.toml")
