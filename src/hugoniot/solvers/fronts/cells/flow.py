r"""Between the fronts: states in the cells and at their faces, second order in space and time, without any viscosity.

Density, velocity and energy are parabolas with the averages of three cells; beside a front the stencil is one-sided, and no stencil reaches
across. Increments to a face are limited by the differences to the neighbours, but where curvature is smooth. Face states move half a step
on with the flow equations (d = 1, 2, 3),

$$\rho_t = -u\rho_x - \rho\left(u_x + \tfrac{d-1}{r}u\right), \quad u_t = -uu_x - p_x/\rho, \quad
  e_t = -ue_x - \tfrac{p}{\rho}\left(u_x + \tfrac{d-1}{r}u\right),$$

and with their own face (velocity w): $q + \tfrac12\Delta t\,(q_t + w q_x)$. The two states at a face meet in an HLLC problem, read
off at w.

Sources: van Leer, J. Comput. Phys. 32 (1979) 101 (MUSCL, Hancock's predictor); Toro, Riemann Solvers, 10.4 and 14.4; Colella and
Woodward, J. Comput. Phys. 54 (1984) 174 (parabolas).
"""

from typing import NamedTuple

import numpy as np

from hugoniot.errors import UnphysicalState
from hugoniot.laws.arrays import float_parameters
from hugoniot.solvers.fronts.cells.mesh import EMPTY, Mesh

COLD = 1e-10      # c^2 over u^2 below which a negative square is rounding


class Media:
    """Equations of state of the regions, asked for rows of states; None for unburned explosive, which has no pressure."""

    def __init__(self, laws):
        self.laws = [None if law is None else float_parameters(law) for law in laws]

    def __call__(self, region, rho, e):
        """(p, dp/drho, dp/de) for states (n,) or (n, m) of cells in the given regions; a gap has none (0)."""
        from hugoniot.solvers.fronts.cells.kernels import states

        found = np.zeros((3, *rho.shape))
        cuts = [0, *(np.flatnonzero(np.diff(region)) + 1).tolist(), len(region)]
        for a, b in zip(cuts, cuts[1:]):
            if region[a] != EMPTY and self.laws[region[a]] is not None:
                out = [np.empty(rho[a:b].size) for _ in range(3)]
                states(rho[a:b].ravel(), e[a:b].ravel(), self.laws[region[a]], *out)
                for row, values in zip(found, out):
                    row[a:b] = values.reshape(rho[a:b].shape)
        return found


class Cells(NamedTuple):
    """Averages: w (n, 3 + scalars) density, velocity, energy and what goes with the mass; p, c, and p's slopes."""

    w: np.ndarray
    p: np.ndarray
    c: np.ndarray
    p_rho: np.ndarray
    p_e: np.ndarray


def sound(p, p_rho, p_e, rho, u):
    """c from the slopes; nan where c^2 is negative by more than rounding."""
    square = p_rho + p * p_e / np.maximum(rho * rho, 1e-300)
    square = np.where((square < 0.0) & (square > -COLD * (u * u)), 0.0, square)
    with np.errstate(invalid="ignore"):
        return np.sqrt(square)


def averages(mesh: Mesh, media: Media) -> Cells:
    """States of the cells; those of a gap, and of cells about to be born, are zero."""
    full = mesh.full()
    w = np.zeros_like(mesh.q)
    w[:, 0] = mesh.q[:, 0] / np.where(full, mesh.volume(), 1.0)
    w[:, 1:] = mesh.q[:, 1:] / np.where(full, mesh.q[:, 0], 1.0)[:, None]
    w[:, 2] -= 0.5 * w[:, 1] ** 2
    w[~full] = 0.0
    p, p_rho, p_e = media(mesh.region, w[:, 0], w[:, 2])
    return Cells(w, p, sound(p, p_rho, p_e, w[:, 0], w[:, 1]), p_rho, p_e)


def check(mesh: Mesh, cells: Cells, time: float, cycle: int) -> None:
    """Raise `UnphysicalState` for the first cell without a sound state."""
    bad = mesh.full() & ~((cells.w[:, 0] > 0.0) & (cells.c >= 0.0) & np.isfinite(cells.p) & (mesh.width > 0.0))
    if bad.any():
        k = int(np.argmax(bad))
        rho, u, e = cells.w[k, :3]
        raise UnphysicalState(f"a cell of density {rho:.6g} kg/m3 and energy {e:.6g} J/kg has no sound state (velocity {u:.6g} m/s)",
                              "stay inside the range of the equation of state, take more zones or a smaller solver.options.courant",
                              k, "", float(mesh.middle[k]), time, cycle)


