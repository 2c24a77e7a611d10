"""The passes of the cells: what is asked of a law, or of a burning mixture, compiled once for each and called by address.

    states_pass   pressure and its slopes of a row of states
    wave_pass     the waves of one side, from a state to a pressure (laws.riemann.wave, solid)
    burn_pass     burn fractions after a time at given states
    pace_pass     rates of burning, which the step has to follow
    crush_pass    compaction of pores after states have been met
"""

from typing import Any, NamedTuple

from hugoniot.core.binder import bind, bind_choice
from hugoniot.core.ops import fmax, fmin
from hugoniot.core.passes import bind_flag, law_of, zone_pass
from hugoniot.laws.burn.contract import Reactive, advance, rate
from hugoniot.laws.eos.contract import compacted
from hugoniot.laws.mixture.contract import MIXTURE
from hugoniot.laws.riemann import medium, porous, solid, wave
from hugoniot.laws.riemann.medium import OnBranch, Porous, Solid, answer, mixed_phases
from hugoniot.laws.riemann.solid import waves
from hugoniot.laws.riemann.wave import Side
from hugoniot.zones.burn import NEARLY, STEP_SHARE, burn_temperature
from hugoniot.zones.laws import bind_burning


class StateRows(NamedTuple):
    rho: Any
    e: Any
    burned: Any
    volume: Any
    energy: Any
    p: Any
    p_rho: Any
    p_e: Any


class WaveRows(NamedTuple):
    """given: the pressure behind and the fields of `Side`; found: those of `Behind` and of `solid.Limit`."""

    given: Any
    found: Any


class BurnRows(NamedTuple):
    """start: burn fractions at the start; the others are the states in which they grow; end: what they are then."""

    start: Any
    rho: Any
    e: Any
    burned: Any
    volume: Any
    energy: Any
    end: Any


@zone_pass(StateRows, exact=True)
def states_pass(count, z, dt, numbers, law):
    par = law_of(law, numbers)
    for j in range(count):
        p, p_rho, p_e = answer(z.rho[j], z.e[j], z.burned[j], z.volume[j], z.energy[j], par)
        z.p[j] = p
        z.p_rho[j] = p_rho
        z.p_e[j] = p_e


@zone_pass(WaveRows, exact=True)
def wave_pass(count, z, dt, numbers, law):
    g, f = z.given, z.found
    behind, limit = waves(g[0], Side(g[1], g[2], g[3], g[4], g[5], g[6], g[7], g[8], g[9], g[10]), law_of(law, numbers))
    f[0], f[1], f[2], f[3] = behind.rise, behind.slope, behind.rho, behind.e
    f[4], f[5], f[6] = behind.flux, behind.volume, behind.energy
    f[7], f[8], f[9], f[10], f[11] = limit.sigma, limit.rise, limit.rho, limit.e, limit.flux


@zone_pass(BurnRows, exact=True)
def burn_pass(count, z, dt, numbers, law):
    par = law_of(law, numbers)
    for j in range(count):
        lam = min(max(z.start[j], 0.0), 1.0)
        if lam < 1.0 and z.rho[j] > 0.0:
            at = min(max(z.burned[j], 0.0), 1.0)
            mixed = mixed_phases(z.rho[j], z.e[j], at, z.volume[j], z.energy[j], par.mixture)
            lam = advance(lam, dt, z.rho[j], mixed.pressure, burn_temperature(at, mixed, par.mixture, par.rate), par.rate)
        z.end[j] = lam


@zone_pass(StateRows, exact=True)
def pace_pass(count, z, dt, numbers, law):
    par = law_of(law, numbers)
    for j in range(count):
        lam = min(max(z.burned[j], 0.0), 1.0)
        z.p[j] = 0.0
        if 0.0 < lam < NEARLY:      # what has not begun has no rate; a term that ends at a small burn fraction is looked past
            mixed = mixed_phases(z.rho[j], z.e[j], lam, z.volume[j], z.energy[j], par.mixture)
            z.p[j] = rate(fmax(lam, STEP_SHARE), z.rho[j], mixed.pressure, burn_temperature(lam, mixed, par.mixture, par.rate), par.rate)


@zone_pass("rho e p compaction", exact=True)
def crush_pass(count, z, dt, numbers, law):
    par = law_of(law, numbers)
    for j in range(count):
        z.compaction[j] = compacted(fmin(fmax(z.compaction[j], 0.0), 1.0), z.rho[j], z.e[j], z.p[j], par.eos)


def _by_kind(plain, **special):
    found = {Reactive: special.get("burning"), Solid: special.get("solid"), OnBranch: special.get("branch"),
             Porous: special.get("porous")}
    return lambda *classes: found.get(classes[-1]) or plain


def _bind() -> None:
    bind_burning()
    search = dict(fastmath=False, error_model="numpy", no_cfunc_wrapper=True)
    bind_choice(medium.answer, _by_kind(medium.plain_answer, burning=medium.reactive_answer, solid=medium.solid_answer,
                                        branch=medium.branch_answer, porous=medium.porous_answer))
    bind_choice(wave.jumps, _by_kind(wave.plain_jump, burning=wave.reactive_jump))
    bind_choice(solid.waves, _by_kind(solid.plain_waves, solid=solid.solid_waves, porous=porous.porous_waves))
    bind_flag(wave.isolates, MIXTURE, "follows_isentrope")
    for function in (medium.mixed_phases, medium.mixed_answer, wave.drop, wave.both_drop, wave.isolated_jump, wave.step, wave.release,
                     wave.compression, wave.reach, medium.strength_left, medium.deviator, *solid.KERNELS, *porous.KERNELS):
        bind(function, **search)


_bind()
