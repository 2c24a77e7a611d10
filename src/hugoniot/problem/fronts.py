"""The deck of the solver `fronts`: bodies, ends, interfaces and gauges as for `lagrange1d`.

Zones say where fields are read out; in the mode "cells" their number also says how fine the mesh is.
"""

from types import MappingProxyType
from typing import Annotated, Any, Literal

from pydantic import Field, WithJsonSchema

from hugoniot.laws.burn.contract import BURN
from hugoniot.laws.eos.contract import EOS, flagged
from hugoniot.laws.fracture.contract import FRACTURE
from hugoniot.laws.mixture.reference_state import ROLLING
from hugoniot.laws.strength.contract import STRENGTH
from hugoniot.materials import burning
from hugoniot.materials.collect import Collector, printable
from hugoniot.materials.material import Material
from hugoniot.problem import checks, explosives, lagrangian, output_fields, windows
from hugoniot.problem.advice import advice_on_speeds, unlikely_constants
from hugoniot.problem.defaults import completed
from hugoniot.problem.gauges import misnamed
from hugoniot.problem.lagrangian import (
    BoundaryTables,
    GaugeTable,
    InterfaceTable,
    LightingTable,
    OutputTable,
    Positive,
    RegionTable,
    _ends,
    _output,
    _parts,
)
from hugoniot.problem.model import Lighting, Problem, SolverOptions
from hugoniot.problem.schema import Quantity, Table, salvage

NAME = "the fronts solver"
SAME_SPEED = 0.01     # between a programmed front and the one its products drive


class OptionsTable(Table):
    """Further options of fronts. The mode decides which problems can be solved."""

    mode: Literal["algebraic", "cells"] = Field(
        "algebraic", description="algebraic: constant states and centred rarefaction fans, every interaction of waves solved exactly; "
        "planar, without profiles, burning or pulses other than constant and square; cells: a moving mesh between the fronts, second "
        "order, for curved geometry, profiles, pulses and burning too")
    fan_step: Annotated[float, Quantity("1", above=0.0, limit=1.0)] = Field(
        0.1, description="velocity step, divided by the sound speed, of each slice into which a rarefaction fan is divided when another "
        "wave reaches it (mode algebraic), or of each cell with which a fan starts (mode cells)")
    weakest: Annotated[float, Quantity("1", least=0.0, limit=0.1)] | None = Field(
        None, description="strength of the weakest waves that are followed; the strength of a wave is its change of stress divided by "
        "rho c^2. In mode cells without profiles, weaker waves are followed too: down to the strength of the strongest wave so far "
        "times the larger of 0.1 and 10 weakest (default: 1e-6; mode cells: 0.01)")
    burn_step: Annotated[float, Quantity("1", least=0.0, limit=1.0)] = Field(
        0.15, description="mode cells: largest change of the burn fraction in a cell while sound crosses it (an eighth of this next to "
        "a tracked shock); cells that burn faster are halved, up to five times, and joined again afterwards; 0: cells are never halved")
    most_fronts: int = Field(400, ge=10, le=100_000, description="largest number of fronts followed at a time; beyond it mode "
        "algebraic stops with a message, and mode cells lets the cells carry new waves, with a warning")


class SolverTable(Table):
    """Options of the solver."""

    kind: Literal["fronts"] = Field(description="name of the solver")
    courant: Annotated[float, Quantity("1", above=0.0, limit=1.0)] | None = Field(
        None, description="mode cells only: Courant number of the time step (default: 0.5)")
    max_cycles: int | None = Field(None, ge=1, le=10**15, description="number of interactions (mode algebraic) or time steps (mode "
        "cells) after which the run stops (default: no limit)")
    options: OptionsTable = Field(default_factory=OptionsTable, description="further options, [solver.options]")  # type: ignore[arg-type]


class FrontsOutputTable(OutputTable):
    """What a run stores, and how often."""

    gauge_interval: Annotated[float, Quantity("s", least=0.0)] = Field(
        0.0, description="time between samples of the gauges, and so the resolution of arrival times (fronts.csv has the exact paths of "
        "the fronts); 0: a thousandth of stop_time")


