"""Herrmann's aluminium impacts (H-1, H-2) with both readings of his illegible constants, and the attenuation onset of H-4."""

import numpy as np
import pytest

from hugoniot.laws.eos.herrmann_series import HerrmannSeries
from hugoniot.theory.hugoniot import shock
from hugoniot.theory.impedance import free_surface, match

H0 = 5.473e3  # kg/m3: 5.473 g/cm3
LITERAL = HerrmannSeries(2780.0, 76.4e9, 1.014, 2.36, 5.13, H0, 1.0, 1.0, 1.0)
RMW = HerrmannSeries(2780.0, 76.4e9, 2.184, 1.793, -0.72, H0, 1.0, 1.0, 1.0)


@pytest.mark.parametrize(("law", "velocity", "pressure", "us", "surface"), [
    (LITERAL, 1900.0, 16.82e9, 6368.0, 1905.1), (RMW, 1900.0, 17.57e9, 6652.0, 1905.4),
    (LITERAL, 1200.0, 9.87e9, 5917.0, 1201.3), (RMW, 1200.0, 10.26e9, 6149.0, 1201.3)])
def test_impacts(law, velocity, pressure, us, surface):
    """The numbers of the sheet have four digits: half a unit of the last one is the tolerance."""
    met = match([law, law], velocity)[0]
    assert met.particle_velocity == pytest.approx(velocity / 2, rel=1e-12)
    assert met.pressure == pytest.approx(pressure, abs=0.0051e9)
    assert met.right.shock_velocity == pytest.approx(us, abs=1.0)
    assert free_surface(law, met.right).particle_velocity == pytest.approx(surface, abs=0.1)


@pytest.mark.parametrize(("law", "velocity", "onset"), [(LITERAL, 1900.0, 11.65), (RMW, 1900.0, 11.30), (LITERAL, 1200.0, 17.6), (RMW, 1200.0, 15.4)])
def test_hydrodynamic_attenuation_onset(law, velocity, onset):
    state = shock(law, particle_velocity=velocity / 2)
    c = state.density * state.sound_speed / law.rho0
    assert (c + state.shock_velocity) / (c - state.shock_velocity) == pytest.approx(onset, rel=5e-3)


def test_bulk_sound_speed():
    state = shock(LITERAL, particle_velocity=np.array([1e-3]))
    assert state.shock_velocity[0] == pytest.approx(np.sqrt(76.4e9 / 2780.0), rel=1e-6)
    assert np.sqrt(76.4e9 / 2780.0) == pytest.approx(5242.0, abs=0.5)
