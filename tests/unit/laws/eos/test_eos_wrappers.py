"""Laws made of a law: porosity, shifted energy, tension cut-off."""

import math

import numpy as np
import pytest
from scipy.optimize import brentq

from hugoniot.errors import OutOfRange
from hugoniot.laws.eos import p_alpha, p_lambda, snow_plough
from hugoniot.laws.eos.contract import density_limits, pressure, pressure_derivatives, reference_state, sound_speed_squared, temperature
from hugoniot.laws.eos.jwl import JWL
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.laws.eos.shifted_energy import ShiftedEnergy
from hugoniot.laws.eos.tension_cutoff import TensionCutoff
from hugoniot.laws.eos.tillotson import Tillotson

ALUMINIUM = MieGruneisen(2700.0, 5350.0, 1.34, 2.0, 863.0)
POROUS = p_alpha.build(ALUMINIUM, 1.275, 0.08e9, 0.7e9)


def hugoniot(par, rho, rho_start):
    """(p, e) on the Hugoniot from rest at rho_start by the jump condition, root found in e."""
    dv = 1 / rho_start - 1 / rho
    e = brentq(lambda e: e - 0.5 * pressure(rho, e, par) * dv, -1e5, 5e7, xtol=1e-6)
    return pressure(rho, e, par), e


def test_p_alpha_is_the_solid_above_compaction():
    for rho, e in ((2900.0, 1e6), (3500.0, 3e6)):
        assert pressure(rho, e, ALUMINIUM) > 0.7e9
        assert pressure(rho, e, POROUS) == pytest.approx(pressure(rho, e, ALUMINIUM), rel=1e-15)
        assert pressure_derivatives(rho, e, POROUS) == pytest.approx(pressure_derivatives(rho, e, ALUMINIUM), rel=1e-14)


def test_p_alpha_below_the_elastic_limit_keeps_its_pores():
    rho = 2700.0 / 1.275 * 1.0002
    assert pressure(rho, 0.0, POROUS) == pytest.approx(pressure(1.275 * rho, 0.0, ALUMINIUM) / 1.275, rel=1e-13)
    assert reference_state(POROUS) == (2700.0 / 1.275, 0.0)
    assert temperature(2700.0 / 1.275, 0.0, POROUS) == pytest.approx(298.15, rel=1e-12)


@pytest.mark.parametrize("rho", [2130.0, 2250.0, 2400.0, 2600.0])
def test_p_alpha_solves_its_own_equation(rho):
    """alpha(p) from the crush curve and alpha from the densities are the same number while the pores close."""
    p = pressure(rho, 2e4, POROUS)
    assert 0.08e9 < p < 0.7e9
    alpha = 1 + 0.275 * ((0.7e9 - p) / 0.62e9) ** 2
    assert pressure(alpha * rho, 2e4, ALUMINIUM) / alpha == pytest.approx(p, rel=1e-9)


def test_p_alpha_is_continuous_and_stable_through_compaction():
    densities = [2000.0 + k for k in range(900)]
    values = [pressure(r, 1e4, POROUS) for r in densities]
    assert all(b > a for a, b in zip(values, values[1:]))
    assert all(sound_speed_squared(r, 1e4, POROUS) > 0.0 for r in densities)


def test_strong_shock_forgets_how_the_pores_closed():
    """A porous Hugoniot well above compaction is the solid's law from the larger volume, in all three models."""
    start = 2700.0 / 1.275
    solid = hugoniot(ALUMINIUM, 3000.0, start)
    assert solid[0] > 5e9
    assert hugoniot(POROUS, 3000.0, start) == pytest.approx(solid, rel=1e-9)
    assert hugoniot(snow_plough.build(ALUMINIUM, start, 0.1e9), 3000.0, start) == pytest.approx(solid, rel=1e-9)
    assert hugoniot(p_lambda.build(ALUMINIUM, start, 25e9, 0.4e9, 1.0), 3000.0, start) == pytest.approx(solid, rel=1e-5)


def test_snow_plough_crushes_along_its_ramp():
    par = snow_plough.build(ALUMINIUM, 1600.0, 0.2e9)
    assert pressure(1600.0, 0.0, par) == 0.0
    assert pressure(2150.0, 0.0, par) == pytest.approx(0.1e9, rel=1e-12)
    assert pressure(2700.0, 5e5, par) == pressure(2700.0, 5e5, ALUMINIUM)
    assert reference_state(par) == (1600.0, 0.0)


@pytest.mark.parametrize("rho, e", [(2110.0, 0.0), (2300.0, 1e5), (2600.0, 3e5), (3000.0, 2e6), (2150.0, 4e6)])
def test_p_lambda_solves_its_own_equation(rho, e):
    par = p_lambda.build(ALUMINIUM, 2100.0, 25e9, 0.4e9, 1.2)
    p = pressure(rho, e, par)
    share = 1 - math.exp(-((p / 0.4e9) ** 1.2))
    solid = brentq(lambda r: pressure(r, e, ALUMINIUM) - p, 500.0, 6000.0, xtol=1e-10)
    assert share / solid + (1 - share) / (2100.0 * (1 + p / 25e9)) == pytest.approx(1 / rho, rel=1e-11)


