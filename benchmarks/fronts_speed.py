#!/usr/bin/env python3
"""Tracked fronts beside `lagrange1d`: processor time of the march for a given error, in Sod's tube and at the spike of a reaction zone.

    python benchmarks/fronts_speed.py

The solvers take turns; the best of the repetitions counts. The spike is the pressure behind the lead shock of the steady zone of
gamma = 1.2, Q = 50, E = 20, f = 1.6, started by a piston that moves as the material behind the front, after 8.6 half-reaction lengths.
"""

import dataclasses
import sys
import time
from pathlib import Path
from types import MappingProxyType

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "verification"))

from steady_zone import SteadyZone, material_of

from hugoniot.problem.model import Boundary, Problem, Pulse, Region, SolverOptions
from hugoniot.problem.standard import gases
from hugoniot.simulate import make_solver
from hugoniot.theory import riemann
from hugoniot.theory.isentrope import state
from hugoniot.theory.stability import Wave

ALGEBRAIC, LAGRANGE = SolverOptions("fronts"), SolverOptions("lagrange1d")
DAMPED = SolverOptions("lagrange1d", viscosity=("limited", {"linear": 1.0, "quadratic": 1.0}))


def cells(courant=None, **options):
    return SolverOptions("fronts", courant=courant, options=MappingProxyType({"mode": "cells", **options}))


def marched(problem):
    """(processor time of the march in s, solver)."""
    solver = make_solver(problem)
    start = time.process_time()
    while solver.time < problem.stop_time:
        solver.march(problem.stop_time, 10**9)
    return time.process_time() - start, solver


def tube(zones, how):
    return dataclasses.replace(gases.build_sod(zones), solver=how)


def tube_error(solver):
    """L1 error of the density over the length, cell by cell (of the algebraic mode and of lagrange1d by zones)."""
    regions, law = solver.problem.regions, solver.problem.materials[solver.problem.regions[0].material].eos
    ends = [state(law, density=r.density, pressure=r.pressure, velocity=r.velocity) for r in regions]
    exact = riemann.riemann(law, ends[0], law, ends[1])
    if hasattr(solver, "mesh"):
        left, right = solver.mesh.x[:-1], solver.mesh.x[1:]
        rho = solver.mesh.q[:, 0] / (right - left)
    else:
        now = solver.state()
        left, right, rho = now.position_left, now.position_right, now.zones["density"]
    x = left[:, None] + (right - left)[:, None] * (np.arange(40) + 0.5) / 40
    wanted = exact(x - regions[0].end, solver.time)["density"].mean(axis=1)
    return float((np.abs(wanted - rho) * (right - left)).sum() / (right[-1] - left[0]))


WAVE = Wave(1.2, 50.0, 20.0, 1.6)
ZONE = SteadyZone(WAVE)


def driven(per_half_length, how, stop=1.0):
    kept = np.unique(np.searchsorted(ZONE.s, np.geomspace(1e-3, 24.0, 800)))
    kept = np.concatenate([[0], kept[ZONE.time[kept] < 2.0 * stop]])
    length = WAVE.velocity * stop + 2.0
    region = Region("gas", "gas", 0.0, length, round(per_half_length * length), density=1.0, pressure=1.0)
    pulse = Pulse("table", times=tuple(ZONE.time[kept]), values=tuple(ZONE.velocity[kept]))
    return Problem("overdriven", "planar", stop, (region,), {"gas": material_of(WAVE)}, Boundary("velocity", pulse), Boundary("fixed"),
                   solver=how)


def spike_error(solver):
    """Pressure behind the lead shock over that of the steady zone, less one; of lagrange1d the highest pressure."""
    if hasattr(solver, "mesh"):
        lead = [front for front in solver.mesh.fronts if front.kind == "shock"][-1]
        pressure = (2.0 * lead.speed**2 - (WAVE.gamma - 1.0)) / (WAVE.gamma + 1.0)
    else:
        pressure = float(solver.state().zones["pressure"].max())
    return pressure / ZONE.pressure[0] - 1.0


def table(title, runs, error, repetitions):
    times = {name: [] for name in runs}
    for _ in range(repetitions):
        for name, problem in runs.items():
            took, solver = marched(problem)
            times[name].append(took)
    print(title)
    for name, problem in runs.items():
        print(f"  {name:58s} {1e3 * min(times[name]):9.3f} ms   error {error(marched(problem)[1]):.2e}")


if __name__ == "__main__":
    coarse = {f"cells, {n} zones, fan_step 0.2, courant 0.8": tube(n, cells(0.8, fan_step=0.2)) for n in (2, 4)}
    table("Sod's tube", {"algebraic (exact), read by 540 zones": tube(540, ALGEBRAIC), **coarse, "cells, 5 zones": tube(5, cells()),
                         "lagrange1d, 540 zones": tube(540, LAGRANGE)}, tube_error, 40)
    table("Sod's tube, finer", {"cells, 5 zones": tube(5, cells()), "lagrange1d, 4600 zones": tube(4600, LAGRANGE)}, tube_error, 3)
    table("spike of a reaction zone", {f"cells, {n} zones in a half-reaction length": driven(n, cells()) for n in (3, 6)}
          | {f"lagrange1d, {n} zones in a half-reaction length": driven(n, LAGRANGE) for n in (40, 80, 160)}
          | {f"lagrange1d, linear = 1, {n} zones in a half-reaction length": driven(n, DAMPED) for n in (20, 30, 40, 80)}, spike_error, 3)
