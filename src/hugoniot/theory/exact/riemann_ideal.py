r"""Riemann problem of two ideal or stiffened gases, each with its own ratio of specific heats and stiffness pressure.

It tests a solver with shocks, rarefactions, contacts and vacuum. Well-known shock tubes have entries of their own below.

Each side obeys $p = (\gamma-1)\rho e - \gamma p_\infty$ with the stiffness pressure $p_\infty$, which is 0 for an ideal gas. Let $P = p +
p_\infty$, let $c$ be the sound speed, $c^2 = \gamma P/\rho$, and let the index k (L or R) denote the initial state of a side. The
velocity change across the wave that takes side k to the pressure $p$ is

$$f_k(p) = \begin{cases}(p - p_k)\left[\tfrac{\rho_k}{2}\left((\gamma+1)P + (\gamma-1)P_k\right)\right]^{-1/2} & p > p_k\\[2pt]
  \dfrac{2 c_k}{\gamma-1}\left[\left(P/P_k\right)^{(\gamma-1)/2\gamma} - 1\right] & p \le p_k\end{cases}$$

The pressure between the waves is the root of $f_L(p) + f_R(p) + u_R - u_L = 0$, whose left side increases with $p$. If a side is an ideal
gas and no root is positive, the two sides separate: an ideal gas expands into vacuum, a stiffened gas is released to zero pressure. Two
stiffened gases may be in tension between the waves, down to minus the smaller $p_\infty$; if they are pulled apart more strongly, there is
no solution and an error is raised.

Source: Toro, Riemann Solvers and Numerical Methods for Fluid Dynamics (2009), chapter 4; with a stiffness pressure: Ivings, Causon &
Toro, Int. J. Numer. Meth. Fluids 28 (1998) 395. Starkenberg's sign of the stiffness pressure is the opposite (S-E8).
"""

from typing import NamedTuple

import numpy as np
from scipy.optimize import brentq

from hugoniot.errors import OutOfRange
from hugoniot.theory.exact.solution import Solution


class Side(NamedTuple):
    """State of one side: density, velocity, pressure, ratio of specific heats, stiffness pressure (0: ideal gas)."""

    density: float
    velocity: float
    pressure: float
    gamma: float = 1.4
    p_infinity: float = 0.0

    @property
    def sound_speed(self) -> float:
        return float(np.sqrt(self.gamma * (self.pressure + self.p_infinity) / self.density))


class Wave(NamedTuple):
    """One side's wave: star density and the lab speeds of its edges, `head` towards the undisturbed gas (equal for a shock)."""

    kind: str
    density: float
    head: float
    tail: float


def velocity_change(pressure: float, side: Side) -> float:
    """f_k(p) of the module's equation: how much the wave to `pressure` slows the approach of the two sides."""
    g, stiff, before = side.gamma, pressure + side.p_infinity, side.pressure + side.p_infinity
    if pressure > side.pressure:
        return (pressure - side.pressure) / np.sqrt(0.5 * side.density * ((g + 1.0) * stiff + (g - 1.0) * before))
    return 2.0 * side.sound_speed / (g - 1.0) * ((stiff / before) ** ((g - 1.0) / (2.0 * g)) - 1.0)


def star(left: Side, right: Side) -> tuple[float, float, float]:
    """(pressure, velocity left, velocity right) between the waves; the velocities differ where the sides separate."""
    for side in (left, right):
        if not (side.density > 0.0 and side.pressure + side.p_infinity > 0.0 and side.gamma > 1.0):
            raise OutOfRange(f"a side of a Riemann problem needs density > 0, pressure + p_infinity > 0 and gamma > 1, got "
                             f"density = {side.density:g} kg/m3, pressure = {side.pressure:g} Pa, p_infinity = {side.p_infinity:g} Pa, "
                             f"gamma = {side.gamma:g}")

    def balance(p):
        return velocity_change(p, left) + velocity_change(p, right) + right.velocity - left.velocity

    lowest = 0.0 - min(left.p_infinity, right.p_infinity)
    if balance(lowest) >= 0.0:  # even full release leaves them apart
        if lowest < 0.0:
            raise OutOfRange("the two liquids are pulled apart beyond their stiffness pressure; there is no Riemann solution")
        return lowest, left.velocity - velocity_change(lowest, left), right.velocity + velocity_change(lowest, right)
    highest = max(left.pressure, right.pressure) - lowest
    while balance(lowest + highest) < 0.0:
        highest *= 4.0
    p = lowest + brentq(lambda excess: balance(lowest + excess), 0.0, highest, xtol=1e-17 * highest, rtol=1e-15, maxiter=500)
    u = 0.5 * (left.velocity + right.velocity + velocity_change(p, right) - velocity_change(p, left))
    return p, u, u


