"""Transport laws against formulas written out again, and the way they are put together."""

import math

import numpy as np
import pytest

from hugoniot.errors import OutOfRange
from hugoniot.laws import eos as _laws  # noqa: F401
from hugoniot.laws.eos.contract import EOS, pressure, pressure_derivatives, sound_speed_squared
from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.laws.transport import contract as t
from hugoniot.laws.transport.mean_free_path import MEAN_FREE_PATHS, mean_free_path, viscosity_exponent
from hugoniot.theory.structure import jordan
from hugoniot.theory.structure.profile import steady

R, RHO, T = 208.1, 1.62, 300.0


def test_hard_sphere_is_the_sphere_formula_of_kinetic_theory():
    mass, d = 6.6335e-26, 3.66e-10
    par = t.make({"law": "hard_sphere", "molecular_mass": mass, "diameter": d}).shear
    cbar = math.sqrt(8.0 * 1.380649e-23 * T / (math.pi * mass))
    path = 1.0 / (math.sqrt(2.0) * math.pi * d**2 * (RHO / mass))
    assert t.viscosity(RHO, T, par) == pytest.approx(RHO * cbar * path / 3.0, rel=1e-12)  # BSL 1.4-8: mu = n m cbar lambda / 3


def test_temperature_exponents():
    for law, exponent in (("constant", 0.0), ("power_law", 0.81), ("maxwell_molecules", 1.0), ("hard_sphere", 0.5)):
        par = jordan.argon_transport(law).shear
        assert t.viscosity(RHO, T, par) == pytest.approx(2.27e-5, rel=1e-12)
        slope = math.log(t.viscosity(RHO, 3.0 * T, par) / t.viscosity(RHO, T, par)) / math.log(3.0)
        assert slope == pytest.approx(exponent, abs=1e-12)


def test_sutherland_runs_between_three_halves_and_one_half():
    par = jordan.argon_transport("sutherland").shear
    def slope(x):
        return (math.log(t.viscosity(RHO, 1.001 * x, par)) - math.log(t.viscosity(RHO, x, par))) / math.log(1.001)
    for temperature in (10.0, 300.0, 1e5):
        middle = temperature * math.sqrt(1.001)
        assert slope(temperature) == pytest.approx(1.5 - middle / (middle + 144.4), abs=1e-6)


def test_mean_free_paths_differ_by_their_known_ratios():
    mu, p = 2.27e-5, RHO * R * T
    found = {name: mean_free_path(name, mu, RHO, p, 0.5) for name in MEAN_FREE_PATHS}
    assert found["bsl"] / found["chapman_enskog"] == pytest.approx(1.4726, abs=5e-5)   # A5
    assert found["bsl"] / found["viscous"] == pytest.approx(1.5, rel=1e-14)
    assert found["viscous"] == pytest.approx(mu / p * math.sqrt(math.pi * R * T / 2.0), rel=1e-14)
    assert found["vhs"] == pytest.approx(found["chapman_enskog"], rel=1e-14)            # omega = 1/2 is the hard sphere


@pytest.mark.parametrize("omega", [0.5, 0.74, 0.81, 1.0])
def test_variable_hard_spheres_have_the_path_of_their_cross_section(omega):
    """Spheres of diameter d at this temperature: Bird (1994) eq. 4.62 gives the viscosity, 1 / (sqrt(2) pi d^2 n) the path."""
    k, mass, d = 1.380649e-23, 6.6335e-26, 4.17e-10
    mu = 15.0 * math.sqrt(math.pi * mass * k * T) / (2.0 * math.pi * d**2 * (5.0 - 2.0 * omega) * (7.0 - 2.0 * omega))
    path = 1.0 / (math.sqrt(2.0) * math.pi * d**2 * (RHO / mass))
    assert mean_free_path("vhs", mu, RHO, RHO * k / mass * T, omega) == pytest.approx(path, rel=1e-12)


@pytest.mark.parametrize("law, omega", [("constant", 0.0), ("power_law", 0.81), ("maxwell_molecules", 1.0), ("hard_sphere", 0.5),
                                        ("sutherland", 1.5 - T / (T + 144.4))])
def test_the_exponent_of_a_viscosity_law_is_its_own(law, omega):
    assert viscosity_exponent(RHO, T, jordan.argon_transport(law).shear) == pytest.approx(omega, abs=1e-7)


