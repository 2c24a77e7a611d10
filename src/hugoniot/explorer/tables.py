"""A table of cases: the CSV file of a sweep with parameters and results in columns, and the runs that stand beside it."""

import csv
import io
import math
import re
from pathlib import Path
from typing import Any

from hugoniot.campaign.journal import kept_answers
from hugoniot.errors import FileTrouble
from hugoniot.files import read_text
from hugoniot.output.listed import check_listed
from hugoniot.output.sweep_file import warnings_of

LARGEST, MOST_ROWS, MOST_COLUMNS = 32_000_000, 20_000, 200
RUN_COLUMNS = ("folder", "run", "case", "path", "name")     # columns that may name the run of a case
KEPT, JOURNAL = "runs", "cases.jsonl"                       # what `hugoniot sweep --keep` writes
CASES, SWEEP = "cases.csv", "sweep.h5"
SAID = {"sensitivity.csv": "Sensitivity of the results to the parameters", "spread.csv": "Spread of the results",
        "constants.csv": "Constants of the library that varied"}
_KEY = re.compile(r"[0-9a-f]{16,64}")
NOTHING = ("", "nan", "inf", "-inf", "none", "null", "-")     # cells without a number in a column of numbers
_HEAD = re.compile(r"(?P<name>.*?)\s*[(\[](?P<unit>[^()\[\]]*)[)\]]\s*$")


def table(path: Path) -> dict[str, Any]:
    """Columns of a CSV file: head, name and unit in it, whether all cells are numbers, cells; `runs`: rows with a run beside the table.

    Raises `FileTrouble` for a file that is no table.
    """
    heads, rows = _read(path)
    columns = _columns(heads, rows)
    return {"columns": columns, "rows": len(rows), "runs": sorted(_runs(path, columns, len(rows))), **_beside(path)}


def _beside(path: Path) -> dict[str, Any]:
    """What a sweep says of its cases in the files beside cases.csv: warnings, and tables of sensitivities, spreads and constants in SI."""
    home = path.parent
    if path.name != CASES or not (home / SWEEP).is_file():
        return {"warnings": [], "tables": []}
    found = []
    for name, title in SAID.items():
        if (home / name).is_file():
            heads, rows = _read(home / name)
            found.append({"title": title, "columns": _columns(heads, rows)})
    return {"warnings": warnings_of(home / SWEEP), "tables": found}


def run_of_case(path: Path, row: int) -> Path:
    """The run folder of a row; `FileTrouble` where the table names none beside itself."""
    heads, rows = _read(path)
    folder = _runs(path, _columns(heads, rows), len(rows)).get(row)
    if folder is None:
        raise FileTrouble(f"{path.name}: row {row + 1} has no run folder beside the table; hugoniot sweep --keep keeps the runs")
    return folder


def _columns(heads: list[str], rows: list[list[str]]) -> list[dict]:
    columns = []
    for k, head in enumerate(heads):
        cells = [row[k].strip() if k < len(row) else "" for row in rows]
        numbers = [_number(cell) for cell in cells]
        numeric = any(n is not None for n in numbers) and all(n is not None or cell.lower() in NOTHING for n, cell in zip(numbers, cells))
        match = _HEAD.fullmatch(head)
        name, unit = (match["name"], match["unit"]) if match else (head, "")
        columns.append({"head": head, "name": name, "unit": "" if unit == "1" else unit, "numeric": numeric,
                        "cells": numbers if numeric else cells})
    return columns


def _read(path: Path) -> tuple[list[str], list[list[str]]]:
    check_listed(path)
    try:
        text = read_text(path, LARGEST)
        lines = [row for row in csv.reader(io.StringIO(text)) if row and not row[0].lstrip().startswith("#")]
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise FileTrouble(f"{path.name}: cannot be read as a table ({error})") from None
    if len(lines) < 2 or len(lines[0]) > MOST_COLUMNS:
        raise FileTrouble(f"{path.name}: a table needs a header line, at least one line of values, and at most {MOST_COLUMNS} columns")
    if len(lines) > MOST_ROWS + 1:
        raise FileTrouble(f"{path.name}: more than {MOST_ROWS} rows; the explorer shows no larger table")
    if long := next((k for k, row in enumerate(lines) if len(row) > len(lines[0])), 0):
        raise FileTrouble(f"{path.name}: row {long}: values: {len(lines[long])}, column headers: {len(lines[0])}; texts with commas need "
                          "quotes, and numbers a decimal point")
    return [head.strip() for head in lines[0]], lines[1:]


def _number(cell: str) -> float | None:
    try:
        value = float(cell)
    except ValueError:
        return None
    return value if math.isfinite(value) else None


# -- the runs of the cases -------------------------------------------------------------------------------------------
def _runs(path: Path, columns: list[dict], count: int) -> dict[int, Path]:
    """Row -> run folder below the folder of the table: kept by `hugoniot sweep --keep`, or named by a column."""
    found = _kept(path.parent.resolve(), columns, count)
    named = [c["cells"] for c in columns if c["name"] in RUN_COLUMNS and not c["numeric"]]
    for row in range(count):
        for cells in named:
            folder = _below(path.parent.resolve(), cells[row])
            if folder is not None:
                found.setdefault(row, folder)
    return found


def _kept(home: Path, columns: list[dict], count: int) -> dict[int, Path]:
    """The runs a sweep kept: the row and the answer in its journal have the same results, to the last bit."""
    if not (home / KEPT).is_dir() or not (home / JOURNAL).is_file():
        return {}
    folders: dict[tuple, Path] = {}
    names: list[str] | None = None
    for answer in kept_answers(home / JOURNAL):
        numbers = answer.get("numbers", {})
        if names is None and numbers:
            names = [c["name"] for c in columns if c["numeric"] and c["name"] in numbers]
        key = str(answer.get("key", ""))
        folder = _below(home, f"{KEPT}/{key}") if names and _KEY.fullmatch(key) else None
        if names and folder is not None:
            folders[tuple(_finite(numbers.get(name)) for name in names)] = folder
    by_name = {c["name"]: c["cells"] for c in columns}
    rows = {row: tuple(by_name[name][row] for name in names or ()) for row in range(count)}
    return {row: folders[values] for row, values in rows.items() if values in folders}


def _finite(value) -> float | None:
    return value if isinstance(value, (int, float)) and math.isfinite(value) else None


def _below(home: Path, name: str) -> Path | None:
    """A run folder of that name below `home`; None for any other place."""
    for candidate in (name, f"{name}.run", f"runs/{name}", f"runs/{name}.run") if name and "\0" not in name else ():
        folder = (home / candidate).resolve()
        if folder != home and folder.is_relative_to(home) and (folder / "deck.toml").is_file():
            return folder
    return None
