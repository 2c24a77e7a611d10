"""Further terms of motion and energy in a deck of `lagrange1d`: body force, heat sources, transport of the materials."""

from types import MappingProxyType
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import BeforeValidator, Field, WithJsonSchema

from hugoniot.errors import OutOfRange
from hugoniot.laws import transport as _transport  # noqa: F401  (enrols the transport laws)
from hugoniot.laws.eos.contract import has_temperature
from hugoniot.laws.transport.contract import CONDUCTION, TRANSPORT, Transport, conducts, make, needs_temperature
from hugoniot.materials.collect import Collector, nearest, printable
from hugoniot.materials.law_reader import read_law
from hugoniot.materials.tables import law_table
from hugoniot.problem.boundaries import pulse_schema, pulse_value, read_pulse
from hugoniot.problem.model import BodyForce, HeatSource, Problem
from hugoniot.problem.schema import Quantity, Table, salvage, trouble
from hugoniot.units import UnitError, parse

_LAW = {"type": "object", "required": ["law"]}
LONGEST_PROFILE = 10_000


def _depths(value: Any) -> tuple[float, ...]:
    if not isinstance(value, list) or not 2 <= len(value) <= LONGEST_PROFILE:
        raise trouble(f"expected an array of 2 to {LONGEST_PROFILE} depths")
    try:
        found = tuple(parse(v, "m") for v in value)
    except UnitError as error:
        raise trouble(error.message, error.hint) from None
    if found[0] < 0.0 or any(b <= a for a, b in zip(found, found[1:])):
        raise trouble("depths must not be negative, and must increase")
    return found


def _weights(value: Any) -> tuple[float, ...]:
    if not isinstance(value, list) or not all(isinstance(v, (int, float)) and not isinstance(v, bool) and 0.0 <= v < 1e30 for v in value):
        raise trouble("expected an array of numbers, none of them negative")
    if not any(value):
        raise trouble("no energy is deposited: every weight is 0")
    return tuple(float(v) for v in value)


class BodyForceTable(Table):
    """A force on all material: uniform gravity in planar geometry, a field about the axis or centre in curved geometry."""

    acceleration: Annotated[Any, WithJsonSchema(pulse_schema() | {"unit": "m/s^2"})] = Field(
        description="acceleration, positive towards larger positions; constant, or a pulse or table of times")
    exponent: Annotated[float, Quantity("1", limit=10.0)] | None = Field(
        None, description="curved geometry, where it is required: power n of the field acceleration (r/radius)^n; -2 for a point mass, "
        "1 for rotation")
    radius: Annotated[float, Quantity("m", above=0.0)] | None = Field(
        None, description="curved geometry, where it is required: radius at which the field equals acceleration")


class HeatSourceTable(Table):
    """Energy supplied to a region that does not burn: an X-ray, laser or electron pulse, or any other heating.

    With neither absorption_length nor depths the energy is spread evenly over the mass of the region.
    """

    region: str = Field(description="name of the heated region; its material must not burn")
    power: Annotated[Any, WithJsonSchema(pulse_schema() | {"unit": "W/kg"})] = Field(
        None, description="power per mass, multiplied by weights if given; constant, or a pulse or table of times; give either this or "
        "intensity")
    intensity: Annotated[Any, WithJsonSchema(pulse_schema() | {"unit": "W/m^2"})] = Field(
        None, description="power per area that enters the region through the face named by side; constant, or a pulse or table of times; "
        "give either this or power")
    side: Literal["left", "right"] = Field("left", description="face of the region from which depths are measured")
    absorption_length: Annotated[float, Quantity("m", above=0.0)] | None = Field(
        None, description="with intensity: depth over which it falls to 1/e; what reaches the other face is lost; excludes depths")
    depths: Annotated[Any, BeforeValidator(_depths), WithJsonSchema({"type": "array", "unit": "m"})] = Field(
        None, description="depths below the face at t = 0, increasing, at which weights are given; linear in between, zero outside")
    weights: Annotated[Any, BeforeValidator(_weights), WithJsonSchema({"type": "array", "items": {"type": "number"}})] = Field(
        None, description="one number per depth: with power the factor that multiplies it, with intensity the relative energy per "
        "mass")


