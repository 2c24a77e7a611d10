"""The von Neumann pressure read from a state whose shock is smeared."""

from types import SimpleNamespace

import numpy as np
import pytest

from hugoniot.diagnostics.detonation import von_neumann_pressure
from hugoniot.errors import OutOfRange


def smeared(direction=1):
    """A zone p = 40 - 3 b GPa (b in mm behind a front at 7 mm), its shock spread over four zones with viscosity; zones of 0.1 mm."""
    faces = np.linspace(0.0, 10e-3, 101)
    behind = 7e-3 - 0.5 * (faces[1:] + faces[:-1])
    share = np.clip(0.5 + behind / 4e-4, 0.0, 1.0)
    p = np.where(behind > -2e-4, share * (40e9 - 3e12 * behind), 0.0)
    q = np.where(np.abs(behind) < 2e-4, 0.2 * p, 0.0)
    return SimpleNamespace(zones={"pressure": p[::direction], "viscous_pressure": q[::direction]},
                           position_left=faces[:-1] if direction > 0 else 10e-3 - faces[:0:-1],
                           position_right=faces[1:] if direction > 0 else 10e-3 - faces[-2::-1])


@pytest.mark.parametrize(("direction", "toward"), [(1, "right"), (-1, "left")])
def test_the_line_is_led_on_to_the_front(direction, toward):
    state = smeared(direction)
    assert state.zones["pressure"].max() < 0.985 * 40e9
    assert von_neumann_pressure(state, toward) == pytest.approx(40e9, rel=1e-3)


def test_a_front_needs_zones_behind_it():
    with pytest.raises(OutOfRange, match="80 zones behind"):
        von_neumann_pressure(smeared(), zones=80)
