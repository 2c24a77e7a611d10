"""The deck of the solver `lagrange1d`: its shape, and the way from a deck that fits it to a `Problem` and back."""

from dataclasses import fields, replace
from types import MappingProxyType
from typing import Annotated, Any, Literal

from pydantic import BeforeValidator, Field, WithJsonSchema

from hugoniot.laws.viscosity.contract import VISCOSITY
from hugoniot.materials.collect import Collector, printable
from hugoniot.materials.law_reader import read_law
from hugoniot.materials.material import Material
from hugoniot.materials.tables import law_table, material_tables
from hugoniot.problem import checks, explosives, output_fields, periodic, terms, windows
from hugoniot.problem.advice import advice
from hugoniot.problem.boundaries import boundary_schema, boundary_value, read_boundary
from hugoniot.problem.defaults import SNAPSHOTS, completed, whole_viscosity
from hugoniot.problem.gauges import misnamed
from hugoniot.problem.model import Boundary, Lighting, OutputOptions, Problem, SolverOptions
from hugoniot.problem.profiles import ProfileTable, profile_value
from hugoniot.problem.schema import Length, Pressure, Quantity, Table, Time, salvage, trouble
from hugoniot.units import UnitError, parse

Positive = Annotated[float, Quantity("s", above=0.0, limit=1e15)]
MOST_ZONES = 10_000_000
MOST_SNAPSHOTS = 100_000
MOST_GAUGES = 10_000


def _velocity(value: Any) -> float | tuple[float, float]:
    if isinstance(value, list) and len(value) != 2:
        raise trouble(f"expected one velocity or two (at the start and the end of the region), got an array of {len(value)}")
    try:
        numbers = [parse(v, "m/s") for v in (value if isinstance(value, list) else [value])]
    except UnitError as error:
        raise trouble(error.message, error.hint) from None
    if max(map(abs, numbers)) > 299792458.0:
        raise trouble(f"unreasonably large: {max(map(abs, numbers)):g} m/s is faster than light")
    return numbers[0] if len(numbers) == 1 else (numbers[0], numbers[1])


def _place(value: Any) -> float | str:
    if isinstance(value, str) and (":" in value or not value.strip()[:1].isdigit() and value.strip()[:1] not in ("+", "-", ".")):
        return " ".join(value.split()) if len(value) < 200 else printable(value)
    try:
        return parse(value, "m")
    except UnitError as error:
        raise trouble(error.message, error.hint) from None


def _times(value: Any) -> float | tuple[float, ...]:
    if isinstance(value, list) and len(value) > MOST_SNAPSHOTS:
        raise trouble(f"{len(value)} snapshots are too many", f"the limit is {MOST_SNAPSHOTS}")
    try:
        times = tuple(parse(v, "s") for v in (value if isinstance(value, list) else [value]))
    except UnitError as error:
        raise trouble(error.message, error.hint) from None
    if not isinstance(value, list):
        if not times[0] > 0.0:
            raise trouble(f"the interval between snapshots must be greater than 0, got {printable(value)!r}")
        return times[0]
    if any(b <= a for a, b in zip(times, times[1:])):
        raise trouble("the times of snapshots must increase")
    return times


_one_or_more = {"anyOf": [{"type": "number"}, {"type": "string"}, {"type": "array", "items": {"type": ["number", "string"]}}]}


Snapshots = Annotated[Any, BeforeValidator(_times), WithJsonSchema(_one_or_more | {"unit": "s"})]


