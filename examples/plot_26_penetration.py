"""
Penetration by an eroding rod
=============================

A steel rod 10 mm in diameter and 60 mm long strikes a steel block at 2.5 km/s. Rod and target flow at the bottom of the crater,
where the mesh would tangle. ``[solver.erosion]`` therefore removes zones whose plastic strain reaches 1.5, and contact continues
on the new surfaces. The crater deepens at about 1220 m/s. For fluids of equal density the rate is half the impact speed, 1250 m/s;
the strength of the steel makes it a little slower.
"""

import tempfile
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import hugoniot
from hugoniot.plotting.style import RC

plt.rcParams.update(RC)
run = hugoniot.run("rod.toml", Path(tempfile.mkdtemp()) / "rod.run", report=False)

# %%
# Plastic strain when about half of the rod has eroded, and at the end.
fig, sides = plt.subplots(1, 2, figsize=(7.6, 4.6), sharey=True, layout="constrained")
for ax, time in zip(sides, ("24 us", "44 us")):
    run.plot.map("plastic_strain", time=time, ax=ax, window=(-0.03, 0.03), limits=(0.0, 1.5), colorbar=ax is sides[-1])

# %%
# The depth of the crater is that of the highest target zone left on the axis. Its rate of change is fitted from 9 µs on, for
# depths up to 50 mm.
rows, blocks = run.arrays("snapshots"), run.arrays("mesh")
corners = blocks["zone_nodes"][:64]      # the column of the target on the axis
top = rows["position_y"][:, corners].max(axis=2)
depth = -np.nanmax(np.where(rows["eroded"][:, :64] == 0.0, top, np.nan), axis=1)
late = (rows["time"] > 9e-6) & (depth < 0.05)
velocity = np.polyfit(rows["time"][late], depth[late], 1)[0]
print(f"penetration {velocity:.0f} m/s, half the impact speed 1250 m/s")
print(f"{run.summary['zones_eroded']} zones removed; relative energy error, their energy included: {abs(run.summary['energy_error']):.1e}")
plt.show()