def test_a_profile_counts_its_vhs_path_with_the_exponent_of_its_law():
    """Bird's factor (5 - 2 omega)(7 - 2 omega): 1.0685 times longer for 0.74 than for 0.81."""
    law, ahead = jordan.argon()
    one, other = (steady(law, t.make({"law": "power_law", "shear_viscosity": 2.27e-5, "exponent": omega}), ahead, mach=2.0)
                  for omega in (0.74, 0.81))
    assert one.mean_free_path("vhs") / other.mean_free_path("vhs") == pytest.approx(3.52 * 5.52 / (3.38 * 5.38), rel=1e-9)


def test_mean_free_path_refuses_a_liquid_and_offers_the_nearest_name():
    with pytest.raises(OutOfRange, match="needs a gas"):
        mean_free_path("bsl", 1e-3, 1000.0, 0.0, 0.5)
    with pytest.raises(OutOfRange, match="did you mean 'chapman_enskog'"):
        mean_free_path("chapman_enskogg", 1e-5, 1.0, 1e5, 0.5)


def test_isobaric_heat_of_an_ideal_gas_is_gamma_cv():
    par = IdealGas(5.0 / 3.0, 312.15, RHO)
    e = 312.15 * T
    p_rho, p_e = pressure_derivatives(RHO, e, par)
    T_e, T_v = 1.0 / 312.15, 0.0
    assert t.isobaric_heat(RHO, sound_speed_squared(RHO, e, par), p_rho, p_e, T_v, T_e) == pytest.approx(312.15 * 5.0 / 3.0, rel=1e-13)


@pytest.mark.parametrize("name, rho, e", [("mie_gruneisen", 3100.0, 9e5), ("snow_plough", 2600.0, 1.5e6), ("p_alpha", 2400.0, 4e5),
                                          ("p_lambda", 2500.0, 4e5)])
def test_isobaric_heat_is_the_enthalpy_slope_at_constant_pressure(name, rho, e):
    """Also where porosity breaks the identities of temperature: a small step along the isobar, by the law's own pressure and temperature."""
    from scipy.optimize import brentq

    from hugoniot.laws.eos.contract import temperature
    par = EOS.get(name).example
    p0, d = pressure(rho, e, par), 1e-5
    states = []
    for r in (rho * (1.0 - d), rho * (1.0 + d)):
        energy = brentq(lambda x, r=r: float(pressure(r, x, par)) - p0, 0.8 * e, 1.2 * e, xtol=1e-9 * e, rtol=1e-15)
        states.append((energy + p0 / r, temperature(r, energy, par)))
    slope = (states[1][0] - states[0][0]) / (states[1][1] - states[0][1])
    p_rho, p_e = pressure_derivatives(rho, e, par)
    s = 1e-5
    T_v = (temperature(rho / (1.0 + s), e, par) - temperature(rho / (1.0 - s), e, par)) * rho / (2.0 * s)
    T_e = (temperature(rho, e * (1.0 + s), par) - temperature(rho, e * (1.0 - s), par)) / (2.0 * s * e)
    found = t.isobaric_heat(rho, sound_speed_squared(rho, e, par), p_rho, p_e, T_v, T_e)
    assert found == pytest.approx(slope, rel=1e-5)


@pytest.mark.parametrize("given, words", [
    (({"law": "constant", "shear_viscosity": 0.0}, None), "shear_viscosity must be a positive number"),
    (({"law": "constant", "shear_viscosity": 1e-5}, {"law": "prandtl", "prandtl": 0.0}), "prandtl must be a positive number"),
    (({"law": "constant", "shear_viscosity": 1e-5}, {"law": "prandtl", "prandtl": math.nan}), "prandtl must be a positive number"),
    (({"law": "power_law", "viscosity": 1.0}, None), "has no parameter viscosity"),
    (({"law": "sutherland", "shear_viscosity": 1.0}, None), "needs reference_temperature"),
])
def test_bad_transport_is_refused_with_the_way_out(given, words):
    with pytest.raises(OutOfRange, match=words):
        t.make(*given)


def test_negative_bulk_viscosity_is_refused():
    with pytest.raises(OutOfRange, match="bulk viscosity must not be negative"):
        t.make({"law": "constant", "shear_viscosity": 1.0}, bulk_ratio=-1.0)


def test_longitudinal_viscosity_adds_bulk():
    made = t.make({"law": "constant", "shear_viscosity": 3.0}, bulk_ratio=2.0, bulk_viscosity=0.5)
    assert np.isclose(t.longitudinal_viscosity(3.0, made), 4.0 + 6.0 + 0.5, rtol=1e-15)
