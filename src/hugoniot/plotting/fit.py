"""Pictures of a fit: data with their uncertainty under the model, and the residuals below."""

import numpy as np

from hugoniot.plotting.style import COLOURS, INK, QUIET, field_scale, labelled, new_panels, quiet_grid, styled, time_scale


def draw_target(above, below, shown) -> None:
    """One record: `shown` is (label, name, unit, time (n,), data (n,), sigma (n,), model (n,)), SI; of a
    Pop plot input pressures take the place of times."""
    label, name, _, time, values, sigma, model = shown
    if name.startswith("pop plot "):
        draw_pop_plot(above, below, shown)
        return
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
    below.set_ylabel("(model − data) / σ")
    below.set_xlim(above.get_xlim())
    for ax in (above, below):
        quiet_grid(ax)


def draw_pop_plot(above, below, shown) -> None:
    """Run distances over input pressure, both logarithmic; residuals are those of the logarithm."""
    label, _, _, pressure, values, sigma, model = shown
    p, ticks = pressure * 1e-9, _few(pressure * 1e-9)
    above.errorbar(p, values * 1e3, 2e3 * sigma, fmt="o", color=INK, markersize=3.5, linewidth=1.0, capsize=2,
                   label="data, ± 2 standard deviations")
    above.plot(p, model * 1e3, color=COLOURS[1], linewidth=1.4, label="model")
    above.set_yscale("log")
    above.set_ylabel("run distance (mm)")
    above.set_title(label, loc="left")
    above.legend(frameon=False, fontsize=8, loc="best")
    below.axhspan(-2.0, 2.0, color=QUIET, alpha=0.18, linewidth=0)
    below.axhline(0.0, color=QUIET, linewidth=0.6)
    below.plot(p, np.log(model / values) * values / sigma, "o", color=COLOURS[1], markersize=3.5)
    below.set_xlabel("input pressure (GPa)")
    below.set_ylabel("(model − data) / σ")
    for ax in (above, below):
        ax.set_xscale("log")
        ax.set_xticks(ticks, [f"{tick:.3g}" for tick in ticks])
        ax.minorticks_off()
        quiet_grid(ax)
    levels = _few(values * 1e3)
    above.set_yticks(levels, [f"{level:.3g}" for level in levels])
    above.minorticks_off()
    above.tick_params(labelbottom=False)
    below.set_xlim(above.get_xlim())


def _few(values: np.ndarray, most: int = 6) -> np.ndarray:
    """A few of the values, the ends among them, to stand beside a logarithmic axis."""
    ordered = np.unique(values)
    return ordered[np.unique(np.linspace(0, len(ordered) - 1, min(most, len(ordered))).round().astype(int))]


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
