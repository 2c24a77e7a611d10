"""Pictures of burning: the reaction zone of a detonation, and mixtures of reactants and products."""

from collections.abc import Sequence

import numpy as np

from hugoniot.errors import HugoniotError
from hugoniot.laws.mixture.contract import MIXTURE
from hugoniot.plotting.style import COLOURS, INK, QUIET, label_lines, length_scale, new_panels, quiet_grid, styled
from hugoniot.theory.hugoniot import Initial, curve, shock
from hugoniot.theory.mixture import FrozenHugoniot, MixtureState

DASHED = (0, (4, 2))


@styled
def reaction_zones(zones: Sequence[tuple[str, object, object, Initial]]):
    """Pressure, burn fraction and temperature behind the front, and the way in the P-V plane; gives the first axes.

    zones   (name, Structure, law or mixture, state ahead) of each
    """
    axes = new_panels(2, 2, 7.6, 5.4)
    last = max(_shown(zone) for _, zone, _, _ in zones)
    unit, factor = length_scale(last)
    for i, (name, zone, par, ahead) in enumerate(zones):
        colour, table = COLOURS[i % len(COLOURS)], zone.table()
        x = table["position"] * factor
        dense = np.linspace(0.0, last * factor, 400)
        for ax, key, scale in ((axes[0, 0], "pressure", 1e-9), (axes[1, 0], "reaction", 1.0), (axes[1, 1], "temperature", 1.0)):
            if table[key] is not None:
                # nascent products are hot at once: at fraction 0 the temperature is still the reactants'
                first = 1 if key == "temperature" else 0
                ax.plot(dense, np.interp(dense, x[first:], table[key][first:] * scale), color=colour)
        spike = zone.von_neumann.pressure * 1e-9
        axes[0, 0].plot([0.0, 0.0], [ahead.pressure * 1e-9, spike], color=colour)
        axes[0, 0].plot(0.0, spike, "o", color=colour, ms=4)
        half = zone.half_reaction_length * factor
        axes[1, 0].plot(half, 0.5, "o", color=colour, ms=4)
        axes[1, 0].annotate(f"half burned after {half:.3g} {unit}", (0.98, 0.05 + 0.085 * (len(zones) - 1 - i)),
                            xycoords="axes fraction", ha="right", fontsize=8, color=colour)
        axes[0, 0].annotate(f"{name}: D = {zone.velocity * 1e-3:.4g} km/s, spike {spike:.3g} GPa", (0.98, 0.97 - 0.085 * i),
                            xycoords="axes fraction", ha="right", va="top", fontsize=8, color=colour)
        _plane(axes[0, 1], zone, par, ahead, colour, notes=i == 0)
    warm = _temperature(par for _, _, par, _ in zones)
    for ax, label in ((axes[0, 0], "pressure (GPa)"), (axes[1, 0], "burn fraction"), (axes[1, 1], warm)):
        ax.set(xlabel=f"distance behind the front ({unit})", ylabel=label, xlim=(-0.03 * last * factor, last * factor))
        quiet_grid(ax)
    axes[0, 0].set_ylim(0.0, (1.13 + 0.12 * len(zones)) * max(zone.von_neumann.pressure for _, zone, _, _ in zones) * 1e-9)
    if not axes[1, 1].lines:
        axes[1, 1].annotate("no temperature: the laws give no specific heat", (0.5, 0.5), xycoords="axes fraction", ha="center",
                            color=QUIET, fontsize=8)
    axes[0, 1].set(xlabel="specific volume (cm³/g)", ylabel="pressure (GPa)")
    quiet_grid(axes[0, 1])
    return axes[0, 0]


def _temperature(laws) -> str:
    """Label of the temperature: of the products where reactants are isolated, also beside closures with one temperature for both phases."""
    flags = [MIXTURE.of(law).flags if MIXTURE.knows(law) else () for law in laws]
    isolated, meaned = any("follows_isentrope" in f for f in flags), any("no_equilibrium" in f for f in flags)
    return "temperature of the products (K)" if isolated and not meaned else "temperature (K)"


def _shown(zone) -> float:
    """How far behind the front the zone is worth drawing: to 99 % burned, at least five half-reaction lengths."""
    return max(float(np.interp(0.99, zone.reaction, zone.position)), min(5.0 * zone.half_reaction_length, float(zone.position[-1])))