def wave(side: Side, pressure: float, velocity: float, sign: float) -> Wave:
    """The wave on one side; sign -1 for the left, +1 for the right."""
    g, stiff, before, c = side.gamma, pressure + side.p_infinity, side.pressure + side.p_infinity, side.sound_speed
    if pressure > side.pressure:
        mu, ratio = (g - 1.0) / (g + 1.0), stiff / before
        speed = side.velocity + sign * c * np.sqrt((g + 1.0) / (2.0 * g) * ratio + (g - 1.0) / (2.0 * g))
        return Wave("shock", side.density * (ratio + mu) / (mu * ratio + 1.0), speed, speed)
    density = side.density * (stiff / before) ** (1.0 / g)
    sound = float(np.sqrt(g * stiff / density)) if density > 0.0 else 0.0
    return Wave("rarefaction", density, side.velocity + sign * c, velocity + sign * sound)


def _fill(out, side, w, p_star, u_star, sign, speed):
    """Write one side's fields at the similarity coordinates `speed` = (x - x0) / t that lie on this side of the contact."""
    g, rho, u, p = side.gamma, side.density, side.velocity, side.pressure
    ahead, behind = sign * speed > sign * w.head, sign * speed < sign * w.tail
    fan = ~ahead & ~behind if w.kind == "rarefaction" else np.zeros_like(ahead)
    c = 2.0 / (g + 1.0) * (side.sound_speed + 0.5 * (g - 1.0) * sign * (speed - u))
    c = np.maximum(c, 0.0)
    ratio = c / side.sound_speed
    out["density"] = np.where(ahead, rho, np.where(fan, rho * ratio ** (2.0 / (g - 1.0)), w.density))
    out["velocity"] = np.where(ahead, u, np.where(fan, speed - sign * c, u_star))
    fan_pressure = (p + side.p_infinity) * ratio ** (2.0 * g / (g - 1.0)) - side.p_infinity
    out["pressure"] = np.where(ahead, p, np.where(fan, fan_pressure, p_star))
    solid = out["density"] > 0.0
    safe = np.where(solid, out["density"], 1.0)
    out["energy"] = np.where(solid, (out["pressure"] + g * side.p_infinity) / ((g - 1.0) * safe), 0.0)
    out["sound_speed"] = np.where(solid, np.sqrt(g * np.maximum(out["pressure"] + side.p_infinity, 0.0) / safe), 0.0)
    return out


