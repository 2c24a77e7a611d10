"""Labels of the pictures of impacts and of shock initiation: apart from each other and large enough in a window of 420 pixels."""

from itertools import combinations
from types import SimpleNamespace

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.path import Path

from hugoniot.diagnostics.detonation import PopLine, pop_line
from hugoniot.materials import library
from hugoniot.output.sweep_file import Column, SweepTable
from hugoniot.plotting.initiation import pop_picture
from hugoniot.plotting.matches import impedance_match
from hugoniot.plotting.sensitivity import draw_effects
from hugoniot.plotting.style import new_axes
from hugoniot.plotting.sweep import uncertainty_figure
from hugoniot.theory.impedance import match

WINDOW, READABLE = 420, 6.5     # pixels: width of the window, height of a line of text in it


def boxes(ax):
    """Text -> its box in pixels of the picture, and the width of the whole."""
    figure = ax.get_figure()
    renderer = FigureCanvasAgg(figure).get_renderer()
    figure.draw(renderer)
    texts = [*ax.texts, *(t for axis in (ax.xaxis, ax.yaxis) for t in axis.get_ticklabels() if t.get_text())]
    return {t.get_text(): t.get_window_extent(renderer) for t in texts if t.get_text()}, figure.get_tightbbox(renderer).width * figure.dpi


@pytest.mark.parametrize("names", [["copper", "aluminum"], ["tungsten", "copper", "pmma"], ["copper", "aluminum", "lif", "pmma", "tungsten"],
                                   ["aluminum", "copper", "iron", "tantalum", "tungsten"],
                                   ["copper", "tantalum", "lif"], ["pmma", "copper"]])
@pytest.mark.parametrize("speed", [500.0, 800.0])
def test_the_labels_of_a_match_keep_apart_and_stay_readable(names, speed):
    """No label lies on another one, nor on a curve."""
    layers = [library.find(name) for name in names]
    ax = impedance_match(layers, speed, match(layers, speed))
    placed, width = boxes(ax)
    named = {t.get_text() for t in ax.texts} - {""}     # a line to a label is a text without words
    assert len(named) == 2 * (len(names) - 1) + 1
    for one, other in combinations(sorted(named), 2):
        assert not placed[one].overlaps(placed[other]), (one, other)
    curves = [Path(ax.transData.transform(line.get_xydata())) for line in ax.lines]
    for name in named:
        assert not any(curve.intersects_bbox(placed[name].padded(-0.5), filled=False) for curve in curves), name
    assert min(placed[name].height for name in named) * WINDOW / width > READABLE


@pytest.mark.parametrize(("pressures", "least"), [((8.0, 9.9, 12.2, 15.0), 4), ((3.0, 6.0, 15.0), 3), ((1.0, 5.0, 40.0), 3)])
def test_a_pop_plot_has_numbers_along_both_axes(pressures, least):
    line = PopLine(1.2534, -0.4)
    points = [SimpleNamespace(pressure=p * 1e9, distance=line.distance(p * 1e9)) for p in pressures]
    ax = pop_picture(SimpleNamespace(points=points, line=line, material="explosive", zone_size=2e-5))
    boxes(ax)
    for axis, (low, high) in ((ax.xaxis, ax.get_xlim()), (ax.yaxis, ax.get_ylim())):
        numbers = [(v, t.get_text()) for minor in (False, True) for v, t in zip(axis.get_ticklocs(minor=minor), axis.get_ticklabels(minor=minor))]
        shown = [text for value, text in numbers if low <= value <= high and text]
        assert len(shown) >= (least if axis is ax.xaxis else 3) and len(shown) <= 12, shown


def test_a_pop_plot_says_of_what_its_slope_is():
    """From two points: the pressure falls to a half where the distance grows to the fourfold, so log p falls by half of what log x grows."""
    points = [SimpleNamespace(pressure=p, distance=x) for p, x in ((16e9, 1e-3), (8e9, 4e-3))]
    line = pop_line([p.pressure for p in points], [p.distance for p in points])
    ax = pop_picture(SimpleNamespace(points=points, line=line, material="explosive", zone_size=2e-5))
    assert ax.get_title(loc="left") == "explosive, d log p / d log x = -0.500"
    assert ax.get_xlabel() == "input pressure p (GPa)" and ax.get_ylabel() == "run distance to detonation x (mm)"


def test_equal_records_of_a_sample_are_drawn_once():
    """An interface and its two sides have one velocity."""
    values = np.random.default_rng(1).normal(size=(12, 5))
    records = tuple(Column(f"joint{side}.velocity", "m/s", values) for side in ("", " left", " right")) + (Column("far.velocity", "m/s", 2.0 * values),)
    figure = uncertainty_figure(SweepTable((), (), ("",) * 12, records=records, times=np.linspace(0.0, 1e-6, 5)))
    assert [ax.get_title(loc="left").split(",")[0] for ax in figure.axes[::2]] == ["joint", "far"]


def test_the_names_of_equal_effects_stand_one_above_the_other():
    """Three parameters whose points nearly coincide."""
    rows = [SimpleNamespace(parameter=f"region.flyer.{name}", magnitude=x, deviation=0.0) for name, x in (("velocity", 3.0), ("density", 2.9), ("to", 2.8))]
    ax = new_axes(4.4, 3.5)
    draw_effects(ax, rows, Column("y", "1", np.zeros(3)))
    placed, _ = boxes(ax)
    for one, other in combinations([t.get_text() for t in ax.texts], 2):
        assert not placed[one].overlaps(placed[other]), (one, other)
