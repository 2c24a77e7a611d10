"""Source Starkenberg, appendix A, laws A-7 to A-10 in the corrected forms (S-E6 to S-E14), and published CJ states (A6)."""

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from hugoniot.laws.eos.contract import (
    adiabatic_exponent,
    energy,
    entropy,
    pressure,
    pressure_derivatives,
    reference_state,
    sound_speed_squared,
    temperature,
)
from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.laws.eos.jwl import JWL
from hugoniot.laws.eos.jwl_proportional import JWLProportional
from hugoniot.laws.eos.jwl_unreacted import JWLUnreacted
from hugoniot.laws.eos.mie_gruneisen_linear_gamma import MieGruneisenLinearGamma
from hugoniot.laws.eos.stiffened_gas import StiffenedGas

AIR = IdealGas(1.4, 717.5)
WATER = StiffenedGas(4.4, 6e8, 1000.0, 1400.0)
COMP_B = JWL(524.23e9, 7.678e9, 4.2, 1.1, 0.34, 1717.0, 8.5e9, 1000.0)
SOLID = JWLProportional(77810e9, -5.031e9, 11.3, 1.13, 0.8938, 1717.0, 1000.0)


def hugoniot_pressure(v, p_u, v_u, e_u, par):
    """p on the Hugoniot from (p_u, v_u, e_u) for a law linear in energy: the jump condition solved with no formula of the source."""
    a, b = pressure(1 / v, 0.0, par), pressure_derivatives(1 / v, 0.0, par)[1]
    return (a + b * (e_u + 0.5 * p_u * (v_u - v))) / (1.0 - 0.5 * b * (v_u - v))


def test_ideal_gas_a7():
    v_u, p_u = 1 / 1.2, 101325.0
    e_u = energy(1 / v_u, p_u, AIR)
    for v in (0.9 * v_u, 0.4 * v_u, 0.2 * v_u):
        formula = ((1.4 + 1) * v_u - 0.4 * v) / (2.4 * v - 0.4 * v_u) * p_u
        assert hugoniot_pressure(v, p_u, v_u, e_u, AIR) == pytest.approx(formula, rel=1e-13)
    assert adiabatic_exponent(3.0, 5e5, AIR) == pytest.approx(1.4, rel=1e-14)
    assert temperature(1.2, e_u, AIR) == pytest.approx(p_u * v_u / (0.4 * 717.5), rel=1e-14)


def test_stiffened_gas_a8_corrected():
    """S-E6: exponent gamma(gamma - 1)(P v + e)/[gamma(P v + e) - e]; S-E7: denominator (g + 1) v - (g - 1) v_u; p_inf = -P (S-E8)."""
    g, p_inf = 4.4, -6e8
    rho, e = 1300.0, 1.2e6
    v = 1 / rho
    corrected = g * (g - 1) * (p_inf * v + e) / (g * (p_inf * v + e) - e)
    printed = g * (g - 1) * (p_inf * v + e) / (g * (p_inf * v + e) + e)
    assert adiabatic_exponent(rho, e, WATER) == pytest.approx(corrected, rel=1e-13)
    assert abs(printed / corrected - 1) > 0.3
    v_u, p_u = 1e-3, 1e5
    e_u = energy(1000.0, p_u, WATER)
    for v in (0.95e-3, 0.8e-3):
        formula = (((g + 1) * v_u - (g - 1) * v) * p_u - 2 * g * p_inf * (v_u - v)) / ((g + 1) * v - (g - 1) * v_u)
        assert hugoniot_pressure(v, p_u, v_u, e_u, WATER) == pytest.approx(formula, rel=1e-13)
    # S-E9: e_o = R T_o - p_inf v_o with R = c_v of A-4 (w = 1)
    assert temperature(1000.0, 1400.0 * 300.0 + 6e8 * 1e-3, WATER) == pytest.approx(300.0, rel=1e-14)


@pytest.mark.parametrize("par, low, high", [(AIR, 0.5, 3.0), (WATER, 800.0, 1500.0), (COMP_B, 300.0, 2400.0), (SOLID, 1717.0, 3000.0)],
                         ids=["ideal_gas", "stiffened_gas", "jwl", "jwl_proportional"])
