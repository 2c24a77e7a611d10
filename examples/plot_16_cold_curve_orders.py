"""
Cold curves: power series against the exact curve
=================================================

Jordan (2011) expands the cold energy (the energy at zero temperature) of copper and of a silica powder in a power series in the
strain 1 - ρ₀/ρ. For the same material model the exact cold energy can be written with an exponential integral. The figure
compares it with the series truncated at orders 3 to 6. For copper at a strain of 0.3 the energy is 21 % too low at order 3, and
1.5 % at order 6. For the powder at a strain of 0.97 (33 times the initial density) it is more than 75 % too low at each of these
orders.
"""

import matplotlib.pyplot as plt
import numpy as np

from hugoniot.laws.eos.contract import EOS
from hugoniot.laws.eos.mie_gruneisen_cold import MieGruneisenCold, cold_energy
from hugoniot.laws.eos.mie_gruneisen_cold_series import cold_energy as series_energy
from hugoniot.plotting.style import COLOURS, INK, RC

plt.rcParams.update(RC)
series = EOS.get("mie_gruneisen_cold_series")
fig, axes = plt.subplots(1, 2, figsize=(7.4, 3.6), layout="constrained")
cases = (("copper", (8930.0, 3940.0, 1.49, 1.99), 0.5), ("silica powder, 100 kg/m³", (100.0, 121.0, 0.9736, 0.3), 0.97))
for ax, (title, (rho0, c0, s, gamma), top) in zip(axes, cases):
    strain = np.linspace(0.02, top, 150)
    rho = rho0 / (1.0 - strain)
    exact = np.array([cold_energy(r, MieGruneisenCold(rho0, c0, s, gamma)) for r in rho])
    for k, order in enumerate((3, 4, 5, 6)):
        par = series.build(rho0=rho0, c0=c0, s=s, gamma0=gamma, order=order)
        found = np.array([series_energy(r, par) for r in rho])
        error = 100 * (found / exact - 1.0)
        ax.plot(strain, error, color=COLOURS[k])
        ax.text(strain[-1] + 0.012 * top, error[-1], f"{order}", color=COLOURS[k], va="center", fontsize=8.5)
        at = np.interp(0.3, strain, error)
        print(f"{title}: order {order}, strain 0.3: {at:+.1f} %")
    ax.axhline(0, color=INK, lw=0.7)
    ax.set_title(title, loc="left")
    ax.set(xlabel="strain 1 - ρ₀/ρ", xlim=(0, 1.06 * top))
    ax.text(top * 1.03, 3, "order", fontsize=8.5, ha="right")
axes[0].set_ylabel("error of the cold energy (%)")
plt.show()
