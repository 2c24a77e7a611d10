"""What a second thread gains on an idle machine, and costs on one that is busy with other work (at most a fifth more time).

    python benchmarks/busy_threads.py [--zones 20000] [--others 2] [--rounds 60]

`--others` processes keep the cores busy (0: none). Runs of the same deck, of one and of two threads, take turns of a tenth of a second in
random order, so that both see the same machine: the scheduler hands out more time in one turn than in another, and only sums over many
turns can be compared. There are three runs of each kind: where in memory a run's tables happen to lie may matter. Printed: the ratio of the
times of two threads to one, its spread over tenths of the turns, the ratio of the processor times, and how many processors were busy with
anything else (Linux).
"""

import argparse
import subprocess
import sys
import time
from pathlib import Path

import numpy as np

from hugoniot.problem.deck import read_deck_text
from hugoniot.simulate import make_solver

DECK = """stop_time = "1 ms"
[[region]]
name = "flyer"
material = "copper"
from = "0 mm"
to = "20 mm"
zones = {0}
velocity = "300 m/s"
[[region]]
name = "target"
material = "copper"
from = "20 mm"
to = "60 mm"
zones = {0}
[solver]
threads = {1}
"""
SPIN = "while True: pass"
TURN = 0.1          # s
STAT = Path("/proc/stat")


def busy_seconds() -> float:
    """Processor time of the whole machine so far, s; NaN where it cannot be read."""
    if not STAT.exists():
        return float("nan")
    ticks = [int(word) for word in STAT.read_text().splitlines()[0].split()[1:]]
    return (sum(ticks) - ticks[3] - ticks[4] - ticks[7]) / 100.0


def turn(solver, cycles: int) -> tuple[float, float]:
    """(wall, processor) time of some cycles, s."""
    wall, used = time.perf_counter(), time.process_time()
    solver.march(1.0, cycles)
    return time.perf_counter() - wall, time.process_time() - used


def main() -> None:
    words = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    for name, number in (("zones", 20_000), ("others", 2), ("rounds", 60)):
        words.add_argument(f"--{name}", type=int, default=number)
    asked = words.parse_args()
    runs = [make_solver(read_deck_text(DECK.format(asked.zones // 2, threads)).problem) for threads in (1, 2, 2, 1, 1, 2)]
    for solver in runs:
        solver.march(1.0, 20)
    pairs = [sorted(runs[k:k + 2], key=lambda solver: solver.problem.solver.threads) for k in (0, 2, 4)]
    cycles = max(int(20 * TURN / turn(runs[0], 20)[0]), 1)
    order = np.random.default_rng(1)
    busy = [subprocess.Popen([sys.executable, "-c", SPIN]) for _ in range(asked.others)]
    before, began, mine = busy_seconds(), time.perf_counter(), time.process_time()
    try:
        each = np.zeros((asked.rounds, 2, 2))        # (round, threads, wall or used)
        for k in range(asked.rounds):
            for which in order.permutation(2):
                each[k, which] = turn(pairs[k % 3][which], cycles)
    finally:
        others = (busy_seconds() - before - time.process_time() + mine) / (time.perf_counter() - began)
        for process in busy:
            process.kill()
    wall, used = each.sum(axis=0).T
    parts = [part[:, 1, 0].sum() / part[:, 0, 0].sum() for part in np.array_split(each, min(10, asked.rounds))]
    print(f"{asked.zones} zones, {asked.rounds} turns of {cycles} steps, {others:.2f} processors busy with other work: two threads take "
          f"{wall[1] / wall[0]:.2f} of the time of one (tenths: {min(parts):.2f} to {max(parts):.2f}) and {used[1] / used[0]:.2f} of its "
          "processor time")


if __name__ == "__main__":
    main()
