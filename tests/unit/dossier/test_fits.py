"""Least squares with standard deviations against numpy's own covariance and against known answers."""

from dataclasses import replace

import numpy as np
import pytest

from hugoniot.dossier import fits
from hugoniot.errors import OutOfRange
from hugoniot.materials import schema


def _states(up, us):
    base = schema.points()[5]
    return [replace(base, values={**base.values, "up": float(a), "us": float(b), "rho0": 8930.0}) for a, b in zip(up, us)]


@pytest.mark.parametrize("degree", [1, 2])
def test_coefficients_and_deviations_agree_with_polyfit(degree):
    states = fits.Selection("Copper").states()
    mine = fits.fit(states, degree)
    up, us = np.array([p["up"] for p in states]), np.array([p["us"] for p in states])
    theirs, covariance = np.polyfit(up, us, degree, cov=True)
    assert mine.coefficients == pytest.approx(theirs[::-1], rel=1e-8)
    assert mine.deviations == pytest.approx(np.sqrt(np.diag(covariance))[::-1], rel=1e-6)
    middle = float(np.mean(up))
    if degree == 1:
        design = np.array([middle, 1.0])
        assert mine.band(middle) == pytest.approx(float(np.sqrt(design @ covariance @ design)), rel=1e-6)


def test_exact_line_is_recovered_without_spread():
    up = np.linspace(100.0, 2000.0, 12)
    mine = fits.fit(_states(up, 3940.0 + 1.489 * up), 1)
    assert mine.coefficients == pytest.approx((3940.0, 1.489), rel=1e-12)
    assert mine.deviation < 1e-8


def test_deviations_cover_the_truth():
    """Of fits to noisy lines about 68 % must hold the true intercept within one standard deviation."""
    noise = np.random.default_rng(7)
    up = np.linspace(200.0, 2900.0, 30)
    inside = 0
    for _ in range(400):
        mine = fits.fit(_states(up, 3940.0 + 1.489 * up + noise.normal(0.0, 60.0, up.size)), 1)
        inside += abs(mine.coefficients[0] - 3940.0) < mine.deviations[0]
    assert 0.61 < inside / 400 < 0.75


def test_too_few_states_are_refused():
    with pytest.raises(OutOfRange, match="needs 4"):
        fits.fit(_states([1.0, 2.0, 3.0], [1.0, 2.0, 3.0]), 2)


def test_selections_leave_out_what_their_words_say():
    iron = fits.RECORDED["U206"][0].states()
    assert all(p["up"] >= 1540.0 and p["porosity"] < 1.01 and "Marsh" in p.source for p in iron)


def test_scatter_is_that_of_the_states_about_the_published_line():
    """Steinberg's line for nickel, which Marsh's states had no part in here, against plain arithmetic on them."""
    row = schema.row("U016")
    states = np.array([(p["up"], p["us"]) for p in schema.points() if p.material == "Nickel" and p["use_for_fit"] == 1.0])
    misses = states[:, 1] - (4650.0 + 1.445 * states[:, 0])
    found = fits.scatter(row)
    assert found == pytest.approx((470.0, 2145.0, np.sqrt(np.mean(misses**2)), 18))
    assert (row["up_min"], row["up_max"], row["states"]) == (470.0, 2145.0, 18)
    assert fits.scatter(schema.row("U008")) is None and "states" not in schema.row("U008")


def test_scatter_of_a_fit_is_its_residual():
    """About the line they were fitted to, n states have the residual deviation times sqrt((n - 2)/n), the least any line can have."""
    mine = fits.recorded("U238")
    count = len(mine.points)
    assert fits.scatter(schema.row("U238")).deviation == pytest.approx(mine.deviation * np.sqrt((count - 2) / count), rel=1e-4)
    for published in ("U031", "U102", "U192"):
        assert fits.scatter(schema.row(published)).deviation >= fits.scatter(schema.row("U238")).deviation * (1.0 - 1e-6)


@pytest.mark.parametrize("fitted, published", [("U218", "U099"), ("U238", "U031"), ("U237", "U076"), ("U223", "U059"), ("U232", "U084"),
                                               ("U224", "U257"), ("U230", "U241"), ("U265", "U151"), ("U266", "U155"), ("U267", "U197")])
def test_lines_fitted_here_meet_those_their_sources_published(fitted, published):
    """States read from one copy, lines drawn through the same states and read from another: nowhere further apart than they scatter."""
    mine, theirs = schema.row(fitted), schema.row(published)
    for up in np.linspace(max(mine["up_min"], theirs["up_min"]), min(mine["up_max"], theirs["up_max"]), 5):
        assert abs(mine["c0"] + mine["s"] * up - theirs["c0"] - theirs["s"] * up) < mine["us_deviation"]


@pytest.mark.parametrize("material, c0, s", [("Aluminum 6061", 5349.0, 1.338), ("LiF", 5181.0, 1.306), ("Ice", 1593.0, 1.44)])
def test_states_read_from_plots_give_the_lines_printed_for_them(material, c0, s):
    """Lines that others drew through the same states, printed to four digits (the last of them cut off): a misread mark would show."""
    mine = fits.fit(fits.Selection(material).states(), 1)
    assert mine.coefficients[0] == pytest.approx(c0, abs=0.6) and 0.0 <= mine.coefficients[1] - s + 5e-5 < 0.01
