"""Pictures of a law's shocks and waves: its portrait, a Riemann problem, a second shock, the isotherms of a table."""

import numpy as np

from hugoniot.errors import HugoniotError
from hugoniot.laws.eos.jwl_isentrope import JWLIsentrope
from hugoniot.plotting.eos import KINDS, columns_of, finish
from hugoniot.plotting.style import COLOURS, INK, QUIET, fit_pressure, label_lines, new_axes, new_panels, quiet_grid, styled
from hugoniot.theory import second_shock as second
from hugoniot.theory.hugoniot import Initial, curve
from hugoniot.theory.isentrope import isentrope, release
from hugoniot.theory.riemann import Riemann
from hugoniot.theory.shock_lines import ShockLines
from hugoniot.theory.states import States

DASHED = (0, (4, 2))
KINDS_OF_WAVES = {"shock": "shock", "fan": "rarefaction", "none": "undisturbed"}


@styled
def portrait(name: str, material, state: States | None = None, points=None):
    """One material in the four planes of the field: Hugoniot, release from a state of it, measured points; gives the first axes.

    state   where the release starts (default: the end of the drawn Hugoniot); points   measured (up, us) in m/s or None
    """
    ahead = Initial.at_rest(material)
    reach = None if state is None else 1.3 * max(float(state.particle_velocity), 1.0)
    shocked = curve(material, ahead, up_to=reach)
    start = shocked[len(shocked) - 1] if state is None else state
    try:
        released = release(material, start, ahead.pressure, points=60)
    except HugoniotError:  # a law whose isentrope ends on the way down
        released = None
    axes = new_panels(2, 2, 7.4, 5.4)
    for ax, kind in zip(axes.flat, ("p-up", "us-up", "p-v", "t-p")):
        x, y = columns_of(kind, shocked)
        if kind == "us-up" and points is not None:
            up, us = np.asarray(points).T * 1e-3
            inside = up <= 1.02 * x[-1]
            ax.plot(up[inside], us[inside], "o", ms=3.0, mfc="none", mec=COLOURS[0], mew=0.6, alpha=0.6)
        ax.plot(x, y, color=COLOURS[0])
        if released is not None and kind != "us-up":
            ax.plot(*columns_of(kind, released), color=COLOURS[1], ls=DASHED)
        mx, my = columns_of(kind, start)
        ax.plot(mx, my, "o", color=COLOURS[0], ms=4)
        if kind == "p-up":
            ax.plot([0.0, mx[0]], [ahead.pressure * 1e-9, my[0]], color=QUIET, lw=0.7)
        if kind == "t-p" and not np.isfinite(y).any():
            ax.annotate("no temperature: the law gives none,\nor no specific heat is known", (0.5, 0.5), xycoords="axes fraction",
                        ha="center", color=QUIET, fontsize=8)
            ax.set(xticks=[], yticks=[], xlabel=KINDS[kind][0], ylabel=KINDS[kind][1])
            continue
        finish(ax, kind)
    for k, (text, colour) in enumerate((("Hugoniot", COLOURS[0]), ("release", COLOURS[1]), ("Rayleigh line", QUIET))):
        axes[0, 0].annotate(text, (0.03, 0.97 - 0.09 * k), xycoords="axes fraction", va="top", color=colour, fontsize=8.5)
    axes[0, 0].set_title(name, loc="left", fontsize=9.5)
    return axes[0, 0]


