"""
Elastic precursor
=================

Aluminium hits aluminium at 800 m/s. In each plate an elastic wave runs ahead of the plastic shock. Two gauges, 2 and 6 mm from
the impact face, show how the two waves separate as they travel. The exact solution (dashed) is that of an elastic-perfectly
plastic body driven by a piston at half the impact velocity. The simulation reproduces the exact stresses, 0.636 GPa behind
the elastic wave and 6.636 GPa behind the shock, within 0.02 %.
"""

import tempfile
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import hugoniot
from hugoniot.plotting.style import COLOURS, INK, RC
from hugoniot.theory.exact.elastic_plastic_piston import aluminium_piston

plt.rcParams.update(RC)
run = hugoniot.run("precursor.toml", Path(tempfile.mkdtemp()) / "precursor.run", report=False)
exact = aluminium_piston()
numbers = exact.numbers

fig, ax = plt.subplots(figsize=(6.4, 3.8), layout="constrained")
for k, (gauge, place) in enumerate((("2 mm", 2e-3), ("6 mm", 6e-3))):
    time, stress = run.gauge("stress", gauge)
    ax.plot(time * 1e6, stress / 1e9, color=COLOURS[k])
    # the gauge moves with the material: the elastic wave has set it in motion before the plastic shock reaches it
    first = place / numbers["elastic_wave_speed"]
    second = (place - numbers["elastic_velocity"] * first) / (numbers["plastic_wave_speed"] - numbers["elastic_velocity"])
    t = np.array([0, first, first, second, second, 1.5e-6]) * 1e6
    ax.plot(t, np.repeat([0.0, numbers["elastic_stress"], numbers["plastic_stress"]], 2) / 1e9, color=INK, lw=0.8, ls=(0, (4, 3)))
    ax.text(second * 1e6 + 0.02, 3.2 + 0.4 * k, f"gauge at {gauge}", color=COLOURS[k], fontsize=8.5)
label = f"exact: {numbers['plastic_stress'] / 1e9:.3f} GPa, {numbers['plastic_velocity']:.0f} m/s"
ax.text(1.49, numbers["plastic_stress"] / 1e9 + 0.1, label, ha="right", fontsize=8.5)
ax.text(0.42, numbers["elastic_stress"] / 1e9 + 0.1, f"exact HEL: {numbers['elastic_stress'] / 1e9:.3f} GPa", fontsize=8.5)
ax.set(xlabel="time (µs)", ylabel="longitudinal stress (GPa)", xlim=(0, 1.5), ylim=(-0.2, 7.4))

# %%
# Mean stresses at the 6 mm gauge: between the two waves, and behind the shock.
time, stress = run.gauge("stress", "6 mm")
between = stress[(time > 0.945e-6) & (time < 0.99e-6)].mean()
behind = stress[(time > 1.15e-6) & (time < 1.4e-6)].mean()
print(f"elastic limit {between / 1e9:.4f} GPa (exact {numbers['elastic_stress'] / 1e9:.4f})")
print(f"behind        {behind / 1e9:.4f} GPa (exact {numbers['plastic_stress'] / 1e9:.4f})")
plt.show()
