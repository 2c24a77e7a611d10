"""Burn laws one by one against closed solutions, tables read another way, and a fine integration of their equations."""

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import hugoniot.laws.burn  # noqa: F401  (enrols the laws)
from hugoniot.errors import OutOfRange
from hugoniot.laws.burn import contract, depletion, forest_fire, lighting
from hugoniot.laws.burn.arrhenius import Arrhenius
from hugoniot.laws.burn.contract import BURN
from hugoniot.laws.burn.ignition_growth import IgnitionGrowth
from hugoniot.laws.burn.jwl_plus_plus import JWLPlusPlus
from hugoniot.laws.burn.pressure_power import PressurePower
from hugoniot.laws.burn.programmed import Beta, Programmed, ProgrammedBeta
from hugoniot.laws.burn.threshold import Threshold

# (rho0, I, b, a, x, G1, c, d, y, G2, e, g, z, limits) of published calibrations: LX-17 (Kapila et al. 2007), C-4 (Urtiew et al. 2006),
# Composition B (Murphy et al. 1993) and PBX-9502 with reversed terms (Tarver and McGuire 2002)
CALIBRATIONS = {
    "LX-17": IgnitionGrowth(1905.0, 4e12, 0.667, 0.22, 7, 4.5e-24, 0.667, 1, 3, 3e-4, 0.667, 0.667, 1, 0.02, 0.8, 0.8),
    "C-4": IgnitionGrowth(1601.0, 4e12, 0.667, 0.0367, 7, 1.4e-14, 0.667, 0.333, 2, 0.0, 0.667, 0.667, 3, 0.022, 1.0, 0.0),
    "Comp B": IgnitionGrowth(1717.0, 4e12, 0.667, 0.0, 7, 8.5e-14, 0.222, 0.667, 2, 6.6e-25, 0.333, 1, 3, 0.022, 0.6, 0.0),
    "PBX-9502": IgnitionGrowth(1895.0, 4.4e11, 2 / 3, 0.214, 7, 6e-6, 2 / 3, 1 / 9, 1, 4e-25, 1 / 3, 1, 3, 0.5, 0.5, 0.0),
}


@pytest.mark.parametrize("name", CALIBRATIONS)
@pytest.mark.parametrize("p, compression", ((8e9, 1.25), (3e10, 1.4)))
def test_ignition_and_growth_against_a_fine_integration(name, p, compression):
    par = CALIBRATIONS[name]
    rho = par.rho0 * compression
    limits = sorted({par.ignition_limit, par.growth_limit, par.completion_limit, 1.0} - {0.0})
    for start in (0.0, 0.015, 0.3, 0.85):
        for dt in (3e-9, 3e-8, 3e-7):
            lam, t = start, 0.0
            for limit in (x for x in limits if x > start):
                def reach(_, y, limit=limit):
                    return y[0] - limit
                reach.terminal = True
                way = solve_ivp(lambda _, y, top=limit: [contract.rate(min(max(y[0], 0.0), top * (1 - 1e-15)), rho, p, 0.0, par)], (t, dt), [lam],
                                rtol=1e-10, atol=1e-13, max_step=dt / 20, events=reach)
                lam, t = float(min(way.y[0, -1], 1.0)), float(way.t[-1])
                if t >= dt * (1 - 1e-12):
                    break
            assert contract.advance(start, dt, rho, p, 0.0, par) == pytest.approx(lam, abs=5e-5)


