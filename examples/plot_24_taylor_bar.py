"""
Taylor test: a copper bar strikes a rigid wall
==============================================

A copper bar 32.4 mm long and 6.4 mm in diameter strikes a rigid wall at 227 m/s. The foot spreads, a plastic wave runs up the
bar and stops, and the final length is a measure of the strength. On the finest of four meshes the final length is 21.50 mm and
the radius of the foot 7.06 mm. On the two finest meshes, with six and eight zones across the radius of the bar, both results
lie within the range of published codes (grey bands).
"""

import tempfile
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import hugoniot
from hugoniot.plotting.style import COLOURS, QUIET, RC

plt.rcParams.update(RC)
runs, zones = Path(tempfile.mkdtemp()), (3, 4, 6, 8)
mesh = {n: {"block.bar.zones": [n, 10 * n], "output.snapshots": "20 us"} for n in zones}
found = {n: hugoniot.run("taylor-copper.toml", runs / f"{n}.run", report=False, **mesh[n]) for n in zones}
last = {n: run.arrays("snapshots") for n, run in found.items()}
length = {n: last[n]["position_y"][-1].max() * 1e3 for n in zones}
foot = {n: last[n]["position_x"][-1].max() * 1e3 for n in zones}

# %%
# Plastic strain in the bar at three times; the axisymmetric result is mirrored about its axis. At 20 µs the foot has spread, but
# the rear of the bar is still undeformed. At 80 µs the bar is at rest.
fig, axes = plt.subplots(1, 3, figsize=(7.2, 4.6), layout="constrained", sharey=True)
for ax, time in zip(axes, ("0 us", "20 us", "80 us")):
    found[8].plot.map("plastic_strain", time=time, limits=(0.0, 2.0), mesh=True, ax=ax, colorbar=False)
axes[1].set_ylabel("")
axes[2].set_ylabel("")
bar = fig.colorbar(axes[2].collections[0], ax=axes, shrink=0.7, pad=0.02, extend="max")
bar.set_label("equivalent plastic strain")
bar.outline.set_visible(False)

# %%
# Final length and foot radius against the width of a zone, for 3, 4, 6 and 8 zones across the radius.
fig, axes = plt.subplots(1, 2, figsize=(7.2, 2.8), layout="constrained")
for ax, values, band, label in zip(axes, (length, foot), ((21.42, 21.66), (6.97, 7.24)), ("length", "radius of the foot")):
    ax.axhspan(*band, color=QUIET, alpha=0.2, lw=0)
    ax.text(0.0, band[1], " published codes", va="top", fontsize=8.5, color=QUIET)
    ax.plot([3.2 / n for n in zones], list(values.values()), "o-", color=COLOURS[0])
    ax.set(xlim=(0, 1.2), xlabel="width of a zone (mm)", ylabel=f"{label} after 80 µs (mm)")
strain = float(last[8]["plastic_strain"][-1].max())
print(f"8 zones across the radius: length {length[8]:.2f} mm, foot {foot[8]:.2f} mm, largest plastic strain {strain:.2f}")
print("largest relative energy error:", np.max([run.summary["energy_error"] for run in found.values()]))
plt.show()
