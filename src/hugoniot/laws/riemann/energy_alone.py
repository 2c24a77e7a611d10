r"""Waves of the law `shock_energy`, whose pressure depends on the energy alone: jumps and isentropes in closed form.

With $p = \rho_0U_s(u_p)\,u_p$ and $e = \tfrac12u_p^2$ everything is a function of $u_p$, the particle velocity of the shock from rest
with that energy. From $e - e_0 = \tfrac12(p + p_0)(v_0 - v)$ a jump and from $de = -p\,dv$ an isentrope have

$$v_0 - v = \frac{u_p^2 - u_{p0}^2}{p + p_0} \qquad\text{and}\qquad v_0 - v = \int_{u_{p0}}^{u_p}\frac{du}{\rho_0U_s}, \quad
  dw = \sqrt{\frac{c_0 + 2su_p + 3s_2u_p^2}{U_s}}\,du_p .$$

The impedance $\rho c = \rho_0\sqrt{U_s(c_0 + 2su_p + 3s_2u_p^2)}$ does not depend on the volume either, and the squared mass flux of a jump
is the mean of its square over the energy: waves are those of an ordinary material where the impedance rises with $u_p$. With $s_2 \ge 0$ it
always does; with $s_2 < 0$ up to a certain $u_p$, and shocks far beyond are refused. At rest it has no stress and a density of its own.

Source: KB codes equations 3.1, 3.6 and 3.7, with conservation of mass, momentum and energy.
"""

import math

import numpy as np

from hugoniot.errors import OutOfRange
from hugoniot.laws.eos.shock_energy import REST, ShockEnergy

_X, _W = (row.tolist() for row in np.polynomial.legendre.leggauss(20))
SOFTENS = ("law 'shock_energy': a shock to {:.6g} Pa would outrun the sound behind it, because with s2 below zero the impedance falls with "
           "the pressure there; use mie_gruneisen")
NO_TENSION = "law 'shock_energy' supports no tension: it has no state at {:.6g} Pa"


def velocity_of(sigma: float, par: ShockEnergy) -> float:
    """u_p (m/s) at a pressure, Pa."""
    if not sigma >= 0.0:
        raise OutOfRange(NO_TENSION.format(sigma))
    u = 2.0 * sigma / par.rho0 / (par.c0 + math.sqrt(par.c0**2 + 4.0 * par.s * sigma / par.rho0))
    for _ in range(60 if par.s2 else 0):
        slope = par.rho0 * _fall(u, par)
        if not slope > 0.0:
            raise OutOfRange(SOFTENS.format(sigma))
        moved = (par.rho0 * _speed(u, par) * u - sigma) / slope
        u -= moved
        if abs(moved) <= 4e-16 * u:
            break
    return u


def of_energy(e: float) -> float:
    """u_p (m/s) at an energy, J/kg."""
    return math.sqrt(max(2.0 * e + REST * REST, 0.0))


def _speed(u: float, par: ShockEnergy) -> float:
    return par.c0 + u * (par.s + u * par.s2)


def _fall(u: float, par: ShockEnergy) -> float:
    """dp/du_p over rho0."""
    return par.c0 + u * (2.0 * par.s + 3.0 * u * par.s2)


def impedance(u: float, par: ShockEnergy) -> float:
    """rho c, kg/m2/s."""
    return par.rho0 * math.sqrt(max(_speed(u, par) * _fall(u, par), 0.0))


def drop(sigma: float, before: float, par: ShockEnergy) -> float:
    """v0 - v of a jump from the pressure `before`; `OutOfRange` where it is no shock."""
    u, u0 = velocity_of(sigma, par), velocity_of(before, par)
    chord = par.rho0 * (par.c0 + par.s * (u + u0) + par.s2 * (u * u + u * u0 + u0 * u0))
    x = (sigma - before) / chord * (u + u0) / (sigma + before) if sigma + before > 0.0 else 0.0
    if par.s2 < 0.0 and sigma > before and (sigma - before) / x > (1.0 + 1e-9) * impedance(u, par) ** 2:
        raise OutOfRange(SOFTENS.format(sigma))
    return x


def release(u: float, start: float, par: ShockEnergy) -> tuple[float, float]:
    """(growth of the specific volume, velocity gained) on the isentrope from u_p = start to u; the velocity is negative."""
    half, middle = 0.5 * (start - u), 0.5 * (start + u)
    places = [middle + half * x for x in _X]
    volume = sum(w / _speed(one, par) for w, one in zip(_W, places))
    gain = sum(w * math.sqrt(_fall(one, par) / _speed(one, par)) for w, one in zip(_W, places))
    return half * volume / par.rho0, -half * gain
