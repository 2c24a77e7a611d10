r"""Steady detonation with a resolved reaction zone: an ideal-gas explosive that burns at the rate $k\sqrt{1-\lambda}$.

It tests a reactive solver: the pressure spike at the shock, the profile of the reaction zone and its end at a finite distance.

The explosive obeys $e = pv/(\gamma-1) - \lambda Q$ with the burn fraction $\lambda$, the specific volume $v$ and the chemical energy $Q =
D^2/[2(\gamma^2-1)]$, with which $D$ is the CJ velocity. Ahead of the shock the explosive is at rest at zero pressure. Between the shock and
the CJ point the state depends on $q = \sqrt{1-\lambda}$ alone:

$$p = \frac{\rho_0 D^2}{\gamma+1}(1+q), \qquad u = \frac{D}{\gamma+1}(1+q), \qquad \rho = \rho_0\frac{D}{D-u}$$

A particle that was shocked a time $\tau$ ago has $q = 1 - k\tau/2$, and its distance behind the shock is

$$\xi(\tau) = D\left[\frac{\gamma-1}{\gamma+1}\,\tau + \frac{k\tau^2}{4(\gamma+1)}\right]$$

The reaction ends at $\tau = 2/k$. From there the CJ state extends unchanged to the piston, which moves at the CJ particle velocity.

* $D$: `detonation_velocity`; $\rho_0$: initial density, `density`; $\gamma$: `gamma`; $k$: `rate`

Source: Fickett & Davis, Detonation (1979), chapter 5, after Fickett & Rivard; the problem SDRZ of ExactPack (gamma = 3, k = 2 per
microsecond).
"""

import numpy as np

from hugoniot.errors import OutOfRange
from hugoniot.theory.exact.solution import Solution


def fickett_rivard(detonation_velocity: float = 8500.0, density: float = 1600.0, gamma: float = 3.0, rate: float = 2e6) -> Solution:
    """CJ detonation along +x with a resolved reaction zone, supported by a piston; the shock is at x = D t.

    detonation_velocity   detonation velocity D
    density               initial density of the explosive
    gamma                 ratio of specific heats, above 1
    rate                  constant k of the rate k sqrt(1 - burn fraction)

    Fields: density, velocity, pressure, energy (p v/(gamma - 1) less the chemical energy released so far), burn_fraction.
    Numbers: cj_pressure, vn_pressure (just behind the shock), zone_length (m), reaction_time (s), heat_of_reaction (J/kg).
    """
    if gamma <= 1.0 or min(detonation_velocity, density, rate) <= 0.0:
        raise OutOfRange("the reaction zone needs gamma > 1 and positive detonation velocity, density and rate")
    d = detonation_velocity
    heat = d * d / (2.0 * (gamma**2 - 1.0))
    done = 2.0 / rate
    slope, bend = d * (gamma - 1.0) / (gamma + 1.0), d * rate / (4.0 * (gamma + 1.0))

    def profile(x, time):
        behind = np.maximum(d * time - x, 0.0)
        tau = 2.0 * behind / (slope + np.sqrt(slope**2 + 4.0 * bend * behind))
        q = np.maximum(1.0 - 0.5 * rate * tau, 0.0)
        shocked = x <= d * time
        u = np.where(shocked, d / (gamma + 1.0) * (1.0 + q), 0.0)
        rho = density * d / (d - u)
        p = density * d * u
        burn = np.where(shocked, 1.0 - q * q, 0.0)
        return {"density": rho, "velocity": u, "pressure": p, "energy": p / ((gamma - 1.0) * rho) - burn * heat, "burn_fraction": burn}

    cj = density * d * d / (gamma + 1.0)
    numbers = {"cj_pressure": cj, "vn_pressure": 2.0 * cj, "zone_length": slope * done + bend * done**2, "reaction_time": done,
               "heat_of_reaction": heat}
    return Solution("steady detonation with reaction zone", "planar", profile, lambda time: (d * time,), numbers)