def test_isentropes_by_integration_keep_the_entropy(par, low, high):
    e0 = reference_state(par)[1] + (2e6 if par is COMP_B else 3e5)
    path = solve_ivp(lambda rho, e: pressure(rho, e[0], par) / rho**2, (low, high), [e0], rtol=1e-12, atol=1e-6, method="DOP853")
    start, end = (entropy(float(path.t[k]), float(path.y[0, k]), par) for k in (0, -1))
    assert end == pytest.approx(start, abs=1e-9 * par.specific_heat)


def test_jwl_sound_speed_a9_s_e10():
    """Comp B at 2000 kg/m3, 5 MJ/kg: c^2 = 2.7745e7; the printed prefactor 1/(w(w + 1)) gives 1.337e8."""
    w, v = COMP_B.omega, 1717.0 / 2000.0
    e1, e2 = COMP_B.a / COMP_B.r1 / 1717.0, COMP_B.b / COMP_B.r2 / 1717.0
    x1, x2 = COMP_B.r1 * v, COMP_B.r2 * v
    bracket = e1 * (x1**2 / (w * (w + 1)) - 1) * math.exp(-x1) + e2 * (x2**2 / (w * (w + 1)) - 1) * math.exp(-x2) + 5e6
    c2 = sound_speed_squared(2000.0, 5e6, COMP_B)
    assert c2 == pytest.approx(w * (w + 1) * bracket, rel=1e-13)
    assert c2 == pytest.approx(2.7745e7, rel=2e-5)
    assert bracket / (w * (w + 1)) == pytest.approx(1.337e8, rel=1e-3)


def test_jwl_hugoniot_a9_s_e11():
    v_u, p_u, e_u = 1 / 1717.0, 1e9, 8.5e9 / 1717.0
    for v in (0.9 * v_u, 0.7 * v_u):
        dv = v_u - v
        formula = (2 * (pressure(1 / v, 0.0, COMP_B) + 0.34 / v * e_u) * v + 0.34 * dv * p_u) / (2 * v - 0.34 * dv)
        assert hugoniot_pressure(v, p_u, v_u, e_u, COMP_B) == pytest.approx(formula, rel=1e-13)


@pytest.mark.parametrize("a, b, r1, r2, omega, rho0, e0, d, p", [
    (524.2e9, 7.678e9, 4.2, 1.1, 0.34, 1717.0, 8.5e9, 7980.0, 29.500e9), (852.4e9, 18.02e9, 4.6, 1.3, 0.38, 1840.0, 10.2e9, 8800.1, 37.001e9),
    (371.2e9, 3.231e9, 4.15, 0.95, 0.3, 1630.0, 7.0e9, 6929.4, 21.000e9), (446e9, 1.339e9, 3.85, 1.03, 0.46, 1900.0, 6.9e9, 7589.6, 29.894e9),
    (617e9, 16.926e9, 4.4, 1.2, 0.25, 1770.0, 10.1e9, 8300.8, 33.509e9)], ids=["comp_b", "pbx_9404", "tnt", "lx_17", "petn"])
def test_jwl_sets_close_on_their_cj_state(a, b, r1, r2, omega, rho0, e0, d, p):
    """A6: tangency of Rayleigh line and Hugoniot, m^2 = rho^2 c^2 on the Hugoniot of the products."""
    par = JWL(a, b, r1, r2, omega, rho0, e0)
    v0, e_rest = 1 / rho0, e0 / rho0

    def gap(v):
        p_h = hugoniot_pressure(v, 0.0, v0, e_rest, par)
        return sound_speed_squared(1 / v, e_rest + 0.5 * p_h * (v0 - v), par) / v**2 - p_h / (v0 - v)

    v = brentq(gap, 0.6 * v0, 0.9 * v0, xtol=1e-18, rtol=1e-15)
    p_cj = hugoniot_pressure(v, 0.0, v0, e_rest, par)
    assert p_cj == pytest.approx(p, rel=2e-4)
    assert v0 * math.sqrt(p_cj / (v0 - v)) == pytest.approx(d, rel=2e-5)


