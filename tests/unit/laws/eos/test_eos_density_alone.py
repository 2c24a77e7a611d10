"""Laws of the sources in which the energy, or the density, does not enter: p = A rho^gamma, the series with h0 = 0, shock_energy with S2."""

import numpy as np
import pytest

from hugoniot.errors import DeckError, OutOfRange
from hugoniot.laws.eos.contract import EOS, pressure, pressure_derivatives, sound_speed_squared
from hugoniot.laws.eos.herrmann_series import HerrmannSeries
from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.laws.eos.power_law import PowerLaw
from hugoniot.laws.eos.shock_energy import ShockEnergy
from hugoniot.problem.deck import read_deck_text
from hugoniot.theory.hugoniot import shock
from hugoniot.theory.isentrope import isentrope, reference, state

DECK = """
geometry = "planar"
stop_time = "0.1 us"
[[region]]
name = "a"
material = "m"
from = "0 mm"
to = "2 mm"
zones = 20
velocity = "200 m/s"
[material.m.eos]
"""


def test_power_law_is_the_isentrope_of_the_gas():
    """p, c and the velocity of a simple wave against the gamma-law gas on its isentrope, closed: du = 2/(gamma-1) dc."""
    par, gas = PowerLaw(1.2, 101325.0, 1.4), IdealGas(1.4, 717.5, 1.2)
    start = state(gas, pressure=101325.0, density=1.2)
    for rho in (0.3, 1.0, 1.2, 4.0):
        end = isentrope(gas, start, density=rho)
        assert pressure(rho, 0.0, par) == pytest.approx(end.pressure, rel=1e-10)
        assert sound_speed_squared(rho, 5e4, par) == pytest.approx(end.sound_speed**2, rel=1e-10)
        moved = isentrope(par, reference(par), density=rho).particle_velocity
        assert moved == pytest.approx(5.0 * (end.sound_speed - start.sound_speed), rel=1e-8, abs=1e-9)


def test_power_law_shock_conserves_mass_and_momentum():
    par = PowerLaw(1.2, 101325.0, 1.4)
    behind = shock(par, particle_velocity=300.0)
    assert behind.density * (behind.shock_velocity - 300.0) == pytest.approx(1.2 * behind.shock_velocity, rel=1e-12)
    assert behind.pressure - 101325.0 == pytest.approx(1.2 * behind.shock_velocity * 300.0, rel=1e-11)
    assert behind.pressure == pytest.approx(101325.0 * (behind.density / 1.2) ** 1.4, rel=1e-12)


@pytest.mark.parametrize("par", [PowerLaw(1.2, 101325.0, 1.4), HerrmannSeries(2780.0, 76.4e9, 1.7, 1.75, 0.67, 0.0)])
def test_density_and_pressure_leave_the_energy_open(par):
    with pytest.raises(OutOfRange, match="does not depend on the energy"):
        state(par, pressure=2e5, density=1.3 * par.rho0)
    assert pressure_derivatives(1.1 * par.rho0, 1e5, par)[1] == 0.0


def test_series_without_energy_term_can_be_given_and_sounds():
    """h0 = 0 is accepted by decks (A.11); the speed of sound is then the slope of the curve."""
    text = DECK + 'law = "herrmann_series"\nrho0 = "2780 kg/m^3"\nk0 = "76.4 GPa"\nk1 = 1.7\nk2 = 1.75\nk3 = 0.67\nh0 = 0\n'
    par = read_deck_text(text).problem.materials["m"].eos
    rho, h = 3000.0, 1e-2
    slope = (pressure(rho + h, 0.0, par) - pressure(rho - h, 0.0, par)) / (2 * h)
    assert sound_speed_squared(rho, 1e6, par) == pytest.approx(slope, rel=1e-8)
    with pytest.raises(DeckError, match="must not be less than 0"):
        read_deck_text(text.replace("h0 = 0", "h0 = -1"))


def test_shock_energy_with_s2_lies_on_its_own_hugoniot():
    """p = rho0 Us up with Us = c0 + s up + s2 up^2 at e = up^2/2 (3.1, 3.6, 3.7), and the slope by differences."""
    par = ShockEnergy(998.0, 1535.4, 1.97562, -1.0125e-4)
    for up in (50.0, 700.0, 2500.0):
        us = 1535.4 + up * (1.97562 - 1.0125e-4 * up)
        e = 0.5 * up * up
        assert pressure(1234.0, e, par) == pytest.approx(998.0 * us * up, rel=1e-12)
        h = 1e-5 * e
        slope = (pressure(1e3, e + h, par) - pressure(1e3, e - h, par)) / (2 * h)
        assert pressure_derivatives(1e3, e, par)[1] == pytest.approx(slope, rel=1e-8)
    assert EOS.get("shock_energy").build(rho0=998.0, c0=1500.0, s=1.9) == ShockEnergy(998.0, 1500.0, 1.9, 0.0)


def test_power_law_in_a_deck():
    par = read_deck_text(DECK + 'law = "power_law"\nrho0 = "1.2 kg/m^3"\np0 = "1 bar"\ngamma = 1.4\n').problem.materials["m"].eos
    assert np.allclose(par, (1.2, 1e5, 1.4))
    with pytest.raises(DeckError):
        read_deck_text(DECK + 'law = "power_law"\nrho0 = "1.2 kg/m^3"\np0 = "0 bar"\ngamma = 1.4\n')
