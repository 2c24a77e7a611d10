"""Gauges on an interface: velocity and stress are the same on both sides and recorded once, all else on each side apart.

A gauge `G` at "A/B" records position, velocity and stress; "G left" and "G right" record the zones of A and B that touch there.
"""

import dataclasses
from collections.abc import Sequence

import numpy as np

from hugoniot.problem.model import Gauge, Problem

CONTINUOUS = ("position", "velocity", "stress")


def is_interface(at) -> bool:
    """Whether a gauge's place names the interface of two regions."""
    return isinstance(at, str) and "/" in at


def with_sides(problem: Problem) -> Problem:
    """The problem with a gauge on each side of every gauge at an interface."""
    names = {gauge.name for gauge in problem.gauges}
    gauges: list[Gauge] = []
    for gauge in problem.gauges:
        gauges.append(gauge)
        if is_interface(gauge.at):
            a, b = (part.strip() for part in str(gauge.at).split("/", 1))
            sides = (Gauge(f"{gauge.name} left", f"{a}:right"), Gauge(f"{gauge.name} right", f"{b}:left"))
            gauges += [side for side in sides if side.name not in names]
    return dataclasses.replace(problem, gauges=tuple(gauges))


def sides(gauges: Sequence[dict]) -> dict[str, str]:
    """{name of a side's gauge: name of its interface gauge} among the gauges of a run's set-up."""
    at = {gauge["name"]: str(gauge["at"]) for gauge in gauges}
    found = {}
    for name, where in at.items():
        if is_interface(where):
            a, b = (part.strip() for part in where.split("/", 1))
            found |= {f"{name} {side}": name for side, place in (("left", f"{a}:right"), ("right", f"{b}:left"))
                      if at.get(f"{name} {side}") == place}
    return found


def without_mixtures(values: dict[str, np.ndarray], gauges: Sequence[Gauge]) -> dict[str, np.ndarray]:
    """Gauge records (n, ngauge) in which what jumps across an interface is NaN at the interface gauge itself."""
    columns = [k for k, gauge in enumerate(gauges) if is_interface(gauge.at)]
    if not columns:
        return values
    found = {}
    for name, record in values.items():
        if name not in CONTINUOUS:
            record = np.array(record, dtype=float)
            record[:, columns] = np.nan
        found[name] = record
    return found
