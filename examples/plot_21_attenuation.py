"""
Attenuation of a shock behind a thin flyer
==========================================

A flyer plate's release overtakes its own shock: the free surface of a thick target is slower than that of a thin one. One sweep over
target thickness, flyer speed and yield stress gives the curves that WL-TR-64-107 (Herrmann) compares with Curran's plates of aluminium.
"""

import tempfile

import matplotlib.pyplot as plt
import numpy as np
import xarray

import hugoniot
from hugoniot.plotting.style import COLOURS, QUIET, RC

plt.rcParams.update(RC)
SPEEDS, THICKNESSES = (1.2, 1.9), (1.5, 3, 5, 6.5, 8, 10, 13)

with tempfile.TemporaryDirectory() as folder:
    table = hugoniot.sweep(
        "flyer.toml", {"thickness": list(THICKNESSES), "region.flyer.velocity": [f"{u} km/s" for u in SPEEDS],
                       "material.al.strength.yield_stress": ["0 GPa", "0.276 GPa"], "region.flyer.zones": 30, "stop_time": "5.2 us",
                       "output.snapshots": "5.2 us"},
        tie=["region.target.to = region.flyer.to * (1 + thickness)", "region.target.zones = round(region.flyer.zones * thickness)"],
        out=folder, output=["free surface.arrival"], record=["free surface.velocity"], report=False).squeeze()

# %%
# The velocity 0.12 µs after the arrival. It begins at the flyer's own speed, as symmetric impact demands but for the release, which is not
# quite the mirror image of the shock. It falls once the release has caught up: sooner with a yield stress, for then the front of the
# release is elastic and runs at the longitudinal speed.
later = table["free surface.arrival"] + 0.12e-6      # behind the overshoot of the front, before the release that limits the plateau
record = table["record free surface.velocity"].transpose(..., "time")
velocity = xarray.apply_ufunc(lambda t, u: np.interp(t, table["time"], u), later, record, input_core_dims=[[], ["time"]], vectorize=True)
fig, axes = plt.subplots(1, 2, figsize=(7.4, 3.3), layout="constrained", sharey=True)
for ax, speed in zip(axes, SPEEDS):
    of_speed = velocity.sel({"region.flyer.velocity": 1000.0 * speed})
    for k, (strength, words, near) in enumerate(((0.0, "no strength", (12.8, 1.03)), (0.276e9, "yield stress 0.276 GPa", (7.6, 0.82)))):
        u = of_speed.sel({"material.al.strength.yield_stress": strength}) / (1000.0 * speed)
        ax.plot(table["thickness"], u, "o-", color=COLOURS[k], markersize=3.5)
        ax.text(*near, words, color=COLOURS[k], ha="right", va="bottom", fontsize=8)
    ax.axhline(1.0, color=QUIET, linewidth=0.6)
    ax.set_title(f"flyer {speed} km/s", loc="left")
    ax.set_xlabel("target thickness / flyer thickness")
axes[0].set_ylabel("free-surface velocity / flyer velocity")
axes[0].set_ylim(0.6, 1.1)

for speed in SPEEDS:
    thick = velocity.sel({"region.flyer.velocity": 1000.0 * speed, "thickness": 13.0}) / (1000.0 * speed)
    soft, hard = (float(thick.sel({"material.al.strength.yield_stress": strength})) for strength in (0.0, 0.276e9))
    print(f"{speed} km/s, target 13 flyers thick: {soft:.3f} without strength, {hard:.3f} with")
assert np.isfinite(velocity).all()
