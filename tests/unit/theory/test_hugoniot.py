"""Hugoniots: closed forms of gases and linear Us-up solids, every way of naming a state, porous, second shock, limits."""

import math

import numpy as np
import pytest
from scipy.optimize import brentq

from hugoniot.errors import NoSolution, OutOfRange
from hugoniot.laws.eos import p_alpha
from hugoniot.laws.eos.contract import EOS, pressure
from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.laws.eos.mie_gruneisen_cold import MieGruneisenCold
from hugoniot.laws.eos.mie_gruneisen_cubic import MieGruneisenCubic
from hugoniot.laws.eos.mie_gruneisen_linear_gamma import MieGruneisenLinearGamma
from hugoniot.laws.eos.mie_gruneisen_quadratic import MieGruneisenQuadratic
from hugoniot.laws.eos.p_lambda import PLambda
from hugoniot.laws.eos.shifted_energy import ShiftedEnergy
from hugoniot.laws.eos.tension_cutoff import TensionCutoff
from hugoniot.theory import hugoniot as h
from hugoniot.theory.hugoniot import Initial, curve, entropy_rise, limit, rayleigh_line, residual, shock

COPPER = MieGruneisen(8930.0, 3940.0, 1.489, 1.99, 390.0)


@pytest.mark.parametrize("gamma", [1.1, 1.4, 5 / 3, 3.0])
def test_gas_by_pressure_is_the_rankine_hugoniot_formula(gamma):
    gas, ahead = IdealGas(gamma), Initial(2.5, 3e5, 3e5 / ((gamma - 1) * 2.5), velocity=-40.0)
    ratio = np.array([1.0001, 2.0, 30.0, 1e6])
    found = shock(gas, ahead, pressure=3e5 * ratio)
    beta = (gamma + 1) / (gamma - 1)
    assert found.density == pytest.approx(2.5 * (beta * ratio + 1) / (beta + ratio), rel=2e-13)
    speed = math.sqrt(gamma * 3e5 / 2.5) * np.sqrt((gamma + 1) / (2 * gamma) * (ratio - 1) + 1)
    # the weakest rise is 30 Pa on 3e5: its round-off is 1e-12
    assert found.shock_velocity == pytest.approx(-40.0 + speed, rel=2e-12)


@pytest.mark.parametrize("s", [0.4045, 0.9736, 1.0, 1.489, 2.5])
@pytest.mark.parametrize("gamma0", [0.1, 1.0, 1.99])
def test_solid_returns_its_measured_line_for_any_gamma(s, gamma0):
    """The exact law passes through every measured shock state whatever Gamma is (the lesson of Jordan eq. 7.1.31)."""
    c0 = 2000.0
    law = MieGruneisen(1000.0, c0, s, gamma0)
    # below both limits of the law: Us = up for s < 1, and 1 - Gamma0 x / 2 = 0
    up = np.array([10.0, 100.0, 800.0])
    found = shock(law, particle_velocity=up)
    assert found.shock_velocity == pytest.approx(c0 + s * up, rel=1e-12)
    assert found.pressure == pytest.approx(1000.0 * (c0 + s * up) * up, rel=1e-12)
    # a weak shock is known to the round-off of the density only: 2e-16 c0/up of its pressure
    assert shock(law, particle_velocity=1e-3).shock_velocity == pytest.approx(c0 + s * 1e-3, rel=2e-9)
    assert residual(law, Initial.at_rest(law), found).max() < 1e-12


@pytest.mark.parametrize("gamma0", [0.3, 1.99])
def test_exact_cold_curve_meets_the_shock_state_for_any_gamma(gamma0):
    law = MieGruneisenCold(8930.0, 3940.0, 1.49, gamma0)
    up = np.array([300.0, 1500.0])
    assert shock(law, particle_velocity=up).shock_velocity == pytest.approx(3940.0 + 1.49 * up, rel=1e-12)


@pytest.mark.parametrize("name", ["pressure", "density", "shock_velocity", "particle_velocity"])
@pytest.mark.parametrize("direction", [1, -1])
def test_every_way_of_naming_a_state_gives_the_same(name, direction):
    ahead = Initial(9100.0, float(h.contract.pressure(9100.0, 2.1e4, COPPER)), 2.1e4, velocity=120.0)
    jumps = 120.0 + direction * np.array([20.0, 90.0, 2500.0])
    states = shock(COPPER, ahead, particle_velocity=jumps, direction=direction)
    again = shock(COPPER, ahead, direction=direction, **{name: getattr(states, name)})
    for field in ("pressure", "density", "particle_velocity", "shock_velocity", "specific_internal_energy"):
        assert getattr(again, field) == pytest.approx(getattr(states, field), rel=1e-10)
    assert residual(COPPER, ahead, states).max() < 1e-12


