"""Cold-curve solids, Davis and Tillotson laws against independent integrals, definitions and limits."""

import math

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq

from hugoniot.errors import OutOfRange
from hugoniot.laws.eos import birch_murnaghan, murnaghan, tait, vinet
from hugoniot.laws.eos.contract import (
    EOS,
    check_state,
    gruneisen,
    pressure,
    pressure_derivatives,
    reference_isentrope,
    sound_speed_squared,
    temperature,
)
from hugoniot.laws.eos.davis_products import DavisProducts
from hugoniot.laws.eos.davis_reactants import DavisReactants
from hugoniot.laws.eos.tillotson import Tillotson

CURVES = [murnaghan.Murnaghan(2785.0, 76e9, 4.3, 2.0, 0.0, 863.0), tait.Tait(998.0, 0.2996e9, 0.1368, 0.12, 0.0, 4180.0),
          vinet.Vinet(8930.0, 137e9, 5.48, 1.99, 0.0, 385.0), birch_murnaghan.BirchMurnaghan(7874.0, 166e9, 5.3, 1.7, 0.0, 450.0)]
FORMULA = {
    "murnaghan": lambda x: 76e9 / 4.3 * (x**4.3 - 1),
    "tait": lambda x: 0.2996e9 * (math.exp((1 - 1 / x) / 0.1368) - 1),
    "vinet": lambda x: 3 * 137e9 * (1 - x ** (-1 / 3)) * x ** (2 / 3) * math.exp(1.5 * 4.48 * (1 - x ** (-1 / 3))),
    "birch_murnaghan": lambda x: 1.5 * 166e9 * (x ** (7 / 3) - x ** (5 / 3)) * (1 + 0.75 * 1.3 * (x ** (2 / 3) - 1)),
}
PBX_9502 = DavisReactants(1890.0, 1800.0, 4.6, 0.34, 0.56, 0.0, 0.4265, 4.115e6, 1074.0, 297.0)
PBX_9502_PRODUCTS = DavisProducts(0.798311, 0.58, 1.35, 2.66182, 0.75419e-3, 3.2e9, 1890.0, 4.115e6, 1072.0)
ROCK = Tillotson(2700.0, 0.5, 1.63, 75.2e9, 65e9, 5.0, 5.0, 5e6, 3e6, 13.9e6)


@pytest.mark.parametrize("par", CURVES, ids=lambda par: EOS.of(par).name)
@pytest.mark.parametrize("x", [0.96, 1.05, 1.4, 1.9])
def test_cold_pressure_and_energy(par, x):
    """On the curve p is the textbook form and e its integral p d(rho)/rho^2."""
    curve = FORMULA[EOS.of(par).name]
    e, _ = quad(lambda y: curve(y) / (par.rho0 * y * y), 1.0, x, epsabs=0.0, epsrel=1e-12)
    assert reference_isentrope(x * par.rho0, par)[0] == pytest.approx(e, rel=1e-11)
    assert pressure(x * par.rho0, e, par) == pytest.approx(curve(x), rel=1e-11)
    assert temperature(x * par.rho0, e, par) == pytest.approx(298.15 * math.exp(par.gamma0 * (1 - 1 / x)), rel=1e-10)


@pytest.mark.parametrize("par", CURVES, ids=lambda par: EOS.of(par).name)
def test_bulk_modulus_and_its_slope_at_rest(par):
    """K0 and K0' of the isentrope; the Tait curve has K0 = B/C and K0' = 1/C - 1 ... + ... = (1 - C)/C + ... from its own form."""
    curve = FORMULA[EOS.of(par).name]
    h = 1e-4
    k0 = (curve(1 + h) - curve(1 - h)) / (2 * h)
    assert par.rho0 * sound_speed_squared(par.rho0, 0.0, par) == pytest.approx(k0, rel=1e-6)
    expected = {"murnaghan": 4.3, "vinet": 5.48, "birch_murnaghan": 5.3, "tait": 1 / 0.1368 - 1}[EOS.of(par).name]
    bulk = [(1 + s * h) * (curve(1 + s * h + 1e-5) - curve(1 + s * h - 1e-5)) / 2e-5 for s in (-1, 1)]
    assert (bulk[1] - bulk[0]) / (curve(1 + h) - curve(1 - h)) == pytest.approx(expected, rel=2e-4)


@pytest.mark.parametrize("law", ["murnaghan", "tait", "vinet", "birch_murnaghan"])
def test_deck_forms_of_gamma(law):
    values = {**EOS.get(law).example._asdict(), "gamma_form": "constant"}
    values.pop("gamma_slope")
    par = EOS.get(law).build(**values)
    assert gruneisen(1.3 * par.rho0, 1e6, par) == pytest.approx(par.gamma0, rel=1e-13)


def test_davis_reactants_isentrope_is_one():
    """On the principal isentrope de/drho = p/rho^2, T and entropy as stated, on both sides of rest."""
    law = EOS.of(PBX_9502)
    for rho in (1800.0, 2000.0, 2600.0, 3400.0):
        y = 1 - 1890.0 / rho
        scale = 1890.0 * 1800.0**2 / (4 * 4.6)

        def p_s(t, scale=scale):
            if t < 0:
                return scale * (math.exp(18.4 * t) - 1)
            terms = sum((18.4 * t) ** j / math.factorial(j) for j in (1, 2, 3))
            return scale * (terms + 0.34 * (18.4 * t) ** 4 / 24 + t * t / (1 - t) ** 4)

        e = 4.115e6 + quad(p_s, 0.0, y, epsabs=0.0, epsrel=1e-12)[0] / 1890.0
        assert pressure(rho, e, PBX_9502) == pytest.approx(p_s(y), rel=1e-10)
        assert temperature(rho, e, PBX_9502) == pytest.approx(297.0 * (1 - y) ** -0.56, rel=1e-9)
        assert law.functions["entropy"](rho, e, PBX_9502) == pytest.approx(0.0, abs=1e-6)


