"""Where the numbers of contact stand: columns of its tables, and the tables themselves.

A surface is a chain of boundary edges, each from point a to point b with the material on its left. A point is a node of a surface or a
vertex of a rigid body. What moves independently is a mover: each node of a surface, and each rigid body as a whole. A pair is a point and
an edge of another stretch of surface that it may meet.
"""

from typing import Any, NamedTuple

# node column; edges that end and start there (-1: none); the first of its pairs, after the last search
POINT_NODE, POINT_MOVER, POINT_PART, POINT_BEFORE, POINT_AFTER, POINT_FIRST = range(6)
# points; block, or number of blocks + rigid body; zone behind (-1: none)
EDGE_A, EDGE_B, EDGE_PART, EDGE_ZONE = range(4)
# a column of the nodes; rigid body (-1: a node); chains that hold it; what drives it; 1 where it is in the list of the step
MOVER_NODE, MOVER_RIGID, MOVER_CHAIN_1, MOVER_CHAIN_2, MOVER_PULSE, MOVER_LISTED = range(6)
# inverse mass, of what turns the inverse moment of inertia; the directions that hold it (unit, 0: none) and the projector on what they
# leave; velocity with the rate of turning, those before; impulse with its moment about the centre
(IM, II, H1X, H1Y, H2X, H2Y, PXX, PXY, PYY, U, V, W, U0, V0, W0, JX, JY, JW) = range(18)
MOVER_FLOATS = 18
# of a rigid body: centre, angle; their velocity at the start of a step, and the mean one of the step
(CENTRE_X, CENTRE_Y, ANGLE, SPEED_X, SPEED_Y, SPIN, MEAN_X, MEAN_Y, MEAN_SPIN) = range(9)
BONDED, SLIDING, SEPARABLE = range(3)
LAW_KIND, LAW_FRICTION, LAW_STRENGTH, LAW_TIES = range(4)                      # ties: whether the point's side is the one that is tied
# point, edge; movers of the point and of the ends of the edge, and their columns of the nodes
PAIR_POINT, PAIR_EDGE, PAIR_ACTIVE, PAIR_S, PAIR_A, PAIR_B, PAIR_AT, PAIR_AT_A, PAIR_AT_B = range(9)
PAIR_INTS = 9
# impulses along the normal and the tangent; share of the edge; normal; least normal velocity, tangential aim; inverse masses; gap at the
# start of the step; impulses of the last step; of a relaxation: impulses before a sweep, direction of search; coefficient of friction;
# change of the velocities of its three movers by a unit impulse along its normal; where one of them turns: 1 for that of the point, -1
# of the edge (0: neither), the way from its centre to where the impulse acts, and its change of rotation by a unit normal impulse;
# the mass that the pair has along its normal; how far points may move relative to each other after the search before it can meet;
# the gap where the impulses act, over the length of the edge
(LAMBDA, TAU, SHARE, NX, NY, LEAST, AIM, WN, WT, GAP, LAST, LAST_TAU, OLD, OLD_TAU, WAY, WAY_TAU, COULOMB, SX, SY, AX, AY,
 BX, BY, SIDE, ARM_X, ARM_Y, TURN, MASS, AWAY, LIFT) = range(30)
PAIR_FLOATS = 30
OFF, ON, FRESH = range(3)      # PAIR_ACTIVE
FREE, BOUND, BROKEN = range(3)
BOND_STATE, BOND_EDGE = range(2)
# share of the edge; impulse; velocity aimed at; impulse before a sweep, direction of search, inverse masses, impulse of the last step;
# as of pairs, what turns
(BOND_SHARE, BOND_X, BOND_Y, BOND_AIM_X, BOND_AIM_Y, BOND_OLD_X, BOND_OLD_Y, BOND_WAY_X, BOND_WAY_Y, BOND_WX, BOND_WY, BOND_LAST_X,
 BOND_LAST_Y, BOND_SIDE, BOND_ARM_X, BOND_ARM_Y) = range(16)
BOND_FLOATS = 16
# of a point: force of the last step, distance slid
FORCE_X, FORCE_Y, SLID = range(3)
# numbers: reach of the search, mean edge, heat of closing, work of friction, deepest place of a node behind a surface over the
# edge, the last step, the largest change of a velocity by contact in it
REACH, MEAN_EDGE, HEAT, FRICTION, DEEPEST, LAST_STEP, CHANGE = range(7)
PAIRS, SEARCHES, SWEEPS, BROKEN_BONDS, FULL, OLD_PAIRS, ACTIVE = range(7)
NEAR, LISTED, BONDS = range(3)  # sizes of the lists of a step


class Contact(NamedTuple):
    """Tables of the contact of a run; columns are above.

    rigid                  what moves rigid bodies, in the order of their movers
    copies_start, copies   node columns that are one with each mover's
    law_of                 (part, part): index of the law between them
    old_pairs, old_numbers   the pairs before the last search
    near, listed, bound    the pairs that may meet in a step, in their order, the movers concerned, and the points with a bond that stands;
                           `sizes` of the three
    active                 the pairs that are active, in their order
    cells, sorted_edges    of the search: first edge of each cell, edges by cell
    since                  (point, 2): where points stood at the last search
    zones                  table of zones, for the heat
    speeds                 pulses that drive rigid bodies, as `march.Run` has them: numbers and tables
    """

    points: Any
    edges: Any
    movers: Any
    mover_numbers: Any
    rigid: Any
    copies_start: Any
    copies: Any
    law_of: Any
    laws: Any
    pairs: Any
    pair_numbers: Any
    old_pairs: Any
    old_numbers: Any
    near: Any
    listed: Any
    bound: Any
    sizes: Any
    active: Any
    bonds: Any
    bond_numbers: Any
    of_points: Any
    cells: Any
    sorted_edges: Any
    since: Any
    numbers: Any
    counts: Any
    zones: Any
    speeds: Any
    speed_tables: Any


class Nowhere(NamedTuple):
    """No contact in this run."""

    none: int = 0


KEPT = ("points", "pairs", "pair_numbers", "bonds", "bond_numbers", "rigid", "of_points", "since", "numbers", "counts")    # in checkpoints
