"""The deck of the solver `shock_structure`: viscous flow of one material through a fixed grid, with or without a shock placed in it."""

from dataclasses import replace
from types import MappingProxyType
from typing import Annotated, Any, Literal

from pydantic import Field, WithJsonSchema

from hugoniot.errors import OutOfRange
from hugoniot.laws import transport as _transport  # noqa: F401  (enrols the transport laws)
from hugoniot.laws.eos.contract import has_temperature
from hugoniot.laws.transport.contract import CONDUCTION, TRANSPORT, make, needs_temperature
from hugoniot.materials.collect import Collector, printable
from hugoniot.materials.law_reader import read_law
from hugoniot.materials.material import Material
from hugoniot.materials.tables import law_table, material_tables
from hugoniot.problem import checks
from hugoniot.problem.advice import unlikely_constants
from hugoniot.problem.defaults import completed
from hugoniot.problem.lagrangian import OutputTable, Positive, UniformRegionTable, _known, _output, _parts
from hugoniot.problem.model import Boundary, Problem, SolverOptions
from hugoniot.problem.schema import Length, Quantity, Table, salvage

_LAW = {"type": "object", "required": ["law"]}


class TransportTable(Table):
    """Physical viscosity and heat conduction of the material."""

    viscosity: Annotated[Any, WithJsonSchema(_LAW)] = Field(description="shear viscosity, a table {law = \"...\", ...} (hugoniot list "
        "transport)")
    conduction: Annotated[Any, WithJsonSchema(_LAW)] = Field(None, description="heat conduction, a table {law = \"...\", ...} "
        "(hugoniot list conduction) (default: none)")
    bulk_ratio: Annotated[float, Quantity("1", least=0.0)] = Field(0.0, description="bulk viscosity divided by shear viscosity")
    bulk_viscosity: Annotated[float, Quantity("Pa s", least=0.0)] = Field(0.0, description="constant that is added to the bulk viscosity")


class ShockTable(Table):
    """A shock in the domain at t = 0. The material ahead of it is on the left and has the state of the first region.

    Give exactly one of mach, shock_velocity, particle_velocity and pressure.
    """

    mach: Annotated[float, Quantity("1", above=1.0, limit=1e6)] | None = Field(None, description="Mach number of the shock")
    shock_velocity: Annotated[float, Quantity("m/s", above=0.0)] | None = Field(None,
        description="speed of the shock relative to the material ahead")
    particle_velocity: Annotated[float, Quantity("m/s", above=0.0)] | None = Field(None,
        description="jump of the particle velocity across the shock")
    pressure: Annotated[float, Quantity("Pa", above=0.0)] | None = Field(None, description="pressure behind the shock")
    at: Length | None = Field(None, description="position of the shock at t = 0 (default: the middle of the domain)")
    start: Literal["step", "steady"] = Field("step", description="step: the run starts with a discontinuity; steady: with the profile "
        "of the steady shock")
    frame: Literal["standing", "moving"] = Field(
        "standing", description="standing: in the frame of the shock, which stays in place; moving: the material ahead has the "
        "velocity of its region, and the shock runs to the left")


class SolverTable(Table):
    """Options of the solver."""

    kind: Literal["shock_structure"] = Field(description="name of the solver")
    courant: Annotated[float, Quantity("1", above=0.0, limit=1.0)] | None = Field(None,
        description="Courant number of the time step (default: 0.9)")
    largest_step: Positive | None = Field(None, description="upper limit of the time step (default: none)")
    max_cycles: int | None = Field(None, ge=1, le=10**15, description="number of time steps after which the run stops (default: no limit)")
    transport: TransportTable = Field(description="physical viscosity and heat conduction, [solver.transport]")
    shock: ShockTable | None = Field(None, description="a shock at t = 0, [solver.shock] (default: none; the run starts from the "
        "states of the regions)")


class EndTables(Table):
    """What happens at the left and right end of the domain."""

    left: Literal["transmitting", "fixed"] = Field("transmitting", description="left end: transmitting lets waves pass, fixed is a wall")
    right: Literal["transmitting", "fixed"] = Field("transmitting", description="right end, in the same way")


