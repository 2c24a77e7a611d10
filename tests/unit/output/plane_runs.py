"""A two-dimensional run that no solver made: two blocks in a uniform motion whose every number is known."""

import numpy as np

from hugoniot.diagnostics.gauges2d import Sampler
from hugoniot.output.plane_record import PlaneRecorder, plane_meta
from hugoniot.output.run_folder import RunFolder
from hugoniot.plotting import load
from hugoniot.problem.deck import read_deck_text
from hugoniot.solvers.protocol import NothingToAdd
from hugoniot.state import State2D

DECK = """\
title = "Rod and sleeve"
geometry = "axisymmetric"
stop_time = "10 us"

[[block]]
name = "rod"
material = "copper"
r = ["0 mm", "2 mm"]
z = ["0 mm", "10 mm"]
zones = [4, 10]

[[block]]
name = "sleeve"
material = "aluminum_6061"
r = ["2 mm", "5 mm"]
z = ["0 mm", "10 mm"]
zones = [5, 10]

[[boundary]]
on = "rod.bottom"
kind = "wall"
[[boundary]]
on = "sleeve.top"
kind = "pressure"
pressure = "1 GPa"

[[gauge]]
name = "inside"
at = ["1.25 mm", "4.5 mm"]
[[gauge]]
name = "end"
on = "rod.top"
[[gauge]]
name = "glue"
on = "rod/sleeve"
[[gauge]]
name = "streak"
on = "sleeve.right"
through = ["0 mm", "5 mm"]
direction = [1, 0]

[solver]
kind = "lagrange2d"
[output]
snapshots = "2 us"
"""

STRETCH, GROWTH = 2.0e4, 1.0e4      # 1/s: z grows as 1 + STRETCH t, r as 1 + GROWTH t; z also slides by TILT r
TILT = 300.0                        # 1/s: v_z gains TILT r


def motion(mesh, time):
    """Node fields at a time."""
    r, z = mesh.nodes
    return {"position_x": r * (1.0 + GROWTH * time), "position_y": z * (1.0 + STRETCH * time) + TILT * time * r,
            "velocity_x": GROWTH * r, "velocity_y": STRETCH * z + TILT * r}


class Moving(NothingToAdd):
    """Stands for a solver: states, errors and exchanges of the motion."""

    def __init__(self, problem):
        self.problem, self.time, self.cycle, self.step = problem, 0.0, 0, 1e-8
        centre = problem.mesh.nodes[:, problem.mesh.zone_nodes].mean(axis=2)
        self.mass = 8930.0 * centre[0] * 0.5e-3 * 1e-3

    def state(self):
        mesh, t = self.problem.mesh, self.time
        centre = mesh.nodes[:, mesh.zone_nodes].mean(axis=2)
        zones = {"density": np.full(len(mesh.zone_nodes), 8930.0), "energy": np.full(len(mesh.zone_nodes), 1e3 * t),
                 "pressure": 1e12 * centre[1] * (t + 1e-6), "mass": self.mass}
        return State2D(t, self.cycle, zones, motion(mesh, t), mesh.zone_nodes)

    def errors(self):
        return {"mass_error": 0.0, "momentum_error": 1e-14, "energy_error": 1e-15}

    def exchanges(self):
        return {f"work {name}": self.time for name in self.problem.mesh.chains}

    def all_zones(self):
        return self.state().zones

    def kinetic_energy(self):
        return 5.0

    def peaks(self):
        return {"peak_pressure": self.state().zones["pressure"]}


def record(folder, text=DECK, times=(0.0, 2e-6, 4e-6, 10e-6)):
    """Write the run into a folder and load it."""
    deck = read_deck_text(text)
    problem, solver = deck.problem, Moving(deck.problem)
    place = RunFolder(folder)
    place.start(problem, deck.resolved, plane_meta(problem, solver, "test"))
    recorder, sampler = PlaneRecorder(place, problem, solver), Sampler(problem)
    for cycle, time in enumerate(times):
        solver.time, solver.cycle = time, cycle
        rows = sampler(solver.state())
        recorder.gauges(np.array([time]), {name: values[None, :] for name, values in rows.items()})
        recorder.snapshot(solver.state())
    place.finish({"cycles": len(times), "time": times[-1], "wall_seconds": 1.0, "kernel_seconds": 0.5, "zone_updates": 10,
                  "voids_opened": 0, "voids_closed": 0, **solver.errors()}, solver.peaks())
    return load(folder)
