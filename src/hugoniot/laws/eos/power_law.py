r"""Pressure as a power of the density alone: the isentrope of an ideal gas.

$$p = p_0\left(\frac{\rho}{\rho_0}\right)^\gamma, \qquad c^2 = \gamma p/\rho$$

Use it for sound waves and rarefactions. The pressure does not depend on the energy, so shock heating has no effect, and material that
expands again returns to its initial density at its initial pressure. For shocks use `ideal_gas`. Density and pressure do not determine
the energy.

Source: KB codes, eq. 2.5 and 2.6.
"""

from typing import NamedTuple

from hugoniot.core.ops import vpow
from hugoniot.errors import OutOfRange
from hugoniot.laws.eos.contract import EOS


class PowerLaw(NamedTuple):
    rho0: float
    p0: float
    gamma: float


def pressure(rho, e, par):
    return par.p0 * vpow(rho / par.rho0, par.gamma) + 0.0 * e


def pressure_derivatives(rho, e, par):
    return par.gamma * pressure(rho, e, par) / rho, 0.0 * e


def reference_state(par):
    return par.rho0, 0.0


def density_limits(par):
    return 0.0, float("inf")


def build(rho0, p0, gamma):
    """Parameters from a deck; OutOfRange unless all are positive."""
    if not (rho0 > 0.0 and p0 > 0.0 and gamma > 0.0):
        raise OutOfRange(f"power_law: needs rho0 > 0, p0 > 0 and gamma > 0, got rho0 = {rho0:g} kg/m3, p0 = {p0:g} Pa, gamma = {gamma:g}")
    return PowerLaw(rho0, p0, gamma)


EOS.add(
    "power_law", PowerLaw,
    functions=[pressure, pressure_derivatives, reference_state, density_limits],
    example=PowerLaw(1.2, 101325.0, 1.4),
    build=build,
    units={"rho0": "kg/m^3", "p0": "Pa", "gamma": "1"},
    meaning={"rho0": "reference density", "p0": "pressure at the reference density", "gamma": "exponent of the density"},
    box={"rho": (0.1, 20.0), "e": (0.0, 1e6)},
    references=("KB codes, equations 2.5 and 2.6",),
    flags=("linear_in_energy", "gas"),
)
