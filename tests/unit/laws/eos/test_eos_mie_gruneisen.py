"""Mie-Grüneisen solids on shock Hugoniots: exact on the data, sound in tension, temperatures by independent quadrature."""

import math

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.special import expi

from hugoniot.errors import OutOfRange
from hugoniot.laws.eos import special
from hugoniot.laws.eos.contract import (
    EOS,
    density_limits,
    entropy,
    gruneisen,
    particle_velocity_limit,
    pressure,
    pressure_derivatives,
    sound_speed_squared,
    temperature,
)
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen, build, reference_isentrope
from hugoniot.laws.eos.mie_gruneisen_cubic import MieGruneisenCubic
from hugoniot.laws.eos.mie_gruneisen_linear_gamma import MieGruneisenLinearGamma
from hugoniot.laws.eos.mie_gruneisen_quadratic import MieGruneisenQuadratic

ALUMINIUM = MieGruneisen(2785.0, 5328.0, 1.338, 2.0, 863.0)


def shock(par, us, up):
    """(rho, e, p) behind a shock into the rest state by the jump conditions."""
    return par.rho0 * us / (us - up), 0.5 * up * up, par.rho0 * us * up


@pytest.mark.parametrize("gamma0", [0.3, 1.0, 2.0, 3.1])
@pytest.mark.parametrize("up", [1.0, 300.0, 2000.0, 5000.0])
def test_linear_hugoniot_is_met_for_any_gamma(gamma0, up):
    """J lesson of A5: the exact law passes through the shock state whatever gamma0 is, with any form of Gamma."""
    for par in (ALUMINIUM._replace(gamma0=gamma0), MieGruneisenLinearGamma(2785.0, 5328.0, 1.338, gamma0, 0.48),
                MieGruneisenLinearGamma(2785.0, 5328.0, 1.338, gamma0, gamma0)):
        rho, e, p = shock(par, 5328.0 + 1.338 * up, up)
        assert pressure(rho, e, par) == pytest.approx(p, rel=1e-12)


@pytest.mark.parametrize("s2", [-6.06e-5, 3e-5])
@pytest.mark.parametrize("up", [10.0, 900.0, 2800.0])
def test_quadratic_hugoniot_is_met(s2, up):
    par = MieGruneisenQuadratic(7856.0, 3531.0, 1.2, s2, 1.69, 0.3)
    rho, e, p = shock(par, 3531.0 + 1.2 * up + s2 * up * up, up)
    assert pressure(rho, e, par) == pytest.approx(p, rel=1e-11)


@pytest.mark.parametrize("up", [10.0, 500.0, 1500.0])
def test_steinberg_cubic_hugoniot_is_met(up):
    par = MieGruneisenCubic(11340.0, 2006.0, 1.429, 0.8506, -1.64, 2.77, 0.54)
    us = 2006.0
    for _ in range(200):
        ratio = up / us
        us = 2006.0 + (1.429 + 0.8506 * ratio - 1.64 * ratio * ratio) * up
    rho, e, p = shock(par, us, up)
    assert pressure(rho, e, par) == pytest.approx(p, rel=1e-11)


@pytest.mark.parametrize("rho0, c0, s, gamma", [(2200.0, 3900.0, (2.16, 1.54, -9.43), 0.24), (2150.0, 1680.0, (1.123, 3.983, -5.797), 0.59)],
                         ids=["graphite", "teflon"])
