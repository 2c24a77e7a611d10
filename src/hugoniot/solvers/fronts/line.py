r"""The line of material as fronts and, between them, pieces of known content.

n + 1 pieces lie between and outside n fronts. A piece is a constant state, a centred fan, or what lies outside the material: nothing
(a gap, a free end), a wall, a given pressure, an open end. A front moves at constant speed from where and when it arose, so that its
position at any time carries one rounding.

The content of a piece between two fronts is exact: of a constant state U times the width; of a fan, self-similar in
$\xi = (x - x_0)/(t - t_0)$, $\int U\,dx = (t - t_0)\left[\xi U - F(U)\right]$ between its edges.
"""

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from hugoniot.laws.riemann.branch import State
from hugoniot.laws.riemann.curve import Wave

OUTSIDE = ("vacuum", "wall", "pressure", "open")


@dataclass
class Front:
    """kind: shock, expansion, elastic shock, fan head, fan tail, contact, interface, surface, end (of fans also "elastic fan head" and
    "compaction fan head"); strength of the wave (0 for contacts).

    direction   -1 or +1 for a wave that runs into its left or right neighbour, 0 for what moves with the material
    sliced      whether it came out of the slices of a fan that was cut
    """

    kind: str
    x0: float
    t0: float
    speed: float
    direction: int = 0
    strength: float = 0.0
    sliced: bool = False
    neighbour: Any = field(default=None, repr=False, compare=False)     # the front on the right for which `meets` holds
    meets: float = field(default=0.0, repr=False, compare=False)

    def at(self, time: float) -> float:
        """Position, m."""
        return self.x0 + self.speed * (time - self.t0)


@dataclass
class Piece:
    """kind: "state", "fan" or one of OUTSIDE; region: index of the problem's region, -1 outside.

    state   of a constant piece; of a fan the one ahead; of an open end the one that stands there
    wave    of a fan: the `Wave`, centred at (x0, t0)
    broken  whether it is the last slice of a cut fan before a vacuum: what is left of its release is one jump
    matter  what it is made of where its region does not say: a mixture that burns
    """

    kind: str
    region: int = -1
    state: State = State(0.0, 0.0, 0.0, 0.0)
    wave: Wave | None = None
    x0: float = 0.0
    t0: float = 0.0
    broken: bool = False
    matter: Any = None

    def edge(self, side: int) -> State:
        """The state at the left (-1) or right (+1) end of the piece."""
        if self.kind == "fan":
            return self.wave.ahead if side == self.wave.direction else self.wave.behind
        return self.state


def densities(state: State) -> np.ndarray:
    """(mass, momentum, total energy) per volume."""
    return np.array([state.rho, state.rho * state.u, state.rho * (state.e + 0.5 * state.u**2)])


def fluxes(state: State) -> np.ndarray:
    """Of mass, momentum and total energy through a resting face."""
    energy = state.rho * (state.e + 0.5 * state.u**2)
    return np.array([state.rho * state.u, state.rho * state.u**2 + state.sigma, state.u * (energy + state.sigma)])


def _primitive(state: State, xi: float) -> np.ndarray:
    return xi * densities(state) - fluxes(state)


def fan_state(piece: Piece, xi: float) -> State:
    """The state of a fan on the characteristic xi = (x - x0)/(t - t0)."""
    wave = piece.wave
    d, path = wave.direction, wave.path
    if d * (xi - wave.head) >= 0.0:
        return wave.ahead
    # at the edge of a vacuum the density falls with a high power of the distance: nothing is left so close to it
    near = 1e-9 * abs(wave.head - wave.tail) if wave.behind.rho == 0.0 else 0.0
    if d * (xi - wave.tail) <= near:
        return wave.behind
    return path.state(path.at_characteristic(d * (xi - wave.ahead.u)), d)


def content(piece: Piece, left: float, right: float, time: float) -> np.ndarray:
    """(mass, momentum, total energy) per m^2 of a piece between two positions inside it."""
    if piece.kind == "state":
        return densities(piece.state) * (right - left)
    if piece.kind != "fan":
        return np.zeros(3)
    age = time - piece.t0
    if age <= 0.0:
        return np.zeros(3)
    a, b = ((x - piece.x0) / age for x in (left, right))
    return age * (_primitive(fan_state(piece, b), b) - _primitive(fan_state(piece, a), a))


def fan_growth(piece: Piece) -> np.ndarray:
    """Content a whole fan gains per time, from its edges alone."""
    wave = piece.wave
    low, high = (wave.behind, wave.ahead) if wave.direction > 0 else (wave.ahead, wave.behind)
    a, b = sorted((wave.head, wave.tail))
    return _primitive(high, b) - _primitive(low, a)


def totals(pieces: list[Piece], fronts: list[Front], time: float) -> np.ndarray:
    """(3, number of inner pieces) contents of the pieces between the fronts."""
    rows = []
    for k, piece in enumerate(pieces[1:-1], start=1):
        if piece.kind == "fan":
            rows.append((time - piece.t0) * fan_growth(piece))
        else:
            rows.append(content(piece, fronts[k - 1].at(time), fronts[k].at(time), time))
    return np.array(rows).reshape(-1, 3).T
