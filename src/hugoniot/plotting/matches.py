"""The picture of an impedance match: Hugoniots of the layers, reshock or release of the layer behind, and the states, all named."""

from collections.abc import Sequence

import numpy as np

from hugoniot.plotting.eos import finish
from hugoniot.plotting.style import COLOURS, INK, QUIET, halo, new_axes, styled
from hugoniot.theory.hugoniot import Initial, curve, shock
from hugoniot.theory.impedance import Match
from hugoniot.theory.isentrope import isentrope, reference
from hugoniot.theory.states import States, law_of

SIZE = 8.5      # points


@styled
def impedance_match(layers: Sequence, velocity: float, met: Sequence[Match], ax=None):
    """The construction of an impact in the P-up plane: target Hugoniots, the flyer's curve, reshock or release, and the states."""
    ax = ax if ax is not None else new_axes(5.4, 3.8)
    names = [getattr(layer, "name", f"layer {i}") for i, layer in enumerate(layers)]
    top = 1.25 * max(m.pressure for m in met)
    ends, states = [], []
    for k, m in enumerate(met[: len(layers) - 1]):
        colour = COLOURS[(k + 1) % len(COLOURS)]
        reach = curve(law_of(layers[k + 1]), up_to=max(1.3 * m.particle_velocity, 0.05 * velocity))
        inside = reach.pressure <= top
        ax.plot(reach.particle_velocity[inside] * 1e-3, reach.pressure[inside] * 1e-9, color=colour)
        last = np.flatnonzero(inside)[-1]
        ends.append((reach.particle_velocity[last] * 1e-3, reach.pressure[last] * 1e-9, names[k + 1], colour))
        arriving = reference(layers[0], velocity) if k == 0 else met[k - 1].right
        u, p = _reflected(law_of(layers[k]), arriving, m)
        ax.plot(u * 1e-3, p * 1e-9, color=COLOURS[k % len(COLOURS)], ls=(0, (4, 2)), lw=1.1)
        ax.plot(m.particle_velocity * 1e-3, m.pressure * 1e-9, "o", color=INK, ms=4.5, zorder=5)
        below = k == 0 or m.pressure < arriving.pressure      # where the Hugoniot ahead, which rises, is not
        states.append((m.particle_velocity * 1e-3, m.pressure * 1e-9, f"{m.pressure * 1e-9:.3g} GPa, {m.particle_velocity:.4g} m/s", below))
    rung = [(m.particle_velocity * 1e-3, m.pressure * 1e-9) for m in met[len(layers) - 2:]]
    if len(rung) > 1:  # the first layer rings up between its neighbours
        ax.plot(*zip(*rung), color=QUIET, lw=0.8, marker="o", ms=3.2, zorder=4)
        states.append((*rung[-1], f"{rung[-1][1]:.4g} GPa", True))
    finish(ax, "p-up")
    ax.set_ylim(0.0, top * 1e-9)
    ax.get_figure().canvas.figure.draw_without_rendering()      # settles the layout, on which the places of labels depend
    lines = [_dense(_places(ax, line.get_xydata())) for line in ax.lines]
    taken: list[tuple[float, float, float]] = []
    _name_flyer(ax, f"{names[0]} at {velocity:.5g} m/s", velocity * 1e-3, taken, lines)
    _name_ends(ax, ends, taken, lines)
    _name_states(ax, states, taken, lines)
    return ax


def _reflected(par, arriving: States, m: Match, count: int = 40):
    """(u, p) along the curve of the layer behind, from its arriving state to the match."""
    pressures = np.linspace(arriving.pressure, m.pressure, count)
    path = (shock(par, Initial.of(arriving), pressure=pressures, direction=-1) if m.pressure >= arriving.pressure
            else isentrope(par, arriving, pressure=pressures, direction=-1))
    return path.particle_velocity, path.pressure


def _places(ax, points) -> np.ndarray:
    """Data -> points of 1/72 inch from the lower left corner of the axes."""
    figure = ax.get_figure()
    box = ax.get_position()
    low, high = np.array([ax.get_xlim(), ax.get_ylim()]).T
    size = 72.0 * np.array([figure.get_figwidth() * box.width, figure.get_figheight() * box.height])
    return (np.asarray(points, float) - low) / (high - low) * size


