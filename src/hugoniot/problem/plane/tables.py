"""The shape of a deck of the two-dimensional hydrocode: one pydantic model per table."""

from typing import Annotated, Any, Literal

from pydantic import BeforeValidator, Field, WithJsonSchema

from hugoniot.problem.boundaries import pulse_schema
from hugoniot.problem.defaults import whole_viscosity
from hugoniot.problem.lagrangian import OutputTable, Positive, Snapshots
from hugoniot.problem.model import SolverOptions
from hugoniot.problem.plane.contact_model import Contact2D
from hugoniot.problem.plane.model import Solver2D, Viscosity2D
from hugoniot.problem.schema import Pressure, Quantity, Table, Time, trouble
from hugoniot.units import UnitError, parse

LIMITED = whole_viscosity("limited", {})[1]
LARGEST_COORDINATE = 1e15
LIGHT = 299792458.0   # m/s
MOST_POINTS = 100_000


def _numbers(unit: str, count: int, limit: float = LARGEST_COORDINATE):
    """Reader of an array of `count` quantities."""
    def read(value: Any) -> tuple[float, ...]:
        if not isinstance(value, (list, tuple)) or len(value) != count:
            shown = len(value) if isinstance(value, (list, tuple)) else "one value"
            raise trouble(f"expected an array of {count} quantities, got {shown}", f"for example {_EXAMPLES[unit]}")
        try:
            found = tuple(parse(part, unit) for part in value)
        except UnitError as error:
            raise trouble(error.message, error.hint) from None
        if max(abs(v) for v in found) > limit:
            raise trouble(f"unreasonably large: {max(found, key=abs):g} {unit}", f"the limit is {limit:g} {unit}")
        return found
    return read


_EXAMPLES = {"m": '["0 mm", "5 mm"]', "m/s": '["0 m/s", "-200 m/s"]', "rad": '["0 deg", "90 deg"]', "1": "[1.0, 1.0]",
             "m/s^2": '["0 m/s^2", "-9.81 m/s^2"]', "1/s": '["0 1/s", "1 1/s"]'}


def _array(unit: str) -> dict:
    return {"type": "array", "items": {"type": ["number", "string"]}, "minItems": 2, "maxItems": 2, "unit": unit}


def _points(value: Any) -> tuple[tuple[float, float], ...]:
    if not isinstance(value, (list, tuple)) or not 2 <= len(value) <= MOST_POINTS:
        raise trouble(f"expected an array of 2 to {MOST_POINTS} points", 'for example [["0 mm", "0 mm"], ["5 mm", "0 mm"]]')
    read = _numbers("m", 2)
    return tuple(read(point) for point in value)  # type: ignore[misc]


def _matrix(value: Any) -> tuple[tuple[float, float], ...]:
    if not isinstance(value, (list, tuple)) or len(value) != 2:
        raise trouble("expected two rows of two rates", '[[dvx/dx, dvx/dy], [dvy/dx, dvy/dy]], such as [["1 1/s", 0], [0, "-1 1/s"]]')
    read = _numbers("1/s", 2, 1e30)
    return tuple(read(row) for row in value)  # type: ignore[misc]


def _names(value: Any) -> tuple[str, ...]:
    names = [value] if isinstance(value, str) else value
    if not isinstance(names, list) or not names or not all(isinstance(name, str) for name in names):
        raise trouble("expected a side or an array of sides", 'for example "bar.bottom", or ["bar.right", "bar.top"]')
    return tuple(" ".join(name.split()) for name in names)


def _pair(value: Any) -> tuple[str, str]:
    if not isinstance(value, (list, tuple)) or len(value) != 2 or not all(isinstance(name, str) for name in value):
        raise trouble("expected two names", 'for example ["flyer", "target"]')
    return value[0].strip(), value[1].strip()


def _counts(value: Any) -> tuple[int, int]:
    if not isinstance(value, (list, tuple)) or len(value) != 2 or not all(isinstance(n, int) and not isinstance(n, bool) for n in value):
        raise trouble("expected two whole numbers (zones along i and along j)", "for example [20, 200]")
    if min(value) < 1 or max(value) > 20_000:
        raise trouble("a block has from 1 to 20 000 zones in each direction", "for example [20, 200]")
    return value[0], value[1]


