"""
Noh's problem in three geometries
=================================

A severe test of the treatment of shocks. Cold gas with gamma = 5/3 runs at 1 m/s into a wall, an axis or a centre, and a shock
of infinite strength moves outward from it. Behind this shock the exact density is 4, 16 or 64 kg/m³; the simulation gives 4.00,
15.84 and 62.31 kg/m³ on average between 0.08 and 0.15 m. The dip at the centre is wall heating, a known error of codes that
spread shocks over several zones. In planar flow the artificial heat flux, which is on by default, keeps it small.
"""

import tempfile
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import hugoniot
from hugoniot.plotting.style import COLOURS, INK, RC
from hugoniot.theory.exact.noh import noh

plt.rcParams.update(RC)
runs = Path(tempfile.mkdtemp())
fig, axes = plt.subplots(1, 3, figsize=(7.2, 2.9), layout="constrained", sharex=True)
for ax, geometry, colour in zip(axes, ("planar", "cylindrical", "spherical"), COLOURS):
    wall = {"left": "fixed", "right": "free"}
    run = hugoniot.run("noh.toml", runs / f"{geometry}.run", report=False, geometry=geometry, boundary=wall)
    rows = run.arrays("snapshots")
    r = 0.5 * (rows["position_left"][-1] + rows["position_right"][-1])
    rho = rows["density"][-1]
    x = np.linspace(1e-4, 0.4, 1000)
    ax.plot(x, noh(geometry)(x, 0.6)["density"], color=INK, lw=0.8)
    ax.plot(r, rho, ".", ms=3, color=colour)
    inside = (r > 0.08) & (r < 0.15)
    plateau = np.average(rho[inside], weights=(rows["position_right"] - rows["position_left"])[-1][inside])
    ax.set_title(f"{geometry}\nmean density {plateau:.2f}", loc="left", color=colour)
    ax.set(xlim=(0, 0.4), ylim=(0, None))
    ax.set_xlabel("radius (m)" if geometry != "planar" else "distance from the wall (m)")
axes[0].set_ylabel("density (kg/m³)")
axes[0].annotate("exact", (0.1, 4.0), xytext=(0.04, 2.6), fontsize=8.5, arrowprops={"arrowstyle": "-", "lw": 0.6})
plt.show()
