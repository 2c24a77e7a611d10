r"""Body force and heat sources, which act throughout the material.

A body force accelerates every node by g(t), in curved geometry by $g(t)(r/R)^n$; its work is recorded node by node. A heat source
gives zone j the energy $w_j\int f\,dt$ per mass in a step, with the exact integral of its history f, so that the energy supplied does not
depend on the steps. The weights $w_j$ represent the profile in depth, in Lagrangian coordinates: the power A f enters through a face of
area A, and the zone between the depths $d_1, d_2$ absorbs the fraction $e^{-d_1/\delta} - e^{-d_2/\delta}$ of it (Beer's law along the
radius).

Source: Herrmann 2.3 and 2.4 (body force), 2.16 and 2.18 (energy supply).
"""

from collections import namedtuple
from typing import Any, NamedTuple

import numba as nb
import numpy as np

from hugoniot.core.passes import rows_apart, zone_pass
from hugoniot.core.target import BY_ADDRESS
from hugoniot.problem.model import Problem
from hugoniot.solvers.lagrange1d import layout as L
from hugoniot.solvers.lagrange1d.assemble import history
from hugoniot.solvers.lagrange1d.field import field_at
from hugoniot.solvers.lagrange1d.layout import H, Z
from hugoniot.solvers.lagrange1d.nodes import add_impulse
from hugoniot.solvers.lagrange1d.pulses import pulse_integral

NO_FORCE = -1.0    # code of the shape of no pulse
STIFFEST = 6.0     # c^2 over the energy of what has been heated: Gamma (Gamma + 1) of Gamma = 2, above any gas


class Force(NamedTuple):
    """pulse, table: the history of the acceleration; field: (its value in this step, 1/R, n), as `field.field_at` takes it."""

    pulse: Any
    table: Any
    field: Any


class Supply(namedtuple("Supply", "pulses tables weights sums amounts")):
    """Heat sources: pulses (n, 4), tables (n, 2, m), weights (n, zones), their sums over the mass (n,), amounts (n, 2).

    amounts are the integrals of the histories over this step, and their halves.
    """


# -- from a problem ----------------------------------------------------------------------------------------------------
def force_of(problem: Problem) -> Force:
    """The body force of a problem; none is an acceleration of 0."""
    force = problem.body_force
    if force is None:
        return Force(np.array([NO_FORCE, 0.0, 0.0, 0.0]), np.zeros((2, 1)), np.zeros(3))
    curved = problem.dimension > 1
    return Force(*history(force.acceleration), np.array([0.0, 1.0 / force.radius, force.exponent] if curved else [0.0, 0.0, 0.0]))


def supply_of(problem: Problem, zones, faces, ranges) -> Supply:
    """The heat sources of a problem; `faces` are the positions (left, right) of the zones, `ranges` the zones of each region."""
    sources, count = problem.heat_sources, zones.shape[1]
    pulses, longest = [history(source.pulse) for source in sources], 1
    longest = max([longest, *(table.shape[1] for _, table in pulses)])
    weights = np.zeros((len(sources), count))
    names = [region.name for region in problem.regions]
    for row, source in zip(weights, sources):
        first, last = ranges[names.index(source.region)]
        row[first:last] = _profile(source, faces[0][first:last], faces[1][first:last], zones[Z.mass, first:last], problem.dimension)
    tables = np.array([_longer(table, longest) for _, table in pulses]).reshape(len(sources), 2, longest)
    return Supply(np.array([pulse for pulse, _ in pulses]).reshape(-1, 4), tables, weights, weights @ zones[Z.mass],
                  np.zeros((len(sources), 2)))


def _longer(table, columns):
    """A table held on after its end, so that tables of several lengths stand in one array."""
    more = columns - table.shape[1]
    ends = table[:, -1:] + np.array([[1.0], [0.0]]) * np.arange(1, more + 1) * max(abs(table[0, -1]), 1.0)
    return np.hstack([table, ends])


def _profile(source, left, right, mass, dimension):
    """Energy per mass that each zone of a region gets, per unit of the history's integral."""
    start, end = left[0], right[-1]
    near, far = (left - start, right - start) if source.side == "left" else (end - right, end - left)
    face = (start if source.side == "left" else end) ** (dimension - 1)
    if source.absorption_length is not None:
        depth = source.absorption_length
        return face * -np.exp(-near / depth) * np.expm1((near - far) / depth) / mass
    mean = np.ones_like(mass)
    if source.depths:
        mean = (_integral(far, source) - _integral(near, source)) / (far - near)
    return mean if source.kind == "power" else face * mean / np.sum(mass * mean)


