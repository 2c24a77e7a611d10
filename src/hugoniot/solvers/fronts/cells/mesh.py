r"""The moving mesh: cells between faces, some of which are fronts. No cell straddles a front.

A cell holds the content of its volume (mass, momentum, total energy, and whatever else goes with the mass). Contents change by fluxes
alone: splitting and merging cells, births and meetings of fronts only move them from cell to cell. Volumes and areas are those of planar
(per m^2), cylindrical (per m and radian) or spherical (per steradian) geometry: $V = \int r^{d-1}\,dr$, $A = r^{d-1}$.
"""

from dataclasses import dataclass, field

import numpy as np

from hugoniot.solvers.fronts.cells import fans
from hugoniot.solvers.fronts.cells.spacing import Spacing
from hugoniot.solvers.fronts.cells.tables import EMPTY, FEWER, MORE, SLIVER
from hugoniot.solvers.fronts.line import Piece

EMPTY_STATE = (0.0,) * 5


@dataclass
class Front:
    """A face that is followed.

    kind        shock, contact, interface, surface, end, fan head, fan tail
    direction   -1 or +1 for a wave that runs into its left or right neighbour, 0 for what moves with the material
    speed       m/s, of the last step; strength of the wave
    least       cells that the interval on its right is not to fall below (newborn fans)
    since, start, sides   time, place, and states (left, right) that a line of the record begins with
    fan         on the right of its left edge: a centred fan that nothing has reached (fans.py)
    """

    kind: str
    speed: float
    direction: int = 0
    strength: float = 0.0
    least: int = 1
    since: float = 0.0
    start: float = 0.0
    sides: tuple = (EMPTY_STATE, EMPTY_STATE)
    fan: Piece | None = None


@dataclass
class Mesh:
    """n cells and n + 1 faces, from left to right.

    x (n+1,) m; q (n, 3 + scalars) contents; region (n,) index of the problem's region, EMPTY for a gap; marked (n+1,) whether a face is a
    front; fronts   of the marked faces, in their order; d   1 planar, 2 cylindrical, 3 spherical
    given (n+1, 5 + scalars)   of faces that were just born: speed, density, velocity, energy, pressure there (and what goes with the
                    mass behind a wave) until the next step is over, of a fan as long as it is self-similar; else nan
    push (n,)       pressure in cells that are to be born in the next step; else nan
    level (n,)      how often a cell is halved for its burning (refining.py)
    """

    x: np.ndarray
    q: np.ndarray
    region: np.ndarray
    marked: np.ndarray
    fronts: list[Front]
    d: int
    given: np.ndarray = field(default_factory=lambda: np.empty((0, 5)))
    push: np.ndarray = field(default_factory=lambda: np.empty(0))
    level: np.ndarray = field(default_factory=lambda: np.empty(0, dtype=np.int64))

    def __post_init__(self):
        if len(self.given) != len(self.x):
            self.given = np.full((len(self.x), 2 + self.q.shape[1]), np.nan)
            self.push = np.full(len(self.q), np.nan)
        if len(self.level) != len(self.q):
            self.level = np.zeros(len(self.q), dtype=np.int64)

    # -- geometry ----------------------------------------------------------------------------------------------------
    @property
    def width(self) -> np.ndarray:
        return np.diff(self.x)

    @property
    def middle(self) -> np.ndarray:
        return 0.5 * (self.x[1:] + self.x[:-1])

    def volume(self) -> np.ndarray:
        """Volume of every cell."""
        return self.width * mean_area(self.x[:-1], self.x[1:], self.d)

    def full(self) -> np.ndarray:
        """Whether a cell holds material: not a gap, and no cell that has yet to be born."""
        return (self.region != EMPTY) & np.isnan(self.push)

    def faces(self) -> np.ndarray:
        """Indices of the faces that are fronts."""
        return np.flatnonzero(self.marked)

    def shares(self, first: int, count: int) -> np.ndarray:
        """How wide some cells are to be beside one that is not halved."""
        return 0.5 ** self.level[first:first + count]

    def intervals(self) -> tuple[np.ndarray, np.ndarray]:
        """(first cells, numbers of cells) of the runs of cells between two fronts."""
        at = self.faces()
        return at[:-1], np.diff(at)

    # -- topology ----------------------------------------------------------------------------------------------------
    def insert_face(self, cell: int, position: float, left, right) -> None:
        """Cut a cell at a position into two of the given contents."""
        self.x = np.insert(self.x, cell + 1, position)
        self.marked = np.insert(self.marked, cell + 1, False)
        self.given = np.insert(self.given, cell + 1, np.nan, axis=0)
        self.q = np.insert(self.q, cell, left, axis=0)
        self.q[cell + 1] = right
        self.region = np.insert(self.region, cell, self.region[cell])
        self.push, self.level = (np.insert(row, cell, row[cell]) for row in (self.push, self.level))

    def remove_face(self, face: int) -> None:
        """Join the two cells beside an inner face; a front there is dropped."""
        if self.marked[face]:
            del self.fronts[int(np.count_nonzero(self.marked[:face]))]
        self.q[face - 1] += self.q[face]
        self.q = np.delete(self.q, face, axis=0)
        self.level[face - 1] = self.level[face - 1:face + 1].min()
        self.region, self.push, self.level = (np.delete(row, face) for row in (self.region, self.push, self.level))
        self.x, self.marked = np.delete(self.x, face), np.delete(self.marked, face)
        self.given = np.delete(self.given, face, axis=0)

    def release(self, face: int) -> None:
        """Follow a front no longer; its face becomes one like others."""
        self.touch(face, face)
        del self.fronts[int(np.count_nonzero(self.marked[:face]))]
        self.marked[face] = False

    def touch(self, first: int, last: int) -> None:
        """Something happens at the fronts from one face to another: fans beside them are no longer self-similar."""
        for front, a, b in zip(self.fronts, *(self.faces()[k:] for k in (0, 1))):
            if front.fan is not None and a <= last and b >= first:
                front.fan = None
                if np.isnan(self.push[a]):
                    self.given[a:b + 1] = np.nan


