r"""Shock equation of state of the KB codes: the pressure of the shock that would have given a zone its energy.

It is included to reproduce results of the KB codes (Field Precision, 2000) for unreacted explosives. For anything else use `mie_gruneisen`.

$$p = \rho_0\,U_s\,u_p, \qquad u_p = \sqrt{2e}, \qquad U_s = c_0 + s\,u_p + s_2u_p^2$$

The density does not enter (K-E10): the pressure is right on the principal Hugoniot and nowhere else. There is no tension. In a zone with $e
= 0$ the pressure is zero, so compression does no work on it: only artificial viscosity heats it.

The sound speed is $c = (\rho_0/\rho)\sqrt{U_s\,(c_0 + 2su_p + 3s_2u_p^2)}$. With $s_2 < 0$ it is no longer real where the last factor
vanishes, and a run stops. The slope $\partial p/\partial e$ is infinite at $e = 0$; $u_p$ is therefore at least $10^{-9}$ m/s, which
leaves a pressure of a few hundredths of a pascal in a metal.

Source: KB codes, eq. 3.1, 3.6 and 3.7.
"""

from typing import NamedTuple

from hugoniot.core.ops import fmax, vsqrt
from hugoniot.errors import OutOfRange
from hugoniot.laws.eos.contract import EOS

REST = 1e-9     # m/s


class ShockEnergy(NamedTuple):
    rho0: float
    c0: float
    s: float
    s2: float = 0.0


def _particle_velocity(e):
    return vsqrt(2.0 * fmax(e, 0.0) + REST * REST)


def pressure(rho, e, par):
    """Energies below that of rest have no pressure."""
    u = _particle_velocity(e)
    return par.rho0 * (par.c0 + u * (par.s + u * par.s2)) * u


def pressure_derivatives(rho, e, par):
    u = _particle_velocity(e)
    return 0.0 * rho, par.rho0 * (par.c0 / u + 2.0 * par.s + 3.0 * par.s2 * u)


def reference_state(par):
    return par.rho0, 0.0


def density_limits(par):
    return 0.0, float("inf")


def build(rho0, c0, s, s2=0.0):
    """Parameters from a deck; OutOfRange unless rho0 and c0 are positive and s is not negative."""
    if not (rho0 > 0.0 and c0 > 0.0 and s >= 0.0):
        raise OutOfRange(f"shock_energy: needs rho0 > 0, c0 > 0 and s >= 0, got rho0 = {rho0:g} kg/m3, c0 = {c0:g} m/s, s = {s:g}")
    return ShockEnergy(rho0, c0, s, s2)


EOS.add(
    "shock_energy", ShockEnergy,
    functions=[pressure, pressure_derivatives, reference_state, density_limits],
    example=ShockEnergy(1770.0, 3080.0, 2.01),
    build=build,
    units={"rho0": "kg/m^3", "c0": "m/s", "s": "1", "s2": "s/m"},
    meaning={"rho0": "reference density", "c0": "shock velocity at zero particle velocity", "s": "initial slope of the Hugoniot, dUs/dup",
             "s2": "coefficient of up^2 in Us"},
    defaults={"s2": 0.0},
    box={"rho": (1200.0, 3500.0), "e": (1e2, 1e7)},
    flags=("shocks_only",),
    references=("KB codes, equations 3.1, 3.6, 3.7",),
)
