"""Scalar operations for laws and sweeps: plain numbers, dual numbers and arrays here, packed instructions inside a kernel.

The standard library's `exp`, `log` and `pow` are scalar calls in a compiled sweep and stop its vectorisation, and so do
`min` and `np.minimum` in a reduction.  A law therefore calls the functions of this module.  In plain Python they go
through numpy, which also serves dual numbers (any object with `exp`, `log`, `sqrt` methods); `core.mathematics` replaces
them inside kernels by forms the vectoriser keeps.
"""

import numpy as np

NO_LIMIT = 1e300  # stands for "no limit" in compiled sweeps, whose fast-math may not meet an infinity


def fmin(a, b):
    """The smaller of two numbers."""
    return a if a < b else b


def fmax(a, b):
    """The larger of two numbers."""
    return a if a > b else b


def vsqrt(x):
    """Square root of x >= 0."""
    return np.sqrt(x)


def late_over(x, y):
    """x / y where x is known later than y: inside a kernel x times 1/y, so that the division has begun when x comes (2 roundings)."""
    return x / y


def vexp(x):
    """Exponential; inside a kernel accurate to about 1e-15 for -708 < x < 709 and saturated outside."""
    return np.exp(x)


def vlog(x):
    """Natural logarithm of a normal positive number; inside a kernel accurate to about 1e-15."""
    return np.log(x)


def vpow(x, y):
    """x**y for x > 0, as exp(y log x): relative error about 1e-16 (1 + |y log x|)."""
    return vexp(y * vlog(x))