class Model(Table):
    """The solver `fronts` follows shocks, fans and contacts in one dimension as sharp fronts, without artificial viscosity.

    Use it for reference solutions. Fracture laws and periodic ends are not supported, and `perfectly_plastic` is the only strength law.
    The fields of the results are given in the zones of the regions; with mode cells the zones also set the fineness of the mesh.
    """

    title: str = Field("", max_length=200, description="title of the report and plots (default: the deck's file name)")
    geometry: Literal["planar", "cylindrical", "spherical"] = Field("planar",
        description="symmetry; cylindrical and spherical need mode cells")
    stop_time: Positive = Field(description="time at which the run ends, such as \"2.5 us\"")
    region: list[RegionTable] = Field(min_length=1, max_length=1000, description="the layers of material, [[region]]")
    material: dict[str, Annotated[Any, WithJsonSchema({"x-definition": "material"})]] = Field(
        default_factory=dict, description="materials defined in this deck, [material.NAME]")
    boundary: BoundaryTables = Field(default_factory=lambda: BoundaryTables(), description="the two ends, [boundary]")
    interface: list[InterfaceTable] = Field(default_factory=list, max_length=1000,
        description="interfaces that are not simply separable, [[interface]]")
    lighting: list[LightingTable] = Field(default_factory=list, max_length=10_000, description="mode cells only: detonators, [[lighting]]")
    gauge: list[GaugeTable] = Field(default_factory=list, max_length=10_000, description="Lagrangian gauges, [[gauge]]")
    solver: SolverTable = Field(description="the solver and its options, [solver]")
    output: FrontsOutputTable = Field(default_factory=FrontsOutputTable, description="what is stored, [output]")  # type: ignore[arg-type]


def read(raw: dict, model: Model | None, materials: dict[str, Material | None], collector: Collector) -> tuple[Problem | None, list[str]]:
    """The problem, and warnings; the problem is None when anything was reported (see `problem.lagrangian.read`)."""
    warnings: list[str] = []
    geometry = raw.get("geometry", "planar")
    tables = {name: _parts(kind, raw.get(name)) for name, kind in
              (("region", RegionTable), ("interface", InterfaceTable), ("gauge", GaugeTable))}
    regions, used = checks.read_regions(tables["region"], raw.get("region"), geometry, materials, collector, warnings)
    broken = checks.unread(raw.get("region"), regions)
    interfaces = checks.read_interfaces(tables["interface"], regions, collector, broken)
    gauges = checks.read_gauges(tables["gauge"], () if broken else regions, used, collector)
    left, right = _ends(raw, geometry, regions, collector)
    output = _output(raw, collector)
    for name in raw.get("material", {}) if isinstance(raw.get("material"), dict) else ():
        if name not in used and regions and not broken:
            warnings.append(f"material '{printable(name)}' of the deck is not used by any region")
    solver = salvage(SolverTable, raw.get("solver", {}))
    if model is None or collector.problems or left is None or right is None or solver is None or output is None:
        return None, warnings
    options = SolverOptions("fronts", courant=solver.courant, max_cycles=solver.max_cycles,
                            options=MappingProxyType(with_defaults(solver.options.model_dump())))
    lighting = tuple(Lighting(row.at, row.time) for row in model.lighting)
    problem = Problem(model.title, model.geometry, model.stop_time, regions, used, left, right, interfaces, gauges, options, output,
                      lighting)
    for defect in (*explosives.defects(problem), *windows.defects(problem), *misnamed(problem),
                   *output_fields.defects(problem.output, problem.regions, problem.materials)):
        collector.add(*defect)
    for path, message in defects(problem):
        collector.add(path, message)
    said = unlikely_constants(problem) + advice_on_speeds(problem) + windows.advice(problem)
    return (None if collector.problems else completed(problem)), warnings + said


def with_defaults(options) -> dict:
    """Options of this solver with nothing left open."""
    given = {name: value for name, value in dict(options).items() if value is not None}
    found = {**OptionsTable(weakest=None).model_dump(), **given}  # type: ignore[call-arg]
    return found | {"weakest": found["weakest"] if found["weakest"] is not None else {"algebraic": 1e-6, "cells": 0.01}[found["mode"]]}


def defects(problem: Problem) -> list[tuple[tuple, str]]:
    """(place in the deck, message) of everything that the mode asked for cannot describe."""
    found: list[tuple[tuple, str]] = []
    cells = with_defaults(problem.solver.options)["mode"] == "cells"
    if problem.solver.viscosity is not None:
        found.append((("solver", "viscosity"), f"{NAME} has no artificial viscosity, its shocks are jumps: leave [solver.viscosity] out"))
    for name, material in problem.materials.items():
        found += [(("material", name, *path), f"material '{name}' {message}") for path, message in _material_defects(material, cells)]
        if cells and _has_strength(material):
            found += [(("material", name, "strength"), f"material '{name}' {message}") for message in _strong_defects(material)]
    if cells:
        found += _front_defects(problem) + _pressed_too_late(problem)
    for side, end in (("left", problem.left), ("right", problem.right)):
        if end.kind == "periodic":
            found.append((("boundary", side), f"{NAME} has no periodic ends, because a front ends at an end of the line: use lagrange1d"))
        if end.pulse is not None and end.kind == "pressure" and min(end.pulse.amplitude, *end.pulse.values, 0.0) < 0.0:
            message = f"a pressure below zero is tension, and the surfaces of {NAME} open in tension: give zero or more"
            found.append((("boundary", side), message))
    return found if cells else found + _beyond_algebra(problem)


