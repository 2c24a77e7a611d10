"""Spall planes that a mesh is too coarse for: their number and place, and the strength read from the surface, are then the mesh's."""

import numpy as np

from hugoniot.problem.model import Problem
from hugoniot.units import format_si

FEWEST = 100     # zones from a void to the end of its region: with fewer, releases are as wide as the layer and hide a second plane


def unresolved(problem: Problem, opened: np.ndarray, region_of: np.ndarray) -> list[str]:
    """A warning for every region with a void fewer than FEWEST zones from its end; opened: the zone on the right of every void."""
    found: dict[int, int] = {}
    for zone in opened.tolist():
        region = int(region_of[zone])
        if int(region_of[zone - 1]) != region:      # a void where regions meet
            continue
        first, last = np.flatnonzero(region_of == region)[[0, -1]]
        found[region] = min(found.get(region, FEWEST), zone - int(first), int(last) + 1 - zone)
    texts = []
    for k, zones in sorted(found.items()):
        region = problem.regions[k]
        if zones < FEWEST:
            size = abs(region.end - region.start) / region.zones * zones / FEWEST
            texts.append(f"a void opened in '{region.name}' {zones} zone{'' if zones == 1 else 's'} from an end of that region: "
                         f"with fewer than {FEWEST} zones between the void and that end, "
                         "the number of spall planes and the pull-back depend on the mesh; "
                         f"try zone_size = \"{format_si(size, 'm', 2)}\" in that region and compare")
    return texts
