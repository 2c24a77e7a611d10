"""Layout of the solver's arrays: rows of the node, zone and scratch tables, columns of the piece table, control slots, codes.

The nodes of all blocks are stored in one table, block by block, row by row (the second logical direction fastest); zones likewise.
Zone (i, j) of a block has the corners 0 (i, j), 1 (i+1, j), 2 (i+1, j+1), 3 (i, j+1), counter-clockwise; of triangles this is a cell,
divided as described in `mesh.triangles`, in whose rows the lower triangles precede the upper ones. In axisymmetric flow x is the
radius and y the axial coordinate, and everything is per radian; otherwise per metre of depth.
"""

from typing import Any, NamedTuple

from hugoniot.zones.constants import Constants
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
    du: Any          # half of the change of velocity in the last step
    dv: Any
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
    qxx: Any                 # mean viscous stress of the last step; none before a step is repeated
    qyy: Any
    qxy: Any
    qhoop: Any
    c: Any                   # longitudinal sound speed; -1 where it is imaginary
    viscous_speed: Any
    sigma: Any               # the principal stress of largest size, compression positive, without viscosity
    plastic_strain: Any
    damage: Any
    failure: Any
    voids: Any               # volume of voids per mass, m3/kg
    compaction: Any
    plastic_work: Any        # J/kg
    viscous_work: Any
    t0: Any                  # triangles at corners 0 and 1 over the zone's area, at t = 0
    t1: Any
    peak_stress: Any
    peak_tension: Any
    peak_pressure: Any
    peak_density: Any


class Forces(NamedTuple):
    """Force of zones on each corner; power (W) that the viscous filter takes. No other step needs them."""

    f0x: Any
    f0y: Any
    f1x: Any
    f1y: Any
    f2x: Any
    f2y: Any
    f3x: Any
    f3y: Any
    filter_power: Any


class OfTriangles(NamedTuple):
    """Further fields of zones, in runs with triangles."""

    way: Any                 # 1 where the diagonal of the cell runs from its corner 0 to 2, 0 where from 1 to 3
    back: Any                # 1 less this
    p_half: Any              # pressure and deviators in the middle of a step, where its work is divided anew in a cell
    sxx: Any
    syy: Any
    sxy: Any


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


class Positions(NamedTuple):
    """Positions of one row of nodes."""

    x: Any
    y: Any


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


class Sides(NamedTuple):
    """Corners of a row of quadrilaterals: the rows of nodes on both its sides."""

    low: Points
    high: Points


class SidesNow(NamedTuple):
    """The same without velocities."""

    low: Positions
    high: Positions


class Vertices(NamedTuple):
    """Corners of a row of triangles, counter-clockwise: a and b end the side that is a side of its cell along i, c is the third."""

    a: Points
    b: Points
    c: Points


class VerticesNow(NamedTuple):
    """The same without velocities."""

    a: Positions
    b: Positions
    c: Positions


class VertexForces(NamedTuple):
    """Forces of triangles on their corners."""

    f0x: Any
    f0y: Any
    f1x: Any
    f1y: Any
    f2x: Any
    f2y: Any


class Work(NamedTuple):
    """Scratch of one piece of zones, a table for each thread: what `zones` passes read and write."""

    v: Any                   # specific volume of solid and voids
    rho: Any
    solid: Any               # density and specific volume of the solid, where voids have grown
    solid_v: Any
    e: Any
    p: Any
    c2: Any
    rate: Any                # of closing, 1/s
    temperature: Any
    shear: Any
    t1: Any                  # largest principal deviator, at which a material tears
    limit: Any
    flow: Any
    rest: Any
    relief: Any
    grown: Any
    sigma: Any               # where it is not kept (`shown`)
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
    inverse_length: Any      # longest edge over area, 1/m
    closes: Any              # 1 at the first zone of a stretch in which something closes (`closing`)
    zero: Any


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
    """psi along the second (xi) and the first (eta) logical direction, each times its part of the square of the velocity gradient; the
    part of xi; the strain rates at the start of the step, 1/s."""

    xi: Any
    eta: Any
    share: Any
    xx: Any
    yy: Any
    xy: Any


PIECE = 256          # zones of a piece: its scratch rows stay in the second level of cache, and a row of the mesh is rarely cut

# -- scratch of a member: rows of Work, Tensor (deviators found), Rates, Smoothness, Corners (viscous forces), Points (of triangles) ------
NEW = len(Work._fields)
RATES = NEW + len(Tensor._fields)
SMOOTH = RATES + len(Rates._fields)
REST = SMOOTH + len(Smoothness._fields)
THIRD = REST + len(Corners._fields)
SCRATCH_ROWS = THIRD + len(Points._fields)

# -- numbers of a material behind its constants: radius that stands for the axis, coefficient of its filter -----------------------------
NEAR, FILTER = len(Constants._fields), len(Constants._fields) + 1

# -- control vector (floats) --------------------------------------------------------------------------------------
(TIME, DT, DT_NATURAL, EVENT_TIME, RATE, COURANT, GROWTH, DT_LARGEST, DT_SMALLEST, WORST_FAILURE, GRAVITY_WORK, NEXT_GAUGE,
 GAUGE_INTERVAL, FILTER_WORK) = range(14)
CONTROL_FLOATS = 14

# -- control vector (integers) ------------------------------------------------------------------------------------
CYCLE, ZONES, ZONE_STEPS, CAP_COUNT, REPEATED = range(5)
LEFT_RANGE, TRIES, LAST_TRIED = range(5, 8)      # steps repeated because they left the range of a law; `rewind`
CONTROL_INTS = 8

# columns of the table of findings behind those of `zones.soundness`: volumes that are not positive, power that the viscous filter takes (W)
FOUND_TANGLED, FOUND_FILTER = FOUND_FLOATS, FOUND_FLOATS + 1
FOUND_COLUMNS = FOUND_FLOATS + 2

# -- why the march came back ---------------------------------------------------------------------------------------
PAUSED, AT_EVENT, BAD_STATE, STEP_COLLAPSED, TANGLED, GAUGE_DUE, NO_ROOM, LED_ON = range(8)

# -- boundaries -------------------------------------------------------------------------------------------------------
CHAIN_WORK, CHAIN_IMPULSE_X, CHAIN_IMPULSE_Y = range(3)                     # columns of the table of chains
(LOAD_A, LOAD_B, LOAD_ZONE, LOAD_CHAIN, LOAD_PULSE, LOAD_OUTWARD) = range(6)  # integer columns of the table of loaded edges
# transmitting edges: nodes, zone, step to the next zone inward, zones, -1 or 1; of both nodes the first row and the number of rows in the
# table of gates; row of its cell beyond in the table of ghosts (-1: none)
(OPEN_A, OPEN_B, OPEN_ZONE, OPEN_INWARD, OPEN_COUNT, OPEN_OUTWARD, OPEN_GATE_A, _, OPEN_GATE_B, _, OPEN_GHOST) = range(11)
(HOLD_NODE, HOLD_CHAIN_1, HOLD_PULSE_1, HOLD_CHAIN_2, HOLD_PULSE_2, HOLD_BOOKED) = range(6)   # and of held nodes; chain 2 may be -1
