"""Where a captured shock may still be forming: beside the faces at which it starts, and nowhere else."""

import numpy as np
import pytest

from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.materials.material import Material
from hugoniot.mesh.shapes import Box
from hugoniot.problem.forming import START_UP, forming
from hugoniot.problem.model import Boundary, Problem, Pulse, Region
from hugoniot.problem.plane.model import Block2D, Boundary2D, Problem2D, VelocityField

AL = Material("al", MieGruneisen(2700.0, 5200.0, 1.5, 2.0))
CU = Material("cu", MieGruneisen(8930.0, 3940.0, 1.489, 1.99))


def line(*regions, left="free", right="free"):
    ends = [Boundary(kind, Pulse("constant", 1.0) if kind in ("velocity", "pressure") else None) for kind in (left, right)]
    return forming(Problem("p", "planar", 1.0, regions, {"al": AL}, left=ends[0], right=ends[1]))


@pytest.mark.parametrize("end, speed, starts", [("free", 5.0, False), ("fixed", 0.0, False), ("fixed", 5.0, True), ("transmitting", 5.0, False),
                                                ("velocity", 0.0, True), ("pressure", 0.0, True)])
def test_the_end_of_a_line(end, speed, starts):
    found = line(Region("a", "al", 0.0, 1.0, 50, velocity=speed), right=end)
    assert np.flatnonzero(found).tolist() == (list(range(50 - START_UP, 50)) if starts else [])


def test_interfaces_of_a_line_and_the_middle_third_of_a_thin_region():
    found = line(Region("a", "al", 0.0, 1.0, 40), Region("b", "al", 1.0, 2.0, 9), Region("c", "al", 2.5, 3.0, 30))
    assert np.flatnonzero(~found).tolist() == [*range(28), 43, 44, 45, *range(59, 79)]


def blocks(speed=(0.0, 0.0), material="al", sides=(), rows=30, apart=False):
    """Two blocks side by side, "a" of 60 and "b" of 36 columns; a moves."""
    shapes = [Box((0.0, 1.0), (0.0, 1.0)), Box((1.1 if apart else 1.0, 2.0), (0.0, 1.0))]
    parts = (Block2D("a", "al", shapes[0], (60, rows), velocity=VelocityField(base=speed)), Block2D("b", material, shapes[1], (36, rows)))
    found = forming(Problem2D("p", "plane", 1.0, parts, {"al": AL, "cu": CU}, boundaries=sides))
    return found[:60 * rows].reshape(60, rows), found[60 * rows:].reshape(36, rows)


@pytest.mark.parametrize("given", [dict(speed=(5.0, 0.0)), dict(material="cu")])
def test_a_joint_of_bodies_that_differ(given):
    a, b = blocks(**given)
    assert a[-START_UP:].all() and b[:START_UP].all() and not a[:-START_UP].any() and not b[START_UP:].any()


def test_a_joint_within_a_body_and_its_free_sides():
    a, b = blocks()
    assert not a.any() and not b.any()


def test_a_wall_that_a_block_moves_along_or_is_thrown_against():
    a, b = blocks((0.0, 5.0), sides=(Boundary2D(("a.left", "a.top", "a.bottom"), "wall"),))
    few = 30 // 3
    assert a[:-START_UP, -few:].all() and not a[:-START_UP, :-few].any() and b[:START_UP].all()


def test_every_side_of_bodies_that_may_meet():
    a, b = blocks(apart=True)
    few = 30 // 3
    assert not a[START_UP:-START_UP, few:-few].any() and a[:START_UP].all() and a[-START_UP:].all() and a[:, :few].all() and b[:, -few:].all()


def test_few_rows_are_left_alone():
    """Two rows of zones between walls, as of a line: nothing across them is a start."""
    a, _ = blocks((5.0, 0.0), sides=(Boundary2D(("a.top", "a.bottom", "b.top", "b.bottom"), "wall"),), rows=2)
    assert a[-START_UP:].all() and not a[:-START_UP].any()
