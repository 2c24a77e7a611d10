"""Checks after every step (failing zones, interfaces, gaps, gauges) and at given times."""

import math

import numba as nb
import numpy as np

from hugoniot.core.binder import bind
from hugoniot.core.passes import rows
from hugoniot.core.target import BY_ADDRESS, INLINE
from hugoniot.laws.eos.contract import LEAST_STIFFNESS
from hugoniot.solvers.lagrange1d import layout as L
from hugoniot.solvers.lagrange1d.layout import ChargeRows, H, NodeRows, Z, ZoneRows

RELIEVED = 0.3        # a zone below this fraction of its failure limit is out of the tension that opened a void, also in its smeared tail
VOIDED = 1e-3         # void fraction from which a zone belongs to an older spall plane and opens none of its own
CHATTER = 1e-4        # tension, in units of rho c^2, a strengthless interface supports: the noise a release leaves (Herrmann A.7)
SILENT = 1e-12        # the same in units of the stiffer side: its round-off beside explosive, which before it burns has no stiffness
TOUCHING = 1e-6       # gap, in units of the neighbouring zones, that counts as closed


@nb.njit(**BY_ADDRESS)
def failing_node(zones, segments, control, counters):
    """Node at which a void opens now, or -1; marks the zones the void will relieve.

    A patch is a stretch of neighbouring zones in tension. When one of them reaches its limit the patch opens at one node, the
    one with the most strained neighbours; its zones, and those that join it later, are marked: they hold at the cap of their
    law, and open no second void, until the release from the void has reached them; nor does a zone in which voids had grown before.
    One spall plane is one void, and a later pulse is free to open another elsewhere (multiple spall of a decaying pulse).
    """
    zone = rows(ZoneRows, zones, 0)
    worst_node, worst = -1, 0.0
    marked = 0
    for k in range(segments.shape[0]):
        first, last = segments[k, L.SEG_FIRST], segments[k, L.SEG_LAST]
        z = first
        while z < last:
            if zone.failure[z] < RELIEVED:
                zone.relieved[z] = 0.0
                z += 1
                continue
            start, peak, at, tagged = z, 0.0, z, False
            while z < last and zone.failure[z] >= RELIEVED:
                if zone.relieved[z] > 0.0:
                    tagged = True
                if zone.failure[z] > peak:
                    peak, at = zone.failure[z], z
                z += 1
            if tagged:
                for i in range(start, z):
                    zone.relieved[i] = 1.0
                marked += z - start
            elif peak >= 1.0 and peak > worst and last - first > 1 and (zone.voids[at] - max(zone.grown[at], 0.0)) * zone.rho[at] < VOIDED:
                # an end of the body is no place to break, however hard its other side is compressed
                leftward = at + 1 == last or (at > first and zone.failure[at - 1] > zone.failure[at + 1])
                worst, worst_node = peak, (at if leftward else at + 1) + k
                counters[L.CULPRIT] = k
    counters[L.FRACTURING] = marked
    return worst_node


def mark_patch(zones, first, last, at):
    """Mark the failing patch around zone `at` as relieved by a void; its damage has become the void."""
    ends = np.concatenate(([first - 1], np.flatnonzero(~(zones[Z.failure, first:last] >= RELIEVED)) + first, [last]))
    k = np.searchsorted(ends, at, side="right")
    zones[Z.relieved, ends[k - 1] + 1:ends[k]], zones[Z.damage, ends[k - 1] + 1:ends[k]] = 1.0, 0.0


@nb.njit(**BY_ADDRESS)
def separating_interface(zones, nodes, interfaces):
    """Index of the first listed interface whose tension exceeds its bond, or -1; rows are (node, zone on the left).

    The traction is that of two half zones that move as one. Where they slow down together, the mass of a gas seems to pull at a liquid in
    tension; but a gas expands faster than it is left behind, and no contact opens that a side still presses on like one.
    """
    zone = rows(ZoneRows, zones, 0)
    h = rows(NodeRows, nodes, 0)
    for i in range(interfaces.shape[0]):
        node, z = interfaces[i, 0], interfaces[i, 1]
        ml, mr = zone.mass[z], zone.mass[z + 1]
        left = zone.p[z] - zone.s1[z]
        right = zone.p[z + 1] - zone.s1[z + 1]
        traction = (left * mr + right * ml) / (ml + mr)
        stiff_left, stiff_right = zone.rho[z] * zone.c[z] * zone.c[z], zone.rho[z + 1] * zone.c[z + 1] * zone.c[z + 1]
        follows = LEAST_STIFFNESS * left > stiff_left or LEAST_STIFFNESS * right > stiff_right
        noise = max(CHATTER * min(stiff_left, stiff_right), SILENT * max(stiff_left, stiff_right))
        if not follows and -traction > h.bond[node] + noise:
            return i
    return -1


