"""What a deck says of edges and places: boundaries on chains, gauges, detonators; checked against the mesh."""

import math
from collections.abc import Sequence

import numpy as np

from hugoniot.materials.collect import Collector, nearest, printable
from hugoniot.mesh.blocks import Blocks
from hugoniot.mesh.locate import crossings, find_zone
from hugoniot.mesh.shapes import SIDES
from hugoniot.problem.boundaries import read_pulse
from hugoniot.problem.plane.model import Boundary2D, Gauge2D, Lighting2D

_DRIVEN = {"velocity": "m/s", "pressure": "Pa"}
_EXAMPLES = {"velocity": '"100 m/s"', "pressure": '"1 GPa"'}
_SLIDING = ("wall", "velocity")


def unit_vector(direction, collector: Collector, path: tuple) -> tuple[float, float] | None:
    """The direction with length 1; None, reported, where it has none.

    One that has it to the last digits stays as it is, so that a resolved deck resolves to itself.
    """
    length = math.hypot(*direction)
    if length == 0.0:
        collector.add(path, "has no length", "give a vector such as [1, 0]")
        return None
    return direction if abs(length - 1.0) < 1e-15 else (direction[0] / length, direction[1] / length)


def _unknown_chain(name: str, mesh: Blocks, joints: bool = False) -> tuple[str, str]:
    """Message and hint of a name that is no chain of the mesh."""
    block, _, side = name.rpartition(".")
    known = [*mesh.chains, *(mesh.joints if joints else ())]
    if block in {b.name for b in mesh.blocks} and side in SIDES:
        others = ", ".join(f"'{joint}'" for joint in mesh.joints if block in joint.split("/"))
        return f"'{printable(name)}' is wholly joined to other blocks", f"its joints: {others}" if joints else "boundaries lie outside"
    if name in mesh.joints:
        a, b = name.split("/")
        return f"'{printable(name)}' is a joint inside the material", f"boundaries lie outside; '{a}' and '{b}' are joined there"
    return f"no side '{printable(name)}'", nearest(name, known)


def read_boundaries(rows: Sequence, mesh: Blocks | None, collector: Collector) -> tuple[Boundary2D, ...]:
    """Boundaries on chains that exist, each chain once, and of a kind that chain can have."""
    found: list[Boundary2D] = []
    seen: dict[str, int] = {}
    for i, row in enumerate(rows):
        if row is None:
            continue
        path = ("boundary", i)
        for name in row.on:
            if name in seen:
                where = "twice here" if seen[name] == i else f"by boundary {seen[name] + 1} already"
                collector.add((*path, "on"), f"'{printable(name)}' is named {where}", "each side has one boundary")
            seen.setdefault(name, i)
        boundary = _boundary(row, collector, path)
        if boundary is None:
            continue
        for name in row.on if mesh is not None else ():
            if name not in mesh.chains:
                collector.add((*path, "on"), *_unknown_chain(name, mesh))
            elif wrong := _wrong_kind(boundary, name, mesh):
                collector.add((*path, "kind"), *wrong)
        found.append(boundary)
    return tuple(found)


def _boundary(row, collector: Collector, path: tuple) -> Boundary2D | None:
    before = collector.findings
    for key in _DRIVEN:
        if (getattr(row, key) is not None) != (row.kind == key):
            if row.kind == key:
                collector.add((*path, key), "missing", f"for example {key} = {_EXAMPLES[key]}")
            else:
                hint = f'write kind = "{key}", or leave it out'
                collector.add((*path, key), f"does not apply to a boundary of kind {row.kind}", hint)
    if row.direction is not None and row.kind != "velocity":
        collector.add((*path, "direction"), f"does not apply to a boundary of kind {row.kind}", "it applies to a driven velocity only")
    if row.slip is not None and row.kind not in _SLIDING:
        collector.add((*path, "slip"), f"does not apply to a boundary of kind {row.kind}", "it applies to a wall or a driven velocity")
    if row.separable is not None and row.kind != "wall":
        collector.add((*path, "separable"), f"does not apply to a boundary of kind {row.kind}", "it applies to a wall")
    if row.separable and row.slip is False:
        collector.add((*path, "slip"), "a separable wall cannot keep nodes from sliding along it",
                      "leave it out, or use a [[rigid]] body and [[contact]] with friction")
    if collector.findings > before:
        return None
    direction = None if row.direction is None else unit_vector(row.direction, collector, (*path, "direction"))
    pulse = None
    if row.kind in _DRIVEN:
        pulse = read_pulse(getattr(row, row.kind), _DRIVEN[row.kind], collector, (*path, row.kind))
    if collector.findings > before:
        return None
    return Boundary2D(row.on, row.kind, pulse, direction, True if row.slip is None else row.slip, bool(row.separable))


