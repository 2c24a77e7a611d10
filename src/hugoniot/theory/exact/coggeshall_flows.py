r"""Coggeshall's flows in one dimension without radiation: velocities proportional to the radius, powers of r and t.

With d = 1, 2, 3 for planar, cylindrical, spherical and any b (the slope of the density):

1. coasting: $u = r/t$, $\rho = \rho_0 r^bt^{-b-d}$, $e = e_0r^{-b}t^{b-(\gamma-1)d}$. The pressure is uniform and nothing accelerates.
2. driven: $u = ar/t$, $\rho = \rho_0r^bt^{-a(b+d)}$, $e = \frac{a(1-a)}{(\gamma-1)(b+2)}\frac{r^2}{t^2}$,
   $a = \frac{2}{2 + (\gamma-1)d}$. The energy equation fixes a, the momentum equation the factor of e; b > -2.

Continuity, momentum and energy are satisfied identically (the tests differentiate them). Of Coggeshall's list these are the adiabatic
flows of an ideal gas with positive temperature in one dimension; `coggeshall` is the one in two, the others need heat conduction or
radiation, or have a negative temperature for gamma > 1.

Source: Coggeshall, Phys. Fluids A 3 (1991) 757, problems 1 and 2; derived here for any density slope.
"""

import numpy as np

from hugoniot.errors import OutOfRange
from hugoniot.theory.exact.noh import DIMENSION
from hugoniot.theory.exact.solution import Solution


def coggeshall_coasting(geometry: str = "spherical", gamma: float = 5.0 / 3.0, slope: float = 1.0, density: float = 1.0,
                        energy_per_mass: float = 1.0) -> Solution:
    """Coggeshall's coasting flow: u = r/t, density a power of the radius, pressure uniform.

    density and energy_per_mass: at r = 1, t = 1; slope: b of rho ~ r^b. Fields: density, velocity, pressure, energy. Holds for time > 0.
    """
    if gamma <= 1.0 or density <= 0.0 or energy_per_mass <= 0.0:
        raise OutOfRange("Coggeshall's flows need gamma > 1 and a positive density and energy")
    return _flow("Coggeshall, coasting", geometry, gamma, (1.0, slope, density),
                 lambda r, t: energy_per_mass * r**-slope * t ** (slope - (gamma - 1.0) * DIMENSION[geometry]))


def coggeshall_driven(geometry: str = "spherical", gamma: float = 5.0 / 3.0, slope: float = 0.0, density: float = 1.0) -> Solution:
    """Coggeshall's driven flow: u = a r/t with a temperature quadratic in the radius, density a power of it.

    density: at r = 1, t = 1; slope: b of rho ~ r^b, above -2. Fields: density, velocity, pressure, energy. Holds for time > 0.
    """
    if gamma <= 1.0 or density <= 0.0 or slope <= -2.0:
        raise OutOfRange("Coggeshall's driven flow needs gamma > 1, a positive density and slope > -2")
    a = 2.0 / (2.0 + (gamma - 1.0) * DIMENSION[geometry])
    factor = a * (1.0 - a) / ((gamma - 1.0) * (slope + 2.0))
    return _flow("Coggeshall, driven", geometry, gamma, (a, slope, density), lambda r, t: factor * (r / t) ** 2)


def _flow(title: str, geometry: str, gamma: float, shape: tuple[float, float, float], energy) -> Solution:
    a, slope, density = shape

    def profile(r, time):
        rho = density * r**slope * time ** (-a * (slope + DIMENSION[geometry]))
        e = energy(r, time)
        return {"density": rho, "velocity": a * r / time, "pressure": (gamma - 1.0) * rho * e, "energy": e}

    return Solution(f"{title}, {geometry}", geometry, profile, numbers={"velocity_factor": a}, times=(1e-300, np.inf),
                    domain=lambda time: (0.01, 1.0))
