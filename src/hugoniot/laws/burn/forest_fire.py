r"""Burning at a rate that depends on the pressure: by a polynomial (`forest_fire`) or a table (`rate_table`), with first-order depletion.

$$\dot\lambda = (1-\lambda)\,\frac{1}{t_0}\exp\left(\sum_{i=0}^{14} a_i\,(p/p_0)^i\right) \;(\text{forest fire}), \qquad
\dot\lambda = (1-\lambda)\,r(p) \;(\text{rate table})$$

* $\lambda$: burned mass fraction, 0 to 1; $\dot\lambda$: its rate of change
* $p$: pressure
* $a_0$ to $a_{14}$: `coefficients`, lowest power first; those not given are 0
* $p_0$, $t_0$: `pressure_scale`, `time_scale`; the defaults are the units of Mader's coefficients, 1 Mbar and 1 µs
* $r$: rate in the table of `pressures` and `rates`; $\ln r$ is interpolated linearly in $\ln p$

The fit or table covers pressures from `p_min` to `p_max`, or from the first to the last pressure of the table. Below this range nothing
burns. Above it the factor that depends on the pressure keeps the value it has at the upper limit. Within a time step the pressure is held
constant and the rate equation is solved exactly.
"""

from typing import NamedTuple

import numpy as np

from hugoniot.core.ops import fmin, vexp, vlog
from hugoniot.errors import OutOfRange
from hugoniot.laws.burn.contract import BURN, no_schedule
from hugoniot.laws.burn.depletion import deplete

TERMS = 15


class ForestFire(NamedTuple):
    coefficients: tuple[float, ...]
    p_min: float
    p_max: float
    pressure_scale: float = 1.0e11
    time_scale: float = 1.0e-6


class RateTable(NamedTuple):
    log_pressure: tuple[float, ...]
    log_rate: tuple[float, ...]


def polynomial_speed(p, par):
    if p <= par.p_min:
        return 0.0
    x = fmin(p, par.p_max) / par.pressure_scale
    exponent = 0.0
    for i in range(TERMS):
        exponent = exponent * x + par.coefficients[TERMS - 1 - i]
    return vexp(exponent) / par.time_scale


def polynomial_rate(burn_fraction, rho, p, temperature, par):
    return polynomial_speed(p, par) * (1.0 - burn_fraction)


def polynomial_advance(burn_fraction, dt, rho, p, temperature, par):
    return deplete(burn_fraction, dt * polynomial_speed(p, par), 1.0)


def table_speed(p, par):
    if p <= 0.0:
        return 0.0
    x = vlog(p)
    last = len(par.log_pressure) - 1
    if x < par.log_pressure[0]:
        return 0.0
    if x >= par.log_pressure[last]:
        return vexp(par.log_rate[last])
    low, high = 0, last
    while high - low > 1:
        middle = (low + high) // 2
        if x >= par.log_pressure[middle]:
            low = middle
        else:
            high = middle
    share = (x - par.log_pressure[low]) / (par.log_pressure[high] - par.log_pressure[low])
    return vexp(par.log_rate[low] + share * (par.log_rate[high] - par.log_rate[low]))


def table_rate(burn_fraction, rho, p, temperature, par):
    return table_speed(p, par) * (1.0 - burn_fraction)


def table_advance(burn_fraction, dt, rho, p, temperature, par):
    return deplete(burn_fraction, dt * table_speed(p, par), 1.0)


def forest_fire(coefficients, p_min, p_max, pressure_scale=1.0e11, time_scale=1.0e-6) -> ForestFire:
    """Parameters from up to 15 coefficients, lowest power first; OutOfRange for more of them, an empty
    pressure range or a unit that is not positive."""
    values = tuple(float(a) for a in coefficients)
    if not 0 < len(values) <= TERMS:
        raise OutOfRange(f"forest_fire: coefficients must have 1 to {TERMS} values, got {len(values)}")
    if not 0.0 <= p_min < p_max:
        raise OutOfRange(f"forest_fire: needs 0 <= p_min < p_max, got {p_min:.6g} and {p_max:.6g} Pa")
    if not (pressure_scale > 0.0 and time_scale > 0.0):
        raise OutOfRange(f"forest_fire: pressure_scale and time_scale must be positive, got {pressure_scale:.6g} Pa and "
                         f"{time_scale:.6g} s")
    return ForestFire(values + (0.0,) * (TERMS - len(values)), float(p_min), float(p_max), float(pressure_scale), float(time_scale))


def rate_table(pressures, rates) -> RateTable:
    """Parameters from pressures (Pa, rising, positive) and rates (1/s, positive); OutOfRange with the first entry that is not so."""
    p, r = np.asarray(pressures, float), np.asarray(rates, float)
    if p.ndim != 1 or p.shape != r.shape or p.size < 2:
        raise OutOfRange(f"rate_table: pressures and rates must have the same number of values, at least 2, got {p.size} and {r.size}")
    for k in range(p.size):
        if not (p[k] > 0.0 and r[k] > 0.0 and (k == 0 or p[k] > p[k - 1])):
            raise OutOfRange(f"rate_table, row {k + 1}: pressures must be positive and increase, and rates must be positive, got "
                             f"{p[k]:.6g} Pa and {r[k]:.6g} 1/s")
    return RateTable(tuple(np.log(p).tolist()), tuple(np.log(r).tolist()))


BURN.add(
    "forest_fire", ForestFire,
    line="Forest fire: the logarithm of the rate is a polynomial in the pressure, with first-order depletion.",
    functions={"rate": polynomial_rate, "advance": polynomial_advance, "scheduled": no_schedule},
    # log-rate of a made-up quadratic fit between 3 and 35 GPa: 0.02 per microsecond to 130 per microsecond
    example=forest_fire((-5.5, 48.0, -52.0), 3.0e9, 35.0e9),
    units={"coefficients": "1", "p_min": "Pa", "p_max": "Pa", "pressure_scale": "Pa", "time_scale": "s"},
    meaning={"coefficients": "coefficients of the polynomial, lowest power first, 1 to 15 values",
             "p_min": "pressure below which nothing burns",
             "p_max": "pressure above which the rate no longer depends on the pressure, usually the CJ pressure",
             "pressure_scale": "unit of pressure of the polynomial",
             "time_scale": "unit of time of the polynomial"},
    build=forest_fire,
    defaults={"pressure_scale": 1.0e11, "time_scale": 1.0e-6},
    box={"p": (0.0, 60.0e9)},
    references=("Mader, Numerical Modeling of Detonations, 1979, chapter 4",),
    flags=("pressure_driven",),
)

BURN.add(
    "rate_table",
    RateTable, line="Rate table: the rate is interpolated logarithmically in a table of pressures, with first-order depletion.",
    functions={"rate": table_rate, "advance": table_advance, "scheduled": no_schedule},
    example=rate_table((2.0e9, 5.0e9, 1.0e10, 2.0e10, 4.0e10), (2.0e3, 8.0e4, 1.2e6, 1.5e7, 1.0e8)),
    units={"log_pressure": "1", "log_rate": "1", "pressures": "Pa", "rates": "1/s"},
    meaning={"log_pressure": "logarithms of the pressures of the table in Pa", "log_rate": "logarithms of the rates of the table in 1/s",
             "pressures": "pressures of the table, in ascending order", "rates": "rates before depletion at the pressures of the table"},
    build=rate_table,
    box={"p": (0.0, 60.0e9)},
    references=("Mader, Numerical Modeling of Detonations, 1979, chapter 4",),
    flags=("pressure_driven",),
)
