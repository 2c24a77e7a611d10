"""Pictures of a fit: data with their uncertainty under the model, and the residuals below."""

import numpy as np

from hugoniot.plotting.style import COLOURS, INK, QUIET, field_scale, labelled, new_panels, quiet_grid, styled, time_scale


def draw_target(above, below, shown) -> None:
    """One record: `shown` is (label, name, unit, time (n,), data (n,), sigma (n,), model (n,)), SI."""
    label, name, _, time, values, sigma, model = shown
    unit, factor, words = field_scale(name.rpartition(".")[2], values)
    unit_t, ft = time_scale(float(time[-1]) if len(time) else 1.0)
    above.fill_between(time * ft, (values - 2 * sigma) * factor, (values + 2 * sigma) * factor, color=QUIET, alpha=0.25, linewidth=0)
    above.plot(time * ft, values * factor, ".", color=INK, markersize=2.2, label="data, ± 2 standard deviations")
    above.plot(time * ft, model * factor, color=COLOURS[1], linewidth=1.4, label="model")
    above.set_ylabel(labelled(words, unit))
    above.set_title(label, loc="left")
    above.legend(frameon=False, fontsize=8, loc="best")
    above.tick_params(labelbottom=False)
    below.axhspan(-2.0, 2.0, color=QUIET, alpha=0.18, linewidth=0)
    below.axhline(0.0, color=QUIET, linewidth=0.6)
    below.plot(time * ft, (model - values) / sigma, color=COLOURS[1], linewidth=0.9)
    below.set_xlabel(labelled("time", unit_t))
    below.set_ylabel("residual / σ")
    below.set_xlim(above.get_xlim())
    for ax in (above, below):
        quiet_grid(ax)


@styled
def fit_figure(records):
    """A figure with one column for each record, as of `draw_target`."""
    records = [shown for shown in records if len(shown[3]) > 1]
    columns = max(1, len(records))
    axes = new_panels(2, columns, 5.4 * columns, 4.2)
    axes[0, 0].get_figure().get_layout_engine().set(hspace=0.02)
    for k, shown in enumerate(records):
        draw_target(axes[0, k], axes[1, k], shown)
    for row in axes:
        for ax in row[len(records):]:
            ax.set_visible(False)
    grid = axes[0, 0].get_gridspec()
    grid.set_height_ratios([3, 1])
    return axes[0, 0].get_figure()


def draw_correlation(ax, names, correlation) -> None:
    """The correlations of the parameters as a table of colours with their numbers."""
    values = np.array(correlation, dtype=float)
    ax.imshow(values, cmap="RdBu_r", vmin=-1.0, vmax=1.0)
    ax.set_xticks(range(len(names)), names, rotation=30, ha="right")
    ax.set_yticks(range(len(names)), names)
    for j, k in np.ndindex(values.shape):
        ax.text(k, j, f"{values[j, k]:+.2f}", ha="center", va="center", fontsize=8, color="#ffffff" if abs(values[j, k]) > 0.6 else INK)
    for side in ax.spines.values():
        side.set_visible(False)