def test_p_lambda_starts_elastic_and_bears_tension_elastically():
    par = p_lambda.build(ALUMINIUM, 2100.0, 25e9, 0.4e9, 2.0)
    assert 2100.0 * sound_speed_squared(2100.0 * (1 + 1e-9), 0.0, par) == pytest.approx(25e9, rel=1e-5)
    assert pressure(2000.0, 1e5, par) == pytest.approx(25e9 * (1 - 1.05), rel=1e-12)


def test_shifted_energy_moves_the_origin_only():
    products = JWL(371.2e9, 3.231e9, 4.15, 0.95, 0.3, 1630.0, 7.0e9, 613.5)
    shifted = ShiftedEnergy(products, 7.0e9 / 1630.0)
    for rho, e in ((1630.0, 0.0), (900.0, -1e6)):
        assert pressure(rho, e, shifted) == pressure(rho, e + 7.0e9 / 1630.0, products)
        assert temperature(rho, e, shifted) == temperature(rho, e + 7.0e9 / 1630.0, products)
    assert reference_state(shifted) == (1630.0, 0.0)
    assert density_limits(shifted) == density_limits(products)


def test_tension_cutoff():
    par = TensionCutoff(ALUMINIUM, 1e9)
    assert pressure(2690.0, 0.0, par) == pressure(2690.0, 0.0, ALUMINIUM)
    assert pressure(2000.0, 0.0, par) == -1e9
    assert pressure_derivatives(2000.0, 0.0, par) == (0.0, 0.0)
    assert temperature(2000.0, 1e5, par) == temperature(2000.0, 1e5, ALUMINIUM)


def test_a_wrapper_of_a_wrapper():
    """Porous material whose solid has a cut-off and a shifted origin: three laws deep, the same numbers."""
    deep = p_alpha.PAlpha(TensionCutoff(ShiftedEnergy(ALUMINIUM, 1e5), 2e9), 1.275, 0.08e9, 0.7e9)
    assert pressure(2900.0, 0.0, deep) == pytest.approx(pressure(2900.0, 1e5, ALUMINIUM), rel=1e-15)
    rock = p_alpha.PAlpha(Tillotson(2700.0, 0.5, 1.5, 26.7e9, 26.7e9, 5.0, 5.0, 4.87e8, 4.72e6, 18.2e6), 1.25, 0.2e9, 2e9)
    assert 0.2e9 < pressure(2300.0, 1e4, rock) < 2e9


@pytest.mark.parametrize("make, message", [
    (lambda: p_alpha.build(ALUMINIUM, 0.9, 0.0, 1e9), "must exceed 1"),
    (lambda: p_alpha.build(ALUMINIUM, 1.2, 2e9, 1e9), "elastic_pressure < compaction_pressure"),
    (lambda: snow_plough.build(ALUMINIUM, 2800.0, 1e8), "between 0 and the solid's 2700"),
    (lambda: snow_plough.build(ALUMINIUM, 2000.0, 0.0), "crush_pressure must be positive"),
    (lambda: p_lambda.build(ALUMINIUM, 3000.0, 25e9, 1e9), "between 0 and the solid's 2700"),
    (lambda: p_lambda.build(ALUMINIUM, 2000.0, 25e9, 1e9, 0.5), "exponent >= 1")])
def test_bad_parameters_are_refused(make, message):
    with pytest.raises(OutOfRange, match=message):
        make()


def test_p_lambda_compiled_finds_the_same_root_all_along_its_hugoniot():
    """Fast arithmetic must not stop the search early: one state in a thousand would be enough to spoil a run."""
    from hugoniot.laws import arrays
    from hugoniot.theory.hugoniot import curve

    par = p_lambda.build(ALUMINIUM, 2100.0, 25e9, 0.4e9, 1.2)
    states = curve(par, points=101, up_to=900.0)
    place = np.linspace(0.0, 100.0, 4000)
    rho, e = (np.interp(place, np.arange(101.0), each) for each in (states.density, states.specific_internal_energy))
    found = arrays.evaluate(par, rho, e, "pressure")["pressure"]
    again = [pressure(*state, par) for state in zip(rho.tolist(), e.tolist())]
    assert found == pytest.approx(again, rel=1e-9, abs=1.0)
    volume, p = 1.0 / rho[1:], found[1:]
    solid = np.array([p_lambda._solid_density(*state, par) for state in zip(rho[1:].tolist(), e[1:].tolist())])
    share = -np.expm1(-((p / 0.4e9) ** 1.2))
    assert share / solid + (1.0 - share) / (2100.0 * (1.0 + p / 25e9)) == pytest.approx(volume, rel=1e-11)
