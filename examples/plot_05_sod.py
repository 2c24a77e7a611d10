"""
Sod's shock tube
================

The standard test of a shock-capturing code. A gas with gamma = 1.4, density 1 kg/m³ and pressure 1 Pa expands into the same gas
at 0.125 kg/m³ and 0.1 Pa. The figure compares the simulation on 200 zones (dots) at t = 0.2 s with the exact solution (line):
from left to right a rarefaction, a contact and a shock. The shock is spread over a few zones, and small overshoots remain at
the tail of the rarefaction and, in the energy, at the contact. The number above each panel is the mean absolute error.
"""

import tempfile
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import hugoniot
from hugoniot.plotting.style import COLOURS, INK, RC
from hugoniot.theory.exact.riemann_ideal import sod

plt.rcParams.update(RC)
run = hugoniot.run("sod.toml", Path(tempfile.mkdtemp()) / "sod.run", report=False)
exact = sod()
rows = run.arrays("snapshots")
left, right = rows["position_left"][-1], rows["position_right"][-1]
centre, width = 0.5 * (left + right), right - left
found = {name: rows[name][-1] for name in ("density", "pressure", "energy")}
found["velocity"] = 0.5 * (rows["velocity_left"][-1] + rows["velocity_right"][-1])

x = np.linspace(0, 1, 2001)
line, at_zones = exact(x, 0.2), exact(centre, 0.2)
fig, axes = plt.subplots(2, 2, figsize=(6.8, 4.8), layout="constrained", sharex=True)
labels = {"density": "density (kg/m³)", "pressure": "pressure (Pa)", "velocity": "velocity (m/s)", "energy": "specific energy (J/kg)"}
for ax, (name, label) in zip(axes.flat, labels.items()):
    ax.plot(x, line[name], color=INK, lw=0.8)
    ax.plot(centre, found[name], ".", color=COLOURS[0], ms=3)
    error = np.sum(np.abs(found[name] - at_zones[name]) * width) / np.sum(width)
    ax.set_title(f"mean error {error:.1e}", loc="right", fontsize=8.5, color=COLOURS[0])
    ax.set_ylabel(label)
for ax in axes[1]:
    ax.set_xlabel("position (m)")
axes[0, 0].annotate("exact", (0.31, exact(np.array([0.31]), 0.2)["density"][0]), xytext=(0.45, 0.85), fontsize=8.5,
                    arrowprops={"arrowstyle": "-", "lw": 0.6})
axes[0, 0].annotate("200 zones", (0.6, 0.426), xytext=(0.62, 0.62), fontsize=8.5, color=COLOURS[0],
                    arrowprops={"arrowstyle": "-", "lw": 0.6, "color": COLOURS[0]})
plt.show()
