r"""Coggeshall's adiabatic compression in two dimensions: a gas of uniform density, with a temperature quadratic in z.

It tests a two-dimensional solver in smooth, anisotropic compression of an ideal gas.

$$u_r = -\frac{r}{1-t},\quad u_z = -\frac{b\,z}{1-t},\quad \rho = \rho_0(1-t)^{-(n+b)},\quad
e = \frac{b(1-b)}{2(\gamma-1)}\frac{z^2}{(1-t)^2}, \qquad b = \frac{2 - n(\gamma-1)}{\gamma+1}$$

* $r$, $z$: coordinates; $n = 2$ if $r$ is an axisymmetric radius, $n = 1$ if it is a Cartesian coordinate
* $u_r$, $u_z$: velocities; $\rho_0$: density at $t = 0$; $\gamma$: ratio of specific heats

The equations are in units in which the collapse takes the time 1. The pressure does not depend on $r$. For $n = 2$ and $\gamma = 5/3$ the
constants are $b = 1/4$ and $e = (3z/8)^2$ at $t = 0$.

Source: Coggeshall, Phys. Fluids A 3 (1991) 757; derived for this project for any gamma.
"""

import numpy as np

from hugoniot.errors import OutOfRange
from hugoniot.theory.exact.solution import Solution


def coggeshall(gamma: float = 5.0 / 3.0, axisymmetric: bool = True, density: float = 1.0) -> Solution:
    """Coggeshall's adiabatic compression of an ideal gas in two dimensions.

    gamma          ratio of specific heats, between 1 and 1 + 2/n (2 if axisymmetric, 3 if not)
    axisymmetric   true: r is a radius (n = 2); false: r is a Cartesian coordinate (n = 1)
    density        density at time 0

    Positions are pairs (r, z), in Python in the last axis of an array. Valid for times below 1.

    Fields: density, velocity (two components, r and z), energy, pressure, sound_speed.
    Numbers: axial_rate (b), energy_factor (e/z^2 at time 0).
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
