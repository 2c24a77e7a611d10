"""Gauges that a run records without being asked: on both sides of interface gauges, and on free ends.

A gauge `G` at "A/B" records position, velocity and stress; "G left" and "G right" record the zones of A and B that touch there.
"""

import dataclasses
from collections.abc import Sequence

from hugoniot.problem.model import Gauge, Problem, Region

NEAR = 1e-12      # of the length of the line: nearer to a face, a gauge is on it


def is_interface(at) -> bool:
    """Whether a gauge's place names the interface of two regions."""
    return isinstance(at, str) and "/" in at


def place_name(at: float | str, regions: Sequence[Region]) -> float | str:
    """The name of a place given as a coordinate, m: "A/B" where two regions touch, "A:right" or "B:left" at another end of a region.

    Anything else is returned as it is. Inside one of two regions that touch, what jumps between them would be taken for both.
    """
    if isinstance(at, str) or not regions:
        return at
    near = NEAR * (regions[-1].end - regions[0].start)
    ending = [r.name for r in regions if abs(r.end - at) <= near]
    starting = [r.name for r in regions if abs(r.start - at) <= near]
    if ending and starting:
        return f"{ending[0]}/{starting[0]}"
    return f"{ending[0]}:right" if ending else f"{starting[0]}:left" if starting else at


def misnamed(problem: Problem) -> list[tuple[tuple, str, str]]:
    """(place in the deck, message, way out) of gauges with the name of one that is recorded without being asked, but at another place."""
    first, last = problem.regions[0].name, problem.regions[-1].name
    kept = {f"free surface {side}": (f"free surface {side}", f"{name}:{side}") for side, name in (("left", first), ("right", last))}
    kept |= {side.name: (side.at,) for gauge in problem.gauges for side in _sides(gauge)}
    return [(("gauge", k, "name"), f"the name '{gauge.name}' belongs to a gauge at \"{kept[gauge.name][0]}\"",
             "choose another name") for k, gauge in enumerate(problem.gauges) if gauge.at not in kept.get(gauge.name, (gauge.at,))]


def with_automatic_gauges(problem: Problem) -> Problem:
    """The problem with gauges at coordinates of faces on these faces, with one on both sides of every interface gauge, and one on every
    free end that has none.

    The latter is what a velocity interferometer would look at. Only plates (planar bodies) have such an end on both sides; a shell has
    its outer one. Gauges that are there already are not added again, so that the problem found is its own.
    """
    placed = tuple(dataclasses.replace(gauge, at=place_name(gauge.at, problem.regions)) for gauge in problem.gauges)
    problem = dataclasses.replace(problem, gauges=placed)
    names = {gauge.name for gauge in problem.gauges}
    gauges: list[Gauge] = []
    for gauge in problem.gauges:
        gauges += [gauge, *(side for side in _sides(gauge) if side.name not in names)]
    known = names | {gauge.at for gauge in problem.gauges}
    ends = (("left", problem.left, problem.geometry == "planar"), ("right", problem.right, True))
    free = [f"free surface {side}" for side, boundary, seen in ends if seen and boundary.kind == "free"]
    gauges += [Gauge(name, name) for name in free if name not in known]
    return dataclasses.replace(problem, gauges=tuple(gauges))


def _sides(gauge: Gauge) -> list[Gauge]:
    if not is_interface(gauge.at):
        return []
    a, b = (part.strip() for part in str(gauge.at).split("/", 1))
    return [Gauge(f"{gauge.name} left", f"{a}:right"), Gauge(f"{gauge.name} right", f"{b}:left")]
