r"""Computes the isentrope of any equation of state from one density to another.

$$\frac{de}{dv} = -p(1/v,\, e)$$

Laws with a known isentrope and a known growth of energy differences from it (`reference_isentrope`) have a closed form. For other laws
linear in the energy, $p = p(v, e_0) + b(v)(e - e_0)$, the energy gained is an integral of known functions,

$$e - e_0 = -\frac{1}{\varphi(v)}\int_{v_0}^{v}\varphi\,p(v', e_0)\,dv', \qquad \ln\varphi = \int_{v_0}^{v'} b\,dv'',$$

evaluated by Gauss-Legendre rules, separately above and below the density at rest, where such laws change branch, and in pieces so short
that the integrand's last Legendre coefficient is negligible. All other laws are integrated step by step.

Source: Starkenberg A-2. The march uses Butcher's seven-stage sixth-order Runge-Kutta method (J. C. Butcher, J. Austral. Math.
Soc. 4 (1964) 179) over sub-steps that change the volume by at most 1.25 %; short ways take cheaper formulas of the same accuracy.
"""

import numpy as np

from hugoniot.core.ops import fmin, vexp
from hugoniot.laws.eos.contract import EOS, pressure, pressure_derivatives, reference_isentrope, reference_state

LONGEST_STRIDE = 0.0125
LONGEST_PIECE = 0.25     # of an integral by 8 points, relative to the volume
LARGEST_COUNT = 4000


def _gauss(count):
    """Gauss-Legendre nodes and weights on 0..1."""
    x, w = np.polynomial.legendre.leggauss(count)
    return 0.5 * (1.0 + x), 0.5 * w


_X3, _W3 = _gauss(3)
_X6, _W6 = _gauss(6)
_X8, _W8 = _gauss(8)
_LAST3 = 5.0 * _W3 * np.polynomial.legendre.Legendre.basis(2)(2.0 * _X3 - 1.0)     # give the last coefficient a rule resolves
_LAST8 = 15.0 * _W8 * np.polynomial.legendre.Legendre.basis(7)(2.0 * _X8 - 1.0)
_TAIL3, _TAIL8 = 3e-5, 1e-6     # shares of the integrand it may have: what is left falls as its cube, its square, below 1e-13


def stride(v, e, h, par):
    """Energy after a change h of the volume: one sixth-order step."""
    k1 = -pressure(1.0 / v, e, par)
    k2 = -pressure(1.0 / (v + h / 3.0), e + h * k1 / 3.0, par)
    k3 = -pressure(1.0 / (v + 2.0 * h / 3.0), e + h * 2.0 * k2 / 3.0, par)
    k4 = -pressure(1.0 / (v + h / 3.0), e + h * (k1 + 4.0 * k2 - k3) / 12.0, par)
    k5 = -pressure(1.0 / (v + 0.5 * h), e + h * (-k1 + 18.0 * k2 - 3.0 * k3 - 6.0 * k4) / 16.0, par)
    k6 = -pressure(1.0 / (v + 0.5 * h), e + h * (9.0 * k2 - 3.0 * k3 - 6.0 * k4 + 4.0 * k5) / 8.0, par)
    k7 = -pressure(1.0 / (v + h), e + h * (9.0 * k1 - 36.0 * k2 + 63.0 * k3 + 72.0 * k4 - 64.0 * k6) / 44.0, par)
    return e + h * (11.0 * (k1 + k7) + 81.0 * (k3 + k4) - 32.0 * (k5 + k6)) / 120.0


def knows_isentropes(par):
    """Whether the law has its isentropes in closed form."""
    return "reference_isentrope" in EOS.of(par).functions


def is_linear(par):
    """Whether the pressure is linear in the energy."""
    return "linear_in_energy" in EOS.of(par).flags


def isentrope_energy(v0, e0, v1, par):
    """Energy (J/kg) at volume v1 (m3/kg) on the isentrope through (v0, e0)."""
    if knows_isentropes(par):
        return closed_energy(v0, e0, v1, par)
    return integrated_energy(v0, e0, v1, par) if is_linear(par) else marched_energy(v0, e0, v1, par)


