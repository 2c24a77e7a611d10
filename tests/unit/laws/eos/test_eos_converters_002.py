"""Source Herrmann, appendix C: converters (H-11, H-E6), the non-ideal gas (H-5) and the cubic of the KO codes (B31)."""

import math

import pytest
from dual import Dual
from scipy.optimize import brentq

from hugoniot.laws.eos import converters
from hugoniot.laws.eos.contract import pressure, pressure_derivatives, reference_state, sound_speed_squared, temperature
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.laws.eos.mie_gruneisen_linear_gamma import MieGruneisenLinearGamma
from hugoniot.laws.eos.nonideal_gas import NonidealGas


class Series:
    """A power series in eta cut after eta^4: arithmetic that gives the coefficients of C.4 to C.16 without their formulas."""

    def __init__(self, *c):
        self.c = [*c, 0.0, 0.0, 0.0, 0.0, 0.0][:5]

    def __add__(self, o):
        o = o if isinstance(o, Series) else Series(o)
        return Series(*(x + y for x, y in zip(self.c, o.c)))

    __radd__ = __add__

    def __neg__(self):
        return Series(*(-x for x in self.c))

    def __sub__(self, o):
        return self + -o

    def __rsub__(self, o):
        return o + -self

    def __mul__(self, o):
        o = o if isinstance(o, Series) else Series(o)
        return Series(*(sum(self.c[i] * o.c[n - i] for i in range(n + 1)) for n in range(5)))

    __rmul__ = __mul__

    def __pow__(self, r):
        """From the differential equation y' x = r x' y of y = x^r."""
        y = [self.c[0] ** r]
        for n in range(1, 5):
            y.append(sum((r * k - (n - k)) * self.c[k] * y[n - k] for k in range(1, n + 1)) / (n * self.c[0]))
        return Series(*y)

    def __truediv__(self, o):
        return self * (o ** -1.0 if isinstance(o, Series) else 1.0 / o)


ETA = Series(0.0, 1.0)


def read_off(p):
    """(k0', k1', k2') of a pressure series."""
    return p.c[1], p.c[2] / p.c[1], p.c[3] / p.c[1]


def test_series_arithmetic_is_right():
    assert ((1.0 - ETA) ** -0.5).c == pytest.approx([1.0, 1 / 2, 3 / 8, 5 / 16, 35 / 128], rel=1e-15)
    assert (ETA / (1.0 - 2.0 * ETA)).c == [0.0, 1.0, 2.0, 4.0, 8.0]


def test_c7_follows_from_the_jump_conditions():
    """C.3: eta = u/U and p = rho0 u U; with C.5 U = c + s eta U, so U = c/(1 - s eta)."""
    rho0, c0, s = 2785.0, 5328.0, 1.338
    speed = c0 * (1.0 - s * ETA) ** -1.0
    assert tuple(converters.from_linear(rho0, c0, s)[:3]) == pytest.approx(read_off(rho0 * speed * speed * ETA), rel=1e-12)


@pytest.mark.parametrize("n", [0.7, 1.0, 4.3, 7.0])
def test_murnaghan_c9(n):
    assert tuple(converters.from_murnaghan(18e9, n)[:3]) == pytest.approx(read_off(18e9 * ((1.0 - ETA) ** -n - 1.0)), rel=1e-12)


def test_rice_mcqueen_walsh_cubic():
    mu = ETA / (1.0 - ETA)
    p = 765e8 * mu + 1659e8 * mu * mu + 428e8 * mu * mu * mu
    assert tuple(converters.from_compression_cubic(765e8, 1659e8, 428e8)[:3]) == pytest.approx(read_off(p), rel=1e-12)


def test_finite_strain_c11_with_h_e6():
    """C.10: p = -(1 - 2 eps)^(5/2) 3 eps (lambda + 2 mu/3), rho = rho0 (1 - 2 eps)^(3/2); H-E6: k0 = lambda + 2 mu/3."""
    lame, mu = 55e9, 27e9
    stretch = (1.0 - ETA) ** (-2.0 / 3.0)  # 1 - 2 eps
    p = -(stretch ** 2.5) * 1.5 * (1.0 - stretch) * (lame + 2.0 / 3.0 * mu)
    made = converters.from_finite_strain(lame, mu)
    assert tuple(made[:3]) == pytest.approx(read_off(p), rel=1e-12)
    assert made.k0 == lame + 2.0 / 3.0 * mu


