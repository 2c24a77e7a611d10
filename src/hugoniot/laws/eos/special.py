r"""Special functions and quadrature for laws, written with plain arithmetic so that they serve floats, duals and kernels.

$$\mathrm{Ei}(z) = \gamma_E + \ln z + \sum_{k\ge1} \frac{z^k}{k\,k!} \quad (z > 0)$$

Source: Abramowitz and Stegun, Handbook of Mathematical Functions, 5.1.10, 5.1.51, 5.1.22 and table 25.4 (Gauss-Legendre).
"""

import numpy as np

from hugoniot.core.ops import vexp, vlog

KERNEL_HELPERS = True
"""Kernels that bind a law bind this module's functions too (core.compile.bind_module)."""

EULER = 0.57721566490153286061


def _gauss(n):
    """Nodes and weights on [0, 1] as a tuple of pairs."""
    x, w = np.polynomial.legendre.leggauss(n)
    return tuple((float(0.5 + 0.5 * a), float(0.5 * b)) for a, b in zip(x, w))


_GAUSS_16 = _gauss(16)


def quadrature():
    """The 16-point Gauss-Legendre rule on [0, 1]: pairs (node, weight)."""
    return _GAUSS_16


def ein(z):
    """Sum over k of z**k/(k k!), k = 1 to 28: relative error below 1e-16 for 0 <= z <= 4, so that Ei(z) = Euler + ln z + ein(z)."""
    return z * (1.0 + z * (1 / 4 + z * (1 / 18 + z * (1 / 96 + z * (1 / 600 + z * (1 / 4320 + z * (1 / 35280 + z * (1 / 322560 +
        z * (1 / 3265920 + z * (1 / 36288000 + z * (1 / 439084800 + z * (1 / 5748019200 + z * (1 / 80951270400 +
        z * (1 / 1220496076800 + z * (1 / 19615115520000 + z * (1 / 334764638208000 + z * (1 / 6046686277632000 +
        z * (1 / 115242726703104000 + z * (1 / 2311256907767808000 + z * (1 / 48658040163532800000 +
        z * (1 / 1072909785605898240000 + z * (1 / 24728016011107368960000 + z * (1 / 594596384994354462720000 +
        z * (1 / 14890761641597746544640000 + z * (1 / 387780251083274649600000000 + z * (1 / 10485577989291746525184000000 +
        z * (1 / 293999475161295508340736000000 + z * (1 / 8536873649127988094042112000000))))))))))))))))))))))))))))


def ei_difference(beta, y):
    """ein(beta) - ein(beta y) for 0 < y <= 1, beta <= 4: Ei(beta) - Ei(beta y) + ln y."""
    return ein(beta) - ein(beta * y)


def exponential_integral(z):
    """Ei(z) for z > 0 and -E1(-z) for z < 0, relative error about 1e-14 except near the zero of Ei at z = 0.3725 (absolute there)."""
    if z < 0.0:
        return -_e1(-z)
    if z < 40.0:
        total, term, k = EULER + vlog(z), 1.0, 1.0
        while k < 140.0:
            term = term * z / k
            total = total + term / k
            k += 1.0
        return total
    return _asymptotic(z)


def _asymptotic(z):
    """exp(z)/z sum of k!/z**k, cut well before its smallest term (z >= 40)."""
    total, term, k = 1.0, 1.0, 1.0
    while k < 38.0:
        term = term * k / z
        total = total + term
        k += 1.0
    return vexp(z) / z * total


def _e1(x):
    """E1(x), x > 0: power series below 1.5, else the continued fraction, evaluated from its tail."""
    if x < 1.5:
        total, term, k = -EULER - vlog(x), -1.0, 1.0
        while k < 30.0:
            term = -term * x / k
            total = total + term / k
            k += 1.0
        return total
    tail, k = x + 201.0, 100.0
    while k > 0.0:
        tail = x + 2.0 * k - 1.0 - k * k / tail
        k -= 1.0
    return vexp(-x) / tail
