"""The shape of a deck of the two-dimensional hydrocode: one pydantic model per table."""

from typing import Annotated, Any, Literal

from pydantic import BeforeValidator, Field, WithJsonSchema

from hugoniot.problem.boundaries import pulse_schema
from hugoniot.problem.lagrangian import OutputTable, Positive, Snapshots
from hugoniot.problem.model import SolverOptions
from hugoniot.problem.plane.contact_model import Contact2D
from hugoniot.problem.plane.model import Solver2D, Viscosity2D
from hugoniot.problem.schema import Pressure, Quantity, Table, Time, trouble
from hugoniot.units import UnitError, parse

LARGEST_COORDINATE = 1e15
LIGHT = 299792458.0   # m/s
MOST_POINTS = 100_000


def _numbers(unit: str, count: int, limit: float = LARGEST_COORDINATE):
    """Reader of an array of `count` quantities."""
    def read(value: Any) -> tuple[float, ...]:
        if not isinstance(value, (list, tuple)) or len(value) != count:
            shown = f"{len(value)} values" if isinstance(value, (list, tuple)) else "one value"
            raise trouble(f"expected an array of {count} quantities, got {shown}", f"such as {_EXAMPLES[unit]}")
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
        raise trouble(f"expected an array of points, 2 to {MOST_POINTS}", 'such as [["0 mm", "0 mm"], ["5 mm", "0 mm"]]')
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
        raise trouble("expected a chain of edges or an array of them", 'such as "bar.bottom", or ["bar.right", "bar.top"]')
    return tuple(" ".join(name.split()) for name in names)


def _pair(value: Any) -> tuple[str, str]:
    if not isinstance(value, (list, tuple)) or len(value) != 2 or not all(isinstance(name, str) for name in value):
        raise trouble("expected two names", 'such as ["flyer", "target"]')
    return value[0].strip(), value[1].strip()


def _counts(value: Any) -> tuple[int, int]:
    if not isinstance(value, (list, tuple)) or len(value) != 2 or not all(isinstance(n, int) and not isinstance(n, bool) for n in value):
        raise trouble("expected two whole numbers", "zones along i and along j, such as [20, 200]")
    if min(value) < 1 or max(value) > 20_000:
        raise trouble("a block has from 1 to 20 000 zones in each direction", "such as [20, 200]")
    return value[0], value[1]


def _velocity(value: Any) -> Any:
    """An array of two velocities; a table passes, to be checked as `VelocityTable`."""
    if isinstance(value, (list, tuple)):
        return _numbers("m/s", 2, LIGHT)(value)
    if isinstance(value, dict):
        return value
    raise trouble("expected an array of two velocities or a table", 'such as ["0 m/s", "-200 m/s"], or {radial = "-1 km/s"}')


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
    """One edge of a block: line, arc, polyline or csv."""

    line: PointList | None = Field(None, description="two points")
    arc: PointList | None = Field(None, description="three points of a circle: one end, one in between, the other end")
    polyline: PointList | None = Field(None, description="two points or more")
    csv: str | None = Field(None, min_length=1, max_length=4000, description="file in the deck's folder: one point per line, two columns")
    unit: str = Field("m", max_length=20, description="length unit of the csv columns")
    spacing: Literal["length", "points"] = Field(
        "length", description="length divides the curve by arc length and ratio; points uses the points of a polyline as nodes")


class VelocityTable(Table):
    """A velocity field: the sum of its parts."""

    base: Speeds = Field((0.0, 0.0), description="constant part")
    centre: Place = Field((0.0, 0.0), description="where the other parts vanish or are centred")
    gradient: Annotated[Any, BeforeValidator(_matrix), WithJsonSchema({"type": "array", "items": _array("1/s"), "unit": "1/s"})] = Field(
        ((0.0, 0.0), (0.0, 0.0)), description="[[dvx/dx, dvx/dy], [dvy/dx, dvy/dy]], times the position relative to the centre")
    radial: Annotated[float, Quantity("m/s", limit=LIGHT)] = Field(0.0, description="speed away from the centre")
    radius: Annotated[float, Quantity("m", above=0.0)] = Field(1.0, description="distance at which the speed equals radial")
    power: Annotated[float, Quantity("1", limit=20.0)] = Field(0.0, description="radial part at distance d: radial (d / radius)^power")
    rotation: Annotated[float, Quantity("rad/s")] = Field(0.0, description="rate of rotation, counter-clockwise (plane only)")


