"""Pictures of a posterior: every pair of parameters, and the bands in which runs of prior and posterior lie beside the data."""

import numpy as np

from hugoniot.output.sweep_file import Column
from hugoniot.plotting.style import COLOURS, INK, QUIET, field_scale, labelled, new_panels, quiet_grid, styled, time_scale
from hugoniot.plotting.sweep import scale

MOST_DOTS = 800
_BINS = 30


def draw_corner(axes, posterior) -> None:
    """axes (n, n): histograms with the 95 % interval on the diagonal, draws of each pair below it.

    posterior   a `campaign.posterior.Posterior`
    """
    count = len(posterior.names)
    chosen = np.linspace(0, len(posterior.draws) - 1, min(len(posterior.draws), MOST_DOTS)).astype(int)
    units = [scale(Column(name, unit, posterior.draws[:, k])) for k, (name, unit) in enumerate(zip(posterior.names, posterior.units))]
    for i, j in np.ndindex(count, count):
        ax, (unit, factor) = axes[i, j], units[j]
        if j > i:
            ax.set_visible(False)
            continue
        x = posterior.draws[:, j] * factor
        if i == j:
            low, middle, high = posterior.quantiles[[0, 2, -1], j] * factor
            ax.hist(x, _BINS, color=COLOURS[0], alpha=0.35, density=True)
            ax.axvspan(low, high, color=QUIET, alpha=0.15, linewidth=0)
            ax.axvline(middle, color=INK, linewidth=0.9)
            ax.set_yticks([])
        else:
            ax.plot(x[chosen], posterior.draws[chosen, i] * units[i][1], ".", color=COLOURS[0], markersize=1.6, alpha=0.5, rasterized=True)
        ax.set_xlim(*np.quantile(x, [0.001, 0.999]))
        ax.locator_params(axis="x", nbins=3)
        ax.tick_params(labelsize=7, labelbottom=i == count - 1, labelleft=j == 0 and i > 0)
        if i == count - 1:
            ax.set_xlabel(labelled(_short(posterior.names[j]), unit), fontsize=8)
        if j == 0 and i > 0:
            ax.set_ylabel(labelled(_short(posterior.names[i]), units[i][0]), fontsize=8)


def _short(name: str) -> str:
    return name.rpartition(".")[2].replace("_", " ")


@styled
def corner_figure(posterior):
    """A figure of `draw_corner`."""
    count = len(posterior.names)
    axes = new_panels(count, count, 1.7 * count + 0.8, 1.6 * count + 0.6)
    draw_corner(axes, posterior)
    return axes[0, 0].get_figure()


def draw_predictive(ax, shown, prior, predicted) -> None:
    """One record (as of `plotting.fit.draw_target`) over the 95 % bands (3, n) of runs of the prior and of the posterior."""
    label, name, _, time, values, *_ = shown
    unit, factor, words = field_scale(name.rpartition(".")[2], values)
    unit_t, ft = time_scale(float(time[-1]) if len(time) else 1.0)
    for band, colour, alpha, whose in ((prior, QUIET, 0.25, "prior"), (predicted, COLOURS[1], 0.45, "posterior")):
        ax.fill_between(time * ft, band[0] * factor, band[2] * factor, color=colour, alpha=alpha, linewidth=0,
                        label=f"{whose} predictive, 95 %")
    ax.plot(time * ft, values * factor, ".", color=INK, markersize=2.2, label="data")
    ax.set_xlabel(labelled("time", unit_t))
    ax.set_ylabel(labelled(words, unit))
    ax.set_title(label, loc="left")
    ax.legend(frameon=False, fontsize=8, loc="best")
    quiet_grid(ax)
