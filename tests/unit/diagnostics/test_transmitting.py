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


def impact(thickness, length, strength, mirrored=False, stop=4e-6):
    """A flyer of LiF that hits LiF at 500 m/s, with a transmitting end behind it."""
    spans = ((-thickness, 0.0, 500.0), (0.0, length, 0.0))
    if mirrored:
        spans = tuple((-b, -a, -v) for a, b, v in reversed(spans))
    regions = tuple(Region(str(k), "lif", a, b, 50, velocity=v) for k, (a, b, v) in enumerate(spans))
    return Problem("impact", "planar", stop, regions, {"lif": Material("lif", FLUORIDE, strength)}, **{"left" if mirrored else "right": END})


@pytest.mark.parametrize("mirrored", [False, True])
def test_check_foresees_the_echo_of_a_shock_overtaken_beyond_the_end(mirrored):
    """By hand: us = 5488 m/s, 3.70 GPa + 2 Y/3; bulk modulus about 83.1 GPa, density 2766 kg/m3, longitudinal impedance 20.3e6 kg/m2/s."""
    strength = PerfectlyPlastic(49e9, 0.36e9)
    words, = expected(impact(2e-3, 8e-3, strength, mirrored))
    release, behind, wave = 0.36e9 * (83.1 / 49.0 + 4.0 / 3.0), 2.0 * 2640.0 * 5487.5 - 2640.0 * 5150.0, 2640.0 * 5487.5 * 250.0 + 0.24e9
    part = release * (20.3e6 - behind) / (20.3e6 + behind) / wave
    assert f"up to {part:.0%} of" in words and ("left" if mirrored else "right") in words
    # no strength; overtaken before the end; never overtaken in the time of the run; no time to come back
    for quiet in (impact(2e-3, 8e-3, None), impact(2e-3, 20e-3, strength), impact(12e-3, 8e-3, strength), impact(2e-3, 8e-3, strength, stop=2e-6)):
        assert not expected(quiet)
