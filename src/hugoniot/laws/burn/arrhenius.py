r"""Arrhenius rate with the mixture's temperature.

$$\dot\lambda = Z\,(1-\lambda)^m \exp(-T_a/T)$$

`advance` is exact at constant temperature. The change of the rate by heating within a step must be resolved by the solver, whose time step
is limited by the rate.

Source: Fickett and Davis, Detonation (1979), chapter 2; C. L. Mader, Numerical Modeling of Detonation (1979). Temperature of the mixture:
Starkenberg ARL-TR-2161 section 5.6.
"""

from typing import NamedTuple

from hugoniot.core.ops import vexp
from hugoniot.laws.burn.contract import BURN, no_schedule
from hugoniot.laws.burn.depletion import deplete, power, without_negatives


class Arrhenius(NamedTuple):
    frequency: float
    activation_temperature: float
    depletion_exponent: float = 1.0


def speed(temperature, par):
    return par.frequency * vexp(-par.activation_temperature / temperature) if temperature > 0.0 else 0.0


def rate(burn_fraction, rho, p, temperature, par):
    return speed(temperature, par) * power(1.0 - burn_fraction, par.depletion_exponent) if burn_fraction < 1.0 else 0.0


def advance(burn_fraction, dt, rho, p, temperature, par):
    return deplete(burn_fraction, dt * speed(temperature, par), par.depletion_exponent)


def build(*values, **named) -> Arrhenius:
    """Parameters; OutOfRange for a negative one."""
    return without_negatives("Arrhenius", Arrhenius(*values, **named))


BURN.add(
    "arrhenius", Arrhenius,
    functions={"rate": rate, "advance": advance, "scheduled": no_schedule},
    example=Arrhenius(5.0e12, 2.6e4),
    units={"frequency": "1/s", "activation_temperature": "K", "depletion_exponent": "1"},
    meaning={"frequency": "frequency factor Z", "activation_temperature": "activation energy over the gas constant",
             "depletion_exponent": "power m of the unburned fraction"},
    defaults={"depletion_exponent": 1.0},
    box={"temperature": (300.0, 5000.0)},
    references=("Fickett and Davis, Detonation, 1979, chapter 2", "Mader, Numerical Modeling of Detonation, 1979"),
    flags=("temperature_driven",),
    build=build,
)
