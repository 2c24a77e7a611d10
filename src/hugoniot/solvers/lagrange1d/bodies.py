"""The topology of a run: bodies (segments), runs of one material, interfaces; splitting a body at a node and joining two.

These rare events are handled on whole arrays in Python; the sweeps in between need no special cases. Momentum is conserved exactly, and the
kinetic energy lost in a join goes to the two zones as heat, so the energy budget closes (W-E6).
"""

import dataclasses

import numpy as np

from hugoniot.core.ops import NO_LIMIT
from hugoniot.solvers.lagrange1d import layout as L
from hugoniot.solvers.lagrange1d.layout import H, Z


def run_table(segments, region_ends, laws_of):
    """Runs (first, last, segment, laws): the pieces of every region in every segment, like neighbours merged."""
    rows: list[list[int]] = []
    for k, (first, last, _, _) in enumerate(segments.tolist()):
        for region, (a, b) in enumerate(region_ends):
            lo, hi, same = max(first, a), min(last, b), [k, laws_of[region]]
            if lo >= hi:
                continue
            if rows and rows[-1][1] == lo and rows[-1][2:] == same:
                rows[-1][1] = hi
            else:
                rows.append([lo, hi, *same])
    return np.array(rows, dtype=np.int64).reshape(-1, 4)


def alike_ranges(regions, ranges, burns):
    """(first, last, whether it burns) of neighbouring regions that start alike (material, state, velocity), merged.

    To cut a region changes nothing.
    Regions that start in different states keep their border, a contact that the artificial heat flux is not to smear.
    """
    merged: list[tuple[int, int, bool]] = []
    before = None
    for region, (first, end), burning in zip(regions, ranges, burns):
        start = dataclasses.replace(region, name="", start=0.0, end=0.0, zones=0, ratio=1.0)
        if merged and start == before and merged[-1][1] == first:
            merged[-1] = (merged[-1][0], end, burning)
        else:
            merged.append((first, end, burning))
        before = start
    return merged


def left_nodes(segments) -> np.ndarray:
    """The node at the left face of every zone, (nzone,)."""
    return np.concatenate([np.arange(a + k, b + k) for k, (a, b, _, _) in enumerate(segments.tolist())])


SHARE = 10 * L.PIECE     # zones of a share of work: some microseconds, and a whole number of pieces


def cuts(first, last):
    """Where a stretch of zones is cut into shares: alike, so that a team has them evenly, and none above SHARE.

    All but the last are whole pieces, which are a multiple of any vector length, so that cutting does not change results.
    """
    shares = max(-(-(last - first) // SHARE), 1)
    length = -(-(last - first) // (shares * L.PIECE)) * L.PIECE
    return [(lo, min(lo + length, last)) for lo in range(first, last, length)]


def shares_of(runs, segments, ranges):
    """(runs, node spans, ranges of heat flux) cut into shares of work for a team of threads.

    A span of zones (first, last) holds the inner nodes first+1 .. last-1; it overlaps the next by one zone, so that every inner
    node of a segment is in one span.
    """
    cut = [(lo, hi, *rest) for first, last, *rest in runs.tolist() for lo, hi in cuts(first, last)]
    spans = [(lo, min(hi + 1, last), k) for k, (first, last, _, _) in enumerate(segments.tolist())
             for lo, hi in cuts(first, max(last - 1, first + 1))]
    flux = [(max(first, a), min(last, b), k, burns) for k, (first, last, _, _) in enumerate(segments.tolist())
            for a, b, burns in ranges if max(first, a) < min(last, b)]
    return tuple(np.array(table, dtype=np.int64).reshape(-1, n) for table, n in zip((cut, spans, flux), (4, 3, 4)))


def interface_table(segments, nodes):
    """(node, zone on its left) of every inner node whose bond is limited."""
    weak = [np.flatnonzero(nodes[H.bond, first + k + 1:last + k] < NO_LIMIT) + first + k + 1
            for k, (first, last, _, _) in enumerate(segments.tolist())]
    return np.concatenate([np.stack((inner, inner - k - 1), axis=1) for k, inner in enumerate(weak)])


def set_node_masses(zones, nodes, segments):
    """Half of each neighbouring zone's mass."""
    left, half = left_nodes(segments), 0.5 * zones[Z.mass]
    nodes[H.mass] = 0.0
    nodes[H.mass, left] += half
    nodes[H.mass, left + 1] += half
    nodes[H.inverse_mass] = 1.0 / nodes[H.mass]


def welded(zones, one, other, u_one, u_other):
    """Velocity of two nodes that become one, with their mean momentum; the kinetic energy that loses heats zones `one` and `other`."""
    left, right, jump = 0.5 * zones[Z.mass, one], 0.5 * zones[Z.mass, other], u_other - u_one
    heat = 0.5 * left * right / (left + right) * jump * jump
    zones[Z.e, [one, other]] += heat / (2.0 * (left + right))
    return u_one + right / (left + right) * jump


def split(zones, nodes, gradient, segments, node):
    """Open a void at an inner node: two free surfaces at one place with one velocity. Returns (nodes, gradient, segments)."""
    k = next(k for k, (first, last, _, _) in enumerate(segments) if first + k < node < last + k)
    first, last, left, right = segments[k]
    zone = node - k
    nodes = np.concatenate((nodes[:, :node + 1], nodes[:, node:]), axis=1)
    ghost = zone + 2 * k + 1
    gradient = np.concatenate((gradient[:ghost], [0.0, 0.0], gradient[ghost:]))
    both = [(first, zone, left, L.FREE), (zone, last, L.FREE, right)]
    segments = np.concatenate((segments[:k], both, segments[k + 1:]))
    set_node_masses(zones, nodes, segments)
    return nodes, gradient, segments


def join(zones, nodes, gradient, segments, k):
    """Close the gap between segments k and k+1. Returns (nodes, gradient, segments, heat in J per unit area or angle)."""
    last = segments[k, L.SEG_LAST]
    a, b = last + k, last + k + 1
    ma, mb = nodes[H.mass, a], nodes[H.mass, b]
    ua, ub = nodes[H.u, a], nodes[H.u, b]
    share = mb / (ma + mb)
    heat = 0.5 * ma * share * (ua - ub) ** 2
    nodes[H.u, a] = nodes[H.u_mean, a] = ua + share * (ub - ua)      # a jump is no acceleration that goes on
    nodes[H.r, a] += share * (nodes[H.r, b] - nodes[H.r, a])
    nodes[H.bond, a] = 0.0
    zones[Z.e, last - 1:last + 1] += heat / (zones[Z.mass, last - 1] + zones[Z.mass, last])
    zones[Z.relieved, last - 1:last + 1] = 0.0
    nodes = np.ascontiguousarray(np.delete(nodes, b, axis=1))
    ghost = last + 2 * k + 1
    gradient = np.delete(gradient, [ghost, ghost + 1])
    first, _, left, _ = segments[k]
    _, end, _, right = segments[k + 1]
    segments = np.delete(segments, k + 1, axis=0)
    segments[k] = (first, end, left, right)
    set_node_masses(zones, nodes, segments)
    return nodes, gradient, segments, heat