def mean_area(a, b, d: int):
    """Mean of r^(d-1) over a path from a to b: exact volumes, and exact areas of faces that move at constant speed."""
    if d == 1:
        return np.ones_like(a)
    return 0.5 * (a + b) if d == 2 else (a * a + a * b + b * b) / 3.0


ABOUT = 0.9                  # of the widest cell: as good to split
CALM = 0.1                   # of its heat: how much a cell that is split may turn into motion of its halves


def adjust(mesh: Mesh, spacing: Spacing, slope, solid) -> None:
    """Split and merge cells until every interval has about the number it should have.

    slope   slope(mesh, cell) -> slopes of density, velocity, energy and scalars per m, (nvar,)
    solid   (regions,) whether a region has strength
    """
    wanted, widths = spacing.wanted(mesh), spacing.widths(mesh)
    first, counts = mesh.intervals()
    moved, heights = 0, [float(widths[f]) for f in first]
    for k, (f, n, want, h) in enumerate(zip(first.tolist(), counts.tolist(), wanted, heights)):
        f += moved
        least = mesh.fronts[k].least if mesh.fronts[k].speed < mesh.fronts[k + 1].speed else 1    # a fan widens; what closes is no fan
        if mesh.region[f] == EMPTY:
            continue
        share = mesh.shares(f, n)
        size = spacing.extents(mesh, f, n, h) / share
        while n > least and (share.sum() > max(FEWER * want + 0.5, least) or size.min() < SLIVER * size.mean()):
            j = int(np.argmin(size[1:] + size[:-1]))
            mesh.remove_face(f + j + 1)
            n, moved = n - 1, moved - 1
            share = mesh.shares(f, n)
            size = spacing.extents(mesh, f, n, h) / share
        while mesh.shares(f, n).sum() < MORE * want - 0.25:
            j = f + _roomiest(spacing.extents(mesh, f, n, h) / mesh.shares(f, n), mesh.fronts[k:k + 2])
            fan = mesh.fronts[k].fan
            if fan is None:
                split(mesh, j, slope(mesh, j), bool(solid[mesh.region[j] % len(solid)]))
            else:
                fans.divide(mesh, j, fan, bool(solid[mesh.region[j] % len(solid)]))
            n, moved = n + 1, moved + 1


def _roomiest(extents: np.ndarray, ends) -> int:
    """The cell to split: of those about as wide as the widest the one farthest from shocks, behind which profiles are steep."""
    at = np.arange(len(extents))
    away = [at[::way] for front, way in zip(ends, (1, -1)) if front.kind in ("shock", "elastic shock", "elastic expansion", "detonation")]
    if not away:
        return int(np.argmax(extents))
    return int(np.argmax(np.where(extents > ABOUT * extents.max(), np.minimum.reduce(away), -1)))


def split(mesh: Mesh, cell: int, slope, solid: bool = False) -> None:
    """Halve a cell with slopes (per m) of density, velocity, energy and scalars; mass, momentum and total energy stay what they are.

    solid   the scalars are those of a solid: its stretch is one over volumes, its hoop strain has either sign
    """
    a, b = mesh.x[cell], mesh.x[cell + 1]
    m = 0.5 * (a + b)
    left, right = (m - a) * mean_area(a, m, mesh.d), (b - m) * mean_area(m, b, mesh.d)
    whole, q, away = left + right, mesh.q[cell], 0.5 * (b - a)      # the middles of the halves are half a width apart
    lean = np.clip(slope[0] * away * right / q[0], -0.5, 0.5)       # neither half is left nearly empty
    mass = q[0] * left / whole * (1.0 - lean)
    low, high = mass / q[0], 1.0 - mass / q[0]
    u, jump = q[1] / q[0], slope[1] * away
    e = q[2] / q[0] - 0.5 * u * u
    most = 2.0 * CALM * max(e, 0.0) / (low * high)                  # what the halves' motion apart may take of the heat
    jump = np.sign(jump) * min(abs(jump), np.sqrt(most))
    e -= 0.5 * low * high * jump * jump
    rise = slope[2] * away
    rows = []
    for share, other, way in ((low, high, -1.0), (high, low, 1.0)):
        v = u + way * other * jump
        scalars = q[3:] / q[0] + way * other * slope[3:] * away
        scalars = scalars if solid else np.clip(scalars, 0.0, None)
        rows.append(q[0] * share * np.array([1.0, v, e + way * other * rise + 0.5 * v * v, *scalars]))
    if solid:
        rows[0][4] = q[4] * left / whole - slope[4] * away * left * right / whole
    mesh.insert_face(cell, m, rows[0], q - rows[0])
