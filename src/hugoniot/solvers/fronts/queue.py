"""The march of the algebraic mode: from meeting to meeting, each at its exact time and place."""

import math

import numpy as np

from hugoniot.solvers.fronts.cutting import cut
from hugoniot.solvers.fronts.line import OUTSIDE, Front, Piece, totals
from hugoniot.solvers.fronts.meeting import Bench, outgoing

SAME_PLACE = 1e-14      # of the length: fronts that close meet at one place


class Line:
    """Pieces and fronts now, with what passed the two ends.

    log     called as log(kind, time, position, text) for everything that happens
    most    largest number of fronts; `full` is set when a meeting would leave more
    """

    def __init__(self, pieces: list[Piece], fronts: list[Front], bench: Bench, length: float, log, most: int):
        self.pieces, self.fronts, self.bench = pieces, fronts, bench
        self.length, self.log, self.most = length, log, most
        self.time, self.meetings, self.cuts = 0.0, 0, 0
        self.work, self.impulse = np.zeros(2), np.zeros(2)      # left, right

    # -- times -------------------------------------------------------------------------------------------------------
    def _meeting(self, k: int) -> float:
        """When front k meets front k + 1 (inf: never, or they bound a fan)."""
        a, b = self.fronts[k], self.fronts[k + 1]
        closing = a.speed - b.speed
        if closing <= 0.0 or self.pieces[k + 1].kind == "fan":
            return math.inf
        base = max(a.t0, b.t0)
        gap = b.at(base) - a.at(base)
        return base + max(gap, 0.0) / closing

    def next_meeting(self) -> tuple[float, int]:
        """(time, index of the left front) of the earliest meeting."""
        best, found = math.inf, -1
        for k, (a, b) in enumerate(zip(self.fronts, self.fronts[1:])):
            if a.neighbour is not b:
                a.neighbour, a.meets = b, self._meeting(k)
            if (when := a.meets) < best:
                best, found = when, k
        return best, found

    def advance(self, until: float) -> bool:
        """To the next meeting or to `until`, whichever comes first; whether there was a meeting."""
        when, k = self.next_meeting()
        if when > until:
            self._move_to(until)
            return False
        self._move_to(max(when, self.time))
        self._meet(k)
        return True

    def _move_to(self, time: float) -> None:
        """Book the work and impulse of the ends up to a time."""
        for side, (front, piece) in enumerate(((self.fronts[0], self.pieces[1]), (self.fronts[-1], self.pieces[-2]))):
            if front.kind == "end" and piece.kind == "state":
                sign = 1 - 2 * side
                push = sign * piece.state.sigma * (time - self.time)
                self.impulse[side] += push
                self.work[side] += push * front.speed
        self.time = time

    # -- meetings ----------------------------------------------------------------------------------------------------
    def _run_of(self, k: int) -> tuple[int, int]:
        """The run of fronts (first, last) that meet with k and k + 1."""
        near, x = SAME_PLACE * self.length, self.fronts[k].at(self.time)
        first, last = k, k + 1
        while first > 0 and x - self.fronts[first - 1].at(self.time) <= near and self.fronts[first - 1].speed > self.fronts[first].speed:
            first -= 1
        while (last + 1 < len(self.fronts) and self.fronts[last + 1].at(self.time) - x <= near
               and self.fronts[last + 1].speed < self.fronts[last].speed):
            last += 1
        return first, last

    def _meet(self, k: int) -> None:
        first, last = self._run_of(k)
        first, last = self._with_newborn_fans(first, last)
        for j in (last + 1, first):       # a fan whose edge is met is cut first; what meets its slices comes next
            if self.pieces[j].kind == "fan":
                x = self.fronts[first].at(self.time)
                count = cut(self.pieces, self.fronts, j, self.time, self.bench)
                self.cuts += 1
                self.log("fan_cut", self.time, x, f"a fan was hit by another wave and cut into {count} slices")
                return
        self._replace(first, last)

    def _with_newborn_fans(self, first: int, last: int) -> tuple[int, int]:
        """The run with both edges of every fan beside it that has no width yet."""
        near = SAME_PLACE * self.length
        while self.pieces[first].kind == "fan" and self.fronts[first].at(self.time) - self.fronts[first - 1].at(self.time) <= near:
            first -= 1
        while self.pieces[last + 1].kind == "fan" and self.fronts[last + 1].at(self.time) - self.fronts[last].at(self.time) <= near:
            last += 1
        return first, last

    def _replace(self, first: int, last: int) -> None:
        met = self.fronts[first:last + 1]
        x = met[0].at(self.time) if met[0].kind == "end" else met[-1].at(self.time) if met[-1].kind == "end" else (
            sum(front.at(self.time) for front in met) / len(met))
        left, right = self.pieces[first], self.pieces[last + 1]
        if left.kind in OUTSIDE and right.kind in OUTSIDE:
            raise ArithmeticError("a body vanished between two fronts")
        opens = left if left.kind == "open" else right if right.kind == "open" else None
        if opens is not None:
            opens.state = (right if opens is left else left).edge(-1 if opens is left else 1)
        fronts, between, found = outgoing(left, right, x, self.time, self.bench, any(front.sliced for front in met))
        if fronts:
            self.fronts[first:last + 1] = fronts
            self.pieces[first + 1:last + 1] = between
        else:                              # nothing is left to track: both sides are one state
            self.fronts[first:last + 1] = []
            self.pieces[first + 1:last + 2] = []
        self.meetings += 1
        names = " with ".join(_count(front.kind for front in met))
        made = ", ".join(front.kind for front in fronts) or "nothing"
        word = "vacuum opens" if found.vacuum else f"{found.stress:.6g} Pa, {found.velocity[0]:.6g} m/s"
        self.log("meeting", self.time, x, f"{names}: {made} ({word})")

    def redo_end(self, side: int) -> None:
        """Solve the end (0 left, 1 right) anew after its wall or pressure has changed."""
        k = 0 if side == 0 else len(self.fronts) - 1
        while self.pieces[k if side else k + 1].kind == "fan":
            cut(self.pieces, self.fronts, k if side else k + 1, self.time, self.bench)
            k = 0 if side == 0 else len(self.fronts) - 1
        left, right = self.pieces[k], self.pieces[k + 1]
        fronts, between, _ = outgoing(left, right, self.fronts[k].at(self.time), self.time, self.bench)
        self.fronts[k:k + 1] = fronts
        self.pieces[k + 1:k + 1] = between
        self.log("boundary", self.time, fronts[0 if side == 0 else -1].x0, f"the {('left', 'right')[side]} end changes")

    @property
    def full(self) -> bool:
        return len(self.fronts) > self.most

    def totals(self) -> np.ndarray:
        """Mass, momentum and total energy now, per m^2."""
        return totals(self.pieces, self.fronts, self.time).sum(axis=1)


def _count(kinds) -> list[str]:
    found: dict[str, int] = {}
    for kind in kinds:
        found[kind] = found.get(kind, 0) + 1
    return [kind if n == 1 else f"{n} x {kind}" for kind, n in found.items()]
