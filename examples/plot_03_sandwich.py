"""
Impedance sandwich: PMMA rings up between copper plates
=======================================================

A copper flyer at 555 m/s hits 1 mm of PMMA backed by copper. Each time the wave crosses the PMMA, the stress in it rises by a
step, towards the stress of copper on copper. Impedance matching gives the steps without a mesh, and the simulation reproduces
the first two within 0.1 %. The problem is that of figure 4.2.3 in Jordan (2011).
"""

import tempfile
from pathlib import Path

import matplotlib.pyplot as plt

import hugoniot
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.plotting.style import COLOURS, QUIET, RC
from hugoniot.theory.impedance import match, ring_up

plt.rcParams.update(RC)
run = hugoniot.run("sandwich.toml", Path(tempfile.mkdtemp()) / "sandwich.run", report=False)

# %%
# The figure shows the stress in the middle of the PMMA (blue) and the exact steps (dashed), each with its pressure and particle
# velocity. The exact steps use the same constants as the run. The particle velocity alternates, because every second wave comes
# from the back.
copper, pmma = MieGruneisen(8930.0, 3940.0, 1.489, 1.99), MieGruneisen(1186.0, 2598.0, 1.516, 0.97)
steps = ring_up([copper, pmma, copper], 555.0, bounces=4)
final = match([copper, copper], 555.0)[0]

fig, ax = plt.subplots(figsize=(6.4, 4.0), layout="constrained")
for step in steps:
    p = step.pressure / 1e9
    ax.axhline(p, color=QUIET, lw=0.7, ls=(0, (4, 3)))
    ax.text(3.02, p + 0.12, f"{p:.3f} GPa, {step.particle_velocity:.1f} m/s", fontsize=8, va="center", color=QUIET)
ax.axhline(final.pressure / 1e9, color=COLOURS[1], lw=0.9)
ax.text(0.02, final.pressure / 1e9 + 0.12, f"limit: copper on copper, {final.pressure / 1e9:.2f} GPa", color=COLOURS[1], fontsize=8.5)
time, stress = run.gauge("stress", "pmma middle")
ax.plot(time * 1e6, stress / 1e9, color=COLOURS[0])
ax.text(0.99, 8.2, "simulation, middle of the PMMA", color=COLOURS[0], fontsize=8.5, ha="left")
ax.set(xlabel="time (µs)", ylabel="stress (GPa)", xlim=(0, 3), ylim=(0, 11.8))

# %%
# Mean stress and particle velocity over the plateaus of the simulation, beside the exact values.
for label, gauge, start, end, exact in (("first", "pmma middle", 0.22, 0.32, steps[0]), ("reshock", "pmma back", 0.40, 0.52, steps[1])):
    here = [run.gauge(field, gauge) for field in ("stress", "velocity")]
    mean = [values[(t > start * 1e-6) & (t < end * 1e-6)].mean() for t, values in here]
    print(f"{label:8} {mean[0] / 1e9:.3f} GPa {mean[1]:.1f} m/s   exact {exact.pressure / 1e9:.3f} GPa {exact.particle_velocity:.1f} m/s")
print(f"end      {stress[time > 2.9e-6].mean() / 1e9:.2f} GPa              exact {final.pressure / 1e9:.2f} GPa")
plt.show()