class UniformRegionTable(Table):
    """A region in one state."""

    name: str = Field(min_length=1, max_length=60, description="name of the region, used by gauges, interfaces, messages and plots")
    material: str = Field(min_length=1, max_length=200, description="NAME of a table [material.NAME] of this deck, or else a material "
        "of the library")
    start: Length = Field(alias="from", description="position of the left end at t = 0 (in curved geometry, the inner radius)")
    end: Length = Field(alias="to", description="position of the right end at t = 0; a gap before the next region closes on impact")
    zones: int | None = Field(None, ge=1, le=MOST_ZONES, description="number of zones; give either this or zone_size")
    zone_size: Annotated[float, Quantity("m", above=0.0)] | None = Field(
        None, description="width of the first (leftmost) zone; give either this or zones")
    ratio: Annotated[float, Quantity("1", above=0.0, limit=10.0)] = Field(
        1.0, description="width of each zone divided by that of its left neighbour")
    velocity: Annotated[Any, BeforeValidator(_velocity), WithJsonSchema(_one_or_more | {"unit": "m/s"})] = Field(
        0.0, description="initial velocity, positive to the right; an array of two gives the velocities at the left and right end, "
        "linear in between")
    density: Annotated[float, Quantity("kg/m^3", above=0.0)] | None = Field(None, description="initial density")
    pressure: Pressure | None = Field(None, description="initial pressure")
    temperature: Annotated[float, Quantity("K", above=0.0, limit=1e12)] | None = Field(
        None, description="initial temperature; the equation of state must give temperatures")
    energy: Annotated[float, Quantity("J/kg")] | None = Field(None, description="initial specific internal energy")


class RegionTable(UniformRegionTable):
    """A layer of one material at t = 0, divided into zones. A state takes at most two of density, pressure, temperature and energy.

    Without any of them the region starts in the reference state of its equation of state (for solids and liquids, the reference density
    at zero pressure). One of pressure, temperature and energy goes with the reference density; density alone goes with zero pressure.
    """

    profile: ProfileTable | None = Field(None, description="initial state that varies along the region, [region.profile]")


class InterfaceTable(Table):
    """Whether two neighbouring regions can separate. Neighbours without an entry are separable."""

    between: list[str] = Field(min_length=2, max_length=2, description="names of the two regions")
    kind: Literal["bonded", "separable", "bond"] = Field(
        "separable", description="separable: opens under any tension; bonded: never opens by itself, only where a fracture law breaks "
        "a material (regions with a gap between them bond when they meet); bond: opens when the tension exceeds strength")
    strength: Annotated[float, Quantity("Pa", above=0.0)] | None = Field(
        None, description="tensile stress that breaks the interface; required for kind bond, not allowed otherwise")


class GaugeTable(Table):
    """A Lagrangian gauge, which moves with the material.

    A free end without a gauge gets one automatically (in curved geometry, the outer end). A gauge at an interface adds two more,
    NAME left and NAME right, in the zones on its two sides.
    """

    name: str = Field(min_length=1, max_length=checks.LONGEST_NAME, description="name of the gauge in gauges.csv and plots")
    at: Annotated[Any, BeforeValidator(_place), WithJsonSchema({"type": ["number", "string"], "unit": "m"})] = Field(
        description="position at t = 0, or one of these strings: \"free surface left\", \"free surface right\", \"LEFT/RIGHT\" (the "
        "interface of two regions, left one first), \"REGION:left\", \"REGION:right\" (an end of a region)")
    window: str | None = Field(
        None, min_length=1, max_length=60, description="for a gauge at an interface in planar geometry: the first or last region, "
        "through which an interferometer looks; the gauge then also records apparent_velocity")
    window_factor: Annotated[float, Quantity("1", least=1.0, limit=5.0)] | None = Field(
        None, description="constant a of the window's refractive index n = a + b rho; needs window, excludes wavelength (default: the "
        "library's value)")
    wavelength: Annotated[float, Quantity("m", least=2e-7, limit=1e-5)] | None = Field(
        None, description="wavelength of the light, for which a is taken from the library; needs window (default: 532 nm)")


class LightingTable(Table):
    """A detonator: where and when a programmed burn starts. Every body of explosive with a programmed burn law needs one."""

    at: Length = Field(description="position at t = 0, inside the explosive or at its end (in curved geometry, a radius)")
    time: Time = Field(0.0, description="time at which the detonator fires")