def closed_energy(v0, e0, v1, par):
    """`isentrope_energy` of a law that knows its isentropes."""
    there, growth = reference_isentrope(1.0 / v1, par)
    start, growth0 = reference_isentrope(1.0 / v0, par)
    return there + (e0 - start) * vexp(growth - growth0)


def marched_energy(v0, e0, v1, par):
    """`isentrope_energy` of any law.

    Ways of more than 4000 sub-steps (a volume ratio beyond e^50) are covered by proportionally longer ones.
    """
    h = v1 - v0
    reach = abs(h) / fmin(v0, v1)
    if reach < 1e-6:
        # the midpoint rule: its error, reach^3 times the third derivative over 24, is below round-off here
        return e0 - h * pressure(1.0 / (v0 + 0.5 * h), e0 - 0.5 * h * pressure(1.0 / v0, e0, par), par)
    if reach <= LONGEST_STRIDE:
        return stride(v0, e0, h, par)
    count = 1
    ratio = 1.0 + reach
    while ratio > 1.0 + LONGEST_STRIDE and count < LARGEST_COUNT:
        ratio = ratio / (1.0 + LONGEST_STRIDE)
        count += 1
    factor = 1.0 + LONGEST_STRIDE if h > 0.0 else 1.0 / (1.0 + LONGEST_STRIDE)
    v, e = v0, e0
    for _ in range(count - 1):
        e = stride(v, e, v * (factor - 1.0), par)
        v = v * factor
    return stride(v, e, v1 - v, par)


def brief_heating(v0, h, par):
    """ln phi between v0 and v0 + h, by 3 points."""
    total = 0.0
    for k in range(3):
        total += _W3[k] * pressure_derivatives(1.0 / (v0 + _X3[k] * h), 0.0, par)[1]
    return h * total


def heating(v0, h, par):
    """The same by 6 points."""
    total = 0.0
    for k in range(6):
        total += _W6[k] * pressure_derivatives(1.0 / (v0 + _X6[k] * h), 0.0, par)[1]
    return h * total


def short_integral(v0, e0, h, par):
    """(energy after a change h of the volume, whether it is sure) by 3 points, for laws linear in the energy."""
    total, size, last = 0.0, 0.0, 0.0
    for k in range(3):
        way = _X3[k] * h
        value = vexp(brief_heating(v0, way, par)) * pressure(1.0 / (v0 + way), e0, par)
        total += _W3[k] * value
        size += _W3[k] * abs(value)
        last += _LAST3[k] * value
    return e0 - h * total * vexp(-brief_heating(v0, h, par)), not abs(last) > _TAIL3 * size


def long_integral(v0, e0, h, par):
    """The same by 8 points."""
    total, size, last = 0.0, 0.0, 0.0
    for k in range(8):
        way = _X8[k] * h
        value = vexp(heating(v0, way, par)) * pressure(1.0 / (v0 + way), e0, par)
        total += _W8[k] * value
        size += _W8[k] * abs(value)
        last += _LAST8[k] * value
    return e0 - h * total * vexp(-heating(v0, h, par)), not abs(last) > _TAIL8 * size


def integrated_energy(v0, e0, v1, par):
    """`isentrope_energy` of laws linear in the energy."""
    if abs(v1 - v0) < 1e-6 * fmin(v0, v1):
        return e0 - (v1 - v0) * pressure(0.5 * (1.0 / v0 + 1.0 / v1), e0 - 0.5 * (v1 - v0) * pressure(1.0 / v0, e0, par), par)
    rest = 1.0 / reference_state(par)[0]
    v, e, end = v0, e0, rest if (rest - v0) * (v1 - rest) > 0.0 else v1
    h = end - v
    for _ in range(LARGEST_COUNT):
        reach = abs(h) / fmin(v, v + h)
        sure, there = False, e
        if reach <= LONGEST_STRIDE:
            there, sure = short_integral(v, e, h, par)
        if not sure and reach <= LONGEST_PIECE:
            there, sure = long_integral(v, e, h, par)
        if not sure:
            h = 0.5 * h if reach <= LONGEST_PIECE or h < 0.0 else 0.249 * v
            continue
        e = there
        v = end if h == end - v else v + h
        if v == end:
            if end == v1:
                return e
            end = v1
        h = end - v
    return marched_energy(v, e, v1, par)


