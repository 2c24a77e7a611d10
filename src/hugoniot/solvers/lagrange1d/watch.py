"""What is looked at after every step: soundness, failing zones, interfaces, gaps, gauges."""

import math

import numba as nb
import numpy as np

from hugoniot.core.compile import GUARD
from hugoniot.solvers.lagrange1d import layout as L
from hugoniot.solvers.lagrange1d.constitutive import hoop_deviator

RELIEVED = 0.02       # a zone below this fraction of its failure limit is out of the tension that opened a void
VOIDED = 1e-3         # void fraction from which a zone belongs to an older spall plane and opens none of its own
CHATTER = 1e-4        # tension, in units of rho c^2, a strengthless interface bears: the noise a release leaves (Herrmann A.7)
LIMIT = 1e12          # density (kg/m3) or sound speed (m/s) beyond which a state is no physics
LIMIT_BITS = np.float64(LIMIT).view(np.uint64)
STRESS_SCALE = 1e-18   # so that the same limit serves stresses: 1e30 Pa
TOUCHING = 1e-6       # gap, in units of the neighbouring zones, that counts as closed


@nb.njit(**GUARD)
def look_over(zones, first, last):
    """How many zones have a density that is not positive or a sound speed that is no finite number; records the peaks on the way."""
    rho, c, sigma, p = zones[L.RHO, first:last], zones[L.C, first:last], zones[L.SIGMA, first:last], zones[L.P, first:last]
    most, least = zones[L.PEAK_STRESS, first:last], zones[L.PEAK_TENSION, first:last]
    highest, densest = zones[L.PEAK_PRESSURE, first:last], zones[L.PEAK_DENSITY, first:last]
    bad = 0
    for j in range(last - first):
        # a negative number, an infinity and what is no number have larger bits than any finite positive one: one comparison does
        # for the three, where a compiled comparison of numbers costs as much as a store
        bits = np.float64(rho[j]).view(np.uint64)
        of_speed, of_stress = np.float64(c[j]).view(np.uint64), np.float64(abs(sigma[j]) * STRESS_SCALE).view(np.uint64)
        bits = of_speed if of_speed > bits else bits
        bits = of_stress if of_stress > bits else bits
        bad += 0 if bits < LIMIT_BITS else 1
        most[j] = sigma[j] if sigma[j] > most[j] else most[j]
        least[j] = sigma[j] if sigma[j] < least[j] else least[j]
        highest[j] = p[j] if p[j] > highest[j] else highest[j]
        densest[j] = rho[j] if rho[j] > densest[j] else densest[j]
    return bad


@nb.njit(**GUARD)
def first_unsound(zones, count):
    """First of the zones `look_over` counts."""
    for j in range(count):
        if not (0.0 <= zones[L.RHO, j] < LIMIT and 0.0 <= zones[L.C, j] < LIMIT and abs(zones[L.SIGMA, j]) * STRESS_SCALE < LIMIT):
            return j
    return -1


@nb.njit(**GUARD)
def failing_node(zones, segments, control, counters):
    """Node at which a void opens now, or -1; marks the zones the void will relieve.

    A patch is a stretch of neighbouring zones in tension. When one of them reaches its limit the patch opens at one node, the
    one with the most strained neighbours; its zones, and those that join it later, are marked: they hold at the cap of their
    law, and open no second void, until the release from the void has reached them; nor does a zone in which voids have grown.
    One spall plane is one void, and a later pulse is free to open another elsewhere (multiple spall of a decaying pulse).
    """
    worst_node, worst = -1, 0.0
    marked = 0
    for k in range(segments.shape[0]):
        first, last = segments[k, L.SEG_FIRST], segments[k, L.SEG_LAST]
        z = first
        while z < last:
            if zones[L.FAILURE, z] < RELIEVED:
                zones[L.TAG, z] = 0.0
                z += 1
                continue
            start, peak, at, tagged = z, 0.0, z, False
            while z < last and zones[L.FAILURE, z] >= RELIEVED:
                if zones[L.TAG, z] > 0.0:
                    tagged = True
                if zones[L.FAILURE, z] > peak:
                    peak, at = zones[L.FAILURE, z], z
                z += 1
            if tagged:
                for i in range(start, z):
                    zones[L.TAG, i] = 1.0
                marked += z - start
            elif peak >= 1.0 and peak > worst and last - first > 1 and zones[L.VOIDS, at] * zones[L.RHO, at] < VOIDED:
                # an end of the body is no place to part, however hard its other side is compressed
                leftward = at + 1 == last or (at > first and zones[L.FAILURE, at - 1] > zones[L.FAILURE, at + 1])
                worst, worst_node = peak, (at if leftward else at + 1) + k
                counters[L.CULPRIT] = k
    counters[L.FRACTURING] = marked
    return worst_node


@nb.njit(**GUARD)
def mark_patch(zones, first, last, at):
    """Mark the failing patch around zone `at` as relieved by a void; its damage has become the void."""
    z = at
    while z >= first and zones[L.FAILURE, z] >= RELIEVED:
        zones[L.TAG, z], zones[L.DAMAGE, z] = 1.0, 0.0
        z -= 1
    z = at + 1
    while z < last and zones[L.FAILURE, z] >= RELIEVED:
        zones[L.TAG, z], zones[L.DAMAGE, z] = 1.0, 0.0
        z += 1


