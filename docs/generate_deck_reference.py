"""Writes docs/generated/deck_reference.md from the deck schema and the registries: what a deck may say is said in one place only."""

import argparse
import inspect
import json
import re
from pathlib import Path

from deck_words import BOUNDARIES, INTRODUCTION, LAWS, MATERIALS

from hugoniot.core.fields import FIELDS
from hugoniot.laws.mixture.contract import MIXTURE
from hugoniot.laws.transport.contract import CONDUCTION, TRANSPORT
from hugoniot.laws.viscosity.contract import VISCOSITY
from hugoniot.materials import table_law
from hugoniot.materials.tables import accepted, families
from hugoniot.problem import catalogue
from hugoniot.problem.boundaries import HistoryTable, PulseTable
from hugoniot.problem.editor_schema import json_schema
from hugoniot.problem.solver_kinds import available_solvers, solver_module

NAMES = {"eos": ("Equations of state", "[material.NAME.eos]"), "strength": ("Strength laws", "[material.NAME.strength]"),
         "fracture": ("Fracture laws", "[material.NAME.fracture]"), "burn": ("Burn laws", "[material.NAME.burn]"),
         "viscosity": ("Artificial viscosity of lagrange1d", "[solver.viscosity]"),
         "transport": ("Shear viscosity", "[transport.MATERIAL] and [solver.transport], as viscosity = {law = ...}"),
         "conduction": ("Heat conduction", "[transport.MATERIAL] and [solver.transport], as conduction = {law = ...}")}
ORDER = ("title", "geometry", "stop_time", "region", "block", "material", "boundary", "interface", "contact", "rigid", "gauge", "lighting",
         "body_force", "heat_source", "transport", "solver", "output")      # in which a user meets the tables
CHOICE = re.compile(r"(?<![`\w])(kind|mode|cells|mixture) (velocity|pressure|wall|bonded|separable|bond|herrmann|cells|algebraic|quads|"
                    r"triangles|thermal_isolation)\b(?!`)")
CUES = (r"(\b(?:[Nn]eeds|[Ee]xcludes|this or|exceeds|equals|[Gg]ive(?: exactly one of)?|[Ww]ithout|[Ww]ith|on|along|by|according to|"
        r"relative to|away from|about|sum of|one of|nor|either|at which|between(?= at)|multiplied by|at most two of) )")
FIRST = "lagrange1d"
PULSES = ("PulseTable", "HistoryTable")
CODE = re.compile(r'`[^`]*`|\[\[?[A-Za-z][\w.]*\]\]?|(?:\w+ = )?\{law = [^}]*\}|law = "[^"]*"|"[^"]*"|'
                  r'\bhugoniot (list \w+|check|init|resume|run)|\w+ = (true|false)|(?<![\w./])[a-z]+_\w+')


def coded(text: str, names=()) -> str:
    """Text with names, tables and values set as code; `names` are keys, which are code where the word before shows that they are meant."""
    text = CHOICE.sub(lambda found: f'`{found[1]} = "{found[2]}"`', text)
    if names:
        one = "(?:" + "|".join(sorted(map(re.escape, names), key=len, reverse=True)) + r")\b(?![(`])"
        listed = f"({one}(?:, {one})*(?:,? (?:and|or) {one})?)(?! =)"
        text = re.sub(CUES + listed, lambda found: found[1] + re.sub(one, r"`\g<0>`", found[2]), text)
    return CODE.sub(lambda found: found[0] if found[0][0] == "`" else f"`{found[0]}`", text)


def table(heads: list[str], rows: list[list[str]]) -> str:
    """A Markdown table."""
    lines = [heads, ["---"] * len(heads), *rows]
    return "\n".join("| " + " | ".join(str(cell).replace("|", "\\|").replace("\n", " ") for cell in line) + " |" for line in lines) + "\n"


