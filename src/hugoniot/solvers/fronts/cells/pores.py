"""Pores in the cells: which regions have a memory, and the compaction of a cell, which goes with its mass.

A cell keeps the integral of its compaction over its mass in the place of a reference energy. After every step it has grown to what the new
state has closed (`crush_pass`); between fronts material yields as its cell does, with the speed of sound of its elastic branch.
"""

import numba as nb

from hugoniot.core.ops import NO_LIMIT
from hugoniot.core.target import BY_ADDRESS
from hugoniot.laws.eos.contract import compacted, elastic_limit, pressure, reference_state, remembered, sound_speed_squared
from hugoniot.laws.riemann.branch import Branch, Matter, State, elastic, has_memory, stress, wave_speed_squared
from hugoniot.laws.riemann.curve import Wave
from hugoniot.solvers.fronts.cells.tables import ENERGY

WEAKEST_LIMIT = 1e-9      # of the stiffness: a lower elastic limit is none


@nb.njit(**BY_ADDRESS)
def is_porous(rules, region):
    """Whether the material of a region keeps its pores crushed."""
    return 0 <= region < len(rules.passes) and rules.passes[region, 3] != 0 and rules.passes[region, 2] == 0


def elastic_range(par) -> float:
    """Elastic limit over stiffness of material at rest; 0 where there is none."""
    if not has_memory(par):
        return 0.0
    rho, e = reference_state(par)
    share = elastic_limit(par) / (rho * sound_speed_squared(rho, e, par))
    return float(share) if WEAKEST_LIMIT < share < NO_LIMIT / 1e30 else 0.0


def strength(wave: Wave, matter: Matter) -> float:
    """Change of stress over the stiffness of the material; of pores that close, which are softer, that of the elastic branch ahead."""
    if not has_memory(matter.par):
        return wave.strength
    stiff = wave.ahead.rho * wave_speed_squared(wave.ahead.rho, wave.ahead.e, elastic(matter, wave.ahead))
    return abs(wave.behind.sigma - wave.ahead.sigma) / max(abs(wave.ahead.sigma), abs(wave.behind.sigma), stiff)


def start(eos, rho: float, e: float) -> float:
    """The compaction of material that was loaded to its initial state."""
    return float(compacted(0.0, rho, e, pressure(rho, e, eos), eos))


def state_of(rho: float, u: float, e: float, scalars, matter: Matter) -> State:
    """The state of porous material of density, velocity and energy; scalars: what cells carry with the mass."""
    k = min(max(scalars[ENERGY - 3], 0.0), 1.0)
    sigma = float(stress(rho, e, Branch(remembered(k, matter.par))))
    return State(rho, u, e, sigma, 0.0, float(compacted(k, rho, e, sigma, matter.par)))
