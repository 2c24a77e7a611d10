r"""Rate as a power of the pressure, depletion as a power of the unburned fraction.

$$\dot\lambda = k\left(\frac{p}{p_0}\right)^n (1-\lambda)^m$$

above the pressure `pressure_threshold`, 0 below. The law includes the simple-depletion
model of Fickett and Rivard (n = 0, m = 1/2: $\lambda = \tau(2-\tau)$). The step is exact at constant pressure.

Source: Starkenberg ARL-TR-2161 section 3 allows any rate that depends on the state; Fickett and Davis, Detonation (1979), chapter 2.
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
    par = without_negatives("pressure power", PressurePower(*values, **named))
    if not par.reference_pressure > 0.0:
        raise OutOfRange("pressure power: reference_pressure must be positive, because the rate constant is the rate at that pressure; "
                         "got 0 Pa")
    return par


BURN.add(
    "pressure_power", PressurePower,
    functions={"rate": rate, "advance": advance, "scheduled": no_schedule},
    example=PressurePower(2.0e5, 1.5, 0.5),
    units={"rate_constant": "1/s", "pressure_exponent": "1", "depletion_exponent": "1", "reference_pressure": "Pa",
           "pressure_threshold": "Pa"},
    meaning={"rate_constant": "rate at the reference pressure before depletion", "pressure_exponent": "power n of the pressure",
             "depletion_exponent": "power m of the unburned fraction (below 1 burning ends in finite time)",
             "reference_pressure": "pressure at which the rate constant is given",
             "pressure_threshold": "pressure below which nothing burns"},
    defaults={"reference_pressure": 1.0e9, "pressure_threshold": 0.0},
    box={"p": (0.0, 60.0e9)},
    references=("Fickett and Davis, Detonation, 1979, chapter 2", "Starkenberg, ARL-TR-2161, section 3"),
    flags=("pressure_driven",),
    build=build,
)