def _velocity(value: Any) -> Any:
    """An array of two velocities; a table passes, to be checked as `VelocityTable`."""
    if isinstance(value, (list, tuple)):
        return _numbers("m/s", 2, LIGHT)(value)
    if isinstance(value, dict):
        return value
    raise trouble("expected an array of two velocities or a table", 'for example ["0 m/s", "-200 m/s"], or {radial = "-1 km/s"}')


Place = Annotated[Any, BeforeValidator(_numbers("m", 2)), WithJsonSchema(_array("m"))]
Angles = Annotated[Any, BeforeValidator(_numbers("rad", 2, 100.0)), WithJsonSchema(_array("rad"))]
Speeds = Annotated[Any, BeforeValidator(_numbers("m/s", 2, LIGHT)), WithJsonSchema(_array("m/s"))]
Acceleration = Annotated[Any, BeforeValidator(_numbers("m/s^2", 2)), WithJsonSchema(_array("m/s^2"))]
Ratios = Annotated[Any, BeforeValidator(_numbers("1", 2, 10.0)), WithJsonSchema(_array("1"))]
Direction = Annotated[Any, BeforeValidator(_numbers("1", 2)), WithJsonSchema(_array("1"))]
PointList = Annotated[Any, BeforeValidator(_points), WithJsonSchema({"type": "array", "items": _array("m"), "unit": "m"})]
_TEXT = {"type": "string"}
Chains = Annotated[Any, BeforeValidator(_names), WithJsonSchema({"anyOf": [_TEXT, {"type": "array", "items": _TEXT}]})]
_WHOLE = {"type": "array", "items": {"type": "integer"}, "minItems": 2, "maxItems": 2}
Counts = Annotated[Any, BeforeValidator(_counts), WithJsonSchema(_WHOLE)]
Plain = Annotated[float, Quantity("1", least=0.0, limit=1e3)]
Pair = Annotated[Any, BeforeValidator(_pair), WithJsonSchema({"type": "array", "items": _TEXT, "minItems": 2, "maxItems": 2})]


class CurveTable(Table):
    """A side of a block with shape "edges": give exactly one of line, arc, polyline and csv. The ends of the sides must meet."""

    line: PointList | None = Field(None, description="straight line between two points")
    arc: PointList | None = Field(None, description="arc of a circle through three points: an end, a point on the arc, the other end")
    polyline: PointList | None = Field(None, description="straight pieces through two or more points")
    csv: str | None = Field(None, min_length=1, max_length=4000, description="file in the deck's folder with one point per line, in "
        "two columns; read as a polyline")
    unit: str = Field("m", max_length=20, description="with csv only: unit of both columns, such as \"mm\"")
    spacing: Literal["length", "points"] = Field(
        "length", description="length: nodes divide the arc length according to ratio; points: the points of the polyline or file are "
        "the nodes")


class VelocityTable(Table):
    """An initial velocity field: the sum of base, gradient, radial and rotation."""

    base: Speeds = Field((0.0, 0.0), description="uniform velocity")
    centre: Place = Field((0.0, 0.0), description="point from which the other parts are measured")
    gradient: Annotated[Any, BeforeValidator(_matrix), WithJsonSchema({"type": "array", "items": _array("1/s"), "unit": "1/s"})] = Field(
        ((0.0, 0.0), (0.0, 0.0)), description="velocity gradient [[dvx/dx, dvx/dy], [dvy/dx, dvy/dy]], multiplied by the position "
        "relative to centre (in axisymmetric geometry x is r and y is z)")
    radial: Annotated[float, Quantity("m/s", limit=LIGHT)] = Field(
        0.0, description="speed away from centre; at distance d it is radial (d/radius)^power, and 0 at centre itself")
    radius: Annotated[float, Quantity("m", above=0.0)] = Field(1.0, description="distance at which that speed equals radial")
    power: Annotated[float, Quantity("1", limit=20.0)] = Field(0.0, description="exponent of the distance; 0: the same speed everywhere")
    rotation: Annotated[float, Quantity("rad/s")] = Field(
        0.0, description="angular velocity about centre, counter-clockwise; plane geometry only")


