"""Wilkins A.1 to A.4 and W-1 to W-5: the second shock, with the damage of equation A.4 shown."""

import numpy as np
import pytest

from hugoniot.errors import OutOfRange
from hugoniot.theory.second_shock import (
    Quadratic,
    leading_difference,
    principal,
    principal_series,
    second,
    second_series,
    second_series_as_printed,
)

LAW = Quadratic(0.73, 1.72, 1.60)  # Mbar
MU = np.array([0.15, 0.20, 0.25])


@pytest.mark.parametrize("law", [LAW, Quadratic(1.37, 1.75, 1.99), Quadratic(0.3, 0.1, 0.5)])
def test_w1_principal_satisfies_the_jump(law):
    mu = np.linspace(0.01, 0.6, 9)
    p = principal(mu, law)
    e = 0.5 * p * (1 - 1 / (1 + mu))
    assert p == pytest.approx(law.a * mu + law.b * mu**2 + law.c * (1 + mu) * e, rel=1e-12)


def test_w2_cubic():
    assert (principal_series(0.25, LAW), principal(0.25, LAW)) == pytest.approx((0.3553, 0.3625), abs=1e-6)


def test_w3_second_hugoniot():
    assert second(MU, 0.10, LAW) == pytest.approx([0.166002, 0.248564, 0.347520], abs=1e-6)
    # the jump from (P1, V1, E1) itself
    p1 = principal(0.1, LAW)
    e1 = 0.5 * p1 * (1 - 1 / 1.1)
    p = second(MU, 0.1, LAW)
    e = e1 + 0.5 * (p + p1) * (1 / 1.1 - 1 / (1 + MU))
    assert p == pytest.approx(LAW.a * MU + LAW.b * MU**2 + LAW.c * (1 + MU) * e, rel=1e-12)


def test_w4_difference_is_of_third_order():
    assert second(MU, 0.1, LAW) - principal(MU, LAW) == pytest.approx([-0.002407, -0.007150, -0.014980], abs=1e-6)
    for scale in (0.02, 0.01, 0.005):
        exact = second(scale, 0.5 * scale, LAW) - principal(scale, LAW)
        lead = leading_difference(scale, 0.5 * scale, LAW)
        assert exact / lead == pytest.approx(1.0, abs=5 * scale)  # the next order
    ratio = (second(0.02, 0.01, LAW) - principal(0.02, LAW)) / (second(0.01, 0.005, LAW) - principal(0.01, LAW))
    assert ratio == pytest.approx(8.0, rel=0.05)


def test_w5_printed_form_fails_and_corrected_form_converges():
    assert second_series_as_printed(MU, 0.1, LAW) == pytest.approx([0.194843, 0.296158, 0.420002], abs=1e-6)
    assert second_series(0.2, 0.1, LAW) == pytest.approx(0.247994, abs=1e-6)
    misses = [abs(second_series(m, m / 2, LAW) - second(m, m / 2, LAW)) for m in (0.04, 0.02, 0.01)]
    assert np.log2(np.array(misses[:-1]) / misses[1:]) == pytest.approx([4.0, 4.0], abs=0.15)
    printed = [abs(second_series_as_printed(m, m / 2, LAW) - second(m, m / 2, LAW)) for m in (0.04, 0.02, 0.01)]
    assert np.log2(printed[1] / printed[2]) < 2.2


def test_limits():
    with pytest.raises(OutOfRange, match="compression limit"):
        principal(2 / 1.6, LAW)
    with pytest.raises(OutOfRange, match="compresses further"):
        second(0.05, 0.1, LAW)
