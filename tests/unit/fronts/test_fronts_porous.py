"""Pores that stay crushed, in exact waves: two-wave shocks, release, reloading and spreading compaction against answers of the laws alone."""

import math
import random
import warnings
from types import MappingProxyType, SimpleNamespace

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from hugoniot.errors import HugoniotError
from hugoniot.laws.eos import p_lambda
from hugoniot.laws.eos.contract import EOS, pressure, reference_state, remembered, temperature
from hugoniot.laws.riemann import solver as exact
from hugoniot.laws.riemann.branch import Matter, State, wave_speed_squared
from hugoniot.laws.riemann.curve import Curve
from hugoniot.laws.strength.perfectly_plastic import PerfectlyPlastic
from hugoniot.materials.material import Material
from hugoniot.problem import fronts
from hugoniot.problem.model import Boundary, Problem, Pulse, Region, SolverOptions
from hugoniot.simulate import make_solver
from hugoniot.solvers.fronts.cutting import slices
from hugoniot.solvers.fronts.line import Piece, content, densities
from porous_impacts import ALPHA0, COPPER, FREE, LAWS, P_E, P_S, REST, SOLID, impact, marched, table


# -- the answers of the solid's law alone -------------------------------------------------------------------------------
def energy(p, v, p0, v0, e0):
    return e0 + 0.5 * (p + p0) * (v0 - v)


def published_density(p, alpha, p0, v0, e0):
    """Density behind a jump to p at which the solid, alpha times as dense, has the pressure alpha p."""
    def miss(solid):
        return pressure(solid, energy(p, alpha / solid, p0, v0, e0), SOLID) - alpha * p
    return brentq(miss, 2000.0, 6000.0, xtol=1e-12, rtol=1e-15) / alpha


def two_waves(p, compaction=0.0, e0=0.0, v0=None):
    """[(p, density, energy, velocity, mass flux)] behind the precursor and behind the crushing shock to p, from rest at zero pressure."""
    alpha1 = 1.0 + (ALPHA0 - 1.0) * (1.0 - compaction)
    limit = P_S - (P_S - P_E) * math.sqrt(1.0 - compaction)
    v0 = v0 or alpha1 / 2700.0
    rho1 = published_density(limit, alpha1, 0.0, v0, e0)
    e1 = energy(limit, 1.0 / rho1, 0.0, v0, e0)
    u1 = math.sqrt(limit * (v0 - 1.0 / rho1))
    alpha2 = 1.0 if p >= P_S else 1.0 + (ALPHA0 - 1.0) * ((P_S - p) / (P_S - P_E)) ** 2
    rho2 = published_density(p, alpha2, limit, 1.0 / rho1, e1)
    e2, x2 = energy(p, 1.0 / rho2, limit, 1.0 / rho1, e1), 1.0 / rho1 - 1.0 / rho2
    return [(limit, rho1, e1, u1, limit / u1), (p, rho2, e2, u1 + math.sqrt((p - limit) * x2), math.sqrt((p - limit) / x2))]


def copper_velocity(p):
    """Particle velocity of copper shocked from rest to p, by Us = c0 + s up."""
    return brentq(lambda u: 8930.0 * (3940.0 + 1.489 * u) * u - p, 0.0, 5000.0, xtol=1e-14, rtol=1e-15)


@pytest.mark.parametrize("speed", [60.0, 150.0, 700.0])
def test_an_impact_sends_out_a_precursor_and_the_shock_that_crushes(speed):
    """Partly crushed at 60 and 150 m/s, solid at 700 m/s; states and speeds by root finding with the law of the solid alone."""
    p = brentq(lambda p: two_waves(p)[1][3] + copper_velocity(p) - speed, 1.001 * P_E, 2e10, xtol=1e-6, rtol=1e-15)
    first, second = two_waves(p)
    found = {kind: row for kind, row in table(marched(impact(LAWS["p_alpha"], speed, 0.4e-6))) if row["direction"] > 0 and row["time"] == 0}
    assert sorted(found) == ["elastic shock", "shock"]
    for kind, (sigma, rho, e, u, flux), (ahead, moving) in (("elastic shock", first, (REST, 0.0)), ("shock", second, (first[1], first[3]))):
        row = found[kind]
        for name, value in (("stress", sigma), ("density", rho), ("energy", e), ("velocity", u)):
            assert row[f"{name}_left"] == pytest.approx(value, rel=1e-10)
        assert row["velocity"] == pytest.approx(moving + flux / ahead, rel=1e-10)


