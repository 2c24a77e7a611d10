"""Every registered law through the tools of this room: jumps, round trips, first law, limits; nothing fails silently."""

import numpy as np
import pytest

import hugoniot.laws.eos  # noqa: F401  (enrols the laws)
from hugoniot.errors import OutOfRange
from hugoniot.laws.eos import contract
from hugoniot.laws.eos.contract import EOS
from hugoniot.theory.hugoniot import Initial, limit, residual, shock
from hugoniot.theory.isentrope import release
from hugoniot.theory.isentrope import residual as first_law

# whose pressure has kinks (crush-up, table cells): Gauss quadrature across a kink is no judge
KINKED = ("p_alpha", "p_lambda", "table")
LAWS = EOS.names()


def upstream(par):
    ahead = Initial.at_rest(par)
    return ahead, contract.sound_speed(ahead.density, ahead.energy, par)


@pytest.mark.parametrize("name", LAWS)
def test_rankine_hugoniot_residual(name):
    par = EOS.get(name).example
    ahead, c = upstream(par)
    states = shock(par, ahead, particle_velocity=np.geomspace(0.01, 0.6, 25) * c)
    assert residual(par, ahead, states).max() < 1e-12
    assert (np.diff(states.pressure) > 0.0).all()


@pytest.mark.parametrize("name", LAWS)
@pytest.mark.parametrize("direction", [1, -1])
def test_rankine_hugoniot_residual_of_second_shocks_into_moving_material(name, direction):
    par = EOS.get(name).example
    ahead, c = upstream(par)
    first = shock(par, ahead, particle_velocity=0.2 * c)
    moving = Initial(first.density, first.pressure, first.specific_internal_energy, velocity=-333.0)
    reach = min(0.4 * c, 0.9 * limit(par, moving).particle_velocity)
    states = shock(par, moving, direction=direction, particle_velocity=-333.0 + direction * np.geomspace(0.02, 1.0, 12) * reach)
    assert residual(par, moving, states).max() < 1e-12
    assert (np.diff(states.pressure) > 0.0).all() and states.pressure[0] > first.pressure


@pytest.mark.parametrize("name", [n for n in LAWS if n not in KINKED])
def test_round_trips(name):
    par = EOS.get(name).example
    ahead, c = upstream(par)
    states = shock(par, ahead, particle_velocity=np.array([0.05, 0.3, 0.6]) * c)
    for word in ("pressure", "density", "shock_velocity"):
        again = shock(par, ahead, **{word: getattr(states, word)})
        assert again.particle_velocity == pytest.approx(states.particle_velocity, rel=1e-9), word


@pytest.mark.parametrize("name", LAWS)
def test_isentrope_first_law(name):
    law = EOS.get(name)
    ahead, c = upstream(law.example)
    start = shock(law.example, ahead, particle_velocity=0.3 * c)
    end = max(ahead.pressure, 0.0, 1e-3 * start.pressure if "gas" in law.flags else 0.0)
    assert first_law(release(law.example, start, end, points=4)) < 1e-11


@pytest.mark.parametrize("name", LAWS)
def test_beyond_the_limit_is_an_error_that_states_it(name):
    par = EOS.get(name).example
    ahead, _ = upstream(par)
    end = limit(par, ahead).density
    if np.isfinite(end):
        with pytest.raises(OutOfRange, match=r"compression limit|ends at"):
            shock(par, ahead, density=1.02 * end)
    with pytest.raises(OutOfRange):
        shock(par, ahead, pressure=ahead.pressure - 1.0)
