"""003 A-10.5: the JWL alternative fitted to Us-up data."""

import numpy as np
import pytest

from hugoniot.errors import OutOfRange
from hugoniot.laws.eos.jwl_proportional import JWLProportional
from hugoniot.theory.hugoniot import shock
from hugoniot.theory.solid_fits import fit_solid

SET = JWLProportional(77810e9, -5.031e9, 11.3, 1.13, 0.8938, 1905.0)


def test_a_made_hugoniot_gives_its_own_constants():
    up = np.linspace(100.0, 2500.0, 15)
    us = shock(SET, particle_velocity=up).shock_velocity
    found = fit_solid(1905.0, 0.8938, up, us)
    assert found.deviation < 1e-6
    again = shock(found.par, particle_velocity=up).shock_velocity
    assert np.allclose(again, us, rtol=1e-6)
    assert found.par.r1 == pytest.approx(11.3, rel=1e-2) and found.par.a == pytest.approx(77810e9, rel=0.1)


def test_linear_hugoniots_are_met_the_worse_the_further_they_reach():
    """The source calls the fits poor: 0.01 % of copper's pressures to 2 km/s, percents of water's to 5 km/s."""
    deviations = []
    for rho0, c0, s, gamma, top in ((8930.0, 3940.0, 1.489, 1.99, 5000.0), (1000.0, 1480.0, 2.0, 0.5, 5000.0)):
        for reach in (0.4 * top, top):
            up = np.linspace(100.0, reach, 20)
            deviations.append(fit_solid(rho0, gamma, up, c0 + s * up).deviation)
    assert deviations[0] < 2e-4 < 1e-3 < deviations[1] < 2e-3 and deviations[2] < 5e-3 < 0.015 < deviations[3] < 0.025
    up = np.linspace(100.0, 2000.0, 20)
    us = 3940.0 + 1.489 * up
    found = fit_solid(8930.0, 1.99, up, us)
    assert found.highest == 2000.0
    shocked = shock(found.par, particle_velocity=up)
    assert np.max(np.abs(shocked.pressure / (8930.0 * us * up) - 1.0)) < 3.0 * found.worst


def test_too_few_points_are_refused():
    with pytest.raises(OutOfRange, match="needs 6 different particle velocities above 0, got 3"):
        fit_solid(8930.0, 1.99, [100.0, 200.0, 300.0], [4000.0, 4200.0, 4400.0])
    with pytest.raises(OutOfRange, match="pole"):
        fit_solid(8930.0, 9.0, np.linspace(500.0, 3000.0, 8), np.linspace(4500.0, 8000.0, 8))
