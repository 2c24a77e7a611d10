"""The algebraic mode of tracked fronts: the line of pieces and fronts, marched from meeting to meeting.

Knows a problem's numbers and laws; never files, decks or plots. Between meetings nothing is integrated: every state is the exact one.
"""

import math

import numpy as np

from hugoniot.errors import HugoniotError, UnphysicalState
from hugoniot.problem.model import Problem
from hugoniot.solvers.fronts import checkpoint, setup
from hugoniot.solvers.fronts.extremes import Extremes
from hugoniot.solvers.fronts.material_points import Column
from hugoniot.solvers.fronts.queue import Line
from hugoniot.solvers.fronts.reading import Reading
from hugoniot.solvers.fronts.record import COLUMNS, Lives
from hugoniot.solvers.protocol import NO_COUNTS, Event

STUCK = 20_000        # meetings in one instant: fronts pile up
LOST = 1e-3        # of the mass, momentum or energy: more than that is warned of


class Fronts(Reading):
    """A run in progress: a `protocol.LineSolver`.

    Raises `OutOfRange` for a problem it does not solve (setup.refuse_what_is_not_solved).
    """

    def __init__(self, problem: Problem):
        setup.refuse_what_is_not_solved(problem)
        super().__init__(problem)
        self.drives = {-1: setup.drive_of(problem.left), 1: setup.drive_of(problem.right)}
        self.bench = setup.bench_of(problem, self.drives)
        self.matters = self.bench.matters
        try:
            pieces, fronts = setup.first_line(problem, self.bench)
        except (HugoniotError, ArithmeticError, ValueError) as error:
            raise setup.unsolved(error, "where the first waves start") from error
        self.line = Line(pieces, fronts, self.bench, self.length, self._log, int(setup.options_of(problem)["most_fronts"]))
        self.lives = Lives()
        self.lives.note(self.line.fronts, self.line.pieces, 0.0)
        self.extremes = Extremes(self.region_of, self.middles)
        self.extremes.note(self.line.pieces, self.line.fronts, 0.0)
        self._changed = {side: 1 for side in (-1, 1)}       # steps of the drives that have been set
        self.start_totals, self.start_size = self.line.totals(), self._size()
        if self._struck():
            self.samples = 1
        else:
            self._sample()

    # -- marching ----------------------------------------------------------------------------------------------------
    @property
    def time(self) -> float:
        return self.line.time

    def column(self, region: int) -> Column:
        """The material of a region now."""
        return Column(self.line.pieces, self.line.fronts, region, self.time)

    def _stress(self, region: int, fraction: float, point) -> float:
        """Stress at a gauge, Pa: on a surface the pressure applied to it, also at t = 0, before any wave has left."""
        if fraction not in (0.0, 1.0):
            return point.sigma
        pieces, side = self.line.pieces, 2 * int(fraction) - 1
        own = [k for k, piece in enumerate(pieces) if piece.region == region]
        beyond = pieces[own[-1] + 1 if side > 0 else own[0] - 1]
        return {"vacuum": 0.0, "pressure": self.bench.pressures.get(side, 0.0)}.get(beyond.kind, point.sigma)

    @property
    def zone_updates(self) -> int:
        """Meetings solved: the work of this solver."""
        return self.line.meetings

    def march(self, until: float, cycles: int) -> list[Event]:
        """From meeting to meeting, at most `cycles` of them, up to the time `until` (hit exactly); what happened on the way."""
        self._events = []
        done, here = 0, 0
        while self.time < until and done < cycles:
            before = self.time
            goal = min(until, self._next_sample(), self._next_change()[0])
            try:
                met = self.line.advance(goal)
                if not met and self._next_change()[0] <= self.time:
                    self._change(self._next_change()[1])
                    met = True
            except (HugoniotError, ArithmeticError, ValueError) as error:
                raise self._unphysical(error) from error
            if met:
                self.cycle += 1
                done += 1
                self.lives.note(self.line.fronts, self.line.pieces, self.time)
                self.extremes.note(self.line.pieces, self.line.fronts, self.time)
                here = here + 1 if self.time == before else 0
                self._check(here)
            if self.time > before:
                self.step = self.time - before
            if self.time >= self._next_sample():
                self._sample()
        return self._events

    def _check(self, here: int) -> None:
        if self.line.full or here > STUCK:
            fronts = f"{len(self.line.fronts)} fronts, more than {self.line.most}"
            count = fronts if self.line.full else f"{here} interactions at one instant"
            low, high, region = self._crowd()
            raise UnphysicalState(f"{count}: too many waves to follow exactly; half of them lie between {low:.6g} and {high:.6g} m",
                                  ("raise solver.options.most_fronts, " if self.line.full else "") + "use a coarser "
                                  "solver.options.fan_step or a larger solver.options.weakest, stop earlier, or use "
                                  "solver.options.mode = \"cells\"", None, region, None, self.time, self.cycle)

    def _crowd(self) -> tuple[float, float, str]:
        """Where half of the fronts lie closest together, from and to (m), and the region in its middle."""
        x = np.sort([front.at(self.time) for front in self.line.fronts])
        half = len(x) // 2
        k = int(np.argmin(x[half:] - x[:len(x) - half]))
        piece = self.line.pieces[k + half // 2]
        return float(x[k]), float(x[k + half]), self.problem.regions[piece.region].name if piece.region >= 0 else ""

    def _next_change(self) -> tuple[float, int]:
        """(time, side) of the next step of a driven end."""
        due = [(self.drives[s].steps[k][0], s) for s, k in self._changed.items() if k < len(self.drives[s].steps)]
        return min(due, default=(math.inf, 0))

    def _change(self, side: int) -> None:
        value = self.drives[side].steps[self._changed[side]][1]
        values = self.bench.walls if side in self.bench.walls else self.bench.pressures
        self._changed[side] += 1
        if values[side] != value:
            values[side] = value
            self.line.redo_end((side + 1) // 2)

    def _unphysical(self, error: Exception) -> UnphysicalState:
        when, k = self.line.next_meeting()
        place = self.line.fronts[k].at(self.time) if k >= 0 else None
        region = self.problem.regions[max(self.line.pieces[k].region, 0)].name if k >= 0 else ""
        return setup.unsolved(error, "where fronts meet", region, place, self.time, self.cycle)

    def _extremes_so_far(self) -> np.ndarray:
        return self.extremes.until(self.line.pieces, self.line.fronts, self.time)

    def limiting(self) -> tuple[int, str]:
        """(zone, region name) where the next meeting is."""
        _, k = self.line.next_meeting()
        region = max(self.line.pieces[k + 1].region, 0)
        return int(np.searchsorted(self.region_of, region)), self.problem.regions[region].name

    # -- accounts ----------------------------------------------------------------------------------------------------
    def _size(self) -> np.ndarray:
        """Scale of each total: mass, momenta, energies without regard to sign."""
        size = np.zeros(3)
        for k, piece in enumerate(self.line.pieces[1:-1], start=1):
            a, b = piece.edge(-1), piece.edge(1)
            width = self.line.fronts[k].at(self.time) - self.line.fronts[k - 1].at(self.time)
            for point in (a, b):
                size += 0.5 * width * point.rho * np.array([1.0, abs(point.u), abs(point.e) + 0.5 * point.u**2])
        return size

    def errors(self) -> dict[str, float]:
        """Relative mass, momentum and energy errors against the impulse and work of the ends."""
        given = np.array([0.0, self.line.impulse.sum(), self.line.work.sum()])
        missing = np.abs(self.line.totals() - self.start_totals - given)
        size = np.maximum(np.maximum(self._size(), self.start_size), np.abs(given))
        return {f"{name}_error": float(m / max(s, 1e-300)) for name, m, s in zip(("mass", "momentum", "energy"), missing, size)}

    def exchanges(self) -> dict[str, float]:
        """Work (J/m2) and impulse (kg/(m s)) of the two ends so far."""
        (wl, wr), (il, ir) = self.line.work.tolist(), self.line.impulse.tolist()
        return {"work_left": wl, "work_right": wr, "impulse_left": il, "impulse_right": ir}

    def counts(self) -> dict[str, int]:
        """Gaps that opened between bodies, and surfaces that met."""
        return {**NO_COUNTS, "voids_opened": self.voids_opened, "voids_closed": self.voids_closed}

    def results(self) -> dict[str, float]:
        """What a summary adds: meetings, fans cut, waves left out, fronts at the end."""
        return {"meetings": float(self.line.meetings), "fans_cut": float(self.line.cuts), "waves_left_out": float(self.bench.dropped),
                "fronts": float(len(self.line.fronts))}

    def front_table(self) -> tuple[tuple[str, ...], list[str], np.ndarray]:
        """(columns, kinds, rows) of every front there was (record.Lives)."""
        return (COLUMNS, *self.lives.table(self.line.fronts, self.time))

    def warnings(self) -> list[str]:
        """Sentences about fans that were met, from where on the solution is one of slices, and about what is missing from the balances."""
        lost = max(self.errors().values())
        missing = [f"waves weaker than solver.options.weakest, which were left out, carried {100.0 * lost:.1g} % of the mass, momentum or "
                   "energy: make solver.options.weakest smaller"] if lost > LOST else []
        if not self.line.cuts:
            return missing
        fans = "1 fan was" if self.line.cuts == 1 else f"{self.line.cuts} fans were"
        return [*missing, f"{fans} reached by other waves and cut into slices, each with a velocity step of at most "
                f"{self.bench.fan_step:g} times the sound speed: behind them states are accurate to the square of that step"]

    # -- checkpoints -------------------------------------------------------------------------------------------------
    def payload(self) -> dict:
        """Everything a bitwise restart needs."""
        return checkpoint.payload(self)

    def restore(self, payload: dict) -> None:
        """Continue from a payload of the same problem."""
        checkpoint.restore(self, payload)

