"""Constants of the zones of a material besides its laws: a row of numbers that passes read by name."""

from typing import NamedTuple

from hugoniot.core.ops import NO_LIMIT


class Constants(NamedTuple):
    """One line of the table of constants.

    rest        density at rest, kg/m3
    noise       -c^2 up to this is round-off, m2/s2
    per_rate    signal rate that the time step counts for a rate of burning
    front       speed of a programmed front, m/s
    isolates    1 where reactants keep an isentrope, and so have a reference state
    freezes     1 where that state is frozen
    crushed     density to which nothing may be pressed before it burns, kg/m3
    """

    rest: float
    noise: float
    per_rate: float = 0.0
    front: float = 0.0
    isolates: float = 0.0
    freezes: float = 0.0
    crushed: float = NO_LIMIT
