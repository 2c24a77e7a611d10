"""Grain contact: the powder's own law up to the density of its grains, their cold compression beside it from there on."""

import math

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq

from hugoniot.errors import OutOfRange
from hugoniot.laws.eos import grain_contact, mie_gruneisen_cold, table
from hugoniot.laws.eos.contract import (
    EOS,
    density_limits,
    energy,
    entropy,
    particle_velocity_limit,
    pressure,
    pressure_derivatives,
    reference_state,
    sound_speed_squared,
    temperature,
)
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.laws.eos.mie_gruneisen_quadratic import MieGruneisenQuadratic
from hugoniot.theory.hugoniot import shock
from hugoniot.theory.isentrope import isentrope, release, residual

SILICA = mie_gruneisen_cold.MieGruneisenCold(100.0, 121.0, 0.9736, 0.3, -86.2 * 298.15, 86.2)
GRAINS = (2200.0, 23.4e9, 4.34)
PAR = grain_contact.build(SILICA, *GRAINS)


def murnaghan(rho):
    """p_s, Pa, from K(p) = K + n p integrated by hand."""
    return 23.4e9 / 4.34 * ((rho / 2200.0) ** 4.34 - 1.0)


def cold_work(rho):
    """e_s, J/kg: the work of p_s by quadrature."""
    return quad(lambda r: murnaghan(r) / (r * r), 2200.0, rho, epsabs=0.0, epsrel=1e-12)[0]


def test_up_to_the_density_of_its_grains_the_powder_is_what_was_fitted():
    for rho, e in ((90.0, 0.0), (100.0, 0.0), (700.0, 3e5), (2199.9, 1.5e6), (2200.0, 1.5e6)):
        assert pressure(rho, e, PAR) == pressure(rho, e, SILICA)
        assert pressure_derivatives(rho, e, PAR) == pressure_derivatives(rho, e, SILICA)
        assert (temperature(rho, e, PAR), entropy(rho, e + 1e5, PAR)) == (temperature(rho, e, SILICA), entropy(rho, e + 1e5, SILICA))
    assert (reference_state(PAR), density_limits(PAR)) == (reference_state(SILICA), density_limits(SILICA))


@pytest.mark.parametrize("rho", [2210.0, 2360.0, 3300.0])
def test_beyond_it_the_cold_grains_stand_beside_the_powder(rho):
    cold, e = cold_work(rho), 5e6
    assert pressure(rho, e, PAR) == pytest.approx(pressure(rho, e - cold, SILICA) + murnaghan(rho), rel=1e-12)
    assert temperature(rho, e, PAR) == pytest.approx(temperature(rho, e - cold, SILICA), rel=1e-11)
    assert entropy(rho, e, PAR) == pytest.approx(entropy(rho, e - cold, SILICA), rel=1e-11)
    assert energy(rho, pressure(rho, e, PAR), PAR) == pytest.approx(e, rel=1e-11)
    slope = (murnaghan(rho * 1.0001) - murnaghan(rho * 0.9999)) / (2e-4 * rho)
    assert sound_speed_squared(rho, e, PAR) == pytest.approx(sound_speed_squared(rho, e - cold, SILICA) + slope, rel=1e-7)


def test_the_sound_speed_leaps_to_that_of_the_grains_and_the_pressure_does_not():
    below, above = 2200.0 * (1.0 - 1e-9), 2200.0 * (1.0 + 1e-9)
    assert pressure(above, 6e5, PAR) == pytest.approx(pressure(below, 6e5, PAR), abs=100.0)
    leap = sound_speed_squared(above, 6e5, PAR) - sound_speed_squared(below, 6e5, PAR)
    assert leap == pytest.approx(23.4e9 / 2200.0, rel=1e-6)


def test_a_powder_with_a_slope_below_1_has_shocks_of_any_speed():
    """J-E16: the fit alone ends at c0/(1 - s) = 4583 m/s, without volume. Beyond 1634 m/s the grains touch; found here by hand."""
    assert (particle_velocity_limit(PAR), particle_velocity_limit(SILICA)) == (math.inf, pytest.approx(121.0 / 0.0264))
    touch = 121.0 * (1 - 100 / 2200) / (1 - 0.9736 * (1 - 100 / 2200))
    for u in (0.999 * touch, 1.05 * touch, 3000.0, 9000.0):
        found = shock(PAR, particle_velocity=u)
        volume = brentq(lambda v, e: pressure(1 / v, e, PAR) * (0.01 - v) - 2 * e, 1e-4, 9e-3, args=(0.5 * u * u,), xtol=1e-18, rtol=1e-15)
        assert found.density == pytest.approx(1.0 / volume, rel=1e-10)
        assert found.shock_velocity == pytest.approx(u / (1.0 - 100.0 * volume), rel=1e-10)
    assert shock(PAR, particle_velocity=0.999 * touch).shock_velocity == pytest.approx(121.0 + 0.9736 * 0.999 * touch, rel=1e-12)


def test_an_isentrope_through_the_contact_is_exact():
    """Down from 2.6 GPa: first law by quadrature, constant entropy, and up again to where it began."""
    start = shock(PAR, particle_velocity=5000.0)
    down = release(PAR, start, points=9)
    assert down.density[0] > 2300.0 > 2200.0 > down.density[-1]
    assert residual(down) < 1e-11
    assert down.entropy == pytest.approx(np.full(9, start.entropy), rel=1e-11)
    again = isentrope(PAR, down[-1], density=start.density)
    assert again.pressure == pytest.approx(start.pressure, rel=1e-10)


def test_over_a_table_the_pieces_of_both_are_followed():
    base = table.from_law(MieGruneisen(770.0, 1070.9, 0.4045, 0.3, 740.0), np.linspace(600.0, 3000.0, 9), np.linspace(250.0, 4000.0, 6))
    par = grain_contact.build(base, *GRAINS)
    path = isentrope(par, density=np.array([1500.0, 2150.0, 2250.0, 2500.0]))
    assert residual(path) < 1e-11


def test_a_law_that_ends_below_the_density_of_its_grains_keeps_its_end():
    steep = mie_gruneisen_cold.build(250.0, 97.0, 1.2509, 0.3)
    assert density_limits(grain_contact.build(steep, *GRAINS)) == density_limits(steep)
    curved = MieGruneisenQuadratic(100.0, 121.0, 2.5, -1e-4, 0.3)
    assert particle_velocity_limit(grain_contact.build(curved, *GRAINS)) == particle_velocity_limit(curved) < math.inf


@pytest.mark.parametrize("given, message", [
    ((90.0, 23.4e9, 4.34), "must be finite and exceed the density of the powder, 100 kg/m3"), ((math.inf, 23.4e9, 4.34), "grain_density"), ((2200.0, 0.0, 4.34), "grain_modulus"),
    ((2200.0, math.nan, 4.34), "grain_modulus"), ((2200.0, 23.4e9, 1.0), "must be finite and exceed 1")])
def test_grains_that_cannot_be_are_refused(given, message):
    with pytest.raises(OutOfRange, match=message):
        EOS.get("grain_contact").build(SILICA, *given)
