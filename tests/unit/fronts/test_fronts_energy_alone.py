"""A pressure that depends on the energy alone (shock_energy): shocks, releases to rest, surfaces and what is ill-posed, in closed form."""

import dataclasses
import math
from types import MappingProxyType

import pytest
from scipy.integrate import quad

from hugoniot.errors import OutOfRange, UnphysicalState
from hugoniot.laws.eos.contract import EOS
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.laws.eos.shock_energy import build
from hugoniot.laws.riemann import solver as exact
from hugoniot.laws.riemann.branch import Matter, State
from hugoniot.laws.riemann.curve import Curve
from hugoniot.laws.strength.perfectly_plastic import PerfectlyPlastic
from hugoniot.materials.material import Material
from hugoniot.problem import fronts
from hugoniot.problem.model import Boundary, Problem, Pulse, Region, SolverOptions
from hugoniot.simulate import make_solver

LAW = EOS.get("shock_energy").example
COPPER = MieGruneisen(rho0=8930.0, c0=3940.0, s=1.489, gamma0=1.99)
FREE, FIXED = Boundary("free"), Boundary("fixed")


def shocked(law, up):
    """The wave of a piston into material at rest."""
    (wave,) = exact.wall(Curve(Matter(law), State(law.rho0, 0.0, 0.0, 0.0), 1), up).right
    return wave


def run(regions, left=FREE, right=FREE, stop=6e-6, law=LAW, **options):
    problem = Problem("energy alone", "planar", stop, regions, {"m": Material("m", law), "cu": Material("cu", COPPER)}, left, right,
                      solver=SolverOptions("fronts", options=MappingProxyType({"mode": "algebraic", **options})))
    solver = make_solver(problem)
    solver.march(stop, 10**9)
    return solver


@pytest.mark.parametrize("s2", [0.0, 2e-5, -5e-5])
@pytest.mark.parametrize("up", [1.0, 300.0, 1500.0])
def test_the_hugoniot_from_rest_is_that_of_the_fit(s2, up):
    law = build(1770.0, 3080.0, 1.5, s2)
    wave, us = shocked(law, up), 3080.0 + 1.5 * up + s2 * up * up
    assert wave.behind.sigma == pytest.approx(1770.0 * us * up, rel=1e-12)
    assert wave.head == pytest.approx(us, rel=1e-12)
    assert 1.0 / wave.behind.rho == pytest.approx((1.0 - up / us) / 1770.0, rel=1e-12)


@pytest.mark.parametrize("s2", [0.0, 2e-5])
@pytest.mark.parametrize("up", [300.0, 1500.0])
def test_a_release_ends_at_rest_with_a_density_of_its_own(s2, up):
    """v - v1 = int de/p = int du/(rho0 Us), dw = sqrt((c0 + 2 s u + 3 s2 u^2)/Us) du; logarithmic where s2 = 0."""
    law = build(1770.0, 3080.0, 1.5, s2)
    behind = shocked(law, up).behind
    (fan,) = exact.surface(Curve(Matter(law), behind, -1), 0.0).left
    grown = quad(lambda u: 1.0 / (1770.0 * (3080.0 + 1.5 * u + s2 * u * u)), 0.0, up, epsabs=0.0, epsrel=1e-13)[0]
    gained = quad(lambda u: math.sqrt((3080.0 + 3.0 * u + 3.0 * s2 * u * u) / (3080.0 + 1.5 * u + s2 * u * u)), 0.0, up, epsrel=1e-13)[0]
    assert s2 or grown == pytest.approx(math.log(1.0 + 1.5 * up / 3080.0) / (1.5 * 1770.0), rel=1e-12)
    assert (fan.kind, fan.behind.sigma) == ("fan", 0.0)
    assert 1.0 / fan.behind.rho == pytest.approx(1.0 / behind.rho + grown, rel=1e-12)
    assert fan.behind.u == pytest.approx(behind.u + gained, rel=1e-12)
    assert fan.tail == pytest.approx(fan.behind.u - 3080.0 * 1770.0 / fan.behind.rho, rel=1e-9)


def test_a_straight_hugoniot_releases_in_a_jump():
    """s = 0: the impedance is constant, and a release is as sharp as its shock."""
    law = build(1770.0, 3080.0, 0.0)
    behind = shocked(law, 500.0).behind
    (wave,) = exact.surface(Curve(Matter(law), behind, -1), 0.0).left
    assert wave.kind == "shock" and wave.behind.u == pytest.approx(1000.0, rel=1e-12)
    assert wave.behind.rho == pytest.approx(1770.0, rel=1e-12)


def test_an_impact_is_conserved_and_its_free_surface_runs_as_it_should():
    solver = run((Region("flyer", "cu", 0.0, 0.004, 10, velocity=600.0), Region("plate", "m", 0.004, 0.008, 20)), stop=1.5e-6)
    assert max(solver.errors().values()) < 1e-12
    columns, kinds, rows = solver.front_table()
    surface = max(row[columns.index("velocity_left")] for kind, row in zip(kinds, rows.tolist()) if kind == "surface")
    p = next(row[columns.index("stress_left")] for kind, row in zip(kinds, rows.tolist()) if kind == "interface" and row[0] == 0.0)
    up = 2.0 * p / 1770.0 / (3080.0 + math.sqrt(3080.0**2 + 4.0 * 2.01 * p / 1770.0))
    gained = quad(lambda u: math.sqrt((3080.0 + 4.02 * u) / (3080.0 + 2.01 * u)), 0.0, up, epsrel=1e-12)[0]
    assert surface == pytest.approx(up + gained, rel=1e-9)


@pytest.mark.parametrize("left", [Boundary("velocity", Pulse("constant", -50.0)), Boundary("velocity", Pulse("square", 200.0, 0.0, 1e-6))])
def test_where_it_would_be_pulled_a_surface_opens(left):
    """No tension: it leaves a piston that draws back or stops, and the budgets close."""
    solver = run((Region("plate", "m", 0.0, 0.01, 20),), left, FIXED, 4e-6)
    assert max(solver.errors().values()) < 1e-8
    assert solver.tensions.max() == 0.0


def test_where_the_impedance_falls_a_shock_is_refused():
    """s2 below zero: beyond the largest impedance a shock would be overtaken by nothing; weaker ones are followed."""
    law = build(1770.0, 3080.0, 1.5, -2e-4)
    assert shocked(law, 1000.0).behind.sigma > 0.0
    with pytest.raises(OutOfRange, match="outrun the sound behind it"):
        shocked(law, 4500.0)
    with pytest.raises(UnphysicalState, match="outrun the sound behind it"):
        run((Region("plate", "m", 0.0, 0.01, 20),), Boundary("velocity", Pulse("constant", 4500.0)), law=law)


def test_what_is_ill_posed_is_refused_with_a_reason():
    problem = Problem("refused", "planar", 1e-6, (Region("plate", "m", 0.0, 0.01, 20),), {"m": Material("m", build(1770.0, 3080.0, 1.5, -1e-5))},
                      solver=SolverOptions("fronts", options=MappingProxyType({"mode": "cells"})))
    (found,) = [message for _, message in fronts.defects(problem)]
    assert "square root" in found and "algebraic" in found
    strong = dataclasses.replace(problem, materials={"m": Material("m", LAW, PerfectlyPlastic(5e9, 1e8))})
    assert any("supports no tension" in message for _, message in fronts.defects(strong))
