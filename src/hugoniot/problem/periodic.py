"""What periodic ends cannot have."""

from hugoniot.problem.model import Problem


def defects(problem: Problem) -> list[tuple[tuple, str, str]]:
    """(place in the deck, message, way out) of everything that does not go with periodic ends."""
    kinds = {"left": problem.left.kind, "right": problem.right.kind}
    if "periodic" not in kinds.values():
        return []
    found: list[tuple[tuple, str, str]] = []
    for side, kind in kinds.items():
        if kind != "periodic":
            found.append((("boundary", side), "one end is periodic, the other is not", 'write "periodic" for both'))
    if problem.dimension > 1:
        found.append((("geometry",), f"periodic ends need planar geometry, not {problem.geometry}", "radii are not periodic"))
    for k, (one, two) in enumerate(zip(problem.regions, problem.regions[1:]), start=1):
        if two.start > one.end:
            found.append((("region", k, "from"), f"there is a gap before '{two.name}', but between periodic ends all regions form one "
                                                 "body", "close the gap"))
    for k, gauge in enumerate(problem.gauges):
        if any(kind == "periodic" and gauge.at == f"free surface {side}" for side, kind in kinds.items()):
            found.append((("gauge", k, "at"), f"a periodic end has no '{gauge.at}'", "give a position, or REGION:left"))
    for region in problem.regions:
        if problem.materials[region.material].burn is not None:
            found.append((("boundary",), f"'{region.name}' burns: a front that leaves at one end would enter at the other",
                          'use "free", "fixed" or "transmitting"'))
    if any("conduction" in table for table in problem.transport.values()):
        found.append((("transport",), "heat conduction is not supported across periodic ends",
                      "leave conduction out, or use other boundaries"))
    return found
