r"""The moving mesh: cells between faces, some of which are fronts. No cell straddles a front.

A cell holds the content of its volume (mass, momentum, total energy, and whatever else goes with the mass). Contents change by fluxes
alone: splitting and merging cells, births and meetings of fronts only move them from cell to cell. Volumes and areas are those of planar
(per m^2), cylindrical (per m and radian) or spherical (per steradian) geometry: $V = \int r^{d-1}\,dr$, $A = r^{d-1}$.
"""

from dataclasses import dataclass, field

import numpy as np

EMPTY = -1           # region of a gap between bodies
EMPTY_STATE = (0.0,) * 5


@dataclass
class Front:
    """A face that is followed.

    kind        shock, contact, interface, surface, end, fan head, fan tail
    direction   -1 or +1 for a wave that runs into its left or right neighbour, 0 for what moves with the material
    speed       m/s, of the last step; strength of the wave
    least       cells that the interval on its right is not to fall below (newborn fans)
    since, start, sides   time, place, and states (left, right) that a line of the record begins with
    """

    kind: str
    speed: float
    direction: int = 0
    strength: float = 0.0
    least: int = 1
    since: float = 0.0
    start: float = 0.0
    sides: tuple = (EMPTY_STATE, EMPTY_STATE)


@dataclass
class Mesh:
    """n cells and n + 1 faces, from left to right.

    x (n+1,) m; q (n, 3 + scalars) contents; region (n,) index of the problem's region, EMPTY for a gap; marked (n+1,) whether a face is a
    front; fronts   of the marked faces, in their order; d   1 planar, 2 cylindrical, 3 spherical
    given (n+1, 5)  of faces that were just born: speed, density, velocity, energy, pressure there until the next step is over; else nan
    push (n,)       pressure in cells that are to be born in the next step; else nan
    """

    x: np.ndarray
    q: np.ndarray
    region: np.ndarray
    marked: np.ndarray
    fronts: list[Front]
    d: int
    given: np.ndarray = field(default_factory=lambda: np.empty((0, 5)))
    push: np.ndarray = field(default_factory=lambda: np.empty(0))

    def __post_init__(self):
        if len(self.given) != len(self.x):
            self.given = np.full((len(self.x), 5), np.nan)
            self.push = np.full(len(self.q), np.nan)

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
        self.push = np.insert(self.push, cell, self.push[cell])

    def remove_face(self, face: int) -> None:
        """Join the two cells beside an inner face; a front there is dropped."""
        if self.marked[face]:
            del self.fronts[int(np.count_nonzero(self.marked[:face]))]
        self.q[face - 1] += self.q[face]
        self.q = np.delete(self.q, face, axis=0)
        self.region, self.push = np.delete(self.region, face), np.delete(self.push, face)
        self.x, self.marked = np.delete(self.x, face), np.delete(self.marked, face)
        self.given = np.delete(self.given, face, axis=0)

    def release(self, face: int) -> None:
        """Follow a front no longer; its face becomes one like others."""
        del self.fronts[int(np.count_nonzero(self.marked[:face]))]
        self.marked[face] = False


def mean_area(a, b, d: int):
    """Mean of r^(d-1) over a path from a to b: exact volumes, and exact areas of faces that move at constant speed."""
    if d == 1:
        return np.ones_like(a)
    return 0.5 * (a + b) if d == 2 else (a * a + a * b + b * b) / 3.0


def area(x, d: int):
    """Area of a face."""
    return x ** (d - 1)