def test_jwl_proportional_a10_corrected():
    """i^2 of A-10.3; Hugoniot with the energy counted once (S-E12), e.g. from a compressed and heated state."""
    par, v = SOLID, 1 / 2300.0
    r_g, n1, n2 = 1717.0 * 0.8938, 11.3 * 1717.0, 1.13 * 1717.0
    e1, e2, e = 77810e9 / n1, -5.031e9 / n2, 2e6
    i2 = e1 * (n1 - r_g) * (n1 + r_g) * math.exp(-n1 * v) + e2 * (n2 - r_g) * (n2 + r_g) * math.exp(-n2 * v) + r_g**2 * e
    assert sound_speed_squared(1 / v, e, par) == pytest.approx(v * v * i2, rel=1e-13)
    v_u, e_u = 1 / 1800.0, 4e5
    p_u = pressure(1 / v_u, e_u, par)
    p_g = e1 * (n1 - r_g) * math.exp(-n1 * v) + e2 * (n2 - r_g) * math.exp(-n2 * v)
    jump = (p_g - p_u + r_g * (e_u + p_u * (v_u - v))) / (1 - 0.5 * r_g * (v_u - v))
    p_h = p_u + jump
    assert p_h == pytest.approx(hugoniot_pressure(v, p_u, v_u, e_u, par), rel=1e-13)
    assert pressure(1 / v, e_u + 0.5 * (p_u + p_h) * (v_u - v), par) == pytest.approx(p_h, rel=1e-12)


@pytest.mark.parametrize("slope", [0.0, 0.48, 2.0])
def test_hugoniot_from_any_upstream_state_a11_5(slope):
    """Second shocks and preheated starts: the printed form against the jump condition, for every form of Gamma of A-6."""
    par, v_a = MieGruneisenLinearGamma(2785.0, 5328.0, 1.338, 2.0, slope), 1 / 2785.0
    v_u, e_u = 1 / 3000.0, 6e5
    p_u = pressure(1 / v_u, e_u, par)
    for v in (1 / 3300.0, 1 / 4000.0):
        rho_g = pressure_derivatives(1 / v, 0.0, par)[1]
        eta = 1 - 2785.0 * v
        p_a = 2785.0 * 5328.0**2 * eta / (1 - 1.338 * eta) ** 2
        f_a, f_u = 1 - 0.5 * rho_g * (v_a - v), 1 - 0.5 * rho_g * (v_u - v)
        formula = (f_a * p_a + (1 - f_u) * p_u + rho_g * e_u) / f_u
        assert hugoniot_pressure(v, p_u, v_u, e_u, par) == pytest.approx(formula, rel=1e-12)


@pytest.mark.parametrize("slope", [0.0, 0.48, 2.0])
def test_acoustic_impedance_with_linear_gamma_a6(slope):
    """i^2 from p_Gamma and the Gamma of A-6, Gamma_o = b and rho_Gamma_o = rho0 (gamma0 - b)."""
    par, v, e = MieGruneisenLinearGamma(2785.0, 5328.0, 1.338, 2.0, slope), 1 / 3500.0, 4e6
    g_o, r_o, h = slope, 2785.0 * (2.0 - slope), 1e-5 * v
    p_slope = (pressure(1 / (v + h), 0.0, par) - pressure(1 / (v - h), 0.0, par)) / (2 * h)
    i2 = (r_o + g_o / v) * pressure(1 / v, 0.0, par) - p_slope + (r_o**2 + 2 * g_o * r_o / v + g_o * (g_o + 1) / v**2) * e
    assert sound_speed_squared(1 / v, e, par) == pytest.approx(v * v * i2, rel=1e-8)
    # A-4 with w = 1: entropy by the integrating factor f_S = (v/v0)^Gamma_o exp[rho_Gamma_o (v - v0)]
    full = par._replace(specific_heat=863.0)
    f_s = (v * 2785.0) ** g_o * math.exp(r_o * (v - 1 / 2785.0))
    assert entropy(1 / v, e, full) == pytest.approx(863.0 * math.log(temperature(1 / v, e, full) * f_s / 298.15), rel=1e-10)


