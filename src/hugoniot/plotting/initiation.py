"""Pictures of shock initiation: the Pop plot."""

import numpy as np
from matplotlib.ticker import MaxNLocator, NullFormatter, NullLocator

from hugoniot.diagnostics.detonation import PopLine
from hugoniot.plotting.style import COLOURS, FAINT, INK, QUIET, new_axes, styled


@styled
def pop_picture(found, lines=(), ax=None):
    """Run distance over input pressure, both logarithmic; `found` a campaign PopPlot, `lines` measured rows. Gives the axes."""
    ax = ax if ax is not None else new_axes(5.4, 4.0)
    turned = [p for p in found.points if np.isfinite(p.distance)]
    pressure, distance = (np.array([getattr(p, name) for p in turned]) * scale for name, scale in (("pressure", 1e-9), ("distance", 1e3)))
    ax.set_xscale("log")
    ax.set_yscale("log")
    if found.line:
        ends = np.array([pressure.min(), pressure.max()])
        ax.plot(ends, found.line.distance(ends * 1e9) * 1e3, color=COLOURS[0])
    ax.plot(pressure, distance, "o", color=COLOURS[0], markersize=5)
    if turned:
        ax.annotate("computed", (pressure[-1], distance[-1]), (7, 3), textcoords="offset points", color=COLOURS[0])
    for k, row in enumerate(lines):
        ends = np.array([row["pressure_low"], row["pressure_high"]]) * 1e-9
        x = PopLine(row["a"], row["b"]).distance(ends * 1e9) * 1e3
        ax.plot(ends, x, "--", color=COLOURS[k + 1])
        ax.annotate(f"measured, {row['rho0']:g} kg/m³ ({row.id})", (ends[1], x[1]), (-8, 11 * k), textcoords="offset points",
                    color=COLOURS[k + 1], fontsize=8, ha="right", va="center")
    ax.set_xlabel("input pressure p (GPa)", color=INK)
    ax.set_ylabel("run distance to detonation x (mm)", color=INK)
    ax.grid(which="both", color=FAINT, linewidth=0.4)
    ax.set_axisbelow(True)
    for axis, (low, high) in ((ax.xaxis, ax.get_xlim()), (ax.yaxis, ax.get_ylim())):
        _number(axis, high / low)
    ax.tick_params(which="both", length=3.0)
    slope = f", d log p / d log x = {found.line.b:.3f}" if found.line else ""      # the line is fitted in log p, the axes are the other way
    ax.set_title(f"{found.material}{slope}", loc="left", color=INK)
    ax.text(1.0, 1.01, f"zone size {found.zone_size * 1e6:g} µm", transform=ax.transAxes, ha="right", color=QUIET, fontsize=8)
    return ax


def _number(axis, ratio: float) -> None:
    """Plain numbers along a logarithmic axis: with 1, 2 or 5 in front, powers of ten over many decades, equal steps within one."""
    axis.set_major_formatter("{x:g}")
    if ratio <= 8.0:
        axis.set_major_locator(MaxNLocator(nbins=6, steps=[1, 2, 2.5, 5, 10]))
        axis.set_minor_locator(NullLocator())
    elif ratio < 2000.0:
        axis.set_minor_formatter(lambda value, _: f"{value:g}" if f"{value:.0e}"[0] in "25" else "")
    else:
        axis.set_minor_formatter(NullFormatter())
