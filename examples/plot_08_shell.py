"""
Collapsing shell that stops
===========================

A cylindrical shell of beryllium moves inwards at 417.1 m/s. Nothing but its yield stress of 330 MPa slows it down, and all
kinetic energy has become plastic work when the inner radius has fallen from 8 to 5 cm (Howell and Ball). The exact
history is that of a rigid-plastic shell.
"""

import tempfile
from pathlib import Path

import matplotlib.pyplot as plt

import hugoniot
from hugoniot.plotting.style import COLOURS, INK, RC
from hugoniot.theory.exact.shell_stopping import howell_ball

plt.rcParams.update(RC)
run = hugoniot.run("shell.toml", Path(tempfile.mkdtemp()) / "shell.run", report=False)
exact = howell_ball()

fig, ax = plt.subplots(figsize=(6.4, 3.4), layout="constrained")
for k, surface in enumerate(("inner surface", "outer surface")):
    time, radius = run.gauge("position", surface)
    ax.plot(time * 1e6, radius * 100, color=COLOURS[k])
    ax.text(151, radius[-1] * 100, surface, color=COLOURS[k], va="center", fontsize=8.5)
    few = time[:: len(time) // 25]
    ax.plot(few * 1e6, [exact.jumps(t)[k] * 100 for t in few], "o", ms=3.5, mfc="none", color=INK, mew=0.7)
stop = exact.numbers["stop_time"] * 1e6
ax.annotate(f"exact: stops at {exact.numbers['stop_radius'] * 100:.3f} cm, {stop:.1f} µs", (stop, 5.0), xytext=(10, 4.95), fontsize=8.5,
            arrowprops={"arrowstyle": "-", "lw": 0.6, "shrinkB": 0})
ax.set(xlabel="time (µs)", ylabel="radius (cm)", xlim=(0, 150), ylim=(4.6, 10.2))

# %%
# Where the energy goes: kinetic energy becomes plastic work; the elastic energy oscillates a little.
ax = run.plot.budget()
inner = run.gauge("position", "inner surface")[1].min()
print(f"inner radius {inner * 100:.3f} cm, exact {exact.numbers['stop_radius'] * 100:.3f} cm")
plt.show()