class MaterialTransportTable(Table):
    """Physical viscosity and heat conduction of MATERIAL, a material that a region uses and that does not burn.

    A material without such a table has neither.
    """

    viscosity: Annotated[Any, WithJsonSchema(_LAW)] = Field(None, description="shear viscosity, a table {law = \"...\", ...} (hugoniot "
        "list transport) (default: none)")
    conduction: Annotated[Any, WithJsonSchema(_LAW)] = Field(None, description="heat conduction, a table {law = \"...\", ...} "
        "(hugoniot list conduction) (default: none)")
    bulk_ratio: Annotated[float, Quantity("1", least=0.0)] = Field(0.0, description="bulk viscosity divided by shear viscosity")
    bulk_viscosity: Annotated[float, Quantity("Pa s", least=0.0)] = Field(0.0, description="constant that is added to the bulk viscosity")


class TermTables(Table):
    """Optional terms of the equations of motion and energy."""

    body_force: BodyForceTable | None = Field(None, description="gravity or another force on all material, [body_force]")
    heat_source: list[HeatSourceTable] = Field(default_factory=list, max_length=100,
        description="energy supplied from outside, [[heat_source]]")
    transport: dict[str, MaterialTransportTable] = Field(
        default_factory=dict, description="physical viscosity and heat conduction of materials, [transport.MATERIAL]")


# -- reading -----------------------------------------------------------------------------------------------------------
def read_terms(raw: dict, collector: Collector) -> dict[str, Any]:
    """{"body_force", "heat_sources", "transport"} of a `Problem`, as far as they could be read; what is wrong is reported."""
    return {"body_force": _body_force(raw.get("body_force"), collector), "heat_sources": _heat_sources(raw.get("heat_source"), collector),
            "transport": MappingProxyType(_transports(raw.get("transport"), collector))}


def _body_force(raw: Any, collector: Collector) -> BodyForce | None:
    table = salvage(BodyForceTable, raw)
    if table is None:
        return None
    pulse = read_pulse(table.acceleration, "m/s^2", collector, ("body_force", "acceleration"))
    return None if pulse is None else BodyForce(pulse, table.exponent, table.radius)


def _heat_sources(raw: Any, collector: Collector) -> tuple[HeatSource, ...]:
    found = []
    for k, row in enumerate(raw if isinstance(raw, list) else []):
        table, path = salvage(HeatSourceTable, row), ("heat_source", k)
        if table is None:
            continue
        given = [(name, unit) for name, unit in (("power", "W/kg"), ("intensity", "W/m^2")) if getattr(table, name) is not None]
        if len(given) != 1:
            collector.add(path, "a heat source needs exactly one of power and intensity",
                          "give power in W/kg, or intensity in W/m^2 through a face")
            continue
        if (table.depths is None) != (table.weights is None) or table.depths and len(table.depths) != len(table.weights):
            collector.add((*path, "depths"), "a profile needs as many weights as depths")
            continue
        if table.absorption_length is not None and (table.depths is not None or given[0][0] == "power"):
            collector.add((*path, "absorption_length"), "applies to an intensity without depths",
                          "give intensity and absorption_length, or depths and weights")
            continue
        pulse = read_pulse(getattr(table, given[0][0]), given[0][1], collector, (*path, given[0][0]))
        if pulse is not None and min(pulse.amplitude, *pulse.values, 0.0) < 0.0:
            collector.add((*path, given[0][0]), "a heat source supplies energy; a negative one could cool the material below absolute zero",
                          "give 0 or more")
            continue
        if pulse is not None:
            found.append(HeatSource(table.region, given[0][0], pulse, table.side, table.absorption_length, table.depths or (),
                                    table.weights or ()))
    return tuple(found)


def _transports(raw: Any, collector: Collector) -> dict[str, Any]:
    """Material -> {"viscosity": {law, parameters} or absent, ...} in SI."""
    found: dict[str, Any] = {}
    for name, row in (raw.items() if isinstance(raw, dict) else ()):
        table, path = salvage(MaterialTransportTable, row), ("transport", name)
        if table is None:
            continue
        own: dict[str, Any] = {"bulk_ratio": table.bulk_ratio, "bulk_viscosity": table.bulk_viscosity}
        for key, family in (("viscosity", TRANSPORT), ("conduction", CONDUCTION)):
            if getattr(table, key) is None:
                continue
            par = read_law(family, getattr(table, key), collector, (*path, key))
            if par is not None:
                own[key] = law_table(family, par)
        try:
            transport_of(own)
            found[name] = own
        except OutOfRange as error:
            collector.add(path, printable(str(error), 300))
    return found


