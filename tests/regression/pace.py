"""How long something takes in units of a piece of work of the same machine at the same moment, so that no test depends on seconds."""

import subprocess
import sys
import time

try:
    import resource
except ImportError:     # no Unix
    resource = None

PATIENCE = 600     # seconds until a test that waits gives up: whoever hangs has failed, whoever is slow has not


def loop():
    """The unit: 200 000 turns of a plain loop of the interpreter, some 10 ms of today's processors."""
    total = 0
    for k in range(200_000):
        total += k * k % 7
    return total


def in_loops(work, rounds=5):
    """Processor time of `work()` over that of `loop()`: the best of some rounds of each, taken in turns."""
    best = [float("inf")] * 2
    for _ in range(rounds):
        for k, call in enumerate((work, loop)):
            begun = time.thread_time()
            call()
            best[k] = min(best[k], time.thread_time() - begun)
    return best[0] / best[1]


def in_starts(arguments, reference, rounds=4, **how):
    """Processor time of Python processes, each with a list of `arguments`, over that of one with `reference`: the best of some rounds."""
    best = [float("inf")] * (1 + len(arguments))
    for _ in range(rounds):
        for k, words in enumerate((reference, *arguments)):
            before = resource.getrusage(resource.RUSAGE_CHILDREN)
            subprocess.run([sys.executable, *words], capture_output=True, **how)
            after = resource.getrusage(resource.RUSAGE_CHILDREN)
            best[k] = min(best[k], after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
    return [one / best[0] for one in best[1:]]


def calls(work):
    """Functions called by `work()`: a measure of its effort that every machine agrees on."""
    count = 0

    def note(frame, event, argument):
        nonlocal count
        count += event in ("call", "c_call")

    sys.setprofile(note)
    try:
        work()
    finally:
        sys.setprofile(None)
    return count