def _beyond_algebra(problem: Problem) -> list[tuple[tuple, str]]:
    """What constant states and exact waves cannot describe."""
    found: list[tuple[tuple, str]] = []
    if problem.geometry != "planar":
        found.append((("geometry",), f"the mode 'algebraic' of {NAME} is planar: between {problem.geometry} fronts no state is constant; "
                      "use solver.options.mode = \"cells\""))
    if problem.solver.courant is not None:
        found.append((("solver", "courant"), "the mode 'algebraic' has no time step: leave courant out"))
    for k, region in enumerate(problem.regions):
        if region.profile is not None:
            found.append((("region", k, "profile"), f"the mode 'algebraic' of {NAME} starts from one state along a region: use "
                          "solver.options.mode = \"cells\", or split the region into several of constant state"))
        if isinstance(region.velocity, tuple) and region.velocity[0] != region.velocity[1]:
            message = (f"region '{region.name}' has a velocity profile; the mode 'algebraic' of {NAME} needs constant initial states: use "
                       "solver.options.mode = \"cells\"")
            found.append((("region", k, "velocity"), message))
    for side, end in (("left", problem.left), ("right", problem.right)):
        if end.pulse is not None and end.pulse.shape not in ("constant", "square"):
            message = (f"a {end.pulse.shape} pulse sends out a fan of its own; the mode 'algebraic' of {NAME} accepts constant and square "
                       "pulses: give one of these, or use solver.options.mode = \"cells\"")
            found.append((("boundary", side), message))
    return found


def _front_defects(problem: Problem) -> list[tuple[tuple, str]]:
    """Programmed speeds that are not those of the products: a tracked front runs at its own."""
    found: list[tuple[tuple, str]] = []
    for region in problem.regions:
        speed = explosives.front_speed(problem, region)
        own = explosives.ideal_speed(problem, region)
        if speed > 0.0 and own is None:
            message = (f"material '{region.material}': its products support no detonation, and a tracked front runs at their CJ speed; "
                       "give products that release energy (an equation of state of products), or use lagrange1d")
            found.append((("material", region.material, "burn"), message))
        elif own is not None and abs(speed / own - 1.0) > SAME_SPEED:
            message = (f"material '{region.material}': the programmed front runs at {speed:.5g} m/s, but {NAME} tracks the CJ front of the "
                       f"products, {own:.6g} m/s; give burn.detonation_velocity = {own:.6g}")
            found.append((("material", region.material, "burn", "detonation_velocity"), message))
    return list(dict.fromkeys(found))


def _pressed_too_late(problem: Problem) -> list[tuple[tuple, str]]:
    """Gases at an end whose pressure begins at zero and rises: they expand to nothing first, and the pressure then meets no mass."""
    found: list[tuple[tuple, str]] = []
    for side, end, region in (("left", problem.left, problem.regions[0]), ("right", problem.right, problem.regions[-1])):
        material, pulse = problem.materials[region.material], end.pulse
        hot = max(region.pressure or 0.0, region.temperature or 0.0, region.energy or 0.0) > 0.0
        if end.kind != "pressure" or pulse is None or material.burn is not None or not flagged(material.eos, "gas") or not hot:
            continue
        late = (pulse.start > 0.0 or pulse.shape in ("half_sine", "ramp")) and pulse.amplitude > 0.0
        if pulse.shape == "table":
            late = pulse.values[0] == 0.0 and max(pulse.values) > 0.0
        if late:
            found.append((("boundary", side), f"the pressure starts at zero, so the gas of region '{region.name}' expands into "
                          "vacuum before the pressure rises, which then acts on an edge without mass; start from the pressure of the "
                          "gas (a table of times and values), or drive the end with a velocity"))
    return found


def _has_strength(material: Material) -> bool:
    strength = material.strength
    return strength is not None and STRENGTH.of(strength).name != "none" and getattr(strength, "yield_stress", 1.0) > 0.0


def _strong_defects(material: Material) -> list[str]:
    """What the cells cannot follow of a material with strength."""
    if material.burn is not None and "programmed" in BURN.of(material.burn).flags:
        return [f"burns by a programmed front and has strength: in {NAME} the explosive has no state ahead of the front, and the products "
                "behind it are a fluid; leave the strength out, or use lagrange1d"]
    if material.burn is not None:
        return [f"burns and has strength: behind a front of {NAME} a partly burned solid would have to divide the work of the jump between "
                "reactants, products and distortion, for which there is no rule; leave one of the two out, or use lagrange1d"]
    return []


