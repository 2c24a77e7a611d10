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


def zone_fields(depths: dict[str, int], plane: bool) -> list[str]:
    """Of columns with their number of axes the fields with a value in every zone; those of nodes under their own name."""
    wide = [name for name, depth in depths.items() if depth == 2 and not name.startswith("position_")]
    if plane:
        extra = ["velocity_x", "velocity_y", "speed", *(["von_mises"] if "deviator_zz" in depths else [])]
        return [*(n for n in wide if n not in (*extra, "eroded")), *extra]      # removed zones are not drawn
    faces = [n.removesuffix("_left") for n in wide if n.endswith("_left")]
    return [*[n for n in wide if not n.endswith(("_left", "_right"))], *faces]


def description(path: Path) -> dict[str, Any]:
    """As `run_data.description`, of what is there; times are empty until the first checkpoint."""
    names = _columns(path, "snapshots")
    problem = _problem(path)
    plane = hasattr(problem, "blocks")
    gauge_names = [g.name for g in getattr(problem, "gauges", ())]
    mesh = {"axes": list(problem.axes), "zone_nodes": problem.mesh.zone_nodes, "block_of": problem.mesh.block_of} if plane else {}
    return {
        **mesh,
        "title": getattr(problem, "title", "") or path.name, "status": status(path), "live": True, "plane": plane, "summary": {},
        "geometry": getattr(problem, "geometry", ""), "zones": 0, "every": 1, "times": column(path, "snapshots", "time"),
        "regions": _regions(problem, plane), "events": [], "numbers": {}, "gauges": gauge_names,
        "fields": fields(zone_fields(names, plane)) if names else [],
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
    blocks = [_rows(table, name) for table in _tables(path, group)]
    return np.concatenate(blocks) if blocks else np.empty(0)


def _rows(table, name: str) -> np.ndarray:
    if name in table:
        return np.asarray(table[name][()], dtype=float)
    if f"{name}_left" in table:
        return 0.5 * (table[f"{name}_left"][()] + table[f"{name}_right"][()])
    raise OutOfRange(f"the run has no field called '{name[:60]}'")


def _tables(path: Path, group: str):
    """The table of every piece, open while it is looked at; a run that ends takes its pieces away, which ends the walk quietly."""
    for piece in _pieces(path):
        try:
            with opened(piece) as payload:
                if payload["tables"][group]:
                    yield payload["tables"][group]
        except OutOfRange:
            raise
        except HugoniotError:
            continue


# -- two dimensions --------------------------------------------------------------------------------------------------
class _Piece:
    """One piece of a run in progress as `plotting.plane` reads a run: its snapshots, and the mesh of the deck."""

    def __init__(self, folder: Path, table, mesh):
        columns = {name: np.asarray(values[()]) for name, values in table.items()}
        self.folder, self._groups = folder, {"snapshots": columns, "mesh": {"zone_nodes": mesh.zone_nodes}}

    def arrays(self, group: str):
        return self._groups[group]


def plane_column(path: Path, name: str, which: dict[str, int]) -> np.ndarray:
    """One record of a field or of a coordinate of the nodes, or the history of one zone, as far as the run has set them down."""
    problem = _problem(path)
    if not hasattr(problem, "blocks"):
        values = column(path, "snapshots", name)
        place = which.get("zone", which.get("record", 0))
        if not values.ndim == 2 or not 0 <= place < values.shape[1 if "zone" in which else 0]:
            raise OutOfRange(f"there is no {'zone' if 'zone' in which else 'record'} {place}")
        return values[:, place] if "zone" in which else values[place]
    from hugoniot.plotting.plane import plane_field

    mesh, before, found = problem.mesh, 0, []
    zone, record = which.get("zone"), which.get("record", 0)
    if zone is not None and not 0 <= zone < len(mesh.zone_nodes):
        raise OutOfRange(f"there is no zone {zone}")
    for table in _tables(path, "snapshots"):
        count = table["time"].shape[0]
        if zone is None and not before <= record < before + count:
            before += count
            continue
        if name.startswith("position_") and zone is None:
            return _rows(table, name)[record - before]
        piece = _Piece(path, table, mesh)
        if zone is None:
            return np.asarray(plane_field(piece, name, record - before), dtype=float)
        found.append(np.asarray(plane_field(piece, name, slice(None)), dtype=float)[:, zone])
    if zone is None:
        raise OutOfRange(f"there is no record {record}")
    return np.concatenate(found) if found else np.empty(0)