class BoundaryTables(Table):
    """What happens at the left and right end of the problem; see \"Boundaries and pulses\"."""

    left: Annotated[Any, WithJsonSchema(boundary_schema())] = Field(
        "free", description="condition at the left end; omit it where the first region starts at the axis or centre of curved geometry")
    right: Annotated[Any, WithJsonSchema(boundary_schema())] = Field("free", description="condition at the right end")


class OptionsTable(Table):
    """Further options of lagrange1d."""

    heat_flux: Annotated[float, Quantity("1", least=0.0)] | None = Field(
        None, description="coefficient of the artificial heat flux in shocks; 0 switches it off (default: 0.5; wilkins: 0)")


class SolverTable(Table):
    """Options of the solver. The table is optional for lagrange1d."""

    kind: Literal["lagrange1d"] = Field("lagrange1d", description="name of the solver")
    integrator: Literal["compatible", "wilkins"] = Field(
        "compatible", description="compatible: conserves total energy to round-off; wilkins: the classical leapfrog scheme of Wilkins")
    courant: Annotated[float, Quantity("1", above=0.0, limit=1.0)] | None = Field(
        None, description="Courant number of the time step (default: 0.5, or 0.7 if all materials are inert solids or liquids and no "
        "viscosity is given; wilkins: 2/3)")
    growth: Annotated[float, Quantity("1", least=1.0, limit=10.0)] = Field(
        1.1, description="largest ratio of a time step to the one before")
    initial_step: Positive | None = Field(None, description="first time step (default: from the Courant condition)")
    largest_step: Positive | None = Field(None, description="upper limit of the time step (default: none)")
    threads: int = Field(1, ge=1, le=1024, description="number of threads; the result is the same, bit for bit, for any number")
    max_cycles: int | None = Field(None, ge=1, le=10**15, description="number of time steps after which the run stops (default: no limit)")
    viscosity: Any = Field(None, description="artificial viscosity, [solver.viscosity], with law = \"...\" and its parameters "
        "(default: law limited; wilkins: law wilkins)",
                           json_schema_extra={"x-definition": "viscosity_law"})
    options: OptionsTable = Field(default_factory=lambda: OptionsTable(heat_flux=None), description="further options, [solver.options]")


class OutputTable(Table):
    """What a run stores, and how often."""

    snapshots: Snapshots = Field(
        None, description="time between snapshots of all zones, or an array of their times (default: a hundredth of stop_time)")
    fields: list[str] = Field(default_factory=list, max_length=50, description="names of the fields stored in each snapshot (hugoniot "
        "list fields); positions and velocities are always stored (default: the usual fields of the solver)")
    gauge_interval: Annotated[float, Quantity("s", least=0.0)] = Field(
        0.0, description="time between samples of the gauges; 0: a sample at every time step")
    checkpoint_seconds: Annotated[float, Quantity("s", above=0.0)] = Field(
        30.0, description="wall-clock time between checkpoints, from which hugoniot resume continues")
    checkpoint_cycles: int | None = Field(
        None, ge=1, le=10**15, description="number of time steps between checkpoints (default: by wall-clock time only)")
    report: bool = Field(True, description="whether report.html is written at the end")


class Model(terms.TermTables):
    """The solver `lagrange1d` is the one-dimensional Lagrangian hydrocode, whose mesh moves with the material.

    Use it for plates, cylinders and spheres with strength, fracture, porosity and burning.
    """

    title: str = Field("", max_length=200, description="title of the report and plots (default: the deck's file name)")
    geometry: Literal["planar", "cylindrical", "spherical"] = Field(
        "planar", description="symmetry; positions are radii in cylindrical and spherical geometry")
    stop_time: Positive = Field(description="time at which the run ends, such as \"2.5 us\"")
    region: list[RegionTable] = Field(min_length=1, max_length=100_000, description="the layers of material, [[region]]")
    material: dict[str, Annotated[Any, WithJsonSchema({"x-definition": "material"})]] = Field(
        default_factory=dict, description="materials defined in this deck, [material.NAME]")
    boundary: BoundaryTables = Field(default_factory=lambda: BoundaryTables(), description="the two ends, [boundary]")
    interface: list[InterfaceTable] = Field(
        default_factory=list, max_length=100_000, description="interfaces that are not simply separable, [[interface]]")
    gauge: list[GaugeTable] = Field(default_factory=list, max_length=MOST_GAUGES, description="Lagrangian gauges, [[gauge]]")
    lighting: list[LightingTable] = Field(default_factory=list, max_length=10_000, description="detonators, [[lighting]]")
    solver: SolverTable = Field(default_factory=SolverTable, description="the solver and its options, [solver]")  # type: ignore[arg-type]
    output: OutputTable = Field(default_factory=OutputTable, description="what is stored, [output]")  # type: ignore[arg-type]