_FIELD = {"anyOf": [_array("m/s"), VelocityTable.model_json_schema()]}
VelocityField = Annotated[Any, BeforeValidator(_velocity), WithJsonSchema(_FIELD)]


class BlockTable(Table):
    """A piece of one material with a logically rectangular mesh, whose zones are counted by i and j.

    In a box i runs along x (or r) and j along y (or z); in a sector i runs outwards and j counter-clockwise. The sides are left (first
    i), right (last i), bottom (first j) and top (last j). Blocks are joined where the nodes of their sides coincide. A state takes at most
    two of density, pressure, temperature and energy, as in `[[region]]`.
    """

    name: str = Field(min_length=1, max_length=60, description="name of the block, used by boundaries, gauges, contacts, messages and "
        "plots")
    material: str = Field(min_length=1, max_length=200, description="NAME of a table [material.NAME] of this deck, or else a material "
        "of the library")
    shape: Literal["box", "sector", "edges"] = Field(
        "box", description="box: rectangle; sector: part of a ring (axisymmetric: of a spherical shell); edges: four curved sides")
    zones: Counts = Field(description="numbers of zones along i and along j")
    ratio: Ratios = Field((1.0, 1.0), description="width of each zone divided by that of the one before it, along i and along j")
    x: Place | None = Field(None, description="box in plane geometry, required: smallest and largest x")
    y: Place | None = Field(None, description="box in plane geometry, required: smallest and largest y")
    r: Place | None = Field(None, description="box in axisymmetric geometry, required: smallest and largest radius")
    z: Place | None = Field(None, description="box in axisymmetric geometry, required: smallest and largest z")
    centre: Place | None = Field(None, description="sector: centre of the ring (default: the origin)")
    radius: Place | None = Field(None, description="sector, required: inner and outer radius; the inner one must be above 0")
    angle: Angles | None = Field(None, description="sector, required: first and last angle, counter-clockwise from the direction of x "
        "(or r); in axisymmetric geometry \"0 deg\" is the equator and \"90 deg\" the axis")
    left: CurveTable | None = Field(None, description="edges, required: the left side (first i), [block.left]")
    right: CurveTable | None = Field(None, description="edges, required: the right side (last i), [block.right]")
    bottom: CurveTable | None = Field(None, description="edges, required: the bottom side (first j), [block.bottom]")
    top: CurveTable | None = Field(None, description="edges, required: the top side (last j), [block.top]")
    fill: Literal["transfinite", "winslow"] | None = Field(
        None, description="edges: interior mesh by transfinite interpolation, or by Winslow's equipotential zoning, whose mesh lines "
        "do not fold over a bump (default: transfinite)")
    velocity: VelocityField = Field((0.0, 0.0), description="initial velocity along both coordinates, or a field, [block.velocity]")
    density: Annotated[float, Quantity("kg/m^3", above=0.0)] | None = Field(None, description="initial density")
    pressure: Pressure | None = Field(None, description="initial pressure")
    temperature: Annotated[float, Quantity("K", above=0.0, limit=1e12)] | None = Field(
        None, description="initial temperature; the equation of state must give temperatures")
    energy: Annotated[float, Quantity("J/kg")] | None = Field(None, description="initial specific internal energy")


class BoundaryTable(Table):
    """What happens at sides of blocks that are not joined. A side without an entry is free, or the axis if it lies on r = 0."""

    on: Chains = Field(description="a side such as \"BLOCK.left\", or an array of sides; where part of a side is joined to "
        "another block, the condition applies to the rest")
    kind: Literal["free", "wall", "axis", "velocity", "pressure", "transmitting"] = Field(
        description="free: no stress; wall: rigid and straight, at any angle; axis: r = 0; velocity or pressure: prescribed; "
        "transmitting: waves leave almost without reflection")
    velocity: Annotated[Any, WithJsonSchema(pulse_schema() | {"unit": "m/s"})] = Field(
        None, description="kind velocity, required: speed along direction; constant, or a pulse or table of times")
    pressure: Annotated[Any, WithJsonSchema(pulse_schema() | {"unit": "Pa"})] = Field(
        None, description="kind pressure, required: pressure on the moving surface; constant, or a pulse or table of times")
    direction: Direction | None = Field(
        None, description="kind velocity: vector along which the side moves (default: the inward normal at each node)")
    slip: bool | None = Field(None, description="kind wall or kind velocity: whether nodes may slide along the side; if false, their other "
        "velocity component is 0 (default: true)")
    separable: bool | None = Field(
        None, description="kind wall: whether material may leave the wall and return; if false, the wall supports tension; true "
        "excludes slip = false (default: false)")


