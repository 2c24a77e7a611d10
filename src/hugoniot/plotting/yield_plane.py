r"""The stress deviators of gauges in the pi-plane, seen along the line of equal principal stresses.

The axes of the three principal stresses are projected at 120 degrees from each other; with

$$x = \tfrac{\sqrt3}{2}(s_2 - s_3), \qquad y = \tfrac12(2 s_1 - s_2 - s_3) = \tfrac32 s_1$$

the distance from the centre is the von Mises stress, so that the yield surface of von Mises is a circle of the flow stress.

Source: Herrmann, WL-TR-64-107, equations 3.31 and 3.32.
"""

import numpy as np

from hugoniot.diagnostics.stress2d import von_mises
from hugoniot.errors import DeckError
from hugoniot.plotting.style import COLOURS, INK, QUIET, field_scale, labelled, new_axes, styled
from hugoniot.units import format_si

LEAST = 1e-6      # share of the largest von Mises stress that is drawn


@styled
def pi_plane(run, names=None, times=None, ax=None):
    """Paths of the stress deviators at gauges, each with a circle at the largest von Mises stress it met; gives the axes.

    names   gauges to draw; default those that meet shear stress (at most eight)
    times   (first, last) time in s; default the whole record
    """
    rows, known = run.arrays("gauges"), run.gauge_names()
    for name in names or ():
        if name not in known:
            raise DeckError.single(run.folder, None, "gauge", f"no gauge '{name}'", f"this run has: {', '.join(known) or 'none'}")
    s, words = _principal(rows)
    largest = 0.0 if s is None or not s.size else float(np.nanmax(von_mises(s[0], s[1], 0.0, s[2])))
    if not largest > 0.0:
        raise DeckError.single(run.folder, None, "pi_plane", "no gauge of this run recorded shear stress",
                               "put a gauge into a material that has strength")
    time = rows["time"]
    during = slice(None) if times is None else (time >= times[0]) & (time <= times[1])
    s = s[:, during]
    if not s.shape[1]:
        raise DeckError.single(run.folder, None, "times", "the gauges have no record between these times",
                               f"their record runs from {format_si(time[0], 's', 4)} to {format_si(time[-1], 's', 4)}")
    met = np.nan_to_num(von_mises(s[0], s[1], 0.0, s[2])).max(axis=0)
    sheared = [k for k in range(len(known)) if met[k] > LEAST * largest][:len(COLOURS)]
    picked = [known.index(name) for name in names] if names else sheared
    unit, factor, _ = field_scale("stress", np.array([largest]))
    ax = ax if ax is not None else new_axes(5.2, 4.8)
    x, y = 0.5 * np.sqrt(3.0) * (s[1] - s[2]) * factor, 0.5 * (2.0 * s[0] - s[1] - s[2]) * factor
    turn, reach = np.linspace(0.0, 2.0 * np.pi, 361), 1.45 * largest * factor
    for k, name in enumerate(words):
        angle = np.pi / 2.0 - 2.0 * np.pi / 3.0 * k
        ax.plot([0.0, reach * np.cos(angle)], [0.0, reach * np.sin(angle)], color=QUIET, linewidth=0.8, zorder=0)
        ax.text(reach * np.cos(angle), 1.04 * reach * np.sin(angle), name, color=INK, fontsize=8.5, ha="center",
                va="top" if k else "bottom")
    for n, k in enumerate(picked):
        colour = COLOURS[n % len(COLOURS)]
        radius = met[k] * factor
        ax.plot(radius * np.cos(turn), radius * np.sin(turn), color=colour, linewidth=0.6, linestyle=(0, (4, 3)))
        ax.plot(x[:, k], y[:, k], color=colour, label=f"{known[k]}: largest {radius:.3g} {unit}")
    ax.set_aspect("equal")
    ax.set_xlim(-1.35 * reach, 1.35 * reach)
    ax.set_ylim(-0.85 * reach, 1.2 * reach)
    ax.set_xlabel(labelled("deviators in the pi-plane; distance from the centre: von Mises stress", unit))
    ax.legend(frameon=False, fontsize=8.5, loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=2)
    for side in ("top", "left", "right"):
        ax.spines[side].set_visible(False)
    ax.set_yticks([])
    return ax


def _principal(rows):
    """((3, time, gauge) principal deviators in the order of their axes, the axes' names); (None, ()) where a run has none."""
    if "deviator_radial" in rows:
        s1, s2 = rows["deviator_radial"], rows["deviator_hoop"]
        return np.stack([s1, s2, -s1 - s2]), ("direction of motion", "second axis", "third axis")
    if "deviator_xx" in rows:
        xx, yy, xy = rows["deviator_xx"], rows["deviator_yy"], rows["deviator_xy"]
        middle, radius = 0.5 * (xx + yy), np.hypot(0.5 * (xx - yy), xy)
        return np.stack([middle + radius, middle - radius, -xx - yy]), ("larger in-plane", "smaller in-plane", "out of plane")
    return None, ()
