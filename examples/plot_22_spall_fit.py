"""
Spall strength from a velocity record
=====================================

What flyer speed, yield stress and spall strength does a free-surface record imply, and how accurately? The record is synthetic,
so that the answer is known: it comes from a run, with 5 m/s of added noise and a delay of 8 ns. The fit estimates these three
quantities and the delay. The spall strength is found as 1.05 ± 0.04 GPa (true value 1.05 GPa) and the delay as 8.2 ± 0.2 ns; all
four values are within 2.2 standard deviations of the truth.
"""

import tempfile
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import hugoniot
from hugoniot.plotting.style import COLOURS, INK, QUIET, RC

plt.rcParams.update(RC)
COARSE = {"region.flyer.zones": 24, "region.target.zones": 48, "output.snapshots": "2.5 us", "stop_time": "1.6 us"}
TRUTH = {"region.flyer.velocity": 712.0, "material.al.strength.yield_stress": 0.28e9, "material.al.fracture.strength": 1.05e9,
         "shift": 8e-9}

with tempfile.TemporaryDirectory() as name:
    folder = Path(name)
    made = {key: value for key, value in TRUTH.items() if key != "shift"}
    truth = hugoniot.run("flyer.toml", folder / "truth.run", report=False, **COARSE, **made)
    at = np.linspace(0.5e-6, 1.5e-6, 300)
    clean = np.interp(at - TRUTH["shift"], *truth.gauge("velocity", "free surface"))
    measured = clean + 5.0 * np.random.default_rng(4).standard_normal(at.size)
    (folder / "visar.csv").write_text("time [us], velocity [m/s]\n" + "".join(f"{t * 1e6:.5f}, {u:.3f}\n" for t, u in zip(at, measured)))
    deck = folder / "start.toml"
    deck.write_text(truth.deck)
    found = hugoniot.fit(deck, folder / "visar.csv", {
        "region.flyer.velocity": "650..800 m/s", "material.al.strength.yield_stress": "0.1..0.6 GPa",
        "material.al.fracture.strength": "0.6..2 GPa"}, gauge="free surface", sigma="5 m/s", shift="20 ns", out=folder / "fit")
    fitted = hugoniot.run(folder / "fit" / "fitted.toml", folder / "fitted.run", report=False)
    time, velocity = fitted.gauge("velocity", "free surface")

# %%
# The upper panel shows the record and the run with the fitted values. The lower panel shows their difference divided by the
# standard deviation σ of the noise (5 m/s); the band is ±2σ. The difference shows no pattern, so the model describes the record.
shift = float(found["value"].sel(parameter="shift"))
fig, (ax, rest) = plt.subplots(2, 1, figsize=(6.6, 4.2), layout="constrained", height_ratios=(3, 1), sharex=True)
ax.plot(at * 1e6, measured, ".", color=INK, markersize=2, label="synthetic record")
model = np.interp(at - shift, time, velocity)
ax.plot(at * 1e6, model, color=COLOURS[1], label="fitted run")
ax.set_ylabel("free-surface velocity (m/s)")
ax.legend(frameon=False)
rest.axhspan(-2, 2, color=QUIET, alpha=0.2, linewidth=0)
rest.plot(at * 1e6, (model - measured) / 5.0, color=COLOURS[1], linewidth=0.8)
rest.set_xlabel("time (µs)")
rest.set_ylabel("difference / σ")

print(f"reduced chi-square {found.attrs['reduced_chi_square']:.3f}, {found.attrs['runs']} runs")
for name, true in TRUTH.items():
    value, sigma = (float(found[key].sel(parameter=name)) for key in ("value", "sigma"))
    print(f"{name}: {value:.5g} +- {sigma:.2g}, true value {true:.5g}, difference {abs(value - true) / sigma:.2f} sigma")
