r"""Taylor wave: a plane detonation, lit at a wall or a piston, and the rarefaction that follows it.

It tests a solver with programmed burn: the pressure at the front and the shape of the release behind it.

The products are an ideal gas with the CJ state $u = D/(\gamma+1)$, $c = \gamma D/(\gamma+1)$, $p = \rho_0D^2/(\gamma+1)$ at the front $x
= Dt$. Behind it

$$u = \frac{2}{\gamma+1}\left(\frac xt - \frac D2\right), \qquad c = \frac D2 + \frac{\gamma-1}{2}u, \qquad
  \frac{\rho}{\rho_{CJ}} = \left(\frac{c}{c_{CJ}}\right)^{2/(\gamma-1)}$$

until $u$ equals the speed $U$ of the piston, at $x = (\tfrac D2 + \tfrac{\gamma+1}{2}U)\,t$; from there to the piston the state is
uniform. With a wall ($U = 0$) the uniform region extends half-way to the front.

* $D$: `detonation_velocity`; $\rho_0$: `density`, before the detonation arrives; $\gamma$: `gamma`; $U$: `piston`

Source: Taylor, Proc. R. Soc. A 200 (1950) 235; Mader, Numerical Modeling of Detonations (1979); the `Mader` problem of ExactPack.
"""

import numpy as np

from hugoniot.errors import OutOfRange
from hugoniot.theory.exact.solution import Solution


def mader(detonation_velocity: float = 8000.0, density: float = 1875.0, gamma: float = 3.0, piston: float = 0.0) -> Solution:
    """Taylor wave: plane detonation along +x, lit at x = 0 at time 0, with a wall or a piston behind it.

    detonation_velocity   detonation velocity D
    density               initial density of the explosive
    gamma                 ratio of specific heats of the products, above 1
    piston                speed of the piston, from -D/(gamma - 1) to the CJ particle velocity D/(gamma + 1); 0: a wall

    Fields: density, velocity, pressure, energy (without chemical energy), sound_speed, burn_fraction; not a number (NaN) behind the face
    of the piston. Numbers: cj_pressure, cj_velocity (particle velocity), cj_density, tail_speed and tail_pressure (where the uniform
    region begins), heat_of_reaction (J/kg).
    """
    d = detonation_velocity
    if gamma <= 1.0 or min(d, density) <= 0.0 or not -d / (gamma - 1.0) < piston <= d / (gamma + 1.0):
        raise OutOfRange("the Taylor wave needs gamma > 1, positive D and density, and a piston between the escape speed -D/(gamma-1) "
                         f"and the CJ velocity D/(gamma+1) = {d / (gamma + 1):g} m/s, got gamma = {gamma:g}, D = {d:g} m/s, "
                         f"density = {density:g} kg/m3, piston = {piston:g} m/s")
    cj_density, cj_sound, cj_pressure = density * (gamma + 1.0) / gamma, gamma * d / (gamma + 1.0), density * d * d / (gamma + 1.0)
    tail = 0.5 * d + 0.5 * (gamma + 1.0) * piston

    def profile(x, time):
        y = np.clip(x / time, tail, d)
        burnt = x <= d * time
        u = 2.0 / (gamma + 1.0) * (y - 0.5 * d)
        c = 0.5 * d + 0.5 * (gamma - 1.0) * u
        ratio = c / cj_sound
        rho = np.where(burnt, cj_density * ratio ** (2.0 / (gamma - 1.0)), density)
        p = np.where(burnt, cj_pressure * ratio ** (2.0 * gamma / (gamma - 1.0)), 0.0)
        fields = {"density": rho, "velocity": np.where(burnt, u, 0.0), "pressure": p, "energy": p / ((gamma - 1.0) * rho),
                  "sound_speed": np.where(burnt, c, 0.0), "burn_fraction": np.where(burnt, 1.0, 0.0)}
        return {name: np.where(x < piston * time, np.nan, value) for name, value in fields.items()}

    tail_ratio = (0.5 * d + 0.5 * (gamma - 1.0) * piston) / cj_sound
    numbers = {"cj_pressure": cj_pressure, "cj_velocity": d / (gamma + 1.0), "cj_density": cj_density, "tail_speed": tail,
               "tail_pressure": cj_pressure * tail_ratio ** (2.0 * gamma / (gamma - 1.0)),
               "heat_of_reaction": d * d / (2.0 * (gamma**2 - 1.0))}
    return Solution("Taylor wave", "planar", profile, lambda time: (d * time,), numbers, (1e-300, float("inf")))