class Spacing:
    """The mesh that is aimed at: cells of a region's own width, in curved geometry no wider than SLOPE times their radius.

    A coordinate eta counts cells: faces of an interval stand at equal steps of eta.
    """

    SLOPE = 0.05       # width over radius
    FINEST = 1e-3      # of the region's width: where the slope ends
    CENTRE = 6         # cells, at least, of an interval that reaches the axis or origin (when it is narrower than six cells)

    def __init__(self, d: int, zones: np.ndarray):
        self.d, self.zones = d, zones

    def widths(self, mesh: Mesh) -> np.ndarray:
        """Width (m) aimed at in every cell, before the radius is looked at."""
        ends = np.zeros(len(self.zones))
        inside = mesh.region >= 0
        own = mesh.region % len(self.zones)                  # unburned explosive counts with its products
        np.add.at(ends, own[inside], mesh.width[inside])
        return np.where(inside, (ends / self.zones)[own], 1.0)

    def count(self, r, h):
        """eta(r): cells from the origin."""
        if self.d == 1:
            return r / h
        floor = self.FINEST * h
        near, far = floor / self.SLOPE, h / self.SLOPE
        logs = (1.0 + np.log(np.maximum(r, near) / near)) / self.SLOPE
        whole = (1.0 + np.log(far / near)) / self.SLOPE
        return np.where(r <= near, r / floor, np.where(r <= far, logs, whole + (r - far) / h))

    def place(self, eta, h):
        """The radius of a count."""
        if self.d == 1:
            return eta * h
        floor = self.FINEST * h
        near, far = floor / self.SLOPE, h / self.SLOPE
        start, whole = 1.0 / self.SLOPE, (1.0 + np.log(far / near)) / self.SLOPE
        logs = near * np.exp(np.minimum(eta, whole) * self.SLOPE - 1.0)
        return np.where(eta <= start, eta * floor, np.where(eta <= whole, logs, far + (eta - whole) * h))

    def targets(self, mesh: Mesh, x_new: np.ndarray) -> np.ndarray:
        """Where faces between the fronts should stand, given where the fronts will be (x_new at the marked faces)."""
        at, first, counts, h = self._intervals(mesh)
        a, b = x_new[at[:-1]], x_new[at[1:]]
        own = np.repeat(np.arange(len(first)), counts)
        steps = (np.arange(len(own)) - first[own]) / counts[own]
        if self.d == 1:
            left = a[own] + steps * (b - a)[own]
        else:
            low, high = self._count(a, a, h), self._count(b, a, h)
            central = a == 0.0
            graded = self.place(low[own] + steps * (high - low)[own], h[own])
            left = np.where(central[own], steps * b[own], graded)
            left[first] = a
        return np.append(left, x_new[-1])

    def _count(self, r, start, h):
        return np.where(start == 0.0, r / np.maximum(np.minimum(h, r / self.CENTRE), self.FINEST * h), self.count(r, h))

    def _intervals(self, mesh: Mesh):
        at = mesh.faces()
        first, counts = at[:-1], np.diff(at)
        return at, first, counts, self.widths(mesh)[first]

    def wanted(self, mesh: Mesh) -> np.ndarray:
        """Number of cells (a real number) each interval should have."""
        at, _, _, h = self._intervals(mesh)
        a, b = mesh.x[at[:-1]], mesh.x[at[1:]]
        if self.d == 1:
            return (b - a) / h
        return self._count(b, a, h) - self._count(a, a, h)

    def extents(self, mesh: Mesh) -> np.ndarray:
        """Cells of the width aimed at that every cell is wide."""
        h = self.widths(mesh)
        if self.d == 1:
            return mesh.width / h
        at = mesh.faces()
        start, end = (np.repeat(mesh.x[row], np.diff(at)) for row in (at[:-1], at[1:]))
        graded = self.count(mesh.x[1:], h) - self.count(mesh.x[:-1], h)
        return np.where(start == 0.0, mesh.width / np.maximum(end, 1e-300) * self._count(end, start, h), graded)


FEWER, MORE = 1.25, 0.8      # cells over those wanted beyond which they are merged and split
CALM = 0.1                   # of its heat: how much a cell that is split may turn into motion of its halves
SLIVER = 0.2                 # of the mean of an interval: narrower cells are merged


def adjust(mesh: Mesh, spacing: Spacing, slope) -> None:
    """Split and merge cells until every interval has about the number it should have.

    slope   slope(mesh, cell) -> slopes of density, velocity and energy per m, (3,)
    """
    wanted = spacing.wanted(mesh)
    first, counts = mesh.intervals()
    moved = 0
    for k, (f, n, want) in enumerate(zip(first.tolist(), counts.tolist(), wanted.tolist())):
        f += moved
        least = mesh.fronts[k].least if mesh.fronts[k].speed < mesh.fronts[k + 1].speed else 1    # a fan widens; what closes is no fan
        if mesh.region[f] == EMPTY:
            continue
        size = spacing.extents(mesh)[f:f + n]
        while n > max(FEWER * want + 0.5, least) or n > least and size.min() < SLIVER * size.mean():
            j = int(np.argmin(size[1:] + size[:-1]))
            mesh.remove_face(f + j + 1)
            n, moved = n - 1, moved - 1
            size = spacing.extents(mesh)[f:f + n]
        while n < MORE * want - 0.25:
            j = f + int(np.argmax(spacing.extents(mesh)[f:f + n]))
            split(mesh, j, slope(mesh, j))
            n, moved = n + 1, moved + 1


def split(mesh: Mesh, cell: int, slope) -> None:
    """Halve a cell with slopes (per m) of density, velocity and energy; mass, momentum and total energy stay what they are."""
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
        rows.append(q[0] * share * np.array([1.0, v, e + way * other * rise + 0.5 * v * v, *(q[3:] / q[0])]))
    mesh.insert_face(cell, m, rows[0], q - rows[0])
