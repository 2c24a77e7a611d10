"""Pictures of what a sweep says about its parameters: Sobol' indices with their intervals, and Morris' elementary effects."""

import numpy as np

from hugoniot.output.sweep_file import Column, SweepTable
from hugoniot.plotting.style import COLOURS, INK, labelled, new_panels, quiet_grid, spread, styled
from hugoniot.plotting.sweep import scale, words_of, worth_drawing


def draw_indices(ax, rows) -> None:
    """First-order and total indices of one result with their 95 % intervals: rows have parameter, first, total and their _low and _high."""
    from matplotlib.transforms import offset_copy

    y = np.arange(len(rows))[::-1]
    for shift, name, colour, words in ((0.17, "first", COLOURS[0], "first order"), (-0.17, "total", COLOURS[1], "total")):
        value = np.array([getattr(row, name) for row in rows])
        ends = np.array([[getattr(row, f"{name}_low"), getattr(row, f"{name}_high")] for row in rows]).T
        away = np.maximum(np.stack([value - ends[0], ends[1] - value]), 0.0)
        ax.barh(y + shift, value, 0.3, color=colour, alpha=0.85, label=words)
        ax.errorbar(value, y + shift, xerr=away, fmt="none", ecolor=INK, elinewidth=0.9, capsize=2)
    ax.set_yticks(y, [words_of(row.parameter) for row in rows])
    ax.set_xlim(min(0.0, ax.get_xlim()[0]), max(1.0, ax.get_xlim()[1]))
    ax.set_xlabel("fraction of the variance", loc="left")
    ax.set_title(words_of(rows[0].result), loc="left")
    beside = offset_copy(ax.transAxes, ax.get_figure(), y=-33.0, units="points")      # the axis label, below the longest names of results
    ax.legend(frameon=False, fontsize=8, loc="lower right", bbox_to_anchor=(1.0, 0.0), bbox_transform=beside, ncol=2, borderaxespad=0.0)


def draw_effects(ax, rows, column: Column) -> None:
    """Morris' effects on one result: mean magnitude across, standard deviation up, each parameter by its name."""
    unit, factor = scale(column)
    x, y = np.array([(row.magnitude * factor, row.deviation * factor) for row in rows]).T
    for k in range(len(rows)):
        ax.plot(x[k], y[k], "o", color=COLOURS[k % len(COLOURS)], markersize=5)
    ax.margins(0.15)
    points = ax.get_figure().get_figheight() * ax.get_position().height * 72.0 / np.ptp(ax.get_ylim())
    for k, up in enumerate(spread(points * y, 10.0) - points * y):      # names of neighbours one above the other
        ax.annotate(words_of(rows[k].parameter), (x[k], y[k]), xytext=(5, 4 + up), textcoords="offset points", fontsize=8,
                    color=COLOURS[k % len(COLOURS)])
    ax.set_xlabel(labelled("mean magnitude of the effects", unit))
    ax.set_ylabel(labelled("standard deviation", unit))
    ax.set_title(words_of(column.name), loc="left")
    quiet_grid(ax)


@styled
def sensitivity_figure(sensitivity, table: SweepTable):
    """A figure of the sensitivities (of `campaign.analysis.Analysis`) of the results worth drawing."""
    chosen = [column for column in worth_drawing(table) if column.name in sensitivity][:4]
    axes = new_panels(max(1, -(-len(chosen) // 2)), min(2, max(1, len(chosen))), 9.6, 2.9 * max(1, -(-len(chosen) // 2))).ravel()
    for ax, column in zip(axes, chosen):
        draw_sensitivity(ax, sensitivity[column.name], column)
    for ax in axes[len(chosen):]:
        ax.set_visible(False)
    return axes[0].get_figure()


def draw_sensitivity(ax, rows, column: Column) -> None:
    """Sobol' indices or Morris' effects, whichever the rows are."""
    if hasattr(rows[0], "total"):
        draw_indices(ax, rows)
    else:
        draw_effects(ax, rows, column)
