"""Jordan, cold curve: verification.md A5 (values and truncation errors), exact integral by independent quadrature."""

import math

import pytest
from scipy.integrate import quad

from hugoniot.errors import OutOfRange
from hugoniot.laws.eos import mie_gruneisen_cold as exact
from hugoniot.laws.eos import mie_gruneisen_cold_series as series
from hugoniot.laws.eos.contract import has_temperature, pressure, temperature
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen, build

COPPER = exact.MieGruneisenCold(8930.0, 3940.0, 1.49, 1.99)
SILICA = exact.MieGruneisenCold(100.0, 121.0, 0.9736, 0.3)


def at(x, par):
    return par.rho0 / (1.0 - x)


@pytest.mark.parametrize("par, x, e, p", [(COPPER, 0.1, 9.55777587e4, 18.9358e9), (COPPER, 0.3, 1.41389344e6, 120.525e9),
                                          (COPPER, 0.4, 3.46266266e6, 266.055e9), (SILICA, 0.6, 7934.556, None), (SILICA, 0.97, 193890.9, None)])
def test_exact_cold_energy(par, x, e, p):
    rho = at(x, par)
    digits = 1e-9 if par is COPPER else 5e-7
    assert exact.cold_energy(rho, par) == pytest.approx(e, rel=max(digits, 5e-9))
    if p is not None:
        assert exact.cold_pressure(rho, par) == pytest.approx(p, rel=5e-6)
    g, s, c = par.gamma0, par.s, par.c0
    integral, _ = quad(lambda t: math.exp(g * (x - t)) * c * c * t * (1 - 0.5 * g * t) / (1 - s * t) ** 2, 0.0, x, epsabs=0.0, epsrel=1e-13)
    assert exact.cold_energy(rho, par) == pytest.approx(integral, rel=1e-11)


@pytest.mark.parametrize("par, x, percent, tol", [(COPPER, 0.3, (-21.15, -8.5, -3.5, -1.5), 0.05), (SILICA, 0.6, (-40.9, -24.5, -14.5, -8.6), 0.05),
                                                  (SILICA, 0.97, (-92, -87, -83, -79), 0.5)])
def test_truncation_errors_of_orders_3_to_6(par, x, percent, tol):
    rho = at(x, par)
    for order, expected in zip((3, 4, 5, 6), percent):
        truncated = series.build(par.rho0, par.c0, par.s, par.gamma0, order)
        error = series.cold_energy(rho, truncated) / exact.cold_energy(rho, par) - 1.0
        assert 100.0 * error == pytest.approx(expected, abs=tol)


def test_order_3_is_11_percent_off_at_30_percent_strain_in_silica():
    """The source's claim that the series holds to 60 % is optimistic."""
    error = series.cold_energy(at(0.3, SILICA), series.build(100.0, 121.0, 0.9736, 0.3, 3)) / exact.cold_energy(at(0.3, SILICA), SILICA) - 1
    assert error == pytest.approx(-0.11, abs=0.005)


def test_coefficients_of_the_recursion():
    c, s, g, e00 = 3940.0, 1.49, 1.99, -1.1e5
    e = exact.cold_coefficients(c, s, g, e00, 4)
    assert e[1] == pytest.approx(g * e00)
    assert e[2] == pytest.approx((c * c + g * g * e00) / 2, rel=1e-14)
    assert e[3] == pytest.approx((4 * s * c * c + g**3 * e00) / 6, rel=1e-14)
    assert e[4] == pytest.approx((18 * s * s * c * c - 2 * g * s * c * c + g**4 * e00) / 24, rel=1e-14)


def test_exact_curve_makes_the_hugoniot_law_and_truncation_misses_the_shock():
    """With the exact cold curve the shock state is met for any gamma0 (residual below 1e-12); order 3 misses it."""
    for gamma0 in (0.5, 1.99, 2.8):
        par, hugoniot = COPPER._replace(gamma0=gamma0), MieGruneisen(8930.0, 3940.0, 1.49, gamma0)
        for up in (300.0, 1500.0):
            us = 3940.0 + 1.49 * up
            rho, e, p = 8930.0 * us / (us - up), 0.5 * up * up, 8930.0 * us * up
            assert pressure(rho, e, par) == pytest.approx(p, rel=1e-12)
            from_cold = exact.cold_pressure(rho, par) + 8930.0 * gamma0 * (e - exact.cold_energy(rho, par))
            assert from_cold == pytest.approx(pressure(rho, e, hugoniot), rel=1e-12)
    us = 3940.0 + 1.49 * 1500.0
    missed = pressure(8930.0 * us / (us - 1500.0), 0.5 * 1500.0**2, series.build(8930.0, 3940.0, 1.49, 1.99, 3))
    assert missed / (8930.0 * us * 1500.0) < 0.95


def test_temperature_is_zero_on_the_cold_curve_and_t0_at_rest():
    par = exact.MieGruneisenCold(8930.0, 3940.0, 1.49, 1.99, -385.0 * 298.15, 385.0)
    assert temperature(8930.0, 0.0, par) == pytest.approx(298.15, rel=1e-13)
    for x in (-0.2, 0.05, 0.3):
        rho = at(x, par)
        assert temperature(rho, exact.cold_energy(rho, par), par) == pytest.approx(0.0, abs=1e-9)


def test_nearly_straight_hugoniots_are_sent_to_the_law_that_can():
    with pytest.raises(OutOfRange, match="use mie_gruneisen"):
        exact.build(8930.0, 3940.0, 0.2, 1.99)
    straight = build(8930.0, 3940.0, 0.0, 1.99, specific_heat=385.0)
    assert has_temperature(straight)
    assert not has_temperature(MieGruneisen(8930.0, 3940.0, 0.0, 1.99, 385.0))
    assert pressure(9500.0, 1e5, straight) == pytest.approx(pressure(9500.0, 1e5, MieGruneisen(8930.0, 3940.0, 0.0, 1.99)), rel=1e-14)


@pytest.mark.parametrize("order", [2, 7, 3.5])
def test_other_orders_are_refused(order):
    with pytest.raises(OutOfRange, match="order must be 3, 4, 5 or 6"):
        series.build(8930.0, 3940.0, 1.49, 1.99, order)
