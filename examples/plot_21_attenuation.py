"""
Attenuation of a shock behind a thin flyer
==========================================

A flyer plate's release overtakes its own shock: the free surface of a thick target is slower than that of a thin one. One sweep over
target thickness, flyer speed and yield stress gives the curves of figures 3 and 4 of WL-TR-64-107 (Herrmann) for two plates of aluminium.

The report shows points of Curran (J. Appl. Phys. 34 (1963) 2677) and a theory of Fowles (J. Appl. Phys. 31 (1960) 655) beside its curves
only as drawings, without numbers, so they are not repeated here. Theory: the release catches the shock in a target that is
(c + U) / (c - U) flyers thick, with the Lagrangian speeds of shock U and release c.
"""

import tempfile

import matplotlib.pyplot as plt
import numpy as np
import xarray

import hugoniot
from hugoniot.diagnostics.arrival import first_crossing
from hugoniot.plotting.style import COLOURS, QUIET, RC
from hugoniot.problem.deck import read_deck
from hugoniot.theory.hugoniot import shock

plt.rcParams.update(RC)
SPEEDS, THICKNESSES = (1.2, 1.9), (1.5, 3, 5, 6.5, 8, 10, 13)

with tempfile.TemporaryDirectory() as folder:
    table = hugoniot.sweep(
        "flyer.toml", {"thickness": list(THICKNESSES), "region.flyer.velocity": [f"{u} km/s" for u in SPEEDS],
                       "material.al.strength.yield_stress": ["0 GPa", "0.276 GPa"], "region.flyer.zones": 30, "stop_time": "5.2 us",
                       "output.snapshots": "5.2 us"},
        tie=["region.target.to = region.flyer.to * (1 + thickness)", "region.target.zones = round(region.flyer.zones * thickness)"],
        out=folder, output=["free surface.peak_velocity"], record=["free surface.velocity"], report=False).squeeze()

aluminum = read_deck("flyer.toml").problem.materials["al"]


def caught(speed, elastic, delay=0.0):
    """Thickness of a target in flyers from which on the release of a flyer (km/s) comes less than `delay` (s) behind the shock."""
    state, law = shock(aluminum.eos, particle_velocity=500.0 * speed), aluminum.eos
    shear = aluminum.strength.shear_modulus if elastic else 0.0
    release = np.sqrt(state.sound_speed**2 + 4.0 * shear / (3.0 * state.density)) * state.density / law.rho0
    fast, slow = 1.0 / release, 1.0 / state.shock_velocity
    return float((slow + fast - delay / 2e-3) / (slow - fast))      # the flyer is 2 mm thick


# %%
# The velocity 0.12 µs after the main wave: at first the flyer's velocity, as the release is almost the mirror image of the shock.
# It falls where the release comes within those 0.12 µs (dotted, from the speeds of sound and shock): sooner with a yield stress, for
# then the front of the release is elastic and runs at the longitudinal speed.
DELAY, time = 0.12e-6, table["time"].values


def behind(u):      # the main wave, not the precursor, and before the release that limits the plateau
    return np.interp(first_crossing(time, u, 0.5 * u.max()) + DELAY, time, u)


velocity = xarray.apply_ufunc(behind, table["record free surface.velocity"], input_core_dims=[["time"]], vectorize=True)
fig, axes = plt.subplots(1, 2, figsize=(7.4, 3.3), layout="constrained", sharey=True)
for ax, speed in zip(axes, SPEEDS):
    of_speed = velocity.sel({"region.flyer.velocity": 1000.0 * speed})
    for k, (strength, words, near) in enumerate(((0.0, "no strength", (11.7, 1.03)), (0.276e9, "yield stress 0.276 GPa", (5.2, 0.82)))):
        u = of_speed.sel({"material.al.strength.yield_stress": strength}) / (1000.0 * speed)
        ax.plot(table["thickness"], u, "o-", color=COLOURS[k], markersize=3.5)
        ax.text(*near, words, color=COLOURS[k], ha="right", va="bottom", fontsize=8)
        ax.axvline(caught(speed, strength > 0.0, DELAY), color=COLOURS[k], linewidth=0.8, linestyle=":")
    ax.axhline(1.0, color=QUIET, linewidth=0.6)
    ax.set_title(f"flyer {speed} km/s", loc="left")
    ax.set_xlabel("target thickness / flyer thickness")
axes[0].set_ylabel("free-surface velocity / flyer velocity")
axes[0].set_ylim(0.6, 1.1)

for speed in SPEEDS:
    thick = velocity.sel({"region.flyer.velocity": 1000.0 * speed, "thickness": 13.0}) / (1000.0 * speed)
    soft, hard = (float(thick.sel({"material.al.strength.yield_stress": strength})) for strength in (0.0, 0.276e9))
    print(f"{speed} km/s: the release catches the shock at {caught(speed, False):.2f} flyers, an elastic one at {caught(speed, True):.2f}")
    print(f"{speed} km/s, target 13 flyers thick: {soft:.3f} without strength, {hard:.3f} with")
assert np.isfinite(velocity).all()