def test_gruneisen_from_expansion_c14():
    """A solid's own expansion and heat at zero pressure, from the slopes of its pressure and temperature, give back its Gamma."""
    par = MieGruneisen(2785.0, 5328.0, 1.338, 2.1, 863.0)
    rho, e = reference_state(par)
    p_rho, p_e = pressure_derivatives(rho, e, par)
    t = temperature(Dual(rho, 1.0, 0.0), Dual(e, 0.0, 1.0), par)
    heated = t.y - t.x * p_e / p_rho  # dT/de at constant (zero) pressure, where de = dh
    expansion = p_e / p_rho / rho / heated
    assert converters.gruneisen_from_expansion(rho * sound_speed_squared(rho, e, par), expansion, rho, 1.0 / heated) == pytest.approx(2.1, rel=1e-12)


def test_rice_mcqueen_walsh_set_of_the_aluminium_example():
    """A = 765, B = 1659, C = 428 kb with gamma0 = 1.9687 and Gamma constant gives k1 = 2.184, k2 = 1.793, k3 = -0.72 ... and 5.242/1.338
    gives 1.692, 1.752."""
    gamma0 = 5.473 / 2.78
    rmw = converters.series(2780.0, converters.from_compression_cubic(765e8, 1659e8, 428e8), gamma0)
    assert (rmw.k1, rmw.k2) == pytest.approx((2.184, 1.793), abs=6e-4)
    linear = converters.series(2780.0, converters.from_linear(2780.0, 5242.0, 1.338), gamma0)
    assert (linear.k1, linear.k2) == pytest.approx((1.692, 1.752), abs=6e-4)
    assert (linear.h1, linear.h2, linear.h3, linear.h0) == (1.0, 1.0, 1.0, pytest.approx(5473.0))


@pytest.mark.parametrize("gammas", [(0.0, 0.0, 0.0), (0.3, -0.2, 0.1), (-1.0, 1.0, -1.0)])
@pytest.mark.parametrize("third", [0.0, 7.5])
def test_c16_is_the_expansion_of_c15(gammas, third):
    """f1 = p_H - gamma rho E_H, f2 = gamma rho with C.4, C.13 and E_H = p_H eta/(2 rho0), for a Gamma that varies and any k3'."""
    rho0, gamma0 = 2785.0, 1.8
    hugoniot = converters.from_linear(rho0, 5328.0, 1.4)._replace(k3=third)
    law = converters.series(rho0, hugoniot, gamma0, gammas)
    p_h = hugoniot.k0 * ETA * (1.0 + hugoniot.k1 * ETA + hugoniot.k2 * ETA * ETA + third * ETA * ETA * ETA)
    gamma_rho = gamma0 * (1.0 + gammas[0] * ETA + gammas[1] * ETA * ETA + gammas[2] * ETA * ETA * ETA) * rho0 / (1.0 - ETA)
    f1 = p_h - gamma_rho * p_h * ETA / (2.0 * rho0)
    assert [law.k0, law.k0 * law.k1, law.k0 * law.k2, law.k0 * law.k3] == pytest.approx(f1.c[1:], rel=1e-12)
    assert [law.h0, law.h0 * law.h1, law.h0 * law.h2, law.h0 * law.h3] == pytest.approx(gamma_rho.c[:4], rel=1e-12)
    # and the law is that series
    for e in (0.0, 1e6):
        found = [pressure(rho0 / (1.0 - h), e, law) for h in (0.0, 0.01, 0.02)]
        assert found == pytest.approx([sum((f1 + e * gamma_rho).c[n] * h**n for n in range(4)) + f1.c[4] * h**4 for h in (0.0, 0.01, 0.02)],
                                      rel=1e-12, abs=1e-2)


@pytest.mark.parametrize("rho0, c0, s, gamma0, ratios", [
    (2785.0, 5328.0, 1.338, 2.0, (0.9959, 0.9862, 0.9675, 0.893)), (8930.0, 3940.0, 1.49, 2.0, (0.9936, 0.9787, 0.9506, 0.841)),
    (1000.0, 1450.0, 1.99, 0.15, (0.974, 0.919, 0.826, 0.534))], ids=["aluminium", "copper", "water"])
