"""The deck editor's side of the server: errors at their lines, the set-up to draw, and the words a deck may hold."""

from pathlib import Path, PurePosixPath, PureWindowsPath
from typing import Any

import numpy as np

from hugoniot.errors import DeckError, FileTrouble, HugoniotError
from hugoniot.files import read_text, toml_tables
from hugoniot.problem.cost import estimate
from hugoniot.problem.deck import Deck, read_deck_text
from hugoniot.problem.editor_schema import json_schema
from hugoniot.problem.solver_kinds import available_solvers

LARGEST = 2_000_000
NAME = "deck.toml"
_FILES = ("file", "csv")    # keys of a deck whose values are names of files


def text_of(path: Path) -> str:
    """The text of a deck; `FileTrouble` where it cannot be read."""
    try:
        return read_text(path, LARGEST)
    except (OSError, UnicodeDecodeError) as error:
        raise FileTrouble(f"{path.name}: cannot be read ({error})") from None


def read(text: str, work: Path | None) -> Deck:
    """The deck of a text from the page. Files it names are looked for in `work` only; `DeckError` with every problem found."""
    _refuse_far_files(text)
    return read_deck_text(text, NAME, beside=work)


def _refuse_far_files(text: str) -> None:
    """Raise `DeckError` for a deck that names a file by a path: a deck from a page reads nothing but what lies beside it."""
    try:
        waiting: list[Any] = [toml_tables(text)]
    except ValueError:
        return      # the reader of decks says what is wrong
    while waiting:
        value = waiting.pop()
        if isinstance(value, list):
            waiting += value
        if not isinstance(value, dict):
            continue
        waiting += value.values()
        for key in _FILES:
            name = value.get(key)
            if isinstance(name, str) and (PurePosixPath(name).name != name or PureWindowsPath(name).name != name):
                raise DeckError.single(NAME, None, key, "a deck in the explorer may only name files in its own folder, without a path",
                                       "run this deck with hugoniot run")


def check(text: str, work: Path | None) -> dict[str, Any]:
    """`problems` as `hugoniot check` prints them, with their lines; of a valid deck warnings, cost and what to draw."""
    try:
        found = read(text, work)
    except DeckError as error:
        return {"ok": False, "count": error.count, "problems": [{"line": p.line, "key": p.key, "text": str(p)} for p in error.problems]}
    except HugoniotError as error:
        return {"ok": False, "problems": [{"line": None, "key": "", "text": str(error)}]}
    problem = found.problem
    return {"ok": True, "problems": [], "warnings": list(found.warnings), "estimate": estimate(problem)._asdict(),
            "title": problem.title, "kind": problem.solver.kind, "drawing": _drawing(problem)}


def _drawing(problem) -> dict[str, Any]:
    """Regions along the axis, or outlines of blocks in the plane, in SI."""
    if not hasattr(problem, "blocks"):
        return {"plane": False, "geometry": getattr(problem, "geometry", "planar"),
                "regions": [{"name": r.name, "material": r.material, "start": r.start, "end": r.end, "zones": r.zones,
                             "velocity": getattr(r, "velocity", 0.0)} for r in problem.regions],
                "gauges": [{"name": g.name, "at": g.at} for g in getattr(problem, "gauges", ())],
                "ends": [getattr(getattr(problem, side, None), "kind", "") for side in ("left", "right")]}
    blocks = []
    for block, part in zip(problem.blocks, problem.mesh.blocks):
        x, y = np.asarray(part.x), np.asarray(part.y)
        ring = [np.concatenate([v[:, 0], v[-1, 1:], v[-2::-1, -1], v[0, -2:0:-1]]) for v in (x, y)]
        blocks.append({"name": block.name, "material": block.material, "x": ring[0], "y": ring[1], "velocity": list(block.velocity.base)})
    return {"plane": True, "geometry": problem.geometry, "axes": list(problem.axes), "blocks": blocks}


# -- words for completion --------------------------------------------------------------------------------------------
def words(kind: str) -> dict[str, Any]:
    """Of every table of a deck its keys with unit, description and choices; `laws` of each family with their parameters."""
    schema = json_schema(kind if kind in available_solvers() else "lagrange1d")
    tables: dict[str, dict] = {}
    _walk(schema, schema, "", tables, 0)
    laws = {name.removesuffix("_law"): _laws(definition) for name, definition in schema["$defs"].items() if name.endswith("_law")}
    return {"tables": tables, "laws": laws, "solvers": available_solvers()}


def _walk(node: dict, schema: dict, path: str, tables: dict, depth: int) -> None:
    node = _resolved(node, schema)
    properties = node.get("properties", {})
    if not properties or depth > 4:
        return
    tables[path] = {key: _key(value, schema) for key, value in properties.items()}
    for key, value in properties.items():
        inner = _resolved(value, schema)
        below = f"{path}.{key}" if path else key
        if inner.get("type") == "array" and "items" in inner:
            _walk(inner["items"], schema, below, tables, depth + 1)
        elif "additionalProperties" in inner and isinstance(inner["additionalProperties"], dict):
            _walk(inner["additionalProperties"], schema, f"{below}.*", tables, depth + 1)
        else:
            _walk(inner, schema, below, tables, depth + 1)


def _resolved(node: dict, schema: dict) -> dict:
    """A node with its reference, or the one alternative that is a table, put in its place."""
    for _ in range(8):
        if "$ref" in node:
            node = {**schema["$defs"][node["$ref"].rpartition("/")[2]], **{k: v for k, v in node.items() if k != "$ref"}}
        elif tables := [n for n in node.get("anyOf", ()) if "$ref" in n and not n["$ref"].endswith("_law")]:
            node = tables[0]
        else:
            break
    return node


def _key(value: dict, schema: dict) -> dict:
    node = _resolved(value, schema)
    choices = node.get("enum") or [n["const"] for n in node.get("anyOf", ()) if "const" in n]
    inner = node.get("items", {})
    table = "$ref" in inner or "properties" in node or node.get("type") == "object" or any("$ref" in n for n in node.get("anyOf", ()))
    return {"text": value.get("description") or node.get("description", ""), "unit": node.get("unit", ""), "choices": choices,
            "table": bool(table), "many": node.get("type") == "array" and "$ref" in inner}


def _laws(definition: dict) -> dict[str, dict]:
    found = {}
    for alternative in definition.get("anyOf", ()):
        law = alternative.get("properties", {}).get("law", {}).get("const")
        if law:
            found[law] = {"text": alternative.get("description", ""), "required": alternative.get("required", []),
                          "keys": {k: {"text": v.get("description", ""), "unit": v.get("unit", "")}
                                   for k, v in alternative["properties"].items() if k != "law"}}
    return found
