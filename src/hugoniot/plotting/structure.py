"""Pictures of a shock's structure: its profile with the terms of the balances, a run's cells upon it, thickness over Mach number."""

from collections.abc import Sequence

import numpy as np

from hugoniot.plotting.style import COLOURS, INK, QUIET, new_axes, new_panels, quiet_grid, scale_of, styled
from hugoniot.theory.structure.profile import Profile

_LENGTHS = (("m", 1.0), ("mm", 1e3), ("µm", 1e6), ("nm", 1e9))
_JUMPS = ("density", "velocity", "pressure", "temperature", "energy")
_TERMS = {"momentum": {"momentum_shear": "dτ/dx", "momentum_flux": "−d(ju)/dx", "momentum_pressure": "−dp/dx"},
          "energy": {"energy_shear": "d(τu)/dx", "energy_enthalpy": "−d(jH)/dx", "energy_conduction": "−dq/dx"}}


@styled
def profile_picture(profile: Profile, title: str = ""):
    """Six panels of a steady shock, see `draw_profile`; gives the axes of the first panel."""
    axes = new_panels(3, 2, 9.2, 7.6)
    draw_profile(axes.ravel(), profile)
    unit, factor = scale_of(profile.thickness(), _LENGTHS)
    axes[0, 0].set_title(title or f"Mach {profile.ends.mach:.4g}, density thickness {profile.thickness() * factor:.4g} {unit}", loc="left")
    return axes[0, 0]


def draw_profile(axes, profile: Profile) -> None:
    """Fill six axes with what Jordan's figures 6.4 to 6.7 show, and more.

    Fields as parts of their jumps; energy per volume, kinetic and internal (figs 6.6); stress and heat flux (6.7); the terms of momentum
    (6.4) and of energy (6.5); entropy and its production by viscosity and conduction. Terms are made dimensionless with the state ahead and
    the density thickness, the entropy with what the shock makes; velocities are those in the frame of the shock.
    """
    delta = profile.thickness()
    low, high = profile.extent(2e-4)
    x = np.linspace(1.1 * low, 1.1 * high, 500)
    unit, factor = scale_of(high - low, _LENGTHS)
    one, fields, terms = profile.ends.upstream, profile.at(x), profile.balance_terms(x)
    pressure, power = one.density * one.sound_speed**2, one.density * one.sound_speed**3
    jumps = {name: part for name in _JUMPS if np.isfinite(part := _part(profile, fields, name)).all()}
    if "temperature" in jumps and np.allclose(jumps["temperature"], jumps["energy"], atol=1e-3):   # one line, not a hidden one
        jumps["temperature, energy"] = jumps.pop("temperature")
        del jumps["energy"]
    panels = [("fraction of the jump", jumps), ("energy density / ρ₁c₁²", _energies(fields, pressure)),
              ("stress and heat flux", {"−τ / ρ₁c₁²": -fields["viscous_stress"] / pressure, "−q / ρ₁c₁³": -fields["heat_flux"] / power})]
    panels += [(f"{name} terms × δ / {unit_}", {word: terms[key] * delta / scale for key, word in words.items()})
               for (name, words), scale, unit_ in zip(_TERMS.items(), (pressure, power), ("ρ₁c₁²", "ρ₁c₁³"))]
    panels += _entropy_panel(profile, fields, delta)
    for ax, (ylabel, curves) in zip(axes, panels):
        curves = {word: values for word, values in curves.items() if np.abs(values).max() > 0.0}
        for k, (word, values) in enumerate(curves.items()):
            ax.plot(x * factor, values, color=COLOURS[k], label=word)
        ax.set_ylabel(ylabel)
        quiet_grid(ax)
        ax.legend(frameon=False, fontsize=8)
    for ax in axes[:len(panels)][-2:]:
        ax.set_xlabel(f"x ({unit})")
    for ax in axes[len(panels):]:
        ax.set_visible(False)


def _part(profile: Profile, fields, name):
    a, b = getattr(profile.ends.upstream, name), getattr(profile.ends.downstream, name)
    return (fields[name] - a) / (b - a)


def _energies(fields, unit) -> dict:
    """Energies per volume in the frame of the shock, in units of `unit` (Jordan figures 6.6): total, kinetic, internal."""
    kinetic, internal = 0.5 * fields["density"] * fields["velocity"] ** 2 / unit, fields["density"] * fields["energy"] / unit
    return {"total": kinetic + internal, "kinetic": kinetic, "internal": internal}


def _entropy_panel(profile: Profile, fields, delta) -> list:
    """(label, curves) of the entropy and of its production, whose area over x/δ is one; none where the law has no temperature."""
    made = profile.entropy_produced
    if not made > 0.0:
        return []
    unit = profile.ends.mass_flux * made / delta
    viscous, conductive = profile.entropy_viscous / made, profile.entropy_conductive / made
    curves = {f"produced by viscosity, {100 * viscous:.0f} %": fields["entropy_production_viscous"] / unit,
              f"produced by conduction, {100 * conductive:.0f} %": fields["entropy_production_conductive"] / unit}
    if np.isfinite(fields["entropy"]).all():
        curves["gained, (s − s₁) / Δs"] = fields["entropy"] / made
    return [("entropy; production × δ / jΔs", curves)]


def draw_cells(ax, profile: Profile, centres, fields) -> None:
    """The cells of a run (`fields` of `centres`, m, in the order of the steady wave) upon the steady wave, as parts of the jumps.

    Both stand where their density is half way.
    """
    one, two = profile.ends.upstream, profile.ends.downstream
    half = 0.5 * (one.density + two.density)
    i = max(int(np.argmax(fields["density"] >= half)), 1)
    middle = float(np.interp(half, fields["density"][i - 1:i + 1], centres[i - 1:i + 1]))
    low, high = profile.extent(2e-4)
    x = np.linspace(1.3 * low, 1.3 * high, 500)
    unit, factor = scale_of(high - low, _LENGTHS)
    smooth, cells = profile.at(x), centres - middle
    inside = (cells > x[0]) & (cells < x[-1])
    names = [name for name in ("density", "pressure", "temperature") if name in fields and np.isfinite(smooth[name]).all()]
    for name, colour in zip(names, COLOURS):
        a, b = getattr(one, name), getattr(two, name)
        ax.plot(x * factor, (smooth[name] - a) / (b - a), color=colour, linewidth=1.0, label=name)
        ax.plot(cells[inside] * factor, (fields[name][inside] - a) / (b - a), "o", color=colour, markersize=3.0, linestyle="none")
    ax.set_xlabel(f"x ({unit})", color=INK)
    ax.set_ylabel("fraction of the jump", color=INK)
    quiet_grid(ax)
    ax.legend(frameon=False, fontsize=8, labelcolor=QUIET)


@styled
def thickness_picture(curves: Sequence[tuple[str, Sequence[float], Sequence[float]]], ylabel: str, ax=None):
    """Reciprocal thickness over Mach number (Jordan fig. 6.2.1.2); curves: (name, Mach numbers, values). Gives the axes."""
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
