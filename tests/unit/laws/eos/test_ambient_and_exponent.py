"""003 A-11 and A-4: Hugoniots from a stated upstream state, and temperatures with a general exponent."""

import math

import numpy as np
import pytest

from hugoniot.errors import OutOfRange
from hugoniot.laws.eos import contract
from hugoniot.laws.eos.ambient import Ambient
from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.laws.eos.jwl_proportional import JWLProportional
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.laws.eos.temperature_power import TemperaturePower, build
from hugoniot.theory.hugoniot import Initial, shock

LINE = MieGruneisen(2785.0, 5328.0, 1.338, 2.0, 863.0)
LOADED = Ambient(LINE, 5e9, 2e5)
SOLID = JWLProportional(77810e9, -5.031e9, 11.3, 1.13, 0.8938, 1717.0, 1000.0)


def test_shocks_from_the_ambient_state_have_the_measured_line():
    ahead = Initial(2785.0, 5e9, 2e5)
    for up in (100.0, 800.0, 2500.0):
        behind = shock(LOADED, ahead, particle_velocity=up)
        assert float(behind.shock_velocity) == pytest.approx(5328.0 + 1.338 * up, rel=1e-12)
        assert float(behind.pressure) == pytest.approx(5e9 + 2785.0 * (5328.0 + 1.338 * up) * up, rel=1e-12)


@pytest.mark.parametrize("rho_u, e_u", [(2785.0, 2e5), (3000.0, 6e5), (2900.0, 1.5e6)])
def test_hugoniots_from_other_states_are_those_printed(rho_u, e_u):
    """A-11.5, with f_H = 1 - rho_Gamma (v_a - v)/2, against the shocks of the law."""
    va, vu, rg, pa, ea = 1.0 / 2785.0, 1.0 / rho_u, 2785.0 * 2.0, 5e9, 2e5
    pu = float(contract.pressure(rho_u, e_u, LOADED))
    for v in (0.95 * vu, 0.85 * vu):
        p_h = pa + 5328.0**2 * (va - v) / (va - 1.338 * (va - v)) ** 2
        f_a, f_u = 1.0 - 0.5 * rg * (va - v), 1.0 - 0.5 * rg * (vu - v)
        printed = (f_a * p_h - (1.0 - f_a) * pa + (1.0 - f_u) * pu + rg * (e_u - ea)) / f_u
        assert float(shock(LOADED, Initial(rho_u, pu, e_u), density=1.0 / v).pressure) == pytest.approx(printed, rel=1e-10)


def test_the_sound_speed_upstream_is_the_lines_intercept():
    assert contract.sound_speed_squared(2785.0, 2e5, LOADED) == pytest.approx(5328.0**2, rel=1e-12)


def test_an_exponent_of_one_changes_nothing():
    same = TemperaturePower(SOLID, 1.0)
    for rho, e in ((1800.0, 1e6), (2300.0, 3e6)):
        assert contract.temperature(rho, e, same) == pytest.approx(contract.temperature(rho, e, SOLID), rel=1e-12)
        rest = contract.entropy(*contract.reference_state(SOLID), SOLID)
        assert contract.entropy(rho, e, same) == pytest.approx(contract.entropy(rho, e, SOLID) - rest, rel=1e-11)


@pytest.mark.parametrize("w", [0.5, 0.8, 1.0, 1.5])
def test_the_equation_of_state_stays_complete(w):
    """T ds = de + p dv, c_v = de/dT, and c_v as printed, R/(w Gamma_0) (f_S T/Gamma_0 T_0)^((1-w)/w), all by differences."""
    par = build(SOLID, w)
    rest = contract.reference_state(par)
    assert contract.temperature(*rest, par) == pytest.approx(298.15, rel=1e-12)
    assert contract.specific_heat(*rest, par) == pytest.approx(1000.0, rel=1e-12)
    for rho, e in ((1750.0, 8e5), (2000.0, 2e6), (2400.0, 4e6)):
        t, h, dv = contract.temperature(rho, e, par), 1e-4 * e, 1e-5 / rho
        by_energy = (contract.entropy(rho, e + h, par) - contract.entropy(rho, e - h, par)) / (2.0 * h)
        by_volume = (contract.entropy(1.0 / (1.0 / rho + dv), e, par) - contract.entropy(1.0 / (1.0 / rho - dv), e, par)) / (2.0 * dv)
        heat = 2.0 * h / (contract.temperature(rho, e + h, par) - contract.temperature(rho, e - h, par))
        assert t * by_energy == pytest.approx(1.0, rel=1e-6)
        assert t * by_volume == pytest.approx(contract.pressure(rho, e, par), rel=1e-6)
        assert contract.specific_heat(rho, e, par) == pytest.approx(heat, rel=1e-6)
        growth = math.exp(SOLID.gamma0 * (1.0 - SOLID.rho0 / rho))
        assert heat == pytest.approx(1000.0 * (t / (298.15 * growth)) ** ((1.0 - w) / w), rel=1e-6)


def test_what_has_no_temperature_has_no_exponent():
    with pytest.raises(OutOfRange, match="specific_heat"):
        build(SOLID._replace(specific_heat=math.nan), 0.8)
    with pytest.raises(OutOfRange, match="positive"):
        build(IdealGas(1.4, 717.5), -1.0)
    assert np.isfinite(contract.temperature(1.2, 2e5, build(IdealGas(1.4, 717.5), 0.9)))
