r"""The waves of one side of an elastic-perfectly plastic solid, from the state ahead to a stress: plain functions that kernels compile.

An elastic wave runs up to the yield point, a plastic one behind it; where a plastic shock would outrun the elastic one, both are one
shock. Each is a wave of `wave.py` on its own branch of the stress (`medium.OnBranch`). Elastic releases are jumps too: the elastic
range is so narrow that their entropy, which falls with the cube of their strength, is nothing. The same as `curve.Curve`, for kernels.

Source: Courant and Friedrichs, sections 54 to 81; Wilkins B.1 items 5 and 9 for the yield condition.
"""

import math
from typing import NamedTuple

from hugoniot.laws.riemann.medium import OnBranch, Solid, answer, deviator, strength_left
from hugoniot.laws.riemann.wave import Behind, Side, compression, reach, sound_squared

YIELDS = 1e-13         # ln of a density: a state that close to its yield point yields at once
TURNS = 100            # iterations for the end of a wave that turns the stress


class Limit(NamedTuple):
    """The yield point between an elastic and a plastic wave: stress, rise of velocity, density, energy, mass flux of the elastic wave.

    flux 0: the waves are one
    """

    sigma: float
    rise: float
    rho: float
    e: float
    flux: float


def waves(target, side, par):
    """(`Behind`, `Limit`) of the wave or waves to a pressure or stress."""
    return solid_waves(target, side, par) if isinstance(par, Solid) else plain_waves(target, side, par)      # of kernels also `porous`


def plain_waves(target, side, par):
    return reach(target, side, par), Limit(0.0, 0.0, 0.0, 0.0, 0.0)


def on_branch(rho, e, sigma, square, a, b, side):
    """A state ahead of a wave on one branch."""
    return Side(rho, e, sigma, square, 0.0, a, b, side.highest, side.highest_r, side.highest_p)


def solid_waves(target, side, par):
    """Of a solid; volume and energy of `side` and of `Behind` are its stretch and hoop strain, ahead and behind the last wave."""
    b, most, law = 4.0 / 3.0 * par.shear_modulus, strength_left(side.energy, par), OnBranch(par.eos)
    s, none = deviator(side.volume, side.energy, par), Limit(0.0, 0.0, 0.0, 0.0, 0.0)
    elastic = on_branch(side.rho, side.e, side.p, side.square, -s - b * math.log(side.rho), b, side)
    if target == side.p:
        return with_stretch(reach(target, elastic, law), side.volume, side), none
    way = 1.0 if target > side.p else -1.0
    left = (way * s + most) / b
    plastic = on_branch(side.rho, side.e, side.p, side.square - b / side.rho, way * most, 0.0, side)
    if left <= YIELDS:
        return yielding(target, way, plastic, side.energy, par), none
    limit = yield_point(way, side.rho * math.exp(way * left), elastic, law)
    if (target - limit.sigma) * way <= 0.0:
        found = compression(target, elastic, law) if way > 0.0 else expansion(target, elastic, law)
        return with_stretch(found, side.volume * found.rho / side.rho, side), none
    sigma, by_rho, by_e = answer(limit.rho, limit.e, 0.0, way * most, 0.0, law)
    square = sound_squared(limit.rho, sigma, by_rho, by_e)
    last = yielding(target, way, on_branch(limit.rho, limit.e, limit.sigma, square, way * most, 0.0, side), side.energy, par)
    if way > 0.0 and limit.rise + last.flux / limit.rho >= limit.flux / side.rho:
        return yielding(target, way, plastic, side.energy, par), none
    return Behind(limit.rise + last.rise, last.slope, last.rho, last.e, last.flux, last.volume, last.energy), limit


