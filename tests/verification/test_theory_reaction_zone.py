"""Reaction zones of mixtures: the closed solution of Fickett and Rivard, and an integration in time that shares nothing with the tool."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from hugoniot.errors import OutOfRange
from hugoniot.laws.burn.arrhenius import Arrhenius
from hugoniot.laws.burn.contract import rate as burn_rate
from hugoniot.laws.burn.ignition_growth import IgnitionGrowth
from hugoniot.laws.burn.pressure_power import PressurePower
from hugoniot.laws.burn.programmed import Programmed
from hugoniot.laws.eos import contract as eos
from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.materials.library import entry
from hugoniot.theory import mixture as mixtures
from hugoniot.theory.chapman_jouguet import cj
from hugoniot.theory.characteristics import reaction_source
from hugoniot.theory.exact import SOLUTIONS
from hugoniot.theory.hugoniot import Initial, shock
from hugoniot.theory.mixture import mixture
from hugoniot.theory.znd import znd

D, RHO, GAMMA, RATE = 8500.0, 1600.0, 3.0, 2e6
COLD = Initial(RHO, 0.0, 0.0)


def gas_mixture(kind):
    gas = IdealGas(GAMMA, 1000.0, RHO)
    return mixture(kind, gas, gas, D**2 / (2.0 * (GAMMA**2 - 1.0)))


@pytest.mark.parametrize("kind", ["weighted_pressures", "thermal_equilibrium"])
def test_equal_gases_are_the_zone_of_fickett_and_rivard(kind):
    """One gas on both sides: both closures reduce to e = pv/(gamma-1) - lambda Q, whose zone is known."""
    exact = SOLUTIONS["fickett_rivard"](D, RHO, GAMMA, RATE)
    found = znd(gas_mixture(kind), COLD, PressurePower(RATE, 0.0, 0.5), points=40)
    assert found.velocity == pytest.approx(D, rel=1e-12)
    assert found.von_neumann.pressure == pytest.approx(exact.numbers["vn_pressure"], rel=1e-12)
    time = 2e-6
    there = exact(D * time - found.position, time)
    inside = found.reaction < 0.9999
    for name, field in (("pressure", "pressure"), ("density", "density"), ("particle_velocity", "velocity"), ("reaction", "burn_fraction")):
        assert found.table()[name][inside] == pytest.approx(there[field][inside], rel=1e-10, abs=1e-10), name
    tau = 2.0 / RATE * (1.0 - np.sqrt(1.0 - found.reaction))
    assert found.time == pytest.approx(tau, rel=1e-10, abs=1e-18)
    slope, bend = D * (GAMMA - 1.0) / (GAMMA + 1.0), D * RATE / (4.0 * (GAMMA + 1.0))
    assert found.position == pytest.approx(slope * tau + bend * tau**2, rel=1e-10, abs=1e-15)


def flow_by_time(explosive, closure, velocity, until):
    """(distance, time) from the front to fractions `until`, by integrating both phases along a particle.

    Unknown rates of v, v_r, v_p, e_r, e_p and p per unit of burn fraction solve the differentiated sums of volume and energy, the
    Rayleigh line dp = -m2 dv, de = -p dv, the slopes of both laws, and the closure: ds_r = 0, or dT_r = dT_p by differences.
    """
    material = explosive.material
    react, prod = material.unreacted, material.eos
    q = float(eos.reference_state(prod)[1] - eos.reference_state(react)[1])
    ahead = Initial.at_rest(react)
    spike = shock(react, ahead, shock_velocity=velocity)
    m2 = (ahead.density * velocity) ** 2

    def slopes(function, v, e, par):
        dv, de = 1e-6 * v, 1e-6 * abs(e) + 10.0
        return ((function(1 / (v + dv), e, par) - function(1 / (v - dv), e, par)) / (2 * dv),
                (function(1 / v, e + de, par) - function(1 / v, e - de, par)) / (2 * de))

    def along(lam, y):
        v_r, e_r, v_p, e_p = y[:4]
        p = eos.pressure(1 / v_r, e_r, react)
        rv, re = slopes(eos.pressure, v_r, e_r, react)
        pv, pe = slopes(eos.pressure, v_p, e_p, prod)
        # columns: dv_r, de_r, dv_p, de_p, dv, dp
        rows = [[1 - lam, 0, lam, 0, -1, 0], [0, 1 - lam, 0, lam, p, 0], [rv, re, 0, 0, 0, -1], [0, 0, pv, pe, 0, -1], [0, 0, 0, 0, m2, 1]]
        right = [v_r - v_p, e_r + q - e_p, 0, 0, 0]
        if closure == "thermal_isolation":
            rows.append([p, 1, 0, 0, 0, 0])
        else:
            tv, te = slopes(eos.temperature, v_r, e_r, react)
            uv, ue = slopes(eos.temperature, v_p, e_p, prod)
            rows.append([tv, te, -uv, -ue, 0, 0])
        right.append(0)
        scale = np.array([1e-4, 1e6, 1e-4, 1e6, 1e-4, 1e10])
        matrix = np.array(rows) * scale
        size = np.abs(matrix).max(axis=1)
        dv_r, de_r, dv_p, de_p, dv, dp = np.linalg.solve(matrix / size[:, None], np.array(right) / size) * scale
        v = (1 - lam) * v_r + lam * v_p
        r = burn_rate(lam, 1 / v, p, 0.0, material.burn)
        return [dv_r, de_r, dv_p, de_p, np.sqrt(m2) * v / r, 1.0 / r]

    # nascent products have the spike's pressure; isolation keeps the enthalpy, equilibrium the temperature
    v, e, p = 1 / spike.density, spike.specific_internal_energy, spike.pressure

    def nascent(v_p):
        e_p = e + q + p * (v - v_p)
        if closure == "thermal_equilibrium":
            target = eos.temperature(1 / v, e, react)
            e_p = brentq(lambda k: eos.temperature(1 / v_p, k, prod) - target, -2e7, 5e7, xtol=1e-6)
        return e_p

    v_p = brentq(lambda w: eos.pressure(1 / w, nascent(w), prod) - p, 0.6 * v, 2.0 * v, xtol=1e-18, rtol=1e-14)
    y, found, start = [v, e, v_p, nascent(v_p), 0.0, 0.0], [], 1e-9
    for end in until:
        y = list(solve_ivp(along, (start, end), y, method="DOP853", rtol=1e-10, atol=[1e-14, 1e-2, 1e-14, 1e-2, 1e-14, 1e-18]).y[:, -1])
        start = end
        found.append((y[4], y[5], eos.pressure(1 / y[0], y[1], react)))
    return np.array(found)


@pytest.mark.parametrize("closure", ["thermal_isolation", "thermal_equilibrium"])
def test_lx17_zone_against_an_integration_of_both_phases(closure):
    explosive = entry("LX-17 reactive")
    material, ahead = explosive.material, Initial.at_rest(explosive.material.unreacted)
    par = mixture(closure, material.unreacted, material.eos)
    for overdrive in (1.0, 1.2):
        found = znd(par, ahead, material.burn, overdrive=overdrive, points=30)
        rate = np.array([burn_rate(f, r, p, 0.0, material.burn) for f, r, p in zip(found.reaction, found.states.density, found.states.pressure)])
        assert found.rates == pytest.approx(rate, rel=1e-12)
        # the limits of the rate, where its slope jumps, are stations of the integration
        by_time = flow_by_time(explosive, closure, found.velocity, (0.02, 0.5, 0.8, 0.95))
        assert found.half_reaction_length == pytest.approx(by_time[1, 0], rel=2e-7)
        assert found.half_reaction_time == pytest.approx(by_time[1, 1], rel=2e-7)
        assert np.interp(0.95, found.reaction, found.states.pressure) == pytest.approx(by_time[3, 2], rel=2e-3)


@pytest.mark.parametrize("closure", ["thermal_isolation", "thermal_equilibrium", "weighted_pressures"])
def test_zone_of_a_mixture_obeys_the_conservation_laws_and_ends_at_cj(closure):
    explosive = entry("comp_b reactive").material
    ahead = Initial.at_rest(explosive.unreacted)
    found = znd(mixture(closure, explosive.unreacted, explosive.eos), ahead, explosive.burn, points=40)
    s, w = found.states, found.velocity - found.particle_velocity
    flux = ahead.density * found.velocity
    assert s.density * w == pytest.approx(np.full(40, flux), rel=1e-12)
    assert s.pressure + s.density * w**2 == pytest.approx(np.full(40, ahead.pressure + flux * found.velocity), rel=1e-12)
    enthalpy = s.energy + s.pressure / s.density + 0.5 * w**2
    assert enthalpy == pytest.approx(np.full(40, enthalpy[0]), rel=1e-12)
    # what drives the flow by the phases' volumes and energies is p_lambda by the laws' slopes, in every closure
    assert reaction_source(s, found.rates) == pytest.approx(s.pressure_by_burn_fraction * found.rates, rel=1e-8)
    # subsonic behind the shock, sonic where the burning ends: u + c - D vanishes as the root of what is left
    mach = w / s.sound_speed
    assert (mach[:-1] < 1.0).all() and mach[-1] == pytest.approx(1.0, abs=2e-3)
    assert (found.table()["thermicity"] > 0.0).all()


def test_arrhenius_sees_the_temperature_of_the_mixture():
    explosive = entry("LX-17 reactive").material
    par, ahead = mixture("thermal_equilibrium", explosive.unreacted, explosive.eos), Initial.at_rest(explosive.unreacted)
    law = Arrhenius(5e12, 2e4)
    found = znd(par, ahead, law, points=20, complete=0.999)
    assert found.rates == pytest.approx(5e12 * (1 - found.reaction) * np.exp(-2e4 / found.temperature), rel=1e-12)
    assert found.temperature == pytest.approx(found.states.temperature, rel=1e-14)


def test_what_has_no_zone_is_told():
    explosive = entry("LX-17 reactive").material
    par, ahead = mixture("thermal_isolation", explosive.unreacted, explosive.eos), Initial.at_rest(explosive.unreacted)
    with pytest.raises(OutOfRange, match="has no reaction rate"):
        znd(par, ahead, Programmed(7600.0))
    with pytest.raises(OutOfRange, match="burning never begins"):
        znd(par, ahead, IgnitionGrowth(1905.0, 0.0, 0.667, 0.22, 7.0, 4.5e-24, 0.667, 1.0, 3.0))
    with pytest.raises(OutOfRange, match="slower than the Chapman-Jouguet"):
        znd(par, ahead, explosive.burn, velocity=7000.0)
    with pytest.raises(OutOfRange, match="needs reactants"):
        znd(mixture("burned_products", None, explosive.eos), ahead, explosive.burn)


def test_many_states_are_those_of_few():
    """Above COMPILE_ABOVE states the solver is compiled: the same numbers to round-off."""
    explosive = entry("LX-17 reactive").material
    par = mixture("thermal_isolation", explosive.unreacted, explosive.eos)
    s = shock(explosive.unreacted, pressure=25e9)
    reference = (s.density, s.specific_internal_energy + par.detonation_energy)
    fractions = np.linspace(0.01, 1.0, mixtures.COMPILE_ABOVE + 10)
    many = mixtures.solve(*reference, fractions, par, reference=reference)
    few = mixtures.solve(*reference, fractions[::20], par, reference=reference)
    for name in ("pressure", "product_density", "reactant_energy", "sound_speed", "pressure_by_burn_fraction"):
        assert getattr(many, name)[::20] == pytest.approx(getattr(few, name), rel=1e-10), name


def test_a_zone_that_chokes_is_told_from_the_slowest_velocity_that_does_not():
    """Two gases of one specific heat in thermal equilibrium are a gas of gamma(lambda): where gamma falls, the slowest steady front is the
    fastest of the Chapman-Jouguet velocities of all partly burned gases, beyond that of the burned one."""
    before, after, q = IdealGas(1.67, 1000.0, 1.2), IdealGas(1.3, 1000.0, 1.2), 1e6
    par = mixture("thermal_equilibrium", before, after, q)
    ahead = Initial(1.2, 1e5, 1e5 / (0.67 * 1.2))

    def partly_burned(fraction):
        gamma = 1.0 + (1.0 - fraction) * 0.67 + fraction * 0.3
        return cj(IdealGas(gamma, 1000.0, 1.2), Initial(1.2, 1e5, ahead.energy + fraction * par.detonation_energy)).detonation_velocity

    slowest = max(partly_burned(f) for f in np.linspace(0.5, 1.0, 201).tolist())
    assert slowest > 1.01 * partly_burned(1.0)
    rate = PressurePower(1e6, 0.0, 0.5)
    with pytest.raises(OutOfRange, match="becomes sonic at burn fraction 0[.]"):
        znd(par, ahead, rate)
    with pytest.raises(OutOfRange, match="becomes sonic"):
        znd(par, ahead, rate, velocity=slowest * (1.0 - 1e-4), points=60)
    found = znd(par, ahead, rate, velocity=slowest * (1.0 + 1e-4), points=60)
    # beyond the fraction that is nearly sonic the reaction takes energy back and the flow is subsonic again
    assert found.table()["thermicity"][-5] < 0.0 and ((found.velocity - found.particle_velocity) < found.states.sound_speed).all()