@styled
def riemann_waves(names: tuple[str, str], solution: Riemann, states: tuple[States, States]):
    """The wave curves in the P-u plane, and pressure, density and velocity against x/t; gives the first axes."""
    axes = new_panels(2, 2, 7.4, 5.2)
    for k, (wave, state) in enumerate(zip((solution.left, solution.right), states)):
        colour, behind = COLOURS[k], wave.behind
        u, p = _wave_curve(state, behind, wave)
        axes[0, 0].plot(u * 1e-3, p * 1e-9, color=colour)
        axes[0, 0].plot(state.particle_velocity * 1e-3, state.pressure * 1e-9, "o", color=colour, ms=4, mfc="none")
        text = f"{('left', 'right')[k]}: {names[k]}, {KINDS_OF_WAVES[wave.kind]}"
        axes[0, 0].annotate(text, (0.02, 1.11 - 0.08 * k), xycoords="axes fraction", color=colour, fontsize=8.5)
    if not solution.vacuum:
        axes[0, 0].plot(solution.velocity * 1e-3, solution.pressure * 1e-9, "o", color=INK, ms=4.5, zorder=5)
    edges = [v for _, v in solution.jumps]
    reach = max(max(abs(v) for v in edges), 1.0)
    low, high = min(edges) - 0.25 * reach, max(edges) + 0.25 * reach
    near = [v + side for v in edges for side in (-1e-7 * reach, 1e-7 * reach)]
    xi = np.sort(np.concatenate([np.linspace(low, high, 240), near]))
    there = solution(xi, 1.0)
    for ax, key, label, factor in ((axes[0, 1], "pressure", "pressure (GPa)", 1e-9), (axes[1, 0], "density", "density (g/cm³)", 1e-3),
                                   (axes[1, 1], "velocity", "particle velocity (km/s)", 1e-3)):
        y = np.asarray(there[key], float) * factor
        for side, colour in ((-1, COLOURS[0]), (0, QUIET), (1, COLOURS[1])):
            ax.plot(xi * 1e-3, np.where(np.asarray(there["side"]) == side, y, np.nan), color=colour)
        ax.set(xlabel="position / time (km/s)", ylabel=label)
        if key == "pressure":
            fit_pressure(ax.yaxis)
        ax.margins(x=0.0)
        quiet_grid(ax)
    axes[0, 0].set(xlabel="particle velocity (km/s)", ylabel="pressure (GPa)")
    fit_pressure(axes[0, 0].yaxis)
    quiet_grid(axes[0, 0])
    return axes[0, 0]


def _wave_curve(state: States, behind: States, wave):
    """(u, p) from the undisturbed state to a little beyond the state behind the wave."""
    from hugoniot.theory.hugoniot import shock

    if wave.kind == "none" or behind.density <= 0.0:
        return np.array([state.particle_velocity]), np.array([state.pressure])
    span = np.linspace(state.pressure, behind.pressure + 0.15 * (behind.pressure - state.pressure) * (wave.kind == "shock"), 60)
    if wave.kind == "shock":
        path = shock(state.par, Initial.of(state), pressure=span, direction=wave.direction)
    else:
        path = isentrope(state.par, state, pressure=span, direction=wave.direction)
    return np.asarray(path.particle_velocity), np.asarray(path.pressure)


@styled
def second_shocks(name: str, law: second.Quadratic, first: float, last: float):
    """Principal and second-shock Hugoniot, and their difference with its leading term; gives the first axes."""
    axes = new_panels(1, 2, 7.4, 3.3)
    mu, ahead = np.linspace(0.0, last, 201), np.linspace(first, last, 121)
    left, right = axes[0]
    left.plot(mu, second.principal(mu, law) * 1e-9, color=INK)
    left.plot(ahead, second.second(ahead, first, law) * 1e-9, color=COLOURS[0])
    left.plot(first, float(second.principal(first, law)) * 1e-9, "o", color=INK, ms=4)
    left.set(xlabel="compression µ = ρ/ρ₀ - 1", ylabel="pressure (GPa)", xlim=(0.0, last))
    left.annotate("principal Hugoniot", (0.03, 0.97), xycoords="axes fraction", va="top", fontsize=8.5)
    left.annotate(f"second shock from µ = {first:g}", (0.03, 0.89), xycoords="axes fraction", va="top", color=COLOURS[0], fontsize=8.5)
    left.set_title(name, loc="left", fontsize=9)
    curves = (("exact (A.3 − A.1)", second.second(ahead, first, law) - second.principal(ahead, law), "-"),
              ("leading term, of third order", second.leading_difference(ahead, first, law), DASHED),
              ("series (A.4 − A.2)", second.second_series(ahead, first, law) - second.principal_series(ahead, law), (0, (1, 1.5))))
    for k, (text, values, style) in enumerate(curves):
        right.plot(ahead, values * 1e-9, color=COLOURS[k], ls=style)
        right.annotate(text, (0.03, 0.06 + 0.08 * k), xycoords="axes fraction", color=COLOURS[k], fontsize=8.5)
    right.set(xlabel="compression µ", ylabel="second − principal Hugoniot (GPa)", xlim=(first, last))
    for ax in (left, right):
        quiet_grid(ax)
    return left