def test_second_shock_from_any_state_against_wilkins_formula():
    """A law P = a mu + b mu^2 + c (1 + mu) E: the Hugoniot from (P1, V1) in closed form, equation A.3."""
    from hugoniot.laws.eos.polynomial import Polynomial
    from hugoniot.theory.second_shock import Quadratic, principal, second

    a, b, c = 73e9, 172e9, 1.6
    names = Polynomial._fields
    law = _polynomial(names, Polynomial, a, b, c)
    mu1, mu = 0.1, np.array([0.12, 0.2, 0.3])
    first = shock(law, density=2700.0 * (1 + mu1))
    assert first.pressure == pytest.approx(principal(mu1, Quadratic(a, b, c)), rel=1e-12)
    again = shock(law, Initial.of(first), density=2700.0 * (1 + mu))
    assert again.pressure == pytest.approx(second(mu, mu1, Quadratic(a, b, c)), rel=1e-12)


def _polynomial(names, law, a, b, c):
    from hugoniot.laws.eos.contract import EOS

    built = EOS.of_class(law).build
    import inspect

    wanted = inspect.signature(built).parameters
    values = {"rho0": 2700.0, "a": a, "b": b, "c": 0.0, "d": c, "k1": a, "k2": b, "k3": 0.0, "gamma0": c}
    return built(**{n: values[n] for n in wanted if n in values})


def test_a_gas_without_pores_keeps_its_law_at_another_density():
    gas = IdealGas(1.4)
    thin = Initial.at_rest(gas, density=0.6)
    assert thin.pressure == pytest.approx(0.4 * 0.6 * thin.energy, rel=1e-15)
    assert residual(gas, thin, shock(gas, thin, particle_velocity=500.0)) < 1e-13
    with pytest.raises(OutOfRange, match="exceeds the reference density of 8930 kg/m3"):
        Initial.at_rest(COPPER, density=9500.0)


def test_porous_hugoniot_against_the_closed_form():
    """Distended material, rho Gamma constant: p = p_H (1 - Gamma0 eta / 2) / (1 - rho0 Gamma0 (v00 - v)/2) (anomalous ones too)."""
    for rho00, rho in ((7500.0, 9200.0), (5000.0, 9200.0), (3000.0, 8700.0)):
        ahead = Initial.at_rest(COPPER, density=rho00)
        found = shock(COPPER, ahead, density=rho)
        reference = h.contract.pressure(rho, 0.0, COPPER)
        if rho > 8930.0:
            eta = 1 - 8930.0 / rho
            assert reference == pytest.approx(8930.0 * 3940.0**2 * eta / (1 - 1.489 * eta) ** 2 * (1 - 1.99 * eta / 2), rel=1e-12)
        assert found.pressure == pytest.approx(reference / (1 - 0.5 * 8930.0 * 1.99 * (1 / rho00 - 1 / rho)), rel=1e-11)
        again = shock(COPPER, ahead, pressure=found.pressure)
        assert again.density == pytest.approx(rho, rel=1e-10)
        assert residual(COPPER, ahead, found) < 1e-12


def test_heat_of_reaction_enters_the_energy():
    gas, ahead = IdealGas(3.0), Initial(1770.0, 0.0, 0.0, heat=6.27e6)
    up = 3000.0
    found = shock(gas, ahead, particle_velocity=up)
    assert found.pressure == pytest.approx(0.5 * 1770.0 * 4.0 * up**2 + 1770.0 * 6.27e6 * 2.0, rel=1e-12)  # KB codes eq. 4.6


def test_compiled_curve_equals_the_plain_one():
    up = np.linspace(0.0, 3000.0, h.COMPILE_ABOVE + 50)
    many = shock(COPPER, particle_velocity=up)
    few = shock(COPPER, particle_velocity=up[::10])
    assert many.pressure[::10] == pytest.approx(few.pressure, rel=1e-13)
    assert residual(COPPER, Initial.at_rest(COPPER), many).max() < 1e-12


def test_entropy_by_quadrature_equals_the_closed_form():
    state = shock(COPPER, pressure=80e9)
    assert entropy_rise(COPPER, Initial.at_rest(COPPER), state.density) == pytest.approx(state.entropy, rel=1e-9)


