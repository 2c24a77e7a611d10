"""
Open sandwich: a plate driven by an explosive, and Gurney's formula
===================================================================

A layer of Composition B, free at its back, drives a copper plate. Gurney's formula (1943) gives the final speed of the plate
from the ratio of plate mass to charge mass, M/C, and one constant of the explosive, the Gurney velocity √(2E); it assumes a
linear velocity profile in the gas. The simulated speeds are 1 to 3 % higher than the formula gives with √(2E) = 2.735 km/s, for
plates from a fifth to five times the mass of the charge. Speeds are compared when the plate is seven charge lengths
from the initial back of the charge; for the two heaviest plates, which do not get that far, at the end of the run.
"""

import tempfile
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import hugoniot
from hugoniot.diagnostics.detonation import body_history
from hugoniot.plotting.style import COLOURS, QUIET, RC
from hugoniot.theory.exact.plate_push import gurney

plt.rcParams.update(RC)
folder = Path(tempfile.mkdtemp())
deck = Path("gurney.toml").read_text()
RATIOS = (0.2, 0.5, 1.0, 2.0, 5.0)


def plate(ratio):
    """For M/C = ratio: the history of the plate, and its speed seven charge lengths from the back of the charge (else at the end)."""
    end = 0.02 + ratio * 0.02 * 1717.0 / 8930.0
    path = folder / f"{ratio}.toml"
    path.write_text(deck.replace('"2.38454 cm"', f'"{end * 100} cm"').replace("zones = 40", f"zones = {max(8, round(40 * ratio))}"))
    run = hugoniot.run(path, folder / f"{ratio}.run", report=False)
    snapshots = run.arrays("snapshots")
    history = body_history(run.arrays("budget"), snapshots, "plate")
    away = snapshots["position_left"][:, 200] > 0.14
    when = snapshots["time"][np.argmax(away)] if away.any() else snapshots["time"][-1]
    return history, float(np.interp(when, history["time"], history["velocity"]))


found = {ratio: plate(ratio) for ratio in RATIOS}

# %%
# Left: velocity of the plates. They gain most of it within the first 10 µs, and the rest while the gas expands. Right: the speeds
# (dots) and Gurney's formula for √(2E) from 2.70 to 2.77 km/s, the handbook values for Composition B (grey band).
fig, (left, right) = plt.subplots(1, 2, figsize=(8.6, 3.8), layout="constrained")
for colour, (ratio, (history, _)) in zip(COLOURS, found.items()):
    left.plot(history["time"] * 1e6, history["velocity"] / 1e3, color=colour)
    left.text(101, history["velocity"][-1] / 1e3, f"M/C = {ratio:g}", color=colour, va="center", fontsize=8.5)
left.set(xlabel="time (µs)", ylabel="plate velocity (km/s)", xlim=(0, 126), ylim=(0, None))
x = np.geomspace(0.15, 6.5, 100)
right.fill_between(x, [gurney("open", r, 2.70) for r in x], [gurney("open", r, 2.77) for r in x], color=QUIET, alpha=0.35, lw=0)
right.text(0.75, 1.9, "Gurney, √(2E) = 2.70\nto 2.77 km/s", fontsize=8.5)
for colour, (ratio, (_, velocity)) in zip(COLOURS, found.items()):
    right.plot(ratio, velocity / 1e3, "o", color=colour)
right.set(xlabel="plate mass / charge mass, M/C", ylabel="plate velocity (km/s)", xscale="log", ylim=(0, None))
right.set_xticks(RATIOS, [f"{r:g}" for r in RATIOS], minor=False)
right.minorticks_off()

# %%
# For each plate: its simulated speed, the speed from Gurney's formula, the √(2E) that the simulated speed implies, and the
# kinetic energy of the plate at that speed.
for ratio, (history, velocity) in found.items():
    energy = 0.5 * history["mass"][-1] * velocity**2 / 1e6
    print(f"M/C {ratio:<4g} {velocity:6.0f} m/s   Gurney {gurney('open', ratio, 2735.0):6.0f}   "
          f"sqrt(2E) {velocity / gurney('open', ratio, 1.0):6.0f} m/s   plate energy {energy:.1f} MJ/m²")
plt.show()
