"""Pictures of exact solutions: fields against position at several times, a plate's history, a map of burn times."""

from collections.abc import Sequence

import numpy as np

from hugoniot.plotting.style import (
    COLOURS,
    INK,
    QUIET,
    field_scale,
    labelled,
    length_scale,
    new_axes,
    new_panels,
    quiet_grid,
    styled,
    time_scale,
)
from hugoniot.theory.exact import Solution
from hugoniot.units import format_si

# field word -> name of `core.fields`
FIELD = {"density": "density", "particle_velocity": "velocity", "pressure": "pressure", "specific_internal_energy": "energy",
         "stress": "stress", "burn_fraction": "burn_fraction", "deviator_radial": "deviator_radial", "sound_speed": "sound_speed",
         "radial_velocity": "velocity", "axial_velocity": "velocity", "transverse_velocity": "velocity"}
# columns of fronts, which are no field of a material: unit and name
FRONT = {"front_position": ("m", "position of the front"), "lag": ("m", "lag"), "slope_angle": ("degrees", "angle of the normal"),
         "shock_velocity": ("m/s", "normal velocity"), "burn_time": ("s", "burn time")}


@styled
def fields(solution: Solution, states: Sequence[dict]):
    """Up to four fields in panels, one line per time, labelled by it; gives the first axes."""
    keys = [k for k in FIELD if k in states[0] and k != "deviator_radial"]
    if {"stress", "burn_fraction"} & set(keys):  # they tell more than the energy
        keys = [k for k in keys if k != "specific_internal_energy"]
    keys = keys or [k for k in FRONT if k in states[0]]
    keys = [k for k in keys[:4] if not _runs_away(np.concatenate([s[k] for s in states]))]
    along = "position" if "position" in states[0] else "axial_position"
    rows, columns = (1, len(keys)) if len(keys) <= 3 else (2, 2)
    axes = new_panels(rows, columns, 3.7 * columns, 2.5 * rows + 0.3)
    reach = max(float(np.max(np.abs(s[along]))) for s in states)
    unit, factor = ("m", 1.0) if reach >= 0.3 else length_scale(reach)
    times = [] if solution.steady else [format_si(s["time"], "s", 4) for s in states]
    for ax, key in zip(axes.flat, keys):
        values = np.concatenate([s[key] for s in states])
        shown, scale, words = field_scale(FIELD[key], values) if key in FIELD else _front_scale(key, values)
        if shown == "kJ/kg" and np.nanmax(np.abs(values)) < 100.0:
            shown, scale = "J/kg", 1.0
        for i, state in enumerate(states):
            y = state[key] * scale
            ax.plot(state[along] * factor, y, color=COLOURS[i % len(COLOURS)])
        where = {"planar": "position", "axisymmetric": "axial position"}.get(solution.geometry, "radius")
        ax.set(xlabel=f"{where} ({unit})", ylabel=labelled(key.replace("_", " ") if FIELD.get(key) == "velocity" else words, shown))
        ax.margins(x=0.0)
        quiet_grid(ax)
    for ax in axes.flat[len(keys):]:
        ax.remove()
    place = {"xycoords": "axes fraction", "ha": "right", "va": "bottom", "fontsize": 8.5}
    if len(times) <= 4:
        for i, text in enumerate(times):
            axes[0, 0].annotate(f"t = {text}", (1.0 - 0.26 * (len(times) - 1 - i), 1.03), color=COLOURS[i % len(COLOURS)], **place)
    else:
        axes[0, 0].annotate(f"t = {times[0]} to {times[-1]}, {len(times)} times", (1.0, 1.03), color=QUIET, **place)
    axes[0, -1].annotate(solution.title if len(keys) > 1 else "", (1.0, 1.03), color=INK, **place)
    return axes[0, 0]


def _front_scale(key: str, values) -> tuple[str, float, str]:
    """(unit, factor, name) of a column of `FRONT`."""
    unit, words = FRONT[key]
    top = float(np.nanmax(np.abs(values)))
    shown, factor = {"m": length_scale, "s": time_scale}.get(unit, lambda _: (unit, 1.0))(top)
    return shown, factor, words


def _runs_away(values) -> bool:
    """Whether a field is infinite at a centre, so that nothing else of it could be seen."""
    finite = np.abs(values[np.isfinite(values)])
    return bool(finite.size) and float(finite.max()) > 1e4 * float(np.percentile(finite, 95.0)) > 0.0


@styled
def history(solution: Solution, state: dict):
    """Velocity and pressure of a driven plate against time, with its terminal velocity; gives the first axes."""
    axes = new_panels(1, 2, 7.4, 2.9)
    unit, factor = time_scale(float(np.max(state["time"])))
    for ax, key in zip(axes.flat, ("particle_velocity", "pressure")):
        shown, scale, words = field_scale(FIELD[key], state[key])
        ax.plot(state["time"] * factor, state[key] * scale, color=COLOURS[0])
        ax.set(xlabel=f"time ({unit})", ylabel=labelled(words, shown))
        ax.margins(x=0.0)
        quiet_grid(ax)
        if key == "particle_velocity":
            last = solution.numbers["terminal_velocity"] * scale
            ax.axhline(last, color=QUIET, lw=0.8, ls=(0, (4, 2)))
            ax.annotate(f"terminal velocity {last:.4g} {shown}", (0.98, last), xycoords=("axes fraction", "data"), xytext=(0, -3),
                        textcoords="offset points", ha="right", va="top", fontsize=8, color=QUIET)
    return axes[0, 0]


@styled
def burn_times(points, times, given: dict):
    """Contours of burn time over the plane, with detonators and the ball; gives the axes. Points must fill a square grid."""
    ax = new_axes(4.8, 4.2)
    x, y = (np.unique(points[:, k]) for k in (0, 1))
    unit, factor = time_scale(float(np.nanmax(times)))
    if x.size * y.size != len(times):
        drawn = ax.scatter(points[:, 0], points[:, 1], c=np.asarray(times) * factor, s=18)
        ax.figure.colorbar(drawn, ax=ax, label=f"burn time ({unit})")
    else:
        drawn = ax.contour(x, y, np.asarray(times).reshape(y.size, x.size) * factor, levels=14, colors=[COLOURS[0]], linewidths=0.8)
        ax.clabel(drawn, fontsize=7.5, fmt=lambda v: f"{v:g}")
        ax.set_title(f"burn time ({unit})", loc="left", fontsize=9)
    for place in np.atleast_2d(np.asarray(given.get("detonators", given.get("detonator")), float)):
        ax.plot(place[0], place[1], "*", color=COLOURS[1], ms=9)
    if "radius" in given:
        angle = np.linspace(0.0, 2.0 * np.pi, 200)
        ax.plot(given["radius"] * np.cos(angle), given["radius"] * np.sin(angle), color=QUIET, lw=0.9)
    ax.set(xlabel="x (m)", ylabel="y (m)", aspect="equal")
    return ax



