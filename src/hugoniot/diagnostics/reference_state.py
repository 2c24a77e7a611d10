"""The reference state of reactants in thermal isolation: when a smeared shock has passed, and which isentrope it left them on.

003 takes the reference state of a zone behind the shock, which a tracked front knows exactly. Artificial viscosity smears the shock
over zones, so somebody has to say when it has passed: `ReferenceDetector` takes the first step after the viscous pressure of a zone has
been at its largest and fallen below `PASSED` of the pressure; if more than `BURNED` of the zone has burned before, it takes the state
then and says so. The solver itself needs no detector: its reference rolls, see docs/theory/mixtures.md. This is how both are measured.
"""

import numpy as np

from hugoniot.laws.mixture.isentrope import isentrope_energy

PASSED = 0.01       # of the pressure, below which a zone's viscous pressure is that of no shock any more
BURNED = 1e-3       # burn fraction beyond which the reactants are no longer the zone
NOT_YET, AFTER_SHOCK, WHILE_BURNING = 0, 1, 2
MEANING = {NOT_YET: "no shock has passed", AFTER_SHOCK: "behind the shock, before burning",
           WHILE_BURNING: "burning began inside the smeared shock"}


class ReferenceDetector:
    """Look at a run after every step: `look(state, phases)` with `solver.state()` and `solver.phases()`.

    how             (nzone,) one of the codes of MEANING
    density, energy (nzone,) of the reactants when they were taken, kg/m3 and J/kg (with the chemical energy); nan before
    time            (nzone,) s
    """

    def __init__(self, zones: int):
        self.how = np.zeros(zones, dtype=int)
        self.density, self.energy, self.time = (np.full(zones, np.nan) for _ in range(3))
        self._largest = np.zeros(zones)

    def look(self, state, phases: np.ndarray) -> None:
        """Take the reactants of the zones whose shock has passed, or that have begun to burn, since the last look."""
        q, p, fraction = state.zones["viscous_pressure"], state.zones["pressure"], phases[0]
        self._largest = np.maximum(self._largest, q)
        waiting = self.how == NOT_YET
        shocked = waiting & (self._largest > PASSED * np.abs(p))
        burning = waiting & (fraction > BURNED)
        passed = shocked & ~burning & (q < PASSED * p)
        for code, here in ((AFTER_SHOCK, passed), (WHILE_BURNING, burning)):
            self.how[here] = code
            self.density[here], self.energy[here], self.time[here] = phases[1, here], phases[2, here], state.time


def isentrope_error(density, energy, exact_density: float, exact_energy: float, rest_energy: float, par) -> np.ndarray:
    """How far the isentropes through reactant states lie from the one through the exact state behind the shock.

    Energies (J/kg) are thermal. Each state is followed along its isentrope to the exact density; what is left is the difference of the
    energies over the energy rise of the exact jump.
    """
    there = [isentrope_energy(1.0 / float(rho), float(e), 1.0 / exact_density, par) for rho, e in zip(density, energy)]
    return (np.array(there) - exact_energy) / (exact_energy - rest_energy)