_FIELD = {"anyOf": [_array("m/s"), VelocityTable.model_json_schema()]}
VelocityField = Annotated[Any, BeforeValidator(_velocity), WithJsonSchema(_FIELD)]


class BlockTable(Table):
    """A logically rectangular piece of one material: i runs along x (r, radius, left to right), j along y (z, angle, bottom to top)."""

    name: str = Field(min_length=1, max_length=60, description="name used in chains, gauges, messages and plots")
    material: str = Field(min_length=1, max_length=200, description="a table [material.NAME] of the deck, or a name of the library")
    shape: Literal["box", "sector", "edges"] = Field("box", description="box, sector of a ring or sphere, or four edges")
    zones: Counts = Field(description="zones along i and along j")
    ratio: Ratios = Field((1.0, 1.0), description="width of each zone over that of the one before, along i and j")
    x: Place | None = Field(None, description="box in the plane: from, to")
    y: Place | None = Field(None, description="box in the plane: from, to")
    r: Place | None = Field(None, description="box in axisymmetric geometry: radii from, to")
    z: Place | None = Field(None, description="box in axisymmetric geometry: from, to")
    centre: Place | None = Field(None, description="sector: its centre (default: the origin)")
    radius: Place | None = Field(None, description="sector: inner (above 0) and outer radius")
    angle: Angles | None = Field(None, description="sector: from, to, counter-clockwise from x (0 is the equator and 90 deg the axis in "
                                "axisymmetric geometry)")
    left: CurveTable | None = Field(None, description="edges: the side i = 0")
    right: CurveTable | None = Field(None, description="edges: the last side of i")
    bottom: CurveTable | None = Field(None, description="edges: the side j = 0")
    top: CurveTable | None = Field(None, description="edges: the last side of j")
    fill: Literal["transfinite", "winslow"] | None = Field(
        None, description="edges: transfinite interpolation (default) or Winslow's equipotential zoning")
    velocity: VelocityField = Field((0.0, 0.0), description="initial velocity, or a table of a velocity field")
    density: Annotated[float, Quantity("kg/m^3", above=0.0)] | None = Field(None, description="initial density")
    pressure: Pressure | None = Field(None, description="initial pressure")
    temperature: Annotated[float, Quantity("K", above=0.0, limit=1e12)] | None = Field(None, description="initial temperature")
    energy: Annotated[float, Quantity("J/kg")] | None = Field(None, description="initial specific internal energy")


class BoundaryTable(Table):
    """What happens on chains of boundary edges."""

    on: Chains = Field(description="\"BLOCK.left\" and so on, one or an array of them")
    kind: Literal["free", "wall", "axis", "velocity", "pressure", "transmitting"] = Field(
        description="free, rigid straight wall, axis r = 0, driven velocity, pressure over time, or transmitting")
    velocity: Annotated[Any, WithJsonSchema(pulse_schema() | {"unit": "m/s"})] = Field(
        None, description="for kind velocity: a value or a pulse")
    pressure: Annotated[Any, WithJsonSchema(pulse_schema() | {"unit": "Pa"})] = Field(
        None, description="for kind pressure: a value or a pulse")
    direction: Direction | None = Field(None, description="of kind velocity: direction of the motion (default: into the material)")
    slip: bool | None = Field(None, description="wall, velocity: nodes may slide along (default true); false: the other component is 0")
    separable: bool | None = Field(None, description="wall: material may leave it and come back (default false: it holds tension)")


class GaugeTable(Table):
    """A gauge: a material point (at), the mean over a chain (on), or a fixed line of sight (on, through, direction)."""

    name: str = Field(min_length=1, max_length=60, description="column of gauges.csv and label of plots")
    at: Place | None = Field(None, description="material point: its place at t = 0")
    on: str | None = Field(None, max_length=200, description="chain \"BLOCK.side\", or joint \"BLOCK/BLOCK\" (mean only)")
    through: Place | None = Field(None, description="line of sight: a point of it")
    direction: Direction | None = Field(None, description="line of sight: its direction, along which positions are counted")


class LightingTable(Table):
    """A detonator: where and when programmed burns start."""

    at: Place = Field(description="place at t = 0, in the explosive or on its edge (a ring about the axis where r > 0)")
    to: Place | None = Field(None, description="other end of a straight line of detonators")
    time: Time = Field(0.0, description="when it fires")


