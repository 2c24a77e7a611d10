"""What the commands share: JSON, aligned tables, values with units, `--set` options."""

import json
import math
import re
import tomllib
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Annotated, Any

import typer

from hugoniot.errors import DeckError
from hugoniot.materials.collect import printable
from hugoniot.units import UnitError, parse

SET = Annotated[list[str] | None, typer.Option("--set", help="Change a key of the deck, such as stop_time=\"3 us\"; repeatable.")]
# where a file cannot be read its reader says so, with the exit code of files
MATERIALS = Annotated[list[Path] | None, typer.Option("--materials", "-m", readable=False,
                                                      help="File or folder with your own materials, in TOML; repeatable.")]
JSON = Annotated[bool, typer.Option("--json", help="Print the result as JSON.")]


def echo_json(value: Any) -> None:
    """Print a value as JSON; numbers that are not finite become null."""
    typer.echo(json.dumps(_finite(value), indent=2, ensure_ascii=False, allow_nan=False))


def _finite(value: Any) -> Any:
    if isinstance(value, dict):
        return {str(k): _finite(v) for k, v in value.items()}
    if isinstance(value, (list, tuple)):
        return [_finite(v) for v in value]
    if hasattr(value, "tolist"):
        return _finite(value.tolist())
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value


def echo_table(heads: Sequence[str], rows: Iterable[Sequence[str]]) -> None:
    """Print an aligned table; the last column may be long, and wraps in a terminal."""
    rows = [[str(cell) for cell in row] for row in rows]
    widths = [max(len(row[k]) for row in [list(heads), *rows]) for k in range(len(heads))]
    for row in ([list(heads)] if any(heads) else []) + rows:
        typer.echo("  ".join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip())


def overrides_of(settings: Sequence[str] | None) -> dict[str, Any]:
    """`KEY=VALUE` options as {key: value}: the value is read as TOML, and as text where it is not TOML."""
    found: dict[str, Any] = {}
    for setting in settings or ():
        key, equals, value = setting.partition("=")
        if not equals or not key.strip():
            raise DeckError.single("--set", None, setting[:60], "expected KEY=VALUE", "for example --set region.flyer.velocity=\"800 m/s\"")
        found[key.strip()] = _value(value.strip())
    return found


def _value(text: str) -> Any:
    try:
        return tomllib.loads(f"value = {text}")["value"]
    except (tomllib.TOMLDecodeError, ValueError, RecursionError):
        return text


def quantity(text: str, unit: str, where: str) -> float:
    """The SI value of an option such as "1 km/s", or of a bare number; `DeckError` naming the option."""
    try:
        return parse(number_or_text(text), unit)
    except UnitError as error:
        raise DeckError.single("command line", None, where, error.message, error.hint) from None


def span(text: str, unit: str, where: str) -> tuple[float, float]:
    """(low, high) in SI of an option such as "0..5 mm"; the unit of the upper end holds for a lower one without."""
    low, dots, high = (part.strip() for part in text.partition(".."))
    named = re.search(r"[A-Za-z%°µ].*$", high)
    ends = [quantity(f"{low} {named.group(0)}" if named and not re.search(r"[A-Za-z]\s*$", low) else low, unit, where) if dots else 0.0,
            quantity(high if dots else low, unit, where)]
    if not dots or not ends[0] < ends[1]:
        raise DeckError.single("command line", None, where, f"'{printable(text)}' is not a range", "write LOW..HIGH, such as \"0..5 mm\"")
    return ends[0], ends[1]


def number_or_text(text: str) -> float | str:
    """A bare number as a number, so that it is SI; any other text as it is."""
    try:
        return float(text)
    except ValueError:
        return text
