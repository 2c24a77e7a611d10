r"""Follows the isentrope of any equation of state from one density to another.

$$\frac{de}{dv} = -p(1/v,\, e)$$

Laws that know one isentrope and the growth of energies beside it (`reference_isentrope`) answer in closed form; the others are marched.

Source: 003 (Starkenberg) A-2. The march uses Butcher's seven-stage sixth-order Runge-Kutta method (J. C. Butcher, J. Austral. Math.
Soc. 4 (1964) 179) over sub-steps that change the volume by at most 1.25 %; short ways take cheaper formulas of the same accuracy.
"""

from hugoniot.core.ops import fmin, vexp
from hugoniot.laws.eos.contract import EOS, pressure, reference_isentrope

LONGEST_STRIDE = 0.0125
LARGEST_COUNT = 4000


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


def isentrope_energy(v0, e0, v1, par):
    """Energy (J/kg) at volume v1 (m3/kg) on the isentrope through (v0, e0)."""
    return closed_energy(v0, e0, v1, par) if knows_isentropes(par) else marched_energy(v0, e0, v1, par)


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
