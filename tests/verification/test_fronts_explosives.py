"""Explosives in the cells of tracked fronts against exact solutions: products that escape, and a steady reaction zone."""

import math
from types import MappingProxyType

import numpy as np
import pytest

from hugoniot.laws.burn.pressure_power import PressurePower
from hugoniot.laws.burn.programmed import Programmed
from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.materials.material import Material
from hugoniot.problem.model import Boundary, Lighting, Problem, Pulse, Region, SolverOptions
from hugoniot.solvers.fronts.cells.solver import Cells
from hugoniot.solvers.fronts.cells.tables import LAM, RHO, P
from hugoniot.theory.exact.ehep import ehep
from hugoniot.theory.exact.fickett_rivard import fickett_rivard

D, RHO0 = 8500.0, 1600.0
CELLS = SolverOptions("fronts", options=MappingProxyType({"mode": "cells", "burn_step": 0.0}))      # a mesh as fine as it is given


def errors_of(problem, exact, until, scales):
    """Solver, and mean differences between cells and averages of the exact fields over them, {row: (name, scale)}, up to the front."""
    solver = Cells(problem)
    while solver.time < until:
        solver.march(until, 10**9)
    assert max(solver.errors().values()) < 1e-12
    mesh, last = solver.mesh, max(f for f, front in zip(solver.mesh.faces(), solver.mesh.fronts) if front.kind != "end")
    rows = solver.flow.look(mesh)[:, :last]
    x = mesh.x[:last, None] + mesh.width[:last, None] * (np.arange(16) + 0.5) / 16
    fields = exact(x.ravel(), until)
    gaps = [np.abs(rows[row] - fields[name].reshape(x.shape).mean(axis=1)) / scale for row, (name, scale) in scales.items()]
    return solver, np.array(gaps) @ mesh.width[:last] / (mesh.x[last] - mesh.x[0])


def escaping(zones, until):
    """A slab lit at a piston; its products escape into vacuum from its end on."""
    explosive = Material("he", IdealGas(3.0, rho0=RHO0), burn=Programmed(D), detonation_energy=D * D / 16.0)
    slab = Problem("slab", "planar", 4e-6, (Region("charge", "he", 0.0, 0.01, zones, density=RHO0),), {"he": explosive},
                   Boundary("velocity", Pulse("constant", 500.0)), Boundary("free"), solver=CELLS, lighting=(Lighting(0.0),))
    return errors_of(slab, ehep(), until, {RHO: ("density", RHO0), P: ("pressure", RHO0 * D * D / 4.0)})


def test_products_in_front_of_a_piston_are_exact_until_they_escape():
    solver, (density, _) = escaping(50, 1e-6)
    assert density < 1e-12
    front, place = next((front, x) for front, x in zip(solver.mesh.fronts, solver.mesh.x[solver.mesh.faces()]) if front.kind == "detonation")
    assert place == pytest.approx(1e-6 * D, rel=1e-13) and front.speed == pytest.approx(D, rel=1e-12)


@pytest.mark.parametrize("until", [2e-6, 3.5e-6])       # before and after the escape wave meets the piston
def test_products_that_escape_into_vacuum(until):
    """The gas front goes on at D; behind it the sound speed rises from zero. A cell of negative internal energy there is merged with the next."""
    (_, coarse), (solver, fine) = (escaping(zones, until) for zones in (50, 200))
    assert (fine < (1.2e-4, 5e-5)).all() and np.log2(coarse[1] / fine[1]) / 2.0 > 1.5
    kinks = [(front.kind, front.direction) for front in solver.mesh.fronts if "fan" in front.kind]      # both go on where they have crossed
    assert kinks == [("fan head", -1 if until < 3e-6 else 1), ("fan tail", 1)]
    assert solver.mesh.x[-1] == pytest.approx(D * until, rel=2e-5)
    assert solver.changes.joined and "merged" in solver.warnings()[0]


@pytest.mark.slow
def test_the_reaction_zone_of_simple_depletion():
    """Three quarters have burned at a piston that moves as the material does; some pressure ahead, for rounding: 3e-7 of the spike."""
    exact, rate, until = fickett_rivard(), 2e6, 0.5e-6
    fuel = IdealGas(3.0, 1000.0, RHO0)
    material = Material("he", fuel, burn=PressurePower(rate, 0.0, 0.5, 1e9, 1e9), unreacted=fuel, mixture="weighted_pressures",
                        detonation_energy=exact.numbers["heat_of_reaction"])
    times = np.linspace(0.0, 2.0 / rate, 2001)
    piston = Pulse("table", times=tuple(times.tolist()), values=tuple((D / 4.0 * (2.0 - 0.5 * rate * times)).tolist()))
    scales = {RHO: ("density", RHO0), P: ("pressure", exact.numbers["vn_pressure"]), LAM: ("burn_fraction", 1.0)}

    def found(per_mm):
        length = 1.1 * D * until
        charge = Problem("zone", "planar", until, (Region("charge", "he", 0.0, length, round(per_mm * 1e3 * length), density=RHO0, pressure=1e4),),
                         {"he": material}, Boundary("velocity", piston), Boundary("fixed"), solver=CELLS)
        solver, errors = errors_of(charge, exact, until, scales)
        return np.append(errors, abs(float(solver.mesh.x[solver.mesh.faces()[1]]) / (D * until) - 1.0))
    coarse, fine = found(10), found(40)
    assert (fine < (5e-6, 2e-6, 7e-6, 2e-6)).all() and math.log2(float(np.exp(np.log(coarse / fine).mean()))) / 2.0 > 1.8
