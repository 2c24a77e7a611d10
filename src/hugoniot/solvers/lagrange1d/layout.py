"""Where things stand in the solver's arrays: rows of the zone and node tables, slots of the control vectors, codes.

Zones of all bodies lie side by side in one table; a body (segment) k holds zones z0..z1-1 and nodes z0+k..z1+k, so the
number of a zone's left node is zone + segment. The velocity-gradient row has one ghost at each end of every segment:
zone z of segment k stands at z + 2k + 1.
"""

# -- rows of the zone table -------------------------------------------------------------------------------------
(MASS, INVERSE_MASS, RHO, E, P, Q, S1, S2, SIGMA, HOOP, C, PLASTIC_STRAIN, DAMAGE, SIGMA_HALF, HOOP_HALF, VISCOUS_SPEED,
 PLASTIC_WORK, VISCOUS_WORK, PEAK_STRESS, PEAK_TENSION, PEAK_PRESSURE, FAILURE, TAG, OLD, PEAK_DENSITY, VOIDS,
 COMPACTION) = range(27)
ZONE_ROWS = 27
# SIGMA = p + q - s1, the longitudinal stress in compression; HOOP = (d-1) V (s2 + q - s1)/(r1 + r2), the force of the hoop
# stress on each of the zone's nodes (`wilkins`: without q); the _HALF rows are their values in the middle of the step. TAG marks
# zones that a nearby void is relieving; VOIDS is the volume of voids grown in a zone per its mass (m3/kg); OLD is scratch of one
# sweep; COMPACTION is the history variable of an equation of state that remembers (0 for the others).

# -- further rows of the zone table of a run in which something burns (solvers.lagrange1d.reactive) ------------------------
(BURN_FRACTION, LIT_SINCE, ZONE_SIZE, RHO_R, E_R, RHO_P, E_P, MIX_STATUS, RESOLUTION, REFERENCE) = range(27, 37)
BURNING_ROWS = 37
# LIT_SINCE: time since the programmed front reached the zone, s (negative before); ZONE_SIZE its width at t = 0; RHO_R to E_P the
# phases of the step before (energies with the chemical one); MIX_STATUS why a mixture was not found, 0 if it was; RESOLUTION the
# fewest zones that held the length in which the zone burned; REFERENCE the code of the reactants' reference state
# (laws.mixture.reference_state; 0 in closures that have none).

# -- rows of the node table -------------------------------------------------------------------------------------
R, U, R_HALF, U_MEAN, NODE_MASS, INVERSE_NODE_MASS, BOND = range(7)
NODE_ROWS = 7
# BOND: tensile stress an interface carries, Pa (inf inside a body); U is at the whole step (compatible) or half a step
# behind (wilkins); U_MEAN the mean over the step.

# -- columns of the segment table (integers) ----------------------------------------------------------------------
SEG_FIRST, SEG_LAST, SEG_LEFT, SEG_RIGHT = range(4)          # zones first..last-1; boundary codes of the two ends
FREE, FIXED, VELOCITY, PRESSURE, TRANSMITTING = range(5)

# -- columns of the run table: a run is a stretch of zones of one material in one segment --------------------------
RUN_FIRST, RUN_LAST, RUN_SEGMENT, RUN_KIND, RUN_MATERIAL = range(5)

# -- control vector (floats) --------------------------------------------------------------------------------------
(TIME, DT, DT_OLD, DT_NATURAL, EVENT_TIME, RATE, WORK_LEFT, WORK_RIGHT, IMPULSE_LEFT, IMPULSE_RIGHT, RADIAL_IMPULSE, COURANT,
 GROWTH, DT_LARGEST, DT_SMALLEST, WORST_FAILURE, NEXT_GAUGE, GAUGE_INTERVAL, REFERENCE_LEFT, REFERENCE_RIGHT, HEAT_FLUX) = range(21)
CONTROL_FLOATS = 21

# -- what a sweep finds in one piece of a run, and the totals of a step -------------------------------------------------------------
(FOUND_RATE, FOUND_FAILURE, FOUND_IMPULSE, FOUND_CAPPED, FOUND_UNSOUND) = range(5)
FOUND_FLOATS = 5

# -- control vector (integers) ------------------------------------------------------------------------------------
CYCLE, GAUGE_ROWS, CULPRIT, ZONE_STEPS, CAP_COUNT, FRACTURING = range(6)
CONTROL_INTS = 6

# -- why the march came back ---------------------------------------------------------------------------------------
PAUSED, AT_EVENT, VOID_OPENS, VOID_CLOSES, BAD_STATE, BUFFER_FULL, STEP_COLLAPSED, INTERFACE_OPENS = range(8)

# -- fields of a gauge row -----------------------------------------------------------------------------------------
GAUGE_FIELDS = ("position", "velocity", "density", "energy", "pressure", "viscous_pressure", "deviator_radial", "deviator_hoop",
                "stress", "plastic_strain", "damage")
GAUGE_COMPACTION = len(GAUGE_FIELDS)
# further columns of a run in which something burns: the burn fraction at the gauge, the share of the second of the two zones it lies
# between, the code of the reference state of the nearer zone, and what a mixture's temperature is found from, for the first zone and for
# the second
PHASE_ROWS = (BURN_FRACTION, RHO_R, E_R, RHO_P, E_P)
GAUGE_BURN, GAUGE_SHARE, GAUGE_REFERENCE, GAUGE_PHASES = range(GAUGE_COMPACTION + 1, GAUGE_COMPACTION + 5)
BURNING_GAUGE_COLUMNS = GAUGE_PHASES + 2 * len(PHASE_ROWS)

PULSES = {"constant": 0, "table": 1, "exponential": 2, "half_sine": 3, "square": 4, "ramp": 5}
