"""
Collapsing shell stopped by its strength
========================================

A cylindrical shell of beryllium moves inwards; its inner surface starts at a radius of 8 cm at 417.1 m/s. Only the yield
stress of 330 MPa slows the shell down. In the exact solution (Howell and Ball), that of a rigid-plastic incompressible shell,
all kinetic energy has become plastic work when the inner radius has fallen to 5 cm. The simulation, which includes elasticity
and compression, stops at 4.99 cm. The problem tests plastic flow and energy conservation in converging geometry.
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
ax.text(60, 8.75, "circles: exact solution, lines: simulation", fontsize=8.5)
stop = exact.numbers["stop_time"] * 1e6
ax.annotate(f"exact: stops at {exact.numbers['stop_radius'] * 100:.3f} cm, {stop:.1f} µs", (stop, 5.0), xytext=(10, 4.95), fontsize=8.5,
            arrowprops={"arrowstyle": "-", "lw": 0.6, "shrinkB": 0})
ax.set(xlabel="time (µs)", ylabel="radius (cm)", xlim=(0, 150), ylim=(4.6, 10.2))

# %%
# The energy budget, per metre of length and radian: kinetic energy becomes plastic work. The elastic energy stays small.
ax = run.plot.budget()
inner = run.gauge("position", "inner surface")[1].min()
print(f"inner radius {inner * 100:.3f} cm, exact {exact.numbers['stop_radius'] * 100:.3f} cm")
plt.show()
