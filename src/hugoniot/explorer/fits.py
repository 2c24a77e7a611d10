"""The folder of a fit: parameters with intervals and correlations from fit.json, data, model and residuals from residuals.csv."""

import csv
import io
import math
from pathlib import Path
from typing import Any

from hugoniot.errors import FileTrouble
from hugoniot.files import read_text
from hugoniot.output.listed import check_listed, read_listed
from hugoniot.page.live import fields

LARGEST = 64_000_000
DRAWS = 1500     # of a posterior that are drawn
COLUMNS = ("time", "data", "model", "sigma", "residual")


def fit(path: Path) -> dict[str, Any]:
    """`fit` as fit.json has it, `targets` with their columns in SI, `deck` that the fit made; `FileTrouble` where they do not agree.

    Of a `pop_plot` the column `time` holds input pressures in Pa.
    """
    found = read_listed(path / "fit.json")
    del found["sha256"]
    for name in ("residuals.csv", "fitted.toml", "posterior.csv"):
        if (path / name).is_file():
            check_listed(path / name)
    try:
        rows = list(csv.reader(io.StringIO(read_text(path / "residuals.csv", LARGEST))))[1:]
        counts = [(str(t["label"]), str(t["name"]), str(t.get("unit", "")), int(t["points"])) for t in found["targets"]]
        deck = read_text(path / "fitted.toml", LARGEST) if (path / "fitted.toml").is_file() else ""
    except (OSError, ValueError, KeyError, TypeError, csv.Error) as error:
        raise FileTrouble(f"{path.name}: cannot be read as a fit ({error})") from None
    if sum(points for *_, points in counts) != len(rows) or any(len(row) != 1 + len(COLUMNS) for row in rows):
        raise FileTrouble(f"{path.name}: residuals.csv does not contain the number of points stated in fit.json")
    targets, first = [], 0
    for label, name, unit, points in counts:
        part = rows[first:first + points]
        first += points
        columns = {key: [_number(row[k + 1], path) for row in part] for k, key in enumerate(COLUMNS)}
        targets.append({**_about(name, unit), "label": label, "name": name, "pop_plot": name.startswith("pop plot "), **columns})
    return {"fit": found, "targets": targets, "deck": deck, "draws": _draws(path, len(found.get("parameters", ())))}


def _about(name: str, unit: str) -> dict[str, Any]:
    """The words and the unit of a target: those of its field, or for a number that is no field those of fit.json."""
    about = fields([name.rpartition(".")[2] or name])[0]
    return about if about["unit"] or unit in ("", "1") else about | {"unit": unit, "shown": unit}


def _draws(path: Path, count: int) -> list[list[float | None]]:
    """Draws of the posterior, a list for each parameter, thinned to `DRAWS`; empty where none was asked for."""
    if not (path / "posterior.csv").is_file():
        return []
    rows = list(csv.reader(io.StringIO(read_text(path / "posterior.csv", LARGEST))))[1:]
    rows = [row for row in rows[::max(1, len(rows) // DRAWS)] if len(row) == count]
    return [[_number(row[k], path) for row in rows] for k in range(count)]


def _number(cell: str, path: Path) -> float | None:
    try:
        value = float(cell)
    except ValueError:
        raise FileTrouble(f"{path.name}: '{cell[:30]}' is not a number") from None
    return value if math.isfinite(value) else None