def transport_of(table: dict) -> Transport:
    """The checked laws of one material; `shear` is None where it has no viscosity. Raises `OutOfRange`."""
    if "viscosity" in table:
        return make(table["viscosity"], table.get("conduction"), table["bulk_ratio"], table["bulk_viscosity"])
    if table["bulk_ratio"] > 0.0 or table["bulk_viscosity"] > 0.0:
        raise OutOfRange("a bulk viscosity needs a shear viscosity as well; give viscosity = {law = ...}")
    if table.get("conduction", {"law": "none"})["law"] in ("none", "prandtl"):
        raise OutOfRange("give a viscosity or a conduction law; a Prandtl number needs a viscosity as well")
    return make(TRANSPORT.get("constant").example, table["conduction"])._replace(shear=None)


# -- checks ------------------------------------------------------------------------------------------------------------
def defects(problem: Problem) -> list[tuple[tuple, str, str]]:
    """(place in the deck, message, way out) of every term that the problem cannot have."""
    found: list[tuple[tuple, str, str]] = []
    force, curved = problem.body_force, problem.dimension > 1
    if force is not None and curved and (force.exponent is None or force.radius is None):
        found.append((("body_force",), f"a uniform force has no {problem.geometry} symmetry",
                      "give exponent and radius of a field about the axis or the centre"))
    if force is not None and not curved and (force.exponent is not None or force.radius is not None):
        found.append((("body_force",), "exponent and radius apply to curved geometry only",
                      "leave them out: in planar geometry the force is uniform"))
    regions = {region.name: region for region in problem.regions}
    for k, source in enumerate(problem.heat_sources):
        region = regions.get(source.region)
        if region is None:
            found.append((("heat_source", k, "region"), f"no region '{printable(source.region)}'", nearest(source.region, regions)))
        elif problem.materials[region.material].burn is not None:
            found.append((("heat_source", k, "region"), f"'{source.region}' burns: how reactants and products share the heat is unknown",
                          "heat an inert region"))
        elif source.depths and not _deposits(source, region.end - region.start):
            found.append((("heat_source", k, "weights"), f"nothing is heated: the weights are 0 throughout '{source.region}'",
                          "depths are measured from the face of the region"))
        elif source.kind == "intensity" and curved and source.side == "left" and region.start == 0.0:
            found.append((("heat_source", k, "side"), "nothing passes through the axis or the centre", 'use side = "right", or power'))
    for name, table in problem.transport.items():
        found += _transport_defects(problem, name, table)
    return found


def _deposits(source: HeatSource, width: float) -> bool:
    """Whether a profile in depth is above zero somewhere in a region of that width, m."""
    inside = [weight for depth, weight in zip(source.depths, source.weights) if depth < width]
    return any(inside) or bool(inside) and float(np.interp(width, source.depths, source.weights, right=0.0)) > 0.0


def _transport_defects(problem: Problem, name: str, table: dict) -> list[tuple[tuple, str, str]]:
    path, material = ("transport", name), problem.materials.get(name)
    if material is None:
        return [(path, f"no region is made of '{printable(name)}'", nearest(name, problem.materials))]
    if material.burn is not None:
        return [(path, f"'{name}' burns: transport in a mixture of reactants and products is unknown", "leave it out")]
    made = transport_of(table)
    needs = conducts(made) if made.shear is None else needs_temperature(made)
    if needs and not has_temperature(material.eos):
        return [(path, f"needs a temperature, which the equation of state of '{printable(name)}' does not give",
                 "give it a specific_heat, or a constant viscosity without conduction")]
    return []


# -- writing -----------------------------------------------------------------------------------------------------------
def write_terms(problem: Problem) -> dict[str, Any]:
    """Tables of a deck that read back to the same terms."""
    deck: dict[str, Any] = {}
    if (force := problem.body_force) is not None:
        deck["body_force"] = _given(acceleration=pulse_value(force.acceleration), exponent=force.exponent, radius=force.radius)
    if problem.heat_sources:
        deck["heat_source"] = [_given(region=s.region, side=s.side, absorption_length=s.absorption_length, depths=list(s.depths) or None,
                                      weights=list(s.weights) or None, **{s.kind: pulse_value(s.pulse)}) for s in problem.heat_sources]
    if problem.transport:
        deck["transport"] = {name: dict(table) for name, table in problem.transport.items()}
    return deck


def _given(**values: Any) -> dict[str, Any]:
    return {name: value for name, value in values.items() if value is not None}
