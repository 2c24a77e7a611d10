"""Extremes of the problem's zones over a run of cells, compiled: those of the cell in which the middle of a zone's mass lies."""

import numba as nb

from hugoniot.core.target import BY_ADDRESS
from hugoniot.solvers.fronts.cells.solids import deviator_of, is_solid
from hugoniot.solvers.fronts.cells.tables import FULL, MEAN, VOLUME, P


@nb.njit(**BY_ADDRESS)
def look_at_zones(grid, rules, work, n):
    """Raise the extremes of all zones by the averages of the cells; regions, their zones and their cells stand from left to right."""
    w, zones, owner, regions = work.w, work.zones, work.owner, len(rules.traits)
    whole = work.sums
    for k in range(regions):
        whole[k] = 0.0
    for i in range(n):
        if grid.region[i] >= 0:
            whole[grid.region[i] % regions] += grid.q[i, 0]
    last, passed, z = -1, 0.0, 0
    for i in range(n):
        if grid.region[i] < 0:
            continue
        k = grid.region[i] % regions
        passed = grid.q[i, 0] if k != last else passed + grid.q[i, 0]
        last = k
        while z < len(owner) and owner[z] < k:
            z += 1
        if w[FULL, i] == 0.0:
            continue
        sigma, rho = w[MEAN + P, i], w[MEAN, i]
        p = sigma + (deviator_of(rules, k, w[MEAN + VOLUME, i]) if is_solid(rules, k) else 0.0)
        while z < len(owner) and owner[z] == k and zones[0, z] * whole[k] <= passed:
            zones[1, z], zones[2, z] = max(zones[1, z], sigma), max(zones[2, z], -sigma)
            zones[3, z], zones[4, z] = max(zones[3, z], p), max(zones[4, z], rho)
            z += 1
