"""Velocity jumps of a zone in one and in two directions: their smoothness, their value in the middle of a step, and their effect
on the time step. Functions of two directions need one division for both."""

from hugoniot.core.binder import bind
from hugoniot.core.ops import fmax, fmin

SMALL = 1e-60
SLIGHT, FAINT = 1e-4, 1e-6    # parts of the other jump and of the sound speed below which a jump limits the time step in proportion
STEADY = 1e-3           # part of the rate now below which one at the start of the step keeps the limiter in proportion


def kept(psi, before, now):
    """Smoothness along a direction that closes at the rate `now`: psi if it closed at the start of the step too, 0 if it opened."""
    return psi * fmax(0.0, fmin(1.0, before / (STEADY * now - SMALL)))


def counted(w, du, other, c):
    """What a jump du <= 0 with the viscous speed w requires of the time step, beside the size `other` of that of the other direction."""
    return w * fmin(1.0, -du / (SLIGHT * other + FAINT * c + SMALL))


def both_kept(part1, whole1, before1, now1, part2, whole2, before2, now2):
    """`kept` of two directions whose psi are part / whole. One division does for both: no factor is below SMALL, nor their product 0."""
    least1, least2 = SMALL - STEADY * now1, SMALL - STEADY * now2
    over1, over2 = fmax(whole1, SMALL) * least1, fmax(whole2, SMALL) * least2
    inverse = 1.0 / (over1 * over2)
    part1, part2 = part1 * fmax(0.0, fmin(-before1, least1)), part2 * fmax(0.0, fmin(-before2, least2))
    return part1 * (over2 * inverse), part2 * (over1 * inverse)


def both_at_middle(du1, q1, w1, length1, du2, q2, w2, length2, a):
    """`zones.viscosity.at_middle` of two closing jumps, q1 and q2 of the previous step, along the lengths of both directions. One division
    does for both."""
    over1, over2 = length1 + a.gives * a.rho * w1 + SMALL, length2 + a.gives * a.rho * w2 + SMALL
    inverse = 1.0 / (over1 * over2)
    own1, own2 = (du1 * length1 - a.gives * q1) * (over2 * inverse), (du2 * length2 - a.gives * q2) * (over1 * inverse)
    return fmin(fmax(own1, du1), 0.0), fmin(fmax(own2, du2), 0.0)


def both_counted(w1, du1, other1, w2, du2, other2, c):
    """The larger of what `counted` finds for two directions."""
    over1, over2 = SLIGHT * other1 + FAINT * c + SMALL, SLIGHT * other2 + FAINT * c + SMALL
    return fmax(w1 * fmin(over1, -du1) * over2, w2 * fmin(over2, -du2) * over1) / (over1 * over2)


for _function in (kept, counted, both_kept, both_at_middle, both_counted):
    bind(_function)
