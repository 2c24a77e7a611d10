r"""The waves of one side of material whose pores stay crushed, from the state ahead to a pressure: plain functions that kernels compile.

Release, and compression up to the elastic limit of the compaction k, run on the elastic branch of the law, beyond it on the law itself,
with k behind by `compacted`. A shock that closes pores follows the precursor, or both are one shock where it would be the faster one.
The same as `curve.Curve`, for kernels, and for crush curves that are convex.

Source: Herrmann, J. Appl. Phys. 40, 2490 (1969); Courant and Friedrichs, sections 54 to 81.
"""

from hugoniot.laws.eos.contract import compacted, elastic_limit, pressure_and_derivatives, remembered, unloading
from hugoniot.laws.riemann.solid import Limit
from hugoniot.laws.riemann.wave import Behind, Side, compression, reach, sound_squared

AT_LIMIT = 1e-12      # of the stiffness: a pressure that close to the elastic limit is at it
ABOVE = 1e-9          # of the density: how far above a kink its upper slopes are looked at


def with_compaction(found, compaction):
    """What stands behind a wave, with its compaction in the place of a reference energy."""
    return Behind(found.rise, found.slope, found.rho, found.e, found.flux, 0.0, compaction)


def crush(target, rho, e, p, compaction, side, crushed, par):
    """The shock that closes pores, from a state at or below its elastic limit to a pressure beyond."""
    above = rho * (1.0 + ABOVE)
    found, by_rho, by_e = pressure_and_derivatives(above, e + ABOVE * p / rho, crushed)
    ahead = Side(rho, e, p, sound_squared(above, found, by_rho, by_e), 0.0, 0.0, 0.0, side.highest, side.highest_r, side.highest_p)
    wave = compression(target, ahead, crushed)
    return with_compaction(wave, compacted(compaction, wave.rho, wave.e, target, par.eos))


def porous_waves(target, side, par):
    """(`Behind`, `Limit`); the energy of `side` and of `Behind` is the compaction, ahead and behind the last wave."""
    none = Limit(0.0, 0.0, 0.0, 0.0, 0.0)
    k = compacted(min(max(side.energy, 0.0), 1.0), side.rho, side.e, side.p, par.eos)
    crushed = remembered(k, par.eos)
    elastic = unloading(crushed)
    if target <= side.p:
        return with_compaction(reach(target, side, elastic), k), none
    limit = elastic_limit(crushed)
    if target <= limit:
        return with_compaction(compression(target, side, elastic), k), none
    if limit - side.p <= AT_LIMIT * side.rho * side.square:
        return crush(target, side.rho, side.e, side.p, k, side, crushed, par), none
    first = compression(limit, side, elastic)
    last = crush(target, first.rho, first.e, limit, k, side, crushed, par)
    if first.rise + last.flux / first.rho >= first.flux / side.rho:
        return crush(target, side.rho, side.e, side.p, k, side, crushed, par), none
    found = Behind(first.rise + last.rise, last.slope, last.rho, last.e, last.flux, 0.0, last.energy)
    return found, Limit(limit, first.rise, first.rho, first.e, first.flux)


KERNELS = (with_compaction, crush, porous_waves)      # what kernels call by name
