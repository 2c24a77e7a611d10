"""Warnings of transmitting ends: none for plane waves, one where a curved wave may come back, and only if it got there."""

import dataclasses

import numpy as np
import pytest

from hugoniot.diagnostics.transmitting import expected, measured
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.laws.strength.perfectly_plastic import PerfectlyPlastic
from hugoniot.materials.material import Material
from hugoniot.problem.model import Boundary, Problem, Region

FLUORIDE = MieGruneisen(2640.0, 5150.0, 1.35, 1.6)
END = Boundary("transmitting")


def body(geometry, strength=None, **ends):
    region = Region("body", "lif", 2e-3, 5e-3, 30)
    return Problem("body", geometry, 1e-6, (region,), {"lif": Material("lif", FLUORIDE, strength)}, **ends)


def test_plane_ends_and_ends_that_transmit_nothing_are_not_warned_of():
    assert not expected(body("planar", left=END, right=END)) and not measured(body("planar", right=END), np.full(30, 20e9))
    assert not expected(body("spherical")) and not measured(body("spherical"), np.full(30, 20e9))


@pytest.mark.parametrize("strength, part", [(None, "8%"), (PerfectlyPlastic(49e9, 0.36e9), "11%")])
def test_a_strong_wave_at_a_curved_end_is_warned_of(strength, part):
    problem = body("spherical", strength, right=END)
    assert len(expected(problem)) == 1 and f"up to {part}" in expected(problem)[0]
    assert measured(problem, np.full(30, 20e9)) == expected(problem) and not measured(problem, np.full(30, 1e6))


def test_the_end_that_faces_the_axis_has_words_of_its_own():
    problem = body("cylindrical", left=END)
    assert len(expected(problem)) == 1 and "converging" in expected(problem)[0]
    solid = dataclasses.replace(problem, regions=(dataclasses.replace(problem.regions[0], start=0.0),))
    assert not expected(solid)