@styled
def isotherms(name: str, rho, temperature, pressure):
    """Pressure against density of a table along some of its temperatures, labelled at the right; gives the axes.

    rho, temperature   (n,), (m,); pressure (n, m), SI
    """
    ax = new_axes(5.4, 3.8)
    chosen = np.unique(np.linspace(0, len(temperature) - 1, min(len(temperature), 6)).round().astype(int))
    shades = [str(v) for v in np.linspace(0.72, 0.0, len(chosen))]
    for j, shade in zip(chosen, shades):
        ax.plot(np.asarray(rho) * 1e-3, np.asarray(pressure)[:, j] * 1e-9, color=shade, lw=1.1)
    ax.margins(x=0.0)
    label_lines(ax, [f"{temperature[j]:.4g} K" for j in chosen], [pressure[-1][j] * 1e-9 for j in chosen], shades)
    ax.set(xlabel="density (g/cm³)", ylabel="pressure (GPa)")
    ax.set_title(f"{name}: isotherms", loc="left", fontsize=9)
    quiet_grid(ax)
    return ax


@styled
def expansion_fit(name: str, volumes, pressures, cj: tuple[float, float], par, c: float):
    """Points of an expansion, the fitted JWL isentrope and its three terms, in logarithms; gives the axes.

    volumes V = v/v0, pressures Pa; cj   (V, p) of the CJ point; c   coefficient of the isentrope's last term, Pa
    """
    ax = new_axes(5.4, 3.8)
    v = np.geomspace(min(cj[0], float(np.min(volumes))), 1.15 * float(np.max(volumes)), 300)
    terms = tuple(zip(("A term", "B term", "C term"), JWLIsentrope.of(par, c).parts(v), strict=True))
    total = sum(values for _, values in terms)
    for text, values in terms:
        shown = values > 0.3 * float(np.min(pressures))
        if shown.any():
            ax.plot(v[shown], values[shown] * 1e-9, color=QUIET, lw=0.8, ls=DASHED)
            ax.annotate(text, (v[shown][-1], values[shown][-1] * 1e-9), xytext=(3, 3), textcoords="offset points", color=QUIET, fontsize=8)
    ax.plot(v, total * 1e-9, color=COLOURS[0])
    ax.plot(volumes, np.asarray(pressures) * 1e-9, "o", mfc="none", mec=COLOURS[1], ms=4)
    ax.plot(cj[0], cj[1] * 1e-9, "o", color=COLOURS[0], ms=5)
    ax.annotate("CJ", (cj[0], cj[1] * 1e-9), xytext=(7, 0), textcoords="offset points", color=COLOURS[0], fontsize=8.5, va="center")
    ax.annotate("points", (0.97, 0.97), xycoords="axes fraction", ha="right", va="top", color=COLOURS[1], fontsize=8.5)
    ax.annotate(f"JWL isentrope: R1 = {par.r1:.4g}, R2 = {par.r2:.4g}, omega = {par.omega:.4g}", (0.97, 0.90), xycoords="axes fraction",
                ha="right", va="top", color=COLOURS[0], fontsize=8.5)
    ax.set(xscale="log", yscale="log")
    ticks = [t for t in (0.5, 1.0, 2.0, 3.0, 5.0, 7.0, 10.0, 20.0, 50.0, 100.0) if v[0] <= t <= v[-1]]
    ax.set_xticks(ticks, [f"{t:g}" for t in ticks])
    ax.set_xticks([], minor=True)
    ax.set(xlabel="relative volume V = v/v0", ylabel="pressure (GPa)")
    ax.set_title(name, loc="left", fontsize=9)
    quiet_grid(ax)
    return ax


@styled
def shock_lines_picture(name: str, found: ShockLines):
    """Rayleigh line, Fanno line and Hugoniot of a shock over density, and its two states; gives the axes."""
    ax = new_axes(5.4, 3.8)
    drawn = (("Hugoniot", found.hugoniot_pressure, "-"), ("Rayleigh line", found.rayleigh_pressure, DASHED),
             ("Fanno line", found.fanno_pressure, (0, (1, 1.5))))
    for i, (text, pressure, style) in enumerate(drawn):
        ax.plot(found.density, pressure * 1e-9, color=COLOURS[i], ls=style)
        ax.annotate(text, (0.03, 0.95 - 0.07 * i), xycoords="axes fraction", color=COLOURS[i], fontsize=8.5, va="top")
    states = ((found.initial.density, found.initial.pressure, "ahead"),
              (float(found.behind.density), float(found.behind.pressure), "behind"))
    for density, pressure, text in states:
        ax.plot(density, pressure * 1e-9, "o", color=INK, ms=4)
        ax.annotate(text, (density, pressure * 1e-9), xytext=(6, -10), textcoords="offset points", color=INK, fontsize=8.5)
    ax.set(xlabel="density (kg/m³)", ylabel="pressure (GPa)")
    ax.set_title(name, loc="left", fontsize=9)
    quiet_grid(ax)
    return ax
