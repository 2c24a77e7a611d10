"""Decks of the KO family of codes as decks of this package: what the readers of both formats (`ko_yaml`, `ko_columns`) share.

A deck of theirs is a row of layers, each with cells, a position, a state, an equation of state, a strength and a fracture criterion. The
result is run by the `wilkins` integrator with their viscosity and time step, so that it gives their numbers.
"""

from dataclasses import dataclass, field
from typing import Any

from hugoniot.errors import DeckError
from hugoniot.laws.eos.contract import pressure
from hugoniot.materials.read import build_material

GEOMETRIES = {1: "planar", 2: "cylindrical", 3: "spherical", "PLA": "planar", "CYL": "cylindrical", "SPH": "spherical"}
NO_LIMIT = 1e15           # Pa: a tension that means no fracture
COURANT, VISCOSITY = 2.0 / 3.0, {"law": "wilkins", "quadratic": 2.0, "linear": 1.0}
STEP_SCALE = 6.0          # pyKO takes a sixth of Wilkins' step; a gas keeps the whole


@dataclass(frozen=True)
class Layer:
    """One layer, SI. `tables` is a material as a deck writes it (eos, strength, fracture); pressure is what their deck states."""

    name: str
    start: float
    length: float
    cells: int
    velocity: float
    density: float
    energy: float
    pressure: float
    tables: dict[str, Any]


@dataclass(frozen=True)
class KoDeck:
    """A deck of theirs, SI; `ends` are "free", "fixed" or {"pressure": Pa}."""

    title: str
    geometry: str
    stop_time: float
    layers: tuple[Layer, ...]
    ends: tuple[Any, Any]
    snapshots: float | None = None
    first_step: float | None = None
    acceleration: float = 0.0
    left: list[str] = field(default_factory=list)


def fracture_table(limit: float, least_density: float | None) -> dict[str, Any] | None:
    """Fracture where p < -limit and rho/rho0 < least_density (000 B.4a); None where the limit is out of reach, or 0."""
    if not 0.0 < limit < NO_LIMIT:
        return None
    return {"law": "pressure_volume", "pressure_limit": -limit, "volume_limit": 1.0 / (least_density or 1.0)}


def check_reference(initial: float, reference: float, file: str, key: str, line: int | None = None) -> None:
    """Refuse a Mie-Grüneisen layer that does not begin at its reference density, kg/m3: pyKO stops, and KO ignores the reference."""
    if abs(initial - reference) > 1e-9 * initial:
        raise DeckError.single(file, line, key, f"the reference density {reference:g} kg/m3 is not the initial density {initial:g} kg/m3, "
                               "which neither pyKO nor KO can run", "make both the same; a region of the deck can have another density")


def deck_tables(source: KoDeck, file: str) -> tuple[dict[str, Any], list[str]]:
    """(tables of a deck in SI, sentences on what their deck says and this one does not). Raises `DeckError`."""
    left, regions, materials = list(source.left), [], {}
    names = _names([layer.name for layer in source.layers])
    for layer, name in zip(source.layers, names):
        problems: list = []
        built = build_material(name, layer.tables, problems, file, lambda path: None)
        if problems or built is None:
            raise DeckError(problems)
        own = float(pressure(layer.density, layer.energy, built.eos))
        if abs(own - layer.pressure) > 1e-3 * max(abs(own), abs(layer.pressure), 1e5):
            left.append(f"{name}: the stated pressure {layer.pressure:.6g} Pa is left out; density and energy give {own:.6g} Pa")
        materials[name] = layer.tables
        regions.append({"name": name, "material": name, "from": layer.start, "to": layer.start + layer.length, "zones": layer.cells,
                        "velocity": layer.velocity, "density": layer.density, "energy": layer.energy})
    for one, two in zip(regions, regions[1:]):
        if abs(two["from"] - one["to"]) < 1e-9 * abs(one["to"] - one["from"]):
            one["to"] = two["from"]      # the sum of start and length, rounded: one place
    interfaces = [{"between": [one["name"], two["name"]], "kind": "bonded"} for one, two in zip(regions, regions[1:])]
    gas = all(layer.tables["eos"]["law"] == "ideal_gas" for layer in source.layers)
    solver: dict[str, Any] = {"integrator": "wilkins", "courant": COURANT if gas else COURANT / STEP_SCALE, "viscosity": dict(VISCOSITY)}
    if source.first_step:
        solver["initial_step"] = source.first_step
    tables: dict[str, Any] = {"title": source.title, "geometry": source.geometry, "stop_time": source.stop_time, "region": regions,
                              "material": materials, "boundary": dict(zip(("left", "right"), source.ends))}
    if interfaces:
        tables["interface"] = interfaces
    if source.acceleration:
        tables["body_force"] = {"acceleration": source.acceleration}
    tables["solver"] = solver
    if source.snapshots:
        tables["output"] = {"snapshots": source.snapshots}
    return tables, left


def _names(given: list[str]) -> list[str]:
    """Every layer under a name of its own."""
    names: list[str] = []
    for number, name in enumerate(given, start=1):
        plain = " ".join("".join(c if c.isalnum() or c in " -_" else " " for c in name).split())[:40] or f"layer {number}"
        names.append(plain if given.count(name) == 1 and plain not in names else f"{plain} {number}")
    return names
