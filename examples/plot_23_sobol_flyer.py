"""
Which inputs matter: Sobol' indices of a flyer impact
=====================================================

In a flyer-plate impact the flyer speed is known to 1 %, the sound speed c₀ to 2 %, the slope s of the Hugoniot to 7 % and the
yield stress to 20 %. Which of them causes the scatter of the results? Sobol' indices divide the variance of each result among
the inputs. The sound speed dominates the arrival time and the plateau stress, the flyer speed dominates the free-surface
velocity, and the yield stress hardly matters. With 64 base cases the intervals are wide; more cases would narrow them.
"""

import csv
import tempfile
from pathlib import Path

import matplotlib.pyplot as plt

import hugoniot
from hugoniot.plotting.style import COLOURS, INK, RC

plt.rcParams.update(RC)
VARY = {"region.flyer.velocity": "693..707 m/s", "material.al.strength.yield_stress": "0.24..0.36 GPa",
        "material.al.eos.c0": "5.1..5.3 km/s", "material.al.eos.s": "1.4..1.6"}
RESULTS = {"2 mm into target.arrival": "arrival at 2 mm", "2 mm into target.plateau_stress": "plateau stress at 2 mm",
           "free surface.peak_velocity": "free-surface velocity"}

with tempfile.TemporaryDirectory() as folder:
    fixed = {"region.flyer.zones": 24, "region.target.zones": 48, "output.snapshots": "2 us", "stop_time": "1 us"}
    deck = Path(folder) / "coarse.toml"
    deck.write_text(hugoniot.run("flyer.toml", Path(folder) / "one.run", report=False, **fixed).deck)
    hugoniot.sweep(deck, VARY, design="saltelli", samples=64, out=Path(folder) / "sweep", output=list(RESULTS), report=False)
    rows = list(csv.DictReader((Path(folder) / "sweep" / "sensitivity.csv").open()))

# %%
# First-order indices (bars) with 95 % bootstrap intervals (lines): the share of the variance of a result that would vanish if
# this input were known exactly. Estimates from few cases can be slightly negative.
fig, axes = plt.subplots(1, 3, figsize=(7.4, 2.7), layout="constrained", sharey=True)
for ax, (result, label) in zip(axes, RESULTS.items()):
    own = [row for row in rows if row["result"] == result][::-1]
    for k, row in enumerate(own):
        first, low, high = (float(row[key]) for key in ("first", "first_low", "first_high"))
        ax.barh(k, first, color=COLOURS[0], height=0.6)
        ax.plot([low, high], [k, k], color=INK, linewidth=1.0)
    ax.set_yticks(range(4), ["slope s", "sound speed c₀", "yield stress", "flyer speed"])
    ax.set_title(label, loc="left")
    ax.set_xlabel("first-order index")

# the total index also counts the share that an input has in interactions with others
for result, label in RESULTS.items():
    most = max((row for row in rows if row["result"] == result), key=lambda row: float(row["total"]))
    print(f"{label}: mostly {most['parameter']}, total index {float(most['total']):.2f}")