class Model(Table):
    """The solver `shock_structure` computes the flow of one viscous, heat-conducting fluid through a fixed planar mesh.

    Use it to resolve the internal structure of a shock. The regions must touch, be of one material and have zones of equal width. Strength
    and fracture are not supported, and there are no gauges.
    """

    title: str = Field("", max_length=200, description="title of the report and plots (default: the deck's file name)")
    geometry: Literal["planar"] = Field("planar", description="symmetry, always planar")
    stop_time: Positive = Field(description="time at which the run ends, such as \"100 ns\"")
    region: list[UniformRegionTable] = Field(min_length=1, max_length=1000, description="parts of the domain, [[region]]")
    material: dict[str, Annotated[Any, WithJsonSchema({"x-definition": "material"})]] = Field(
        default_factory=dict, description="the material, if this deck defines it, [material.NAME]")
    boundary: EndTables = Field(default_factory=EndTables, description="the two ends, [boundary]")  # type: ignore[arg-type]
    solver: SolverTable = Field(description="the solver and its options, [solver]")
    output: OutputTable = Field(default_factory=OutputTable, description="what is stored, [output]")  # type: ignore[arg-type]


def read(raw: dict, model: Model | None, materials: dict[str, Material | None], collector: Collector) -> tuple[Problem | None, list[str]]:
    """The problem, and warnings; the problem is None when anything was reported (see `problem.lagrangian.read`)."""
    warnings: list[str] = []
    rows = _parts(UniformRegionTable, raw.get("region"))
    regions, used = checks.read_regions(rows, raw.get("region"), "planar", materials, collector, warnings)
    _check_grid(regions, used, collector)
    used = {name: _as_fluid(name, material, raw.get("material"), collector, warnings) for name, material in used.items()}
    table = raw.get("solver")
    table = table if isinstance(table, dict) else {}
    transport = _read_transport(table.get("transport"), used, collector)
    shock = _read_shock(table.get("shock"), regions, collector)
    output = _output(raw, collector)
    if model is None or collector.problems or transport is None or output is None:
        return None, warnings
    options: dict[str, Any] = {"transport": transport}
    if shock is not None:
        options["shock"] = shock
    solver = SolverOptions("shock_structure", courant=model.solver.courant, largest_step=model.solver.largest_step,
                           max_cycles=model.solver.max_cycles, options=MappingProxyType(options))
    left, right = Boundary(model.boundary.left), Boundary(model.boundary.right)
    problem = Problem(model.title, "planar", model.stop_time, regions, used, left, right, solver=solver, output=output)
    return completed(problem), warnings + unlikely_constants(problem)


def _as_fluid(name: str, material: Material, tables: Any, collector: Collector, warnings: list[str]) -> Material:
    """The material as the fluid this solver flows.

    Strength, fracture and burning are refused where the deck asks for them; what comes with a name of the library is left out with a
    warning, but for burning, without which an explosive is another material.
    """
    own = tables.get(name) if isinstance(tables, dict) else None
    shown = printable(name)
    for family in ("strength", "fracture", "burn"):
        if getattr(material, family) is None:
            continue
        path = ("material", name, family) if isinstance(own, dict) and family in own else None
        if path or family == "burn":
            collector.add(path or ("material", name), f"'{shown}': {family} has no effect in shock_structure, which treats a viscous fluid",
                          "use solver kind lagrange1d, or " + ("leave the table out" if path else 'give the material burn = "none"'))
        else:
            warnings.append(f"'{shown}' is treated as a viscous fluid: shock_structure ignores its {family} from the library")
    return replace(material, strength=None, fracture=None)


def _check_grid(regions, used, collector: Collector) -> None:
    if len(used) > 1:
        collector.add(("region", 1, "material"), f"this solver treats one material on a fixed grid, not {len(used)}",
                      "use solver kind lagrange1d for several")
    for k, (a, b) in enumerate(zip(regions, regions[1:])):
        if a.end != b.start:
            collector.add(("region", k + 1, "from"), f"a gap after '{printable(a.name)}'", "the regions of this solver must touch")
    for k, region in enumerate(regions):
        width, first = (region.end - region.start) / region.zones, (regions[0].end - regions[0].start) / regions[0].zones
        if region.ratio != 1.0:
            collector.add(("region", k, "ratio"), f"each cell is {region.ratio:g} times as wide as the one before",
                          "this solver needs cells of equal width: leave ratio out")
        elif abs(width / first - 1.0) > 1e-9:
            collector.add(("region", k, "zones"), f"cells of {width:.6g} m and of {first:.6g} m", "this solver needs cells of equal width")