def riemann_ideal(left: Side, right: Side, x0: float = 0.0, title: str = "Riemann problem") -> Solution:
    """Riemann problem of ideal or stiffened gases: two uniform states that meet at x0 at time 0.

    left.density      density on the left
    left.velocity     velocity on the left
    left.pressure     pressure on the left
    left.gamma        ratio of specific heats on the left, above 1
    left.p_infinity   stiffness pressure on the left; 0: ideal gas
    right.density     density on the right
    right.velocity    velocity on the right
    right.pressure    pressure on the right
    right.gamma       ratio of specific heats on the right, above 1
    right.p_infinity  stiffness pressure on the right; 0: ideal gas
    x0                position of the contact at time 0
    title             heading of the results

    Fields: density, velocity, pressure, energy, sound_speed. In a vacuum the density is 0, and the velocity is that of the nearer gas
    front. Numbers: star_pressure, star_velocity (between the waves), star_density_left, star_density_right (on either side of the
    contact), and the velocities left_head, left_tail, right_tail, right_head of the edges of both waves (equal for a shock).
    """
    p, u_left, u_right = star(left, right)
    waves = wave(left, p, u_left, -1.0), wave(right, p, u_right, 1.0)
    middle = 0.5 * (u_left + u_right)

    def profile(x, time):
        with np.errstate(divide="ignore", invalid="ignore"):
            speed = (x - x0) / time if time > 0.0 else np.where(x < x0, -np.inf, np.inf)
        finite = np.clip(speed, -1e30, 1e30)
        one = _fill({}, left, waves[0], p, u_left, -1.0, finite)
        two = _fill({}, right, waves[1], p, u_right, 1.0, finite)
        fields = {name: np.where(finite < middle, one[name], two[name]) for name in one}
        if u_right > u_left:
            gap = (finite > u_left) & (finite < u_right)
            for name in ("density", "pressure", "energy", "sound_speed"):
                fields[name] = np.where(gap, 0.0, fields[name])
        return fields

    def fronts(time):
        shocks = [w.head for w in waves if w.kind == "shock"]
        contacts = [u for u, w in zip((u_left, u_right), waves) if w.density > 0.0 or u_left == u_right]
        return tuple(x0 + s * time for s in {*shocks, *contacts})

    numbers = {
        "star_pressure": p, "star_velocity": middle, "star_density_left": waves[0].density, "star_density_right": waves[1].density,
        "left_head": waves[0].head, "left_tail": waves[0].tail, "right_tail": waves[1].tail, "right_head": waves[1].head,
    }
    return Solution(title, "planar", profile, fronts, numbers)


def sod() -> Solution:
    """Sod's shock tube: gamma 1.4 on 0 < x < 1, diaphragm at 0.5.

    Both sides are at rest. Left: density 1, pressure 1. Right: density 0.125, pressure 0.1.
    """
    return riemann_ideal(Side(1.0, 0.0, 1.0), Side(0.125, 0.0, 0.1), 0.5, "Sod shock tube")


def leblanc() -> Solution:
    """LeBlanc's shock tube: gamma 5/3 on 0 < x < 9, diaphragm at 3, specific energies that differ by a factor of a million.

    Both sides are at rest. Left: density 1, specific internal energy 0.1. Right: density 0.001, specific internal energy 1e-7.
    """
    g = 5.0 / 3.0
    return riemann_ideal(Side(1.0, 0.0, (g - 1.0) * 0.1, g), Side(1e-3, 0.0, (g - 1.0) * 1e-10, g), 3.0, "LeBlanc shock tube")


def two_rarefactions() -> Solution:
    """The "123" problem: two rarefactions that leave almost a vacuum, gamma 1.4 on 0 < x < 1, initial contact at 0.5.

    Both sides have density 1 and pressure 0.4; the velocity is -2 on the left and 2 on the right.
    """
    return riemann_ideal(Side(1.0, -2.0, 0.4), Side(1.0, 2.0, 0.4), 0.5, "123 problem")


def collision() -> Solution:
    """Two gas streams that collide and produce two shocks: gamma 1.4 on 0 < x < 1, initial contact at 0.5.

    Left: density 5.99924, velocity 19.5975, pressure 460.894. Right: density 5.99242, velocity -6.19633, pressure 46.0950.
    """
    return riemann_ideal(Side(5.99924, 19.5975, 460.894), Side(5.99242, -6.19633, 46.0950), 0.5, "colliding streams")


def water_gas() -> Solution:
    """Compressed stiffened liquid (1 GPa) against a gas (0.1 MPa) on 0 < x < 1 m, initial contact at 0.7 m.

    Both sides are at rest. Left: density 1000 kg/m3, pressure 1 GPa, gamma 4.4, stiffness pressure 600 MPa. Right: density 50 kg/m3,
    pressure 0.1 MPa, gamma 1.4, no stiffness pressure.
    """
    return riemann_ideal(Side(1000.0, 0.0, 1e9, 4.4, 6e8), Side(50.0, 0.0, 1e5), 0.7, "liquid-gas shock tube")