@nb.njit(**BY_ADDRESS)
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


def touching_gap(zones, nodes, segments):
    """First gap (between segments k and k+1) that is closed and closing, or -1."""
    h = rows(NodeRows, nodes, 0)
    for k in range(segments.shape[0] - 1):
        z = segments[k, L.SEG_LAST] - 1
        left, right = z + 1 + k, z + 1 + k + 1
        gap = h.r[right] - h.r[left]
        width = min(h.r[left] - h.r[left - 1], h.r[right + 1] - h.r[right])
        if gap <= TOUCHING * width and (h.u[right] < h.u[left] or gap < 0.0):
            return k
    return -1


def cavity_closed(nodes, segments):
    """Whether the inner surface of a curved problem has reached the axis or the origin, where it stays."""
    h = rows(NodeRows, nodes, 0)
    inner = h.r[0]
    return segments[0, L.SEG_LEFT] != L.FIXED and inner <= TOUCHING * (h.r[1] - inner)


@nb.njit(**BY_ADDRESS)
def pass_times(zones, nodes, control, counters, segments, passed):
    """Note what is there at the times that are reached, and aim at the next one; whether that lies before the end of the march."""
    k, zone_count = counters[L.PASSED_TIMES], segments[-1, L.SEG_LAST]
    node_count = zone_count + segments.shape[0]
    while k < passed.shape[0] and passed[k, L.PASS_TIME] <= control[L.TIME]:
        velocity = stress = 0.0
        for node in range(node_count):
            velocity = max(velocity, abs(nodes[H.u, node]))
        for zone in range(zone_count):
            stress = max(stress, abs(zones[Z.sigma, zone]))
        passed[k, L.PASS_VELOCITY], passed[k, L.PASS_STRESS], passed[k, L.PASS_RIGHT] = velocity, stress, nodes[H.u, node_count - 1]
        k += 1
    counters[L.PASSED_TIMES] = k
    following = passed[k, L.PASS_TIME] if k < passed.shape[0] else control[L.UNTIL]
    control[L.EVENT_TIME] = min(following, control[L.UNTIL])
    return control[L.TIME] < control[L.UNTIL]


@nb.njit(**BY_ADDRESS)
def record_gauges(zones, charge, nodes, table, weights, out):
    """One gauge row: table (gauge; zone a, zone b, zone of the faces, left node of that zone), weights (of b; of the right face; 0 on a
    surface whose stress is not that of its zone, else 1)."""
    h = rows(NodeRows, nodes, 0)
    burn = rows(ChargeRows, charge, 0)
    for i in range(table.shape[0]):
        a, b, node = table[i, 0], table[i, 1], table[i, 3]
        w, f = weights[i, 0], weights[i, 1]
        out[i, 0] = (1.0 - f) * h.r[node] + f * h.r[node + 1]
        out[i, 1] = (1.0 - f) * h.u[node] + f * h.u[node + 1]
        for k in range(len(L.GAUGE_ROWS_OF_ZONES)):
            field = L.GAUGE_ROWS_OF_ZONES[k]
            out[i, k + 2] = (1.0 - w) * zones[field, a] + w * zones[field, b]
        out[i, L.GAUGE_STRESS] *= weights[i, 2]
        if out.shape[1] > L.GAUGE_BURN:
            out[i, L.GAUGE_BURN] = (1.0 - w) * burn.lam[a] + w * burn.lam[b]
            out[i, L.GAUGE_SHARE] = w
            out[i, L.GAUGE_REFERENCE] = burn.reference[a]
            for k in range(len(L.PHASE_ROWS)):
                out[i, L.GAUGE_PHASES + k] = charge[L.PHASE_ROWS[k], a]
                out[i, L.GAUGE_PHASES + len(L.PHASE_ROWS) + k] = charge[L.PHASE_ROWS[k], b]


bind(touching_gap, **INLINE)
bind(cavity_closed, **INLINE)
