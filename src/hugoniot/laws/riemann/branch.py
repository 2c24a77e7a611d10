r"""The longitudinal stress of a material on one branch of its behaviour, as the wave curves need it.

$$\sigma(\rho, e) = p(\rho, e) + a + b \ln\rho$$

A fluid has a = b = 0. An elastic solid in uniaxial strain has the deviator $s_1 = s_0 - \tfrac43 G\ln(\rho/\rho_0)$ (tension positive), so
that $b = \tfrac43 G$ and $a = -s_0 - b\ln\rho_0$; on the yield surface $s_1 = \mp\tfrac23 Y$ is constant, $a = \pm\tfrac23 Y$, b = 0.
Work is done by the whole stress, $de = \sigma\,d\rho/\rho^2$: the energy of distortion is part of e.

Of a law with a memory (pores that stay crushed) a state carries the compaction k. It leaves that state on the elastic branch of the law at
that k; beyond the elastic limit the law itself holds, and k grows with the pores that close.

Source: Wilkins B.1 items 5 and 9 with conservation of mass, momentum and energy.
"""

import math
from typing import Any, NamedTuple

from hugoniot.laws.eos.contract import EOS, remembered, unloading
from hugoniot.laws.riemann import medium


class Branch(NamedTuple):
    """par   parameters of an equation of state, or a `medium.Frozen` mixture; a, b   Pa"""

    par: Any
    a: float = 0.0
    b: float = 0.0


class Matter(NamedTuple):
    """What stands on one side of a front: equation of state, shear modulus and yield stress (Pa; both 0 for a fluid).

    hoop   of a solid in a cylinder: elastic part of its hoop strain; its yield stress is then what this leaves to uniaxial strain
    """

    par: Any
    shear_modulus: float = 0.0
    yield_stress: float = 0.0
    hoop: float = 0.0


class State(NamedTuple):
    """density kg/m3, velocity m/s, energy J/kg, longitudinal stress Pa (compression positive), deviator s1 Pa (tension positive).

    compaction   of a law with a memory: its history variable, 0 before any pore has closed, 1 once all have; else 0
    """

    rho: float
    u: float
    e: float
    sigma: float
    s: float = 0.0
    compaction: float = 0.0

    @property
    def pressure(self) -> float:
        return self.sigma + self.s


EMPTY = State(0.0, 0.0, 0.0, 0.0)


def stress(rho: float, e: float, branch: Branch) -> float:
    """Longitudinal stress, Pa."""
    shear = branch.b * math.log(rho) if branch.b else 0.0
    return medium.respond(rho, e, branch.par)[0] + branch.a + shear


def stress_and_slopes(rho: float, e: float, branch: Branch) -> tuple[float, float, float]:
    """(sigma, dsigma/drho at e, dsigma/de at rho)."""
    p, p_rho, p_e = medium.respond(rho, e, branch.par)
    if branch.b:
        return p + branch.a + branch.b * math.log(rho), p_rho + branch.b / rho, p_e
    return p + branch.a, p_rho, p_e


def wave_speed_squared(rho: float, e: float, branch: Branch) -> float:
    """c^2 = dsigma/drho at constant entropy, m2/s2 (negative where the state is unstable)."""
    sigma, slope, by_energy = stress_and_slopes(rho, e, branch)
    return slope + sigma * by_energy / (rho * rho)


def has_memory(par) -> bool:
    """Whether a law keeps its pores crushed."""
    return not isinstance(par, medium.Frozen) and "remembers" in EOS.of(par).flags


def shocks_only(par) -> bool:
    """Whether the pressure of a law depends on the energy alone."""
    return not isinstance(par, medium.Frozen) and "shocks_only" in EOS.of(par).flags


def loading(matter: Matter, state: State) -> Branch:
    """The branch on which pores go on closing from the compaction of a state; below its elastic limit the same as `elastic`."""
    return Branch(remembered(state.compaction, matter.par))


def elastic(matter: Matter, state: State) -> Branch:
    """The branch on which a solid, or material whose pores are as crushed as in `state`, leaves it elastically; of a fluid its only one."""
    if has_memory(matter.par):
        return Branch(unloading(remembered(state.compaction, matter.par)))
    if not matter.yield_stress:
        return Branch(matter.par)
    b = 4.0 / 3.0 * matter.shear_modulus
    return Branch(matter.par, -state.s - b * math.log(state.rho), b)


def plastic(matter: Matter, way: int) -> Branch:
    """The branch of a yielding solid, compressed (way 1, s1 = -2Y/3) or extended (-1)."""
    return Branch(matter.par, way * 2.0 / 3.0 * matter.yield_stress)


def yield_density(matter: Matter, state: State, way: int) -> float:
    """Density at which a solid compressed (way 1) or extended (-1) from `state` yields."""
    left = way * state.s + 2.0 / 3.0 * matter.yield_stress
    return state.rho * math.exp(way * max(left, 0.0) / (4.0 / 3.0 * matter.shear_modulus))
