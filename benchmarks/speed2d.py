#!/usr/bin/env python3
"""Rate of the two-dimensional solver beside the C yardstick (scheme B, 2-D quadrilaterals with strength), in one run.

    python benchmarks/speed2d.py PATH/TO/yardstick.py [zones per side]
    python benchmarks/speed2d.py threads [zones per side]

The first prints M zone-updates/s of one core for both, and their ratio; only the ratio means anything, machines differ and are noisy.
The second prints how much faster two threads are than one, taking turns: the median and the extremes of fifteen marches. It needs a
machine that does nothing else, since a team of threads gives way to other processes.
"""

import importlib.util
import statistics
import sys
import time
from dataclasses import replace

from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.laws.strength.perfectly_plastic import PerfectlyPlastic
from hugoniot.materials.material import Material
from hugoniot.mesh.shapes import Box
from hugoniot.problem.plane.model import Block2D, Boundary2D, Problem2D, VelocityField
from hugoniot.solvers.lagrange2d.solver import Lagrange2D


def plate(n, threads=1):
    """A square of aluminium that runs into a wall."""
    material = Material("al", MieGruneisen(2700.0, 5200.0, 1.5, 2.0), PerfectlyPlastic(24.8e9, 0.30e9))
    block = Block2D("b", "al", Box((0.0, 1.0), (0.0, 1.0)), (n, n), velocity=VelocityField(base=(0.0, -300.0)))
    problem = Problem2D("bench", "plane", 1.0, (block,), {"al": material}, (Boundary2D(("b.bottom",), "wall"),))
    return replace(problem, solver=replace(problem.solver, threads=threads))


def compare_threads(n):
    """Print how much faster two threads are than one."""
    steps, solvers, ratios = 4_000_000 // n**2, [Lagrange2D(plate(n, threads)) for threads in (1, 2)], []
    for turn in range(16):
        spent = []
        for solver in solvers:
            begun = time.perf_counter()
            solver.march(1.0, steps)
            spent.append(time.perf_counter() - begun)
        ratios += [spent[0] / spent[1]] if turn else []
    print(f"{n} x {n}: two threads are {statistics.median(ratios):.2f} times as fast as one ({min(ratios):.2f} to {max(ratios):.2f})")


def main():
    if sys.argv[1] == "threads":
        return compare_threads(int(sys.argv[2]) if len(sys.argv) > 2 else 256)
    spec = importlib.util.spec_from_file_location("yardstick", sys.argv[1])
    yardstick = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(yardstick)
    n = int(sys.argv[2]) if len(sys.argv) > 2 else 256
    library, solver = yardstick.library(), Lagrange2D(plate(n))
    solver.march(1.0, 2)
    ours = theirs = 0.0
    for _ in range(7):
        begun = time.process_time()
        solver.march(1.0, 6)
        ours = max(ours, 6 * n * n / (time.process_time() - begun) / 1e6)
        theirs = max(theirs, 24 * n * n / yardstick.run_b(library, n, n, 24, yardstick.init_b(n, n)) / 1e6)
    print(f"lagrange2d {ours:.2f}, C {theirs:.2f} M zone-updates/s, ratio {ours / theirs:.3f}; "
          f"{sum(table.nbytes for table in (solver.zones, solver.nodes, solver.forces, solver.run.gradients)) / n / n:.0f} bytes a zone")


if __name__ == "__main__":
    main()
