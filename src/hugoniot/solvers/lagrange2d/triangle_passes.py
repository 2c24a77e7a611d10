"""Passes of triangles: those of `zone_passes` over three corners instead of four, and further ones for a cell of two triangles.

The two triangles of a cell are processed together, in rows of lower and rows of upper triangles (`mesh.triangles`). The corners a and b are
nodes of one row of nodes each; which node is c depends on the diagonal, so it is gathered first (`gather_thirds`).
"""

from typing import Any, NamedTuple, get_type_hints

from hugoniot.core.binder import bind
from hugoniot.core.ops import fmax
from hugoniot.core.passes import Pass, kind_of, rows_apart, zone_pass
from hugoniot.solvers.lagrange2d import layout as L
from hugoniot.solvers.lagrange2d import node_step, zone_passes
from hugoniot.solvers.lagrange2d.cells import cell, coefficients, power, volume
from hugoniot.solvers.lagrange2d.node_step import LEAST_LEFT
from hugoniot.solvers.lagrange2d.quads import Strains
from hugoniot.solvers.lagrange2d.zone_passes import stress_power

LEAST_ENERGY = 1e-30      # J/kg, beside which no energy of a zone counts
_INSTEAD = {L.Sides: L.Vertices, L.SidesNow: L.VerticesNow, L.Corners: L.VertexForces, node_step.Behind: node_step.OfPairs,
            node_step.Before: node_step.OfPairs}


def _over_triangles(known: Pass) -> Pass:
    """The same loop over rows of triangles."""
    hints = get_type_hints(known.rows)
    name = f"Triangle{known.rows.__name__}"
    fields = [(field, _INSTEAD.get(hints[field], hints[field])) for field in known.rows._fields]
    rows = NamedTuple(name, fields)  # pyrefly: ignore[bad-class-definition]
    rows.__module__ = __name__
    globals()[name] = rows      # where compiled code that is kept looks for it
    return Pass(known.function, rows, known.options)


strain, settle, shape, push, mean_motion = (_over_triangles(known) for known in (
    zone_passes.strain, zone_passes.settle, zone_passes.shape, zone_passes.push, node_step.mean_motion))


class ThirdsOf(NamedTuple):
    """Nodes at the end of the diagonal from a, and beside it; which of them is the third corner -> the third corners."""

    across: L.Points
    beside: L.Points
    way: Any
    c: L.Points


class RestOf(NamedTuple):
    """Corners, planar forces that no stress gives -> corner forces with them."""

    corners: L.Vertices
    g: L.VertexForces
    f: L.VertexForces


class LookOf(NamedTuple):
    """Corners of the lower and the upper triangles at the end and in the middle of the step -> how many triangles are tangled."""

    low: L.Positions
    high: L.Positions
    low_ahead: L.Positions
    high_ahead: L.Positions
    middle_low: L.Positions
    middle_high: L.Positions
    middle_low_ahead: L.Positions
    middle_high_ahead: L.Positions
    way: Any
    tangled: Any


@zone_pass(ThirdsOf)
def gather_thirds(count, z, dt, numbers, law):
    """Third corners of triangles: across the diagonal from a where `way` is 1, beside a where it is 0."""
    rows_apart()
    for j in range(count):
        over = z.way[j] > 0.5
        z.c.x[j] = z.across.x[j] if over else z.beside.x[j]
        z.c.y[j] = z.across.y[j] if over else z.beside.y[j]
        z.c.u[j] = z.across.u[j] if over else z.beside.u[j]
        z.c.v[j] = z.across.v[j] if over else z.beside.v[j]


@zone_pass(RestOf)
def add_rest(count, z, dt, numbers, law):
    """Planar forces added with the weights of the geometry; numbers: the radius used for the axis."""
    rows_apart()
    geometry, f, g = kind_of(law), z.f, z.g
    for j in range(count):
        b = coefficients(cell(z.corners, j), numbers[L.NEAR], geometry)
        f.f0x[j] += b.w0 * g.f0x[j]
        f.f0y[j] += b.w0 * g.f0y[j]
        f.f1x[j] += b.w1 * g.f1x[j]
        f.f1y[j] += b.w1 * g.f1y[j]
        f.f2x[j] += b.w2 * g.f2x[j]
        f.f2y[j] += b.w2 * g.f2y[j]


def doubled(a, b, c, j):
    """Twice the area of the triangle j."""
    return (b.x[j] - a.x[j]) * (c.y[j] - a.y[j]) - (b.y[j] - a.y[j]) * (c.x[j] - a.x[j])


def robbed(middle, end):
    """1 where the area has become too small, or negative, since the middle of the step; 0 elsewhere."""
    return 0.0 if end > LEAST_LEFT * middle and end > 0.0 else 1.0