def test_the_compaction_behind_a_shock_is_that_of_the_crush_curve():
    solver = marched(impact(LAWS["p_alpha"], 150.0, 1e-6))
    zones = solver.state().zones
    p, k = zones["pressure"][4], zones["compaction"][4]
    assert P_E < p < P_S and k == pytest.approx(1.0 - ((P_S - p) / (P_S - P_E)) ** 2, rel=1e-10)
    assert zones["compaction"][-5] == 0.0      # of the foam: not reached yet
    assert (zones["compaction"][:4] == 0.0).all()


@pytest.mark.parametrize("name", LAWS)
@pytest.mark.parametrize("speed", [100.0, 400.0, 1500.0])
def test_mass_momentum_and_energy_are_conserved(name, speed):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        solver = marched(impact(LAWS[name], speed, 4e-6, weakest=1e-14), most=40)
    assert max(solver.errors().values()) < 1e-12 and solver.cycle >= 20


@pytest.mark.parametrize("up", [60.0, 150.0, 500.0])
def test_crushed_material_releases_along_its_solid(up):
    """de = -p dv of the solid at the alpha that the shock has left, to zero pressure; the density of rest but for the heat of the shock."""
    law = LAWS["p_alpha"]
    behind = exact.wall(Curve(Matter(law), State(REST, 0.0, 0.0, 0.0), 1), up).right[-1].behind
    alpha = 1.0 + (ALPHA0 - 1.0) * (1.0 - behind.compaction)
    (fan,) = exact.surface(Curve(Matter(law), behind, -1), 0.0).left
    start = (alpha * behind.rho, behind.e)

    def rates(log_density, y):
        p = pressure(math.exp(log_density), y[0], SOLID)
        c2 = float(EOS.of(SOLID).functions["pressure_derivatives"](math.exp(log_density), y[0], SOLID)[0]) + (
            p * EOS.of(SOLID).functions["pressure_derivatives"](math.exp(log_density), y[0], SOLID)[1] / math.exp(2.0 * log_density))
        return [p / math.exp(log_density), math.sqrt(c2)]

    def empty(log_density, y):
        return pressure(math.exp(log_density), y[0], SOLID)
    empty.terminal = True
    found = solve_ivp(rates, (math.log(start[0]), math.log(start[0]) - 0.2), [start[1], 0.0], events=empty, rtol=1e-12, atol=1e-9)
    assert fan.kind == "fan" and fan.behind.compaction == behind.compaction
    assert fan.behind.rho == pytest.approx(math.exp(found.t[-1]) / alpha, rel=1e-9)
    assert fan.behind.u == pytest.approx(behind.u - found.y[1, -1], rel=1e-9)
    rest = reference_state(remembered(behind.compaction, law))[0]
    hot = pressure(2700.0, fan.behind.e, SOLID) / (2700.0 * 5350.0**2)      # the strain that this heat makes
    assert fan.behind.rho == pytest.approx(rest * (1.0 - hot), rel=2.0 * hot**2 + 1e-9)


def test_partly_crushed_material_is_elastic_up_to_where_it_was_crushed():
    """Released, then hit harder: a precursor to the raised elastic limit, then the crush curve goes on."""
    law, compaction = LAWS["p_alpha"], 0.5
    v0 = (1.0 + (ALPHA0 - 1.0) * (1.0 - compaction)) / 2700.0
    ahead = State(1.0 / v0, 0.0, 0.0, 0.0, 0.0, compaction)
    p = 0.5e9
    wanted = two_waves(p, compaction)
    found = Curve(Matter(law), ahead, 1).waves(p)
    assert [(wave.kind, wave.elastic) for wave in found] == [("shock", True), ("shock", False)]
    for wave, (sigma, rho, e, u, _) in zip(found, wanted):
        assert (wave.behind.sigma, wave.behind.rho, wave.behind.e, wave.behind.u) == pytest.approx((sigma, rho, e, u), rel=1e-10)
    assert found[0].behind.compaction == compaction < found[1].behind.compaction
    assert len(Curve(Matter(law), ahead, 1).waves(0.9 * wanted[0][0])) == 1