def kind_of(entry: dict) -> str:
    """What a key takes, in words."""
    parts = entry.get("anyOf", ())
    if "$ref" in entry and '"none"' in entry.get("description", ""):
        return 'table, or `"none"`'
    unit = entry.get("unit") or next((part["unit"] for part in parts if "unit" in part), None)
    if unit is not None:
        return _measured(entry, parts, unit)
    if "enum" in entry:
        return ", ".join(f'`"{value}"`' for value in entry["enum"])
    if "const" in entry:
        return f'`"{entry["const"]}"`'
    if parts:
        found = list(dict.fromkeys(kind_of(part) for part in parts if part.get("type") != "null"))
        words = ["string", "table"] if any("enum" in part for part in parts) and len(parts) > 2 else found
        return " or ".join([", ".join(words[:-1]), words[-1]] if len(words) > 1 else words)
    if entry.get("type") == "array":
        inside = entry.get("items", {})
        plural = {"string": "strings", "integer": "whole numbers", "number": "numbers"}.get(str(inside.get("type")), "")
        two = entry.get("minItems") == entry.get("maxItems") == 2
        return "tables" if "$ref" in inside else f"two {plural}" if two and plural else f"array of {plural}" if plural else "array"
    names = {"integer": "whole number", "string": "string", "boolean": "true or false", "number": "number"}
    return names.get(str(entry.get("type")), "table")


def _measured(entry: dict, parts, unit: str) -> str:
    """What a key takes that is a quantity, or some of them."""
    shapes = [entry, *parts]
    if any(part.get("minItems") == 2 and "items" in part and part.get("maxItems") == 2 for part in shapes):
        words = "two numbers" if unit == "1" else f"two quantities in {unit}"
    elif any(part.get("items", {}).get("type") == "array" for part in shapes):
        words = "2 by 2 matrix in 1/s" if unit == "1/s" else f"array of points in {unit}"
    elif any(part.get("type") == "array" and "unit" in part for part in shapes):
        words = f"array of quantities in {unit}"
    else:
        words = "number" if unit == "1" else f"quantity in {unit}"
        words += ", or array" if any(part.get("type") == "array" for part in parts) else ""
        words += ", or string" if isinstance(entry.get("type"), list) else ""
    titles = {part.get("title") for part in parts}
    return words + (", or pulse" if titles & set(PULSES) else ", or table" if titles - {None} else "")


def shown(value) -> str:
    """A default as a deck writes it, with the digits that matter."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, (list, tuple)):
        return f"[{', '.join(shown(v) for v in value)}]"
    return f'"{value}"' if isinstance(value, str) else str(value)


def row(name: str, entry: dict, required: bool, names=()) -> list[str]:
    """The row of a key: a default that the description ends with stands in its column."""
    text, default, preset = entry.get("description", ""), "", entry.get("default")
    if said := re.fullmatch(r"(.*?) \(default: ([^()]*(?:\([^()]*\)[^()]*)*)\)", text, re.DOTALL):
        text = said[1]
    if required:
        default = "required"
    elif said:
        choices = [value for part in (entry, *entry.get("anyOf", ())) for value in part.get("enum", ())]
        plain = re.fullmatch(r"true|false|[\d.e-]+", said[2])
        default = f'`"{said[2]}"`' if said[2] in choices else f"`{said[2]}`" if plain else coded(said[2], names)
    elif preset not in (None, "", [], {}):
        unit = entry.get("unit") or next((part["unit"] for part in entry.get("anyOf", ()) if "unit" in part), "1")
        default = f"`{shown(preset)}`" + (f" {unit}" if isinstance(preset, float) and preset != 0.0 and unit != "1" else "")
    return [f"`{name}`", kind_of(entry), default, coded(text, names)]


def keys(schema: dict, but: dict | None = None) -> str:
    """The keys of one table of the deck; those that stand in the same words in `but` are left out."""
    required = set(schema.get("required", ()))
    whole = "stop_time" in schema["properties"]
    properties = sorted(schema["properties"].items(), key=_place) if whole else schema["properties"].items()
    names = () if whole else schema["properties"]
    rows = [row(name, entry, name in required, names) for name, entry in properties]
    known = [] if but is None else [row(name, entry, name in but.get("required", ())) for name, entry in but["properties"].items()]
    return table(["key", "type", "default", "meaning"], [found for found in rows if found not in known])


def _place(item) -> int:
    return ORDER.index(item[0]) if item[0] in ORDER else -1


def target(entry: dict, schema: dict) -> dict | None:
    """The definition a key of the deck refers to, if it is a table of its own."""
    for part in (entry, entry.get("items", {}), entry.get("additionalProperties", {}), *entry.get("anyOf", ())):
        if not isinstance(part, dict):
            continue
        if "$ref" in part:
            return schema["$defs"][part["$ref"].rpartition("/")[2]]
        if "properties" in part and part.get("title", PULSES[0]) not in PULSES:
            return part
    return None


def sections(schema: dict) -> dict[str, tuple[str, dict]]:
    """Head of every table of a solver's deck -> (depth of the heading, its definition), in the order of a reader."""
    found: dict[str, tuple[str, dict]] = {}
    for name, entry in sorted(schema["properties"].items(), key=_place):
        table_of = target(entry, schema)
        if table_of is None or name == "material":
            continue
        head = f"[[{name}]]" if entry.get("type") == "array" else f"[{name}.MATERIAL]" if name == "transport" else f"[{name}]"
        found[head] = ("###", table_of)
        inner: dict[str, list] = {}
        for key, part in table_of.get("properties", {}).items():
            if (deeper := target(part, schema)) and "properties" in deeper:
                inner.setdefault(json.dumps(deeper, sort_keys=True), [deeper]).append(f"[{name}.{key}]")
        for deeper, *heads in inner.values():
            found[", ".join(heads)] = ("####", deeper)
    return found


