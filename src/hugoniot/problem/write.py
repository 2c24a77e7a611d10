"""Writes tables as TOML. Floats are written by `repr`, so reading them back gives the same bits."""

import functools
import json
import math
import re
from typing import Any

_BARE = re.compile(r"[A-Za-z0-9_-]+")


def to_toml(tables: dict[str, Any]) -> str:
    """TOML text of nested tables of texts, numbers, booleans, arrays; empty tables and arrays of tables are left out."""
    return "\n".join(_table(tables, ())).strip() + "\n"


def _table(table: dict[str, Any], path: tuple[str, ...]) -> list[str]:
    lines, headed = [], []
    for name, value in table.items():
        if isinstance(value, (dict, list)) and _has_header(value, len(path)):
            headed.append((name, value))
        else:
            lines.append(f"{toml_key(name)} = {_value(value)}")
    for name, value in headed:
        here = (*path, name)
        header = ".".join(toml_key(k) for k in here)
        if isinstance(value, list):
            for element in value:
                lines += ["", f"[[{header}]]", *_table(element, here)]
        else:
            inner = _table(value, here)
            if inner and inner[0] != "":
                lines += ["", f"[{header}]"]
            lines += inner
    return lines


def _has_header(value: Any, depth: int) -> bool:
    """Whether a value gets a header of its own; small tables inside arrays and deep ones are written inline."""
    if isinstance(value, dict):
        return depth < 3 and not (depth >= 1 and any(isinstance(v, dict) for v in value.values()) and _inline_only(value))
    return depth == 0 and _of_tables(value)


def _of_tables(value: Any) -> bool:
    return isinstance(value, list) and bool(value) and all(isinstance(v, dict) for v in value)


def _inline_only(value: dict) -> bool:
    """Driven boundaries read best on one line: {velocity = {...}}."""
    return set(value) in ({"velocity"}, {"pressure"})


@functools.lru_cache(maxsize=1024)
def toml_key(name: str) -> str:
    """A key as TOML writes it: in quotes where it has other characters than letters, digits, - and _."""
    return name if _BARE.fullmatch(name) else _text(name)


def _text(text: str) -> str:
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")


def _value(value: Any) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return _text(value)
    if isinstance(value, int):
        return str(value)
    if isinstance(value, float):
        if not math.isfinite(value):
            raise ValueError(f"{value} cannot be written in a deck")
        return repr(value)
    if _of_tables(value):
        return "[\n" + "".join(f"    {_value(v)},\n" for v in value) + "]"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_value(v) for v in value) + "]"
    if isinstance(value, dict):
        return "{" + ", ".join(f"{toml_key(k)} = {_value(v)}" for k, v in value.items()) + "}"
    raise TypeError(f"a {type(value).__name__} cannot be written in a deck")
