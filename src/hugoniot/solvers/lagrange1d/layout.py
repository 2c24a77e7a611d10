"""Layout of the solver's arrays: rows of the tables, slots of the control vectors, codes.

The zones of all bodies are stored contiguously in one table; body (segment) k has zones z0..z1-1 and nodes z0+k..z1+k, so the
number of a zone's left node is zone + segment. The velocity-gradient row has one ghost at each end of every segment:
zone z of segment k is at z + 2k + 1.
"""

from typing import Any, NamedTuple


# -- rows of the tables: one array or row each, in the order of the table ------------------------------------------------------
class ZoneRows(NamedTuple):
    """Fields of zones. Stresses in Pa, sigma in compression positive, deviators in tension."""

    mass: Any                # kg per m2, per m and radian, or per steradian
    inverse_mass: Any
    rho: Any                 # of solid and voids
    e: Any
    p: Any
    q: Any                   # artificial viscous pressure
    s1: Any                  # deviator along the motion
    s2: Any                  # hoop deviator
    sigma: Any               # p + q - s1
    hoop: Any                # (d-1) V (s2 + q - s1)/(r1 + r2): force of the hoop stress on each node of the zone
    sigma_half: Any          # in the middle of the step (compatible)
    hoop_half: Any
    c: Any                   # longitudinal sound speed; -1 where it is imaginary
    viscous_speed: Any
    plastic_strain: Any
    damage: Any
    failure: Any             # 1 where the zone fails
    voids: Any               # volume of voids per mass, m3/kg
    grown: Any               # its growth in the last step in which there were any, m3/kg
    compaction: Any          # history variable of an equation of state that remembers
    plastic_work: Any        # J/kg
    viscous_work: Any
    face_flux: Any           # artificial heat through the right face in the step, J
    v: Any                   # specific volume at n (wilkins)
    pull: Any                # (s1 - s2)/(rho r): what the hoop stress adds to acceleration, per hoop direction, m/s2 (wilkins)
    width: Any               # rho dr, kg/m2 (wilkins)
    peak_stress: Any
    peak_tension: Any
    peak_pressure: Any
    peak_density: Any
    relieved: Any            # 1 where a nearby void is relieving the zone


class ChargeRows(NamedTuple):
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


class NodeRows(NamedTuple):
    """Fields of nodes; u is at the whole step (compatible) or half a step behind (wilkins)."""

    r: Any
    u: Any
    r_half: Any
    u_mean: Any
    mass: Any
    inverse_mass: Any
    bond: Any                # tensile stress an interface carries, Pa (NO_LIMIT inside a body)


class WorkRows(NamedTuple):
    """Scratch of one piece of zones, one table for each thread.

    `grown` is the field, and in the leapfrog's lists v, t1 and t2 are the fields v, s1 and s2.
    """

    v: Any                   # specific volume of solid and voids
    rho: Any
    solid: Any               # density and specific volume of the solid, where voids have grown
    solid_v: Any
    e: Any
    p: Any
    c2: Any
    dv: Any
    v_half: Any
    radial: Any              # strains of the step
    hoop: Any
    dilation: Any
    smooth: Any
    speed: Any
    printed: Any             # b of `leapfrog_passes.signal_squared`
    q: Any                   # the viscous pressure that moved the nodes (leapfrog, of what burns)
    temperature: Any
    shear: Any
    t1: Any
    t2: Any
    limit: Any
    flow: Any
    rest: Any
    relief: Any
    grown: Any
    given: Any               # energy that others than the pressure give in a step
    target: Any              # energy before the pressure at the end of the step has worked
    shocked: Any             # 1 where a shock is passing
    inverse_width: Any
    lam: Any
    heat: Any
    rho_r: Any
    e_r: Any
    rho_p: Any
    e_p: Any
    status: Any
    p_e: Any
    pace: Any
    zero: Any


PIECE = 128      # zones of a piece: what its passes touch stays in the first-level cache
LONGEST_AHEAD = 2.0     # steps over which the acceleration of the last one counts for the next: after a short step to an event

# -- columns of the segment table (integers) ----------------------------------------------------------------------
SEG_FIRST, SEG_LAST, SEG_LEFT, SEG_RIGHT = range(4)          # zones first..last-1; boundary codes of the two ends
FREE, FIXED, VELOCITY, PRESSURE, TRANSMITTING, PERIODIC = range(6)

