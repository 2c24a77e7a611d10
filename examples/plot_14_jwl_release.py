"""
Release isentropes of detonation products
=========================================

After a detonation the products expand from the CJ state along an isentrope. The JWL equation of state describes it by three
terms, p = A exp(-R₁V) + B exp(-R₂V) + C/V^(1+ω), with the relative volume V = ρ₀/ρ. For PBX 9404 the first term is the largest
up to V = 1.2, the second from there to V = 3.4, and the third, which has the form of an ideal-gas
isentrope, beyond. The figure compares three explosives of the library.
"""

import matplotlib.pyplot as plt
import numpy as np

from hugoniot.materials.library import find
from hugoniot.plotting.style import COLOURS, INK, QUIET, RC
from hugoniot.theory.chapman_jouguet import cj
from hugoniot.theory.isentrope import isentrope

plt.rcParams.update(RC)
fig, ax = plt.subplots(figsize=(6.4, 4.2), layout="constrained")
volumes = np.geomspace(0.7, 20.0, 200)
for k, name in enumerate(("pbx_9404", "comp_b", "tnt")):
    explosive = find(name)
    par, point = explosive.eos, cj(explosive)
    v_cj = par.rho0 / point.state.density
    relative = volumes[volumes > v_cj]
    path = isentrope(par, point.state, density=par.rho0 / relative)
    ax.loglog(relative, path.pressure / 1e9, color=COLOURS[k])
    ax.plot(v_cj, point.state.pressure / 1e9, "o", color=COLOURS[k], ms=5)
    title = explosive.name.replace("_", " ").upper()
    label = f"{title}: D = {point.detonation_velocity / 1e3:.2f} km/s, {point.state.pressure / 1e9:.1f} GPa at CJ"
    ax.text(0.98, 0.95 - 0.06 * k, label, color=COLOURS[k], transform=ax.transAxes, ha="right", fontsize=8.5)
    if k == 0:
        first, second = par.a * np.exp(-par.r1 * relative), par.b * np.exp(-par.r2 * relative)
        tail = path.pressure - first - second
        print(f"{title}: the second term exceeds the first beyond V = {relative[np.argmax(second > first)]:.2f}, "
              f"the third exceeds the second beyond V = {relative[np.argmax(tail > second)]:.2f}")
        for part, text, where in ((first, "A exp(-R₁V)", 2.15), (second, "B exp(-R₂V)", 4.6), (tail, "C / V^(1+ω)", 0.75)):
            ax.plot(relative, part / 1e9, color=QUIET, lw=0.8, ls=(0, (4, 3)))
            height = np.interp(where, relative, part) / 1e9 * (0.45 if where < 1 else 1.0)
            ax.text(where, height, f" {text}", fontsize=8, color=QUIET, va="center")
ax.set(xlabel="relative volume V = ρ₀/ρ", ylabel="pressure (GPa)", xlim=(0.65, 20), ylim=(0.02, 60))
ax.set_xticks([1, 2, 5, 10, 20], ["1", "2", "5", "10", "20"])
ax.set_yticks([0.1, 1, 10], ["0.1", "1", "10"])
ax.minorticks_off()
ax.text(0.68, 0.024, "dots: CJ states\ndashed: terms of\nPBX 9404", fontsize=8.5, color=INK)
plt.show()