def test_ignition_and_growth_terms_stop_at_their_limits():
    par = CALIBRATIONS["LX-17"]
    rho = 1905.0 * 1.4
    strength = 4e12 * (0.4 - 0.22) ** 7
    assert contract.rate(0.0, rho, 0.0, 0.0, par) == pytest.approx(strength, rel=1e-12)
    assert contract.rate(0.02, rho, 0.0, 0.0, par) == 0.0
    assert contract.rate(0.0, 1905.0 * 1.219, 3e10, 0.0, par) == 0.0
    # ignition alone ends exactly at its limit, however long the step
    assert contract.advance(0.0, 1.0, rho, 0.0, 0.0, par) == 0.02
    below, above = np.nextafter(0.8, 0.0), 0.8
    p = 3e10
    growth = 4.5e-24 * 0.2**0.667 * 0.8 * p**3
    completion = 3e-4 * 0.2**0.667 * 0.8**0.667 * p
    assert contract.rate(below, rho, p, 0.0, par) == pytest.approx(growth, rel=1e-9)
    assert contract.rate(above, rho, p, 0.0, par) == pytest.approx(completion, rel=1e-9)


def test_burning_ends_exactly_where_the_equation_does():
    """d(lambda)/dt = k (1 - lambda)^0.667 is over at t = 1/(0.333 k)."""
    par = IgnitionGrowth(1000.0, 0.0, 0.0, 0.0, 1.0, 1e-4, 0.667, 0.0, 1.0)
    end = 1.0 / (0.333 * 1e-4 * 1e10)
    assert contract.advance(0.0, 1.001 * end, 1500.0, 1e10, 0.0, par) == 1.0
    early = contract.advance(0.0, 0.9 * end, 1500.0, 1e10, 0.0, par)
    assert early == pytest.approx(1.0 - 0.1 ** (1 / 0.333), abs=2e-5)


def test_simple_depletion_of_fickett_and_rivard():
    """lambda = tau (2 - tau) for the rate 2 sqrt(1 - lambda), done at tau = 1 (B24)."""
    par = PressurePower(2.0e6, 0.0, 0.5)
    for tau in (0.1, 0.5, 0.99):
        assert contract.advance(0.0, tau * 1e-6, 0.0, 1e10, 0.0, par) == pytest.approx(tau * (2.0 - tau), rel=1e-13)
    assert contract.advance(0.0, 1.0e-6 * (1 + 1e-12), 0.0, 1e10, 0.0, par) == 1.0


@pytest.mark.parametrize("order", (0.0, 0.3, 1.0, 1.0 + 1e-7, 2.0))
def test_depletion_is_the_integral_of_its_rate(order):
    start, amount = 0.2, 0.5
    way = solve_ivp(lambda _, y: [(1.0 - y[0]) ** order], (0.0, amount), [start], rtol=1e-12, atol=1e-14)
    assert depletion.deplete(start, amount, order) == pytest.approx(way.y[0, -1], rel=1e-7 if 0 < abs(order - 1) < 1e-3 else 1e-11)


def test_exponential_laws():
    gain = 3.5e-7 * (2e10) ** 1.3 * 1e-8
    assert contract.advance(0.3, 1e-8, 0.0, 2e10, 0.0, JWLPlusPlus(3.5e-7, 1.3)) == pytest.approx(1.0 - 0.7 * math.exp(-gain), rel=1e-13)
    gain = 5e12 * math.exp(-2.6e4 / 2000.0) * 1e-7
    assert contract.advance(0.3, 1e-7, 0.0, 0.0, 2000.0, Arrhenius(5e12, 2.6e4)) == pytest.approx(1.0 - 0.7 * math.exp(-gain), rel=1e-12)


def test_threshold_burns_at_once_and_only_above():
    par = Threshold(2e10)
    assert contract.advance(0.0, 0.0, 0.0, 2e10, 0.0, par) == 0.0
    assert contract.advance(0.0, 0.0, 0.0, np.nextafter(2e10, 1e11), 0.0, par) == 1.0


def test_programmed_fraction_spreads_over_its_zones():
    """A.28: at B_s zones behind the front a zone is burned; the front itself has F = 0."""
    par, dx = Programmed(8000.0, 3.0), 1e-4
    lit = 5e-6
    for zones in (0.0, 0.75, 1.5, 3.0, 9.0):
        time = lit + zones * dx / 8000.0
        assert contract.scheduled(0.0, time, lit, dx, 0.0, par) == pytest.approx(min(zones / 3.0, 1.0), abs=1e-12)
    assert contract.scheduled(0.25, lit, lit, dx, 0.0, par) == 0.25


