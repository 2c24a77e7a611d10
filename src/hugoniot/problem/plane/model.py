"""What is asked of the two-dimensional hydrocode: a frozen, complete description of one simulation. SI everywhere.

    Problem2D
      geometry    "plane": coordinates (x, y), everything per metre of depth; "axisymmetric": coordinates (r, z), axis at r = 0,
                  everything per radian. The first coordinate is always called x and the second y inside: x = r and y = z.
      blocks      logically rectangular pieces of one material each, in the order that numbers zones and nodes; a block is a region
      boundaries  what happens on named chains of boundary edges; a chain no entry names is free, or the axis where it lies on r = 0
      gauges      material points, means over a chain, lines of sight
      lighting    detonators of programmed burns
      contacts    what surfaces do that meet: Contact2D
      rigid       rigid bodies: Rigid2D
      body_force  acceleration (x, y) in m/s2, constant
      solver      Solver2D
      output      as in one dimension
      mesh        `mesh.blocks.Blocks`, built from the blocks' shapes (cached; not part of what is compared or written)

Made from a deck by `problem.deck` (solver.kind = "lagrange2d"), or directly in Python.
"""

from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from hugoniot.materials.material import Material
from hugoniot.mesh.blocks import Blocks, BlockShape, build
from hugoniot.mesh.shapes import Point, Shape
from hugoniot.mesh.triangles import DIAGONALS, divided
from hugoniot.problem.defaults import whole_viscosity
from hugoniot.problem.model import OutputOptions, Pulse
from hugoniot.problem.plane.contact_model import Contact2D, Rigid2D, apart

__all__ = ["BOUNDARIES", "CELLS", "DIAGONALS", "GEOMETRIES", "SCHEMES", "VISCOSITIES", "Block2D", "Boundary2D", "Gauge2D", "Lighting2D",
           "Problem2D", "Solver2D", "VelocityField", "Viscosity2D", "velocity_at"]

GEOMETRIES = ("plane", "axisymmetric")
BOUNDARIES = ("free", "wall", "axis", "velocity", "pressure", "transmitting")
SCHEMES = ("true_volume", "area_weighted")
CELLS = ("quads", "triangles")
VISCOSITIES = ("tensor", "edge", "herrmann")


@dataclass(frozen=True)
class VelocityField:
    """Initial velocity of a block: v(x) = base + gradient . (x - centre) + radial part + rotation about the centre.

    base       (vx, vy), m/s
    centre     (x, y), m
    gradient   ((dvx/dx, dvx/dy), (dvy/dx, dvy/dy)), 1/s
    radial     speed away from the centre, m/s, where the distance to it is `radius`; at distance d it is radial (d / radius)**power,
               and 0 at the centre itself. power = 0 (the default) gives the same speed everywhere and needs no radius
    rotation   rate, rad/s, counter-clockwise (plane only)
    """

    base: Point = (0.0, 0.0)
    centre: Point = (0.0, 0.0)
    gradient: tuple[Point, Point] = ((0.0, 0.0), (0.0, 0.0))
    radial: float = 0.0
    radius: float = 1.0
    power: float = 0.0
    rotation: float = 0.0


@dataclass(frozen=True)
class Block2D:
    """A logically rectangular piece of one material.

    name, material   as a region's in one dimension
    shape            `mesh.shapes.Box | Sector | Edges`
    zones            (ni, nj)
    ratio            width of each zone over that of the one before, along i and along j
    velocity         `VelocityField`
    density, pressure, temperature, energy   as a region's in one dimension: any two fix the initial state
    """

    name: str
    material: str
    shape: Shape
    zones: tuple[int, int]
    ratio: tuple[float, float] = (1.0, 1.0)
    velocity: VelocityField = VelocityField()
    density: float | None = None
    pressure: float | None = None
    temperature: float | None = None
    energy: float | None = None


