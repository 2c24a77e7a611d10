"""Gauges that a run records without being asked: on both sides of interface gauges, and on free ends.

A gauge `G` at "A/B" records position, velocity and stress; "G left" and "G right" record the zones of A and B that touch there.
"""

import dataclasses

from hugoniot.problem.model import Gauge, Problem


def is_interface(at) -> bool:
    """Whether a gauge's place names the interface of two regions."""
    return isinstance(at, str) and "/" in at


def with_automatic_gauges(problem: Problem) -> Problem:
    """The problem with a gauge on both sides of every interface gauge, and on every free end that has none.

    The latter is what a velocity interferometer would look at. Only plates (planar bodies) have such an end on both sides; a shell has
    its outer one. Gauges that are there already are not added again, so that the problem found is its own.
    """
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
