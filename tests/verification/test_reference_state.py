"""The reactants' reference state in thermal isolation against the exact jump: found by a detector behind the smeared shock, and rolling."""

import dataclasses

import numpy as np
import pytest
from reactive_builders import driven

from hugoniot.diagnostics.reference_state import AFTER_SHOCK, WHILE_BURNING, ReferenceDetector, isentrope_error
from hugoniot.laws.burn.pressure_power import PressurePower
from hugoniot.materials import burning, library
from hugoniot.simulate import make_solver
from hugoniot.theory.hugoniot import Initial, shock
from hugoniot.theory.znd import znd

LX17 = dataclasses.replace(library.find("LX-17 reactive"), name="lx-17")
REST = Initial.at_rest(LX17.unreacted)
HEAT = burning.heat_of(LX17)


def watched(problem):
    """(solver, detector) of a run looked at after every step."""
    solver = make_solver(problem)
    detector = ReferenceDetector(solver.zones.shape[1])
    while solver.time < problem.stop_time:
        solver.march(problem.stop_time, 1)
        detector.look(solver.state(), solver.phases())
    return solver, detector


def slow_burn(per_mm):
    """A shock of 15 GPa with a rate of 2e3 1/s behind it, which leaves the shock alone; its exact state."""
    behind = shock(LX17.unreacted, REST, pressure=15e9)
    material = dataclasses.replace(LX17, burn=PressurePower(2e3, 0.0, 1.0, pressure_threshold=1e9))
    return driven(material, 4e-3, 4 * per_mm, float(behind.particle_velocity), 0.6e-6), behind


def detonation(per_mm):
    """LX-17 from its exact reaction zone; its von Neumann state."""
    exact = znd(burning.reactive(LX17).mixture, REST, LX17.burn, points=300, complete=1.0 - 1e-5)
    length = 12.0 * exact.half_reaction_length
    piston = (exact.time, exact.particle_velocity)
    return driven(LX17, length, round(length * per_mm * 1e3), piston, 0.9 * length / exact.velocity), exact.von_neumann


def errors(problem, behind):
    """(detector's codes, isentrope error frozen by the detector, the same of the rolling reference at the end), middle third of what was shocked."""
    solver, detector = watched(problem)
    phases = solver.phases()
    shocked = np.flatnonzero(detector.how)
    middle = shocked[len(shocked) // 3:2 * len(shocked) // 3]
    middle = middle[phases[1, middle] > 0.0]
    exact = (float(behind.density), float(behind.specific_internal_energy), REST.energy)
    frozen = isentrope_error(detector.density[middle], detector.energy[middle] - HEAT, *exact, LX17.unreacted)
    rolling = isentrope_error(phases[1, middle], phases[2, middle] - HEAT, *exact, LX17.unreacted)
    return detector.how[middle], frozen, rolling, phases[0, middle]


@pytest.mark.slow
def test_behind_a_shock_that_does_not_burn_the_detector_and_the_rolling_reference_find_the_exact_isentrope():
    """Zones of 40 and 20 um: both within 0.5 % of the energy rise, and the detector says that it found the state behind the shock."""
    for per_mm in (25, 50):
        how, frozen, rolling, fraction = errors(*slow_burn(per_mm))
        assert (how == AFTER_SHOCK).all() and 0.0 < fraction.min() < fraction.max() < 2e-3
        assert np.abs(frozen).max() < 5e-3 and np.abs(rolling).max() < 5e-3


@pytest.mark.slow
def test_in_a_detonation_burning_begins_inside_the_smeared_shock_and_the_detector_says_so():
    found = {}
    for per_mm in (50, 100):
        how, frozen, rolling, _ = errors(*detonation(per_mm))
        assert (how == WHILE_BURNING).all()
        found[per_mm] = np.median(frozen), np.median(rolling)
    assert abs(found[100][1]) < abs(found[50][1])