def test_cubic_of_the_ko_codes_against_the_exact_law_b31(rho0, c0, s, gamma0, ratios):
    """Pressure on its own Hugoniot over that of the exact law, at strains 0.1, 0.15, 0.2, 0.3."""
    cubic = converters.wilkins_cubic(rho0, c0, s, gamma0)
    for x, ratio in zip((0.1, 0.15, 0.2, 0.3), ratios):
        rho = rho0 / (1 - x)
        cold = pressure(rho, 0.0, cubic)
        p = cold / (1.0 - 0.5 * gamma0 * x)  # e = p x/(2 rho0)
        assert p / (rho0 * c0 * c0 * x / (1 - s * x) ** 2) == pytest.approx(ratio, abs=1e-4 if len(str(ratio)) == 6 else 5.1e-4)
        exact = MieGruneisen(rho0, c0, s, gamma0)
        p_h = rho0 * c0 * c0 * x / (1 - s * x) ** 2
        assert pressure(rho, p_h * x / (2 * rho0), exact) == pytest.approx(p_h, rel=1e-13)


def test_pentolite_h5():
    """chi = 0 with gamma = 1.77, beta = 2.77; CJ of that gamma law: 2.33277 g/cm3, 290.317 kb, 2119.6 m/s with E0 = 4.7847 kJ/g."""
    d, beta = 7991.0, 2.77
    e0 = d * d / (2 * (beta * beta - 1))
    assert e0 == pytest.approx(4.7847e6, rel=1e-5)
    par = NonidealGas(2333.0, 290.289e8, beta, 1.77, 1714.0, e0 * 1714.0)
    assert pressure(1500.0, 0.0, par) == pytest.approx(0.0, abs=1.0)

    def gap(v):
        p = 1.77 / v * e0 / (1 - 0.5 * 1.77 / v * (1 / 1714.0 - v))
        e = e0 + 0.5 * p * (1 / 1714.0 - v)
        return sound_speed_squared(1 / v, e, par) / v**2 - p / (1 / 1714.0 - v)

    v = brentq(gap, 1 / 2600.0, 1 / 1900.0, xtol=1e-18)
    p = 1.77 / v * e0 / (1 - 0.5 * 1.77 / v * (1 / 1714.0 - v))
    assert 1 / v == pytest.approx(2332.77, rel=1e-5)
    assert p == pytest.approx(290.317e8, rel=1e-5)
    assert math.sqrt(p * (1 / 1714.0 - v)) == pytest.approx(2119.6, rel=2.5e-5)


def test_nonideal_gas_keeps_its_isentrope():
    par = NonidealGas(2333.0, 29.0289e9, 2.9, 0.9, 1714.0)
    for rho in (500.0, 2333.0, 3000.0):
        p_i = 29.0289e9 * (rho / 2333.0) ** 2.9
        assert pressure(rho, p_i / (rho * 1.9), par) == pytest.approx(p_i, rel=1e-13)
        # C.21: de_i/drho = p_i/rho^2 on it, and gamma = beta
        assert sound_speed_squared(rho, p_i / (rho * 1.9), par) == pytest.approx(2.9 * p_i / rho, rel=1e-12)


def test_gruneisen_relation_and_elastic_wave():
    assert converters.gruneisen_from_expansion(76e9, 69e-6, 2700.0, 900.0) == pytest.approx(76e9 * 69e-6 / 2.43e6)
    k, g, rho = 76.4e9, 28.6e9, 2780.0
    assert converters.elastic_wave_speed(k, g, rho) == pytest.approx(6419.0, abs=1.0)
    once, twice = converters.elastic_wave_speed(k, g, rho) ** 2, converters.elastic_wave_speed(k, 2.0 * g, rho) ** 2
    slope = 0.5 * (twice - once) / once  # dln c/dln G, as c^2 is linear in G
    assert slope == pytest.approx(1.0 / (1.5 * k / g + 2.0), rel=1e-12)  # C.18
    assert slope == pytest.approx(0.16647, rel=1e-4)


def test_series_of_gamma_constant_approaches_the_exact_law():
    exact = MieGruneisenLinearGamma(2785.0, 5328.0, 1.338, 2.0, 2.0)
    law = converters.series(2785.0, converters.from_linear(2785.0, 5328.0, 1.338), 2.0)
    errors = [abs(pressure(2785.0 / (1 - x), 0.0, law) / pressure(2785.0 / (1 - x), 0.0, exact) - 1) for x in (0.08, 0.04, 0.02)]
    assert math.log2(errors[0] / errors[1]) == pytest.approx(3.0, abs=0.35)
    assert math.log2(errors[1] / errors[2]) == pytest.approx(3.0, abs=0.2)
