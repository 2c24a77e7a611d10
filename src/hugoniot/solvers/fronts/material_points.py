"""Where the material of a region is now, and in what state: from its mass coordinate to position and state.

In a constant piece mass is proportional to distance; between two characteristics of a centred fan it is (t - t0) times the difference of
rho c, so that a point of the fan is found from its mass along the isentrope.
"""

import numpy as np

from hugoniot.laws.riemann.branch import State
from hugoniot.solvers.fronts.line import Front, Piece, content, fan_state


class Column:
    """The pieces of one region at one time, from left to right."""

    def __init__(self, pieces: list[Piece], fronts: list[Front], region: int, time: float):
        self.time = time
        self.rows = [(piece, fronts[k - 1].at(time), fronts[k].at(time)) for k, piece in enumerate(pieces) if piece.region == region]
        masses = [piece.state.rho * (b - a) if piece.kind == "state" else content(piece, a, b, time)[0] for piece, a, b in self.rows]
        self.mass = np.concatenate([[0.0], np.cumsum(masses)])

    def at(self, fraction: float) -> tuple[float, State]:
        """(position, state) of the point that has this fraction of the region's mass on its left."""
        mass = min(max(fraction, 0.0), 1.0) * self.mass[-1]
        k = min(max(int(np.searchsorted(self.mass, mass, side="right")) - 1, 0), len(self.rows) - 1)
        while k + 1 < len(self.rows) and self.mass[k + 1] <= self.mass[k]:      # pieces that have no width yet hold no material
            k += 1
        while k and self.mass[k + 1] <= self.mass[k]:
            k -= 1
        piece, left, right = self.rows[k]
        inside = min(max(mass - self.mass[k], 0.0), self.mass[k + 1] - self.mass[k])
        if piece.kind == "state":
            return min(left + inside / piece.state.rho, right), piece.state
        return self._in_fan(piece, left, right, inside)

    def _in_fan(self, piece: Piece, left: float, right: float, inside: float) -> tuple[float, State]:
        wave, age = piece.wave, self.time - piece.t0
        if age <= 0.0:
            return left, wave.ahead
        d, path = wave.direction, wave.path
        start = wave.ahead.rho * path.speed(path.nodes[0])                 # rho c at the head
        whole = content(piece, left, right, self.time)[0]
        from_head = whole - inside if d > 0 else inside
        least = 0.0 if wave.behind.rho == 0.0 else wave.behind.rho * abs(wave.tail - wave.behind.u)
        impedance = min(max(start - from_head / age, least), start)
        if impedance <= 0.0:
            return (left if d > 0 else right), wave.behind
        if impedance == start:
            return (right if d > 0 else left), wave.ahead
        state = path.state(path.at_impedance(impedance), d)
        x = piece.x0 + age * (state.u + d * impedance / state.rho)
        return min(max(x, left), right), state


def sample(piece: Piece, x: float, time: float) -> State:
    """The state of a piece at a position inside it."""
    return fan_state(piece, (x - piece.x0) / (time - piece.t0)) if piece.kind == "fan" and time > piece.t0 else piece.state