class ContactTable(Table):
    """What surfaces do that meet."""

    between: Pair | None = Field(None, description="two blocks or rigid bodies; named blocks that touch at the start are not joined "
                                 "(default: all that no other [[contact]] names)")
    kind: Literal["sliding", "bonded", "separable"] = Field(
        "sliding", description="sliding; bonded for good where they touch; or bonded up to a strength and sliding after that")
    friction: Plain = Field(Contact2D.friction, description="Coulomb friction coefficient")
    strength: Annotated[float, Quantity("Pa", above=0.0)] | None = Field(
        None, description="of kind separable: tension at which a bond breaks")


class RigidTable(Table):
    """A rigid body: a wall or a punch."""

    name: str = Field(min_length=1, max_length=60, description="name used in contact and results")
    points: PointList = Field(description="its surface, a polyline")
    closed: bool = Field(False, description="whether the last point is joined to the first")
    velocity: Annotated[Any, WithJsonSchema(pulse_schema() | {"unit": "m/s"})] = Field(
        None, description="driven along direction: a value or a pulse (default: at rest)")
    mass: Annotated[float, Quantity("kg", above=0.0)] | None = Field(
        None, description="of a free body: kg per metre of depth in the plane; "
        "in axisymmetric geometry kg of a ring, which moves along the axis")
    start: Speeds | None = Field(None, description="velocity at t = 0 of a body with mass, of its centre of mass where it turns")
    direction: Direction | None = Field(None, description="along which it moves, or is guided if it has a mass (default: any)")
    turns: bool = Field(False, description="whether a body with mass turns too, in the plane")
    inertia: Annotated[float, Quantity("kg*m^2", above=0.0)] | None = Field(
        None, description="of a body that turns: moment of inertia about the centre of mass per metre of depth (default: uniform density)")
    centre: Place | None = Field(
        None, description="of a body that turns: centre of mass (default: that of the closed polygon, of uniform density)")
    spin: Annotated[float, Quantity("1/s")] | None = Field(
        None, description="of a body that turns: angular velocity at t = 0 in radians per second, counter-clockwise (default: 0)")


class ViscosityTable(Table):
    """Artificial viscosity."""

    kind: Literal["tensor", "edge", "herrmann"] = Field("tensor", description="tensor: along both principal directions of the strain rate, "
                                                        "each with its own length; edge: along the edges that shorten; herrmann: bulk and "
                                                        "deviators along the axes of the frame, for comparison")
    limited: bool = Field(Viscosity2D.limited, description="use a limiter (no viscosity in smooth flow); herrmann: write false")
    linear: Plain = Field(Viscosity2D.linear, description="linear coefficient of materials without strength")
    quadratic: Plain = Field(Viscosity2D.quadratic, description="quadratic coefficient of materials without strength")
    solid_linear: Plain = Field(Viscosity2D.solid_linear, description="linear coefficient of solids where they are compressed")
    solid_shear: Plain = Field(Viscosity2D.solid_shear, description="linear coefficient of solids where they flow at constant volume; "
                                                                    "herrmann: everywhere")
    solid_quadratic: Plain = Field(Viscosity2D.solid_quadratic, description="quadratic coefficient of materials with strength")
    explosive_linear: Plain = Field(Viscosity2D.explosive_linear, description="linear coefficient of explosives; 0 in those "
                                                                              "whose burn is programmed alone")
    explosive_quadratic: Plain = Field(Viscosity2D.explosive_quadratic, description="quadratic coefficient of materials that burn")
    heat_flux: Plain = Field(Viscosity2D.heat_flux, description="coefficient of the artificial heat flux in shocks of quadrilaterals, "
                                                                "in materials without strength that do not burn; 0: none")


class HourglassTable(Table):
    """What works against hourglass modes of quadrilaterals; 0 is off."""

    subzonal_pressure: Plain = Field(Solver2D.subzonal_pressure, description="merit factor, materials without strength")
    flanagan_belytschko: Plain = Field(Solver2D.flanagan_belytschko, description="viscous coefficient, materials with strength")


