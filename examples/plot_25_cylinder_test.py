"""
Cylinder test of Composition B
==============================

A charge 25.4 mm in diameter fills a copper tube and is lit at one end; a streak camera looks through a slit at one section of
the tube. It records the point where its line of sight meets the wall. Because the wall is inclined and moves along the line of
sight as well as across it, this point moves about 2 % faster than the metal itself. A gauge with a fixed line of sight gives
the speed to compare with the record: 1411 m/s after 6 mm of travel and 1606 m/s after 19 mm, 1.8 % above and 1.6 % below the
experiment.
"""

import tempfile
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import hugoniot
from hugoniot.plotting.style import COLOURS, INK, QUIET, RC

plt.rcParams.update(RC)
run = hugoniot.run("cylinder-test.toml", Path(tempfile.mkdtemp()) / "cylinder.run", report=False, stop_time="28.5 us")
time, place = run.gauge("line_position", "streak at 100 mm")
_, streak = run.gauge("line_velocity", "streak at 100 mm")
travel = (place - place[0]) * 1e3
rows = run.arrays("snapshots")
node = np.hypot(rows["position_x"][0] - 15.306e-3, rows["position_y"][0] - 0.1).argmin()      # the metal seen through the slit at t = 0
moved, metal = (rows["position_x"][:, node] - 15.306e-3) * 1e3, rows["velocity_x"][:, node]

# %%
# The pressure while the detonation runs up the charge, mirrored about the axis. The dashed line is the line of sight of the
# camera.
fig, ax = plt.subplots(figsize=(4.6, 6.0), layout="constrained")
run.plot.map("pressure", time="20 us", limits=(-2e9, 20e9), mesh=False, ax=ax)
ax.axhline(100.0, color=QUIET, lw=0.8, ls=(0, (4, 3)))
ax.text(36.0, 102.0, "slit", fontsize=8.5, color=QUIET)
ax.set_xlim(-50, 50)

# %%
# Speed against travel of the wall: the slit record (line) and the radial velocity of the metal at the surface (small dots). The
# speed oscillates because waves run to and fro in the wall, so the printed speeds are means over one period, 1.4 mm of travel.
# The two large dots are the measured speeds, which correspond to 0.960 and 1.330 kJ per gram of copper.
fig, ax = plt.subplots(figsize=(7.2, 3.2), layout="constrained")
ax.plot(travel, streak, color=COLOURS[0], lw=1.0)
ax.plot(moved, metal, ".", color=COLOURS[1], ms=4)
for mm, measured in ((6.0, 1386.0), (19.0, 1631.0)):
    ax.plot(mm, measured, "o", color=INK, ms=5)
    begin, end = np.interp([mm - 0.7, mm + 0.7], travel, time)
    mean = 1.4e-3 / (end - begin)
    print(f"after {mm:.0f} mm: {mean:.0f} m/s, {100.0 * (mean / measured - 1.0):+.1f} % from the experiment")
ax.text(7.4, 1520.0, "slit record, simulated", color=COLOURS[0], fontsize=8.5, ha="right")
ax.text(12.0, 1430.0, "radial velocity of the metal", color=COLOURS[1], fontsize=8.5)
ax.text(19.0, 1650.0, "experiment", color=INK, fontsize=8.5, ha="center")
ax.set(xlim=(0, 21), ylim=(900, 1700), xlabel="travel of the wall (mm)", ylabel="velocity (m/s)")
plt.show()
