r"""What a Riemann problem asks of a material: a plain law, or a mixture whose burn fraction stands still while waves pass.

A mixture is frozen at a burn fraction lambda; reactants in thermal isolation are on the isentrope through the reference state
$(v_k, e_k)$ (e_k with the chemical energy, as e of the mixture). Behind a shock that state is a new one: each phase obeys the jump
relations by itself, and the volumes and energies of the phases add,

$$x = (1-\lambda)\,x_r + \lambda\,x_p, \qquad e_{r} - e_{r0} = \tfrac12(p + p_0)\,x_r, \qquad v_k = v_r,\ e_k = e_r$$

which satisfies the relations of the mixture, because they are linear in the volumes and energies at given pressures.

An elastic-perfectly plastic solid in uniaxial strain is known by its density, its energy and its stretch $z = \rho v_r$, where $v_r$ is
the specific volume at which its deviator would vanish. z moves with the flow as a density does, for elastic strain leaves $v_r$ as it is:

$$s_1 = -\tfrac43 G \ln z, \quad |s_1| \le \tfrac23 Y, \qquad \sigma = p(\rho, e) - s_1$$

In a cylinder the deviators along hoop and axis differ by 2 G h, where h is what is elastic of the hoop strain. Waves leave h as it is, and
of the yield surface (von Mises) $|s_1| \le \sqrt{(\tfrac23 Y)^2 - \tfrac43 G^2 h^2}$ is left to them.

Sources: 003 (Starkenberg ARL-TR-2161) sections 4.3 (the reference state behind a tracked shock is exact) and 5.8;
Wilkins B.1 items 5 and 9.
"""

import math
from typing import Any, NamedTuple

from hugoniot.laws.burn.contract import Reactive
from hugoniot.laws.eos import contract
from hugoniot.laws.eos.contract import (
    EOS,
    compacted,
    flagged,
    pressure,
    pressure_and_derivatives,
    pressure_derivatives,
    remembered,
    unloading,
)
from hugoniot.laws.mixture.contract import MIXTURE, Mixed, slopes, solve
from hugoniot.laws.mixture.search import NASCENT


class Frozen(NamedTuple):
    """A mixture of burn fraction `burned`; (volume, energy): reference state of its reactants, where they are isolated."""

    mixture: Any
    burned: float
    volume: float
    energy: float


class Solid(NamedTuple):
    """An elastic-perfectly plastic solid: law of its pressure, shear modulus and yield stress, Pa."""

    eos: Any
    shear_modulus: float
    yield_stress: float


class Porous(NamedTuple):
    """Material whose pores stay crushed: a law with a memory, for kernels that know a state by its compaction too."""

    eos: Any


class OnBranch(NamedTuple):
    """A solid on one branch of its behaviour (`branch.Branch`): its stress is p + a + b ln(rho)."""

    eos: Any


# -- scalars that kernels know too -------------------------------------------------------------------------------------
def mixed_phases(rho, e, burned, volume, energy, mixture):
    """`Mixed` of a frozen mixture."""
    return solve(rho, e, min(max(burned, 0.0), 1.0), Mixed(0.0, 1.0 / volume if volume > 0.0 else rho, energy, 0.0, 0.0, 0.0), mixture)


def mixed_answer(rho, e, burned, volume, energy, mixture):
    """(p, dp/drho at e, dp/de at rho) of a frozen mixture; nan where its phases find no equilibrium."""
    mixed = mixed_phases(rho, e, burned, volume, energy, mixture)
    slope = slopes(rho, e, min(max(burned, 0.0), 1.0), mixed, mixture)
    p = mixed.pressure if mixed.status == 0.0 else math.nan
    return p, -slope.by_volume / (rho * rho), slope.by_energy


