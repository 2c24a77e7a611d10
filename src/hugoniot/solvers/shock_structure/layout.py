"""Names of the rows and numbers that the sweeps and the solver share."""

RHO, J, E = 0, 1, 2                     # conserved: density, momentum density, total energy density
GHOSTS = 3

# control, floats
TIME, DT, COURANT, EVENT_TIME, DT_LARGEST, ADVECTIVE, DIFFUSIVE = range(7)
CONTROL_FLOATS = 7
# counters, integers
CYCLE, CULPRIT, LIMITING, FALLBACKS, ROUGH = range(5)
CONTROL_INTS = 5

ROUGH_STEPS = 40                        # cycles taken to low order after one that high order could not take
RETRIES = 12                            # halvings of a step that fails

# how `march` ended
RUNNING, BAD_STATE = 0, 1

# ends
TRANSMITTING, WALL = 0, 1
END_KINDS = {"transmitting": TRANSMITTING, "fixed": WALL}
