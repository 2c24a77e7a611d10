r"""Ideal gas with constant specific heats.

$$p = (\gamma - 1)\,\rho e, \qquad T = e / c_v, \qquad s = c_v \ln\left(p\,\rho^{-\gamma}\right) + \text{const}$$

The reference state is the density $\rho_0$ at 298.15 K, or at one atmosphere if the specific heat $c_v$ is not given; a region of a deck
may start from another state. The law is valid while intermolecular forces, dissociation and ionisation are negligible.

Source: Starkenberg, ARL-TR-2161, appendix A-7 (polytropic gas); KB codes, eq. 4.4, which prints $\rho_0$ for $\rho$ (K-E4).
"""

import math
from typing import NamedTuple

from hugoniot.core.ops import vlog
from hugoniot.laws.eos.contract import EOS

ATMOSPHERE = 101325.0      # Pa
ROOM = 298.15              # K


class IdealGas(NamedTuple):
    gamma: float
    specific_heat: float = math.nan
    rho0: float = 1.2


def pressure(rho, e, par):
    return (par.gamma - 1.0) * rho * e


def pressure_derivatives(rho, e, par):
    return (par.gamma - 1.0) * e, (par.gamma - 1.0) * rho


def energy(rho, p, par):
    return p / ((par.gamma - 1.0) * rho)


def temperature(rho, e, par):
    return e / par.specific_heat


def specific_heat(rho, e, par):
    return par.specific_heat


def entropy(rho, e, par):
    return par.specific_heat * (vlog(e) - (par.gamma - 1.0) * vlog(rho))


def reference_isentrope(rho, par):
    """The state without energy; energies grow as rho^(gamma - 1)."""
    return 0.0, (par.gamma - 1.0) * vlog(rho)


def reference_state(par):
    """A gas has no reference state of its own: room temperature at its nominal density, or one atmosphere where the former is unknown."""
    heat = par.specific_heat * ROOM
    return par.rho0, heat if heat > 0.0 else ATMOSPHERE / ((par.gamma - 1.0) * par.rho0)


def density_limits(par):
    return 0.0, float("inf")


EOS.add(
    "ideal_gas", IdealGas,
    functions=[pressure, pressure_derivatives, energy, temperature, specific_heat, entropy, reference_state, density_limits,
               reference_isentrope],
    example=IdealGas(1.4, 717.5),
    units={"gamma": "1", "specific_heat": "J/kg/K", "rho0": "kg/m^3"},
    meaning={"gamma": "ratio of specific heats", "specific_heat": "specific heat at constant volume, needed for temperatures",
             "rho0": "reference density, used where a region gives none"},
    defaults={"specific_heat": math.nan, "rho0": 1.2},
    box={"rho": (1e-3, 100.0), "e": (1e3, 1e8)},
    above={"gamma": 1.0},
    references=("Starkenberg, ARL-TR-2161, appendix A-7",),
    flags=("linear_in_energy", "gas"),
)