def read(raw: dict, model: Model | None, materials: dict[str, Material | None], collector: Collector) -> tuple[Problem | None, list[str]]:
    """The problem, and warnings; the problem is None when anything was reported.

    raw, model   the parsed deck, and the model of it (None if it did not fit: then whatever parts do fit are still checked)
    materials    the deck's own materials, None for one that could not be built
    """
    warnings: list[str] = []
    geometry = raw.get("geometry", "planar")
    tables = {name: _parts(kind, raw.get(name)) for name, kind in
              (("region", RegionTable), ("interface", InterfaceTable), ("gauge", GaugeTable))}
    regions, used = checks.read_regions(tables["region"], raw.get("region"), geometry, materials, collector, warnings)
    broken = checks.unread(raw.get("region"), regions)
    interfaces = checks.read_interfaces(tables["interface"], regions, collector, broken)
    gauges = checks.read_gauges(tables["gauge"], () if broken else regions, used, collector)
    left, right = _ends(raw, geometry, regions, collector)
    solver = _solver(raw.get("solver", {}), collector)
    output = _output(raw, collector)
    more = terms.read_terms(raw, collector)
    for name in raw.get("material", {}) if isinstance(raw.get("material"), dict) else ():
        if name not in used and regions and not broken:
            warnings.append(f"material '{printable(name)}' of the deck is not used by any region")
    if model is None or collector.problems or left is None or right is None or solver is None or output is None:
        return None, warnings
    lighting = tuple(Lighting(row.at, row.time) for row in model.lighting)
    problem = completed(Problem(model.title, model.geometry, model.stop_time, regions, used, left, right, interfaces, gauges, solver,
                                output, lighting, **more))
    if len(problem.gauges) > MOST_GAUGES:
        collector.add(("gauge",), f"{len(problem.gauges)} gauges are too many (those beside interfaces and on free surfaces are counted)",
                      f"the limit is {MOST_GAUGES}")
    asked = replace(problem, gauges=gauges)      # in the order of the deck, which places are counted by
    for defect in (*explosives.defects(problem), *periodic.defects(problem), *terms.defects(problem), *windows.defects(asked),
                   *misnamed(asked), *output_fields.defects(problem.output, problem.regions, problem.materials)):
        collector.add(*defect)
    if collector.problems:
        return None, warnings
    return problem, warnings + advice(problem) + explosives.advice(problem) + windows.advice(problem)


def _parts(kind: type[Table], rows: Any) -> list:
    return [salvage(kind, row) for row in rows[:100_000]] if isinstance(rows, list) else []


def _ends(raw: dict, geometry: Any, regions: tuple, collector: Collector) -> tuple[Boundary | None, Boundary | None]:
    table = raw.get("boundary", {})
    table = table if isinstance(table, dict) else {}
    at_centre = geometry in ("cylindrical", "spherical") and regions and regions[0].start == 0.0
    ends = [read_boundary(table.get(side, "fixed" if side == "left" and at_centre else "free"), collector, ("boundary", side))
            for side in ("left", "right")]
    if at_centre and ends[0] is not None and ends[0].pulse is not None:
        collector.add(("boundary", "left"), f"nothing can be driven at the {'axis' if geometry == 'cylindrical' else 'origin'}, r = 0",
                      "omit it, or start the region at a radius")
    return ends[0], ends[1]


