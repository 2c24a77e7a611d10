"""Gauges on surfaces: their stress is the one applied there, whatever the zone beside them holds."""

import dataclasses

import lagrange_builders as build
import numpy as np
import pytest

from hugoniot.materials.material import Material
from hugoniot.problem.model import Boundary, Gauge, Problem, Pulse, Region, SolverOptions
from hugoniot.simulate import make_solver


def recorded(problem, stop):
    """(times, {gauge: {field: (n,)}}) of a run up to a time."""
    solver = make_solver(dataclasses.replace(problem, output=dataclasses.replace(problem.output, gauge_interval=stop / 200)))
    rows, events = [], []
    while solver.time < stop:
        events += solver.march(stop, 400)
        rows.append(solver.take_gauges())
    fields = {name: np.concatenate([found[name] for _, found in rows]) for name in rows[0][1]}
    names = [gauge.name for gauge in problem.gauges]
    return np.concatenate([times for times, _ in rows]), {n: {f: v[:, k] for f, v in fields.items()} for k, n in enumerate(names)}, events


@pytest.mark.parametrize("integrator", ["compatible", "wilkins"])
def test_a_free_surface_has_no_stress(integrator):
    """However it is named; of two bodies the faces that have separated too. The zone beside the surface shows 1 GPa in passing."""
    problem = build.flyer((20, 40), integrator=integrator)
    places = ("free surface left", "free surface right", "target:right", 6e-3, 4e-3, "flyer/target", "flyer:right", "target:left")
    problem = dataclasses.replace(problem, gauges=tuple(Gauge(str(at), at) for at in places))
    time, gauges, events = recorded(problem, 2e-6)
    for name in ("free surface left", "free surface right", "target:right", "0.006"):
        assert np.ptp(gauges[name]["velocity"]) > 300.0 and not gauges[name]["stress"].any(), name
        assert np.max(gauges[name]["pressure"]) > 0.5e9, name       # all else is that of the zone
    assert np.max(gauges["0.004"]["stress"]) > 5e9
    apart = next(event.time for event in events if event.kind == "interface_separated")
    for name in ("flyer/target", "flyer:right", "target:left"):
        stress = gauges[name]["stress"]
        assert np.max(stress[time < apart]) > 5e9 and not stress[time > 1.01 * apart].any(), name


@pytest.mark.parametrize("integrator", ["compatible", "wilkins"])
def test_a_driven_end_has_the_pressure_applied_to_it_and_a_wall_that_of_its_zone(integrator):
    pulse = Pulse("half_sine", amplitude=3.0, duration=0.3)
    problem = build.gas_tube(left=Boundary("pressure", pulse), stop=0.4, integrator=integrator)
    problem = dataclasses.replace(problem, gauges=(Gauge("driven", "free surface left"), Gauge("wall", "right:right")),
                                  solver=SolverOptions(integrator=integrator))
    time, gauges, _ = recorded(problem, 0.4)
    expected = np.where(time < 0.3, 3.0 * np.sin(np.pi * time / 0.3), 0.0)
    assert gauges["driven"]["stress"] == pytest.approx(expected, abs=1e-12)
    assert np.ptp(gauges["driven"]["velocity"]) > 0.1
    assert np.all(gauges["wall"]["stress"] >= gauges["wall"]["pressure"]) and np.min(gauges["wall"]["pressure"]) > 0.05     # with its q


@pytest.mark.parametrize("mode", ["algebraic", "cells"])
def test_tracked_fronts_record_the_same(mode):
    """A plate between a driven and a free end: the pressure of the drive, and nothing, behind shock and release."""
    plate = Region("plate", "al", 0.0, 1e-3, 10)
    places = ("free surface left", "free surface right", "plate:right", 1e-3)
    problem = Problem("plate", "planar", 4e-7, (plate,), {"al": Material("al", build.EOS)}, build.constant("pressure", 5e9), build.FREE,
                      gauges=tuple(Gauge(str(at), at) for at in places), solver=SolverOptions("fronts", options={"mode": mode}))
    _, gauges, _ = recorded(problem, 4e-7)
    assert gauges["free surface left"]["stress"][1:] == pytest.approx(5e9, rel=1e-9)
    for name in ("free surface right", "plate:right", "0.001"):
        assert not gauges[name]["stress"].any() and np.ptp(gauges[name]["velocity"]) > 500.0
