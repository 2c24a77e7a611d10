"""What a standard problem consists of, and the short cuts its builders share."""

from collections.abc import Callable
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np

from hugoniot.laws.eos.ideal_gas import IdealGas
from hugoniot.materials.material import Material
from hugoniot.problem.model import Boundary, Interface, OutputOptions, Problem, Pulse, Region


class Measure(NamedTuple):
    """How a finished run is judged; every number is SI or, where the problem has no scale, dimensionless.

    kind     "l1"        sum |f - f_exact| dr / sum dr over the window, divided by `scale`
             "self_l1"   "l1" against a run of the same solver on `exact` zones, for problems without an exact answer
             "points"    largest |f / f_reference - 1| over the reference positions that come with the solution
             "front"     |position of the discontinuity - exact|, divided by `scale`; `at` is the index in `jumps(t)`
             "value"     |field interpolated at the window's middle / exact - 1|
             "mean"      |mean of the field over the window / exact - 1|
             "first"     field in the zone nearest the wall, axis or centre, divided by exact
             "maximum"   largest value of the field
             "minimum"   smallest value of the field over the run
             "boundary"  |final position of the inner (at = 0) or outer (at = 1) boundary / exact - 1|
             "smallest"  |smallest position the inner boundary ever reached / exact - 1|
    field    name of core.fields, or "position"
    window   (from, to) in m at the final time; None: everything
    exact    the value to compare with; a number, the name of one of the solution's `numbers`, or None where the solution's fields serve
    """

    key: str
    kind: str
    field: str
    window: tuple[float, float] | None = None
    exact: float | str | None = None
    scale: float = 1.0
    at: int = 0


class Bar(NamedTuple):
    """Bars of one measure on one grid, from the verification table: "KO" scheme, second-order Godunov scheme ("G2"), the goal.

    sense   "below": smaller is better; "above": larger is better
    peer    the best of the open two-dimensional codes
    """

    measure: str
    zones: int
    ko: float | None = None
    g2: float | None = None
    goal: float | None = None
    sense: str = "below"
    peer: float | None = None


class StandardProblem(NamedTuple):
    """A problem of the field with a known answer.

    build      zones -> Problem
    measure    how to judge it
    bars       numbers to beat
    solution   name in theory.exact.SOLUTIONS, or "" where only numbers are known; called with `arguments`
    rates      measure -> order of convergence asked for
    zones      the grids of the verification table
    """

    name: str
    description: str
    build: Callable[[int], Problem]
    measure: tuple[Measure, ...]
    bars: tuple[Bar, ...]
    solution: str = ""
    arguments: MappingProxyType = MappingProxyType({})
    rates: MappingProxyType = MappingProxyType({})
    zones: tuple[int, ...] = (100, 200, 400)


def frozen(**values: Any) -> MappingProxyType:
    """A read-only mapping."""
    return MappingProxyType(values)


def gas(gamma: float) -> Material:
    """A dimensionless ideal gas."""
    return Material("gas", IdealGas(gamma, 1.0, 1.0))


def constant_velocity(speed: float) -> Boundary:
    """A boundary that moves at a constant speed from the start."""
    return Boundary("velocity", Pulse("constant", amplitude=speed))


def pressure_table(function: Callable[[np.ndarray], np.ndarray], stop: float, points: int = 4001) -> Boundary:
    """A boundary pressure given as a function of time, tabulated finely enough that the table adds no visible error."""
    times = np.linspace(0.0, stop, points)
    return Boundary("pressure", Pulse("table", times=tuple(map(float, times)), values=tuple(map(float, function(times)))))


def bonded(regions: tuple[Region, ...]) -> tuple[Interface, ...]:
    """Interfaces between touching neighbours that never open."""
    return tuple(Interface(a.name, b.name, "bonded") for a, b in zip(regions[:-1], regions[1:]) if b.start <= a.end)


def profiled(material: str, faces: np.ndarray, velocity=None, density=None, pressure=None) -> tuple[Region, ...]:
    """One region per zone, for initial states that vary in space.

    faces: positions of the nodes; velocity: per node; density and pressure: per zone. Values left out keep the region's default.
    """
    regions = []
    for k, (left, right) in enumerate(zip(faces[:-1], faces[1:])):
        speed = 0.0 if velocity is None else (float(velocity[k]), float(velocity[k + 1]))
        regions.append(Region(f"zone {k + 1}", material, float(left), float(right), 1, velocity=speed,
                              density=None if density is None else float(density[k]),
                              pressure=None if pressure is None else float(pressure[k])))
    return tuple(regions)


def final_only(stop: float, snapshots: int = 1) -> OutputOptions:
    """Snapshots at `snapshots` equal intervals; no report."""
    return OutputOptions(snapshots=stop / snapshots, report=False)


def simple(title: str, stop: float, regions: tuple[Region, ...], materials: dict[str, Material], left: Boundary, right: Boundary,
           **more: Any) -> Problem:
    """A planar problem unless `geometry` says otherwise, its touching regions bonded."""
    geometry = more.pop("geometry", "planar")
    return Problem(title, geometry, stop, regions, materials, left, right, bonded(regions), output=final_only(stop), **more)