# -- control vector (floats) --------------------------------------------------------------------------------------
(TIME, DT, DT_OLD, DT_NATURAL, EVENT_TIME, RATE, WORK_LEFT, WORK_RIGHT, IMPULSE_LEFT, IMPULSE_RIGHT, RADIAL_IMPULSE, COURANT,
 GROWTH, DT_LARGEST, DT_SMALLEST, WORST_FAILURE, NEXT_GAUGE, GAUGE_INTERVAL, HEAT_FLUX, FORCE_WORK, FORCE_IMPULSE, SUPPLIED,
 LAST_NODE, UNTIL, LOST_IMPULSE, END_LEFT) = range(26)
# what a transmitting end knows (`transmitting`), from END_LEFT and from END_RIGHT on: the stress outside and that at t = 0 (Pa), impedance
# (kg/m2/s), transit times of its zone in the last step, zones of the end's material (at most REACH), lead and excess (Pa); of the strongest
# shock that passed: its viscous pressure (Pa), its impedance and that of small waves behind it on the Hugoniot (kg/m2/s), the time since
# (s), what is left of it beyond the end (Pa); bulk impedance at t = 0 (0 in fluids), time to the end of the run (s), stress before (Pa),
# the echo that is missing (Pa); a memory
(OUTSIDE, AMBIENT, IMPEDANCE, PASSED, ZONES, LEAD, EXCESS, LARGEST, SHOCK, BEHIND, SINCE, REST, BULK, REMAINING, BEFORE, MISSING,
 MEMORY) = range(17)
REACH, REMEMBERED = 6, 4          # zones from the end on; numbers kept of each
END_FLOATS = MEMORY + REMEMBERED * REACH
END_RIGHT = END_LEFT + END_FLOATS
CONTROL_FLOATS = END_RIGHT + END_FLOATS

# -- control vector (integers) ------------------------------------------------------------------------------------
CYCLE, GAUGE_ROWS, CULPRIT, ZONE_STEPS, CAP_COUNT, FRACTURING, STOP, PASSED_TIMES = range(8)
CONTROL_INTS = 8

# -- columns of the table of times that a march passes without coming back: the time, and what was found there ------
PASS_TIME, PASS_VELOCITY, PASS_STRESS, PASS_RIGHT = range(4)   # largest sizes of velocity and stress; velocity of the right end
PASS_FLOATS = 4

# -- why the march came back ---------------------------------------------------------------------------------------
PAUSED, AT_EVENT, VOID_OPENS, VOID_CLOSES, BAD_STATE, BUFFER_FULL, STEP_COLLAPSED, INTERFACE_OPENS = range(8)

PULSES = {"constant": 0, "table": 1, "exponential": 2, "half_sine": 3, "square": 4, "ramp": 5}

# a row's place in its table: zones[Z.rho] is a row of densities
Z, B, H = (cls(*range(len(cls._fields))) for cls in (ZoneRows, ChargeRows, NodeRows))

# -- fields of a gauge row: further columns where something burns ------------------------------------------------------------------
GAUGE_ROWS_OF_ZONES = (Z.rho, Z.e, Z.p, Z.q, Z.s1, Z.s2, Z.sigma, Z.plastic_strain, Z.damage, Z.compaction,
                       Z.voids)
GAUGE_FIELDS = ("position", "velocity", "density", "energy", "pressure", "viscous_pressure", "deviator_radial", "deviator_hoop",
                "stress", "plastic_strain", "damage", "compaction", "void_fraction")
GAUGE_STRESS = GAUGE_FIELDS.index("stress")
# the burn fraction at the gauge, the share of the second of the two zones it lies between, the code of the reference state of the nearer
# zone, and what a mixture's temperature is found from, for the first zone and for the second
PHASE_ROWS = (B.lam, B.rho_r, B.e_r, B.rho_p, B.e_p)
GAUGE_BURN, GAUGE_SHARE, GAUGE_REFERENCE, GAUGE_PHASES = range(len(GAUGE_FIELDS), len(GAUGE_FIELDS) + 4)
BURNING_GAUGE_COLUMNS = GAUGE_PHASES + 2 * len(PHASE_ROWS)
