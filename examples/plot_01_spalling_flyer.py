"""
Spalling flyer plate
====================

An aluminium plate 2 mm thick hits a 4 mm plate at 700 m/s. The releases from the two free surfaces meet inside the target and
pull it apart: where the tension reaches the spall strength, a void opens. The example shows the wave diagram, the free-surface
velocity that an interferometer would record, and how far the spall strength inferred from this record falls short of the true
one: the acoustic estimate is 0.395 GPa, the strength in the deck 1.0 GPa.
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
# The wave diagram: longitudinal stress against position and time; compression is red, tension is blue. From the impact at 2 mm an
# elastic wave and a plastic shock run into each plate. The target spalls at two planes; the voids there are white.
run.plot.xt("stress")

# %%
# The free-surface velocity: the step of the elastic precursor at 76 m/s, the plateau at 692 m/s, and the pull-back of 56 m/s.
# Then the spalled layer rings.
ax = run.plot.free_surface()
ax.annotate("elastic precursor", (0.66, 76), xytext=(0.3, 180), arrowprops={"arrowstyle": "-", "lw": 0.7}, fontsize=8.5)

# %%
# The spall strength that an experimenter would infer from the record, and the largest tension in any zone, which is limited to
# the strength in the deck (1.0 GPa).
reading = spall_reading(run)
print(f"pull-back {reading.numbers['pull_back']:.1f} m/s")
print(f"spall strength, acoustic {reading.numbers['spall_strength_acoustic'] / 1e9:.3f} GPa: {reading.note}")
print(f"largest tension {run.arrays('peaks')['peak_tension'].max() / 1e9:.3f} GPa, voids {run.summary['voids_opened']}")
plt.show()