@dataclass(frozen=True)
class Boundary2D:
    """What happens on chains of boundary edges.

    on          names of chains: "<block>.left|right|bottom|top"; of a side that is joined in part, the edges left over
    kind        "free"; "wall" (rigid, straight, at any angle: the velocity along its normal is zero); "axis" (r = 0: v_r = 0);
                "velocity" (driven); "pressure" (a load, compression positive, normal to the surface as it moves); "transmitting"
    pulse       of "velocity" (m/s) and "pressure" (Pa): amplitude over time, `problem.model.Pulse`
    direction   of "velocity": unit vector (x, y) of the motion; None: the inward normal of each node (mean of its edges, as at t = 0)
    slip        True: only the component along the normal (wall) or the direction (velocity) is prescribed; False: the other one is zero
    separable   of "wall": it holds no tension; material may leave it and come back (`problem.plane.walls`)
    """

    on: tuple[str, ...]
    kind: str = "free"
    pulse: Pulse | None = None
    direction: Point | None = None
    slip: bool = True
    separable: bool = False


@dataclass(frozen=True)
class Gauge2D:
    """A gauge.

    kind        "point": the material at `at` (m, at t = 0): fields of its zone, velocity interpolated from its four nodes
                "edge": mean over the chain or joint `on`, by area at t = 0: velocity and position of its nodes, fields of its zones
                "slit": a fixed line of sight from the point `at` along `direction`; it sees the outermost point where the chain `on`
                crosses it, and reports that point's position along the line (m) and the rate at which it moves (m/s), which is
                what a streak camera records (an oblique surface crosses faster than its material moves along the line)
    direction   of a slit: unit vector
    """

    name: str
    kind: str
    at: Point | None = None
    on: str | None = None
    direction: Point | None = None


@dataclass(frozen=True)
class Lighting2D:
    """A detonator: the point `at` (m; a ring about the axis where r > 0), or the straight line from `at` to `to`, and its time (s)."""

    at: Point
    time: float = 0.0
    to: Point | None = None


@dataclass(frozen=True)
class Viscosity2D:
    """Artificial viscosity: kind, whether limited, and its coefficients, for fluids, explosives and materials with strength.

    kind               "tensor": both principal directions of the strain rate, each with its own length (corner quadrature);
                       "edge": the edges that close; "herrmann": bulk and deviators along the axes of the frame, for comparison
    limited            whether smooth flow is spared; "herrmann" has no limiter
    linear, quadratic  of a material without strength;  solid_linear, solid_quadratic of one with, where it shrinks;
                       explosive_linear, explosive_quadratic of one that burns, whose products are stiffer than a gas, as in one dimension;
                       explosives with a programmed burn and no unreacted equation of state have no linear part
    solid_shear        linear coefficient of a material with strength where it flows at constant volume; "herrmann" takes it everywhere
    heat_flux          coefficient of the artificial heat flux between quadrilaterals of materials without strength that do not burn
    linear_condensed   in place of `linear` in condensed materials, in porous ones in strong shocks only; solid_linear_condensed in place of
                       `solid_linear` in strong shocks; "herrmann" has neither

    None stands for the value of `problem.defaults.whole_viscosity`: a linear coefficient that is given alone holds in every shock.
    """

    kind: str = "tensor"
    limited: bool = True
    linear: float | None = None
    quadratic: float = 2.0 / 3.0
    solid_linear: float | None = None
    solid_quadratic: float = 2.0 / 3.0
    explosive_linear: float = 0.3
    explosive_quadratic: float = 1.0
    solid_shear: float = 0.06
    heat_flux: float = 1.0
    linear_condensed: float | None = None
    solid_linear_condensed: float | None = None

    def __post_init__(self):
        for kind in ("", "solid_"):
            given = {name: value for name in ("linear", "linear_condensed") if (value := getattr(self, kind + name)) is not None}
            whole = whole_viscosity("limited", given)[1]
            object.__setattr__(self, kind + "linear", whole["linear"])
            object.__setattr__(self, kind + "linear_condensed", whole["linear_condensed"])


@dataclass(frozen=True)
class Erosion2D:
    """When zones leave the mesh; a zone that the mesh would tangle in leaves it too.

    plastic_strain  equivalent plastic strain at which they do; None: whatever it is
    smallest_step   Courant step of a zone at which it does, s; None: whatever it is
    mass            "kept": its nodes keep the mass of the zone, and fly on by themselves where no zone is left around them;
                    "dropped": it leaves with its momentum and energy, which are counted
    """

    plastic_strain: float | None = None
    smallest_step: float | None = None
    mass: str = "kept"