def test_unreacted_jwl_rests_at_zero_pressure():
    """LX-17 of Lee and Tarver's set: the same pressures as the law jwl; the set closes on 298 K (A e^-R1 + B e^-R2 + w rho0 c_v T = 0)."""
    par = JWLUnreacted(77810e9, -5.031e9, 11.3, 1.13, 0.8938, 1905.0, 1305.5)
    products = JWL(*par[:6])
    assert pressure(2300.0, 1e6, par) == pressure(2300.0, 1e6, products)
    rho, e = reference_state(par)
    assert pressure(rho, e, par) == pytest.approx(0.0, abs=1e-4)
    assert temperature(rho, e, par) == pytest.approx(298.15, rel=1e-12)
    closing = (par.a * math.exp(-11.3) + par.b * math.exp(-1.13)) / (0.8938 * 1905.0 * 1305.5)
    assert -closing == pytest.approx(298.0, abs=0.1)


@pytest.mark.parametrize("shock", [1.0, 0.9, 0.72, 0.6], ids="V={}".format)
def test_an_unreacted_jwl_with_negative_b_keeps_its_greatest_tension_when_torn(shock):
    """Released from shocks of up to 60 GPa to four times its volume: before, the sound speed was imaginary from V = 1.2 or so on."""
    par = JWL(77810e9, -5.031e9, 11.3, 1.13, 0.8938, 1905.0, -6.1189e8, 1305.5)

    def cold(v):
        return par.a * math.exp(-par.r1 * v) + par.b * math.exp(-par.r2 * v)

    torn = brentq(lambda v: par.a * par.r1 * math.exp(-par.r1 * v) + par.b * par.r2 * math.exp(-par.r2 * v), 1.0, 2.0, xtol=1e-15)
    assert torn == pytest.approx(1.1749254, rel=1e-7)
    v_u, e_u = 1.0 / par.rho0, par.e0 / par.rho0
    p_h = hugoniot_pressure(shock * v_u, pressure(par.rho0, e_u, par), v_u, e_u, par) if shock < 1.0 else pressure(par.rho0, e_u, par)
    start = e_u + 0.5 * (p_h + pressure(par.rho0, e_u, par)) * (1.0 - shock) * v_u
    path = solve_ivp(lambda v, e: -pressure(par.rho0 / v, e[0], par) * v_u, (shock, 4.0), [start], rtol=1e-12, atol=1e-6, method="DOP853",
                     t_eval=np.linspace(shock, 4.0, 60))
    states = [(par.rho0 / v, e) for v, e in zip(path.t.tolist(), path.y[0].tolist())]
    falling = [pressure(rho, e, par) for rho, e in states]
    assert all(sound_speed_squared(rho, e, par) > 0.0 for rho, e in states) and all(np.diff(falling) < 0.0)
    assert [entropy(rho, e, par) for rho, e in states] == pytest.approx([entropy(*states[0], par)] * 60, abs=1e-7 * par.specific_heat)
    assert all(p > cold(torn) for p in falling)
    for v, p in zip(path.t, falling):     # cold pressure and the thermal one beside it, c_v T0 V^-(1 + omega) on the isentrope
        thermal = (falling[0] - cold(shock)) * (shock / v) ** (1.0 + par.omega)
        assert p == pytest.approx(cold(min(v, torn)) + thermal, abs=1e-6 * max(abs(falling[0]), 1e9))


def test_jwl_cold_constant_shifts_the_zero_isentrope():
    par = COMP_B._replace(cold_constant=3e5)
    for rho in (400.0, 1717.0):
        v = 1717.0 / rho
        e_c = (COMP_B.a / 4.2 * math.exp(-4.2 * v) + COMP_B.b / 1.1 * math.exp(-1.1 * v)) / 1717.0 + 3e5 * v**-0.34
        assert temperature(rho, e_c, par) == pytest.approx(0.0, abs=1e-9)
        # the zero isentrope is an isentrope: de/drho = p/rho^2
        h = 1e-5 * rho
        de = np.diff([(COMP_B.a / 4.2 * math.exp(-4.2 * 1717 / r) + COMP_B.b / 1.1 * math.exp(-1.1 * 1717 / r)) / 1717
                      + 3e5 * (1717 / r) ** -0.34 for r in (rho - h, rho + h)])[0] / (2 * h)
        assert de == pytest.approx(pressure(rho, e_c, par) / rho**2, rel=1e-8)