@pytest.mark.parametrize("name", ["p_alpha", "snow_plough", "p_lambda, n = 1"])
def test_a_strong_shock_is_one(name):
    """Where the crushing shock would outrun its precursor both are one jump, from the state ahead to the solid."""
    law = LAWS[name]
    rho, e = reference_state(law)
    (wave,) = exact.wall(Curve(Matter(law), State(rho, 0.0, e, 0.0), 1), 4000.0).right
    solid = pressure(wave.behind.rho, wave.behind.e, SOLID)
    assert wave.behind.compaction == pytest.approx(1.0, abs=1e-15) and wave.behind.sigma == pytest.approx(solid, rel=1e-10)
    assert wave.behind.sigma == pytest.approx(rho * wave.head * 4000.0, rel=1e-12)


def test_closed_pores_are_the_solid():
    """The snow-plough behind its ramp, and p_alpha above the compaction pressure, shocked again: waves of the solid's own law."""
    state = State(2800.0, 0.0, 2e5, float(pressure(2800.0, 2e5, SOLID)), 0.0, 1.0)
    for name in ("p_alpha", "snow_plough"):
        for p in (0.0, 1e10, 5e10):
            ours, solid = (Curve(Matter(law), state, 1).waves(p)[0].behind for law in (LAWS[name], SOLID))
            assert (ours.rho, ours.u, ours.e) == pytest.approx((solid.rho, solid.u, solid.e), rel=1e-12)


# -- compaction that spreads --------------------------------------------------------------------------------------------
def matrix_path(top):
    """(p, v, e, u) along the crush curve of p_lambda with n = 1.2 from rest, by its own equation in the pressure: dense output in ln p."""
    law = LAWS["p_lambda"]

    def solid_volume(p, e):
        return 1.0 / brentq(lambda rho: pressure(rho, e, SOLID) - p, 2300.0, 4000.0, xtol=1e-12, rtol=1e-15)

    def volume(p, e):
        left = math.exp(-((p / law.crush_strength) ** law.exponent))
        return (1.0 - left) * solid_volume(p, e) + left / (law.rho_porous * (1.0 + p / law.matrix_modulus))

    def slope(p, e):
        """dv/dp along de = -p dv."""
        by_p = (volume(p * 1.0001, e) - volume(p * 0.9999, e)) / (2e-4 * p)
        by_e = (volume(p, e + 10.0) - volume(p, e - 10.0)) / 20.0
        return by_p / (1.0 + p * by_e)

    def rates(log_p, y):
        p, dv = math.exp(log_p), slope(math.exp(log_p), y[0])
        return [-p * dv * p, math.sqrt(-dv) * p]
    found = solve_ivp(rates, (math.log(1.0), math.log(top)), [0.0, 0.0], rtol=1e-9, atol=1e-12, dense_output=True)
    return lambda p: (volume(p, found.sol(math.log(p))[0]), *found.sol(math.log(p)), slope(p, found.sol(math.log(p))[0]))


def test_compaction_that_begins_gently_spreads_ahead_of_its_shock():
    """p_lambda with n = 1.2 to 40 MPa: a fan alone; to 300 MPa: a fan, and a shock from where their speeds are one."""
    law = LAWS["p_lambda"]
    path = matrix_path(1e8)
    curve = Curve(Matter(law), State(2100.0, 0.0, 0.0, 0.0), 1)
    (fan,) = curve.waves(4e7)
    v, e, u, dv = path(4e7)
    assert (fan.kind, fan.attached) == ("fan", False)
    assert (fan.behind.rho, fan.behind.e, fan.behind.u) == pytest.approx((1.0 / v, e, u), rel=2e-6)
    assert fan.tail == pytest.approx(u + v * math.sqrt(-1.0 / dv), rel=2e-6)
    fan, shock = curve.waves(3e8)
    assert shock.attached and shock.head == fan.tail and shock.behind.compaction > fan.behind.compaction > 0.0
    v, e, u, dv = path(fan.behind.sigma)
    assert (fan.behind.rho, fan.behind.u) == pytest.approx((1.0 / v, u), rel=2e-6)
    flux = (shock.head - shock.ahead.u) * shock.ahead.rho
    assert flux**2 == pytest.approx(-1.0 / dv, rel=1e-5)
    jump = shock.ahead.e + 0.5 * (3e8 + shock.ahead.sigma) * (1.0 / shock.ahead.rho - 1.0 / shock.behind.rho)
    assert shock.behind.e == pytest.approx(jump, rel=1e-12)
    assert pressure(shock.behind.rho, shock.behind.e, law) == pytest.approx(3e8, rel=1e-10)