def test_a_cubic_hugoniot_is_answered_to_its_end(rho0, c0, s, gamma):
    """Shocks found from the law follow the fit up to where up(eta) turns back, and end there."""
    from hugoniot.theory import hugoniot

    par = MieGruneisenCubic(rho0, c0, *s, gamma)
    eta = np.linspace(0.0, 1.0, 200001)[1:-1]
    up = c0 * eta / (1.0 - eta * (s[0] + eta * (s[1] + eta * s[2])))
    end = int(np.argmax(np.diff(up) <= 0.0))
    assert particle_velocity_limit(par) == pytest.approx(up[end], rel=1e-8) and density_limits(par)[1] == pytest.approx(rho0 / (1 - eta[end]), rel=1e-4)
    chosen = slice(end // 40, int(0.999 * end), end // 40)
    found = hugoniot.shock(par, particle_velocity=up[chosen])
    assert found.shock_velocity == pytest.approx(up[chosen] / eta[chosen], rel=1e-9)
    with pytest.raises(OutOfRange, match=f"particle velocity {up[end]:.6g} m/s"):
        hugoniot.shock(par, particle_velocity=1.01 * up[end])


def test_quadratic_and_cubic_reduce_to_linear():
    quadratic = MieGruneisenQuadratic(2785.0, 5328.0, 1.338, 0.0, 2.0, 0.48, 863.0)
    cubic = MieGruneisenCubic(2785.0, 5328.0, 1.338, 0.0, 0.0, 2.0, 0.48, 863.0)
    linear = MieGruneisenLinearGamma(2785.0, 5328.0, 1.338, 2.0, 0.48, 863.0)
    for rho in (1500.0, 2700.0, 3000.0, 4500.0):
        for other in (quadratic, cubic):
            assert pressure(rho, 3e6, other) == pytest.approx(pressure(rho, 3e6, linear), rel=1e-13)
            assert temperature(rho, 3e6, other) == pytest.approx(temperature(rho, 3e6, linear), rel=1e-11)
    assert temperature(4500.0, 3e6, linear._replace(gamma_slope=0.0)) == pytest.approx(temperature(4500.0, 3e6, ALUMINIUM), rel=1e-12)


def test_pyko_reference_value_b16():
    """The density is known to 5e-8 kg/m3, which is 1.4 Pa."""
    par = MieGruneisenLinearGamma(2790.0, 5330.0, 1.34, 2.0, 2.0)
    assert pressure(2802.7397260, 438.933, par) == pytest.approx(0.3655008605e9, abs=2.0)


def test_isentrope_slope_on_the_hugoniot_s_e5():
    """dp_S/dv on the Hugoniot of aluminium at 3200 kg/m3: -4.40141e14, not the printed -3.565e14; i^2 = f_H(-p_H') + rhoGamma p_H/2."""
    rho = 3200.0
    eta = 1.0 - 2785.0 / rho
    k = 2785.0 * 5328.0**2
    p_h = k * eta / (1 - 1.338 * eta) ** 2
    slope = -2785.0 * k * (1 + 1.338 * eta) / (1 - 1.338 * eta) ** 3
    corrected = (1 - eta) * slope - 0.5 * 2785.0 * 2.0 * p_h
    e_h = p_h * eta / (2 * 2785.0)
    assert corrected == pytest.approx(-4.40141e14, rel=1e-5)
    assert -rho * rho * sound_speed_squared(rho, e_h, ALUMINIUM) == pytest.approx(corrected, rel=1e-12)


@pytest.mark.parametrize("par", [ALUMINIUM, MieGruneisenLinearGamma(2785.0, 5328.0, 1.338, 2.0, 0.48),
                                 MieGruneisenQuadratic(2785.0, 5328.0, 1.338, 3e-5, 2.0), MieGruneisenCubic(2785.0, 5328.0, 1.338, 0.2, 0.1, 2.0)],
                         ids=lambda p: type(p).__name__)
def test_pressure_slope_and_curvature_are_continuous_at_rest(par):
    h = 1e-3
    for e in (0.0, 1e5):
        # e couples to the reference curve through Gamma alone, which is smooth
        left, right = (pressure_derivatives(2785.0 + sign * 1e-9, e, par)[0] for sign in (-1, 1))
        assert left == pytest.approx(right, rel=1e-11)
        below = (pressure_derivatives(2785.0 - h, e, par)[0] - pressure_derivatives(2785.0 - 2 * h, e, par)[0]) / h
        above = (pressure_derivatives(2785.0 + 2 * h, e, par)[0] - pressure_derivatives(2785.0 + h, e, par)[0]) / h
        assert below == pytest.approx(above, rel=3e-4)


def test_tension_is_bounded_and_stable_at_every_expansion():
    bound = 3 * 2785.0 * 5328.0**2 / (8 * 1.338)
    for rho in np.geomspace(2784.0, 20.0, 60):
        e_s, _ = reference_isentrope(rho, ALUMINIUM)
        assert -bound < pressure(rho, e_s, ALUMINIUM) < 0.0
        for heat in (0.0, 1e4, 1e6):
            assert sound_speed_squared(rho, e_s + heat, ALUMINIUM) > 0.0


def test_tension_curve_is_an_isentrope():
    for rho in (2700.0, 2000.0, 700.0):
        h = 1e-4 * rho
        slope = (reference_isentrope(rho + h, ALUMINIUM)[0] - reference_isentrope(rho - h, ALUMINIUM)[0]) / (2 * h)
        assert pressure(rho, reference_isentrope(rho, ALUMINIUM)[0], ALUMINIUM) == pytest.approx(rho * rho * slope, rel=1e-6)


@pytest.mark.parametrize("s, gamma0", [(1.338, 2.0), (1.49, 1.99), (0.9736, 0.3), (0.4045, 0.3), (2.5, 0.2), (0.26, 2.0)])
def test_temperature_in_compression_against_quadrature(s, gamma0):
    par = MieGruneisen(2785.0, 5328.0, s, gamma0, 863.0)
    for rho in (2800.0, 3500.0, 4400.0):
        eta = 1.0 - 2785.0 / rho
        exact, _ = quad(lambda t, eta=eta: math.exp(gamma0 * (eta - t)) * 5328.0**2 * t * (1 - gamma0 * t / 2) / (1 - s * t) ** 2, 0.0, eta,
                        epsabs=0.0, epsrel=1e-13)
        t = 298.15 * math.exp(gamma0 * eta) + (5e6 - exact) / 863.0
        assert temperature(rho, 5e6, par) == pytest.approx(t, abs=1e-7)


def test_temperature_with_linear_gamma_against_quadrature():
    par = MieGruneisenLinearGamma(2785.0, 5328.0, 1.338, 2.0, 2.0, 863.0)
    for rho in (3000.0, 5000.0, 9000.0):
        eta = 1.0 - 2785.0 / rho

        def integrand(t):
            return (1 - t) ** 2 * 5328.0**2 * t * (1 - 0.5 * t * (2.0 / (1 - t))) / (1 - 1.338 * t) ** 2

        exact = quad(integrand, 0.0, eta, epsabs=0.0, epsrel=1e-13)[0] * (1 - eta) ** -2
        assert temperature(rho, 1e7, par) == pytest.approx(298.15 * (1 - eta) ** -2 + (1e7 - exact) / 863.0, rel=1e-11)


def test_shocked_water_temperature_and_entropy():
    """A5: exact jump for water, rho Gamma constant, c_v = 1385, gamma0 = 0.15, from 300 K: 321.8 and 425.9 K, 61 and 429 J/(kg K)."""
    water = MieGruneisen(1000.0, 1450.0, 1.99, 0.15, 1385.0, 300.0)
    for up, us, p, rho, t, s in ((387.5, 2221.1, 0.8607e9, 1211.3, 321.8, 61.0), (858.0, 3157.4, 2.7091e9, 1373.1, 425.9, 429.0)):
        state = shock(water, 1450.0 + 1.99 * up, up)
        assert 1450.0 + 1.99 * up == pytest.approx(us, rel=2e-5)
        assert state[2] == pytest.approx(p, rel=5e-5)
        assert state[0] == pytest.approx(rho, rel=5e-5)
        assert temperature(state[0], state[1], water) == pytest.approx(t, abs=0.06)
        assert entropy(state[0], state[1], water) == pytest.approx(s, abs=0.6)


@pytest.mark.parametrize("z", [1e-8, 0.3, 2.0, 5.0, 8.0])
def test_ein_series(z):
    assert special.ein(z) == pytest.approx(float(expi(z)) - np.euler_gamma - math.log(z), rel=1e-14, abs=1e-15)


def test_density_limit_is_the_pole():
    assert density_limits(ALUMINIUM)[1] == pytest.approx(2785.0 / (1 - 1 / 1.338))
    assert density_limits(MieGruneisenCubic(2785.0, 5328.0, 1.338, 0.0, 0.0, 2.0))[1] == pytest.approx(density_limits(ALUMINIUM)[1])
    steep = MieGruneisenQuadratic(2785.0, 5328.0, 1.338, 1e-5, 2.0)
    assert 1 - 2785.0 / density_limits(steep)[1] == pytest.approx(1 / (1.338 + 2 * math.sqrt(5328.0 * 1e-5)))


def test_fits_with_s_below_one_state_their_velocity_limit_j_e16():
    assert particle_velocity_limit(MieGruneisen(100.0, 121.0, 0.9736, 0.3)) == pytest.approx(4583.0, abs=0.5)
    assert particle_velocity_limit(MieGruneisenLinearGamma(250.0, 1070.7, 0.4045, 0.3, 0.1)) == pytest.approx(1798.0, abs=0.5)
    assert particle_velocity_limit(ALUMINIUM) == math.inf
    assert density_limits(MieGruneisen(100.0, 121.0, 0.9736, 0.3))[1] == math.inf
    bent = MieGruneisenQuadratic(7856.0, 3531.0, 1.914, -6.06e-5, 1.69)
    assert particle_velocity_limit(bent) == pytest.approx(1.914 / (2 * 6.06e-5))
    assert particle_velocity_limit(MieGruneisenQuadratic(100.0, 121.0, 0.9, -1e-5, 0.3)) == pytest.approx(
        max(np.roots([-1e-5, -0.1, 121.0])))


def test_deck_forms_of_gamma():
    constant = build(2785.0, 5328.0, 1.338, 2.0, gamma_form="constant")
    linear = build(2785.0, 5328.0, 1.338, 2.0, gamma_form="linear", gamma_slope=0.48)
    assert gruneisen(4000.0, 1e6, constant) == pytest.approx(2.0, rel=1e-14)
    mu = 4000.0 / 2785.0 - 1
    assert gruneisen(4000.0, 1e6, linear) == pytest.approx((2.0 + 0.48 * mu) / (1 + mu), rel=1e-14)
    assert gruneisen(4000.0, 1e6, build(2785.0, 5328.0, 1.338, 2.0)) == pytest.approx(2.0 * 2785.0 / 4000.0, rel=1e-14)
    assert repr(build(2785.0, 5328.0, 1.338, 2.0, gamma_slope=0.48)) == repr(linear)
    assert EOS.of(build(2785.0, 5328.0, 0.2, 2.0)).name == "mie_gruneisen_linear_gamma"


LEAD = {"rho0": 11340.0, "c0": 2006.0, "s1": 1.429, "s2": 0.8506, "s3": -1.64, "gamma0": 2.77}


@pytest.mark.parametrize("law, values", [("mie_gruneisen", {"rho0": 2785.0, "c0": 5328.0, "s": 1.338, "gamma0": 2.77}),
                                         ("mie_gruneisen_cubic", LEAD)])
def test_a_form_of_gamma_refuses_a_slope_that_contradicts_it(law, values):
    """A slope alone is linear; beside a form that is written out it used to win over rho_gamma_constant and to be ignored by constant."""
    make = EOS.get(law).build
    assert gruneisen(2.0 * values["rho0"], 1e6, make(**values, gamma_slope=0.54)) == pytest.approx((2.77 + 0.54) / 2.0, rel=1e-14)
    for form, slope in (("rho_gamma_constant", 0.0), ("constant", 2.77)):
        expected = pytest.approx((2.77 + slope) / 2.0, rel=1e-14)
        for given in ({}, {"gamma_slope": 0.0}, {"gamma_slope": slope}):      # 0: that of a library material without a slope
            assert gruneisen(2.0 * values["rho0"], 1e6, make(**values, gamma_form=form, **given)) == expected
        with pytest.raises(OutOfRange, match=f"gamma_form = '{form}' means gamma_slope = {slope:g}, but gamma_slope is 0.54"):
            make(**values, gamma_form=form, gamma_slope=0.54)


@pytest.mark.parametrize("change, message", [({"gamma_form": "quadratic"}, "unknown gamma_form 'quadratic'"), ({"gamma_form": "linear"}, "gamma_slope"),
                                             ({"rho0": -1.0}, "rho0 must be positive"), ({"s": -0.5}, "s >= 0"), ({"gamma0": 0.0}, "gamma0 > 0")])
def test_bad_parameters_are_refused(change, message):
    with pytest.raises(OutOfRange, match=message):
        build(**({"rho0": 2785.0, "c0": 5328.0, "s": 1.338, "gamma0": 2.0} | change))
