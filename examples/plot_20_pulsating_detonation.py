"""
A detonation that pulsates
==========================

A steady reaction zone need not be stable. The standard test case is a single Arrhenius reaction in a gas of
gamma = 1.2 with heat and activation energy of 50 (in units of the state ahead), overdriven to f = (D/D_CJ)² = 1.6: the front
settles into one mode of pulsation. Fickett and Wood found it in 1966 by characteristics; peaks of 98.6 every 7.3 to 7.5
units of time have been quoted ever since.
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
# The run starts from the exact steady zone and follows its front with a moving window of zones; sound waves leave at the rear.
# Five zones per half-reaction length are coarse, but enough. `quadratic` is (gamma + 1)/4, the value for the shock itself.
found = follow(mixture, Initial(1.0, 1.0, 5.0), 62.0, overdrive=1.6, zones=5, window=12.0, viscosity={"quadratic": 0.55, "linear": 1.0})
times, crests = found.crests(after=38.0)

# %%
# Pressure behind the front. The instability of the steady zone grows for three periods; from then on all peaks are equally high.
fig, ax = plt.subplots(figsize=(7.2, 3.4), layout="constrained")
ax.plot(found.time, found.front_pressure, color=COLOURS[0])
spike = float(found.exact.von_neumann.pressure)
for level, words in ((spike, "von Neumann,\nsteady"), (98.6, "crests of the\nliterature")):
    ax.axhline(level, color=QUIET, lw=0.8, ls=(0, (4, 3)))
    ax.text(62.5, level, f"{words}: {level:.1f}", fontsize=8.5, color=QUIET, va="center")
ax.set(xlabel="time (units of half-reaction length, gas ahead)", ylabel="pressure behind the front", xlim=(0, 62), ylim=(45, 108))

# %%
# In numbers.
print(f"period {np.diff(times).mean():.2f}   literature 7.3 to 7.5")
print(f"crests {crests.mean():.1f}   literature 98.6")
print(f"front  {(found.position[-1] - found.position[0]) / found.time[-1]:.3f}   steady {found.exact.velocity:.3f}")
plt.show()