def _read_transport(raw: Any, used: dict[str, Material], collector: Collector) -> dict | None:
    """{"viscosity": {law, parameters}, "conduction": ..., "bulk_ratio", "bulk_viscosity"} in SI, or None after reporting."""
    path = ("solver", "transport")
    if not isinstance(raw, dict) or "viscosity" not in raw:
        return None   # the model has told it
    shear = read_law(TRANSPORT, raw["viscosity"], collector, (*path, "viscosity"))
    given = raw.get("conduction", "none")
    conduction = CONDUCTION.get("none").example if given == "none" else read_law(CONDUCTION, given, collector, (*path, "conduction"))
    table = salvage(TransportTable, raw)
    if shear is None or conduction is None or table is None:
        return None
    try:
        made = make(shear, conduction, table.bulk_ratio, table.bulk_viscosity)
    except OutOfRange as error:
        collector.add(path, str(error))
        return None
    for material in used.values():
        if needs_temperature(made) and not has_temperature(material.eos):
            collector.add(path, f"needs a temperature, which the equation of state of '{printable(material.name)}' does not give",
                          "give it a specific_heat, or a constant viscosity without conduction")
    return {"viscosity": law_table(TRANSPORT, shear), "conduction": law_table(CONDUCTION, conduction),
            "bulk_ratio": table.bulk_ratio, "bulk_viscosity": table.bulk_viscosity}


def _read_shock(raw: Any, regions, collector: Collector) -> dict | None:
    table = salvage(ShockTable, raw) if isinstance(raw, dict) else None
    if table is None:
        return None
    measures = [name for name in ("mach", "shock_velocity", "particle_velocity", "pressure") if getattr(table, name) is not None]
    if len(measures) != 1:
        collector.add(("solver", "shock"), "a shock needs exactly one measure of strength"
                      + (f", not {' and '.join(measures)}" if measures else ""),
                      "give mach, shock_velocity, particle_velocity or pressure")
        return None
    shock = {name: value for name, value in table.model_dump().items() if value is not None}
    _check_states(regions, shock["frame"], collector)
    if regions:
        left, right = regions[0].start, regions[-1].end
        shock.setdefault("at", 0.5 * (left + right))
        if not left < shock["at"] < right:
            collector.add(("solver", "shock", "at"), f"{shock['at']:g} m lies outside the domain from {left:g} m to {right:g} m")
    return shock


def _check_states(regions, frame: str, collector: Collector) -> None:
    """States that a shock would replace: the material ahead has that of the first region, all else follows from the shock."""
    for k, region in enumerate(regions):
        if k:
            for name in ("density", "pressure", "temperature", "energy"):
                if getattr(region, name) not in (None, getattr(regions[0], name)):
                    collector.add(("region", k, name), "has no effect: [solver.shock] sets the states of all regions, from that of the "
                                  "first one and the strength of the shock", "leave it out, or leave [solver.shock] out")
        ahead = regions[0].velocity if k else 0.0
        if frame == "standing" and region.velocity not in (0.0, (0.0, 0.0)):
            collector.add(("region", k, "velocity"), "has no effect: the shock stands, and the velocities ahead of it and behind follow",
                          'leave it out, or give solver.shock.frame = "moving"')
        elif (k and region.velocity not in (0.0, ahead)) or (isinstance(region.velocity, tuple) and len(set(region.velocity)) > 1):
            collector.add(("region", k, "velocity"), "has no effect: the material ahead has the velocity at the left end of the first "
                          "region, that behind the shock follows", "give the first region one velocity, the others none")


def write(problem: Problem) -> dict:
    """Tables of a deck, every default written out, that reads back to exactly this problem."""
    names = {"start": "from", "end": "to"}
    deck: dict[str, Any] = {"title": problem.title, "geometry": "planar", "stop_time": problem.stop_time}
    deck["region"] = [{names.get(k, k): list(v) if isinstance(v, tuple) else v for k, v in _known(r).items()} for r in problem.regions]
    deck["material"] = {name: material_tables(m) for name, m in problem.materials.items()}
    deck["boundary"] = {"left": problem.left.kind, "right": problem.right.kind}
    options = problem.solver.options
    wanted = ("kind", "courant", "largest_step", "max_cycles")
    deck["solver"] = {k: v for k in wanted if (v := getattr(problem.solver, k)) is not None}
    deck["solver"]["transport"] = _plain(options["transport"])
    if options.get("shock"):
        deck["solver"]["shock"] = dict(options["shock"])
    output = _known(problem.output)
    output["fields"] = list(problem.output.fields)
    if isinstance(problem.output.snapshots, tuple):
        output["snapshots"] = list(problem.output.snapshots)
    deck["output"] = output
    return deck


def _plain(transport) -> dict:
    if not isinstance(transport, dict):   # a Transport tuple given in Python
        return {"viscosity": law_table(TRANSPORT, transport.shear), "conduction": law_table(CONDUCTION, transport.conduction),
                "bulk_ratio": transport.bulk_ratio, "bulk_viscosity": transport.bulk_viscosity}
    return {name: dict(value) if isinstance(value, dict) else value for name, value in transport.items()}