class ErosionTable(Table):
    """When zones leave the mesh."""

    plastic_strain: Annotated[float, Quantity("1", above=0.0)] | None = Field(
        None, description="equivalent plastic strain at which a zone leaves the mesh (default: none)")
    smallest_step: Positive | None = Field(None, description="Courant step of a zone at which it leaves the mesh (default: none)")
    mass: Literal["kept", "dropped"] = Field("kept", description="kept by its nodes, or dropped with its momentum and energy, which are "
                                             "recorded")


class SolverTable(Table):
    """How it is solved."""

    kind: Literal["lagrange2d"] = Field(description="the solver")
    integrator: Literal["compatible"] = Field("compatible", description="compatible conserves total energy to round-off")
    cells: Literal["quads", "triangles"] = Field("quads", description="a cell of a block is one quadrilateral zone, or two triangles")
    diagonal: Literal["one_way", "alternating", "crossed"] | None = Field(
        None, description="triangles: all diagonals one way (default), turned from row to row along j, or turned from cell to cell")
    average_pressure: bool | None = Field(None, description="triangles: whether the two of a cell share one pressure, in materials with "
                                          "strength (default true); on their own they are too stiff in plastic flow")
    scheme: Literal["true_volume", "area_weighted"] | None = Field(
        None, description="axisymmetric: true_volume (default), or area_weighted (default where all blocks are sectors about the axis)")
    courant: Annotated[float, Quantity("1", above=0.0, limit=1.0)] = Field(Solver2D.courant, description="Courant number")
    growth: Annotated[float, Quantity("1", least=1.0, limit=10.0)] = Field(
        SolverOptions.growth, description="largest growth of the step per cycle")
    initial_step: Positive | None = Field(None, description="first time step (default: from the Courant condition)")
    largest_step: Positive | None = Field(None, description="largest time step (default: none)")
    threads: int = Field(1, ge=1, le=1024, description="number of threads; any number gives the same result, to the last bit")
    max_cycles: int | None = Field(None, ge=1, le=10**15, description="stop after this many cycles (default: no limit)")
    viscosity: ViscosityTable = Field(default_factory=ViscosityTable, description="artificial viscosity")  # type: ignore[arg-type]
    hourglass: HourglassTable = Field(default_factory=HourglassTable, description="hourglass filters")  # type: ignore[arg-type]
    erosion: ErosionTable | None = Field(None, description="when zones leave the mesh (default: never)")


class PlaneOutputTable(OutputTable):
    """What is kept."""

    snapshots: Snapshots = Field(
        None, description="interval between snapshots, or their times (default: a hundredth of stop_time; a twentieth beyond 10 000 zones)")
    gauge_interval: Annotated[float, Quantity("s", least=0.0)] | None = Field(  # pyrefly: ignore[bad-override]
        None, description="time between gauge samples, 0: every cycle (default: a two-thousandth of stop_time)")


class Model(Table):
    """A deck of the two-dimensional Lagrangian hydrocode."""

    title: str = Field("", max_length=200, description="title of report and plots (default: the deck's file name)")
    geometry: Literal["plane", "axisymmetric"] = Field("plane", description="plane: (x, y); axisymmetric: (r, z) with the axis at r = 0")
    stop_time: Positive = Field(description="time at which the run ends, such as \"2.5 us\"")
    block: list[BlockTable] = Field(min_length=1, max_length=10_000, description="the pieces of material, [[block]]")
    material: dict[str, Annotated[Any, WithJsonSchema({"x-definition": "material"})]] = Field(
        default_factory=dict, description="materials of this deck, [material.NAME.eos] and so on")
    boundary: list[BoundaryTable] = Field(default_factory=list, max_length=10_000, description="what happens at the edges, [[boundary]]")
    gauge: list[GaugeTable] = Field(default_factory=list, max_length=10_000, description="gauges, [[gauge]]")
    lighting: list[LightingTable] = Field(default_factory=list, max_length=10_000, description="where programmed burns start, [[lighting]]")
    contact: list[ContactTable] = Field(default_factory=list, max_length=10_000, description="surfaces that meet, [[contact]]")
    rigid: list[RigidTable] = Field(default_factory=list, max_length=1000, description="rigid bodies, [[rigid]]")
    body_force: Acceleration = Field((0.0, 0.0), description="acceleration of everything")
    solver: SolverTable = Field(description="how the problem is solved")
    output: PlaneOutputTable = Field(default_factory=PlaneOutputTable, description="what is kept")  # type: ignore[arg-type]
