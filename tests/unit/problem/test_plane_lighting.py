"""Lighting times in the plane: straight lines, around obstacles, through explosives of several speeds (Kenamond's problems)."""

import math

import numpy as np
import pytest

from hugoniot.errors import DeckError
from hugoniot.laws.burn.paths import Walls, first_arrivals
from hugoniot.problem.deck import read_deck_text
from hugoniot.problem.plane.lighting import node_lighting_times, zone_lighting_times
from hugoniot.theory.exact.kenamond import nested, obstacle, single


def explosive(name, speed):
    return f"""
[material.{name}]
base = "comp_b"
burn = {{law = "programmed", detonation_velocity = {speed}}}
"""


def deck(blocks, lighting, geometry="plane", materials=(("he", 2000.0),)):
    text = f'geometry = "{geometry}"\nstop_time = "1 s"\n'
    text += "".join(f"[[block]]\nname = {name!r}\nmaterial = {material!r}\n{rest}\n" for name, material, rest in blocks)
    text += "".join(f"[[lighting]]\nat = {list(at)}\ntime = {time}\n" + (f"to = {list(to[0])}\n" if to else "") for at, time, *to in lighting)
    return text + "".join(explosive(*m) for m in materials) + '[solver]\nkind = "lagrange2d"\n'


def box(x, y, zones):
    return f'x = {list(x)}\ny = {list(y)}\nzones = {list(zones)}'


def sector(radius, angle, zones):
    return f'shape = "sector"\nradius = {list(radius)}\nangle = {list(angle)}\nzones = {list(zones)}'


def read(text):
    """The problem, its lighting kept from the deck's own checks of density and CJ speed (advice only)."""
    return read_deck_text(text).problem


def test_several_detonators_in_one_convex_explosive_are_exact():
    detonators = [((0.0, 0.0), 0.0), ((7.0, 3.0), 0.5e-3), ((4.0, 0.0), 2.0e-4)]
    problem = read(deck([("a", "he", box((0.0, 4.0), (0.0, 4.0), (7, 9))), ("b", "he", box((4.0, 8.0), (0.0, 4.0), (6, 9)))], detonators))
    places, times = zip(*detonators)
    exact = single(problem.mesh.nodes.T, 2000.0, places, times)
    assert np.abs(node_lighting_times(problem) - exact).max() < 1e-12 * exact.max()
    zones = zone_lighting_times(problem)
    assert np.array_equal(zones, node_lighting_times(problem)[problem.mesh.zone_nodes].min(axis=1))


