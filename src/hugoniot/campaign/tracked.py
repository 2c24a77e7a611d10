"""The standard problems as tracked fronts take them: in cells, and with one region where a state varies from zone to zone."""

import dataclasses
from types import MappingProxyType

import numpy as np

from hugoniot.problem.fronts import defects
from hugoniot.problem.model import Problem, Profile, Region, SolverOptions
from hugoniot.problem.standard.parts import StandardProblem, bonded

FRONTS = "fronts"
JUMP = 0.5      # change of density from zone to zone, over the larger, that is a shock and no profile


def with_fronts(asked: Problem) -> Problem:
    """The same problem for tracked fronts, in the mode with cells."""
    asked = joined(asked)
    return dataclasses.replace(asked, solver=SolverOptions(FRONTS, options=MappingProxyType({"mode": "cells"})))


def beyond_fronts(problem: StandardProblem | None) -> str:
    """Why tracked fronts do not take a standard problem; empty where they do. None stands for one in two dimensions."""
    if problem is None:
        return "it is two-dimensional"
    found = defects(with_fronts(problem.build(problem.zones[0])))
    return found[0][1] if found else ""


def joined(problem: Problem) -> Problem:
    """Regions of one zone each made into regions with a profile: every line between regions would be followed as an interface."""
    runs: list[list[Region]] = []
    for region in problem.regions:
        if runs and _goes_on(runs[-1][-1], region):
            runs[-1].append(region)
        else:
            runs.append([region])
    if len(runs) == len(problem.regions):
        return problem
    regions = tuple(_as_one(run, k > 0, k + 1 < len(runs)) for k, run in enumerate(runs))
    return dataclasses.replace(problem, regions=regions, interfaces=bonded(regions))


def shocks(solver) -> np.ndarray:
    """(time, place, direction) of the ends of all lines of tracked shocks, (n, 3); none where waves are not followed."""
    table = solver.front_table()
    if table is None:
        return np.empty((0, 3))
    columns, kinds, rows = table
    return rows[np.array(kinds) == "shock"][:, [columns.index(name) for name in ("end_time", "end_position", "direction")]]


def _goes_on(left: Region, right: Region) -> bool:
    same = left.zones == right.zones == 1 and left.material == right.material and left.end == right.start
    if not same or left.density is None or right.density is None:
        return same and left.density is right.density      # both rest at the law's own density
    return abs(left.density - right.density) <= JUMP * max(left.density, right.density)


def _as_one(run: list[Region], jump_before: bool, jump_after: bool) -> Region:
    """One region: the state linear between the middles of the zones, the velocity between their nodes.

    At a jump the velocity goes on as inside, for a node there has that of the other side.
    """
    if len(run) < 3:
        return run[0] if len(run) == 1 else dataclasses.replace(run[0], end=run[-1].end, zones=len(run))
    nodes = np.array([run[0].start, *(r.end for r in run)])
    speeds = [r.velocity if isinstance(r.velocity, tuple) else (r.velocity, r.velocity) for r in run]
    u = np.array([speeds[0][0], *(after for _, after in speeds)])
    if jump_before:
        u[0] = 2.0 * u[1] - u[2]
    if jump_after:
        u[-1] = 2.0 * u[-2] - u[-3]
    middles = 0.5 * (nodes[1:] + nodes[:-1])
    places = np.sort(np.concatenate([nodes, middles]))
    fields = [("velocity", np.interp(places, nodes, u))]
    for name in ("density", "pressure", "energy"):
        given = [getattr(r, name) for r in run]
        if given[0] is not None:
            fields.append((name, _beyond(places, middles, np.array(given))))
    profile = Profile(tuple(places.tolist()), tuple((name, tuple(values.tolist())) for name, values in fields))
    nothing = dict.fromkeys(("density", "pressure", "energy"))
    return dataclasses.replace(run[0], end=run[-1].end, zones=len(run), velocity=0.0, profile=profile, **nothing)


def _beyond(places: np.ndarray, middles: np.ndarray, values: np.ndarray) -> np.ndarray:
    """Linear between the middles, and the same slopes to the ends, but not to a change of sign."""
    found = np.interp(places, middles, values)
    for at, (a, b) in ((0, (0, 1)), (-1, (-1, -2))):
        end = values[a] + (values[b] - values[a]) * (places[at] - middles[a]) / (middles[b] - middles[a])
        found[at] = end if end * values[a] > 0.0 else values[a]
    return found
