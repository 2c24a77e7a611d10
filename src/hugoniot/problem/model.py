"""A one-dimensional simulation described by Python objects, which cannot be changed after they are made. All numbers are in SI.

`read_deck` reads a deck into a `Deck`, whose attribute `problem` is a `Problem`; `hugoniot.run` runs either. Each value means the same as
the corresponding key in the deck reference, which also says which values exclude each other. `write_deck` turns a problem into a deck that
gives the same results.
"""

from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Any

from hugoniot.materials.material import Material

GEOMETRIES = {"planar": 1, "cylindrical": 2, "spherical": 3}


@dataclass(frozen=True)
class Profile:
    """An initial state that varies along a region.

    positions   positions of the values, m, increasing; () if the fields are expressions in x
    fields      pairs (name, values), with velocity, density, pressure, temperature or energy as name; values are a tuple of numbers in
                SI, one per position, or an expression in x as text
    """

    positions: tuple[float, ...]
    fields: tuple[tuple[str, tuple[float, ...] | str], ...]


@dataclass(frozen=True)
class Region:
    """A layer of one material at t = 0, divided into zones.

    name            name of the region
    material        key of `Problem.materials`
    start, end      positions of its ends, m; `start` equals the `end` of the left neighbour, or is larger where a gap is left
    zones           number of zones
    ratio           width of each zone divided by that of its left neighbour
    velocity        initial velocity, m/s: a number, or (velocity at start, velocity at end), linear in between
    density, pressure, temperature, energy   initial state (kg/m3, Pa, K, J/kg): any two of them, or one, or none (the reference state).
                    pressure, temperature or energy alone goes with the reference density, density alone with zero pressure
    profile         a state that varies along the region, or None
    """

    name: str
    material: str
    start: float
    end: float
    zones: int
    ratio: float = 1.0
    velocity: float | tuple[float, float] = 0.0
    density: float | None = None
    pressure: float | None = None
    temperature: float | None = None
    energy: float | None = None
    profile: Profile | None = None


@dataclass(frozen=True)
class Pulse:
    """A velocity, pressure or other quantity as a function of time.

    shape           "constant", "table", "exponential", "half_sine", "square" or "ramp"; all but the first two are zero before `start`
    amplitude       largest value in SI; not used by "table"
    start           time at which the pulse starts, s
    duration        in s: time in which "exponential" falls to 1/e, length of "half_sine" and "square", rise time of "ramp", which then
                    stays constant
    times, values   of "table": times in s and values in SI, linear in between, constant outside
    """

    shape: str = "constant"
    amplitude: float = 0.0
    start: float = 0.0
    duration: float = 0.0
    times: tuple[float, ...] = ()
    values: tuple[float, ...] = ()


@dataclass(frozen=True)
class Boundary:
    """Condition at one end of the problem.

    kind    "free", "fixed", "transmitting", "periodic" (then both ends must be), "velocity" or "pressure"
    pulse   value over time of "velocity" (m/s) or "pressure" (Pa), None for the other kinds
    """

    kind: str = "free"
    pulse: Pulse | None = None


@dataclass(frozen=True)
class Interface:
    """Whether two neighbouring regions can separate.

    left, right   names of the regions
    kind          "separable": opens under any tension; "bonded": opens only where a fracture law breaks a material; "bond": opens when the
                  tensile stress exceeds `strength`
    strength      tensile stress that breaks a "bond", Pa
    """

    left: str
    right: str
    kind: str = "separable"
    strength: float = 0.0


@dataclass(frozen=True)
class Gauge:
    """A Lagrangian gauge, which moves with the material.

    name            name of the gauge
    at              position at t = 0 in m, or one of the strings "free surface left", "free surface right", "LEFT/RIGHT" (the interface of
                    two regions), "REGION:left" and "REGION:right" (the ends of a region)
    window          name of the first or last region, through which an interferometer looks at an interface; "" for none. The gauge then
                    also records `apparent_velocity`
    window_factor   constant a of the window's refractive index n = a + b rho
    """

    name: str
    at: float | str
    window: str = ""
    window_factor: float | None = None


@dataclass(frozen=True)
class Lighting:
    """A detonator, which starts a programmed burn.

    position   position at t = 0, m, inside the explosive or at its end
    time       time at which it fires, s
    """

    position: float
    time: float = 0.0


