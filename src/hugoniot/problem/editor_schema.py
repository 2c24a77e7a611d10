"""JSON Schema of decks, for editors: the models of each solver with the parameters of every registered law."""

from typing import Any

from hugoniot.core.registry import Registry
from hugoniot.laws import mixture, viscosity  # noqa: F401  (enrols the laws)
from hugoniot.laws.mixture.contract import MIXTURE
from hugoniot.laws.mixture.reference_state import CHOICES
from hugoniot.laws.viscosity.contract import VISCOSITY
from hugoniot.materials import table_law
from hugoniot.materials.tables import accepted, families
from hugoniot.problem.solver_kinds import solver_module

_FAMILIES = {"eos": "equation of state, [material.NAME.eos]; of an explosive, the equation of state of its detonation products",
             "strength": "strength law, [material.NAME.strength]; \"none\": a fluid",
             "fracture": "fracture law, [material.NAME.fracture]; \"none\": the material never breaks",
             "burn": "burn law, [material.NAME.burn]; \"none\": the material does not burn"}


def json_schema(kind: str = "lagrange1d") -> dict:
    """JSON Schema of a solver's deck, with the parameters of every registered law."""
    schema = solver_module(kind).Model.model_json_schema(by_alias=True)
    schema["$schema"] = "https://json-schema.org/draft/2020-12/schema"
    schema["title"] = f"hugoniot deck ({kind})"
    definitions = schema.setdefault("$defs", {})
    material: dict[str, Any] = {"type": "object", "additionalProperties": False, "properties": {
        "base": {"type": "string", "description": "name of a material of the library, whose laws the other tables replace or change"}}}
    for family, registry in families().items():
        definitions[f"{family}_law"] = law_schema(registry)
        material["properties"][family] = {"$ref": f"#/$defs/{family}_law", "description": _FAMILIES.get(family, f"{family} law")}
    number = {"anyOf": [{"type": "number"}, {"type": "string"}]}
    material["properties"] |= {
        "unreacted": {"$ref": "#/$defs/eos_law", "description": "equation of state of an explosive before it burns, "
                      "[material.NAME.unreacted]"},
        "mixture": {"enum": MIXTURE.names(), "description":
                    "how unreacted explosive and products share a zone while it burns (default: chosen by the burn law)"},
        "detonation_energy": number | {"unit": "J/kg", "description":
                                       "chemical energy per mass that burning releases (default: from the two equations of state)"},
        "reference_state": {"enum": list(CHOICES), "default": CHOICES[0], "description":
                            "mixture thermal_isolation: whether the reference isentrope of the unreacted explosive keeps shifting "
                            "with its share of the viscous heating (rolling), or stays fixed once a shock has passed (frozen); with "
                            "the solver fronts always frozen"},
        "library": {"type": "string", "description": "name of the library's material of the same substance, for its spall strength and "
                    "optical data, which are not part of the laws (default: base)"},
        "valid_up_to": number | {"unit": "m/s", "description":
                                 "highest particle velocity of the data behind the equation of state; shown by hugoniot check and "
        "in reports"},
        "sources": {"type": "array", "description": "where the numbers come from: strings, or tables with source and, if known, quantity, "
                    "value, unit, via (where it was read), status and note"},
        "warnings": {"type": "array", "items": {"type": "string"}, "description": "texts that a run with this material prints"}}
    definitions["viscosity_law"] = law_schema(VISCOSITY)
    definitions["material"] = material
    return _linked(schema)


def _linked(value: Any) -> Any:
    """Marks of the models (`x-definition`) turned into references to definitions that pydantic does not know."""
    if isinstance(value, dict):
        linked = {key: _linked(inner) for key, inner in value.items() if key != "x-definition"}
        return linked | ({"$ref": f"#/$defs/{value['x-definition']}"} if "x-definition" in value else {})
    return [_linked(inner) for inner in value] if isinstance(value, list) else value


def law_schema(registry: Registry) -> dict:
    """JSON Schema of one law table: one alternative per registered law."""
    alternatives = []
    for law in registry:
        names, required = accepted(law)
        properties: dict[str, Any] = {"law": {"const": law.name}}
        for name in names:
            unit = law.units.get(name, "1")
            kind = {"type": "string"} if unit == "text" else {"type": ["number", "string", "array", "object"]}
            default = law.defaults.get(name)
            properties[name] = kind | {"description": law.meaning.get(name, ""), "unit": unit}
            if default is not None and default == default:
                properties[name]["default"] = default
        alternatives.append({"type": "object", "title": law.name, "description": law.summary, "properties": properties,
                             "required": ["law", *required]})
    if registry.family == "eos":
        alternatives.append(table_law.editor_schema())
    override = {"type": "object", "not": {"required": ["law"]}, "description": "overrides of the base material's law"}
    return {"anyOf": [*alternatives, override, {"const": "none"}]}