@pytest.mark.parametrize("ahead", [{"heat": 1e6}, {"density": 7000.0}])
def test_no_entropy_rise_where_the_hugoniot_does_not_begin_at_the_state_ahead(ahead):
    """The integral along the Hugoniot would leave out the entropy of the heat itself, or have no path from the pores."""
    with pytest.raises(OutOfRange, match="does not begin there"):
        entropy_rise(COPPER, Initial.at_rest(COPPER, **ahead), 9500.0)


def test_kb_figure_point():
    """K-1: p = 3.401e12 Pa, up = 3e4 m/s, rho0 = 2700: the Rayleigh line's slope is rho0 Us, 4.199e4 m/s."""
    us = 3.401e12 / (2700.0 * 3.0e4)
    assert us == pytest.approx(4.199e4, rel=2e-4)
    u, p = rayleigh_line(Initial(2700.0, 0.0, 0.0), us, particle_velocity=3.0e4)
    assert p[-1] == pytest.approx(3.401e12, rel=1e-14) and u[-1] == 3.0e4


@pytest.mark.parametrize(("law", "density"), [(IdealGas(1.4), 7.2), (IdealGas(5 / 3), 4.8), (COPPER, 8930.0 * 1.489 / 0.489)])
def test_limit_is_the_compression_limit(law, density):
    assert limit(law).density == pytest.approx(density, rel=1e-9)
    with pytest.raises(OutOfRange, match="ends at density"):
        shock(law, density=1.01 * density)


def test_segletes_limit():
    """Gamma0 > 2 s: the Hugoniot factor 1 - Gamma0 eta/2 vanishes before the pole, at eta = 2/Gamma0 (Starkenberg A-5)."""
    law = MieGruneisen(8930.0, 3940.0, 1.0, 3.0)
    assert limit(law).density == pytest.approx(3 * 8930.0, rel=1e-6)


@pytest.mark.parametrize("count", [150, pytest.param(600, marks=pytest.mark.slow)])
def test_no_hole_below_the_limit_of_a_solid_whose_gamma_rises(count):
    """Past Segletes' limit the misfit changes its sign again: a search that leaps over both must turn back, plain and compiled."""
    law = MieGruneisenLinearGamma(2703.0, 5240.0, 1.4, 1.97, 0.48)
    up = np.linspace(100.0, 62e3, count)
    found = shock(law, particle_velocity=up)
    assert found.shock_velocity == pytest.approx(5240.0 + 1.4 * up, rel=1e-9)
    assert residual(law, Initial.at_rest(law), found).max() < 1e-12


def test_a_hugoniot_of_finite_pressure_ends_upright_at_segletes_limit():
    """Steinberg's lead: 1 - eta (Gamma0 + b mu)/2 = 0 at finite pressure on its fit; there any higher pressure meets law and jump."""
    law = EOS.get("mie_gruneisen_cubic").example
    mu = (2.0 - law.gamma0 + math.sqrt((2.0 - law.gamma0) ** 2 + 8.0 * law.gamma_slope)) / (2.0 * law.gamma_slope)  # eta (Gamma0 + b mu) = 2
    end = limit(law)
    assert end.density == pytest.approx(law.rho0 * (1.0 + mu), rel=1e-9)
    eta = np.linspace(0.0, 1.0, 1000001)
    fastest = (law.c0 * eta / (1.0 - eta * (law.s1 + eta * (law.s2 + eta * law.s3)))).max()  # where the fit ends: it turns back to weaker shocks
    assert end.particle_velocity == pytest.approx(fastest, rel=1e-9) and end.pressure == pytest.approx(fastest * end.shock_velocity * law.rho0)
    beyond = shock(law, particle_velocity=0.999 * fastest)
    assert beyond.density == pytest.approx(end.density, rel=1e-9)
    assert residual(law, Initial.at_rest(law), beyond) < 1e-12
    assert curve(law, points=5).particle_velocity[-1] == pytest.approx(law.c0)


@pytest.mark.parametrize(("c0", "s", "end"), [(121.0, 0.9736, 4583.33), (1070.0, 0.4045, 1796.81)])
def test_fits_with_s_below_one_end_where_us_meets_up(c0, s, end):
    """J-E16: at up = c/(1 - s) the shock no longer runs ahead of the material."""
    law = MieGruneisen(100.0, c0, s, 0.3)
    assert c0 / (1 - s) == pytest.approx(end, abs=0.01)
    assert limit(law).particle_velocity == pytest.approx(c0 / (1 - s), rel=1e-6)
    assert shock(law, particle_velocity=0.99 * end).shock_velocity == pytest.approx(c0 + s * 0.99 * end, rel=1e-9)
    with pytest.raises(OutOfRange, match=f"particle velocity {end:.6g}"[:22]):
        shock(law, particle_velocity=1.01 * end)


