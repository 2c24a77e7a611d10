r"""Waves in time and space after an impact, without a mesh: every front is tracked and every interaction is a Riemann problem.

Between fronts the states are constant. A shock moves at its exact velocity, an interface or a free surface with the material. A fan is
divided into steps of equal pressure. Each is a jump between two states a and b of one isentrope, which moves at the velocity $W$ that
conserves mass:

$$W = \frac{\rho_bu_b - \rho_au_a}{\rho_b - \rho_a}$$

When two fronts meet, the Riemann problem of the outer states gives the outgoing waves. Shocks and their interactions are thus exact; the
error of fans is of second order in the step. Bodies separate rather than support tension, and may meet again.

Source: Wave-front tracking after Dafermos, J. Math. Anal. Appl. 38 (1972) 33; Starkenberg, ARL-TR-2161, section 6, for the local solutions.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from hugoniot.errors import OutOfRange
from hugoniot.theory.hugoniot import Initial, shock
from hugoniot.theory.isentrope import history, reference, unload
from hugoniot.theory.riemann import riemann
from hugoniot.theory.states import States, law_of


@dataclass
class Cell:
    """A part of one layer in one state; `layer` is -1 in a gap or outside."""

    layer: int
    state: States | None = None


@dataclass
class Front:
    """A front: kind (shock, fan, contact within a layer, interface or surface), position x (m) at the last time, and velocity (m/s)."""

    kind: str
    x: float
    velocity: float
    born: tuple[float, float] = (0.0, 0.0)


@dataclass(frozen=True)
class Event:
    """An interaction of fronts.

    time, position   s and m
    met              kinds of the fronts that met
    layers           numbers of the layers on both sides; -1 in a gap or outside
    left, right      states on both sides afterwards; None: no material
    """

    time: float
    position: float
    met: tuple[str, ...]
    layers: tuple[int, int]
    left: States | None
    right: States | None


@dataclass
class Diagram:
    """The result: `events` in chronological order, `paths` (kind, t1, x1, t2, x2) of all fronts, and `profile`, the state at the last
    time."""

    time: float = 0.0
    events: list[Event] = field(default_factory=list)
    paths: list[tuple[str, float, float, float, float]] = field(default_factory=list)
    cells: list[Cell] = field(default_factory=list)
    fronts: list[Front] = field(default_factory=list)

    def profile(self) -> list[tuple[float, float, int, States]]:
        """(left end, right end, layer, state) of every piece of material at the last time, from left to right."""
        return [(self.fronts[i - 1].x, self.fronts[i].x, cell.layer, cell.state)
                for i, cell in enumerate(self.cells) if cell.state is not None]


def wave_diagram(layers: Sequence, thicknesses: Sequence[float], velocity: float, until: float, *, fan: int = 8,
                 smallest: float = 1e-3, most_events: int = 20000) -> Diagram:
    """Follow the waves of an impact at x = 0 and time 0.

    layers        flyer first, then the targets: materials or parameters of equations of state
    thicknesses   thickness of each layer, m; the rear of the flyer and of the last target are free surfaces
    velocity      velocity of the flyer towards +x, m/s
    until         end of the calculation, s
    fan           number of steps into which a fan as strong as the first shock is divided
    smallest      waves weaker than this fraction of the impact pressure are ignored
    most_events   largest number of interactions

    Raises OutOfRange for impossible input or when there are more interactions than `most_events`.
    """
    if len(layers) < 2 or len(layers) != len(thicknesses) or not all(t > 0.0 for t in thicknesses) or not velocity > 0.0:
        raise OutOfRange("an impact needs a flyer and a target, a positive thickness of each and a positive velocity")
    tracker = _Tracker([law_of(layer) for layer in layers], thicknesses, velocity, fan, smallest)
    for _ in range(most_events):
        wait, k = tracker.next_meeting()
        if tracker.diagram.time + wait >= until:
            tracker.move(until - tracker.diagram.time)
            break
        tracker.move(wait)
        tracker.meet(k)
    else:
        raise OutOfRange(f"more than {most_events} interactions of waves by {tracker.diagram.time:.6g} s: choose an earlier "
                         "end time (until); in Python also fewer steps of a fan, or a larger `smallest`")
    tracker.finish()
    return tracker.diagram


class _Tracker:
    """The fronts between the cells: fronts[i] stands between cells[i] and cells[i + 1]."""

    def __init__(self, laws, thicknesses, velocity, fan, smallest):
        self.laws, self.diagram = laws, Diagram()
        edges = np.concatenate([[-thicknesses[0], 0.0], np.cumsum(thicknesses[1:])])
        states = [reference(laws[0], velocity), *(reference(law) for law in laws[1:])]
        d = self.diagram
        d.cells = [Cell(-1), *(Cell(i, s) for i, s in enumerate(states)), Cell(-1)]
        speeds = [velocity, velocity, *([0.0] * (len(laws) - 1))]
        kinds = ["surface", *["interface"] * (len(laws) - 1), "surface"]
        d.fronts = [Front(kind, float(x), u, (0.0, float(x))) for kind, x, u in zip(kinds, edges, speeds)]
        first = riemann(laws[0], states[0], laws[1], states[1])
        self.scale, self.step = first.pressure, first.pressure / fan
        self.least = smallest * first.pressure
        self.meet(1)

    def next_meeting(self):
        """(wait, index) of the pair of neighbouring fronts that meet next."""
        fronts = self.diagram.fronts
        best, which = math.inf, -1
        for i in range(len(fronts) - 1):
            closing = fronts[i].velocity - fronts[i + 1].velocity
            if closing > 1e-9:
                wait = max(0.0, fronts[i + 1].x - fronts[i].x) / closing
                if wait < best:
                    best, which = wait, i
        return best, which

    def move(self, wait):
        self.diagram.time += wait
        for front in self.diagram.fronts:
            front.x += front.velocity * wait

    def meet(self, k):
        """Replace the fronts that meet at fronts[k] by the waves that leave."""
        d = self.diagram
        x = d.fronts[k].x
        near = 1e-12 * (abs(x) + 1e-3)
        low = high = k
        while high + 1 < len(d.fronts) and d.fronts[high + 1].x - x <= near and d.fronts[high].velocity > d.fronts[high + 1].velocity:
            high += 1
        while low > 0 and x - d.fronts[low - 1].x <= near and d.fronts[low - 1].velocity > d.fronts[low].velocity:
            low -= 1
        gone = d.fronts[low : high + 1]
        left, right = d.cells[low], d.cells[high + 1]
        for front in gone:
            d.paths.append((front.kind, *front.born, d.time, x))
        fronts, cells = self.leaving(left, right, x)
        d.fronts[low : high + 1] = fronts
        d.cells[low + 1 : high + 1] = cells
        sides = [left, *cells, right]
        middle = next((i for i, f in enumerate(fronts) if f.kind in ("interface", "surface", "contact")), None)
        after = (sides[middle], sides[middle + 1]) if middle is not None else (left, right)
        d.events.append(Event(d.time, x, tuple(f.kind for f in gone), (after[0].layer, after[1].layer), after[0].state, after[1].state))

    def leaving(self, left: Cell, right: Cell, x: float):
        """(fronts, cells between them) of the Riemann problem of two cells, either of which may be empty."""
        if left.state is None or right.state is None:
            return self.from_surface(left, right, x)
        same = left.layer == right.layer
        found = riemann(self.laws[left.layer], left.state, self.laws[right.layer], right.state, bonded=same)
        lefts = [left, *self.pieces(left, found.left.behind, -1)]
        rights = [*self.pieces(right, found.right.behind, 1)[::-1], right]
        gap, middle = [], []
        alike = same and abs(lefts[-1].state.density / rights[0].state.density - 1.0) < 1e-7
        if found.vacuum:
            gap = [Cell(-1)]
            middle = [self.born("surface", x, cell.state.particle_velocity) for cell in (lefts[-1], rights[0])]
        elif alike and len(lefts) > 1:
            # no contact: the innermost cells of both sides are one
            lefts[-1] = lefts[-1] if len(rights) > 1 else right
            rights[0] = lefts[-1]
        elif alike and len(rights) > 1:
            rights[0] = left
        else:
            middle = [self.born("contact" if same else "interface", x, found.velocity)]
        fronts = [self.front(p, q, x, -1) for p, q in zip(lefts, lefts[1:])]
        fronts += middle
        fronts += [self.front(p, q, x, 1) for p, q in zip(rights, rights[1:])]
        if middle:
            cells = [*lefts[1:], *gap, *rights[:-1]]
        else:
            cells = [*lefts[1:], *rights[1:]][: len(fronts) - 1] if len(lefts) > 1 else rights[1:-1]
        return fronts, cells

    def born(self, kind: str, x: float, velocity: float) -> Front:
        return Front(kind, x, velocity, (self.diagram.time, x))

    def from_surface(self, left: Cell, right: Cell, x: float):
        """A wave meets a free surface (or a surface was left alone): zero pressure behind the reflected wave."""
        if left.state is None and right.state is None:
            return [], []
        direction = 1 if left.state is None else -1
        body = right if direction > 0 else left
        par, state = self.laws[body.layer], body.state
        if abs(state.pressure) <= self.least:
            return [Front("surface", x, state.particle_velocity, (self.diagram.time, x))], []
        if state.pressure > 0.0:
            behind = unload(par, state, pressure=0.0, direction=direction)
        else:
            behind = shock(history(par, state), Initial.of(state), pressure=0.0, direction=direction)
        pieces = self.pieces(body, behind, direction)
        surface = Front("surface", x, pieces[-1].state.particle_velocity, (self.diagram.time, x))
        if direction > 0:
            return [surface, *[self.front(b, a, x, 1) for a, b in zip([right, *pieces], pieces)][::-1]], pieces[::-1]
        return [*[self.front(a, b, x, -1) for a, b in zip([left, *pieces], pieces)], surface], pieces

    def pieces(self, ahead: Cell, behind: States, direction: int) -> list[Cell]:
        """The cells behind the steps of a wave, outermost first; none for a wave too weak to follow."""
        change = behind.pressure - ahead.state.pressure
        if abs(change) <= self.least:
            return []
        if change > 0.0:
            return [Cell(ahead.layer, behind)]
        count = max(1, math.ceil(-change / self.step))
        levels = np.linspace(ahead.state.pressure, behind.pressure, count + 1)[1:]
        path = unload(self.laws[ahead.layer], ahead.state, pressure=levels, direction=direction)
        return [Cell(ahead.layer, path[i]) for i in range(count)]

    def front(self, left: Cell, right: Cell, x: float, direction: int) -> Front:
        """The jump between two cells, moving so that mass is conserved."""
        a, b = left.state, right.state
        ahead, behind = (a, b) if direction < 0 else (b, a)
        speed = (b.density * b.particle_velocity - a.density * a.particle_velocity) / (b.density - a.density)
        kind = "shock" if behind.pressure > ahead.pressure else "fan"
        return Front(kind, x, speed, (self.diagram.time, x))

    def finish(self):
        for front in self.diagram.fronts:
            self.diagram.paths.append((front.kind, *front.born, self.diagram.time, front.x))
