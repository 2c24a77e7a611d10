"""Detonations followed in a moving window: the pulsation of B23, and zones that stay what they were laid out as."""

import numpy as np
import pytest
from test_reaction_zones import START, explosive, one_step

from hugoniot.campaign.moving_window import follow
from hugoniot.errors import OutOfRange
from hugoniot.materials import burning
from hugoniot.theory.hugoniot import Initial
from hugoniot.theory.znd import znd

SHOCK = {"quadratic": 0.55, "linear": 1.0}     # (gamma + 1)/4 and 1: the jump of a shock in a gas of gamma = 1.2 itself
RATE = 231.16                                  # makes the half-reaction length 1 at f = 1.6


@pytest.mark.slow
@pytest.mark.parametrize(("zones", "window"), [(10, 15.0), (10, 30.0), (20, 15.0)])
def test_b23_settles_into_one_mode(zones, window):
    """f = 1.6: from the sixth period on every crest within 2 % of 98.6 and 1 % of each other, the period 7.3 to 7.5, D below the steady one."""
    found = follow(one_step(RATE), START, 84.0, overdrive=1.6, zones=zones, window=window, viscosity=SHOCK)
    assert found.exact.half_reaction_length == pytest.approx(1.0, rel=1e-4)
    times, crests = found.crests(after=45.0)
    assert len(crests) >= 5
    assert crests == pytest.approx(np.full(len(crests), 98.6), rel=0.02)
    assert np.ptp(crests) < 0.01 * crests.mean()
    assert 7.3 < np.diff(times).mean() < 7.5 and np.ptp(np.diff(times)) < 0.15
    late = found.time > times[0]
    mean = (found.position[late][-1] - found.position[late][0]) / (found.time[late][-1] - found.time[late][0])
    assert mean == pytest.approx(found.exact.velocity, rel=5e-3)


@pytest.mark.slow
def test_b23_stays_steady_at_18():
    """f = 1.8, 20 zones: every zone passed sees the von Neumann pressure within 0.5 %, the front pressure stays within 1 % of it."""
    rate = one_step()
    half = znd(burning.reactive(rate).mixture, START, rate.burn, overdrive=1.8).half_reaction_length
    found = follow(one_step(half), START, 12.0, overdrive=1.8, zones=20, window=10.0, viscosity=SHOCK)
    spike = float(found.exact.von_neumann.pressure)
    assert found.peak_pressure[-400:] == pytest.approx(np.full(400, spike), rel=5e-3)
    late = found.time > 5.0
    assert found.front_pressure[late] == pytest.approx(np.full(late.sum(), spike), rel=0.01)
    assert np.polyfit(found.time[late], found.position[late], 1)[0] == pytest.approx(found.exact.velocity, rel=2e-3)


def test_a_window_must_hold_the_zone():
    with pytest.raises(OutOfRange, match="window"):
        follow(one_step(RATE), START, 1.0, overdrive=1.6, window=1.0)
    with pytest.raises(OutOfRange, match="duration"):
        follow(explosive("pressure_power"), Initial(1600.0, 0.0, 0.0), 0.0)