@nb.njit(**GUARD)
def parting_interface(zones, nodes, interfaces):
    """Index of the first listed interface whose tension exceeds its bond, or -1; rows are (node, zone on the left)."""
    for i in range(interfaces.shape[0]):
        node, z = interfaces[i, 0], interfaces[i, 1]
        ml, mr = zones[L.MASS, z], zones[L.MASS, z + 1]
        left = zones[L.P, z] - zones[L.S1, z]
        right = zones[L.P, z + 1] - zones[L.S1, z + 1]
        traction = (left * mr + right * ml) / (ml + mr)
        soft = min(zones[L.RHO, z] * zones[L.C, z] ** 2, zones[L.RHO, z + 1] * zones[L.C, z + 1] ** 2)
        if -traction > nodes[L.BOND, node] + CHATTER * soft:
            return i
    return -1


@nb.njit(**GUARD)
def closing_time(gap, approach, acceleration, dt_old):
    """Time in which a gap closes: A t^2 + (2 W + A dt_old) t + 2 R = 0 (Wilkins B.4 b), the smallest positive root, or 1e300.

    gap R >= 0 (m), approach W = u_right - u_left (m/s, negative when closing), acceleration A relative, (a_right - a_left), with
    the corrected sign of the hoop terms (W-E2). dt_old is the last step of a leapfrog, 0 for a one-step integrator.
    """
    b = 2.0 * approach + acceleration * dt_old
    discriminant = b * b - 8.0 * acceleration * gap
    if discriminant < 0.0:
        return 1e300
    root = math.sqrt(discriminant)
    if b < 0.0:
        return 4.0 * gap / (root - b)     # 2c/(-b + root): no cancellation, and -2R/B as A goes to 0
    if acceleration < 0.0:
        return (-b - root) / (2.0 * acceleration)
    return 1e300


@nb.njit(**GUARD)
def touching_gap(zones, nodes, segments):
    """First gap (between segments k and k+1) that is closed and closing, or -1."""
    for k in range(segments.shape[0] - 1):
        z = segments[k, L.SEG_LAST] - 1
        left, right = z + 1 + k, z + 1 + k + 1
        gap = nodes[L.R, right] - nodes[L.R, left]
        width = min(nodes[L.R, left] - nodes[L.R, left - 1], nodes[L.R, right + 1] - nodes[L.R, right])
        if gap <= TOUCHING * width and (nodes[L.U, right] < nodes[L.U, left] or gap < 0.0):
            return k
    return -1


@nb.njit(**GUARD)
def cavity_closed(nodes, segments):
    """Whether the inner surface of a curved problem has reached the axis or the origin, where it stays."""
    inner = nodes[L.R, 0]
    return segments[0, L.SEG_LEFT] != L.FIXED and inner <= TOUCHING * (nodes[L.R, 1] - inner)


@nb.njit(**GUARD)
def record(zones, nodes, table, weights, geometry, out):
    """One gauge row: table (gauge; zone a, zone b, zone of the faces, left node of that zone), weights (of b; of the right face)."""
    for i in range(table.shape[0]):
        a, b, node = table[i, 0], table[i, 1], table[i, 3]
        w, f = weights[i, 0], weights[i, 1]
        out[i, 0] = (1.0 - f) * nodes[L.R, node] + f * nodes[L.R, node + 1]
        out[i, 1] = (1.0 - f) * nodes[L.U, node] + f * nodes[L.U, node + 1]
        out[i, 2] = (1.0 - w) * zones[L.RHO, a] + w * zones[L.RHO, b]
        out[i, 3] = (1.0 - w) * zones[L.E, a] + w * zones[L.E, b]
        out[i, 4] = (1.0 - w) * zones[L.P, a] + w * zones[L.P, b]
        out[i, 5] = (1.0 - w) * zones[L.Q, a] + w * zones[L.Q, b]
        out[i, 6] = (1.0 - w) * zones[L.S1, a] + w * zones[L.S1, b]
        hoop_a = hoop_deviator(zones[L.S1, a], zones[L.S2, a], geometry)
        hoop_b = hoop_deviator(zones[L.S1, b], zones[L.S2, b], geometry)
        out[i, 7] = (1.0 - w) * hoop_a + w * hoop_b
        out[i, 8] = (1.0 - w) * zones[L.SIGMA, a] + w * zones[L.SIGMA, b]
        out[i, 9] = (1.0 - w) * zones[L.PLASTIC_STRAIN, a] + w * zones[L.PLASTIC_STRAIN, b]
        out[i, 10] = (1.0 - w) * zones[L.DAMAGE, a] + w * zones[L.DAMAGE, b]
        out[i, L.GAUGE_COMPACTION] = (1.0 - w) * zones[L.COMPACTION, a] + w * zones[L.COMPACTION, b]
        if out.shape[1] > L.GAUGE_BURN:
            out[i, L.GAUGE_BURN] = (1.0 - w) * zones[L.BURN_FRACTION, a] + w * zones[L.BURN_FRACTION, b]
            out[i, L.GAUGE_SHARE] = w
            out[i, L.GAUGE_REFERENCE] = zones[L.REFERENCE, a]
            for k in range(len(L.PHASE_ROWS)):
                out[i, L.GAUGE_PHASES + k] = zones[L.PHASE_ROWS[k], a]
                out[i, L.GAUGE_PHASES + len(L.PHASE_ROWS) + k] = zones[L.PHASE_ROWS[k], b]
