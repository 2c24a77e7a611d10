r"""A piston drives cold ideal gas against a wall: the shock runs back and forth, each time into the state left by the previous passage.

It tests a solver with repeated shocks. On a skewed mesh in two dimensions it is Saltzman's problem, which tests whether a plane shock
stays plane.

Every passage is a shock into a known state $(\rho, p)$ with the sound speed $c$ that changes the velocity by the piston speed $U$. The
speed $w$ of the shock relative to the gas ahead and the state behind, marked by a prime, are

$$w = A + \sqrt{A^2 + c^2}, \quad A = \tfrac{\gamma+1}{4} U; \qquad
p' = p + \rho w U, \quad \rho' = \rho\,\frac{w}{w - U}, \quad e' = e + \tfrac12 (p + p')\left(\tfrac1\rho - \tfrac1{\rho'}\right)$$

For $\gamma = 5/3$ and unit piston speed, length and density the densities are 4, 10 and 20, and the shock meets the wall at $t = 0.75$,
the piston at 0.9 and the wall again at 0.95.

Source: Dukowicz & Meltz, J. Comput. Phys. 99 (1992) 115 (Saltzman's skewed-mesh piston); Rankine-Hugoniot relations.
"""

from typing import NamedTuple

import numpy as np

from hugoniot.errors import OutOfRange
from hugoniot.theory.exact.solution import Solution


class Passage(NamedTuple):
    """One run of the shock: when and where it starts, its lab speed, when it ends, and the state behind it."""

    start: float
    position: float
    speed: float
    end: float
    density: float
    pressure: float
    energy: float
    velocity: float


def passages(gamma: float, piston: float, length: float, density: float, count: int) -> list[Passage]:
    """The first `count` runs of the shock between the piston (from x = 0) and the wall at x = length."""
    rho, p, e, u, time, x, found = density, 0.0, 0.0, 0.0, 0.0, 0.0, []
    for k in range(count):
        towards_wall = k % 2 == 0
        sign = 1.0 if towards_wall else -1.0
        half = 0.25 * (gamma + 1.0) * piston
        w = half + float(np.sqrt(half * half + gamma * p / rho))
        behind = rho * w / (w - piston)
        p_behind = p + rho * w * piston
        e_behind = e + 0.5 * (p + p_behind) * (1.0 / rho - 1.0 / behind)
        lab = u + sign * w
        end = time + (length - x) / lab if towards_wall else time + (x - piston * time) / (piston - lab)
        u_behind = piston if towards_wall else 0.0
        found.append(Passage(time, x, lab, end, behind, p_behind, e_behind, u_behind))
        rho, p, e, u, x, time = behind, p_behind, e_behind, u_behind, x + lab * (end - time), end
    return found


def saltzman(gamma: float = 5.0 / 3.0, piston: float = 1.0, length: float = 1.0, density: float = 1.0, reflections: int = 6) -> Solution:
    """Piston driven at constant speed from x = 0 into cold gas that extends to a wall: the shock and its successive reflections.

    gamma         ratio of specific heats, above 1
    piston        speed of the piston
    length        position of the wall
    density       density of the cold gas
    reflections   number of reflections followed, at least 2

    Fields: density, velocity, pressure, energy, sound_speed; not a number (NaN) where the piston has passed. Numbers: wall_time,
    piston_time and second_wall_time (the first three reflections), density_1 to density_3 and pressure_1 to pressure_3 (behind the first
    three passages). Valid until the reflection after the last one followed.
    """
    if gamma <= 1.0 or piston <= 0.0 or length <= 0.0 or density <= 0.0 or reflections < 2:
        raise OutOfRange("the piston problem needs gamma > 1, positive piston speed, length and density, and at least 2 reflections")
    runs = passages(gamma, piston, length, density, reflections + 1)
    cold = Passage(0.0, 0.0, 0.0, 0.0, density, 0.0, 0.0, 0.0)

    def now(time):
        index = next(k for k, run in enumerate(runs) if time <= run.end)
        return index, runs[index].position + runs[index].speed * (time - runs[index].start)

    def profile(x, time):
        index, front = now(time)
        behind, ahead = runs[index], runs[index - 1] if index else cold
        shocked = x < front if index % 2 == 0 else x > front
        gas = (x >= piston * time) & (x <= length)
        fields = {name: np.where(gas, np.where(shocked, getattr(behind, name), getattr(ahead, name)), np.nan)
                  for name in ("density", "velocity", "pressure", "energy")}
        fields["sound_speed"] = np.sqrt(gamma * fields["pressure"] / fields["density"])
        return fields

    numbers = {"wall_time": runs[0].end, "piston_time": runs[1].end, "second_wall_time": runs[2].end,
               "density_1": runs[0].density, "density_2": runs[1].density, "density_3": runs[2].density,
               "pressure_1": runs[0].pressure, "pressure_2": runs[1].pressure, "pressure_3": runs[2].pressure}
    return Solution("Saltzman piston", "planar", profile, lambda time: (now(time)[1],), numbers, (0.0, runs[-1].end))