class GaugeTable(Table):
    """A gauge of one of three types: a material point (give at), the mean over a side (give on), or a line of sight.

    A line of sight (give on, through and direction) is fixed in space, like the slit of a streak camera. It records where it meets the
    side, and how fast that point moves.
    """

    name: str = Field(min_length=1, max_length=60, description="name of the gauge in gauges.csv and plots")
    at: Place | None = Field(None, description="material point: its position at t = 0")
    on: str | None = Field(None, max_length=200, description="mean or line of sight: a side, \"BLOCK.left\"; for a mean also the joint "
        "of two blocks, \"BLOCK/BLOCK\"")
    through: Place | None = Field(None, description="line of sight: a point of the line, from which positions along it are measured")
    direction: Direction | None = Field(None, description="line of sight: vector along the line; positions increase along it")


class LightingTable(Table):
    """A detonator: where and when a programmed burn starts. Every body of explosive with a programmed burn law needs one."""

    at: Place = Field(description="position at t = 0, in the explosive or on its edge; off the axis of axisymmetric geometry it is a ring")
    to: Place | None = Field(None, description="second point; the detonators then form a straight line between at and to (default: a "
        "single point)")
    time: Time = Field(0.0, description="time at which the detonator fires")


class ContactTable(Table):
    """What happens where surfaces meet. Without an entry they slide without friction, separate in tension and may meet again."""

    between: Pair | None = Field(None, description="names of two blocks, or of a block and a rigid body; one block twice is contact "
        "with itself; blocks named here are not joined where they touch at the start (default: all surfaces that no other [[contact]] "
        "names)")
    kind: Literal["sliding", "bonded", "separable"] = Field(
        "sliding", description="sliding: no tension; bonded: permanent once they touch; separable: bonded until the tension exceeds "
        "strength, then sliding")
    friction: Plain = Field(Contact2D.friction, description="Coulomb friction coefficient; not with kind bonded")
    strength: Annotated[float, Quantity("Pa", above=0.0)] | None = Field(
        None, description="kind separable, required: tensile stress that breaks the bond")


class RigidTable(Table):
    """A rigid body. It is at rest, driven (give velocity and direction), or free (give mass)."""

    name: str = Field(min_length=1, max_length=60, description="name of the body, used by contacts and results")
    points: PointList = Field(description="points of its surface, a polyline; the body must not overlap a block")
    closed: bool = Field(False, description="whether the last point is joined to the first")
    velocity: Annotated[Any, WithJsonSchema(pulse_schema() | {"unit": "m/s"})] = Field(
        None, description="speed of a driven body along direction; constant, or a pulse or table of times; excludes mass (default: at "
        "rest)")
    mass: Annotated[float, Quantity("kg", above=0.0)] | None = Field(
        None, description="mass of a free body: in plane geometry per metre of depth, in axisymmetric geometry of the whole ring, "
        "which moves along the axis only; excludes velocity")
    start: Speeds | None = Field(None, description="initial velocity of a free body, of its centre of mass if it turns (default: 0)")
    direction: Direction | None = Field(
        None, description="vector along which a driven body moves (required), or to which a free body is restricted (default: none)")
    turns: bool = Field(False, description="whether a free body without direction also rotates; plane geometry only")
    inertia: Annotated[float, Quantity("kg*m^2", above=0.0)] | None = Field(
        None, description="with turns: moment of inertia about the centre of mass, per metre of depth; required if the body is not "
        "closed (default: that of uniform density)")
    centre: Place | None = Field(
        None, description="with turns: centre of mass at t = 0; required if the body is not closed (default: that of uniform density)")
    spin: Annotated[float, Quantity("1/s")] | None = Field(
        None, description="with turns: initial angular velocity in radians per second, counter-clockwise (default: 0)")


