"""The only time loop: marches a solver from event to event and passes what happens to observers.

Observers are objects with any of `gauges(times, values)`, `snapshot(state)`, `motion(state)` (places and velocities of a
snapshot), `event(event)`, `progress(report)` and `checkpoint(payload)`; they do not change the state. What the loop decides
from the wall clock (how long a burst of cycles lasts, when to checkpoint, when to report) never changes a result: bursts end on
whole cycles and every step depends on the state alone. An interrupt (Ctrl-C) takes effect at the end of a burst and of what it
caused, so that the checkpoint contains neither half a snapshot nor a void that was detected but not opened.
"""

import math
import signal
import threading
import time
from dataclasses import dataclass, field

from hugoniot.signals import interrupt
from hugoniot.solvers.protocol import Solver

BURST_SECONDS = 0.1
FIRST_BURST = 64


@dataclass(frozen=True)
class Report:
    """What a progress display shows: times in s, the zone that limits the step, energy error."""

    time: float
    stop_time: float
    cycle: int
    step: float
    limiting_zone: int
    limiting_region: str
    energy_error: float


@dataclass
class Schedule:
    """When to look: stop time, snapshot times (sorted, s), wall seconds and cycles between checkpoints, most cycles; cycles of the first
    burst, before it is known how long one takes."""

    stop_time: float
    snapshots: list[float] = field(default_factory=list)
    checkpoint_seconds: float = math.inf
    checkpoint_cycles: int | None = None
    max_cycles: int | None = None
    first_burst: int = FIRST_BURST


@dataclass
class Outcome:
    """status: "done" or "stopped at max_cycles"; kernel_seconds: time spent in the solver."""

    status: str
    kernel_seconds: float


def snapshot_times(stop_time, wanted, default_count: int = 100) -> list[float]:
    """Sorted snapshot times from an interval, explicit times or None (100 intervals); 0 and the stop time included."""
    if wanted is None:
        wanted = stop_time / default_count
    if isinstance(wanted, (int, float)):
        count = math.floor(stop_time / wanted * (1.0 + 1e-12))
        times = [k * wanted for k in range(count + 1)]
    else:
        times = [t for t in wanted if t <= stop_time]
    close = 1e-9 * stop_time
    times = [t for t in times if close < t < stop_time - close]
    return [0.0, *sorted(times), stop_time]


class _Interrupts:
    """Notes the first Ctrl-C or request to end (`asked`) instead of raising wherever the loop happens to be; a second one raises at once.

    Only where the signal would raise: one that is ignored, or that somebody else answers, stays as it is.
    """

    def __init__(self):
        self.asked, self.before = False, {}

    def __enter__(self):
        if threading.current_thread() is threading.main_thread():
            for number, raising in ((signal.SIGINT, signal.default_int_handler), (signal.SIGTERM, interrupt)):
                if signal.getsignal(number) is raising:
                    self.before[number] = signal.signal(number, self._note)
        return self

    def __exit__(self, *_):
        for number, handler in self.before.items():
            signal.signal(number, handler)

    def _note(self, number, frame):
        if self.asked:
            raise KeyboardInterrupt
        self.asked = True


class _Hands:
    """Calls a hook on every observer that has it."""

    def __init__(self, observers):
        self.observers = observers

    def wanted(self, hook) -> bool:
        """Whether anybody looks: what nobody looks at need not be made."""
        return any(getattr(observer, hook, None) is not None for observer in self.observers)

    def __call__(self, hook, *args):
        for observer in self.observers:
            method = getattr(observer, hook, None)
            if method is not None:
                method(*args)


def march_to_end(solver: Solver, schedule: Schedule, observers=(), next_snapshot: int = 0) -> Outcome:
    """Run a solver to the stop time.

    next_snapshot   index of the first snapshot still to take (of a resumed run)

    Raises `UnphysicalState` in the cycle it arises, and KeyboardInterrupt after a checkpoint.
    """
    tell = _Hands(observers)
    times = schedule.snapshots
    last_checkpoint = time.perf_counter()
    last_cycle, kernel, burst, first = solver.cycle, 0.0, schedule.first_burst, True
    with _Interrupts() as interrupts:
        if next_snapshot == 0 and solver.time >= times[0]:
            _look(solver, tell)
            next_snapshot = 1
        while solver.time < schedule.stop_time:
            if interrupts.asked:
                tell("checkpoint", {"solver": solver.payload(), "next_snapshot": next_snapshot})
                raise KeyboardInterrupt
            cycles = _allowance(solver, schedule, burst, last_cycle)
            if cycles <= 0:
                return Outcome("stopped at max_cycles", kernel)
            begun, cycle = time.perf_counter(), solver.cycle
            events = solver.march(times[next_snapshot], cycles)
            spent = time.perf_counter() - begun
            kernel += spent
            if not first and solver.cycle > cycle:   # the first burst may have compiled
                burst = max(1, min(int((solver.cycle - cycle) * BURST_SECONDS / spent), 4 * burst))
            first = False
            tell("gauges", *solver.take_gauges())
            for event in events:
                tell("event", event)
            if solver.time >= times[next_snapshot]:
                _look(solver, tell)
                next_snapshot += 1
            now = time.perf_counter()
            if tell.wanted("progress"):
                tell("progress", _report(solver, schedule))
            if now - last_checkpoint > schedule.checkpoint_seconds or _due(solver, schedule, last_cycle):
                tell("checkpoint", {"solver": solver.payload(), "next_snapshot": next_snapshot})
                last_checkpoint, last_cycle = time.perf_counter(), solver.cycle
    return Outcome("done", kernel)


def _look(solver: Solver, tell: _Hands) -> None:
    """Hand out a snapshot, and only what somebody looks at of it."""
    if tell.wanted("snapshot"):
        tell("snapshot", solver.state())
    if tell.wanted("motion"):
        tell("motion", solver.motion())


def _allowance(solver: Solver, schedule, burst, last_cycle):
    """Cycles the next burst may take."""
    cycles = burst
    if schedule.checkpoint_cycles:
        cycles = min(cycles, max(1, last_cycle + schedule.checkpoint_cycles - solver.cycle))
    if schedule.max_cycles is not None:
        cycles = min(cycles, schedule.max_cycles - solver.cycle)
    return cycles


def _due(solver: Solver, schedule, last_cycle):
    return bool(schedule.checkpoint_cycles) and solver.cycle - last_cycle >= schedule.checkpoint_cycles


def _report(solver: Solver, schedule):
    zone, region = solver.limiting()
    return Report(solver.time, schedule.stop_time, solver.cycle, solver.step, zone, region, solver.errors()["energy_error"])