def _integral(depth, source):
    """Integral of the table of weights from its first depth to `depth`."""
    at, values = np.array(source.depths), np.array(source.weights)
    sums = np.concatenate(([0.0], np.cumsum(0.5 * (values[1:] + values[:-1]) * np.diff(at))))
    x = np.clip(depth, at[0], at[-1])
    k = np.clip(np.searchsorted(at, x, side="right") - 1, 0, len(at) - 2)
    return sums[k] + (x - at[k]) * 0.5 * (values[k] + np.interp(x, at, values))


# -- passes: inner nodes as in `nodes`, `numbers` the field ------------------------------------------------------------
@zone_pass("r_half u u_mean r")
def fall(count, z, dt, numbers, law):
    """What the force adds to velocity and position at the end of the step."""
    rows_apart()
    for j in range(count):
        more = dt * field_at(z.r_half[j + 1], numbers)
        z.u[j + 1] += more
        z.u_mean[j + 1] += 0.5 * more
        z.r[j + 1] += 0.5 * dt * more


@zone_pass("r u")
def kick(count, z, dt, numbers, law):
    """Leapfrog: what it adds to the velocity before the nodes are leapt; the step is the mean time step."""
    rows_apart()
    for j in range(count):
        z.u[j + 1] += dt * field_at(z.r[j + 1], numbers)


@zone_pass("weights e")
def supply_pass(count, z, dt, numbers, law):
    """Energy of one source."""
    rows_apart()
    amount = numbers[0]
    for j in range(count):
        z.e[j] += amount * z.weights[j]


def supply(s, e, half: bool = False) -> None:
    """Write what heat sources add to energies in a step, or in its half; s: `zones.steps.MaterialSteps` with the rows of `plan`."""
    for weights, amounts in s.at.supplied:
        s.do(supply_pass, (weights, e), numbers=amounts[int(half):])


# -- in a march --------------------------------------------------------------------------------------------------------
@nb.njit(**BY_ADDRESS)
def heated_step(nodes, control, segments, supply):
    """Shorten the time step where the heat of a source would make a zone so hot that sound crosses it; amounts are set for it."""
    limit, time = control[L.COURANT] ** 2, control[L.TIME]
    for _ in range(60):
        dt = control[L.DT]
        for i in range(supply.sums.shape[0]):
            pulse, table = supply.pulses[i], supply.tables[i]
            amount = pulse_integral(time + dt, pulse, table) - pulse_integral(time, pulse, table)
            supply.amounts[i, 0], supply.amounts[i, 1] = amount, 0.5 * amount
        worst = 0.0
        for s in range(segments.shape[0]):
            for j in range(segments[s, L.SEG_FIRST], segments[s, L.SEG_LAST]):
                heat, width = 0.0, nodes[H.r, j + s + 1] - nodes[H.r, j + s]
                for i in range(supply.sums.shape[0]):
                    heat += supply.amounts[i, 0] * supply.weights[i, j]
                worst = max(worst, STIFFEST * heat / (width * width))
        if dt * dt * worst <= limit:
            break
        control[L.DT] = max(0.99 * dt * (limit / (dt * dt * worst)) ** (1.0 / 3.0), 1e-3 * dt)
        control[L.DT_NATURAL] = min(control[L.DT_NATURAL], control[L.DT])


@nb.njit(**BY_ADDRESS)
def book_force(nodes, control, dts, staggered, force):
    """Work and impulse of the body force in a step that was taken; `dts` = (dt, mean dt)."""
    work = impulse = 0.0
    dt, dt_kick = dts[0], dts[1] if staggered else dts[0]
    for n in range(int(control[L.LAST_NODE]) + 1):     # beyond it the table has room for nodes, and what closed gaps left
        u = nodes[H.u, n] if staggered else nodes[H.u_mean, n]
        push = nodes[H.mass, n] * field_at(nodes[H.r, n] - dt * u if staggered else nodes[H.r_half, n], force.field)
        work += dt * push * u
        impulse += dt_kick * push
    control[L.FORCE_WORK] += work
    add_impulse(control, L.FORCE_IMPULSE, impulse)


@nb.njit(**BY_ADDRESS)
def book_supply(control, supply):
    """Energy of the heat sources in a step that was taken."""
    for i in range(supply.sums.shape[0]):
        control[L.SUPPLIED] += supply.sums[i] * supply.amounts[i, 0]
