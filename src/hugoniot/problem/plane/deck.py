"""The deck of the two-dimensional hydrocode (solver.kind = "lagrange2d"): from tables that fit it to a `Problem2D` and back."""

from dataclasses import fields, replace
from typing import Any

from hugoniot.laws.fracture.contract import asked_at_nodes
from hugoniot.materials.collect import Collector, printable
from hugoniot.materials.material import Material
from hugoniot.materials.tables import material_tables
from hugoniot.mesh.blocks import Blocks, BlockShape, MeshError, build
from hugoniot.mesh.shapes import Sector
from hugoniot.mesh.triangles import divided
from hugoniot.problem import checks, output_fields
from hugoniot.problem.advice import advice_on_blocks
from hugoniot.problem.boundaries import pulse_value
from hugoniot.problem.lagrangian import MOST_ZONES, _output
from hugoniot.problem.model import OutputOptions
from hugoniot.problem.plane import explosives, geometry
from hugoniot.problem.plane.contact import (
    check_bodies,
    check_overlap,
    contact_tables,
    read_contacts,
    read_rigid,
    rigid_tables,
    trouble_on_the_axis,
)
from hugoniot.problem.plane.contact_model import apart
from hugoniot.problem.plane.edges import read_boundaries, read_gauges, read_lighting
from hugoniot.problem.plane.model import Block2D, Erosion2D, Problem2D, Solver2D, Viscosity2D
from hugoniot.problem.plane.tables import (
    BlockTable,
    BoundaryTable,
    ContactTable,
    GaugeTable,
    LightingTable,
    Model,
    RigidTable,
    SolverTable,
)
from hugoniot.problem.schema import Table, salvage

__all__ = ["Model", "read", "write"]

GAUGE_SAMPLES = 2000                 # of each gauge, and snapshots, in a run whose deck does not say otherwise
OF_TRIANGLES = ("diagonal", "average_pressure")
OF_STRONG_SHOCKS = ("linear_condensed", "solid_linear_condensed")
NO_FILTERS, NO_FLUX = {"subzonal_pressure": 0.0, "flanagan_belytschko": 0.0}, {"heat_flux": 0.0}
LARGE, FEW_SNAPSHOTS = 10_000, 20    # zones beyond which there are so few snapshots; else a hundred


def _have_radii(blocks) -> bool:
    """Whether blocks are written for axisymmetric geometry, which a deck then means whatever it calls it."""
    return isinstance(blocks, list) and any(isinstance(block, dict) and "r" in block for block in blocks)


