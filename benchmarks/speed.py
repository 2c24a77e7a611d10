#!/usr/bin/env python3
"""Speed of the one-dimensional solver, printed as rates and as ratios taken in one run.

    python benchmarks/speed.py                        # rates, geometry ratios, gauges, threads
    python benchmarks/speed.py --yardstick FOLDER     # and against the C yardstick of that folder (kernels/yardstick.py)

Two elastic-plastic Mie-Grüneisen materials, flyer on target, as the yardstick's scheme A. Every figure is the best of several
repeats, and what is compared alternates, so that a drift of the machine's speed falls on both.
"""

import argparse
import pathlib
import sys
import time

from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.laws.strength.perfectly_plastic import PerfectlyPlastic
from hugoniot.materials.material import Material
from hugoniot.problem.model import Gauge, Problem, Region, SolverOptions
from hugoniot.solvers.lagrange1d.solver import Lagrange1D

ALUMINIUM = Material("aluminium", MieGruneisen(2700.0, 5323.0, 1.34, 2.1), PerfectlyPlastic(27.6e9, 0.3e9))
COPPER = Material("copper", MieGruneisen(8930.0, 3960.0, 1.49, 2.0), PerfectlyPlastic(47.7e9, 0.12e9))
REPEATS = 9


def impact(zones, integrator, geometry="planar", gauges=0, threads=1):
    """Aluminium on copper at 1 km/s in 2 cm, long before any wave leaves."""
    start = 0.0 if geometry == "planar" else 0.05
    places = tuple(Gauge(f"gauge {k}", start + 0.012 + 0.0005 * k) for k in range(gauges))
    regions = (Region("flyer", "al", start, start + 0.01, zones // 2, velocity=1000.0),
               Region("target", "cu", start + 0.01, start + 0.02, zones - zones // 2))
    return Problem("impact", geometry, 1e-3, regions, {"al": ALUMINIUM, "cu": COPPER}, gauges=places,
                   solver=SolverOptions(integrator=integrator, threads=threads))


class Timed:
    """A problem marched in equal bursts; keeps its best rate."""

    def __init__(self, name, zones, *args, **kwargs):
        self.name, self.best = name, 0.0
        self.problem, self.cycles = impact(zones, *args, **kwargs), max(60, 1_500_000 // zones)
        solver = Lagrange1D(self.problem)
        solver.march(1e-3, 3)

    def burst(self):
        solver = Lagrange1D(self.problem)
        before, begun = solver.zone_updates, time.perf_counter()
        done = 0
        while done < self.cycles:
            cycle = solver.cycle
            solver.march(1e-3, self.cycles - done)
            solver.take_gauges()
            done += solver.cycle - cycle
        self.best = max(self.best, (solver.zone_updates - before) / (time.perf_counter() - begun) / 1e6)


class Yardstick:
    """Scheme A of the C yardstick on the same number of zones."""

    def __init__(self, module, library, zones):
        self.name, self.best = f"C yardstick {zones}", 0.0
        self.module, self.library, self.zones, self.cycles = module, library, zones, max(60, 1_500_000 // zones)

    def burst(self):
        seconds = self.module.run_a(self.library, self.zones, self.cycles, self.module.init_a(self.zones))
        self.best = max(self.best, self.zones * self.cycles / seconds / 1e6)


def compare(*timed):
    """Run every candidate in turn, several times."""
    for _ in range(REPEATS):
        for one in timed:
            one.burst()
    return [one.best for one in timed]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--yardstick", help="folder of yardstick.py and yardstick.c")
    folder = parser.parse_args().yardstick
    yard = None
    if folder:
        sys.path.insert(0, str(pathlib.Path(folder).resolve()))
        import yardstick
        yard = yardstick, yardstick.library()
    print("rates in M zone updates/s, one core")
    for zones in (1000, 10_000):
        runs = [Timed(f"{integrator} {zones}", zones, integrator) for integrator in ("wilkins", "compatible")]
        runs += [Yardstick(*yard, zones)] if yard else []
        rates = compare(*runs)
        for run, rate in zip(runs, rates):
            ratio = f"  {rate / rates[-1]:5.2f} of C" if yard and run is not runs[-1] else ""
            print(f"  {run.name:24s} {rate:7.1f}{ratio}")
    for integrator in ("wilkins", "compatible"):
        runs = [Timed(g, 1000, integrator, g) for g in ("planar", "cylindrical", "spherical")]
        planar, *curved = compare(*runs)
        print(f"  {integrator}: cylindrical {curved[0] / planar:.2f}, spherical {curved[1] / planar:.2f} of planar")
    for integrator in ("wilkins", "compatible"):
        without, with_one = compare(Timed("", 1000, integrator), Timed("", 1000, integrator, gauges=1))
        print(f"  {integrator}: a gauge on every step costs {100 * (without / with_one - 1):.1f} %")
    for zones in (10_000, 100_000):
        one, two = compare(Timed("", zones, "compatible"), Timed("", zones, "compatible", threads=2))
        print(f"  compatible {zones}: two threads {two / one:.2f} times one")


if __name__ == "__main__":
    main()
