"""
A burning mixture along an adiabat
==================================

An explosive shocked to 20 GPa expands while it burns (Starkenberg, section 5.7). Reactants and products have the same pressure
but exchange no heat: the reactants stay on their isentrope, and all the heat of reaction goes to the products. While the volume
grows to 1.15 times that behind the shock, the pressure falls to 10.6 GPa. Burning then keeps it above 10 GPa up to a volume
ratio of 1.4. Without burning (dashed) the pressure is only 4.2 GPa at a ratio of 1.2. The products take a larger share of the
volume than of the mass.
"""

import matplotlib.pyplot as plt
import numpy as np

from hugoniot.laws.eos.jwl import JWL
from hugoniot.plotting.style import COLOURS, QUIET, RC
from hugoniot.theory import mixture as mx
from hugoniot.theory.hugoniot import Initial, shock

plt.rcParams.update(RC)
RHO0, Q = 1895.0, 3.6e6
products = JWL(1.36177e12, 7.199e10, 6.2, 2.2, 0.5, RHO0, 6.9e9, 1.0e6 / RHO0)
reactants = JWL(7.781e13, -5.031e9, 11.3, 1.13, 0.8938, RHO0, 0.0, 2.487e6 / RHO0)
par = mx.mixture("thermal_isolation", reactants, products, Q)
behind = shock(reactants, Initial.at_rest(reactants), pressure=20e9)
rho, energy = float(behind.density), float(behind.specific_internal_energy) + Q
start = mx.solve(rho, energy, 0.0, par, reference=(rho, energy))

volumes = np.linspace(1.0, 2.2, 121)[1:] / rho


def burning(v):
    """Burn fraction at a specific volume: it rises from 0 to 1 while the volume grows by half."""
    x = min(max((v * rho - 1.0) / 0.5, 0.0), 1.0)
    return x * x * (3.0 - 2.0 * x)


way = mx.adiabat(start, volumes, burning)
few = np.linspace(1.0, 1.24, 60)[1:] / rho            # without burning the pressure is zero soon after
frozen = mx.adiabat(start, few)
ratio = volumes * rho

# %%
# Pressure, sound speed, and the share of the products by mass and by volume, against the volume relative to that behind the
# shock.
fig, axes = plt.subplots(1, 3, figsize=(7.6, 3.1), layout="constrained")
axes[0].plot(ratio, way.pressure / 1e9, color=COLOURS[0])
axes[0].plot(few * rho, frozen.pressure / 1e9, color=QUIET, ls=(0, (4, 3)))
axes[0].text(1.5, 10, "burning", color=COLOURS[0], fontsize=8.5)
axes[0].text(1.32, 3.2, "unburned", color=QUIET, fontsize=8.5)
axes[0].set_ylabel("pressure (GPa)")
axes[1].plot(ratio, way.sound_speed / 1e3, color=COLOURS[0])
axes[1].plot(few * rho, frozen.sound_speed / 1e3, color=QUIET, ls=(0, (4, 3)))
axes[1].set_ylabel("sound speed (km/s)")
axes[2].plot(ratio, way.burn_fraction, color=COLOURS[0])
axes[2].plot(ratio, way.volume_fraction, color=COLOURS[1])
axes[2].text(1.6, 0.9, "by mass", color=COLOURS[0], fontsize=8.5)
axes[2].text(1.01, 0.94, "by volume", color=COLOURS[1], fontsize=8.5)
axes[2].set_ylabel("fraction of products")
for ax in axes:
    ax.set(xlim=(1, 2.2), ylim=(0, None))
fig.supxlabel("volume / volume behind the shock", fontsize=9)
change = np.diff(way.energy) + 0.5 * (way.pressure[1:] + way.pressure[:-1]) * np.diff(volumes)
print(f"largest |de + p dv| of an interval, by the trapezoidal rule: {np.abs(change).max() / Q:.1e} Q (exact: 0)")
plt.show()
