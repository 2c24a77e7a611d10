"""
Impedance matching with error bars
==================================

A copper flyer at 1000 ± 2 m/s hits aluminium. How uncertain is the pressure at the interface? Each Hugoniot Us = c₀ + s up has
uncertain constants, and c₀ and s of a fit are strongly anticorrelated (here -0.9). The pressure is 12.07 GPa with a standard
deviation of 0.039 GPa; ignoring the correlation would give 0.054 GPa. Linear propagation and a Monte Carlo calculation with 400
samples agree.
"""

import matplotlib.pyplot as plt
import numpy as np

from hugoniot.laws.eos.mie_gruneisen import MieGruneisen
from hugoniot.plotting.matches import impedance_match
from hugoniot.plotting.style import COLOURS, INK, QUIET, RC
from hugoniot.theory.impedance import match
from hugoniot.theory.uncertainty import propagate

plt.rcParams.update(RC)
VALUES = {"velocity": 1000.0, "c_cu": 3940.0, "s_cu": 1.489, "c_al": 5328.0, "s_al": 1.338}
SIGMAS = {"velocity": 2.0, "c_cu": 20.0, "s_cu": 0.012, "c_al": 30.0, "s_al": 0.02}
ANTI = {("c_cu", "s_cu"): -0.9, ("c_al", "s_al"): -0.9}


def impact(velocity, c_cu, s_cu, c_al, s_al):
    """Pressure (GPa) and particle velocity (m/s) at the impact face."""
    found = match([MieGruneisen(8930.0, c_cu, s_cu, 1.99), MieGruneisen(2785.0, c_al, s_al, 2.0)], velocity)[0]
    return {"pressure": found.pressure / 1e9, "particle_velocity": found.particle_velocity}


linear = propagate(impact, VALUES, SIGMAS, correlation=ANTI)
drawn = propagate(impact, VALUES, SIGMAS, correlation=ANTI, samples=400, seed=1)
careless = propagate(impact, VALUES, SIGMAS)

# %%
# Left: the impedance match, with the Hugoniot of the target and that of the flyer, reflected and shifted to the impact velocity.
# The inset shows the match with its standard deviations. Right: the standard deviation of the pressure that each input would
# cause alone (bars) and all of them together.
fig, (ax, bars) = plt.subplots(1, 2, figsize=(7.4, 3.5), layout="constrained", width_ratios=(1.25, 1))
layers = [MieGruneisen(8930.0, 3940.0, 1.489, 1.99), MieGruneisen(2785.0, 5328.0, 1.338, 2.0)]
impedance_match(layers, 1000.0, match(layers, 1000.0), ax=ax)
for text in list(ax.texts):
    if text.get_text().startswith("layer"):
        text.set_text("copper" + text.get_text()[7:] if "layer 0" in text.get_text() else "aluminium")
ax.set_xlim(0, 1.08)
p, u = linear["pressure"], linear["particle_velocity"]
zoom = ax.inset_axes((0.14, 0.60, 0.31, 0.33))
for line in ax.get_lines()[:2]:
    zoom.plot(1e3 * line.get_xdata(), line.get_ydata(), color=line.get_color(), ls=line.get_linestyle(), lw=1.0)
zoom.errorbar(u.value, p.value, xerr=u.sigma, yerr=p.sigma, color=INK, lw=1.2, capsize=2.5, zorder=6)
zoom.set(xlim=(u.value - 4 * u.sigma, u.value + 4 * u.sigma), ylim=(p.value - 3 * p.sigma, p.value + 3 * p.sigma))
zoom.set_title("match ± σ (GPa, m/s)", fontsize=7.5)
zoom.tick_params(labelsize=7.5)

names = {"velocity": "impact velocity", "c_al": "c₀ aluminium", "s_al": "s aluminium", "c_cu": "c₀ copper", "s_cu": "s copper"}
shares = [linear["pressure"].shares[name] ** 0.5 * linear["pressure"].sigma for name in names]
y = np.arange(len(names))
bars.barh(y, shares, color=COLOURS[0], height=0.55)
bars.set_yticks(y, list(names.values()))
bars.spines["left"].set_visible(False)
bars.tick_params(axis="y", length=0)
bars.axvline(linear["pressure"].sigma, color=INK, lw=0.8)
bars.text(linear["pressure"].sigma, -0.55, "all, with correlation", ha="center", fontsize=8.5)
bars.axvline(careless["pressure"].sigma, color=QUIET, lw=0.8, ls=(0, (4, 3)))
bars.text(careless["pressure"].sigma * 1.02, 4.3, "all, without\ncorrelation", fontsize=8.5, color=QUIET, va="bottom")
bars.set(xlabel="standard deviation of pressure (GPa)", xlim=(0, 1.45 * careless["pressure"].sigma), ylim=(4.6, -0.5))
for name, unit in (("pressure", "GPa"), ("particle_velocity", "m/s")):
    print(f"{name}: {linear[name].value:.2f} ± {linear[name].sigma:.3f} {unit}, Monte Carlo ± {drawn[name].sigma:.3f}, "
          f"without correlation ± {careless[name].sigma:.3f}")
plt.show()
