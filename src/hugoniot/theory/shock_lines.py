r"""Rayleigh and Fanno lines of a shock, for any law: the states that satisfy two of the three conservation laws.

In the frame of the shock, with the mass flux $m = \rho_0U_s$, the specific volume $v = 1/\rho$ and the index 0 for the state ahead,

$$\text{Rayleigh (mass, momentum):}\quad p = p_0 + m^2(v_0 - v), \qquad
  \text{Fanno (mass, energy):}\quad e + p(\rho, e)\,v + \tfrac12m^2v^2 = e_0 + p_0v_0 + \tfrac12m^2v_0^2$$

The two lines cross at the states ahead of and behind the shock, where all three conservation laws hold. Inside a shock with heat conduction
but no viscosity the pressure lies on the Rayleigh line; with viscosity but no conduction the total stress (pressure and viscous stress)
does. Along the Fanno line the entropy has its maximum where the flow is sonic.

Source: Jordan (2011), figures 7.1.1 and following.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.optimize import brentq

from hugoniot.errors import NoSolution
from hugoniot.laws.eos import contract
from hugoniot.theory.hugoniot import Initial, shock
from hugoniot.theory.states import States, law_of

WIDEST = 1e12     # J/kg: how far the energy of a Fanno state is searched


@dataclass(frozen=True)
class ShockLines:
    """Both lines and the Hugoniot at the same densities.

    initial, behind                      states ahead of the shock and behind it
    density                              kg/m3; the specific volume falls from the one ahead by 1.1 times its change across the shock
    rayleigh_pressure, fanno_pressure    Pa
    hugoniot_pressure                    Pa
    rayleigh_energy, fanno_energy        J/kg
    """

    initial: Initial
    behind: States
    density: np.ndarray
    rayleigh_pressure: np.ndarray
    fanno_pressure: np.ndarray
    hugoniot_pressure: np.ndarray
    rayleigh_energy: np.ndarray
    fanno_energy: np.ndarray

    def table(self) -> dict[str, Any]:
        """Columns by name, SI."""
        return {"density": self.density, "rayleigh_pressure": self.rayleigh_pressure, "fanno_pressure": self.fanno_pressure,
                "hugoniot_pressure": self.hugoniot_pressure}


def shock_lines(material, initial: Initial | None = None, points: int = 101, **strength) -> ShockLines:
    """The Rayleigh line, the Fanno line and the Hugoniot of a shock, as `ShockLines`.

    initial    state ahead, an `Initial`; default: the reference state
    points     number of points of each line
    strength   exactly one of shock_velocity and, behind the shock, pressure, particle_velocity and density, as in `pressure=20e9` (SI)

    Raises NoSolution if the equation of state has no state on a line at one of the densities.
    """
    par = law_of(material)
    ahead = initial or Initial.at_rest(par)
    behind = shock(par, ahead, **strength)
    v0, v1 = 1.0 / ahead.density, 1.0 / float(behind.density)
    flux = ahead.density * (float(behind.shock_velocity) - ahead.velocity)
    v = np.linspace(v0, max(v1 - 0.1 * (v0 - v1), 1.02 / float(contract.density_limits(par)[1])), points)
    v[np.argmin(np.abs(v - v1))] = v1
    total = ahead.energy + ahead.pressure * v0 + 0.5 * (flux * v0) ** 2
    energies = np.array([_fanno_energy(x, total - 0.5 * (flux * x) ** 2, par) for x in v])
    line = ahead.pressure + flux**2 * (v0 - v)
    on_line = np.array([_energy(x, p, par) for x, p in zip(v, line)])
    hugoniot = np.array([ahead.pressure if x == v0 else _hugoniot_pressure(x, ahead, par) for x in v])
    fanno = np.array([float(contract.pressure(1.0 / x, e, par)) for x, e in zip(v, energies)])
    return ShockLines(ahead, behind, 1.0 / v, line, fanno, hugoniot, on_line, energies)


def _fanno_energy(v: float, enthalpy: float, par) -> float:
    """e with e + p(1/v, e) v = enthalpy, J/kg."""
    return _root(lambda e: e + float(contract.pressure(1.0 / v, e, par)) * v - enthalpy, enthalpy, v)


def _energy(v: float, p: float, par) -> float:
    return _root(lambda e: float(contract.pressure(1.0 / v, e, par)) - p, p * v, v)


def _hugoniot_pressure(v: float, ahead: Initial, par) -> float:
    try:
        return float(shock(par, ahead, density=1.0 / v).pressure)
    except (NoSolution, ValueError):
        return float("nan")


def _root(function, near: float, v: float) -> float:
    width = max(abs(near), 1e3)
    while width < WIDEST:
        if function(near - width) < 0.0 < function(near + width):
            return float(brentq(function, near - width, near + width, xtol=1e-12 * width, rtol=8.9e-16))
        width *= 2.0
    raise NoSolution(f"no energy satisfies the equation at a density of {1.0 / v:.6g} kg/m3")
