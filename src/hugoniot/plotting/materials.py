"""Pictures of materials: Hugoniots of several materials, or of every source of one, with the measured states."""

from pathlib import Path
from typing import Any

import numpy as np

from hugoniot.dossier.curves import Comparison, Curve


def compare_figure(chosen: Comparison, path: Path | None = None) -> Any:
    """Us-up and P-up side by side, and for the sources of one material their difference from the default; saved where `path` says.

    A line is full where the source states that its data reach, thin and dashed outside. Returns the matplotlib figure.
    """
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    default = chosen.curves[0] if chosen.curves and chosen.curves[0].default and sum(c.default for c in chosen.curves) == 1 else None
    panels = 3 if default is not None and len(chosen.curves) > 1 else 2
    entries = len(chosen.curves) + len(chosen.states)
    legend = 0.24 * ((entries + panels - 1) // panels) + 0.45
    figure, axes = plt.subplots(1, panels, figsize=(5.2 * panels, 4.6 + legend))
    colours = _colours(chosen, panels == 3)
    unit, scale = ("GPa", 1e9) if max(float(c.p[-1]) for c in chosen.curves) > 2e8 else ("MPa", 1e6)
    for k, states in enumerate(chosen.states):
        style = {"linestyle": "none", "marker": "os^D"[k % 4], "markersize": 3.4, "markeredgewidth": 0.0, "alpha": 0.6,
                 "color": "0.5" if panels == 3 else colours.get(states.material, "0.5")}
        axes[0].plot(states.up / 1e3, states.us / 1e3, label=states.label, **style)
        axes[1].plot(states.up / 1e3, states.p / scale, **style)
        if panels == 3:
            inside = (states.up >= default.up[0]) & (states.up <= default.up[-1])
            base = np.interp(states.up[inside], default.up, default.us)
            axes[2].plot(states.up[inside] / 1e3, 100.0 * (states.us[inside] / base - 1.0), **style)
    for curve in chosen.curves:
        colour = colours[curve.material or curve.label]
        _draw(axes[0], curve, curve.us / 1e3, colour, label=curve.label)
        _draw(axes[1], curve, curve.p / scale, colour)
        if panels == 3:
            base = np.interp(curve.up, default.up, default.us)
            _draw(axes[2], curve, np.where(curve.up <= default.up[-1], 100.0 * (curve.us / base - 1.0), np.nan), colour)
    _finish(figure, axes, chosen, unit, legend)
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


def _finish(figure: Any, axes: Any, chosen: Comparison, unit: str, legend: float) -> None:
    panels = len(axes)
    top = max((float(c.up[-1]) for c in chosen.curves), default=1e3) * 1.03 / 1e3
    for axis, name in zip(axes, ("shock velocity (km/s)", f"pressure ({unit})", "Us, difference from the curve used (%)")):
        axis.set_xlabel("particle velocity (km/s)")
        axis.set_ylabel(name)
        axis.grid(True, color="0.9", linewidth=0.6)
        axis.set_axisbelow(True)
        axis.set_xlim(0.0, top)
    axes[1].set_ylim(bottom=0.0)
    if panels == 3:
        axes[2].set_ylim(*_difference_limits(chosen))
    handles, labels = axes[0].get_legend_handles_labels()
    figure.suptitle(chosen.title)
    share = legend / figure.get_figheight()
    figure.tight_layout(rect=(0.0, share, 1.0, 0.99))
    figure.legend(handles, labels, loc="lower center", ncols=panels, fontsize=8, frameon=False,
                  bbox_to_anchor=(0.5, 0.17 / figure.get_figheight()))
    figure.text(0.5, 0.05 / figure.get_figheight(), "full line: within the stated range, or where no range is stated; dashed: outside it",
                ha="center", va="bottom", fontsize=7.5, color="0.35")


def _difference_limits(chosen: Comparison) -> tuple[float, float]:
    """Limits that show the lines above the lowest eighth of the range, whatever the scatter of single states."""
    default = chosen.curves[0]
    spread = [100.0 * (c.us / np.interp(c.up, default.up, default.us) - 1.0)[len(c.up) // 8:] for c in chosen.curves[1:]]
    low, high = min(float(s.min()) for s in spread), max(float(s.max()) for s in spread)
    room = 0.15 * max(high - low, 2.0)
    return min(low - room, -2.0), max(high + room, 2.0)
