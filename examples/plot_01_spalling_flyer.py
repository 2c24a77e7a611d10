"""
Spalling flyer plate
====================

A 2 mm plate of aluminium hits one of 4 mm at 700 m/s. The two releases meet inside the target and pull it apart:
the tension (blue) is limited by the spall strength, a void opens, and the free surface, as a VISAR would record it, pulls
back and rings.
"""

import tempfile
from pathlib import Path

import matplotlib.pyplot as plt

import hugoniot
from hugoniot.output.spall_reading import spall_reading
from hugoniot.plotting.style import RC

plt.rcParams.update(RC)
run = hugoniot.run("flyer.toml", Path(tempfile.mkdtemp()) / "flyer.run", report=False)

# %%
# The wave diagram. Shocks and the elastic waves ahead of them run up and outwards from the impact; the white region is the void.
run.plot.xt("stress")

# %%
# The free-surface velocity: the elastic step at 76 m/s, the plateau near the impact velocity, the pull-back.
ax = run.plot.free_surface()
ax.annotate("elastic step", (0.66, 76), xytext=(0.3, 180), arrowprops={"arrowstyle": "-", "lw": 0.7}, fontsize=8.5)

# %%
# The spall strength that an experiment would infer, beside the strength put into the deck (1.0 GPa) and the largest tension in any zone.
reading = spall_reading(run)
print(f"pull-back {reading.numbers['pull_back']:.1f} m/s")
print(f"spall strength, acoustic {reading.numbers['spall_strength_acoustic'] / 1e9:.3f} GPa: {reading.note}")
print(f"largest tension {run.arrays('peaks')['peak_tension'].max() / 1e9:.3f} GPa, voids {run.summary['voids_opened']}")
plt.show()
