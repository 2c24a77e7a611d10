"""Problems of the one-dimensional solver that its tests share, and a watcher of a run.

Only a few combinations of laws, geometry and integrator are used here, because each is compiled once: a solid that yields and
spalls, and an ideal gas without strength.
"""

import dataclasses

import numpy as np

from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.laws.fracture.spall_stress import SpallStress
from hugoniot.laws.strength.perfectly_plastic import PerfectlyPlastic
from hugoniot.materials.material import Material
from hugoniot.problem.model import Boundary, Gauge, OutputOptions, Problem, Pulse, Region, SolverOptions
from hugoniot.simulate import make_solver
from hugoniot.solvers.run import Schedule, march_to_end, snapshot_times

EOS = MieGruneisen(2700.0, 5200.0, 1.5, 2.0)
STRENGTH = PerfectlyPlastic(24.8e9, 0.30e9)
SPALL = 1.0e9
GAS = Material("gas", IdealGas(1.4, 1.0, 1.0))
FREE, FIXED = Boundary("free"), Boundary("fixed")


def aluminium(spall=SPALL, name="al") -> Material:
    return Material(name, EOS, STRENGTH, SpallStress(spall))


def flyer(zones=(200, 400), speed=700.0, stop=2.5e-6, spall=SPALL, gap=0.0, geometry="planar", origin=0.0, **options) -> Problem:
    """The reference flyer, or a coarser one: 2 mm on 4 mm of aluminium, with gauges 1 and 2 mm into the target and on its surface."""
    a, b, c = origin, origin + 2e-3, origin + 2e-3 + gap
    regions = (Region("flyer", "al", a, b, zones[0], velocity=speed), Region("target", "al", c, c + 4e-3, zones[1]))
    gauges = (Gauge("1 mm", c + 1e-3), Gauge("2 mm", c + 2e-3), Gauge("surface", "free surface right"))
    return Problem("flyer", geometry, stop, regions, {"al": aluminium(spall)}, gauges=gauges, solver=SolverOptions(**options),
                   output=OutputOptions(report=False))


def gas_tube(zones=(60, 40), geometry="planar", left=FIXED, right=FIXED, stop=0.2, velocity=0.0, **options) -> Problem:
    """A shock tube of an ideal gas between 1 and 2 (no axis in curved geometry)."""
    regions = (Region("left", "gas", 1.0, 1.6, zones[0], velocity=velocity, density=1.0, pressure=1.0),
               Region("right", "gas", 1.6, 2.0, zones[1], velocity=velocity, density=0.125, pressure=0.1))
    from hugoniot.problem.standard.parts import bonded
    return Problem("tube", geometry, stop, regions, {"gas": GAS}, left, right, bonded(regions), solver=SolverOptions(**options),
                   output=OutputOptions(report=False))


def constant(kind, value) -> Boundary:
    return Boundary(kind, Pulse("constant", amplitude=value))


def changed(problem, **solver) -> Problem:
    """The problem with other solver options."""
    return dataclasses.replace(problem, solver=dataclasses.replace(problem.solver, **solver))


class Watcher:
    """Collects what the time loop tells: gauge records, events, snapshots, reports, checkpoints."""

    def __init__(self, keep_snapshots=False):
        self.times, self.records, self.events, self.states, self.payloads = [], {}, [], [], []
        self.keep = keep_snapshots
        self.worst = {"mass_error": 0.0, "momentum_error": 0.0, "energy_error": 0.0}

    def gauges(self, times, values):
        self.times.append(times)
        for name, block in values.items():
            self.records.setdefault(name, []).append(block)

    def snapshot(self, state):
        if self.keep:
            self.states.append(state)

    def event(self, event):
        self.events.append(event)

    def checkpoint(self, payload):
        self.payloads.append(payload)

    def record(self, field, gauge):
        """(times, values) of one gauge."""
        return np.concatenate(self.times), np.concatenate(self.records[field])[:, gauge]


def run(problem, watcher=None, snapshots=10, **schedule):
    """(solver at the end, watcher) of a problem."""
    solver, watcher = make_solver(problem), watcher or Watcher()
    march_to_end(solver, Schedule(problem.stop_time, snapshot_times(problem.stop_time, None, snapshots), **schedule), (watcher,))
    return solver, watcher


def march_cycles(solver, cycles, until=None):
    """March a number of cycles through whatever events come; the events."""
    events, end = [], solver.cycle + cycles
    while solver.cycle < end:
        before = solver.cycle
        events += solver.march(until or solver.problem.stop_time, end - solver.cycle)
        solver.take_gauges()
        if solver.cycle == before:      # the stop time is reached
            break
    return events