def read(raw: dict, model: Model | None, materials: dict[str, Material | None], collector: Collector) -> tuple[Problem2D | None, list[str]]:
    """The problem, and warnings; the problem is None when anything was reported (see `problem.lagrangian.read`)."""
    warnings: list[str] = []
    radial = raw.get("geometry", "plane") == "axisymmetric" or raw.get("geometry", "plane") != "plane" and _have_radii(raw.get("block"))
    axes = ("r", "z") if radial else ("x", "y")
    blocks, used, complete = _read_blocks(raw, axes, materials, collector)
    names = [row.name for row in _parts(BlockTable, raw.get("block")) if row is not None]
    solids = _parts(RigidTable, raw.get("rigid"))
    rigid = read_rigid(solids, axes, names, collector)
    rows = _parts(ContactTable, raw.get("contact"))
    contacts = read_contacts(rows, names, [row.name for row in solids if row is not None], collector)
    mesh = _mesh(blocks, axes, contacts, salvage(SolverTable, raw.get("solver")), collector) if complete else None
    check_bodies(contacts, rows, mesh, rigid, collector)
    check_overlap(rigid, mesh, collector)
    boundaries = read_boundaries(_parts(BoundaryTable, raw.get("boundary")), mesh, collector)
    gauges = read_gauges(_parts(GaugeTable, raw.get("gauge")), mesh, collector)
    lighting = read_lighting(_parts(LightingTable, raw.get("lighting")), axes, collector)
    solver = _solver(raw.get("solver"), axes, blocks, mesh, collector)
    output = _output(raw, collector)
    for name in raw.get("material", {}) if isinstance(raw.get("material"), dict) else ():
        if name not in used and complete:
            warnings.append(f"material '{printable(name)}' of the deck is not used by any block")
    if model is None or collector.problems or solver is None or output is None:
        return None, warnings
    output = _sparing(output, raw.get("output", {}), model.stop_time, 0 if mesh is None else len(mesh.zone_nodes))
    problem = Problem2D(model.title, model.geometry, model.stop_time, blocks, used, boundaries, gauges, lighting, contacts, rigid,
                        model.body_force, solver, output)
    problem.__dict__["mesh"] = mesh   # built already: what the cached property would build again
    if axes[0] == "r" and model.body_force[0] != 0.0:
        collector.add(("body_force",), "a radial force is not uniform about the axis", "leave the first number 0")
    _check_axis_velocity(problem, collector)
    if solver.erosion and solver.erosion.plastic_strain is not None and all(material.strength is None for material in used.values()):
        collector.add(("solver", "erosion", "plastic_strain"), "has no effect: no material has strength, so that none has a plastic strain",
                      'use smallest_step, for example "0.1 ns"')
    if wrong := trouble_on_the_axis(problem):
        collector.add(("solver", "scheme"), wrong, 'write scheme = "true_volume"')
    for name, material in used.items():
        if asked_at_nodes(material.fracture):
            collector.add(("material", name, "fracture"), "opens voids at nodes, but in two dimensions zones fail and nodes stay joined",
                          'use "pressure_volume" or "spall_stress"')
    for defect in (*explosives.defects(problem), *output_fields.defects(problem.output, problem.blocks, problem.materials)):
        collector.add(*defect)
    if collector.problems:
        return None, warnings
    return problem, warnings + advice_on_blocks(problem) + explosives.advice(problem)


def _sparing(output: OutputOptions, given: dict, stop_time: float, zones: int) -> OutputOptions:
    """What is kept where the deck does not say: a gauge looks at the whole state here, and a snapshot of a large mesh is large."""
    if "gauge_interval" not in given:
        output = replace(output, gauge_interval=stop_time / GAUGE_SAMPLES)
    if "snapshots" not in given and zones > LARGE:
        output = replace(output, snapshots=stop_time / FEW_SNAPSHOTS)
    return output


def _parts(kind: type[Table], rows: Any) -> list:
    return [salvage(kind, row) for row in rows[:10_000]] if isinstance(rows, list) else []


def _read_blocks(raw, axes, own, collector: Collector) -> tuple[tuple[Block2D, ...], dict[str, Material], bool]:
    """Blocks in the deck's order, the materials they use, and whether every block of the deck could be read."""
    rows = _parts(BlockTable, raw.get("block"))
    found: list[Block2D] = []
    used: dict[str, Material] = {}
    failed: set[str] = set()
    seen: dict[str, int] = {}
    for i, row in enumerate(rows):
        path = ("block", i)
        if row is None:
            name = raw["block"][i].get("material") if isinstance(raw["block"][i], dict) else None
            if isinstance(name, str):
                checks.look_up(name, own, dict(used), failed, collector, (*path, "material"))
            continue
        before = collector.findings
        checks.check_name(row.name, seen, i, collector, path, kept="/.")
        checks.look_up(row.material, own, used, failed, collector, (*path, "material"))
        checks.check_state(row, used.get(row.material), collector, path)
        if min(row.ratio) <= 0.0:
            collector.add((*path, "ratio"), f"must be greater than 0, got {min(row.ratio):g}")
        shape = geometry.read_shape(row, axes, collector, path)
        motion = geometry.read_velocity(row, axes, collector, path)
        if shape is not None and motion is not None and collector.findings == before:
            found.append(Block2D(row.name, row.material, shape, row.zones, row.ratio, motion, row.density, row.pressure, row.temperature,
                                 row.energy))
    total = sum(block.zones[0] * block.zones[1] for block in found)
    if total > MOST_ZONES:
        collector.add(("block",), f"{total} zones in all are too many", f"the limit is {MOST_ZONES}")
        return tuple(found), used, False
    return tuple(found), used, bool(rows) and len(found) == len(rows)


