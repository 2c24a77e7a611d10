"""
Attenuation of a shock driven by a thin flyer
=============================================

The release from the back of a flyer plate overtakes the shock that the flyer drives, so the free surface of a thick target is
slower than that of a thin one. A sweep over target thickness, flyer speed and yield stress gives the curves of figures 3 and 4
of Herrmann (WL-TR-64-107) for aluminium; the measurements are only plotted there, not tabulated, and are not shown here. With a
flyer at 1.2 km/s the free surface of a target 13 flyers thick moves, 0.12 µs after the shock has arrived, at 0.95 of the flyer
velocity without strength, but at only 0.77 of it with a yield stress of 0.276 GPa, because an elastic release is faster. In
theory the release catches the shock in a target (c+U)/(c-U) flyers thick, with the Lagrangian speeds U of the shock and c of the
release.
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
    """Target thickness (in flyers) beyond which the release follows the shock by less than `delay` (s)."""
    state, law = shock(aluminum.eos, particle_velocity=500.0 * speed), aluminum.eos
    shear = aluminum.strength.shear_modulus if elastic else 0.0
    release = np.sqrt(state.sound_speed**2 + 4.0 * shear / (3.0 * state.density)) * state.density / law.rho0
    fast, slow = 1.0 / release, 1.0 / state.shock_velocity
    return float((slow + fast - delay / 2e-3) / (slow - fast))      # the flyer is 2 mm thick


# %%
# The free-surface velocity 0.12 µs after the arrival of the main wave. It falls below the flyer velocity in targets so thick that
# the release arrives within those 0.12 µs; the dotted lines show this thickness as calculated from the sound and shock speeds.
DELAY, time = 0.12e-6, table["time"].values


def behind(u):      # half of the peak is reached in the main wave, not in the elastic precursor
    return np.interp(first_crossing(time, u, 0.5 * u.max()) + DELAY, time, u)


velocity = xarray.apply_ufunc(behind, table["record free surface.velocity"], input_core_dims=[["time"]], vectorize=True)
fig, axes = plt.subplots(1, 2, figsize=(7.4, 3.3), layout="constrained", sharey=True)
for ax, speed in zip(axes, SPEEDS):
    of_speed = velocity.sel({"region.flyer.velocity": 1000.0 * speed})
    for k, (strength, label, near) in enumerate(((0.0, "no strength", (11.7, 1.03)), (0.276e9, "yield stress\n0.276 GPa", (5.0, 0.82)))):
        u = of_speed.sel({"material.al.strength.yield_stress": strength}) / (1000.0 * speed)
        ax.plot(table["thickness"], u, "o-", color=COLOURS[k], markersize=3.5)
        ax.text(*near, label, color=COLOURS[k], ha="right", va="bottom", fontsize=8)
        ax.axvline(caught(speed, strength > 0.0, DELAY), color=COLOURS[k], linewidth=0.8, linestyle=":")
    ax.axhline(1.0, color=QUIET, linewidth=0.6)
    ax.set_title(f"flyer at {speed} km/s", loc="left")
    ax.set_xlabel("target thickness / flyer thickness")
axes[0].set_ylabel("free-surface velocity / flyer velocity")
axes[0].set_ylim(0.6, 1.1)

for speed in SPEEDS:
    thick = velocity.sel({"region.flyer.velocity": 1000.0 * speed, "thickness": 13.0}) / (1000.0 * speed)
    soft, hard = (float(thick.sel({"material.al.strength.yield_stress": strength})) for strength in (0.0, 0.276e9))
    print(f"{speed} km/s: the release catches the shock at {caught(speed, False):.2f} flyers, an elastic one at {caught(speed, True):.2f}")
    print(f"{speed} km/s, target 13 flyers thick: {soft:.3f} without strength, {hard:.3f} with")
assert np.isfinite(velocity).all()
