"""The mixture's search over whole runs: 1e8 zone-steps, every solved state checked apart from the search that found it.

A search that does not converge stops the run in that cycle (`watch`), so a run that ends had none. That an answer called converged is
one is checked here from the equations of state alone.
"""

import dataclasses

import numpy as np
import pytest
from reactive_builders import driven

from hugoniot.laws.arrays import pressure_array, temperature_array
from hugoniot.materials import burning, library
from hugoniot.problem.model import Problem
from hugoniot.simulate import make_solver
from hugoniot.solvers.lagrange1d.layout import B, Z

# closure, explosive, piston (m/s), length (m), zones, stop (s), geometry: initiation, growth, detonation and the burned state behind it
RUNS = [
    ("thermal_isolation", "LX-17 reactive", 1400.0, 0.02, 5000, 2.4e-6, "planar"),
    ("thermal_isolation", "LX-17 reactive", 1800.0, 0.02, 2500, 2.4e-6, "spherical"),
    ("thermal_equilibrium", "LX-17 reactive", 1400.0, 0.02, 1500, 2.4e-6, "planar"),
    ("weighted_pressures", "LX-17 reactive", 1800.0, 0.02, 2500, 2.0e-6, "cylindrical"),
]
CYCLES = 2000       # between two checks


def worst_defects(zones, charge, mixture):
    """(pressure of both phases, sums of volume and energy, temperatures) of all burning zones: largest relative defects."""
    lam = charge[B.lam]
    here = (lam > 1e-6) & (lam < 1.0 - 1e-6) & (zones[Z.p] > 1e8)
    if not here.any():
        return 0.0, 0.0, 0.0
    rho, e, p = (zones[k, here] for k in (Z.rho, Z.e, Z.p))
    lam, rho_r, e_r, rho_p, e_p = (charge[k, here] for k in (B.lam, B.rho_r, B.e_r, B.rho_p, B.e_p))
    thermal = e_r - mixture.detonation_energy
    apart = np.maximum(np.abs(pressure_array(rho_r, thermal, mixture.reactants) / p - 1.0),
                       np.abs(pressure_array(rho_p, e_p, mixture.products) / p - 1.0))
    volume = ((1.0 - lam) / rho_r + lam / rho_p) * rho - 1.0
    energy = ((1.0 - lam) * e_r + lam * e_p) / e - 1.0
    heat = temperature_array(rho_r, thermal, mixture.reactants) / temperature_array(rho_p, e_p, mixture.products) - 1.0
    return apart.max(), max(np.abs(volume).max(), np.abs(energy).max()), np.abs(heat).max()


@pytest.mark.slow
def test_no_search_fails_and_no_answer_is_wrong_in_1e8_zone_steps():
    total, burned = 0, []
    for closure, name, speed, length, zones, stop, geometry in RUNS:
        material = dataclasses.replace(library.find(name), name="explosive", mixture=closure)
        problem: Problem = dataclasses.replace(driven(material, length, zones, speed, stop), geometry=geometry)
        if geometry != "planar":
            shifted = tuple(dataclasses.replace(r, start=r.start + 0.05, end=r.end + 0.05) for r in problem.regions)
            problem = dataclasses.replace(problem, regions=shifted)
        mixture, solver = burning.reactive(material).mixture, make_solver(problem)
        while solver.time < stop:
            solver.march(stop, CYCLES)
            solver.take_gauges()
            assert not solver.charge[B.status].any()
            if closure != "weighted_pressures":
                apart, sums, heat = worst_defects(solver.zones, solver.charge, mixture)
                assert apart < 1e-9 and sums < 1e-12
                assert closure == "thermal_isolation" or heat < 1e-9
        total += solver.zone_updates
        burned.append((solver.charge[B.lam] > 0.99).mean())
        assert solver.errors()["energy_error"] < 1e-10
    assert total > 1e8
    assert min(burned) > 0.3