def answer(rho, e, burned, volume, energy, par):
    """(p, dp/drho, dp/de) of a law or of the mixture of a `Reactive` pair; of a solid sigma for p.

    volume, energy   of a mixture: reference state; of a `Solid`: its stretch z and its hoop strain h; `OnBranch`: a and b of its branch;
                     energy of `Porous`: its compaction
    """
    if isinstance(par, Reactive):
        return reactive_answer(rho, e, burned, volume, energy, par)
    if isinstance(par, Solid):
        return solid_answer(rho, e, burned, volume, energy, par)
    if isinstance(par, Porous):
        return porous_answer(rho, e, burned, volume, energy, par)
    if isinstance(par, OnBranch):
        return branch_answer(rho, e, burned, volume, energy, par)
    return plain_answer(rho, e, burned, volume, energy, par)


def plain_answer(rho, e, burned, volume, energy, par):
    return pressure_and_derivatives(rho, e, par)


def branch_answer(rho, e, burned, a, b, par):
    p, p_rho, p_e = pressure_and_derivatives(rho, e, par.eos)
    return p + a + b * math.log(rho), p_rho + b / rho, p_e


def strength_left(hoop, par):
    """Largest |s1| (Pa) of a solid of a given hoop strain."""
    turned = par.shear_modulus * hoop
    return 2.0 / 3.0 * math.sqrt(max(par.yield_stress * par.yield_stress - 3.0 * turned * turned, 0.0))


def deviator(stretch, hoop, par):
    """s1 (Pa, tension positive) of a solid."""
    most = strength_left(hoop, par)
    return min(max(-4.0 / 3.0 * par.shear_modulus * math.log(stretch), -most), most)


def solid_answer(rho, e, burned, stretch, hoop, par):
    """The slopes are those of elastic strain, whose waves are the faster ones."""
    p, p_rho, p_e = pressure_and_derivatives(rho, e, par.eos)
    return p - deviator(stretch, hoop, par), p_rho + 4.0 / 3.0 * par.shear_modulus / rho, p_e


def porous_answer(rho, e, burned, volume, compaction, par):
    """The slopes are those of the elastic branch, whose waves are the faster ones."""
    k = min(max(compaction, 0.0), 1.0)
    p = pressure(rho, e, remembered(k, par.eos))
    p_rho, p_e = pressure_derivatives(rho, e, unloading(remembered(compacted(k, rho, e, p, par.eos), par.eos)))
    return p, p_rho, p_e


def reactive_answer(rho, e, burned, volume, energy, par):
    return mixed_answer(rho, e, burned, volume, energy, par.mixture)


# -- what the Riemann problems of Python ask --------------------------------------------------------------------------
def respond(rho, e, par) -> tuple[float, float, float]:
    """(p, dp/drho at e, dp/de at rho) of a law or a `Frozen` mixture."""
    if isinstance(par, Frozen):
        return mixed_answer(rho, e, par.burned, par.volume, par.energy, par.mixture)
    return pressure_and_derivatives(rho, e, par)


def name_of(par) -> str:
    """What messages call it."""
    return MIXTURE.of(par.mixture).name if isinstance(par, Frozen) else EOS.of(par).name


def has_pieces(par) -> bool:
    """Whether slopes of the law leap in many places (tables)."""
    laws = (par,) if not isinstance(par, Frozen) else (getattr(par.mixture, phase, None) for phase in ("reactants", "products"))
    return any(law is not None and EOS.of(law).functions["smooth_piece"] is not contract.one_piece for law in laws)


def limits_of(par) -> tuple[float, float]:
    """(lowest, highest) density, kg/m3."""
    if not isinstance(par, Frozen):
        return contract.density_limits(par)
    return 0.0, mixture_limit(par.burned, par.mixture)


def mixture_limit(burned: float, mixture) -> float:
    """Highest density of a mixture: both phases at their own, or one density for both where their pressures are weighted."""
    highest = [contract.density_limits(getattr(mixture, phase))[1] if hasattr(mixture, phase) else math.inf
               for phase in ("reactants", "products")]
    if "no_equilibrium" in MIXTURE.of(mixture).flags:
        return min(highest)
    least = (1.0 - burned) / highest[0] + burned / highest[1]
    return 1.0 / least if least > 0.0 else math.inf


def is_gas(par) -> bool:
    """Whether it expands without bound."""
    if not isinstance(par, Frozen):
        return flagged(par, "gas")
    return flagged(par.mixture.products if par.burned > NASCENT else par.mixture.reactants, "gas")
