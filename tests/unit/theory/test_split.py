"""Split Hugoniots against jump conditions solved on the solid's law alone, and where there is none."""

import math

import pytest
from scipy.optimize import brentq

from hugoniot.laws.eos import p_alpha
from hugoniot.laws.eos.contract import pressure
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.theory.hugoniot import Initial, shock
from hugoniot.theory.split import split_range, split_wave

SOLID = MieGruneisen(2700.0, 5350.0, 1.34, 2.0, 863.0)
ALPHA0, P_E, P_S = 1.275, 0.08e9, 0.7e9
POROUS = p_alpha.build(SOLID, ALPHA0, P_E, P_S)


def elastic():
    """(density, energy, particle velocity, shock velocity) behind the wave to P_E, the pores as they are."""
    rest = 2700.0 / ALPHA0

    def miss(rho):
        return pressure(ALPHA0 * rho, 0.5 * P_E * (1.0 / rest - 1.0 / rho), SOLID) / ALPHA0 - P_E
    rho = brentq(miss, rest, 1.05 * rest)
    u = math.sqrt(P_E * (1.0 / rest - 1.0 / rho))
    return rho, 0.5 * P_E * (1.0 / rest - 1.0 / rho), u, P_E / (rest * u)


@pytest.mark.parametrize("speed", [50.0, 150.0, 400.0])
def test_the_precursor_goes_to_the_elastic_limit_and_mass_momentum_and_energy_hold_behind_it(speed):
    ahead = Initial.at_rest(POROUS)
    single = shock(POROUS, ahead, particle_velocity=speed)
    found = split_wave(POROUS, ahead, single)
    rho, e, u, us = elastic()
    assert float(found.precursor.pressure) == pytest.approx(P_E, rel=1e-6)
    assert float(found.precursor.shock_velocity) == pytest.approx(us, rel=1e-6)
    p, v = float(found.behind.pressure), 1.0 / float(found.behind.density)
    assert p - P_E == pytest.approx((speed - u) ** 2 / (1.0 / rho - v), rel=1e-6)
    assert float(found.behind.specific_internal_energy) - e == pytest.approx(0.5 * (p + P_E) * (1.0 / rho - v), rel=1e-6)
    alpha = 1.0 if p >= P_S else 1.0 + (ALPHA0 - 1.0) * ((P_S - p) / (P_S - P_E)) ** 2
    assert p == pytest.approx(pressure(alpha / v, float(found.behind.specific_internal_energy), SOLID) / alpha, rel=1e-6)
    assert abs(p / float(single.pressure) - 1.0) > 0.02


@pytest.mark.parametrize("speed", [841.0, 1500.0])
def test_a_precursor_of_a_hundredth_of_the_particle_velocity_is_found(speed):
    """The shock is slower than the elastic wave, which takes 7 m/s: 841 m/s is an impact of copper at 1 km/s."""
    ahead = Initial.at_rest(POROUS)
    single = shock(POROUS, ahead, particle_velocity=speed)
    assert float(single.shock_velocity) < elastic()[3]
    assert float(split_wave(POROUS, ahead, single).precursor.pressure) == pytest.approx(P_E, rel=1e-6)
    assert split_range(POROUS, ahead, 5000.0)[0] == pytest.approx(elastic()[2], abs=0.5)


@pytest.mark.parametrize("law, speed", [(POROUS, 1700.0), (POROUS, 5.0), (SOLID, 150.0)])
def test_a_shock_that_outruns_everything_holds_together(law, speed):
    ahead = Initial.at_rest(law)
    assert split_wave(law, ahead, shock(law, ahead, particle_velocity=speed)) is None


def test_the_range_of_a_curve_ends_where_the_shock_overtakes_its_precursor():
    ahead = Initial.at_rest(POROUS)
    low, high = split_range(POROUS, ahead, 2500.0)
    overtakes = brentq(lambda up: float(shock(POROUS, ahead, particle_velocity=up).shock_velocity) - elastic()[3], 1000.0, 2500.0)
    assert low < 15.0 and high == pytest.approx(overtakes, abs=10.0)
    assert split_range(SOLID, Initial.at_rest(SOLID), 2500.0) is None
