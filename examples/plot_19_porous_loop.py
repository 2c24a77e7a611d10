"""
Porous aluminium: crushed, released and crushed again
=====================================================

A slow piston compresses aluminium with 78 % of the solid density. First the material is elastic; from 0.08 GPa the pores close
along the crush curve of the P-alpha law. When the piston is drawn back, the material unloads elastically, with a sound speed
near that of the solid, because the closed pores stay closed. On reloading it returns to the point where it left the crush curve and
follows the curve from there. A law without memory would go back along the crush curve and reopen the pores.
"""

import matplotlib.pyplot as plt
import numpy as np

from hugoniot.laws.eos import p_alpha
from hugoniot.laws.eos.contract import pressure
from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.materials.material import Material
from hugoniot.plotting.style import COLOURS, QUIET, RC
from hugoniot.problem.model import Boundary, OutputOptions, Problem, Pulse, Region
from hugoniot.simulate import make_solver

plt.rcParams.update(RC)
solid = MieGruneisen(2700.0, 5350.0, 1.34, 2.0, 863.0)
porous = p_alpha.build(solid, alpha0=1.275, elastic_pressure=0.08e9, compaction_pressure=0.7e9)

# %%
# The piston moves in at 0.5 m/s, is drawn back for a while, and moves in again. It is so slow that the 2 mm of material stays in
# equilibrium. The figure shows the mean pressure against the mean density: the simulated path (blue) and the crush curve at zero
# internal energy (dashed).
pulse = Pulse("table", times=(0.0, 4e-4, 4.04e-4, 4.8e-4, 4.84e-4, 1e-3), values=(0.5, 0.5, -0.08, -0.08, 0.5, 0.5))
problem = Problem("loop", "planar", 7e-4, (Region("slab", "foam", 0.0, 2e-3, 20),), {"foam": Material("foam", porous)},
                  Boundary("velocity", pulse), Boundary("fixed"), output=OutputOptions(report=False))
solver, path = make_solver(problem), []
for time in np.linspace(2e-6, 7e-4, 350):
    solver.march(float(time), 10**6)
    zones = solver.state().zones
    path.append([zones[name].mean() for name in ("density", "pressure", "compaction")])
rho, p, k = np.array(path).T

fig, ax = plt.subplots(figsize=(6.4, 4.0), layout="constrained")
curve = np.linspace(2117.6, 2590.0, 200)
ax.plot(curve, [pressure(r, 0.0, porous) / 1e9 for r in curve], color=QUIET, lw=0.9, ls=(0, (4, 3)))
ax.text(2562, 0.365, "crush curve", color=QUIET, fontsize=8.5, ha="left", va="top")
ax.plot(rho, p / 1e9, color=COLOURS[0], lw=1.5)
turn = int(np.argmin(np.where((rho > 2300) & (rho < 2400) & (k > 0.4), p, 1e10)))
ax.annotate("released and reloaded:\nelastic, pores stay closed", (rho[turn], p[turn] / 1e9), xytext=(2390, 0.09), fontsize=8.5,
            color=COLOURS[0], arrowprops=dict(arrowstyle="-", color=COLOURS[0], lw=0.7), va="center")
ax.annotate("pores begin to close", (2121.0, 0.08), xytext=(2140, 0.03), fontsize=8.5, color=QUIET, va="center",
            arrowprops=dict(arrowstyle="-", color=QUIET, lw=0.7))
ax.set(xlabel="density (kg/m³)", ylabel="pressure (GPa)", xlim=(2100, 2640), ylim=(0, 0.42))

# %%
# The sound speed along the unloading path, and the compaction (0: pores as in the initial state, 1: all closed) at the end.
stiff = (p[turn - 12] - p[turn - 4]) / (rho[turn - 12] - rho[turn - 4])
print(f"unloading, sqrt(dp/drho): {np.sqrt(stiff):.0f} m/s, sound speed of the solid {5350.0:.0f} m/s")
print(f"compaction {k[-1]:.3f} at {p[-1] / 1e9:.3f} GPa; the crush curve gives {1.0 - ((0.7e9 - p[-1]) / 0.62e9) ** 2:.3f}")
plt.show()
