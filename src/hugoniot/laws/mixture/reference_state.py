r"""Detects when a smeared shock has passed a zone, which determines the isentrope of the reactants in thermal isolation.

Starkenberg takes the reference state of a zone behind the last shock. A tracked front gives it directly; artificial viscosity smears
the front over several zones, so a detector must find when it has passed. A shock is passing a zone while

$$q > 0.01\,(|p| + 10^{-4}\rho c^2),$$

where the second term excludes noise in material at rest. When the shock has passed, the detector records how the state was
found: behind the shock, before burning, or while the zone was burning (more than a thousandth), so that the state behind the
shock is one of partly burned explosive. A later shock restarts the detection.

With a *frozen* reference the reactants receive their share of the viscous heat only while a shock is passing; the isentrope through their
state in the previous step is then the one through the state found. With a *rolling* reference they receive their share of all heat.

Source: Starkenberg ARL-TR-2161 section 4.3 for the reference state; the detector is specific to this package.
"""

PASSED = 0.01      # of the pressure, up to which a zone's viscous pressure is that of no shock
FAINT = 1e-4       # pressure, in units of rho c^2, beside which no shock counts
BURNED = 1e-3      # burn fraction beyond which the state behind a shock is that of a burning zone

ROLLING, FROZEN = "rolling", "frozen"
CHOICES = (ROLLING, FROZEN)
NO_SHOCK, PASSING, BEHIND, WHILE_BURNING = 0.0, 1.0, 2.0, 3.0
MEANING = {NO_SHOCK: "with no shock yet", PASSING: "with a shock still passing", BEHIND: "behind the shock",
           WHILE_BURNING: "while burning inside it"}


def is_passing(q, p, stiffness):
    """Whether a zone of viscous pressure q, pressure p and stiffness rho c^2 (Pa) is inside a smeared shock."""
    return q > PASSED * (abs(p) + FAINT * stiffness)


def found_state(code, shocked, burn_fraction):
    """The code of MEANING of a zone at the end of a step, from the one at its start."""
    if shocked:
        return PASSING
    if code == PASSING:
        return WHILE_BURNING if burn_fraction > BURNED else BEHIND
    return code


def reactants_share(heat, shocked, freezes):
    """What the reactants take of a step's viscous heat (J/kg of mixture) per mass; `freezes` is 1 for a frozen reference, else 0."""
    return heat if shocked or freezes == 0.0 else 0.0
