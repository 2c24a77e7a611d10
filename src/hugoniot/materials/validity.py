r"""Up to which particle velocity a material may be believed, and to which one an impact drives it.

Where no source states the end of a material's data it is estimated: the least particle velocity of a single shock into the material at
rest at which its atoms are ionised (`IONISED`), its law compresses it more than `COMPRESSED` times, as a strong shock does an ideal
monatomic gas, its pressure exceeds `HIGHEST`, or the fit of its law ends. An impact is estimated by the two Hugoniots from rest,
$p_A(u) = p_B(w - u)$ for the closing velocity w: strength, pores that are crushed already and other initial states are left out.
"""

import contextlib
import math
from collections.abc import Callable
from typing import NamedTuple

from hugoniot.errors import HugoniotError, NoSolution
from hugoniot.laws.eos.contract import (
    density_limits,
    flagged,
    is_condensed,
    particle_velocity_limit,
    pressure,
    pressure_derivatives,
    reference_state,
)
from hugoniot.materials.material import Material
from hugoniot.materials.plausible import unlikely
from hugoniot.units import format_si

IONISED = 15e3       # m/s of particle velocity: 112 MJ/kg, 31 eV for an atom of aluminium, whose first two electrons take 25 eV
COMPRESSED = 4.0     # times the density at rest
HIGHEST = 10e12      # Pa
LIGHTEST = 600.0     # kg/m3: lighter solids are foams, which are crushed to more than four times their density, and lithium
LEAST = 1e-6         # of the closing velocity: the smallest part that one of two bodies takes
SHOCKS_ONLY = ("this law gives the pressure of the shock that would produce the energy, whatever the density: releases, isentropes and "
               "second shocks computed with it are meaningless, and it has no Grüneisen parameter")
_NEWTON = 40
_STEPS = 80
_DENSEST = 1e3       # times the density at rest: as far as a law without a limit is looked at


class Range(NamedTuple):
    """The particle velocity (m/s) where a material's data, or what is estimated of them, end; `why` an estimate ends there, in words."""

    up: float
    why: str
    stated: bool


def range_of(material: Material) -> Range:
    """Where the data of a material end: as stated, else as estimated from its law."""
    if material.valid_up_to is not None:
        return Range(material.valid_up_to, "", True)
    ends = [(IONISED, "an estimate for all materials: above roughly this velocity atoms are ionised")]
    if material.burn is None and not flagged(material.eos, "gas"):
        with contextlib.suppress(HugoniotError, ArithmeticError, ValueError):      # a law that cannot be asked there
            ends += _ends(material.eos)
    up, why = min(ends)
    return Range(up, why, False)


def beyond(end: Range) -> str:
    """What is said of a material that is driven beyond the estimated end of its range."""
    atoms = "its atoms are ionised there, which no law of a deck describes"
    return atoms if end.up == IONISED else f"that is beyond {rounded(end.up)}, {end.why}"


def rounded(up: float) -> str:
    """A particle velocity in words, to four digits."""
    return format_si(float(f"{up:.4g}"), "m/s")


def beyond_data(material: Material) -> tuple[float, str]:
    """(largest change of the particle velocity in a shock that needs no remark, m/s; the remark above it, {up} in place of the change)."""
    limit = material.valid_up_to
    if limit:
        return limit * (1.0 + 1e-9), (f"the data of {material.name} end at up = {limit:.6g} m/s, but the shock has up = {{up}} m/s: "
                                      "extrapolated")
    if limit is None and not flagged(material.eos, "gas"):
        return 0.0, f"the range of the data of {material.name} is not known: up = {{up}} m/s may lie beyond it"
    return math.inf, ""


def about_shock(material: Material, jump: float = 0.0) -> list[str]:
    """What must be said with an answer about a material: where a shock that changes the particle velocity by `jump` (m/s) extrapolates its
    data, what its law cannot describe, unlikely constants, its own warnings."""
    return [*about_jump(material, jump), *about_law(material), *unlikely(material.name, material), *material.warnings]


def about_jump(material: Material, jump: float) -> list[str]:
    """Where a shock that changes the particle velocity by `jump` (m/s) extrapolates the data of a material."""
    limit, words = beyond_data(material)
    return [words.replace("{up}", f"{jump:.6g}")] if jump > limit else []