class ViscosityTable(Table):
    """Artificial viscosity. Linear coefficients weight the sound speed, quadratic ones the velocity jump."""

    kind: Literal["tensor", "edge", "herrmann"] = Field(
        "tensor", description="tensor: acts along both principal directions of the strain rate, with the width of the zone in each; "
        "edge: acts along the edges that shorten; herrmann: acts on bulk and deviators along the coordinate axes, for comparison")
    limited: bool = Field(Viscosity2D.limited, description="whether a limiter removes the viscosity in smooth flow; kind herrmann has "
        "none and needs limited = false")
    linear: Plain = Field(LIMITED["linear"], description="linear coefficient of materials without strength that do not burn: of "
        "gases; of solids and liquids where they flow at constant volume; of porous materials in weak shocks")
    linear_condensed: Plain | None = Field(
        None, description="linear coefficient of materials without strength that do not burn: of solids and liquids where they "
        f"are compressed; of porous materials in strong shocks (default: {LIMITED['linear_condensed']:g}, or linear if that is given); not "
        "with kind herrmann")
    quadratic: Plain = Field(Viscosity2D.quadratic, description="quadratic coefficient of materials without strength that do not burn")
    solid_linear: Plain = Field(LIMITED["linear"], description="linear coefficient of materials with strength where they are "
        "compressed, in weak shocks; not with kind herrmann")
    solid_linear_condensed: Plain | None = Field(
        None, description="linear coefficient of materials with strength where they are compressed, in strong shocks "
        f"(default: {LIMITED['linear_condensed']:g}, or solid_linear if that is given); not with kind herrmann")
    solid_shear: Plain = Field(Viscosity2D.solid_shear, description="linear coefficient of materials with strength where they flow at "
        "constant volume (with kind herrmann, in all motion)")
    solid_quadratic: Plain = Field(Viscosity2D.solid_quadratic, description="quadratic coefficient of materials with strength")
    explosive_linear: Plain = Field(Viscosity2D.explosive_linear, description="linear coefficient of materials that burn; not used "
        "with the burn law programmed and the mixture burned_products")
    explosive_quadratic: Plain = Field(Viscosity2D.explosive_quadratic, description="quadratic coefficient of materials that burn")
    heat_flux: Plain = Field(Viscosity2D.heat_flux, description="coefficient of the artificial heat flux in shocks of materials "
        "without strength that do not burn; cells quads only; 0 switches it off")


class HourglassTable(Table):
    """Filters against hourglass modes; cells quads only. A coefficient of 0 switches a filter off."""

    subzonal_pressure: Plain = Field(Solver2D.subzonal_pressure, description="merit factor of the subzonal pressures, in materials "
        "without strength")
    flanagan_belytschko: Plain = Field(Solver2D.flanagan_belytschko, description="viscous coefficient of the Flanagan-Belytschko "
        "filter, in materials with strength")


class ErosionTable(Table):
    """When zones are removed from the mesh; cells quads only. Give plastic_strain, smallest_step, or both.

    Zones in which the mesh would tangle are then removed too. Without this table no zone is removed.
    """

    plastic_strain: Annotated[float, Quantity("1", above=0.0)] | None = Field(
        None, description="equivalent plastic strain at which a zone is removed (default: no limit)")
    smallest_step: Positive | None = Field(
        None, description="a zone is removed when its Courant time step falls below this (default: no limit)")
    mass: Literal["kept", "dropped"] = Field(
        "kept", description="kept: the nodes of the zone keep its mass; dropped: it is removed with its momentum and energy, which are "
        "recorded")


