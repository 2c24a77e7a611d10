"""The record of a gauge on the face where two bodies meet begins with the velocity of that face, not with that of one of them."""

import numpy as np
import pytest

from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.materials.material import Material
from hugoniot.problem.model import Gauge, Problem, Region, SolverOptions
from hugoniot.simulate import make_solver

METAL = Material("al", MieGruneisen(2703.0, 5350.0, 1.34, 1.97))


def first_times(first, second, at="flyer/target"):
    solver = make_solver(Problem("faces", "planar", 1e-8, (first, second), {"al": METAL}, gauges=(Gauge("face", at),),
                                 solver=SolverOptions("fronts", options={"mode": "cells"})))
    solver.march(1e-9, 1000)
    return solver.take_gauges()[0]


def test_the_first_record_is_left_out_only_where_two_bodies_strike_each_other():
    target = Region("target", "al", 2e-3, 6e-3, 40)
    assert first_times(Region("flyer", "al", 0.0, 2e-3, 20), target)[0] == 0.0                      # at rest together
    assert first_times(Region("flyer", "al", 0.0, 2e-3, 20, velocity=(700.0, 0.0)), target)[0] == 0.0
    assert first_times(Region("flyer", "al", 0.0, 1e-3, 20, velocity=700.0), target, "flyer:right")[0] == 0.0      # a gap lies between
    assert first_times(Region("flyer", "al", 0.0, 2e-3, 20, velocity=700.0), target)[0] > 0.0


@pytest.mark.parametrize("mode", ["algebraic", "cells"])
def test_an_impact_face_has_one_velocity_from_its_first_record_on(mode):
    regions = Region("flyer", "al", 0.0, 2e-3, 20, velocity=700.0), Region("target", "al", 2e-3, 6e-3, 40)
    asked = Problem("impact", "planar", 1e-7, regions, {"al": METAL}, gauges=(Gauge("face", "flyer/target"),),
                    solver=SolverOptions("fronts", options={"mode": mode}))
    solver = make_solver(asked)
    while solver.time < 1e-7:
        solver.march(1e-7, 1000)
    times, found = solver.take_gauges()
    assert len(times) > 10 and np.allclose(found["velocity"], 350.0, rtol=1e-9)