def test_beta_burn_is_done_at_the_cj_density_and_the_larger_fraction_wins():
    beta, both = Beta(1714.0, 2332.8), ProgrammedBeta(8000.0, 1714.0, 2332.8, 3.0)
    assert contract.scheduled(0.0, 0.0, 1.0, 1e-4, 2332.8, beta) == 1.0
    half = 1.0 / (1.0 / 1714.0 - 0.5 * (1.0 / 1714.0 - 1.0 / 2332.8))
    assert contract.scheduled(0.0, 0.0, 1.0, 1e-4, half, beta) == pytest.approx(0.5, rel=1e-12)
    assert contract.scheduled(0.0, 0.0, 1.0, 1e-4, half, both) == pytest.approx(0.5, rel=1e-12)
    assert contract.scheduled(0.0, 1e-5 + 2.4e-4 / 8000.0, 1e-5, 1e-4, half, both) == pytest.approx(0.8, rel=1e-12)


def test_forest_fire_polynomial_and_table_agree_on_a_power_law():
    """ln r = a + b p sampled into a table: equal at the nodes; the polynomial holds its value above p_max and nothing burns below p_min."""
    par = forest_fire.forest_fire((-3.0, 20.0), 2e9, 3e10)
    nodes = np.linspace(2.5e9, 3e10, 12)
    table = forest_fire.rate_table(nodes, 1e6 * np.exp(-3.0 + 20.0 * nodes / 1e11))
    for p in nodes:
        want = 1e6 * math.exp(-3.0 + 20.0 * p / 1e11)
        assert contract.rate(0.0, 0.0, p, 0.0, par) == pytest.approx(want, rel=1e-13)
        assert contract.rate(0.0, 0.0, p, 0.0, table) == pytest.approx(want, rel=1e-12)
    middle = math.sqrt(nodes[3] * nodes[4])
    assert contract.rate(0.0, 0.0, middle, 0.0, table) == pytest.approx(
        math.sqrt(contract.rate(0.0, 0.0, nodes[3], 0.0, table) * contract.rate(0.0, 0.0, nodes[4], 0.0, table)), rel=1e-12)
    assert contract.rate(0.0, 0.0, 2e9, 0.0, par) == 0.0 == contract.rate(0.0, 0.0, 2e9, 0.0, table)
    assert contract.rate(0.0, 0.0, 9e10, 0.0, par) == contract.rate(0.0, 0.0, 3e10, 0.0, par)


@pytest.mark.parametrize("pressures, rates, word", (
    ((1e9, 2e9, 1.5e9), (1.0, 2.0, 3.0), "row 3"), ((1e9, 2e9), (1.0, -2.0), "row 2"), ((1e9,), (1.0,), "same number of values"),
    ((1e9, float("nan")), (1.0, 2.0), "row 2")))
def test_bad_rate_tables_are_refused_with_the_row(pressures, rates, word):
    with pytest.raises(OutOfRange, match=word):
        forest_fire.rate_table(pressures, rates)


def test_lighting_times_from_points_on_any_side():
    edges = np.linspace(0.0, 0.1, 11)
    times = lighting.lighting_times(edges, [(0.0, 0.0)], 8000.0)
    assert np.allclose(times, edges[:-1] / 8000.0, rtol=0, atol=1e-18)
    times = lighting.lighting_times(edges, [(0.1, 2e-6)], 8000.0)
    assert np.allclose(times, 2e-6 + (0.1 - edges[1:]) / 8000.0, rtol=1e-14)
    both = lighting.lighting_times(edges, [(0.0, 0.0), (0.1, 2e-6), (0.055, 1e-6)], 8000.0)
    assert both[5] == 1e-6 and both[0] == 0.0 and both[9] == pytest.approx(2e-6)
    assert np.all(np.abs(np.diff(both)) <= 0.01 / 8000.0 * (1 + 1e-9))
    with pytest.raises(OutOfRange, match="outside the explosive"):
        lighting.lighting_times(edges, [(0.2, 0.0)], 8000.0)
    with pytest.raises(OutOfRange, match="at least one"):
        lighting.lighting_times(edges, [], 8000.0)
    with pytest.raises(OutOfRange, match="velocity"):
        lighting.lighting_times(edges, [(0.0, 0.0)], 0.0)