def about_law(material: Material) -> list[str]:
    """What the law of a material cannot describe."""
    return [SHOCKS_ONLY] if flagged(material.eos, "shocks_only") else []


def _ends(par) -> list[tuple[float, str]]:
    found = [(particle_velocity_limit(par), "the largest that a shock on this Us-up relation can have")]
    if not is_condensed(par):
        return found
    rho0 = reference_state(par)[0]
    low, high = rho0, min(COMPRESSED * rho0, density_limits(par)[1] * (1.0 - 1e-9))
    p = _hugoniot(high, par)
    if p < math.inf and high == COMPRESSED * rho0 and rho0 > LIGHTEST:
        found.append((_velocity(high, p, par), f"at which the law gives a density of {COMPRESSED:g} rho0 in one shock"))
    if p > HIGHEST:
        rho = _root(lambda rho: min(_hugoniot(rho, par), 1e3 * HIGHEST) - HIGHEST, low, high)
        found.append((_velocity(rho, HIGHEST, par), f"at which the pressure of a shock is {HIGHEST * 1e-12:g} TPa"))
    return found


def _root(function: Callable[[float], float], low: float, high: float) -> float:
    """Where a function changes its sign, to nine digits, by the rule of false position in the form called Illinois. Raises `NoSolution`."""
    f_low, f_high = function(low), function(high)
    if not f_low * f_high <= 0.0:
        raise NoSolution("no change of sign")
    for _ in range(_STEPS):
        x = high - f_high * (high - low) / (f_high - f_low) if f_high != f_low else high
        f = function(x)
        if f * f_high < 0.0:
            low, f_low = high, f_high
        else:
            f_low *= 0.5
        high, f_high = x, f
        if f == 0.0 or abs(high - low) <= 1e-9 * abs(high):
            break
    return high


def _hugoniot(rho: float, par) -> float:
    """Pressure (Pa) of the shock from rest to a density; inf beyond the last compression that a shock reaches."""
    rho0, e0 = reference_state(par)
    p0, half = pressure(rho0, e0, par), 0.5 * (1.0 / rho0 - 1.0 / rho)
    p = p0
    for _ in range(_NEWTON):
        e = e0 + (p + p0) * half
        slope = pressure_derivatives(rho, e, par)[1] * half - 1.0
        if not slope < 0.0:
            return math.inf
        step = (pressure(rho, e, par) - p) / slope
        p -= step
        if abs(step) <= 1e-10 * abs(p):
            break
    return p if p >= p0 else math.inf


def _velocity(rho: float, p: float, par) -> float:
    """Particle velocity (m/s) behind that shock."""
    rho0, e0 = reference_state(par)
    return math.sqrt((p - pressure(rho0, e0, par)) * (1.0 / rho0 - 1.0 / rho))


def _shock(up: float, par) -> float:
    """Pressure (Pa) of the shock from rest with a particle velocity."""
    rho0, limit = reference_state(par)[0], density_limits(par)[1]

    def misses(rho):
        p = _hugoniot(rho, par)
        return min(_velocity(rho, p, par) if p < math.inf else math.inf, 1e3 * up) - up

    low, high = rho0, min(1.3 * rho0, 0.5 * (rho0 + limit))
    while misses(high) < 0.0 and low < high < _DENSEST * rho0:      # equal, once the limit is a digit away
        low, high = high, min(1.3 * high, 0.5 * (high + limit))
    rho = _root(misses, low, high)
    return pressure(rho0, reference_state(par)[1], par) + up * up / (1.0 / rho0 - 1.0 / rho)


def impact(left: Material, right: Material, closing: float) -> tuple[float, float]:
    """Particle velocities (m/s) of the shocks in two materials that meet at `closing` m/s; half of that where a law does not tell."""
    up = 0.5 * closing
    if left.burn is None and right.burn is None:
        low, high = LEAST * closing, (1.0 - LEAST) * closing
        with contextlib.suppress(HugoniotError, ArithmeticError, ValueError):
            up = _root(lambda u: _shock(u, left.eos) - _shock(closing - u, right.eos), low, high)
    return up, closing - up
