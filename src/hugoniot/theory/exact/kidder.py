r"""Kidder's isentropic compression of a shell: self-similar and without shocks, to any density.

For $\gamma = 1 + 2/d$ every radius moves as $R(r,t) = r\,h(t)$, $h = \sqrt{1 - (t/\tau)^2}$, and

$$\rho(R,t) = \rho_0(R/h)\,h^{-2/(\gamma-1)}, \quad p = s\rho^\gamma, \quad u = -\frac{R\,t}{\tau^2 - t^2}, \qquad
\rho_0(r)^{\gamma-1} = \frac{(r_2^2 - r^2)\rho_1^{\gamma-1} + (r^2 - r_1^2)\rho_2^{\gamma-1}}{r_2^2 - r_1^2}$$

with the focussing time $\tau^2 = \tfrac12(\gamma-1)\,(r_2^2 - r_1^2)/(c_2^2 - c_1^2)$. The shell is driven by p(r1 h, t) and p(r2 h, t).

Source: Kidder, Nucl. Fusion 16 (1976) 3; Maire, J. Comput. Phys. 228 (2009) 2391, section 6.
"""

import numpy as np

from hugoniot.errors import OutOfRange
from hugoniot.theory.exact.noh import DIMENSION
from hugoniot.theory.exact.solution import Solution


def kidder(geometry: str = "cylindrical", inner: float = 0.9, outer: float = 1.0, inner_pressure: float = 0.1,
           outer_pressure: float = 10.0, outer_density: float = 0.01) -> Solution:
    """Kidder's isentropic shell.

    gamma = 1 + 2/d follows from the geometry (planar 3, cylindrical 2, spherical 5/3).

    Fields: density, velocity, pressure, energy, sound_speed; NaN outside the shell. `numbers`: gamma, tau, inner_density,
    entropy_constant. Radii at time t are those at time 0 times h = sqrt(1 - (t/tau)^2); the solution holds for t < tau.
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
