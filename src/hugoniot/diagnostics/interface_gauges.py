"""Gauges on an interface: velocity and stress are the same on both sides and recorded once, all else on each side apart.

A gauge `G` at "A/B" records position, velocity and stress; "G left" and "G right" record that stress, their own faces, and the zones of A
and B that touch there.
"""

from collections.abc import Sequence

import numpy as np

from hugoniot.diagnostics.apparent import APPARENT
from hugoniot.problem.gauges import is_interface
from hugoniot.problem.model import Gauge, Problem

CONTINUOUS = ("position", "velocity", "stress", APPARENT)


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


def _strongest_tension(problem: Problem, gauge: Gauge) -> float:
    """Tension that the interface of a gauge carries before it opens, Pa; inf where it never does."""
    pair = {part.strip() for part in str(gauge.at).split("/", 1)}
    row = next((row for row in problem.interfaces if {row.left, row.right} == pair), None)
    return 0.0 if row is None else {"bonded": np.inf, "separable": 0.0, "bond": row.strength}[row.kind]


def without_mixtures(values: dict[str, np.ndarray], problem: Problem) -> dict[str, np.ndarray]:
    """Gauge records (n, ngauge) in which what jumps across an interface is NaN at the interface gauge itself.

    The gauges of both sides have its stress, that of their common face: the zone beside it holds the stress of another place. Its tension
    does not exceed the strength of the interface, as it would in the step at whose end the interface opens.
    """
    gauges = problem.gauges
    columns = [k for k, gauge in enumerate(gauges) if is_interface(gauge.at)]
    if not columns:
        return values
    found = {}
    for name, record in values.items():
        if name not in CONTINUOUS:
            record = np.array(record, dtype=float)
            record[:, columns] = np.nan
        found[name] = record
    if "stress" in values:
        found["stress"] = np.array(values["stress"], dtype=float)
        for k in columns:
            found["stress"][:, k] = np.maximum(found["stress"][:, k], -_strongest_tension(problem, gauges[k]))
        names = [gauge.name for gauge in gauges]
        for side, whole in sides([{"name": gauge.name, "at": gauge.at} for gauge in gauges]).items():
            found["stress"][:, names.index(side)] = found["stress"][:, names.index(whole)]
    return found
