"""A run in progress, from what its folder holds so far: deck, log and the pieces set down with each checkpoint."""

import re
from pathlib import Path
from typing import Any

import numpy as np

from hugoniot.errors import HugoniotError, OutOfRange
from hugoniot.files import read_text
from hugoniot.output.codec import opened
from hugoniot.output.columns import describe

TAIL = 30           # lines of the log that are shown
_PIECE = re.compile(r"\d{6,}\.h5")


def status(path: Path) -> str:
    """In words how far a run came that has no result."""
    if (path / "post_mortem.txt").is_file():
        return "failed"
    return "in progress" if (path / ".lock").is_file() else "unfinished"


def fields(names) -> list[dict]:
    """Name, SI unit and words of fields, and the unit and factor in which they are shown."""
    from hugoniot.plotting.style import field_scale

    found = []
    for name in names:
        unit, _ = describe(name)
        shown, factor, words = field_scale(name)
        found.append({"name": name, "unit": unit, "words": words, "shown": shown, "factor": factor})
    return found


def description(path: Path) -> dict[str, Any]:
    """As `run_data.description`, of what is there; times are empty until the first checkpoint."""
    names = _columns(path, "snapshots")
    problem = _problem(path)
    plane = hasattr(problem, "blocks")
    gauge_names = [g.name for g in getattr(problem, "gauges", ())]
    wide = [n for n in names if names[n] == 2 and not n.startswith("position_")]
    faces = [n.removesuffix("_left") for n in wide if n.endswith("_left")]
    return {
        "title": getattr(problem, "title", "") or path.name, "status": status(path), "live": True, "plane": plane, "summary": {},
        "geometry": getattr(problem, "geometry", ""), "zones": 0, "every": 1, "times": column(path, "snapshots", "time"),
        "regions": _regions(problem, plane), "events": [], "numbers": {}, "gauges": gauge_names,
        "fields": [] if plane else fields([*[n for n in wide if not n.endswith(("_left", "_right"))], *faces]),
        "gauge_fields": fields([n for n, depth in _columns(path, "gauges").items() if depth == 2 and n != "position"]),
        "gauge_times": len(column(path, "gauges", "time")), "stop_time": getattr(problem, "stop_time", None), "log": log_tail(path),
    }


def _problem(path: Path):
    from hugoniot.problem.deck import read_deck

    try:
        return read_deck(path / "deck.toml").problem
    except (HugoniotError, OSError):
        return None


def _regions(problem, plane: bool) -> list[dict]:
    found, first = [], 0
    for region in () if problem is None or plane else problem.regions:
        found.append({"name": region.name, "material": region.material, "first": first, "last": first + region.zones - 1})
        first += region.zones
    return found


def log_tail(path: Path) -> list[str]:
    """The last lines of the run's log, and of the post-mortem of one that failed."""
    lines: list[str] = []
    for name in ("run.log", "post_mortem.txt"):
        try:
            lines += read_text(path / name).splitlines()[-TAIL:]
        except (HugoniotError, OSError, UnicodeDecodeError):
            continue
    return lines


def _pieces(path: Path) -> list[Path]:
    folder = path / "pieces"
    return sorted(p for p in folder.iterdir() if _PIECE.fullmatch(p.name) and not p.is_symlink()) if folder.is_dir() else []


def _columns(path: Path, group: str) -> dict[str, int]:
    """Name -> number of axes of the columns in the first piece that has any."""
    for piece in _pieces(path):
        try:
            with opened(piece) as payload:
                if payload["tables"][group]:
                    return {name: len(values.shape) for name, values in payload["tables"][group].items()}
        except HugoniotError:
            continue
    return {}


def column(path: Path, group: str, name: str) -> np.ndarray:
    """A column as far as the run has set it down; of a field of faces the mean of both."""
    blocks = []
    for piece in _pieces(path):
        try:
            with opened(piece) as payload:
                table = payload["tables"][group]
                if not table:
                    continue
                if name in table:
                    blocks.append(np.asarray(table[name][()], dtype=float))
                elif f"{name}_left" in table:
                    blocks.append(0.5 * (table[f"{name}_left"][()] + table[f"{name}_right"][()]))
                else:
                    raise OutOfRange(f"the run holds no numbers called '{name[:60]}'")
        except OutOfRange:
            raise
        except HugoniotError:       # removed at the end of the run, between the look and the reading
            continue
    return np.concatenate(blocks) if blocks else np.empty(0)