def solver_section(kind: str) -> str:
    """Everything a deck of one solver may say, laws aside; what it shares with the first solver is only named."""
    schema, first = json_schema(kind), json_schema(FIRST)
    text = [f"## Decks of {kind}\n", coded(inspect.cleandoc(solver_module(kind).Model.__doc__ or "")) + "\n"]
    mine, known = sections(schema), {} if kind == FIRST else {head: json.dumps(part) for head, (_, part) in sections(first).items()}
    same = [head for head, (_, part) in mine.items() if known.get(head) == json.dumps(part)]
    if same:
        shared = [head for head in same if head.count(".") == 0 or head.split(".")[0] + "]" not in same]
        verb = "is" if len(shared) == 1 else "are"
        text.append(f"{_listed(shared)} {verb} the same as in [decks of `{FIRST}`](#decks-of-{FIRST}). Of the keys outside tables the "
                    "following differ:\n")
    text.append(keys(schema, first if same else None))
    if same and (without := sorted(first["properties"].keys() - schema["properties"].keys())):
        text.append(f"There is no {' or '.join(f'`{name}`' for name in without)}.\n" if len(without) < 3 else
                    f"There is no {', '.join(f'`{name}`' for name in without[:-1])} or `{without[-1]}`.\n")
    for head, (depth, part) in mine.items():
        if (more := _more(part, known.get(head))):
            text += [f"{depth} {head}\n", f"The same keys as in [decks of `{FIRST}`](#decks-of-{FIRST}), without {_listed(more)}.\n"]
        elif head not in same:
            text += [f"{depth} {head}\n", _linked(part.get("description", ""), part["properties"]) + "\n", keys(part)]
    return "\n".join(text)


def _more(part: dict, known: str | None) -> list[str] | None:
    """Keys that a table of the first solver has beside all those of this one; None where they differ otherwise, or not at all."""
    first = json.loads(known)["properties"] if known else {}
    more = [name for name in first if name not in part["properties"]]
    return more if more and all(first.get(name) == entry for name, entry in part["properties"].items()) else None


def _listed(heads: list[str]) -> str:
    coded_heads = [f"`{head}`" for head in heads]
    return coded_heads[0] if len(heads) == 1 else ", ".join(coded_heads[:-1]) + " and " + coded_heads[-1]


def _linked(text: str, names) -> str:
    """The text of a table, the title of a section in it as a link."""
    linked = text.replace('see "Boundaries and pulses"', "see [Boundaries and pulses](#boundaries-and-pulses)")
    return coded(linked, names) if linked == text else linked


