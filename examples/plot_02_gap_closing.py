"""
Three plates and two gaps
=========================

A flyer crosses a gap of 0.5 mm and hits a plate, which flies on and hits a third. A gap closes exactly on a time step.
The kinetic energy lost where two bodies join becomes heat in the two zones that meet, so the total energy is conserved
to round-off.
"""

import tempfile
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import hugoniot
from hugoniot.plotting.style import COLOURS, FAINT, RC

plt.rcParams.update(RC)
run = hugoniot.run("gap.toml", Path(tempfile.mkdtemp()) / "gap.run", report=False)

# %%
# Paths of the waves and of the plates.
run.plot.xt("stress")

# %%
# Mean velocity of every plate. In a lossless chain of equal plates each would pass on its whole velocity; strength and
# the waves that remain inside hold a little of it back.
rows = run.arrays("budget")
mass = [float(run.arrays("snapshots")["mass"][run.arrays("snapshots")["region"] == name].sum()) for name in rows["region"]]
fig, ax = plt.subplots(figsize=(6.4, 3.4), layout="constrained")
events = run.arrays("events")
for time, kind in zip(events["time"], events["kind"]):
    if kind == "void_closed":
        ax.axvline(time * 1e6, color=FAINT, lw=1)
        ax.text(time * 1e6 + 0.04, 505, f"meet at {time * 1e6:.3f} µs", fontsize=8.5, va="bottom")
for k, name in enumerate(rows["region"]):
    speed = rows["momentum"][:, k] / mass[k]
    ax.plot(rows["time"] * 1e6, speed, color=COLOURS[k])
    ax.text(5.03, speed[-1], name, color=COLOURS[k], va="center", fontsize=8.5)
ax.set(xlabel="time (µs)", ylabel="mean velocity (m/s)", xlim=(0, 5), ylim=(-25, 540))

# %%
# Conservation: largest relative errors of the totals over the run.
print(f"largest energy error {np.abs(rows['energy_error']).max():.1e}, momentum {np.abs(rows['momentum_error']).max():.1e}")
plt.show()