# -- parabolas -----------------------------------------------------------------------------------------------------------
def _moments(mesh: Mesh):
    """(m, first, second): middle of each cell, and the averages over its volume of x - m and (x - m)^2."""
    m, h = mesh.middle, mesh.width
    if mesh.d == 1:
        return m, np.zeros_like(m), h * h / 12.0
    if mesh.d == 2:
        return m, h * h / (12.0 * m), h * h / 12.0
    volume = m * m + h * h / 12.0
    return m, m * h * h / (6.0 * volume), (m * m * h * h / 12.0 + h**4 / 80.0) / volume


def _about(moments, k, i):
    """Averages over cells i of (x - x_k) and its square, x_k the middle of cells k."""
    m, first, second = moments
    away = m[i] - m[k]
    return away + first[i], away * away + 2.0 * away * first[i] + second[i]


def reconstruct(mesh: Mesh, w: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(left, right) values of every cell at its faces, (n, nvar) each."""
    n = len(w)
    full = mesh.full()
    has_left, has_right = ~mesh.marked[:-1] & full, ~mesh.marked[1:] & full
    i = np.arange(n)
    both = has_left & has_right
    k = np.clip(i + (~has_left & has_right) - (has_left & ~has_right), 0, n - 1)
    moments = _moments(mesh)
    slope, curve = _parabolas(w, both, moments)
    inside = both[k]
    one, two = _about(moments, k, i)
    values = []
    for x in (mesh.x[:-1], mesh.x[1:]):
        s = x - moments[0][k]
        step = slope[k] * (s - one)[:, None] + curve[k] * (s * s - two)[:, None]
        values.append(np.where(inside[:, None], step, 0.0))
    # intervals of two cells: straight lines
    pair = ~inside & (has_left | has_right)
    if pair.any():
        j = np.where(has_right, i + 1, i - 1)[pair]
        p = i[pair]
        gradient = (w[j] - w[p]) / (moments[0][j] + moments[1][j] - moments[0][p] - moments[1][p])[:, None]
        centre = (moments[0] + moments[1])[p]
        values[0][pair] = gradient * (mesh.x[:-1][pair] - centre)[:, None]
        values[1][pair] = gradient * (mesh.x[1:][pair] - centre)[:, None]
    _limit(w, values, has_left, has_right, _smooth(curve, both)[k] & inside[:, None])
    return w + values[0], w + values[1]


def _parabolas(w, both, moments):
    """Slope and curvature (half the second derivative) at the middles of cells with two neighbours; zero elsewhere."""
    slope, curve = np.zeros_like(w), np.zeros_like(w)
    k = np.flatnonzero(both)
    if len(k):
        one, two = _about(moments, k, k)
        (right1, right2), (left1, left2) = _about(moments, k, k + 1), _about(moments, k, k - 1)
        a, b, c, d = right1 - one, right2 - two, left1 - one, left2 - two
        up, down = w[k + 1] - w[k], w[k - 1] - w[k]
        det = (a * d - c * b)[:, None]
        slope[k] = (up * d[:, None] - down * b[:, None]) / det
        curve[k] = (a[:, None] * down - c[:, None] * up) / det
    return slope, curve


def _smooth(curve, both):
    """Whether the curvature is about the same in a cell and its neighbours: then an extremum is one of the flow, and kept."""
    size, sign = np.abs(curve), np.sign(curve)
    result = np.repeat(both[:, None], curve.shape[1], axis=1)
    lone = np.ones_like(both)
    for near in (-1, 1):
        other = np.roll(both, -near) & both
        c, s = np.roll(size, -near, axis=0), np.roll(sign, -near, axis=0)
        alike = (s == sign) & (c < 3.0 * size) & (size < 3.0 * c)
        result &= alike | ~other[:, None]
        lone &= ~other
    return result & ~lone[:, None]


def _limit(w, values, has_left, has_right, smooth) -> None:
    """Limit the increments to both faces by the differences to the neighbours, in place."""
    up = np.zeros_like(w)
    up[:-1] = w[1:] - w[:-1]
    down = np.zeros_like(w)
    down[1:] = up[:-1]
    up = np.where(has_right[:, None], up, down)
    down = np.where(has_left[:, None], down, up)
    most = np.where(up * down > 0.0, np.minimum(np.abs(up), np.abs(down)), 0.0)
    sign = np.sign(up)
    for value, way in zip(values, (-1.0, 1.0)):
        held = way * sign * np.clip(way * sign * value, 0.0, most)
        value[:] = np.where(smooth, value, held)


# -- Hancock's half step ---------------------------------------------------------------------------------------------------
def predict(mesh: Mesh, cells: Cells, left, right, speed, dt: float, sources=None):
    """(left, right, middle) states after half a step at both faces, which move at `speed` (n+1,), and in the middle of every cell."""
    full = mesh.full()
    slope = (right - left) / np.where(full, mesh.width, 1.0)[:, None]
    rho, u, _ = cells.w[:, :3].T
    bulge = 0.0 if mesh.d == 1 else (mesh.d - 1) * u / mesh.middle
    rate = -u[:, None] * slope
    with np.errstate(all="ignore"):
        rate[:, 0] -= rho * (slope[:, 1] + bulge)
        rate[:, 1] -= (cells.p_rho * slope[:, 0] + cells.p_e * slope[:, 2]) / rho
        rate[:, 2] -= cells.p / rho * (slope[:, 1] + bulge)
    if sources is not None:
        rate += sources
    rate[~full] = 0.0
    half = 0.5 * dt
    return (left + half * (rate + speed[:-1, None] * slope), right + half * (rate + speed[1:, None] * slope), cells.w + half * rate)


class Sides(NamedTuple):
    """States of every cell at its left and right face and in its middle, (n, 3, nvar), with their p and c (n, 3)."""

    w: np.ndarray
    p: np.ndarray
    c: np.ndarray


def sides(mesh: Mesh, cells: Cells, media: Media, predicted) -> Sides:
    """The predicted states with their pressures; a cell in which one is not sound keeps its average."""
    w = np.stack(predicted, axis=1)
    p, p_rho, p_e = media(mesh.region, w[:, :, 0], w[:, :, 2])
    c = sound(p, p_rho, p_e, w[:, :, 0], w[:, :, 1])
    bad = ~((w[:, :, 0] > 0.0) & (c >= 0.0) & np.isfinite(p)).all(axis=1)
    if bad.any():
        w[bad], p[bad], c[bad] = cells.w[bad][:, None], cells.p[bad][:, None], cells.c[bad][:, None]
    return Sides(w, p, c)


# -- faces ---------------------------------------------------------------------------------------------------------------
class Faces(NamedTuple):
    """At every face (n+1,): its speed w, and density, velocity, total energy per mass and pressure there; scalars (n+1, k)."""

    speed: np.ndarray
    rho: np.ndarray
    u: np.ndarray
    energy: np.ndarray
    p: np.ndarray
    scalars: np.ndarray


def hllc(side: Sides, speed: np.ndarray) -> Faces:
    """The HLLC state at inner faces that move at `speed`; the outermost two faces are left at zero."""
    wl, wr = side.w[:-1, 1], side.w[1:, 0]
    pl, pr, cl, cr = side.p[:-1, 1], side.p[1:, 0], side.c[:-1, 1], side.c[1:, 0]
    (rl, ul, el), (rr, ur, er) = wl[:, :3].T, wr[:, :3].T
    at = speed[1:-1]
    low, high = np.minimum(ul - cl, ur - cr), np.maximum(ul + cl, ur + cr)
    ml, mr = rl * (low - ul), rr * (high - ur)           # mass fluxes into the waves, negative and positive
    gap = mr - ml
    with np.errstate(all="ignore"):
        star = np.where(gap > 0.0, (pl - pr + mr * ur - ml * ul) / gap, 0.5 * (ul + ur))
        p = np.where(gap > 0.0, 0.5 * (pl + ml * (star - ul) + pr + mr * (star - ur)), 0.5 * (pl + pr))
    left = at <= star
    rho, u, e, p0, m, edge = (np.where(left, a, b) for a, b in ((rl, rr), (ul, ur), (el, er), (pl, pr), (ml, mr), (low, high)))
    outside = np.where(left, at <= low, at >= high) | (m == 0.0)
    whole = e + 0.5 * u * u
    with np.errstate(all="ignore"):
        inner = (m / (edge - star), star, whole + (p * star - p0 * u) / m, p)
    found = [np.where(outside, a, b) for a, b in zip((rho, u, whole, p0), inner)]
    scalars = np.where(left[:, None], wl[:, 3:], wr[:, 3:])
    ends = [np.pad(row, 1) for row in found]
    return Faces(speed.copy(), *ends, np.pad(scalars, ((1, 1), (0, 0))))


def fluxes(face: Faces) -> np.ndarray:
    """Of mass, momentum, total energy and scalars through moving faces, per area, (n+1, nvar)."""
    mass = face.rho * (face.u - face.speed)
    rows = [mass, mass * face.u + face.p, mass * face.energy + face.p * face.u]
    return np.column_stack([*rows, mass[:, None] * face.scalars])