def _mesh(blocks, axes, contacts, solver: SolverTable | None, collector: Collector) -> Blocks | None:
    try:
        shapes = [BlockShape(b.name, b.shape, b.zones, b.ratio) for b in blocks]
        mesh = build(shapes, axes[0] == "r", apart(contacts, [b.name for b in blocks]))
        triangles = solver is not None and solver.cells == "triangles"
        return divided(mesh, solver.diagonal or Solver2D.diagonal) if triangles else mesh
    except MeshError as error:
        for defect in error.defects:
            collector.add(("block", defect.block, defect.key), defect.message, defect.hint)
        return None


def _check_axis_velocity(problem: Problem2D, collector: Collector) -> None:
    if problem.geometry != "axisymmetric":
        return
    for k, (velocity, block) in enumerate(zip(problem.velocities(), problem.mesh.blocks)):
        off = (block.x == 0.0) & (velocity[0] != 0.0)
        if off.any():
            i, j = (int(n[0]) for n in off.nonzero())
            collector.add(("block", k, "velocity"), f"gives a radial velocity of {velocity[0, i, j]:g} m/s on the axis, at z = "
                                                    f"{block.y[i, j]:g} m",
                          "the radial velocity must be 0 there: put the centre of the radial part on the axis")


# -- solver ------------------------------------------------------------------------------------------------------------
def _solver(table: Any, axes, blocks, mesh: Blocks | None, collector: Collector) -> Solver2D | None:
    row = salvage(SolverTable, table)
    if row is None:
        return None
    if axes[0] == "x" and row.scheme is not None:
        collector.add(("solver", "scheme"), "applies to axisymmetric geometry only", 'write geometry = "axisymmetric", or leave it out')
    if row.viscosity.kind == "herrmann" and row.viscosity.limited:
        collector.add(("solver", "viscosity"), "Herrmann's viscosity has no limiter", "write limited = false with this kind")
    if row.viscosity.kind == "herrmann":
        if row.viscosity.solid_linear != Viscosity2D().solid_linear:
            collector.add(("solver", "viscosity", "solid_linear"), "does not apply to Herrmann's viscosity, which has one coefficient for "
                          "shocks and plastic flow", "use solid_shear")
        for key in (key for key in OF_STRONG_SHOCKS if key in row.viscosity.model_fields_set):
            collector.add(("solver", "viscosity", key), "does not apply to Herrmann's viscosity, which has one linear coefficient for weak "
                          "and strong shocks", "use solid_shear" if key.startswith("solid") else "use linear")
    _check_cells(row, table, collector)
    polar = bool(blocks) and all(isinstance(block.shape, Sector) for block in blocks)
    about_axis = polar and all(block.shape.centre[0] == 0.0 for block in blocks)
    own = row.model_dump(exclude={"hourglass", "viscosity", "erosion"}) | row.hourglass.model_dump()
    if row.cells == "triangles":
        own |= NO_FILTERS
    own |= {key: getattr(Solver2D, key) for key in OF_TRIANGLES if own[key] is None}
    own["scheme"] = row.scheme or ("area_weighted" if about_axis and axes[0] == "r" else "true_volume")
    if row.erosion is not None and row.erosion.plastic_strain is None and row.erosion.smallest_step is None:
        collector.add(("solver", "erosion"), "has no condition for removing a zone",
                      'for example plastic_strain = 1.5, or smallest_step = "0.1 ns"')
    erosion = None if row.erosion is None else Erosion2D(**row.erosion.model_dump())
    # what is not given follows what is, as `Viscosity2D` has it
    viscosity = row.viscosity.model_dump(exclude_unset=True) | ({} if row.cells == "quads" else NO_FLUX)
    return Solver2D(**own | {"viscosity": Viscosity2D(**viscosity), "erosion": erosion})


