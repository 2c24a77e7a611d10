"""Extremes of every zone over a run of exact waves: largest stress, tension, pressure and density at the middle of its mass.

The state of a material point changes only where a front passes it. A piece of constant state is met by all material between the lowest mass
coordinate of its left end and the highest of its right end, and both ends run straight in mass and time: looking at every meeting is
exact. Across a fan the stress falls, so that what a point in it meets is seen ahead of it, behind it, or at the end.
"""

import numpy as np

from hugoniot.solvers.fronts.line import Piece, fan_growth

NAMES = ("peak_stress", "peak_tension", "peak_pressure", "peak_density")


def start(count: int) -> np.ndarray:
    """(4, nzone): stress, tension, pressure, density so far."""
    return np.vstack([np.full((3, count), -np.inf), np.zeros((1, count))])


def update(found: np.ndarray, zones, sigma, pressure, rho) -> None:
    """Raise the extremes of some zones by a state, or by one for each."""
    for row, value in enumerate((sigma, -sigma, pressure, rho)):
        found[row, zones] = np.maximum(found[row, zones], value)


def named(found: np.ndarray) -> dict[str, np.ndarray]:
    """The fields of a run; tension counts from zero."""
    return dict(zip(NAMES, (found[0], np.maximum(found[1], 0.0), *found[2:])))


class Extremes:
    """region_of (nzone,); middles (nzone,): share of the region's mass on the left of each zone's middle.

    found (4, nzone); reach: piece -> (piece, lowest and highest share of its region's mass that it held)
    """

    def __init__(self, region_of: np.ndarray, middles: np.ndarray):
        self.region_of, self.middles = region_of, middles
        self.found = start(len(middles))
        self.reach: dict[int, tuple[Piece, float, float]] = {}

    def note(self, pieces: list[Piece], fronts, time: float) -> None:
        """Look at the pieces after a meeting."""
        here = set()
        for piece, low, high in _shares(pieces, fronts, time):
            key = id(piece)
            here.add(key)
            _, lowest, highest = self.reach.get(key, (piece, low, high))
            self.reach[key] = piece, min(low, lowest), max(high, highest)
        for key in [key for key in self.reach if key not in here]:
            self._close(*self.reach.pop(key))

    def _close(self, piece: Piece, low: float, high: float) -> None:
        zones = np.flatnonzero((self.region_of == piece.region) & (self.middles >= low) & (self.middles <= high))
        if len(zones):
            update(self.found, zones, piece.state.sigma, piece.state.pressure, piece.state.rho)

    def until(self, pieces: list[Piece], fronts, time: float) -> np.ndarray:
        """(4, nzone) with the pieces of now; fans are left to whoever reads the zones now.

        What is kept stays as it is: a run that is looked at goes on to the bits of one that is not.
        """
        now = Extremes(self.region_of, self.middles)
        now.found, now.reach = self.found.copy(), dict(self.reach)
        now.note(pieces, fronts, time)
        for one in now.reach.values():
            now._close(*one)
        return now.found


def _shares(pieces: list[Piece], fronts, time: float):
    """(piece, share of its region's mass at its left end, at its right end) of every constant piece."""
    masses = [0.0] * len(pieces)
    whole: dict[int, float] = {}
    for k, piece in enumerate(pieces[1:-1], start=1):
        if piece.region >= 0:
            width = fronts[k].at(time) - fronts[k - 1].at(time)
            masses[k] = piece.state.rho * width if piece.kind == "state" else float(fan_growth(piece)[0]) * (time - piece.t0)
            whole[piece.region] = whole.get(piece.region, 0.0) + masses[k]
    passed = dict.fromkeys(whole, 0.0)
    for k, piece in enumerate(pieces):
        if piece.region < 0:
            continue
        low = passed[piece.region]
        passed[piece.region] = low + masses[k]
        if piece.kind == "state":
            yield piece, low / whole[piece.region], passed[piece.region] / whole[piece.region]
