"""Norms, arrivals, wave diagram and velocimetry against closed forms."""

import pathlib
import sys

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "output"))

from acoustic_flyer import IMPACT, RHO, STRENGTH, AcousticFlyer, C

from hugoniot.diagnostics.arrival import arrival_times, arrivals, first_crossing, front_speed, steepest_times
from hugoniot.diagnostics.norms import difference, time_shift
from hugoniot.diagnostics.velocimetry import (
    PullBack,
    durations,
    flat_stretch,
    fringes,
    kanel_correction,
    plateau,
    pull_back,
    ringing_period,
    spall_strength,
    spall_thickness,
    turning_points,
    visar_velocity,
)
from hugoniot.diagnostics.wave_diagram import gaps, interfaces, raster


# -- norms --------------------------------------------------------------------------------------------------------------
def test_norms_of_a_triangle():
    """b - a = x on [0, 1]: L1 = 1/2, L2 = 1/sqrt(3), Linf = 1, on whatever points each record stands."""
    d = difference([0.0, 1.0], [2.0, 2.0], [0.0, 0.3, 1.0, 2.0], [2.0, 2.3, 3.0, 9.0])
    assert d.l1 == pytest.approx(0.5, rel=1e-14) and d.l2 == pytest.approx(3**-0.5, rel=1e-14) and d.linf == pytest.approx(1.0)
    assert (d.start, d.end, d.scale) == (0.0, 1.0, 3.0)


@given(st.lists(st.floats(-1e3, 1e3), min_size=3, max_size=9), st.floats(-100, 100))
def test_norms_of_a_record_and_itself_shifted_up(values, step):
    t, a = np.arange(len(values), dtype=float), np.array(values)
    d = difference(t, a, t, a + step)
    assert max(abs(x - abs(step)) for x in (d.l1, d.l2, d.linf)) < 1e-10
    assert d.l1 <= d.l2 * (1 + 1e-12) + 1e-12 and d.l2 <= d.linf * (1 + 1e-12) + 1e-12


def test_time_shift_is_the_delay_of_a_ramp():
    t = np.linspace(0, 10, 401)
    a, b = np.clip(t - 2, 0, 1), np.clip(t - 3.7, 0, 1)
    assert time_shift(t, a, t, b) == pytest.approx(1.7, abs=1e-12)
    assert np.isnan(time_shift(t, a, t, 0 * t)) and np.isnan(time_shift(t, 0 * t, t, a))


def test_time_shift_is_that_of_one_wave():
    """The same level in both: a third more amplitude shifts a ramp of 1 s by an eighth; a wave after the end of the data, or before their
    beginning, is no wave of theirs."""
    t = np.linspace(0, 10, 401)
    a = np.clip(t - 2, 0, 1) + 4.0 * np.clip(t - 7, 0, 1)
    assert time_shift(t, a, t, 4.0 / 3.0 * np.clip(t - 2, 0, 1) + 4.0 * np.clip(t - 8, 0, 1)) == pytest.approx(1.0 - 1.0 / 12.0, abs=1e-12)
    early = t <= 5.0
    assert time_shift(t, a, t[early], 4.0 / 3.0 * np.clip(t - 2, 0, 1)[early]) == pytest.approx(-0.125, abs=1e-12)
    late = t >= 8.5
    assert np.isnan(time_shift(t, a, t[late], a[late] - 2.0 * (t[late] - 8.5)))


def test_records_without_common_time_are_refused():
    with pytest.raises(ValueError, match="no time in common"):
        difference([0, 1], [0, 0], [2, 3], [0, 0])


# -- arrival ------------------------------------------------------------------------------------------------------------
def test_a_front_is_found_at_every_zone():
    x, t = np.linspace(0, 1, 50), np.linspace(0, 2, 301)
    field = np.clip((t[:, None] - x / 0.8) / 0.1, 0, 1)
    expected = x / 0.8 + 0.05
    assert np.allclose(arrival_times(t, field, 0.5), expected, atol=1e-3)
    assert np.allclose(steepest_times(t, field), expected, atol=0.06)
    speed, misfit = front_speed(arrival_times(t, field, 0.5), x)
    assert speed == pytest.approx(0.8, rel=1e-3) and misfit < 1e-3
    assert np.isnan(arrival_times(t, field, 2.0)).all()


