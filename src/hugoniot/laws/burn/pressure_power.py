r"""Burning at a rate proportional to a power of the pressure and a power of the unburned fraction.

$$\dot\lambda = k\left(\frac{p}{p_0}\right)^n (1-\lambda)^m \text{ for } p > p_t, \text{ else } 0$$

* $\lambda$: burned mass fraction, 0 to 1; $\dot\lambda$: its rate of change
* $p$: pressure of the mixture; $p_t$: `pressure_threshold`
* $k$: `rate_constant`, the rate at $p_0$ = `reference_pressure` before depletion
* $n$, $m$: `pressure_exponent`, `depletion_exponent`; burning ends in finite time for $m < 1$

With $n = 0$ and $m = 1/2$ it is the simple rate of Fickett and Rivard, whose reaction zone is known exactly (`hugoniot exact
fickett_rivard`). Within a time step the pressure is held constant and the rate equation is solved exactly.
"""

from typing import NamedTuple

from hugoniot.errors import OutOfRange
from hugoniot.laws.burn.contract import BURN, no_schedule
from hugoniot.laws.burn.depletion import deplete, power, without_negatives


class PressurePower(NamedTuple):
    rate_constant: float
    pressure_exponent: float
    depletion_exponent: float
    reference_pressure: float = 1.0e9
    pressure_threshold: float = 0.0


def speed(p, par):
    """k (p/p0)^n above the threshold, 1/s."""
    return par.rate_constant * power(p / par.reference_pressure, par.pressure_exponent) if p > par.pressure_threshold else 0.0


def rate(burn_fraction, rho, p, temperature, par):
    return speed(p, par) * power(1.0 - burn_fraction, par.depletion_exponent) if burn_fraction < 1.0 else 0.0


def advance(burn_fraction, dt, rho, p, temperature, par):
    return deplete(burn_fraction, dt * speed(p, par), par.depletion_exponent)


def build(*values, **named) -> PressurePower:
    """Parameters; OutOfRange for a negative one, or a reference pressure of 0."""
    par = without_negatives(PressurePower(*values, **named))
    if not par.reference_pressure > 0.0:
        raise OutOfRange("pressure_power: reference_pressure must be positive, because rate_constant is the rate at that pressure, "
                         "got 0 Pa")
    return par


BURN.add(
    "pressure_power", PressurePower,
    functions={"rate": rate, "advance": advance, "scheduled": no_schedule},
    example=PressurePower(2.0e5, 1.5, 0.5),
    units={"rate_constant": "1/s", "pressure_exponent": "1", "depletion_exponent": "1", "reference_pressure": "Pa",
           "pressure_threshold": "Pa"},
    meaning={"rate_constant": "k, rate at the reference pressure before depletion", "pressure_exponent": "n, power of the pressure",
             "depletion_exponent": "m, power of the unburned fraction (below 1 burning ends in finite time)",
             "reference_pressure": "pressure at which the rate constant is given",
             "pressure_threshold": "pressure below which nothing burns"},
    defaults={"reference_pressure": 1.0e9, "pressure_threshold": 0.0},
    box={"p": (0.0, 60.0e9)},
    references=("Fickett and Davis, Detonation, 1979, chapter 2", "Starkenberg, ARL-TR-2161, section 3"),
    flags=("pressure_driven",),
    build=build,
)