def _check_cells(row: SolverTable, table: dict, collector: Collector) -> None:
    """Report keys of one kind of cell where the other is asked for."""
    if row.cells == "quads":
        for key in OF_TRIANGLES:
            if getattr(row, key) is not None:
                collector.add(("solver", key), "applies to triangles only", 'write cells = "triangles", or leave it out')
        return
    if "heat_flux" in row.viscosity.model_fields_set:
        collector.add(("solver", "viscosity", "heat_flux"), "is computed between quadrilaterals only",
                      'leave it out, or write cells = "quads"')
    if row.erosion is not None:
        collector.add(("solver", "erosion"), "works with quads only", 'leave the table out, or write cells = "quads"')
    if "hourglass" in table:
        collector.add(("solver", "hourglass"), "triangles have no hourglass modes: they have one velocity gradient each",
                      "leave the table out, or write cells = \"quads\"")


# -- and back ----------------------------------------------------------------------------------------------------------
def write(problem: Problem2D) -> dict:
    """Tables of a deck, every default written out, that reads back to exactly this problem."""
    deck: dict[str, Any] = {"title": problem.title, "geometry": problem.geometry, "stop_time": problem.stop_time,
                            "body_force": list(problem.body_force)}
    deck["block"] = [_block_table(block, problem.axes) for block in problem.blocks]
    deck["material"] = {name: material_tables(m) for name, m in problem.materials.items()}
    boundaries = [_boundary_table(boundary) for boundary in problem.boundaries]
    gauges = [_listed({f.name: getattr(g, f.name) for f in fields(g) if f.name != "kind"}) for g in problem.gauges]
    for gauge, row in zip(problem.gauges, gauges):
        if gauge.kind == "slit":
            row["through"] = row.pop("at")
    lighting = [_listed({"at": point.at, "to": point.to, "time": point.time}) for point in problem.lighting]
    deck |= {key: rows for key, rows in (("boundary", boundaries), ("gauge", gauges), ("lighting", lighting),
                                       ("contact", contact_tables(problem.contacts)), ("rigid", rigid_tables(problem.rigid))) if rows}
    deck["solver"] = _solver_table(problem)
    output = {f.name: v for f in fields(problem.output) if (v := getattr(problem.output, f.name)) is not None}
    deck["output"] = output | {"fields": list(problem.output.fields)}
    if isinstance(problem.output.snapshots, tuple):
        deck["output"]["snapshots"] = list(problem.output.snapshots)
    return deck


def _listed(row: dict) -> dict:
    return {key: list(value) if isinstance(value, tuple) else value for key, value in row.items() if value is not None}


def _block_table(block: Block2D, axes) -> dict:
    state = {key: getattr(block, key) for key in ("density", "pressure", "temperature", "energy")}
    row = {"name": block.name, "material": block.material, "zones": list(block.zones), "ratio": list(block.ratio)}
    return _listed(row | state) | {"velocity": geometry.velocity_table(block.velocity)} | geometry.shape_tables(block.shape, axes)


def _boundary_table(boundary) -> dict:
    row = {"on": list(boundary.on), "kind": boundary.kind}
    if boundary.direction is not None:
        row["direction"] = list(boundary.direction)
    if boundary.kind in ("wall", "velocity"):
        row["slip"] = boundary.slip
    if boundary.separable:
        row["separable"] = True
    return row | ({} if boundary.pulse is None else {boundary.kind: pulse_value(boundary.pulse)})


def _solver_table(problem: Problem2D) -> dict:
    solver = problem.solver
    row = {f.name: v for f in fields(solver) if (v := getattr(solver, f.name)) is not None and f.name not in ("viscosity", "erosion")}
    if solver.erosion is not None:
        row["erosion"] = _listed({f.name: getattr(solver.erosion, f.name) for f in fields(solver.erosion)})
    row["hourglass"] = {key: row.pop(key) for key in NO_FILTERS}
    for key in OF_TRIANGLES if solver.cells == "quads" else ("hourglass",):
        del row[key]
    if problem.geometry == "plane":
        del row["scheme"]
    left_out = {*(() if solver.cells == "quads" else NO_FLUX), *(OF_STRONG_SHOCKS if solver.viscosity.kind == "herrmann" else ())}
    row["viscosity"] = {f.name: getattr(solver.viscosity, f.name) for f in fields(solver.viscosity) if f.name not in left_out}
    return row
