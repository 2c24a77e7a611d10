r"""The Taylor wave: a detonation along +x, lit at a wall or piston, followed by a rarefaction down to the piston's speed.

Ideal-gas products: CJ state $u = D/(\gamma+1)$, $c = \gamma D/(\gamma+1)$, $p = \rho_0D^2/(\gamma+1)$; behind it, with the invariant
$u - 2c/(\gamma-1)$ uniform and $u + c = x/t$,

$$u = \frac{2}{\gamma+1}\left(\frac xt - \frac D2\right), \qquad c = \frac D2 + \frac{\gamma-1}{2}u, \qquad
  \frac{\rho}{\rho_{CJ}} = \left(\frac{c}{c_{CJ}}\right)^{2/(\gamma-1)}$$

until u equals the piston speed U, at $x = (\tfrac D2 + \tfrac{\gamma+1}{2}U)\,t$. At a wall (U = 0) the tail is half-way to the front.

Source: Taylor, Proc. R. Soc. A 200 (1950) 235; Mader, Numerical Modeling of Detonations (1979); the problem of that name in ExactPack.
"""

import numpy as np

from hugoniot.errors import OutOfRange
from hugoniot.theory.exact.solution import Solution


def mader(detonation_velocity: float = 8000.0, density: float = 1875.0, gamma: float = 3.0, piston: float = 0.0) -> Solution:
    """Taylor wave: planar detonation lit at x = 0 at time 0 with a wall or a piston (speed below the CJ particle velocity) behind.

    Fields: density, velocity, pressure, energy (zero chemical energy left), sound_speed, burn_fraction; NaN where the piston is.
    `numbers`: cj_pressure, cj_velocity, cj_density, tail_speed, tail_pressure, heat_of_reaction.
    """
    d = detonation_velocity
    if gamma <= 1.0 or min(d, density) <= 0.0 or not -d / (gamma - 1.0) < piston <= d / (gamma + 1.0):
        raise OutOfRange("the Taylor wave needs gamma > 1, positive D and density, and a piston between the escape speed -D/(gamma-1) "
                         f"and the CJ velocity D/(gamma+1) = {d / (gamma + 1):g}")
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