class SolverTable(Table):
    """Options of the solver."""

    kind: Literal["lagrange2d"] = Field(description="name of the solver")
    integrator: Literal["compatible"] = Field("compatible", description="the only scheme; it conserves total energy to round-off")
    cells: Literal["quads", "triangles"] = Field("quads", description="whether each cell of a block is one quadrilateral zone or is "
        "divided into two triangular zones")
    diagonal: Literal["one_way", "alternating", "crossed"] | None = Field(
        None, description="cells triangles: diagonals all in one direction, alternating from row to row along j, or alternating from "
        "cell to cell (default: one_way)")
    average_pressure: bool | None = Field(
        None, description="cells triangles: whether the two triangles of a cell share one pressure, in materials with strength; "
        "without it triangles are too stiff in plastic flow (default: true)")
    scheme: Literal["true_volume", "area_weighted"] | None = Field(
        None, description="axisymmetric geometry: true_volume does exactly the work p dV and conserves axial momentum; area_weighted keeps "
        "spherical symmetry on polar meshes, but contact of bodies that reach the axis is refused (default: area_weighted if all blocks "
        "are sectors centred on the axis, else true_volume)")
    courant: Annotated[float, Quantity("1", above=0.0, limit=1.0)] = Field(Solver2D.courant, description="Courant number of the time step")
    growth: Annotated[float, Quantity("1", least=1.0, limit=10.0)] = Field(
        SolverOptions.growth, description="largest ratio of a time step to the one before")
    initial_step: Positive | None = Field(None, description="first time step (default: from the Courant condition)")
    largest_step: Positive | None = Field(None, description="upper limit of the time step (default: none)")
    threads: int = Field(1, ge=1, le=1024, description="number of threads; the result is the same, bit for bit, for any number")
    max_cycles: int | None = Field(None, ge=1, le=10**15, description="number of time steps after which the run stops (default: no limit)")
    viscosity: ViscosityTable = Field(
        default_factory=ViscosityTable, description="artificial viscosity, [solver.viscosity]")  # type: ignore[arg-type]
    hourglass: HourglassTable = Field(
        default_factory=HourglassTable, description="hourglass filters, [solver.hourglass]")  # type: ignore[arg-type]
    erosion: ErosionTable | None = Field(None, description="removal of zones, [solver.erosion] (default: no zone is removed)")


class PlaneOutputTable(OutputTable):
    """What a run stores, and how often."""

    snapshots: Snapshots = Field(
        None, description="time between snapshots of all zones, or an array of their times (default: a hundredth of stop_time, or a "
        "twentieth with more than 10 000 zones)")
    gauge_interval: Annotated[float, Quantity("s", least=0.0)] | None = Field(  # pyrefly: ignore[bad-override]
        None, description="time between samples of the gauges; 0: a sample at every time step (default: stop_time / 2000)")


class Model(Table):
    """The solver `lagrange2d` is the two-dimensional Lagrangian hydrocode, for plane bodies and bodies of revolution.

    Its mesh is made of blocks and moves with the material. [The guide](../two_dimensions.md) explains them with examples.
    """

    title: str = Field("", max_length=200, description="title of the report and plots (default: the deck's file name)")
    geometry: Literal["plane", "axisymmetric"] = Field(
        "plane", description="plane: coordinates (x, y), results per metre of depth; axisymmetric: (r, z) with the axis at r = 0, "
        "results per radian")
    stop_time: Positive = Field(description="time at which the run ends, such as \"2.5 us\"")
    block: list[BlockTable] = Field(min_length=1, max_length=10_000, description="the pieces of material, [[block]]")
    material: dict[str, Annotated[Any, WithJsonSchema({"x-definition": "material"})]] = Field(
        default_factory=dict, description="materials defined in this deck, [material.NAME]")
    boundary: list[BoundaryTable] = Field(default_factory=list, max_length=10_000,
        description="conditions at sides of blocks, [[boundary]]")
    gauge: list[GaugeTable] = Field(default_factory=list, max_length=10_000, description="gauges, [[gauge]]")
    lighting: list[LightingTable] = Field(default_factory=list, max_length=10_000, description="detonators, [[lighting]]")
    contact: list[ContactTable] = Field(default_factory=list, max_length=10_000,
        description="what happens where surfaces meet, [[contact]]")
    rigid: list[RigidTable] = Field(default_factory=list, max_length=1000, description="rigid bodies, [[rigid]]")
    body_force: Acceleration = Field(
        (0.0, 0.0), description="constant acceleration of all material along both coordinates; in axisymmetric geometry the radial one "
        "must be 0")
    solver: SolverTable = Field(description="the solver and its options, [solver]")
    output: PlaneOutputTable = Field(default_factory=PlaneOutputTable, description="what is stored, [output]")  # type: ignore[arg-type]