def ring_about(n, radius=3.0, outer=10.0):
    """Half of a ring of explosive about an inert half disc, lit on its axis; x = 0 is the plane of symmetry."""
    return deck([("ring", "he", sector((radius, outer), (-0.5 * math.pi, 0.5 * math.pi), (n // 2, n)))], [((0.0, 5.0), 0.0)],
                geometry="axisymmetric")


@pytest.mark.parametrize("n", [16, 48])
def test_an_inert_ball_is_passed_along_tangent_arc_and_tangent(n):
    problem = read(ring_about(n))
    nodes = problem.mesh.nodes
    exact = obstacle(nodes.T * (1.0 + 1e-13), 2000.0, 3.0, (0.0, 5.0))
    error = node_lighting_times(problem) / np.where(exact > 0.0, exact, 1.0) - 1.0
    # the polygon of n chords cuts the arc short by (pi/n)^2/24 of it at the most, half the arc of one chord at its ends
    assert np.abs(error).max() < (math.pi / n) ** 2 / 4.0
    shadow = np.hypot(*(nodes - np.array([[0.0], [5.0]]))) / 2000.0 < exact * (1.0 - 1e-3)
    assert shadow.sum() > 0.3 * exact.size       # the test does look into the shadow


def test_a_front_does_not_cross_an_inert_wall():
    problem = read(deck([("low", "he", box((0.0, 3.0), (0.0, 1.0), (6, 2))), ("wall", "copper", box((0.0, 2.0), (1.0, 2.0), (4, 2))),
                         ("passage", "he", box((2.0, 3.0), (1.0, 2.0), (2, 2))), ("up", "he", box((0.0, 3.0), (2.0, 3.0), (6, 2)))],
                        [((0.0, 0.0), 0.0)]))
    times = dict(zip(map(tuple, problem.mesh.nodes.T.tolist()), node_lighting_times(problem)))
    corner = math.hypot(2.0, 1.0)
    assert times[0.0, 3.0] == pytest.approx((corner + 1.0 + math.hypot(2.0, 1.0)) / 2000.0, rel=1e-12)
    assert times[3.0, 3.0] == pytest.approx(2.0 * corner / 2000.0, rel=1e-12)     # past one corner of the wall
    assert times[0.0, 2.0] == pytest.approx((corner + 1.0 + 2.0) / 2000.0, rel=1e-12)        # along the wall's upper face
    assert times[0.0, 1.0] == pytest.approx(1.0 / 2000.0, rel=1e-12)
    assert np.isinf(zone_lighting_times(problem)[problem.mesh.block_of == 1]).all()
    assert np.isfinite(zone_lighting_times(problem)[problem.mesh.block_of != 1]).all()


def nested_problem(n):
    inner = sector((0.001, 3.0), (-0.5 * math.pi, 0.5 * math.pi), (n, n))
    outer = sector((3.0, 10.0), (-0.5 * math.pi, 0.5 * math.pi), (n, n))
    return read(deck([("fast", "he", inner), ("slow", "slow", outer)], [((0.001, 0.0), 0.0), ((0.0, 5.0), 2.0e-3), ((0.0, -5.0), 2.0e-3)],
                     geometry="axisymmetric", materials=(("he", 2000.0), ("slow", 1000.0))))


def test_a_fast_explosive_in_a_slow_one_with_detonators_outside():
    problem = nested_problem(16)
    exact = nested(problem.mesh.nodes.T * (1.0 + 1e-13), 3.0, 2000.0, 1000.0, ((0.0, 5.0), (0.0, -5.0)), (2.0e-3, 2.0e-3))
    far = np.hypot(*problem.mesh.nodes) > 1.0
    error = np.abs(node_lighting_times(problem) / exact - 1.0)[far].max()
    assert error < (1.0 + 0.5 * math.pi) * 0.001       # the way around the small hole that stands for the centre, over r = 1


def test_a_fast_neighbour_lights_a_slow_explosive_from_its_border():
    """A fast strip runs ahead along the border: the slow front behind it makes the Mach angle, t = (x + y sqrt(D1^2/D2^2 - 1)) / D1."""
    problem = read(deck([("fast", "he", box((0.0, 10.0), (-0.1, 0.0), (200, 1))), ("slow", "slow", box((0.0, 10.0), (0.0, 2.0), (200, 20)))],
                        [((0.0, 0.0), 0.0)], materials=(("he", 2000.0), ("slow", 1000.0))))
    x, y = problem.mesh.nodes
    head = (x + y * math.sqrt(3.0)) / 2000.0
    exact = np.where(y <= 0.0, np.hypot(x, y) / 2000.0, np.where(x * math.sqrt(3.0) < y, np.hypot(x, y) / 1000.0, head))
    gap = (node_lighting_times(problem) - exact)[y >= 0.0]
    assert gap.min() > -1e-12 and gap.max() < 0.05 / 1000.0 * 0.5      # half a zone of the border at the most


def test_a_line_of_detonators_lights_a_plane_front():
    problem = read(deck([("a", "he", box((0.0, 4.0), (0.0, 4.0), (8, 8)))], [((0.0, 0.0), 1e-6, (0.0, 4.0))]))
    assert np.allclose(node_lighting_times(problem), 1e-6 + problem.mesh.nodes[0] / 2000.0, rtol=1e-12)


def test_a_line_lights_every_node_from_its_nearest_point():
    """However many nodes lie between points of it; about the corner of an L the front goes from the point nearest to the corner."""
    blocks = [("a", "he", box((0.0, 4.0), (0.0, 2.0), (8, 300))), ("b", "he", box((0.0, 4.0), (2.0, 4.0), (8, 150))),
              ("c", "he", box((4.0, 8.0), (0.0, 2.0), (8, 300)))]
    problem = read(deck(blocks, [((0.0, 3.0), 1e-6, (0.0, 3.9))]))
    x, y = problem.mesh.nodes
    straight = np.hypot(x, y - np.clip(y, 3.0, 3.9))
    hidden = (x > 4.0) & (3.0 - (3.0 - y) * 4.0 / np.where(x > 0.0, x, 1.0) > 2.0)
    way = np.where(hidden, np.hypot(4.0, 1.0) + np.hypot(x - 4.0, y - 2.0), straight)
    assert hidden.sum() > 100
    assert np.abs(node_lighting_times(problem) - 1e-6 - way / 2000.0).max() < 1e-12


def test_an_unlit_explosive_is_a_mistake_of_the_deck():
    blocks = [("a", "he", box((0.0, 1.0), (0.0, 1.0), (2, 2))), ("c", "copper", box((1.0, 2.0), (0.0, 1.0), (2, 2))),
              ("b", "he", box((2.0, 3.0), (0.0, 1.0), (2, 2)))]
    with pytest.raises(DeckError, match="no detonation front reaches 'b'"):
        read(deck(blocks, [((0.0, 0.0), 0.0)]))
    with pytest.raises(DeckError, match=r"lighting\[2\].at: no explosive with programmed burn at \(1.5, 0.5\) m; move the lighting point into 'a' or 'b'"):
        read(deck(blocks, [((0.0, 0.0), 0.0), ((1.5, 0.5), 0.0)]))
    assert read(deck(blocks, [((0.0, 0.0), 0.0), ((3.0, 0.5), 0.0)])) is not None


def test_paths_do_not_cut_through_a_polygon_of_many_corners():
    """Seen from one corner of the obstacle, all but its neighbours lie behind it."""
    angle = np.linspace(0.0, 2.0 * np.pi, 25)[:-1]
    circle = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    inner = np.stack([np.roll(circle, -1, axis=0), circle], axis=1)          # the explosive on the left: outside
    square = np.array([[-4.0, -4.0], [4.0, -4.0], [4.0, 4.0], [-4.0, 4.0]])
    walls = Walls(np.concatenate([inner, np.stack([square, np.roll(square, -1, axis=0)], axis=1)]))
    assert len(walls.corners) == 24
    start = walls.corners[:1]
    hidden = walls.hide(np.repeat(start, 24, axis=0), walls.corners)
    assert hidden.sum() == 24 - 3       # itself and its two neighbours are seen
    around = first_arrivals(-start, walls, start, [0.0], 1.0)
    assert around[0] == pytest.approx(12 * 2.0 * math.sin(math.pi / 24), rel=1e-9)


@pytest.mark.parametrize("boxes, lit, warned", [
    (("comp_b", "tnt"), (0.0, 1.0), True), (("comp_b", "tnt"), (8.0, 1.0), False), (("tnt", "comp_b"), (0.0, 1.0), False),
    (("tnt", "comp_b"), (8.0, 1.0), True)])
def test_a_front_that_passes_into_a_weaker_explosive_is_warned_of(boxes, lit, warned):
    """From Composition B (CJ 28.7 GPa) into TNT (21 GPa), whichever block comes first; not the other way."""
    blocks = [("one", boxes[0], box((0.0, 4.0), (0.0, 2.0), (8, 4))), ("two", boxes[1], box((4.0, 8.0), (0.0, 2.0), (8, 4)))]
    found = [text for text in read_deck_text(deck(blocks, [(lit, 0.0)], materials=())).warnings if "stronger products" in text]
    assert len(found) == warned and all("from 'one'" in text if lit[0] == 0.0 else "from 'two'" in text for text in found)


def test_a_front_that_runs_along_a_joint_is_not_warned_of():
    blocks = [("one", "comp_b", box((0.0, 8.0), (0.0, 1.0), (16, 2))), ("two", "tnt", box((0.0, 8.0), (1.0, 2.0), (16, 2)))]
    line = [((0.0, 0.0), 0.0, (0.0, 2.0))]
    assert not [text for text in read_deck_text(deck(blocks, line, materials=())).warnings if "stronger products" in text]
