r"""Solids in the cells: which regions have strength, their yield surface, and the stretch that stands for their deviator.

A cell of a solid keeps, in the place of a reference volume, the integral of its stretch z (laws.riemann.medium) over its volume. In a
cylinder the deviators along hoop and axis are $-\tfrac12 s_1 \pm G h$ with the elastic part h of the hoop strain, which goes with the mass
and which a cell keeps in the place of a reference energy. The yield surface (von Mises) is the circle

$$(\ln z)^2 + \tfrac34 h^2 = \left(\frac{Y}{2G}\right)^2,$$

and what lies beyond it returns along its radius.
"""

import math

import numba as nb

from hugoniot.core.target import BY_ADDRESS
from hugoniot.laws.riemann.branch import Matter, State
from hugoniot.laws.riemann.medium import Solid, deviator, strength_left
from hugoniot.solvers.fronts.cells import pores
from hugoniot.solvers.fronts.cells.spacing import path_mean
from hugoniot.solvers.fronts.cells.tables import (
    BURNED,
    CENTRE,
    FIRST,
    FROM,
    HOOP,
    LENGTH,
    MIDDLE,
    SHEAR,
    SPEED,
    TOUCHING,
    VOLUME,
    YIELDS,
    U,
)

LEAST_LEFT = 1e-9      # of the yield stress: what is always left to uniaxial strain


@nb.njit(**BY_ADDRESS)
def is_solid(rules, region):
    """Whether the material of a region has strength."""
    return 0 <= region < len(rules.traits) and rules.traits[region, SHEAR] > 0.0


@nb.njit(**BY_ADDRESS)
def yielded(rules, region, stretch, hoop):
    """(stretch, hoop strain), returned to the yield surface where they lie beyond."""
    most = rules.traits[region, YIELDS]
    if hoop == 0.0:
        return min(max(stretch, math.exp(-most)), math.exp(most)), 0.0
    strain = math.log(stretch)
    size = math.sqrt(strain * strain + 0.75 * hoop * hoop)
    return (stretch, hoop) if size <= most else (math.exp(strain * most / size), hoop * most / size)


@nb.njit(**BY_ADDRESS)
def deviator_of(rules, region, stretch):
    """s1 (Pa, tension positive) of a stretch inside the yield surface."""
    return -rules.traits[region, SHEAR] * math.log(stretch)


@nb.njit(**BY_ADDRESS)
def hoop_excess(rules, region, stretch, hoop):
    """Hoop stress above the radial one, Pa (compression positive)."""
    return 1.5 * deviator_of(rules, region, stretch) - 0.75 * rules.traits[region, SHEAR] * hoop


@nb.njit(**BY_ADDRESS)
def settle(grid, rules, w, i, d, dt):
    """Stretch and hoop strain of a cell after a step whose fluxes have passed: what u/r adds in curved geometry, and the yield surface."""
    a, b, region = grid.x[i], grid.x[i + 1], grid.region[i]
    volume = (b - a) * path_mean(a, b, d)
    if not math.isnan(grid.push[i]):
        grid.q[i, VOLUME], grid.q[i, HOOP] = volume * w[FROM, i], grid.q[i, 0] * w[BURNED, i]
    elif b - a > TOUCHING * rules.numbers[LENGTH]:       # else two fronts have met, and nothing but rounding is left between them
        stretch, hoop = grid.q[i, VOLUME] / volume, grid.q[i, HOOP] / grid.q[i, 0]
        if d > 1:
            low, high = a - 0.5 * dt * w[SPEED, i], b - 0.5 * dt * w[SPEED, i + 1]
            half_way = (high - low) * path_mean(low, high, d)
            r = w[CENTRE, i] + w[FIRST, i] + 0.25 * dt * (w[SPEED, i] + w[SPEED, i + 1])
            turned = dt * w[MIDDLE + U, i] / r
            stretch += 1.5 * (d - 1) * w[MIDDLE + VOLUME, i] * turned * half_way / volume
            hoop += turned * w[MIDDLE, i] * half_way / grid.q[i, 0] if d == 2 else 0.0
        stretch, hoop = yielded(rules, region, stretch, hoop)
        grid.q[i, VOLUME], grid.q[i, HOOP] = volume * stretch, grid.q[i, 0] * hoop


def traits(law) -> tuple[float, float]:
    """(4/3 of the shear modulus, the largest |ln z|): see `tables.Rules`."""
    return (4.0 / 3.0 * law.shear_modulus, 0.5 * law.yield_stress / law.shear_modulus) if isinstance(law, Solid) else (0.0, 0.0)


def elastic_share(matters: list[Matter]) -> float:
    """Strength of a wave of the size of the elastic range: elastic waves are measured by it. 1 without such material."""
    return min((m.yield_stress / m.shear_modulus if m.yield_stress else pores.elastic_range(m.par) for m in matters
                if m.yield_stress or pores.elastic_range(m.par) > 0.0), default=1.0)


def stretch_of(state: State, matter: Matter) -> float:
    """The stretch of a state of known deviator."""
    return math.exp(-0.75 * state.s / matter.shear_modulus)


def of_hoop(law: Solid, hoop: float) -> Matter:
    """A solid of a given hoop strain as the Riemann problems take it."""
    return Matter(law.eos, law.shear_modulus, max(1.5 * strength_left(hoop, law), LEAST_LEFT * law.yield_stress), hoop)


def strains_of(whole, fronts, pair, bench) -> tuple[float, float]:
    """(stretch, hoop strain) of the new cell between two of the waves that leave a place in a cylinder, beside a contact or an end.

    whole   all pieces, those outside included; fronts   all fronts between them; pair   numbers of the two waves
    A plastic wave turns the stress of what it runs into along the yield surface (laws.riemann.solid.turned).
    """
    left = fronts[pair[0]].direction < 0
    crossed = fronts[:pair[1]] if left else fronts[pair[0] + 1:]
    outer, state = (whole[0], whole[pair[1]].edge(-1)) if left else (whole[-1], whole[pair[0] + 1].edge(1))
    law, hoop = bench.matters[outer.region], outer.matter.hoop if outer.matter is not None else 0.0
    if any(not front.kind.startswith("elastic") for front in crossed):
        turned = math.sqrt(max(law.yield_stress**2 - 2.25 * state.s**2, 0.0) / 3.0) / law.shear_modulus
        hoop = math.copysign(min(turned, abs(hoop)), hoop)
    return stretch_of(state, law), hoop


def with_deviator(rho: float, u: float, e: float, stretch: float, matter: Matter, pressure: float) -> State:
    """The state of a given stretch; of a fluid without one."""
    if not matter.yield_stress:
        return State(rho, u, e, pressure)
    s = deviator(stretch, 0.0, Solid(matter.par, matter.shear_modulus, matter.yield_stress))
    return State(rho, u, e, pressure - s, s)