def _wrong_kind(boundary: Boundary2D, name: str, mesh: Blocks) -> tuple[str, str] | None:
    chain = mesh.chains[name]
    if chain.on_axis:
        return None if boundary.kind == "axis" else (f"'{name}' lies on the axis, where no other boundary is possible", "leave it out")
    if boundary.kind == "axis":
        wanted = "lie on r = 0" if mesh.axisymmetric else "exist in axisymmetric geometry only"
        return f"'{name}' is not an axis: axes {wanted}", 'a plane of symmetry is kind = "wall"'
    if boundary.kind == "wall" and mesh.straight_normal(chain) is None:
        return f"'{name}' is not straight; a rigid wall must be", 'use kind = "velocity" with velocity = 0 and slip = false to clamp it'
    return None


def read_gauges(rows: Sequence, mesh: Blocks | None, collector: Collector) -> tuple[Gauge2D, ...]:
    """Gauges, each at a place that exists."""
    found: list[Gauge2D] = []
    names: set[str] = set()
    for i, row in enumerate(rows):
        if row is None:
            continue
        path = ("gauge", i)
        if row.name in names:
            collector.add((*path, "name"), f"another gauge has the name '{printable(row.name)}'", "names must differ")
        elif row.name != row.name.strip() or not row.name.isprintable():
            collector.add((*path, "name"), f"'{printable(row.name)}' is not a valid name", "use printable characters, no spaces at the "
                                                                                           "ends")
        names.add(row.name)
        gauge = _gauge(row, collector, path)
        if gauge is not None and mesh is not None and (wrong := _wrong_place(gauge, mesh)):
            collector.add((*path, "on" if gauge.on else "at"), *wrong)
        if gauge is not None:
            found.append(gauge)
    return tuple(found)


def _gauge(row, collector: Collector, path: tuple) -> Gauge2D | None:
    given = {key for key in ("at", "on", "through", "direction") if getattr(row, key) is not None}
    if given == {"at"}:
        return Gauge2D(row.name, "point", at=row.at)
    if given == {"on"}:
        return Gauge2D(row.name, "edge", on=" ".join(row.on.split()))
    if given == {"on", "through", "direction"}:
        direction = unit_vector(row.direction, collector, (*path, "direction"))
        return None if direction is None else Gauge2D(row.name, "slit", row.through, " ".join(row.on.split()), direction)
    has = f"; got {' and '.join(sorted(given))}" if given else ""
    collector.add(path, "a gauge needs one of: 'at' (a material point), 'on' (the mean over a side), or 'on', 'through' and 'direction' "
                  f"(a line of sight){has}",
                  'for example at = ["1 mm", "2 mm"]')
    return None


def _wrong_place(gauge: Gauge2D, mesh: Blocks) -> tuple[str, str] | None:
    if gauge.kind == "point":
        if find_zone(mesh.nodes, mesh.zone_nodes, gauge.at) is not None:
            return None
        low, high = mesh.nodes.min(axis=1), mesh.nodes.max(axis=1)
        spans = f"the blocks lie within ({low[0]:g}, {low[1]:g}) to ({high[0]:g}, {high[1]:g}) m"
        return f"no material at ({gauge.at[0]:g}, {gauge.at[1]:g}) m", spans
    if gauge.on in mesh.joints and gauge.kind == "edge":
        return None
    if gauge.on not in mesh.chains:
        return _unknown_chain(gauge.on, mesh, joints=gauge.kind == "edge")
    if gauge.kind == "slit" and not crossings(mesh.nodes, mesh.chains[gauge.on].edges, gauge.at, gauge.direction).size:
        ends = mesh.nodes[:, mesh.chains[gauge.on].nodes[[0, -1]]].T
        where = " to ".join(f"({x:g}, {y:g})" for x, y in np.asarray(ends))
        return f"the line of sight does not cross '{printable(gauge.on)}' at t = 0", f"that side runs from {where} m"
    return None


def read_lighting(rows: Sequence, axes: tuple[str, str], collector: Collector) -> tuple[Lighting2D, ...]:
    """Detonators; whether they stand in an explosive is checked with the whole problem."""
    found = []
    for i, row in enumerate(rows):
        if row is None:
            continue
        if axes[0] == "r" and min(p[0] for p in (row.at, row.to) if p is not None) < 0.0:
            collector.add(("lighting", i, "at"), "has a negative radius", "radii are not negative; the axis is r = 0")
        found.append(Lighting2D(row.at, row.time, row.to))
    return tuple(found)
