"""Pictures of a shock's structure: its profile with the terms of the balances, and reciprocal thickness over Mach number."""

from collections.abc import Sequence

import numpy as np

from hugoniot.plotting.style import COLOURS, INK, QUIET, new_axes, quiet_grid, scale_of, styled
from hugoniot.theory.structure.profile import Profile

_LENGTHS = (("m", 1.0), ("mm", 1e3), ("µm", 1e6), ("nm", 1e9))
_BALANCES = {"momentum": ("momentum_shear", "momentum_flux", "momentum_pressure"),
             "energy": ("energy_shear", "energy_enthalpy", "energy_conduction")}
_WORDS = {"momentum_shear": "dτ/dx", "momentum_flux": "−d(ju)/dx", "momentum_pressure": "−dp/dx",
          "energy_shear": "d(τu)/dx", "energy_enthalpy": "−d(jH)/dx", "energy_conduction": "−dq/dx"}


@styled
def profile_picture(profile: Profile, title: str = ""):
    """Four panels: normalised density, velocity, pressure, temperature; stress and heat flux; momentum and energy terms (004 figs 6.4-6.7).

    Gives the axes of the first panel. Terms are made dimensionless with the state ahead and the density thickness.
    """
    figure = new_axes(8.6, 5.4).get_figure()
    figure.clear()
    axes = figure.subplots(2, 2, sharex=True)
    delta = profile.thickness()
    low, high = profile.extent(2e-4)
    x = np.linspace(1.1 * low, 1.1 * high, 500)
    unit, factor = scale_of(high - low, _LENGTHS)
    one, two = profile.ends.upstream, profile.ends.downstream
    fields = profile.at(x)
    shown = [name for name in ("density", "velocity", "pressure", "temperature") if np.isfinite(fields[name]).all()]
    for name in shown:
        a, b = getattr(one, name), getattr(two, name)
        axes[0, 0].plot(x * factor, (fields[name] - a) / (b - a), label=name)
    axes[0, 0].set_ylabel("part of the jump")
    pressure, power = one.density * one.sound_speed**2, one.density * one.sound_speed**3
    axes[0, 1].plot(x * factor, -fields["viscous_stress"] / pressure, label="−τ / ρ₁c₁²")
    if profile._equations.conducting:
        axes[0, 1].plot(x * factor, -fields["heat_flux"] / power, label="−q / ρ₁c₁³")
    axes[0, 1].set_ylabel("stress and heat flux")
    terms = profile.balance_terms(x)
    for ax, (name, scale) in zip(axes[1], (("momentum", pressure), ("energy", power))):
        for key in _BALANCES[name]:
            if np.abs(terms[key]).max() > 0.0:
                ax.plot(x * factor, terms[key] * delta / scale, label=_WORDS[key])
        ax.set_ylabel(f"{name} terms × δ")
        ax.set_xlabel(f"x ({unit})")
    for ax in axes.flat:
        quiet_grid(ax)
        ax.legend(frameon=False, fontsize=8)
    axes[0, 0].set_title(title or f"Mach {profile.ends.mach:.4g}, density thickness {delta * factor:.4g} {unit}", loc="left")
    return axes[0, 0]


@styled
def thickness_picture(curves: Sequence[tuple[str, Sequence[float], Sequence[float]]], ylabel: str, ax=None):
    """Reciprocal thickness over Mach number (004 fig. 6.2.1.2); curves: (name, Mach numbers, values). Gives the axes."""
    ax = ax if ax is not None else new_axes(5.6, 3.8)
    for k, (name, machs, values) in enumerate(curves):
        ax.plot(machs, values, color=COLOURS[k % len(COLOURS)], label=name)
    ax.set_xlabel("Mach number", color=INK)
    ax.set_ylabel(ylabel, color=INK)
    ax.set_ylim(bottom=0.0)
    quiet_grid(ax)
    if len(curves) > 1:
        ax.legend(frameon=False, labelcolor=QUIET)
    return ax
