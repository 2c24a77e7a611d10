"""What the compiled march works on: the mesh, the laws and the fronts as arrays, and a table of scratch rows.

Blocks of ten rows hold states: density, velocity, energy, burn fraction, reference volume and energy, then pressure, its two slopes and
the sound speed. LOW and HIGH are the parabolas' values at the faces of every cell, LEFT, RIGHT and MIDDLE the same half a step on.
In solids the rows of the reference volume and energy hold the stretch and the hoop strain (laws.riemann.medium), that of the pressure the
stress.
"""

from typing import Any, NamedTuple

import numpy as np

RHO, U, E, LAM, VOLUME, ENERGY, P, P_RHO, P_E, C = range(10)
HOOP = ENERGY
STATE = 6                         # rows of a block that are carried with the material
MEAN, LOW, HIGH, LEFT, RIGHT, MIDDLE = range(0, 60, 10)
SLOPE, CURVE, SMOOTH = 60, 66, 72
(CENTRE, FIRST, SECOND, FULL, BOTH, KNOWN, AIM, SPEED, F_RHO, F_U, F_E, F_P) = range(78, 90)
BORN_HOOP, BORN_LEFT, BORN_RIGHT = 5, 6, 7      # columns of `mesh.Mesh.given`: of solids hoop strain, stretch left and right of a new face
INTO_LEFT, INTO_RIGHT = 90, 93    # scalars that the cells left and right of a face lose or gain
PACE, FROM, BURNED, WIDTH, OWN, CHANGES, PLAN = range(96, 103)
ROWS = 103

# columns of the table of fronts
FACE, KIND, SPEED_OF, DIRECTION, STRENGTH, LEAST, FAN = range(7)      # FAN: 1 where a self-similar fan lies on the right
KINDS = ("shock", "contact", "interface", "surface", "end", "fan head", "fan tail", "detonation", "elastic shock", "elastic expansion")
SHOCK, CONTACT, INTERFACE, SURFACE, END, HEAD, TAIL, DETONATION, ELASTIC_SHOCK, ELASTIC_EXPANSION = range(len(KINDS))

# numbers of a run that change: `State.numbers`
(TIME, STEP, LIMITING, CROWDED, STALLED, CYCLE, LINES, UPDATES, SAMPLED, PENDING, MEETS, RESOLUTION, STEEP_WAY, UNRESOLVED,
 UNSPLIT) = range(15)
# numbers that do not: `Rules.numbers`
(DIMENSION, COURANT, WEAKEST, LENGTH, STOP, BURNS, UNBURNED, MOST, ELASTIC, BURN_STEP, KINKED) = range(11)   # ELASTIC: 0 without solids
# traits of a region: `Rules.traits`
ZONES, GRIP, GAS, SHEAR, YIELDS, KINKS = range(6)

WALL, PRESSURE, VACUUM, OPEN = range(4)
OUTSIDE = {"wall": WALL, "pressure": PRESSURE, "vacuum": VACUUM, "open": OPEN}
EMPTY = -1
FEWER, MORE = 1.25, 0.8           # cells over those wanted beyond which they are merged and split
SLIVER = 0.2                      # of the mean of an interval: narrower cells are merged
TOUCHING = 1e-13                  # of the length: two fronts so close have met
COLD = 1e-10                      # c^2 over u^2 below which a negative square is rounding


class Grid(NamedTuple):
    """The arrays of `mesh.Mesh`."""

    x: Any
    q: Any
    region: Any
    marked: Any
    given: Any
    push: Any
    level: Any


class Rules(NamedTuple):
    """What stays the same in a run.

    passes (regions, 4)    addresses of the passes: states, wave, burning, pace; 0 where there is none
    words (regions,)       addresses of the laws' numbers
    limits (regions, 3)    highest densities: of the material, of reactants, of products
    traits (regions, 6)    zones; grip to the next region, Pa; 1 for a gas; of a solid 4/3 of its shear modulus (Pa, else 0) and the
                           largest |ln z| of its stretch; 1 for a law whose slopes at one state say little of its neighbours (kinks)
    ends (2, 5)            kind, shape of the drive, amplitude, start, duration
    times, values (2, n)   of drives given as tables
    numbers                see above
    """

    passes: Any
    words: Any
    limits: Any
    traits: Any
    ends: Any
    times: Any
    values: Any
    numbers: Any


class Work(NamedTuple):
    """Scratch: w (ROWS, room), pointers for passes, io (2, 24) for the waves of one front, trace (lines, TRACE) of the fronts' paths.

    flags (2, room)    1 where a front is to be released, and where a contact parts
    zones (5, zones)   of every zone of the problem the share of its region's mass left of its middle, and its extremes (extremes.NAMES);
                       owner (zones,) its region
    passed (2, nvar)   contents that have come in through the ends; numbers: see above; sums: one for each region, and the drives
    """

    w: Any
    pointers: Any
    io: Any
    trace: Any
    zones: Any
    owner: Any
    flags: Any
    passed: Any
    numbers: Any
    sums: Any


TRACE = 15            # time, front, position, strength, 5 numbers of both states, and the velocity jump
ROOM_OF_TRACE = 4096


def make_work(room: int, variables: int, regions: int, zones, owner) -> Work:
    """Scratch for that many cells."""
    return Work(np.zeros((ROWS, room)), np.zeros(40, dtype=np.int64), np.zeros((2, 24)), np.zeros((ROOM_OF_TRACE, TRACE)), zones, owner,
                np.zeros((2, room)), np.zeros((2, variables)), np.zeros(15), np.zeros(regions + 2))
