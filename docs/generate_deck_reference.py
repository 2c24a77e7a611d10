"""Writes docs/generated/deck_reference.md from the deck schema and the registries: what a deck may say is said in one place only."""

import argparse
from pathlib import Path

from hugoniot.core.fields import FIELDS
from hugoniot.laws.viscosity.contract import VISCOSITY
from hugoniot.materials.tables import accepted, families
from hugoniot.problem import catalogue
from hugoniot.problem.editor_schema import json_schema
from hugoniot.problem.solver_kinds import available_solvers, solver_module

INTRODUCTION = """\
# Deck reference

A deck is a [TOML](https://toml.io) file. A quantity is a string with a unit, such as `"3.94 km/s"`; a bare number is SI.
Unknown keys are errors, and all errors are reported together. `hugoniot check DECK` reads a deck without running it,
`hugoniot check DECK --resolved` prints it with every default written out, and `hugoniot init --schema` writes the JSON Schema for editors.

This page is generated from the schema.
"""
MATERIALS = """\
## Materials and laws

A region's `material` is a table of the deck or a name from the library. `base = "copper"` starts from a material of the library:
a law table without `law`, or with the same law, replaces single numbers; a table with another law replaces the whole law;
`fracture = "none"` removes the fracture law.
`sources` and `valid_up_to` say where the numbers come from and up to which particle velocity they hold.
"""
BOUNDARIES = """\
## Boundaries

`left` and `right` are `"free"`, `"fixed"`, `"transmitting"`, `"periodic"` (both ends), `{velocity = ...}` or `{pressure = ...}`.
The value is a quantity, a table
`{times = [...], values = [...]}` (linear between the times, constant outside them),
or a pulse `{shape = ..., amplitude = ..., duration = ..., start = ...}`
with the shape `exponential`, `half_sine`, `square` or `ramp`. At the axis or origin of curved geometry nothing needs to be given.

In two dimensions `[[boundary]]` names chains of edges (`on = "bar.bottom"`), their `kind`, and `velocity` or `pressure` in the same forms.
"""


def table(heads: list[str], rows: list[list[str]]) -> str:
    """A Markdown table."""
    lines = [heads, ["---"] * len(heads), *rows]
    return "\n".join("| " + " | ".join(str(cell).replace("|", "\\|").replace("\n", " ") for cell in line) + " |" for line in lines) + "\n"


def kind_of(entry: dict) -> str:
    """What a key takes, in words."""
    if "unit" in entry:
        return "number" if entry["unit"] == "1" else f"quantity in {entry['unit']}"
    for part in entry.get("anyOf", ()):
        if "unit" in part:
            return kind_of(part)
    if "enum" in entry:
        return " | ".join(f'`"{value}"`' for value in entry["enum"])
    if "const" in entry:
        return f'`"{entry["const"]}"`'
    names = {"integer": "whole number", "string": "text", "boolean": "true or false", "array": "array", "number": "number"}
    if "anyOf" in entry:
        return " or ".join(dict.fromkeys(kind_of(part) for part in entry["anyOf"] if part.get("type") != "null"))
    return names.get(str(entry.get("type")), "table")


def keys(schema: dict) -> str:
    """The keys of one table of the deck."""
    required = set(schema.get("required", ()))
    rows = []
    for name, entry in schema["properties"].items():
        default = "required" if name in required else "" if entry.get("default") in (None, "") else f"`{entry['default']}`".lower()
        rows.append([f"`{name}`", kind_of(entry), default, entry.get("description", "")])
    return table(["key", "takes", "default", "meaning"], rows)


def target(entry: dict, schema: dict) -> dict | None:
    """The definition a key of the deck refers to, if it is a table of its own."""
    for part in (entry, entry.get("items", {}), entry.get("additionalProperties", {}), *entry.get("anyOf", ())):
        reference = part.get("$ref") if isinstance(part, dict) else None
        if reference:
            return schema["$defs"][reference.rpartition("/")[2]]
    return None


def solver_section(kind: str) -> str:
    """Everything a deck of one solver may say, laws aside."""
    schema = json_schema(kind)
    text = [f"## Decks of `{kind}`\n", (solver_module(kind).Model.__doc__ or "").strip() + "\n", keys(schema)]
    for name, entry in schema["properties"].items():
        found = target(entry, schema)
        if found and name != "material":
            head = f"[[{name}]]" if entry.get("type") == "array" else f"[{name}.MATERIAL]" if name == "transport" else f"[{name}]"
            text += [f"### {head}\n", found.get("description", "") + "\n", keys(found)]
            for inner, part in found.get("properties", {}).items():
                if (deeper := target(part, schema)) and "properties" in deeper:
                    text += [f"#### [{name}.{inner}]\n", deeper.get("description", "") + "\n", keys(deeper)]
    return "\n".join(text)


def law_section(family: str, registry) -> str:
    """Every law of a family with its parameters."""
    where = "[solver.viscosity]" if family == "viscosity" else f"[material.NAME.{family}]"
    text = [f"### {family} laws, {where}\n"]
    for name in registry.names():
        law = registry.get(name)
        names, required = accepted(law)
        text.append(f'#### law = "{name}"\n\n{law.summary}\n\nSource: {"; ".join(law.references)}.\n')
        rows = []
        for n in names:
            default = "required" if n in required else shown_default(law, n)
            rows.append([f"`{n}`", law.units.get(n, "1"), default, law.meaning.get(n, "")])
        text.append(table(["parameter", "unit", "default", "meaning"], rows) if rows else "It has no parameters.\n")
    return "\n".join(text)


def shown_default(law, name: str) -> str:
    """A default as the table shows it; not-a-number stands for "none"."""
    value = law.defaults.get(name)
    return "optional" if value is None or value != value else f"`{value}`"


def reference() -> str:
    """The whole page."""
    text = [INTRODUCTION, *(solver_section(kind) for kind in available_solvers())]
    text.append(MATERIALS)
    text += [law_section(family, registry) for family, registry in {**families(), "viscosity": VISCOSITY}.items()]
    text.append(BOUNDARIES)
    text.append("## Fields\n\n" + table(["field", "symbol", "unit", "at", "meaning"],
                                        [[f"`{f.name}`", f.symbol, f.unit, f.place, f.long_name] for f in FIELDS.values()]))
    problems = [[f"`{p.name}`", p.summary] for p in catalogue.problems()]
    text.append("## Problems to start from\n\n" + table(["`hugoniot init` ...", "shows"], problems))
    return "\n".join(text)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=Path, default=Path(__file__).parent / "generated" / "deck_reference.md")
    out = parser.parse_args().out
    out.parent.mkdir(parents=True, exist_ok=True)
    out.write_text(reference(), encoding="utf-8")


if __name__ == "__main__":
    main()
