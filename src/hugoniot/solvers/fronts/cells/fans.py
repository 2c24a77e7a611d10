r"""Centred fans in planar geometry, kept as what they are: self-similar, until something reaches them.

A fan between two constant states is a function of $\xi = (x - x_0)/(t - t_0)$ alone. Its faces run at constant $\xi$ and carry the
constant states there, so that the contents of its cells stay exact, $(t - t_0)\,[\xi U - F(U)]$ between two faces, whatever the step. This
ends when the material beside one of its edges changes (`let_go`), or when an edge meets another front (`Mesh.touch`). In a solid it is the
plastic release between the elastic one and the state behind; its stretch is that of the yield point throughout.
"""

import math

import numba as nb
import numpy as np

from hugoniot.core.target import BY_ADDRESS
from hugoniot.laws.riemann.branch import State, elastic
from hugoniot.laws.riemann.curve import Wave
from hugoniot.laws.riemann.fan import Fan
from hugoniot.laws.riemann.medium import Frozen
from hugoniot.solvers.fronts.cells.tables import FACE, FAN, FULL, MEAN, VOLUME, E, P, U
from hugoniot.solvers.fronts.line import Piece, densities, fan_state, fluxes

SAME = 1e-9        # of the density, and of signal speeds: a state beside a fan that differs by more is no longer the one it began with


@nb.njit(**BY_ADDRESS)
def changed(grid, w, face, cell):
    """Whether the cell outside an edge of a fan has another state than the edge."""
    if not 0 <= cell < len(grid.q) or w[FULL, cell] == 0.0:
        return False
    speed, rho, u, e, p = grid.given[face, 0], grid.given[face, 1], grid.given[face, 2], grid.given[face, 3], grid.given[face, 4]
    signal = SAME * abs(speed - u)
    return not (abs(w[MEAN, cell] - rho) <= SAME * rho and abs(w[MEAN + U, cell] - u) <= signal
                and abs(w[MEAN + E, cell] - e) <= signal * abs(speed - u) and abs(w[MEAN + P, cell] - p) <= rho * signal * abs(speed - u))


@nb.njit(**BY_ADDRESS)
def let_go(grid, w, fronts, count):
    """Fans beside which the state has changed go on as other cells do."""
    for k in range(count - 1):
        a, b = int(fronts[k, FACE]), int(fronts[k + 1, FACE])
        if fronts[k, FAN] > 0.0 and math.isnan(grid.push[a]) and (changed(grid, w, a, a - 1) or changed(grid, w, b, b)):
            fronts[k, FAN] = 0.0
            grid.given[a:b + 1] = math.nan


@nb.njit(**BY_ADDRESS)
def forget(grid, fronts, count):
    """After a step: the states of newborn faces have done their part, but for those of fans that last."""
    lasts = False
    for k in range(count - 1):
        before, lasts = lasts, fronts[k, FAN] > 0.0
        for f in range(int(fronts[k, FACE]), int(fronts[k + 1, FACE])):
            if not lasts and not (before and f == int(fronts[k, FACE])):
                grid.given[f] = math.nan
    if not lasts:
        grid.given[int(fronts[count - 1, FACE])] = math.nan


def lasting(piece: Piece, d: int, bench) -> bool:
    """Whether a fan is self-similar: in planar geometry, where nothing burns."""
    matter = bench.of(piece)
    return piece.kind == "fan" and d == 1 and not isinstance(matter.par, Frozen)


def divide(mesh, cell: int, fan: Piece, solid: bool) -> None:
    """Halve a cell of a fan exactly."""
    (first, *start), (last, *_) = mesh.given[cell:cell + 2]
    age, xi = (mesh.x[cell + 1] - mesh.x[cell]) / (last - first), 0.5 * (first + last)
    found, q = fan_state(fan, xi), mesh.q[cell]
    low, high = State(*start[:4]), found
    left = np.empty_like(q)
    left[:3] = age * ((xi * densities(high) - fluxes(high)) - (first * densities(low) - fluxes(low)))
    left[3:] = q[3:] * left[0] / q[0]
    if solid:
        left[VOLUME] = 0.5 * q[VOLUME]        # the stretch is uniform
    scalars = mesh.given[cell, 5:].copy()
    mesh.insert_face(cell, 0.5 * (mesh.x[cell] + mesh.x[cell + 1]), left, q - left)
    mesh.given[cell + 1] = [xi, *found[:4], *scalars]


def numbers_of(fan: Piece) -> list[float]:
    """A fan as numbers, for a checkpoint."""
    wave = fan.wave
    return [fan.region, wave.direction, wave.head, wave.tail, *wave.ahead, *wave.behind, wave.path.branch.a, wave.path.branch.b]


def fan_of(numbers, bench) -> Piece:
    """The fan of these numbers."""
    region, direction, head, tail, *rest, a, b = numbers
    ahead, behind = State(*rest[:len(rest) // 2]), State(*rest[len(rest) // 2:])
    path = Fan(ahead, elastic(bench.matters[int(region)], ahead)._replace(a=a, b=b))
    return Piece("fan", int(region), ahead, Wave("fan", False, int(direction), ahead, behind, head, tail, path))
