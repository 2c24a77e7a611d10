"""Fits: Us-up with its statistics, files of points, JWL that closes on its CJ state, the Gamma of Jordan eq. 7.1.31."""

import numpy as np
import pytest

from hugoniot.errors import DeckError, NoSolution, OutOfRange
from hugoniot.laws.eos.jwl import JWL
from hugoniot.theory.chapman_jouguet import cj
from hugoniot.theory.fits import adjusted_gamma, fit_jwl, jwl_coefficients, read_points, truncated_pressure, us_up

UP = np.array([200.0, 500.0, 900.0, 1400.0, 1500.0, 2100.0, 2600.0])


@pytest.mark.parametrize(("coefficients", "degree"), [((3940.0, 1.489), 1), ((3531.0, 1.914, -6.06e-5), 2)])
def test_exact_points_are_recovered(coefficients, degree):
    found = us_up(UP, np.polynomial.polynomial.polyval(UP, coefficients), degree)
    assert found.coefficients == pytest.approx(coefficients, rel=1e-9)
    assert found.deviation < 1e-8 and (found.least, found.highest) == (200.0, 2600.0)


def test_statistics_are_those_of_the_textbook():
    noise = np.array([13.0, -20.0, 5.0, 31.0, -14.0, -9.0, 4.0])
    us = 4000.0 + 1.5 * UP + noise
    found = us_up(UP, us)
    n, mean = UP.size, UP.mean()
    sxx = ((UP - mean) ** 2).sum()
    slope = ((UP - mean) * (us - us.mean())).sum() / sxx
    constant = us.mean() - slope * mean
    sigma = np.sqrt(((us - constant - slope * UP) ** 2).sum() / (n - 2))
    assert found.coefficients == pytest.approx((constant, slope), rel=1e-12)
    assert found.deviation == pytest.approx(sigma, rel=1e-10)
    assert found.deviations == pytest.approx((sigma * np.sqrt(1 / n + mean**2 / sxx), sigma / np.sqrt(sxx)), rel=1e-10)
    assert found.band(1000.0) == pytest.approx(sigma * np.sqrt(1 / n + (1000.0 - mean) ** 2 / sxx), rel=1e-10)


def test_copper_points_of_the_library():
    """Marsh's 141 copper states: 3900(11) + 1.517(7) up, residual 67 m/s, by an independent fit."""
    from hugoniot.dossier.fits import library_points

    up, us = library_points(("copper",)).T
    found = us_up(up, us)
    assert found.coefficients == pytest.approx((3900.0, 1.517), rel=5e-4)
    assert found.deviations == pytest.approx((11.0, 0.007), rel=0.1)
    assert len(up) == 141 and found.deviation == pytest.approx(67.0, abs=0.5) and found.highest == pytest.approx(2946.0)


@pytest.mark.parametrize("head", ["up (km/s), us (km/s)", "particle_velocity [km/s],shock_velocity [km/s]", "up_km_s,us_km_s"])
def test_columns_and_units(tmp_path, head):
    path = tmp_path / "points.csv"
    path.write_text(f"# a comment\n{head}\n0.5,4.7\n\n1.0, 5.4\n", encoding="utf-8")
    up, us = read_points(path)
    assert up == pytest.approx([500.0, 1000.0]) and us == pytest.approx([4700.0, 5400.0])


@pytest.mark.parametrize(("text", "words"), [
    ("up,speed\n1,2\n", r"points.csv:1: shock_velocity: there is no such column"), ("up,us\n1,2\n3\n", r"points.csv:3: shock_velocity: the line has only 1 value, but"),
    ("up,us\n1,fast\n", r"points.csv:2: shock_velocity: 'fast' is not a velocity"), ("", "empty"), ("up,us\n", "no points"),
    ("up (furlong),us\n1,2\n", r"points.csv:1: particle_velocity"), ("up,us\n1,-3\n", "positive number or zero"), ("up,us\n1,nan\n", "not a velocity")])
def test_bad_files_are_told_with_the_line(tmp_path, text, words):
    path = tmp_path / "points.csv"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(DeckError, match=words):
        read_points(path)


def test_too_few_points():
    with pytest.raises(OutOfRange, match="needs 3 different"):
        us_up([1.0, 2.0], [3.0, 4.0])
    with pytest.raises(OutOfRange, match="needs 4 different"):
        us_up([1.0, 2.0, 2.0, 3.0], [3.0, 4.0, 4.1, 5.0], 2)
    with pytest.raises(OutOfRange, match="linear"):
        us_up(UP, UP, 3)


TNT = JWL(371.2e9, 3.231e9, 4.15, 0.95, 0.3, 1630.0, 7.0e9)


