"""Solids in the cells: which regions have strength, their yield surface, and the stretch that stands for their deviator.

A cell of a solid keeps, in the place of a reference volume, the integral of its stretch (laws.riemann.medium) over its volume.
"""

import math

import numba as nb

from hugoniot.core.target import BY_ADDRESS
from hugoniot.laws.riemann.branch import Matter, State
from hugoniot.laws.riemann.medium import Solid, deviator
from hugoniot.solvers.fronts.cells.spacing import path_mean
from hugoniot.solvers.fronts.cells.tables import CENTRE, FIRST, FROM, MIDDLE, SHEAR, SPEED, VOLUME, YIELDS, U


@nb.njit(**BY_ADDRESS)
def is_solid(rules, region):
    """Whether the material of a region has strength."""
    return 0 <= region < len(rules.traits) and rules.traits[region, SHEAR] > 0.0


@nb.njit(**BY_ADDRESS)
def yielded(rules, region, stretch):
    """The stretch returned to the yield surface, where it lies beyond."""
    most = rules.traits[region, YIELDS]
    return min(max(stretch, math.exp(-most)), math.exp(most))


@nb.njit(**BY_ADDRESS)
def deviator_of(rules, region, stretch):
    """s1 (Pa, tension positive) of a stretch inside the yield surface."""
    return -rules.traits[region, SHEAR] * math.log(stretch)


@nb.njit(**BY_ADDRESS)
def hoop_excess(rules, region, stretch):
    """Hoop stress above the radial one, Pa (compression positive): both hoop deviators are half of s1, of the other sign."""
    return 1.5 * deviator_of(rules, region, stretch)


@nb.njit(**BY_ADDRESS)
def settle(grid, rules, w, i, d, dt):
    """The stretch of a cell after a step whose fluxes have passed: what u/r adds in curved geometry, and the yield surface."""
    a, b, region = grid.x[i], grid.x[i + 1], grid.region[i]
    volume = (b - a) * path_mean(a, b, d)
    if not math.isnan(grid.push[i]):
        grid.q[i, VOLUME] = volume * yielded(rules, region, w[FROM, i])
    elif volume > 0.0:       # else two fronts have met, and nothing is left between them
        stretch = grid.q[i, VOLUME] / volume
        if d > 1:
            low, high = a - 0.5 * dt * w[SPEED, i], b - 0.5 * dt * w[SPEED, i + 1]
            half_way = (high - low) * path_mean(low, high, d)
            r = w[CENTRE, i] + w[FIRST, i] + 0.25 * dt * (w[SPEED, i] + w[SPEED, i + 1])
            stretch += 1.5 * (d - 1) * dt * w[MIDDLE + VOLUME, i] * w[MIDDLE + U, i] / r * half_way / volume
        grid.q[i, VOLUME] = volume * yielded(rules, region, stretch)


def traits(law) -> tuple[float, float]:
    """(4/3 of the shear modulus, the largest |ln z|): see `tables.Rules`."""
    return (4.0 / 3.0 * law.shear_modulus, 0.5 * law.yield_stress / law.shear_modulus) if isinstance(law, Solid) else (0.0, 0.0)


def elastic_share(matters: list[Matter]) -> float:
    """Strength of a wave of the size of the elastic range: elastic waves are measured by it. 1 without solids."""
    return min((m.yield_stress / m.shear_modulus for m in matters if m.yield_stress), default=1.0)


def stretch_of(state: State, matter: Matter) -> float:
    """The stretch of a state of known deviator."""
    return math.exp(-0.75 * state.s / matter.shear_modulus)


def with_deviator(rho: float, u: float, e: float, stretch: float, matter: Matter, pressure: float) -> State:
    """The state of a given stretch; of a fluid without one."""
    if not matter.yield_stress:
        return State(rho, u, e, pressure)
    s = deviator(stretch, Solid(matter.par, matter.shear_modulus, matter.yield_stress))
    return State(rho, u, e, pressure - s, s)
