"""
Aluminium: Hugoniot, Rayleigh lines and a doubtful extrapolation
================================================================

Pressure against particle velocity for aluminium 6061, after figure 2.3 of the manual of the KB codes (Field Precision, 2000).
The linear Us-up relation of the library is a fit to data up to 3.8 km/s (solid). The manual gives one state at 30 km/s, 3401
GPa, from a table that is not public. Extrapolated to that velocity (dashed), the fit gives 3831 GPa, 13 % more.
"""

import matplotlib.pyplot as plt

from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.materials.library import find
from hugoniot.plotting.style import COLOURS, INK, RC
from hugoniot.theory.hugoniot import curve, shock

plt.rcParams.update(RC)
aluminum = find("aluminum_6061")
limit = aluminum.valid_up_to / 1e3
law = MieGruneisen(aluminum.eos.rho0, aluminum.eos.c0, aluminum.eos.s, aluminum.eos.gamma0)
reach = curve(law, up_to=30e3, points=601)
up, p = reach.particle_velocity / 1e3, reach.pressure / 1e9
known = up <= limit

# %%
# Left: up to the state given in the manual. Right: the range of the data, with Rayleigh lines (black) to three states. The slope of a
# Rayleigh line is the initial density times the shock velocity Us.
fig, (ax, near) = plt.subplots(1, 2, figsize=(7.4, 3.6), layout="constrained", width_ratios=(1.2, 1))
ax.plot(up[known], p[known], color=COLOURS[0])
ax.plot(up[~known], p[~known], color=COLOURS[0], ls=(0, (4, 2)))
ax.plot([0, 30], [0, 3401], color=INK, lw=0.8)
ax.plot(30, 3401, "o", color=INK, ms=5)
speed = 3.401e12 / (2700.0 * 30e3)
ax.annotate(f"KB manual: 3401 GPa\nUs = p/(ρ₀ up) = {speed / 1e3:.2f} km/s", (30, 3401), xytext=(31.5, 250), ha="right", fontsize=8.5,
            arrowprops={"arrowstyle": "-", "lw": 0.6, "shrinkB": 4})
ax.text(11.5, 1480, "Rayleigh line", fontsize=8.5, ha="right")
ax.text(22, 3000, f"extrapolated fit\nUs = {reach.shock_velocity[-1] / 1e3:.2f} km/s", color=COLOURS[0], fontsize=8.5, ha="right")
ax.set(xlabel="particle velocity (km/s)", ylabel="pressure (GPa)", xlim=(0, 32), ylim=(0, 4100))

near.plot(up[known], p[known], color=COLOURS[0])
for velocity in (1000.0, 2000.0, 3000.0):
    state = shock(law, particle_velocity=velocity)
    near.plot([0, velocity / 1e3], [0, state.pressure / 1e9], color=INK, lw=0.8)
    near.plot(velocity / 1e3, state.pressure / 1e9, "o", color=INK, ms=4.5)
    label = f"{state.pressure / 1e9:.1f} GPa\nUs = {state.shock_velocity / 1e3:.2f} km/s"
    near.text(velocity / 1e3 + 0.1, state.pressure / 1e9 - 1.5, label, fontsize=8.5, va="top")
near.set(xlabel="particle velocity (km/s)", ylabel="pressure (GPa)", xlim=(0, 4.2), ylim=(0, None))
print(f"fit at 30 km/s: {p[-1]:.0f} GPa, {p[-1] / 3401 - 1:+.1%}; shock velocity {reach.shock_velocity[-1] / speed - 1:+.1%}")
plt.show()