FROTH = MieGruneisen(250.0, 1070.0, 0.4045, 0.3, 800.0)  # s < 1


@pytest.mark.parametrize("law", [
    FROTH, MieGruneisenLinearGamma(250.0, 1070.0, 0.4045, 0.3, 0.1), MieGruneisenLinearGamma(250.0, 1070.0, 0.4045, 0.3, 0.3),
    MieGruneisenCubic(250.0, 1070.0, 0.4045, 0.0, 0.0, 0.3, 0.1), MieGruneisenQuadratic(250.0, 1070.0, 0.4045, 0.0, 0.3, 0.1),
    MieGruneisenCold(250.0, 1070.0, 0.4045, 0.3), ShiftedEnergy(FROTH, 1e5), TensionCutoff(FROTH, 1e8)], ids=lambda law: EOS.of(law).name)
def test_every_law_with_s_below_one_is_guarded_j_e16(law):
    """No shock beyond c/(1 - s) = 1796.8 m/s, whether infinite density or Segletes' limit comes first."""
    fastest = 1070.0 / (1 - 0.4045)
    up = np.linspace(1.0, 0.999 * fastest, 40)
    found = shock(law, particle_velocity=up)
    assert (found.shock_velocity > up).all()
    assert residual(law, Initial.at_rest(law), found).max() < 1e-12
    assert limit(law).particle_velocity == pytest.approx(fastest, rel=1e-6)
    assert np.isfinite(limit(law).pressure)
    for given in ({"particle_velocity": 1.01 * fastest}, {"particle_velocity": 40e3}, {"pressure": 2e10}):
        with pytest.raises(OutOfRange, match=r"particle velocity 1796\.8"):
            shock(law, **given)


def test_a_jump_of_the_law_is_no_solution():
    """P-lambda of a solid too soft for its pores has two roots; its pressure jumps, and no shock meets the jump conditions there."""
    law = PLambda(FROTH, 200.0, 1e7, 1e7, 1.0)
    with pytest.raises(NoSolution, match="pressure of the law jumps there"):
        shock(law, particle_velocity=100.0)
    assert residual(law, Initial.at_rest(law), shock(law, particle_velocity=1000.0)) < 1e-12


@pytest.mark.parametrize(("given", "words"), [
    ({"pressure": -1.0}, "isentrope"), ({"particle_velocity": -5.0}, "compression"), ({"shock_velocity": 3000.0}, "sound speed 3940"),
    ({"pressure": math.nan}, "finite"), ({"density": 8000.0}, "does not compress"), ({"temperature": 300.0}, "exactly one"), ({}, "exactly one"),
    ({"pressure": 1e9, "density": 9000.0}, "exactly one")])
def test_impossible_states_are_refused_in_words(given, words):
    with pytest.raises(OutOfRange, match=words):
        shock(COPPER, **given)


def test_shapes_and_ends_of_a_curve():
    states = curve(COPPER, points=7, up_to=700.0)
    assert len(states) == 7 and states.pressure[0] == 0.0 and states.shock_velocity[0] == pytest.approx(3940.0)
    assert isinstance(shock(COPPER, pressure=1e9).density, float)
    assert shock(COPPER, pressure=np.full((2, 3), 1e9)).density.shape == (2, 3)
    assert states[2].particle_velocity == pytest.approx(700.0 / 3)


@pytest.mark.parametrize("distension", [1.9, 2.2, 2.5, 2.7, 3.5, 6.0])
def test_strongly_porous_material_has_a_shock_of_every_strength(distension):
    """Beyond the pores the state is the solid's own at e = u^2/2, lighter than the solid: by the jump conditions on its law alone."""
    solid = MieGruneisen(2700.0, 5350.0, 1.34, 2.0, 863.0)
    porous, rest = p_alpha.build(solid, distension, 1e7, 3e8), 2700.0 / distension
    for up in (800.0, 2000.0, 3000.0, 5000.0):
        def misses(rho, up=up):
            return pressure(rho, 0.5 * up * up, solid) - rest * up * up / (1.0 - rest / rho)
        found = shock(porous, particle_velocity=up)
        if found.pressure > 3e8:
            assert float(found.density) == pytest.approx(brentq(misses, 1.05 * rest, 4000.0), rel=1e-9)
