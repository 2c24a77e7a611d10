"""A step that leaves the range of a law is repeated with a smaller step before the run is given up.

Whether a step has left the range of a law is known only at its end, when the state before it is gone. A copy of the state, at most
`KEPT_FOR` steps old, is therefore kept, and the march is repeated from there to the step in question, bit for bit as after a checkpoint.
The result depends on the state alone, not on when the copy was made, so a resumed run repeats the same steps.

The same copy is used if a zone tangles in a step that is taken band by band, after the first rows have been advanced. The march then
continues for `WHOLE_FOR` steps with the whole mesh as one band, where such a step can be repeated directly.
"""

from typing import Any, NamedTuple

import numpy as np

from hugoniot.errors import UnphysicalState
from hugoniot.solvers.lagrange2d import layout as L
from hugoniot.solvers.lagrange2d.assemble import N, Z
from hugoniot.solvers.lagrange2d.bands import local
from hugoniot.solvers.protocol import Event

KEPT_FOR = 256       # steps
WHOLE_FOR = 1024     # steps
MOST_TRIES = 12      # of the same trouble, each with half the step of the one before
CLEAR = 4 * MOST_TRIES     # steps without trouble after which it counts as over
NOT_LED_ON = {"mass", "inverse_mass", "t0", "t1"}
ZONE_ROWS = np.array([k for k, name in enumerate(Z._fields) if name not in NOT_LED_ON])
NODE_ROWS = np.array([N.x, N.y, N.u, N.v, N.du, N.dv, N.im])
WHOLE = ("control", "counters", "chains", "ends")


class Kept(NamedTuple):
    """Tables at the start of a step."""

    zones: Any
    nodes: Any
    charge: Any
    rest: tuple
    contact: dict


def keep(solver) -> Kept:
    """What the next step is taken from."""
    rest = tuple(getattr(solver, name).copy() for name in WHOLE)
    return Kept(solver.zones[ZONE_ROWS], solver.nodes[NODE_ROWS], solver.charge.copy(), rest, solver.contact.payload())


def put_back(solver, kept: Kept) -> None:
    """Stand where `keep` was called."""
    solver.zones[ZONE_ROWS], solver.nodes[NODE_ROWS], solver.charge[...] = kept.zones, kept.nodes, kept.charge
    for name, values in zip(WHOLE, kept.rest):
        getattr(solver, name)[...] = values
    solver.run = solver.contact.restored(solver.run, kept.contact)


class Rewind:
    """The copy, and the event times of the marches since: what is needed to stand before any step since then."""

    def __init__(self):
        self.kept: Kept | None = None
        self.marches: list[tuple[int, float]] = []      # (cycle of the first step, event time)
        self.whole_until = 0                            # cycle to which the whole mesh is one band

    def forget(self) -> None:
        """What is kept no longer leads to the state as it stands."""
        self.kept = None

    def begin(self, solver, until: float, anew: bool = False) -> None:
        """A march to the event time `until` begins; anew: from a state that the copy does not lead to."""
        if anew or self.kept is None:
            self._keep(solver)
        self.marches.append((solver.cycle, until))

    def _keep(self, solver) -> None:
        """Copy the state as it stands."""
        self.kept, self.marches = keep(solver), []

    def pause(self, solver, end: int) -> int:
        """Cycle to which the march may go on with this copy and with bands of one height, at most `end`; sets the height."""
        if solver.cycle - self.marches[0][0] >= KEPT_FOR:
            self._keep(solver)
            self.marches.append((solver.cycle, float(solver.control[L.EVENT_TIME])))
        whole = solver.cycle < self.whole_until
        in_bands = not whole and local(solver.run, solver.problem.solver.erosion)
        solver.planner.set_bands(solver.plan, in_bands)
        return min(end, self.marches[0][0] + KEPT_FOR, self.whole_until if whole else end)

    def finish(self, solver, stop) -> None:
        """Stand before a step some of whose bands have been advanced; stop(cycle) marches on to a cycle."""
        cycle, until = solver.cycle, float(solver.control[L.EVENT_TIME])
        self._stand_before(solver, cycle, stop)
        solver.control[L.EVENT_TIME] = until
        self.kept, self.marches, self.whole_until = keep(solver), [(cycle, until)], cycle + WHOLE_FOR

    def _stand_before(self, solver, before: int, stop) -> None:
        """Go on from the copy to the step `before`, with the whole mesh as one band."""
        assert self.kept is not None
        put_back(solver, self.kept)
        self.whole_until = max(self.whole_until, before)
        ends = [start for start, _ in self.marches[1:]] + [before]
        for (_, event), end in zip(self.marches, ends):
            solver.control[L.EVENT_TIME] = event
            if end > solver.cycle:
                stop(end)

    def again(self, solver, cause: UnphysicalState, stop) -> Event | None:
        """Stand before the last step, and have the next one half as long; None if that has been tried often enough.

        cause   what the step has done
        stop    stop(cycle): march on to the event time of the control vector or to a cycle
        """
        counters, cycle, dt, until = solver.counters, solver.cycle, solver.step, solver.control[L.EVENT_TIME]
        before = cycle - 1
        tries = 1 if before - counters[L.LAST_TRIED] > CLEAR or counters[L.TRIES] == 0 else int(counters[L.TRIES]) + 1
        if tries > MOST_TRIES or not 0.5 * dt > solver.control[L.DT_SMALLEST]:
            return None
        self._stand_before(solver, before, stop)
        solver.control[L.EVENT_TIME], solver.control[L.DT_NATURAL] = until, 0.5 * dt / solver.control[L.GROWTH]
        counters[L.TRIES], counters[L.LAST_TRIED], counters[L.LEFT_RANGE] = tries, before, counters[L.LEFT_RANGE] + 1
        self.kept, self.marches = keep(solver), [(before, until)]
        text = (f"a step of {dt:.4g} s is repeated with half the length: in block '{cause.region}' {cause.cause}")
        return Event("step_repeated", solver.time, solver.cycle, cause.values["x"], text)
