"""
Three plates and two gaps
=========================

A flyer at 500 m/s crosses a gap of 0.5 mm and hits a plate of the same thickness, which flies on, crosses a second gap and hits
a third plate twice as thick. The example shows how the solver handles bodies that collide and separate. The time step is
adjusted so that a gap closes exactly at the end of a step. The kinetic energy lost where two bodies join becomes heat in the
two zones that meet, so total energy is conserved to round-off (relative error 5e-16).
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
# The wave diagram: longitudinal stress against position and time, with the paths of the plates.
run.plot.xt("stress")

# %%
# The mean velocity of each plate. Without losses the flyer would pass its whole velocity on to the second plate, which has the
# same mass. Because of strength and of waves that remain inside the plates, the second plate reaches only 468 m/s and the flyer
# keeps 32 m/s. The third plate is twice as heavy and reaches about half of the velocity of the second.
rows = run.arrays("budget")
mass = [float(run.arrays("snapshots")["mass"][run.arrays("snapshots")["region"] == name].sum()) for name in rows["region"]]
fig, ax = plt.subplots(figsize=(6.4, 3.4), layout="constrained")
events = run.arrays("events")
for time, kind in zip(events["time"], events["kind"]):
    if kind == "void_closed":
        ax.axvline(time * 1e6, color=FAINT, lw=1)
        ax.text(time * 1e6 + 0.04, 505, f"impact at {time * 1e6:.3f} µs", fontsize=8.5, va="bottom")
for k, name in enumerate(rows["region"]):
    speed = rows["momentum"][:, k] / mass[k]
    ax.plot(rows["time"] * 1e6, speed, color=COLOURS[k])
    ax.text(5.03, speed[-1], name, color=COLOURS[k], va="center", fontsize=8.5)
ax.set(xlabel="time (µs)", ylabel="mean velocity (m/s)", xlim=(0, 5), ylim=(-25, 540))

# %%
# Conservation: largest relative errors of the totals over the run.
print(f"largest energy error {np.abs(rows['energy_error']).max():.1e}, momentum {np.abs(rows['momentum_error']).max():.1e}")
plt.show()
