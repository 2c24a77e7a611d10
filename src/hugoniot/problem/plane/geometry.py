"""From a block's table to its shape and velocity field, and back."""

import math
from pathlib import Path
from typing import Any

from hugoniot.errors import DeckError
from hugoniot.files import csv_rows, read_text
from hugoniot.materials.collect import Collector, printable
from hugoniot.mesh.shapes import SIDES, Box, Curve, Edges, Sector, Shape
from hugoniot.problem.plane.model import VelocityField
from hugoniot.problem.plane.tables import MOST_POINTS, BlockTable, CurveTable, VelocityTable
from hugoniot.problem.schema import validate
from hugoniot.units import UnitError, convert

_KEYS = {"sector": ("centre", "radius", "angle"), "edges": (*SIDES, "fill")}
_FULL_TURN = 2.0 * math.pi


def read_shape(row: BlockTable, axes: tuple[str, str], collector: Collector, path: tuple) -> Shape | None:
    """The shape a block's table describes; None after reporting what is wrong."""
    mine = axes if row.shape == "box" else _KEYS[row.shape]
    before = collector.findings
    for key in ("x", "y", "r", "z", *_KEYS["sector"], *_KEYS["edges"]):
        if getattr(row, key) is not None and key not in mine:
            other = key in ("x", "y", "r", "z") and row.shape == "box"
            hint = f"here the coordinates are {axes[0]} and {axes[1]}" if other else f"the shape {row.shape} has: {', '.join(mine)}"
            collector.add((*path, key), f"does not apply to a {row.shape} in {_word(axes)}", hint)
    needed = [key for key in mine if key not in ("centre", "fill")]
    for key in needed:
        if getattr(row, key) is None:
            collector.add((*path, key), "missing", f"the shape {row.shape} has: {', '.join(mine)}")
    if collector.findings > before:
        return None
    if row.shape == "box":
        return _box(row, axes, collector, path)
    return _sector(row, collector, path) if row.shape == "sector" else _edges(row, collector, path)


def _word(axes) -> str:
    return "axisymmetric geometry" if axes[0] == "r" else "plane geometry"


def _box(row, axes, collector, path) -> Box | None:
    for key in axes:
        low, high = getattr(row, key)
        if not high > low:
            collector.add((*path, key), f"must run from the smaller value to the larger, got {low:g} m to {high:g} m",
                          "exchange them" if low > high else 'for example ["0 mm", "5 mm"]')
            return None
    return Box(getattr(row, axes[0]), getattr(row, axes[1]))


def _sector(row, collector, path) -> Sector | None:
    (inner, outer), (start, end) = row.radius, row.angle
    if not 0.0 < inner < outer:
        collector.add((*path, "radius"), f"needs 0 < inner < outer radius, got {inner:g} m and {outer:g} m",
                      "zones would meet in a point at the centre: leave a small hole, or put a box there" if inner == 0.0 else
                      "exchange them" if inner > outer > 0.0 else 'for example ["8 cm", "10 cm"]')
        return None
    if not 0.0 < end - start <= _FULL_TURN * (1.0 + 1e-12):
        collector.add((*path, "angle"), f"must rise by at most a full turn, got {math.degrees(start):g} to {math.degrees(end):g} degrees",
                      'for example ["0 deg", "90 deg"]')
        return None
    return Sector(row.centre or (0.0, 0.0), row.radius, row.angle)


def _edges(row, collector, path) -> Edges | None:
    curves = {side: _curve(getattr(row, side), collector, (*path, side)) for side in SIDES}
    if any(curve is None for curve in curves.values()):
        return None
    return Edges(**curves, fill=row.fill or "transfinite")


