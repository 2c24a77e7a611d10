r"""Arrhenius rate: burning at a rate that depends on the temperature of the mixture.

$$\dot\lambda = Z\,(1-\lambda)^m \exp(-T_a/T)$$

* $\lambda$: burned mass fraction, 0 to 1; $\dot\lambda$: its rate of change
* $T$: temperature of the mixture of unburned and burned material; with the mixture law `thermal_isolation` that of the products, once
  anything has burned
* $Z$: `frequency`; $T_a$: `activation_temperature`; $m$: `depletion_exponent`

The equations of state of the unreacted explosive and of the products must both give a temperature. Within a time step the temperature is
held constant and the rate equation is solved exactly. The step is a small part of the burning time $1/\dot\lambda$, so that the temperature
changes little within it.
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
    return without_negatives(Arrhenius(*values, **named))


BURN.add(
    "arrhenius", Arrhenius,
    functions={"rate": rate, "advance": advance, "scheduled": no_schedule},
    example=Arrhenius(5.0e12, 2.6e4),
    units={"frequency": "1/s", "activation_temperature": "K", "depletion_exponent": "1"},
    meaning={"frequency": "Z, frequency factor", "activation_temperature": "activation energy divided by the gas constant",
             "depletion_exponent": "m, power of the unburned fraction"},
    defaults={"depletion_exponent": 1.0},
    box={"temperature": (300.0, 5000.0)},
    references=("Fickett and Davis, Detonation, 1979, chapter 2", "Mader, Numerical Modeling of Detonations, 1979",
                "Starkenberg, ARL-TR-2161, section 5.6, for the temperature of the mixture"),
    flags=("temperature_driven",),
    build=build,
)
