"""Any equation of state in both modes: a piston that starts and stops, and what laws that are not smooth, or bear little, ask for."""

import dataclasses
from types import MappingProxyType

import pytest

from hugoniot.errors import UnphysicalState
from hugoniot.laws.eos.contract import EOS
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.laws.riemann.branch import Branch, State
from hugoniot.laws.riemann.fan import Fan
from hugoniot.laws.strength.contract import STRENGTH
from hugoniot.materials.material import Material
from hugoniot.problem import fronts
from hugoniot.problem.model import Boundary, Problem, Pulse, Region, SolverOptions
from hugoniot.simulate import make_solver
from hugoniot.theory.hugoniot import shock
from hugoniot.theory.isentrope import isentrope

FIXED, FREE = Boundary("fixed"), Boundary("free")
COPPER = MieGruneisen(rho0=8930.0, c0=3940.0, s=1.489, gamma0=1.99)


def pushed(law, mode, geometry="planar", stop=3e-6, side=0):
    """A layer between a wall and a piston that runs at 200 m/s for a microsecond, then stands."""
    state = {"pressure": 1e5} if "gas" in EOS.of(law).flags else {}
    piston = Boundary("velocity", Pulse("square", 200.0 if side == 0 else -200.0, 0.0, 1e-6))
    ends = (piston, FIXED) if side == 0 else (FIXED, piston)
    return Problem("pushed", geometry, stop, (Region("layer", "m", 0.01, 0.02, 40, **state),), {"m": Material("m", law)}, *ends,
                   solver=SolverOptions("fronts", options=MappingProxyType({"mode": mode})))


def marched(problem):
    solver = make_solver(problem)
    solver.march(problem.stop_time, 10**9)
    return solver


@pytest.mark.parametrize("side", [0, 1])
def test_a_gas_leaves_a_piston_that_is_drawn_away(side):
    """Products at 1 GPa run behind it into vacuum at less than its 8 km/s; the wall goes on alone, and what ran away is conserved."""
    problem = pushed(EOS.get("jwl").example, "cells", side=side)
    layer = dataclasses.replace(problem.regions[0], density=800.0, pressure=1e9)
    away = Boundary("velocity", Pulse("constant", -8e3 if side == 0 else 8e3, 1e-7))
    problem = dataclasses.replace(problem, regions=(layer,), **{"left" if side == 0 else "right": away})
    solver = marched(problem)
    assert solver.counts()["voids_opened"] == 1
    assert max(solver.errors().values()) < 1e-12
    _, kinds, _ = solver.front_table()
    assert "surface" in kinds


def test_a_release_across_the_leaps_of_a_table_is_a_fan_with_constant_states():
    """Where c leaps down at a line of the table, no characteristic between the two speeds has a state of its own."""
    law = EOS.get("table").example
    behind = shock(law, particle_velocity=200.0)
    ahead = State(float(behind.density), 200.0, float(behind.specific_internal_energy), float(behind.pressure))
    fan = Fan(ahead, Branch(law))
    start, end = fan.speed(fan.nodes[0]), fan.at_stress(0.0)
    last = end[2] + fan.speed(end)
    places = [fan.at_characteristic(start + share * (last - start)) for share in (0.02 * k for k in range(51))]
    assert all(b[0] <= a[0] + 1e-12 for a, b in zip(places, places[1:]))
    for node in places:
        point = fan.state(node, 1)
        assert float(isentrope(law, behind, density=point.rho).pressure) == pytest.approx(point.sigma, abs=1e-7 * ahead.sigma)


@pytest.mark.parametrize("mode", ["algebraic", "cells"])
def test_a_table_is_followed_through_shock_and_release(mode):
    solver = marched(pushed(EOS.get("table").example, mode, stop=2e-6))
    assert max(solver.errors().values()) < 1e-12


@pytest.mark.parametrize("mode", ["algebraic", "cells"])
def test_a_law_whose_tension_is_cut_off_stops_where_it_would_part(mode):
    law = EOS.get("tension_cutoff").example
    regions = (Region("flyer", "cu", 0.01, 0.012, 20, velocity=500.0), Region("target", "m", 0.012, 0.02, 40))
    problem = Problem("cut off", "planar", 6e-6, regions, {"m": Material("m", law), "cu": Material("cu", COPPER)}, FREE, FREE,
                      solver=SolverOptions("fronts", options=MappingProxyType({"mode": mode})))
    with pytest.raises(UnphysicalState, match="stretched to the largest tension that its law") as stopped:
        marched(problem)
    assert "lagrange1d" in str(stopped.value) and 1.8e-6 < stopped.value.time < 1.9e-6


def test_a_state_without_waves_at_the_start_is_told_with_a_remedy():
    law = EOS.get("mie_gruneisen").example
    problem = pushed(law, "algebraic")
    far = Problem("far", "planar", 1e-6, (Region("layer", "m", 0.0, 0.01, 4, velocity=-3e4),), problem.materials, FIXED, FIXED,
                  solver=problem.solver)
    with pytest.raises(UnphysicalState, match="where the first waves start") as stopped:
        make_solver(far)
    assert stopped.value.remedy


def test_a_law_of_shocks_alone_is_refused_in_cells():
    """It has isentropes, and the other mode follows them (test_fronts_energy_alone.py)."""
    (found,) = fronts.defects(pushed(EOS.get("shock_energy").example, "cells"))
    assert "square root of the energy" in found[1] and "algebraic" in found[1] and "mie_gruneisen" in found[1]
    assert fronts.defects(pushed(EOS.get("shock_energy").example, "algebraic")) == []


@pytest.mark.parametrize("name, reason", [("constant_poisson", "no constant shear modulus"), ("herrmann", "no constant shear modulus"),
                                          ("johnson_cook", "no constant yield stress")])
def test_strength_is_refused_for_what_it_lacks(name, reason):
    problem = pushed(COPPER, "cells")
    material = Material("m", COPPER, STRENGTH.get(name).example)
    found = fronts.defects(dataclasses.replace(problem, materials={"m": material}))
    assert len(found) == 1 and reason in found[0][1] and "lagrange1d" in found[0][1]


@pytest.mark.parametrize("pulse, refused", [
    (Pulse("half_sine", 5e8, 0.0, 1e-7), True), (Pulse("constant", 5e8, 1e-7), True), (Pulse("table", times=(0.0, 1e-6), values=(0.0, 1e8)), True),
    (Pulse("constant", 5e8), False), (Pulse("table", times=(0.0, 1e-6), values=(1e5, 1e8)), False)])
def test_a_pressure_that_comes_after_the_gas_has_gone_is_refused(pulse, refused):
    """It ended in a cell of negative density in the second step: a pressure on an edge without mass."""
    gas = pushed(EOS.get("ideal_gas").example, "cells")
    found = fronts.defects(dataclasses.replace(gas, left=Boundary("pressure", pulse)))
    assert [place for place, _ in found] == [("boundary", "left")] * refused
    solid = pushed(COPPER, "cells")
    assert not fronts.defects(dataclasses.replace(solid, left=Boundary("pressure", pulse)))


def test_a_shell_that_runs_into_the_axis_is_stopped():
    """In a sphere it comes to the highest density of its law before."""
    shell = Region("shell", "cu", 0.002, 0.004, 10, velocity=-1000.0)
    problem = Problem("collapse", "cylindrical", 1e-5, (shell,), {"cu": Material("cu", COPPER)}, FREE, FREE,
                      solver=SolverOptions("fronts", options=MappingProxyType({"mode": "cells"})))
    with pytest.raises(UnphysicalState, match="run into the axis or centre"):
        marched(problem)