def _curve(table: CurveTable, collector: Collector, path: tuple) -> Curve | None:
    given = [kind for kind in ("line", "arc", "polyline", "csv") if getattr(table, kind) is not None]
    if len(given) != 1:
        collector.add(path, "a curve is one of line, arc, polyline and csv" + (f", not {' and '.join(given)}" if given else ""))
        return None
    kind = given[0]
    if kind != "csv" and table.unit != "m":
        collector.add((*path, "unit"), "only the columns of csv have a unit of their own", "write it with each number")
        return None
    if table.spacing == "points" and kind not in ("polyline", "csv"):
        collector.add((*path, "spacing"), f"a {kind} has no points to use as nodes", "use a polyline or csv")
        return None
    points = _read_csv(table.csv, table.unit, collector, (*path, "csv")) if kind == "csv" else getattr(table, kind)
    wanted = {"line": 2, "arc": 3}.get(kind)
    if points is not None and wanted is not None and len(points) != wanted:
        collector.add((*path, kind), f"has {wanted} points, got {len(points)}")
        return None
    return None if points is None else Curve("polyline" if kind == "csv" else kind, points, table.spacing)


def _read_csv(name: str, unit: str, collector: Collector, path: tuple) -> tuple | None:
    """Points of a file of two columns; a first line that holds no numbers is its heading."""
    file = Path(name) if Path(name).is_absolute() else collector.folder / name
    try:
        factor = convert(1.0, unit, "m")
        rows = [(k, row) for k, row in csv_rows(read_text(file), name, most=2 * MOST_POINTS) if any(cell.strip() for cell in row)]
    except UnitError as error:
        collector.add((*path[:-1], "unit"), error.message, error.hint)
        return None
    except DeckError as error:
        collector.add(path, f"{printable(name)}:{error.problems[0].line}: {error.problems[0].message}", error.problems[0].hint)
        return None
    except (OSError, UnicodeDecodeError) as error:
        reason = (getattr(error, "strerror", None) or str(error)).removeprefix(f"{file}: ")      # the path would be there twice
        collector.add(path, f"cannot read '{printable(name)}': {printable(reason, 100)}")
        return None
    points = []
    for place, (k, row) in enumerate(rows):
        try:
            x, y = (float(cell) for cell in row)
            if not (math.isfinite(x) and math.isfinite(y)):
                raise ValueError
        except ValueError:
            if place == 0:
                continue
            collector.add(path, f"{printable(name)}:{k}: expected two finite numbers, got '{printable(','.join(row), 40)}'")
            return None
        points.append((x * factor, y * factor))
    if not 2 <= len(points) <= MOST_POINTS:
        collector.add(path, f"points in '{printable(name)}': {len(points)}", f"a curve has 2 to {MOST_POINTS}")
        return None
    return tuple(points)


def read_velocity(row: BlockTable, axes: tuple[str, str], collector: Collector, path: tuple) -> VelocityField | None:
    """The velocity field of a block; None after reporting what is wrong with it."""
    if isinstance(row.velocity, tuple):
        return VelocityField(base=row.velocity)
    table = validate(VelocityTable, row.velocity, collector, (*path, "velocity"))
    if table is None:
        return None
    motion = VelocityField(**table.model_dump())
    if axes[0] == "r" and motion.rotation != 0.0:
        collector.add((*path, "velocity", "rotation"), "does not apply to axisymmetric geometry, where nothing rotates", "leave it out")
        return None
    return motion


def shape_tables(shape: Shape, axes: tuple[str, str]) -> dict[str, Any]:
    """The keys of a block's table that describe a shape."""
    if isinstance(shape, Box):
        return {"shape": "box", axes[0]: list(shape.x), axes[1]: list(shape.y)}
    if isinstance(shape, Sector):
        return {"shape": "sector", "centre": list(shape.centre), "radius": list(shape.radius), "angle": list(shape.angle)}
    curves = {side: getattr(shape, side) for side in SIDES}
    return {"shape": "edges", "fill": shape.fill} | {
        side: {curve.kind: [list(p) for p in curve.points], "spacing": curve.spacing} for side, curve in curves.items()}


def velocity_table(motion: VelocityField) -> Any:
    """What a resolved deck writes for a velocity field."""
    if motion == VelocityField(base=motion.base):
        return list(motion.base)
    return {"base": list(motion.base), "centre": list(motion.centre), "gradient": [list(row) for row in motion.gradient],
            "radial": motion.radial, "radius": motion.radius, "power": motion.power, "rotation": motion.rotation}


