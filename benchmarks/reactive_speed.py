#!/usr/bin/env python3
"""Speed of the one-dimensional solver in burning zones: ns of one core for a zone-step, by closure and by how much has burned.

    python benchmarks/reactive_speed.py

LX-17, ignition and growth, both phases JWL, 1000 zones. The whole charge starts compressed by 30 %, so that all of it ignites at once,
and a piston sends a shock through it: every zone is partly burned all the time until the last burst. `unburned` and `burned` are the same
charge with its rate at 0 and after burning has ended. A burst is 40 steps; of each the best of several runs counts, in processor time.
"""

import dataclasses
import time

from hugoniot.materials import library
from hugoniot.problem.model import Boundary, OutputOptions, Problem, Pulse, Region
from hugoniot.simulate import make_solver
from hugoniot.solvers.lagrange1d.layout import B

CLOSURES = ("thermal_isolation", "thermal_equilibrium", "weighted_pressures")
ZONES, BURST, BURSTS, REPEATS, FOREVER = 1000, 40, 40, 5, 1e-3


def charge(closure, burns=True):
    """2 cm of LX-17 at 1.3 times its density behind a piston of 300 m/s."""
    explosive = dataclasses.replace(library.find("LX-17 reactive"), name="explosive", mixture=closure)
    if not burns:
        explosive = dataclasses.replace(explosive, burn=explosive.burn._replace(i=0.0))
    region = Region("charge", "explosive", 0.0, 0.02, ZONES, density=1.3 * explosive.burn.rho0)
    piston = Boundary("velocity", Pulse("constant", amplitude=300.0))
    return Problem("burning", "planar", FOREVER, (region,), {"explosive": explosive}, piston, Boundary("fixed"),
                   output=OutputOptions(report=False))


def bursts(problem):
    """(mean burn fraction at its start, share of zones partly burned at its end, best ns per zone-step) of every burst."""
    best = {}
    for _ in range(REPEATS):
        solver = make_solver(problem)
        solver.march(FOREVER, 3)
        for k in range(BURSTS):
            at_start, updates, begun = solver.charge[B.lam].mean(), solver.zone_updates, time.process_time()
            solver.march(FOREVER, BURST)
            took = 1e9 * (time.process_time() - begun) / (solver.zone_updates - updates)
            lam = solver.charge[B.lam]
            best[k] = at_start, ((lam > 0.0) & (lam < 1.0)).mean(), min(took, best.get(k, (0.0, 0.0, took))[2])
    return list(best.values())


def main():
    print("ns of one core for a zone-step (M zone-steps/s)")
    print(f"  {'closure':20s} {'unburned':>14s} {'partly burned':>14s} {'whole burn':>14s} {'burned':>14s}")
    for closure in CLOSURES:
        still, burning = bursts(charge(closure, False)), bursts(charge(closure))
        # all zones partly burned, their ignition over; and from the first ignition until no zone burns any more
        partly = [ns for lam, share, ns in burning if share == 1.0 and lam > 0.01]
        burn = [ns for lam, share, ns in burning if lam < 1.0]
        figures = min(ns for *_, ns in still), sum(partly) / len(partly), sum(burn) / len(burn), min(ns for *_, ns in burning)
        print(f"  {closure:20s} " + " ".join(f"{ns:7.1f} ({1e3 / ns:4.0f})" for ns in figures))


if __name__ == "__main__":
    main()
