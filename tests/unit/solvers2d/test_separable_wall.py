"""Walls that let go: no tension, the motion of a rigid body, and what a deck may not ask of them."""

import dataclasses

import numpy as np
import pytest
from contact_builders import Rigid2D, al, meeting
from plane_builders import Boundary2D, ran

from hugoniot.errors import DeckError, OutOfRange
from hugoniot.mesh.shapes import Curve, Edges
from hugoniot.problem.deck import read_deck_text
from hugoniot.problem.plane.model import Block2D
from hugoniot.problem.plane.walls import with_walls
from hugoniot.solvers.lagrange2d.assemble import N
from hugoniot.solvers.lagrange2d.solver import Lagrange2D

LETS_GO = Boundary2D(("a.bottom",), "wall", separable=True)


def plate(velocity, *boundaries, **more):
    return meeting([al(6, 4, 3e-3, 2e-3, velocity=velocity)], 1.5e-6, boundaries, **more)


@pytest.mark.parametrize("geometry", ["plane", "axisymmetric"])
def test_it_is_a_rigid_body_at_rest(geometry):
    """A plate that strikes it: the same bits as against a body given by hand; energy closed."""
    wall = ran(plate((0.0, -200.0), LETS_GO, geometry=geometry))
    beyond = 3e-3 * 3.0
    left = 0.0 if geometry == "axisymmetric" else 1.5e-3 - beyond
    body = ran(plate((0.0, -200.0), geometry=geometry, rigid=[Rigid2D("floor", ((left, 0.0), (1.5e-3 + beyond, 0.0)))]))
    assert np.array_equal(wall.zones, body.zones) and np.array_equal(wall.nodes, body.nodes)
    count = wall.numbering.total
    assert wall.nodes[N.v, :count].mean() > -50.0 and wall.nodes[N.y, :count].max() < 2e-3 and wall.errors()["energy_error"] < 1e-12
    mine, its = wall.exchanges(), body.exchanges()
    assert mine["impulse_y a.bottom"] == pytest.approx(its["impulse_y rigid floor"], rel=1e-9) and mine["impulse_y a.bottom"] > 0.0
    assert not any("rigid" in name or name.startswith("moved") for name in mine)


def test_it_holds_no_tension_where_a_wall_does():
    """A plate that flies away: free at once, or held back."""
    free, held = ran(plate((0.0, 100.0), LETS_GO)), ran(plate((0.0, 100.0), dataclasses.replace(LETS_GO, separable=False)))
    count = free.numbering.total
    assert np.allclose(free.nodes[N.v, :count], 100.0, rtol=1e-9)
    assert held.nodes[N.y, :count].min() == 0.0 and free.nodes[N.y, :count].min() == pytest.approx(1.5e-4, rel=1e-9)


def test_a_problem_without_one_is_left_as_it_is():
    given = plate((0.0, 0.0))
    assert with_walls(given) is given


def test_one_that_is_not_straight_is_refused():
    bent = Edges(*(Curve("line", ends) for ends in (((0.0, 0.0), (0.0, 1.0)), ((1.0, 0.0), (1.0, 1.0)))),
                 Curve("polyline", ((0.0, 0.0), (0.5, -0.2), (1.0, 0.0))), Curve("line", ((0.0, 1.0), (1.0, 1.0))))
    with pytest.raises(OutOfRange, match="is a wall, but it is not straight"):
        Lagrange2D(meeting([Block2D("a", "al", bent, (4, 4))], 1e-6, (LETS_GO,)))


DECK = """\
stop_time = "1 us"
[[block]]
name = "a"
material = "copper"
x = ["0 mm", "1 mm"]
y = ["0 mm", "1 mm"]
zones = [3, 3]
[[boundary]]
on = "a.bottom"
kind = "wall"
separable = true
[solver]
kind = "lagrange2d"
"""


def test_a_deck_asks_for_it_and_is_written_back():
    deck = read_deck_text(DECK)
    assert deck.problem.boundaries[0].separable and read_deck_text(deck.resolved).problem == deck.problem


@pytest.mark.parametrize("old, new, key, words", [
    ('kind = "wall"', 'kind = "free"', "boundary[1].separable", "does not apply to a boundary of kind free"),
    ("separable = true", "separable = true\nslip = false", "boundary[1].slip", "cannot keep nodes from sliding along it"),
])
def test_what_it_cannot_be_is_said(old, new, key, words):
    with pytest.raises(DeckError) as caught:
        read_deck_text(DECK.replace(old, new))
    assert any(p.key == key and words in p.message and p.line for p in caught.value.problems)
