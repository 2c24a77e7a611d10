"""
Second shock compared with the principal Hugoniot
=================================================

Shocking a solid twice heats it less than shocking it once to the same density, so the Hugoniot of the second shock lies below
the principal Hugoniot. The example follows appendix A of Wilkins, with the equation of state P = aµ + bµ² + c(1 + µ)E, where µ
= ρ/ρ₀ - 1 is the compression and E the energy per initial volume (a = 0.73 Mbar, b = 1.72 Mbar, c = 1.60). The second shock
starts from µ = 0.10; at µ = 0.25 it reaches 34.75 GPa, 1.50 GPa less than the principal Hugoniot. The difference is of third
order in the compression. Wilkins' series for the second shock (A.4), as far as it is legible, is 17 to 21 % too high between µ
= 0.15 and 0.25; a corrected form is shown as well.
"""

import matplotlib.pyplot as plt
import numpy as np

from hugoniot.plotting.style import COLOURS, INK, RC
from hugoniot.theory import second_shock as s

plt.rcParams.update(RC)
MBAR = 100.0    # in GPa; Wilkins works in Mbar, and A.4 as printed mixes units, so it has to be evaluated in Mbar
law, start = s.Quadratic(0.73, 1.72, 1.60), 0.10
mu, ahead = np.linspace(0, 0.25, 201), np.linspace(start, 0.25, 121)

# %%
# Left: the Hugoniots; the numbers in brackets are those of Wilkins' equations. Right: how far the second shock lies below the
# principal Hugoniot, exactly and by two approximations; A.2 is Wilkins' series for the principal Hugoniot.
fig, (ax, diff) = plt.subplots(1, 2, figsize=(7.2, 3.5), layout="constrained")
ax.plot(mu, MBAR * s.principal(mu, law), color=INK)
ax.plot(ahead, MBAR * s.second(ahead, start, law), color=COLOURS[0])
ax.plot(ahead, MBAR * s.second_series_as_printed(ahead, start, law), color=COLOURS[1], ls=(0, (4, 2)))
ax.plot(start, MBAR * s.principal(start, law), "o", color=INK, ms=4)
for height, name, colour in ((36.8, "principal (A.1)", INK), (34.2, "second shock (A.3)", COLOURS[0]),
                             (42.0, "series A.4 as printed", COLOURS[1])):
    ax.text(0.254, height, name, color=colour, fontsize=8.5, va="center")
ax.set(xlabel="compression µ = ρ/ρ₀ - 1", ylabel="pressure (GPa)", xlim=(0, 0.25), ylim=(0, 43))

diff.plot(ahead, MBAR * (s.second(ahead, start, law) - s.principal(ahead, law)), color=COLOURS[0])
diff.plot(ahead, MBAR * s.leading_difference(ahead, start, law), color=COLOURS[2], ls=(0, (4, 2)))
diff.plot(ahead, MBAR * (s.second_series(ahead, start, law) - s.principal_series(ahead, law)), color=COLOURS[3], ls=(0, (1, 1.5)))
diff.text(0.102, -1.62, "exact, A.3 less A.1", color=COLOURS[0], fontsize=8.5)
diff.text(0.102, -1.50, "leading term (third order)", color=COLOURS[2], fontsize=8.5)
diff.text(0.102, -1.38, "series: A.4 corrected less A.2", color=COLOURS[3], fontsize=8.5)
diff.set_xticks([0.10, 0.15, 0.20, 0.25])
diff.set(xlabel="compression µ", ylabel="second less principal pressure (GPa)", xlim=(0.1, 0.25), ylim=(-1.7, 0.05))
for value in (0.15, 0.20, 0.25):
    print(f"mu {value:.2f}: second shock {MBAR * s.second(value, start, law):.4f} GPa, principal {MBAR * s.principal(value, law):.4f} GPa")
plt.show()