def pulses() -> str:
    """Boundaries of one dimension, and the forms of a history."""
    text = [BOUNDARIES]
    for head, model in (("Pulse", PulseTable), ("Table of times", HistoryTable)):
        schema = model.model_json_schema()
        schema["properties"] = {name: entry | ({"unit": "s"} if name == "times" else {}) for name, entry in schema["properties"].items()}
        rows = keys(schema).replace("| table |", "| quantity |").replace("| array |", "| array of quantities |")
        text += [f"### {head}\n", schema["description"] + "\n", rows]
    return "\n".join(text)


def law_section(family: str, registry) -> str:
    """Every law of a family with its parameters."""
    title, where = NAMES[family]
    text = [f"### {title}\n", f"In {coded(where)}.\n"]
    for name in registry.names():
        law = registry.get(name)
        names, required = accepted(law)
        text.append(f'#### law = "{name}"\n\n{law.summary} [Equations, example and sources](laws/{family}/{name}.md).\n')
        rows = [[f"`{n}`", _unit_of(law, n), "required" if n in required else shown_default(law, n), law.meaning.get(n, "")] for n in names]
        text.append(table(["parameter", "unit", "default", "meaning"], rows) if rows else "It has no parameters.\n")
        if name == table_law.LAW and family == "eos":
            text += ["Instead of these parameters the key `file` may name a file that holds the table:\n", _file_keys()]
    return "\n".join(text)


def _unit_of(law, name: str) -> str:
    unit = law.units.get(name, "1")
    return "" if unit in ("1", "text") else unit or "law"


def _file_keys() -> str:
    """The keys of an equation of state that is read from a file."""
    rows = [[f"`{n}`", "" if unit in ("1", "text") else unit, "required" if n == "file" else "optional", table_law.MEANING[n]]
            for n, unit in table_law.UNITS.items()]
    return table(["parameter", "unit", "default", "meaning"], rows)


def shown_default(law, name: str) -> str:
    """A default as the table shows it; not-a-number stands for "none"."""
    value = law.defaults.get(name)
    return "optional" if value is None or value != value else f"`{shown(value)}`"


def mixtures() -> str:
    """The closures a burning material may name."""
    rows = [[f"`{law.name}`", law.summary, f"[page](laws/mixture/{law.name}.md)"] for law in MIXTURE]
    return ("### Mixtures\n\nThe key `mixture` of `[material.NAME]` says how unreacted explosive and products share a zone while it "
        "burns.\n\n"
            + table(["mixture", "meaning", "equations, example and sources"], rows))


def reference() -> str:
    """The whole page."""
    others = [kind for kind in available_solvers() if kind != FIRST]
    text = [INTRODUCTION, solver_section(FIRST), pulses(), MATERIALS + keys(json_schema(FIRST)["$defs"]["material"]),
            *(solver_section(kind) for kind in others), LAWS]
    laws = {**families(), "viscosity": VISCOSITY, "transport": TRANSPORT, "conduction": CONDUCTION}
    text += [*(law_section(family, registry) for family, registry in laws.items()), mixtures()]
    text.append("## Fields\n\nNames for `fields` in `[output]` and for the command `hugoniot plot`. Which of them a run has depends on "
                "its solver, geometry and materials. In the column \"at\", zone means one value per zone, and node one value per corner of "
                "a zone (in one dimension, per zone boundary).\n\n"
                + table(["field", "symbol", "unit", "at", "meaning"],
                        [[f"`{f.name}`", f.symbol, "" if f.unit == "1" else f.unit, f.place, f.long_name] for f in FIELDS.values()]))
    rows = [[f"`{p.name}`", p.summary] for p in catalogue.problems()]
    text.append("## Problems to start from\n\n`hugoniot init NAME` writes the deck NAME.toml of one of these problems.\n\n"
                + table(["name", "problem"], rows))
    return "\n".join(text)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=Path, default=Path(__file__).parent / "generated" / "deck_reference.md")
    out = parser.parse_args().out
    out.parent.mkdir(parents=True, exist_ok=True)
    out.write_text(reference(), encoding="utf-8")


if __name__ == "__main__":
    main()