def test_a_spreading_wave_and_its_shock_share_a_front():
    """In the table of fronts: the head of the fan and, at its tail, the shock alone; the contents of the fan are exact."""
    solver = marched(impact(LAWS["p_lambda"], 150.0, 0.3e-6, zones=(4, 24, 4), weakest=1e-14))
    assert [kind for kind, row in table(solver) if row["direction"] > 0] in (["shock", "compaction fan head"], ["compaction fan head", "shock"])
    assert max(solver.errors().values()) < 1e-13
    zones = solver.state().zones
    assert (np.diff(zones["compaction"][4:28]) <= 0.0).all() and len(set(zones["compaction"][4:28])) > 3


@pytest.mark.parametrize("direction", [-1, 1])
def test_a_compaction_fan_is_cut_where_its_sound_speed_changes(direction):
    """With an exponent of 2 the velocity changes by a tenth of the sound speed, which falls to a quarter: two slices were not enough."""
    law = p_lambda.build(SOLID, 2100.0, 25e9, 0.4e9, 2.0)
    matter = Matter(law)
    (fan,) = Curve(matter, State(2100.0, 0.0, 0.0, 0.0), direction).waves(2.4e8)
    piece, bench, edges = Piece("fan", 0, fan.ahead, fan), SimpleNamespace(fan_step=0.1, matters=[matter]), sorted((1e-6 * fan.head, 1e-6 * fan.tail))
    places, found = slices(piece, *edges, 1e-6, bench)
    speeds = [math.sqrt(wave_speed_squared(one.state.rho, one.state.e, fan.path.branch)) for one in found][::-direction]
    assert (places[0], places[-1]) == tuple(edges) and (np.diff(places) > 0.0).all()
    assert len(found) > 10 and all(1.0 < a / b < 1.25 for a, b in zip(speeds, speeds[1:]))
    assert np.abs(np.diff([one.state.sigma for one in found])).max() < 0.15 * fan.behind.sigma
    held = sum(densities(one.state) * (b - a) for one, a, b in zip(found, places, places[1:]))
    assert held == pytest.approx(content(piece, *edges, 1e-6), rel=1e-12)


# -- runs ---------------------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("name, speed", [("p_alpha", 150.0), ("snow_plough", 60.0), ("p_lambda", 200.0)])
def test_lagrange1d_tends_to_the_same_plateau(name, speed):
    """Behind the first shock, in the middle of what it has crossed; 0.5 % is its own error at that mesh."""
    stop, law = 1e-6, LAWS[name]
    ours = marched(impact(law, speed, stop, thick=0.006))
    theirs = marched(impact(law, speed, stop, solver="lagrange1d", zones=(133, 400, 60), thick=0.006))
    zones, state = theirs.state().zones, theirs.state()
    x = 0.5 * (state.position_left + state.position_right)
    front = max(row["end_position"] for kind, row in table(ours) if kind == "shock" and row["direction"] > 0 and row["end_time"] == stop)
    face = state.position_left[133]
    here = np.flatnonzero((x > face + 0.1 * (front - face)) & (x < face + 0.5 * (front - face)))
    column = ours.column(1)
    share = float(np.mean(here) - 133 + 0.5) / 400
    point = column.at(share)[1]
    assert np.mean(zones["pressure"][here]) == pytest.approx(point.pressure, rel=5e-3)
    assert np.mean(zones["compaction"][here]) == pytest.approx(point.compaction, rel=1e-2)


@pytest.mark.parametrize("name", ["p_alpha", "p_lambda"])
def test_a_mirrored_problem_has_the_mirrored_answer(name):
    one, other = (marched(impact(LAWS[name], 300.0, 1.05e-6, mirrored=way, weakest=1e-14), most=12) for way in (False, True))
    assert one.cycle == other.cycle == 12
    zones, mirrored = one.state().zones, other.state().zones
    for field in ("density", "pressure", "compaction"):
        assert zones[field] == pytest.approx(mirrored[field][::-1], rel=1e-9, abs=1e-9 * np.abs(zones[field]).max())


