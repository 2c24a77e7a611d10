"""What a run will need of memory and disk, estimated before it starts."""

import math
from typing import NamedTuple

from hugoniot.problem.model import Problem

PROGRAM = 300e6         # bytes of the program itself: interpreter, compiler, libraries
COLUMNS = 14            # columns of a snapshot where the deck chooses none, faces included
FACES = 4
BURNING = 4             # further columns where something burns
PER_ZONE = 900.0        # bytes of memory per zone: the solver's rows, and the copies made for snapshots and checkpoints


class Cost(NamedTuple):
    """zones, snapshots (numbers); memory at the peak and size of result.h5 in bytes.

    Until a long run ends its pieces need the size of the result a second time.
    """

    zones: int
    snapshots: int
    memory: float
    result: float


def estimate(problem: Problem) -> Cost:
    """Memory and result of a run, to some tens of per cent; gauges, a few columns for each step, are not counted."""
    zones = sum(math.prod(part.zones) if isinstance(part.zones, tuple) else part.zones for part in problem.regions)
    zones *= 2 if getattr(problem.solver, "cells", "quads") == "triangles" else 1
    wanted = problem.output.snapshots
    if isinstance(wanted, tuple):
        snapshots = len(wanted) + 2
    else:
        snapshots = 101 if not wanted else int(problem.stop_time / wanted) + 1
    burning = any(material.burn is not None for material in problem.materials.values())
    columns = len(problem.output.fields) + FACES if problem.output.fields else COLUMNS + (BURNING if burning else 0)
    return Cost(zones, snapshots, PROGRAM + PER_ZONE * zones, 8.0 * columns * zones * snapshots)