def test_lighting_times_from_lines_in_the_plane():
    points = np.array([[0.0, 3.0], [4.0, 4.0], [-3.0, -4.0]])
    times = lighting.lighting_times_of_points(points, [((0.0, 0.0), (1.0, 0.0), 0.5)], 2.0)
    assert np.allclose(times, 0.5 + np.array([3.0, 5.0, 5.0]) / 2.0)
    assert lighting.distance_to_segment([[3.0, 4.0]], (0.0, 0.0), (0.0, 0.0))[0] == 5.0


@pytest.mark.parametrize("name, change, word", (
    ("programmed", {"detonation_velocity": 0.0}, "detonation_velocity"), ("programmed", {"spread_zones": -1.0}, "spread_zones"),
    ("beta", {"rho_cj": 1700.0}, "rho_cj"), ("programmed_beta", {"rho0": float("nan")}, "rho0"),
    ("ignition_growth", {"g1": -1.0}, "g1"), ("ignition_growth", {"growth_limit": 1.2}, "growth_limit"),
    ("ignition_growth", {"rho0": 0.0}, "rho0")))
def test_impossible_constants_are_refused_by_name(name, change, word):
    law = BURN.get(name)
    assert law.build(**law.example._asdict()) == law.example
    with pytest.raises(OutOfRange, match=word):
        law.build(**(law.example._asdict() | change))


def test_names_cover_the_models_of_the_sources():
    assert {"threshold", "programmed", "beta", "programmed_beta", "ignition_growth", "jwl_plus_plus", "forest_fire", "pressure_power",
            "arrhenius"} <= set(BURN.names())


def test_burn_laws_compile_into_one_sweep_kernel():
    """The generic functions resolve inside a kernel to each law's own and give the same numbers as in Python."""
    import numba as nb

    from hugoniot.core import binder

    binder.bind_family(BURN, contract.GENERICS)
    binder.bind_module(depletion)
    binder.bind_module(contract)

    @nb.njit
    def sweep(lam, dt, time, lit, dx, rho, p, temperature, par):
        for j in range(lam.shape[0]):
            lam[j] = contract.scheduled(lam[j], time, lit, dx, rho, par)
            lam[j] = contract.advance(lam[j], dt, rho, p, temperature, par)

    for law in BURN:
        args = (3e-9, 5.02e-6, 5e-6, 1e-4, 2500.0, 2.5e10, 2500.0, law.example)
        lam = np.array([0.0, 0.01, 0.5, 0.995, 1.0])
        want = [contract.advance(contract.scheduled(x, *args[1:5], law.example), args[0], *args[4:7], law.example) for x in lam]
        sweep(lam, *args)
        assert np.allclose(lam, want, rtol=1e-12, atol=1e-15), law.name


@pytest.mark.parametrize("exponent", [0.0, 1.0, 2.0, 3.0, 2.5])
def test_whole_powers_are_the_powers(exponent):
    """The short cuts of `power` against Python's own, from 1e-3 to 40 GPa; nothing of what is not there but for the zeroth power."""
    for x in (1e6, 3.7e8, 4e10):
        assert depletion.power(x, exponent) == pytest.approx(x**exponent, rel=1e-13)
    assert depletion.power(0.0, exponent) == depletion.power(-1.0, exponent) == (1.0 if exponent == 0.0 else 0.0)
