"""Layout of the tables of contact.

A surface is a chain of boundary edges, each from point a to point b with the material on its left. A point is a node of a surface or a
vertex of a rigid body. A mover is anything that moves independently: each node of a surface, and each rigid body as a whole. A pair is a
point and an edge of another part of a surface that it may touch.
"""

from typing import Any, NamedTuple

import numpy as np

# node column; edges that end and start there (-1: none); the first of its pairs, after the last search
POINT_NODE, POINT_MOVER, POINT_PART, POINT_BEFORE, POINT_AFTER, POINT_FIRST = range(6)
# where a point is at the start of a step, and how far the velocity of its mover takes it in the step
AT_X, AT_Y, BY_X, BY_Y, HALF_X, HALF_Y = range(6)
# points; block, or number of blocks + rigid body; zone behind (-1: none), and the node columns of its other corners
EDGE_A, EDGE_B, EDGE_PART, EDGE_ZONE, EDGE_ACROSS_1, EDGE_ACROSS_2 = range(6)
# a column of the nodes; rigid body (-1: a node); chains that hold it; what drives it; 1 where it is in the list of
# the step, 2 if it is pushed too
MOVER_NODE, MOVER_RIGID, MOVER_CHAIN_1, MOVER_CHAIN_2, MOVER_PULSE, MOVER_LISTED = range(6)
# velocity with the rate of turning; inverse mass, the projector on the directions that nothing holds, of what turns the inverse moment of
# inertia; velocities before; impulse with its moment about the centre; the directions that hold it (unit, 0: none)
(U, V, W, IM, PXX, PXY, PYY, II, U0, V0, W0, JX, JY, JW, _, _, H1X, H1Y, H2X, H2Y) = range(20)
MOVER_FLOATS = 24
# of a rigid body: centre, angle; their velocity at the start of a step, and the mean one of the step
(CENTRE_X, CENTRE_Y, ANGLE, SPEED_X, SPEED_Y, SPIN, MEAN_X, MEAN_Y, MEAN_SPIN) = range(9)
BONDED, SLIDING, SEPARABLE = range(3)
LAW_KIND, LAW_FRICTION, LAW_STRENGTH, LAW_TIES = range(4)                      # ties: whether the point's side is the one that is tied
# point, edge; movers of the point and of the ends of the edge; the points at these ends
PAIR_POINT, PAIR_EDGE, PAIR_ACTIVE, PAIR_S, PAIR_A, PAIR_B, PAIR_FROM, PAIR_TO = range(8)
PAIR_INTS = 8
# of a pair that may meet: its number, its point, the points at the ends of its edge
NEAR_PAIR, NEAR_POINT, NEAR_FROM, NEAR_TO = range(4)
# impulse along the normal; normal; least normal velocity; the mass that the pair has along its normal, and its inverse; impulse before a
# sweep, direction of search;
# change of the velocities of its three movers by a unit impulse along its normal; share of the edge; 1 where it has friction or one of its
# movers turns;
# impulse along the tangent, its coefficient of friction, tangential aim, inverse mass, the gap where the impulses act over the length of
# the edge, impulse before a sweep, direction of search; 1 where the mover of the point turns, -1 where that of the edge does (0: neither);
# impulses of the last step; gap at the start of the step; where a mover turns: the way from its centre to where the impulse acts, and its
# change of rotation by a unit normal impulse
(LAMBDA, NX, NY, LEAST, MASS, WN, OLD, WAY,
 SX, SY, AX, AY, BX, BY, SHARE, MORE,
 TAU, COULOMB, AIM, WT, LIFT, OLD_TAU, WAY_TAU, SIDE,
 LAST, LAST_TAU, GAP, ARM_X, ARM_Y, TURN) = range(30)
PAIR_FLOATS = 32
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
# edge, the largest change of a velocity by contact in the last step
REACH, MEAN_EDGE, HEAT, FRICTION, DEEPEST, CHANGE = range(6)
PAIRS, SEARCHES, SWEEPS, BROKEN_BONDS, FULL, OLD_PAIRS, ACTIVE, STEPS = range(8)
# of a point at the last look at which pairs may meet: its place and velocity
FLIGHT_X, FLIGHT_Y, FLIGHT_U, FLIGHT_V = range(4)
# time since that look, how far points have gone astray from straight flight since, how far they may, how long the list then made serves
FLOWN, FARTHEST, ASTRAY, SERVES = range(4)
NEAR, LISTED, BONDS, TOUCHED, POINTS, PUSHED = range(6)      # sizes of the lists of a step; NEAR is -1 where they are to be made anew
LINE = 8             # floats of a line of cache
UNSIGNED = np.uint32      # numbers of points, movers and pairs: compiled code asks of every signed index whether it counts from the end


class Contact(NamedTuple):
    """Tables of the contact of a run; columns are above.

    rigid                  what moves rigid bodies, in the order of their movers
    held                   movers that a wall, the axis or a pulse holds, and rigid bodies
    copies_start, copies   node columns that are one with each mover's
    law_of                 (part, part): index of the law between them
    old_pairs, old_numbers   point and edge of the pairs that had impulses before the last search, and their numbers
    places                 (points and behind them centres of rigid bodies, columns AT_X to HALF_Y)
    flight, looked         (point, columns FLIGHT_X to FLIGHT_V), (numbers from FLOWN): of the list of near pairs
    near, listed, bound    the pairs that may meet in a step, in their order, the movers concerned, and the points with a bond that stands
    touched                those of the pairs that had an impulse in the last step
    near_points, marks     (point, mover) of the points concerned; whether each point is in that list
    sizes                  of these lists
    active, candidates     the pairs that are active, in their order, and those that may become so
    pushed                 the movers of active pairs and of bonds
    binds                  whether a law ties points to edges
    cells, sorted_edges, boxes   of the search: first edge of each cell, edges by cell, where points are within reach of these (x, y)
    since                  (point, 2): where points stood when their motion began to count: at the last search or later
    zones, nodes, chains   tables of the march
    kind, gx, gy           as `march.Options` has them
    speeds, speed_tables   pulses that drive rigid bodies, as `march.Run` has them
    """

    points: Any
    edges: Any
    movers: Any
    mover_numbers: Any
    rigid: Any
    held: Any
    copies_start: Any
    copies: Any
    law_of: Any
    laws: Any
    pairs: Any
    pair_numbers: Any
    old_pairs: Any
    old_numbers: Any
    places: Any
    near: Any
    listed: Any
    bound: Any
    touched: Any
    near_points: Any
    marks: Any
    sizes: Any
    active: Any
    candidates: Any
    pushed: Any
    bonds: Any
    bond_numbers: Any
    of_points: Any
    cells: Any
    sorted_edges: Any
    boxes: Any
    since: Any
    flight: Any
    looked: Any
    numbers: Any
    counts: Any
    zones: Any
    nodes: Any
    chains: Any
    kind: int
    gx: float
    gy: float
    binds: bool
    speeds: Any
    speed_tables: Any


def table(rows: int, columns: int) -> np.ndarray:
    """Zeros (rows, columns) of floats; the first row begins a line of cache."""
    buffer = np.zeros(rows * columns + LINE)
    start = (-buffer.ctypes.data // buffer.itemsize) % LINE
    return buffer[start:start + rows * columns].reshape(rows, columns)


KEPT = ("points", "pairs", "pair_numbers", "bonds", "bond_numbers", "rigid", "of_points", "since", "numbers", "counts")    # in checkpoints
