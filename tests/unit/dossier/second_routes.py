"""Second routes to what theory answers, sharing no code with it: bisection on the jump conditions with the law's pressure alone."""

import math
from typing import NamedTuple

from hugoniot.laws.eos.contract import EOS, pressure, pressure_derivatives, reference_state, sound_speed_squared


class ChapmanJouguet(NamedTuple):
    """Velocity m/s, pressure Pa, density kg/m3, adiabatic exponent."""

    velocity: float
    pressure: float
    density: float
    exponent: float


def hugoniot_pressure(rho, rho0, e0, par):
    """Pressure on the Hugoniot from (rho0, e0) at zero pressure, Pa, for a law linear in energy: e = e0 + p (1/rho0 - 1/rho)/2."""
    p_cold, p_e = pressure(rho, 0.0, par), pressure_derivatives(rho, 0.0, par)[1]
    return (p_cold + p_e * e0) / (1.0 - 0.5 * p_e * (1.0 / rho0 - 1.0 / rho))


def chapman_jouguet(par) -> ChapmanJouguet:
    """Tangency of the Rayleigh line and the products' Hugoniot, rho c = rho0 D, by bisection in density; a law linear in energy."""
    rho0, e0 = reference_state(par)

    def energy(rho):
        return e0 + 0.5 * hugoniot_pressure(rho, rho0, e0, par) * (1.0 / rho0 - 1.0 / rho)

    def slope(rho):
        return rho * rho * sound_speed_squared(rho, energy(rho), par) - hugoniot_pressure(rho, rho0, e0, par) / (1.0 / rho0 - 1.0 / rho)

    low = high = 1.02 * rho0
    while not slope(high) > 0.0:
        low, high = high, high * 1.02
        assert high < 2.5 * rho0
    for _ in range(200):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if slope(middle) > 0.0 else (middle, high)
    p = hugoniot_pressure(high, rho0, e0, par)
    c2 = sound_speed_squared(high, energy(high), par)
    return ChapmanJouguet(math.sqrt(p / (1.0 - rho0 / high) / rho0), p, high, high * c2 / p)


def shock_velocity(par, up):
    """Us of the principal Hugoniot, m/s: p - p0 = up^2/dv and e = e0 + up^2/2 + p0 dv hold at any density; bisection finds the law's."""
    rho0, e0 = reference_state(par)
    p0 = pressure(rho0, e0, par)

    def excess(rho):
        dv = 1.0 / rho0 - 1.0 / rho
        return (pressure(rho, e0 + 0.5 * up * up + p0 * dv, par) - p0) * dv - up * up

    highest = EOS.of(par).functions["density_limits"](par)[1]
    low = high = rho0
    while not excess(high) > 0.0:
        low, high = high, min(high * 1.02, 0.5 * (high + highest))
        assert high > low
    for _ in range(100):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if excess(middle) > 0.0 else (middle, high)
    return up / (1.0 - rho0 / high)
