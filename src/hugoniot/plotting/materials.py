"""Pictures of materials: Hugoniots of several materials, or of every source of one, with the measured states."""

import textwrap
from pathlib import Path
from typing import Any

import numpy as np

from hugoniot.dossier.curves import Comparison, Curve
from hugoniot.plotting.style import RC

WIDTH = 5.6      # in: legible at 420 pixels as well as across a page
WRAP = 34        # characters of a line of the legend


def compare_figure(chosen: Comparison, path: Path | None = None) -> Any:
    """Us-up and p-up side by side, below them for the sources of one material their difference from the default; saved if `path` is given.

    A curve is full where the source states that its data reach, thin and dashed outside. Returns the matplotlib figure.
    """
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    default = chosen.curves[0] if chosen.curves and chosen.curves[0].default and sum(c.default for c in chosen.curves) == 1 else None
    differ = default is not None and len(chosen.curves) > 1
    entries = [textwrap.fill(item.label, WRAP) for item in (*chosen.states, *chosen.curves)]
    legend = 0.16 * (sum(1 + text.count("\n") for text in entries) // 2 + 2) + 0.2
    with plt.rc_context(RC):
        figure = plt.figure(figsize=(WIDTH, 2.6 + (2.2 if differ else 0.0) + legend), layout="constrained")
        grid = figure.add_gridspec(1 + differ, 2)
        axes = [figure.add_subplot(grid[0, 0]), figure.add_subplot(grid[0, 1])] + ([figure.add_subplot(grid[1, :])] if differ else [])
        colours = _colours(chosen, differ)
        unit, scale = ("GPa", 1e9) if max(float(c.p[-1]) for c in chosen.curves) > 2e8 else ("MPa", 1e6)
        for k, states in enumerate(chosen.states):
            style = {"linestyle": "none", "marker": "os^D"[k % 4], "markersize": 2.6, "markeredgewidth": 0.0, "alpha": 0.6,
                     "color": "0.5" if differ else colours.get(states.material, "0.5")}
            axes[0].plot(states.up / 1e3, states.us / 1e3, label=textwrap.fill(states.label, WRAP), **style)
            axes[1].plot(states.up / 1e3, states.p / scale, **style)
            if differ:
                inside = (states.up >= default.up[0]) & (states.up <= default.up[-1])
                base = np.interp(states.up[inside], default.up, default.us)
                axes[2].plot(states.up[inside] / 1e3, 100.0 * (states.us[inside] / base - 1.0), **style)
        for curve in chosen.curves:
            colour = colours[curve.material or curve.label]
            _draw(axes[0], curve, curve.us / 1e3, colour, label=textwrap.fill(curve.label, WRAP))
            _draw(axes[1], curve, curve.p / scale, colour)
            if differ:
                base = np.interp(curve.up, default.up, default.us)
                _draw(axes[2], curve, np.where(curve.up <= default.up[-1], 100.0 * (curve.us / base - 1.0), np.nan), colour)
        _finish(figure, axes, chosen, unit)
        if path is not None:
            figure.savefig(path, dpi=150)
            plt.close(figure)
    return figure


def _draw(axis: Any, curve: Curve, values: np.ndarray, colour: Any, label: str | None = None) -> None:
    inside = np.where(curve.reliable, values, np.nan)
    width = 2.2 if curve.default else 1.4
    axis.plot(curve.up / 1e3, values, color=colour, linewidth=0.6 * width, linestyle=(0, (4, 3)), alpha=0.8)
    axis.plot(curve.up / 1e3, inside, color=colour, linewidth=width, label=label)


def _colours(chosen: Comparison, sources: bool) -> dict:
    """Colour of each curve by material or label: black for the default among sources, no colour twice up to twenty curves."""
    from matplotlib import colormaps

    palette = colormaps["tab10"].colors if len(chosen.curves) <= 10 else colormaps["tab20"].colors
    found, k = {}, 0
    for curve in chosen.curves:
        if sources and curve.default:
            found[curve.material or curve.label] = "black"
        else:
            found[curve.material or curve.label] = palette[k % len(palette)]
            k += 1
    return found


def _finish(figure: Any, axes: Any, chosen: Comparison, unit: str) -> None:
    top = max((float(c.up[-1]) for c in chosen.curves), default=1e3) * 1.03 / 1e3
    for axis, name in zip(axes, ("shock velocity (km/s)", f"pressure ({unit})", "Us: difference from\nthe curve used (%)")):
        axis.set_xlabel("particle velocity (km/s)")
        axis.set_ylabel(name)
        axis.set_xlim(0.0, top)
    axes[1].set_ylim(bottom=0.0)
    if len(axes) == 3:
        axes[2].set_ylim(*_difference_limits(chosen))
        axes[2].axhline(0.0, color="0.8", linewidth=0.8, zorder=0)
    handles, labels = axes[0].get_legend_handles_labels()
    figure.suptitle(textwrap.fill(chosen.title, 60))
    figure.legend(handles, labels, loc="outside lower left", ncols=2, fontsize=8.5, frameon=False)
    if not all(curve.reliable.all() for curve in chosen.curves):
        axes[0].annotate("dashed: outside the stated range", (0.98, 0.03), xycoords="axes fraction", ha="right", fontsize=8, color="0.35")


def _difference_limits(chosen: Comparison) -> tuple[float, float]:
    """Limits that show the lines above the lowest eighth of the range, whatever the scatter of single states."""
    default = chosen.curves[0]
    spread = [100.0 * (c.us / np.interp(c.up, default.up, default.us) - 1.0)[len(c.up) // 8:] for c in chosen.curves[1:]]
    low, high = min(float(s.min()) for s in spread), max(float(s.max()) for s in spread)
    room = 0.15 * max(high - low, 2.0)
    return min(low - room, -2.0), max(high + room, 2.0)
