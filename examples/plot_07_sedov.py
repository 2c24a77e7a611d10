"""
Sedov's blast wave
==================

An energy of 0.851072 J is released at a point in a cold gas (gamma = 1.4, density 1 kg/m³). The exact, self-similar solution
has the shock at a radius of 1 m after one second, with a density of 6 kg/m³ behind it. The simulation starts from a hot ball of
1 cm radius. After one second its shock is at 0.999 m with a peak density of 5.85 kg/m³: the peak is cut off because the shock
is spread over a few zones.
"""

import tempfile
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import hugoniot
from hugoniot.plotting.style import COLOURS, INK, RC
from hugoniot.theory.exact.sedov import sedov

plt.rcParams.update(RC)
run = hugoniot.run("sedov.toml", Path(tempfile.mkdtemp()) / "sedov.run", report=False)
exact, rows = sedov(), run.arrays("snapshots")
centre = 0.5 * (rows["position_left"] + rows["position_right"])

# %%
# Left: density at three times, simulation (dots) and exact profiles (lines). Right: the radius R of the shock, which grows as the
# power 2/5 of the time t.
fig, (one, two) = plt.subplots(1, 2, figsize=(7.2, 3.2), layout="constrained")
x = np.linspace(1e-3, 1.15, 3000)
for k, wanted in enumerate((0.2, 0.5, 1.0)):
    n = int(np.argmin(np.abs(rows["time"] - wanted)))
    one.plot(x, exact(x, wanted)["density"], color=INK, lw=0.7)
    one.plot(centre[n], rows["density"][n], ".", ms=2.5, color=COLOURS[k])
    one.text(exact.jumps(wanted)[0], 6.15, f"{wanted:g} s", color=COLOURS[k], ha="center", fontsize=8.5)
one.set(xlabel="radius (m)", ylabel="density (kg/m³)", xlim=(0, 1.15), ylim=(0, 6.7))
time = rows["time"][2:]
front = [c[np.flatnonzero(r > 2.0)[-1]] for r, c in zip(rows["density"][2:], centre[2:])]
two.loglog(time, [exact.jumps(t)[0] for t in time], color=INK, lw=0.8)
two.loglog(time, front, "o", ms=3, mfc="none", color=COLOURS[0])
two.text(0.2, 0.75, "exact, R ∝ t^(2/5)", fontsize=8.5, ha="center")
two.text(0.35, 0.52, "simulation", color=COLOURS[0], fontsize=8.5)
two.set(xlabel="time (s)", ylabel="radius of the shock (m)")
two.minorticks_off()
two.set_xticks([0.1, 0.2, 0.5, 1], ["0.1", "0.2", "0.5", "1"])
two.set_yticks([0.4, 0.6, 0.8, 1], ["0.4", "0.6", "0.8", "1"])
top = int(np.argmax(rows["density"][-1]))
print(f"peak density {rows['density'][-1][top]:.3f} kg/m³ (exact 6) at r = {rows['position_right'][-1][top]:.4f} m (exact 1)")
plt.show()
