"""Where things stand in the solver's arrays: rows of the node, zone and scratch tables, columns of the piece table, control slots, codes.

Nodes of all blocks lie side by side in one table, block by block, row by row (the second logical direction fastest); zones likewise.
Zone (i, j) of a block has the corners 0 (i, j), 1 (i+1, j), 2 (i+1, j+1), 3 (i, j+1), counter-clockwise. In axisymmetric flow x is the
radius and y the axial coordinate, and everything is per radian; otherwise per metre of depth.
"""

from typing import Any, NamedTuple

from hugoniot.zones.soundness import FOUND_FLOATS


class Nodes(NamedTuple):
    """Fields of nodes. The mean velocity (um, vm) moves a node through a step; (xh, yh) is where forces act."""

    x: Any
    y: Any
    u: Any
    v: Any
    xh: Any
    yh: Any
    um: Any
    vm: Any
    fx: Any          # force in the middle of the step
    fy: Any
    gx: Any          # force at its start, kept for a step that is repeated
    gy: Any
    im: Any          # inverse mass
    own: Any         # mass, divided among the copies of a node that blocks share


class Zones(NamedTuple):
    """Fields of zones. Deviators are positive in tension, viscous stress and pressure in compression, Pa."""

    mass: Any
    inverse_mass: Any
    rho: Any                 # of solid and voids
    e: Any
    p: Any
    q: Any                   # trace of the viscous stress
    sxx: Any
    syy: Any
    sxy: Any
    qxx: Any                 # mean viscous stress of the last step
    qyy: Any
    qxy: Any
    qhoop: Any
    nxx: Any                 # the same of a step that may yet have to be repeated
    nyy: Any
    nxy: Any
    nhoop: Any
    filter_power: Any        # W/kg that the viscous filter took in the middle of the step
    c: Any                   # longitudinal sound speed; -1 where it is imaginary
    viscous_speed: Any
    sigma: Any               # the principal stress of largest size, compression positive, viscosity included
    plastic_strain: Any
    damage: Any
    failure: Any
    voids: Any               # volume of voids per mass, m3/kg
    compaction: Any
    plastic_work: Any        # J/kg
    viscous_work: Any
    filter_work: Any
    t0: Any                  # triangles at corners 0 and 1 over the zone's area, at t = 0
    t1: Any
    peak_stress: Any
    peak_tension: Any
    peak_pressure: Any
    peak_density: Any
    f0x: Any                 # force on each corner
    f0y: Any
    f1x: Any
    f1y: Any
    f2x: Any
    f2y: Any
    f3x: Any
    f3y: Any


class Charge(NamedTuple):
    """Further fields of zones, in runs in which something burns. Energies hold the chemical one."""

    lam: Any                 # burn fraction
    since: Any               # time since the programmed front reached the zone, s (negative before)
    size: Any                # width at t = 0, m
    rho_r: Any               # reactants and products
    e_r: Any
    rho_p: Any
    e_p: Any
    status: Any              # why a mixture was not found, 0 if it was
    resolution: Any          # fewest zones that held the length in which the zone burned
    reference: Any           # code of the reactants' reference state (laws.mixture.reference_state)
    lam_half: Any            # scratch of a step: burn fraction, density, pressure, and viscous heat in its middle
    rho_half: Any
    p_half: Any
    heat: Any


class Points(NamedTuple):
    """Positions and velocities of one row of nodes, at whatever time."""

    x: Any
    y: Any
    u: Any
    v: Any


class Corners(NamedTuple):
    """Forces of zones on their four corners."""

    f0x: Any
    f0y: Any
    f1x: Any
    f1y: Any
    f2x: Any
    f2y: Any
    f3x: Any
    f3y: Any


class Work(NamedTuple):
    """Scratch of one piece of zones, a table for each thread: what `zones` passes read and write."""

    v: Any                   # specific volume of solid and voids
    rho: Any
    solid: Any               # density and specific volume of the solid, where voids have grown
    solid_v: Any
    e: Any
    p: Any
    c2: Any
    rate: Any                # equivalent strain rate, 1/s
    temperature: Any
    shear: Any
    t1: Any                  # largest principal deviator, at which a material tears
    txx: Any                 # deviators after the step
    tyy: Any
    txy: Any
    equivalent: Any
    limit: Any
    flow: Any
    rest: Any
    grown: Any
    relief: Any
    shocked: Any             # 1 where a shock is passing
    lam: Any
    heat: Any                # viscous heat, J/kg
    rho_r: Any
    e_r: Any
    rho_p: Any
    e_p: Any
    status: Any
    p_e: Any
    pace: Any
    power: Any               # that the corner forces put into a zone, W
    stiffness: Any           # rho c^2, Pa
    inverse_length: Any      # longest edge over area, 1/m
    zero: Any


class Shape(NamedTuple):
    """What geometry finds for a piece: volume, area, corner triangles, gradient and hoop coefficients, weights of planar forces.

    The mean of a gradient over the zone is sum(b_k u_k) / volume, of u/r sum(h_k u_k) / volume, and the force of a stress is its
    transpose. t0, t1: areas of the triangles at corners 0 and 1 (those at 2 and 3 are the area less them).
    """

    volume: Any
    area: Any
    t0: Any
    t1: Any
    b0x: Any
    b0y: Any
    b1x: Any
    b1y: Any
    b2x: Any
    b2y: Any
    b3x: Any
    b3y: Any
    h0: Any
    h1: Any
    h2: Any
    h3: Any
    w0: Any
    w1: Any
    w2: Any
    w3: Any


