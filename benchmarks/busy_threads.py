"""What a second thread costs on a machine that is busy with other work: at most a fifth more time than one thread.

    python benchmarks/busy_threads.py [--zones 20000] [--others 2] [--rounds 9]

Other processes keep every core busy; runs of one and of two threads are timed in turns. Printed: the ratio of the times of two threads to
one, of every round, their median, and the processor time used.
"""

import argparse
import statistics
import subprocess
import sys
import time

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


def seconds(zones: int, threads: int, cycles: int) -> tuple[float, float]:
    """(wall, processor) time of some cycles."""
    solver = make_solver(read_deck_text(DECK.format(zones // 2, threads)).problem)
    solver.march(1.0, 20)
    wall, used = time.perf_counter(), time.process_time()
    solver.march(1.0, cycles)
    return time.perf_counter() - wall, time.process_time() - used


def main() -> None:
    words = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    for name, number in (("zones", 20_000), ("others", 2), ("rounds", 9), ("cycles", 400)):
        words.add_argument(f"--{name}", type=int, default=number)
    asked = words.parse_args()
    busy = [subprocess.Popen([sys.executable, "-c", SPIN]) for _ in range(asked.others)]
    try:
        walls, used = [], []
        for _ in range(asked.rounds):
            (one, spent), (two, both) = (seconds(asked.zones, threads, asked.cycles) for threads in (1, 2))
            walls.append(two / one)
            print(f"one thread {one:.2f} s, two threads {two:.2f} s, ratio {two / one:.2f}", flush=True)
            used.append(both / spent)
    finally:
        for process in busy:
            process.kill()
    print(f"{asked.zones} zones beside {asked.others} busy processes: two threads take {statistics.median(walls):.2f} of the time "
          f"of one and {statistics.median(used):.2f} of its processor time (medians)")


if __name__ == "__main__":
    main()
