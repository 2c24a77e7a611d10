r"""One wave of a fluid, from the state ahead to a pressure: plain functions that kernels compile for each law.

Compression is a jump, release an isentrope (equations as in `jump` and `fan`):

$$m^2 = \frac{p - p_0}{x},\quad e - e_0 = \tfrac12(p + p_0)x \qquad\text{or}\qquad
  \frac{de}{d\ln\rho} = \frac p\rho,\quad \frac{dw}{d\ln\rho} = c .$$

x is found by Newton's method inside a bracket; of reactants in thermal isolation that have partly burned it is the sum of the phases'
own jumps (`medium`). The isentrope takes Butcher's sixth-order steps of at most STRIDE in ln(rho), shorter where c^2 falls fast. It agrees
with the integration of `fan` to 1e-10, complete releases from twice the normal density and more to 1e-7.

Source: Courant and Friedrichs, sections 54, 65; J. C. Butcher, J. Austral. Math. Soc. 4 (1964) 179.
"""

import math
from typing import NamedTuple

from hugoniot.laws.burn.contract import Reactive
from hugoniot.laws.mixture.contract import MIXTURE
from hugoniot.laws.mixture.search import NASCENT
from hugoniot.laws.riemann.medium import answer, mixed_phases

STRIDE = 0.05
FEEBLE = 3e-8          # rise over rho c^2 below which a jump is acoustic to round-off
STIFF = 0.8            # of c^2: a step of a release on which it falls by more is halved
HALVINGS = 12
THINNEST = -60.0       # ln of the density over the one ahead where a release is given up


class Side(NamedTuple):
    """The state ahead of a wave: density, energy, pressure, c^2; burn fraction and reference state; highest densities."""

    rho: float
    e: float
    p: float
    square: float
    burned: float
    volume: float
    energy: float
    highest: float
    highest_r: float
    highest_p: float


class Behind(NamedTuple):
    """What stands behind: rise of velocity in the direction of the wave, its slope by p, density, energy, mass flux, reference state."""

    rise: float
    slope: float
    rho: float
    e: float
    flux: float
    volume: float
    energy: float


def sound_squared(rho, p, p_rho, p_e):
    """c^2 from a pressure and its slopes."""
    return p_rho + p * p_e / (rho * rho)


def drop(target, side, highest, par):
    """x = v0 - v behind a jump to the pressure `target` above the one ahead; nan where there is none."""
    v0, rise, mean = 1.0 / side.rho, target - side.p, 0.5 * (target + side.p)
    if side.square > 0.0 and abs(rise) <= FEEBLE * side.rho * side.square:
        return rise / (side.rho * side.rho * side.square)
    low, high = 0.0, v0 - 1.0 / highest
    x = rise / (side.rho * side.rho * side.square) if side.square > 0.0 else 0.5 * high
    if not x < 0.5 * v0 or not x < high:
        x = 0.5 * min(high, v0)
    last = 1e300
    for _ in range(200):
        rho = 1.0 / (v0 - x)
        found, by_rho, by_e = answer(rho, side.e + mean * x, side.burned, side.volume, side.energy, par)
        miss = found - target
        new = x - miss / (rho * rho * by_rho + mean * by_e)
        if abs(new - x) <= 2e-16 * abs(x):          # a step of rounding, which a bracket of rounding would only send astray
            return x
        if miss > 0.0 or miss != miss:
            high = x
        else:
            low = x
        new = min(new, 0.5 * (x + v0))              # no step more than doubles the density: pressures rise without bound
        if not (low < new < high):
            new = 0.5 * (low + high)
        moved = abs(new - x)
        if moved <= 1e-16 * v0 or (moved <= 1e-13 * abs(x) and moved >= last):
            return new if moved < last else x
        last, x = moved, new
    return x if last <= 1e-9 * abs(x) else math.nan


def both_drop(target, side, par):
    """(x, volume and energy of the reactants behind): of a partly burned mixture in isolation each phase jumps by itself."""
    mixture = par.mixture
    mixed = mixed_phases(side.rho, side.e, side.burned, side.volume, side.energy, mixture)
    heat, mean = mixture.detonation_energy, 0.5 * (target + side.p)
    if mixed.rho_r <= 0.0 or mixed.rho_p <= 0.0:           # a phase so rare that it is not found
        x = drop(target, side, side.highest, par)
        return x, 1.0 / side.rho - x, side.e + mean * x
    e_r = mixed.e_r - heat
    p_r, r_rho, r_e = answer(mixed.rho_r, e_r, 0.0, 0.0, 0.0, mixture.reactants)
    p_p, p_rho, p_e = answer(mixed.rho_p, mixed.e_p, 0.0, 0.0, 0.0, mixture.products)
    reactants = Side(mixed.rho_r, e_r, side.p, sound_squared(mixed.rho_r, p_r, r_rho, r_e), 0.0, 0.0, 0.0, side.highest_r, 0.0, 0.0)
    products = Side(mixed.rho_p, mixed.e_p, side.p, sound_squared(mixed.rho_p, p_p, p_rho, p_e), 0.0, 0.0, 0.0, side.highest_p, 0.0, 0.0)
    x_r, x_p = drop(target, reactants, side.highest_r, mixture.reactants), drop(target, products, side.highest_p, mixture.products)
    return (1.0 - side.burned) * x_r + side.burned * x_p, 1.0 / mixed.rho_r - x_r, mixed.e_r + mean * x_r