def yielding(target, way, side, hoop, par):
    """A plastic wave from a state at yield; stretch and hoop strain stand for volume and energy of its `Behind`.

    In a cylinder uniaxial compression turns the stress along the yield surface (`turned`). The jump to the state at the end of that path
    is found on the straight branch p + a + b ln(rho) between both ends. Releases, which are not followed there, keep the hoop strain.
    """
    law, b, most = OnBranch(par.eos), 4.0 / 3.0 * par.shear_modulus, way * side.volume
    if hoop == 0.0 or way < 0.0:
        found = reach(target, side, law)
        return Behind(found.rise, found.slope, found.rho, found.e, found.flux, math.exp(way * most / b), hoop)
    full = 2.0 / 3.0 * par.yield_stress
    stiff, h, last = b * (1.0 - (most / full) * (most / full)), hoop, 0.0
    found = reach(target, on_branch(side.rho, side.e, side.p, side.square, most, 0.0, side), law)
    for _ in range(TURNS):
        square = side.square + stiff / side.rho
        found = reach(target, on_branch(side.rho, side.e, side.p, square, most - stiff * math.log(side.rho), stiff, side), law)
        strain = math.log(found.rho / side.rho)
        h = turned(hoop, strain, par)
        if abs(strain - last) <= 1e-13 * strain:
            break
        stiff, last = (strength_left(h, par) - most) / strain, strain
    return Behind(found.rise, found.slope, found.rho, found.e, found.flux, math.exp(strength_left(h, par) / b), h)


def turned(hoop, strain, par):
    """Hoop strain behind a uniaxial compression (ln of the densities) of a solid that yields: its angle psi from pure compression obeys

    d psi / d strain = -(2 G / Y) sin(psi).
    """
    ratio = 2.0 * par.shear_modulus / par.yield_stress
    sine = min(abs(0.5 * math.sqrt(3.0) * ratio * hoop), 1.0)
    tangent = sine / (1.0 + math.sqrt(1.0 - sine * sine)) * math.exp(-ratio * strain)
    behind = 2.0 * tangent / (1.0 + tangent * tangent)
    return hoop * behind / sine if sine > 0.0 else 0.0


def with_stretch(behind, stretch, side):
    """What stands behind a wave, with its stretch and the hoop strain of what is ahead."""
    return Behind(behind.rise, behind.slope, behind.rho, behind.e, behind.flux, stretch, side.energy)


def expansion(target, side, par):
    """A jump to a lower stress on the elastic branch."""
    v0, rise, mean = 1.0 / side.rho, target - side.p, 0.5 * (target + side.p)
    x, growth = rise / (side.rho * side.rho * side.square), 0.0
    for _ in range(20):        # nearly linear
        rho = 1.0 / (v0 - x)
        found, by_rho, by_e = answer(rho, side.e + mean * x, 0.0, side.volume, side.energy, par)
        step = (found - target) / (rho * rho * by_rho + mean * by_e)
        growth = (1.0 - 0.5 * by_e * x) / (rho * rho * by_rho + mean * by_e)
        x = x - step
        if not abs(step) > 1e-15 * abs(x):
            break
    flux = math.sqrt(rise / x) if rise * x > 0.0 else side.rho * math.sqrt(side.square)
    return Behind(rise / flux, (x + rise * growth) / (2.0 * rise / flux), 1.0 / (v0 - x), side.e + mean * x, flux, 0.0, 0.0)


def yield_point(way, rho, side, par):
    """The state behind a jump to a density on the elastic branch, compressed (way 1) or released (-1)."""
    x, sigma, e = 1.0 / side.rho - 1.0 / rho, side.p, side.e
    for _ in range(50):       # the stress is nearly linear in the energy
        e = side.e + 0.5 * (sigma + side.p) * x
        found, _, by_e = answer(rho, e, 0.0, side.volume, side.energy, par)
        new = sigma + (found - sigma) / (1.0 - 0.5 * by_e * x)
        done = abs(new - sigma) <= 2e-16 * abs(new)
        sigma = new
        if done:
            break
    rise = sigma - side.p
    flux = math.sqrt(rise / x) if rise * x > 0.0 else side.rho * math.sqrt(side.square)
    return Limit(sigma, rise / flux, rho, side.e + 0.5 * (sigma + side.p) * x, flux)


KERNELS = (plain_waves, on_branch, solid_waves, yielding, turned, with_stretch, expansion, yield_point)      # what kernels call by name
