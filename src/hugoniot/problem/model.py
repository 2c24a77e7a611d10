"""The problem: an immutable, complete description of one simulation in one dimension, in SI units.

`read_deck` makes one from a deck; it can also be built directly in Python.
"""

from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Any

from hugoniot.materials.material import Material

GEOMETRIES = {"planar": 1, "cylindrical": 2, "spherical": 3}


@dataclass(frozen=True)
class Profile:
    """An initial state that varies along a region.

    positions   m, increasing; () where the fields are expressions in x
    fields      (name, values at the positions in SI, or an expression) of velocity, density, pressure, temperature, energy
    """

    positions: tuple[float, ...]
    fields: tuple[tuple[str, tuple[float, ...] | str], ...]


@dataclass(frozen=True)
class Region:
    """A contiguous piece of one material at t = 0, divided into zones.

    start, end      m, start < end; `start` is the end of the left neighbour where bodies touch, larger where a gap is left
    zones           number of zones; the k-th is `ratio` times as wide as the one before
    velocity        m/s; a number, or (u at start, u at end) for a linear profile
    density, pressure, temperature, energy   any two fix the initial state (kg/m3, Pa, K, J/kg); none: the law's reference state;
                    one alone goes with the reference density (pressure, temperature, energy) or zero pressure (density)
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
    """A quantity as a function of time; every shape but "table" is zero before `start`.

    shape       "constant", "table", "exponential", "half_sine", "square", "ramp"
    amplitude   SI value (unused by a table)
    start       s
    duration    s: decay time of the exponential, length of half sine and square, rise time of the ramp (which then stays)
    times, values   of a table: s and SI values, linear between points and constant outside them
    """

    shape: str = "constant"
    amplitude: float = 0.0
    start: float = 0.0
    duration: float = 0.0
    times: tuple[float, ...] = ()
    values: tuple[float, ...] = ()


@dataclass(frozen=True)
class Boundary:
    """What happens at an end of the body.

    kind    "free", "fixed", "velocity" or "pressure" (both with a pulse), "transmitting", or "periodic" (then at both ends)
    """

    kind: str = "free"
    pulse: Pulse | None = None


@dataclass(frozen=True)
class Interface:
    """How two neighbouring regions hold together.

    kind    "bonded" (opens only by fracture of a material), "separable" (opens under any tension), or "bond" (opens when the tensile
            stress exceeds `strength`, Pa)
    """

    left: str
    right: str
    kind: str = "separable"
    strength: float = 0.0


@dataclass(frozen=True)
class Gauge:
    """A Lagrangian gauge.

    at   a position at t = 0 in m, or "free surface left", "free surface right", "<region>/<region>" for an interface,
         or "<region>:left" and "<region>:right" for the end faces of a region
    window, window_factor   at an interface: the name of the region (the last at this end) that an interferometer looks through, and the
                            constant a of its refractive index n = a + b rho; the gauge then also records `apparent_velocity`
    """

    name: str
    at: float | str
    window: str = ""
    window_factor: float | None = None


@dataclass(frozen=True)
class Lighting:
    """A detonator of an explosive with programmed burn: its position at t = 0 (m, inside the explosive or at its end) and time (s)."""

    position: float
    time: float = 0.0


@dataclass(frozen=True)
class SolverOptions:
    """The solver and its options, named as under [solver] in a deck.

    kind        name of the solver
    options     further options of this solver, such as heat_flux of lagrange1d
    viscosity   (law name, {parameter: value}) of the artificial viscosity; None: the default
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
    """What a run stores.

    snapshots   interval in s, or a list of times
    fields      names of the fields to store (empty: the default set)
    """

    snapshots: float | tuple[float, ...] | None = None
    fields: tuple[str, ...] = ()
    gauge_interval: float = 0.0
    checkpoint_seconds: float = 30.0
    checkpoint_cycles: int | None = None
    report: bool = True


@dataclass(frozen=True)
class BodyForce:
    """A force on every mass, as an acceleration (m/s2, towards larger positions) over time.

    exponent, radius   in curved geometry the acceleration is multiplied by (r/radius)^exponent; None in planar geometry
    """

    acceleration: Pulse
    exponent: float | None = None
    radius: float | None = None


@dataclass(frozen=True)
class HeatSource:
    """Energy supplied to a region from outside.

    kind                "power", W/kg where the profile is 1, or "intensity", W/m2 through the face of the region on `side`
    absorption_length   m: depth over which the intensity falls to 1/e; None: the energy is spread evenly, or as the table says
    depths, weights     table of the energy per mass at depths below that face at t = 0 (m): linear between its points, zero beyond
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
    """A whole problem. `transport` maps a material to its physical "viscosity", "conduction", "bulk_ratio" and "bulk_viscosity"."""

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
        """1 planar, 2 cylindrical, 3 spherical: the volume element is r^(d-1) dr."""
        return GEOMETRIES[self.geometry]
