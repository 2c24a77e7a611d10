"""`hugoniot verify` in two dimensions: problems run by name, are judged, and stand where they stood."""

import numpy as np
import pytest

from hugoniot.campaign.plane import PLANE
from hugoniot.campaign.plane.impacts import crossings
from hugoniot.campaign.verify import PROBLEMS, verify_problem
from hugoniot.errors import DeckError

# goals that are missed; docs/verification.md says why
MISSED = {("noh_square", "shock_position", 50), ("noh_ring", "density_l1", 75), ("noh_ring", "density_l1", 150),
          ("sedov_sphere", "shock_position", 45),
          ("gresho", "peak_speed", 40), ("taylor_steel", "length", 5), ("cylinder_comp_b", "speed_6mm", 12)}
QUICK = {"noh_square": (50,), "sedov_square": (45,), "saltzman_skewed": (100,), "coggeshall_rz": (20, 40), "gresho": (20, 40, 80),
         "howell_ring": (20,), "verney_sphere": (20,), "kenamond_1": (20,), "kenamond_2": (20,), "kenamond_3": (20,),
         "spinning_square": (100,), "disc_impact": (16,), "oblique_impact": (20,), "noh_triangles": (50,), "sedov_triangles": (45,)}


def missed(found):
    return {(row.problem, row.measure, row.zones) for row in found.judged if row.beats(row.goal) is False}


@pytest.mark.parametrize("name", QUICK)
def test_a_problem_meets_its_goals(name):
    """Those of its quick grids; energy closed to round-off."""
    found = verify_problem(name, QUICK[name])
    assert missed(found) <= MISSED
    assert all(row.beats(row.peer) is not False for row in found.judged)
    assert found.energy_error < 1e-12 and not found.momentum_error > 1e-12      # NaN in axisymmetric flow, where it is not judged


@pytest.mark.slow
@pytest.mark.parametrize("name", [name for name in PLANE if name not in QUICK])
def test_a_long_problem_meets_its_goals(name):
    found = verify_problem(name)
    assert missed(found) <= MISSED
    assert found.energy_error < 1e-12


@pytest.mark.parametrize("zones", [10, 20, 30])
def test_the_points_of_an_oblique_front_lie_on_it(zones):
    """A front three zones wide at 20 degrees to the rows' normal, on rows that lean as those behind and ahead of it do (7 degrees apart)."""
    size, slope = 1.0 / zones, np.tan(np.radians(20.0))
    i, j = np.meshgrid(np.arange(8 * zones), np.arange(zones), indexing="ij")
    along, lean = (i + 0.5) * size, np.tan(np.radians(7.0))
    across = (j + 0.5) * size + lean * np.maximum(along - 4.0, 0.0)
    distance = (along - 4.0 + slope * across) / size
    found = np.array(crossings(along, across, np.clip(0.5 - distance / 3.0, 0.0, 1.0), 0.5))
    assert len(found) == zones and np.abs(found[:, 0] - 4.0 + slope * found[:, 1]).max() < 0.02 * size


def test_smooth_flow_is_of_second_order():
    """Coggeshall's compression, in which nothing but the discretisation errs."""
    assert verify_problem("coggeshall_rz", (10, 20, 40)).orders["density"] > 1.5


def test_a_vortex_is_of_second_order():
    """Taylor and Green's, without viscosity."""
    found = verify_problem("taylor_green", (8, 16, 32))
    assert found.orders["velocity_l2"] > 1.9 and found.energy_error < 1e-12 and found.momentum_error < 1e-12


def test_the_cylinder_test_on_a_coarse_mesh():
    """Four zones across the charge: the streak record within 3 % of the measured one; 2 % is the bar of the finer meshes."""
    found = verify_problem("cylinder_comp_b", (4,))
    assert all(row.value < 0.03 for row in found.judged) and len(found.judged) == 2 and found.energy_error < 1e-12


def test_what_is_missed_is_a_goal():
    goals = {(problem.name, bar.measure, bar.zones) for problem in PLANE.values() for bar in problem.bars if bar.goal is not None}
    assert goals >= MISSED and set(PLANE) <= set(PROBLEMS)


def test_an_integrator_of_one_dimension_is_refused():
    with pytest.raises(DeckError, match="no integrator 'wilkins'"):
        verify_problem("gresho", integrator="wilkins")