def _solver(table: Any, collector: Collector) -> SolverOptions | None:
    viscosity = None
    if isinstance(table, dict) and "viscosity" in table:
        given = table["viscosity"]
        par = read_law(VISCOSITY, given, collector, ("solver", "viscosity"))
        if par is not None:
            values = law_table(VISCOSITY, par)
            given = given.get("parameters", given)
            viscosity = whole_viscosity(values.pop("law"), {key: value for key, value in values.items() if key in given})
    model = salvage(SolverTable, table)
    if model is None:
        return None
    own = {name: value for name, value in model.options.model_dump().items() if value is not None}
    return SolverOptions(**model.model_dump() | {"viscosity": viscosity, "options": MappingProxyType(own)})


def _output(raw: dict, collector: Collector) -> OutputOptions | None:
    model = salvage(OutputTable, raw.get("output", {}))
    if model is None:
        return None
    for i, name in enumerate(model.fields):
        if (wrong := output_fields.trouble_with(name, raw)) is not None:
            collector.add(("output", "fields", i), *wrong)
    snapshots = model.snapshots
    try:
        stop = parse(raw.get("stop_time"), "s")
    except UnitError:
        return None
    path = ("output", "snapshots")
    if snapshots is None:
        snapshots = stop / SNAPSHOTS
    elif isinstance(snapshots, float) and stop > snapshots * MOST_SNAPSHOTS:
        collector.add(path, f"{stop / snapshots:.3g} snapshots up to stop_time are too many", f"the limit is {MOST_SNAPSHOTS}")
    elif isinstance(snapshots, tuple) and snapshots and not (snapshots[0] >= 0.0 and snapshots[-1] <= stop):
        collector.add(path, f"snapshots must lie between 0 and stop_time = {stop:g} s")
    return OutputOptions(**model.model_dump() | {"snapshots": snapshots, "fields": tuple(model.fields)})


def write(problem: Problem) -> dict:
    """Tables of a deck, every default written out, that reads back to exactly this problem."""
    deck: dict[str, Any] = {"title": problem.title, "geometry": problem.geometry, "stop_time": problem.stop_time}
    names = {"start": "from", "end": "to"}
    deck["region"] = [{names.get(k, k): list(v) if isinstance(v, tuple) else v for k, v in _known(r).items()}
                      | ({"profile": profile_value(r.profile)} if r.profile else {}) for r in problem.regions]
    deck["material"] = {name: material_tables(m) for name, m in problem.materials.items()}
    deck["boundary"] = {"left": boundary_value(problem.left), "right": boundary_value(problem.right)}
    interfaces = [{"between": [i.left, i.right], "kind": i.kind} | ({"strength": i.strength} if i.kind == "bond" else {})
                  for i in problem.interfaces]
    gauges = [{"name": g.name, "at": g.at} | ({"window": g.window, "window_factor": g.window_factor} if g.window else {})
              for g in problem.gauges]
    lighting = [{"at": point.position, "time": point.time} for point in problem.lighting]
    deck |= {key: rows for key, rows in (("interface", interfaces), ("gauge", gauges), ("lighting", lighting)) if rows}
    deck |= terms.write_terms(problem)
    solver = _known(problem.solver)
    if problem.solver.viscosity is not None:
        law, values = problem.solver.viscosity
        solver["viscosity"] = {"law": law, **values}
    solver["options"] = dict(problem.solver.options)
    deck["solver"] = solver
    output = _known(problem.output)
    output["fields"] = list(problem.output.fields)
    if isinstance(problem.output.snapshots, tuple):
        output["snapshots"] = list(problem.output.snapshots)
    deck["output"] = output
    return deck


def _known(part: Any) -> dict[str, Any]:
    return {f.name: value for f in fields(part) if (value := getattr(part, f.name)) is not None}
