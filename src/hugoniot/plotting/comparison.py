"""Two runs, or a run and data, over each other, and their difference below."""

import textwrap

from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from hugoniot.plotting.style import COLOURS, INK, QUIET, field_scale, labelled, quiet_grid, styled, time_scale

_FIRST = ("velocity", "stress")
WIDTH, WIDTH_BELOW = 30, 12      # characters of a y label in a line: what the heights of the panels hold


def _robust(ax, gap, unit: str) -> None:
    """Limits of a panel of differences that a spike, such as two fronts a step apart, does not flatten; the spike is stated."""
    import numpy as np

    size = np.abs(gap[np.isfinite(gap)])
    usual, largest = (float(np.percentile(size, 95)), float(size.max())) if size.size else (0.0, 0.0)
    if 0.0 < 4.0 * usual < largest:
        ax.set_ylim(-2.0 * usual, 2.0 * usual)
        words = f"largest {largest:.3g} {unit}".rstrip()
        ax.text(0.99, 0.95, words, transform=ax.transAxes, ha="right", va="top", fontsize=7.5, color=QUIET)


@styled
def comparison(compared, most: int = 6):
    """One column per pair of records: both lines above, difference below; gives the figure.

    Velocity and stress come first, then the other fields, those that differ most at the front.

    compared   output.compare.Comparison
    most       how many pairs to draw
    """
    import numpy as np

    pairs = sorted(compared.pairs, key=lambda pair: (pair.a.field not in _FIRST, -pair.norms.relative[0]))[:most]
    columns = min(len(pairs), 3)
    rows = -(-len(pairs) // columns)
    figure = Figure(figsize=(3.6 * columns + 0.6, 3.8 * rows), layout="constrained")
    FigureCanvasAgg(figure)
    grid = figure.subplots(2 * rows, columns, squeeze=False, sharex=False, height_ratios=[3, 1] * rows)
    for k, pair in enumerate(pairs):
        above, below = grid[2 * (k // columns)][k % columns], grid[2 * (k // columns) + 1][k % columns]
        unit, factor, words = field_scale(pair.a.field, pair.a.values)
        unit_t, ft = time_scale(max(pair.a.time[-1], pair.b.time[-1]))
        above.plot(pair.a.time * ft, pair.a.values * factor, color=COLOURS[0], label=compared.name_a)
        above.plot(pair.b.time * ft, pair.b.values * factor, color=COLOURS[1], linestyle="--", label=compared.name_b)
        above.set_title(pair.a.gauge, loc="left")
        above.set_ylabel(textwrap.fill(labelled(words, unit), WIDTH))
        inside = np.union1d(pair.a.time, pair.b.time)
        inside = inside[(inside >= pair.norms.start) & (inside <= pair.norms.end)]
        gap = np.interp(inside, pair.b.time, pair.b.values) - np.interp(inside, pair.a.time, pair.a.values)
        below.axhline(0.0, color=QUIET, linewidth=0.6)
        below.plot(inside * ft, gap * factor, color=INK, linewidth=1.0)
        below.set_xlim(above.get_xlim())
        _robust(below, gap * factor, unit)
        below.set_xlabel(labelled("time", unit_t))
        below.set_ylabel(textwrap.fill(labelled("difference", unit), WIDTH_BELOW))
        quiet_grid(above)
        quiet_grid(below)
    grid[0][0].legend(frameon=False, fontsize=8, loc="best")
    for k in range(len(pairs), rows * columns):
        grid[2 * (k // columns)][k % columns].set_visible(False)
        grid[2 * (k // columns) + 1][k % columns].set_visible(False)
    return figure