def test_a_crossing_downwards_counts_too():
    assert first_crossing([0, 1, 2], [4.0, 2.0, 0.0], 1.0) == pytest.approx(1.5)
    assert np.isnan(first_crossing([0, 1], [0.0, 1.0], 3.0))


def front(t, at, height, width):
    """The profile of a captured shock: a hyperbolic tangent whose middle is at the time `at`."""
    return 0.5 * height * (1.0 + np.tanh((t - at) / width))


@pytest.mark.parametrize("way", [1.0, -1.0])
@pytest.mark.parametrize("width", [0.01, 0.03])
def test_the_arrival_is_that_of_the_first_wave_however_thick(way, width):
    """A precursor of 3 % at 1, the plastic wave at 2, a slow rise and a fall: both middles, and noise of a thousandth before is no wave."""
    t = np.linspace(0.0, 5.0, 2001)
    u = front(t, 1.0, 3.0, width) + front(t, 2.0, 97.0, width) + 0.1 * front(t, 0.4, 1.0, width) + np.clip(t - 3.0, 0.0, 1.0)
    first, second = arrivals(t, 700.0 + way * (u - front(t, 4.5, 80.0, width)))
    assert first == pytest.approx(1.0, abs=0.2 * width) and second == pytest.approx(2.0, abs=0.2 * width)


def test_waves_that_are_not_separated_count_as_one_and_a_small_second_one_is_not_the_main_wave():
    t = np.linspace(0.0, 5.0, 2001)
    assert arrivals(t, front(t, 1.0, 3.0, 0.1) + front(t, 1.2, 97.0, 0.1))[0] == pytest.approx(1.2, abs=0.02)
    first, second = arrivals(t, front(t, 1.0, 3.0, 0.03) + front(t, 1.3, 97.0, 0.085))
    assert first == pytest.approx(1.0, abs=0.02) and np.isnan(second)      # seen, but without a plateau to be sure of
    assert arrivals(t, front(t, 1.0, 60.0, 0.03) + front(t, 2.0, 40.0, 0.03)) == pytest.approx((1.0, np.nan), abs=0.01, nan_ok=True)
    assert np.isnan(arrivals(t, 0.0 * t)).all()
    begun = front(t, 0.02, 3.0, 0.03) + front(t, 1.0, 97.0, 0.03)      # as of a face at its own impact
    assert np.isnan(arrivals(t, begun)[1])


def test_a_front_that_is_still_rising_when_the_record_ends_has_not_arrived():
    """The first part of a front at 5.1 is no wave; the part beyond its middle, once it slows, is."""
    t = np.linspace(0.0, 5.0, 2001)
    assert np.isnan(arrivals(t, front(t, 5.1, 100.0, 0.05))).all()
    assert arrivals(t, front(t, 4.9, 100.0, 0.05))[0] == pytest.approx(4.9, abs=0.01)


def test_a_step_between_two_points_and_a_ramp():
    """Tracked fronts step at one time; a ramp arrives in its middle."""
    assert arrivals([0.0, 1.0, 1.0, 2.0, 2.0, 3.0], [0.0, 0.0, 4.0, 4.0, 9.0, 9.0]) == (1.0, 2.0)
    t = np.linspace(0.0, 3.0, 301)
    assert arrivals(t, np.clip(t - 1.0, 0.0, 1.0))[0] == pytest.approx(1.5, abs=0.02)


# -- wave diagram -------------------------------------------------------------------------------------------------------
def moving_step(times, count=200, speed=40.0):
    faces = np.tile(np.linspace(0, 1, count + 1), (len(times), 1))
    centre = 0.5 * (faces[0, 1:] + faces[0, :-1])
    return faces[:, :-1], faces[:, 1:], (centre[None, :] < 0.1 + speed / count * times[:, None]).astype(float)


def test_a_shock_between_two_records_stays_a_line():
    """A step that runs 16 zones between records: carried along, it is within two zones of its place at every time."""
    times = np.linspace(0, 4, 11)
    left, right, field = moving_step(times)
    picture = raster(times, left, right, field, size=(200, 400))
    for t, row in zip(picture.time, picture.values):
        front = picture.position[np.flatnonzero(row > 0.5)[-1]]
        assert abs(front - (0.1 + 0.2 * t)) < 2 / 200 + 1e-9
    blurred = raster(times, left, right, field, size=(200, 400), follow=False)
    assert np.mean((blurred.values > 0.01) & (blurred.values < 0.99)) > 10 * np.mean((picture.values > 0.01) & (picture.values < 0.99))


