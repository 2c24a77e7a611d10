"""Taylor bars on 5, 10 and 20 zones across: they converge, and Richardson's error of the finest is small. docs/verification.md has the table.

Richardson: of values f1, f2, f3 on meshes each twice as fine, the order is p = log2 (f1 - f2)/(f2 - f3), the limit f3 + (f3 - f2)/(2^p - 1).
"""

import math

import pytest

from hugoniot.campaign.plane import PLANE, run_plane
from hugoniot.solvers.lagrange2d.assemble import N, Z

pytestmark = pytest.mark.slow
ZONES = (5, 10, 20)
# largest Richardson error on the finest mesh: length, radius of the foot, largest plastic strain. The foot converges with the width of the
# shock with which the impact starts, in first order; shocks of condensed matter are a zone wider than those of gases
BOUNDS = {"taylor_copper": {"length": 1e-3, "foot": 1e-2, "plastic_strain": 0.012},
          "taylor_steel": {"length": 1e-3, "foot": 4e-3, "plastic_strain": 0.01}}


def measured(name, zones):
    solver = run_plane(PLANE[name], zones)
    assert solver.errors()["energy_error"] < 1e-12
    return {"length": solver.nodes[N.y].max(), "foot": solver.nodes[N.x].max(), "plastic_strain": solver.zones[Z.plastic_strain].max()}


@pytest.mark.parametrize("name", BOUNDS)
def test_a_taylor_bar_converges(name):
    found = [measured(name, zones) for zones in ZONES]
    for key, bound in BOUNDS[name].items():
        coarse, middle, fine = (values[key] for values in found)
        ratio = (coarse - middle) / (middle - fine)
        assert ratio > 1.8, key                 # of order 0.85 at the least
        limit = fine + (fine - middle) / (ratio - 1.0)
        order, error = math.log2(ratio), abs(fine / limit - 1.0)
        row = f"{name} {key}: {coarse:.6g} {middle:.6g} {fine:.6g}, order {order:.2f}, limit {limit:.6g}, error {error:.2%}"
        assert error < bound, row