def test_jwl_coefficients_close_on_the_cj_state():
    point = cj(TNT)
    found = jwl_coefficients(1630.0, point.detonation_velocity, point.state.pressure, 7.0e9, 4.15, 0.95, 0.3)
    assert found[:2] == pytest.approx((371.2e9, 3.231e9), rel=1e-10)
    # any other exponents close too: that is what they are solved for
    a, b, _ = jwl_coefficients(1630.0, 6900.0, 19.0e9, 6.5e9, 4.6, 1.3, 0.38)
    again = cj(JWL(a, b, 4.6, 1.3, 0.38, 1630.0, 6.5e9))
    assert (again.detonation_velocity, again.state.pressure) == pytest.approx((6900.0, 19.0e9), rel=1e-10)


def test_jwl_is_recovered_from_its_expansion():
    point = cj(TNT)
    c = jwl_coefficients(1630.0, point.detonation_velocity, point.state.pressure, 7.0e9, 4.15, 0.95, 0.3)[2]
    v = np.geomspace(0.8, 10.0, 25)
    p = TNT.a * np.exp(-4.15 * v) + TNT.b * np.exp(-0.95 * v) + c * v**-1.3
    found = fit_jwl(1630.0, point.detonation_velocity, point.state.pressure, 7.0e9, v, p)
    assert found.par[:5] == pytest.approx(TNT[:5], rel=1e-7) and found.deviation < 1e-9
    noisy = fit_jwl(1630.0, point.detonation_velocity, point.state.pressure, 7.0e9, v, p * np.exp(0.01 * np.cos(7 * np.arange(25))))
    assert noisy.deviation < 0.01
    assert cj(noisy.par).detonation_velocity == pytest.approx(point.detonation_velocity, rel=1e-9)
    with pytest.raises(NoSolution, match="check units"):
        fit_jwl(1630.0, point.detonation_velocity, point.state.pressure, 7.0e9, v, p * 1e-6)
    with pytest.raises(OutOfRange, match="at least 4"):
        fit_jwl(1630.0, 6900.0, 21e9, 7e9, v[:3], p[:3])


@pytest.mark.parametrize(("rho0", "c0", "s", "up", "gamma", "printed"), [
    (1000.0, 1450.0, 1.99, 387.5, 0.15, 2.8381831), (1000.0, 1450.0, 1.99, 858.0, 0.15, 2.9543413), (100.0, 121.0, 0.9736, 934.0, 0.3, 0.1918117),
    (250.0, 97.0, 1.2509, 770.0, 0.3, 0.7240199), (770.0, 1070.9, 0.4045, 704.0, 0.3, 0.1016222)])
def test_gamma_of_the_source(rho0, c0, s, up, gamma, printed):
    """verification.md A5; the silica rows of 100 and 770 kg/m3 only with each other's up (J-E10)."""
    assert adjusted_gamma(rho0, c0, s, up, gamma) == pytest.approx(printed, rel=0.01)


def test_swapped_velocities_of_the_silica_table():
    """J-E10: with the up column as printed both rows are missed by more than a tenth."""
    assert abs(adjusted_gamma(100.0, 121.0, 0.9736, 704.0, 0.3) / 0.1918117 - 1) > 0.1
    assert abs(adjusted_gamma(770.0, 1070.9, 0.4045, 934.0, 0.3) / 0.1016222 - 1) > 0.1


def test_water_gammas_recovered():
    assert adjusted_gamma(1000.0, 1450.0, 1.99, 387.5, 0.15) == pytest.approx(2.83879, abs=1e-5)
    assert adjusted_gamma(1000.0, 1450.0, 1.99, 858.0, 0.15) == pytest.approx(2.95439, abs=1e-5)


def test_adjusted_law_passes_through_the_shock_state_and_no_other_does():
    rho0, c0, s, up, p0 = 1000.0, 1450.0, 1.99, 600.0, 101325.0
    us = c0 + s * up
    x, behind = up / us, rho0 * us * up + p0
    e = p0 / (0.15 * rho0) + 0.5 * (behind + p0) * x / rho0
    good = adjusted_gamma(rho0, c0, s, up, 0.15)
    assert truncated_pressure(rho0, c0, s, good, rho0 / (1 - x), e) == pytest.approx(behind, rel=1e-13)
    assert abs(truncated_pressure(rho0, c0, s, 0.15, rho0 / (1 - x), e) / behind - 1) > 0.05
    with pytest.raises(OutOfRange, match=r"5000 m/s, must lie between 0 and the shock velocity, 4989 m/s; .* = 4583.33 m/s"):
        adjusted_gamma(100.0, 121.0, 0.9736, 5000.0, 0.3)