def test_records_are_shown_as_they_are_at_their_times():
    times = np.linspace(0, 4, 11)
    left, right, field = moving_step(times)
    picture = raster(times, left, right, field, size=(11, 200))
    assert np.array_equal(picture.values, field)


def test_voids_are_holes():
    left = np.array([[0.0, 1.0], [0.0, 2.0]])
    right = left + 1.0
    picture = raster([0.0, 1.0], left, right, np.ones((2, 2)), size=(3, 60))
    hole = np.isnan(picture.values[-1])
    assert np.array_equal(hole, (picture.position > 1) & (picture.position < 2))
    assert gaps(left, right, 0.1) == [0] and gaps(left[:1], right[:1], 0.1) == []
    assert interfaces(["a", "a", "b"]) == [1]


# -- velocimetry --------------------------------------------------------------------------------------------------------
def test_visar_sees_the_mean_over_its_delay():
    t = np.linspace(0, 10, 101)
    seen_at, seen = visar_velocity(t, t**1.0, 0.5)
    inside = seen_at > 0.3
    assert np.allclose(seen[inside], seen_at[inside], rtol=1e-12)  # a ramp is seen exactly, at the middle of the delay
    step_at, step = visar_velocity(np.array([0, 1, 1 + 1e-9, 3]), np.array([0.0, 0, 1, 1]), 0.5)
    assert step[-1] == pytest.approx(1.0)
    assert fringes(t * 1e-7, np.full(101, 133.0), 2e-9, 532e-9)[-1] == pytest.approx(2 * 2e-9 * 133 / 532e-9, rel=1e-12)
    assert visar_velocity(t, t, 0.0)[1] is t


def test_turning_points_ignore_small_swings():
    wave = [0, 5, 4.9, 6, 1, 1.2, 0.8, 4, 3.9, 4.2, 0]
    assert turning_points(wave, 0.5) == [3, 6, 9]


@pytest.mark.parametrize("flyer, target", [(60, 120), (80, 200)])
def test_spall_strength_and_thickness_of_the_exact_flyer_are_read_back(flyer, target):
    """The triangular wave varies by impedance * U / flyer zones from zone to zone: the reading may miss by that."""
    body = AcousticFlyer(flyer, target)
    time, velocity, planes = [], [], []
    while body.cycle < 4 * target:
        body.step()
        time.append(body.time)
        velocity.append(body.face_right[-1])
        planes = planes or list(np.flatnonzero(body.split[1:-1]))
    found = pull_back(time, velocity)
    one_zone = RHO * C * IMPACT / flyer / 2
    assert found.peak == pytest.approx(IMPACT) and abs(spall_strength(found.drop, RHO, C) - STRENGTH) <= 2 * one_zone
    thickness = (body.n - (planes[0] + 1)) * body.width
    period = ringing_period(time, velocity, found.minimum_time)
    assert spall_thickness(period, C) == pytest.approx(thickness, abs=body.width)


def test_a_record_that_ends_on_a_flat_top_has_the_same_ringing_period():
    """Dips of 60 m/s every microsecond between flat tops; the last top is cut short by a later fall, at the end of the record."""
    time = np.linspace(0.0, 2.3, 2301)
    phase = time % 1.0
    velocity = 300.0 - 60.0 * np.maximum(0.0, 1.0 - np.minimum(phase, 1.0 - phase) / 0.1) - 100.0 * np.maximum(0.0, time - 2.2)
    assert ringing_period(time, velocity, 0.0) == pytest.approx(1.0, abs=2e-3)


def test_without_a_rebound_there_is_no_pull_back():
    t = np.linspace(0, 1, 100)
    assert pull_back(t, np.minimum(5 * t, 1)) is None
    assert pull_back(t, np.where(t < 0.5, 5 * t, 2.5 - 2 * (t - 0.5))) is None
    assert pull_back(t, 0 * t) is None
    assert pull_back(t, np.minimum(5 * t, 1) + 0.005 * np.sin(80 * t)) is None


