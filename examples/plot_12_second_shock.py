"""
How far a second shock lies from the principal Hugoniot
=======================================================

Wilkins, appendix A, with a = 0.73, b = 1.72 and c = 1.60 Mbar. A second shock from mu = 0.10 ends below the principal
Hugoniot, because it heats less. The source calls the difference one of high order; it is of third order. Equation A.4 of the source, as
far as it is legible, gives values 17 to 21 % too high (W-E1).
"""

import matplotlib.pyplot as plt
import numpy as np

from hugoniot.plotting.style import COLOURS, INK, RC
from hugoniot.theory import second_shock as s

plt.rcParams.update(RC)
MBAR = 100.0  # GPa: A.4 as printed is a sum of unlike units, so it is evaluated in the Mbar of the source
law, start = s.Quadratic(0.73, 1.72, 1.60), 0.10
mu, ahead = np.linspace(0, 0.25, 201), np.linspace(start, 0.25, 121)

fig, (ax, diff) = plt.subplots(1, 2, figsize=(7.2, 3.5), layout="constrained")
ax.plot(mu, MBAR * s.principal(mu, law), color=INK)
ax.plot(ahead, MBAR * s.second(ahead, start, law), color=COLOURS[0])
ax.plot(ahead, MBAR * s.second_series_as_printed(ahead, start, law), color=COLOURS[1], ls=(0, (4, 2)))
ax.plot(start, MBAR * s.principal(start, law), "o", color=INK, ms=4)
for height, name, colour in ((36.8, "principal", INK), (34.2, "second shock, A.3", COLOURS[0]), (42.0, "A.4 as printed", COLOURS[1])):
    ax.text(0.254, height, name, color=colour, fontsize=8.5, va="center")
ax.set(xlabel="compression µ = ρ/ρ₀ - 1", ylabel="pressure (GPa)", xlim=(0, 0.25), ylim=(0, 43))

diff.plot(ahead, MBAR * (s.second(ahead, start, law) - s.principal(ahead, law)), color=COLOURS[0])
diff.plot(ahead, MBAR * s.leading_difference(ahead, start, law), color=COLOURS[2], ls=(0, (4, 2)))
diff.plot(ahead, MBAR * (s.second_series(ahead, start, law) - s.principal_series(ahead, law)), color=COLOURS[3], ls=(0, (1, 1.5)))
diff.text(0.102, -1.62, "exact", color=COLOURS[0], fontsize=8.5)
diff.text(0.102, -1.50, "leading term, of third order", color=COLOURS[2], fontsize=8.5)
diff.text(0.102, -1.38, "A.4 corrected less A.2", color=COLOURS[3], fontsize=8.5)
diff.set_xticks([0.10, 0.15, 0.20, 0.25])
diff.set(xlabel="compression µ", ylabel="second less principal (GPa)", xlim=(0.1, 0.25), ylim=(-1.7, 0.05))
for value in (0.15, 0.20, 0.25):
    print(f"mu {value:.2f}: second shock {MBAR * s.second(value, start, law):.4f} GPa, principal {MBAR * s.principal(value, law):.4f} GPa")
plt.show()