@pytest.mark.parametrize("name", ["p_alpha", "snow_plough", "p_lambda"])
def test_a_resumed_run_has_the_same_bits(name):
    problem = impact(LAWS[name], 300.0, 1.1e-6, weakest=1e-4)
    whole, first = marched(problem), marched(problem, 0.5e-6)
    second = make_solver(problem)
    second.restore(first.payload())
    second.march(problem.stop_time, 10**9)
    for field, values in whole.state().fields().items():
        assert (values == second.state().fields()[field]).all(), field
    assert table(whole) == table(second)


def test_gauges_and_temperatures_know_the_compaction(tmp_path):
    from hugoniot.simulate import run
    problem = impact(LAWS["p_alpha"], 300.0, 1e-6)
    made = run(problem, tmp_path / "porous.run")
    gauges, last = made.arrays("gauges"), made.arrays("snapshots")
    k = gauges["compaction"][:, 0]
    assert k[0] == 0.0 and 0.9 < k[-1] <= 1.0 and (np.diff(k) >= 0.0).all()
    law = remembered(float(last["compaction"][-1][5]), LAWS["p_alpha"])
    assert last["temperature"][-1][5] == pytest.approx(temperature(last["density"][-1][5], last["energy"][-1][5], law), rel=1e-10)


def random_problem(seed):
    """Three to five layers, half of them porous, at random velocities."""
    rng = random.Random(seed)
    x, regions, materials = 0.0, [], {}
    for j in range(rng.randint(3, 5)):
        name = rng.choice([*LAWS] if j % 2 else ["copper", "gas"])
        law = {"copper": COPPER, "gas": EOS.get("ideal_gas").example}.get(name) or LAWS[name]
        if name == "p_lambda" and rng.random() < 0.7:
            law = LAWS["p_alpha"]
        width = rng.uniform(0.5e-3, 4e-3)
        start = {"pressure": 10.0 ** rng.uniform(4, 6)} if name == "gas" else {}
        materials[f"m{j}"] = Material(f"m{j}", law)
        regions.append(Region(f"r{j}", f"m{j}", x, x + width, 3, velocity=rng.uniform(-1.0, 1.0) * 10.0 ** rng.uniform(1, 3.3), **start))
        x += width
    ends = [rng.choice([FREE, Boundary("fixed"), Boundary("velocity", Pulse("constant", rng.uniform(-200.0, 200.0)))]) for _ in range(2)]
    return Problem("random", "planar", 5e-6, tuple(regions), materials, *ends,
                   solver=SolverOptions("fronts", options=MappingProxyType({"weakest": 1e-14})))


def test_sixty_random_problems_are_followed_or_stop_clearly():
    stopped = []
    for seed in range(60):
        try:
            solver = marched(random_problem(seed), most=12)
        except HugoniotError as stop:
            stopped.append((seed, str(stop)))
            continue
        assert max(solver.errors().values()) < 1e-12, (seed, solver.errors())
    assert len(stopped) <= 3, stopped


def test_pores_with_strength_are_refused_with_a_reason():
    problem = impact(LAWS["p_alpha"], 100.0)
    strong = Material("foam", LAWS["p_alpha"], PerfectlyPlastic(26e9, 0.3e9))
    for mode in ("algebraic", "cells"):
        given = Problem(**{**vars(problem), "materials": {**problem.materials, "foam": strong},
                           "solver": SolverOptions("fronts", options=MappingProxyType({"mode": mode}))})
        assert any("strength and pores" in message and "lagrange1d" in message for _, message in fronts.defects(given))


def test_what_waves_that_are_left_out_carry_is_warned_of():
    """The precursor and what it meets are weaker than a hundredth: without them per cents of the energy are missing."""
    coarse, fine = (marched(impact(LAWS["p_alpha"], 60.0, 1.2e-6, **options)) for options in ({"weakest": 0.01}, {}))
    assert any("were left out" in warning for warning in coarse.warnings()) and max(coarse.errors().values()) > 1e-3
    assert not any("were left out" in warning for warning in fine.warnings()) and max(fine.errors().values()) < 1e-5
