"""A root inside a bracket: regula falsi whose end that stays is weighted down, with bisection where that is slow.

Source: Anderson and Bjoerck, BIT 13 (1973) 253.
"""


def root(value, low: float, high: float, at_low: float, at_high: float) -> float:
    """Where `value`, of opposite signs at both ends, vanishes: to rounding of the larger end."""
    least = 2e-16 * max(abs(low), abs(high))
    if at_high == 0.0:
        return high
    for k in range(200):
        width = high - low
        if abs(width) <= least or at_low == 0.0:
            return low
        place = low - at_low * width / (at_high - at_low)
        if k % 8 == 7 or not min(low, high) < place < max(low, high):
            place = low + 0.5 * width
        here = value(place)
        if here == 0.0 or place in (low, high):
            return place
        if (here > 0.0) == (at_high > 0.0):
            share = 1.0 - here / at_high
            high, at_high = place, here
            at_low *= share if share > 0.0 else 0.5
        else:
            share = 1.0 - here / at_low
            low, at_low = place, here
            at_high *= share if share > 0.0 else 0.5
        if abs(high - low) <= least:
            return place
    return low
