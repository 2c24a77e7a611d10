"""What both searches for equal pressures share: Newton's method in w = v_r - v_p, in which the difference F of the pressures falls.

Source: Starkenberg ARL-TR-2161 sections 4.2 and 5.1 for the unknown w; the end of the search is specific to this package.
"""

from hugoniot.core.ops import fmax, fmin

# A phase of less than this mass fraction is left out by `solve`: it changes the pressure by about 1e-8 of itself, and its energy is the
# difference of nearly equal numbers (only reactants in tension would notice the bubbles).
NASCENT = 1e-8
CLOSE = 1e-8         # step from which a search ends, relative
CLOSE_PAIR = 4e-9    # product of two steps from which it ends
SHORT = 0.1          # of a phase's volume, beyond which `attempt` goes no step


def limits(v, lam, par):
    """w between which both phases are less dense than their laws bear."""
    low = -(v - 1.0 / par.reactant_density_limit) / fmax(lam, 1e-12)
    return low, fmin((v - 1.0 / par.product_density_limit) / fmax(1.0 - lam, 1e-12), 1e6 * v)


def is_close(step, step_0, scale):
    """Whether a search ends with this step, the one before being step_0: then what is left is of the order of CLOSE^2, CLOSE_PAIR^2."""
    return (abs(step) <= CLOSE * scale) | (abs(step * step_0) <= CLOSE_PAIR * scale * scale)


def inverse_cubic(excess, decline, moved, excess_0, decline_0):
    """Way from a trial w to the root of F: w as a cubic of F through this trial and the one before, `moved` behind, and both slopes."""
    between = excess_0 - excess
    chord = -moved / between
    bend = (chord + 1.0 / decline) / between
    twist = ((-1.0 / decline_0 - chord) / between - bend) / between
    return excess / decline + excess * excess * (bend - excess_0 * twist)
