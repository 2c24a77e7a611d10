"""The life of every front: where and when it arose, where and when it ended, its velocity and the states on both sides."""

import numpy as np

from hugoniot.solvers.fronts.line import Front, Piece

COLUMNS = ("time", "position", "end_time", "end_position", "velocity", "direction", "strength",
           "density_left", "velocity_left", "energy_left", "stress_left", "deviator_left",
           "density_right", "velocity_right", "energy_right", "stress_right", "deviator_right")


class Lives:
    """Rows of `COLUMNS` for fronts that have ended, and for those still there their states at birth."""

    def __init__(self):
        self.kinds: list[str] = []
        self.rows: list[list[float]] = []
        self.born: dict[int, tuple[Front, list[float]]] = {}
        self.jumps: dict[int, float] = {}         # region -> largest velocity change across a shock in it
        self.tensions: dict[int, float] = {}      # region -> largest tension in it, Pa: every state stands beside a front when it arises

    def note(self, fronts: list[Front], pieces: list[Piece], time: float) -> None:
        """Look at the fronts after a meeting: some are new, some are gone."""
        here = {id(front): k for k, front in enumerate(fronts)}
        gone = [(key, front) for key, (front, _) in self.born.items() if key not in here]
        for key, front in sorted(gone, key=lambda pair: (pair[1].t0, pair[1].x0, pair[1].speed)):    # whatever order they are kept in
            _, states = self.born.pop(key)
            self._end(front, states, time)
        for key, k in here.items():
            if key not in self.born:
                left, right = pieces[k].edge(1), pieces[k + 1].edge(-1)
                self.born[key] = fronts[k], [*left[:5], *right[:5]]      # of `COLUMNS`
                for piece, state in ((pieces[k], left), (pieces[k + 1], right)):
                    if piece.region >= 0 and state.sigma < 0.0:
                        self.tensions[piece.region] = max(self.tensions.get(piece.region, 0.0), -state.sigma)
                if "shock" in fronts[k].kind:
                    region = max(pieces[k].region, pieces[k + 1].region)
                    self.jumps[region] = max(self.jumps.get(region, 0.0), abs(left.u - right.u))

    def _end(self, front: Front, states: list[float], time: float) -> None:
        self.kinds.append(front.kind)
        self.rows.append([front.t0, front.x0, time, front.at(time), front.speed, float(front.direction), front.strength, *states])

    def table(self, fronts: list[Front], time: float) -> tuple[list[str], np.ndarray]:
        """(kinds, rows of COLUMNS) of all fronts, those that still run ended now, in the order in which they arose."""
        kinds, rows = list(self.kinds), [list(row) for row in self.rows]
        for front in fronts:
            _, states = self.born[id(front)]
            kinds.append(front.kind)
            rows.append([front.t0, front.x0, time, front.at(time), front.speed, float(front.direction), front.strength, *states])
        found = np.array(rows, dtype=float).reshape(-1, len(COLUMNS))
        order = np.lexsort((found[:, 1], found[:, 0]))
        return [kinds[k] for k in order], found[order]
