"""The pi-plane shows the deviators at their von Mises stress from the centre, on the axis of the stress that differs."""

from types import SimpleNamespace

import numpy as np
import pytest

from hugoniot.errors import DeckError
from hugoniot.plotting.yield_plane import pi_plane


def run_with(**rows):
    return SimpleNamespace(folder="a.run", arrays=lambda name: rows, gauge_names=lambda: ["one", "two"])


TIME = np.linspace(0.0, 1e-6, 5)


def path(ax, name):
    (line,) = [line for line in ax.lines if str(line.get_label()).startswith(name)]
    return np.array(line.get_data())


def test_uniaxial_strain_runs_along_the_axis_of_the_motion():
    s1 = np.stack([np.linspace(0.0, -0.2e9, 5), np.linspace(0.0, 0.1e9, 5)], axis=1)
    ax = pi_plane(run_with(time=TIME, deviator_radial=s1, deviator_hoop=-0.5 * s1))
    x, y = path(ax, "one: largest 0.3 GPa")
    assert np.allclose(x, 0.0, atol=1e-15) and np.allclose(y, 1.5e-9 * s1[:, 0])
    assert path(ax, "two: largest 0.15 GPa")[1][-1] == pytest.approx(0.15)


def test_pure_shear_in_the_plane_lies_between_two_axes_and_a_turned_frame_changes_nothing():
    shear = np.linspace(0.0, 1e9, 5)[:, None] * np.array([[1.0, 0.0]])
    none = np.zeros_like(shear)
    turned = pi_plane(run_with(time=TIME, deviator_xx=none, deviator_yy=none, deviator_xy=shear))
    along = pi_plane(run_with(time=TIME, deviator_xx=shear, deviator_yy=-shear, deviator_xy=none))
    assert np.allclose(path(turned, "one"), path(along, "one"))
    x, y = path(along, "one")[:, -1]
    assert np.hypot(x, y) == pytest.approx(np.sqrt(3.0)) and np.arctan2(y, x) == pytest.approx(2.0 * np.pi / 3.0)


def test_times_choose_and_what_cannot_be_drawn_is_refused():
    s1 = np.linspace(0.0, 1e8, 5)[:, None] * np.ones(2)
    rows = dict(time=TIME, deviator_radial=s1, deviator_hoop=-0.5 * s1)
    assert path(pi_plane(run_with(**rows), times=(0.0, 0.5e-6)), "one").shape == (2, 3)
    with pytest.raises(DeckError, match="recorded shear stress"):
        pi_plane(run_with(time=TIME, pressure=s1))
    with pytest.raises(DeckError, match="no gauge 'three'"):
        pi_plane(run_with(**rows), ["three"])
    with pytest.raises(DeckError, match="no record between these times; their record runs from 0 s to 1 us"):
        pi_plane(run_with(**rows), times=(5e-6, 6e-6))
