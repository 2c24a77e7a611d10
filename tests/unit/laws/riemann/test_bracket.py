"""Roots inside a bracket: at its ends, and where the value bends."""

import math

import numpy as np
import pytest

from hugoniot.laws.riemann.bracket import root


@pytest.mark.parametrize("low, high", [(1.0, 3.0), (3.0, 1.0), (0.5, 1.0), (1.0, 0.5)])
def test_a_root_at_an_end_of_the_bracket_is_found_at_once(low, high):
    """At either end; at the upper one it was divided by the value there, which is zero."""
    asked = []

    def value(x):
        asked.append(x)
        return np.float64(math.log(x))
    assert root(value, low, high, value(low), value(high)) == 1.0
    assert len(asked) == 2


@pytest.mark.parametrize("power", [1, 3, 7])
def test_a_root_inside_is_found_to_rounding(power):
    assert root(lambda x: x**power - 2.0, 0.0, 5.0, -2.0, 5.0**power - 2.0) == pytest.approx(2.0 ** (1.0 / power), rel=1e-14)
