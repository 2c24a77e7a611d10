r"""Reference numbers of the two interacting blast waves, for which no closed solution exists.

Ideal gas, gamma = 1.4, rho = 1, u = 0 on [0, 1] between walls; p = 1000 for x < 0.1, 0.01 up to 0.9, 100 beyond; t = 0.038.
The values were computed with a second-order Lagrangian Godunov scheme on 3 200 zones; the right shock
still drifts from 0.8647 to 0.8653 between 1 600 and 3 200 zones, and the peak density depends on the method (6.4 to 7.2).

Source: problem of Woodward & Colella, J. Comput. Phys. 54 (1984) 115; numbers of the project's own reference run.
"""

from typing import NamedTuple

import numpy as np


class Reference(NamedTuple):
    """Feature positions with their uncertainty, and the density at chosen positions."""

    time: float
    contacts: tuple[float, float]
    spike: float
    right_shock: float
    right_shock_uncertainty: float
    positions: tuple[float, ...]
    density: tuple[float, ...]


REFERENCE = Reference(0.038, (0.59389, 0.79811), 0.7647, 0.865, 1e-3, (0.60, 0.65, 0.70, 0.75), (1.9856, 5.2739, 4.1828, 3.2539))


def initial(positions) -> dict[str, np.ndarray]:
    """Density, velocity and pressure of the problem at time 0 at positions in [0, 1]."""
    x = np.asarray(positions, float)
    pressure = np.where(x < 0.1, 1000.0, np.where(x < 0.9, 0.01, 100.0))
    return {"density": np.ones_like(x), "velocity": np.zeros_like(x), "pressure": pressure, "energy": pressure / 0.4}


def woodward_colella() -> Reference:
    """Reference numbers of the interacting blast waves; data, not a callable solution."""
    return REFERENCE
