"""Which stretches of zones the tensor viscosity passes over: those in which nothing closes, also where round-off moves the nodes."""

import numpy as np
import pytest

from hugoniot.solvers.lagrange2d.closing import HEAD, STRETCH, ClosingOf, alike, most_closing
from hugoniot.solvers.lagrange2d.layout import Points

ZONES, SPEED = STRETCH, 300.0


def row(motion):
    """A row of unit zones in flight; motion(x, y): what its nodes have besides."""
    def line(x):
        y = np.arange(ZONES + 1.0)
        u, v = motion(np.full(ZONES + 1, x), y)
        return Points(np.full(ZONES + 1, x), y, u + 0.0 * y, SPEED + v + 0.0 * y)

    return ClosingOf(line(7.0), line(8.0), np.full(ZONES, 5e3), np.zeros(ZONES))


def test_a_body_in_flight():
    z = row(lambda x, y: (0.0, 0.0))
    assert alike(z, 0, ZONES) and most_closing(z, 0, ZONES) == 0.0


def test_round_off_closes_nothing():
    less, more = (row(lambda x, y, size=size: (0.0, np.where(y % 3 == 1, size, 0.0))) for size in (1e-13, 1e-12))
    assert alike(less, 0, ZONES) and most_closing(less, 0, ZONES) == 0.0
    assert not alike(more, 0, ZONES) and most_closing(more, 0, ZONES) == 0.0


@pytest.mark.parametrize("motion, closes", [
    (lambda x, y: (x, y), False), (lambda x, y: (-x, y), True), (lambda x, y: (x, -y), True), (lambda x, y: (y, 0.0), True),
], ids=["opens", "closes along i", "closes along j", "shears"])
def test_motion(motion, closes):
    assert (most_closing(row(motion), 0, ZONES) > 0.0) == closes


def test_one_zone_behind_the_first_ones():
    z = row(lambda x, y: (0.0, np.where(y > HEAD + 4, -1.0, 0.0)))
    assert most_closing(z, 0, HEAD) == 0.0 and not alike(z, 0, ZONES)
    assert most_closing(z, HEAD, ZONES) > 0.0
