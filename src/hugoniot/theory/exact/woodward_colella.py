"""Two interacting blast waves (Woodward & Colella): reference values for a problem without a closed-form solution.

They test a solver in the collision of strong shocks, with narrow peaks of the density.

The problem: ideal gas with gamma = 1.4 and unit density, at rest between walls at x = 0 and 1. The pressure is 1000 for x < 0.1, 0.01 up
to x = 0.9 and 100 beyond. The numbers are for the time 0.038, computed with a second-order Lagrangian Godunov scheme on 3200 zones. The
position of the right shock still changed from 0.8647 to 0.8653 between 1600 and 3200 zones, and the peak density depends on the method
(6.4 to 7.2).

Source: the problem of Woodward & Colella, J. Comput. Phys. 54 (1984) 115; values from the project's own reference run.
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
    """Interacting blast waves: reference values at time 0.038.

    Numbers: time, contacts (positions of two contacts), spike (position of the density peak), right_shock and its uncertainty, and the
    density at some positions. No profiles are given. In Python `SOLUTIONS["woodward_colella"]()` of `hugoniot.theory.exact` returns the
    numbers as a named tuple.
    """
    return REFERENCE
