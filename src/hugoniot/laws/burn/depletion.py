r"""Closed-form solution of depletion at a constant speed, and a power that is safe at zero.

$$\frac{d\lambda}{dt} = k\,(1-\lambda)^m \;\Rightarrow\; (1-\lambda)^{1-m} = (1-\lambda_0)^{1-m} - (1-m)\,k t \;(m \ne 1), \qquad
1-\lambda = (1-\lambda_0)\,e^{-kt} \;(m = 1)$$

For m < 1 burning ends after the time $(1-\lambda_0)^{1-m}/((1-m)k)$, exactly at 1.
"""

import math

from hugoniot.core.ops import vexp, vpow
from hugoniot.errors import OutOfRange
from hugoniot.laws.burn.contract import BURN


def power(x, y):
    """x**y for x >= 0 and y >= 0, with 0**0 = 1 and negative x taken as 0."""
    if x <= 0.0:
        return 1.0 if y == 0.0 else 0.0
    # the powers most calibrations have, without logarithm and exponential
    if y == 1.0:
        return x
    if y == 2.0:
        return x * x
    if y == 3.0:
        return x * x * x
    return vpow(x, y)


def deplete(burn_fraction, amount, exponent):
    """Burn fraction after `amount` = k t (dimensionless) of depletion of order `exponent`."""
    left = 1.0 - burn_fraction
    if left <= 0.0 or amount <= 0.0:
        return burn_fraction
    share = amount * vpow(left, exponent - 1.0)
    if share < 1e-5:
        # the closed forms lose a small rise to the 1 of 1 - lambda; this series has lost nothing at the third power
        return burn_fraction + left * share * (1.0 - 0.5 * exponent * share * (1.0 - (2.0 * exponent - 1.0) / 3.0 * share))
    if abs(exponent - 1.0) < 1e-9:
        return 1.0 - left * vexp(-amount)
    base = 1.0 - (1.0 - exponent) * share
    if base <= 0.0:
        return 1.0
    return 1.0 - left * vpow(base, 1.0 / (1.0 - exponent))


def with_unit(par, key: str) -> str:
    """A parameter of a registered burn law as messages show it, with its unit."""
    if math.isnan(getattr(par, key)):
        return "a value that is not a number"
    unit = BURN.of(par).units[key]
    return f"{getattr(par, key):.6g}" + (f" {unit}" if unit != "1" else "")


def without_negatives(par):
    """The parameters as they are; OutOfRange for a negative or missing one, with which burning would run backwards or without end."""
    for key, value in par._asdict().items():
        if not value >= 0.0:
            raise OutOfRange(f"{BURN.of(par).name}: {key} must not be negative, got {with_unit(par, key)}")
    return par