class Rates(NamedTuple):
    """Velocity gradient of a piece, 1/s: strain rates, spin (dv/dx - du/dy)/2, hoop rate, volume rate over volume."""

    xx: Any
    yy: Any
    xy: Any
    spin: Any
    hoop: Any
    dilation: Any


class Stress(NamedTuple):
    """Stress of a piece as the forces see it, Pa: tension positive, viscosity included."""

    xx: Any
    yy: Any
    xy: Any
    hoop: Any


class Vector(NamedTuple):
    """A vector for each zone or node."""

    x: Any
    y: Any


class Tensor(NamedTuple):
    """A symmetric tensor for each zone."""

    xx: Any
    yy: Any
    xy: Any


class Smoothness(NamedTuple):
    """psi along the second (xi) and the first (eta) logical direction, and the strain rates at the start of the step, 1/s."""

    xi: Any
    eta: Any
    xx: Any
    yy: Any
    xy: Any


class Metric(NamedTuple):
    """Mean edges of each zone along the second (xi) and the first (eta) logical direction, as tensors e (x) e, m^2."""

    xixx: Any
    xiyy: Any
    xixy: Any
    etaxx: Any
    etayy: Any
    etaxy: Any


class Closing(NamedTuple):
    """Velocity jumps (<= 0) and smoothness of the two principal directions of a corner; n (x) n = (1 -+ m)/2."""

    du1: Any
    psi1: Any
    du2: Any
    psi2: Any
    mxx: Any
    mxy: Any
    apart: Any               # part of the viscosity along principal directions, the rest is along the edges of a slender zone


PIECE = 192          # zones of a piece: its scratch rows stay in the first two levels of cache

# -- first rows of the parts of a thread's scratch table ---------------------------------------------------------------------
WORK = 0
SHAPE = WORK + len(Work._fields)
RATES = SHAPE + len(Shape._fields)
STRESS = RATES + len(Rates._fields)
SMOOTH = STRESS + len(Stress._fields)
METRIC = SMOOTH + len(Smoothness._fields)
CLOSING = METRIC + len(Metric._fields)
SPEEDS = CLOSING + len(Closing._fields)      # viscous speeds of the two directions
CORNERS = SPEEDS + 2                         # viscous stress of the four corners
ALONG = CORNERS + 12                         # viscous stress along the mean edges
EXTRA = ALONG + 3                            # half the subzonal pressure of the four corners
GRADIENTS = EXTRA + 4                        # velocity differences per length: along rows, and across them before, here and behind
SCRATCH_ROWS = GRADIENTS + 8
SCRATCH_WIDTH = PIECE + 8                    # gradients along a row reach over both its ends

# -- columns of the piece table (integers): a piece is whole rows of zones of a block, or a part of one -----------------------
(P_ZONE, P_NODE, P_ROWS, P_COUNT, P_STRIDE, P_FIRST_ROW, P_LAST_ROW, P_FIRST, P_LAST, P_RECIPE, P_BLOCK, P_LEFT, P_RIGHT, P_BOTTOM,
 P_TOP) = range(15)
# first zone, node at its corner 0, rows, zones of each row, nodes of a row of the block, whether its first and last row and its first
# and last column are edges of the block, recipe, block, rows of the table of what lies beyond these edges

# -- columns of the line table (integers): a row of nodes of a block --------------------------------------------------------------
(N_NODE, N_COUNT, N_BEFORE, N_BEHIND) = range(4)      # first node, nodes, first zone of the rows of zones before and behind, or -1

# -- control vector (floats) --------------------------------------------------------------------------------------
(TIME, DT, DT_NATURAL, EVENT_TIME, RATE, COURANT, GROWTH, DT_LARGEST, DT_SMALLEST, WORST_FAILURE, NEAR_AXIS, GRAVITY_X, GRAVITY_Y,
 GRAVITY_WORK, NEXT_GAUGE, GAUGE_INTERVAL) = range(16)
CONTROL_FLOATS = 16

# -- control vector (integers) ------------------------------------------------------------------------------------
CYCLE, GAUGE_ROWS, CULPRIT, ZONE_STEPS, CAP_COUNT, REPEATED = range(6)
CONTROL_INTS = 6

FOUND_TANGLED = FOUND_FLOATS      # column of the table of findings behind those of `zones.soundness`: volumes that are not positive
FOUND_COLUMNS = FOUND_FLOATS + 1

# -- why the march came back ---------------------------------------------------------------------------------------
PAUSED, AT_EVENT, BAD_STATE, STEP_COLLAPSED, TANGLED, GAUGE_DUE = range(6)

# -- boundaries -------------------------------------------------------------------------------------------------------
CHAIN_WORK, CHAIN_IMPULSE_X, CHAIN_IMPULSE_Y = range(3)                     # columns of the table of chains
(LOAD_A, LOAD_B, LOAD_ZONE, LOAD_CHAIN, LOAD_PULSE, LOAD_OUTWARD) = range(6)  # integer columns of the table of loaded edges
(HOLD_NODE, HOLD_CHAIN_1, HOLD_PULSE_1, HOLD_CHAIN_2, HOLD_PULSE_2, HOLD_BOOKED) = range(6)   # and of held nodes; chain 2 may be -1
