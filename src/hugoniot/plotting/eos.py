"""Pictures of equations of state: P-up with Rayleigh lines, Us-up with the measured points, P-V, T-P, release paths."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from hugoniot.errors import DeckError, FileTrouble
from hugoniot.plotting.style import COLOURS, INK, QUIET, fit_pressure, halo, label_lines, new_axes, quiet_grid, styled
from hugoniot.theory.hugoniot import Initial, curve
from hugoniot.theory.isentrope import isentrope
from hugoniot.theory.states import States

KINDS = {"p-up": ("particle velocity (km/s)", "pressure (GPa)"), "us-up": ("particle velocity (km/s)", "shock velocity (km/s)"),
         "p-v": ("specific volume (cm³/g)", "pressure (GPa)"), "t-p": ("pressure (GPa)", "temperature (K)")}


def save(axes, path) -> None:
    """Write the picture; `FileTrouble` if it cannot be written, `DeckError` for an unknown kind of file."""
    path = Path(path)
    figure = axes.get_figure()
    known = figure.canvas.get_supported_filetypes()
    if path.suffix.lstrip(".").lower() not in known:
        raise DeckError.single("command line", None, "--plot", f"'{path.name}' is not a picture file", "end the name in .png, .pdf or .svg")
    try:
        figure.savefig(path, bbox_inches="tight")
    except OSError as error:
        raise FileTrouble(f"cannot write {path}: {error.strerror or error}") from None


@styled
def hugoniots(curves: Sequence[tuple[str, Initial, States]], kind: str = "p-up", *, points: Sequence | None = None,
              mark: Sequence[States] | None = None, ax=None):
    """Hugoniots of several materials in one picture; gives the axes.

    curves   (name, upstream state, states) of each
    kind     "p-up" (with the Rayleigh line to the end or the marked state), "us-up", "p-v" or "t-p"
    points   per curve the measured (up, us) in m/s, or None; drawn in the planes of "us-up" and "p-up"
    mark     per curve one state to point out
    """
    if kind not in KINDS:
        raise DeckError.single("command line", None, "--axes", f"unknown picture '{kind}'", f"choose one of {', '.join(KINDS)}")
    ax = ax if ax is not None else new_axes(5.4, 3.8)
    if kind == "t-p" and all(np.isnan(_temperature(states)).all() for _, _, states in curves):
        raise DeckError.single("command line", None, "--axes", "none of these equations of state gives a temperature",
                               "give a specific heat in the material's tables")
    heights = []
    for i, (_, ahead, states) in enumerate(curves):
        colour = COLOURS[i % len(COLOURS)]
        if kind in ("us-up", "p-up") and points is not None and points[i] is not None:
            up, us = np.asarray(points[i]).T * 1e-3
            inside = up <= 1.02 * np.max(states.particle_velocity) * 1e-3
            # of the points' own shocks: p = rho0 Us up, in GPa
            height = us if kind == "us-up" else ahead.pressure * 1e-9 + 1e-3 * ahead.density * us * up
            ax.plot(up[inside], height[inside], "o", ms=3.2, mfc="none", mec=colour, mew=0.6, alpha=0.65, zorder=1)
        x, y = columns_of(kind, states)
        ax.plot(x, y, color=colour, zorder=3)
        if kind == "p-up" and ahead.velocity > 0.0:  # a second shock: the principal Hugoniot beside it
            first = curve(states.par, up_to=float(np.max(states.particle_velocity)))
            ax.plot(*columns_of(kind, first), color=colour, lw=0.8, alpha=0.5)
            ax.annotate("thin: principal Hugoniot", (0.02, 0.97), xycoords="axes fraction", va="top", fontsize=8, color=QUIET)
        marked = mark[i] if mark is not None else None
        if kind == "p-up":
            _rayleigh(ax, ahead, marked if marked is not None else states[len(states) - 1], colour)
        elif kind == "p-v":
            _chord(ax, ahead, marked if marked is not None else states[len(states) - 1], colour)
        if marked is not None:
            mx, my = columns_of(kind, marked)
            ax.plot(mx, my, "o", color=colour, ms=5, zorder=5)
        heights.append(y)
    finish(ax, kind)
    if kind in ("p-up", "p-v"):
        corner = (0.02, 0.03) if kind == "p-v" else (0.02, 0.9)
        ax.annotate("dashed: Rayleigh line", corner, xycoords="axes fraction", fontsize=8, color=QUIET, path_effects=halo())
    if kind == "p-up" and mark is not None:
        # every curve rises from the lower left to the upper right and is hollow: the corner below it is free
        for i, (state, (name, _, _)) in enumerate(zip(mark, curves)):
            text = f"{state.pressure * 1e-9:.4g} GPa, {state.particle_velocity:.4g} m/s, Us = {state.shock_velocity * 1e-3:.4g} km/s"
            ax.annotate(f"{name}: {text}", (0.99, 0.03 + 0.055 * (len(curves) - 1 - i)), xycoords="axes fraction", ha="right", fontsize=8,
                        color=COLOURS[i % len(COLOURS)], bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.6, "alpha": 0.8})
    if kind == "p-v":
        _name_at_top(ax, [name for name, _, _ in curves], [columns_of(kind, s) for _, _, s in curves])
    else:
        label_lines_at_ends(ax, [name for name, _, _ in curves], [columns_of(kind, s) for _, _, s in curves])
    if kind == "us-up":
        ax.set_ylim(bottom=0.9 * min(np.nanmin(h[np.isfinite(h)]) for h in heights))
    return ax


@styled
def releases(paths: Sequence[tuple[str, States | None, States]], ax=None):
    """Release isentropes against particle velocity, with the Hugoniot each left (faint); gives the axes.

    paths   (name, Hugoniot or None, states along the release)
    """
    ax = ax if ax is not None else new_axes(5.4, 3.8)
    columns = []
    for i, (_, shocked, states) in enumerate(paths):
        colour = COLOURS[i % len(COLOURS)]
        x, y = columns_of("p-up", states)
        if shocked is not None:
            hx, hy = columns_of("p-up", shocked)
            below = hy <= 1.0001 * np.max(y)
            ax.plot(hx[below], hy[below], color=colour, lw=0.9, alpha=0.5)
        ax.plot(x, y, color=colour)
        ax.plot(x[0], y[0], "o", color=colour, ms=4.5)
        columns.append((x, y))
    finish(ax, "p-up")
    for i, ((name, shocked, _), (x, y)) in enumerate(zip(paths, columns)):
        middle = int(np.argmin(np.abs(y - 0.45 * np.max(y))))
        ax.annotate(f"{name} release", (x[middle], y[middle]), xytext=(7, 4), textcoords="offset points",
                    color=COLOURS[i % len(COLOURS)], fontsize=8.5, path_effects=halo())
        if shocked is not None and i == 0:
            hx, hy = columns_of("p-up", shocked)
            k = int(np.searchsorted(hy, 0.45 * np.max(y)))
            ax.annotate("Hugoniot", (hx[k], hy[k]), xytext=(-8, 2), textcoords="offset points", color=QUIET, fontsize=8, ha="right")
    return ax


@styled
def waves_in_time(diagram, names: Sequence[str], ax=None):
    """The x-t diagram of an impact: shocks solid, fans thin, interfaces and free surfaces grey; gives the axes."""
    ax = ax if ax is not None else new_axes(5.4, 4.2)
    looks = {"shock": (COLOURS[1], 1.3, 3), "fan": (COLOURS[0], 0.6, 2), "interface": (INK, 0.9, 4), "surface": (INK, 0.9, 4),
             "contact": (QUIET, 0.4, 1)}
    for kind, t1, x1, t2, x2 in diagram.paths:
        colour, width, order = looks[kind]
        ax.plot([x1 * 1e3, x2 * 1e3], [t1 * 1e6, t2 * 1e6], color=colour, lw=width, zorder=order)
    edges = sorted({x1 for kind, t1, x1, _, _ in diagram.paths if t1 == 0.0 and kind in ("surface", "interface")} | {0.0})
    for name, low, high in zip(names, edges, edges[1:]):
        ax.text(0.5 * (low + high) * 1e3, -0.012 * diagram.time * 1e6, name, ha="center", va="top", fontsize=8.5, color=INK)
    legend = [("shock", "shocks", 0.0), ("fan", "release fans", 0.14)]
    if any(kind == "contact" for kind, *_ in diagram.paths):
        legend.append(("contact", "thin grey: contacts left by crossing waves", 0.37))
    for kind, label, place in legend:
        ax.text(place, 1.02, label, transform=ax.transAxes, color=looks[kind][0], fontsize=8.5)
    ax.set_ylim(-0.07 * diagram.time * 1e6, diagram.time * 1e6)
    ax.set_xlabel("position (mm)")
    ax.set_ylabel("time (µs)")
    return ax


@styled
def detonations(points: Sequence, ax=None):
    """Detonation Hugoniot, Rayleigh line and CJ point of explosives in the P-V plane; gives the axes."""
    ax = ax if ax is not None else new_axes(5.4, 3.8)
    for i, (name, found) in enumerate(points):
        colour = COLOURS[i % len(COLOURS)]
        ahead, state = found.initial, found.state
        v0 = 1.0 / ahead.density
        x = np.linspace(0.05, 1.25, 80) * (v0 - 1.0 / state.density)
        from hugoniot.theory.hugoniot import shock

        hugoniot = shock(state.par, ahead, density=1.0 / (v0 - x))
        fall = isentrope(state.par, state, density=1.0 / np.linspace(1.0 / state.density, 1.35 * v0, 40), direction=-1)
        ax.plot(1e3 / hugoniot.density, hugoniot.pressure * 1e-9, color=colour)
        ax.plot(1e3 / fall.density, fall.pressure * 1e-9, color=colour, ls=(0, (4, 2)), lw=1.0)
        ax.plot([v0 * 1e3, 1e3 / state.density], [ahead.pressure * 1e-9, state.pressure * 1e-9], color=colour, lw=0.8)
        ax.plot(1e3 / state.density, state.pressure * 1e-9, "o", color=colour, ms=4.5)
        text = f"{name}: D = {found.detonation_velocity * 1e-3:.4g} km/s"
        ax.annotate(text, (1e3 / state.density, state.pressure * 1e-9), xytext=(-8, -2),
                    textcoords="offset points", color=colour, fontsize=8.5, ha="right", va="top")
    ax.annotate("solid: detonation Hugoniot, Rayleigh line\ndashed: isentrope of the products", (0.99, 0.97), xycoords="axes fraction",
                ha="right", va="top", fontsize=8, color=QUIET)
    finish(ax, "p-v")
    left, right = ax.get_xlim()
    ax.set_xlim(left - 0.3 * (right - left), right)
    return ax


@styled
def us_up_fit(fits: Sequence, ax=None):
    """Measured points with the fitted line and its one-sigma band; dashed where no points are; gives the axes."""
    ax = ax if ax is not None else new_axes(5.4, 3.8)
    for i, (name, found) in enumerate(fits):
        colour = COLOURS[i % len(COLOURS)]
        up, us = found.points.T * 1e-3
        ax.plot(up, us, "o", ms=3.4, mfc="none", mec=colour, mew=0.7, alpha=0.7)
        x = np.linspace(0.0, 1.15 * found.highest, 200)
        inside = (x >= found.least) & (x <= found.highest)
        y, band = found(x), found.band(x)
        ax.plot(x * 1e-3, np.where(inside, y, np.nan) * 1e-3, color=colour)
        ax.plot(x * 1e-3, np.where(inside, np.nan, y) * 1e-3, color=colour, ls=(0, (4, 2)))
        ax.fill_between(x * 1e-3, (y - band) * 1e-3, (y + band) * 1e-3, color=colour, alpha=0.18, lw=0)
        terms = [f"{found.coefficients[0] * 1e-3:.3f}", f"{found.coefficients[1]:.3f} up"]
        if len(found.coefficients) == 3:
            terms.append(f"{found.coefficients[2] * 1e3:.3g} up²")
        text = " + ".join(terms).replace("+ -", "- ")
        ax.annotate(f"{name}: Us = {text} km/s\nstandard deviation {found.deviation:.0f} m/s, {len(up)} points", (0.03, 0.97 - 0.13 * i),
                    xycoords="axes fraction", va="top", color=colour, fontsize=8.5)
    finish(ax, "us-up")
    ax.set_ylim(bottom=None)
    return ax


def label_lines_at_ends(ax, names, columns) -> None:
    """Each name beside the right end of its line, in its colour."""
    right = max(np.nanmax(x) for x, _ in columns)
    at_edge = [i for i, (x, _) in enumerate(columns) if np.nanmax(x) > 0.97 * right]
    if len(at_edge) == len(columns):
        ax.set_xlim(right=right)
        label_lines(ax, names, [y[np.isfinite(y)][-1] for _, y in columns], [COLOURS[i % len(COLOURS)] for i in range(len(names))])
        return
    ends = [(x[k], y[k]) for x, y in columns for k in np.flatnonzero(np.isfinite(y))[-1:]]
    size = np.array([ax.get_xlim()[1] - ax.get_xlim()[0], ax.get_ylim()[1] - ax.get_ylim()[0]])
    placed: list[np.ndarray] = []
    for i in np.argsort([end[1] for end in ends]):
        place, lift = np.array(ends[i]) / size, 0.0
        while any(abs(place[0] - other[0]) < 0.15 and abs(place[1] + lift - other[1]) < 0.05 for other in placed):
            lift += 0.01
        placed.append(place + [0.0, lift])
        ax.annotate(names[i], ends[i], xytext=(4, lift * 72.0 * 3.0), textcoords="offset points", color=COLOURS[i % len(COLOURS)],
                    fontsize=8.5, va="center", path_effects=halo())


def _name_at_top(ax, names, columns):
    for i, (name, (x, y)) in enumerate(zip(names, columns)):
        ax.annotate(name, (x[-1], y[-1]), xytext=(4, 2), textcoords="offset points", color=COLOURS[i % len(COLOURS)], fontsize=8.5,
                    path_effects=halo())


def _temperature(states: States):
    found = states.temperature
    return np.full(np.shape(states.density), np.nan) if found is None else np.asarray(found, float)


def columns_of(kind: str, states: States):
    """(x, y) in the units of the picture."""
    if kind == "p-up":
        pair = np.asarray(states.particle_velocity) * 1e-3, np.asarray(states.pressure) * 1e-9
    elif kind == "us-up":
        pair = np.asarray(states.particle_velocity) * 1e-3, np.asarray(states.shock_velocity) * 1e-3
    elif kind == "p-v":
        pair = 1e3 / np.asarray(states.density), np.asarray(states.pressure) * 1e-9
    else:
        pair = np.asarray(states.pressure) * 1e-9, _temperature(states)
    return tuple(np.atleast_1d(v) for v in pair)


def _rayleigh(ax, ahead: Initial, state: States, colour):
    """The line from the upstream state to the shocked one: its slope is rho0 Us."""
    ax.plot([ahead.velocity * 1e-3, state.particle_velocity * 1e-3], [ahead.pressure * 1e-9, state.pressure * 1e-9], color=colour, lw=0.7,
            ls=(0, (4, 3)), alpha=0.8)


def _chord(ax, ahead: Initial, state: States, colour):
    ax.plot([1e3 / ahead.density, 1e3 / state.density], [ahead.pressure * 1e-9, state.pressure * 1e-9], color=colour, lw=0.7,
            ls=(0, (4, 3)), alpha=0.8)


def finish(ax, kind: str) -> None:
    """Labels, origin and grid of one of the planes of the field; pressures of gases in MPa or kPa."""
    ax.set_xlabel(KINDS[kind][0])
    ax.set_ylabel(KINDS[kind][1])
    if kind == "p-up":
        ax.set_ylim(bottom=0.0)
        ax.set_xlim(left=min(0.0, ax.get_xlim()[0]) if ax.get_xlim()[0] < -1e-3 else 0.0)
    if kind in ("p-up", "p-v"):
        fit_pressure(ax.yaxis)
    elif kind == "t-p":
        fit_pressure(ax.xaxis)
    quiet_grid(ax)


__all__ = ["columns_of", "detonations", "finish", "hugoniots", "releases", "save", "us_up_fit", "waves_in_time"]
