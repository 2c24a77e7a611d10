r"""Coggeshall's adiabatic compression in two dimensions: density uniform, temperature quadratic in z.

$$u_r = -\frac{r}{1-t},\quad u_z = -\frac{b\,z}{1-t},\quad \rho = \rho_0(1-t)^{-(n+b)},\quad
e = \frac{b(1-b)}{2(\gamma-1)}\frac{z^2}{(1-t)^2}, \qquad b = \frac{2 - n(\gamma-1)}{\gamma+1}$$

with n = 2 if r is an axisymmetric radius and n = 1 if it is a Cartesian coordinate. The momentum equation along z gives the factor of e,
that along r contains no pressure, and $\dot e = -(p/\rho)\nabla\cdot u$ gives b. For n = 2, gamma = 5/3: b = 1/4, e = (3z/8)^2 at t = 0.

Source: Coggeshall, Phys. Fluids A 3 (1991) 757; general gamma re-derived here.
"""

import numpy as np

from hugoniot.errors import OutOfRange
from hugoniot.theory.exact.solution import Solution


def coggeshall(gamma: float = 5.0 / 3.0, axisymmetric: bool = True, density: float = 1.0) -> Solution:
    """Coggeshall's adiabatic compression in two dimensions.

    Positions are an array of (r, z) pairs in its last axis.

    Fields: density, velocity (last axis r, z), energy, pressure, sound_speed. Holds for time < 1; 1 < gamma < 1 + 2/n.
    """
    n = 2 if axisymmetric else 1
    b = (2.0 - n * (gamma - 1.0)) / (gamma + 1.0)
    if gamma <= 1.0 or not 0.0 < b < 1.0:
        raise OutOfRange(f"Coggeshall's compression needs 1 < gamma < {1 + 2 / n:g}, got {gamma:g}")
    factor = b * (1.0 - b) / (2.0 * (gamma - 1.0))

    def profile(points, time):
        left = 1.0 - time
        rho = np.full(points.shape[:-1], density * left ** -(n + b))
        e = factor * (points[..., 1] / left) ** 2
        return {"density": rho, "velocity": -points * np.array([1.0, b]) / left, "energy": e, "pressure": (gamma - 1.0) * rho * e,
                "sound_speed": np.sqrt(gamma * (gamma - 1.0) * e)}

    return Solution("Coggeshall compression", "axisymmetric" if axisymmetric else "planar", profile,
                    numbers={"axial_rate": b, "energy_factor": factor}, times=(0.0, 1.0 - 1e-12))