def _dense(line: np.ndarray) -> np.ndarray:
    """(x, y) of points along a line, at most half a point of 1/72 inch apart: what covers none of them does not lie on the line."""
    along = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(line, axis=0).T))])
    at = np.linspace(0.0, along[-1], int(2.0 * along[-1]) + 2)
    return np.array([np.interp(at, along, line[:, k]) for k in (0, 1)])


def _name_flyer(ax, text: str, velocity: float, taken, lines) -> None:
    """The flyer's name to the left of the foot of its curve."""
    width = _width(text)
    tried = [(-8.0 - width - 0.5 * SIZE * k, (1.2 + 0.5 * j) * SIZE) for k in range(30) for j in range(12)]
    across, up = _free(taken, lines, _places(ax, [(velocity, 0.0)])[0], text, sorted(tried, key=lambda at: 2.0 * at[1] - at[0]))
    ax.annotate(text, (velocity, 0.0), xytext=(across + width, up), textcoords="offset points", color=COLOURS[0], fontsize=SIZE,
                ha="right", va="center", path_effects=halo())


def _name_ends(ax, ends, taken, lines) -> None:
    """Names of the Hugoniots where they end, those too near to another one, or to a line, above it."""
    places = _places(ax, [(x, y) for x, y, *_ in ends])
    for i in np.argsort(places[:, 0]):
        x, y, name, colour = ends[i]
        shift = _free(taken, lines, places[i], name, [(3.0, 6.0 + 0.65 * SIZE * k) for k in range(2 * len(ends) + 4)])
        ax.annotate(name, (x, y), xytext=shift, textcoords="offset points", color=colour, fontsize=SIZE, va="center", path_effects=halo())


def _name_states(ax, states, taken, lines) -> None:
    """Pressure and particle velocity beside each state, in the nearest place that is free, with a thin line to those further away."""
    places = _places(ax, [(x, y) for x, y, *_ in states])
    for i in np.argsort(-places[:, 1]):
        x, y, text, below = states[i]
        width, first = _width(text), -0.9 * SIZE if below else 0.6 * SIZE
        ups = [first - 0.65 * SIZE * j for j in range(-6, 7)]
        tried = [(at, up) for k in range(50) for at in (9.0 + 0.5 * SIZE * k, -9.0 - width - 0.5 * SIZE * k) for up in ups]
        inside = [at for at in tried if places[i][0] + at[0] > 0.0 and places[i][1] + at[1] > SIZE]

        def far(at, width=width, first=first):
            return max(at[0], -at[0] - width) + 2.5 * abs(at[1] - first)

        across, up = _free(taken, lines, places[i], text, sorted(inside, key=far))
        near = across if across > 0.0 else across + width
        ax.annotate(text, (x, y), xytext=(near, up), textcoords="offset points", fontsize=8, color=INK, va="center",
                    ha="left" if across > 0.0 else "right", path_effects=halo(), zorder=6)
        if abs(near) > 9.0 + SIZE:
            ax.annotate("", (x, y), xytext=(near - np.sign(near), up), textcoords="offset points",
                        arrowprops={"arrowstyle": "-", "color": QUIET, "lw": 0.6, "shrinkB": 3.0, "shrinkA": 0.0})


def _width(text: str) -> float:
    """Of a label, at most, in points."""
    return 0.62 * SIZE * len(text)


def _free(taken, lines, place, text: str, shifts: Sequence[tuple[float, float]]) -> tuple[float, float]:
    """The first of the shifts by which the text meets no other text and no line (else the last); its place is taken from then on."""
    width, left, height = _width(text), 0.0, 0.0
    for across, up in shifts:
        left, height = place[0] + across, place[1] + up
        if any(left < right and other < left + width and abs(height - level) < 1.3 * SIZE for other, right, level in taken):
            continue
        if not any(((x > left - 2.0) & (x < left + width) & (abs(y - height) < 0.65 * SIZE)).any() for x, y in lines):
            break
    taken.append((left, left + width, height))
    return across, up
