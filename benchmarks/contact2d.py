#!/usr/bin/env python3
"""Share of contact in the time of a step of the two-dimensional solver.

    python benchmarks/contact2d.py [name ...]

Alternates bursts of steps from the same state, with contact and with its calls left out (in which bodies pass through each other for
those few steps), on one core. Prints the median of the shares of pairs of bursts and that of the best bursts; only shares mean anything,
machines differ and are noisy. A share contains what contact takes from the cache of the passes over zones.
"""

import sys
import time
from pathlib import Path

import numpy as np

from hugoniot.problem.deck import read_deck, read_deck_text
from hugoniot.solvers.lagrange2d import layout as L
from hugoniot.solvers.lagrange2d.march import march
from hugoniot.solvers.lagrange2d.solver import Lagrange2D

EXAMPLES = Path(__file__).parents[1] / "examples"
STEPS, BURSTS = 20, 61
ALUMINIUM = "[material.al.eos]" + (EXAMPLES / "gap-disc.toml").read_text().split("[material.al.eos]")[1].split("[[gauge]]")[0]
LONG_LINE = """
geometry = "plane"
stop_time = "20 us"
[solver]
kind = "lagrange2d"
[[block]]
name = "a"
material = "al"
x = ["0 mm", "10 mm"]
y = ["0 mm", "5 mm"]
zones = [100, 50]
[[block]]
name = "b"
material = "al"
x = ["0 mm", "10 mm"]
y = ["5.01 mm", "10.01 mm"]
zones = [{zones}, 50]
velocity = ["0 m/s", "-300 m/s"]
""" + ALUMINIUM


def example(name):
    return read_deck(str(EXAMPLES / f"{name}.toml")).problem


PROBLEMS = {      # and the time at which they are taken
    "flyer-disc": (lambda: example("flyer-disc"), 1e-6),
    "gap-disc": (lambda: example("gap-disc"), 2.4e-6),
    "rod": (lambda: example("rod"), 20e-6),
    "100 zones on 100": (lambda: read_deck_text(LONG_LINE.format(zones=100), "line.toml").problem, 1e-6),
    "100 zones on 59": (lambda: read_deck_text(LONG_LINE.format(zones=59), "line.toml").problem, 1e-6),
}


def tables(run, found):
    """All arrays in nested tuples, each once."""
    for one in run:
        if isinstance(one, np.ndarray):
            if not any(one is other for other, _ in found):
                found.append((one, one.copy()))
        elif isinstance(one, tuple):
            tables(one, found)
    return found


def main():
    for name in [name for name in PROBLEMS if len(sys.argv) < 2 or any(word in name for word in sys.argv[1:])]:
        make, start = PROBLEMS[name]
        solver = Lagrange2D(make())
        solver.march(start, 10**7)
        solver.control[L.EVENT_TIME] = 1.0
        kept = tables((solver.run, solver.contact.tables, solver.plan, solver.control, solver.counters, solver._charge), [])
        runs = solver.run, solver.run._replace(touch=0)
        times = np.zeros((BURSTS, 2))
        for burst in times:
            for k, run in enumerate(runs):
                for table, values in kept:
                    table[...] = values
                begun = time.process_time()
                march(STEPS, run, solver.plan, solver.options, solver.control, solver.counters)
                burst[k] = (time.process_time() - begun) / STEPS
        whole, without = times[1:].T
        share, best = np.median(1.0 - without / whole), 1.0 - without.min() / whole.min()
        print(f"{name:22s} {100.0 * share:5.1f} % (of the best bursts {100.0 * best:.1f} %) of {1e6 * np.median(whole):.0f} us, "
              f"{len(solver.zones[0])} zones, {len(solver.contact.tables.points)} points", flush=True)


if __name__ == "__main__":
    main()
