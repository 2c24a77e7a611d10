"""Fracture criteria evaluated at nodes, from the zones beside them: ratios from which `watch.failing_node` opens a void.

They replace the ratios of the zones: a zone takes the larger ratio of its two nodes.
"""

import numba as nb
import numpy as np

from hugoniot.core.passes import rows
from hugoniot.core.target import BY_ADDRESS, GUARD
from hugoniot.laws.fracture.contract import asked_at_nodes, at_node
from hugoniot.laws.fracture.pressure_volume_at_nodes import PressureVolumeAtNodes
from hugoniot.laws.fracture.stress_gradient import StressGradient
from hugoniot.solvers.lagrange1d import layout as L
from hugoniot.solvers.lagrange1d.layout import NodeRows, ZoneRows

LAWS = (PressureVolumeAtNodes, StressGradient)
FIRST, LAST, LAW, REST, NUMBERS = range(5)     # columns of the table: zones of a region, law, density at rest, the law's numbers
COLUMNS = NUMBERS + 3
AROUND = 4      # zones over which a slope of the tension is taken: noise from zone to zone is none


def node_criteria(laws, laws_of_region, region_ranges):
    """The table of regions whose fracture is asked at nodes; without rows where there are none."""
    found = []
    for k, (first, last) in zip(laws_of_region, region_ranges):
        par = laws[k].fracture
        if asked_at_nodes(par):
            numbers = [*par, 0.0, 0.0][:COLUMNS - NUMBERS]
            found.append([first, last, LAWS.index(type(par)), laws[k].constants.rest, *numbers])
    return np.array(found, dtype=float).reshape(-1, COLUMNS)


@nb.njit(**GUARD)
def steepest(zone, h, z, k, low, high):
    """Slope of the tension over `AROUND` zones before or behind the right node of zone z of segment k, the larger of both; zones low to
    high - 1 of the region, Pa/m."""
    slope = 0.0
    for near, far in ((z, max(low, z - AROUND)), (z + 1, min(high - 1, z + 1 + AROUND))):
        apart = 0.5 * abs(h.r[far + k + 1] + h.r[far + k] - h.r[near + k + 1] - h.r[near + k])
        if apart > 0.0:
            slope = max(slope, abs((zone.s1[far] - zone.p[far]) - (zone.s1[near] - zone.p[near])) / apart)
    return slope


@nb.njit(**BY_ADDRESS)
def fail_at_nodes(zones, nodes, segments, criteria):
    """Write the failure ratio of the zones of all regions in the table."""
    zone, h = rows(ZoneRows, zones, 0), rows(NodeRows, nodes, 0)
    for i in range(criteria.shape[0]):
        first, last, law, rest = int(criteria[i, FIRST]), int(criteria[i, LAST]), int(criteria[i, LAW]), criteria[i, REST]
        a, b, c = criteria[i, NUMBERS], criteria[i, NUMBERS + 1], criteria[i, NUMBERS + 2]
        for z in range(first, last):
            zone.failure[z] = 0.0
        for k in range(segments.shape[0]):
            low, high = max(first, segments[k, L.SEG_FIRST]), min(last, segments[k, L.SEG_LAST])
            for z in range(low, high - 1):
                p, v = 0.5 * (zone.p[z] + zone.p[z + 1]), 0.5 * rest * (1.0 / zone.rho[z] + 1.0 / zone.rho[z + 1])
                tension = 0.5 * (zone.s1[z] + zone.s1[z + 1]) - p
                if law == 0:
                    ratio = at_node(tension, p, v, 0.0, PressureVolumeAtNodes(a, b))
                else:
                    ratio = at_node(tension, p, v, steepest(zone, h, z, k, low, high), StressGradient(a, b, c))
                zone.failure[z], zone.failure[z + 1] = max(zone.failure[z], ratio), max(zone.failure[z + 1], ratio)
