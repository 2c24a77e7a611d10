"""Source 002, appendix C: converters (H-11, H-E6), the non-ideal gas (H-5) and the cubic of the KO codes (B31)."""

import math

import numpy as np
import pytest
from scipy.optimize import brentq

from hugoniot.laws.eos import converters
from hugoniot.laws.eos.contract import pressure, sound_speed_squared
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.laws.eos.mie_gruneisen_linear_gamma import MieGruneisenLinearGamma
from hugoniot.laws.eos.nonideal_gas import NonidealGas


def series_by_fit(p, k0):
    """(k1', k2') of p = k0 eta (1 + k1 eta + k2 eta^2 + ...) by a polynomial fit on a small circle in the complex plane."""
    n, radius = 16, 0.05
    eta = radius * np.exp(2j * np.pi * np.arange(n) / n)
    coefficients = np.fft.fft(p(eta)) / n / radius ** np.arange(n)
    assert coefficients[1].real == pytest.approx(k0, rel=1e-12)
    return coefficients[2].real / k0, coefficients[3].real / k0


@pytest.mark.parametrize("made, p", [
    (converters.from_linear(2785.0, 5328.0, 1.338), lambda h: 2785.0 * 5328.0**2 * h / (1 - 1.338 * h) ** 2),
    (converters.from_murnaghan(18e9, 4.3), lambda h: 18e9 * ((1 - h) ** -4.3 - 1)),
    (converters.from_compression_cubic(765e8, 1659e8, 428e8),
     lambda h: 765e8 * h / (1 - h) + 1659e8 * (h / (1 - h)) ** 2 + 428e8 * (h / (1 - h)) ** 3)], ids=["linear", "murnaghan", "rice_mcqueen_walsh"])
def test_expansions_c7_c9(made, p):
    k1, k2 = series_by_fit(p, made.k0)
    assert (made.k1, made.k2) == pytest.approx((k1, k2), rel=1e-11)


def test_finite_strain_c11_with_h_e6():
    """p = -(1 - 2 eps)^(5/2) 3 eps (lambda + 2 mu/3), rho = rho0 (1 - 2 eps)^(3/2): k0 = lambda + 2 mu/3, k1 = 5/2, k2 = 235/54."""
    lame, mu = 55e9, 27e9

    def p(eta):
        strain = 0.5 * (1.0 - (1.0 - eta) ** (-2.0 / 3.0))
        return -((1.0 - 2.0 * strain) ** 2.5) * 3.0 * strain * (lame + 2.0 / 3.0 * mu)

    made = converters.from_finite_strain(lame, mu)
    assert made.k0 == lame + 2.0 / 3.0 * mu
    assert (made.k1, made.k2) == pytest.approx(series_by_fit(p, made.k0), rel=1e-11)
    assert made.k1 == 2.5
    assert made.k2 == pytest.approx(235.0 / 54.0, rel=1e-15)


def test_rice_mcqueen_walsh_set_of_the_aluminium_example():
    """A = 765, B = 1659, C = 428 kb with gamma0 = 1.9687 and Gamma constant gives k1 = 2.184, k2 = 1.793, k3 = -0.72 ... and 5.242/1.338
    gives 1.692, 1.752."""
    gamma0 = 5.473 / 2.78
    rmw = converters.series(2780.0, converters.from_compression_cubic(765e8, 1659e8, 428e8), gamma0)
    assert (rmw.k1, rmw.k2) == pytest.approx((2.184, 1.793), abs=6e-4)
    linear = converters.series(2780.0, converters.from_linear(2780.0, 5242.0, 1.338), gamma0)
    assert (linear.k1, linear.k2) == pytest.approx((1.692, 1.752), abs=6e-4)
    assert (linear.h1, linear.h2, linear.h3, linear.h0) == (1.0, 1.0, 1.0, pytest.approx(5473.0))


def test_c16_is_the_expansion_of_c15():
    """The series law agrees with the Mie-Grüneisen law it was expanded from to the order kept, for a Gamma that varies."""
    gamma0, gammas, s = 1.8, (0.3, -0.2, 0.1), 1.4
    law = converters.series(2785.0, converters.from_linear(2785.0, 5328.0, s), gamma0, gammas)

    def exact(eta):
        gamma = gamma0 * (1 + eta * (gammas[0] + eta * (gammas[1] + eta * gammas[2])))
        p_h = 2785.0 * 5328.0**2 * eta / (1 - s * eta) ** 2
        return p_h * (1 - 0.5 * gamma * eta / (1 - eta))

    k1, k2 = series_by_fit(exact, law.k0)
    assert (law.k1, law.k2) == pytest.approx((k1, k2), rel=1e-10)
    n, radius = 16, 0.05
    eta = radius * np.exp(2j * np.pi * np.arange(n) / n)
    k3 = (np.fft.fft(exact(eta)) / n / radius ** np.arange(n))[4].real / law.k0
    # C.16 drops k3' = 4 s^3
    assert law.k3 == pytest.approx(k3 - 4 * s**3, rel=1e-9)
    warm = np.fft.fft(gamma0 * 2785.0 * (1 + eta * (gammas[0] + eta * (gammas[1] + eta * gammas[2]))) / (1 - eta)) / n / radius ** np.arange(n)
    assert (law.h0, law.h0 * law.h1, law.h0 * law.h2, law.h0 * law.h3) == pytest.approx(tuple(warm[:4].real), rel=1e-9)


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


def test_gruneisen_relation_and_elastic_wave():
    assert converters.gruneisen_from_expansion(76e9, 69e-6, 2700.0, 900.0) == pytest.approx(76e9 * 69e-6 / 2.43e6)
    k, g, rho = 76.4e9, 28.6e9, 2780.0
    assert converters.elastic_wave_speed(k, g, rho) == pytest.approx(6419.0, abs=1.0)
    h = 1e-6
    slope = math.log(converters.elastic_wave_speed(k, g * (1 + h), rho) / converters.elastic_wave_speed(k, g, rho)) / h
    assert slope == pytest.approx(1.0 / (1.5 * k / g + 2.0), rel=1e-5)  # C.18
    assert slope == pytest.approx(0.16647, rel=1e-4)


def test_series_of_gamma_constant_approaches_the_exact_law():
    exact = MieGruneisenLinearGamma(2785.0, 5328.0, 1.338, 2.0, 2.0)
    law = converters.series(2785.0, converters.from_linear(2785.0, 5328.0, 1.338), 2.0)
    errors = [abs(pressure(2785.0 / (1 - x), 0.0, law) / pressure(2785.0 / (1 - x), 0.0, exact) - 1) for x in (0.08, 0.04, 0.02)]
    assert math.log2(errors[0] / errors[1]) == pytest.approx(3.0, abs=0.35)
    assert math.log2(errors[1] / errors[2]) == pytest.approx(3.0, abs=0.2)