@zone_pass(LookOf, exact=True)
def look(count, z, dt, numbers, law):
    """How many triangles of a row of cells the step has inverted, or has robbed of so much of their area that it was too long."""
    rows_apart()
    bad = 0.0
    for j in range(count):
        if z.way[j] > 0.5:
            bad += robbed(doubled(z.middle_low, z.middle_high, z.middle_high_ahead, j), doubled(z.low, z.high, z.high_ahead, j))
            bad += robbed(doubled(z.middle_high_ahead, z.middle_low_ahead, z.middle_low, j), doubled(z.high_ahead, z.low_ahead, z.low, j))
        else:
            bad += robbed(doubled(z.middle_low, z.middle_high, z.middle_low_ahead, j), doubled(z.low, z.high, z.low_ahead, j))
            bad += robbed(doubled(z.middle_high_ahead, z.middle_low_ahead, z.middle_high, j), doubled(z.high_ahead, z.low_ahead, z.high, j))
    z.tangled[0] += bad


# -- work divided anew between both triangles of a cell -----------------------------------------------------------------------
class OwnWorkOf(NamedTuple):
    """Corners, forces, strain rates, stress in the middle of the step -> energy by the work of the stress, and what that is beyond the
    work of the forces, J."""

    corners: L.Vertices
    f: L.VertexForces
    d: L.Rates
    p: Any
    s: L.Tensor
    q: L.Stress
    inverse_mass: Any
    e: Any
    beyond: Any


class GiveBackOf(NamedTuple):
    """Inverse masses, and work beyond that of the forces, of both triangles of a cell -> their energies."""

    im1: Any
    im2: Any
    beyond1: Any
    beyond2: Any
    e1: Any
    e2: Any


class WorkOf(NamedTuple):
    """Positions, inverse masses, pressures and volume rates (over volume) of both triangles of a cell -> their energies."""

    one: L.VerticesNow
    other: L.VerticesNow
    im1: Any
    im2: Any
    p1: Any
    p2: Any
    d1: Any
    d2: Any
    e1: Any
    e2: Any


class PairOf(NamedTuple):
    """Inverse masses, and a row of each triangle of a cell -> their mean by mass in both rows."""

    im1: Any
    im2: Any
    one: Any
    other: Any


class DensityOf(NamedTuple):
    """Specific volumes -> densities."""

    v: Any
    rho: Any


@zone_pass(OwnWorkOf)
def take_own_work(count, z, dt, numbers, law):
    """The work of a triangle's stress on its own strain in place of that of its forces."""
    rows_apart()
    geometry = kind_of(law)
    for j in range(count):
        d = Strains(z.d.xx[j], z.d.yy[j], z.d.xy[j], z.d.spin[j], z.d.hoop[j], z.d.dilation[j])
        beyond = dt * (volume(cell(z.corners, j), geometry) * stress_power(z, j, d) + power(z.f, z.corners, j))
        z.e[j] += z.inverse_mass[j] * beyond
        z.beyond[j] = beyond


@zone_pass(GiveBackOf)
def give_back(count, z, dt, numbers, law):
    """What both triangles of a cell have taken beyond the work of their forces, given back by their energies, so that a cold one does not
    pay for a hot one: the cell has that work again."""
    rows_apart()
    for j in range(count):
        e1, e2 = fmax(z.e1[j], -z.e1[j]) + LEAST_ENERGY, fmax(z.e2[j], -z.e2[j]) + LEAST_ENERGY
        part = (z.beyond1[j] + z.beyond2[j]) / (e1 / z.im1[j] + e2 / z.im2[j])
        z.e1[j] -= part * e1
        z.e2[j] -= part * e2


@zone_pass(WorkOf)
def share_work(count, z, dt, numbers, law):
    """Divide the work of the pressure between both triangles of a cell by their masses, instead of by their own changes of volume."""
    rows_apart()
    geometry = kind_of(law)
    for j in range(count):
        m1, m2 = 1.0 / z.im1[j], 1.0 / z.im2[j]
        work1 = z.p1[j] * volume(cell(z.one, j), geometry) * z.d1[j]
        work2 = z.p2[j] * volume(cell(z.other, j), geometry) * z.d2[j]
        both = (work1 + work2) / (m1 + m2)
        z.e1[j] += dt * (work1 * z.im1[j] - both)
        z.e2[j] += dt * (work2 * z.im2[j] - both)


@zone_pass(PairOf)
def average(count, z, dt, numbers, law):
    """The mean by mass of both triangles of a cell."""
    rows_apart()
    for j in range(count):
        m1, m2 = 1.0 / z.im1[j], 1.0 / z.im2[j]
        mean = (m1 * z.one[j] + m2 * z.other[j]) / (m1 + m2)
        z.one[j] = mean
        z.other[j] = mean


@zone_pass(DensityOf)
def density(count, z, dt, numbers, law):
    """Density from the specific volume."""
    rows_apart()
    for j in range(count):
        z.rho[j] = 1.0 / z.v[j]


bind(doubled)
bind(robbed)
