r"""Noh's implosion: cold gas flows towards a wall, an axis or a centre and stops behind an outgoing shock.

It tests a solver with an infinitely strong shock: the density behind the shock, its speed, and the spurious heating at the wall or centre.

$$r > r_s:\; \rho = \rho_0\left(1 + \frac{Ut}{r}\right)^{d-1},\; u = -U,\; p = 0; \qquad
  r < r_s:\; \rho = \rho_0\left(\frac{\gamma+1}{\gamma-1}\right)^{d},\; u = 0,\; e = \tfrac12 U^2,\; p = (\gamma-1)\rho e$$

* $r_s = \tfrac12(\gamma-1)Ut$: radius of the shock
* $\rho_0$, $U$: density at $t = 0$ and speed of the inflow, `density`, `speed`
* $\gamma$: ratio of specific heats, `gamma`
* $d$: 1 planar, 2 cylindrical, 3 spherical

The solution holds for every gamma; the values $4^d$ and $t/3$ often given for the compression and the shock hold only for $\gamma = 5/3$.

Source: Noh, J. Comput. Phys. 72 (1987) 78; conservation of mass, momentum and energy at the shock.
"""

import numpy as np

from hugoniot.errors import OutOfRange
from hugoniot.theory.exact.solution import Solution

DIMENSION = {"planar": 1, "cylindrical": 2, "spherical": 3}


def noh(geometry: str = "spherical", gamma: float = 5.0 / 3.0, density: float = 1.0, speed: float = 1.0) -> Solution:
    """Noh's implosion of an ideal gas: uniform cold inflow against a wall, axis or centre at r = 0.

    geometry   planar, cylindrical or spherical
    gamma      ratio of specific heats, above 1
    density    density of the inflow at time 0
    speed      speed of the inflow, towards r = 0

    Fields: density, velocity, pressure, energy, sound_speed, at r > 0.
    Numbers: plateau_density, plateau_energy, plateau_pressure (behind the shock), shock_speed.
    """
    if gamma <= 1.0 or density <= 0.0 or speed <= 0.0:
        raise OutOfRange(f"Noh's problem needs gamma > 1, density > 0 and speed > 0, got gamma = {gamma:g}, density = {density:g} kg/m3, "
                         f"speed = {speed:g} m/s")
    d = DIMENSION[geometry]
    plateau = density * ((gamma + 1.0) / (gamma - 1.0)) ** d
    energy = 0.5 * speed * speed
    shock = 0.5 * (gamma - 1.0) * speed

    def profile(r, time):
        inside = r < shock * time
        with np.errstate(divide="ignore"):
            ahead = density * (1.0 + speed * time / np.where(inside, np.inf, r)) ** (d - 1)
        rho = np.where(inside, plateau, ahead)
        e = np.where(inside, energy, 0.0)
        return {"density": rho, "velocity": np.where(inside, 0.0, -speed), "energy": e, "pressure": (gamma - 1.0) * rho * e,
                "sound_speed": np.sqrt(gamma * (gamma - 1.0) * e)}

    numbers = {"plateau_density": plateau, "plateau_energy": energy, "plateau_pressure": (gamma - 1.0) * plateau * energy,
               "shock_speed": shock}
    return Solution(f"Noh, {geometry}", geometry, profile, lambda time: (shock * time,), numbers)
