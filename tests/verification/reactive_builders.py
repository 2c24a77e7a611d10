"""Burning problems the detonation tests share, and a watcher of their runs."""

import dataclasses

import numpy as np

from hugoniot.diagnostics import detonation
from hugoniot.laws.burn.programmed import Programmed
from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.materials import library
from hugoniot.materials.material import Material
from hugoniot.problem.model import Boundary, Lighting, OutputOptions, Problem, Pulse, Region
from hugoniot.simulate import make_solver
from hugoniot.solvers.run import Schedule, march_to_end, snapshot_times

QUIET = OutputOptions(report=False)
PENTOLITE_SPEED, PENTOLITE_HEAT = 7991.0, 7991.0**2 / (2.0 * (2.77**2 - 1.0))   # H-5: beta = 2.77, E0 = 4.7847 MJ/kg
PENTOLITE = IdealGas(2.77, 1000.0, 1714.0)
PENTOLITE_CJ = 1714.0 * 3.77 / 2.77


class Watcher:
    """Keeps states, events and the largest energy error at a snapshot."""

    def __init__(self, solver):
        self.solver, self.states, self.events, self.energy_error = solver, [], [], 0.0

    def snapshot(self, state):
        self.states.append(state)
        self.energy_error = max(self.energy_error, self.solver.errors()["energy_error"])

    def event(self, event):
        self.events.append(event)

    @property
    def times(self):
        return np.array([state.time for state in self.states])

    def field(self, name):
        return np.array([state.zones[name] for state in self.states])

    def velocity(self, side):
        """Velocity of the outermost face on a side."""
        return np.array([state.velocity_left[0] if side == "left" else state.velocity_right[-1] for state in self.states])

    def path(self, name="burn_fraction", level=0.5, toward="right"):
        left, right = (np.array([getattr(state, f"position_{side}") for state in self.states]) for side in ("left", "right"))
        return detonation.front_path(self.field(name), left, right, level, toward)


def run(problem, snapshots=20):
    """(solver at the end, watcher)."""
    solver = make_solver(problem)
    watcher = Watcher(solver)
    march_to_end(solver, Schedule(problem.stop_time, snapshot_times(problem.stop_time, None, snapshots)), (watcher,))
    return solver, watcher


def charge(material, length=0.04, zones=400, geometry="planar", inner=0.0, lit=(0.0,), part=0.9, left="fixed") -> Problem:
    """A single charge lit at `lit`, run until its front has crossed `part` of it."""
    speed = material.burn.detonation_velocity
    region = Region("charge", material.name, inner, inner + length, zones)
    return Problem("charge", geometry, part * length / speed, (region,), {material.name: material}, Boundary(left), Boundary("free"),
                   lighting=tuple(Lighting(at) for at in lit), output=QUIET)


def comp_b() -> Material:
    return dataclasses.replace(library.find("comp_b"), name="comp_b")


def gamma_explosive(gamma=3.0, speed=8000.0, rho0=1600.0, burn=None) -> Material:
    """Products of one exponent whose heat gives the CJ velocity named."""
    return Material("gas", IdealGas(gamma, 1000.0, rho0), burn=burn or Programmed(speed),
                    detonation_energy=speed**2 / (2.0 * (gamma**2 - 1.0)))


def driven(material, length, zones, velocity, stop, energy=None) -> Problem:
    """A charge pushed from the left: `velocity` is a number or (times, values)."""
    pulse = Pulse("table", times=tuple(velocity[0]), values=tuple(velocity[1])) if isinstance(velocity, tuple) else Pulse(
        "constant", amplitude=velocity)
    region = Region("charge", material.name, 0.0, length, zones, energy=energy)
    return Problem("driven", "planar", stop, (region,), {material.name: material}, Boundary("velocity", pulse), Boundary("free"),
                   output=QUIET)