def test_a_precursor_and_a_flat_top_do_not_mislead():
    t = np.array([0, 1, 1.1, 2, 2.2, 4, 5, 6, 9], dtype=float)
    u = np.array([0, 0, 10, 10, 100, 100, 70, 90, 90], dtype=float)
    found = pull_back(t, u)
    assert (found.peak, found.minimum, found.rebound) == (100, 70, 90) and (found.peak_time, found.minimum_time) == (4, 5)


def test_a_flat_top_between_slow_slopes_is_a_plateau_and_a_rounded_peak_is_not():
    t = np.linspace(0.0, 4.0, 4001)
    flat = np.interp(t, [1.0, 1.1, 1.35, 1.95, 2.2, 2.3, 4.0], [0.0, 0.955, 1.0, 1.0, 0.955, 0.3, 0.3])
    assert flat_stretch(durations(t), flat)[1] == pytest.approx(1.0, abs=1e-3)
    assert np.isnan(flat_stretch(durations(t), np.maximum(1.0 - (t - 2.0)**2, 0.0))[1])
    assert np.isnan(flat_stretch(durations(t), np.interp(t, [1.0, 1.01, 3.0], [0.0, 1.0, 0.0]))[1])


def test_the_plateau_is_free_of_the_overshoot_and_a_peak_is_kept():
    """A top at 100 m/s behind an overshoot of 4 %, and a triangle, whose highest velocity is its peak."""
    t = np.linspace(0.0, 1.0, 1001)
    flat = np.interp(t, [0, 0.1, 0.11, 0.13, 0.8, 0.9], [0.0, 0, 104, 100, 100, 50])
    assert plateau(t, flat) == pytest.approx(100.0, abs=0.05) and flat.max() > 103
    triangle = np.interp(t, [0, 0.1, 0.11, 0.9], [0.0, 0, 104, 0])
    assert plateau(t, triangle) == triangle.max() and plateau([0.0], [3.0]) == 3.0


def test_stepanov_tends_to_the_acoustic_reading_without_strength():
    assert spall_strength(100, 2700, 5200, 5200) == pytest.approx(spall_strength(100, 2700, 5200), rel=1e-15)
    assert spall_strength(100, 2700, 5200, 6300) > spall_strength(100, 2700, 5200)


def test_kanels_correction_is_the_delay_times_the_harmonic_slope():
    """A fall of 40 m/s in 20 ns and a rise of 30 m/s in 10 ns behind 2 mm: slopes 2e9 and 3e9, delay h/c_b - h/c_l."""
    time = np.linspace(0, 200e-9, 2001)
    velocity = np.interp(time, [0, 100e-9, 120e-9, 130e-9, 200e-9], [100.0, 100, 60, 90, 90])
    found = pull_back(time, velocity)
    expected = (2e-3 / 5200 - 2e-3 / 6250) * (2e9 * 3e9 / 5e9)
    assert kanel_correction(time, velocity, found, 2e-3, 5200, 6250) == pytest.approx(expected, rel=0.02)
    assert kanel_correction(time, velocity, found, 2e-3, 5200, 5200) == 0.0


def test_a_fall_within_one_record_leaves_the_other_slope():
    time, velocity = np.array([0, 1, 2, 3, 4.0]), np.array([0.0, 100, 100, 50, 90])
    found = PullBack(100, 2, 50, 3, 90, 4)
    assert np.isfinite(kanel_correction(time, velocity, found, 1.0, 1.0, 2.0))


def test_a_wave_that_grows_is_not_carried_where_nothing_was():
    """The self-similar wave behind a detonation: its shape changes as it moves, and windows of undisturbed zones match anything undisturbed.

    In the zones that the front has not reached in the second of two records there is nothing between them either, and no hole behind it.
    """
    zones, speed = 60, 0.72
    left = np.tile(np.arange(zones, dtype=float), (40, 1))
    front = zones - speed * np.arange(40)[:, None]
    field = np.where(left >= front, 1.0 - 0.9 * (left - front) / np.maximum(zones - front, 1.0), 0.0)
    found = raster(np.arange(40.0), left, left + 1.0, field, size=(400, zones))
    for row, t in zip(found.values, found.time):
        k = min(int(t), 38)
        low, high = np.minimum(field[k], field[k + 1]), np.maximum(field[k], field[k + 1])
        assert (row >= low - 1e-12).all() and (row <= high + 1e-12).all()