@dataclass(frozen=True)
class Solver2D:
    """How it is solved; every default is written out in the resolved deck.

    cells        "quads", or "triangles": every cell of a block divided by a diagonal
    diagonal     which way (`mesh.triangles`): "one_way", "alternating" or "crossed"
    average_pressure   whether both triangles of a cell share their pressure, in materials with strength
    scheme       axisymmetric: "true_volume" (virtual work) or "area_weighted" (keeps spherical symmetry on polar meshes)
    subzonal_pressure    of quads: merit factor against hourglass modes of materials without strength; 0 is off
    flanagan_belytschko  of quads: viscous coefficient against hourglass modes of materials with strength; 0 is off
    erosion      when zones leave the mesh, of quads; None: never
    courant, growth, initial_step, largest_step, threads, max_cycles   as in one dimension
    """

    kind: str = "lagrange2d"
    integrator: str = "compatible"
    cells: str = "quads"
    diagonal: str = "one_way"
    average_pressure: bool = True
    scheme: str = "true_volume"
    viscosity: Viscosity2D = Viscosity2D()
    subzonal_pressure: float = 1.0
    flanagan_belytschko: float = 0.05
    courant: float = 0.4
    growth: float = 1.1
    initial_step: float | None = None
    largest_step: float | None = None
    threads: int = 1
    max_cycles: int | None = None
    erosion: Erosion2D | None = None


@dataclass(frozen=True)
class Problem2D:
    """One simulation; the fields are described at the top of the file."""

    title: str
    geometry: str
    stop_time: float
    blocks: tuple[Block2D, ...]
    materials: dict[str, Material]
    boundaries: tuple[Boundary2D, ...] = ()
    gauges: tuple[Gauge2D, ...] = ()
    lighting: tuple[Lighting2D, ...] = ()
    contacts: tuple[Contact2D, ...] = ()
    rigid: tuple[Rigid2D, ...] = ()
    body_force: Point = (0.0, 0.0)
    solver: Solver2D = Solver2D()
    output: OutputOptions = field(default_factory=OutputOptions)

    @property
    def regions(self) -> tuple[Block2D, ...]:
        """The blocks, under the name that parts of one dimension have."""
        return self.blocks

    @property
    def axes(self) -> tuple[str, str]:
        """Names of the coordinates: ("x", "y") or ("r", "z")."""
        return ("r", "z") if self.geometry == "axisymmetric" else ("x", "y")

    @cached_property
    def mesh(self) -> Blocks:
        """Blocks, node numbers and chains at t = 0. Raises `mesh.blocks.MeshError` where the shapes do not make a mesh."""
        shapes = tuple(BlockShape(block.name, block.shape, block.zones, block.ratio) for block in self.blocks)
        mesh = build(shapes, self.geometry == "axisymmetric", apart(self.contacts, [block.name for block in self.blocks]))
        return divided(mesh, self.solver.diagonal) if self.solver.cells == "triangles" else mesh

    def velocities(self):
        """Initial velocity of every block's own nodes: arrays (2, ni + 1, nj + 1). Nodes that blocks share are the solver's to unite."""
        return [velocity_at(block.velocity, part.x, part.y) for block, part in zip(self.blocks, self.mesh.blocks)]

    def chain_boundaries(self) -> dict[str, Boundary2D]:
        """Boundary of every chain of the mesh: the deck's, else the axis on r = 0, else free."""
        given = {name: boundary for boundary in self.boundaries for name in boundary.on}
        return {name: given.get(name, Boundary2D((name,), "axis" if chain.on_axis else "free")) for name, chain in self.mesh.chains.items()}


def velocity_at(motion: VelocityField, x, y):
    """Velocity (2, ...) in m/s of a field at places x, y (arrays, m)."""
    dx, dy = np.asarray(x) - motion.centre[0], np.asarray(y) - motion.centre[1]
    distance = np.hypot(dx, dy)
    away = np.where(distance > 0.0, distance, 1.0)
    over = np.where(distance > 0.0, motion.radial * (away / motion.radius) ** motion.power / away, 0.0)
    (a, b), (c, d) = motion.gradient
    return np.stack([motion.base[0] + (a + over) * dx + (b - motion.rotation) * dy,
                     motion.base[1] + (c + motion.rotation) * dx + (d + over) * dy])