def plain_jump(target, side, par):
    """(x, reference volume, reference energy) behind a jump of a law without a reference state."""
    return drop(target, side, side.highest, par), side.volume, side.energy


def isolated_jump(target, side, par):
    """The same of a mixture in thermal isolation: the reactants' state behind the jump is their new reference."""
    if NASCENT < side.burned < 1.0 - NASCENT:
        return both_drop(target, side, par)
    x = drop(target, side, side.highest, par)
    return x, 1.0 / side.rho - x, side.e + 0.5 * (target + side.p) * x


def isolates(mixture):
    """Whether the reactants keep an isentrope."""
    return "follows_isentrope" in MIXTURE.of(mixture).flags


def reactive_jump(target, side, par):
    """The jump of a burning mixture."""
    return isolated_jump(target, side, par) if isolates(par.mixture) else plain_jump(target, side, par)


def jumps(target, side, par):
    """(x, reference volume, reference energy) behind a jump to a higher pressure."""
    return reactive_jump(target, side, par) if isinstance(par, Reactive) else plain_jump(target, side, par)


def compression(target, side, par):
    """The jump to a higher pressure."""
    x, volume, energy = jumps(target, side, par)
    rise, v = target - side.p, 1.0 / side.rho - x
    flux = math.sqrt(rise / x) if x > 0.0 else side.rho * math.sqrt(side.square)
    rho, e = 1.0 / v, side.e + 0.5 * (target + side.p) * x
    slope = 1.0 / flux
    if rise > 1e-6 * flux * flux / side.rho:
        p, by_rho, by_e = answer(rho, e, side.burned, volume, energy, par)
        growth = (1.0 - 0.5 * by_e * x) / (rho * rho * by_rho + 0.5 * by_e * (target + side.p))
        slope = (x + rise * growth) / (2.0 * rise / flux)
    return Behind(rise / flux, slope, rho, e, flux, volume, energy)


# -- release -----------------------------------------------------------------------------------------------------------
def rates(s, e, side, par):
    """(de/ds, dw/ds) at s = ln(rho/rho0)."""
    rho = side.rho * math.exp(s)
    p, by_rho, by_e = answer(rho, e, side.burned, side.volume, side.energy, par)
    return p / rho, math.sqrt(by_rho + p * by_e / (rho * rho))


def step(s, e, h, side, par):
    """(energy, w gained) after a step h of ln(rho): Butcher's sixth order."""
    a1, b1 = rates(s, e, side, par)
    a2, b2 = rates(s + h / 3.0, e + h * a1 / 3.0, side, par)
    a3, b3 = rates(s + 2.0 * h / 3.0, e + h * 2.0 * a2 / 3.0, side, par)
    a4, b4 = rates(s + h / 3.0, e + h * (a1 + 4.0 * a2 - a3) / 12.0, side, par)
    a5, b5 = rates(s + 0.5 * h, e + h * (-a1 + 18.0 * a2 - 3.0 * a3 - 6.0 * a4) / 16.0, side, par)
    a6, b6 = rates(s + 0.5 * h, e + h * (9.0 * a2 - 3.0 * a3 - 6.0 * a4 + 4.0 * a5) / 8.0, side, par)
    a7, b7 = rates(s + h, e + h * (9.0 * a1 - 36.0 * a2 + 63.0 * a3 + 72.0 * a4 - 64.0 * a6) / 44.0, side, par)
    return (e + h * (11.0 * (a1 + a7) + 81.0 * (a3 + a4) - 32.0 * (a5 + a6)) / 120.0,
            h * (11.0 * (b1 + b7) + 81.0 * (b3 + b4) - 32.0 * (b5 + b6)) / 120.0)


def release(target, side, par):
    """The isentrope down to a pressure: Newton's steps along it, each integrated from where the last one ended."""
    s, e, w, p, rho, square = 0.0, side.e, 0.0, side.p, side.rho, side.square
    new, gained, there, found, c2 = e, 0.0, rho, p, square
    for _ in range(2000):
        h = min(max((target - p) / (rho * square), -STRIDE), STRIDE) if square > 0.0 else 0.0
        if abs(h) <= 1e-15 or s <= THINNEST:
            break
        for _ in range(HALVINGS):       # c^2 falls fast near the highest density of a law, and towards none
            new, gained = step(s, e, h, side, par)
            there = side.rho * math.exp(s + h)
            found, by_rho, by_e = answer(there, new, side.burned, side.volume, side.energy, par)
            c2 = sound_squared(there, found, by_rho, by_e)
            if c2 >= STIFF * square or h > 0.0:
                break
            h = 0.5 * h
        s, e, w, p, rho, square = s + h, new, w + gained, found, there, c2
        if abs(p - target) <= 1e-15 * (abs(target) + abs(side.p)):
            break
    c = math.sqrt(square)
    return Behind(w, 1.0 / (rho * c), rho, e, rho * c, side.volume, side.energy)


def reach(target, side, par):
    """The wave to a pressure: a jump above the one ahead, an isentrope below it."""
    if target > side.p:
        return compression(target, side, par)
    if target == side.p:
        flux = side.rho * math.sqrt(side.square)
        return Behind(0.0, 1.0 / flux if flux > 0.0 else math.inf, side.rho, side.e, flux, side.volume, side.energy)
    return release(target, side, par)
