r"""Detonation fronts as jumps from an unburned explosive to its products: the Chapman-Jouguet one, and overdriven ones.

The unburned state $(\rho_0, u_0, e_0, p_0)$ has the chemical energy in $e_0$. With the products' law the jump obeys the
relations of `jump`,

$$m^2 = \frac{p - p_0}{v_0 - v}, \qquad e - e_0 = \tfrac12(p + p_0)(v_0 - v),$$

where at each density behind one pressure answers. The front is slowest where the products leave it at their own speed of sound,
$m/\rho = c$ (Chapman and Jouguet); compressed further, it is a strong detonation, and what stands behind it can reach it.

Source: Fickett and Davis, Detonation, sections 2A and 2C.
"""

import math
from typing import NamedTuple

from hugoniot.errors import NoSolution
from hugoniot.laws.eos.contract import EOS, density_limits
from hugoniot.laws.riemann import jump
from hugoniot.laws.riemann.branch import Branch, State, wave_speed_squared
from hugoniot.laws.riemann.curve import Curve

SUPPORTED = 1e-2      # excess of velocity, over that behind the front, below which a front counts as unsupported (D changes by 4e-5)


class Front(NamedTuple):
    """A detonation: velocity (m/s, in the laboratory), state ahead, and of the products behind."""

    speed: float
    ahead: State
    behind: State


def at_density(rho: float, ahead: State, par, direction: int) -> Front:
    """The detonation that compresses its products to a density."""
    after, flux = jump.to_density(rho, ahead, Branch(par), direction, 0.0)
    return Front(ahead.u + direction * flux / ahead.rho, ahead, after)


def chapman_jouguet(ahead: State, par, direction: int) -> Front:
    """The slowest detonation; `NoSolution` where the products drive none."""
    low, limit = ahead.rho * (1.0 + 1e-9), min(0.999 * density_limits(par)[1], 20.0 * ahead.rho)

    def subsonic(rho):
        found = at_density(rho, ahead, par, direction)
        relative = abs(found.speed - found.behind.u)
        return relative < math.sqrt(max(wave_speed_squared(rho, found.behind.e, Branch(par)), 0.0)) and relative > 0.0

    high = 1.01 * low
    while high < limit and not subsonic(high):
        low, high = high, 1.01 * high
    if high >= limit or subsonic(low):
        raise NoSolution(f"the products '{EOS.of(par).name}' drive no detonation from {ahead.rho:.6g} kg/m3 and {ahead.e:.6g} J/kg; "
                         "give products that release energy there")
    for _ in range(200):
        middle = 0.5 * (low + high)
        if not low < middle < high:
            break
        low, high = (low, middle) if subsonic(middle) else (middle, high)
    return at_density(high, ahead, par, direction)


def driven(slowest: Front, follower: Curve, par) -> Front:
    """The front in balance with what follows it: `slowest`, or a strong one if the follower pushes harder.

    follower   wave curve of the material behind, for waves that run away from the front
    """
    d = -follower.direction

    def excess(front: Front) -> float:
        return d * (follower.at(front.behind.sigma)[0].u - front.behind.u)

    if excess(slowest) <= SUPPORTED * abs(slowest.behind.u - slowest.ahead.u):
        return slowest
    low, high = slowest.behind.rho, slowest.behind.rho * 1.02
    limit = 0.999 * density_limits(par)[1]
    while excess(at_density(min(high, limit), slowest.ahead, par, d)) > 0.0:
        if high >= limit:
            raise NoSolution(f"the products '{EOS.of(par).name}' are driven beyond their compression limit")
        low, high = high, high * 1.05
    high = min(high, limit)
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if excess(at_density(middle, slowest.ahead, par, d)) > 0.0 else (low, middle)
        if high - low <= 1e-13 * high:
            break
    return at_density(high, slowest.ahead, par, d)
