"""A table of cases: the CSV file of a sweep with parameters and results in columns, and the runs that stand beside it."""

import csv
import io
import math
import re
from pathlib import Path
from typing import Any

from hugoniot.errors import FileTrouble
from hugoniot.files import read_text

LARGEST, MOST_ROWS, MOST_COLUMNS = 32_000_000, 20_000, 200
RUN_COLUMNS = ("folder", "run", "case", "path", "name")     # columns that may name the run of a case
NOTHING = ("", "nan", "inf", "-inf", "none", "null", "-")     # cells without a number in a column of numbers
_HEAD = re.compile(r"(?P<name>.*?)\s*[(\[](?P<unit>[^()\[\]]*)[)\]]\s*$")


def table(path: Path) -> dict[str, Any]:
    """Columns of a CSV file: name, unit, whether all cells are numbers, cells. `FileTrouble` for a file that is no table."""
    heads, rows = _read(path)
    columns = []
    for k, head in enumerate(heads):
        cells = [row[k].strip() if k < len(row) else "" for row in rows]
        numbers = [_number(cell) for cell in cells]
        numeric = any(n is not None for n in numbers) and all(n is not None or cell.lower() in NOTHING for n, cell in zip(numbers, cells))
        match = _HEAD.fullmatch(head)
        name, unit = (match["name"], match["unit"]) if match else (head, "")
        columns.append({"name": name, "unit": unit, "numeric": numeric, "cells": numbers if numeric else cells})
    return {"columns": columns, "rows": len(rows), "runs": [k for k in range(len(rows)) if _folder(path, heads, rows[k]) is not None]}


def _read(path: Path) -> tuple[list[str], list[list[str]]]:
    try:
        text = read_text(path, LARGEST)
        lines = [row for row in csv.reader(io.StringIO(text)) if row and not row[0].lstrip().startswith("#")]
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise FileTrouble(f"{path.name}: cannot be read as a table ({error})") from None
    if len(lines) < 2 or len(lines[0]) > MOST_COLUMNS:
        raise FileTrouble(f"{path.name}: a table has a line of names and at least one of values, and up to {MOST_COLUMNS} columns")
    if len(lines) > MOST_ROWS + 1:
        raise FileTrouble(f"{path.name}: more than {MOST_ROWS} rows")
    return [head.strip() for head in lines[0]], lines[1:]


def _number(cell: str) -> float | None:
    try:
        value = float(cell)
    except ValueError:
        return None
    return value if math.isfinite(value) else None


def _folder(path: Path, heads: list[str], row: list[str]) -> Path | None:
    """The run of a case: a folder below that of the table which a column names, and nothing outside of it."""
    home = path.parent.resolve()
    for wanted in RUN_COLUMNS:
        if wanted not in heads or heads.index(wanted) >= len(row):
            continue
        name = row[heads.index(wanted)].strip()
        for candidate in (name, f"{name}.run", f"cases/{name}", f"cases/{name}.run", f"runs/{name}") if name else ():
            folder = (home / candidate).resolve() if "\0" not in candidate else home
            if folder != home and folder.is_relative_to(home) and (folder / "deck.toml").is_file():
                return folder
    return None


def run_of_case(path: Path, row: int) -> Path:
    """The run folder of a row; `FileTrouble` where the table names none beside itself."""
    heads, rows = _read(path)
    folder = _folder(path, heads, rows[row]) if 0 <= row < len(rows) else None
    if folder is None:
        raise FileTrouble(f"{path.name}: row {row + 1} names no run folder beside the table")
    return folder
