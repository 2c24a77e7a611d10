"""
Overdriven detonation by a copper flyer
=======================================

A self-sustained detonation is in the Chapman-Jouguet (CJ) state, where the Rayleigh line touches the Hugoniot of the products.
A copper flyer at 4.5 km/s drives Composition B harder. The state behind the front is then the intersection of the Hugoniot of
copper with the strong branch of the product Hugoniot, above CJ: 50.5 GPa instead of 29.5 GPa, and the front runs at 8.48 km/s
instead of 7.98 km/s. The simulation reproduces both within 0.1 %.
"""

import tempfile
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from scipy.optimize import brentq

import hugoniot
from hugoniot.diagnostics.detonation import front_path, front_speed
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.materials import library
from hugoniot.plotting.style import COLOURS, QUIET, RC
from hugoniot.theory.chapman_jouguet import cj, overdriven
from hugoniot.theory.hugoniot import shock

plt.rcParams.update(RC)
products, copper = library.find("comp_b").eos, MieGruneisen(8930.0, 3940.0, 1.489, 1.99)
point = cj(products)
run = hugoniot.run("overdriven.toml", Path(tempfile.mkdtemp()) / "overdriven.run", report=False)

# %%
# The intersection, from the equations of state alone.
lowest = float(point.state.particle_velocity)
u = brentq(lambda u: float(overdriven(products, particle_velocity=u).pressure - shock(copper, particle_velocity=4500.0 - u).pressure),
           1.001 * lowest, 4490.0)
theory = overdriven(products, particle_velocity=u)

# %%
# Left: pressure against particle velocity; the circle is the mean state in the simulation from 0.5 to 2.5 mm behind the front, 2
# µs after the impact. Right: the pressure in the simulation at that time, with the front at 17 mm. The release from the back of
# the flyer follows the front but has not caught up with it.
snapshots = run.arrays("snapshots")
row = int(np.argmin(np.abs(snapshots["time"] - 2e-6)))
path = front_path(snapshots["burn_fraction"], snapshots["position_left"], snapshots["position_right"])
where = 0.5e3 * (snapshots["position_left"] + snapshots["position_right"])[row]
velocity = 0.5 * (snapshots["velocity_left"] + snapshots["velocity_right"])[row]
inside = np.abs(where - 1e3 * path[row] + 1.5) < 1.0
speed = np.linspace(1.0005 * lowest, 4400.0, 60)
fig, (left, right) = plt.subplots(1, 2, figsize=(8.6, 3.8), layout="constrained")
left.plot(speed / 1e3, [float(overdriven(products, particle_velocity=v).pressure) / 1e9 for v in speed], color=COLOURS[0])
left.text(2.75, 50.0, "products,\nstrong branch", color=COLOURS[0], fontsize=8.5, ha="right")
flyer = np.linspace(2000.0, 4400.0, 60)
left.plot(flyer / 1e3, [float(shock(copper, particle_velocity=4500.0 - v).pressure) / 1e9 for v in flyer], color=COLOURS[1])
left.text(2.8, 103.0, "copper at 4.5 km/s", color=COLOURS[1], fontsize=8.5)
left.plot(velocity[inside].mean() / 1e3, snapshots["pressure"][row][inside].mean() / 1e9, "o", mfc="none", mec="black", ms=9)
left.text(3.58, 50.0, "simulation", fontsize=8.5, va="center")
left.plot(lowest / 1e3, float(point.state.pressure) / 1e9, "o", color=COLOURS[2])
left.text(lowest / 1e3, 23.0, "CJ", color=COLOURS[2], fontsize=8.5, ha="center", va="top")
left.set(xlabel="particle velocity (km/s)", ylabel="pressure (GPa)", xlim=(1.8, 4.5), ylim=(0, 120))
right.plot(where, snapshots["pressure"][row] / 1e9, color=COLOURS[0])
for p, label in ((theory.pressure, "overdriven, theory"), (point.state.pressure, "Chapman-Jouguet")):
    right.axhline(float(p) / 1e9, color=QUIET, lw=0.8, ls=(0, (4, 3)))
    right.text(44, float(p) / 1e9 + 0.8, label, fontsize=8.5, ha="right")
right.set(xlabel="position (mm)", ylabel="pressure (GPa)", xlim=(0, 45), ylim=(0, 60))

# %%
# Speed of the front and pressure behind it: simulation, theory and CJ state.
print(f"front    {front_speed(snapshots['time'], path, 0.005, 0.038):.0f} m/s   theory {float(theory.shock_velocity):.0f}   "
      f"CJ {point.detonation_velocity:.0f}")
print(f"pressure {snapshots['pressure'][row][inside].mean() / 1e9:.2f} GPa   theory {float(theory.pressure) / 1e9:.2f}   "
      f"CJ {float(point.state.pressure) / 1e9:.2f}")
plt.show()