@dataclass(frozen=True)
class SolverOptions:
    """The solver and its options.

    kind           "lagrange1d", "fronts" or "shock_structure"
    integrator     of lagrange1d: "compatible" or "wilkins"
    courant        Courant number; None: the default of the solver
    initial_step, largest_step   first time step and upper limit of the time step, s; None: not prescribed
    growth         largest ratio of a time step to the one before
    viscosity      artificial viscosity of lagrange1d, as (name of the law, {parameter: value}); None: the default
    threads        number of threads
    max_cycles     number of time steps after which the run stops; None: no limit
    options        the keys of [solver.options] in a deck of the solver
    """

    kind: str = "lagrange1d"
    integrator: str = "compatible"
    courant: float | None = None
    initial_step: float | None = None
    largest_step: float | None = None
    growth: float = 1.1
    viscosity: Any = None
    threads: int = 1
    max_cycles: int | None = None
    options: MappingProxyType = field(default_factory=lambda: MappingProxyType({}))


@dataclass(frozen=True)
class OutputOptions:
    """What a run stores, and how often.

    snapshots            time between snapshots in s, or a tuple of times; None: a hundredth of the stop time
    fields               names of the fields in each snapshot; (): the usual ones of the solver
    gauge_interval       time between samples of the gauges in s; 0: every time step
    checkpoint_seconds   wall-clock time between checkpoints, s
    checkpoint_cycles    number of time steps between checkpoints; None: by wall-clock time only
    report               whether report.html is written
    """

    snapshots: float | tuple[float, ...] | None = None
    fields: tuple[str, ...] = ()
    gauge_interval: float = 0.0
    checkpoint_seconds: float = 30.0
    checkpoint_cycles: int | None = None
    report: bool = True


@dataclass(frozen=True)
class BodyForce:
    """A force on all material.

    acceleration       m/s2 over time, positive towards larger positions
    exponent, radius   in curved geometry: the field is acceleration (r/radius)^exponent, with `radius` in m; None in planar geometry, where
                       the field is uniform
    """

    acceleration: Pulse
    exponent: float | None = None
    radius: float | None = None


@dataclass(frozen=True)
class HeatSource:
    """Energy supplied to a region from outside.

    region              name of the region, whose material must not burn
    kind                "power" (W/kg) or "intensity" (W/m2, through the face of the region on `side`)
    pulse               power or intensity over time
    side                "left" or "right": the face from which depths are measured
    absorption_length   of "intensity": depth in m over which it falls to 1/e; None: as `depths` say, or evenly over the mass
    depths, weights     depths in m at t = 0, and a number at each: with "power" a factor of it, with "intensity" the relative energy per
                        mass; linear in between, zero outside
    """

    region: str
    kind: str
    pulse: Pulse
    side: str = "left"
    absorption_length: float | None = None
    depths: tuple[float, ...] = ()
    weights: tuple[float, ...] = ()


@dataclass(frozen=True)
class Problem:
    """A one-dimensional simulation.

    title             title of the report and plots
    geometry          "planar", "cylindrical" or "spherical"
    stop_time         time at which the run ends, s
    regions           `Region` objects from left to right
    materials         {name: `Material`} of all regions
    left, right       the `Boundary` at each end
    interfaces, gauges, lighting, heat_sources   tuples of `Interface`, `Gauge`, `Lighting` and `HeatSource` objects, possibly empty
    body_force        a `BodyForce`, or None
    solver, output    `SolverOptions` and `OutputOptions`
    transport         {name of a material: {"viscosity", "conduction", "bulk_ratio", "bulk_viscosity"}}: physical viscosity and heat
                      conduction, with the laws as tables {"law": name, parameter: value}
    """

    title: str
    geometry: str
    stop_time: float
    regions: tuple[Region, ...]
    materials: dict[str, Material]
    left: Boundary = Boundary()
    right: Boundary = Boundary()
    interfaces: tuple[Interface, ...] = ()
    gauges: tuple[Gauge, ...] = ()
    solver: SolverOptions = SolverOptions()
    output: OutputOptions = OutputOptions()
    lighting: tuple[Lighting, ...] = ()
    body_force: BodyForce | None = None
    heat_sources: tuple[HeatSource, ...] = ()
    transport: MappingProxyType = field(default_factory=lambda: MappingProxyType({}))

    @property
    def dimension(self) -> int:
        """1 in planar, 2 in cylindrical and 3 in spherical geometry: d of the volume element r^(d-1) dr."""
        return GEOMETRIES[self.geometry]
