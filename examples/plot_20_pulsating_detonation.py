"""
Pulsating detonation
====================

A steady reaction zone need not be stable. The standard test is a gas of gamma = 1.2 with one Arrhenius reaction, whose heat of
reaction and activation energy are both 50 in units of p₀/ρ₀, the ratio of initial pressure to initial density. Overdriven to f
= (D/D_CJ)² = 1.6, with D the speed of the front and D_CJ that of a CJ detonation, it settles into regular pulsations. Since
Fickett and Wood (1966) a peak pressure of 98.6 p₀ and a period of 7.3 to 7.5 time units have been quoted. The simulation gives
98.3 and 7.43.
"""

import matplotlib.pyplot as plt
import numpy as np

from hugoniot.campaign.moving_window import follow
from hugoniot.laws.burn.arrhenius import Arrhenius
from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.materials.material import Material
from hugoniot.plotting.style import COLOURS, QUIET, RC
from hugoniot.theory.hugoniot import Initial

plt.rcParams.update(RC)
gas = IdealGas(1.2, 5.0, 1.0)
RATE = 231.16    # makes the steady half-reaction length 1 at f = 1.6
mixture = Material("gas", gas, burn=Arrhenius(RATE, 50.0), unreacted=gas, mixture="weighted_pressures", detonation_energy=50.0)

# %%
# The run starts from the exact steady reaction zone. A window of zones moves with the front, and sound waves leave at its rear.
# Five zones per half-reaction length (the distance from the shock to the point where half of the gas has reacted) are coarse, but
# enough here. The coefficient ``quadratic`` of the artificial viscosity is (gamma + 1)/4, which suits a strong shock.
found = follow(mixture, Initial(1.0, 1.0, 5.0), 62.0, overdrive=1.6, zones=5, window=12.0, viscosity={"quadratic": 0.55, "linear": 1.0})
times, crests = found.crests(after=38.0)

# %%
# The pressure behind the front. The instability grows for three periods; from then on all peaks have the same height. The unit of
# time is the steady half-reaction length divided by √(p₀/ρ₀).
fig, ax = plt.subplots(figsize=(7.2, 3.4), layout="constrained")
ax.plot(found.time, found.front_pressure, color=COLOURS[0])
spike = float(found.exact.von_neumann.pressure)
for level, label in ((spike, "steady von\nNeumann spike"), (98.6, "published\npeak")):
    ax.axhline(level, color=QUIET, lw=0.8, ls=(0, (4, 3)))
    ax.text(62.5, level, f"{label}: {level:.1f}", fontsize=8.5, color=QUIET, va="center")
ax.set(xlabel="time (half-reaction length / √(p₀/ρ₀))", ylabel="pressure behind the front / p₀", xlim=(0, 62), ylim=(45, 108))

# %%
# Period and height of the peaks, and the mean speed of the front in units of sqrt(p/rho) of the gas ahead.
print(f"period {np.diff(times).mean():.2f}   literature 7.3 to 7.5")
print(f"peaks  {crests.mean():.1f}   literature 98.6")
print(f"front  {(found.position[-1] - found.position[0]) / found.time[-1]:.3f}   steady {found.exact.velocity:.3f}")
plt.show()
