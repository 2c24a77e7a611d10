r"""Kidder's shell: isentropic compression of a shell of ideal gas to any density, without a shock.

It tests a solver for spurious heating in smooth compression: the entropy must stay constant.

For $\gamma = 1 + 2/d$, with $d$ = 1, 2, 3 in planar, cylindrical and spherical geometry, a particle that starts at the radius $r$ is at
$R = r\,h(t)$ with $h = \sqrt{1 - (t/\tau)^2}$, and

$$\rho = \rho_0(R/h)\,h^{-2/(\gamma-1)}, \quad p = s\rho^\gamma, \quad u = -\frac{R\,t}{\tau^2 - t^2}, \qquad
\rho_0(r)^{\gamma-1} = \frac{(r_2^2 - r^2)\rho_1^{\gamma-1} + (r^2 - r_1^2)\rho_2^{\gamma-1}}{r_2^2 - r_1^2}$$

* $r_1$, $\rho_1$, $c_1$ and $r_2$, $\rho_2$, $c_2$: radius, density and sound speed of the inner and the outer surface at $t = 0$
* $\rho_0(r)$: initial density; $s$: uniform entropy constant $p/\rho^\gamma$
* $\tau$: time of collapse, $\tau^2 = \tfrac12(\gamma-1)\,(r_2^2 - r_1^2)/(c_2^2 - c_1^2)$

The pressures of the solution at the two surfaces drive the shell.

Source: Kidder, Nucl. Fusion 16 (1976) 3; Maire, J. Comput. Phys. 228 (2009) 2391, section 6.
"""

import numpy as np

from hugoniot.errors import OutOfRange
from hugoniot.theory.exact.noh import DIMENSION
from hugoniot.theory.exact.solution import Solution


def kidder(geometry: str = "cylindrical", inner: float = 0.9, outer: float = 1.0, inner_pressure: float = 0.1,
           outer_pressure: float = 10.0, outer_density: float = 0.01) -> Solution:
    """Kidder's shell: isentropic compression of an ideal gas, gamma = 1 + 2/d (planar 3, cylindrical 2, spherical 5/3).

    geometry         planar, cylindrical or spherical
    inner            inner radius at time 0
    outer            outer radius at time 0
    inner_pressure   pressure at the inner radius at time 0
    outer_pressure   pressure at the outer radius at time 0, above inner_pressure
    outer_density    density at the outer radius at time 0

    Fields: density, velocity, pressure, energy, sound_speed; not a number (NaN) outside the shell.
    Numbers: gamma, tau (time of collapse, s), inner_density, entropy_constant (p/rho^gamma). Valid for times below tau.
    """
    if not (0.0 <= inner < outer and 0.0 < inner_pressure < outer_pressure and outer_density > 0.0):
        raise OutOfRange("Kidder's shell needs 0 <= inner < outer radius, 0 < inner < outer pressure and a positive density")
    gamma = 1.0 + 2.0 / DIMENSION[geometry]
    constant = outer_pressure / outer_density**gamma
    inner_density = (inner_pressure / constant) ** (1.0 / gamma)
    sound = [gamma * constant * rho ** (gamma - 1.0) for rho in (inner_density, outer_density)]
    tau = np.sqrt(0.5 * (gamma - 1.0) * (outer**2 - inner**2) / (sound[1] - sound[0]))

    def profile(radius, time):
        h = np.sqrt(1.0 - (time / tau) ** 2)
        r = radius / h
        weight = (r**2 - inner**2) / (outer**2 - inner**2)
        power = (1.0 - weight) * inner_density ** (gamma - 1.0) + weight * outer_density ** (gamma - 1.0)
        inside = (r >= inner * (1.0 - 1e-12)) & (r <= outer * (1.0 + 1e-12))
        rho = np.where(inside, np.where(inside, power, 1.0) ** (1.0 / (gamma - 1.0)), np.nan) * h ** (-2.0 / (gamma - 1.0))
        p = constant * rho**gamma
        velocity = np.where(inside, -radius * time / (tau**2 - time**2), np.nan)
        return {"density": rho, "velocity": velocity, "pressure": p, "energy": p / ((gamma - 1.0) * rho),
                "sound_speed": np.sqrt(gamma * p / rho)}

    numbers = {"gamma": gamma, "tau": float(tau), "inner_density": inner_density, "entropy_constant": constant}
    return Solution(f"Kidder shell, {geometry}", geometry, profile, numbers=numbers, times=(0.0, float(tau) * (1.0 - 1e-9)))