def _plane(ax, zone, par, ahead: Initial, colour, notes: bool) -> None:
    """Rayleigh line, Hugoniot of the unreacted explosive and of the products, spike and end of reaction."""
    from dataclasses import replace

    v0 = 1.0 / ahead.density
    spike, end = zone.von_neumann, zone.states
    mixed = isinstance(end, MixtureState)
    reactants, products = (par.reactants, par.products) if mixed else (par, par)
    burned = replace(ahead, energy=ahead.energy + par.detonation_energy) if mixed else ahead
    volumes = v0 - np.linspace(0.0, 1.03, 80) * (v0 - 1.0 / spike.density)
    before = shock(reactants, replace(ahead, heat=0.0), density=1.0 / volumes[1:])
    ax.plot(1e3 * volumes[1:], before.pressure * 1e-9, color=colour, lw=0.9, ls=(0, (1, 1.5)))
    last = 1.0 / float(end.density[-1])
    try:
        after = shock(products, burned, density=1.0 / (v0 - np.linspace(0.35, 1.35, 80) * (v0 - last)))
        inside = after.pressure <= 1.05 * spike.pressure
        ax.plot(1e3 / after.density[inside], after.pressure[inside] * 1e-9, color=colour, lw=0.9, ls=DASHED)
    except HugoniotError:  # a law that ends on the way
        pass
    ax.plot([1e3 * v0, 1e3 / spike.density], [ahead.pressure * 1e-9, spike.pressure * 1e-9], color=colour, lw=0.6)
    ax.plot(1e3 / end.density, end.pressure * 1e-9, color=colour, lw=2.2)
    ax.plot([1e3 / spike.density, 1e3 * last], [spike.pressure * 1e-9, float(end.pressure[-1]) * 1e-9], "o", color=colour, ms=4)
    if notes:
        ax.annotate("heavy: reaction zone, on its Rayleigh line\ndotted: Hugoniot of the unreacted\ndashed: Hugoniot of the products",
                    (0.99, 0.98), xycoords="axes fraction", ha="right", va="top", fontsize=8, color=QUIET)


@styled
def mixture_states(name: str, curves: Sequence[tuple[str, MixtureState]], along: str):
    """Pressure, sound speed, Gamma and temperature of mixtures against burn fraction or volume; gives the first axes.

    curves   (closure, states); along   "burn_fraction" or "volume" (an adiabat; the burn fraction then takes Gamma's place)
    """
    axes = new_panels(2, 2, 7.2, 5.0)
    keys = (("pressure", "pressure (GPa)", 1e-9), ("sound_speed", "sound speed (km/s)", 1e-3),
            ("burn_fraction", "burn fraction", 1.0) if along == "volume" else ("gruneisen", "Grüneisen parameter", 1.0),
            ("temperature", _temperature(states.par for _, states in curves), 1.0))
    for ax, (key, label, factor) in zip(axes.flat, keys):
        ends, names, colours = [], [], []
        for i, (closure, states) in enumerate(curves):
            y = states.table()[key]
            if y is None:
                continue
            x = states.burn_fraction if along == "burn_fraction" else 1e3 / states.density
            colour = COLOURS[i % len(COLOURS)]
            y = np.asarray(y) * factor
            # in isolation Gamma and T do not join the reactants' as burning begins
            there = states.burn_fraction > 0.0 if key in ("gruneisen", "temperature") else np.ones(y.shape, bool)
            ax.plot(x[there], y[there], color=colour, ls="-" if i == 0 else DASHED)
            ends.append(float(y[-1]))
            names.append(closure.replace("_", " "))
            colours.append(colour)
        ax.set(ylabel=label, xlabel="burn fraction" if along == "burn_fraction" else "specific volume (cm³/g)")
        ax.margins(x=0.0)
        quiet_grid(ax)
        if ax is axes[0, 0]:
            high = ax.get_ylim()[1] > 0 and ends and ends[0] > np.mean(ax.get_ylim())
            for k, (text, colour) in enumerate(zip(names, colours)):
                ax.annotate(("solid: " if k == 0 else "dashed: ") + text, (0.97, (0.22 if high else 0.97) - 0.09 * k),
                            xycoords="axes fraction", ha="right", va="top", color=colour, fontsize=8.5)
    axes[0, 0].set_title(name, loc="left", fontsize=9, color=INK)
    return axes[0, 0]


@styled
def mixture_hugoniots(name: str, found: Sequence[tuple[str, object, FrozenHugoniot]]):
    """Frozen Hugoniots of mixtures in the P-up plane beside that of the reactants alone; gives the axes."""
    ax = new_panels(1, 1, 5.4, 3.8)[0, 0]
    for i, (closure, _, states) in enumerate(found):
        ax.plot(states.particle_velocity * 1e-3, states.pressure * 1e-9, color=COLOURS[i % len(COLOURS)], ls="-" if i == 0 else DASHED)
        ax.annotate(("solid: " if i == 0 else "dashed: ") + closure.replace("_", " "), (0.03, 0.97 - 0.07 * i), xycoords="axes fraction",
                    va="top", color=COLOURS[i % len(COLOURS)], fontsize=8.5)
    top = max(float(states.pressure[-1]) for _, _, states in found)
    alone = curve(found[0][1], up_to=float(shock(found[0][1], pressure=top).particle_velocity))
    ax.plot(alone.particle_velocity * 1e-3, alone.pressure * 1e-9, color=QUIET, lw=0.9)
    ax.set_xlim(left=0.0)
    label_lines(ax, ["unreacted, from rest"], [alone.pressure[-1] * 1e-9], [QUIET])
    ax.set(xlabel="particle velocity behind the shock (km/s)", ylabel="pressure (GPa)")
    ax.set_title(name, loc="left", fontsize=9, color=INK)
    quiet_grid(ax)
    return ax