def _material_defects(material: Material, cells: bool) -> list[tuple[tuple, str]]:
    found: list[tuple[tuple, str]] = []
    if material.burn is not None and not cells:
        found.append((("burn",), f"burns, which {NAME} follows in the mode 'cells' only: behind a detonation no state is constant; "
                      "use solver.options.mode = \"cells\""))
    elif material.burn is not None:
        found += _burn_defects(material)
    if material.fracture is not None and FRACTURE.of(material.fracture).name != "none":
        found.append((("fracture",), f"has a fracture law; {NAME} cannot open a new surface inside a body: "
                      "leave the law out (nothing spalls then), or use lagrange1d"))
    if flagged(material.eos, "shocks_only") and _has_strength(material):
        law = EOS.of(material.eos).name
        found.append((("strength",), f"has strength and a pressure that does not depend on its density ('{law}'), which "
                      "supports no tension: "
                      "leave the strength out, or use another equation of state, such as mie_gruneisen"))
    if cells and flagged(material.eos, "shocks_only"):
        found.append((("eos",), f"has a pressure that rises with the square root of the energy ('{EOS.of(material.eos).name}'); "
                      "in cells that energy is a small difference of large numbers, and releases would be too fast on any mesh: use "
                      "solver.options.mode = \"algebraic\", or another equation of state, such as mie_gruneisen"))
    if flagged(material.eos, "remembers"):
        found += _porous_defects(material, cells)
    if material.strength is not None and STRENGTH.of(material.strength).name not in ("none", "perfectly_plastic"):
        law = STRENGTH.of(material.strength).name
        what = "no constant shear modulus" if law in ("constant_poisson", "herrmann") else "no constant yield stress"
        found.append((("strength", "law"), f"has {what} ('{law}'); the waves of {NAME} are exact for perfectly_plastic (or none) only, "
                      "whose stress deviator depends on the density alone: use one of these, or lagrange1d"))
    return found


def _porous_defects(material: Material, cells: bool) -> list[tuple[tuple, str]]:
    """What is not followed of material whose pores stay crushed."""
    found: list[tuple[tuple, str]] = []
    if cells and getattr(material.eos, "exponent", 1.0) > 1.0:
        found.append((("eos", "exponent"), "has a crush curve that is concave at first (an exponent above 1), so that compaction begins "
                      f"with a fan ahead of its shock, which {NAME} follows in the mode 'algebraic' only: use that, exponent = 1, or "
                      "lagrange1d"))
    if _has_strength(material):
        found.append((("strength",), "has strength and pores that stay crushed: its yield surface would move with the pores, and "
                      f"{NAME} has no exact waves for both together; leave one of the two out, or use lagrange1d"))
    return found


def _burn_defects(material: Material) -> list[tuple[tuple, str]]:
    """Programmed fronts burn into products alone; rates are resolved behind tracked shocks; what burns at once is neither."""
    law, closure = BURN.of(material.burn), burning.closure(material)
    if "programmed" in law.flags:
        if closure == "burned_products":
            return []
        return [(("burn",), f"burns by '{law.name}' with '{closure}'; {NAME} follows programmed fronts into 'burned_products' only: a "
                 "front into a mixture would have a shock of its own; use that closure, a rate law, or lagrange1d")]
    if "instantaneous" in law.flags or not burning.has_reactants(material):
        return [(("burn",), f"burns by '{law.name}' with '{closure}': {NAME} resolves a reaction rate behind a tracked shock, and "
                 "this law has none; use 'programmed', whose front is tracked, or a rate law")]
    found: list[tuple[tuple, str]] = []
    if material.reference_state == ROLLING:
        found.append((("reference_state",), f"has reference_state = \"rolling\"; {NAME} keeps the state behind its tracked shocks: "
                      "use \"frozen\""))
    if material.unreacted is not None and flagged(material.unreacted, "remembers"):
        found.append((("unreacted",), f"keeps the pores of its unreacted explosive crushed, which {NAME} does not follow: their "
                      "release is not an isentrope of the law; use lagrange1d"))
    return found


def write(problem: Problem) -> dict:
    """Tables of a deck, every default written out, that reads back to exactly this problem."""
    deck = lagrangian.write(problem)
    own = {"courant": problem.solver.courant, "max_cycles": problem.solver.max_cycles}
    deck["solver"] = {"kind": "fronts", "options": with_defaults(problem.solver.options)} | {k: v for k, v in own.items() if v is not None}
    return deck