def test_davis_reactants_specific_heat_grows_as_t_to_the_alpha():
    t_s = temperature(1890.0, 4.115e6, PBX_9502)
    e = 4.115e6 + quad(lambda t: 1074.0 * (t / t_s) ** 0.4265, t_s, 1200.0, epsrel=1e-12)[0]
    assert temperature(1890.0, e, PBX_9502) == pytest.approx(1200.0, rel=1e-11)


def test_davis_products_expand_to_a_gas_and_detonate_like_pbx_9502():
    """Gamma tends to k - 1 at large volume; the CJ state of the published constants is that of PBX 9502: 7.7 km/s and 28.5 GPa within 3 %."""
    assert gruneisen(1.0, 3e6, PBX_9502_PRODUCTS) == pytest.approx(0.35, abs=1e-6)
    v0, e0 = 1 / 1890.0, 4.115e6

    def p_h(v):
        a, b = pressure(1 / v, 0.0, PBX_9502_PRODUCTS), pressure_derivatives(1 / v, 0.0, PBX_9502_PRODUCTS)[1]
        return (a + b * e0) / (1 - 0.5 * b * (v0 - v))

    def gap(v):
        p = p_h(v)
        return sound_speed_squared(1 / v, e0 + 0.5 * p * (v0 - v), PBX_9502_PRODUCTS) / v**2 - p / (v0 - v)

    v = brentq(gap, 0.6 * v0, 0.9 * v0, xtol=1e-18)
    assert v0 * math.sqrt(p_h(v) / (v0 - v)) == pytest.approx(7700.0, rel=0.03)
    assert p_h(v) == pytest.approx(28.5e9, rel=0.03)


def test_davis_products_isentrope():
    """e_s of the paper's closed form: p_s = -de_s/dv by central difference, T_s on it."""
    def e_s(v):
        w = v / 0.75419e-3
        d = 0.5 * (w**2.66182 + w**-2.66182)
        return 3.2e9 * 0.75419e-3 / (0.35 + 0.798311) * d ** (0.798311 / 2.66182) / w ** (0.35 + 0.798311)

    for v in (0.35e-3, 0.75419e-3, 5e-3):
        h = 1e-5 * v
        p = -(e_s(v + h) - e_s(v - h)) / (2 * h)
        assert pressure(1 / v, e_s(v), PBX_9502_PRODUCTS) == pytest.approx(p, rel=1e-8)
    t_c = 2 ** (-0.798311 * 0.58 / 2.66182) / (0.35 + 0.798311) * 3.2e9 * 0.75419e-3 / 1072.0
    assert temperature(1 / 0.75419e-3, e_s(0.75419e-3), PBX_9502_PRODUCTS) == pytest.approx(t_c, rel=1e-12)


def test_tillotson_is_continuous_on_every_border():
    for e in (1e6, 2.9e6, 5e6, 1.39e7, 3e7):
        assert pressure(2700.0 - 1e-9, e, ROCK) == pytest.approx(pressure(2700.0, e, ROCK), rel=1e-9)
    for rho in (300.0, 1500.0, 2600.0):
        for e in (3e6, 13.9e6):
            assert pressure(rho, e * (1 - 1e-12), ROCK) == pytest.approx(pressure(rho, e * (1 + 1e-12), ROCK), rel=1e-9, abs=1.0)


def test_tillotson_limits():
    """Cold solid: K0 = A, Gamma0 = a + b; hot vapour: an ideal gas of Gamma = a."""
    assert 2700.0 * sound_speed_squared(2700.0, 0.0, ROCK) == pytest.approx(75.2e9, rel=1e-12)
    assert gruneisen(2700.0, 0.0, ROCK) == pytest.approx(2.13, rel=1e-12)
    assert pressure(10.0, 1e8, ROCK) == pytest.approx(0.5 * 10.0 * 1e8, rel=1e-12)
    with pytest.raises(OutOfRange, match="unstable"):
        check_state(1300.0, 1e5, ROCK)


def test_tillotson_derivatives_in_every_branch():
    h = 1e-5
    for rho, e in ((1500.0, 1e6), (1500.0, 8e6), (1500.0, 3e7), (4000.0, 8e6), (20.0, 5e7)):
        p_rho, p_e = pressure_derivatives(rho, e, ROCK)
        assert (pressure(rho * (1 + h), e, ROCK) - pressure(rho * (1 - h), e, ROCK)) / (2 * h * rho) == pytest.approx(p_rho, rel=1e-6)
        assert (pressure(rho, e * (1 + h), ROCK) - pressure(rho, e * (1 - h), ROCK)) / (2 * h * e) == pytest.approx(p_e, rel=1e-6)


def test_murnaghan_and_birch_murnaghan_agree_at_small_compression():
    """Same K0 and K0': the curves part at third order."""
    a = murnaghan.Murnaghan(7874.0, 166e9, 5.3, 1.7)
    b = birch_murnaghan.BirchMurnaghan(7874.0, 166e9, 5.3, 1.7)
    gaps = [abs(pressure(7874.0 * (1 + x), 0.0, a) - pressure(7874.0 * (1 + x), 0.0, b)) for x in (0.02, 0.01)]
    assert np.log2(gaps[0] / gaps[1]) == pytest.approx(3.0, abs=0.1)
